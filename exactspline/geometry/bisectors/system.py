"""The linear system of two curves on one patch, with polynomials in both parameters as its entries.

A point B = γ + Y/(w w̄) lies in both normal planes and in the plane of equal distance when ``a·Y = 0``, ``b·Y = b·E``
and ``2E·Y = E·E``: here a and b are the tangents γ′ and γ̄′ without their common factors, and E = w p̄ − w̄ p is the
chord.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import reduce
from typing import Protocol, Self, TypeVar

from flint import fmpz_mpoly, fmpz_poly

from exactspline.errors import ReachError
from exactspline.language.operand import Scalar
from exactspline.language.vector import Vector, cross, det, dot, norm2
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Box, Interval
from exactspline.numbers.once import cached_property
from exactspline.one_line import OneLine
from exactspline.polynomials.factors import factorize, greatest_common_divisor
from exactspline.polynomials.two_parameters import lifted
from exactspline.roots.of_polynomials import Parameter, roots_in
from exactspline.roots.values import segment_polynomials
from exactspline.roots.vanishing import vanish_at
from exactspline.splines.nurbs import Nurbs

# ---- polynomials


class Euclidean(Scalar, Protocol):
    """A polynomial in one parameter over the integers or a field."""

    def __mul__(self, other: Self | int, /) -> Self: ...
    def __floordiv__(self, other: Self, /) -> Self: ...
    def gcd(self, other: Self, /) -> Self:
        """The greatest common divisor."""


E = TypeVar("E", bound=Euclidean)


# ---- one parameter


def common_divisor_along(polynomials: Iterable[E]) -> E:
    """The greatest common divisor of polynomials in one parameter. Raises `ReachError` if this would take too long."""
    given = list(polynomials)
    if isinstance(given[0], fmpz_poly):
        return greatest_common_divisor(given)  # type: ignore[type-var]  # all of them are of one type
    return reduce(lambda p, q: p.gcd(q), given)


# ---- two parameters


def vanish_together(polynomials: Sequence[fmpz_mpoly], s: Parameter, t: Parameter) -> bool | None:
    """Whether polynomials vanish at a pair, decided exactly; None if this would take too long."""
    try:
        return vanish_at(polynomials, s, t)
    except ReachError:
        return None


@dataclass(frozen=True, repr=False)
class SegmentOfCurve(OneLine):
    """One segment of a curve as polynomials in its parameter: the point ``p/w`` and the tangent without its zeros.

    ``cusps`` are irreducible polynomials whose roots on the interval are the zeros of γ′; if γ′ vanishes identically,
    the tangent is zero.
    """

    interval: Interval
    p: list[fmpz_poly]
    w: fmpz_poly
    tangent: list[fmpz_poly]
    cusps: tuple[fmpz_poly, ...]

    def __reduce__(self) -> tuple[object, ...]:
        # polynomials of FLINT do not pickle
        parts = [self.p, [self.w], self.tangent, self.cusps]
        return _piece, (self.interval, [[[int(x) for x in f.coeffs()] for f in part] for part in parts])

    @property
    def stands_still(self) -> bool:
        """Whether the segment is a single point."""
        return not any(self.tangent)

    def over(self, variable: int) -> list[list[fmpz_mpoly]]:
        """p and w, and the tangent, as polynomials in two parameters, of which this one is the first (0) or the
        second.
        """
        return [[lifted(f, variable) for f in own] for own in ((*self.p, self.w), self.tangent)]

    def homogeneous(self, t: mpq) -> list[int]:
        """Integers that are homogeneous coordinates of a point, the weight last."""
        n = max(f.degree() for f in (*self.p, self.w))
        top, bottom = int(t.numerator), int(t.denominator)
        return [sum(int(x) * top**k * bottom ** (n - k) for k, x in enumerate(f.coeffs())) for f in (*self.p, self.w)]


def _piece(interval: Interval, parts: list[list[list[int]]]) -> SegmentOfCurve:
    p, (w,), tangent, cusps = ([fmpz_poly(f) for f in part] for part in parts)
    return SegmentOfCurve(interval, p, w, tangent, tuple(cusps))


def piece(curve: Nurbs, i: int) -> SegmentOfCurve:
    """Segment i of a curve.

    >>> from exactspline.interchange.examples import example
    >>> piece(example("twisted_cubic"), 0).tangent
    [1, 2*x, 3*x^2]
    """
    interval = Interval(*curve.breakpoints[i : i + 2])
    *p, w = segment_polynomials((*curve.p, curve.w), i)
    shared = common_divisor_along([*p, w])
    *p, w = [f // shared for f in (*p, w)]
    velocity = [f.derivative() * w - f * w.derivative() for f in p]
    if not any(velocity):
        return SegmentOfCurve(interval, p, w, velocity, ())
    shared = common_divisor_along(velocity)
    cusps = tuple(q for q, _ in factorize(shared).powers if q.degree() > 0 and roots_in(q, *interval))
    return SegmentOfCurve(interval, p, w, [f // shared for f in velocity], cusps)


@dataclass(frozen=True, repr=False)
class System(OneLine):
    """The linear system of two pieces, with its rows over both parameters."""

    first: SegmentOfCurve
    second: SegmentOfCurve

    def __reduce__(self) -> tuple[object, ...]:
        # computed values are recomputed when needed
        return System, (self.first, self.second)

    @property
    def sides(self) -> Box:
        """The closed rectangle of the patch."""
        return Box(self.first.interval, self.second.interval)

    @cached_property
    def a(self) -> Vector[fmpz_mpoly]:
        """The tangent of the first curve, nowhere zero on its side."""
        return Vector(*[lifted(f, 0) for f in self.first.tangent])

    @cached_property
    def b(self) -> Vector[fmpz_mpoly]:
        """The tangent of the second curve, nowhere zero on its side."""
        return Vector(*[lifted(f, 1) for f in self.second.tangent])

    @cached_property
    def chord(self) -> Vector[fmpz_mpoly]:
        """``E = w p̄ − w̄ p``."""
        (*p, w), (*q, v) = self.first.over(0)[0], self.second.over(1)[0]
        return Vector(*[w * y - v * x for x, y in zip(p, q, strict=True)])

    @property
    def cusps(self) -> list[fmpz_mpoly]:
        """Equations of the pairs at which one of the curves has no tangent."""
        return [lifted(q, k) for k, own in enumerate((self.first, self.second)) for q in own.cusps]

    @cached_property
    def weight(self) -> fmpz_mpoly:
        """``w w̄``."""
        return lifted(self.first.w, 0) * lifted(self.second.w, 1)

    @cached_property
    def determinant(self) -> fmpz_mpoly:
        """``[a b E]``."""
        return det(self.a, self.b, self.chord)

    @cached_property
    def numerators(self) -> list[fmpz_mpoly]:
        """``2 [a b E] Y`` by Cramer's rule: ``2 (b·E)(E × a) + (E·E)(a × b)``."""
        a, b, e = self.a, self.b, self.chord
        over, square = dot(b, e) * 2, norm2(e)
        return [over * x + square * y for x, y in zip(cross(e, a), cross(a, b), strict=True)]

    @cached_property
    def factor(self) -> fmpz_mpoly:
        """The common factor of determinant and numerators: along the zeros of this factor the system is singular, and
        the minors do not exclude solutions. The factor is zero if all minors vanish.
        """
        return greatest_common_divisor([self.determinant, *self.numerators])

    def transposed(self) -> System:
        """The system with the curves exchanged."""
        return System(self.second, self.first)

    def crosses(self) -> list[Vector[fmpz_mpoly]]:
        """The cross products of the three normals, two at a time: all zero where they are parallel."""
        return [cross(self.a, self.chord), cross(self.a, self.b), cross(self.b, self.chord)]


def divides(factor: fmpz_mpoly, v: Vector[fmpz_mpoly]) -> bool:
    """Whether a polynomial divides all components."""
    return all(not f or not divmod(f, factor)[1] for f in v)


def irreducible_factors(p: fmpz_mpoly) -> list[fmpz_mpoly]:
    """The irreducible factors that depend on a parameter, each once, their first coefficient positive."""
    factors = [q for q in factorize(p).bases if q.total_degree() > 0]
    return sorted((q if q.leading_coefficient() > 0 else -q for q in factors), key=str)
