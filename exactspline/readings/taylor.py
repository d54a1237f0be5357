"""The series reading: truncated Taylor series at a parameter. It gives values and derivatives of any formula there,
without splines or quotient rules.

Coefficients have the type of numbers in the expansion of the curve: ``mpq`` (exact), ``mpf`` of mpmath, or intervals.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import factorial
from typing import Any, Protocol, Self, cast

from exactspline.errors import FormulaError, as_instance, as_integer, counted
from exactspline.language.arguments import Curve, T
from exactspline.language.operand import Constant, FieldOperand, Scalar
from exactspline.numbers.exact import Number, mpq
from exactspline.numbers.sides import Side
from exactspline.one_line import one_line


class Coefficient(Scalar, Protocol):
    """A coefficient of a series."""

    def __truediv__(self, other: int, /) -> Self: ...


class Series(FieldOperand):
    """A truncated series ``a_0 + a_1 h + a_2 h² + …``.

    >>> h = Series([mpq(0), mpq(1), mpq(0), mpq(0)])
    >>> (1 / (1 - h)).coefficients
    (mpq(1,1), mpq(1,1), mpq(1,1), mpq(1,1))
    """

    __slots__ = ("coefficients",)
    degree = 0
    coefficients: tuple[Any, ...]

    def __init__(self, coefficients: Iterable[Coefficient]) -> None:
        self.coefficients = tuple(coefficients)

    def constant(self, value: Constant) -> Series:
        """An exact constant."""
        zero = self.coefficients[0] * 0
        return Series([zero + value, *[zero] * (len(self.coefficients) - 1)])

    def _plus(self, right: Series) -> Series:
        return Series(a + b for a, b in zip(self.coefficients, right.coefficients, strict=False))

    def _times(self, right: Series) -> Series:
        a, b = self.coefficients, right.coefficients
        return Series(sum(a[j] * b[i - j] for j in range(i + 1)) for i in range(min(len(a), len(b))))

    def reciprocal(self) -> Series:
        """``1 / a``; raises `FormulaError` if the constant term is zero."""
        a = self.coefficients
        if a[0] == 0:
            raise FormulaError(
                "division by a series that vanishes at this parameter", remedy="expand at another parameter"
            )
        b: list[Any] = [1 / a[0]]
        for i in range(1, len(a)):
            b.append(-b[0] * sum(a[j] * b[i - j] for j in range(1, i + 1)))
        return Series(b)

    def scaled(self, constant: Constant) -> Series:
        """The series times an exact constant."""
        return Series(a * constant for a in self.coefficients)

    def d(self, order: int = 1, *, by: str | None = None) -> Series:
        """The derivative, with correspondingly fewer terms."""
        self.only_parameter(by)
        if order >= len(self.coefficients):
            problem = f"a derivative of order {order} of a series of {counted(len(self.coefficients), 'term')}"
            raise FormulaError(problem, remedy="expand further")
        return Series(a * (factorial(i) // factorial(i - order)) for i, a in enumerate(self.coefficients) if i >= order)

    @property
    def value(self) -> Coefficient:
        """The value at the parameter."""
        value: Coefficient = self.coefficients[0]
        return value

    @property
    def is_zero(self) -> bool:
        """Whether all known coefficients vanish."""
        return all(a == 0 for a in self.coefficients)

    @one_line
    def __repr__(self) -> str:
        return f"Series({', '.join(map(str, self.coefficients))})"


class Function(Protocol):
    """A piecewise polynomial that can be expanded."""

    @property
    def degree(self) -> int:
        """The degree."""

    def d(self, order: int = 1) -> Self:
        """The derivative of the given order."""

    def __call__(self, t: Number, side: Side | str = Side.RIGHT) -> mpq:
        """The value at a parameter."""


def taylor(spline: Function, t: Number, terms: int, side: Side | str = Side.RIGHT) -> Series:
    """The expansion of a spline at a parameter (at a knot, on the given side).

    >>> from exactspline import BSpline
    >>> taylor(BSpline.bezier([0, 0, 1]), "1/2", 3).coefficients
    (mpq(1,4), mpq(1,1), mpq(1,1))
    """
    coefficients, derivative = [], spline
    for i in range(terms):
        coefficients.append(derivative(t, side) / factorial(i) if i <= spline.degree else mpq(0))
        derivative = derivative.d() if i < spline.degree else derivative
    return Series(coefficients)


def series_curve(curve: Curve[T], t: Number, terms: int, side: Side | str = Side.RIGHT) -> Curve[Series]:
    """The expansion of a concrete curve at a parameter."""
    curve = as_instance(curve, Curve, "a curve", 'give one such as exactspline.example("cusp")')
    terms = as_integer(terms, "a number of terms", 1)
    expanded: Curve[Series] = curve.mapped(lambda spline: taylor(cast(Function, spline), t, terms, side))
    return expanded
