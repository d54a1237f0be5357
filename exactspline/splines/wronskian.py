"""Wronskians of splines computed at their true degree at once, from partial derivatives of homogeneous forms.

For forms of degree n in u and v, with ``A = u ∂u + v ∂v`` and ``B = ∂v − ∂u`` (the derivative, where u + v = 1),
Euler's relation gives ``A^(r−i) Bⁱ f = (n−i)(n−i−1)…(n−r+1) f⁽ⁱ⁾``; the matrix that takes the r-th partial derivatives
to these has a power of u + v for determinant, that is 1. So the Wronskian is the determinant of the r-th partial
derivatives over a constant: of degree (r+1)(n−r), which is ``kd − 2m``, with nothing to divide.
"""

from __future__ import annotations

from math import factorial

from flint import fmpz, fmpz_poly

from exactspline.language.vector import Vector, det
from exactspline.numbers.exact import mpq, to_fmpz
from exactspline.polynomials.bernstein import raiser
from exactspline.splines.bspline import BSpline
from exactspline.splines.refinement import over


def lowest_wronskian(vector: Vector[BSpline]) -> BSpline:
    """The Wronskian of a vector of splines, at degree N(n − N + 1) for N components of degree n.

    >>> t = BSpline.bezier([0, "1/3", "2/3", 1])
    >>> lowest_wronskian(Vector(t.constant(1).elevate_degree(3), t, t * t * t.constant(1))).degree
    12
    """
    r, n = len(vector) - 1, max(f.degree for f in vector)
    first = vector[0]
    mesh = first.mesh
    for f in vector:
        mesh = mesh if f.mesh is mesh or f.mesh.breaks == mesh.breaks else mesh.union(f.mesh)
    splines = [over(f, mesh) for f in vector]
    if n < r:
        zero: BSpline = first.constant(0)
        return zero
    continuity = tuple(max(min(inner) - r, -1) for inner in zip(*[f.continuity for f in splines], strict=True))
    columns = [[_partials(c * raiser(n - f.degree), n, r) for c in f._polynomials] for f in splines]
    rows = [
        Vector(
            *[
                BSpline.from_forms(
                    n - r, mesh, continuity, [(parts[i], m) for parts, m in zip(column, f.denominators, strict=True)]
                )
                for column, f in zip(columns, splines, strict=True)
            ]
        )
        for i in range(r + 1)
    ]
    value: BSpline = det(*rows)
    return _scaled_by_widths(value, r, n)


def _partials(c: fmpz_poly, n: int, r: int) -> list[fmpz_poly]:
    """``∂u^(r−i) ∂vⁱ`` of a form of degree n, for i = 0 … r."""
    level = [c]
    for step in range(r):
        degree = fmpz(n - step)
        slopes = [p.derivative() for p in level]
        level = [degree * level[0] - slopes[0].left_shift(1), *slopes]
    return level


def _scaled_by_widths(value: BSpline, r: int, n: int) -> BSpline:
    """Over the constant of Euler's relation, and by the parameter of the spline instead of that of each segment."""
    constant, weight = 1, r * (r + 1) // 2
    for i in range(r + 1):
        constant *= factorial(n - i) // factorial(n - r)
    forms = []
    for (c, m), a, b in zip(value.forms, value.breakpoints, value.breakpoints[1:], strict=False):
        scale = mpq(1, constant) / (b - a) ** weight
        forms.append((c * to_fmpz(scale.numerator), m * to_fmpz(scale.denominator)))
    return BSpline.from_forms(value.degree, value.mesh, value.continuity, forms)
