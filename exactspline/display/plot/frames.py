"""The visible part of a figure: boxes around points, and the control points of computed objects."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import ceil, floor, log10

from exactspline.display.plot.canvas import PlotError, Point
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector
from exactspline.numbers.exact import mpq
from exactspline.splines.common import with_common_knots
from exactspline.splines.lowest_terms import SplineVector

#: The visible part: the fraction of points omitted on either side, and the margin (in multiples of its longest side).
OUTLIERS, AROUND = 10, mpq(1)
#: A side of a box is short below this fraction of the longest one.
SHORT = 0.55

Box = tuple[Point, Point]


def box_around(points: Iterable[Point]) -> Box:
    """Lower left and upper right corner of the smallest box around the points."""
    columns = list(zip(*points, strict=True))
    return tuple(map(min, columns)), tuple(map(max, columns))


def longer_side(box: Box) -> mpq:
    """The length of the longest side of a box."""
    return max(high - low for low, high in zip(*box, strict=True))


def grown(box: Box, by: mpq) -> Box:
    """The box with a margin on all sides, given as a multiple of its longer side."""
    margin = by * longer_side(box)
    return tuple(x - margin for x in box[0]), tuple(x + margin for x in box[1])


def inside(point: Point, box: Box) -> bool:
    """Whether a box contains a point."""
    return all(low <= x <= high for low, x, high in zip(box[0], point, box[1], strict=True))


def usual_box(points: Sequence[Point], poles: bool = True) -> Box:
    """A box around the points with a margin; with `poles` around most of them, so that faraway points do not matter.

    Raises `PlotError` where there are no points.
    """
    if not points:
        raise PlotError(
            "there is nothing to draw",
            remedy="this does not exist on the curve (its denominator vanishes), or is all at infinity",
        )
    columns = [sorted(column) for column in zip(*points, strict=True)]
    cut = len(points) // OUTLIERS if poles else 0
    return grown((tuple(c[cut] for c in columns), tuple(c[-1 - cut] for c in columns)), AROUND)


def three_ticks(low: mpq | float, high: mpq | float, longest: float = 0) -> list[mpq]:
    """Two or three round numbers between two bounds, by steps of 1, 2 or 5 times a power of ten; no three on a side
    that is short compared with the longest one, where they would stand over each other.

    >>> [[float(x) for x in three_ticks(*ends)] for ends in ((-1.2, 4.1), (-0.5, 2.5), (0.12, 0.31), (3, 3))]
    [[0.0, 2.0, 4.0], [0.0, 1.0, 2.0], [0.2, 0.3], [3.0]]
    """
    low, high = mpq(low), mpq(high)
    if low >= high:
        return [low]
    power = floor(log10(high - low)) - 1
    at_most = 2 if float(high - low) < SHORT * longest else 3
    steps = (mpq(k) * mpq(10) ** (power + up) for up in range(3) for k in (1, 2, 5))
    return next(
        [k * step for k in range(first, last + 1)]
        for step in steps
        if (last := floor(high / step)) - (first := ceil(low / step)) < at_most
    )


def kept(point: Point | None, box: Box) -> Point | None:
    """The point if the box contains it, otherwise None."""
    return point if point is not None and inside(point, box) else None


def clipped(
    point: Point, direction: Point, box: Box, low: mpq | None = None, high: mpq | None = None
) -> tuple[Point, Point] | None:
    """The two ends of the part of a line inside a box, between two of its parameters where they are given; None where
    there is none.

    >>> clipped((mpq(-2), mpq(0)), (mpq(1), mpq(0)), ((mpq(-1), mpq(-1)), (mpq(1), mpq(1))))
    ((mpq(-1,1), mpq(0,1)), (mpq(1,1), mpq(0,1)))
    """
    for x, d, a, b in zip(point, direction, *box, strict=True):
        if d == 0:
            if not a <= x <= b:
                return None
            continue
        first, last = sorted(((a - x) / mpq(d), (b - x) / mpq(d)))
        low = first if low is None else max(low, first)
        high = last if high is None else min(high, last)
    if low is None or high is None or low >= high:
        return None
    ends = [tuple(x + z * d for x, d in zip(point, direction, strict=True)) for z in (low, high)]
    return ends[0], ends[1]


def polygon_in(corners: Sequence[Point], box: Box) -> list[Point]:
    """The part of a polygon inside a box: cut by one side of the box after the other.

    >>> square = [(mpq(x), mpq(y)) for x, y in ((0, 0), (2, 0), (2, 2), (0, 2))]
    >>> polygon_in(square, ((mpq(1), mpq(1)), (mpq(3), mpq(3))))
    [(mpq(2,1), mpq(1,1)), (mpq(2,1), mpq(2,1)), (mpq(1,1), mpq(2,1)), (mpq(1,1), mpq(1,1))]
    """
    points = list(corners)
    for k in range(len(box[0])):
        for bound, side in ((box[0][k], 1), (box[1][k], -1)):
            cut: list[Point] = []
            for p, q in zip(points, [*points[1:], *points[:1]], strict=True):
                a, b = side * (p[k] - bound), side * (q[k] - bound)
                if a >= 0:
                    cut.append(p)
                if a * b < 0:
                    cut.append(tuple(x + (y - x) * a / (a - b) for x, y in zip(p, q, strict=True)))
            points = cut
    return points


def homogeneous(value: SplineVector) -> tuple[list[tuple[mpq, ...]], Sequence[mpq], int]:
    """Homogeneous control points ``(w x, …, w)`` of a vector or quotient over the knots that carry all components, the
    knots, and the degree.
    """
    numerator, w = value.elevated() if isinstance(value, Rational) else (value, value[0].constant(1))
    assert isinstance(numerator, Vector)
    raised = with_common_knots([*numerator, w])
    return list(zip(*[c.control_points for c in raised], strict=True)), raised[0].knots.knots, raised[0].degree
