"""Formulas: a function with its name, its symbol and where it stands in its source."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from exactspline.language.services import Displayed


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
        hook = getattr(c, "calls", None)
        return self.function(c) if hook is None else hook(self)

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
