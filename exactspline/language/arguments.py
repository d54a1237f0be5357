"""The arguments of formulas: a curve, a curve and a point, two curves, or named operands; and their kinds. A kind
declares its operands, parameters and constants, and the derivatives of dependent operands.

A formula is a plain function over operands that know ``+ - * /``, ``**`` with a small integer, and ``.d(k)``, the k-th
derivative. The meaning of an operand depends on the reading, that is on the type of its values: a spline, a polynomial
in jets, a degree, a node of an expression tree, a Taylor series. Nothing in this package depends on the reading.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import lru_cache, partial
from types import MappingProxyType
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


_DIGITS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")


@dataclass(frozen=True)
class Symbol:
    """An operand of a kind of argument.

    `name` is its name in the argument, `text` its notation; `parameters` are the variables of which it is a function,
    none for a constant. `degree` is its degree, expressed in the degrees that claims may use; empty for a function
    without a degree.

    >>> Symbol("x", "x", (Parameter.FIRST,)).degree_in(Parameter.FIRST)
    'd'
    >>> Symbol("x", "x", (Parameter.U, Parameter.V)).degree_in(Parameter.V)
    'd_v'
    """

    name: str
    text: str
    parameters: tuple[Parameter, ...]
    degree: str = "d"

    def degree_in(self, parameter: Parameter) -> str:
        """The degree in one of its parameters; a function of several parameters has a separate degree in each."""
        return self.degree if len(self.parameters) == 1 or not self.degree else f"{self.degree}_{parameter}"


#: Greek letters by their names.
GREEK = {
    **{"alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "zeta": "ζ", "eta": "η", "theta": "θ"},
    **{"kappa": "κ", "lambda": "λ", "lamda": "λ", "mu": "μ", "nu": "ν", "xi": "ξ", "pi": "π", "rho": "ρ"},
    **{"sigma": "σ", "tau": "τ", "phi": "φ", "chi": "χ", "psi": "ψ", "omega": "ω"},
}


def constant_text(name: str) -> str:
    """The mathematical notation for the name of a constant.

    >>> constant_text("delta"), constant_text("lambda_1"), constant_text("r")
    ('δ', 'λ₁', 'r')
    """
    stem = name.rstrip("0123456789")
    return GREEK.get(stem.rstrip("_"), stem.rstrip("_")) + name[len(stem) :].translate(_DIGITS)


#: The derivative of an operand, computed from all operands by name: the chain rule, where operands depend on each
#: other.
Rule = Callable[[Mapping[str, Operand]], object]


class Kind(ABC):
    """A kind of argument of formulas.

    `dimensions` are the dimensions in which the kind exists. A kind that `adjoins_roots` exists only in readings with
    division, not for splines or degrees; `made_of_a_curve` states whether a single curve determines an argument.
    """

    adjoins_roots: bool = False
    name: str
    dimensions: tuple[int, ...]
    made_of_a_curve = True
    #: Whether a single surface determines an argument.
    made_of_a_surface = False
    #: The parameters in which tables count degrees; for two curves, only that of the first.
    counted: tuple[Parameter, ...] = (Parameter.FIRST,)
    #: If a parameter of some operands is itself a function of the parameter of the curve: the operand for it.
    composed: Mapping[Parameter, str] = MappingProxyType({})
    #: The names of constants that accompany a curve, such as the distance of an offset.
    constants: tuple[str, ...] = ()

    @abstractmethod
    def symbols(self, dimension: int, *, polynomial: bool = False) -> tuple[Symbol, ...]:
        """The operands, numerators before denominators; a polynomial curve has no denominator."""

    @abstractmethod
    def of_operands(self, named: Mapping[str, T], dimension: int, one: T) -> Evaluated:
        """The argument made from its operands, given by name; `one` is the denominator of polynomial curves."""

    def argument(
        self, dimension: int, operand: Callable[[Symbol], T], one: T, *, polynomial: bool = False
    ) -> Evaluated:
        """The argument, each of its operands made from its symbol."""
        named = {symbol.name: operand(symbol) for symbol in self.symbols(dimension, polynomial=polynomial)}
        return self.of_operands(named, dimension, one)

    @abstractmethod
    def names(self, dimension: int) -> dict[str, bool]:
        """The names that formulas may use for such an argument, and whether each is a vector."""

    def rules(self, dimension: int) -> dict[str, Rule]:
        """The derivatives of the operands that depend on other operands, by name."""
        return {}

    @property
    def parts(self) -> dict[str, Kind]:
        """The kinds of the arguments that it consists of, by their names in formulas."""
        return {}

    def parameters(self, dimension: int) -> tuple[Parameter, ...]:
        """The parameters of its operands.

        >>> from exactspline.language.kinds import PAIR, SURFACE
        >>> *PAIR.parameters(3), *SURFACE.parameters(3)
        (<Parameter.FIRST: 's'>, <Parameter.SECOND: 's̄'>, <Parameter.U: 'u'>, <Parameter.V: 'v'>)
        """
        return _parameters(self, dimension)

    def takes(self, other: Kind, dimension: int) -> bool:
        """Whether formulas of another kind can be evaluated on such an argument, because it has their operands.

        >>> from exactspline.language.kinds import CURVE, PAIR, PLANE, PLANE_POINT, kind_of
        >>> PLANE_POINT.takes(PLANE, 2), PLANE.takes(PLANE_POINT, 2), PAIR.takes(CURVE, 3)
        (True, False, False)
        >>> kind_of("plane with delta").takes(PLANE, 2)
        True
        """
        alike = dimension in other.dimensions and isinstance(self, type(other))
        return alike and _has_operands(self, other, dimension)

    def __repr__(self) -> str:
        return f"<kind {self.name}>"


@lru_cache(1024)
def _parameters(kind: Kind, dimension: int) -> tuple[Parameter, ...]:
    return tuple(dict.fromkeys(p for symbol in kind.symbols(dimension) for p in symbol.parameters))


@lru_cache(1024)
def _has_operands(kind: Kind, other: Kind, dimension: int) -> bool:
    return set(other.symbols(dimension)) <= set(kind.symbols(dimension))


def constants_of(kind: Kind) -> tuple[Symbol, ...]:
    """The symbols of the constants of a kind."""
    return tuple(Symbol(name, constant_text(name), ()) for name in kind.constants)
