"""The numeric reading: Taylor series of mpmath numbers to any precision, floating-point or intervals.

The expansion of a curve is made from its knots and control points alone: de Boor's triangle run at ``t + h``, a series
in h. It shares no code with the splines, so that their answers can be compared with it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, Protocol, cast

from gmpy2 import mpq

from exactspline import Nurbs, Side, rational
from exactspline.errors import DomainError
from exactspline.language import Vector
from exactspline.language.arguments import Curve
from exactspline.language.operand import CONSTANTS, Constant
from exactspline.numbers.exact import Number
from exactspline.readings.taylor import Coefficient, Series


class Arithmetic(Protocol):
    """What is needed from a context of mpmath."""

    def mpf(self, value: int, /) -> Coefficient:
        """A number of the arithmetic."""


class NumericSeries(Series):
    """A series of mpmath numbers; exact constants are rounded (in intervals: enclosed) when they are combined with it.

    >>> h = NumericSeries(arithmetic(30), [0, 1, 0])
    >>> [str(a) for a in (1 / (2 - h)).coefficients]
    ['0.5', '0.25', '0.125']
    """

    __slots__ = ("context",)

    def __init__(self, context: Arithmetic, coefficients: Iterable[Coefficient | Constant]) -> None:
        super().__init__(number(context, a) if isinstance(a, CONSTANTS) else a for a in coefficients)
        self.context = context

    def _made(self, series: Series) -> NumericSeries:
        return NumericSeries(self.context, series.coefficients)

    def constant(self, value: Constant) -> NumericSeries:
        """An exact constant."""
        return NumericSeries(self.context, [value, *[0] * (len(self.coefficients) - 1)])

    def __add__(self, other: object) -> NumericSeries:
        found = super().__add__(other)
        return self._made(found) if isinstance(found, Series) else found

    def __mul__(self, other: object) -> NumericSeries:
        found = super().__mul__(other)
        return self._made(found) if isinstance(found, Series) else found

    def reciprocal(self) -> NumericSeries:
        """``1 / a``; `FormulaError` when the value here is zero."""
        return self._made(super().reciprocal())

    def scaled(self, constant: Constant) -> NumericSeries:
        """The series times an exact constant."""
        return self._made(Series(self.coefficients).scaled(cast(Any, number(self.context, constant))))

    def d(self, order: int = 1, *, by: str | None = None) -> NumericSeries:
        """The derivative, known to correspondingly fewer terms."""
        return self._made(super().d(order, by=by))


def arithmetic(digits: int, *, intervals: bool = False) -> Arithmetic:
    """A separate context of mpmath with this many decimal digits; with `intervals`, every result encloses the true
    value.

    >>> str(number(arithmetic(40), "1/3"))
    '0.3333333333333333333333333333333333333333'
    """
    from mpmath.ctx_iv import MPIntervalContext
    from mpmath.ctx_mp import MPContext

    context = MPIntervalContext() if intervals else MPContext()
    context.dps = digits
    made: Arithmetic = context
    return made


def number(context: Arithmetic, value: Number) -> Coefficient:
    """An exact number in an arithmetic of mpmath."""
    q = rational(value)
    return context.mpf(int(q.numerator)) / int(q.denominator)


def numeric_curve(
    curve: Nurbs, t: Number, terms: int, digits: int, *, intervals: bool = False, side: Side | str = Side.RIGHT
) -> Curve[NumericSeries]:
    """The expansion of a curve at a parameter (at a knot the one on the given side) to this many terms and digits.

    >>> from exactspline.interchange.examples import example
    >>> from exactspline.papers import find
    >>> circle = numeric_curve(example("circle"), "1/3", 4, 30)
    >>> str(find("curvature_squared")(circle).value), find("g0")(circle).value < circle.w.context.mpf(10) ** -29
    ('1.0', True)

    Raises `DomainError` for a parameter outside the domain.
    """
    context, place, knots = arithmetic(digits, intervals=intervals), rational(t), list(curve.knots)
    j = _span(knots, curve.degree, place, side)
    weights = list(curve.weights)
    rows = [[x * w for x, w in zip(column, weights, strict=True)] for column in zip(*curve.control_points, strict=True)]
    first: list[Coefficient | Constant] = [place, 1, *[0] * terms]
    at = NumericSeries(context, first[:terms])
    made = [_de_boor(knots, curve.degree, points, j, at) for points in (*rows, weights)]
    return Curve(Vector(*made[:-1]), made[-1], polynomial=curve.polynomial)


def _span(knots: Sequence[mpq], n: int, t: mpq, side: Side | str) -> int:
    """The index j of a non-empty span [t_j, t_{j+1}] that holds t."""
    inside = [j for j in range(n, len(knots) - n - 1) if knots[j] < knots[j + 1] and knots[j] <= t <= knots[j + 1]]
    if not inside:
        raise DomainError(f"{t} is outside the domain", remedy="choose a parameter of the curve")
    return inside[0] if side == Side.LEFT else inside[-1]


def _de_boor(knots: Sequence[mpq], n: int, points: Sequence[mpq], j: int, at: NumericSeries) -> NumericSeries:
    """De Boor's triangle over the span j, the parameter a series."""
    row = [at.constant(points[i]) for i in range(j - n, j + 1)]
    for r in range(1, n + 1):
        for k in range(n, r - 1, -1):
            low, high = knots[j - n + k], knots[j + 1 + k - r]
            share = (at - low) / (high - low)
            row[k] = row[k - 1] + (row[k] - row[k - 1]) * share
    return row[n]
