"""The same curve with another parameter t: with ``ρ = ds/dt``, derivatives are ``d/dt = ρ d/ds``.

ρ is an independent function, so that statements proved in this reading hold for every change of parameter.
"""

from __future__ import annotations

from exactspline.language.operand import Constant, FieldOperand


class InOtherParameter(FieldOperand):
    """An operand of a reading with division, differentiated with respect to another parameter.

    >>> from exactspline.language.kinds import kind_of
    >>> from exactspline.readings.jet import RationalJetReading
    >>> c = RationalJetReading(2).argument(kind_of("plane with rho"), 2)
    >>> InOtherParameter(c.p[0], c.rho).d(2).value == c.p[0].d(2) * c.rho * c.rho
    True
    """

    __slots__ = ("speed", "value")
    degree = provenance = 0

    def __init__(self, value: FieldOperand, speed: FieldOperand) -> None:
        self.value, self.speed = value, speed

    def _made(self, value: FieldOperand) -> InOtherParameter:
        return InOtherParameter(value, self.speed)

    def constant(self, value: Constant) -> InOtherParameter:
        """An exact constant."""
        return self._made(self.value.constant(value))

    def _plus(self, right: InOtherParameter) -> InOtherParameter:
        return self._made(self.value + right.value)

    def _times(self, right: InOtherParameter) -> InOtherParameter:
        return self._made(self.value * right.value)

    def reciprocal(self) -> InOtherParameter:
        """``1 / a``."""
        return self._made(self.value.reciprocal())

    def scaled(self, constant: Constant) -> InOtherParameter:
        """The operand times an exact constant."""
        return self._made(self.value.scaled(constant))

    def _first_derivative(self, by: str | None) -> InOtherParameter:
        """The derivative with respect to the other parameter."""
        return self._made(self.value.d(1, by=by) * self.speed)

    @property
    def is_zero(self) -> bool:
        """Whether the value vanishes on every curve."""
        return bool(self.value.is_zero)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, InOtherParameter) and bool(self.value == other.value)

    __hash__ = None  # type: ignore[assignment]  # not hashable
