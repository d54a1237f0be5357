"""The control net of a spline in two parameters: checked when given, computed when needed."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import product
from typing import TypeVar, cast

from exactspline.errors import ExactSplineError, ShapeError, counted, shown
from exactspline.numbers.exact import Number, mpq
from exactspline.splines import blossom
from exactspline.splines.bspline import BSpline
from exactspline.splines.inputs import checked_degree
from exactspline.splines.knots import KnotVector, Mesh
from exactspline.splines.tensor_patches import Degrees

Net = list[list[mpq]]
Points = tuple[tuple[mpq, ...], ...]
T = TypeVar("T")
#: The points of a row, or their numbers.
Row = TypeVar("Row", bound=Sequence[object])


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


def control_point_counts(knots: tuple[KnotVector, KnotVector], degrees: tuple[int, int]) -> tuple[int, int]:
    """How many control points there are along each parameter."""
    first, second = (len(vector) - n - 1 for vector, n in zip(knots, degrees, strict=True))
    return first, second


def checked_net(
    given: object, counts: tuple[int, int], letters: tuple[str, str], read: Callable[[Iterable[T], str], Row]
) -> list[Row]:
    """A net of control points as given by a user: this many rows along the first parameter of this many points along
    the second; `read` takes a row and its place.

    Raises `ShapeError` for a net of another shape, and what `read` raises.
    """
    if isinstance(given, str) or not isinstance(given, Iterable):
        remedy = f"give rows of control points along {letters[0]}"
        raise ShapeError(f"{shown(given)} is not a net", where="control_points", remedy=remedy)
    net = []
    for i, row in enumerate(given):
        place = f"control_points[{i}]"
        if isinstance(row, str) or not isinstance(row, Iterable):
            remedy = "give a list of control points"
            raise ShapeError(f"{shown(row)} is not a row of control points", where=place, remedy=remedy)
        points = read(cast("Iterable[T]", row), place)
        if len(points) != counts[1]:
            raise _miscounted(f"{counted(len(points), 'control point')} in a row", place, counts[1], letters[1])
        net.append(points)
    if len(net) != counts[0]:
        raise _miscounted(f"{counted(len(net), 'row')} of control points", "control_points", counts[0], letters[0])
    return net


def _miscounted(problem: str, where: str, count: int, letter: str) -> ShapeError:
    return ShapeError(problem, where=where, remedy=f"there must be {count} (knots − degree − 1 along {letter})")


def bezier_nets(degrees: Degrees, along_s: Sequence[BSpline]) -> Iterator[Net]:
    """The Bézier nets of all patches, t running faster; `along_s` has a spline in s for each Bézier point along t."""
    n = degrees.t + 1
    segments = [spline.bezier_points for spline in along_s]
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
    segmented = ([row[j : j + n] for j in range(0, len(row), n)] for row in zip(*columns, strict=True))
    return tuple(blossom.to_control_points(knots[1].knots, degrees.t, meshes[1].breaks, parts) for parts in segmented)
