"""What can be done to a curve without changing what there is to tell of it, each with where a parameter goes.

Made from knots, control points and weights alone.
"""

from gmpy2 import mpq

from exactspline import BSpline, Nurbs


def homogeneous(curve):
    """The columns of weighted coordinates, and of the weights."""
    rows = [[*(x * w for x in p), w] for p, w in zip(curve.control_points, curve.weights, strict=True)]
    return [list(column) for column in zip(*rows, strict=True)]


def from_rows(degree, knots, rows):
    """A curve from homogeneous control points; the weights must not vanish."""
    return Nurbs(degree, knots, [tuple(x / r[-1] for x in r[:-1]) for r in rows], [r[-1] for r in rows])


def same(curve, points=None, weights=None, knots=None):
    """The curve with other points, weights or knots."""
    return Nurbs(
        curve.degree, knots or list(curve.knots), points or list(curve.control_points), weights or list(curve.weights)
    )


def similar(p):
    """A similarity: turned by the angle of a 3-4-5 triangle, 7/2 times as large, moved."""
    x, y, *rest = p
    moved = ((3 * x - 4 * y) / mpq(5), (4 * x + 3 * y) / mpq(5), *rest)
    return tuple(c * mpq(7, 2) + d for c, d in zip(moved, (3, -1, 2), strict=False))


def turned(curve):
    """Every control point moved by one similarity."""
    return same(curve, points=[similar(p) for p in curve.control_points]), lambda t: t


def mirrored(curve):
    """Mirrored in the line, or the plane, where the first coordinate is 0."""
    return same(curve, points=[(-p[0], *p[1:]) for p in curve.control_points]), lambda t: t


def backwards(curve):
    """Run through the other way."""
    a, b = curve.domain
    knots = [a + b - t for t in reversed(list(curve.knots))]
    return Nurbs(curve.degree, knots, curve.control_points[::-1], curve.weights[::-1]), lambda t: a + b - t


def with_idle_knots(curve):
    """A knot inserted into every segment, by Boehm's algorithm."""
    knots, n = list(curve.knots), curve.degree
    rows = [list(r) for r in zip(*homogeneous(curve), strict=True)]
    for a, b in list(zip(curve.breakpoints, curve.breakpoints[1:], strict=False)):
        t = (2 * a + b) / 3
        j = max(i for i, u in enumerate(knots) if u <= t)
        made = []
        for i in range(len(rows) + 1):
            if i <= j - n:
                made.append(rows[i])
            elif i > j:
                made.append(rows[i - 1])
            else:
                share = (t - knots[i]) / (knots[i + n] - knots[i])
                made.append([(1 - share) * x + share * y for x, y in zip(rows[i - 1], rows[i], strict=True)])
        rows, knots = made, sorted([*knots, t])
    return from_rows(n, knots, rows), lambda t: t


def scaled_weights(curve):
    """All weights 5/3 times as large."""
    return same(curve, weights=[w * mpq(5, 3) for w in curve.weights]), lambda t: t


def negated_weights(curve):
    """All weights negated."""
    return same(curve, weights=[-w for w in curve.weights]), lambda t: t


def affine(curve):
    """The parameter 3t − 2."""
    return same(curve, knots=[3 * t - 2 for t in curve.knots]), lambda t: 3 * t - 2


def moebius(curve):
    """The parameter ``u = t / (1 + k (t − a))``, increasing on the domain: of the homogeneous blossom each argument t
    leaves a factor ``1 + k (t − a)`` below.
    """
    knots, n = list(curve.knots), curve.degree
    k = mpq(1, 3) / max(knots[-1] - knots[0], 1)
    low = min(knots)

    def below(t):
        return 1 + k * (t - low)

    def image(t):
        return (t - low) / below(t)

    rows = []
    for i, row in enumerate(zip(*homogeneous(curve), strict=True)):
        factor = mpq(1)
        for t in knots[i + 1 : i + n + 1]:
            factor = factor / below(t)
        rows.append([x * factor for x in row])
    return from_rows(n, [image(t) for t in knots], rows), image


def elevated(curve):
    """Written with a degree more."""
    columns = [BSpline(curve.degree, list(curve.knots), c).elevate_degree(1) for c in homogeneous(curve)]
    rows = list(zip(*[c.control_points for c in columns], strict=True))
    return from_rows(curve.degree + 1, list(columns[0].knots), rows), lambda t: t


#: All of them by name, but for a mirror image; reversal changes the sign of the curvature of a plane curve.
CHANGES = {
    f.__name__: f
    for f in (turned, backwards, with_idle_knots, scaled_weights, negated_weights, affine, moebius, elevated)
}
