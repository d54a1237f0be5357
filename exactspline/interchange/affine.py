"""Exact affine maps, as rows ``(a_1, …, a_n, shift)``, and the vectors from which their columns are made."""

from __future__ import annotations

from collections.abc import Sequence

from exactspline.errors import ShapeError
from exactspline.interchange.numbers import square_root
from exactspline.numbers.exact import mpq
from exactspline.numbers.once import cached_property


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
        return tuple(
            sum((a * x for a, x in zip(row, point, strict=False)), start=mpq(0)) + row[-1] * weight for row in self.rows
        )

    def homogeneous(self, point: Sequence[mpq]) -> tuple[mpq, ...]:
        """The image of a homogeneous point ``(w x, w y, …, w)``."""
        return (*self(point[:-1], point[-1]), point[-1])

    def __matmul__(self, inner: Affine) -> Affine:
        """The composition: first `inner`, then this map."""
        columns = [self([row[j] for row in inner.rows], 0) for j in range(len(inner.rows))]
        return Affine([*zip(*columns, self([row[-1] for row in inner.rows]), strict=True)])


def unit(vector: Sequence[mpq]) -> list[mpq]:
    """A vector divided by its length; raises `ShapeError` where that is irrational."""
    length = square_root(sum((x * x for x in vector), start=mpq(0)))
    if not length:
        raise ShapeError("an axis of irrational length", remedy="only axes of rational length are exact")
    return [x / length for x in vector]


def cross(u: Sequence[mpq], v: Sequence[mpq]) -> tuple[mpq, mpq, mpq]:
    """The vector product; raises `ShapeError` for vectors that are not in space."""
    if len(u) != 3 or len(v) != 3:
        raise ShapeError("a vector that is not in space", remedy="write three coordinates")
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
