"""A value of the language taken apart: numerator, components, denominator."""

from __future__ import annotations

from typing import Any

from exactspline.language.operand import Operand
from exactspline.language.rational import Rational
from exactspline.language.ruled import RuledSurface
from exactspline.language.vector import Vector

#: What formulas return, in any reading: a scalar (a quotient is one), a vector, a ruled surface.
Value = Operand | Vector[Operand] | RuledSurface[Operand | Vector[Operand]]


def numerator(value: Any) -> Any:
    """The numerator of a quotient, anything else as it is."""
    return value.numerator if isinstance(value, Rational) else value


def joined(value: Any) -> Any:
    """Of a ruled surface directrix and generator side by side, anything else as it is."""
    return value.joined if isinstance(value, RuledSurface) else value


def split(value: Any) -> tuple[list[Any], Any]:
    """The components of the numerator, and the denominator or None."""
    denominator = None
    if isinstance(value, RuledSurface):
        value = value.joined
    if isinstance(value, Rational):
        value, denominator = value.numerator, value.denominator
    return list(value) if isinstance(value, Vector) else [value], denominator
