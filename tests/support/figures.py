"""The figures of the paper, drawn once for all tests of a process that look at them."""

import atexit
from functools import cache
from shutil import rmtree
from tempfile import mkdtemp
from typing import Any

from exactspline.display.figures import FIGURES, Made, make


@cache
def _folder() -> str:
    place = mkdtemp()
    atexit.register(rmtree, place, ignore_errors=True)
    return place


@cache
def drawn(number: int) -> Any:
    """A figure, its caption and its scenes."""
    return FIGURES[number]()


@cache
def figure(number: int) -> Made:
    """A figure with its caption and its files."""
    return make(number, _folder(), drawn(number))
