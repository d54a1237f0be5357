"""Curvature and torsion at a parameter: exact values at rational parameters, enclosures at irrational roots.

What `exactspline.Nurbs.curvature` and `exactspline.Nurbs.torsion` call.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from exactspline.errors import DomainError, ShapeError
from exactspline.exact import Number, mpq, text
from exactspline.geometry.domain import part, space
from exactspline.language.arguments import Curve
from exactspline.language.choices import Side
from exactspline.language.rational import Rational
from exactspline.papers import find
from exactspline.roots.enclosure import (
    Bounds,
    Enclosure,
    exact_place,
    narrowed,
    quotient,
    root_of,
    sign_at,
    value_at,
    values_between,
)
from exactspline.roots.root import Root
from exactspline.splines.bspline import BSpline, checked_side
from exactspline.splines.lowest_terms import in_lowest_terms
from exactspline.splines.surd import Surd, square_root

if TYPE_CHECKING:
    from exactspline.splines.nurbs import Nurbs


def curvature(
    curve: Nurbs, t: Number | Root, *, digits: int = 15, side: Side | str = Side.RIGHT
) -> mpq | Surd | Enclosure:
    """The curvature of a curve at a parameter or a root (see `exactspline.Nurbs.curvature`)."""
    if curve.dimension not in (2, 3):
        raise ShapeError(f"a curve in R{curve.dimension}", remedy="curvature needs a curve in the plane or in space")
    place = exact_place(t)
    c = _segment(curve, place, side)
    _refuse_singular(c, place, side)
    squared: Rational[BSpline] = find("space_curvature_squared" if curve.dimension == 3 else "curvature_squared")(c)
    sign = 1 if curve.dimension == 3 else sign_at(find("f2")(c) * c.w, place, side)
    if not isinstance(place, Root):
        return square_root(_quotient(squared, place, side)) * sign
    if sign_at(squared.scalar, place) == 0:
        return mpq(0)

    def bounds(low: mpq, high: mpq) -> list[Bounds] | None:
        top, bottom = (values_between(f, low, high) for f in (squared.scalar, squared.denominator))
        if top is None or bottom is None or bottom.low <= 0 <= bottom.high:
            return None
        size = root_of(quotient(top, bottom), digits + 5)
        return [size if sign > 0 else Bounds(-size.high, -size.low)]

    return narrowed(bounds, place, digits)[0]


def torsion(curve: Nurbs, t: Number | Root, *, digits: int = 15, side: Side | str = Side.RIGHT) -> mpq | Enclosure:
    """The torsion of a space curve at a parameter or a root (see `exactspline.Nurbs.torsion`)."""
    place = exact_place(t)
    c = _segment(space(curve), place, side)
    _refuse_singular(c, place, side)
    found = find("torsion")(c)
    if found.denominator.is_zero:
        raise ShapeError("the torsion of a straight piece", remedy="ask for it where the curve is not straight")
    tau = in_lowest_terms(found)
    if sign_at(tau.denominator, place, side) == 0:
        raise DomainError(f"the torsion has a pole {_named(place)}", remedy="choose another parameter")
    if not isinstance(place, Root):
        return _quotient(tau, place, side)
    if sign_at(tau.numerator, place) == 0:
        return mpq(0)
    return value_at((tau.numerator,), tau.denominator, place, digits)[0]


def _segment(curve: Nurbs, place: mpq | Root, side: Side | str) -> Curve[BSpline]:
    """The curve over the segment that holds a parameter or a root."""
    left = checked_side(side)
    i = _segment_of_root(curve, place) if isinstance(place, Root) else curve.mesh.locate(place, left=left)
    return part(curve, *curve.breakpoints[i : i + 2])


def _segment_of_root(curve: Nurbs, root: Root) -> int:
    """The number of the segment with an irrational root inside."""
    a, b = curve.domain
    if not a < root < b:
        raise DomainError(f"the root is outside the domain [{text(a)}, {text(b)}]", remedy="stay inside")
    return next(i for i, t in enumerate(curve.breakpoints[1:]) if root < t)


def _quotient(value: Rational[BSpline], t: mpq, side: Side | str) -> mpq:
    quotient: mpq = value(t, side)
    return quotient


def _refuse_singular(c: Curve[BSpline], place: mpq | Root, side: Side | str) -> None:
    if all(sign_at(x, place, side) == 0 for x in find("D1")(c)):
        raise DomainError(f"γ′ = 0 {_named(place)}", remedy="choose another parameter")


def _named(place: mpq | Root) -> str:
    return "at the root" if isinstance(place, Root) else f"at the parameter {text(place)}"
