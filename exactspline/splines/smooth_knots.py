"""A spline of given smoothness from its pieces: control points over knots that leave nothing of a gap."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Sequence

from exactspline.numbers.exact import mpq
from exactspline.splines.blossom import to_control_points


def with_smooth_knots(
    degree: int,
    breaks: Sequence[mpq],
    pieces: Sequence[Sequence[Sequence[mpq]]],
    multiplicities: Sequence[int],
    *,
    periodic: bool = False,
) -> tuple[list[mpq], list[tuple[mpq, ...]]]:
    """Knots and control points of the curve whose pieces have these Bézier points. A breakpoint of multiplicity m (the
    first of them: that of the seam) is a knot of class C^(degree − m), whether the pieces agree there or not: each
    control point is computed from one of them. A periodic spline has the knots of the next periods beyond its ends.

    >>> line, square = [(mpq(0),), (mpq(1, 2),), (mpq(1),)], [(mpq(1),), (mpq(3, 2),), (mpq(5),)]
    >>> with_smooth_knots(2, [mpq(0), mpq(1), mpq(2)], [line, square], [1, 1])[1]
    [(mpq(0,1),), (mpq(1,2),), (mpq(3,2),), (mpq(5,1),)]
    """
    width, around = breaks[-1] - breaks[0], (degree // len(pieces) + 1) * periodic
    periods = range(-around, around + 1)
    ends = [t + i * width for i in periods for t in breaks[:-1]] + [breaks[-1] + around * width]
    counts = [*multiplicities] * len(periods) + [multiplicities[0]]
    knots = [t for t, count in zip(ends, counts, strict=True) for _ in range(count)]
    if periodic:
        knots = knots[bisect_right(knots, breaks[0]) - 1 - degree : bisect_left(knots, breaks[-1]) + degree + 1]
    else:
        full = degree + 1 - multiplicities[0]
        knots = [breaks[0]] * full + knots + [breaks[-1]] * full
    columns = zip(*[zip(*piece, strict=True) for piece in pieces], strict=True)
    points = [to_control_points(knots, degree, ends, column * len(periods)) for column in columns]
    return knots, list(zip(*points, strict=True))
