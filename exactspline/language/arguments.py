"""The arguments of formulas: a curve, a curve and a point, two curves, or named operands.

A formula is a plain function over operands that know ``+ - * /``, ``**`` with a small integer, and ``.d(k)``, the k-th
derivative. The meaning of an operand depends on the reading, that is on the type of its values: a spline, a polynomial
in jets, a degree, a node of an expression tree, a Taylor series. Nothing in this package depends on the reading.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Mapping
from functools import partial
from typing import Any, Generic, Protocol, TypeVar

from exactspline.errors import as_items
from exactspline.hooks import Displayed
from exactspline.language.operand import Constant, Operand, Parameter
from exactspline.language.vector import Vector
from exactspline.polynomials.cost import Priced


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
    _values: dict[Callee, Priced[object]] | None = None

    def calls(self, formula: Callee) -> object:
        """Return the value of a formula."""
        if self._values is None:
            return self.remembering().calls(formula)
        if formula not in self._values:
            self._values[formula] = Priced(partial(formula.function, self))
        return self._values[formula].value

    def remembering(self) -> Evaluated:
        """Return a copy that stores the value of every formula that is evaluated on it."""
        kept = self.copied()
        kept._values = {}
        return kept

    @abstractmethod
    def copied(self) -> Evaluated:
        """Return a new argument with the same operands."""

    @abstractmethod
    def operands(self) -> Mapping[str, Operand | Vector[Operand]]:
        """Return the operands by name."""

    @abstractmethod
    def mapped(self, change: Callable[[Operand], Operand]) -> Evaluated:
        """Return the argument with `change` applied to every operand."""

    def together(self) -> tuple[Evaluated, ...]:
        """Return the objects that a formula gets: for a curve, the curve itself; for a pair, also its two curves."""
        return (self,)


T = TypeVar("T", bound=Operand)
U = TypeVar("U", bound=Operand)


class Operands(Evaluated):
    """Named operands, such as those of Table 1.

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
        """A new argument with the same operands."""
        return Operands(**self.operands())

    def mapped(self, change: Callable[[Operand], Operand]) -> Operands:
        """The argument with `change` applied to every operand."""
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
        """The number of coordinates."""
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
        """Return the coordinates, the denominator and the coordinates of the point, by name."""
        named = dict(zip(COORDINATES, self.p, strict=False)) | {"w": self.w}
        return named if self.point is None else named | dict(zip(POINT, self.point, strict=False))

    def copied(self) -> Curve[T]:
        """Return a new `Curve` with the same operands."""
        return Curve(self.p, self.w, polynomial=self.polynomial, gamma=self.gamma, point=self.point)

    def mapped(self, change: Callable[[T], U]) -> Curve[U]:
        """Return the curve with `change` applied to every operand."""
        point = None if self.point is None else self.point.mapped(change)
        return Curve(self.p.mapped(change), change(self.w), polynomial=self.polynomial, point=point)

    def with_point(self, point: Iterable[Constant]) -> Curve[T]:
        """Return the curve together with a point, whose coordinates are exact constants."""
        beside = Vector(*map(self.w.constant, as_items(point, "the coordinates of a point")))
        return Curve(self.p, self.w, polynomial=self.polynomial, point=beside)


class Pair(Evaluated, Generic[T]):
    """Two curves, ``first`` with parameter s and ``second`` with parameter s̄: the argument of a formula of §6.1 of the
    paper.

    Expressions may mix operands of both curves, but only an operand of a single curve can be differentiated, with
    respect to the parameter of that curve.
    """

    def __init__(self, first: Curve[T], second: Curve[T]) -> None:
        self.first, self.second = first, second

    @property
    def dimension(self) -> int:
        """The number of coordinates."""
        return self.first.dimension

    def operands(self) -> dict[str, T]:
        """The operands of the first curve, and the operands of the second curve with capital letters."""
        return self.first.operands() | {name.upper(): x for name, x in self.second.operands().items()}

    def copied(self) -> Pair[T]:
        """A new pair of memoizing curves."""
        pair = Pair(self.first.copied(), self.second.copied())
        pair.first._values, pair.second._values = {}, {}
        return pair

    def together(self) -> tuple[Evaluated, ...]:
        """The pair and its two curves."""
        return self, self.first, self.second

    def mapped(self, change: Callable[[T], U]) -> Pair[U]:
        """The pair with `change` applied to every operand."""
        return Pair(self.first.mapped(change), self.second.mapped(change))


#: The parameters of two curves.
PARAMETERS = (Parameter.FIRST, Parameter.SECOND)
#: Names of the coordinates and the denominator of the first curve, and the same of the second.
COORDINATES, BARRED = "xyzuvst", "XYZUVST"
#: Names of the coordinates of the point. No name in a formula begins like these, so that no constant has such a name.
POINT = tuple(f"_q{i}" for i in range(1, 8))


def embedded(c: Curve[T]) -> Curve[T]:
    """A plane curve (and its point) in the plane z = 0 of space."""
    zero = c.w.constant(0)
    point = None if c.point is None else Vector(*c.point, zero)
    return Curve(Vector(*c.p, zero), c.w, polynomial=c.polynomial, point=point)


V = TypeVar("V")

#: Computes further values that formulas may name from the operands, given by name.
Made = Callable[[Mapping[str, Operand]], dict[str, object]]


def _nothing_made(operands: Mapping[str, object]) -> dict[str, object]:
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

    def __init__(self, curve: Curve[T], additional: Mapping[str, T], made: Made = _nothing_made) -> None:
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
