"""Numerators and denominators of curves and surfaces: equality, and images under linear, affine and projective maps."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TypeVar

from exactspline.errors import ShapeError, as_items
from exactspline.language.operand import Operand
from exactspline.numbers.exact import Number, mpq
from exactspline.splines.inputs import exact_row

T = TypeVar("T", bound=Operand)


def same_quotients(p: Iterable[T], w: T, q: Iterable[T], v: T) -> bool:
    """Whether p/w and q/v are the same functions."""
    return all((x * v - y * w).is_zero for x, y in zip(p, q, strict=True))


def mapped(p: Sequence[T], w: T, matrix: Sequence[Sequence[Number]], *, polynomial: bool) -> tuple[list[T], T | None]:
    """Numerator and denominator (None for 1) of the image of p/w under a linear, an affine or a projective map.

    Raises `ShapeError` for a matrix of another shape.
    """
    given = enumerate(as_items(matrix, "rows of a matrix"))
    rows = [exact_row(as_items(row, "the numbers of a row"), f"matrix[{i}]") for i, row in given]
    n = len(p)
    shapes = {(len(rows), len(row)) for row in rows}
    projective, affine = shapes == {(n + 1, n + 1)}, shapes == {(n, n + 1)}
    linear = len(shapes) == 1 and len(rows) >= 2 and len(rows[0]) == n
    if not (projective or affine or linear):
        raise ShapeError(
            f"a matrix of rows of {sorted({len(row) for row in rows})} entries, {len(rows)} of them",
            where="matrix",
            remedy=f"in R{n}: n columns (linear), {n} × {n + 1} (affine) or {n + 1} × {n + 1} (projective)",
        )
    coordinates = [*p, *([] if linear else [w])]
    image = [_combination(row, coordinates) for row in rows]
    denominator = image.pop() if projective else None if polynomial else w
    return image, denominator


def _combination(factors: Sequence[mpq], splines: Sequence[T]) -> T:
    first, *rest = [f.scaled(factor) for factor, f in zip(factors, splines, strict=True)]
    for f in rest:
        first = first + f
    return first
