"""Lines of solutions over one parameter: directrix and generator in lowest terms. The other parameter is a quotient of
polynomials in the first, or an irrational constant.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import Flag, auto
from itertools import islice
from typing import Any, Generic, TypeVar

from flint import arb, ctx, fmpq_poly, fmpz_mpoly, fmpz_poly

from exactspline.errors import ReachError, ShapeError
from exactspline.geometry.bisectors.system import Euclidean, System, common_divisor_along, vanish_together
from exactspline.language.rational import Rational
from exactspline.language.ruled import RuledSurface
from exactspline.language.vector import Vector, cross, dot, norm2
from exactspline.numbers.exact import Number, mpq, primitive, rational, to_fmpq, to_fmpz
from exactspline.numbers.intervals import Interval
from exactspline.one_line import OneLine, short_text
from exactspline.polynomials.bernstein import substituted
from exactspline.polynomials.elimination import resultant
from exactspline.polynomials.over_root import OverRoot, by_powers
from exactspline.polynomials.two_parameters import S, T, enclosed, lifted, rows_of
from exactspline.roots.of_polynomials import Parameter, as_splines, ball, exactly, roots_in
from exactspline.roots.root import Root
from exactspline.roots.values import segment_polynomials
from exactspline.splines.bspline import BSpline
from exactspline.splines.lowest_terms import RationalSurface

# ---- lines over a root


# ---- flats


N = TypeVar("N", mpq, arb)


class Conditions(Flag):
    """The effective planes of the system: a curve without a tangent has no normal plane."""

    FIRST = auto()
    SECOND = auto()
    MIDDLE = auto()


ALL = Conditions.FIRST | Conditions.SECOND | Conditions.MIDDLE


@dataclass(frozen=True, repr=False)
class Flat(OneLine, Generic[N]):
    """A point, and the direction of a line through it or the normal of a plane; an exact direction or normal has
    coprime integers.
    """

    point: tuple[N, ...]
    direction: tuple[N, ...]


def flat_at(system: System, s: mpq, t: mpq, conditions: Conditions, *, plane: bool) -> Flat[mpq]:
    """The solutions of a pair of rational parameters whose rank is known."""

    def value(p: fmpz_mpoly) -> mpq:
        return mpq(sum((int(x) * s ** int(i) * t ** int(j) for (i, j), x in p.terms()), mpq(0)))

    found = _flat(system, value, conditions, plane)
    return Flat(found.point, primitive(found.direction))


def enclosed_flat(
    system: System, s: Parameter, t: Parameter, conditions: Conditions, digits: int, *, plane: bool
) -> Flat[arb]:
    """The solutions of a pair of parameters whose rank is known, in balls."""
    with ctx.workprec(8 * digits + 128):
        balls = ball(s, digits + 10), ball(t, digits + 10)
        return _flat(system, lambda p: enclosed(p, *balls), conditions, plane)


def _flat(system: System, value: Any, conditions: Conditions, plane: bool) -> Flat[Any]:
    a, b, e = (Vector(*[value(x) for x in v]) for v in (system.a, system.b, system.chord))
    rows = [
        (condition, v, h)
        for condition, v, h in (
            (Conditions.FIRST, a, value(lifted(system.first.w, 0)) * 0),
            (Conditions.SECOND, b, dot(b, e)),
            (Conditions.MIDDLE, Vector(*[x * 2 for x in e]), norm2(e)),
        )
        if condition in conditions
    ]
    w, weight = value(lifted(system.first.w, 0)), value(system.weight)
    foot = [value(lifted(f, 0)) / w for f in system.first.p]
    if plane:
        _, normal, height = max(rows, key=lambda row: _size(norm2(row[1])))
        offset = [height * x / (norm2(normal) * weight) for x in normal]
        return Flat(_sum(foot, offset), tuple(normal))
    pairs = [(one, other) for i, one in enumerate(rows) for other in rows[:i]]
    (_, r, h), (_, q, k) = max(pairs, key=lambda pair: _size(norm2(cross(pair[0][1], pair[1][1]))))
    n = cross(r, q)
    below = norm2(n) * weight
    offset = [(h * x + k * y) / below for x, y in zip(cross(q, n), cross(n, r), strict=True)]
    return Flat(_sum(foot, offset), tuple(n))


def _sum(one: Any, other: Any) -> tuple[Any, ...]:
    return tuple(x + y for x, y in zip(one, other, strict=True))


def _size(x: Any) -> Any:
    """The key for choosing among several normals. Any nonzero normal is right, so that a rounded size is enough."""
    return x.lower() if isinstance(x, arb) else x


#: A coordinate: the coefficients of 1, r, r², … for a root r.
Coordinate = tuple[BSpline, ...]


@dataclass(frozen=True, repr=False)
class RootLines(OneLine):
    """Lines as a ruled surface over a segment of one parameter (``of``: 0 is s, 1 is t) at an irrational value r of the
    other one.

    Every coordinate of the ``directrix`` (homogeneous: wx, wy, wz, w) and of the ``generator`` is a tuple of splines,
    the coefficients of 1, r, r², … below the degree of r: exact numbers of the field of r. ``poles`` are the parameters
    whose line is at infinity, decided exactly; None where this takes too much work.
    """

    of: int
    other: Root
    interval: Interval
    directrix: tuple[Coordinate, ...]
    generator: tuple[Coordinate, ...]
    poles: tuple[Parameter, ...] | None

    @classmethod
    def over(
        cls, other: Root, interval: Interval, directrix: tuple[Coordinate, ...], generator: tuple[Coordinate, ...]
    ) -> RootLines:
        """The lines over the second curve at an irrational parameter of the first, with their poles."""
        return cls(1, other, interval, directrix, generator, _poles(directrix[-1], other, interval))

    @property
    def degree(self) -> int:
        """The degree of the surface in its parameter."""
        return max(self.directrix[0][0].degree, self.generator[0][0].degree)

    def line(self, parameter: Number, digits: int = 20) -> Flat[arb]:
        """A point and the direction of a line, in balls, which are not finite where the line is at infinity; raises
        `ShapeError` outside the segment.
        """
        u = rational(parameter)
        if not self.interval[0] <= u <= self.interval[1]:
            raise ShapeError(f"{short_text(u)} is outside this piece", remedy="stay inside the segment")
        with ctx.workprec(8 * digits + 128):
            root = ball(self.other, digits + 10)
            *top, w = (_value(x, u, root) for x in self.directrix)
            return Flat(tuple(x / w for x in top), tuple(_value(x, u, root) for x in self.generator))

    def transposed(self) -> RootLines:
        """The lines of the exchanged curves."""
        return replace(self, of=1 - self.of)


def _poles(weight: Coordinate, r: Root, interval: Interval) -> tuple[Parameter, ...] | None:
    """The zeros of the weight of a directrix, a polynomial in r and the parameter."""
    p = lifted(fmpz_poly([]), 0)
    for k, part in enumerate(segment_polynomials(weight, 0)):
        p += lifted(part, 1) * S**k
    try:
        # among the zeros of the product of the weights at all conjugates of r
        minimal = [fmpz_poly([x]) for x in r.minimal_polynomial()]
        candidates = [exactly(t) for t in roots_in(resultant(minimal, rows_of(p.compose(T, S))), *interval)]
        vanishing = [vanish_together([p], r, t) for t in candidates]
    except ReachError:
        return None
    return None if None in vanishing else tuple(t for t, is_zero in zip(candidates, vanishing, strict=True) if is_zero)


def _value(x: Coordinate, u: mpq, root: arb) -> arb:
    total = arb(0)
    for f in reversed(x):
        total = total * root + arb(to_fmpq(f(u)))
    return total


P = TypeVar("P", bound=Euclidean)

ONE, PARAMETER = fmpz_poly([1]), fmpz_poly([0, 1])
#: A parameter of a curve as a quotient of polynomials in the parameter of the lines.
Quotient = tuple[fmpz_poly, fmpz_poly]


@dataclass(frozen=True, repr=False)
class Path(OneLine):
    """A curve of pairs: both parameters as quotients of polynomials in one parameter."""

    s: Quotient
    t: Quotient


def constant(value: mpq) -> Quotient:
    """A rational number as a constant quotient."""
    return fmpz_poly([to_fmpz(value.numerator)]), fmpz_poly([to_fmpz(value.denominator)])


def along(polynomials: Sequence[fmpz_mpoly], path: Path) -> list[fmpz_poly]:
    """Polynomials in both parameters along a path, all multiplied by the same power of the denominators of the path."""
    m, n = (max((int(p.degrees()[i]) for p in polynomials if p), default=0) for i in (0, 1))
    values = []
    for p in polynomials:
        rows = [substituted(row, m, path.s[1], path.s[0]) for row in rows_of(p)]
        total = fmpz_poly([])
        for j, row in enumerate(rows):
            total += row * path.t[0] ** j * path.t[1] ** (n - j)
        values.append(total)
    return values


def lines_along(system: System, path: Path, interval: Interval, conditions: Conditions = ALL) -> RationalSurface | None:
    """The lines in which the planes meet along a path, as a ruled surface over an interval; None where the planes are
    parallel.

    The directrix is the foot of γ on the line, so that in lowest terms it is infinite only where the line is.
    """
    *p, w = along([lifted(f, 0) for f in (*system.first.p, system.first.w)], path)
    *chord, weight = along([*system.chord, system.weight], path)
    a, b = (Vector(*along(list(v), path)) for v in (system.a, system.b))
    line = _in_lowest_terms(_Entries(p, w, Vector(*chord), weight, a, b), conditions)
    if line is None:
        return None
    *top, bottom = as_splines(line[0], *interval)
    directrix = Rational(Vector(*top), bottom)
    return RuledSurface(directrix, Rational(Vector(*as_splines(line[1], *interval)), directrix.product))


def lines_over_root(system: System, s: Root, conditions: Conditions = ALL) -> RootLines | None:
    """The lines in which the planes meet at an irrational parameter of the first curve, over all of the second; None
    where the planes are parallel.
    """
    modulus = fmpq_poly(s.minimal_polynomial())
    (*p, w), chord, (weight,), a, b = (
        [OverRoot.of(f, modulus) for f in part]
        for part in (
            [lifted(f, 0) for f in (*system.first.p, system.first.w)],
            system.chord,
            [system.weight],
            system.a,
            system.b,
        )
    )
    line = _in_lowest_terms(_Entries(p, w, Vector(*chord), weight, Vector(*a), Vector(*b)), conditions)
    if line is None:
        return None
    directrix, generator = (_splines(part, system.second.interval) for part in line)
    return RootLines.over(s, system.second.interval, directrix, generator)


def _splines(polynomials: Sequence[OverRoot], interval: Interval) -> tuple[tuple[BSpline, ...], ...]:
    """For each polynomial the coefficients of the powers of the root, all of the same degree."""
    rows = by_powers(polynomials)
    splines = iter(as_splines([p for row in rows for p in row], *interval))
    return tuple(tuple(islice(splines, len(row))) for row in rows)


@dataclass(frozen=True)
class _Entries(Generic[P]):
    """The entries of the system as functions of one parameter: foot, chord with its weight, tangents."""

    p: list[P]
    w: P
    chord: Vector[P]
    weight: P
    a: Vector[P]
    b: Vector[P]

    def planes(self, conditions: Conditions) -> list[tuple[Vector[P], P]]:
        """Normals and offsets of the requested planes."""
        e, nothing = self.chord, self.w - self.w
        rows = []
        if Conditions.FIRST in conditions:
            rows.append((self.a, nothing))
        if Conditions.MIDDLE in conditions:
            rows.append((Vector(*[x * 2 for x in e]), norm2(e)))
        if Conditions.SECOND in conditions:
            rows.append((self.b, dot(self.b, e)))
        return rows


def _in_lowest_terms(given: _Entries[P], conditions: Conditions) -> tuple[list[P], list[P]] | None:
    """The directrix, homogeneous, and the generator of the lines in which two of the planes meet."""
    rows = given.planes(conditions)
    for i, one in enumerate(rows):
        for other in rows[:i]:
            normal = cross(one[0], other[0])
            if any(normal):
                return _directrix_and_generator(one, other, normal, given)
    return None


def _directrix_and_generator(
    one: tuple[Vector[P], P], other: tuple[Vector[P], P], normal: Vector[P], given: _Entries[P]
) -> tuple[list[P], list[P]]:
    (r, h), (q, k) = one, other
    factor = common_divisor_along(normal)
    n = Vector(*[x // factor for x in normal])
    below = factor * norm2(n) * given.weight
    offsets = [h * x + k * y for x, y in zip(cross(q, n), cross(n, r), strict=True)]
    quotient = [*[x * below + given.w * y for x, y in zip(given.p, offsets, strict=True)], given.w * below]
    shared = common_divisor_along(quotient)
    return [f // shared for f in quotient], list(n)
