"""The extent of a curve: the extrema of its coordinates, and its bounding box."""

from __future__ import annotations

from collections.abc import Sequence

from exactspline.errors import ShapeError
from exactspline.geometry.curves.facts import located
from exactspline.geometry.curves.kinds import Feature, FeatureKind
from exactspline.language.vector import Vector
from exactspline.language.wronskians import wronskians
from exactspline.numbers.exact import mpq
from exactspline.reals.real import Extreme, RationalNumber, Real
from exactspline.roots.answers import CurvePiece, Places
from exactspline.roots.values import exact_place, value_at
from exactspline.roots.zero_set import ZeroSet, zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs


def slope(curve: Nurbs, axis: int) -> BSpline:
    """A spline with the sign of the derivative of a coordinate."""
    return wronskians(curve.w, Vector(curve.p[axis]))[0]


def slope_zeros(curve: Nurbs, axis: int | str) -> ZeroSet:
    """The zeros of the derivative of a coordinate; raises `ShapeError` for a coordinate that the curve does not
    have.
    """
    return zeros(slope(curve, _number_of(curve, axis)), periodic=curve.closed)


def _number_of(curve: Nurbs, axis: int | mpq | str) -> int:
    number = next((i for i in range(curve.dimension) if str(i) == str(axis)), None)
    if number is None:
        raise ShapeError(f"the coordinate {axis} of a curve in R{curve.dimension}", remedy="0 is x, 1 is y, 2 is z")
    return number


def value_zeros(curve: Nurbs, axis: int | mpq, value: mpq) -> ZeroSet:
    """The parameters at which a coordinate has a given value; raises `ShapeError` for a coordinate that the curve does
    not have.
    """
    return zeros(curve.p[_number_of(curve, axis)] - curve.w.scaled(value), periodic=curve.closed)


def at_coordinate(curve: Nurbs, axis: int | mpq, value: mpq) -> Places[Feature]:
    """The parameters at which a coordinate crosses a value, also by a jump (``level crossing``), or reaches the value
    without crossing it (``level touch``); and the pieces on which the coordinate has this value.

    Raises `ShapeError` for a coordinate that the curve does not have.
    """
    solved, kinds = value_zeros(curve, axis, value), (FeatureKind.TOUCH, FeatureKind.CROSSING)
    found = (Feature(kinds[root.sign_change], root, f"coordinate {axis}", jump) for root, jump in located(solved))
    return Places(tuple(found), tuple(CurvePiece(each.parts) for each in solved.intervals))


def turning_points(curve: Nurbs, axis: int | str) -> Places[Feature]:
    """The parameters at which a coordinate changes from increasing to decreasing (``maximum``) or back (``minimum``);
    and the pieces on which the coordinate is constant.

    Raises `ShapeError` for a coordinate that the curve does not have.
    """
    features = []
    solved = slope_zeros(curve, axis)
    for root, by_jump in located(solved):
        left, right = root.signs
        if left and right and left != right:
            kind = FeatureKind.MAXIMUM if left > 0 else FeatureKind.MINIMUM
            features.append(Feature(kind, root, f"coordinate {axis}", by_jump))
    return Places(tuple(features), tuple(CurvePiece(each.parts) for each in solved.intervals))


def coordinate_range(curve: Nurbs, axis: int) -> tuple[Real, Real]:
    """The smallest and the largest value of a coordinate, known exactly.

    >>> from exactspline import example
    >>> coordinate_range(example("circle"), 0)
    (<Real -1>, <Real 1>)
    """
    values = [Real(curve(t, side)[axis]) for t in curve.breakpoints for side in ("left", "right")]
    values += [
        value_at(curve.p[axis], curve.w, exact_place(root)) for root in slope_zeros(curve, axis) if not root.at_knot
    ]
    return _extreme(values, -1), _extreme(values, 1)


def _extreme(values: Sequence[Real], side: int) -> Real:
    """The largest (side 1) or smallest (−1) of several numbers, without deciding which of them is attained."""
    choose = max if side > 0 else min
    best = choose(x for x in values if isinstance(x, RationalNumber))
    rest = [x for x in values if not isinstance(x, RationalNumber) and (x > best if side > 0 else x < best)]
    return Extreme(side, rest) if len(rest) > 1 else rest[0] if rest else best
