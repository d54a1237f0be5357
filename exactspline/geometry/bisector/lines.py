"""Lines of solutions along pairs that a rational parameter describes: directrix and generator in lowest terms."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import fmpz_mpoly, fmpz_poly

from exactspline.exact import mpq, to_fmpz
from exactspline.geometry.bisector.flats import ALL, Conditions
from exactspline.geometry.bisector.polynomials import Interval, as_splines, common_divisor, lifted, rows_of
from exactspline.geometry.bisector.system import System
from exactspline.language.rational import Rational
from exactspline.language.ruled import RuledSurface
from exactspline.language.vector import Vector, cross, dot, norm2
from exactspline.splines.bernstein import substituted
from exactspline.splines.values import RationalSurface

ONE, PARAMETER = fmpz_poly([1]), fmpz_poly([0, 1])
#: A parameter as a quotient of polynomials in the parameter of the lines.
Quotient = tuple[fmpz_poly, fmpz_poly]


@dataclass(frozen=True)
class Path:
    """Pairs as quotients of polynomials in one parameter."""

    s: Quotient
    t: Quotient


def constant(value: mpq) -> Quotient:
    """A rational number."""
    return fmpz_poly([to_fmpz(value.numerator)]), fmpz_poly([to_fmpz(value.denominator)])


def along(polynomials: Sequence[fmpz_mpoly], path: Path) -> list[fmpz_poly]:
    """Polynomials in both parameters along a path, all times one power of its denominators."""
    m, n = (max((int(p.degrees()[i]) for p in polynomials if p), default=0) for i in (0, 1))
    found = []
    for p in polynomials:
        rows = [substituted(row, m, path.s[1], path.s[0]) for row in rows_of(p)]
        total = fmpz_poly([])
        for j, row in enumerate(rows):
            total += row * path.t[0] ** j * path.t[1] ** (n - j)
        found.append(total)
    return found


def lines_along(system: System, path: Path, interval: Interval, conditions: Conditions = ALL) -> RationalSurface | None:
    """The lines in which the planes meet along a path, as a ruled surface over an interval; None where the planes are
    parallel.

    The directrix is the foot of γ on the line, so that in lowest terms it is infinite only where the line is.
    """
    *p, w = along([lifted(f, 0) for f in (*system.first.p, system.first.w)], path)
    *chord, weight = along([*system.chord, system.weight], path)
    e = Vector(*chord)
    rows = []
    if Conditions.FIRST in conditions:
        rows.append((Vector(*along(list(system.a), path)), fmpz_poly([])))
    if Conditions.MIDDLE in conditions:
        rows.append((Vector(*[x * 2 for x in e]), norm2(e)))
    if Conditions.SECOND in conditions:
        b = Vector(*along(list(system.b), path))
        rows.append((b, dot(b, e)))
    for i, (one, height) in enumerate(rows):
        for other, its in rows[:i]:
            normal = cross(one, other)
            if any(normal):
                return _ruled((one, height), (other, its), normal, (p, w, weight), interval)
    return None


def _ruled(
    one: tuple[Vector[fmpz_poly], fmpz_poly],
    other: tuple[Vector[fmpz_poly], fmpz_poly],
    normal: Vector[fmpz_poly],
    foot: tuple[list[fmpz_poly], fmpz_poly, fmpz_poly],
    interval: Interval,
) -> RationalSurface:
    (r, h), (q, k), (p, w, weight) = one, other, foot
    factor = common_divisor(normal)
    n = Vector(*[x // factor for x in normal])
    below = factor * norm2(n) * weight
    offsets = [h * x + k * y for x, y in zip(cross(q, n), cross(n, r), strict=True)]
    quotient = [*[x * below + w * y for x, y in zip(p, offsets, strict=True)], w * below]
    shared = common_divisor(quotient)
    *top, bottom = as_splines([f // shared for f in quotient], *interval)
    directrix = Rational(Vector(*top), bottom)
    return RuledSurface(directrix, Rational(Vector(*as_splines(list(n), *interval)), directrix.product))
