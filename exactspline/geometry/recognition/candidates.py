"""Shapes on which points may lie: guesses, from which a proof begins. Nothing rests on them but how close they come."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

import flint

from exactspline.geometry.recognition.shapes import Circle, Conic, Line, Point, Shape, minus, scalar, upper_square_root
from exactspline.numbers.exact import decimal_unit, from_flint, mpq, over_one_denominator, to_fmpq

#: The points from which a shape is guessed, at most.
MOST_POINTS = 24
#: A shape through few of the points may come this much less close to the others than the best one.
WORSE = 1024
#: Coordinates are rounded to this fraction of the size of the points for sums of squares, parameters of the shape to
#: `FINE` times the distance that the guess leaves.
ROUND = mpq(1, 2**64)
FINE = mpq(1, 32)


def candidates(points: Sequence[Point], limit: mpq) -> Iterator[Shape]:
    """A line, a circle, in the plane a conic, which come about as close to points as a limit: through some of the
    points where that is exact, otherwise by least squares.

    >>> line, *_ = candidates([(mpq(0), mpq(0)), (mpq(1), mpq(2)), (mpq(2), mpq(4))], mpq(1))
    >>> print(line)
    line: point (0, 0), direction (2, 4)
    """
    squared = limit * limit
    if (line := _line(points)) is not None and _farthest(line, points) <= squared:
        yield line
    in_plane = len(points[0]) == 2
    makers = ((_circle_through, 3, _fitted_circle), (_conic_through, 5, _fitted_conic))
    for through, count, fitted in makers if in_plane else ((_circle_in_space_through, 3, _fitted_circle_in_space),):
        first = through(_spread(points[:-1], count))
        away = None if first is None else _farthest(first, points)
        if away is None or away > squared * WORSE * WORSE:
            continue
        found = fitted(_spread(points, MOST_POINTS)) if away else first
        if found is not None and _farthest(found, points) <= squared:
            yield found


def _farthest(shape: Shape, points: Sequence[Point]) -> mpq:
    """About the square of the largest distance of the points."""
    return max(map(shape.estimate, points))


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
    start = points[0]
    end = max(points, key=lambda point: scalar(minus(point, start), minus(point, start)))
    direction = minus(end, start)
    return Line(start, direction) if any(direction) else None


# ---- circles


def _circle_through(points: Sequence[Point], normal: Point = ()) -> Circle | None:
    """The circle through three points."""
    if len(points) < 3:
        return None
    a, b, c = points
    sides = [minus(x, a) for x in (b, c)]
    rows, right = [*sides], [scalar(x, x) / 2 for x in sides]
    if normal:
        rows, right = [*rows, normal], [*right, mpq(0)]
    step = _solved(rows, right)
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
    """The conic through five points."""
    if len(points) < 5:
        return None
    rows = [over_one_denominator(_monomials(point))[0] for point in points]
    basis, count = flint.fmpz_mat(rows).nullspace()
    return _conic([from_flint(basis[i, 0]) for i in range(6)]) if count == 1 else None


def _fitted_conic(points: Sequence[Point]) -> Conic | None:
    """The conic whose coefficients, of length 1, have the least sum of squares at the points, by inverse iteration;
    with coefficients as short as its distance from the points allows.
    """
    if len(points) < 6:
        return None
    middle, size = _box(points)
    local = [tuple(_rounded((x - m) / size, ROUND) for x, m in zip(p, middle, strict=True)) for p in points]
    columns = list(zip(*map(_monomials, local), strict=True))
    scatter = [[scalar(x, y) + (ROUND * ROUND if x is y else 0) for y in columns] for x in columns]
    k = [mpq(1, i + 2) for i in range(6)]
    for _ in range(3):
        solution = _solved(scatter, k)
        if solution is None:
            return None
        largest = max(solution, key=abs)
        k = [_rounded(x / largest, ROUND * ROUND) for x in solution]
    found = _conic(k)
    left = found and max(map(found.estimate, local))
    if not left:
        return None
    unit = mpq(2) ** (1 - (1 / (upper_square_root(left) * FINE)).numerator.bit_length())
    return _moved([_rounded(x, unit) for x in k], middle, size)


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
