"""A knot inserted into a curve, on its control points: Boehm's algorithm. Only the points around the knot and the
segment that it splits are computed.

Source: W. Boehm, Inserting new knots into B-spline curves, CAD 1980.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Sequence

from flint import fmpz, fmpz_poly

from exactspline.language.provenance import leaf
from exactspline.numbers.exact import mpq
from exactspline.numbers.immutable import fill
from exactspline.polynomials.bernstein import over_common_denominator, restrict
from exactspline.splines.bspline import BSpline
from exactspline.splines.knots import KnotVector


def is_clamped(knots: KnotVector, degree: int) -> bool:
    """Whether both ends of the domain are knots of multiplicity degree + 1."""
    t = knots.knots
    return t[0] == t[degree] and t[-1] == t[-1 - degree]


def boehm(knots: Sequence[mpq], degree: int, points: Sequence[mpq], t: mpq) -> list[mpq]:
    """The control points over the knots with t inserted once more.

    >>> boehm([mpq(0), mpq(0), mpq(1), mpq(1)], 1, [mpq(0), mpq(4)], mpq(1, 4))
    [mpq(0,1), mpq(1,1), mpq(4,1)]
    """
    k, first = bisect_right(knots, t) - 1, bisect_left(knots, t)
    new = []
    for i in range(k - degree + 1, first):
        a = knots[i]
        x = (t - a) / (knots[i + degree] - a)
        p = points[i - 1]
        new.append(p + x * (points[i] - p))
    return [*points[: k - degree + 1], *new, *points[first - 1 :]]


def inserted(splines: Sequence[BSpline], t: mpq, times: int) -> list[BSpline]:
    """The components of one curve, over clamped knots and common denominators, with a knot inserted inside the domain;
    its multiplicity is then at most degree + 1.
    """
    f = splines[0]
    degree, mesh, vector = f.degree, f.mesh, f.knots
    columns = [g.control_points for g in splines]
    for _ in range(times):
        columns = [tuple(boehm(vector.knots, degree, column, t)) for column in columns]
        vector = vector.insert(t)
    below = f.denominators
    rows: list[tuple[fmpz_poly, ...]] = [g._polynomials for g in splines]
    i, lowered = bisect_left(mesh.breaks, t), degree - vector.knots.count(t)
    if mesh.breaks[i] == t:
        continuity = (*f.continuity[: i - 1], lowered, *f.continuity[i:])
    else:
        parts: list[tuple[list[fmpz_poly], fmpz]] = []
        local = mesh.local(i - 1, t)
        for a, b in ((mpq(0), local), (local, mpq(1))):
            parts.append(over_common_denominator([restrict((row[i - 1], below[i - 1]), degree, a, b) for row in rows]))
        rows = [(*row[: i - 1], *(own[j] for own, _ in parts), *row[i:]) for j, row in enumerate(rows)]
        below = (*below[: i - 1], *(m for _, m in parts), *below[i:])
        mesh = mesh.refined(i - 1, t)
        continuity = (*f.continuity[: i - 1], lowered, *f.continuity[i - 1 :])
    found = []
    for row, column in zip(rows, columns, strict=True):
        made = BSpline.from_parts(degree, mesh, continuity, row, below, leaf())
        fill(made, _knots=vector, _points=column)
        found.append(made)
    return found
