"""A knot inserted into a curve, on its control points: Boehm's algorithm. Only the points around the knot and the
segment that it splits are computed.

Source: W. Boehm, Inserting new knots into B-spline curves, CAD 1980.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from itertools import accumulate, pairwise, repeat
from math import comb, gcd, lcm
from operator import mul

from flint import fmpz, fmpz_poly

from exactspline.language.provenance import leaf
from exactspline.numbers.exact import mpq
from exactspline.splines.bspline import BSpline
from exactspline.splines.knots import KnotVector


def is_clamped(knots: KnotVector, degree: int) -> bool:
    """Whether both ends of the domain are knots of multiplicity degree + 1."""
    t = knots.knots
    return t[0] == t[degree] and t[-1] == t[-1 - degree]


def boehm(knots: Sequence[mpq], degree: int, columns: Sequence[Sequence[mpq]], t: mpq) -> list[tuple[mpq, ...]]:
    """Columns of control points over the knots with t inserted once more.

    >>> boehm([mpq(0), mpq(0), mpq(1), mpq(1)], 1, [[mpq(0), mpq(4)]], mpq(1, 4))
    [(mpq(0,1), mpq(1,1), mpq(4,1))]
    """
    before, after = unchanged(knots, degree, t)
    factors = [(t - knots[i]) / (knots[i + degree] - knots[i]) for i in range(before, after + 1)]
    found = []
    for points in columns:
        pairs = zip(factors, points[before - 1 :], points[before:], strict=False)
        found.append((*points[:before], *[p + x * (q - p) for x, p, q in pairs], *points[after:]))
    return found


def unchanged(knots: Sequence[mpq], degree: int, t: mpq) -> tuple[int, int]:
    """The control points that stay when t is inserted, however often: those before the first index, and those from the
    second on.
    """
    return bisect_right(knots, t) - degree, bisect_left(knots, t) - 1


def _halves(
    polynomials: Sequence[fmpz_poly], below: fmpz, n: int, t: mpq
) -> tuple[tuple[list[fmpz_poly], fmpz], tuple[list[fmpz_poly], fmpz]]:
    """Forms over one denominator on both sides of a local parameter, in lowest terms: de Casteljau's algorithm in
    integers.
    """
    a, q = int(t.numerator), int(t.denominator)
    binomials = [comb(n, k) for k in range(n + 1)]
    unit, powers = lcm(*binomials), [*accumulate(repeat(q, n), mul, initial=1)]
    lefts, rights = [], []
    for c in polynomials:
        row = [int(c[k]) * (unit // binomials[k]) for k in range(n + 1)]
        left, right = [row[0] * powers[n]], [row[n] * powers[n]]
        for k in range(1, n + 1):
            row = [(q - a) * x + a * y for x, y in pairwise(row)]
            left.append(row[0] * powers[n - k] * binomials[k])
            right.append(row[-1] * powers[n - k] * binomials[k])
        lefts.append(left)
        rights.append(right[::-1])
    whole = int(below) * unit * powers[n]
    return _lowest(lefts, whole), _lowest(rights, whole)


def _lowest(rows: list[list[int]], below: int) -> tuple[list[fmpz_poly], fmpz]:
    shared = gcd(below, *[x for row in rows for x in row])
    return [fmpz_poly([x // shared for x in row]) for row in rows], fmpz(below // shared)


def inserted(splines: Sequence[BSpline], t: mpq, times: int) -> list[BSpline]:
    """The components of one curve, over clamped knots and common denominators, with a knot inserted inside the domain;
    its multiplicity is then at most degree + 1.
    """
    f = splines[0]
    degree, mesh, vector = f.degree, f.mesh, f.knots
    columns = [g.control_points for g in splines]
    for _ in range(times):
        columns = boehm(vector.knots, degree, columns, t)
        vector = vector.insert(t)
    below = f.denominators
    rows: list[tuple[fmpz_poly, ...]] = [g._polynomials for g in splines]
    i, lowered = bisect_left(mesh.breaks, t), degree - vector.knots.count(t)
    if mesh.breaks[i] == t:
        continuity = (*f.continuity[: i - 1], lowered, *f.continuity[i:])
    else:
        parts = _halves([row[i - 1] for row in rows], below[i - 1], degree, mesh.local(i - 1, t))
        rows = [(*row[: i - 1], *(own[j] for own, _ in parts), *row[i:]) for j, row in enumerate(rows)]
        below = (*below[: i - 1], *(m for _, m in parts), *below[i:])
        mesh = mesh.refined(i - 1, t)
        continuity = (*f.continuity[: i - 1], lowered, *f.continuity[i - 1 :])
    return [
        BSpline.from_parts(degree, mesh, continuity, row, below, leaf(), vector, column)
        for row, column in zip(rows, columns, strict=True)
    ]
