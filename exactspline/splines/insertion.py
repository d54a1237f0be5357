"""A knot inserted into a curve, on its control points: Boehm's algorithm. Only the points around the knot are computed.

Source: W. Boehm, Inserting new knots into B-spline curves, CAD 1980.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Sequence

from exactspline.numbers.exact import mpq
from exactspline.splines.control_points import ONE, Point, lifted, projected
from exactspline.splines.knots import KnotVector


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
    # the points around the knot, homogeneous, the first and the last of which stay
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
