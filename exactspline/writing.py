"""Files written atomically: there whole or not at all."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import BinaryIO

from exactspline.errors import CurveFileError, ExactSplineError


def write_atomically(path: str | os.PathLike[str], write: Callable[[BinaryIO], object], error: type[ExactSplineError] = CurveFileError) -> None:
    """Let `write` fill a temporary file beside the path, then move it there.

    Raises `error` where nothing can be written.
    """
    place = Path(path)
    try:
        handle, temporary = tempfile.mkstemp(dir=place.parent, prefix=f".{place.name}.")
        try:
            with os.fdopen(handle, "wb") as stream:
                write(stream)
            os.chmod(temporary, 0o644)
            os.replace(temporary, place)
        except BaseException:
            os.unlink(temporary)
            raise
    except OSError as reason:
        raise error(f"cannot be written ({reason.strerror})", where=str(place), remedy="name a file in a folder that can be written") from None
