"""The curvature of a surface by a route of its own: rational numbers, the sum over basis functions, truncated Taylor
series, the shape operator by linear algebra.
"""

from itertools import pairwise

from gmpy2 import mpq

from tests.support.vectors import dot


class Jet:
    """A polynomial in two small quantities to the second order: coefficients of 1, x, y, x², xy, y²."""

    ORDERS = ((0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2))

    def __init__(self, *c):
        self.c = dict(zip(self.ORDERS, (*c, *[0] * (6 - len(c))), strict=True))

    def __add__(self, other):
        other = other if isinstance(other, Jet) else Jet(other)
        return Jet(*[self.c[k] + other.c[k] for k in self.ORDERS])

    __radd__ = __add__

    def __sub__(self, other):
        return self + other * -1

    def __rsub__(self, other):
        return self * -1 + other

    def __mul__(self, other):
        if not isinstance(other, Jet):
            return Jet(*[self.c[k] * other for k in self.ORDERS])
        found = dict.fromkeys(self.ORDERS, 0)
        for (a, b), x in self.c.items():
            for (d, e), y in other.c.items():
                if a + b + d + e <= 2:
                    found[a + d, b + e] += x * y
        return Jet(*found.values())

    __rmul__ = __mul__

    def __truediv__(self, other):
        if not isinstance(other, Jet):
            return self * (1 / other)
        # 1/(a + e) = 1/a − e/a² + e²/a³
        a = other.c[0, 0]
        e = other - a
        return self * (e * e * (1 / a**3) - e * (1 / a**2) + 1 / a)


def basis(degree, knots, at):
    """All N_i by the recursion of Cox and de Boor: each with N_i′ and N_i″/2 at a parameter."""
    found = [(int(a <= at < b or a < b == at == knots[-1]), 0, 0) for a, b in pairwise(knots)]
    for n in range(1, degree + 1):
        rising = [_times(f, at - a, b - a) for f, a, b in zip(found, knots, knots[n:], strict=False)]
        falling = [_times(f, at - b, a - b) for f, a, b in zip(found[1:], knots[1:], knots[n + 1 :], strict=False)]
        found = [tuple(map(sum, zip(f, g, strict=True))) for f, g in zip(rising, falling, strict=False)]
    return found


def _times(f, value, length):
    """A series times (value + x)/length; nothing where the length is zero, as the functions there are zero."""
    return tuple((f[k] * value + (f[k - 1] if k else 0)) / length if length else 0 for k in range(3))


def jets(surface, u, v, number=mpq):
    """The coordinates as jets at a point; `number` float for searches."""

    def exact(x):
        return number(mpq(x))

    along = [
        [(i, f) for i, f in enumerate(basis(n, [exact(t) for t in own], number(at))) if any(f)]
        for n, own, at in zip(surface.degree, surface.knots, (u, v), strict=True)
    ]
    sums = [Jet(0)] * (surface.dimension + 1)
    for i, f in along[0]:
        for j, g in along[1]:
            weighted = Jet(*[f[a] * g[b] for a, b in Jet.ORDERS]) * exact(surface.weights[i][j])
            row = (*surface.control_points[i][j], 1)
            sums = [x + weighted * exact(y) for x, y in zip(sums, row, strict=True)]
    return [x / sums[-1] for x in sums[:-1]]


def forms(surface, u, v, number=mpq):
    """E, F, G and L, M, N with the normal S_u × S_v."""
    own = jets(surface, number(u), number(v), number)
    su, sv, half_uu, suv, half_vv = ([x.c[k] for x in own] for k in Jet.ORDERS[1:])
    n = [su[1] * sv[2] - su[2] * sv[1], su[2] * sv[0] - su[0] * sv[2], su[0] * sv[1] - su[1] * sv[0]]
    second = dot(n, half_uu) * 2, dot(n, suv), dot(n, half_vv) * 2
    return dot(su, su), dot(su, sv), dot(sv, sv), *second


def shape_operator(surface, u, v, number=mpq):
    """The matrix of the shape operator times the length of the normal, and the square of that; None where there is no
    tangent plane.
    """
    e, f, g, ll, m, n = forms(surface, u, v, number)
    area = e * g - f * f
    if area == 0:
        return None
    rows = [(g * ll - f * m) / area, (g * m - f * n) / area, (e * m - f * ll) / area, (e * n - f * m) / area]
    return rows, area


def gaussian_curvature(surface, u, v, number=mpq):
    """K: the determinant of the shape operator."""
    found = shape_operator(surface, u, v, number)
    if found is None:
        return None
    (a, b, c, d), area = found
    return (a * d - b * c) / area


def umbilicity(surface, u, v, number=mpq):
    """How far the shape operator is from a multiple of the identity: zero at umbilics alone; None without a tangent
    plane.
    """
    found = shape_operator(surface, u, v, number)
    if found is None:
        return None
    (a, b, c, d), _ = found
    # the gap of the eigenvalues, squared, beside their size
    size = (a + d) ** 2 + (a - d) ** 2 + b * b + c * c
    return ((a - d) ** 2 + 4 * b * c) / size if size else number(0)
