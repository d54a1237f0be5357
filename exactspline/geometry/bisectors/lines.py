"""Lines of solutions over one parameter, the other one a quotient of polynomials in it or an irrational constant:
directrix and generator in lowest terms.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import islice
from typing import Generic, TypeVar

from flint import fmpq_poly, fmpz_mpoly, fmpz_poly

from exactspline.geometry.bisectors.flats import ALL, Conditions
from exactspline.geometry.bisectors.polynomials import Euclidean, common_divisor_along
from exactspline.geometry.bisectors.root_lines import RootLines
from exactspline.geometry.bisectors.system import System
from exactspline.language.rational import Rational
from exactspline.language.ruled import RuledSurface
from exactspline.language.vector import Vector, cross, dot, norm2
from exactspline.numbers.exact import mpq, to_fmpz
from exactspline.numbers.intervals import Interval
from exactspline.one_line import OneLine
from exactspline.polynomials.bernstein import substituted
from exactspline.polynomials.over_root import OverRoot, by_powers
from exactspline.polynomials.two_parameters import lifted, rows_of
from exactspline.roots.of_polynomials import as_splines
from exactspline.roots.root import Root
from exactspline.splines.bspline import BSpline
from exactspline.splines.lowest_terms import RationalSurface

P = TypeVar("P", bound=Euclidean)

ONE, PARAMETER = fmpz_poly([1]), fmpz_poly([0, 1])
#: A parameter as a quotient of polynomials in the parameter of the lines.
Quotient = tuple[fmpz_poly, fmpz_poly]


@dataclass(frozen=True, repr=False)
class Path(OneLine):
    """Pairs as quotients of polynomials in one parameter."""

    s: Quotient
    t: Quotient


def constant(value: mpq) -> Quotient:
    """A rational number."""
    return fmpz_poly([to_fmpz(value.numerator)]), fmpz_poly([to_fmpz(value.denominator)])


def along(polynomials: Sequence[fmpz_mpoly], path: Path) -> list[fmpz_poly]:
    """Polynomials in both parameters along a path, all multiplied by one power of its denominators."""
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
    """For each polynomial, the coefficients of the powers of the root, all of one degree."""
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
