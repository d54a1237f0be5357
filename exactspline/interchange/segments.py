"""Exact curves made of segments: circular and conic arcs as rational Bézier curves, and segments joined into one
spline.

A segment is the tuple of its homogeneous control points ``(w x, w y, …, w)``.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from exactspline.errors import ShapeError
from exactspline.interchange.affine import Affine, cross
from exactspline.numbers.exact import mpq
from exactspline.splines.bspline import BSpline

Point = tuple[mpq, ...]
Segment = tuple[Point, ...]


def polynomial(*points: Sequence[mpq]) -> Segment:
    """The Bézier segment with these Cartesian control points."""
    return tuple((*map(mpq, point), mpq(1)) for point in points)


def arc_around_origin(u: Point, v: Point) -> list[Segment]:
    """The arc around the origin, counter-clockwise from u to v (the full circle when they coincide), as rational
    quadratics with rational weights.

    With c² = (1 + cos θ)/2 the weights (1, c², c²) describe the same arc as the usual (1, c, 1), which are seldom
    rational; every second segment is reversed, so that a circle gets the weights 1 1 2 1 1 1 2 1 1 rather than powers
    of two.

    >>> one, zero = mpq(1), mpq(0)
    >>> [segment] = arc_around_origin((one, zero), (zero, one))
    >>> [point[-1] for point in segment]
    [mpq(2,1), mpq(1,1), mpq(1,1)]

    Raises `ShapeError` if u and v are not at the same distance from the origin.
    """
    radius2 = u[0] ** 2 + u[1] ** 2
    if radius2 != v[0] ** 2 + v[1] ** 2 or not radius2:
        remedy = (
            "their distances from it must be equal; exactspline.constructors.arc_through(start, middle, end) finds it"
        )
        raise ShapeError("the end points are not exactly on one circle about the centre", remedy=remedy)
    corners = [u]
    for _ in range(4):
        last = corners[-1]
        turned = (-last[1], last[0])
        cosine, sine = last[0] * v[0] + last[1] * v[1], turned[0] * v[0] + turned[1] * v[1]
        if cosine >= 0 and sine > 0:
            break
        corners.append(turned)
    if corners[-1] != v:
        corners.append(v)
    return [_small_arc(a, b, radius2, backwards=i % 2 == 0) for i, (a, b) in enumerate(pairwise(corners))]


def _small_arc(u: Point, v: Point, radius2: mpq, *, backwards: bool) -> Segment:
    """An arc of less than half a turn: its end tangents meet at (u + v)/(1 + cos θ), and the weight there is (1 + cos
    θ)/2.
    """
    c2 = (1 + (u[0] * v[0] + u[1] * v[1]) / radius2) / 2
    middle = ((u[0] + v[0]) / 2, (u[1] + v[1]) / 2)
    first, last = (1 / c2, mpq(1)) if backwards else (mpq(1), 1 / c2)
    return ((u[0] * first, u[1] * first, first), (middle[0] / c2, middle[1] / c2, mpq(1)), (*_times(v, last), last))


def ellipse(frame: Affine) -> list[Segment]:
    """The image of the unit circle: in the plane or in space, from the first column of the frame on."""
    start = (mpq(1), mpq(0))
    return mapped(arc_around_origin(start, start), frame)


def bezier_knots(degree: int) -> list[mpq]:
    """The knots of one segment."""
    return [mpq(0)] * (degree + 1) + [mpq(1)] * (degree + 1)


def _times(point: Sequence[mpq], factor: mpq) -> Point:
    return tuple(x * factor for x in point)


def mapped(segments: Sequence[Segment], affine: Affine) -> list[Segment]:
    """The images of segments."""
    if affine.is_identity:
        return list(segments)
    return [tuple(affine.homogeneous(point) for point in segment) for segment in segments]


def conic_arc(form: Sequence[mpq], start: Point, end: Point) -> list[Segment]:
    """The arc of the conic A x² + B x y + C y² + D x + E y + F = 0 from `start` to `end` in the plane:
    counter-clockwise on an ellipse, on a parabola or hyperbola the arc that stays on one branch.

    >>> one, zero = mpq(1), mpq(0)
    >>> [segment] = conic_arc([one, zero, zero, zero, -one, zero], (zero, zero), (one, one))
    >>> segment[1]
    (mpq(1,2), mpq(0,1), mpq(1,1))

    Raises `ShapeError` if an end is not exactly on the conic, or if there is no such arc.
    """
    a, b, c, d, e, f = form
    matrix = ((2 * a, b, d), (b, 2 * c, e), (d, e, 2 * f))
    if not sum((x * y for x, y in zip(matrix[0], cross(*matrix[1:]), strict=True)), start=mpq(0)):
        raise ShapeError("the conic is a pair of lines, a point or empty", remedy="its determinant must not vanish")
    if any(_paired(matrix, (*point, mpq(1)), (*point, mpq(1))) for point in (start, end)):
        raise ShapeError("an end point is not exactly on the conic", remedy="the equation must hold exactly there")
    ellipse = b * b < 4 * a * c
    if start == end and not ellipse:
        raise ShapeError("the ends coincide on a conic that is not closed", remedy="give two points")
    return _conic(matrix, start, end, ellipse, 8)


def _paired(matrix: Sequence[Point], p: Sequence[mpq], q: Sequence[mpq]) -> mpq:
    return sum((p[i] * matrix[i][j] * q[j] for i in range(3) for j in range(3)), start=mpq(0))


def _conic(matrix: Sequence[Point], start: Point, end: Point, ellipse: bool, pieces: int) -> list[Segment]:
    p, q = (*start, mpq(1)), (*end, mpq(1))
    pole = cross(_applied(matrix, p), _applied(matrix, q))
    pole_value = _paired(matrix, pole, pole)
    if start == end or pole[2] == 0 or pole_value == 0:
        return _split(matrix, start, end, ellipse, pieces)
    middle = (pole[0] / pole[2], pole[1] / pole[2], mpq(1))
    # with these weights the quadratic form vanishes along the whole segment
    weight = -_paired(matrix, p, q) / (2 * _paired(matrix, middle, middle))
    turn = (middle[0] - p[0]) * (q[1] - p[1]) - (middle[1] - p[1]) * (q[0] - p[0])
    if ellipse and turn < 0:
        return _split(matrix, start, end, ellipse, pieces)
    if weight <= 0:
        raise ShapeError("the ends are on different branches", remedy="an arc stays on one branch")
    return [(p, _times(middle, weight), _times(q, weight))]


def _split(matrix: Sequence[Point], start: Point, end: Point, ellipse: bool, pieces: int) -> list[Segment]:
    """A large arc of an ellipse, divided at a rational point: the second intersection with a line through the start."""
    if not ellipse or not pieces:
        raise ShapeError("the conic has no such arc", remedy="it must be an ellipse, a parabola or a hyperbola")
    p = (*start, mpq(1))
    tangent = _applied(matrix, p)
    # the line halfway between the counter-clockwise tangent and the direction to the centre cuts off less than half a
    # turn
    along = (-tangent[1], tangent[0])
    (a, b, d), (_, c, e), _ = matrix
    determinant = a * c - b * b
    centre = ((b * e - c * d) / determinant, (b * d - a * e) / determinant)
    to_centre = (centre[0] - start[0], centre[1] - start[1])
    if along[0] * to_centre[1] - along[1] * to_centre[0] < 0:
        along = (-along[0], -along[1])
    scale = (abs(to_centre[0]) + abs(to_centre[1])) / (abs(along[0]) + abs(along[1]))
    direction = (to_centre[0] + along[0] * scale, to_centre[1] + along[1] * scale, mpq(0))
    step = -2 * _paired(matrix, p, direction) / _paired(matrix, direction, direction)
    cut = (start[0] + step * direction[0], start[1] + step * direction[1])
    return _conic(matrix, start, cut, ellipse, 0) + _conic(matrix, cut, end, ellipse, pieces - 1)


def _applied(matrix: Sequence[Point], x: Sequence[mpq]) -> Point:
    return tuple(sum((a * b for a, b in zip(row, x, strict=True)), start=mpq(0)) for row in matrix)


def _elevated(segment: Segment, degree: int) -> Segment:
    """The segment elevated to a higher degree."""
    by = degree + 1 - len(segment)
    if not by:
        return segment
    columns = [BSpline.bezier(x).elevate_degree(by).control_points for x in zip(*segment, strict=True)]
    return tuple(zip(*columns, strict=True))


def joined_segments(segments: Sequence[Segment]) -> tuple[int, list[mpq], list[Point]]:
    """The segments, each beginning where the previous one ends, as one spline: degree, knots (0, 1, 2, … with
    multiplicity degree) and homogeneous control points.

    >>> line = polynomial((0, 0), (2, 0))
    >>> degree, knots, points = joined_segments([line, polynomial((2, 0), (3, 1), (2, 2))])
    >>> degree, [int(t) for t in knots], len(points)
    (2, [0, 0, 0, 1, 1, 2, 2, 2], 5)
    """
    degree = max(len(segment) - 1 for segment in segments)
    knots = [mpq(0)] * (degree + 1)
    points: list[Point] = []
    for i, segment in enumerate(segments, 1):
        lifted = _elevated(segment, degree)
        factor = points[-1][-1] / lifted[0][-1] if points else mpq(1)
        scaled = [_times(point, factor) for point in lifted]
        if points and points[-1] != scaled[0]:
            raise ShapeError("a segment does not begin where the previous one ends", remedy="segments must join")
        points += scaled[1:] if points else scaled
        knots += [mpq(i)] * degree
    return degree, [*knots, mpq(len(segments))], points


def bulged(start: Point, end: Point, bulge: mpq) -> list[Segment]:
    """The segment of a polyline with a bulge, which is the tangent of a quarter of its angle, positive for a left turn:
    a line, or an arc with a rational centre.

    >>> [[int(x) for x in point] for segment in bulged((mpq(0), mpq(0)), (mpq(2), mpq(0)), mpq(1)) for point in segment]
    [[0, 0, 2], [0, -1, 1], [1, -1, 1], [1, -1, 1], [2, -1, 1], [4, 0, 2]]
    """
    if not bulge:
        return [polynomial(start, end)]
    if bulge < 0:
        return [segment[::-1] for segment in reversed(bulged(end, start, -bulge))]
    factor = (1 - bulge * bulge) / (4 * bulge)
    x = (start[0] + end[0]) / 2 - (end[1] - start[1]) * factor
    y = (start[1] + end[1]) / 2 + (end[0] - start[0]) * factor
    arcs = arc_around_origin(*((point[0] - x, point[1] - y) for point in (start, end)))
    return mapped(arcs, Affine([[1, 0, x], [0, 1, y]]))
