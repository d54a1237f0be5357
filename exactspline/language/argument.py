"""The base classes of the arguments of formulas."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from typing import Any, Protocol

from exactspline.hooks import Displayed
from exactspline.language.operand import Operand
from exactspline.language.vector import Vector


class Callee(Protocol):
    """The attributes of a formula that an argument uses when the formula is called on it."""

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
    """An argument with given operands, on which formulas are evaluated.

    Each evaluation has a private memo: a formula called by several parts of a formula is computed once. The memo is
    kept in a copy of the argument, so that an argument can be shared between threads.
    """

    #: The memo: values of the formulas called so far. None except in a copy made for an evaluation.
    _values: dict[Callee, object] | None = None

    def calls(self, formula: Callee) -> object:
        """The value of a formula."""
        if self._values is None:
            return self.remembering().calls(formula)
        if formula not in self._values:
            self._values[formula] = formula.function(self)
        return self._values[formula]

    def remembering(self) -> Evaluated:
        """A copy that memoizes every formula for its lifetime; for evaluating many formulas on one argument."""
        kept = self.copied()
        kept._values = {}
        return kept

    @abstractmethod
    def copied(self) -> Evaluated:
        """A new argument with the same operands."""

    @abstractmethod
    def operands(self) -> Mapping[str, Operand | Vector[Operand]]:
        """The operands by name."""

    @abstractmethod
    def mapped(self, change: Callable[[Operand], Operand]) -> Evaluated:
        """The argument with `change` applied to every operand, such as a conversion to another reading or domain."""

    def together(self) -> tuple[Evaluated, ...]:
        """This argument and the arguments that it consists of."""
        return (self,)
