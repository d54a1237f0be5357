"""The parameters with respect to which a formula differentiates: checked in a first pass, before it is evaluated in a
reading.

Readings treat an operand that does not depend on a parameter as constant in it, and splines in two parameters have no
names for their parameters. So a parameter that the argument does not have must be rejected beforehand.
"""

from __future__ import annotations

from exactspline.errors import FormulaError
from exactspline.language.operand import CONSTANTS, Constant, FieldOperand


class Letter(FieldOperand):
    """An operand of which only the parameters are known with respect to which it may be differentiated: of a sum or a
    product those that are common.

    >>> Letter(("u", "v")).d(1, by="s")
    Traceback (most recent call last):
    exactspline.errors.FormulaError: a derivative with respect to 's' of a function of u and v; write d(1, by='u')
    """

    __slots__ = ("parameters",)
    degree = provenance = 0

    def __init__(self, parameters: tuple[str, ...]) -> None:
        self.parameters = parameters

    def __add__(self, other: object) -> Letter:
        if isinstance(other, Letter):
            return Letter(tuple(each for each in self.parameters if each in other.parameters))
        return self if isinstance(other, CONSTANTS) else NotImplemented

    __mul__ = __add__

    def reciprocal(self) -> Letter:
        """The reciprocal: a function of the same parameters."""
        return self

    def scaled(self, constant: Constant) -> Letter:
        """A multiple: a function of the same parameters."""
        return self

    def constant(self, value: Constant) -> Letter:
        """A constant, taken as a function of the same parameters."""
        return self

    def d(self, order: int = 1, *, by: str | None = None) -> Letter:
        """A derivative: a function of the same parameters.

        Raises `FormulaError` for a parameter that the argument does not have.
        """
        refuse_letter(by, self.parameters)
        return self


def refuse_letter(by: str | None, parameters: tuple[str, ...]) -> None:
    """Raise `FormulaError` for a parameter that an argument does not have."""
    if by is not None and by not in parameters:
        raise FormulaError(
            f"a derivative with respect to {str(by)!r} of a function of {' and '.join(parameters)}",
            remedy=f"write d(1, by={str(parameters[0])!r})",
        )
