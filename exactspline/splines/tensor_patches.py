"""The parts of a spline in two parameters: packed polynomials, patch by patch; a spline in one parameter, if it depends
on this parameter only; and lines of splines in one parameter, so that every operation of `BSpline` is available in
either direction.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import cache
from typing import NamedTuple, TypeVar, cast

from flint import fmpz, fmpz_poly

from exactspline.errors import ExactSplineError, ShapeError, counted, shown
from exactspline.language.provenance import Provenance
from exactspline.numbers.exact import Number, mpq
from exactspline.polynomials import tensor_bernstein
from exactspline.polynomials.bernstein import over_common_denominator, raiser, without_content
from exactspline.polynomials.tensor_bernstein import packed, rows
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


def _repacked(c: fmpz_poly, old: int, new: int) -> fmpz_poly:
    """The same patch with another stride."""
    if old == new or c.degree() < old:
        return c
    return c.inflate(new) if old == 1 else packed(rows(c, old, c.degree() // old), new)


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
                found = tuple(_repacked(c, self.stride, stride) for c in self.numerators)
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

    def _derived(self, direction: int) -> Parts:
        """The parts of the derivative by one parameter (0: the first), in which the degree must be positive."""
        polynomials = [_derivative(c, self.stride, self.degree, direction) for c in self.numerators]
        denominators = self.denominators
        if not self.meshes[direction].unit:
            widths = spread(self.meshes[direction].widths, direction, self.meshes)
            polynomials = [c * bottom for c, (_, bottom) in zip(polynomials, widths, strict=True)]
            denominators = tuple([m * top for m, (top, _) in zip(denominators, widths, strict=True)])
        (m, n), (s, t) = self.degree, self.continuity
        lower = tuple([max(c - 1, -1) for c in self.continuity[direction]])
        degree, continuity = (Degrees(m, n - 1), (s, lower)) if direction else (Degrees(m - 1, n), (lower, t))
        return degree, self.meshes, continuity, self.stride, tuple(polynomials), denominators

    @property
    def true_degree(self) -> Degrees:
        """The largest degree in each parameter of the polynomials of the patches (−1 for zero)."""
        if not any(self.numerators):
            return Degrees(-1, -1)
        m, n = self.degree
        in_s = (row for c in self.numerators for row in rows(c, self.stride, n))
        in_t = (column for c in self.numerators for column in _columns(c, self.stride, m))
        return Degrees(m - _multiplicity(in_s), n - _multiplicity(in_t))

    def _lowered(self, by_s: int, by_t: int) -> Parts | None:
        """The parts of the same function with the degrees lowered; None if the function is zero, if it has more than
        one patch (knots may be smooth afterwards), or if the degrees cannot be lowered that much.
        """
        true, (m, n) = self.true_degree, self.degree
        degree = Degrees(m - by_s, n - by_t)
        if len(self.denominators) > 1 or min(by_s, by_t, *true) < 0 or degree.max(true) != degree:
            return None
        c, below = without_content(
            (_without_powers(self.numerators[0], self.stride, (by_s, by_t)), self.denominators[0])
        )
        return degree, self.meshes, self.continuity, self.stride, (c,), (below,)

    def _lines(self) -> list[list[BSpline]]:
        """For each segment of s and each power of its local parameter the coefficients, as splines in t."""
        columns, own = len(self.meshes[1]), self.numerators
        found = []
        for i in range(len(self.meshes[0])):
            patches = range(i * columns, (i + 1) * columns)
            nets = [tensor_bernstein.rows(own[k], self.stride, self.degree.t) for k in patches]
            lines = []
            # for a degree below 0 one line of zeros, so that there is a line to change
            for h in range(max(self.degree.s, 0) + 1):
                forms = [
                    without_content((fmpz_poly([row[h] for row in net]), self.denominators[k]))
                    for k, net in zip(patches, nets, strict=True)
                ]
                lines.append(BSpline.from_forms(self.degree.t, self.meshes[1], self.continuity[1], forms))
            found.append(lines)
        return found

    def _with_lines(self, found: list[list[BSpline]]) -> Parts:
        """Degree, meshes, continuity, stride, packed polynomials and denominators of the spline with these lines;
        along s it is as this spline.
        """
        first, stride = found[0][0], tensor_bernstein.stride_for(self.degree.s)
        polynomials, denominators = [], []
        for own in found:
            for j in range(len(first.mesh)):
                rows, denominator = over_common_denominator(
                    [(line.numerators[j], line.denominators[j]) for line in own]
                )
                polynomials.append(
                    tensor_bernstein.packed(
                        [fmpz_poly([row[k] for row in rows]) for k in range(first.degree + 1)], stride
                    )
                )
                denominators.append(denominator)
        continuity = (self.continuity[0], first.continuity)
        return (
            Degrees(self.degree.s, first.degree),
            replaced(self.meshes, 1, first.mesh),
            continuity,
            stride,
            tuple(polynomials),
            tuple(denominators),
        )


Z_MINUS_1 = fmpz_poly([-1, 1])


def _derivative(c: fmpz_poly, stride: int, degrees: tuple[int, int], direction: int) -> fmpz_poly:
    """``∂v − ∂u`` in one direction (0: the first parameter) of a patch of positive degree there.

    >>> _derivative(fmpz_poly([1, 2, 3, 4]), 2, (1, 1), 1)  # 1 + 2x + (3 + 4x) y: the difference of two rows
    2*x + 2
    """
    (m, n), a = degrees, c.coeffs()
    a += [fmpz(0)] * (stride * (n + 1) - len(a))
    if direction:
        return fmpz_poly([(k // stride + 1) * a[k + stride] + (k // stride - n) * a[k] for k in range(stride * n)])
    places = [(k, k % stride) for k in range(stride * (n + 1))]
    return fmpz_poly([(i + 1) * a[k + 1] + (i - m) * a[k] if i < m else 0 for k, i in places])


def _columns(c: fmpz_poly, stride: int, m: int) -> list[fmpz_poly]:
    """The forms in the second parameter, one per power of the first.

    >>> _columns(fmpz_poly([1, 2, 3, 4]), 2, 1)
    [3*x + 1, 4*x + 2]
    """
    coefficients = c.coeffs()
    return [fmpz_poly(coefficients[i::stride]) for i in range(m + 1)]


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


def _without_powers(c: fmpz_poly, stride: int, by: tuple[int, int]) -> fmpz_poly:
    """A patch divided by powers of ``u + v`` and ``ū + v̄``, which must divide it.

    >>> _without_powers(fmpz_poly([1, 1, 1, 1]), 2, (0, 1))  # (1 + x)(1 + y)
    x + 1
    """
    for times, gap in zip(by, (1, stride), strict=True):
        if times:
            c = c // raiser(times).inflate(gap)
    return c


# ---- the control net


Net = list[list[mpq]]
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
