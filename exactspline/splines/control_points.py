"""Control points as users write them: Cartesian points, each with a weight, and directions."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Sequence
from itertools import pairwise

from exactspline.errors import NumberError, ShapeError, as_instance, as_items, counted, shown
from exactspline.numbers.exact import Number, mpq, text
from exactspline.one_line import one_line
from exactspline.splines.bspline import BSpline
from exactspline.splines.inputs import exact_row
from exactspline.splines.knots import KnotVector


class Direction(tuple[mpq, ...]):
    """A control vector, that is, a control point at infinity: ``(x, y, 0)`` in homogeneous coordinates.

    A direction v with basis function N adds ``N v`` to the numerator of the curve and nothing to the denominator (Piegl
    and Tiller call v an infinite control point). A Cartesian point of weight 0 adds nothing to numerator and
    denominator.

    >>> from exactspline import Nurbs
    >>> half_circle = Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), Direction(0, 1), (-1, 0)])
    >>> half_circle("1/2"), half_circle.weights
    ((mpq(0,1), mpq(1,1)), (mpq(1,1), mpq(0,1), mpq(1,1)))

    Raises `NumberError` if a coordinate is not an exact number.
    """

    __slots__ = ()

    def __new__(cls, *coordinates: Number) -> Direction:
        """The direction with these coordinates."""
        return super().__new__(cls, exact_row(coordinates, "Direction"))

    def __getnewargs__(self) -> tuple[mpq, ...]:  # a constructor of several arguments
        return tuple(self)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Direction) and tuple(self) == tuple(other)

    def __ne__(self, other: object) -> bool:
        return not self == other

    def __hash__(self) -> int:
        return hash((Direction, *self))

    @one_line
    def __repr__(self) -> str:
        return f"Direction({', '.join(map(text, self))})"


Point = tuple[mpq, ...]
#: The default weights of points and of directions.
ONE, NONE = mpq(1), mpq(0)


def exact_points(rows: Iterable[Iterable[Number]], least: int = 2) -> tuple[Point, ...]:
    """Points and directions of the same dimension, with at least this many coordinates each; the `ShapeError` names the
    invalid one.
    """
    points: list[Point] = []
    for i, row in enumerate(as_items(rows, "control points")):
        if type(row) is Direction:
            points.append(row)
            continue
        if type(row) is not tuple and (isinstance(row, str) or not isinstance(row, Iterable)):
            raise ShapeError(
                f"{shown(row)} is not a point", where=f"control_points[{i}]", remedy="write a list of coordinates"
            )
        try:
            points.append(exact_row(row, ""))
        except NumberError as error:
            raise error.at(f"control_points[{i}]") from None
    if not points:
        raise ShapeError("no control points", where="control_points", remedy="give at least degree + 1")
    sizes = set(map(len, points))
    if len(sizes) > 1:
        i, point = next((i, point) for i, point in enumerate(points) if len(point) != len(points[0]))
        problem = f"{counted(len(point), 'coordinate')} where control_points[0] has {len(points[0])}"
        raise ShapeError(problem, where=f"control_points[{i}]", remedy="use one dimension")
    if min(sizes) < least:
        raise ShapeError(
            counted(min(sizes), "coordinate"), where="control_points[0]", remedy=f"at least {least} are needed"
        )
    return tuple(points)


def exact_weights(weights: Iterable[Number] | None, points: Sequence[Point]) -> tuple[mpq, ...]:
    """One weight per control point, 0 for a direction; without weights, 1 for every point."""
    if weights is None:
        return tuple([NONE if type(point) is Direction else ONE for point in points])
    exact = exact_row(weights, "weights")
    if len(exact) != len(points):
        problem = f"{counted(len(exact), 'weight')} for {counted(len(points), 'control point')}"
        raise ShapeError(problem, where="weights", remedy="give one weight per control point")
    for i, point in enumerate(points):
        if type(point) is Direction and exact[i]:
            raise ShapeError(
                f"the weight {text(exact[i])} of a direction",
                where=f"weights[{i}]",
                remedy="a direction has the weight 0; a point is written as a list of coordinates",
            )
    return exact


def lifted(point: Point, weight: mpq) -> Point:
    """The homogeneous coordinates of a control point except the last, which is its weight.

    >>> lifted((mpq(1), mpq(2)), mpq(3)), lifted(Direction(1, 2), mpq(0))
    ((mpq(3,1), mpq(6,1)), (mpq(1,1), mpq(2,1)))
    """
    return tuple(point) if isinstance(point, Direction) else tuple(x * weight for x in point)


def projected(row: Sequence[mpq]) -> Point:
    """The control point with these homogeneous coordinates, a direction if the last coordinate is 0 and another one is
    not.

    >>> projected([mpq(2), mpq(4), mpq(2)]), projected([mpq(1), mpq(2), mpq(0)])
    ((mpq(1,1), mpq(2,1)), Direction(1, 2))
    """
    *coordinates, weight = row
    if not weight and any(coordinates):
        return Direction(*coordinates)
    return tuple(x / weight if weight else x for x in coordinates)


def greville_abscissae(f: BSpline) -> list[mpq]:
    """Return the parameters over which the control points of a function are drawn: the means of n consecutive knots for
    the degree n, or the midpoints of segments for degree 0.

    >>> from exactspline import BSpline
    >>> greville_abscissae(BSpline(2, [0, 0, 0, 1, 2, 2, 2], [0, 1, 0, 1]))
    [mpq(0,1), mpq(1,2), mpq(3,2), mpq(2,1)]
    """
    f = as_instance(f, BSpline, "a spline", "give a BSpline")
    n, t = f.degree, f.knots.knots
    if n == 0:
        return [(a + b) / 2 for a, b in pairwise(t)]
    return [sum(t[i + 1 : i + n + 1], mpq(0)) / n for i in range(len(f.control_points))]


# ---- insertion of a knot
#
# Only the points around the knot are computed.
#
# Source: W. Boehm, Inserting new knots into B-spline curves, CAD 1980.


def inserted(
    knots: KnotVector, degree: int, points: Sequence[Point], weights: Sequence[mpq], t: mpq, times: int
) -> tuple[KnotVector, tuple[Point, ...], tuple[mpq, ...]]:
    """Knots, control points and weights of a curve with a knot inserted inside the domain, or at its end; its
    multiplicity is then at most degree + 1.

    >>> line = (mpq(0), mpq(0)), (mpq(4), mpq(8))
    >>> _, points, weights = inserted(KnotVector([0, 0, 1, 1]), 1, line, (mpq(1), mpq(3)), mpq(1, 2), 1)
    >>> points[1], weights
    ((mpq(3,1), mpq(6,1)), (mpq(1,1), mpq(2,1), mpq(3,1)))
    """
    first, last = bisect_right(knots.knots, t) - degree, bisect_left(knots.knots, t) - 1
    polynomial, near = weights.count(weights[0]) == len(weights), range(first - 1, last + 1)
    # the homogeneous points around the knot; the first and the last do not change
    rows: list[Point] = [points[i] if polynomial else (*lifted(points[i], weights[i]), weights[i]) for i in near]
    vector = knots
    for start in range(first, first + times):
        own, made = vector.knots, []
        for i in range(start, last + 1):
            part = (t - own[i]) / (own[i + degree] - own[i])
            ends = zip(rows[i - first], rows[i - first + 1], strict=True)
            made.append(tuple([a + part * (b - a) for a, b in ends]))
        rows = [*rows[: start - first + 1], *made, *rows[last - first + 1 :]]
        vector = vector.insert(t)
    between = rows[1:-1]
    new = between if polynomial else [*map(projected, between)]
    fresh = (ONE,) * len(new) if polynomial else tuple([row[-1] for row in between])
    kept = (ONE,) * len(weights) if polynomial else weights
    return vector, (*points[:first], *new, *points[last:]), (*kept[:first], *fresh, *kept[last:])
