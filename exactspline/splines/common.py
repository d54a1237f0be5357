"""Splines in a common representation: over the same knots and of the same degree."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TypeVar

from flint import fmpz, fmpz_poly

from exactspline.errors import ShapeError, as_items
from exactspline.language.operand import Operand
from exactspline.language.provenance import leaf
from exactspline.language.vector import Vector
from exactspline.numbers.exact import Number, mpq
from exactspline.splines.blossom import CommonRows, common_rows
from exactspline.splines.bspline import BSpline, from_parts
from exactspline.splines.inputs import exact_row
from exactspline.splines.knots import KnotVector, mesh_of
from exactspline.splines.tensor import TensorSpline

S = TypeVar("S", BSpline, TensorSpline)


def with_common_knots(splines: Iterable[S]) -> list[S]:
    """The same functions over a common knot vector (in two parameters, one in each): with all breakpoints, the highest
    degree, and the lowest continuity at each knot.

    The control points with the same index then belong together, as coordinates, or as coordinates and weights.

    >>> t = BSpline.identity(0, 1)
    >>> [f.control_points for f in with_common_knots([t, t * t])]
    [(mpq(0,1), mpq(1,2), mpq(1,1)), (mpq(0,1), mpq(0,1), mpq(1,1))]

    Raises `DomainError` if their domains differ.
    """
    splines = list(splines)
    # a sum has the knots of both operands and the larger degree; multiplied by 0, the other splines contribute only
    # these
    common = splines[0] * 0
    for f in splines[1:]:
        common = common + f * 0
    return [f + common for f in splines]


def splines_over(
    degree: int, knots: KnotVector, columns: Sequence[tuple[mpq, ...]], rows: Sequence[CommonRows] | None = None
) -> list[BSpline]:
    """The components of a curve, from their control points over knots that are valid for the degree. Segment by segment
    they are over a common denominator, so that sums stay cheap; they share one mesh. `rows` are the integers of the
    forms of the components, if known.

    >>> x, y = splines_over(1, KnotVector([0, 0, 1, 1]), [(mpq(0), mpq(1)), (mpq(1, 2), mpq(1))])
    >>> int(x.denominators[0]), y.denominators == x.denominators, y.control_points
    (2, True, (mpq(1,2), mpq(1,1)))
    """
    mesh, continuity, spans = mesh_of(knots, degree)
    forms = rows or common_rows(knots.knots, degree, columns, spans)
    below = tuple([fmpz(m) for _, m in forms])
    return [
        from_parts(degree, mesh, continuity, tuple([fmpz_poly(list(c)) for c in own]), below, leaf(), knots, column)
        for own, column in zip(zip(*[own for own, _ in forms], strict=True), columns, strict=True)
    ]


# ---- numerators and denominators of curves and surfaces


T = TypeVar("T", bound=Operand)


def same_quotients(p: Vector[S], w: S, q: Vector[S], v: S) -> bool:
    """Whether p/w and q/v are the same functions on the same domain."""
    alike = len(p) == len(q) and w.domain == v.domain
    return alike and all((x * v - y * w).is_zero for x, y in zip(p, q, strict=True))


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
