"""Functions for checks on a concrete curve: all are exact, by multiplication and never by sampling."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import prod
from typing import Any, cast

from flint import fmpz_poly

from exactspline.language.arguments import Curve, Evaluated, Operands
from exactspline.language.surface_kind import Surface
from exactspline.language.vector import Vector
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval
from exactspline.polynomials.factors import greatest_common_divisor
from exactspline.polynomials.isolation import zero_on_segment
from exactspline.splines.bspline import BSpline
from exactspline.splines.inputs import checked_degree
from exactspline.splines.lowest_terms import common_factor
from exactspline.splines.tensor import TensorSpline
from exactspline.verification.evaluation import place_between, segment
from exactspline.verification.evidence import At, AtBoth, Place, StatedFactor
from exactspline.verification.notation import WEIGHTS, factor_parts
from exactspline.verification.vocabulary import Name


def where_it_differs(
    difference: BSpline | TensorSpline, divisors: Sequence[BSpline | TensorSpline] = ()
) -> tuple[mpq, At | AtBoth]:
    """The value of a nonzero spline divided by others at a parameter (a pair for splines in two parameters) at which
    none of them vanishes; no divisor vanishes on a whole segment.
    """
    if isinstance(difference, TensorSpline):
        return _not_zero_at_both(difference, cast("Sequence[TensorSpline]", divisors))
    t, value = _not_zero(difference, cast("Sequence[BSpline]", divisors))
    return value, At(t)


def _not_zero_at_both(f: TensorSpline, divisors: Sequence[TensorSpline]) -> tuple[mpq, AtBoth]:
    n = sum(g.degree.t * len(g.meshes[0]) for g in (f, *divisors))
    # in every segment one line more than the number of lines of zeros that a patch can have
    inside = (c + (d - c) / mpq(j) for c, d in pairwise(f.meshes[1].breaks) for j in range(2, n + 3))
    lines = ((t, f.at_t(t), [g.at_t(t) for g in divisors]) for t in inside)
    t, line, below = next(x for x in lines if not (x[1].is_zero or any(g.vanishes_somewhere for g in x[2])))
    s, value = _not_zero(line, below)
    return value, AtBoth(s, t)


def _not_zero(f: BSpline, divisors: Sequence[BSpline]) -> tuple[mpq, mpq]:
    """A parameter at which a nonzero spline and its divisors do not vanish, and the quotient there."""
    n = f.degree + sum(g.degree for g in divisors) + 3
    return next(
        (t, value / prod(below))
        for p, (a, b) in zip(f.numerators, pairwise(f.breakpoints), strict=True)
        if p
        for t in (a + (b - a) * mpq(j, n) for j in range(1, n))
        if (value := f(t)) and all(below := [g(t) for g in divisors])
    )


def stated_factor(factor: str, c: Evaluated | Operands) -> StatedFactor:
    """A factor as stated; for splines also whether the factor is 1, as powers of w are on polynomial curves.

    >>> from exactspline.interchange.examples import example
    >>> [str(stated_factor("w^-3", example(name))) for name in ("circle", "parabola")]
    ['w⁻³', 'w⁻³ = 1 (polynomial: w = 1)']
    """
    powers = tuple((Name(name), exponent) for name, exponent in factor_parts(factor))
    known = [each for each in c.together() if isinstance(each, (Curve, Surface))]
    splines = all(isinstance(each.w, BSpline | TensorSpline) for each in known)
    polynomial = bool(known) and splines and all(each.polynomial for each in known)
    return StatedFactor(powers, polynomial and all(name in WEIGHTS for name, _ in powers))


def common_zeros(components: list[BSpline]) -> BSpline:
    """A spline that vanishes exactly where all the components do."""
    return components[0] if len(components) == 1 else common_factor(Vector(*components))


def extra_zero(a: BSpline, b: BSpline) -> Place | None:
    """A place where a vanishes and b does not vanish; None if there is none.

    >>> t = BSpline.identity(0, 1)
    >>> extra_zero(t * (t - 1), t), extra_zero(t, t * t)
    (<at the parameter 1 (from the left)>, None)
    """
    for i, (p, q) in enumerate(zip(a.numerators, b.numerators, strict=True)):
        if not p and not q:
            continue
        if not p:
            return segment(a, i)
        low, high = a.breakpoints[i : i + 2]
        rest, n = _without(p, q)
        zero = zero_on_segment(rest, n)
        if zero and not (zero[0] == zero[1] == 1 and q and q[b.degree] == 0):
            return place_between(Interval(low, high).part(zero))
        if p[a.degree] == 0 and q and q[b.degree] != 0:
            return At(high, from_left=True)
    return None


def _without(p: fmpz_poly, q: fmpz_poly) -> tuple[fmpz_poly, int]:
    """p without the factors it shares with q, and the degree of p (without roots at the right end, z = ∞)."""
    common = greatest_common_divisor([p, q])
    while common.degree() > 0:
        p = p // common
        common = greatest_common_divisor([p, q])
    return p, p.degree()


def table_1_splines(d1: int = 2, d2: int = 3) -> Operands:
    """Return splines as the operands of the paper's Table 1, with different degrees and knots and with positive
    denominators.
    """
    d1, d2 = checked_degree(d1), checked_degree(d2)
    state = 12345

    def number() -> int:
        nonlocal state
        state = (1103515245 * state + 12345) % 2**31
        return state // 65536 % 100 + 1

    def spline(d: int, inner: list[Any]) -> BSpline:
        knots = [0] * (d + 1) + inner + [3] * (d + 1)
        return BSpline(d, knots, [number() for _ in range(len(knots) - d - 1)])

    one, two = [spline(d1, [1, 2]) for _ in range(5)], [spline(d2, ["1/2", 2, 2]) for _ in range(5)]
    return Operands(p1=one[0], w1=one[1], v1=Vector(*one[2:]), p2=two[0], w2=two[1], v2=Vector(*two[2:]))
