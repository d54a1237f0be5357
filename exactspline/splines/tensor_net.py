"""The control net of a spline in two parameters: checked when given, computed when needed."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import product
from typing import Any

from exactspline.errors import ExactSplineError, ShapeError, counted, shown
from exactspline.numbers.exact import Number, mpq
from exactspline.splines import blossom
from exactspline.splines.bspline import BSpline
from exactspline.splines.given import checked_degree, exact_row
from exactspline.splines.knots import KnotVector, Mesh
from exactspline.splines.tensor_patches import Degrees

Net = list[list[mpq]]
Points = tuple[tuple[mpq, ...], ...]


def checked_degrees(degrees: object) -> Degrees:
    """Two degrees as given by a user; raises `ShapeError` for anything else."""
    if not isinstance(degrees, (tuple, list)) or len(degrees) != 2:
        raise ShapeError(
            f"{shown(degrees)} are not two degrees", where="degrees", remedy="give one for s and one for t"
        )
    checked = []
    for i, degree in enumerate(degrees):
        try:
            checked.append(checked_degree(degree))
        except ShapeError as error:
            raise error.moved("degree", f"degrees[{i}]") from None
    return Degrees(*checked)


def checked_knots(knots: Iterable[Number], degree: int, name: str) -> KnotVector:
    """Knots as given by a user, the errors of `BSpline` with the name of the argument."""
    try:
        vector = KnotVector(knots)
        vector.check(degree)
    except ExactSplineError as error:
        raise error.moved("knots", name) from None
    return vector


def checked_net(net: object, rows: int, columns: int) -> list[tuple[mpq, ...]]:
    """Control points as given by a user: this many rows along s of this many points along t."""
    if not isinstance(net, Iterable):
        raise ShapeError(f"{shown(net)} is not a net", where="control_points", remedy="give the control points in rows")
    found = [_checked_row(row, f"control_points[{i}]", columns) for i, row in enumerate(net)]
    if len(found) != rows:
        raise ShapeError(
            f"{counted(len(found), 'row')} of control points",
            where="control_points",
            remedy=f"there must be {rows} (knots − degree − 1 along s)",
        )
    return found


def _checked_row(row: Any, where: str, columns: int) -> tuple[mpq, ...]:
    if not isinstance(row, Iterable):
        raise ShapeError(
            f"{shown(row)} is not a row of control points", where=where, remedy="give the control points in rows"
        )
    points = exact_row(row, where)
    if len(points) != columns:
        raise ShapeError(
            f"{counted(len(points), 'control point')} in a row",
            where=where,
            remedy=f"there must be {columns} (knots − degree − 1 along t)",
        )
    return points


def bezier_nets(degrees: Degrees, along_s: Sequence[BSpline]) -> Iterator[Net]:
    """The Bézier nets of all patches, t running faster; `along_s` has a spline in s for each Bézier point along t."""
    n = degrees.t + 1
    segments = [spline.segments for spline in along_s]
    for i, j in product(range(len(along_s[0].mesh)), range(len(along_s) // n)):
        yield [list(row) for row in zip(*[segments[j * n + k][i] for k in range(n)], strict=True)]


def control_net(
    knots: tuple[KnotVector, KnotVector], degrees: Degrees, meshes: tuple[Mesh, Mesh], nets: list[list[Net]]
) -> Points:
    """The control net over clamped knots; ``nets[i][j]`` are the Bézier points over segment i of s and j of t. None
    below degree 0.
    """
    if min(degrees) < 0:
        return ()
    n, columns = degrees.t + 1, []
    for j in range(len(meshes[1])):
        for k in range(n):
            segments = [[row[k] for row in patches[j]] for patches in nets]
            columns.append(blossom.to_control_points(knots[0].knots, degrees.s, meshes[0].breaks, segments))
    rows = zip(*columns, strict=True)
    segmented = ([row[j : j + n] for j in range(0, len(row), n)] for row in rows)
    return tuple(blossom.to_control_points(knots[1].knots, degrees.t, meshes[1].breaks, parts) for parts in segmented)
