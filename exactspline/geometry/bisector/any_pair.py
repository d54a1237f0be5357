"""The bisector of two curves, or of a curve and a point."""

from __future__ import annotations

from collections.abc import Iterable

from exactspline.errors import ShapeError
from exactspline.geometry.bisector.point_and_curve import PointBisector, exact_point, point_bisector, refuse_point
from exactspline.geometry.bisector.two_curves import CurveBisector, curve_bisector
from exactspline.language.rational import Rational
from exactspline.numbers.exact import Number
from exactspline.papers import find
from exactspline.splines.bspline import BSpline
from exactspline.splines.expected import curve_of
from exactspline.splines.lowest_terms import where_it_exists
from exactspline.splines.nurbs import Nurbs


def bisector(first: Nurbs, second: Nurbs | Iterable[Number]) -> CurveBisector | PointBisector | Rational[BSpline]:
    """The points of equal *critical* distances to a curve and to another curve or a point (its coordinates).

    For two space curves it is a surface in patches; for a space curve and a point, ruled surfaces in pieces; for a
    plane curve and a point, a plane curve ``p/w`` (0/1 where there is none), of which `exactspline.trimmed_bisector`
    keeps the points of equal distances.

    >>> from exactspline import example
    >>> type(bisector(example("twisted_cubic"), example("rational_space_cubic"))).__name__
    'CurveBisector'
    >>> type(bisector(example("ellipse_in_space"), (1, 1, 2))).__name__
    'PointBisector'
    >>> line = Nurbs(1, [0, 0, 1, 1], [(-1, 0), (1, 0)])
    >>> bisector(line, (0, 2))("1/2")
    (mpq(0,1), mpq(1,1))

    Raises `ShapeError` where the dimensions do not match.
    """
    first = curve_of(first)
    if isinstance(second, Nurbs):
        return curve_bisector(first, second)
    if first.dimension == 3:
        return point_bisector(first, second)
    if first.dimension != 2:
        raise ShapeError(f"a curve in R{first.dimension}", remedy="bisectors need the plane or space")
    refuse_point(first)
    value: Rational[BSpline] = find("plane_bisector_polynomial")(first.with_point(exact_point(first, second, 2)))
    return where_it_exists(value)
