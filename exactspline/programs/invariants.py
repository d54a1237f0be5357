"""Tangent, binormal, curvature and its derivative up to positive factors, at their true degrees, by one program.

Wronskians of the lift ``P = (w, p)`` are computed from partial derivatives (see `exactspline.splines.wronskian`), and
``κ² = f² w⁶/s³`` (in space with ‖b‖² for f²) is a quotient of forms that is homogeneous of degree 0: there ``u ∂u + v
∂v`` is zero by Euler's relation, so that where ``u + v = 1`` the derivative ``∂v − ∂u`` is ``∂v/u``. The numerator of
(κ²)′/κ² comes out as ``(2 f_v w s + 6 f w_v s − 3 f w s_v)/u``: of degree 8n − 12, as the Wronskian of the conformal
lift, with a third of its products.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, TypeVar

from exactspline.language.arguments import Curve
from exactspline.language.formula import Formula
from exactspline.language.kinds import CURVE, PLANE, SPACE, Kind
from exactspline.language.vector import Vector, join, norm2
from exactspline.programs.program import Given
from exactspline.programs.term import Term
from exactspline.programs.wronskian import lowest
from exactspline.splines.bspline import BSpline
from exactspline.splines.values import SplineValue

#: What the formulas here are evaluated on: terms of a program, or splines.
T = TypeVar("T", Term, BSpline)


def _as_formula(kind: Kind) -> Callable[[Callable[[Any], object]], Formula]:
    return lambda function: Formula(function, "lifted, at its true degree", kind, "")


@_as_formula(CURVE)
def tangent(c: Curve[T]) -> Vector[T]:
    """γ′ times w²."""
    return c.p.d(1) if c.polynomial else Vector(*[lowest(Vector(c.w, x)) for x in c.p])


@_as_formula(PLANE)
def turning(c: Curve[T]) -> T:
    """``[γ′ γ″]`` times w³."""
    return lowest(tangent(c) if c.polynomial else join(c.w, c.p))


@_as_formula(SPACE)
def bending(c: Curve[T]) -> Vector[T]:
    """``γ′ × γ″`` times w³."""
    x, y, z = tangent(c) if c.polynomial else c.p
    beside = () if c.polynomial else (c.w,)
    return Vector(*[lowest(Vector(*beside, *two)) for two in ((y, z), (z, x), (x, y))])


@_as_formula(SPACE)
def twisting(c: Curve[T]) -> T:
    """``[γ′ γ″ γ‴]`` times w⁴."""
    found: T = turning.function(c)
    return found


@_as_formula(PLANE)
def slope(c: Curve[T]) -> T:
    """κ′ times a power of ‖γ′‖ and w⁸."""
    found: T = _slope([(turning(c), 2), (norm2(tangent(c)), -3)], c)
    return found


@_as_formula(SPACE)
def space_slope(c: Curve[T]) -> T:
    """κκ′ times a power of ‖γ′‖ and w¹¹."""
    found: T = _slope([(norm2(bending(c)), 1), (norm2(tangent(c)), -3)], c)
    return found


#: What is computed at once for a curve in the plane and in space, and how many components each value has.
TOGETHER = {2: {tangent: 2, turning: 1, slope: 1}, 3: {tangent: 3, bending: 3, twisting: 1, space_slope: 1}}

INVARIANTS = frozenset(formula for own in TOGETHER.values() for formula in own)


@_as_formula(PLANE)
def plane_invariants(c: Curve[T]) -> Vector[T]:
    """All of a plane curve."""
    return join(*[each(c) for each in TOGETHER[2]])


@_as_formula(SPACE)
def space_invariants(c: Curve[T]) -> Vector[T]:
    """All of a space curve."""
    return join(*[each(c) for each in TOGETHER[3]])


def invariants(given: Given) -> dict[Formula, SplineValue]:
    """All of a curve, by one program.

    >>> from exactspline.language.kinds import PLANE
    >>> from exactspline.programs.program import operands_of
    >>> from exactspline.splines.examples import example
    >>> from exactspline.splines.lowest_terms import in_lowest_terms
    >>> found = invariants(operands_of(PLANE, example("rational_cubic")))
    >>> found[turning].degree, in_lowest_terms(found[slope]).degree
    (3, 12)
    """
    dimension = given.signature.dimension
    value = given.value(plane_invariants if dimension == 2 else space_invariants)
    assert isinstance(value, Vector)
    components = iter(value)
    found: dict[Formula, SplineValue] = {}
    for formula, count in TOGETHER[dimension].items():
        own = [next(components) for _ in range(count)]
        found[formula] = own[0] if count == 1 else Vector(*own)
    return found


def _slope(powers: Sequence[tuple[Any, int]], c: Curve[T]) -> Any:
    """``Π f · F′/F`` of ``F = w⁶ · Π fᵉ``, which is homogeneous of degree 0 on rational curves."""
    powers = powers if c.polynomial else [*powers, (c.w, 6)]
    over_u = not c.polynomial and isinstance(c.w, Term)
    total = None
    for k, (f, e) in enumerate(powers):
        product = f.by_v() if over_u else f.d(1)
        for j, (other, _) in enumerate(powers):
            product = product * other if j != k else product
        total = product * e if total is None else total + product * e
    assert total is not None
    return total.over_u().per_width(1, 1) if over_u else total
