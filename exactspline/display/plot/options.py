"""What the options of a picture may be, checked before anything is drawn: matplotlib would say it in its own words, or
draw half of the picture first.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from inspect import signature
from typing import Any

from exactspline.display.plot.canvas import LARGEST_SIZE, PlotError, library
from exactspline.display.plot.frames import Box
from exactspline.errors import ExactSplineError, nearest, shown
from exactspline.numbers.exact import rational

#: The largest number that an option may be.
LARGEST_NUMBER = 10**9


def check_options(**given: object) -> None:
    """Refuse what an option of a picture cannot be, by its name, with `PlotError`.

    >>> check_options(color="#D55E00", control_polygon=True, label=None)
    >>> check_options(color="reddish")
    Traceback (most recent call last):
    exactspline.display.plot.canvas.PlotError: color: 'reddish' is not a colour; give a name or '#rrggbb'
    """
    for name, value in given.items():
        what, is_good, remedy = CHECKS[name]
        if not is_good(value):
            raise PlotError(f"{shown(value)} is not {what}", where=name, remedy=remedy)


def exact_box(box: Box | None, dimension: int) -> Box | None:
    """The box with exact corners; `PlotError` for one of another dimension."""
    if box is None:
        return None
    low, high = (tuple(map(rational, corner)) for corner in box)
    if len(low) != dimension:
        raise PlotError(f"a box in R{len(low)}", where="box", remedy=f"corners have {dimension} coordinates here")
    return low, high


def check_names(draw: Callable[..., object], names: Iterable[str]) -> None:
    """Refuse the name of an option that a function does not have, with `PlotError`."""
    known = [p.name for p in signature(draw).parameters.values() if p.kind is p.KEYWORD_ONLY]
    for name in names:
        if name not in known:
            raise PlotError(f"{draw.__name__} has no option {name!r}", remedy=nearest(name, known))


def _is_color(value: object) -> bool:
    if isinstance(value, tuple):
        return len(value) in (3, 4) and all(_is_number(x) and 0 <= x <= 1 for x in value)
    return isinstance(value, str) and bool(library("matplotlib.colors").is_color_like(value))


def _is_number(value: Any) -> bool:
    if not isinstance(value, int | float) or isinstance(value, bool):
        return False
    return -LARGEST_NUMBER < value < LARGEST_NUMBER


def _is_corner(value: Any) -> bool:
    return isinstance(value, list | tuple) and all(map(_is_rational, value))


def _is_rational(value: Any) -> bool:
    try:
        rational(value)
    except ExactSplineError:
        return False
    return True


def _is_box(value: Any) -> bool:
    if value is None:
        return True
    if not isinstance(value, list | tuple) or len(value) != 2 or not all(map(_is_corner, value)):
        return False
    low, high = value
    return len(low) == len(high) in (2, 3) and all(rational(x) < rational(y) for x, y in zip(low, high, strict=True))


def _is_marker(value: object) -> bool:
    return isinstance(value, str) and value in library("matplotlib.markers").MarkerStyle.markers


_COLOR = ("a colour", _is_color, "give a name or '#rrggbb'")
_FLAG = ("a choice between two", lambda x: isinstance(x, bool), "give True or False")
_SIZE = f"give a number between 0 and {LARGEST_SIZE}"
#: For each option: what it is, whether a value is that, and what would be.
CHECKS: dict[str, tuple[str, Callable[[Any], bool], str]] = {
    **dict.fromkeys(("color", "polygon_color", "net_color"), _COLOR),
    **dict.fromkeys(("control_polygon", "control_net", "knots", "hollow"), _FLAG),
    "label": ("a label", lambda x: isinstance(x, str | None), "give a text"),
    "marker": ("a marker", _is_marker, "give one of matplotlib's, such as 'o', 'D', '^'"),
    "size": ("a size of markers", lambda x: _is_number(x) and 0 < x <= LARGEST_SIZE, _SIZE),
    "box": ("a box", _is_box, "give two opposite corners, the lower one first: ((0, 0), (1, 2))"),
}
