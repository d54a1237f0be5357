"""Curves as explicit functions of t, for statements that fail: quotients of polynomials in one variable."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from flint import fmpq_poly

from exactspline.exact import rational, to_fmpq
from exactspline.language.arguments import COORDINATES, POINT, Curve
from exactspline.language.kinds import Kind, Symbol
from exactspline.language.operand import Constant, FieldOperand


class RationalFunction(FieldOperand):
    """``top / bottom``, two polynomials in t.

    >>> t = RationalFunction(fmpq_poly([0, 1]))
    >>> (1 / t).d() == -1 / (t * t)
    True
    """

    __slots__ = ("bottom", "top")
    degree = provenance = 0

    def __init__(self, top: fmpq_poly, bottom: fmpq_poly | None = None) -> None:
        below = fmpq_poly([1]) if bottom is None else bottom
        common = top.gcd(below)
        self.top, self.bottom = top // common, below // common

    def constant(self, value: Constant) -> RationalFunction:
        """An exact constant."""
        return RationalFunction(fmpq_poly([to_fmpq(rational(value))]))

    def __add__(self, other: object) -> RationalFunction:
        right = self.beside(other)
        if right is None:
            return NotImplemented
        return RationalFunction(self.top * right.bottom + right.top * self.bottom, self.bottom * right.bottom)

    def __mul__(self, other: object) -> RationalFunction:
        right = self.beside(other)
        if right is None:
            return NotImplemented
        return RationalFunction(self.top * right.top, self.bottom * right.bottom)

    def reciprocal(self) -> RationalFunction:
        """``1 / a``; `ZeroDivisionError` for zero."""
        if not self.top:
            raise ZeroDivisionError("division by a function that is zero")
        return RationalFunction(self.bottom, self.top)

    def scaled(self, constant: Constant) -> RationalFunction:
        """The function times an exact constant."""
        return RationalFunction(self.top * to_fmpq(rational(constant)), self.bottom)

    def elevated_to(self, other: object) -> RationalFunction:
        """Itself: degree elevation does not change a function."""
        return self

    def d(self, order: int = 1, *, by: str | None = None) -> RationalFunction:
        """The derivative."""
        self.only_parameter(by)
        result = self
        for _ in range(order):
            top, bottom = result.top, result.bottom
            result = RationalFunction(top.derivative() * bottom - top * bottom.derivative(), bottom * bottom)
        return result

    @property
    def is_zero(self) -> bool:
        """Whether it is the function 0."""
        return not self.top

    def __eq__(self, other: object) -> bool:
        return isinstance(other, RationalFunction) and self.top * other.bottom == other.top * self.bottom

    __hash__ = None  # type: ignore[assignment]  # Python's way to say: not hashable

    def __repr__(self) -> str:
        return f"({self.top}) / ({self.bottom})"


@dataclass(frozen=True)
class ExplicitCurve:
    """Numerators, denominator and point by their coefficients, constants first."""

    numerators: tuple[tuple[int, ...], ...]
    denominator: tuple[int, ...]
    point: tuple[int, ...]

    def argument(self, kind: Kind) -> Curve[RationalFunction]:
        """The argument of formulas."""
        dimension = len(self.numerators)
        functions = dict(zip(COORDINATES, self.numerators, strict=False)) | {"w": self.denominator}
        functions |= {name: (value,) for name, value in zip(POINT, self.point, strict=False)}

        def operand(symbol: Symbol) -> RationalFunction:
            return RationalFunction(fmpq_poly(list(functions[symbol.name])))

        made = kind.argument(dimension, operand, RationalFunction(fmpq_poly([1])))
        assert isinstance(made, Curve)  # there are explicit curves of kinds of one curve alone
        return made


#: The numerators, denominators and points that are tried, the simplest first.
_NUMERATORS = ((0, 1), (0, 0, 1), (1, 0, 0, 1), (0, 1, 0, 0, 1))
_DENOMINATORS = ((1, 1), (1, 0, 1))
_POINT = (1, 2, 5)


def candidates(dimension: int, *, with_point: bool) -> Iterator[ExplicitCurve]:
    """Explicit curves of a dimension."""
    for w in _DENOMINATORS:
        for i in range(len(_NUMERATORS) - dimension + 1):
            yield ExplicitCurve(_NUMERATORS[i : i + dimension], w, _POINT[:dimension] if with_point else ())
