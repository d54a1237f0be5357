"""The language in which formulas are written: operands, vectors and their products, curves, ruled surfaces, formulas.

A formula is a plain function over operands that know ``+ - * /``, ``**`` with a small integer, and ``.d(k)``, the k-th
derivative. What an operand *is* depends on the reading: a spline, a polynomial in jets, a degree, a node of an expression tree,
a Taylor series. Nothing in this room knows which.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from exactspline.vectors import CONSTANTS, FieldOperand, Operand, Vector, cross, det, dot, generalized_cross, norm2, perp, triple, wronskian

__all__ = [
    "CONSTANTS",
    "Curve",
    "FieldOperand",
    "Formula",
    "Operand",
    "RuledSurface",
    "Vector",
    "cross",
    "det",
    "dot",
    "formula",
    "generalized_cross",
    "norm2",
    "perp",
    "ruled",
    "triple",
    "wronskian",
]


class Curve:
    """What a formula is handed: named operands of one reading.

    ``p`` the vector of numerators, ``w`` the denominator, ``gamma`` the curve itself: the `Rational` ``p/w``, or ``p`` when the curve is polynomial
    (then ``w`` is the constant of degree 0).
    """

    def __init__(self, p: Any, w: Any, *, polynomial: bool = False, gamma: Any = None) -> None:
        self.p, self.w, self.polynomial = p, w, polynomial
        self.gamma = gamma if gamma is not None else (p if polynomial else p / w)

    @property
    def dimension(self) -> int:
        """Number of coordinates."""
        return len(self.p)

    #: Values of the formulas called while one formula is being evaluated.
    _values: dict[Formula, Any] | None = None

    def calls(self, formula: Formula) -> Any:
        """The value of a formula; what several parts of it call is computed once and forgotten when it is done."""
        if self._values is None:
            self._values = {}
            try:
                return formula.function(self)
            finally:
                self._values = None
        if formula not in self._values:
            self._values[formula] = formula.function(self)
        return self._values[formula]


class RuledSurface:
    """``directrix + ζ generator`` in any reading: two vectors (or vector quotients) of one parameter s, and the ruling parameter ζ.

    >>> RuledSurface(Vector(1, 2, 3), Vector(0, 0, 1)).at(5)
    Vector(1, 2, 8)
    """

    __slots__ = ("directrix", "generator")

    def __init__(self, directrix: Any, generator: Any) -> None:
        self.directrix, self.generator = directrix, generator

    def at(self, ruling: Any) -> Any:
        """The curve of constant ruling parameter."""
        return self.directrix + self.generator * ruling

    @property
    def degree(self) -> Any:
        """Degree in s: that of directrix + ζ generator with ζ a number, under Table 1."""
        return self.joined.degree

    @property
    def joined(self) -> Any:
        """Directrix and generator side by side, as one vector of twice as many components (over one denominator where they are quotients)."""
        directrix, generator = self.directrix, self.generator
        nothing = [directrix[0].constant(0)] * len(directrix)
        first = _with_numerator(directrix, lambda v: Vector(*v, *nothing))
        return first + _with_numerator(generator, lambda v: Vector(*nothing, *v))


def ruled(directrix: Any, generator: Any) -> Any:
    """The ruled surface ``directrix + ζ generator`` (in the tree reading a node).

    >>> ruled(Vector(1, 0, 0), Vector(0, 0, 1)).at(2)
    Vector(1, 0, 2)
    """
    hook = getattr(directrix, "ruled", None)
    return RuledSurface(directrix, generator) if hook is None else hook(generator)


def _with_numerator(value: Any, change: Callable[[Any], Any]) -> Any:
    """A vector, or the numerator of a vector quotient, changed."""
    return change(value) if isinstance(value, Vector) else type(value)(change(value.numerator), value.product)


class Formula:
    """A formula with its name, its symbol and where it stands in the paper; calling it evaluates it in the reading of its argument.

    ``curve`` tells what the argument must be: ``"curve"`` (any dimension), ``"plane"``, ``"space"`` or ``"table"`` (the operands of Table 1).
    `symbol` is its LaTeX name, where the paper gives it one. A reading may take the call over (a tree keeps a symbol as a node).
    """

    def __init__(self, function: Callable[..., Any], source: str, curve: str, symbol: str) -> None:
        self.function, self.source, self.curve, self.symbol = function, source, curve, symbol
        self.name, self.__name__, self.__doc__, self.__module__ = function.__name__, function.__name__, function.__doc__, function.__module__

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
