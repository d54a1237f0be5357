"""Splines in two parameters: exact tensor-product B-splines, as needed in §6 of the paper (Chen, Riesenfeld and Cohen
2007).

A `TensorSpline` is immutable and scalar; a surface in space is a `Vector` of three, or a `Rational`. A spline that
depends on one parameter only is stored as a `BSpline`, so that nothing is computed per patch that can be computed per
segment.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import product
from math import comb
from operator import add as plus
from operator import mul as times
from operator import sub as minus
from typing import Any, ClassVar

from flint import fmpz, fmpz_mat, fmpz_poly

from exactspline.errors import FormulaError, ShapeError, as_instance, shown
from exactspline.hooks import FunctionsOutside
from exactspline.language.arguments import PARAMETERS, Curve, Pair
from exactspline.language.operand import CONSTANTS, Constant, Parameter, checked_order, refuse_letter
from exactspline.language.provenance import DIFFERENCE, MULTIPLE, PRODUCT, SUM, Provenance, leaf
from exactspline.language.rational import RingOperand
from exactspline.numbers.exact import Number, mpq, over_one_denominator, ratio, rational, to_fmpz
from exactspline.numbers.intervals import Box, Interval
from exactspline.numbers.once import Immutable, fill, setters
from exactspline.one_line import one_line, short_text
from exactspline.polynomials import tensor_bernstein
from exactspline.polynomials.bernstein import ONE, Form, common_denominators, raiser, value, without_content
from exactspline.polynomials.patch_forms import PatchForm
from exactspline.polynomials.tensor_bernstein import packed, rows
from exactspline.splines import blossom, refinement
from exactspline.splines.bspline import BSpline
from exactspline.splines.inputs import exact_row
from exactspline.splines.knots import SMOOTH, KnotVector, Mesh, clamped
from exactspline.splines.refinement import segmentwise
from exactspline.splines.tensor_patches import (
    Continuity,
    Degrees,
    Net,
    Profile,
    TensorParts,
    checked_degrees,
    checked_knots,
    checked_net,
    control_point_counts,
    letters_of,
    packed_segments,
    replaced,
    smooth,
    spread,
    with_names,
)

#: The directions of parameters: those of two curves, and those of a surface.
DIRECTION = {Parameter.FIRST: 0, Parameter.U: 0, Parameter.SECOND: 1, Parameter.V: 1}


def _transposed(c: fmpz_poly, stride: int, n: int, new: int) -> fmpz_poly:
    """The patch with its parameters exchanged: n is the degree in the original second parameter, `new` the stride of
    the result.
    """
    parts = [row.coeffs() for row in rows(c, stride, n)]
    height = max((len(row) for row in parts), default=0)
    return packed([fmpz_poly([row[i] if i < len(row) else 0 for row in parts]) for i in range(height)], new)


def _at_first(c: fmpz_poly, m: fmpz, degrees: tuple[int, int], stride: int, a: mpq) -> Form:
    """The form in the second parameter at the local value a of the first parameter."""
    values = [value((row, m), degrees[0], a) for row in rows(c, stride, degrees[1])]
    integers, common = over_one_denominator(values)
    return without_content((fmpz_poly(integers), fmpz(common)))


def _evaluated(c: fmpz_poly, m: fmpz, degrees: tuple[int, int], stride: int, a: mpq, b: mpq) -> mpq:
    """The value at the local parameters a and b."""
    return value(_at_first(c, m, degrees, stride, a), degrees[1], b) if min(degrees) >= 0 else mpq(0)


def _from_net(net: Sequence[Sequence[mpq]], stride: int) -> Form:
    """The patch with the Bézier points ``net[i][j]``."""
    m, n = len(net) - 1, len(net[0]) - 1
    scaled = [comb(m, i) * comb(n, j) * net[i][j] for j in range(n + 1) for i in range(m + 1)]
    integers, common = over_one_denominator(scaled)
    rows = [fmpz_poly(integers[k : k + m + 1]) for k in range(0, len(integers), m + 1)]
    return packed(rows, stride), fmpz(common)


def _bezier_net(form: Form, degrees: tuple[int, int], stride: int) -> list[list[mpq]]:
    """The Bézier points of a patch.

    >>> _bezier_net(_from_net([[mpq(1), mpq(2)], [mpq(3), mpq(4)]], 2), (1, 1), 2)
    [[mpq(1,1), mpq(2,1)], [mpq(3,1), mpq(4,1)]]
    """
    (c, common), (m, n) = form, degrees
    return [[ratio(c[i + stride * j], common * comb(m, i) * comb(n, j)) for j in range(n + 1)] for i in range(m + 1)]


def _changed_one(mesh: Mesh, change: Callable[[BSpline], BSpline]) -> BSpline:
    """The image of the constant 1 under a linear map of splines: its effect on splines that depend on the other
    parameter only.
    """
    return change(BSpline.from_forms(0, mesh, smooth(len(mesh)), [(fmpz_poly([1]), ONE)] * len(mesh)))


def _exchanged(meshes: tuple[Mesh, Mesh]) -> tuple[Mesh, Mesh]:
    """The meshes in the other order."""
    letters = letters_of(meshes)
    return with_names((meshes[1], meshes[0]), None if letters is None else (letters[1], letters[0]))


def _one_parameter(a: Profile | None, b: Profile | None) -> tuple[int, BSpline, BSpline] | None:
    """The direction and the splines of two profiles that depend on the same parameter only; a constant counts for
    either parameter.
    """
    if a is None or b is None:
        return None
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


def _bezier_nets(degrees: Degrees, along_s: Sequence[BSpline]) -> Iterator[Net]:
    """The Bézier nets of all patches, t running faster; `along_s` has a spline in s for each Bézier point along t."""
    n = degrees.t + 1
    segments = [spline.bezier_points for spline in along_s]
    for i, j in product(range(len(along_s[0].mesh)), range(len(along_s) // n)):
        yield [list(row) for row in zip(*[segments[j * n + k][i] for k in range(n)], strict=True)]


Points = tuple[tuple[mpq, ...], ...]


def _control_net(
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


class TensorSpline(Immutable, TensorParts, RingOperand, FunctionsOutside):
    """A scalar tensor-product B-spline in two parameters s and t, over a rectangle.

    `degrees`, knots and `control_points` are as for `BSpline`, in each direction. In ``control_points[i][j]`` the index
    i runs along s and j along t.

    >>> f = TensorSpline((1, 2), [0, 0, 1, 1], [0, 0, 0, 1, 1, 1], [[0, 0, 0], [0, 0, 4]])
    >>> f("1/2", "1/2"), tuple((f * f).degree), f.partial(0, 1)(1, "1/2")
    (mpq(1,2), (2, 4), mpq(4,1))

    Raises `ShapeError`, `KnotError` or `NumberError` with the place of the error.
    """

    equals_quotients: ClassVar[bool] = True
    __slots__ = ()

    def __init__(
        self,
        degrees: tuple[int, int],
        knots_s: Iterable[Number],
        knots_t: Iterable[Number],
        control_points: Iterable[Iterable[Number]],
    ) -> None:
        degree = checked_degrees(degrees)
        vectors = checked_knots(knots_s, degree.s, "knots_s"), checked_knots(knots_t, degree.t, "knots_t")
        net = checked_net(control_points, control_point_counts(vectors, degree), ("s", "t"), exact_row)
        along_t = [BSpline(degree.t, vectors[1], row) for row in net]
        bezier = zip(*[[x for part in row.bezier_points for x in part] for row in along_t], strict=True)
        along_s = [BSpline(degree.s, vectors[0], column) for column in bezier]
        stride = tensor_bernstein.stride_for(degree.s)
        numerators, denominators = zip(*[_from_net(net, stride) for net in _bezier_nets(degree, along_s)], strict=True)
        meshes, continuity = zip(*[(line[0].mesh, line[0].continuity) for line in (along_s, along_t)], strict=True)
        make(degree, meshes, continuity, stride, numerators, denominators, leaf(), self)

    def __reduce__(self) -> tuple[object, ...]:
        if self.profile is not None:
            return lifted, (self.profile[1], self.meshes, self.profile[0], self.stride)
        forms = tuple((tuple(map(int, c.coeffs())), int(m)) for c, m in zip(self.numerators, self.denominators))
        return _restored, (tuple(self.degree), self.meshes, self.continuity, self.stride, forms)

    # ---- representation

    @property
    def domain(self) -> Box:
        """The rectangle of definition, given by its two sides."""
        return Box(self.meshes[0].domain, self.meshes[1].domain)

    @property
    def knots(self) -> tuple[KnotVector, KnotVector]:
        """The clamped knots in each direction."""
        s, t = (clamped(mesh, c, n) for mesh, c, n in zip(self.meshes, self.continuity, self.degree, strict=True))
        return s, t

    @property
    def control_points(self) -> tuple[tuple[mpq, ...], ...]:
        """The control net over `knots`, with one row for each index along s."""
        points: tuple[tuple[mpq, ...], ...] | None = getattr(self, "_points", None)
        if points is None:
            nets = [[self.bezier_net(i, j) for j in range(len(self.meshes[1]))] for i in range(len(self.meshes[0]))]
            points = _control_net(self.knots, self.degree, self.meshes, nets)
            fill(self, _points=points)
        return points

    @property
    def control_point_counts(self) -> tuple[int, int]:
        """The numbers of control points along s and along t."""
        return (0, 0) if min(self.degree) < 0 else control_point_counts(self.knots, self.degree)

    def bezier_net(self, i: int, j: int) -> list[list[mpq]]:
        """Return the Bézier points of the patch over segment i of s and segment j of t."""
        at = i * len(self.meshes[1]) + j
        return _bezier_net((self.numerators[at], self.denominators[at]), self.degree, self.stride)

    def patch(self, i: int, j: int) -> Box:
        """Return the parameter rectangle of the patch over segment i of s and segment j of t."""
        first, second = (Interval(*mesh.breaks[k : k + 2]) for mesh, k in zip(self.meshes, (i, j), strict=True))
        return Box(first, second)

    def patch_form(self, i: int, j: int) -> PatchForm:
        """Return the polynomial of the patch over segment i of s and segment j of t, up to a positive constant.

        >>> f = TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[0, "1/2"], [1, 2]])
        >>> f.patch_form(0, 0).entries
        [0, 1, 2, 4]
        """
        net = self.bezier_net(i, j) if min(self.degree) >= 0 else [[mpq(0)]]
        integers, _ = over_one_denominator([x for row in net for x in row])
        return PatchForm(fmpz_mat(len(net), len(net[0]), integers))

    @one_line
    def __repr__(self) -> str:
        (a, b), (c, d) = (map(short_text, side) for side in self.domain)
        return f"<TensorSpline of degree {self.degree.s} × {self.degree.t} over [{a}, {b}] × [{c}, {d}]>"

    # ---- arithmetic

    def constant(self, number: Number) -> TensorSpline:
        """Return the constant function of degree 0 × 0 on this rectangle."""
        a, b = self.meshes[0].domain
        return lifted(refinement.over(BSpline.identity(a, b).constant(number), self.meshes[0]), self.meshes, 0)

    def __add__(self, other: TensorSpline | Constant) -> TensorSpline:
        return self._sum(other, plus, SUM)

    def __sub__(self, other: TensorSpline | Constant) -> TensorSpline:
        return self._sum(other, minus, DIFFERENCE)

    def _sum(self, other: object, operation: Callable[[Any, Any], Any], name: int) -> TensorSpline:
        right = other if type(other) is TensorSpline else self.coerced(other)
        if right is None:
            refused: TensorSpline = NotImplemented
            return refused
        a, b = (self, right) if self.meshes is right.meshes else aligned(self, right)
        stride = a.stride if a.stride >= b.stride else b.stride
        if shared := _one_parameter(a.profile, b.profile):
            return lifted(operation(shared[1], shared[2]), a.meshes, shared[0], stride)
        degree = a.degree
        if degree == b.degree:
            p, q = a.at_stride(stride), b.at_stride(stride)
        else:
            degree = degree.max(b.degree)
            p, q = _elevated(a, degree, stride), _elevated(b, degree, stride)
        denominators = a.denominators
        if denominators != b.denominators:
            p, q, denominators = common_denominators(p, denominators, q, b.denominators)
        continuity = a.continuity if a.continuity == b.continuity else _lower(a, b)
        return make(
            degree,
            a.meshes,
            continuity,
            stride,
            segmentwise(operation, p, q),
            denominators,
            (name, self.provenance, right.provenance),
        )

    def __mul__(self, other: TensorSpline | Constant) -> TensorSpline:
        if type(other) is not TensorSpline:
            return self.scaled(other) if isinstance(other, CONSTANTS) else NotImplemented
        a, b = (self, other) if self.meshes is other.meshes else aligned(self, other)
        stride = a.stride if a.stride >= b.stride else b.stride
        if shared := _one_parameter(a.profile, b.profile):
            return lifted(shared[1] * shared[2], a.meshes, shared[0], stride)
        (m, n), (k, h) = a.degree, b.degree
        if m + k >= stride:
            stride = tensor_bernstein.stride_for(m + k)
        p, q = a.at_stride(stride), b.at_stride(stride)
        return make(
            _tuple(Degrees, (m + k, n + h)),
            a.meshes,
            a.continuity if a.continuity == b.continuity else _lower(a, b),
            stride,
            segmentwise(times, p, q),
            segmentwise(times, a.denominators, b.denominators),
            (PRODUCT, self.provenance, other.provenance),
        )

    def scaled(self, constant: Number) -> TensorSpline:
        """The spline times an exact constant."""
        if self.profile is not None:
            return lifted(self.profile[1].scaled(constant), self.meshes, self.profile[0], self.stride)
        q = rational(constant)
        top, bottom = to_fmpz(q.numerator), to_fmpz(q.denominator)
        denominators = self.denominators if bottom == 1 else tuple([m * bottom for m in self.denominators])
        polynomials = self.numerators if top == 1 else tuple([c * top for c in self.numerators])
        provenance = (MULTIPLE, self.provenance, q)
        return make(self.degree, self.meshes, self.continuity, self.stride, polynomials, denominators, provenance)

    def d(self, order: int = 1, *, by: str | None = None) -> TensorSpline:
        """Return the derivative with respect to the parameter with this name: u or v on a surface, s or s̄ on two
        curves, any of these names for other splines. The name may be omitted for a spline that depends on one parameter
        only. Raises `FormulaError` for another name.
        """
        if by is not None:
            if by not in DIRECTION:
                raise FormulaError(
                    f"a derivative with respect to {by!r}", remedy=f"the parameters are {', '.join(DIRECTION)}"
                )
            letters = letters_of(self.meshes)
            if letters is not None:
                refuse_letter(by, letters)
            direction = DIRECTION[Parameter(by)] if letters is None else letters.index(by)
            return self.partial(0, order) if direction else self.partial(order, 0)
        if self.profile is None:
            first, second = letters_of(self.meshes) or PARAMETERS
            raise FormulaError(
                "a derivative of a spline in two parameters",
                remedy=f"name the parameter: d(1, by={str(first)!r}) or d(1, by={str(second)!r})",
            )
        return lifted(self.profile[1].d(order), self.meshes, self.profile[0], self.stride)

    def partial(self, i: int, j: int) -> TensorSpline:
        """Return the derivative of order i with respect to s and of order j with respect to t. For orders above the
        degree this is the constant 0.

        >>> s = TensorSpline((1, 0), [0, 0, 1, 1], [0, 1], [[0], [1]])
        >>> (s * s * s).partial(2, 0)("1/2", 1), s.partial(0, 1).is_zero
        (mpq(3,1), True)
        """
        i, j = checked_order(i), checked_order(j)
        if any(0 <= degree < order for degree, order in zip(self.degree, (i, j), strict=True)):
            return self.constant(0)
        found = self
        for direction in (0,) * i + (1,) * j:
            found = found._slope(direction)
        return found

    def _slope(self, direction: int) -> TensorSpline:
        """The derivative by one parameter."""
        direct = self.profile is None and self.degree[direction] > 0
        return make(*self._derived(direction), leaf()) if direct else self.along(direction, lambda f: f.d())

    def elevated_to(self, other: TensorSpline) -> TensorSpline:
        """Return the same function with at least the degree of `other` in each direction."""
        by = [max(theirs - own, 0) for own, theirs in zip(self.degree, other.degree, strict=True)]
        return self.elevate_degree(*by)

    # ---- the function

    def __call__(self, s: Number, t: Number) -> mpq:
        """Return the exact value at two parameters; at a jump, the limit from the right (at the end of the domain, from
        the left).

        Raises `DomainError` outside the rectangle.
        """
        s, t = rational(s), rational(t)
        i, j = self.meshes[0].locate(s), self.meshes[1].locate(t)
        at = i * len(self.meshes[1]) + j
        place = self.meshes[0].local(i, s), self.meshes[1].local(j, t)
        return _evaluated(self.numerators[at], self.denominators[at], self.degree, self.stride, *place)

    def at_t(self, t: Number) -> BSpline:
        """Return this function at a fixed t, as a spline in s."""
        t, forms = rational(t), []
        for own in self._lines():
            integers, common = over_one_denominator([line(t) for line in own])
            forms.append(without_content((fmpz_poly(integers), fmpz(common))))
        return BSpline.from_forms(self.degree.s, self.meshes[0], self.continuity[0], forms)

    def at_s(self, s: Number) -> BSpline:
        """Return this function at a fixed s, as a spline in t."""
        return self.transposed().at_t(s)

    @property
    def is_zero(self) -> bool:
        """Whether the function is identically zero."""
        return not any(self.numerators)

    def __eq__(self, other: object) -> bool:
        """Whether both are the same function on the same rectangle, whatever their knots and degrees."""
        if not isinstance(other, TensorSpline):
            return NotImplemented
        return self is other or (self.domain == other.domain and bool((self - other).is_zero))

    def __hash__(self) -> int:
        return self.hash_of_quotient(self)

    @property
    def vanishes_somewhere(self) -> bool:
        """Whether the function is identically zero on at least one patch."""
        return not all(self.numerators)

    def hash_of_quotient(self, numerator: TensorSpline) -> int:
        """Return a hash of the rectangle, which is the same for equal quotients."""
        return hash((TensorSpline, self.domain))

    # ---- other representations and parts, as for `BSpline`, in either direction

    def along(self, direction: int, change: Callable[[BSpline], BSpline]) -> TensorSpline:
        """Return the spline with a linear map of splines applied along the direction of s (0) or of t (1)."""
        if direction not in (0, 1):
            raise ShapeError(f"the direction {shown(direction)}", remedy="0 for s or 1 for t")
        if self.profile is not None:
            own, spline = self.profile
            if own != direction:
                other = _changed_one(self.meshes[direction], change)
                meshes = replaced(self.meshes, direction, other.mesh)
                return lifted(spline, meshes, own, self.stride) * lifted(other, meshes, direction)
            spline = change(spline)
            return lifted(spline, replaced(self.meshes, direction, spline.mesh), direction, self.stride)
        if direction == 0:
            return self.transposed().along(1, change).transposed()
        return make(*self._with_lines([[change(line) for line in own] for own in self._lines()]), leaf())

    def elevate_degree(self, by_s: int = 0, by_t: int = 0) -> TensorSpline:
        """Return the same function with the degrees raised."""
        first = self.along(0, lambda f: f.elevate_degree(by_s)) if by_s else self
        return first.along(1, lambda f: f.elevate_degree(by_t)) if by_t else first

    def reduce_degree(self, by_s: int = 0, by_t: int = 0) -> TensorSpline:
        """Return the same function with lower degrees. Raises `ReductionError` if this is not possible exactly."""
        if (parts := self._lowered(by_s, by_t)) is not None:
            return make(*parts, leaf())
        return self.along(0, lambda f: f.reduce_degree(by_s)).along(1, lambda f: f.reduce_degree(by_t))

    def insert_knot(self, direction: int, t: Number, times: int = 1) -> TensorSpline:
        """Return the same function with an additional knot in one direction."""
        return self.along(direction, lambda f: f.insert_knot(t, times))

    def restrict(self, side_s: tuple[Number, Number], side_t: tuple[Number, Number]) -> TensorSpline:
        """Return the part of the spline over a smaller rectangle."""
        return self.along(0, lambda f: f.restrict(*side_s)).along(1, lambda f: f.restrict(*side_t))

    def transposed(self) -> TensorSpline:
        """Return the spline with its parameters exchanged."""
        meshes, continuity = _exchanged(self.meshes), (self.continuity[1], self.continuity[0])
        if self.profile is not None:
            return lifted(self.profile[1], meshes, 1 - self.profile[0])
        degree, stride = Degrees(self.degree.t, self.degree.s), tensor_bernstein.stride_for(self.degree.t)
        order = [i * len(meshes[0]) + j for j in range(len(meshes[0])) for i in range(len(meshes[1]))]
        own, denominators = self.numerators, self.denominators
        polynomials = tuple(_transposed(own[k], self.stride, self.degree.t, stride) for k in order)
        return make(degree, meshes, continuity, stride, polynomials, tuple(denominators[k] for k in order), leaf())


_new, _tuple = object.__new__, tuple.__new__
_set_degree, _set_meshes, _set_continuity, _set_stride, _set_profile, _set_provenance = setters(
    TensorParts, "degree", "meshes", "continuity", "stride", "profile", "provenance"
)
_set_packed, _set_denominators = setters(TensorParts, "_packed", "_denominators")


def make(
    degree: Degrees,
    meshes: tuple[Mesh, Mesh],
    continuity: Continuity,
    stride: int,
    polynomials: tuple[fmpz_poly, ...],
    denominators: tuple[fmpz, ...],
    provenance: Provenance,
    made: TensorSpline | None = None,
) -> TensorSpline:
    """The spline with these packed polynomials, set in `made` if one is given; the caller is responsible for the
    continuity.
    """
    spline: TensorSpline = _new(TensorSpline) if made is None else made
    _set_degree(spline, degree)
    _set_meshes(spline, meshes)
    _set_continuity(spline, continuity)
    _set_stride(spline, stride)
    _set_provenance(spline, provenance)
    _set_packed(spline, {stride: polynomials})
    _set_denominators(spline, denominators)
    _set_profile(spline, None)
    return spline


def _restored(
    degree: tuple[int, int],
    meshes: tuple[Mesh, Mesh],
    continuity: Continuity,
    stride: int,
    forms: tuple[tuple[tuple[int, ...], int], ...],
) -> TensorSpline:
    """The unpickled spline, with a new provenance."""
    polynomials, denominators = zip(*[(fmpz_poly(list(c)), fmpz(m)) for c, m in forms], strict=True)
    return make(Degrees(*degree), meshes, continuity, stride, polynomials, denominators, leaf())


def _elevated(f: TensorSpline, degree: Degrees, stride: int) -> tuple[fmpz_poly, ...]:
    """The packed polynomials, raised to a degree."""
    if f.degree == degree:
        return f.at_stride(stride)
    lift = raiser(degree.s - f.degree.s) * raiser(degree.t - f.degree.t).inflate(stride)
    if f.profile is None:
        return tuple([c * lift for c in f.at_stride(stride)])
    return spread(tuple([c * lift for c in packed_segments(f.profile, stride)]), f.profile[0], f.meshes)


def _lower(a: TensorSpline, b: TensorSpline) -> tuple[tuple[int, ...], tuple[int, ...]]:
    s, t = (tuple(map(min, x, y)) for x, y in zip(a.continuity, b.continuity, strict=True))
    return s, t


def aligned(*splines: TensorSpline) -> list[TensorSpline]:
    """All splines over the union of their breakpoints."""
    meshes = splines[0].meshes
    for f in splines[1:]:
        if f.meshes is not meshes:
            first, second = (m if m.breaks == n.breaks else m.union(n) for m, n in zip(meshes, f.meshes, strict=True))
            meshes = replaced(replaced(meshes, 0, first), 1, second)
    return [_over(f, meshes) for f in splines]


def _over(f: TensorSpline, meshes: tuple[Mesh, Mesh]) -> TensorSpline:
    if f.meshes is meshes or all(m.breaks == n.breaks for m, n in zip(f.meshes, meshes, strict=True)):
        return f
    if f.profile is not None:
        return lifted(refinement.over(f.profile[1], meshes[f.profile[0]]), meshes, f.profile[0], f.stride)
    return f.along(0, lambda g: refinement.over(g, meshes[0])).along(1, lambda g: refinement.over(g, meshes[1]))


def lifted(spline: BSpline, meshes: tuple[Mesh, Mesh], direction: int, stride: int = 1) -> TensorSpline:
    """A spline in one parameter as a spline in two parameters: direction 0 if the parameter is s, 1 if it is t.

    The stride is large enough for later products.

    >>> f = BSpline.bezier([0, 0, 1])
    >>> lifted(f, (f.mesh, Mesh([mpq(0), mpq(1)])), 0)("1/2", "1/3")
    mpq(1,4)
    """
    n, made = spline.degree, _new(TensorSpline)
    if direction == 0:
        _set_degree(made, _tuple(Degrees, (n, 0)))
        _set_continuity(made, (spline.continuity, smooth(len(meshes[1].widths))))
        stride = stride if n < stride else tensor_bernstein.stride_for(n)
    else:
        _set_degree(made, _tuple(Degrees, (0, n)))
        _set_continuity(made, (smooth(len(meshes[0].widths)), spline.continuity))
    _set_meshes(made, meshes)
    _set_stride(made, stride)
    _set_provenance(made, spline.provenance)
    _set_packed(made, {})
    _set_denominators(made, None)
    _set_profile(made, (direction, spline))
    return made


#: In the polynomial forms of §6 of the paper the degrees in each parameter are below this multiple of the degree of the
#: curve.
BISECTOR_ROOM = 4


def surface_pair(first: Curve[BSpline], second: Curve[BSpline]) -> Pair[TensorSpline]:
    """Return the argument for formulas of two curves, whose values are splines in the parameters of both curves.

    >>> from exactspline.interchange.examples import example
    >>> c = surface_pair(example("twisted_cubic"), example("rational_space_cubic"))
    >>> tuple((c.first.p[0] * c.second.w).degree)
    (3, 3)
    """
    for each in (first, second):
        as_instance(each, Curve, "a curve", 'give a Nurbs, such as exactspline.example("cusp")')
    meshes, room = with_names((first.w.mesh, second.w.mesh), PARAMETERS), max(BISECTOR_ROOM * first.p.degree, 1)
    return Pair(first.mapped(lambda f: lifted(f, meshes, 0, room)), second.mapped(lambda f: lifted(f, meshes, 1, room)))
