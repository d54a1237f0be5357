"""The curvature of a surface by a route of its own: plain Fractions, the sum over basis functions, truncated Taylor
series, the shape operator by linear algebra.
"""

from fractions import Fraction


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


def basis(i, degree, knots, t, at):
    """N_i by the recursion of Cox and de Boor, t a jet around `at`."""
    if degree == 0:
        last = at == knots[-1] and knots[i] < knots[i + 1] == at
        return int(knots[i] <= at < knots[i + 1] or last)
    value = 0
    if knots[i + degree] > knots[i]:
        value = value + (t - knots[i]) / (knots[i + degree] - knots[i]) * basis(i, degree - 1, knots, t, at)
    if knots[i + degree + 1] > knots[i + 1]:
        factor = (knots[i + degree + 1] - t) / (knots[i + degree + 1] - knots[i + 1])
        value = value + factor * basis(i + 1, degree - 1, knots, t, at)
    return value


def jets(surface, u, v, number=Fraction):
    """The coordinates as jets at a point; `number` float for searches."""

    def exact(x):
        return number(Fraction(int(x.numerator), int(x.denominator)))

    knots = [[exact(t) for t in own] for own in surface.knots]
    along = [
        [basis(i, n, own, t, at) for i in range(len(own) - n - 1)]
        for n, own, t, at in zip(surface.degree, knots, (Jet(u, 1), Jet(v, 0, 1)), (u, v), strict=True)
    ]
    top, bottom = [Jet(0)] * surface.dimension, Jet(0)
    for f, row, weights in zip(along[0], surface.control_points, surface.weights, strict=True):
        if not isinstance(f, Jet):
            continue
        for g, point, weight in zip(along[1], row, weights, strict=True):
            if isinstance(g, Jet):
                factor = f * g * exact(weight)
                top = [x + factor * exact(y) for x, y in zip(top, point, strict=True)]
                bottom = bottom + factor
    return [x / bottom for x in top]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b, strict=True))


def forms(surface, u, v, number=Fraction):
    """E, F, G and L, M, N with the normal S_u × S_v."""
    own = jets(surface, number(u), number(v), number)
    su, sv, half_uu, suv, half_vv = ([x.c[k] for x in own] for k in Jet.ORDERS[1:])
    n = [su[1] * sv[2] - su[2] * sv[1], su[2] * sv[0] - su[0] * sv[2], su[0] * sv[1] - su[1] * sv[0]]
    second = dot(n, half_uu) * 2, dot(n, suv), dot(n, half_vv) * 2
    return dot(su, su), dot(su, sv), dot(sv, sv), *second


def shape_operator(surface, u, v, number=Fraction):
    """The matrix of the shape operator times the length of the normal, and the square of that; None where there is no
    tangent plane.
    """
    e, f, g, ll, m, n = forms(surface, u, v, number)
    area = e * g - f * f
    if area == 0:
        return None
    rows = [(g * ll - f * m) / area, (g * m - f * n) / area, (e * m - f * ll) / area, (e * n - f * m) / area]
    return rows, area


def gaussian_curvature(surface, u, v, number=Fraction):
    """K: the determinant of the shape operator."""
    found = shape_operator(surface, u, v, number)
    if found is None:
        return None
    (a, b, c, d), area = found
    return (a * d - b * c) / area


def umbilicity(surface, u, v, number=Fraction):
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
