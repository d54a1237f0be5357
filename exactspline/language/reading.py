"""Readings: interpretations of the operands of a formula, and what the value of the formula then proves."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import ClassVar

from exactspline.errors import InapplicableError
from exactspline.language.arguments import Argument
from exactspline.language.formula import Formula
from exactspline.language.kind import Kind, Symbol


class Reading(ABC):
    """One way to evaluate formulas. To add a reading, add one file that provides one of these; nothing else changes.

    `name` is its name in the ledger; its file says what the equality of two values in it proves.
    """

    name: ClassVar[str]

    def __repr__(self) -> str:
        fields = ", ".join(str(x) for x in vars(self).values() if isinstance(x, int | str))
        return f"<{type(self).__name__}{' of ' * bool(fields)}{fields}>"

    @abstractmethod
    def argument(self, kind: Kind, dimension: int, *, polynomial: bool = False) -> Argument:
        """The argument for formulas of a kind in a dimension; polynomial curves have no denominator."""

    def of(self, formula: Formula, dimension: int, *, polynomial: bool = False) -> object:
        """The value of a formula in this reading.

        >>> from exactspline.papers import find
        >>> from exactspline.readings.degree import DegreeReading
        >>> DegreeReading().of(find("g2"), 2)
        9d − 6
        """
        return formula(self.argument(formula.kind, dimension, polynomial=polynomial))


def freely_differentiable(
    kind: Kind, reading: Reading, dimension: int, *, polynomial: bool = False
) -> tuple[Symbol, ...]:
    """The operands of a kind, for a reading in which they are independent functions, all of the same degree.

    Raises `InapplicableError` for a kind whose operands depend on each other.
    """
    if kind.rules(dimension) or kind.composed:
        raise InapplicableError(
            f"the reading {reading.name!r} does not apply to the kind {kind.name!r}",
            remedy="its operands depend on each other: prove an identity, or check a single curve",
        )
    return kind.symbols(dimension, polynomial=polynomial)
