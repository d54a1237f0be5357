"""Functions that make exact curves: conic arcs as quadratics with rational weights, curves through points, closed
curves, and joined curves.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import accumulate, pairwise

from flint import fmpq_mat

from exactspline.errors import KnotError, NumberError, ShapeError, as_flag, as_items, counted, shown
from exactspline.interchange.segments import (
    DEGREES,
    Affine,
    Segment,
    arc_around_origin,
    conic_arc,
    joined_segments,
    mapped,
    turn_near,
)
from exactspline.interchange.segments import ellipse as full_ellipse
from exactspline.numbers.exact import Number, from_flint, isqrt, mpq, rational, to_fmpq
from exactspline.reals.real import square_root
from exactspline.splines.blossom import with_smooth_knots
from exactspline.splines.bspline import BSpline
from exactspline.splines.control_points import Point, exact_points, exact_weights
from exactspline.splines.inputs import checked_degree, exact_row
from exactspline.splines.nurbs import Nurbs, as_dimension
from exactspline.splines.type_checks import curve_of
from exactspline.words import Word, choice

__all__ = ["arc", "arc_through", "catmull_rom", "circle", "closed", "closed_spline", "conic", "ellipse"]
__all__ += ["from_powers", "hermite", "interpolate", "joined", "line", "polyline", "rotate"]


def line(start: Iterable[Number], end: Iterable[Number]) -> Nurbs:
    """Return the line segment between two points, over [0, 1].

    >>> line((0, 0), (4, 2))("1/2")
    (mpq(2,1), mpq(1,1))
    """
    return polyline([start, end])


def polyline(points: Iterable[Iterable[Number]], *, closed: bool = False) -> Nurbs:
    """Return the polygon through points, over the parameters 0, 1, 2, …; with `closed` the polygon ends at its first
    point.

    >>> polyline([(0, 0), (1, 0), (1, 1)], closed=True)("5/2")
    (mpq(1,2), mpq(1,2))

    Raises `ShapeError` for fewer than two points.
    """
    p = [*exact_points(points)]
    p += p[:1] * as_flag(closed, "whether the polygon is closed")
    return Nurbs(1, [0, *_parameters(range(len(p)), p), len(p) - 1], p)


def circle(centre: Iterable[Number] = (0, 0), radius: Number = 1) -> Nurbs:
    """Return a full circle in the plane, counter-clockwise from its rightmost point, in four segments.

    >>> x, y = circle((1, 0), "5/2")("1/3")
    >>> (x - 1) ** 2 + y**2
    mpq(25,4)

    Raises `ShapeError` if the radius is not positive.
    """
    r, centre = rational(radius), _point(centre)
    as_dimension(len(centre), 2, "centre")
    if r <= 0:
        raise ShapeError(f"the radius {r}", where="radius", remedy="it must be positive")
    return ellipse(centre, (r, 0), (0, r))


def ellipse(centre: Iterable[Number], u: Iterable[Number], v: Iterable[Number]) -> Nurbs:
    """Return the full ellipse ``centre + cos t u + sin t v`` in the plane or in space.

    >>> ellipse((0, 0, 1), (2, 0, 0), (0, 1, 1))(1)
    (mpq(0,1), mpq(1,1), mpq(2,1))
    """
    p, q, r = map(_point, (u, v, centre))
    for vector in (p, q):
        as_dimension(len(vector), len(r), "vector")
    return _curve(full_ellipse(Affine(list(zip(p, q, r, strict=True)))), "ellipse")


def arc(centre: Iterable[Number], start: Iterable[Number], end: Iterable[Number]) -> Nurbs:
    """Return the circular arc in the plane, counter-clockwise from `start` to `end`, or the full circle if these points
    coincide.

    >>> quarter = arc((0, 0), (3, 4), (-4, 3))
    >>> quarter.degree, quarter.weights
    (2, (mpq(2,1), mpq(1,1), mpq(1,1)))

    Raises `ShapeError` if the distances of both points from the centre are not exactly equal.
    """
    x, y = _point(centre)
    u, v = ((p[0] - x, p[1] - y) for p in (_point(start), _point(end)))
    return _curve(mapped(arc_around_origin(u, v), Affine([[1, 0, x], [0, 1, y]])), "arc")


def conic(form: Sequence[Number], start: Iterable[Number], end: Iterable[Number]) -> Nurbs:
    """Return an arc of the conic A x² + B x y + C y² + D x + E y + F = 0, counter-clockwise on an ellipse, otherwise
    along the branch that contains both ends.

    >>> conic([0, 1, 0, 0, 0, -1], (1, 1), (4, "1/4"))("1/2")
    (mpq(28,13), mpq(13,28))

    Raises `ShapeError` if an end is not exactly on the conic, or if there is no such arc.
    """
    if len(form) != 6:
        raise ShapeError(counted(len(form), "coefficient"), where="form", remedy="give A, B, C, D, E, F")
    return _curve(conic_arc([rational(c) for c in form], _point(start), _point(end)), "conic")


def _point(values: Iterable[Number]) -> tuple[mpq, ...]:
    return exact_row(as_items(values, "the coordinates of a point"), "point")


def _curve(segments: Sequence[Segment], name: str) -> Nurbs:
    return Nurbs.from_homogeneous(*joined_segments(segments), name=name)


def arc_through(start: Iterable[Number], middle: Iterable[Number], end: Iterable[Number]) -> Nurbs:
    """Return the circular arc in the plane from `start` through `middle` to `end`.

    >>> arc_through((1, 0), (0, -1), (0, 1))(1)
    (mpq(0,1), mpq(-1,1))

    Raises `ShapeError` for points on one line.
    """
    (x, y), *others = map(_point, (start, middle, end))
    (a, b), (c, d) = ((u - x, v - y) for u, v in others)
    turn = a * d - b * c
    if not turn:
        raise ShapeError("three points on one line", remedy="give the ends of a line to Nurbs.bezier")
    first, second = a * a + b * b, c * c + d * d
    centre = x + (d * first - b * second) / (2 * turn), y + (a * second - c * first) / (2 * turn)
    return arc(centre, (x, y), others[1]) if turn > 0 else arc(centre, others[1], (x, y)).reverse()


def from_powers(coefficients: Iterable[Iterable[Number]], a: Number = 0, b: Number = 1) -> Nurbs:
    """Return the curve over [a, b] whose coordinates are the polynomials with these coefficients, constant term first
    (as in ``paramPoly3`` of OpenDRIVE).

    >>> from_powers([[1, 2], [0, 0, 1]])("1/2")
    (mpq(2,1), mpq(1,4))
    """
    t = BSpline.identity(a, b)
    rows = [exact_row(row, f"coefficients[{i}]") for i, row in enumerate(as_items(coefficients, "rows"))]
    if not all(rows):
        raise ShapeError("a coordinate without coefficients", where="coefficients", remedy="0 is the constant [0]")
    return Nurbs.from_splines([sum((t**k * c for k, c in enumerate(row) if k), t.constant(row[0])) for row in rows])


def hermite(
    points: Iterable[Iterable[Number]], slopes: Iterable[Iterable[Number]], parameters: Iterable[Number] | None = None
) -> Nurbs:
    """Return the cubic spline of class C¹ through these points, with these derivatives, at the parameters 0, 1, 2, ….

    >>> curve = hermite([(0, 0), (1, 1)], [(1, 0), (0, 3)])
    >>> curve(1), curve.derivative(1, 0), curve.derivative(1, 1)
    ((mpq(1,1), mpq(1,1)), (mpq(1,1), mpq(0,1)), (mpq(0,1), mpq(3,1)))
    """
    p = exact_points(points)
    t = _parameters(range(len(p)) if parameters is None else parameters, p)
    m = _slopes(slopes, p, len(p))
    inner = [row for piece in _hermite_pieces(p, m, t) for row in piece[1:3]]
    return Nurbs(3, [t[0], t[0], *[x for x in t for _ in range(2)], t[-1], t[-1]], [p[0], *inner, p[-1]])


def catmull_rom(points: Iterable[Iterable[Number]], *, closed: bool = False) -> Nurbs:
    """Return the Catmull–Rom spline through points, over the parameters 0, 1, 2, …. The derivative at a point is half
    of the step from the previous point to the next point; at the ends of an open spline, it is the first or the last
    step.

    >>> catmull_rom([(0, 0), (1, 1), (2, 0)]).derivative(1, 1)
    (mpq(1,1), mpq(0,1))
    """
    p = [*exact_points(points)]
    p += p[:1] * as_flag(closed, "whether the spline is closed")
    _parameters(range(len(p)), p)
    before, after = ([p[-2]], [p[1]]) if closed else ([], [])
    row = [*before, *p, *after]
    inner = [tuple((b - a) / 2 for a, b in zip(*ends, strict=True)) for ends in zip(row, row[2:], strict=False)]
    ends = [] if closed else [tuple(b - a for a, b in zip(*step, strict=True)) for step in (p[:2], p[-2:])]
    return hermite(p, inner if closed else [ends[0], *inner, ends[1]])


def closed_spline(
    points: Iterable[Iterable[Number]], degree: int = 3, weights: Iterable[Number] | None = None
) -> Nurbs:
    """Return the closed spline with these control points and uniform knots, which is as smooth at its seam as at the
    other knots.

    >>> curve = closed_spline([(0, 0), (2, 0), (2, 2), (0, 2)])
    >>> curve.closed, str(curve.domain), curve.derivative(1, 0) == curve.derivative(1, 4)
    (True, '[0, 4]', True)
    """
    p, n = exact_points(points), checked_degree(degree)
    w = exact_weights(weights, p)
    around = [i % len(p) for i in range(len(p) + n)]
    return Nurbs(n, range(-n, len(p) + n + 1), [p[i] for i in around], [w[i] for i in around])


def joined(curves: Iterable[Nurbs]) -> Nurbs:
    """Return one curve made of several curves, each of which begins where the previous curve ends. Every segment is
    over an interval of length 1.

    >>> joined([Nurbs.bezier([(0, 0), (1, 0)]), Nurbs.bezier([(1, 0), (2, 1), (3, 0)])]).breakpoints
    (mpq(0,1), mpq(1,1), mpq(2,1))
    """
    segments: list[Segment] = []
    for curve in map(curve_of, as_items(curves, "curves")):
        columns = [f.elevate_degree(curve.degree - f.degree).bezier_points for f in (*curve.p, curve.w)]
        segments += [tuple(zip(*rows, strict=True)) for rows in zip(*columns, strict=True)]
    if not segments:
        raise ShapeError("no curves", remedy="give at least one")
    return _curve(segments, "")


def closed(curve: Nurbs, *, within: Number) -> Nurbs:
    """Return the closed curve made of a curve whose ends nearly meet: the last control point is moved to the first
    control point, by at most `within`. If the weights are positive, no point of the curve moves farther. The `note` of
    the result gives the distance.

    >>> closed(Nurbs.bezier([(0, 0), (1, 1), ("1e-12", 0)]), within="1e-9").note
    'closed: the last control point was moved by at most 1/1000000000000'

    Raises `ShapeError` if the ends are farther apart.
    """
    made, most = curve_of(curve).restrict(*curve.domain), rational(within)
    first, last = made.control_points[0], made.control_points[-1]
    gap = square_root(sum(((b - a) ** 2 for a, b in zip(first, last, strict=True)), mpq(0)))
    if gap > most:
        raise ShapeError(f"ends {gap.decimal(6)} apart", remedy="allow a larger distance, or join them by a segment")
    note = f"closed: the last control point was moved by at most {gap.enclosure(20)[1]}"
    return Nurbs(made.degree, made.knots, [*made.control_points[:-1], first], made.weights, name=curve.name, note=note)


def rotate(curve: Nurbs, degrees: Number, *, within: Number = "1e-9") -> Nurbs:
    """Return a plane curve rotated counter-clockwise about the origin. The angle has a rational sine and cosine, and
    differs from the given angle by at most `within` radians.

    >>> turned = rotate(circle(), 60)
    >>> abs(2 * turned(0)[0] - 1) < mpq(1, 10**8), turned == circle(), rotate(circle(), 90)(0)
    (True, False, (mpq(0,1), mpq(1,1)))

    Raises `ShapeError` for a curve that is not in the plane.
    """
    curve, most = curve_of(curve), rational(within)
    as_dimension(curve.dimension, 2, "curve")
    if most <= 0:
        raise NumberError(f"an angle of {most}", where="within", remedy="give a number of radians above 0")
    cosine, sine = turn_near(rational(degrees), DEGREES, most)
    return curve.transform([[cosine, -sine], [sine, cosine]])


class Ends(Word):
    """The end conditions of an interpolating spline: second derivatives 0, given slopes, or closed."""

    NATURAL = "natural"
    CLAMPED = "clamped"
    PERIODIC = "periodic"


def interpolate(
    points: Iterable[Iterable[Number]],
    parameters: Iterable[Number] | None = None,
    *,
    degree: int = 3,
    closed: bool = False,
    ends: Ends | str = Ends.NATURAL,
    slopes: Iterable[Iterable[Number]] = (),
    within: Number = "1e-6",
) -> Nurbs:
    """Return the cubic spline of class C² through points at given parameters, by default the chord lengths, rounded.
    `ends` is ``natural``, ``clamped`` (with two `slopes`) or ``periodic`` (the same as `closed`). The last point of a
    periodic spline may repeat the first point.

    >>> curve = interpolate([(0, 0), (1, 1), (2, 0)], [0, 1, 2])
    >>> curve(1), curve.derivative(2, 0), curve.p[1].continuity_at(1)
    ((mpq(1,1), mpq(1,1)), (mpq(0,1), mpq(0,1)), 2)
    >>> interpolate([(0, 0), (3, 4), (6, 0)], closed=True).breakpoints
    (mpq(0,1), mpq(5,1), mpq(10,1), mpq(16,1))

    Raises `ShapeError` for too few points or slopes and for a degree other than 3, `KnotError` for parameters that do
    not increase.
    """
    if degree != 3:
        remedy = "exactspline.from_scipy(scipy.interpolate.make_interp_spline(parameters, points, degree)) has others"
        raise ShapeError(f"the degree {shown(degree)}; this spline is cubic", where="degree", remedy=remedy)
    how, p = choice(Ends, ends, "ends", raised=ShapeError), [*exact_points(points)]
    around = as_flag(closed, "whether the spline is closed") or how is Ends.PERIODIC
    p += p[:1] * (around and p[0] != p[-1])
    t = _parameters(_chord_lengths(p, rational(within)) if parameters is None else parameters, p)
    h, n = [b - a for a, b in pairwise(t)], len(p) - 1
    steps = [[3 * (y - x) / w for x, y in zip(*ends, strict=True)] for ends, w in zip(pairwise(p), h, strict=True)]
    matrix, right = fmpq_mat(n + 1, n + 1), fmpq_mat(n + 1, len(p[0]))

    def row(i: int, factors: Iterable[tuple[int, mpq]], values: Sequence[mpq]) -> None:
        for j, factor in factors:
            matrix[i, j] += to_fmpq(factor)
        for j, value in enumerate(values):
            right[i, j] = to_fmpq(value)

    for i in range(0 if around else 1, n):
        # the second derivatives of the two sides agree
        factors = ((i - 1) % n, 1 / h[i - 1]), (i, 2 / h[i - 1] + 2 / h[i]), (i + 1, 1 / h[i])
        row(i, factors, [x / h[i - 1] + y / h[i] for x, y in zip(steps[i - 1], steps[i], strict=True)])
    if around:
        row(n, [(0, mpq(1)), (n, mpq(-1))], [])
    elif how is Ends.CLAMPED:
        for i, slope in zip((0, n), _slopes(slopes, p, 2), strict=True):
            row(i, [(i, mpq(1))], slope)
    else:
        row(0, [(0, mpq(2)), (1, mpq(1))], steps[0])
        row(n, [(n, mpq(2)), (n - 1, mpq(1))], steps[-1])
    found = [[from_flint(x) for x in m] for m in matrix.solve(right).tolist()]
    pieces = _hermite_pieces(p, found, t)
    return Nurbs(3, *with_smooth_knots(3, t, pieces, [1] * n, periodic=around))


def _slopes(given: Iterable[Iterable[Number]], points: Sequence[Point], count: int) -> tuple[Point, ...]:
    """This many slopes, of the dimension of the points."""
    m, dimension = exact_points(given), len(points[0])
    if (len(m), len(m[0])) != (count, dimension):
        found = f"{counted(len(m), 'slope')} of {counted(len(m[0]), 'coordinate')}"
        raise ShapeError(found, where="slopes", remedy=f"give {count} of {counted(dimension, 'coordinate')}")
    return m


def _chord_lengths(points: Sequence[Point], within: mpq) -> list[mpq]:
    """The lengths from the first point to each point along the polygon, with the length of each chord rounded by less
    than the distance.
    """
    if within <= 0:
        raise NumberError(f"a distance of {within}", where="within", remedy="give a number above 0")
    unit = within / len(points)
    squares = [sum(((b - a) ** 2 for a, b in zip(*ends, strict=True)), mpq(0)) / unit**2 for ends in pairwise(points)]
    return [*accumulate((isqrt(int(square)) * unit for square in squares), initial=mpq(0))]


def _parameters(given: Iterable[Number], points: Sequence[Point]) -> tuple[mpq, ...]:
    t = exact_row(as_items(given, "parameters"), "parameters")
    if len(t) != len(points) or len(t) < 2:
        remedy = "give at least two points, and one parameter a point"
        raise ShapeError(f"{counted(len(t), 'parameter')} for {counted(len(points), 'point')}", remedy=remedy)
    if any(b <= a for a, b in pairwise(t)):
        raise KnotError("parameters that do not increase", where="parameters", remedy="two equal points are one")
    return t


def _hermite_pieces(p: Sequence[Point], m: Sequence[Sequence[mpq]], t: Sequence[mpq]) -> list[list[Point]]:
    """The Bézier points of the cubic pieces through points with these slopes."""

    def moved(i: int, step: mpq) -> Point:
        return tuple(x + step * y for x, y in zip(p[i], m[i], strict=True))

    steps = enumerate((b - a) / 3 for a, b in pairwise(t))
    return [[p[i], moved(i, h), moved(i + 1, -h), p[i + 1]] for i, h in steps]
