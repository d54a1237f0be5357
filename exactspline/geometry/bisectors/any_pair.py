"""The bisector of two curves, or of a curve and a point."""

from __future__ import annotations

from collections.abc import Iterable
from typing import overload

from exactspline.geometry.bisectors.common import Bisector
from exactspline.geometry.bisectors.plane_curves import PlaneBisector
from exactspline.geometry.bisectors.point_and_curve import PointBisector, point_bisector
from exactspline.geometry.bisectors.trimmed import TrimmedBisector, trimmed_bisector
from exactspline.geometry.bisectors.two_curves import CurveBisector, curve_bisector
from exactspline.geometry.curves.planarity import in_one_plane
from exactspline.numbers.exact import Number
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of, of_dimension


@overload
def bisector(first: Nurbs, second: Nurbs) -> CurveBisector | PlaneBisector:
    """The bisector of two curves in space or in the plane."""


@overload
def bisector(first: Nurbs, second: Iterable[Number]) -> PointBisector | TrimmedBisector:
    """The bisector of a curve and a point."""


def bisector(first: Nurbs, second: Nurbs | Iterable[Number]) -> Bisector:
    """Return the bisector of a curve and another curve, or of a curve and a point (its coordinates), in pieces.

    The bisector of two space curves consists of surface patches of equal *critical* distances, and of lines, planes and
    single pairs. The bisector of a space curve and a point consists of ruled surfaces. The bisector of a plane curve
    and a point consists of curves of equal distances. The bisector of two curves in the plane, or in the plane z = 0 of
    space, consists of correspondences of parameters, which are not trimmed.

    >>> from exactspline import example
    >>> bisector(example("twisted_cubic"), example("rational_space_cubic"))
    <CurveBisector: 1 piece>
    >>> bisector(example("ellipse_in_space"), (1, 1, 2))
    <PointBisector: 3 pieces>
    >>> line = Nurbs(1, [0, 0, 1, 1], [(-1, 0), (1, 0)])
    >>> bisector(line, (0, 2)).pieces[0]("1/2")
    (mpq(0,1), mpq(1,1))

    Raises `ShapeError` if the dimensions do not fit, and for a point on a plane curve.
    """
    first = curve_of(first)
    if isinstance(second, Nurbs):
        first, second = in_one_plane(first, second)
        return PlaneBisector(first, second) if first.dimension == 2 else curve_bisector(first, second)
    if first.dimension == 3:
        return point_bisector(first, second)
    return trimmed_bisector(of_dimension(first, "bisectors need the plane or space", 2), second)
