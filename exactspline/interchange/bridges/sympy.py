"""sympy: the coordinates of a curve as `Piecewise` expressions."""

from __future__ import annotations

from itertools import pairwise
from math import comb
from typing import TYPE_CHECKING

from exactspline.errors import as_instance
from exactspline.numbers.exact import mpq
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of

if TYPE_CHECKING:
    import sympy


def to_sympy(curve: Nurbs | BSpline, symbol: sympy.Symbol) -> tuple[sympy.Expr, ...]:
    """The coordinates over the domain, each a `Piecewise` in the symbol: segments are half-open intervals [a, b), the
    last one closed.

    >>> from sympy import Symbol
    >>> to_sympy(BSpline(2, [0, 0, 0, 1, 1, 1], [0, 1, 0]), Symbol("t"))
    (Piecewise((-2*t**2 + 2*t, (t >= 0) & (t <= 1))),)

    Raises `ExactSplineError` for what is not a curve, a spline or a symbol.
    """
    import sympy

    as_instance(symbol, sympy.Symbol, "a symbol", 'give sympy.Symbol("t")')
    parts = [curve] if isinstance(curve, BSpline) else list(curve_of(curve).p)
    numerators = [_polynomials(part, symbol) for part in parts]
    denominators = (
        [sympy.Integer(1)] * len(numerators[0])
        if isinstance(curve, BSpline) or curve.polynomial
        else _polynomials(curve.w, symbol)
    )
    breaks = [sympy.Rational(str(t)) for t in curve.breakpoints]
    conditions = [sympy.And(symbol >= a, symbol < b) for a, b in pairwise(breaks)]
    conditions[-1] = sympy.And(symbol >= breaks[-2], symbol <= breaks[-1])
    return tuple(
        sympy.Piecewise(*((p / w, where) for p, w, where in zip(row, denominators, conditions, strict=True)))
        for row in numerators
    )


def _polynomials(spline: BSpline, symbol: sympy.Symbol) -> list[sympy.Expr]:
    """One polynomial per segment, in powers of the symbol."""
    import sympy

    polynomials = []
    for (a, b), points in zip(pairwise(spline.breakpoints), spline.bezier_points, strict=True):
        n = len(points) - 1
        # in powers of u = (t − a)/(b − a)
        powers = [
            comb(n, k) * sum(((-1) ** (k - i) * comb(k, i) * points[i] for i in range(k + 1)), start=mpq(0))
            for k in range(n + 1)
        ]
        local = sympy.Poly([1, sympy.Rational(str(-a))], symbol) * sympy.Rational(str(1 / (b - a)))
        value = sympy.Poly(0, symbol)
        for c in reversed(powers):
            value = value * local + sympy.Rational(str(c))
        polynomials.append(value.as_expr())
    return polynomials
