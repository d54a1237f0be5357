"""Space curves for the tests, made from polynomials and put together from pieces, and what can be done to a curve
without changing its shape.
"""

from gmpy2 import mpq

from exactspline import BSpline, Nurbs


def power_curve(*coordinates, domain=(-1, 1)):
    """The Bézier curve with these coordinates, lists of coefficients in the power basis."""
    t = BSpline.identity(*domain)
    n = max(len(c) for c in coordinates) - 1
    splines = []
    for coefficients in coordinates:
        total, power = t.constant(0), t.constant(1)
        for c in coefficients:
            total, power = total + power * mpq(c), power * t
        splines.append(
            total.elevate_degree(n - total.degree) if total.degree < n else total.reduce_degree(total.degree - n)
        )
    a, b = domain
    return Nurbs(n, [a] * (n + 1) + [b] * (n + 1), list(zip(*[s.control_points for s in splines], strict=True)))


def chained(*curves):
    """Bézier curves of one degree over adjacent intervals as one curve, with full multiplicity between them."""
    n = curves[0].degree
    ends = [curves[0].domain[0], *[c.domain[1] for c in curves]]
    points, weights = [p for c in curves for p in c.control_points], [w for c in curves for w in c.weights]
    return Nurbs(n, [t for t in ends for _ in range(n + 1)], points, weights)


def moved(curve, matrix, shift=(0, 0, 0)):
    """The curve after a linear map and a translation of its control points."""
    rows = [[mpq(x) for x in row] for row in matrix]

    def image(point):
        return tuple(
            sum(a * x for a, x in zip(row, point, strict=True)) + mpq(d) for row, d in zip(rows, shift, strict=True)
        )

    points = [image(p) for p in curve.control_points]
    return Nurbs(curve.degree, curve.knots, points, curve.weights)


def backwards(curve):
    """The curve run through the other way, over the same domain."""
    knots = curve.knots.knots
    turned = [knots[curve.degree] + knots[-curve.degree - 1] - t for t in reversed(knots)]
    return Nurbs(curve.degree, turned, curve.control_points[::-1], curve.weights[::-1])


#: A rotation and a reflection, each three times an orthogonal matrix, and a mere scaling.
TURNED = [[2, -1, 2], [2, 2, -1], [-1, 2, 2]]
SCALED = [[7, 0, 0], [0, 7, 0], [0, 0, 7]]
MIRRORED = [[-2, 1, -2], [2, 2, -1], [-1, 2, 2]]
