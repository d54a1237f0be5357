"""Operations that change all splines of a curve in the same way, and its images under linear, affine and projective
maps. Functions behind the methods of `Nurbs`; the maps serve surfaces too.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, TypeVar

from exactspline.errors import ShapeError
from exactspline.exact import Number, mpq
from exactspline.language.operand import Operand
from exactspline.splines.bspline import BSpline
from exactspline.splines.control_points import exact_row

if TYPE_CHECKING:
    from exactspline.splines.nurbs import Nurbs
    from exactspline.splines.surface import NurbsSurface

T = TypeVar("T", bound=Operand)


def changed(curve: Nurbs, change: Callable[[BSpline], BSpline]) -> Nurbs:
    """The curve of the changed splines, with the name of the old one; the change keeps constants."""
    w = None if curve.polynomial else change(curve.w)
    return type(curve).from_splines(map(change, curve.p), w, name=curve.name)


def same_function(one: Nurbs | NurbsSurface, other: Nurbs | NurbsSurface) -> bool:
    """Whether two curves, or two surfaces, are one function on one domain."""
    if one.dimension != other.dimension or one.domain != other.domain:
        return False
    w, v = one.w, other.w
    return all((x * v - y * w).is_zero for x, y in zip(one.p, other.p, strict=True))


def transformed(curve: Nurbs, matrix: Sequence[Sequence[Number]]) -> Nurbs:
    """The image under the map with this matrix (see `Nurbs.transform`)."""
    image, w = mapped(list(curve.p), curve.w, matrix, polynomial=curve.polynomial)
    return type(curve).from_splines(image, w, name=curve.name)


def mapped(p: Sequence[T], w: T, matrix: Sequence[Sequence[Number]], *, polynomial: bool) -> tuple[list[T], T | None]:
    """Numerator and denominator (None for 1) of the image of p/w under a linear, an affine or a projective map.

    Raises `ShapeError` for a matrix of another shape.
    """
    rows = [exact_row(row, f"matrix[{i}]") for i, row in enumerate(matrix)]
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
