"""Exact curves made of segments: circular and conic arcs as rational Bézier curves, and segments joined into one
spline.

A segment is the tuple of its homogeneous control points ``(w x, w y, …, w)``.
"""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal
from itertools import pairwise

from flint import arb, ctx

from exactspline.errors import ShapeError
from exactspline.interchange.numbers import root_below, square_root
from exactspline.numbers.exact import mpq, mpz, rational, text, to_fmpq
from exactspline.numbers.intervals import ball_ends
from exactspline.numbers.once import cached_property
from exactspline.splines.bspline import BSpline

# ---- affine maps


Vector = list[mpq]
#: The words of a message for the option with which an arc without rational numbers is read.
APPROXIMATE = "--approximate E takes one within E"


class Affine:
    """An affine map of the plane or of space.

    >>> turn = Affine([[0, -1, 5], [1, 0, 0]])
    >>> turn((1, 0)), (turn @ turn)((1, 0))
    ((mpq(5,1), mpq(1,1)), (mpq(4,1), mpq(5,1)))
    """

    def __init__(self, rows: Sequence[Sequence[mpq | int]]) -> None:
        self.rows = tuple(tuple(mpq(x) for x in row) for row in rows)

    @classmethod
    def identity(cls, dimension: int) -> Affine:
        """The identity map."""
        return cls([[int(i == j) for j in range(dimension + 1)] for i in range(dimension)])

    @cached_property
    def is_identity(self) -> bool:
        """Whether the map is the identity."""
        return self == Affine.identity(len(self.rows))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Affine) and self.rows == other.rows

    def __hash__(self) -> int:
        return hash(self.rows)

    def __call__(self, point: Sequence[mpq], weight: mpq | int = 1) -> tuple[mpq, ...]:
        """The image of a point, or of ``w x`` where the homogeneous coordinates of the point are ``(w x, w)`` (w = 0
        for a vector).
        """
        return tuple(dot(row[:-1], point) + row[-1] * weight for row in self.rows)

    def homogeneous(self, point: Sequence[mpq]) -> tuple[mpq, ...]:
        """The image of a homogeneous point ``(w x, w y, …, w)``."""
        return (*self(point[:-1], point[-1]), point[-1])

    @cached_property
    def stretch(self) -> mpq:
        """An upper bound on the factor by which distances are stretched: the largest sum of a row or of a column."""
        rows = [[abs(x) for x in row[:-1]] for row in self.rows]
        return max(sum(each, start=mpq(0)) for each in [*rows, *zip(*rows, strict=True)])

    def __matmul__(self, inner: Affine) -> Affine:
        """The composition: first `inner`, then this map."""
        columns = [self([row[j] for row in inner.rows], 0) for j in range(len(inner.rows))]
        return Affine([*zip(*columns, self([row[-1] for row in inner.rows]), strict=True)])


def unit(vector: Sequence[mpq], error: mpq | None = None) -> list[mpq]:
    """A vector divided by its length, which must be rational; with `error`, which is at most 1, it is divided by a
    number so near to its length that the error of the result is at most `error`.
    """
    square = dot(vector, vector)
    length = square_root(square)
    if length is None and error is not None:
        length = root_below(square, error * max(map(abs, vector)) / 2)
    if not length:
        raise ShapeError("an axis of irrational length", remedy=f"rational lengths are exact; {APPROXIMATE}")
    return [x / length for x in vector]


def axes(
    along: Sequence[mpq], normal: Sequence[mpq], error: mpq | None = None
) -> tuple[tuple[Vector, Vector, Vector], bool]:
    """Three perpendicular unit vectors, and whether they are approximations. One is on the side of `along`, one is that
    vector rotated by a right angle, and one has the direction of `normal`. If they are irrational and `error` is given,
    they are three rational vectors, each with at most this error.

    >>> (x, y, z), near = axes([mpq(1), mpq(1), mpq(0)], [mpq(1), mpq(-1), mpq(1)], mpq(1, 10**9))
    >>> dot(x, x) == dot(y, y) == 1, dot(x, y) == 0 == dot(y, z), abs(x[0] * x[0] - mpq(1, 2)) < mpq(1, 10**8)
    (True, True, True)
    """
    slack = None if error is None else min(error, mpq(1)) / 64
    while True:
        z = unit(normal, slack)
        onto = dot(along, z) / dot(z, z)
        x = unit([a - onto * b for a, b in zip(along, z, strict=True)], slack)
        found = (x, list(cross(z, x)), z)
        if slack is None or error is None or dot(x, x) == dot(z, z) == 1:
            return found, False
        # the errors of the lengths of x and z are at most the slack; their directions are exact
        turned = _rotation(*found, slack)
        off = max(sum(abs(a - b) for a, b in zip(*both, strict=True)) for both in zip(turned, found, strict=True))
        if off + 3 * slack <= error:
            return turned, True
        slack /= 16


def _dyadic(value: mpq, error: mpq) -> mpq:
    """A multiple of a power of two that is at most `error` below a number.

    >>> _dyadic(mpq(1, 3), mpq(1, 10))
    mpq(5,16)
    """
    scale = mpz(1) << int(1 / error).bit_length()
    return mpq(value * scale // 1, scale)


def _rotation(x: Vector, y: Vector, z: Vector, error: mpq) -> tuple[Vector, Vector, Vector]:
    """The columns of a rational rotation near a matrix with nearly perpendicular columns of lengths near 1."""
    # one of the matrix and its three products with half turns has a trace that is not near −1
    for signs in ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)):
        u, v, w = ([sign * a for a in column] for sign, column in zip(signs, (x, y, z), strict=True))
        size = 1 + u[0] + v[1] + w[2]
        if size > mpq(1, 2):
            break
    a, b, c = (_dyadic(q / size, error) for q in (v[2] - w[1], w[0] - u[2], u[1] - v[0]))
    n = 1 + a * a + b * b + c * c
    rows = [
        [n - 2 * (b * b + c * c), 2 * (a * b + c), 2 * (a * c - b)],
        [2 * (a * b - c), n - 2 * (a * a + c * c), 2 * (b * c + a)],
        [2 * (a * c + b), 2 * (b * c - a), n - 2 * (a * a + b * b)],
    ]
    first, second, third = ([sign * q / n for q in row] for sign, row in zip(signs, rows, strict=True))
    return first, second, third


def minus(u: Sequence[mpq], v: Sequence[mpq]) -> Vector:
    """The difference; raises `ShapeError` for vectors of different dimensions."""
    _see_that_they_agree(u, v)
    return [a - b for a, b in zip(u, v, strict=True)]


def _see_that_they_agree(u: Sequence[mpq], v: Sequence[mpq]) -> None:
    if len(u) != len(v):
        raise ShapeError(f"points with {len(u)} and {len(v)} coordinates", remedy="write as many for each")


def dot(u: Sequence[mpq], v: Sequence[mpq]) -> mpq:
    """The scalar product; raises `ShapeError` as `minus` does."""
    _see_that_they_agree(u, v)
    return sum((a * b for a, b in zip(u, v, strict=True)), start=mpq(0))


def cross(u: Sequence[mpq], v: Sequence[mpq]) -> tuple[mpq, mpq, mpq]:
    """The vector product; raises `ShapeError` for vectors that are not in space."""
    if len(u) != 3 or len(v) != 3:
        raise ShapeError("a vector that is not in space", remedy="write three coordinates")
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


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
    """The image of the unit circle in the plane or in space; it begins at the first column of the frame."""
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


# ---- arcs between ends that a file gives
# Only multiples of a right angle have a sine and a cosine that are exactly known. If an error is allowed, any other end
# is moved along the curve, which remains exact, to a rational point of the curve.


ZERO = mpq(0)
#: A right angle in degrees and in radians, these to 80 digits: more than any decimal in a file has.
DEGREES = mpq(90)
RADIANS = rational("1.57079632679489661923132169163975144209858469968755291048747229615390820314310449")
#: The directions of the first four multiples of a right angle.
RIGHT = [(mpq(1), mpq(0)), (mpq(0), mpq(1)), (mpq(-1), mpq(0)), (mpq(0), mpq(-1))]


def quarter_turns(angle: mpq, right: mpq, digit: mpq = ZERO) -> int | None:
    """The number of right angles in an angle whose last digit has the unit `digit`; None if this is not an integer: the
    angle must be a multiple of a right angle rounded, up or down, to that digit, or to a double.

    >>> quarter_turns(mpq("6.2831853"), RADIANS, mpq("1e-7")), quarter_turns(mpq("-90.00000000000001"), DEGREES)
    (4, -1)
    >>> quarter_turns(mpq("89.9999999"), DEGREES, mpq("1e-7"))
    """
    turns = int((angle / right + mpq(1, 2)) // 1)
    exact = turns * right
    written = {exact // digit * digit, -(-exact // digit) * digit} if 0 < digit <= mpq(1, 10_000) else set()
    near = abs(angle - exact) <= max(abs(exact), right) / 2**50
    return turns if near or angle in written else None


def turn_near(angle: mpq, right: mpq, error: mpq) -> Point:
    """The cosine and sine, both rational, of an angle that differs from the given angle by at most this many radians.

    >>> cosine, sine = turn_near(mpq(120), DEGREES, mpq(1, 1000))
    >>> cosine**2 + sine**2 == 1, abs(cosine + mpq(1, 2)) < mpq(1, 1000)
    (True, True)
    """
    bits = 64
    while True:
        with ctx.workprec(bits):
            turned = arb(to_fmpq(angle)) if right == RADIANS else arb.pi() * arb(to_fmpq(angle / (2 * right)))
            x, y = ball_ends(turned.cos()), ball_ends(turned.sin())
        if x.width + y.width < min(error, mpq(1)) / 8:
            return on_circle(x.low, y.low, error / 2)
        bits *= 2


def on_circle(x: mpq, y: mpq, error: mpq) -> Point:
    """The rational point of the unit circle in the direction of (x, y); if there is none, a rational point whose
    direction differs by at most this many radians.

    >>> on_circle(mpq(3), mpq(-4), mpq(1)), on_circle(mpq(1), mpq(1), mpq(1, 100))
    ((mpq(3,5), mpq(-4,5)), (mpq(13575,19193), mpq(13568,19193)))
    """
    if not x or abs(y) > x:
        cosine, sine = on_circle(y, -x, error)
        return -sine, cosine
    square = x * x + y * y
    length = square_root(square)
    if length is not None:
        return x / length, y / length
    # the tangent of half the angle has at most a quarter of the error, twice: from the root, and from rounding
    t = _dyadic(y / (x + root_below(square, min(error, mpq(1)) * x / 4)), error / 4)
    return (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)


class Round:
    """The image of the unit circle under a map that keeps its two axes perpendicular, its arcs, and notes on them.

    >>> circle = Round(Affine([[2, 0, 0], [0, 2, 0]]), mpq(1, 100))
    >>> [arc] = circle.arc(circle.at_angle(mpq(30), DEGREES), circle.at_angle(mpq(90), DEGREES))
    >>> arc[-1], *circle.notes
    ((mpq(0,1), mpq(2,1), mpq(1,1)), 'its ends are moved along the curve by at most 1/100')
    """

    def __init__(self, frame: Affine, within: mpq | None, near: bool = False) -> None:
        if not all(map(any, list(zip(*frame.rows, strict=True))[:-1])):
            raise ShapeError("a circle or an ellipse of radius 0", remedy="its radius must be positive")
        self.frame, self.within = frame, within
        #: The note on irrational axes, for which the map is an approximation.
        self.notes = [f"its axes are irrational: it is read within {text(within)} of it"] if within and near else []
        #: The angle by which an end may have been rotated.
        self.turned = ZERO
        #: The angle by which an end may be rotated.
        self.error = None if within is None else within / (2 * frame.stretch)

    def at_angle(self, angle: mpq, right: mpq, digit: mpq = ZERO) -> Point:
        """The point of the unit circle at an angle (see `quarter_turns`)."""
        turns = quarter_turns(angle, right, digit)
        if turns is not None:
            if angle != turns * right:
                self.notes.append("an angle is read as the multiple of 90° of which it is a rounding")
            return RIGHT[turns % 4]
        if self.error is None:
            raise ShapeError("an angle that is not a multiple of 90°", remedy=f"its ends are irrational; {APPROXIMATE}")
        self.turned = max(self.turned, self.error)
        self.notes.append(f"its ends are moved along the curve by at most {text(self.within or mpq(0))}")
        return turn_near(angle, right, self.error)

    def at_point(self, point: Sequence[mpq], reach: mpq | None = None) -> Point:
        """The point of the unit circle whose image is a point, or is near this point: by default, within the error."""
        *columns, centre = zip(*self.frame.rows, strict=True)
        away = minus(point, centre)
        x, y = (dot(away, column) / dot(column, column) for column in columns)
        if x * x + y * y == 1 and self.frame((x, y)) == tuple(point):
            return x, y
        if self.error is None:
            raise ShapeError("an end that is not exactly on the curve", remedy=f"correct it; {APPROXIMATE}")
        found = on_circle(x, y, self.error / 2**16) if x or y else RIGHT[0]
        self.notes.append(moved(self.frame(found), point, reach or self.within))
        self.turned = max(self.turned, (reach or self.within or ZERO) / (2 * self.frame.stretch))
        return found

    def arc(self, start: Point, end: Point) -> list[Segment]:
        """The arc counter-clockwise between two points of the unit circle; the whole curve if they are the same
        point.
        """
        gap = minus(start, end)
        if dot(gap, gap) < 16 * self.turned**2:
            raise ShapeError("the ends are nearer to each other than E", remedy="give a smaller --approximate E")
        return mapped(arc_around_origin(start, end), self.frame)


def through_ends(
    form: Sequence[mpq], start: Point, end: Point, within: mpq | None, notes: list[str]
) -> tuple[Sequence[mpq], Point]:
    """The ellipse about the same centre, given by its equation (see `conic_arc`), that passes through the start of an
    arc, and the end of the arc moved onto it, both by at most half of an error. A conic other than an ellipse is
    unchanged, and without an error every conic is.

    >>> form, notes = [mpq(1), mpq(0), mpq(1), mpq(0), mpq(0), mpq(-24, 25)], []
    >>> form, end = through_ends(form, (mpq(1), mpq(0)), (mpq(0), mpq(99, 100)), mpq(1, 5), notes)
    >>> form[-1], end[0] ** 2 + end[1] ** 2 == 1, notes[1:]
    (mpq(-1,1), True, ['an end is moved by 0.0141 onto the curve'])

    Raises `ShapeError` if the ends are further away.
    """
    (a, b, c, d, e, f), w = form, [q - p for p, q in zip(start, end, strict=True)]
    determinant = 4 * a * c - b * b
    if within is None or determinant <= 0:
        return form, end

    def value(x: mpq, y: mpq) -> mpq:
        return (a * x + b * y + d) * x + (c * y + e) * y

    centre = (b * e - 2 * c * d) / determinant, (b * d - 2 * a * e) / determinant
    level, size = -value(*start), -value(*centre) - f
    # its points move away from the centre in proportion; the squared half axis is at most 4 (a + c) size / determinant
    if not size or not 0 <= 16 * (f - level) ** 2 * (a + c) / (size * determinant) <= within**2:
        raise ShapeError("a start of an arc that is not near its ellipse", remedy=f"correct it; {APPROXIMATE}")
    notes += [f"the ellipse is moved by at most {text(within / 2)} onto its start"] if f != level else []
    if any(w):
        # the other point of the line through both ends
        (x, y), square = start, value(*w) - d * w[0] - e * w[1]
        t = 1 - (value(x + w[0], y + w[1]) - value(x, y)) / square
        found = (x + t * w[0], y + t * w[1])
        notes += [moved(found, end, within / 2)] if found != tuple(end) else []
        end = found
    return [a, b, c, d, e, level], end


def moved(to: Sequence[mpq], point: Sequence[mpq], within: mpq | None, onto: str = "the curve") -> str:
    """A note on an end that is moved onto a curve; raises `ShapeError` if it is moved further than allowed."""
    gap = minus(to, point)
    if within is None or dot(gap, gap) > within**2:
        raise ShapeError(f"an end {distance_text(gap)} away from {onto}", remedy=f"correct it; {APPROXIMATE}")
    return f"an end is moved by {distance_text(gap)} onto {onto}"


def _about(value: mpq) -> str:
    """A nonnegative number, as text of three digits.

    >>> _about(mpq(2, 3) / 10**9), _about(mpq(109)), _about(mpq(1234567))
    ('6.67E-10', '109', '1.23E+6')
    """
    return f"{Decimal(int(value.numerator)) / Decimal(int(value.denominator)):.3g}".replace("e", "E")


def distance_text(gap: Sequence[mpq]) -> str:
    """The length of a vector, to three digits."""
    square = dot(gap, gap)
    return _about(root_below(square, square / (1 + square) / 10_000)) if square else "0"
