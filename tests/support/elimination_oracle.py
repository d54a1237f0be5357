"""The common points of two Bézier curves by another route than the library's: powers of the parameters instead of
Bernstein forms, FLINT's resultants in two variables instead of Bézout's matrix, complex roots of the resultants to
hundreds of digits instead of isolation, and every pair of them tried.

It shares no code with `exactspline.polynomials.plane_pairs`. It does not prove: two values are equal where they agree
to `BITS` bits.
"""

from __future__ import annotations

from fractions import Fraction
from functools import reduce
from math import comb, lcm
from typing import NamedTuple

from flint import Ordering, arb, ctx, fmpz_mpoly_ctx, fmpz_poly

BITS = 700
CONTEXT = fmpz_mpoly_ctx.get(["s", "t"], Ordering.lex)
S, T = CONTEXT.gens()

#: Rows of control points in homogeneous coordinates (w x, w y, w).
Rows = list[tuple[Fraction, Fraction, Fraction]]


class Common(NamedTuple):
    """A common point: approximate parameters, and the multiplicities of the parameters as roots of the resultants."""

    s: float
    t: float
    of_s: int
    of_t: int


def powers(rows: Rows) -> list[fmpz_poly]:
    """The coordinates as polynomials, over a common denominator."""
    n = len(rows) - 1
    columns = []
    for k in range(3):
        column = [Fraction(0)] * (n + 1)
        for i, row in enumerate(rows):
            for j in range(n - i + 1):
                column[i + j] += comb(n, i) * comb(n - i, j) * (-1) ** j * Fraction(row[k])
        columns.append(column)
    bottom = lcm(*[x.denominator for column in columns for x in column])
    return [fmpz_poly([int(x * bottom) for x in column]) for column in columns]


def _lifted(p, variable):
    return CONTEXT.from_dict({(i, 0) if variable == 0 else (0, i): x for i, x in enumerate(p.coeffs()) if x})


def _in_one(p, variable):
    coefficients = {int(e[variable]): x for e, x in p.to_dict().items()}
    return fmpz_poly([coefficients.get(k, 0) for k in range(max(coefficients, default=-1) + 1)])


def roots(p: fmpz_poly) -> list[tuple[arb, int]]:
    """The roots in [0, 1] with their multiplicities; roots at the ends exactly."""
    found = []
    for end, factor in ((0, fmpz_poly([0, 1])), (1, fmpz_poly([-1, 1]))):
        times = 0
        while p.degree() > 0 and p(end) == 0:
            p, times = p // factor, times + 1
        if times:
            found.append((arb(end), times))
    for base, times in p.factor()[1]:
        found += [
            (root.real, int(times))
            for root, _ in base.complex_roots()
            if root.imag.contains(0) and abs(root.imag) < arb(2) ** -200 and 0 < root.real < 1
        ]
    return found


def common_points(first: Rows, second: Rows) -> tuple[list[Common], bool]:
    """The common points, sorted, and whether the curves have a common component; its points are left out."""
    with ctx.workprec(BITS):
        p, q = powers(first), powers(second)
        equations = [
            _lifted(p[i], 0) * _lifted(q[j], 1) - _lifted(p[j], 0) * _lifted(q[i], 1)
            for i, j in ((0, 2), (1, 2), (0, 1))
        ]
        return solutions(equations)


def solutions(equations) -> tuple[list[Common], bool]:
    """The common zeros of polynomials in s and t on the unit square, and whether they have a common component."""
    with ctx.workprec(BITS):
        if not any(equations):
            return [], True
        component = reduce(lambda p, q: p.gcd(q), equations)
        shared = component.total_degree() > 0
        if not all(equations):
            equations = [e for e in equations if e] * 2
        if shared:
            equations = [e / component for e in equations]
        # combinations of the minors: those that vanish on one line through both curves are none of them
        for i, j in ((3, -5), (7, 2), (-4, 11)):
            f, g = equations[0] + i * equations[-1], equations[1] + j * equations[-1]
            if not f or not g or f.total_degree() <= 0 or g.total_degree() <= 0:
                return [], shared
            by = [_in_one(f.resultant(g, name), 1 - k) for k, name in enumerate(("s", "t"))]
            if all(by):
                break
        assert all(by), "the common component has been removed"
        ts, ss = (roots(r) for r in by)
        found = []
        for s, of_s in ss:
            for t, of_t in ts:
                on_component = shared and _is_zero(component, s, t)
                if not on_component and all(_is_zero(e, s, t) for e in equations):
                    found.append(Common(float(s), float(t), of_s, of_t))
        return sorted(found), shared


def _is_zero(e, s: arb, t: arb) -> bool:
    total = arb(0)
    for (i, j), x in e.to_dict().items():
        total += arb(x) * s ** int(i) * t ** int(j)
    return total.contains(0) and total.rad() < arb(2) ** -300
