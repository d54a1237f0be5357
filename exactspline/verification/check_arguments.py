"""What claims about two curves, or about a curve and a point, are checked on when one curve is given."""

from __future__ import annotations

from exactspline.exact import mpq, text
from exactspline.language.argument import Evaluated
from exactspline.language.arguments import Curve, Pair
from exactspline.language.kinds import PAIR
from exactspline.language.vector import Vector
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.tensor import TensorSpline, surface_pair

#: Segments of either curve that a pair is made of: more would show nothing new, and the patches grow with their square.
SEGMENTS = 1


def point_beside(curve: Nurbs) -> tuple[mpq, ...]:
    """A point beside the curve: the mean of its control points, moved by unequal parts of their extent.

    >>> from exactspline.splines.examples import example
    >>> point_beside(example("circle"))
    (mpq(1,3), mpq(4,11))
    """
    point = []
    for i, column in enumerate(zip(*curve.control_points, strict=True)):
        extent = max(column) - min(column)
        point.append(sum(column) / len(column) + (extent or 1) * mpq(i + 1, 2 * i + 9))
    return tuple(point)


def moved_copy(curve: Nurbs) -> Curve[BSpline]:
    """The curve with its coordinates exchanged cyclically and moved by the vector of its test point."""
    move = point_beside(curve)
    p = Vector(*[curve.p[(i + 1) % curve.dimension] + curve.w * move[i] for i in range(curve.dimension)])
    return Curve(p, curve.w, polynomial=curve.polynomial)


def beginning(curve: Curve[BSpline], segments: int = SEGMENTS) -> Curve[BSpline]:
    """The first segments of a curve."""
    breaks = curve.w.breakpoints
    a, b = breaks[0], breaks[min(segments, len(breaks) - 1)]
    return Curve(Vector(*[x.restrict(a, b) for x in curve.p]), curve.w.restrict(a, b), polynomial=curve.polynomial)


def pair_with(curve: Nurbs, other: Curve[BSpline] | None = None) -> Pair[TensorSpline]:
    """The first segments of two curves, or of a curve and its moved copy."""
    return surface_pair(beginning(curve), beginning(moved_copy(curve) if other is None else other))


def argument(kind: str, curve: Nurbs) -> tuple[Evaluated, str]:
    """What formulas of a kind are handed on one curve, and what is said of it beside the curve."""
    if kind == PAIR.name:
        return pair_with(curve), ", first segment, with its moved copy"
    if kind.endswith("point"):
        point = point_beside(curve)
        return curve.with_point(point), f", with the point ({', '.join(map(text, point))})"
    return curve, ""
