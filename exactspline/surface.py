"""Splines in two parameters: exact tensor-product B-splines, the algebra that §6 needs.

A `TensorSpline` is immutable, like `BSpline`, and scalar; a surface in space is a `Vector` of three, or a `Rational`. What depends on one parameter
only is kept as the `BSpline` it is, so that nothing is computed once a patch that can be computed once a segment.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from itertools import product
from operator import add as plus
from operator import mul as times
from operator import sub as minus
from typing import Any

from flint import fmpz, fmpz_poly
from gmpy2 import lcm, mpq

from exactspline import bezier_points, patch, refinement, structure
from exactspline.errors import FormulaError, ShapeError
from exactspline.exact import rational, text, to_fmpz
from exactspline.form import common_denominators, primitive, raiser
from exactspline.knots import SMOOTH, KnotVector, Mesh, clamped
from exactspline.language import CONSTANTS, Curve, Operand, Pair
from exactspline.spline import BSpline
from exactspline.surface_lines import Degrees, joined, lines


class TensorSpline(Operand):
    """A scalar tensor-product B-spline in two parameters s and t, over a rectangle.

    `degrees`, knots and `control_points` as for `BSpline`, in each direction: ``control_points[i][j]`` with i along s and j along t.

    >>> f = TensorSpline((1, 2), [0, 0, 1, 1], [0, 0, 0, 1, 1, 1], [[0, 0, 0], [0, 0, 4]])
    >>> f("1/2", "1/2"), (f * f).degree, f.partial(0, 1)(1, "1/2")
    (mpq(1,2), Degrees(s=2, t=4), mpq(4,1))

    Raises `ShapeError`, `KnotError` or `NumberError` with the place at fault.
    """

    __slots__ = ("_packed", "_points", "continuity", "degree", "denominators", "meshes", "profile", "recipe")

    degree: Degrees
    #: The breakpoints in each direction, and the continuity at the interior ones.
    meshes: tuple[Mesh, Mesh]
    continuity: tuple[tuple[int, ...], tuple[int, ...]]
    #: Denominators patch by patch, t running faster.
    denominators: list[fmpz]
    #: Where it depends on one parameter only: which (0 for s), and the spline.
    profile: tuple[int, BSpline] | None
    recipe: structure.Recipe
    #: The packed polynomials by stride (see `exactspline.patch`).
    _packed: dict[int, list[fmpz_poly]]
    _points: tuple[tuple[mpq, ...], ...] | None

    def __init__(self, degrees: tuple[int, int], knots_s: Iterable[Any], knots_t: Iterable[Any], control_points: Iterable[Iterable[Any]]) -> None:
        m, n = degrees
        net, vector_t = [list(row) for row in control_points], KnotVector(knots_t)
        if not net:
            raise ShapeError("no control points", where="control_points", remedy="give a net of them")
        along_t = [BSpline(n, vector_t, row) for row in net]
        vector_s = KnotVector(knots_s)
        along_s = [BSpline(m, vector_s, column) for column in zip(*[[x for part in row.segments for x in part] for row in along_t], strict=True)]
        meshes, stride = (along_s[0].mesh, along_t[0].mesh), patch.stride_for(m)
        nets = [
            [list(row) for row in zip(*[along_s[j * (n + 1) + k].segments[i] for k in range(n + 1)], strict=True)]
            for i, j in product(range(len(meshes[0])), range(len(meshes[1])))
        ]
        forms = [patch.from_net(net, stride) for net in nets]
        self._fill(Degrees(m, n), meshes, (along_s[0].continuity, along_t[0].continuity), structure.leaf())
        self._packed, self.denominators = {stride: [c for c, _ in forms]}, [d for _, d in forms]

    def _fill(self, degree: Degrees, meshes: tuple[Mesh, Mesh], continuity: tuple[tuple[int, ...], tuple[int, ...]], recipe: Any) -> None:
        self.degree, self.meshes, self.continuity, self.recipe = degree, meshes, continuity, recipe
        self.profile, self._points = None, None

    # ---- representation

    @property
    def stride(self) -> int:
        """The stride of the packed polynomials at hand."""
        return next(iter(self._packed), patch.stride_for(self.degree.s))

    def packed(self, stride: int | None = None) -> list[fmpz_poly]:
        """The packed polynomials of all patches, t running faster."""
        stride = self.stride if stride is None else stride
        if stride not in self._packed:
            if self.profile is None:
                self._packed[stride] = [patch.repacked(c, self.stride, stride) for c in self.packed()]
            else:
                direction, spline = self.profile
                self._packed[stride] = _spread(spline.polynomials if direction == 0 else [c.inflate(stride) for c in spline.polynomials], self)
        return self._packed[stride]

    @property
    def polynomials(self) -> list[fmpz_poly]:
        """The packed polynomials at the stride at hand: zero where the spline is."""
        return self.packed()

    @property
    def domain(self) -> tuple[tuple[mpq, mpq], tuple[mpq, mpq]]:
        """The rectangle, as its two sides."""
        return self.meshes[0].domain, self.meshes[1].domain

    @property
    def knots(self) -> tuple[KnotVector, KnotVector]:
        """Clamped knots in each direction."""
        s, t = (clamped(mesh, c, n) for mesh, c, n in zip(self.meshes, self.continuity, self.degree, strict=True))
        return s, t

    @property
    def control_points(self) -> tuple[tuple[mpq, ...], ...]:
        """The control net over `knots`, rows along s."""
        if self._points is None:
            n, knots_s, knots_t = self.degree.t + 1, self.knots[0].knots, self.knots[1].knots
            columns = []
            for j in range(len(self.meshes[1])):
                nets = [self.bezier_net(i, j) for i in range(len(self.meshes[0]))]
                for k in range(n):
                    segments = [[row[k] for row in net] for net in nets]
                    columns.append(bezier_points.to_control_points(knots_s, self.degree.s, self.meshes[0].breaks, segments))
            rows = zip(*columns, strict=True)
            segmented = ([row[j : j + n] for j in range(0, len(row), n)] for row in rows)
            self._points = tuple(bezier_points.to_control_points(knots_t, n - 1, self.meshes[1].breaks, parts) for parts in segmented)
        return self._points

    @property
    def control_point_counts(self) -> tuple[int, int]:
        """How many control points there are along s and along t."""
        return len(self.knots[0]) - self.degree.s - 1, len(self.knots[1]) - self.degree.t - 1

    def bezier_net(self, i: int, j: int) -> list[list[mpq]]:
        """The Bézier points of the patch over segment i of s and segment j of t."""
        at = i * len(self.meshes[1]) + j
        return patch.bezier_net((self.packed()[at], self.denominators[at]), self.degree, self.stride)

    def __repr__(self) -> str:
        (a, b), (c, d) = ((text(x) for x in side) for side in self.domain)
        return f"<TensorSpline of degree {self.degree.s} × {self.degree.t} over [{a}, {b}] × [{c}, {d}]>"

    # ---- arithmetic

    def constant(self, number: Any) -> TensorSpline:
        """The constant of degree 0 × 0 on this rectangle."""
        a, b = self.meshes[0].domain
        return lifted(refinement.over(BSpline.identity(a, b).constant(number), self.meshes[0]), self.meshes, 0)

    def __add__(self, other: Any) -> Any:
        return self._sum(other, plus, structure.SUM)

    def __sub__(self, other: Any) -> Any:
        return self._sum(other, minus, structure.DIFFERENCE)

    def _sum(self, other: Any, operation: Any, name: int) -> Any:
        right = self.beside(other)
        if right is None:
            return NotImplemented
        a, b = aligned(self, right)
        if (shared := _one_parameter(a, b)) is not None:
            return lifted(operation(shared[1], shared[2]), a.meshes, shared[0])
        degree = a.degree.max(b.degree)
        stride = _stride(degree, a, b)
        p, q, denominators = _elevated(a, degree, stride), _elevated(b, degree, stride), a.denominators
        if denominators != b.denominators:
            p, q, denominators = common_denominators(p, denominators, q, b.denominators)
        return make(degree, a.meshes, _lower(a, b), {stride: list(map(operation, p, q))}, denominators, (name, self.recipe, right.recipe))

    def __mul__(self, other: Any) -> Any:
        if type(other) is not TensorSpline:
            return self.scaled(other) if isinstance(other, CONSTANTS) else NotImplemented
        a, b = aligned(self, other)
        if (shared := _one_parameter(a, b)) is not None:
            return lifted(shared[1] * shared[2], a.meshes, shared[0])
        degree = Degrees(a.degree.s + b.degree.s, a.degree.t + b.degree.t)
        stride = _stride(degree, a, b)
        polynomials = list(map(times, a.packed(stride), b.packed(stride)))
        denominators = list(map(times, a.denominators, b.denominators))
        return make(degree, a.meshes, _lower(a, b), {stride: polynomials}, denominators, (structure.PRODUCT, self.recipe, other.recipe))

    def scaled(self, constant: Any) -> TensorSpline:
        """The spline times an exact constant."""
        if self.profile is not None:
            return lifted(self.profile[1].scaled(constant), self.meshes, self.profile[0])
        q = rational(constant)
        top, bottom = to_fmpz(q.numerator), to_fmpz(q.denominator)
        denominators = self.denominators if bottom == 1 else [m * bottom for m in self.denominators]
        polynomials = {self.stride: [c * top for c in self.packed()]}
        return make(self.degree, self.meshes, self.continuity, polynomials, denominators, (structure.MULTIPLE, self.recipe, q))

    def d(self, order: int = 1) -> TensorSpline:
        """The derivative of what depends on one parameter only; `FormulaError` for anything else (see `partial`)."""
        if self.profile is None:
            raise FormulaError("a derivative of a spline in two parameters", remedy="say by which: partial(1, 0) or partial(0, 1)")
        return lifted(self.profile[1].d(order), self.meshes, self.profile[0])

    def partial(self, i: int, j: int) -> TensorSpline:
        """The derivative of order i by s and j by t.

        >>> s = TensorSpline((1, 0), [0, 0, 1, 1], [0, 1], [[0], [1]])
        >>> (s * s * s).partial(2, 0)("1/2", 1), s.partial(0, 1).is_zero
        (mpq(3,1), True)
        """
        if i > self.degree.s or j > self.degree.t:
            return self.constant(0)
        return self.along(0, lambda f: f.d(i)).along(1, lambda f: f.d(j))

    def raised_to(self, other: TensorSpline) -> TensorSpline:
        """The same function, in each direction at least of the degree of `other`."""
        return self.elevate_degree(*[max(theirs - own, 0) for own, theirs in zip(self.degree, other.degree, strict=True)])

    # ---- the function

    def __call__(self, s: Any, t: Any) -> mpq:
        """Exact value at two parameters; at a jump the limit from the right (from the left at the end).

        Raises `DomainError` outside the rectangle.
        """
        s, t = rational(s), rational(t)
        i, j = self.meshes[0].locate(s), self.meshes[1].locate(t)
        at = i * len(self.meshes[1]) + j
        place = self.meshes[0].local(i, s), self.meshes[1].local(j, t)
        return patch.evaluated(self.packed()[at], self.denominators[at], self.degree, self.stride, *place)

    def at_t(self, t: Any) -> BSpline:
        """The iso-curve of constant t, a spline in s."""
        t, forms = rational(t), []
        for own in lines(self):
            values = [line(t) for line in own]
            common = lcm(*[x.denominator for x in values])
            forms.append(primitive((fmpz_poly([int(x.numerator * (common // x.denominator)) for x in values]), to_fmpz(common))))
        return BSpline.from_forms(self.degree.s, self.meshes[0], self.continuity[0], forms)

    def at_s(self, s: Any) -> BSpline:
        """The iso-curve of constant s, a spline in t."""
        return self.turned().at_t(s)

    @property
    def is_zero(self) -> bool:
        """Whether the function is identically zero."""
        return not any(self.packed())

    def __eq__(self, other: object) -> bool:
        """Whether both are the same function on the same rectangle, whatever their knots and degrees."""
        if not isinstance(other, TensorSpline):
            return NotImplemented
        return self.domain == other.domain and bool((self - other).is_zero)

    def __hash__(self) -> int:
        (a, b), (c, d) = self.domain
        return hash((self.domain, *[self(a + (b - a) * mpq(i, 4), c + (d - c) * mpq(j, 5)) for i in range(4) for j in range(3)]))

    @property
    def true_degree(self) -> Degrees:
        """Largest degree in each parameter, over the patches, of the polynomials themselves (−1 for the zero function)."""
        s, t = (max(line.true_degree for own in lines(f) for line in own) for f in (self.turned(), self))
        return Degrees(s, t)

    # ---- other representations and parts: what `BSpline` can do, in either direction

    def along(self, direction: int, change: Callable[[BSpline], BSpline]) -> TensorSpline:
        """The spline with a linear map of splines applied along one direction (0: along s)."""
        if self.profile is not None and self.profile[0] == direction:
            spline = change(self.profile[1])
            return lifted(spline, (spline.mesh, self.meshes[1]) if direction == 0 else (self.meshes[0], spline.mesh), direction)
        if direction == 0:
            return self.turned().along(1, change).turned()
        changed = [[change(line) for line in own] for own in lines(self)]
        degree, meshes, continuity, packed, denominators = joined(changed, self)
        return make(degree, meshes, continuity, packed, denominators, structure.leaf())

    def elevate_degree(self, by_s: int = 0, by_t: int = 0) -> TensorSpline:
        """The same function, its degrees raised."""
        return self.along(0, lambda f: f.elevate_degree(by_s)).along(1, lambda f: f.elevate_degree(by_t)) if by_s or by_t else self

    def reduce_degree(self, by_s: int = 0, by_t: int = 0) -> TensorSpline:
        """The same function, its degrees lowered; `ReductionError` where that cannot be done exactly."""
        return self.along(0, lambda f: f.reduce_degree(by_s)).along(1, lambda f: f.reduce_degree(by_t))

    def insert_knot(self, direction: int, t: Any, times: int = 1) -> TensorSpline:
        """The same function with a knot more in one direction."""
        return self.along(direction, lambda f: f.insert_knot(t, times))

    def restrict(self, side_s: tuple[Any, Any], side_t: tuple[Any, Any]) -> TensorSpline:
        """The part over a smaller rectangle."""
        return self.along(0, lambda f: f.restrict(*side_s)).along(1, lambda f: f.restrict(*side_t))

    def turned(self) -> TensorSpline:
        """The spline with its parameters exchanged."""
        meshes, continuity = (self.meshes[1], self.meshes[0]), (self.continuity[1], self.continuity[0])
        if self.profile is not None:
            return lifted(self.profile[1], meshes, 1 - self.profile[0])
        degree, stride = Degrees(self.degree.t, self.degree.s), patch.stride_for(self.degree.t)
        order = [i * len(meshes[0]) + j for j in range(len(meshes[0])) for i in range(len(meshes[1]))]
        polynomials = [patch.turned(self.packed()[k], self.stride, self.degree.t, stride) for k in order]
        return make(degree, meshes, continuity, {stride: polynomials}, [self.denominators[k] for k in order], structure.leaf())


_new = object.__new__


def make(degree: Degrees, meshes: Any, continuity: Any, packed: dict[int, list[fmpz_poly]], denominators: list[fmpz], recipe: Any) -> TensorSpline:
    """The spline with these packed polynomials; the caller vouches for the continuity."""
    spline = _new(TensorSpline)
    spline._fill(degree, meshes, continuity, recipe)
    spline._packed, spline.denominators = packed, denominators
    return spline


def _spread(values: list[Any], f: TensorSpline) -> list[Any]:
    """What belongs to the segments of the one direction of f, patch by patch."""
    assert f.profile is not None
    return [x for x in values for _ in range(len(f.meshes[1]))] if f.profile[0] == 0 else values * len(f.meshes[0])


def _one_parameter(a: TensorSpline, b: TensorSpline) -> tuple[int, BSpline, BSpline] | None:
    """The direction and the splines of two that depend on the same parameter only; a constant depends on either."""
    if a.profile is None or b.profile is None:
        return None
    (i, f), (j, g) = a.profile, b.profile
    if i != j and _is_constant(f):
        i, f = j, _constant_beside(g, f)
    elif i != j and _is_constant(g):
        g = _constant_beside(f, g)
    elif i != j:
        return None
    return i, f, g


def _is_constant(f: BSpline) -> bool:
    return f.degree == 0 and all(c == SMOOTH for c in f.continuity)


def _constant_beside(f: BSpline, constant: BSpline) -> BSpline:
    return refinement.over(f.constant(constant(constant.domain[0])), f.mesh)


def _stride(degree: Degrees, a: TensorSpline, b: TensorSpline) -> int:
    """A stride with room for a result, the one at hand where it will do."""
    return max(patch.stride_for(degree.s), *[x.stride if x.profile is None else 1 for x in (a, b)])


def _elevated(f: TensorSpline, degree: Degrees, stride: int) -> list[fmpz_poly]:
    """The packed polynomials raised to a degree."""
    polynomials = f.packed(stride)
    if f.degree == degree:
        return polynomials
    lift = raiser(degree.s - f.degree.s) * raiser(degree.t - f.degree.t).inflate(stride)
    return [c * lift for c in polynomials]


def _lower(a: TensorSpline, b: TensorSpline) -> tuple[tuple[int, ...], tuple[int, ...]]:
    s, t = (tuple(map(min, x, y)) for x, y in zip(a.continuity, b.continuity, strict=True))
    return s, t


def aligned(a: TensorSpline, b: TensorSpline) -> tuple[TensorSpline, TensorSpline]:
    """Both over the union of their breakpoints."""
    if a.meshes is b.meshes or (a.meshes[0].breaks == b.meshes[0].breaks and a.meshes[1].breaks == b.meshes[1].breaks):
        return a, b
    meshes = tuple(m if m.breaks == n.breaks else m.union(n) for m, n in zip(a.meshes, b.meshes, strict=True))
    return _over(a, meshes), _over(b, meshes)


def _over(f: TensorSpline, meshes: Any) -> TensorSpline:
    if f.profile is not None:
        return lifted(refinement.over(f.profile[1], meshes[f.profile[0]]), meshes, f.profile[0])
    return f.along(0, lambda g: refinement.over(g, meshes[0])).along(1, lambda g: refinement.over(g, meshes[1]))


def lifted(spline: BSpline, meshes: tuple[Mesh, Mesh], direction: int) -> TensorSpline:
    """A spline of one parameter as one of two: direction 0 if the parameter is s, 1 if it is t.

    >>> f = BSpline.bezier([0, 0, 1])
    >>> lifted(f, (f.mesh, Mesh([mpq(0), mpq(1)])), 0)("1/2", "1/3")
    mpq(1,4)
    """
    n, other = spline.degree, (SMOOTH,) * (len(meshes[1 - direction]) - 1)
    result = _new(TensorSpline)
    degree = Degrees(n, 0) if direction == 0 else Degrees(0, n)
    result._fill(degree, meshes, (spline.continuity, other) if direction == 0 else (other, spline.continuity), spline.recipe)
    result.profile = (direction, spline)
    result._packed = {}
    result.denominators = _spread(spline.denominators, result)
    return result


def surface_pair(first: Curve, second: Curve) -> Pair:
    """Two curves as the argument of formulas whose values are splines in both parameters.

    >>> from exactspline.curves import example
    >>> c = surface_pair(example("twisted_cubic"), example("rational_space_cubic"))
    >>> (c.first.p[0] * c.second.w).degree
    Degrees(s=3, t=3)
    """
    meshes = first.w.mesh, second.w.mesh
    return Pair(first.mapped(lambda f: lifted(f, meshes, 0)), second.mapped(lambda f: lifted(f, meshes, 1)))
