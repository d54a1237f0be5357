"""Files written atomically: whole or not at all."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import BinaryIO

from exactspline.errors import CurveFileError, ExactSplineError


def write_atomically(
    path: str | os.PathLike[str], write: Callable[[BinaryIO], object], error: type[ExactSplineError] = CurveFileError
) -> None:
    """Let `write` fill a temporary file next to the path, then move it there; a link is followed, and what it points
    to replaced.

    Raises `error` where nothing can be written, and where something that is not a regular file (a folder, a device, a
    pipe) has that name: it is left alone.
    """
    place = Path(path)
    try:
        place = place.resolve()
        if place.is_symlink():  # as of Python 3.13 a circle is no error of `resolve`
            raise RuntimeError
        if place.exists() and not place.is_file():
            raise error(
                "is not a regular file", where=str(path), remedy="name a file; leave the name out for standard output"
            )
        handle, temporary = tempfile.mkstemp(dir=place.parent, prefix=f".{place.name}.")
        try:
            with os.fdopen(handle, "wb") as stream:
                write(stream)
            os.chmod(temporary, 0o644)
            os.replace(temporary, place)
        except BaseException:
            os.unlink(temporary)
            raise
    except (OSError, RuntimeError) as reason:
        problem = getattr(reason, "strerror", None) or "its links form a cycle"
        raise error(
            f"cannot be written ({problem})", where=str(path), remedy="name a file in a folder that can be written"
        ) from None


def write_text(path: str | os.PathLike[str], text: str, error: type[ExactSplineError] = CurveFileError) -> None:
    """Write a text in UTF-8 atomically, with the errors of `write_atomically`."""
    write_atomically(path, lambda stream: stream.write(text.encode()), error)
