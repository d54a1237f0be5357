"""The language in which formulas are written: operands, vectors and their products, curves, ruled surfaces, formulas.

A formula is a plain function over operands that know ``+ - * /``, ``**`` with a small integer, and ``.d(k)``, the k-th
derivative. What an operand *is* depends on the reading: a spline, a polynomial in jets, a degree, a node of an
expression tree, a Taylor series. Nothing in this room knows which.
"""

from __future__ import annotations

from collections.abc import Callable
from copy import copy
from typing import Any

from exactspline.language.formula import Formula, formula
from exactspline.language.linear_system import cramer, level
from exactspline.language.operand import CONSTANTS, Operand
from exactspline.language.ruled import RuledSurface, ruled
from exactspline.language.services import Displayed
from exactspline.language.vector import (
    FieldOperand,
    Vector,
    cross,
    det,
    dot,
    generalized_cross,
    join,
    norm2,
    perp,
    triple,
    wronskian,
)


def with_point(curve: Any, point: Any) -> Curve:
    """A curve and a point as the argument of formulas."""
    return Curve(curve.p, curve.w, polynomial=curve.polynomial, point=Vector(*[curve.w.constant(x) for x in point]))


__all__ = [
    "BARRED",
    "CONSTANTS",
    "COORDINATES",
    "DIMENSIONS",
    "POINT",
    "Argument",
    "Curve",
    "FieldOperand",
    "Formula",
    "Operand",
    "Pair",
    "RuledSurface",
    "Vector",
    "assemble",
    "cramer",
    "cross",
    "det",
    "dot",
    "embedded",
    "formula",
    "generalized_cross",
    "join",
    "level",
    "norm2",
    "operands",
    "perp",
    "ruled",
    "triple",
    "wronskian",
]


class Argument(Displayed):
    """What formulas are handed. It is never changed by them: each evaluation has a copy of its own that remembers."""

    #: Values of the formulas called, in a copy that remembers.
    _values: dict[Formula, Any] | None = None

    def calls(self, formula: Formula) -> Any:
        """The value of a formula; what several parts of it call is computed once and forgotten when it is done."""
        if self._values is None:
            return self.remembering().calls(formula)
        if formula not in self._values:
            self._values[formula] = formula.function(self)
        return self._values[formula]

    def together(self) -> tuple[Argument, ...]:
        """The arguments that remember together."""
        return (self,)

    def remembering(self) -> Argument:
        """A copy that remembers every value as long as it lives: for many formulas of one argument, one after the
        other, in one thread.
        """
        kept = copy(self)
        kept._values = {}
        return kept


class Curve(Argument):
    """A curve as named operands of one reading.

    ``p`` the vector of numerators, ``w`` the denominator, ``gamma`` the curve itself: the `Rational` ``p/w``, or ``p``
    when the curve is polynomial (then ``w`` is the constant of degree 0). ``point`` is the point Q of a point/curve
    bisector, a vector of constants.
    """

    def __init__(self, p: Any, w: Any, *, polynomial: bool = False, gamma: Any = None, point: Any = None) -> None:
        self.p, self.w, self.polynomial, self.point = p, w, polynomial, point
        self.gamma = gamma if gamma is not None else (p if polynomial else p / w)

    @property
    def dimension(self) -> int:
        """Number of coordinates."""
        return len(self.p)

    @property
    def axis_x(self) -> Vector:
        """The unit vector of the first coordinate."""
        return Vector(1, *[0] * (self.dimension - 1))

    @property
    def axis_y(self) -> Vector:
        """The unit vector of the second coordinate."""
        return Vector(0, 1, *[0] * (self.dimension - 2))

    @property
    def axis_z(self) -> Vector:
        """The unit vector of the third coordinate."""
        return Vector(0, 0, 1, *[0] * (self.dimension - 3))

    def remembering(self) -> Curve:
        """A copy that remembers every value as long as it lives, of operands alone: of a curve with data of its own
        (see `exactspline.Nurbs`) what formulas see of it.
        """
        kept = object.__new__(Curve)
        vars(kept).update(vars(self), _values={})
        return kept

    def mapped(self, change: Callable[[Any], Any]) -> Curve:
        """The curve with every operand changed: into another reading, or onto another domain."""
        p, w = Vector(*map(change, self.p)), change(self.w)
        return Curve(
            p, w, polynomial=self.polynomial, point=None if self.point is None else Vector(*map(change, self.point))
        )


class Pair(Argument):
    """Two curves, ``first`` of the parameter s and ``second`` of the parameter s̄: what a formula of §6.1 is handed.

    Operands of the two may be mixed; only those of one curve are differentiated, each by its own parameter.
    """

    def __init__(self, first: Curve, second: Curve) -> None:
        self.first, self.second = first, second

    @property
    def dimension(self) -> int:
        """Number of coordinates."""
        return self.first.dimension

    def together(self) -> tuple[Argument, ...]:
        """The two curves remember with the pair."""
        return self, self.first, self.second

    def remembering(self) -> Pair:
        """A copy of the pair, and of both curves."""
        kept = copy(self)
        kept.first, kept.second = self.first.remembering(), self.second.remembering()
        kept._values = {}
        return kept

    def mapped(self, change: Callable[[Any], Any]) -> Pair:
        """The pair with every operand changed."""
        return Pair(self.first.mapped(change), self.second.mapped(change))


#: Coordinates, denominator and point by name: of the first curve, of the second curve, of the point.
COORDINATES, BARRED, POINT = "xyzuvst", "XYZUVST", "abcefgh"


#: The dimensions in which there are formulas of a kind.
DIMENSIONS = {
    "curve": (2, 3),
    "plane": (2,),
    "space": (3,),
    "table": (3,),
    "pair": (3,),
    "point": (3,),
    "plane point": (2,),
}


def operands(argument: Any) -> dict[str, Any]:
    """The operands of a curve or a pair by name: what `assemble` puts together."""
    if isinstance(argument, Pair):
        second = operands(argument.second)
        return operands(argument.first) | {name.upper(): x for name, x in second.items()}
    named = dict(zip(COORDINATES, argument.p, strict=False)) | {"w": argument.w}
    return named if argument.point is None else named | dict(zip(POINT, argument.point, strict=False))


def embedded(c: Curve) -> Curve:
    """A plane curve (and its point) in the plane z = 0 of space."""
    zero = c.w.constant(0)
    point = None if c.point is None else Vector(*c.point, zero)
    return Curve(Vector(*c.p, zero), c.w, polynomial=c.polynomial, point=point)


def assemble(kind: str, dimension: int, operand: Callable[[str], Any], one: Any, *, polynomial: bool = False) -> Any:
    """The argument of formulas of a kind (see `Formula`) from its operands by name.

    The first curve has ``x, y, z, w``, the second one ``X, Y, Z, W``, the point ``a, b, c``; ``one`` stands for w where
    the curves are polynomial.
    """

    def curve(names: str, w: str) -> Curve:
        p = Vector(*map(operand, names[:dimension]))
        point = Vector(*map(operand, POINT[:dimension])) if kind.endswith("point") else None
        return Curve(p, one if polynomial else operand(w), polynomial=polynomial, point=point)

    first = curve(COORDINATES, "w")
    return Pair(first, curve(BARRED, "W")) if kind == "pair" else first
