"""The terms of a formula's value, and the value with splines in their place."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, TypeVar

from exactspline.errors import FormulaError
from exactspline.language.operand import Operand
from exactspline.language.rational import Rational
from exactspline.language.ruled import RuledSurface
from exactspline.language.vector import Vector

T = TypeVar("T", bound=Operand)


def terms_of(value: object, kind: type[T]) -> list[T]:
    """The terms of a value, or of each of several.

    Raises `FormulaError` for a value that formulas of programs do not return.
    """
    if isinstance(value, RuledSurface):
        return terms_of(value.directrix, kind) + terms_of(value.generator, kind)
    if isinstance(value, Rational):
        return [*terms_of(value.numerator, kind), value.denominator]
    if isinstance(value, (Vector, tuple)):
        return [term for part in value for term in terms_of(part, kind)]
    if isinstance(value, kind):
        return [value]
    raise FormulaError(
        f"a formula that returns a {type(value).__name__}", remedy="a scalar, a vector, a quotient or a ruled surface"
    )


def rebuilt(value: object, splines: Iterator[Operand]) -> object:
    """The value with splines in the place of its terms."""
    return _rebuilt(value, splines)


def _rebuilt(value: object, splines: Iterator[Any]) -> Any:
    if isinstance(value, RuledSurface):
        directrix = _rebuilt(value.directrix, splines)
        return RuledSurface(directrix, _rebuilt(value.generator, splines))
    if isinstance(value, Rational):
        numerator = _rebuilt(value.numerator, splines)
        return Rational(numerator, next(splines))
    if isinstance(value, Vector):
        return Vector(*[_rebuilt(part, splines) for part in value])
    if isinstance(value, tuple):
        return tuple(_rebuilt(part, splines) for part in value)
    return next(splines)
