"""The arguments of formulas, whatever they consist of."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from typing import Any, Protocol

from exactspline.hooks import Displayed
from exactspline.language.operand import Operand
from exactspline.language.vector import Vector


class Callee(Protocol):
    """What an argument needs of a formula that is called on it."""

    function: Callable[..., Any]
    symbol: str


class Argument(Displayed, ABC):
    """The argument of a formula."""

    def __repr__(self) -> str:
        return f"<{type(self).__name__} argument>"

    @abstractmethod
    def calls(self, formula: Callee) -> object:
        """The value of a formula."""


class Evaluated(Argument):
    """An argument whose operands are given: a formula is evaluated on them.

    An evaluation owns its memo: what several parts of a formula call is computed once, in a copy of the argument that
    nobody else sees, so that an argument can be shared between threads.
    """

    #: Values of the formulas that were called, in a copy that remembers.
    _values: dict[Callee, object] | None = None

    def calls(self, formula: Callee) -> object:
        """The value of a formula."""
        if self._values is None:
            return self.remembering().calls(formula)
        if formula not in self._values:
            self._values[formula] = formula.function(self)
        return self._values[formula]

    def remembering(self) -> Evaluated:
        """A copy that remembers every value as long as it lives: for many formulas of one argument."""
        kept = self.copied()
        kept._values = {}
        return kept

    @abstractmethod
    def copied(self) -> Evaluated:
        """The same operands in an argument of its own."""

    @abstractmethod
    def operands(self) -> Mapping[str, Operand | Vector[Operand]]:
        """The operands by name."""

    @abstractmethod
    def mapped(self, change: Callable[[Operand], Operand]) -> Evaluated:
        """The argument with every operand changed: into another reading, or onto another domain."""

    def together(self) -> tuple[Evaluated, ...]:
        """The arguments that it is made of, itself among them."""
        return (self,)
