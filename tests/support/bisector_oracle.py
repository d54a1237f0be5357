"""An oracle for pairs of parameters that shares no code with the package but its numbers: de Boor's algorithm over dual
numbers for points and tangents, Gaussian elimination for the three planes, families of curves with known bisectors.
"""

from dataclasses import dataclass
from itertools import pairwise

from flint import fmpq, fmpq_poly
from gmpy2 import mpq

from exactspline import Direction, Nurbs
from tests.support.vectors import dot


@dataclass(frozen=True)
class Dual:
    """a + b ε with ε² = 0."""

    a: mpq
    b: mpq

    def __add__(self, other):
        return Dual(self.a + other.a, self.b + other.b)

    def __sub__(self, other):
        return Dual(self.a - other.a, self.b - other.b)

    def __mul__(self, other):
        return Dual(self.a * other.a, self.a * other.b + self.b * other.a)

    def __truediv__(self, other):
        return Dual(self.a / other.a, (self.b * other.a - self.a * other.b) / other.a**2)


def number(x):
    return Dual(mpq(x), mpq(0))


ONE = number(1)


def spans(curve):
    """The indices of the knot spans that are not empty, and the spans."""
    n, knots = curve.degree, list(curve.knots)
    return [(k, (a, b)) for k, (a, b) in enumerate(pairwise(knots)) if a < b and n <= k < len(knots) - n - 1]


def point_and_tangent(curve, span, t):
    """γ and γ′ of the polynomial piece of a knot span, by de Boor's algorithm in homogeneous coordinates."""
    n, knots, x = curve.degree, list(curve.knots), Dual(mpq(t), mpq(1))
    d = []
    for i in range(span - n, span + 1):
        w = mpq(curve.weights[i])
        d.append([number(w * c) for c in curve.control_points[i]] + [number(w)])
    for r in range(1, n + 1):
        for j in range(n, r - 1, -1):
            low, high = knots[j + span - n], knots[j + 1 + span - r]
            alpha = (x - number(low)) * number(1 / mpq(high - low))
            d[j] = [(ONE - alpha) * p + alpha * q for p, q in zip(d[j - 1], d[j], strict=True)]
    *xs, w = d[n]
    values = [c / w for c in xs]
    return [v.a for v in values], [v.b for v in values]


# ---- polynomials


def power_basis(curve, span):
    """Numerators and denominator on a knot span, coefficients of t⁰, t¹, …: de Boor's algorithm on polynomials."""
    n, knots = curve.degree, list(curve.knots)
    # a point at infinity has the coordinates of its direction
    points = [
        [*([x * (1 if isinstance(p, Direction) else mpq(w))] for x in p), [mpq(w)]]
        for p, w in list(zip(curve.control_points, curve.weights, strict=True))[span - n : span + 1]
    ]
    for r in range(1, n + 1):
        for j in range(n, r - 1, -1):
            low, high = mpq(knots[j + span - n]), mpq(knots[j + 1 + span - r])
            rising, falling = [-low / (high - low), 1 / (high - low)], [high / (high - low), -1 / (high - low)]
            points[j] = [
                plus(times(falling, p), times(rising, q)) for p, q in zip(points[j - 1], points[j], strict=True)
            ]
    return points[n]


def times(a, b):
    found = [mpq(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            found[i + j] += x * y
    return found


def plus(a, b):
    longer = max(len(a), len(b))
    return [x + y for x, y in zip(a + [mpq(0)] * (longer - len(a)), b + [mpq(0)] * (longer - len(b)), strict=True)]


def planes(first, second):
    """The rows ``normal | height`` of a pair of feet with tangents."""
    (p, v), (q, u) = first, second
    chord = [y - x for x, y in zip(p, q, strict=True)]
    return [(v, dot(v, p)), (u, dot(u, q)), (chord, (dot(q, q) - dot(p, p)) / 2)]


def dimension(rows):
    """The dimension of the common points of planes (a row of zeros imposes none), −1 where there are none."""
    left = [[*normal, height] for normal, height in rows]
    rank = 0
    for column in range(3):
        pivot = next((row for row in left[rank:] if row[column]), None)
        if pivot is None:
            continue
        left.remove(pivot)
        left.insert(rank, pivot)
        left = [
            row if row is pivot else [x - row[column] / pivot[column] * y for x, y in zip(row, pivot, strict=True)]
            for row in left
        ]
        rank += 1
    return -1 if any(row[3] for row in left[rank:]) else 3 - rank


def holds(rows, b):
    """Whether a point lies in all planes."""
    return all(dot(normal, b) == height for normal, height in rows)


def flint(x):
    return fmpq(int(x.numerator), int(x.denominator))


def divisor(polynomials):
    """The greatest common divisor."""
    found = fmpq_poly([])
    for f in polynomials:
        found = found.gcd(f)
    return found


# ---- curves


def line(*points):
    return Nurbs(1, [0, 0, *range(1, len(points) - 1), len(points) - 1, len(points) - 1], points)


def bezier(*points, weights=None, domain=(0, 1)):
    n = len(points) - 1
    return Nurbs(n, [domain[0]] * (n + 1) + [domain[1]] * (n + 1), points, weights)


def curve_of(*coordinates):
    """The Bézier curve with these splines for coordinates."""
    highest = max(coordinates, key=lambda f: f.degree)
    return bezier(*zip(*[f.elevated_to(highest).control_points for f in coordinates], strict=True))


def circle(radius, height, quarters=4):
    """Quarters of a circle around the z-axis."""
    corners = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)][: 2 * quarters + 1]
    knots = [0, 0, 0, *[t for k in range(1, quarters) for t in (k, k)], quarters, quarters, quarters]
    # the weights of the quarters 1, 1, 2 run on from one to the next
    weights = [mpq(1), mpq(1), mpq(2), mpq(2), mpq(4), mpq(4), mpq(8), mpq(8), mpq(16)][: 2 * quarters + 1]
    return Nurbs(2, knots, [(radius * x, radius * y, height) for x, y in corners], weights)


def mapped(curve, function):
    return Nurbs(curve.degree, curve.knots, [function(*p) for p in curve.control_points], curve.weights)


def mirrored(curve):
    """In the plane z = −1."""
    return mapped(curve, lambda x, y, z: (x, y, -2 - z))


CUBIC = bezier((0, 0, 0), (1, 0, 1), (2, 2, 0), (3, 1, 2))
RATIONAL = bezier((0, 0, 0), (1, 0, 1), (2, 2, 0), weights=[1, 2, 1])
SPLINE = Nurbs(2, [0, 0, 0, 1, 2, 2, 2], [(0, 0, 0), (1, 0, 1), (1, 2, 0), (3, 1, 2)])
JUMPS = Nurbs(1, [0, 0, 1, 1, 2, 2], [(0, 0, 0), (1, 0, 0), (1, 1, 0), (2, 1, 1)])
CUSP = bezier((1, -1, 0), (-1, 1, 0), (-1, -1, 0), (1, 1, 0), domain=(-1, 1))
#: Its tangent at 0 is that of the unit circle: normal planes there and of the circle have the axis in common.
TOUCHING = bezier((1, -1, 1), (1, 0, -1), (1, 1, 1), domain=(-1, 1))
FAMILIES = {
    "coaxial circles of one radius": (circle(1, 0, 2), circle(1, 1, 2)),
    "coaxial circles": (circle(1, 0, 3), circle(2, 1, 2)),
    "concentric circles": (circle(1, 0, 2), circle(3, 0, 2)),
    "a circle and itself": (circle(1, 0, 2), circle(1, 0, 2)),
    "a cubic and its mirror image": (CUBIC, mirrored(CUBIC)),
    "a rational curve and its mirror image": (RATIONAL, mirrored(RATIONAL)),
    "a spline and its mirror image": (SPLINE, mirrored(SPLINE)),
    "a cubic and itself": (CUBIC, CUBIC),
    "a cubic and a part of itself": (CUBIC, CUBIC.restrict("1/3", 1)),
    "a cubic and a translated copy": (CUBIC, mapped(CUBIC, lambda x, y, z: (x + 1, y, z - 2))),
    "parallel lines": (line((0, 0, 0), (2, 0, 0)), line((-1, 0, 2), (3, 0, 2))),
    "parallel lines that meet in one normal plane": (line((0, 0, 0), (1, 0, 0)), line((1, 1, 0), (2, 1, 0))),
    "parallel lines apart": (line((0, 0, 0), (1, 0, 0)), line((2, 1, 0), (3, 1, 0))),
    "one line": (line((0, 0, 0), (2, 0, 0)), line((1, 0, 0), (5, 0, 0))),
    "skew lines": (line((-1, 0, 0), (1, 0, 0)), line((0, -1, 1), (0, 1, 1))),
    "crossing lines": (line((-1, 0, 0), (1, 0, 0)), line((0, -1, 0), (0, 1, 0))),
    "polygons in one plane": (line((0, 0, 0), (2, 0, 0), (2, 2, 0)), line((0, 2, 0), (2, 4, 0), (4, 4, 0))),
    "parabolas in one plane": (bezier((-1, 1, 0), (0, -1, 0), (1, 1, 0)), bezier((-1, -3, 0), (0, -1, 0), (1, -3, 0))),
    "a line and a circle around it": (line((0, 0, -1), (0, 0, 1)), circle(1, 0, 2)),
    "a line and a circle through it": (line((1, 0, -1), (1, 0, 1)), circle(1, 0, 2)),
    "a curve that touches a circle, and the circle": (TOUCHING, circle(1, 0, 2)),
    "a circle and a curve that touches it": (circle(1, 0, 2), TOUCHING),
    "a cusp and a curve through it": (CUSP, bezier(("-1/2", 1, -1), ("-1/2", -1, 0), ("-1/2", 1, 1))),
    "a cusp and a cubic": (CUSP, CUBIC),
    "two cusps": (CUSP, mapped(CUSP, lambda x, y, z: (y, z + 1, x))),
    "two cusps in one point": (CUSP, mapped(CUSP, lambda x, y, z: (x, z, y))),
    "a cusp and a line through it": (CUSP, line(("-1/2", 0, -1), ("-1/2", 0, 1))),
    "pieces with a jump": (JUMPS, mirrored(JUMPS)),
    "a point and a cubic": (line((1, 1, 1), (1, 1, 1)), CUBIC),
    "a point and a line through it": (line((1, 0, 0), (1, 0, 0)), line((0, 0, 0), (2, 0, 0))),
    "two points": (line((1, 1, 1), (1, 1, 1)), line((0, 1, 0), (0, 1, 0))),
    "one point": (line((1, 1, 1), (1, 1, 1)), line((1, 1, 1), (1, 1, 1))),
    "a curve that stands still": (line((0, 0, 0), (1, 0, 0), (1, 0, 0), (1, 2, 3)), CUBIC),
}
