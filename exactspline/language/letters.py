"""Which parameters a formula differentiates by: a first pass over it, before any reading carries it out.

Readings treat what does not depend on a parameter as constant in it, and splines in two parameters have no names for
them, so that a parameter that the argument does not have must be refused before.
"""

from __future__ import annotations

from exactspline.errors import FormulaError
from exactspline.language.operand import CONSTANTS, Constant, FieldOperand


class Letter(FieldOperand):
    """An operand of which nothing is known but the parameters.

    >>> Letter(("u", "v")).d(1, by="s")
    Traceback (most recent call last):
    exactspline.errors.FormulaError: a derivative by 's' of a function of u and v; write d(1, by='u')
    """

    __slots__ = ("parameters",)
    degree = provenance = 0

    def __init__(self, parameters: tuple[str, ...]) -> None:
        self.parameters = parameters

    def __add__(self, other: object) -> Letter:
        return self if isinstance(other, (Letter, *CONSTANTS)) else NotImplemented

    __mul__ = __add__

    def reciprocal(self) -> Letter:
        """Another function of the same parameters, as everything here is."""
        return self

    def scaled(self, constant: Constant) -> Letter:
        """A multiple."""
        return self

    def constant(self, value: Constant) -> Letter:
        """A constant."""
        return self

    def elevated_to(self, other: object) -> Letter:
        """Itself."""
        return self

    def d(self, order: int = 1, *, by: str | None = None) -> Letter:
        """A derivative.

        Raises `FormulaError` for a parameter that the argument does not have.
        """
        refuse_letter(by, self.parameters)
        return self


def refuse_letter(by: str | None, parameters: tuple[str, ...]) -> None:
    """Refuse a parameter that is none of those of an argument, with `FormulaError`."""
    if by is not None and by not in parameters:
        raise FormulaError(
            f"a derivative by {str(by)!r} of a function of {' and '.join(parameters)}",
            remedy=f"write d(1, by={str(parameters[0])!r})",
        )
