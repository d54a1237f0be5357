"""What needs no lines: derivatives, degrees and lower degrees of a spline in two parameters, patch by patch on its
packed polynomials.
"""

from __future__ import annotations

from collections.abc import Iterable

from flint import fmpz_poly

from exactspline.polynomials.bernstein import primitive
from exactspline.polynomials.tensor_bernstein import columns, derivative, rows, without_powers
from exactspline.splines.tensor_parts import Degrees, Parts, TensorParts
from exactspline.splines.tensor_univariate import spread

Z_MINUS_1 = fmpz_poly([-1, 1])


def derived(f: TensorParts, direction: int) -> Parts:
    """The parts of the derivative by one parameter (0: the first), in which the degree is positive."""
    polynomials = [derivative(c, f.stride, f.degree, direction) for c in f._own]
    denominators = f.denominators
    if not f.meshes[direction].unit:
        widths = spread(f.meshes[direction].widths, direction, f.meshes)
        polynomials = [c * bottom for c, (_, bottom) in zip(polynomials, widths, strict=True)]
        denominators = tuple([m * top for m, (top, _) in zip(denominators, widths, strict=True)])
    (m, n), (s, t) = f.degree, f.continuity
    lower = tuple([max(c - 1, -1) for c in f.continuity[direction]])
    degree, continuity = (Degrees(m, n - 1), (s, lower)) if direction else (Degrees(m - 1, n), (lower, t))
    return degree, f.meshes, continuity, f.stride, tuple(polynomials), denominators


def true_degrees(f: TensorParts) -> Degrees:
    """Largest degree in each parameter, over the patches, of the polynomials themselves (−1 for zero)."""
    if not any(f._own):
        return Degrees(-1, -1)
    m, n = f.degree
    in_s = (row for c in f._own for row in rows(c, f.stride, n))
    in_t = (column for c in f._own for column in columns(c, f.stride, m))
    return Degrees(m - _multiplicity(in_s), n - _multiplicity(in_t))


def _multiplicity(polynomials: Iterable[fmpz_poly]) -> int:
    """How often ``u + v``, which is 1 + z, divides all of these polynomials, which are not all zero."""
    least = -1
    for p in polynomials:
        if p and p(-1) != 0:
            return 0
        if p:
            shifted = p(Z_MINUS_1)
            times = next(k for k in range(shifted.degree() + 1) if shifted[k])
            least = times if least < 0 else min(least, times)
    return least


def lowered(f: TensorParts, by_s: int, by_t: int) -> Parts | None:
    """The parts of the same function with its degrees lowered; None where it is zero, where it has more than one
    patch (knots may be smooth afterwards), and where its degrees are not that much too high.
    """
    true, (m, n) = true_degrees(f), f.degree
    degree = Degrees(m - by_s, n - by_t)
    if len(f.denominators) > 1 or min(by_s, by_t, *true) < 0 or degree.max(true) != degree:
        return None
    c, below = primitive((without_powers(f._own[0], f.stride, (by_s, by_t)), f.denominators[0]))
    return degree, f.meshes, f.continuity, f.stride, (c,), (below,)
