"""Polynomials of peers for the inline formulas: `Fraction`, and sympy's, in powers of t."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import zip_longest
from math import comb
from typing import TYPE_CHECKING, Any

from exactspline.language.arguments import Curve
from exactspline.language.operand import CONSTANTS
from exactspline.language.rational import RingOperand
from exactspline.language.vector import Vector
from exactspline.numbers.exact import mpq, mpz
from exactspline.splines.nurbs import Nurbs

if TYPE_CHECKING:
    import sympy

Constant = int | mpz | mpq | Fraction


class FractionPoly:
    """A polynomial with coefficients in Python's fractions.

    >>> p = FractionPoly([1, 1])
    >>> (p * p - 2 * p).coefficients
    [Fraction(-1, 1), Fraction(0, 1), Fraction(1, 1)]
    """

    def __init__(self, coefficients: Sequence[Fraction | int]) -> None:
        self.coefficients = [Fraction(c) for c in coefficients]

    def __add__(self, other: FractionPoly) -> FractionPoly:
        return FractionPoly([a + b for a, b in zip_longest(self.coefficients, other.coefficients, fillvalue=0)])

    def __sub__(self, other: FractionPoly) -> FractionPoly:
        return FractionPoly([a - b for a, b in zip_longest(self.coefficients, other.coefficients, fillvalue=0)])

    def __mul__(self, other: FractionPoly | int) -> FractionPoly:
        if isinstance(other, int):
            return FractionPoly([other * a for a in self.coefficients])
        products = [Fraction(0)] * (len(self.coefficients) + len(other.coefficients) - 1)
        for i, a in enumerate(self.coefficients):
            for j, b in enumerate(other.coefficients):
                products[i + j] += a * b
        return FractionPoly(products)

    __rmul__ = __mul__

    def derivative(self) -> FractionPoly:
        """The derivative."""
        return FractionPoly([i * a for i, a in enumerate(self.coefficients)][1:] or [0])


def powers(c: Nurbs) -> list[list[list[Fraction]]]:
    """The components and the weight of every segment in powers of its local parameter from 0 to 1."""
    rows = zip(*[spline.bezier_points for spline in (*c.p, c.w)], strict=True)
    return [[_in_powers([Fraction(str(b)) for b in points]) for points in row] for row in rows]


def _in_powers(points: Sequence[Fraction]) -> list[Fraction]:
    n = len(points) - 1
    return [comb(n, k) * sum((-1) ** (k - i) * comb(k, i) * points[i] for i in range(k + 1)) for k in range(n + 1)]


def sympy_polys(c: Nurbs) -> list[list[sympy.Poly]]:
    """The same as polynomials of sympy over the rational numbers."""
    import sympy

    t = sympy.Symbol("t")
    return [
        [sympy.Poly([sympy.Rational(a.numerator, a.denominator) for a in reversed(p)], t, domain="QQ") for p in row]
        for row in powers(c)
    ]


class SympyOperand(RingOperand):
    """A polynomial of sympy as an operand, differentiated by one of its variables: the library's formulas run
    over it.
    """

    __slots__ = ("poly", "variable")
    provenance = degree = 0

    def __init__(self, poly: sympy.Poly, variable: sympy.Symbol) -> None:
        self.poly, self.variable = poly, variable

    def __add__(self, other: object) -> SympyOperand:
        right = self.coerced(other)
        return NotImplemented if right is None else SympyOperand(self.poly + right.poly, self.variable)

    def __mul__(self, other: object) -> SympyOperand:
        if isinstance(other, CONSTANTS):
            return self.scaled(other)
        return (
            SympyOperand(self.poly * other.poly, self.variable) if isinstance(other, SympyOperand) else NotImplemented
        )

    def __eq__(self, other: object) -> bool:
        return isinstance(other, SympyOperand) and bool(self.poly == other.poly)

    __hash__ = None  # type: ignore[assignment]  # operands are compared by value

    def constant(self, number: Constant) -> SympyOperand:
        """A constant polynomial."""
        return SympyOperand(self.poly * 0 + _rational(number), self.variable)

    def scaled(self, constant: Constant) -> SympyOperand:
        """A multiple."""
        return SympyOperand(self.poly * _rational(constant), self.variable)

    def elevated_to(self, other: object) -> SympyOperand:
        """Itself: powers of t need no elevation."""
        return self

    def d(self, order: int = 1, *, by: str | None = None) -> SympyOperand:
        """A derivative."""
        return SympyOperand(self.poly.diff((self.variable, order)), self.variable)


def _rational(number: Constant) -> Any:
    import sympy

    return sympy.Rational(str(number))


def sympy_arguments(c: Nurbs) -> list[Curve[SympyOperand]]:
    """The curve segment by segment over sympy's polynomials, for the library's formulas."""
    rows = sympy_polys(c)
    operands = [[SympyOperand(poly, poly.gen) for poly in row] for row in rows]
    return [Curve(Vector(*row[:-1]), row[-1]) for row in operands]
