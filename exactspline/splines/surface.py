"""The concrete surface: degrees, knots, net, weights, and the operands ``p``, ``w`` that formulas use. Whether the
denominator keeps its sign is decided exactly, patch by patch.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from enum import StrEnum
from functools import partial
from itertools import product
from math import comb

from exactspline.errors import ExactSplineError, ShapeError, WeightError, counted, shown
from exactspline.hooks import FunctionsOutside
from exactspline.language.operand import checked_order
from exactspline.language.rational import Rational
from exactspline.language.surface_kind import BOTH, Surface
from exactspline.language.vector import Vector, cross
from exactspline.numbers.exact import Number, mpq, rational
from exactspline.numbers.intervals import UNIT, Box
from exactspline.numbers.once import Immutable, fill
from exactspline.numbers.search import Search
from exactspline.one_line import one_line
from exactspline.polynomials.patch_forms import PatchForm, Sized, halved
from exactspline.reals.real import Real
from exactspline.splines.bspline import BSpline
from exactspline.splines.common import mapped, same_quotients, with_common_knots
from exactspline.splines.control_points import Point, exact_points, exact_weights, lifted, projected
from exactspline.splines.knots import KnotVector, Mesh
from exactspline.splines.nurbs import Nurbs, normalized
from exactspline.splines.tensor import TensorSpline, make
from exactspline.splines.tensor_patches import (
    checked_degrees,
    checked_knots,
    checked_net,
    control_point_counts,
    with_names,
)
from exactspline.words import choice

#: The limit of boxes on one patch before the search stops.
BOXES = 4000
#: Halvings until the box of a zero is small enough to be reported.
DEPTH = 16


def _check_weight(w: TensorSpline) -> None:
    """Raise `WeightError` unless the denominator has one sign on its closed rectangle, including one-sided limits at
    jumps.

    The ``witness`` of the error is a box that contains a zero (a point if the ends of its sides agree), or a box that
    is too small to be decided.
    """
    sign = 0
    for i, j in product(range(len(w.meshes[0])), range(len(w.meshes[1]))):
        found = _sign_or_box(w.patch_form(i, j))
        if not isinstance(found, int):
            box, certain = found
            raise _zero(w.patch(i, j).part(box), certain)
        if sign and found != sign:
            place = w.patch(i, j)
            problem = f"the denominator w changes sign by a jump into the patch {place}"
            raise WeightError(problem, where="weights", remedy="w must keep its sign on the domain", witness=place)
        sign = found


def _sign_or_box(form: PatchForm) -> int | tuple[Box, bool]:
    """The sign on the closed square, or a box and whether it certainly contains a zero."""
    sign = 0
    search = Search([Sized(UNIT, [form])])
    for part in search:
        if search.seen > BOXES:
            return part.box, False
        if place := zero_at_corners(part, search.depth):
            return place, True
        sign = 1 if part.forms[0].corners[0] > 0 else -1
        if part.forms[0].sign is None:
            search.split(halved(part))
    return sign


def zero_at_corners(part: Sized, depth: int = 0) -> Box | None:
    """A corner of a part that is a zero, or a small box between corners of both signs, which contains a zero."""
    for value, (x, y) in zip(part.forms[0].corners, product(*part.box), strict=True):
        if value == 0:
            return Box.point(x, y)
    if not _crosses(part):
        return None
    if depth >= DEPTH:
        return part.box
    # a half has corners of both signs, or a corner that is a zero
    first, second = halved(part)
    return zero_at_corners(first if _crosses(first) or 0 in first.forms[0].corners else second, depth + 1)


def _crosses(part: Sized) -> bool:
    """Whether the corners have both signs."""
    corners = part.forms[0].corners
    return min(corners) < 0 < max(corners)


def _zero(box: Box, certain: bool) -> WeightError:
    where = f"at {box}" if all(a == b for a, b in box) else f"where {box}"
    found = "has a zero" if certain else "could not be shown to be without a zero"
    problem = f"the denominator w {found} {where}"
    return WeightError(problem, where="weights", remedy="w must keep its sign on the domain", witness=box)


#: Control points in rows along u.
Net = tuple[tuple[Point, ...], ...]
Weights = tuple[tuple[mpq, ...], ...]


class Along(StrEnum):
    """One of the two parameters of a surface."""

    U = "u"
    V = "v"

    @property
    def direction(self) -> int:
        """The number of the parameter: 0 for u, 1 for v."""
        return 0 if self is Along.U else 1


class NurbsSurface(Immutable, Surface[TensorSpline], FunctionsOutside):
    """A polynomial or rational tensor-product B-spline surface with exact data.

    ``control_points[i][j]``, with i along u and j along v, are Cartesian points of the same dimension, or `Direction`
    objects; `weights` are a net of the same shape, or None. With the points P_ij, the weights w_ij and the basis
    functions N_i, N_j, the surface is ``Σ w_ij P_ij N_i(u) N_j(v) / Σ w_ij N_i(u) N_j(v)``. Equal weights mean that the
    surface is polynomial: `polynomial` is true, and the denominator ``w`` is the constant 1.

    >>> saddle = NurbsSurface((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]])
    >>> saddle("1/2", "1/3"), saddle.partial(1, 1, 0, 0)
    ((mpq(1,2), mpq(1,3), mpq(1,6)), (mpq(0,1), mpq(0,1), mpq(1,1)))

    A surface never changes, and ``==`` tests whether two surfaces are the same function.

    >>> saddle == saddle.insert_knot("u", "1/3").elevate_degree(0, 2), saddle == saddle.transposed().transposed()
    (True, True)

    Raises `ShapeError`, `KnotError` or `NumberError` with the place of the error, and `WeightError`, with the place, if
    the denominator has a zero on the domain.
    """

    #: The degrees in u and v.
    degree: tuple[int, int]
    knots: tuple[KnotVector, KnotVector]
    #: The control points in rows along u: tuples of coordinates, or a `Direction`.
    control_points: Net
    weights: Weights
    name: str
    source: str
    note: str
    p: Vector[TensorSpline]
    w: TensorSpline
    #: The surface as ``p``, or as the `Rational` ``p/w``.
    S: Vector[TensorSpline] | Rational[TensorSpline]
    #: Whether all weights are equal.
    polynomial: bool

    def __init__(
        self,
        degree: tuple[int, int],
        knots_u: Iterable[Number],
        knots_v: Iterable[Number],
        control_points: Iterable[Iterable[Iterable[Number]]],
        weights: Iterable[Iterable[Number]] | None = None,
        *,
        name: str = "",
        source: str = "",
        note: str = "",
    ) -> None:
        m, n = checked_degrees(degree)
        degrees = m, n
        vectors = checked_knots(knots_u, m, "knots_u"), checked_knots(knots_v, n, "knots_v")
        net = _checked_net(control_points, control_point_counts(vectors, degrees))
        scale = _checked_weights(weights, net)
        first = scale[0][0]
        polynomial = first != 0 and all(x == first for row in scale for x in row)
        p, w = _splines(degrees, vectors, net, None if polynomial else scale)
        fill(
            self,
            **vars(Surface(p, w, polynomial=polynomial)),
            degree=degrees,
            knots=vectors,
            control_points=net,
            weights=scale,
            name=name,
            source=source,
            note=note,
        )

    @classmethod
    def from_splines(
        cls, p: Iterable[TensorSpline], w: TensorSpline | None = None, *, name: str = "", note: str = ""
    ) -> NurbsSurface:
        """Return the surface ``p/w`` (or ``p``) with these splines as components, which may have different degrees and
        knots.

        >>> u = TensorSpline((1, 0), [0, 0, 1, 1], [0, 2], [[0], [1]])
        >>> v = TensorSpline((0, 1), [0, 1], [0, 0, 2, 2], [[0, 2]])
        >>> NurbsSurface.from_splines([u, v, u * v])(1, "1/2")
        (mpq(1,1), mpq(1,2), mpq(1,2))
        """
        splines = with_common_knots([*p, *([] if w is None else [w])])
        nets = [f.control_points for f in splines]
        rows = [list(zip(*[net[i] for net in nets], strict=True)) for i in range(len(nets[0]))]
        degree, (knots_u, knots_v) = tuple(splines[0].degree), splines[0].knots
        weights = None
        if w is not None:
            weights = [[point[-1] for point in row] for row in rows]
            rows = [[projected(point) for point in row] for row in rows]
        return cls((degree[0], degree[1]), knots_u, knots_v, rows, weights, name=name, note=note)

    # ---- a value

    def __reduce__(self) -> tuple[object, ...]:
        named = partial(NurbsSurface, name=self.name, source=self.source, note=self.note)
        return named, (self.degree, *self.knots, self.control_points, self.weights)

    def __eq__(self, other: object) -> bool:
        """Whether both are the same function on the same rectangle, whatever their knots, degrees and weights."""
        if not isinstance(other, NurbsSurface):
            return NotImplemented
        return self is other or same_quotients(self.p, self.w, other.p, other.w)

    def __hash__(self) -> int:
        (a, b), (c, d) = self.domain
        places = [(a + (b - a) * mpq(i, 3), c + (d - c) * mpq(j, 4)) for i in range(3) for j in range(3)]
        return hash((self.domain, *[self(u, v) for u, v in places]))

    @one_line
    def __repr__(self) -> str:
        kind = "polynomial" if self.polynomial else "rational"
        (m, n), net = self.degree, self.control_points
        points = f"{len(net)} × {len(net[0])} control points in R{self.dimension}"
        return f"<NurbsSurface {self.name or 'surface'}: {kind}, degree {m} × {n}, {points}>"

    # ---- the surface

    @property
    def domain(self) -> Box:
        """The rectangle of parameters, given by its two sides."""
        return self.w.domain

    @property
    def meshes(self) -> tuple[Mesh, Mesh]:
        """The distinct knots of the domain, for each parameter."""
        return self.w.meshes

    @property
    def patches(self) -> tuple[int, int]:
        """The numbers of polynomial or rational patches along u and along v."""
        return len(self.meshes[0]), len(self.meshes[1])

    def __call__(self, u: Number, v: Number) -> tuple[mpq, ...]:
        """Return the exact point at a pair of parameters; at a jump, the limit from the right.

        Raises `DomainError` outside the rectangle.
        """
        w = self.w(u, v)
        return tuple(x(u, v) / w for x in self.p)

    def at(self, u: Number, v: Number) -> tuple[mpq, ...]:
        """Return the same exact point as a call of the surface."""
        return self(u, v)

    def partial(self, i: int, j: int, u: Number, v: Number) -> tuple[mpq, ...]:
        """Return the exact derivative of order i with respect to u and of order j with respect to v at a pair of
        parameters; at a knot, the limit from the right.

        >>> f = NurbsSurface((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[(0, 0), (0, 1)], [(1, 0), (1, 1)]],
        ...                  [[1, 1], [1, 2]])
        >>> f.partial(1, 0, 1, 1)
        (mpq(1,2), mpq(0,1))

        Raises `FormulaError` for a negative order, `DomainError` outside the rectangle.
        """
        i, j = checked_order(i), checked_order(j)
        u, v = rational(u), rational(v)
        places = [(k, h) for k in range(i + 1) for h in range(j + 1)]
        weights = {(k, h): self.w.partial(k, h)(u, v) for k, h in places}
        found: dict[tuple[int, int], list[mpq]] = {}
        for k, h in places:
            # (w S) differentiated by Leibniz' rule in both parameters
            row = [x.partial(k, h)(u, v) for x in self.p]
            for (a, b), earlier in found.items():
                if a <= k and b <= h:
                    factor = comb(k, a) * comb(h, b) * weights[k - a, h - b]
                    row = [x - factor * y for x, y in zip(row, earlier, strict=True)]
            found[k, h] = [mpq(x / weights[0, 0]) for x in row]
        return tuple(found[i, j])

    def normal(self, u: Number, v: Number) -> tuple[Real, ...]:
        """Return the unit normal ``S_u × S_v/‖S_u × S_v‖`` of a surface in space at a pair of parameters, exactly.

        >>> f = NurbsSurface((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]])
        >>> f.normal(0, 0)
        (<Real 0>, <Real 0>, <Real 1>)

        Raises `DomainError` where there is no tangent plane, `ShapeError` for a surface that is not in space.
        """
        if self.dimension != 3:
            raise ShapeError(f"the normal of a surface in R{self.dimension}", remedy="it is defined in space")
        upright = cross(Vector(*self.partial(1, 0, u, v)), Vector(*self.partial(0, 1, u, v)))
        return normalized(upright.components, f"no tangent plane at {rational(u)}, {rational(v)}")

    def isocurve(self, along: Along | str, at: Number) -> Nurbs:
        """Return the curve on the surface along which one parameter is fixed.

        >>> f = NurbsSurface((1, 1), [0, 0, 1, 1], [0, 0, 2, 2], [[(0, 0), (0, 1)], [(1, 0), (1, 1)]])
        >>> f.isocurve("u", 1).control_points
        ((mpq(0,1), mpq(1,2)), (mpq(1,1), mpq(1,2)))

        Raises `DomainError` for a value outside the domain.
        """
        of_u = choice(Along, along, "parameter") is Along.U

        def line(f: TensorSpline) -> BSpline:
            return f.at_t(at) if of_u else f.at_s(at)

        held = f"{Along.V if of_u else Along.U} = {rational(at)}"
        return Nurbs.from_splines(
            [line(x) for x in self.p], None if self.polynomial else line(self.w), name=f"{self.name} {held}".strip()
        )

    # ---- other representations, parts, images

    def insert_knot(self, along: Along | str, t: Number, times: int = 1) -> NurbsSurface:
        """Return the same surface with an additional knot in one parameter.

        Raises `DomainError` outside the domain and at its ends, `KnotError` if the multiplicity would exceed degree +
        1.
        """
        direction = choice(Along, along, "parameter").direction
        return self._changed(lambda f: f.insert_knot(direction, t, times))

    def elevate_degree(self, by_u: int = 1, by_v: int = 1) -> NurbsSurface:
        """Return the same surface with the degrees raised."""
        return self._changed(lambda f: f.elevate_degree(by_u, by_v))

    def split(self, along: Along | str, t: Number) -> tuple[NurbsSurface, NurbsSurface]:
        """Return the two parts of the surface before and after an inner value of one parameter.

        >>> f = NurbsSurface((1, 1), [0, 0, 1, 1], [0, 0, 2, 2], [[(0, 0), (0, 1)], [(1, 0), (1, 1)]])
        >>> [str(part.domain.second) for part in f.split("v", 1)]
        ['[0, 1]', '[1, 2]']

        Raises `DomainError` for a value that is not inside the domain.
        """
        of_u, (u, v) = choice(Along, along, "parameter") is Along.U, self.domain
        if of_u:
            return self.restrict((u.low, t), v), self.restrict((t, u.high), v)
        return self.restrict(u, (v.low, t)), self.restrict(u, (t, v.high))

    def restrict(self, side_u: tuple[Number, Number], side_v: tuple[Number, Number]) -> NurbsSurface:
        """Return the part of the surface over a smaller rectangle, with the same parameters.

        Raises `DomainError` unless the rectangle is nondegenerate and inside the domain.
        """
        return self._changed(lambda f: f.restrict(side_u, side_v))

    def transposed(self) -> NurbsSurface:
        """Return the surface with its parameters exchanged."""
        return self._changed(lambda f: f.transposed())

    def transform(self, matrix: Sequence[Sequence[Number]]) -> NurbsSurface:
        """Return the image under a linear, an affine or a projective map, given by a matrix as for `Nurbs.transform`.

        >>> f = NurbsSurface((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[(0, 0), (0, 1)], [(1, 0), (1, 1)]])
        >>> f.transform([[2, 0, 5], [0, 1, 0]])(1, 1)
        (mpq(7,1), mpq(1,1))

        Raises `ShapeError` for a matrix of another shape, and `WeightError` if the image passes through infinity.
        """
        image, w = mapped(list(self.p), self.w, matrix, polynomial=self.polynomial)
        return NurbsSurface.from_splines(image, w, name=self.name)

    def _changed(self, change: Callable[[TensorSpline], TensorSpline]) -> NurbsSurface:
        """The surface of the changed splines; the change must preserve constants."""
        w = None if self.polynomial else change(self.w)
        return NurbsSurface.from_splines(map(change, self.p), w, name=self.name)


def _checked_net(given: object, counts: tuple[int, int]) -> Net:
    """A net of points of the same dimension, as given by a user."""

    def row_of(row: Iterable[Iterable[Number]], place: str) -> tuple[Point, ...]:
        try:
            return exact_points(row)
        except ExactSplineError as error:
            raise error.moved("control_points", place) from None

    net = checked_net(given, counts, BOTH, row_of)
    dimension = len(net[0][0])
    for i, points in enumerate(net):
        if len(points[0]) != dimension:
            problem = f"{counted(len(points[0]), 'coordinate')} where control_points[0] has {dimension}"
            raise ShapeError(problem, where=f"control_points[{i}]", remedy="use one dimension")
    return tuple(net)


def _checked_weights(given: object, net: Net) -> Weights:
    """A weight for each control point; by default 1 for a point and 0 for a direction."""
    if given is None:
        return tuple(exact_weights(None, row) for row in net)
    rows = [] if isinstance(given, str) or not isinstance(given, Iterable) else list(given)
    if len(rows) != len(net):
        problem = f"{counted(len(rows), 'row')} of weights for {counted(len(net), 'row')} of control points"
        raise ShapeError(problem, where="weights", remedy="give one weight per control point, in rows along u")
    found = []
    for i, (row, points) in enumerate(zip(rows, net, strict=True)):
        place = f"weights[{i}]"
        if isinstance(row, str) or not isinstance(row, Iterable):
            raise ShapeError(f"{shown(row)} is not a row of weights", where=place, remedy="give a list of numbers")
        try:
            found.append(exact_weights(row, points))
        except ExactSplineError as error:
            raise error.moved("weights", place) from None
    return tuple(found)


def _on_one_mesh(splines: Iterable[TensorSpline], letters: tuple[str, str]) -> list[TensorSpline]:
    """Components over the same breakpoints, unchanged except that they share the meshes of the first component, so that
    operations need not compare meshes, and that their parameters have names.
    """
    found = list(splines)
    meshes = with_names(found[0].meshes, letters)
    return [make(f.degree, meshes, f.continuity, f.stride, f.numerators, f.denominators, f.provenance) for f in found]


def _splines(
    degree: tuple[int, ...], knots: tuple[KnotVector, KnotVector], net: Net, weights: Weights | None
) -> tuple[Vector[TensorSpline], TensorSpline]:
    """Numerators and denominator; without weights the denominator is the constant 1."""

    def spline(values: Iterable[Iterable[mpq]]) -> TensorSpline:
        return TensorSpline((degree[0], degree[1]), *knots, values)

    if weights is None:
        p = _on_one_mesh([spline([[point[k] for point in row] for row in net]) for k in range(len(net[0][0]))], BOTH)
        return Vector(*p), p[0].constant(1)
    scaled = [[lifted(x, w) for x, w in zip(*rows, strict=True)] for rows in zip(net, weights, strict=True)]
    p = [spline([[point[k] for point in row] for row in scaled]) for k in range(len(net[0][0]))]
    *p, w = _on_one_mesh([*p, spline(weights)], BOTH)
    _check_weight(w)
    return Vector(*p), w
