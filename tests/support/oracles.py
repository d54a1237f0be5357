"""What the kernel is held against: textbook algorithms on knots and control points, sharing no code with it."""

from itertools import combinations
from math import comb

from flint import fmpq, fmpq_mat
from gmpy2 import mpq

from exactspline import BSpline, TensorSpline


def basis(knots, n, i, t, side="right"):
    """The B-spline N_{i,n} at t by the recursion of Cox and de Boor; at a knot the limit from the side."""
    if n == 0:
        return mpq(knots[i] <= t < knots[i + 1] if side == "right" else knots[i] < t <= knots[i + 1])
    low, high = knots[i + n] - knots[i], knots[i + n + 1] - knots[i + 1]
    left = (t - knots[i]) / low * basis(knots, n - 1, i, t, side) if low else mpq(0)
    right = (knots[i + n + 1] - t) / high * basis(knots, n - 1, i + 1, t, side) if high else mpq(0)
    return left + right


def span(knots, n, t, side="right"):
    """Index j of the non-empty span [t_j, t_{j+1}] of the domain that holds t."""
    spans = [j for j in range(n, len(knots) - n - 1) if knots[j] < knots[j + 1]]
    inside = [j for j in spans if knots[j] <= t <= knots[j + 1]]
    return inside[0] if side == "left" else inside[-1]


def polar(knots, n, points, j, arguments):
    """The polar form (blossom) of the polynomial over span j, by de Boor's triangle with one argument a column."""
    d = {i: points[i] for i in range(j - n, j + 1)}
    for r, u in enumerate(arguments, start=1):
        d = {
            i: ((knots[i + n + 1 - r] - u) * d[i - 1] + (u - knots[i]) * d[i]) / (knots[i + n + 1 - r] - knots[i])
            for i in range(j - n + r, j + 1)
        }
    return d[j]


def value(knots, n, points, t, side="right"):
    """Value by the de Boor algorithm."""
    return polar(knots, n, points, span(knots, n, t, side), [t] * n)


def differentiated(knots, n, points):
    """Knots and control points of the derivative of a spline of degree n ≥ 1, by differences; where a basis function is
    void the point is free.
    """
    widths = [knots[i + n] - knots[i] for i in range(1, len(points))]
    return knots[1:-1], [n * (b - a) / h if h else mpq(0) for a, b, h in zip(points, points[1:], widths, strict=False)]


def data(f):
    """Knots, degree and control points of a spline, the order in which the oracles take them."""
    return tuple(f.knots), f.degree, f.control_points


def derivative_values(knots, n, points, t, side="right"):
    """The value and the n derivatives at t."""
    values = []
    while n >= 0:
        values.append(value(knots, n, points, t, side))
        if n:
            knots, points = differentiated(knots, n, points)
        n -= 1
    return values


def jet(knots, n, rows, t, order, side="right"):
    """The value and the derivatives up to an order at t of a spline of rows of numbers, by differences of its control
    points and de Boor's algorithm.
    """
    j, found = span(knots, n, t, side), []
    points = {i: rows[i] for i in range(j - n, j + 1)}
    for m in range(n, n - order - 1, -1):
        if m < 0:
            found.append([mpq(0)] * len(rows[0]))
            continue
        columns = [{i: p[k] for i, p in points.items()} for k in range(len(rows[0]))]
        found.append([polar(knots, m, column, j, [t] * m) for column in columns])
        points = {
            i: [m * (b - a) / (knots[i + m] - knots[i]) for a, b in zip(points[i - 1], points[i], strict=True)]
            for i in range(j - m + 1, j + 1)
        }
    return found


def product_knots(f, g):
    """The knots of a product (Mørken): a knot of multiplicity m of one factor gets m plus the degree of the other;
    clamped ends.
    """
    (a, b), n = f.domain, f.degree + g.degree
    inner = {
        t: max([h.knots.multiplicity(t) + other.degree for h, other in ((f, g), (g, f)) if t in h.knots.knots])
        for t in sorted({*f.knots, *g.knots})
        if a < t < b
    }
    return (*[a] * (n + 1), *[t for t, m in inner.items() for _ in range(m)], *[b] * (n + 1))


def collocated(knots, n, function):
    """Control points over clamped knots of the spline that interpolates the function, by solving the collocation
    system.

    Site i is the mean of the n+2 knots of N_i: inside its support, increasing, and never at a jump (Schoenberg–Whitney
    holds).
    """
    size = len(knots) - n - 1
    sites = [sum(knots[i : i + n + 2]) / (n + 2) for i in range(size)]
    rows = [[_fmpq(basis(knots, n, i, s)) for i in range(size)] for s in sites]
    solution = fmpq_mat(rows).solve(fmpq_mat([[_fmpq(function(s))] for s in sites]))
    return tuple(mpq(int(solution[i, 0].p), int(solution[i, 0].q)) for i in range(size))


def _fmpq(x):
    x = mpq(x)
    return fmpq(int(x.numerator), int(x.denominator))


def blossomed(knots, f, g):
    """Control points of the product over the given knots: means of products of polar forms over all ways to deal out
    the knots (Lee, Mørken).
    """
    n = f.degree + g.degree
    points = []
    for i in range(len(knots) - n - 1):
        inner = knots[i + 1 : i + n + 1]
        j = next(j for j in range(i, i + n + 1) if knots[j] < knots[j + 1])
        middle = (knots[j] + knots[j + 1]) / 2
        spans = [span(h.knots, h.degree, middle) for h in (f, g)]
        total = mpq(0)
        for chosen in combinations(range(n), f.degree):
            mine = [inner[k] for k in chosen]
            yours = [inner[k] for k in range(n) if k not in chosen]
            total += polar(f.knots, f.degree, f.control_points, spans[0], mine) * polar(
                g.knots, g.degree, g.control_points, spans[1], yours
            )
        points.append(total / comb(n, f.degree))
    return tuple(points)


def inner_parameters(f, count):
    """This many parameters inside every segment."""
    pairs = zip(f.breakpoints, f.breakpoints[1:], strict=False)
    return [a + (b - a) * mpq(k, count + 1) for a, b in pairs for k in range(1, count + 1)]


def places(f):
    """Every breakpoint from both sides, and as many parameters in every segment as determine a polynomial of the
    degree.
    """
    return [(t, side) for t in f.breakpoints for side in ("left", "right")] + [
        (t, "right") for t in inner_parameters(f, max(f.degree, 0) + 1)
    ]


def rebuilt(f):
    """The spline made anew from what it prints."""
    return BSpline(f.degree, [str(t) for t in f.knots], [str(b) for b in f.control_points])


def assert_function(f, function):
    """f has the given values at its breakpoints from both sides and at enough places between; its printed data give the
    same by de Boor.
    """
    knots, n, points = data(f)
    for t, side in places(f):
        expected = function(t, side)
        assert f(t, side) == expected
        assert value(knots, n, points, t, side) == expected
    assert rebuilt(f) == f


def surface_value(knots, degrees, net, s, t):
    """Value of a tensor-product spline by the de Boor algorithm, in t on every row of the net and then in s."""
    return value(knots[0], degrees[0], [value(knots[1], degrees[1], row, t) for row in net], s)


def surface_data(f):
    """Knots, degrees and control points of a spline in two parameters."""
    return tuple(tuple(k) for k in f.knots), f.degree, f.control_points


def transposed(net):
    """The net with rows and columns exchanged."""
    return [list(column) for column in zip(*net, strict=True)]


def surface_places(f):
    """All corners of patches, and in each patch as many places as determine a polynomial of the degrees."""
    sides = []
    for mesh, n in zip(f.meshes, f.degree, strict=True):
        pairs = zip(mesh.breaks, mesh.breaks[1:], strict=False)
        count = max(n, 0) + 1
        sides.append([*mesh.breaks, *[a + (b - a) * mpq(k, count + 1) for a, b in pairs for k in range(1, count + 1)]])
    return [(s, t) for s in sides[0] for t in sides[1]]


def surface_rebuilt(f):
    """The spline made anew from what it prints."""
    knots = [[str(x) for x in k] for k in f.knots]
    return TensorSpline(tuple(f.degree), *knots, [[str(b) for b in row] for row in f.control_points])


def assert_surface(f, function):
    """f has the given values at enough places; its printed data give the same by de Boor."""
    data = surface_data(f)
    for s, t in surface_places(f):
        expected = function(s, t)
        assert f(s, t) == expected
        assert surface_value(*data, s, t) == expected
    assert (len(f.control_points), len(f.control_points[0])) == f.control_point_counts
    assert surface_rebuilt(f) == f
