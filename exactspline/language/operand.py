"""Operands: what every scalar of every reading has in common."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from exactspline.errors import FormulaError
from exactspline.exact import mpq, mpz
from exactspline.language.services import Displayed

#: The constants that may stand in a formula.
CONSTANTS = (int, type(mpz()), type(mpq()), Fraction)


class Operand(Displayed):
    """What every scalar of every reading has in common.

    A reading supplies ``__add__``, ``__mul__``, ``scaled`` (by an exact constant), ``d``, ``elevated_to`` (the same
    thing, of at least another's degree), ``degree`` and ``provenance`` (see `exactspline.language.provenance`); the
    rest follows. ``/`` by an operand makes a `Rational`, which is Table 1's row T3.
    """

    __slots__ = ()
    #: Whether it is a vector (some readings have one class for both).
    is_vector = False
    #: Whether it decides itself what a plain vector times or over it is.
    takes_over = False

    @property
    def vanishes_somewhere(self) -> bool:
        """Whether it is identically zero, if only on one segment of its domain."""
        return bool(self.is_zero)  # type: ignore[attr-defined]

    def hash_of_quotients(self, numerators: tuple[Any, ...]) -> int:
        """A hash of the quotients by this that all equal ones share; a reading that can tell more than nothing does."""
        return len(numerators)

    def __neg__(self) -> Any:
        return self.scaled(-1)  # type: ignore[attr-defined]

    def __sub__(self, other: Any) -> Any:
        return self + (-other)  # type: ignore[operator]

    def __rsub__(self, other: Any) -> Any:
        return (-self).__add__(other)

    def __radd__(self, other: Any) -> Any:
        return self.__add__(other)  # type: ignore[operator]

    def __rmul__(self, other: Any) -> Any:
        return self.__mul__(other)  # type: ignore[operator]

    def __truediv__(self, other: Any) -> Any:
        if isinstance(other, CONSTANTS):
            return self.scaled(1 / mpq(other))  # type: ignore[attr-defined]
        if not isinstance(other, Operand):
            return NotImplemented
        return other.dividing(self) if hasattr(other, "dividing") else _rational()(self, other)

    def __rtruediv__(self, other: Any) -> Any:
        if not isinstance(other, CONSTANTS):
            return NotImplemented
        return self.constant(other) / self  # type: ignore[attr-defined]

    def __pow__(self, exponent: int) -> Any:
        if not isinstance(exponent, int) or exponent < 1:
            raise FormulaError(f"a power with exponent {exponent!r}", remedy="use a positive integer")
        result = self
        for _ in range(exponent - 1):
            result = result * self  # type: ignore[operator]
        return result

    def __bool__(self) -> bool:
        raise FormulaError(
            f"a {type(self).__name__} was used as a truth value",
            remedy="formulas must not branch; compare with == or use is_zero outside formulas",
        )

    def beside(self, other: Any) -> Any:
        """Another operand of the same reading, a constant made one; None for anything else."""
        if type(other) is type(self):
            return other
        return self.constant(other) if isinstance(other, CONSTANTS) else None  # type: ignore[attr-defined]


def _rational() -> Any:
    from exactspline.language.rational import Rational

    return Rational
