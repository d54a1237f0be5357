"""Shapes on which points may lie: guesses, from which a proof begins. Nothing rests on them but how close they come."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from operator import mul

import flint

from exactspline.geometry.recognition.shapes import (
    NOTHING,
    Circle,
    Conic,
    Line,
    Point,
    Shape,
    minus,
    scalar,
    upper_square_root,
)
from exactspline.numbers.exact import decimal_unit, from_flint, mpq, over_one_denominator, to_fmpq

#: The points from which a shape is guessed, at most.
MOST_POINTS = 24
#: A shape through few of the points may come this much less close to the others than the best one.
WORSE = 1024
#: Coordinates are rounded to this fraction of the size of the points for sums of squares, parameters of the shape to
#: `FINE` times the distance that the guess leaves.
ROUND = mpq(1, 2**64)
FINE = mpq(1, 32)
#: Bits behind the point, more than conics through points that are almost on several need.
FIXED = 384


def candidates(points: Sequence[Point], limit: mpq) -> Iterator[Shape]:
    """A line, a circle, in the plane a conic, which come about as close to points as a limit: through some of the
    points where that is exact, otherwise by least squares.

    >>> line, *_ = candidates([(mpq(0), mpq(0)), (mpq(1), mpq(2)), (mpq(2), mpq(4))], mpq(1))
    >>> print(line)
    line: point (0, 0), direction (2, 4)
    """
    squared = limit * limit
    if (line := _line(points)) is not None and _all_near(line, points, squared):
        yield line
    in_plane = len(points[0]) == 2
    makers = ((_circle_through, 3, _fitted_circle), (_conic_through, 5, _fitted_conic))
    for through, count, fitted in makers if in_plane else ((_circle_in_space_through, 3, _fitted_circle_in_space),):
        first = through(_spread(points[:-1], count))
        if first is None or not _all_near(first, points, squared * WORSE * WORSE):
            continue
        found = first if _all_near(first, points, NOTHING) else fitted(_spread(points, MOST_POINTS))
        if found is not None and _all_near(found, points, squared):
            yield found


def _all_near(shape: Shape, points: Sequence[Point], squared: mpq) -> bool:
    """Whether about the square of the distance of no point is above this; from the last point on, which is not one of
    those through which a shape was laid.
    """
    return all(shape.estimate(point) <= squared for point in reversed(points))


def _spread(points: Sequence[Point], count: int) -> list[Point]:
    """This many of the points, evenly; all different neighbours."""
    different = [points[0], *[b for a, b in pairwise(points) if a != b]]
    n = len(different)
    return different if n <= count else [different[i * (n - 1) // (count - 1)] for i in range(count)]


def _box(points: Sequence[Point]) -> tuple[Point, mpq]:
    """The middle of the box around points, and its longest side as a power of 2 (1 for a single point)."""
    columns = list(zip(*points, strict=True))
    middle = tuple((min(column) + max(column)) / 2 for column in columns)
    side = max(max(column) - min(column) for column in columns)
    if not side:
        return middle, mpq(1)
    return middle, mpq(2) ** (side.numerator.bit_length() - side.denominator.bit_length())


def _rounded(x: mpq, unit: mpq) -> mpq:
    """The nearest multiple of a number."""
    return (x / unit + mpq(1, 2)) // 1 * unit


def _cross(a: Point, b: Point) -> Point:
    return tuple(a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3))


def _solved(rows: Sequence[Sequence[mpq]], right: Sequence[mpq]) -> list[mpq] | None:
    """The solution of a linear system, None where it has not exactly one."""
    n = len(right)
    matrix = flint.fmpq_mat(n, n, [to_fmpq(x) for row in rows for x in row])
    try:
        found = matrix.solve(flint.fmpq_mat(n, 1, [to_fmpq(x) for x in right]))
    except ZeroDivisionError:
        return None
    return [from_flint(found[i, 0]) for i in range(n)]


def _line(points: Sequence[Point]) -> Line | None:
    """From the first point to the last, or to the one farthest from it."""
    offsets = [minus(point, points[0]) for point in points]
    direction = max(offsets, key=lambda offset: scalar(offset, offset))
    return Line(points[0], direction) if any(direction) else None


# ---- circles


def _circle_through(points: Sequence[Point], normal: Point = ()) -> Circle | None:
    """The circle through three points."""
    if len(points) < 3:
        return None
    a, b, c = points
    sides = [minus(x, a) for x in (b, c)]
    right = [scalar(x, x) / 2 for x in sides]
    step: Sequence[mpq] | None
    if normal:
        step = _solved([*sides, normal], [*right, NOTHING])
    else:
        (x, y), (u, v) = sides
        area = x * v - y * u
        step = ((right[0] * v - right[1] * y) / area, (right[1] * x - right[0] * u) / area) if area else None
    if step is None:
        return None
    return Circle(tuple(x + y for x, y in zip(a, step, strict=True)), scalar(step, step), normal)


def _fitted_circle(points: Sequence[Point], frame: Sequence[Point] = (), normal: Point = ()) -> Circle | None:
    """The circle with the least sum of ``(‖x − c‖² − r²)²`` (I. Kåsa 1976), its centre in the plane through the first
    point that a frame spans; with numbers as short as its distance from the points allows.
    """
    (_, size), start = _box(points), points[0]
    frame = frame or ((mpq(1), mpq(0)), (mpq(0), mpq(1)))
    rows, right = [], []
    for point in points:
        offset = [_rounded(x / size, ROUND) for x in minus(point, start)]
        rows.append([*[-2 * scalar(offset, e) for e in frame], mpq(1)])
        right.append(-scalar(offset, offset))
    columns = list(zip(*rows, strict=True))
    found = _solved([[scalar(x, y) for y in columns] for x in columns], [scalar(x, right) for x in columns])
    if found is None:
        return None
    shift = [sum((k * e[i] for k, e in zip(found, frame, strict=False)), start=mpq(0)) for i in range(len(start))]
    centre = tuple(x + size * y for x, y in zip(start, shift, strict=True))
    return _shortened(Circle(centre, size * size * (scalar(shift, shift) - found[-1]), normal), points)


def _shortened(circle: Circle, points: Sequence[Point]) -> Circle | None:
    """The circle with shorter numbers, its radius in the middle between the least and the largest distance."""
    if circle.radius_squared <= 0:
        return None
    left = max(map(circle.estimate, points))
    if not left:
        return circle
    unit = decimal_unit(upper_square_root(left) * FINE)
    centre = tuple(_rounded(x, unit) for x in circle.centre)
    distances = [scalar(minus(point, centre), minus(point, centre)) for point in points]
    radius = _rounded((upper_square_root(min(distances)) + upper_square_root(max(distances))) / 2, unit)
    normal = circle.normal
    if normal:
        largest = max(normal, key=abs)
        slope = decimal_unit(unit / upper_square_root(circle.radius_squared))
        normal = tuple(_rounded(x / largest, slope) for x in normal)
    return Circle(centre, radius * radius, normal) if radius > 0 else None


def _normal(points: Sequence[Point]) -> Point | None:
    """A vector orthogonal to the plane through three points of space."""
    if len(points) < 3:
        return None
    found = _cross(minus(points[1], points[0]), minus(points[2], points[0]))
    return found if any(found) else None


def _circle_in_space_through(points: Sequence[Point]) -> Circle | None:
    normal = _normal(points)
    return None if normal is None else _circle_through(points, normal)


def _fitted_circle_in_space(points: Sequence[Point]) -> Circle | None:
    three = _spread(points[:-1], 3)
    normal = _normal(three)
    if normal is None:
        return None
    u = minus(three[1], three[0])
    frame = []
    for vector in (u, _cross(normal, u)):
        largest = max(vector, key=abs)
        frame.append(tuple(_rounded(x / abs(largest), ROUND) for x in vector))
    return _fitted_circle(points, frame, normal)


# ---- conics


def _monomials(point: Point) -> list[mpq]:
    x, y = point
    return [x * x, x * y, y * y, x, y, mpq(1)]


def _conic(k: Sequence[mpq]) -> Conic | None:
    """The conic with these coefficients of x², xy, y², x, y, 1; None for pairs of lines."""
    a, b, c, d, e, f = k
    found = Conic(((a, b / 2, d / 2), (b / 2, c, e / 2), (d / 2, e / 2, f)))
    return found if found.determinant else None


def _conic_through(points: Sequence[Point]) -> Conic | None:
    """The conic through five points: of the conics through the first four, which two pairs of lines span."""
    if len(points) < 5:
        return None
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
    degrees = (2, 2, 2, 1, 1, 0)
    return _conic([mpq((w * k - v * m) * unit**e) for k, m, e in zip(one, other, degrees, strict=True)])


def _through(a: tuple[int, int], b: tuple[int, int]) -> tuple[int, int, int]:
    """The coefficients of x, y and 1 in the equation of the line through two points."""
    (x, y), (u, v) = a, b
    return y - v, u - x, x * v - y * u


def _fitted_conic(points: Sequence[Point]) -> Conic | None:
    """The conic whose coefficients, of length 1, have the least sum of squares at the points, by inverse iteration;
    with coefficients as short as its distance from the points allows.
    """
    if len(points) < 6:
        return None
    middle, size = _box(points)
    local = [tuple(_rounded((x - m) / size, ROUND) for x, m in zip(p, middle, strict=True)) for p in points]
    found = _conic(k) if (k := _smallest(local)) else None
    left = found and max(map(found.estimate, local))
    if not left:
        return None
    unit = mpq(2) ** (1 - (1 / (upper_square_root(left) * FINE)).numerator.bit_length())
    return _moved([_rounded(x, unit) for x in k], middle, size)


def _smallest(points: Sequence[Point]) -> list[mpq]:
    """The coefficients, the largest of them 1, with the least sum of squares at points whose coordinates are multiples
    of `ROUND`, to twice its digits; none where there is no such conic. In numbers of a fixed number of bits.
    """
    unit = int(1 / ROUND)
    whole = [[int(x * unit) for x in point] for point in points]
    columns = [*zip(*[(x * x, x * y, y * y, x * unit, y * unit, unit * unit) for x, y in whole], strict=True)]
    scatter = [[sum(map(mul, x, y)) << FIXED for y in columns[: i + 1]] for i, x in enumerate(columns)]
    for row in scatter:
        row[-1] += unit * unit << FIXED
    # the matrix is L D Lᵀ
    lower, diagonal = [[0] * 6 for _ in range(6)], list[int]()
    for j in range(6):
        weighted = [x * d >> FIXED for x, d in zip(lower[j], diagonal, strict=False)]
        pivot = scatter[j][j] - (sum(map(mul, lower[j], weighted)) >> FIXED)
        if pivot <= 0:
            return []
        diagonal.append(pivot)
        for i in range(j + 1, 6):
            lower[i][j] = ((scatter[i][j] << FIXED) - sum(map(mul, lower[i], weighted))) // pivot
    upper = [*zip(*lower, strict=True)]
    # a start that is in no way special
    numbers, fine = [210, 140, 105, 84, 70, 60], unit * unit
    for _ in range(3):
        for i in range(6):
            numbers[i] = (numbers[i] << FIXED) - (sum(map(mul, lower[i], numbers[:i])) >> FIXED)
        numbers = [(x << 2 * FIXED) // d for x, d in zip(numbers, diagonal, strict=True)]
        for i in range(4, -1, -1):
            numbers[i] -= sum(map(mul, upper[i][i + 1 :], numbers[i + 1 :])) >> FIXED
        largest = max(numbers, key=abs)
        if not largest:
            return []
        numbers = [(2 * fine * x + largest) // (2 * largest) for x in numbers]
    return [mpq(x, fine) for x in numbers]


def _moved(k: Sequence[mpq], middle: Point, size: mpq) -> Conic | None:
    """The conic by its coefficients in the coordinates ``(x − middle) / size``."""
    a, b, c, d, e, f = k
    (x, y), s = middle, size
    return _conic(
        [
            a,
            b,
            c,
            d * s - 2 * a * x - b * y,
            e * s - 2 * c * y - b * x,
            a * x * x + b * x * y + c * y * y - (d * x + e * y) * s + f * s * s,
        ]
    )
