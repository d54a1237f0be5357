"""The concrete curve: degree, knots, control points, weights, its values, and the operands ``p``, ``w``, ``gamma`` that
formulas use.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterable, Sequence
from functools import partial
from itertools import pairwise
from typing import TYPE_CHECKING, Any, overload

from exactspline.errors import DomainError, ShapeError, WeightError, as_instance, as_items, counted, shown
from exactspline.formulas.derivatives import across
from exactspline.hooks import FunctionsOutside
from exactspline.language.arguments import Curve
from exactspline.language.operand import Operand, checked_order
from exactspline.language.vector import Vector, dot, norm2, perp
from exactspline.numbers.exact import Number, from_floats, mpq, rational, sign, text
from exactspline.numbers.intervals import Interval, Side
from exactspline.numbers.once import Immutable, cached_property, fill
from exactspline.one_line import one_line
from exactspline.polynomials.isolation import zero_on_segment
from exactspline.reals.real import Real, square_root
from exactspline.splines.blossom import CommonRows
from exactspline.splines.bspline import BSpline
from exactspline.splines.common import mapped, same_quotients, splines_over, with_common_knots
from exactspline.splines.control_points import Point, exact_points, exact_weights, inserted, projected
from exactspline.splines.evaluation import Evaluation
from exactspline.splines.inputs import checked_degree, checked_side, exact_row
from exactspline.splines.knots import KnotVector, Mesh, mesh_of
from exactspline.splines.refinement import insertable

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


def normalized(v: tuple[mpq, ...], problem: str) -> tuple[Real, ...]:
    """A vector divided by its length; raises an error with this problem for the zero vector.

    >>> normalized((mpq(3), mpq(4)), "the null vector")
    (<Real 3/5>, <Real 4/5>)
    """
    length = norm2(Vector(*v))
    if not length:
        raise DomainError(problem, remedy="choose another parameter")
    inverse = square_root(1 / length)
    return tuple(x * inverse for x in v)


class Nurbs(Immutable, Curve[BSpline], FunctionsOutside):
    """A polynomial or rational B-spline curve with exact data.

    `control_points` are Cartesian points of the same dimension, or `Direction` objects; `weights` are optional. With
    the points Pᵢ, the weights wᵢ and the basis functions Nᵢ, the curve is ``Σ wᵢ Pᵢ Nᵢ / Σ wᵢ Nᵢ``: a point of weight 0
    adds nothing, and a direction v adds ``v Nᵢ`` to the numerator only. Equal weights mean that the curve is
    polynomial: `polynomial` is true, the denominator ``w`` is the constant 1 of degree 0, and ``gamma`` is the vector
    ``p`` of the numerators. Otherwise ``gamma`` is the `Rational` ``p/w``.

    >>> arc = Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], weights=[1, 1, 2])
    >>> arc("1/2"), arc.polynomial
    ((mpq(3,5), mpq(4,5)), False)

    A curve never changes, and ``==`` tests whether two curves are the same function.

    >>> arc == arc.insert_knot("1/3").elevate_degree(), arc == arc.reverse()
    (True, False)

    Raises `ShapeError`, `KnotError` or `NumberError` with the place of the error, and `WeightError` if the denominator
    has a zero on the domain, with the parameter of the zero or an interval around the zero.
    """

    degree: int
    knots: KnotVector
    #: Tuples of coordinates, or a `Direction`.
    control_points: tuple[Point, ...]
    weights: tuple[mpq, ...]
    name: str
    source: str
    note: str
    #: The analysis stored by `exactspline.analyse`: set once, neither pickled nor compared.
    kept_analysis: object = None

    def __init__(
        self,
        degree: int,
        knots: Iterable[Number],
        control_points: Iterable[Iterable[Number]],
        weights: Iterable[Number] | None = None,
        *,
        name: str = "",
        source: str = "",
        note: str = "",
    ) -> None:
        degree, points = checked_degree(degree), exact_points(control_points)
        vector = knots if isinstance(knots, KnotVector) else KnotVector(knots)
        data = degree, vector, points, exact_weights(weights, points)
        vars(self).update(_fields(*data), name=name, source=source, note=note)
        # weights of one sign cannot cancel
        if not self.polynomial and min(self.weights) <= 0 <= max(self.weights):
            _check_weight(self.w)

    @classmethod
    def bezier(
        cls, points: Sequence[Iterable[Number]], weights: Iterable[Number] | None = None, a: Number = 0, b: Number = 1
    ) -> Nurbs:
        """Return the Bézier curve with these points over [a, b].

        >>> Nurbs.bezier([(0, 0), (1, 2), (2, 0)])("1/2")
        (mpq(1,1), mpq(1,1))
        """
        points = list(as_items(points, "control points"))
        return cls(len(points) - 1, [*[a] * len(points), *[b] * len(points)], points, weights)

    @classmethod
    def from_homogeneous(
        cls,
        degree: int,
        knots: Iterable[Number],
        points: Iterable[Iterable[Number]],
        *,
        name: str = "",
        source: str = "",
        note: str = "",
    ) -> Nurbs:
        """Return the curve with the homogeneous control points ``(w x, w y, …, w)``. A point with w = 0 is a direction.

        >>> Nurbs.from_homogeneous(1, [0, 0, 1, 1], [(2, 4, 2), (0, 3, 1)]).control_points
        ((mpq(1,1), mpq(2,1)), (mpq(0,1), mpq(3,1)))
        """
        rows = exact_points(points, least=3)
        cartesian = [projected(row) for row in rows]
        return cls(degree, knots, cartesian, [row[-1] for row in rows], name=name, source=source, note=note)

    @classmethod
    def from_floats(
        cls,
        degree: int,
        knots: Iterable[float],
        control_points: Iterable[Iterable[float]],
        weights: Iterable[float] | None = None,
        *,
        snap: bool = False,
        name: str = "",
    ) -> Nurbs:
        """Return the curve with these floats and integers as data, in lists or in numpy's arrays of any type of float.

        A float means its exact binary value or, with `snap`, the shortest decimal as which the float prints.

        >>> curve = Nurbs.from_floats(1, [0, 0, 1, 1], [(0.1, 0), (0.5, 1)])
        >>> curve(0)[0] == mpq(1, 10), curve(1)
        (False, (mpq(1,2), mpq(1,1)))
        >>> Nurbs.from_floats(1, [0, 0, 1, 1], [(0.1, 0), (0.5, 1)], snap=True)(0)
        (mpq(1,10), mpq(0,1))

        Raises `NumberError` for NaN and infinities, and the errors of `Nurbs`.
        """
        exact = None if weights is None else from_floats(weights, snap=snap)
        points = from_floats(control_points, snap=snap)
        return cls(degree, from_floats(knots, snap=snap), points, exact, name=name)

    @classmethod
    def from_splines(cls, p: Iterable[BSpline], w: BSpline | None = None, *, name: str = "") -> Nurbs:
        """Return the curve ``p/w`` (or ``p``) with these splines as components, which may have different degrees and
        knots.

        >>> t = BSpline.identity(0, 2)
        >>> Nurbs.from_splines([t, t * t]).control_points
        ((mpq(0,1), mpq(0,1)), (mpq(1,1), mpq(0,1)), (mpq(2,1), mpq(4,1)))
        """
        splines = with_common_knots([*p, *([] if w is None else [w])])
        rows = list(zip(*[f.control_points for f in splines], strict=True))
        made: Callable[..., Nurbs] = cls if w is None else cls.from_homogeneous
        return made(splines[0].degree, splines[0].knots, rows, name=name)

    @classmethod
    def _unchanged(cls, name: str, *data: Any) -> Nurbs:
        """The curve with exact data of an existing curve, without a new check for zeros of the denominator."""
        curve = cls.__new__(cls)
        fill(curve, **_fields(*data), name=name, source="", note="")
        return curve

    # ---- a value

    def __setattr__(self, name: str, value: object) -> None:  # type: ignore[override]  # one slot may be set, once
        if name != "kept_analysis":
            super().__setattr__(name, value)
        vars(self).setdefault(name, value)

    def __reduce__(self) -> tuple[Callable[..., Nurbs], tuple[object, ...]]:
        named = partial(Nurbs, name=self.name, source=self.source, note=self.note)
        return named, (self.degree, self.knots, self.control_points, self.weights)

    def __eq__(self, other: object) -> bool:
        """Whether both are the same function on the same domain, whatever their knots, degrees and weights."""
        if not isinstance(other, Nurbs):
            return NotImplemented
        return self is other or same_quotients(self.p, self.w, other.p, other.w)

    def __hash__(self) -> int:
        a, b = self.domain
        return hash((a, b, *[self(a + (b - a) * mpq(i, 4)) for i in range(4)]))

    # ---- sums and multiples

    __array_ufunc__ = None  # so that the methods of the curve are used for sums and products with numpy arrays

    def __add__(self, other: Nurbs | Sequence[Number]) -> Nurbs:
        """The sum with a curve over the same domain, or the curve moved by a vector.

        >>> line = Nurbs.bezier([(0, 0), (1, 2)])
        >>> (line + (1, "1/2"))(0), (line - line)(1), (2 * line)(1), line @ line == (5 * BSpline.bezier([0, 0, 1]))
        ((mpq(1,1), mpq(1,2)), (mpq(0,1), mpq(0,1)), (mpq(2,1), mpq(4,1)), True)

        Raises `DomainError` for curves over different domains.
        """
        if isinstance(other, Nurbs):
            as_dimension(other.dimension, self.dimension, "curve")
            p = [x * other.w + y * self.w for x, y in zip(self.p, other.p, strict=True)]
            return Nurbs.from_splines(p, None if self.polynomial and other.polynomial else self.w * other.w)
        vector = exact_row(as_items(other, "the numbers of a vector"), "vector")
        as_dimension(len(vector), self.dimension, "vector")
        return self.transform([[int(i == j) for j in range(self.dimension)] + [x] for i, x in enumerate(vector)])

    __radd__ = __add__

    def __neg__(self) -> Nurbs:
        return self * -1

    def __sub__(self, other: Nurbs | Sequence[Number]) -> Nurbs:
        return -(-self + other)

    def __rsub__(self, other: Sequence[Number]) -> Nurbs:
        return -self + other

    def __mul__(self, factor: Number) -> Nurbs:
        """The multiple by an exact number."""
        if isinstance(factor, Nurbs):
            raise ShapeError("a product of two curves", remedy="their dot product is curve @ curve")
        n, q = self.dimension, rational(factor)
        return self.transform([[q * (i == j) for j in range(n)] for i in range(n)])

    __rmul__ = __mul__

    def __truediv__(self, divisor: Number) -> Nurbs:
        return self * (1 / rational(divisor))

    def __matmul__(self, other: Nurbs) -> Operand:
        """The dot product with a curve over the same domain, a function."""
        other = as_instance(other, Nurbs, "a curve", "curve @ curve is a dot product")
        as_dimension(other.dimension, self.dimension, "curve")
        product = dot(self.p, other.p)
        return product if self.polynomial and other.polynomial else product / (self.w * other.w)

    # ---- the curve

    def __call__(self, t: Number, side: Side | str = Side.RIGHT) -> tuple[mpq, ...]:
        """Return the exact point at a parameter; at a jump, the limit from the right, or from the given `side`."""
        *numerators, [w] = self.evaluation.numbers(rational(t), 0, left=checked_side(side))
        return tuple([mpq(x, w) for [x] in numerators])

    def points_at(self, ts: Iterable[Number], side: Side | str = Side.RIGHT) -> list[tuple[mpq, ...]]:
        """Return the exact points at many parameters, in less time than single calls of the curve.

        >>> Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], weights=[1, 1, 2]).points_at([0, "1/2"])
        [(mpq(1,1), mpq(0,1)), (mpq(3,5), mpq(4,5))]

        Raises `NumberError` for a parameter that is not an exact number, `DomainError` outside the domain.
        """
        return self.evaluation.points(exact_row(as_items(ts, "parameters"), "parameters"), left=checked_side(side))

    @cached_property
    def evaluation(self) -> Evaluation:
        """The integers of the curve, from which points and derivatives are computed."""
        return Evaluation(self.knots, self.degree, self.control_points, None if self.polynomial else self.weights)

    @overload
    def derivative(self, order: int = ...) -> Nurbs:
        """The curve of the derivatives."""

    @overload
    def derivative(self, order: int, t: Number, side: Side | str = ...) -> tuple[mpq, ...]:
        """The derivative at a parameter."""

    def derivative(
        self, order: int = 1, t: Number | None = None, side: Side | str = Side.RIGHT
    ) -> Nurbs | tuple[mpq, ...]:
        """Return the derivative of the given order at a rational parameter, exactly; at a knot, the limit from `side`.
        Without a parameter, return the curve of the derivatives (for order 1, the hodograph).

        >>> from exactspline import Nurbs
        >>> arc = Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], weights=[1, 1, 2])
        >>> arc.derivative(1, 0), arc.derivative(2, 0), arc.derivative()(0)
        ((mpq(0,1), mpq(2,1)), (mpq(-4,1), mpq(0,1)), (mpq(0,1), mpq(2,1)))

        Raises `FormulaError` for a negative order, `DomainError` outside the domain.
        """
        if t is None:
            numerators, w = derivative_splines(self, checked_order(order))
            numerators = [f if f.degree >= 0 else f.constant(0) for f in numerators]
            return Nurbs.from_splines(numerators, None if self.polynomial else w, name=self.name)
        return self.evaluation.jet(rational(t), checked_order(order), left=checked_side(side))[-1]

    def tangent(self, t: Number, side: Side | str = Side.RIGHT) -> tuple[mpq, ...]:
        """Return the tangent vector γ′ at a rational parameter (see `unit_tangent`).

        >>> from exactspline import Nurbs
        >>> Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 2)]).tangent(0)
        (mpq(1,1), mpq(2,1))
        """
        return self.derivative(1, t, side)

    def unit_tangent(self, t: Number, side: Side | str = Side.RIGHT) -> tuple[Real, ...]:
        """Return the unit tangent γ′/‖γ′‖ at a rational parameter, exactly.

        >>> from exactspline import Nurbs
        >>> [str(x) for x in Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 2)]).unit_tangent(0)]
        ['√5/5', '2√5/5']

        Raises `DomainError` where γ′ = 0.
        """
        return normalized(self.tangent(t, side), f"γ′ = 0 at the parameter {text(rational(t))}")

    def normal(self, t: Number, side: Side | str = Side.RIGHT) -> tuple[Real, ...]:
        """Return the unit normal at a rational parameter, exactly. In the plane the normal γ′⊥/‖γ′‖ points to the left
        of the curve; in space the principal normal points towards the centre of curvature.

        >>> from exactspline import Nurbs
        >>> arc = Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], weights=[1, 1, 2])
        >>> arc.normal("1/2")
        (<Real -3/5>, <Real -4/5>)

        Raises `DomainError` where γ′ = 0, in space also where the curvature is 0, and `ShapeError` in other dimensions.
        """
        where = f"at the parameter {text(rational(t))}"
        first = self.tangent(t, side)
        if self.dimension == 2:
            return normalized(perp(Vector(*first)).components, f"γ′ = 0 {where}")
        if self.dimension != 3:
            raise ShapeError(f"the normal of a curve in R{self.dimension}", remedy="it is defined in plane and space")
        bent = across(Vector(*first), Vector(*self.derivative(2, t, side)))
        return normalized(bent.components, f"γ′ × γ″ = 0 {where}")

    # the splines are computed when first needed: a curve that was only read has control points only

    @cached_property
    def _splines(self) -> tuple[BSpline, ...]:
        """The components; for a rational curve the last one is the weight function."""
        return tuple(splines_over(self.degree, self.knots, self.evaluation.columns, self.rows))

    @property
    def rows(self) -> Sequence[CommonRows]:
        """The integer coefficients of the components on every segment, over a common denominator.

        >>> Nurbs(1, [0, 0, 1, 1], [(0, 0), (4, "1/2")]).rows
        [(((0, 8), (0, 1)), 2)]
        """
        return self.evaluation.rows

    @cached_property
    def p(self) -> Vector[BSpline]:  # type: ignore[override]  # computed when asked for
        """The vector of the numerators."""
        return Vector(*self._splines[: self.dimension])

    @cached_property
    def w(self) -> BSpline:  # type: ignore[override]  # computed when asked for
        """The denominator; for a polynomial curve the constant 1 of degree 0."""
        return self._splines[0].constant(1) if self.polynomial else self._splines[-1]

    @cached_property
    def gamma(self) -> Vector[BSpline] | Operand:  # type: ignore[override]  # computed when asked for
        """The curve itself."""
        return self.p if self.polynomial else self.p / self.w

    @property
    def dimension(self) -> int:
        """The number of coordinates."""
        return len(self.control_points[0])

    @property
    def domain(self) -> Interval:
        """The parameter interval."""
        return self.mesh.domain

    @property
    def breakpoints(self) -> tuple[mpq, ...]:
        """The distinct knots of the domain, ends included."""
        return self.mesh.breaks

    @property
    def mesh(self) -> Mesh:
        """The distinct knots of the domain, shared by all splines of the curve."""
        return mesh_of(self.knots, self.degree)[0]

    @property
    def segments(self) -> int:
        """The number of polynomial or rational segments."""
        return len(self.mesh)

    @property
    def closed(self) -> bool:
        """Whether the two ends are exactly the same point."""
        t = self.knots.knots
        if t[0] == t[self.degree] and t[-1] == t[-1 - self.degree]:
            return self.control_points[0] == self.control_points[-1]
        a, b = self.domain
        return self(a) == self(b)

    @one_line
    def __repr__(self) -> str:
        kind = "polynomial" if self.polynomial else "rational"
        points = f"{len(self.control_points)} control points in R{self.dimension}"
        return f"<Nurbs {self.name or 'curve'}: {kind}, degree {self.degree}, {points}>"

    # ---- other representations, parts, images

    def insert_knot(self, t: Number, times: int = 1) -> Nurbs:
        """Return the same curve with one or several additional knots inside the domain, or at an end that is not
        clamped.

        >>> line = Nurbs(1, [0, 0, 1, 1], [(0, 0), (4, 2)])
        >>> line.insert_knot("1/4").control_points
        ((mpq(0,1), mpq(0,1)), (mpq(1,1), mpq(1,2)), (mpq(4,1), mpq(2,1)))

        Raises `DomainError` outside the domain and at clamped ends, `KnotError` if the multiplicity would exceed degree
        + 1.
        """
        mesh, continuity, _ = mesh_of(self.knots, self.degree)
        if not self.knots.has_room_at_end(self.degree, t := rational(t), times):
            insertable(self.degree, mesh, continuity, t, times)
        knots, points, weights = inserted(self.knots, self.degree, self.control_points, self.weights, t, times)
        return Nurbs._unchanged(self.name, self.degree, knots, points, weights)

    def elevate_degree(self, by: int = 1) -> Nurbs:
        """Return the same curve with the degree raised.

        >>> Nurbs(1, [0, 0, 1, 1], [(0, 0), (4, 2)]).elevate_degree().control_points
        ((mpq(0,1), mpq(0,1)), (mpq(2,1), mpq(1,1)), (mpq(4,1), mpq(2,1)))
        """
        return changed(self, lambda f: f.elevate_degree(by))

    def split(self, t: Number) -> tuple[Nurbs, Nurbs]:
        """Return the two parts of the curve before and after an inner parameter.

        >>> first, second = Nurbs(1, [0, 0, 1, 1], [(0, 0), (4, 2)]).split("1/2")
        >>> first.control_points[1] == second.control_points[0], str(second.domain)
        (True, '[1/2, 1]')

        Raises `DomainError` for a parameter that is not inside the domain.
        """
        a, b = self.domain
        return self.restrict(a, t), self.restrict(t, b)

    def bezier_segments(self) -> list[Nurbs]:
        """Return the segments as separate curves.

        >>> [str(part.domain) for part in Nurbs(1, [0, 0, 1, 3, 3], [(0, 0), (4, 2), (5, 0)]).bezier_segments()]
        ['[0, 1]', '[1, 3]']
        """
        return [self.restrict(*ends) for ends in pairwise(self.breakpoints)]

    def sample(self, count: int = 100) -> NDArray[np.float64]:
        """Return the points at this many equally spaced parameters, from one end of the domain to the other, as
        correctly rounded doubles.

        >>> Nurbs(1, [0, 0, 1, 1], [(0, 0), (4, 2)]).sample(3).tolist()
        [[0.0, 0.0], [2.0, 1.0], [4.0, 2.0]]

        Raises `ShapeError` for fewer than two points.
        """
        if type(count) is not int or count < 2:
            raise ShapeError(f"{shown(count)} points", where="count", remedy="give at least 2")
        a, b = self.domain
        return self.floats([a + (b - a) * i / (count - 1) for i in range(count)])

    def restrict(self, a: Number, b: Number) -> Nurbs:
        """Return the part of the curve over [a, b], with the same parameters.

        >>> Nurbs(1, [0, 0, 1, 1], [(0, 0), (4, 2)]).restrict("1/4", "3/4").control_points
        ((mpq(1,1), mpq(1,2)), (mpq(3,1), mpq(3,2)))

        Raises `DomainError` unless a < b are in the domain.
        """
        return changed(self._around(rational(a), rational(b)), lambda f: f.restrict(a, b))

    def _around(self, a: mpq, b: mpq) -> Nurbs:
        """The curve; while its splines are not computed only the segments that meet [a, b], if they are few."""
        t, n, points, weights = self.knots.knots, self.degree, self.control_points, self.weights
        first, last = bisect_right(t, a) - 1, bisect_left(t, b)
        inside = a < b and n <= first < last <= len(points)
        if "_splines" in vars(self) or not inside or 4 * (last - first + n) > len(points):
            return self
        own = weights[first - n : last]
        if own.count(own[0]) == len(own) and not self.polynomial:
            return self  # the constant weights of a part are kept
        return self._unchanged(self.name, n, KnotVector(t[first - n : last + n + 1]), points[first - n : last], own)

    def reverse(self) -> Nurbs:
        """Return the reversed curve, over the same domain.

        >>> Nurbs(1, [0, 0, 1, 1], [(0, 0), (4, 2)]).reverse()(0)
        (mpq(4,1), mpq(2,1))
        """
        return changed(self, lambda f: f.reverse())

    def transform(self, matrix: Sequence[Sequence[Number]]) -> Nurbs:
        """Return the image under a linear, an affine or a projective map with exact entries.

        In Rⁿ a matrix of n columns is a linear map, a matrix of n rows and n + 1 columns is an affine map (the last
        column is the translation), and a matrix of n + 1 rows and columns is a projective map of ``(w x, …, w)``.

        >>> line = Nurbs(1, [0, 0, 1, 1], [(0, 0), (4, 2)])
        >>> line.transform([[0, -1], [1, 0]])(1), line.transform([[1, 0, 5], [0, 1, 0]])(0)
        ((mpq(-2,1), mpq(4,1)), (mpq(5,1), mpq(0,1)))

        Raises `ShapeError` for a matrix of another shape, and `WeightError` if the image passes through infinity.
        """
        image, w = mapped(list(self.p), self.w, matrix, polynomial=self.polynomial)
        return type(self).from_splines(image, w, name=self.name)


def as_dimension(found: int, needed: int, what: str) -> None:
    """Raise `ShapeError` unless a vector or a curve has as many coordinates as a curve."""
    if found != needed:
        raise ShapeError(f"a {what} of {counted(found, 'coordinate')}", remedy=f"it needs {needed}")


def derivative_splines(curve: Nurbs, order: int) -> tuple[list[BSpline], BSpline]:
    """The derivative of the given order as a quotient of splines.

    >>> derivative_splines(Nurbs.bezier([(0, 0), (1, 2)]), 1)[0][1].control_points
    (mpq(2,1),)
    """
    if curve.polynomial:
        return [x.d(order) for x in curve.p], curve.w
    numerators, slope, denominator = list(curve.p), curve.w.d(), curve.w
    for k in range(1, order + 1):
        # (N/wᵏ)′ = (N′ w − k w′ N)/wᵏ⁺¹
        numerators = [f.d() * curve.w - (slope * f).scaled(k) for f in numerators]
        denominator = denominator * curve.w
    return numerators, denominator


def graph(f: BSpline) -> Nurbs:
    """Return the graph t ↦ (t, f(t)) of a function f as a plane curve.

    >>> graph(BSpline.bezier([0, 0, 1]))("1/2")
    (mpq(1,2), mpq(1,4))
    """
    f = as_instance(f, BSpline, "a function", "give a BSpline")
    return Nurbs.from_splines([BSpline.identity(*f.domain), f])


def changed(curve: Nurbs, change: Callable[[BSpline], BSpline]) -> Nurbs:
    """The curve of the changed splines, with the name of the original curve; the change must preserve constants."""
    w = None if curve.polynomial else change(curve.w)
    return type(curve).from_splines(map(change, curve.p), w, name=curve.name)


def _fields(degree: int, knots: KnotVector, points: tuple[Point, ...], weights: tuple[mpq, ...]) -> dict[str, object]:
    """The fields of a curve with this data."""
    knots.check(degree)
    knots.check_count(degree, len(points))
    polynomial = weights.count(weights[0]) == len(weights) and weights[0] != 0
    data = {"degree": degree, "knots": knots, "control_points": points, "weights": weights}
    return data | {"polynomial": polynomial, "point": None}


def _check_weight(w: BSpline) -> None:
    def refused(problem: str, low: mpq, high: mpq) -> WeightError:
        at = f"at the parameter {text(low)}" if low == high else f"between the parameters {text(low)} and {text(high)}"
        remedy = "w must keep its sign on the domain"
        return WeightError(f"the denominator w {problem} {at}", where="weights", remedy=remedy, witness=(low, high))

    before = 0
    for c, a, b in zip(w.numerators, w.breakpoints, w.breakpoints[1:], strict=False):
        witness = zero_on_segment(c, w.degree)
        if witness is not None:
            raise refused("has a zero", *Interval(a, b).part(witness))
        here = sign(c[0])
        if before * here < 0:
            raise refused("changes sign by a jump", a, a)
        before = here
