"""Shapes on which points may lie: guesses from which a proof begins. Only how small the proved distance is depends on
the guess.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from operator import mul

import flint
from flint import arb, arb_mat

from exactspline.geometry.recognition.shapes import (
    NOTHING,
    Circle,
    Conic,
    CurveShape,
    Line,
    Plane,
    Point,
    Shape,
    cross_product,
    minus,
    solved,
    upper_square_root,
)
from exactspline.numbers.exact import decimal_unit, from_flint, mpq, over_one_denominator, scalar, to_fmpq
from exactspline.reals.algebraic import PRECISION

#: The largest number of points from which a shape is guessed.
MOST_POINTS = 24
#: A shape through a few of the points may be this many times farther from the other points than the limit.
WORSE = 1024
#: Coordinates are rounded to this fraction of the size of the points for sums of squares, parameters of the shape to
#: `FINE` times the distance between the guess and the points.
ROUND = mpq(1, 2**64)
FINE = mpq(1, 32)
#: Steps towards the direction of a parabola.
STEPS = 3
#: The largest absolute value of the relative discriminant of a conic for which a parabola is tried.
NEARLY = mpq(1, 16)
#: The bits behind the binary point; more than is needed for conics through points that nearly lie on several conics.
FIXED = 384


def candidates(points: Sequence[Point], limit: mpq) -> Iterator[CurveShape]:
    """A line, a circle and a conic within about a limit of the points: through some of the points if all points are on
    it, otherwise by least squares.

    >>> line, *_ = candidates([(mpq(0), mpq(0)), (mpq(1), mpq(2)), (mpq(2), mpq(4))], mpq(1))
    >>> print(line)
    line: point (0, 0), direction (1, 2)
    """
    if off_every_conic(points, limit):
        return
    squared = limit * limit
    if (line := _line(points)) is not None and all_near(line, points, squared):
        yield line
    for plane in planes(points, limit) if len(points[0]) == 3 else (None,):
        for through, count, fitted in ((_circle_through, 3, _fitted_circles), (_conic_through, 5, _fitted_conics)):
            first = through(_spread(points[:-1], count), plane)
            if first is None or not all_near(first, points, squared * WORSE * WORSE):
                continue
            if all_near(first, points, NOTHING):
                yield first
            else:
                yield from fitted(points, plane, squared)


def planes(points: Sequence[Point], limit: mpq) -> Iterator[Plane]:
    """The plane through three of some points in space if all are on it, otherwise the plane of least squares, if it is
    within about a limit of the points.
    """
    three = _spread(points[:-1], 3)
    if len(three) < 3 or not any(normal := cross_product(minus(three[1], three[0]), minus(three[2], three[0]))):
        return
    through = Plane(three[0], normal)
    plane = through if all_near(through, points, NOTHING) else _fitted_plane(_spread(points, MOST_POINTS))
    if plane is not None and all_near(plane, points, limit * limit):
        yield plane


def farthest(shape: Shape, points: Sequence[Point]) -> mpq:
    """Approximately the square of the largest distance of the points."""
    return max(map(shape.estimate, points))


def all_near(shape: Shape, points: Sequence[Point], squared: mpq) -> bool:
    """Whether the approximate squared distances of all points are at most this. The last points are tried first,
    because a shape passes through the first ones.
    """
    return all(shape.estimate(point) <= squared for point in reversed(points))


def _spread(points: Sequence[Point], count: int) -> list[Point]:
    """At most this many of the points, evenly selected, after neighbours that are equal have been merged."""
    different = [points[0], *[b for a, b in pairwise(points) if a != b]]
    n = len(different)
    return different if n <= count else [different[i * (n - 1) // (count - 1)] for i in range(count)]


def box(points: Sequence[Point]) -> tuple[Point, mpq]:
    """The middle of the box around points, and its longest side as a power of 2 (1 for a single point)."""
    columns = list(zip(*points, strict=True))
    middle = tuple((min(column) + max(column)) / 2 for column in columns)
    side = max(max(column) - min(column) for column in columns)
    if not side:
        return middle, mpq(1)
    return middle, mpq(2) ** (side.numerator.bit_length() - side.denominator.bit_length())


def rounded(x: mpq, unit: mpq) -> mpq:
    """The nearest multiple of a number."""
    return (x / unit + mpq(1, 2)) // 1 * unit


def _line(points: Sequence[Point]) -> Line | None:
    """The line through the first point and the point farthest from it."""
    direction = max([minus(point, points[0]) for point in points], key=lambda offset: scalar(offset, offset))
    return Line(points[0], direction) if any(direction) else None


def least(rows: Sequence[Sequence[mpq]]) -> list[mpq]:
    """Approximately the vector with the largest component 1 whose scalar products with the rows have the least sum of
    squares, by inverse iteration in numbers of a fixed number of bits; an empty list if this fails. Rows and vector
    have twice the digits of `ROUND`.
    """
    fine = int(1 / ROUND) ** 2
    columns = [*zip(*[[int(x * fine) for x in row] for row in rows], strict=True)]
    if not (n := len(columns)):
        return []
    scatter = [[sum(map(mul, x, y)) << FIXED for y in columns[: i + 1]] for i, x in enumerate(columns)]
    for row in scatter:
        row[-1] += fine << FIXED
    # the matrix is L D Lᵀ
    lower, diagonal = [[0] * n for _ in range(n)], list[int]()
    for j in range(n):
        weighted = [x * d >> FIXED for x, d in zip(lower[j], diagonal, strict=False)]
        pivot = scatter[j][j] - (sum(map(mul, lower[j], weighted)) >> FIXED)
        if pivot <= 0:
            return []
        diagonal.append(pivot)
        for i in range(j + 1, n):
            lower[i][j] = ((scatter[i][j] << FIXED) - sum(map(mul, lower[i], weighted))) // pivot
    upper = [*zip(*lower, strict=True)]
    # a generic start
    numbers = [420 // (k + 2) for k in range(n)]
    for _ in range(3):
        for i in range(n):
            numbers[i] = (numbers[i] << FIXED) - (sum(map(mul, lower[i], numbers[:i])) >> FIXED)
        numbers = [(x << 2 * FIXED) // d for x, d in zip(numbers, diagonal, strict=True)]
        for i in range(n - 2, -1, -1):
            numbers[i] -= sum(map(mul, upper[i][i + 1 :], numbers[i + 1 :])) >> FIXED
        largest = max(numbers, key=abs)
        if not largest:
            return []
        numbers = [(2 * fine * x + largest) // (2 * largest) for x in numbers]
    return [mpq(x, fine) for x in numbers]


def _fitted_plane(points: Sequence[Point]) -> Plane | None:
    """The plane of least squares, with its numbers rounded as far as its distance from the points allows."""
    middle, size = box(points)
    found = least([(*[rounded((x - m) / size, ROUND) for x, m in zip(p, middle, strict=True)], mpq(1)) for p in points])
    if not any(found[:-1]):
        return None
    *normal, offset = found
    foot = -offset * size / scalar(normal, normal)
    plane = Plane(tuple(m + foot * n for m, n in zip(middle, normal, strict=True)), tuple(normal))
    left = farthest(plane, points)
    if not left:
        return plane
    unit = decimal_unit(upper_square_root(left) * FINE)
    largest, slope = max(normal, key=abs), decimal_unit(unit / size)
    normal = [rounded(n / largest, slope) for n in normal]
    return Plane(tuple(rounded(x, unit) for x in plane.point), tuple(normal))


def _frame(plane: Plane | None, dimension: int = 2) -> tuple[Point, ...]:
    """Two orthogonal vectors in a plane of space; without a plane, the vectors of the axes."""
    if plane is None:
        return tuple(tuple(mpq(i == k) for i in range(dimension)) for k in range(dimension))
    n = plane.normal
    smallest = min(range(3), key=lambda i: abs(n[i]))
    first = cross_product(n, tuple(mpq(i == smallest) for i in range(3)))
    return tuple(tuple(x / max(map(abs, e)) for x in e) for e in (first, cross_product(n, first)))


# ---- circles


def _circle_through(points: Sequence[Point], plane: Plane | None) -> Circle | None:
    """The circle through three points; for points in space without a plane, the sphere through four points."""
    if len(points) + (plane is not None) <= len(points[0]):
        return None
    a, *others = points
    sides = [minus(x, a) for x in others]
    right = [scalar(x, x) / 2 for x in sides]
    step: Sequence[mpq] | None
    if plane is not None:
        step = solved([*sides, plane.normal], [*right, scalar(plane.normal, minus(plane.point, a))])
    elif len(a) == 3:
        step = solved(sides, right)
    else:
        (x, y), (u, v) = sides
        area = x * v - y * u
        step = ((right[0] * v - right[1] * y) / area, (right[1] * x - right[0] * u) / area) if area else None
    if step is None:
        return None
    return Circle(tuple(x + y for x, y in zip(a, step, strict=True)), scalar(step, step), plane.normal if plane else ())


def fitted_circle(points: Sequence[Point], plane: Plane | None) -> Circle | None:
    """The circle (in space without a plane: the sphere) with the least sum of ``(‖x − c‖² − r²)²`` (I. Kåsa 1976), with
    numbers as short as its distance from the points allows.
    """
    (_, size), start = box(points), plane.point if plane else points[0]
    frame = _frame(plane, len(start))
    rows, right = [], []
    for point in points:
        offset = [rounded(x / size, ROUND) for x in minus(point, start)]
        rows.append([*[-2 * scalar(offset, e) for e in frame], mpq(1)])
        right.append(-scalar(offset, offset))
    columns = list(zip(*rows, strict=True))
    found = solved([[scalar(x, y) for y in columns] for x in columns], [scalar(x, right) for x in columns])
    if found is None:
        return None
    shift = [sum((k * e[i] for k, e in zip(found, frame, strict=False)), start=mpq(0)) for i in range(len(start))]
    centre = tuple(x + size * y for x, y in zip(start, shift, strict=True))
    radius_squared = size * size * (scalar(shift, shift) - found[-1])
    if radius_squared <= 0:
        return None
    return _shortened(Circle(centre, radius_squared, plane.normal if plane else ()), points)


def sphere(points: Sequence[Point], limit: mpq) -> Circle | None:
    """A sphere, represented as a circle in space without a plane: the sphere through four points if all points are on
    it, otherwise the sphere of least squares, if it is within about a limit of the points.
    """
    found = _circle_through(_spread(points[:-1], 4), None)
    if found is not None and not all_near(found, points, NOTHING):
        found = fitted_circle(_spread(points, MOST_POINTS), None)
    return found if found is not None and all_near(found, points, limit * limit) else None


def _fitted_circles(points: Sequence[Point], plane: Plane | None, squared: mpq) -> Iterator[CurveShape]:
    found = fitted_circle(_spread(points, MOST_POINTS), plane)
    if found is not None and all_near(found, points, squared):
        yield found


def _shortened(circle: Circle, points: Sequence[Point]) -> Circle | None:
    """The circle with shorter numbers, its radius in the middle between the least and the largest distance."""
    left = farthest(circle, points)
    if not left:
        return circle
    unit = decimal_unit(upper_square_root(left) * FINE)
    centre = tuple(rounded(x, unit) for x in circle.centre)
    distances = [scalar(minus(point, centre), minus(point, centre)) for point in points]
    radius = rounded((upper_square_root(min(distances)) + upper_square_root(max(distances))) / 2, unit)
    return Circle(centre, radius * radius, circle.normal) if radius > 0 else None


# ---- conics


def off_every_conic(points: Sequence[Point], limit: mpq) -> bool:
    """Whether it is certain, by balls around the coordinates, that no conic and no line of the plane is within a limit
    of all points: the rows of monomials of six points of a conic are linearly dependent. False decides nothing.

    >>> points = [(mpq(x), mpq(x**3)) for x in range(6)]
    >>> off_every_conic(points, mpq(1, 10**6)), off_every_conic(points, mpq(1))
    (True, False)
    """
    some = _spread(points, 6)
    if len(some) < 6 or len(some[0]) > 2:
        return False
    numbers, unit = over_one_denominator([x for point in some for x in point])
    places = [(x - numbers[0], y - numbers[1]) for x, y in zip(numbers[::2], numbers[1::2], strict=True)]
    exponent = -max(max(abs(x), abs(y)) for x, y in places).bit_length()
    with flint.ctx.workprec(PRECISION):
        reach = arb(0, arb(to_fmpq(limit * unit)) * arb((1, exponent)))
        around = [(arb((x, exponent)) + reach, arb((y, exponent)) + reach) for x, y in places]
        rows = arb_mat([[x * x, x * y, y * y, x, y, 1] for x, y in around])
        try:
            # with an approximate inverse the balls stay small
            return not (rows.mid().inv() * rows).det().contains(0)
        except ZeroDivisionError:
            return False


def _monomials(point: Point) -> list[mpq]:
    x, y = point
    return [x * x, x * y, y * y, x, y, mpq(1)]


def _conic(k: Sequence[mpq]) -> Conic | None:
    """The conic of the plane with these coefficients of x², xy, y², x, y, 1; None for pairs of lines."""
    a, b, c, d, e, f = k
    found = flint.fmpq_mat(3, 3, [to_fmpq(x) for x in (a, b / 2, d / 2, b / 2, c, e / 2, d / 2, e / 2, f)])
    return Conic(tuple(tuple(map(from_flint, row)) for row in found.table())) if found.det() else None


def _conic_through(points: Sequence[Point], plane: Plane | None) -> Conic | None:
    """The conic through five points, as a combination of two pairs of lines through the first four points."""
    if len(points) < 5:
        return None
    if plane is not None:
        frame = _frame(plane)
        flat = _conic_through([_local(point, plane.point, mpq(1), frame) for point in points], None)
        return flat and _lifted(flat, plane.point, mpq(1), frame, plane)
    numbers, unit = over_one_denominator([x for point in points for x in point])
    first, second, third, fourth, (x, y) = list(zip(numbers[::2], numbers[1::2], strict=True))
    pairs = []
    for b, c in ((second, third), (third, second)):
        (p, q, r), (s, t, u) = _through(first, b), _through(c, fourth)
        pairs.append(
            (
                (p * x + q * y + r) * (s * x + t * y + u),
                (p * s, p * t + q * s, q * t, p * u + r * s, q * u + r * t, r * u),
            )
        )
    (v, one), (w, other) = pairs
    return _conic([mpq((w * k - v * m) * unit**e) for k, m, e in zip(one, other, (2, 2, 2, 1, 1, 0), strict=True)])


def _through(a: tuple[int, int], b: tuple[int, int]) -> tuple[int, int, int]:
    """The coefficients of x, y and 1 in the equation of the line through two points."""
    (x, y), (u, v) = a, b
    return y - v, u - x, x * v - y * u


def _fitted_conics(points: Sequence[Point], plane: Plane | None, squared: mpq) -> Iterator[CurveShape]:
    """A parabola and a conic with about the least sum of squares of their polynomials at the points, with coefficients
    as short as their distance from the points allows.
    """
    if len(points) < 6:
        return
    (middle, size), frame = box(points), _frame(plane)
    if plane is not None:  # the conic is sought around a point of the plane
        height = scalar(minus(plane.point, middle), plane.normal) / scalar(plane.normal, plane.normal)
        middle = tuple(x + height * n for x, n in zip(middle, plane.normal, strict=True))
    local = [tuple(rounded(x, ROUND) for x in _local(p, middle, size, frame)) for p in points]
    few = _spread(local, MOST_POINTS)
    if not (general := least([_monomials(p) for p in few])):
        return
    # lengths in the frame differ from those in the plane by a factor of at most 2
    scale = size * size * max(scalar(e, e) for e in frame)
    for rounding, k in ((_with_rounded_square, _parabola(general, few)), (_with_rounded_all, general)):
        if k is None or (found := _conic(k)) is None or not (left := farthest(found, local)):
            continue
        if left * scale <= squared * 4:
            unit = mpq(2) ** (1 - (1 / (upper_square_root(left) * FINE)).numerator.bit_length())
            if (short := _conic(rounding(k, unit))) is not None:
                yield _lifted(short, middle, size, frame, plane)


def _with_rounded_all(k: Sequence[mpq], unit: mpq) -> list[mpq]:
    return [rounded(x, unit) for x in k]


def _with_rounded_square(k: Sequence[mpq], unit: mpq) -> list[mpq]:
    """The coefficients of a parabola, whose quadratic part stays a square."""
    (u, v), scale = _square_root(k), max(k[0], k[2])
    u, v = rounded(u, unit), rounded(v, unit)
    return [u * u, 2 * u * v, v * v, *[rounded(x / scale, unit) for x in k[3:]]]


def _square_root(k: Sequence[mpq]) -> tuple[mpq, mpq]:
    """Approximately the vector u whose square ``(u·x)²`` is nearest to a quadratic part, scaled to a largest entry of
    1.
    """
    a, b, c = k[:3]
    spread = upper_square_root((a - c) * (a - c) + b * b)
    u, v = (a - c + spread, b) if a >= c else (b, c - a + spread)
    if a + c < 0:
        u, v = (b, c - a - spread) if a >= c else (a - c - spread, b)
    largest = max(abs(u), abs(v))
    return u / largest, v / largest


def _parabola(k: Sequence[mpq], points: Sequence[Point]) -> list[mpq] | None:
    """The coefficients of a parabola ``(u·x)² + d·x + f`` near points, from those of a conic, by the Gauss-Newton
    method for the direction of u.
    """
    a, b, c = k[:3]
    if abs(4 * a * c - b * b) > NEARLY * (a + c) ** 2:
        return None
    u, rest = _square_root(k), list[mpq]()
    for _ in range(STEPS):
        rows = [(rounded(2 * scalar(u, p) * (u[0] * p[1] - u[1] * p[0]), ROUND), *p, mpq(1)) for p in points]
        right, columns = [-(scalar(u, p) ** 2) for p in points], list(zip(*rows, strict=True))
        found = solved([[scalar(x, y) for y in columns] for x in columns], [scalar(x, right) for x in columns])
        if found is None:
            return None
        u = rounded(u[0] - found[0] * u[1], ROUND), rounded(u[1] + found[0] * u[0], ROUND)
        rest = [rounded(x, ROUND * ROUND) for x in found[1:]]
    return [u[0] * u[0], 2 * u[0] * u[1], u[1] * u[1], *rest]


def _local(point: Point, origin: Point, size: mpq, frame: Sequence[Point]) -> Point:
    """The coordinates in a frame."""
    offset = minus(point, origin)
    return tuple(scalar(offset, e) / (size * scalar(e, e)) for e in frame)


def _lifted(conic: Conic, origin: Point, size: mpq, frame: Sequence[Point], plane: Plane | None) -> Conic:
    """The conic that is given in a frame, constant along the normal of the plane."""
    rows = [[x / (size * scalar(e, e)) for x in e] for e in frame]
    matrix = [[*row, -scalar(row, origin)] for row in rows] + [[mpq(0)] * len(origin) + [mpq(1)]]
    columns = list(zip(*matrix, strict=True))
    images = [[scalar(row, column) for row in conic.matrix] for column in columns]
    found = tuple(tuple(scalar(column, image) for image in images) for column in columns)
    return Conic(found, plane.normal, plane.point) if plane else Conic(found)
