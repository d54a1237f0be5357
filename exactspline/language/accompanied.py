"""A curve together with further operands: constants, and functions on which it depends."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Generic, TypeVar

from exactspline.language.arguments import Curve, T, U
from exactspline.language.operand import Operand
from exactspline.language.vector import Vector

V = TypeVar("V")

#: Computes further values that formulas may name from the operands, given by name.
Made = Callable[[Mapping[str, Operand]], dict[str, object]]


def nothing_made(operands: Mapping[str, object]) -> dict[str, object]:
    """No further values."""
    return {}


class Accompanied(Curve[T], Generic[T]):
    """A curve with additional operands, which formulas name as attributes, and with the values that `made` computes
    from all operands.

    >>> from exactspline.language.kinds import kind_of
    >>> from exactspline.readings.jet import JetReading
    >>> c = JetReading(1).argument(kind_of("plane with delta"), 2)
    >>> c.p[0].d(1) * c.delta
    x′·δ
    """

    def __init__(self, curve: Curve[T], additional: Mapping[str, T], made: Made = nothing_made) -> None:
        super().__init__(curve.p, curve.w, polynomial=curve.polynomial, gamma=curve.gamma, point=curve.point)
        self.additional, self.made = dict(additional), made
        vars(self).update(self.additional | made(self.operands()))

    def operands(self) -> dict[str, T]:
        """The operands of the curve, and the additional ones."""
        return super().operands() | self.additional

    def copied(self) -> Accompanied[T]:
        """A new curve with the same operands."""
        return Accompanied(super().copied(), self.additional, self.made)

    def mapped(self, change: Callable[[T], U]) -> Accompanied[U]:
        """The curve with `change` applied to every operand, the additional ones included."""
        return Accompanied(super().mapped(change), {n: change(x) for n, x in self.additional.items()}, self.made)


def vector_of(operands: Mapping[str, V], *names: str) -> Vector[V]:
    """The vector of operands with these names."""
    return Vector(*[operands[name] for name in names])
