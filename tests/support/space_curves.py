"""Space curves for the tests, made from polynomials and put together from pieces; a rotation and a reflection."""

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


#: A rotation and a reflection, each three times an orthogonal matrix.
TURNED = [[2, -1, 2], [2, 2, -1], [-1, 2, 2]]
MIRRORED = [[-2, 1, -2], [2, 2, -1], [-1, 2, 2]]
