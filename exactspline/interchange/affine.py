"""Exact affine maps, as rows ``(a_1, …, a_n, shift)``, and the vectors from which their columns are made."""

from __future__ import annotations

from collections.abc import Sequence

from exactspline.errors import ShapeError
from exactspline.interchange.numbers import dyadic, root_below, square_root
from exactspline.numbers.exact import mpq
from exactspline.numbers.once import cached_property

Vector = list[mpq]
#: How a message names the option with which a thing without rational numbers is read.
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
        """The identity."""
        return cls([[int(i == j) for j in range(dimension + 1)] for i in range(dimension)])

    @cached_property
    def is_identity(self) -> bool:
        """Whether this is the identity map."""
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
        """A number by which no distance is stretched more: the largest sum of a row or of a column."""
        rows = [[abs(x) for x in row[:-1]] for row in self.rows]
        return max(sum(each, start=mpq(0)) for each in [*rows, *zip(*rows, strict=True)])

    def __matmul__(self, inner: Affine) -> Affine:
        """The composition: first `inner`, then this map."""
        columns = [self([row[j] for row in inner.rows], 0) for j in range(len(inner.rows))]
        return Affine([*zip(*columns, self([row[-1] for row in inner.rows]), strict=True)])


def unit(vector: Sequence[mpq], error: mpq | None = None) -> list[mpq]:
    """A vector divided by its length, which must be rational; with `error`, of at most 1, by a number so near to its
    length that the result is off by at most that.
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
    """Three perpendicular unit vectors: one on the side of `along`, the one turned from it by a right angle, and one in
    the direction of `normal`; where these are irrational, with `error` three rational ones, each off by at most that.
    And whether it is so.

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
        # the lengths of x and z are off by at most the slack, their directions are right
        turned = _rotation(*found, slack)
        off = max(sum(abs(a - b) for a, b in zip(*both, strict=True)) for both in zip(turned, found, strict=True))
        if off + 3 * slack <= error:
            return turned, True
        slack /= 16


def _rotation(x: Vector, y: Vector, z: Vector, error: mpq) -> tuple[Vector, Vector, Vector]:
    """The columns of a rational rotation near a matrix with nearly perpendicular columns of lengths near 1."""
    # of the matrix and its three products with half turns, one has a trace that is not near −1
    for signs in ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)):
        u, v, w = ([sign * a for a in column] for sign, column in zip(signs, (x, y, z), strict=True))
        size = 1 + u[0] + v[1] + w[2]
        if size > mpq(1, 2):
            break
    a, b, c = (dyadic(q / size, error) for q in (v[2] - w[1], w[0] - u[2], u[1] - v[0]))
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
