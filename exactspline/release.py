"""Which release this is, and which ones of the libraries compute."""

__version__ = "0.2.0"


def releases() -> dict[str, str]:
    """The releases on which answers depend, by the names of the packages.

    >>> releases()["exactspline"] == __version__
    True
    """
    import flint  # when something is printed: the package is imported without it

    return {"exactspline": __version__, "python-flint": flint.__version__}
