"""The series reading: truncated Taylor series at a parameter. It gives values and derivatives of any formula at that
parameter, without splines or quotient rules.

Coefficients have the type of numbers in the expansion of the curve: ``mpq`` (exact), ``mpf`` of mpmath, or intervals.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from math import factorial
from typing import Any, Protocol, Self, cast

from exactspline.errors import FormulaError, as_instance, as_integer, counted
from exactspline.language.arguments import Curve, Evaluated, T
from exactspline.language.formula import Reading
from exactspline.language.kinds import Kind
from exactspline.language.operand import Constant, FieldOperand, Parameter, Scalar
from exactspline.numbers.exact import Number, mpq
from exactspline.numbers.intervals import Side
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
        return cast(Coefficient, self.coefficients[0])

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
    """Return the Taylor expansion of a curve at a parameter."""
    curve = as_instance(curve, Curve, "a curve", 'give one such as exactspline.example("cusp")')
    terms = as_integer(terms, "a number of terms", 1)
    return cast("Curve[Series]", curve.mapped(lambda spline: taylor(cast(Function, spline), t, terms, side)))


# ---- surfaces
#
# These series give values and partial derivatives of any formula at a point, without splines or quotient rules.


#: Nonzero coefficients by the exponents of the two variables: exact numbers, or objects with the same operations.
Coefficients = dict[tuple[int, int], mpq]


class DoubleSeries(FieldOperand):
    """``Σ a_ij h^i k^j`` with exact coefficients, known for ``i + j < terms``.

    >>> h, k = DoubleSeries({(1, 0): mpq(1)}, 3), DoubleSeries({(0, 1): mpq(1)}, 3)
    >>> (1 / (1 - h * k - h)).coefficients
    {(0, 0): mpq(1,1), (1, 0): mpq(1,1), (1, 1): mpq(1,1), (2, 0): mpq(1,1)}
    """

    __slots__ = ("coefficients", "terms")
    degree = 0

    def __init__(self, coefficients: Mapping[tuple[int, int], mpq], terms: int) -> None:
        known = {place: a for place, a in coefficients.items() if a and sum(place) < terms}
        self.coefficients, self.terms = dict(sorted(known.items())), terms

    @staticmethod
    def number(value: Constant) -> mpq:
        """A constant as a coefficient."""
        return mpq(value)

    def constant(self, value: Constant) -> Self:
        """An exact constant."""
        return type(self)({(0, 0): self.number(value)}, self.terms)

    def _plus(self, right: Self) -> Self:
        total = dict(self.coefficients)
        for place, a in right.coefficients.items():
            total[place] = total[place] + a if place in total else a
        return type(self)(total, min(self.terms, right.terms))

    def _times(self, right: Self) -> Self:
        product, terms = Coefficients(), min(self.terms, right.terms)
        others = [(m, n, b) for (m, n), b in right.coefficients.items() if m + n < terms]
        for (i, j), a in self.coefficients.items():
            for m, n, b in others:
                if i + j + m + n < terms:
                    place = i + m, j + n
                    product[place] = product[place] + a * b if place in product else a * b
        return type(self)(product, terms)

    def reciprocal(self) -> Self:
        """``1 / a``; raises `FormulaError` if the constant term is zero."""
        if not self.value:
            raise FormulaError("division by a series that vanishes at this point", remedy="expand at another point")
        inverse = self.constant(1 / self.value)
        rest, power, total = 1 - self * inverse, self.constant(1), self.constant(1)
        for _ in range(1, self.terms):
            power = power * rest
            total = total + power
        return total * inverse

    def scaled(self, constant: Constant) -> Self:
        """The series times an exact constant."""
        return type(self)({place: a * self.number(constant) for place, a in self.coefficients.items()}, self.terms)

    def d(self, order: int = 1, *, by: str | None = None) -> Self:
        """The derivative with respect to one of the two parameters, with `order` fewer terms.

        Raises `FormulaError` if no parameter is named, and for derivatives beyond the known terms.
        """
        if by not in (Parameter.U, Parameter.V):
            raise FormulaError(
                f"a derivative with respect to {by!r} of a function of u and v", remedy='write d(1, by="u")'
            )
        if order >= self.terms:
            raise FormulaError(
                f"a derivative of order {order} of a series of {self.terms} terms", remedy="expand further"
            )
        which, derived = (0 if by == Parameter.U else 1), Coefficients()
        for place, a in self.coefficients.items():
            if (n := place[which]) >= order:
                lowered = tuple(e - order if k == which else e for k, e in enumerate(place))
                derived[lowered[0], lowered[1]] = a * (factorial(n) // factorial(n - order))
        return type(self)(derived, self.terms - order)

    @property
    def value(self) -> mpq:
        """The value at the point."""
        return self.coefficients.get((0, 0), self.number(0))

    @property
    def is_zero(self) -> bool:
        """Whether all known coefficients vanish."""
        return not self.coefficients

    @one_line
    def __repr__(self) -> str:
        return f"DoubleSeries({self.coefficients}, {self.terms})"


class _FunctionOfTwo(Protocol):
    """A function of two parameters that can be expanded."""

    def partial(self, i: int, j: int) -> Self:
        """The derivative of order i in the first and j in the second parameter."""

    def __call__(self, s: Number, t: Number) -> mpq:
        """The value at two parameters."""


def double_taylor(spline: _FunctionOfTwo, u: Number, v: Number, terms: int) -> DoubleSeries:
    """The expansion of a spline in two parameters at a point (at a knot, from the right).

    >>> from exactspline import TensorSpline
    >>> f = TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[0, 0], [0, 1]])
    >>> double_taylor(f, "1/2", 0, 3).coefficients
    {(0, 1): mpq(1,2), (1, 1): mpq(1,1)}
    """
    places = [(i, j) for i in range(terms) for j in range(terms - i)]
    known = {(i, j): spline.partial(i, j)(u, v) / (factorial(i) * factorial(j)) for i, j in places}
    return DoubleSeries(known, terms)


class DoubleTaylorReading(Reading):
    """A surface made of splines, expanded at a point to this many terms.

    >>> from exactspline import example
    >>> from exactspline.language.kinds import SURFACE
    >>> from exactspline.papers import find
    >>> sphere = DoubleTaylorReading(example("sphere"), "1/3", "1/4", 3).argument(SURFACE, 3)
    >>> find("surfaces:gaussian_curvature")(sphere).value
    mpq(1,1)
    """

    name = "series in two variables"

    def __init__(self, given: Evaluated, u: Number, v: Number, terms: int) -> None:
        self.given, self.place, self.terms = given, (u, v), terms

    def argument(self, kind: Kind, dimension: int, *, polynomial: bool = False) -> Evaluated:
        """The expansion of the given surface."""
        u, v = self.place
        # the operands of the given argument are functions
        return self.given.mapped(lambda operand: double_taylor(cast(_FunctionOfTwo, operand), u, v, self.terms))
