"""Files written atomically: whole or not at all."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import BinaryIO
from uuid import uuid4

from exactspline.errors import CurveFileError, ExactSplineError


def write_atomically(
    path: str | os.PathLike[str], write: Callable[[BinaryIO], object], error: type[ExactSplineError] = CurveFileError
) -> None:
    """Let `write` fill a temporary file next to the path, then move it there; a link is followed, and what it points
    to replaced. An existing file keeps its mode, a new one has that which the system gives to new files.

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
        temporary = place.with_name(f".{place.name}.{uuid4().hex[:8]}")
        try:
            with open(temporary, "xb") as stream:
                write(stream)
                stream.flush()
                os.fsync(stream.fileno())
            if place.exists():
                os.chmod(temporary, place.stat().st_mode & 0o7777)
            os.replace(temporary, place)
        except BaseException:
            temporary.unlink(missing_ok=True)
            raise
    except (OSError, RuntimeError) as reason:
        problem = getattr(reason, "strerror", None) or "its links form a cycle"
        raise error(
            f"cannot be written ({problem})", where=str(path), remedy="name a file in a folder that can be written"
        ) from None


def write_text(path: str | os.PathLike[str], text: str, error: type[ExactSplineError] = CurveFileError) -> None:
    """Write a text in UTF-8 atomically, with the errors of `write_atomically`."""
    write_atomically(path, lambda stream: stream.write(text.encode()), error)
