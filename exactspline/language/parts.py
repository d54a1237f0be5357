"""The parts of the value of a formula: numerator, components, denominator."""

from __future__ import annotations

from typing import Any, TypeVar, overload

from exactspline.language.operand import Counted, Operand
from exactspline.language.rational import Rational
from exactspline.language.ruled import RuledSurface
from exactspline.language.vector import Vector

C = TypeVar("C", bound=Counted)
V = TypeVar("V")

#: The values that formulas return, in any reading: a scalar (possibly a quotient), a vector, or a ruled surface.
Value = Operand | Vector[Operand] | RuledSurface[Operand | Vector[Operand]]


@overload
def numerator(value: Rational[C]) -> C | Vector[C]:
    """The numerator of a quotient."""


@overload
def numerator(value: V) -> V:
    """A value without a denominator, unchanged."""


def numerator(value: object) -> object:
    """The numerator of a quotient; any other value unchanged."""
    return value.numerator if isinstance(value, Rational) else value


@overload
def joined(value: RuledSurface[V]) -> V:
    """Directrix and generator of a ruled surface as one vector."""


@overload
def joined(value: V) -> V:
    """Any other value, unchanged."""


def joined(value: object) -> object:
    """Directrix and generator of a ruled surface concatenated to one vector; any other value unchanged."""
    return value.joined if isinstance(value, RuledSurface) else value


def split(value: Vector[C] | Rational[C] | RuledSurface[Vector[C] | Rational[C]] | C) -> tuple[list[C], C | None]:
    """The components of the numerator, and the denominator or None."""
    whole: Any = value.joined if isinstance(value, RuledSurface) else value
    top = whole.numerator if isinstance(whole, Rational) else whole
    components = list(top) if isinstance(top, Vector) else [top]
    return components, whole.denominator if isinstance(whole, Rational) else None
