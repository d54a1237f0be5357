"""The forms whose zeros are the features of a curve, and these zeros."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any

from gmpy2 import mpq

from exactspline.geometry.constructions import MINIMAL, construction
from exactspline.geometry.domain import plane, space
from exactspline.language.arguments import Curve
from exactspline.roots.zero_set import ZeroSet, zeros
from exactspline.splines.bspline import BSpline


def zero_form(curve: Any, name: str, variant: str = MINIMAL) -> tuple[BSpline, ZeroSet]:
    """The form of a zero-set construction on a curve, with the sign it has for a positive weight function, and its
    certified zeros.

    Raises `ShapeError` for a curve of another dimension.
    """
    made = construction(name)
    {"plane": plane, "space": space}[made.curve](curve)
    f = made.on(_with_positive_weight(curve), variant)
    return f, zeros(f, periodic=curve.closed)


def _with_positive_weight(curve: Any) -> Any:
    """The same curve as operands, (p, w) replaced by (−p, −w) where w is negative: forms of odd degree in (p, w) change
    their sign with it.
    """
    return curve if curve.w(curve.domain[0]) > 0 else Curve(-curve.p, -curve.w, polynomial=curve.polynomial)


def split_at_joints(curve: Any, found: ZeroSet, smooth: Callable[[mpq], bool]) -> list[tuple[mpq, mpq]]:
    """The intervals of a zero set, cut at the inner knots that are not smooth."""
    pieces: list[tuple[mpq, mpq]] = []
    for interval in found.intervals:
        cuts = [t for t in curve.breakpoints[1:-1] if interval.low < t < interval.high and not smooth(t)]
        pieces += pairwise([interval.low, *cuts, interval.high])
    return pieces
