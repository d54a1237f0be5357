"""The order reading: the highest derivative of a curve in a formula, which determines the jet ring."""

from __future__ import annotations

from functools import lru_cache
from typing import Any, cast

from exactspline.errors import FormulaError
from exactspline.language.adjoined_root import Adjoined
from exactspline.language.arguments import Evaluated
from exactspline.language.formula import Formula, Reading
from exactspline.language.kinds import CURVE, Kind
from exactspline.language.operand import CONSTANTS, Constant, FieldOperand
from exactspline.language.ruled import joined
from exactspline.language.vector import Vector
from exactspline.numbers.exact import mpq


class Order(FieldOperand):
    """The highest derivative in an expression, and whether it is a quotient.

    >>> (Order(1) * Order(0)).d(2).order, (Order(1) / Order(2)).quotient
    (3, True)
    """

    __slots__ = ("order", "quotient")
    degree = 0
    provenance = 0
    is_zero = False

    def __init__(self, order: int, *, quotient: bool = False) -> None:
        self.order, self.quotient = order, quotient

    def _plus(self, right: Order) -> Order:
        return Order(max(self.order, right.order), quotient=self.quotient or right.quotient)

    _times = _plus

    def __truediv__(self, other: object) -> Order:
        if isinstance(other, CONSTANTS):
            return self.scaled(1 / mpq(other))
        return super().__truediv__(cast(Order, other))

    def reciprocal(self) -> Order:
        """A quotient of the same order."""
        return Order(self.order, quotient=True)

    def scaled(self, constant: Constant) -> Order:
        """The same order: a constant factor needs no derivative."""
        return self

    def constant(self, value: Constant) -> Order:
        """Order 0: a constant needs no derivative."""
        return Order(0)

    def d(self, order: int = 1, *, by: str | None = None) -> Order:
        """The order increased by that of the derivative."""
        return Order(self.order + order, quotient=self.quotient)


class _OrderReading(Reading):
    """The reading in which every operand has order 0."""

    name = "order"

    def argument(self, kind: Kind, dimension: int, *, polynomial: bool = False) -> Evaluated:
        """The operands, all of order 0."""
        return kind.argument(dimension, lambda _: Order(0), Order(0), polynomial=polynomial)


def is_polynomial(formula: Formula, dimension: int) -> bool:
    """Whether a formula is a polynomial in the numerators, the denominator and their derivatives on a rational curve,
    and not a quotient.

    >>> from exactspline.papers.chen_riesenfeld_cohen_2007.plane import f0, f2
    >>> is_polynomial(f2, 2), is_polynomial(f0, 2)
    (True, False)
    """
    value = orders(formula, dimension)
    parts = value if isinstance(value, Vector) else [value]
    return all(isinstance(part, Order) and not part.quotient for part in parts)


def order_of(formula: Formula, dimension: int, kind: Kind | None = None) -> int:
    """The order of the highest derivative of the curve in a formula, on its own kind of argument or on another one.

    Raises `FormulaError` if the value, or a component, is a number instead of an operand.

    >>> from exactspline.papers.chen_riesenfeld_cohen_2007.derivatives import D3
    >>> order_of(D3, 3)
    3
    """
    return _highest(orders(formula, dimension, kind), formula)


def _highest(value: Any, formula: Formula) -> int:
    if isinstance(value, Order):
        return value.order
    if isinstance(value, CONSTANTS):
        problem = f"{getattr(formula, 'name', 'the formula')} returns a number"
        raise FormulaError(problem, remedy="write it with an operand: 1 + 0 * c.w")
    parts = (value.plain, value.rooted, value.square) if isinstance(value, Adjoined) else tuple(value)
    return max(_highest(part, formula) for part in parts)


@lru_cache(4096)
def orders(formula: Formula, dimension: int, kind: Kind | None = None) -> object:
    """The value of a formula in this reading, for curves of a dimension."""
    kind = kind or (formula.kind if isinstance(formula, Formula) else CURVE)
    return joined(formula(_argument(kind, dimension)))


@lru_cache(64)
def _argument(kind: Kind, dimension: int) -> Evaluated:
    """One argument for all formulas of a kind, so that common subformulas are evaluated once."""
    return _OrderReading().argument(kind, dimension).remembering()
