"""Formulas, and what they are handed: a formula is a function with its name, its symbol and where it stands in its
source.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import Any

from exactspline.language.services import Displayed


class Argument(Displayed, ABC):
    """What formulas are handed."""

    @abstractmethod
    def calls(self, formula: Formula) -> Any:
        """The value of a formula."""


class Evaluated(Argument):
    """An argument whose operands are at hand: a formula is evaluated on them.

    An evaluation owns its memo: what several parts of a formula call is computed once, in a copy of the argument that
    nobody else sees, so that an argument can be shared between threads.
    """

    #: Values of the formulas that were called, in a copy that remembers.
    _values: dict[Formula, Any] | None = None

    def calls(self, formula: Formula) -> Any:
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
    def operands(self) -> dict[str, Any]:
        """The operands by name."""

    @abstractmethod
    def mapped(self, change: Callable[[Any], Any]) -> Any:
        """The argument with every operand changed: into another reading, or onto another domain."""

    def together(self) -> tuple[Evaluated, ...]:
        """The arguments that it is made of, itself among them."""
        return (self,)


class Formula(Displayed):
    """A formula with its name, its symbol and where it stands in the paper; calling it evaluates it in the reading of
    its argument.

    ``curve`` tells what the argument must be: ``"curve"`` (any dimension), ``"plane"``, ``"space"``, ``"table"`` (the
    operands of Table 1), ``"pair"`` (two curves in space), ``"point"`` or ``"plane point"`` (a curve and a point, in
    space or in the plane). `symbol` is its LaTeX name, where the paper gives it one. A reading may take the call over
    (a tree keeps a symbol as a node).
    """

    def __init__(self, function: Callable[..., Any], source: str, curve: str, symbol: str) -> None:
        self.function, self.source, self.curve, self.symbol = function, source, curve, symbol
        self.name, self.__name__, self.__doc__, self.__module__ = (
            function.__name__,
            function.__name__,
            function.__doc__,
            function.__module__,
        )

    def __call__(self, c: Any) -> Any:
        """The formula in the reading of `c`."""
        return c.calls(self) if isinstance(c, Argument) else self.function(c)

    def __repr__(self) -> str:
        return f"<formula {self.name}, {self.source}>"


def formula(source: str, *, curve: str = "curve", symbol: str = "") -> Callable[[Callable[..., Any]], Formula]:
    """Mark a function as a formula of the paper (or of a user).

    >>> @formula("Table 1, T16")
    ... def velocity(c):
    ...     return c.p.d(1)
    >>> velocity
    <formula velocity, Table 1, T16>
    """
    return lambda function: Formula(function, source, curve, symbol)
