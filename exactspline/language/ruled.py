"""Ruled surfaces, given by a directrix and a generator, as values of formulas."""

from __future__ import annotations

from typing import Any, Generic, TypeVar, cast, overload

from exactspline.hooks import Displayed
from exactspline.language.operand import Constant, Counted, D, HasDegree, Operand, OwnVectors, R
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector, cross, det
from exactspline.numbers.once import Immutable, fill
from exactspline.one_line import OneLine

T_co = TypeVar("T_co", covariant=True)
V = TypeVar("V")


class RuledSurface(OneLine, Immutable, Displayed, Generic[T_co]):
    """``directrix + ζ generator`` in any reading: two vectors (or vector quotients) that depend on a parameter s, and
    the ruling parameter ζ.

    >>> RuledSurface(Vector(1, 2, 3), Vector(0, 0, 1)).at(5)
    Vector(1, 2, 8)
    """

    __slots__ = ("directrix", "generator")

    directrix: T_co
    generator: T_co

    def __init__(self, directrix: T_co, generator: T_co) -> None:
        fill(self, directrix=directrix, generator=generator)

    def __reduce__(self) -> tuple[object, ...]:
        return RuledSurface, (self.directrix, self.generator)

    def __eq__(self, other: object) -> bool:
        """Whether both directrix and generator are equal (see `exactspline.geometry.derived.ruled_surfaces` for two
        representations of the same surface).
        """
        if not isinstance(other, RuledSurface):
            return NotImplemented
        return bool(self.directrix == other.directrix and self.generator == other.generator)

    def __hash__(self) -> int:
        return hash((RuledSurface, self.directrix, self.generator))

    def at(self, ruling: Constant) -> T_co:
        """The curve of constant ruling parameter."""
        directrix: Any = self.directrix
        generator: Any = self.generator
        return cast(T_co, directrix + generator * ruling)

    @property
    def degree(self: RuledSurface[HasDegree[D]]) -> D:
        """The degree in s of directrix + ζ generator for a constant ζ, counted as in Table 1 of the 2007 paper."""
        return self.joined.degree

    @property
    def joined(self) -> T_co:
        """Directrix and generator concatenated to one vector of twice as many components (over a common denominator if
        they are quotients).
        """
        directrix: Any = self.directrix
        generator: Any = self.generator
        operand = directrix.denominator if isinstance(directrix, Rational) else directrix[0]
        nothing = [operand.constant(0)] * len(directrix)
        return cast(T_co, _extended(directrix, [], nothing) + _extended(generator, nothing, []))


def ruled(directrix: V, generator: V) -> RuledSurface[V]:
    """Return the ruled surface ``directrix + ζ generator``.

    >>> ruled(Vector(1, 0, 0), Vector(0, 0, 1)).at(2)
    Vector(1, 0, 2)
    """
    if isinstance(directrix, OwnVectors):
        return cast("RuledSurface[V]", directrix.ruled(cast(Any, generator)))
    return RuledSurface(directrix, generator)


def development(surface: RuledSurface[Vector[R]]) -> R:
    """``[δ′ G G′]`` of a ruled surface δ + ζ G: zero when its tangent plane is constant along every ruling."""
    return det(surface.directrix.d(1), surface.generator, surface.generator.d(1))


def differences(a: RuledSurface[V], b: RuledSurface[V]) -> tuple[V, V]:
    """Vectors that vanish exactly where the rulings of two ruled surfaces (in any reading) coincide: ``G × Ḡ`` and
    ``(δ̄ − δ) × G``.
    """
    between: Any = b.directrix
    first: Any = a.generator
    second: Any = b.generator
    across: Any = cross(first, second)
    aside: Any = cross(between - a.directrix, first)
    return across, aside


def _extended(value: Any, before: list[Any], behind: list[Any]) -> Any:
    """A vector or vector quotient with additional components before and after those of the vector or numerator."""
    if isinstance(value, Rational):
        return value.with_numerator(lambda v: Vector(*before, *v, *behind))
    return Vector(*before, *value, *behind)


# ---- the parts of a value


C = TypeVar("C", bound=Counted)

#: The values that formulas return, in any reading: a scalar (possibly a quotient), a vector, or a ruled surface.
Value = Operand | Vector[Operand] | RuledSurface[Operand | Vector[Operand]]


@overload
def numerator(value: Rational[C]) -> C | Vector[C]:
    """The numerator of a quotient."""


@overload
def numerator(value: V) -> V:
    """A value without a denominator, unchanged."""


def numerator(value: object) -> object:
    """Return the numerator of a quotient, and any other value unchanged."""
    return value.numerator if isinstance(value, Rational) else value


@overload
def joined(value: RuledSurface[V]) -> V:
    """Directrix and generator of a ruled surface as one vector."""


@overload
def joined(value: V) -> V:
    """Any other value, unchanged."""


def joined(value: object) -> object:
    """Directrix and generator of a ruled surface concatenated to one vector; any other value unchanged."""
    return value.joined if isinstance(value, RuledSurface) else value


def split(value: Vector[C] | Rational[C] | RuledSurface[Vector[C] | Rational[C]] | C) -> tuple[list[C], C | None]:
    """The components of the numerator, and the denominator or None."""
    whole: Any = value.joined if isinstance(value, RuledSurface) else value
    top = whole.numerator if isinstance(whole, Rational) else whole
    components = list(top) if isinstance(top, Vector) else [top]
    return components, whole.denominator if isinstance(whole, Rational) else None
