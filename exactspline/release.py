"""Which release this is, and which ones of the libraries compute."""

__version__ = "0.3.0"
#: The extras that are not for developers alone, and what is installed without any.
USERS = ("", "plot", "formats", "sweep")


def releases() -> dict[str, str]:
    """The releases on which answers depend, by the names of the packages.

    >>> releases()["exactspline"] == __version__
    True
    """
    import flint  # when something is printed: the package is imported without it

    return {"exactspline": __version__, "python-flint": flint.__version__}


def all_releases() -> dict[str, str]:
    """The releases of Python and of all libraries that the package can use, by the names of the packages.

    >>> {"Python", "gmpy2", "sympy", "mpmath"} <= all_releases().keys()
    True
    """
    import re
    from importlib.metadata import PackageNotFoundError, requires, version
    from platform import python_version

    needed = [each.partition("; extra == ") for each in requires("exactspline") or ()]
    names = {re.split(r"[^\w-]", name)[0] for name, _, extra in needed if extra.strip("'\"") in USERS}
    found = {"exactspline": __version__, "Python": python_version()}
    for name in sorted(names):
        try:
            found[name] = version(name)
        except PackageNotFoundError:
            found[name] = "is not installed"
    return found
