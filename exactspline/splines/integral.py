"""The antiderivative of a spline."""

from __future__ import annotations

from exactspline.numbers.exact import mpq
from exactspline.splines.bspline import BSpline


def integral(f: BSpline) -> BSpline:
    """The antiderivative that is 0 at the start of the domain, one degree higher and continuous.

    >>> f = BSpline(1, [0, 0, 1, 3, 3], [2, 0, 4])
    >>> integral(f).d() == f, integral(f)(0), integral(f)(3)
    (True, mpq(0,1), mpq(5,1))
    """
    degree, reached, points = f.degree + 1, mpq(0), list[mpq]()
    for piece in f.bezier_segments():
        (a, b), values = piece.domain, [reached]
        for point in piece.control_points:
            values.append(values[-1] + point * (b - a) / degree)
        points += values
        reached = values[-1]
    knots = [t for t in f.breakpoints for _ in range(degree + 1)]
    return BSpline(degree, knots, points)
