"""The parts of a spline in two parameters: packed polynomials, patch by patch; a spline in one parameter, if it depends
on this parameter only; and lines of splines in one parameter, so that every operation of `BSpline` is available in
either direction.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cache
from itertools import product
from typing import NamedTuple, TypeVar, cast

from flint import fmpz, fmpz_poly

from exactspline.errors import ExactSplineError, ShapeError, counted, shown
from exactspline.language.provenance import Provenance
from exactspline.numbers.exact import Number, mpq
from exactspline.polynomials import tensor_bernstein
from exactspline.polynomials.bernstein import ONE, over_common_denominator, without_content
from exactspline.polynomials.tensor_bernstein import columns, derivative, rows, without_powers
from exactspline.splines import blossom, refinement
from exactspline.splines.bspline import BSpline
from exactspline.splines.inputs import checked_degree
from exactspline.splines.knots import SMOOTH, KnotVector, Mesh

Profile = tuple[int, BSpline]
T = TypeVar("T")


def packed_segments(profile: Profile, stride: int) -> tuple[fmpz_poly, ...]:
    """The packed polynomials, one per segment."""
    direction, spline = profile
    return tuple([c.inflate(stride) for c in spline.numerators]) if direction else spline.numerators


def spread(values: tuple[T, ...], direction: int, meshes: tuple[Mesh, Mesh]) -> tuple[T, ...]:
    """Values on the segments of one direction, patch by patch, t running faster."""
    count = len(meshes[1 - direction].widths)
    if count == 1:
        return values
    return values * count if direction else tuple([x for x in values for _ in range(count)])


@cache
def smooth(segments: int) -> tuple[int, ...]:
    """Continuity across the breakpoints of a parameter on which a spline does not depend."""
    return (SMOOTH,) * (segments - 1)


def changed_one(mesh: Mesh, change: Callable[[BSpline], BSpline]) -> BSpline:
    """The image of the constant 1 under a linear map of splines: its effect on splines that depend on the other
    parameter only.
    """
    return change(BSpline.from_forms(0, mesh, smooth(len(mesh)), [(fmpz_poly([1]), ONE)] * len(mesh)))


class _NamedMeshes(tuple[Mesh, Mesh]):
    """The breakpoints in two directions with names of the parameters, as for a surface or for two curves."""

    letters: tuple[str, str]


def with_names(meshes: tuple[Mesh, Mesh], letters: tuple[str, str] | None) -> tuple[Mesh, Mesh]:
    """The meshes with the names of their parameters; unchanged if there are no names."""
    if letters is None:
        return meshes
    found = _NamedMeshes(meshes)
    found.letters = letters
    return found


def letters_of(meshes: tuple[Mesh, Mesh]) -> tuple[str, str] | None:
    """The names of the parameters; None if they have no names."""
    return meshes.letters if isinstance(meshes, _NamedMeshes) else None


def replaced(meshes: tuple[Mesh, Mesh], direction: int, mesh: Mesh) -> tuple[Mesh, Mesh]:
    """The meshes with one mesh replaced; the same tuple if nothing changes, because operands are aligned by
    identity.
    """
    if mesh is meshes[direction]:
        return meshes
    return with_names((meshes[0], mesh) if direction else (mesh, meshes[1]), letters_of(meshes))


def exchanged(meshes: tuple[Mesh, Mesh]) -> tuple[Mesh, Mesh]:
    """The meshes in the other order."""
    letters = letters_of(meshes)
    return with_names((meshes[1], meshes[0]), None if letters is None else (letters[1], letters[0]))


def one_parameter(a: Profile, b: Profile) -> tuple[int, BSpline, BSpline] | None:
    """The direction and the splines of two profiles that depend on the same parameter only; a constant counts for
    either parameter.
    """
    (i, f), (j, g) = a, b
    if i == j:
        return i, f, g
    if _is_constant(f):
        return j, _constant_beside(g, f), g
    return (i, f, _constant_beside(f, g)) if _is_constant(g) else None


def _is_constant(f: BSpline) -> bool:
    return f.degree == 0 and all(c == SMOOTH for c in f.continuity)


def _constant_beside(f: BSpline, constant: BSpline) -> BSpline:
    return refinement.over(f.constant(constant(constant.domain[0])), f.mesh)


class Degrees(NamedTuple):
    """The degrees in the two parameters."""

    s: int
    t: int

    def max(self, other: Degrees) -> Degrees:
        """The larger of two degrees in each parameter."""
        return Degrees(max(self.s, other.s), max(self.t, other.t))


#: The continuity in each parameter at its inner knots.
Continuity = tuple[tuple[int, ...], tuple[int, ...]]
#: Degree, meshes, continuity, stride, packed polynomials and denominators.
Parts = tuple[Degrees, tuple[Mesh, Mesh], Continuity, int, tuple[fmpz_poly, ...], tuple[fmpz, ...]]


class TensorParts:
    """The fields of a spline in two parameters (see `exactspline.splines.tensor.TensorSpline`)."""

    __slots__ = (
        "_denominators",
        "_packed",
        "_points",
        "continuity",
        "degree",
        "meshes",
        "profile",
        "provenance",
        "stride",
    )

    degree: Degrees
    #: The breakpoints in each direction, and the continuity at the interior ones.
    meshes: tuple[Mesh, Mesh]
    continuity: tuple[tuple[int, ...], tuple[int, ...]]
    #: If the spline depends on one parameter only: the direction of this parameter (0 for s), and the spline in it.
    profile: Profile | None
    provenance: Provenance
    #: The stride of `polynomials` (see `exactspline.polynomials.tensor_bernstein`); results keep the stride as long as
    #: it is large enough, because repacking costs more than a product.
    stride: int
    #: The packed polynomials by stride, and the denominators; for a spline in one parameter only they are computed when
    #: needed.
    _packed: dict[int, tuple[fmpz_poly, ...]]
    _denominators: tuple[fmpz, ...] | None
    #: Set when they are computed.
    _points: tuple[tuple[mpq, ...], ...]

    def at_stride(self, stride: int) -> tuple[fmpz_poly, ...]:
        """Return the packed polynomials of all patches, ordered by s, then by t. The stride must be large enough for
        the degree.
        """
        found = self._packed.get(stride)
        if found is None:
            if self.profile is None:
                found = tuple(tensor_bernstein.repacked(c, self.stride, stride) for c in self.numerators)
            else:
                found = spread(packed_segments(self.profile, stride), self.profile[0], self.meshes)
            self._packed[stride] = found
        return found

    @property
    def numerators(self) -> tuple[fmpz_poly, ...]:
        """The packed polynomials at the current stride, which are shared and must not be changed. They are zero if the
        spline is zero.
        """
        return self.at_stride(self.stride)

    @property
    def denominators(self) -> tuple[fmpz, ...]:
        """The denominators of the patches, ordered by s, then by t."""
        known = self._denominators
        if known is None:
            assert self.profile is not None
            known = spread(self.profile[1].denominators, self.profile[0], self.meshes)
            object.__setattr__(self, "_denominators", known)  # store a part computed lazily
        return known


Z_MINUS_1 = fmpz_poly([-1, 1])


def derived(f: TensorParts, direction: int) -> Parts:
    """The parts of the derivative by one parameter (0: the first), in which the degree must be positive."""
    polynomials = [derivative(c, f.stride, f.degree, direction) for c in f.numerators]
    denominators = f.denominators
    if not f.meshes[direction].unit:
        widths = spread(f.meshes[direction].widths, direction, f.meshes)
        polynomials = [c * bottom for c, (_, bottom) in zip(polynomials, widths, strict=True)]
        denominators = tuple([m * top for m, (top, _) in zip(denominators, widths, strict=True)])
    (m, n), (s, t) = f.degree, f.continuity
    lower = tuple([max(c - 1, -1) for c in f.continuity[direction]])
    degree, continuity = (Degrees(m, n - 1), (s, lower)) if direction else (Degrees(m - 1, n), (lower, t))
    return degree, f.meshes, continuity, f.stride, tuple(polynomials), denominators


def true_degrees(f: TensorParts) -> Degrees:
    """The largest degree in each parameter of the polynomials of the patches (−1 for zero)."""
    if not any(f.numerators):
        return Degrees(-1, -1)
    m, n = f.degree
    in_s = (row for c in f.numerators for row in rows(c, f.stride, n))
    in_t = (column for c in f.numerators for column in columns(c, f.stride, m))
    return Degrees(m - _multiplicity(in_s), n - _multiplicity(in_t))


def _multiplicity(polynomials: Iterable[fmpz_poly]) -> int:
    """The multiplicity with which ``u + v``, which is 1 + z, divides all of these polynomials (not all zero)."""
    least = -1
    for p in polynomials:
        if p and p(-1) != 0:
            return 0
        if p:
            shifted = p(Z_MINUS_1)
            times = next(k for k in range(shifted.degree() + 1) if shifted[k])
            least = times if least < 0 else min(least, times)
    return least


def lowered(f: TensorParts, by_s: int, by_t: int) -> Parts | None:
    """The parts of the same function with the degrees lowered; None if the function is zero, if it has more than one
    patch (knots may be smooth afterwards), or if the degrees cannot be lowered that much.
    """
    true, (m, n) = true_degrees(f), f.degree
    degree = Degrees(m - by_s, n - by_t)
    if len(f.denominators) > 1 or min(by_s, by_t, *true) < 0 or degree.max(true) != degree:
        return None
    c, below = without_content((without_powers(f.numerators[0], f.stride, (by_s, by_t)), f.denominators[0]))
    return degree, f.meshes, f.continuity, f.stride, (c,), (below,)


def lines(f: TensorParts) -> list[list[BSpline]]:
    """For each segment of s and each power of its local parameter the coefficients, as splines in t."""
    columns, own = len(f.meshes[1]), f.numerators
    found = []
    for i in range(len(f.meshes[0])):
        patches = range(i * columns, (i + 1) * columns)
        nets = [tensor_bernstein.rows(own[k], f.stride, f.degree.t) for k in patches]
        lines = []
        for h in range(
            max(f.degree.s, 0) + 1
        ):  # for a degree below 0 one line of zeros, so that there is a line to change
            forms = [
                without_content((fmpz_poly([row[h] for row in net]), f.denominators[k]))
                for k, net in zip(patches, nets, strict=True)
            ]
            lines.append(BSpline.from_forms(f.degree.t, f.meshes[1], f.continuity[1], forms))
        found.append(lines)
    return found


def joined_lines(found: list[list[BSpline]], old: TensorParts) -> Parts:
    """Degree, meshes, continuity, stride, packed polynomials and denominators of the spline with these lines; along s
    it is as the old spline.
    """
    first, stride = found[0][0], tensor_bernstein.stride_for(old.degree.s)
    polynomials, denominators = [], []
    for own in found:
        for j in range(len(first.mesh)):
            rows, denominator = over_common_denominator([(line.numerators[j], line.denominators[j]) for line in own])
            polynomials.append(
                tensor_bernstein.packed([fmpz_poly([row[k] for row in rows]) for k in range(first.degree + 1)], stride)
            )
            denominators.append(denominator)
    continuity = (old.continuity[0], first.continuity)
    return (
        Degrees(old.degree.s, first.degree),
        replaced(old.meshes, 1, first.mesh),
        continuity,
        stride,
        tuple(polynomials),
        tuple(denominators),
    )


# ---- the control net


Net = list[list[mpq]]
Points = tuple[tuple[mpq, ...], ...]
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
    """Knots as given by a user, raises the errors of `BSpline` with the name of the argument."""
    try:
        vector = KnotVector(knots)
        vector.check(degree)
    except ExactSplineError as error:
        raise error.moved("knots", name) from None
    return vector


def control_point_counts(knots: tuple[KnotVector, KnotVector], degrees: tuple[int, int]) -> tuple[int, int]:
    """The number of control points along each parameter."""
    first, second = (len(vector) - n - 1 for vector, n in zip(knots, degrees, strict=True))
    return first, second


def checked_net(
    given: object, counts: tuple[int, int], letters: tuple[str, str], read: Callable[[Iterable[T], str], Row]
) -> list[Row]:
    """A net of control points as given by a user: this many rows along the first parameter of this many points along
    the second; `read` takes a row and its place.

    Raises `ShapeError` for a net of another shape, and the errors of `read`.
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
    """The control net over clamped knots; ``nets[i][j]`` are the Bézier points over segment i of s and j of t. None for
    a degree below 0.
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
