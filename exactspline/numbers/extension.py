"""The optional C extension (programs/filter.c), which is not a Python module. A library that is not byte for byte the
one compiled from the source, or that computes a known case differently, is not used: without it exact arithmetic
decides, with the same answers.

>>> loaded("curve_points", lambda function: False) is None
True
"""

from __future__ import annotations

from collections.abc import Callable
from ctypes import CDLL, c_int
from functools import cache
from hashlib import sha256
from os import environ
from pathlib import Path

SOURCE = Path(__file__).parents[1] / "programs" / "filter.c"
#: The compiled extension: a file next to the source, absent if there was no compiler, or the file that this environment
#: variable names ("none": run without the extension).
LIBRARY = environ.get("EXACTSPLINE_EXTENSION") or str(SOURCE.with_name("filter.lib"))


@cache
def _library() -> CDLL | None:
    """The extension, if it is the one that was compiled from the source beside this file. A damaged library, or one
    compiled from other source, is not loaded: it could end this process, or give wrong answers.
    """
    try:
        contents = SOURCE.read_bytes() + Path(LIBRARY).read_bytes()
        known = Path(f"{LIBRARY}.sha256").read_bytes().decode("ascii").strip()
        return CDLL(LIBRARY) if known == sha256(contents).hexdigest() else None
    except (OSError, UnicodeDecodeError):
        return None


def loaded(name: str, right: Callable[[Callable[..., int]], bool], *arguments: type) -> Callable[..., int] | None:
    """A function of the extension, if its answer in a known case is `right`; None without the extension. Without types
    of its arguments it takes bytes and arrays of ctypes as they are, which is faster.
    """
    library = _library()
    if library is None:
        return None
    # by item a new object, whose types nobody else sets: by attribute there is one for all
    function = library[name]
    function.argtypes, function.restype = arguments, c_int
    return function if right(function) else None
