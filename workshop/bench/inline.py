"""The formulas of the benchmarks written by hand over bare polynomials, subexpressions shared: as a program without
this library would compute them. They run over anything with ``+ − *``, given the derivative of a polynomial of a
degree.

python-flint's polynomials hold the forms of the library in ``z = v/u``; those of sympy and of `Fraction` are in powers
of t.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Protocol, Self, TypeVar

from flint import fmpz_poly

U_PLUS_V = fmpz_poly([1, 1])


class Polynomial(Protocol):
    """A polynomial of any library."""

    def __add__(self, other: Self, /) -> Self: ...
    def __sub__(self, other: Self, /) -> Self: ...
    def __mul__(self, other: Self, /) -> Self: ...
    def __rmul__(self, other: int, /) -> Self: ...


P = TypeVar("P", bound=Polynomial)
#: The derivative of a polynomial with respect to the parameter, given its degree.
D = Callable[[P, int], P]


def form_derivative(p: fmpz_poly, degree: int) -> fmpz_poly:
    """The derivative of a form of that degree, as a form of the same degree."""
    return p.derivative() * U_PLUS_V - degree * p


def f2(x: P, y: P, w: P, n: int, d: D[P]) -> P:
    """``[X X′ X″]`` of ``X = (x, y, w)``: the inflections."""
    x1, y1, w1 = d(x, n), d(y, n), d(w, n)
    x2, y2, w2 = d(x1, n - 1), d(y1, n - 1), d(w1, n - 1)
    return (x1 * y2 - y1 * x2) * w - (x * y2 - y * x2) * w1 - (x1 * y - y1 * x) * w2


def g2(x: P, y: P, w: P, n: int, d: D[P]) -> P:
    """The critical points of the curvature, as the paper reduces them."""
    x1, y1, w1 = d(x, n), d(y, n), d(w, n)
    x2, y2, w2 = d(x1, n - 1), d(y1, n - 1), d(w1, n - 1)
    x3, y3, w3 = d(x2, n - 2), d(y2, n - 2), d(w2, n - 2)
    ax, ay = x1 * w - x * w1, y1 * w - y * w1
    bx, by = x2 * w - x * w2, y2 * w - y * w2
    cx, cy = x3 * w - x * w3, y3 * w - y * w3
    ex, ey = x2 * w1 - x1 * w2, y2 * w1 - y1 * w2
    speed, turn = ax * ax + ay * ay, ax * by - ay * bx
    return ((ax * (cy + ey) - ay * (cx + ex)) * w + 2 * w1 * turn) * speed - 3 * (ax * bx + ay * by) * turn * w


def vertices(x: P, y: P, w: P, n: int, d: D[P]) -> P:
    """``[X X′ X″ X‴]`` of ``X = (x² + y², x w, y w, w²)``, expanded by pairs of rows."""
    rows = [[x * x + y * y, x * w, y * w, w * w]]
    for k in range(3):
        rows.append([d(p, 2 * n - k) for p in rows[-1]])
    (a, b, c, e), (a1, b1, c1, e1), (p, q, r, s), (p1, q1, r1, s1) = rows
    return (
        (a * b1 - b * a1) * (r * s1 - s * r1)
        - (a * c1 - c * a1) * (q * s1 - s * q1)
        + (a * e1 - e * a1) * (q * r1 - r * q1)
        + (b * c1 - c * b1) * (p * s1 - s * p1)
        - (b * e1 - e * b1) * (p * r1 - r * p1)
        + (c * e1 - e * c1) * (p * q1 - q * p1)
    )


def cross(a: Sequence[P], b: Sequence[P]) -> list[P]:
    """a × b."""
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a: Sequence[P], b: Sequence[P]) -> P:
    """a · b."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def differences(p: Sequence[P], w: P, n: int, d: D[P]) -> list[list[P]]:
    """``p⁽ᵏ⁾ w − p w⁽ᵏ⁾`` for k = 1, 2, 3."""
    weights, points = [w], [list(p)]
    for k in range(3):
        weights.append(d(weights[-1], n - k))
        points.append([d(x, n - k) for x in points[-1]])
    return [[x * w - y * weights[k] for x, y in zip(points[k], p, strict=True)] for k in (1, 2, 3)]


def torsion(p: Sequence[P], w: P, n: int, d: D[P]) -> tuple[P, P]:
    """Numerator and denominator of the reduced torsion of a space curve."""
    a, b, c = differences(p, w, n, d)
    binormal = cross(a, b)
    return w * w * dot(binormal, c), dot(binormal, binormal)


def one_parameter(x: P, y: P, z: P, w: P, degree: int, d: D[P]) -> tuple[P, ...]:
    """The data of one curve for the symmetric bisector: D1, its height, the squared length of p, p, w and w²."""
    x1, y1, z1, w1 = (d(p, degree) for p in (x, y, z, w))
    a = x1 * w - x * w1, y1 * w - y * w1, z1 * w - z * w1
    return (*a, x * a[0] + y * a[1] + z * a[2], x * x + y * y + z * z, x, y, z, w, w * w)


def bisector_patch(one: Sequence[P], two: Sequence[P]) -> tuple[list[P], P]:
    """The numerators of the symmetric bisector of two curves, doubled, and its denominator, on one patch."""
    *a, h, n, x, y, z, w, w2 = one
    *b, k, m, p, q, r, v, v2 = two
    middle, e = (x * v - p * w, y * v - q * w, z * v - r * w), n * v2 - m * w2
    normal, hv, kw = cross(a, b), 2 * (h * v), 2 * (k * w)
    first, second = cross(b, middle), cross(middle, a)
    numerators = [f * hv + g * kw + c * e for f, g, c in zip(first, second, normal, strict=True)]
    return numerators, dot(normal, middle) * (w * v)
