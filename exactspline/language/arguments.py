"""The arguments of formulas: a curve, a curve and a point, two curves, or operands by name.

A formula is a plain function over operands that know ``+ - * /``, ``**`` with a small integer, and ``.d(k)``, the k-th
derivative. What an operand *is* depends on the reading: a spline, a polynomial in jets, a degree, a node of an
expression tree, a Taylor series. Nothing in this room knows which.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Generic, TypeVar

from exactspline.language.argument import Evaluated
from exactspline.language.choices import Parameter
from exactspline.language.operand import Constant, Operand
from exactspline.language.vector import Vector

T = TypeVar("T", bound=Operand)
U = TypeVar("U", bound=Operand)


class Operands(Evaluated):
    """Operands by name, as the operands of Table 1 are.

    >>> Operands(p1=1, w1=2).operands()
    {'p1': 1, 'w1': 2}
    """

    def __init__(self, **named: Operand | Vector[Operand]) -> None:
        self.__dict__.update(named)

    def __getattr__(self, name: str) -> object:
        raise AttributeError(name)

    def operands(self) -> dict[str, Operand | Vector[Operand]]:
        """The operands by name."""
        return {name: value for name, value in vars(self).items() if name != "_values"}

    def copied(self) -> Operands:
        """The same operands in an argument of its own."""
        return Operands(**self.operands())

    def mapped(self, change: Callable[[Operand], Operand]) -> Operands:
        """The argument with every operand changed."""
        return Operands(
            **{name: x.mapped(change) if isinstance(x, Vector) else change(x) for name, x in self.operands().items()}
        )


class Curve(Evaluated, Generic[T]):
    """A curve as named operands of one reading.

    ``p`` the vector of numerators, ``w`` the denominator, ``gamma`` the curve itself: the `Rational` ``p/w``, or ``p``
    when the curve is polynomial (then ``w`` is the constant of degree 0). ``point`` is the point Q of a point/curve
    bisector, a vector of constants.
    """

    p: Vector[T]
    w: T
    gamma: Vector[T] | Operand
    polynomial: bool
    point: Vector[T] | None

    def __init__(
        self,
        p: Vector[T],
        w: T,
        *,
        polynomial: bool = False,
        gamma: Vector[T] | Operand | None = None,
        point: Vector[T] | None = None,
    ) -> None:
        self.p, self.w, self.polynomial, self.point = p, w, polynomial, point
        self.gamma = gamma if gamma is not None else (p if polynomial else p / w)

    @property
    def dimension(self) -> int:
        """Number of coordinates."""
        return len(self.p)

    @property
    def axis_x(self) -> Vector[int]:
        """The unit vector of the first coordinate."""
        return Vector(1, *[0] * (self.dimension - 1))

    @property
    def axis_y(self) -> Vector[int]:
        """The unit vector of the second coordinate."""
        return Vector(0, 1, *[0] * (self.dimension - 2))

    @property
    def axis_z(self) -> Vector[int]:
        """The unit vector of the third coordinate."""
        return Vector(0, 0, 1, *[0] * (self.dimension - 3))

    def operands(self) -> dict[str, T]:
        """Coordinates, denominator and the coordinates of the point by name."""
        named = dict(zip(COORDINATES, self.p, strict=False)) | {"w": self.w}
        return named if self.point is None else named | dict(zip(POINT, self.point, strict=False))

    def copied(self) -> Curve[T]:
        """The same operands in a plain curve of its own."""
        return Curve(self.p, self.w, polynomial=self.polynomial, gamma=self.gamma, point=self.point)

    def mapped(self, change: Callable[[T], U]) -> Curve[U]:
        """The curve with every operand changed: into another reading, or onto another domain."""
        point = None if self.point is None else self.point.mapped(change)
        return Curve(self.p.mapped(change), change(self.w), polynomial=self.polynomial, point=point)

    def with_point(self, point: Iterable[Constant]) -> Curve[T]:
        """The curve with a point, whose coordinates are exact constants, beside it."""
        return Curve(self.p, self.w, polynomial=self.polynomial, point=Vector(*[self.w.constant(x) for x in point]))


class Pair(Evaluated, Generic[T]):
    """Two curves, ``first`` of the parameter s and ``second`` of the parameter s̄: what a formula of §6.1 is handed.

    Operands of the two may be mixed; only those of one curve are differentiated, each by its own parameter.
    """

    def __init__(self, first: Curve[T], second: Curve[T]) -> None:
        self.first, self.second = first, second

    @property
    def dimension(self) -> int:
        """Number of coordinates."""
        return self.first.dimension

    def operands(self) -> dict[str, T]:
        """Those of the first curve, and those of the second in capitals."""
        return self.first.operands() | {name.upper(): x for name, x in self.second.operands().items()}

    def copied(self) -> Pair[T]:
        """A pair of its own, of curves that remember what is called on them."""
        pair = Pair(self.first.copied(), self.second.copied())
        pair.first._values, pair.second._values = {}, {}
        return pair

    def together(self) -> tuple[Evaluated, ...]:
        """The pair and its curves."""
        return self, self.first, self.second

    def mapped(self, change: Callable[[T], U]) -> Pair[U]:
        """The pair with every operand changed."""
        return Pair(self.first.mapped(change), self.second.mapped(change))


#: The parameters of two curves.
PARAMETERS = (Parameter.FIRST, Parameter.SECOND)
#: Coordinates, denominator and point by name: of the first curve, of the second curve, of the point.
COORDINATES, BARRED, POINT = "xyzuvst", "XYZUVST", "abcefgh"


def embedded(c: Curve[T]) -> Curve[T]:
    """A plane curve (and its point) in the plane z = 0 of space."""
    zero = c.w.constant(0)
    point = None if c.point is None else Vector(*c.point, zero)
    return Curve(Vector(*c.p, zero), c.w, polynomial=c.polynomial, point=point)
