"""sympy: the coordinates of a curve as `Piecewise` expressions."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

from exactspline.errors import as_instance
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of

if TYPE_CHECKING:
    import sympy


def to_sympy(curve: Nurbs | BSpline, symbol: sympy.Symbol | None = None) -> tuple[sympy.Expr, ...]:
    """The coordinates over the domain, each a `Piecewise` in the symbol, by default t: segments are half-open intervals
    [a, b), the last one closed.

    >>> to_sympy(BSpline(2, [0, 0, 0, 1, 1, 1], [0, 1, 0]))
    (Piecewise((-2*t**2 + 2*t, (t >= 0) & (t <= 1))),)

    Raises `ExactSplineError` for what is not a curve, a spline or a symbol.
    """
    import sympy

    symbol = sympy.Symbol("t") if symbol is None else symbol
    as_instance(symbol, sympy.Symbol, "a symbol", 'give sympy.Symbol("t")')
    parts = [curve] if isinstance(curve, BSpline) else list(curve_of(curve).p)
    numerators = [_polynomials(part, symbol) for part in parts]
    denominators = [1] * len(numerators[0]) if isinstance(curve, BSpline) else _polynomials(curve.w, symbol)
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

    rows = ([sympy.Rational(int(c.p), int(c.q)) for c in p.coeffs()[::-1]] for p in spline.polynomials)
    return [sympy.Poly(row or [0], symbol).as_expr() for row in rows]
