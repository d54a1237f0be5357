"""New papers: a small working example, copied into a user's folder."""

from __future__ import annotations

from importlib import resources
from pathlib import Path

from exactspline.errors import ClaimError
from exactspline.papers.folder import files_in

#: The folder that is copied.
TEMPLATE = "new_paper"
#: The suffix of the Python file in this folder, which is not a module of this package.
TEXT = ".txt"


def write_new_paper(folder: str | Path) -> list[Path]:
    """Write the example paper into a folder; return the files written.

    >>> import tempfile
    >>> [path.name for path in write_new_paper(Path(tempfile.mkdtemp()) / "mine")]
    ['README.md', 'claims.toml', 'arch.json', 'formulas.py']

    Raises `ClaimError` for a folder that is not empty or cannot be written.
    """
    place = Path(folder)
    if place.exists() and (not place.is_dir() or any(place.iterdir())):
        problem = "is not empty" if place.is_dir() else "is a file"
        raise ClaimError(problem, where=str(place), remedy="name a new folder")
    template = resources.files(__package__).joinpath(TEMPLATE)
    written = []
    try:
        for name, file in sorted(files_in(template)):
            path = place.joinpath(*name.removesuffix(TEXT).split("/"))
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(file.read_bytes())
            written.append(path)
    except OSError as error:
        raise ClaimError(f"cannot be written: {error.strerror}", where=str(folder), remedy="name another") from None
    return written
