"""Kinds of arguments: each declares its operands, its parameters and its constants; readings build from that.

A new kind is a new class here and an entry in `KINDS`; no reading changes.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

from exactspline.errors import FormulaError
from exactspline.language.adjoined_root import framed
from exactspline.language.argument import Evaluated
from exactspline.language.arguments import BARRED, COORDINATES, PARAMETERS, POINT, Curve, Operands, Pair, T
from exactspline.language.vector import Vector

_SUBSCRIPTS = str.maketrans("xyzuvst", "₁₂₃₄₅₆₇")


@dataclass(frozen=True)
class Symbol:
    """An operand that an argument is made of.

    `name` is its own among those of the argument, `text` as people write it; `parameter` is what it is a function of,
    empty for a constant; functions of one `degree` have the same one, which has that name.
    """

    name: str
    text: str
    parameter: str
    degree: str = "d"


class Kind(ABC):
    """What formulas of one kind are handed.

    `dimensions` are those of the curves for which there are formulas of the kind.
    """

    name: str
    dimensions: tuple[int, ...]

    @abstractmethod
    def symbols(self, dimension: int, *, polynomial: bool = False) -> tuple[Symbol, ...]:
        """The operands, numerators before denominators; none for the denominator of a polynomial curve."""

    @abstractmethod
    def argument(
        self, dimension: int, operand: Callable[[Symbol], T], one: T, *, polynomial: bool = False
    ) -> Evaluated:
        """The argument from its operands; `one` stands for the denominators of polynomial curves."""

    @abstractmethod
    def names(self, dimension: int) -> dict[str, bool]:
        """What formulas may name of such an argument, and whether it is a vector."""

    @property
    def parts(self) -> dict[str, Kind]:
        """The arguments that it is made of, by the names formulas have for them."""
        return {}

    def takes(self, other: Kind, dimension: int) -> bool:
        """Whether formulas of another kind can be evaluated on such an argument: it has their operands.

        >>> PLANE_POINT.takes(PLANE, 2), PLANE.takes(PLANE_POINT, 2), PAIR.takes(CURVE, 3)
        (True, False, False)
        """
        alike = dimension in other.dimensions and type(self) is type(other)
        return alike and set(other.symbols(dimension)) <= set(self.symbols(dimension))

    def __repr__(self) -> str:
        return f"<kind {self.name}>"


class CurveKind(Kind):
    """A curve, in any dimension or in one; with a point beside it where `with_point` says so."""

    def __init__(self, name: str, dimensions: tuple[int, ...], *, with_point: bool = False) -> None:
        self.name, self.dimensions, self.with_point = name, dimensions, with_point

    def symbols(self, dimension: int, *, polynomial: bool = False) -> tuple[Symbol, ...]:
        """Coordinates, denominator, and the coordinates of the point."""
        point = [Symbol(POINT[i], "Q" + x.translate(_SUBSCRIPTS), "") for i, x in enumerate(COORDINATES[:dimension])]
        return (*_functions(COORDINATES, "w", dimension, 0, polynomial), *(point if self.with_point else ()))

    def names(self, dimension: int) -> dict[str, bool]:
        """Numerator, denominator, the curve itself, the axes, and the point."""
        axes = dict.fromkeys(("axis_x", "axis_y", "axis_z")[:dimension], True)
        return {"p": True, "w": False, "gamma": True} | axes | ({"point": True} if self.with_point else {})

    def argument(
        self, dimension: int, operand: Callable[[Symbol], T], one: T, *, polynomial: bool = False
    ) -> Evaluated:
        """The curve."""
        named = {symbol.name: operand(symbol) for symbol in self.symbols(dimension, polynomial=polynomial)}
        point = Vector(*[named[name] for name in POINT[:dimension]]) if self.with_point else None
        return _curve(named, COORDINATES[:dimension], "w", one, point)


class PairKind(Kind):
    """Two curves in space, the first a function of s, the second of s̄."""

    name = "pair"
    dimensions = (3,)

    def symbols(self, dimension: int, *, polynomial: bool = False) -> tuple[Symbol, ...]:
        """The operands of the first curve, then those of the second."""
        first = _functions(COORDINATES, "w", dimension, 0, polynomial)
        return (*first, *_functions(BARRED, "W", dimension, 1, polynomial))

    def names(self, dimension: int) -> dict[str, bool]:
        """None but its parts."""
        return {}

    @property
    def parts(self) -> dict[str, Kind]:
        """The two curves."""
        return {"first": SPACE, "second": SPACE}

    def argument(
        self, dimension: int, operand: Callable[[Symbol], T], one: T, *, polynomial: bool = False
    ) -> Evaluated:
        """The pair."""
        named = {symbol.name: operand(symbol) for symbol in self.symbols(dimension, polynomial=polynomial)}
        first = _curve(named, COORDINATES[:dimension], "w", one)
        return Pair(first, _curve(named, BARRED[:dimension], "W", one))


class TableKind(Kind):
    """The operands of Table 1: polynomials p1, p2, denominators w1, w2 and vectors v1, v2, all of one parameter."""

    name = "table"
    dimensions = (3,)

    def symbols(self, dimension: int, *, polynomial: bool = False) -> tuple[Symbol, ...]:
        """The operands of index 1, then those of index 2, vectors by their components."""
        names = [(f"{x}{i}", f"d{i}") for i in "12" for x in ("p", "w", *(f"v{j}_" for j in range(dimension)))]
        return tuple(Symbol(name, name, PARAMETERS[0], degree) for name, degree in names)

    def names(self, dimension: int) -> dict[str, bool]:
        """Scalars and vectors of both indices."""
        return {f"{x}{i}": x == "v" for i in "12" for x in "pwv"}

    def argument(
        self, dimension: int, operand: Callable[[Symbol], T], one: T, *, polynomial: bool = False
    ) -> Evaluated:
        """The operands by name."""
        named = {symbol.name: operand(symbol) for symbol in self.symbols(dimension)}
        scalars = {name: x for name, x in named.items() if "_" not in name}
        vectors = {f"v{i}": Vector(*[named[f"v{j}_{i}"] for j in range(dimension)]) for i in "12"}
        return Operands(**scalars, **vectors)


class FramedKind(CurveKind):
    """A curve with the roots σ = ‖γ′‖ and, in space, ρ = ‖γ′ × γ″‖ adjoined: for readings that can divide."""

    def names(self, dimension: int) -> dict[str, bool]:
        """Those of a curve, and the roots."""
        return super().names(dimension) | {"sigma": False} | ({"rho": False} if dimension == 3 else {})

    def takes(self, other: Kind, dimension: int) -> bool:
        """Those of curves without a frame, too.

        >>> FRAMED_SPACE.takes(SPACE, 3), FRAMED_SPACE.takes(POINT_IN_SPACE, 3), SPACE.takes(FRAMED_SPACE, 3)
        (True, False, False)
        """
        return isinstance(other, CurveKind) and not other.with_point and dimension in other.dimensions

    def argument(
        self, dimension: int, operand: Callable[[Symbol], T], one: T, *, polynomial: bool = False
    ) -> Evaluated:
        """The curve with its roots."""
        curve: Any = super().argument(dimension, operand, one, polynomial=polynomial)
        return framed(curve)


def _functions(names: str, w: str, dimension: int, which: int, polynomial: bool) -> tuple[Symbol, ...]:
    """The functions of one curve: numerators, and the denominator of a rational one."""
    bar = "\u0304" if which else ""
    own = [*names[:dimension], *([] if polynomial else [w])]
    return tuple(Symbol(name, name.lower() + bar, PARAMETERS[which]) for name in own)


def _curve(named: dict[str, Any], names: str, w: str, one: Any, point: Vector[Any] | None = None) -> Curve[Any]:
    return Curve(Vector(*[named[name] for name in names]), named.get(w, one), polynomial=w not in named, point=point)


CURVE, PLANE, SPACE = CurveKind("curve", (2, 3)), CurveKind("plane", (2,)), CurveKind("space", (3,))
PLANE_POINT, POINT_IN_SPACE = CurveKind("plane point", (2,), with_point=True), CurveKind("point", (3,), with_point=True)
PAIR, TABLE = PairKind(), TableKind()
FRAMED = FramedKind("framed", (2, 3))
FRAMED_PLANE, FRAMED_SPACE = FramedKind("framed plane", (2,)), FramedKind("framed space", (3,))
#: The kinds by their names.
KINDS: dict[str, Kind] = {
    kind.name: kind
    for kind in (CURVE, PLANE, SPACE, TABLE, PAIR, POINT_IN_SPACE, PLANE_POINT, FRAMED, FRAMED_PLANE, FRAMED_SPACE)
}


def common_kind(kinds: Iterable[Kind]) -> Kind:
    """The kind of argument on which formulas of all these kinds can be evaluated, in the dimensions that they share.

    >>> common_kind([PLANE, PLANE_POINT]), common_kind([CURVE, SPACE])
    (<kind plane point>, <kind curve>)
    """
    return next((kind for kind in kinds if not any(kind is k for k in (CURVE, PLANE, SPACE))), CURVE)


def kind_of(name: str) -> Kind:
    """The kind with this name.

    >>> kind_of("plane").dimensions
    (2,)

    Raises `FormulaError` with the names there are.
    """
    if name not in KINDS:
        raise FormulaError(f"no kind of argument is called {name!r}", remedy=f"there are {', '.join(KINDS)}")
    return KINDS[name]


#: The dimensions in which there are formulas of a kind.
DIMENSIONS = {name: kind.dimensions for name, kind in KINDS.items()}
