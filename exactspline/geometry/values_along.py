"""Curvature and torsion at a parameter: exact values at rational parameters, enclosures at irrational roots.

Behind `exactspline.Nurbs.curvature` and `exactspline.Nurbs.torsion`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from exactspline.errors import DomainError, ShapeError
from exactspline.exact import Number, mpq, text
from exactspline.geometry.analysis import analyse
from exactspline.geometry.domain import part, space
from exactspline.language.arguments import Curve
from exactspline.language.choices import Side
from exactspline.language.rational import Rational
from exactspline.papers import find
from exactspline.roots.enclosure import Enclosure, exact_place, sign_at
from exactspline.roots.real import Real
from exactspline.roots.root import Root
from exactspline.splines.bspline import BSpline
from exactspline.splines.given import checked_side
from exactspline.splines.lowest_terms import in_lowest_terms
from exactspline.splines.surd import Surd, square_root

if TYPE_CHECKING:
    from exactspline.splines.nurbs import Nurbs


def curvature(
    curve: Nurbs, t: Number | Root, *, digits: int = 15, side: Side | str = Side.RIGHT
) -> mpq | Surd | Enclosure:
    """The curvature of a curve at a parameter or a root (see `exactspline.Nurbs.curvature`)."""
    return curvature_at(curve, exact_place(t), side).told(digits)


def torsion(curve: Nurbs, t: Number | Root, *, digits: int = 15, side: Side | str = Side.RIGHT) -> mpq | Enclosure:
    """The torsion of a space curve at a parameter or a root (see `exactspline.Nurbs.torsion`)."""
    found = torsion_at(curve, exact_place(t), side).told(digits)
    assert not isinstance(found, Surd)
    return found


def point_at(curve: Nurbs, place: mpq | Root, order: int = 0, side: Side | str = Side.RIGHT) -> tuple[Real, ...]:
    """The point or a derivative of a curve at a rational parameter or an irrational root.

    >>> from exactspline import example, zeros
    >>> circle = example("circle")
    >>> [x.double() for x in point_at(circle, zeros(circle.p[0] - circle.p[1]).roots[0], 1)]
    [-1.2071067811865475, 1.2071067811865475]
    """
    if not isinstance(place, Root):
        return tuple(map(Real.of, curve.derivative(order, place, side) if order else curve(place, side)))
    numerators, denominator = _derivative(curve, order)
    return tuple(Real.quotient_at(f, denominator, place) for f in numerators)


def _derivative(curve: Nurbs, order: int) -> tuple[list[BSpline], BSpline]:
    """The derivative of some order as a quotient of splines."""
    if curve.polynomial:
        return [x.d(order) for x in curve.p], curve.w
    found, slope, denominator = list(curve.p), curve.w.d(), curve.w
    for k in range(1, order + 1):
        # (N/wᵏ)′ = (N′ w − k w′ N)/wᵏ⁺¹
        found = [f.d() * curve.w - (slope * f).scaled(k) for f in found]
        denominator = denominator * curve.w
    return found, denominator


def curvature_at(curve: Nurbs, place: mpq | Root, side: Side | str = Side.RIGHT) -> Real:
    """The curvature of a curve at a rational parameter or an irrational root."""
    if curve.dimension not in (2, 3):
        raise ShapeError(f"a curve in R{curve.dimension}", remedy="curvature needs a curve in the plane or in space")
    i = _segment(curve, place, side)
    _refuse_singular(curve, i, place, side)
    squared, turning = analyse(curve).once(("curvature on a segment", i), lambda: _curvature_forms(curve, i))
    sign = 1 if turning is None else sign_at(turning, place, side)
    if not isinstance(place, Root):
        return Real.of(square_root(_quotient(squared, place, side)) * sign)
    return Real.root_of_quotient_at(sign, squared.scalar, squared.denominator, place)


def _curvature_forms(curve: Nurbs, i: int) -> tuple[Rational[BSpline], BSpline | None]:
    """κ² on a segment, and in the plane a spline with the sign of κ."""
    c = _part(curve, i)
    if curve.dimension == 3:
        return find("space_curvature_squared")(c), None
    return find("curvature_squared")(c), find("f2")(c) * c.w


def torsion_at(curve: Nurbs, place: mpq | Root, side: Side | str = Side.RIGHT) -> Real:
    """The torsion of a space curve at a rational parameter or an irrational root."""
    i = _segment(space(curve), place, side)
    _refuse_singular(curve, i, place, side)
    tau = analyse(curve).once(("torsion on a segment", i), lambda: _torsion_form(curve, i))
    if sign_at(tau.denominator, place, side) == 0:
        raise DomainError(f"the torsion has a pole {_named(place)}", remedy="choose another parameter")
    if not isinstance(place, Root):
        return Real.of(_quotient(tau, place, side))
    return Real.quotient_at(tau.scalar, tau.denominator, place)


def _torsion_form(curve: Nurbs, i: int) -> Rational[BSpline]:
    """τ on a segment in lowest terms."""
    found = find("torsion")(_part(curve, i))
    if found.denominator.is_zero:
        raise ShapeError("the torsion of a straight piece", remedy="ask for it where the curve is not straight")
    reduced: Rational[BSpline] = in_lowest_terms(found)
    return reduced


def _segment(curve: Nurbs, place: mpq | Root, side: Side | str) -> int:
    """The number of the segment that holds a parameter or a root."""
    left = checked_side(side)
    return _segment_of_root(curve, place) if isinstance(place, Root) else curve.mesh.locate(place, left=left)


def _part(curve: Nurbs, i: int) -> Curve[BSpline]:
    """The curve over a segment."""
    return part(curve, *curve.breakpoints[i : i + 2])


def _segment_of_root(curve: Nurbs, root: Root) -> int:
    """The number of the segment with an irrational root inside."""
    a, b = curve.domain
    if not a < root < b:
        raise DomainError(f"the root is outside the domain [{text(a)}, {text(b)}]", remedy="stay inside")
    return next(i for i, t in enumerate(curve.breakpoints[1:]) if root < t)


def _quotient(value: Rational[BSpline], t: mpq, side: Side | str) -> mpq:
    return value.number(t, side=side)


def _refuse_singular(curve: Nurbs, i: int, place: mpq | Root, side: Side | str) -> None:
    velocity = analyse(curve).once(("velocity on a segment", i), lambda: tuple(find("D1")(_part(curve, i))))
    if all(sign_at(x, place, side) == 0 for x in velocity):
        raise DomainError(f"γ′ = 0 {_named(place)}", remedy="choose another parameter")


def _named(place: mpq | Root) -> str:
    return "at the root" if isinstance(place, Root) else f"at the parameter {text(place)}"
