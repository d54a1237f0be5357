"""Lines, circles, conics, planes, spheres, cylinders, cones and tori, and the conditions for a curve or a surface to
lie within a distance E of such a shape: polynomials in the parameters that must keep one sign. The conditions are
written once, for curves and for surfaces.

For a circle, a sphere or a cylinder the condition is ``(r − E)² ≤ s ≤ (r + E)²`` for the squared distance s from a
centre or an axis. For a torus let ρ be the distance from the axis and ‖x‖ the distance from the centre: with ``F(e) =
‖x‖² + R² − e²``, ``F(r + E)² ≤ 4 R² ρ² ≤ F(r − E)²`` means that ``(ρ − R)² + z²`` lies between the squares of r ± E.
For a cone with half angle α let ``X = ρ² cos² α`` and ``Y = z² sin² α``: the distance from the cone is ``|√X − √Y|``,
which is at most E where ``(X − Y)² ≤ E² (X + Y)``, also at the apex. The distance shown by this condition is at most √2
times too large.

A conic is the zero set of a polynomial q of degree 2. Let Λ be a bound on half of its second derivatives. From a point
x, a step of length E along the gradient changes q by at least ``E‖∇q‖ − E²Λ`` towards the conic; so
``|q| + E²Λ ≤ E‖∇q‖`` shows that x is at most E away from the conic. Where ``‖∇q‖ ≥ 64 EΛ``, the lines along the
gradient lead from the curve to the conic within 17/16 E, and do not meet each other; the curve advances along the conic
where ``[∇q, γ′]`` keeps its sign. For lines and circles simpler conditions have the same meaning.

In space a circle or a conic is the intersection of a plane with a cylinder orthogonal to the plane. A point at most
``3/5 E`` away from the plane and at most ``4/5 E`` away from the cylinder is at most E away from this intersection.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import chain, combinations
from operator import sub
from typing import Any, Protocol, cast

import flint
from gmpy2 import isqrt

from exactspline.language.vector import Vector, cross, det
from exactspline.language.wronskians import wronskians
from exactspline.numbers.exact import from_flint, mpq, primitive, scalar, sign, to_fmpq
from exactspline.numbers.once import cached_property
from exactspline.one_line import OneLine, one_line
from exactspline.reals.real import Real, real, square_root
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.words import Word

Point = tuple[mpq, ...]
NOTHING = mpq(0)
#: The parts (n, d) of a squared distance: the sum of n²/d is approximately w² times the squared distance, and 0 only on
#: the shape.
Parts = Sequence[tuple[Any, Any]]
#: Steps along the gradient lead to the shape within this multiple of E.
ALONG_GRADIENT = mpq(17, 16)
#: The least ratio of the gradient to EΛ for this.
STEEP = 64
#: The fractions of E allowed in the plane of a curve and orthogonal to this plane.
IN_PLANE, ACROSS = mpq(4, 5), mpq(3, 5)


class Homogeneous(Protocol):
    """A curve, a surface or a point: homogeneous coordinates ``(p, w)`` that are multiplied and added."""

    @property
    def p(self) -> Any:
        """The coordinates times w."""

    @property
    def w(self) -> Any:
        """The weight function."""


@dataclass(frozen=True, repr=False)
class PointToAsk(OneLine):
    """A point as an argument of the methods of a shape."""

    p: Point
    w: mpq


class ShapeKind(Word):
    """The kinds of shapes."""

    LINE = "line"
    CIRCLE = "circle"
    ELLIPSE = "ellipse"
    PARABOLA = "parabola"
    HYPERBOLA = "hyperbola"
    PLANE = "plane"
    SPHERE = "sphere"
    CYLINDER = "cylinder"
    CONE = "cone"
    TORUS = "torus"


class Shape(OneLine, ABC):
    """A curve or a surface of one of the simple kinds in `ShapeKind`."""

    kind: ShapeKind

    def __post_init__(self) -> None:
        """Make the integers of the vectors coprime."""
        for name in ("direction", "normal", "axis"):
            if vector := vars(self).get(name):
                object.__setattr__(self, name, primitive(vector))

    @property
    @abstractmethod
    def numbers(self) -> dict[str, tuple[Real, ...]]:
        """The numbers that describe the shape, by name: centre, radius, …"""

    @one_line
    def __str__(self) -> str:
        numbers = ", ".join(f"{name} {_shown(values)}" for name, values in self.numbers.items())
        return f"{self.kind}: {numbers}" if numbers else str(self.kind)

    @property
    def most(self) -> mpq | None:
        """The largest distance for which `margins` may be used; None if there is no limit."""
        return None

    @abstractmethod
    def parts(self, of: Homogeneous) -> Parts:
        """Functions that vanish on the shape, with their denominators."""

    @abstractmethod
    def margins(self, of: Homogeneous, within: mpq) -> Iterable[Any]:
        """Functions that are nowhere negative only if the whole curve or surface is within this distance."""

    def estimate(self, point: Point) -> mpq:
        """The approximate squared distance of a point, with which the search for a proved bound begins."""
        return sum((n * n / d if d else n * n for n, d in self.parts(PointToAsk(point, mpq(1)))), start=NOTHING)

    def holds(self, of: Homogeneous) -> bool:
        """Whether the whole curve or surface lies on the shape."""
        return all(n.is_zero for n, _ in self.parts(of))


class CurveShape(Shape):
    """A shape along which a curve can run; in space with a vector orthogonal to its plane."""

    #: Whether the shape is closed, so that a curve can run around it more than once.
    closes = False
    normal: Point = ()

    @abstractmethod
    def advance(self, curve: Nurbs) -> BSpline:
        """A function with the sign of the speed at which the curve runs along the shape."""

    def _turning(self, across: Vector[BSpline], curve: Nurbs) -> BSpline:
        """A function with the sign of the speed of a curve to the left of a vector, in the plane of the shape."""
        velocity = wronskians(curve.w, curve.p)
        return cast(BSpline, scalar(cross(across, velocity), self.normal) if self.normal else det(across, velocity))


@dataclass(frozen=True, repr=False)
class Line(CurveShape):
    """The line through a point in a direction, in the plane or in space."""

    point: Point
    direction: Point
    kind = ShapeKind.LINE

    @property
    def numbers(self) -> dict[str, tuple[Real, ...]]:
        """A point of the line, and the direction of the line."""
        return {"point": _reals(self.point), "direction": _reals(self.direction)}

    def parts(self, of: Homogeneous) -> Parts:
        """Functions that vanish on the shape."""
        bottom = of.w * of.w * scalar(self.direction, self.direction)
        return [(x, bottom) for x in _beside(_from(of, self.point), self.direction)]

    def margins(self, of: Homogeneous, within: mpq) -> Iterable[Any]:
        """Functions that are nowhere negative only if the whole curve is within this distance."""
        return [_square_margin(self.parts(of), within)]

    def advance(self, curve: Nurbs) -> BSpline:
        """A function with the sign of the speed of a curve along the shape."""
        return cast(BSpline, scalar(wronskians(curve.w, curve.p), self.direction))


@dataclass(frozen=True, repr=False)
class Plane(Shape):
    """The plane through a point orthogonal to a vector."""

    point: Point
    normal: Point
    kind = ShapeKind.PLANE

    @property
    def numbers(self) -> dict[str, tuple[Real, ...]]:
        """The normal vector, and its scalar product with the points of the plane."""
        return {"normal": _reals(self.normal), "offset": (real(scalar(self.point, self.normal)),)}

    def parts(self, of: Homogeneous) -> Parts:
        """Functions that vanish on the shape."""
        return [(scalar(_from(of, self.point), self.normal), of.w * of.w * scalar(self.normal, self.normal))]

    def margins(self, of: Homogeneous, within: mpq) -> Iterable[Any]:
        """Functions that are nowhere negative only if all points are within this distance."""
        return [_square_margin(self.parts(of), within)]


@dataclass(frozen=True, repr=False)
class _Round(Shape):
    """A shape of constant distance from a centre or an axis, given by the square of this distance."""

    centre: Point
    radius_squared: mpq

    @property
    def radius(self) -> Real:
        """The radius of the shape."""
        return square_root(self.radius_squared)

    @property
    def most(self) -> mpq | None:
        """The largest distance for which `margins` may be used."""
        return self.radius_squared / upper_square_root(self.radius_squared) / 8

    def _squared(self, of: Homogeneous) -> tuple[Any, Any]:
        """The numerator and the denominator of the squared distance from the centre or the axis."""
        offset = _from(of, self.centre)
        return scalar(offset, offset), of.w * of.w

    def parts(self, of: Homogeneous) -> Parts:
        """Functions that vanish on the shape."""
        squared, one = self._squared(of)
        return [(squared - one * self.radius_squared, one * one * (4 * self.radius_squared))]

    def margins(self, of: Homogeneous, within: mpq) -> Iterable[Any]:
        """Functions that are nowhere negative only if all points are within this distance."""
        squared, one = self._squared(of)
        inner, outer = _ends(self.radius_squared, within)
        return [one * (outer * outer) - squared, squared - one * (inner * inner)]


@dataclass(frozen=True, repr=False)
class Sphere(_Round):
    """A sphere by its centre and the square of its radius."""

    kind = ShapeKind.SPHERE

    @property
    def numbers(self) -> dict[str, tuple[Real, ...]]:
        """Centre and radius."""
        return {"centre": _reals(self.centre), "radius": (self.radius,)}


@dataclass(frozen=True, repr=False)
class Cylinder(_Round):
    """A cylinder by a point and the direction of its axis and the square of its radius."""

    axis: Point
    kind = ShapeKind.CYLINDER

    @property
    def numbers(self) -> dict[str, tuple[Real, ...]]:
        """A point of the axis, its direction, the radius."""
        return {"point": _reals(self.centre), "axis": _reals(self.axis), "radius": (self.radius,)}

    def _squared(self, of: Homogeneous) -> tuple[Any, Any]:
        beside = _beside(_from(of, self.centre), self.axis)
        return scalar(beside, beside), of.w * of.w * scalar(self.axis, self.axis)


@dataclass(frozen=True, repr=False)
class Circle(_Round, CurveShape):
    """A circle by its centre and the square of its radius; in space with a vector orthogonal to its plane."""

    normal: Point = ()
    kind = ShapeKind.CIRCLE
    closes = True

    @property
    def numbers(self) -> dict[str, tuple[Real, ...]]:
        """Centre and radius, in space the normal of its plane."""
        found = {"centre": _reals(self.centre), "radius": (self.radius,)}
        return found | {"normal": _reals(self.normal)} if self.normal else found

    @property
    def _in_space(self) -> tuple[Plane, Cylinder]:
        return Plane(self.centre, self.normal), Cylinder(self.centre, self.radius_squared, self.normal)

    def parts(self, of: Homogeneous) -> Parts:
        """Functions that vanish on the shape."""
        return [part for each in self._in_space for part in each.parts(of)] if self.normal else super().parts(of)

    def margins(self, of: Homogeneous, within: mpq) -> Iterable[Any]:
        """Functions that are nowhere negative only if the whole curve is within this distance."""
        if not self.normal:
            return super().margins(of, within)
        plane, cylinder = self._in_space
        return chain(plane.margins(of, within * ACROSS), cylinder.margins(of, within * IN_PLANE))

    def advance(self, curve: Nurbs) -> BSpline:
        """A function with the sign of the speed of a curve along the shape."""
        return self._turning(_from(curve, self.centre), curve)


@dataclass(frozen=True, repr=False)
class Cone(Shape):
    """A cone, with both its halves, by its apex, the direction of its axis and the square of tan α for the angle α
    between axis and rulings.
    """

    apex: Point
    axis: Point
    tangent_squared: mpq
    kind = ShapeKind.CONE

    @property
    def numbers(self) -> dict[str, tuple[Real, ...]]:
        """Apex, direction of the axis, tangent of the half angle."""
        return {"apex": _reals(self.apex), "axis": _reals(self.axis), "tan": (square_root(self.tangent_squared),)}

    def _squares(self, of: Homogeneous) -> tuple[Any, Any, mpq]:
        """X and Y, as described in the module, and their common denominator."""
        offset, one = _from(of, self.apex), scalar(self.axis, self.axis)
        along, beside = scalar(offset, self.axis), _beside(offset, self.axis)
        return scalar(beside, beside), along * along * self.tangent_squared, one * (1 + self.tangent_squared)

    def parts(self, of: Homogeneous) -> Parts:
        """Functions that vanish on the shape."""
        x, y, scale = self._squares(of)
        return [(x - y, (x + y) * of.w * of.w * (2 * scale))]

    def margins(self, of: Homogeneous, within: mpq) -> Iterable[Any]:
        """Functions that are nowhere negative only if all points are within this distance."""
        x, y, scale = self._squares(of)
        return [(x + y) * of.w * of.w * (within * within * scale) - (x - y) * (x - y)]


@dataclass(frozen=True, repr=False)
class Torus(Shape):
    """A ring torus, given by its centre, the direction of its axis, and the squares of two radii: the distance R
    between the axis and the centre of the rotating circle, and the radius r < R of this circle.
    """

    centre: Point
    axis: Point
    major_squared: mpq
    minor_squared: mpq
    kind = ShapeKind.TORUS

    @property
    def numbers(self) -> dict[str, tuple[Real, ...]]:
        """Centre, direction of the axis, both radii."""
        radii = [square_root(x) for x in (self.major_squared, self.minor_squared)]
        return {"centre": _reals(self.centre), "axis": _reals(self.axis), "radii": tuple(radii)}

    @property
    def most(self) -> mpq | None:
        """The largest distance for which `margins` may be used: within it the torus keeps its hole."""
        minor = upper_square_root(self.minor_squared)
        hole = self.major_squared / upper_square_root(self.major_squared) - minor
        return min(self.minor_squared / minor, hole) / 8

    def _squares(self, of: Homogeneous) -> tuple[Any, Any, Any]:
        """‖x‖², 4 R² ρ² and the denominator of the latter, all times w²."""
        offset = _from(of, self.centre)
        beside = _beside(offset, self.axis)
        return scalar(offset, offset), scalar(beside, beside) * (4 * self.major_squared), scalar(self.axis, self.axis)

    def parts(self, of: Homogeneous) -> Parts:
        """Functions that vanish on the shape."""
        whole, beside, one = self._squares(of)
        w2 = of.w * of.w
        level = whole + w2 * (self.major_squared - self.minor_squared)
        return [(level * level * one - w2 * beside, w2 * w2 * beside * (16 * self.minor_squared * one))]

    def margins(self, of: Homogeneous, within: mpq) -> Iterable[Any]:
        """Functions that are nowhere negative only if all points are within this distance."""
        whole, beside, one = self._squares(of)
        w2 = of.w * of.w
        for end, s in zip(_ends(self.minor_squared, within), (1, -1), strict=True):
            level = whole + w2 * (self.major_squared - end * end)
            yield (level * level * one - w2 * beside) * s


@dataclass(frozen=True, repr=False)
class Conic(CurveShape):
    """A conic, ``(x, 1) Q (x, 1)ᵀ = 0`` with a symmetric matrix Q; in the plane Q is regular; in space q is constant
    along a vector orthogonal to the plane of the conic, and a point of this plane is given.
    """

    matrix: tuple[tuple[mpq, ...], ...]
    normal: Point = ()
    point: Point = ()

    @cached_property
    def kind(self) -> ShapeKind:  # type: ignore[override]  # known when the matrix is
        """Ellipse, parabola or hyperbola."""
        return {1: ShapeKind.ELLIPSE, 0: ShapeKind.PARABOLA, -1: ShapeKind.HYPERBOLA}[sign(self._minor)]

    @property
    def closes(self) -> bool:  # type: ignore[override]  # likewise
        """Whether the conic is an ellipse."""
        return self.kind is ShapeKind.ELLIPSE

    @cached_property
    def _quadratic(self) -> list[Point]:
        return [row[:-1] for row in self.matrix[:-1]]

    @cached_property
    def _linear(self) -> Point:
        return tuple(row[-1] for row in self.matrix[:-1])

    @cached_property
    def _minor(self) -> mpq:
        """The product of the eigenvalues of the quadratic part, except the eigenvalue 0 of the normal."""
        a, pairs = self._quadratic, combinations(range(len(self._quadratic)), 2)
        return sum((a[i][i] * a[j][j] - a[i][j] * a[i][j] for i, j in pairs), start=NOTHING)

    @cached_property
    def centre(self) -> Point | None:
        """The centre of an ellipse or a hyperbola."""
        return self._where(self._quadratic, [-x for x in self._linear]) if self._minor else None

    def _where(self, rows: Sequence[Sequence[mpq]], right: Sequence[mpq]) -> Point:
        """The point of the plane of the conic that solves these equations."""
        if n := self.normal:
            level = scalar(n, self.point)
            rows = [[x + a * b for x, b in zip(row, n, strict=True)] for row, a in zip(rows, n, strict=True)]
            right = [x + a * level for x, a in zip(right, n, strict=True)]
        found = solved(rows, right)
        assert found is not None  # the conic is regular
        return tuple(found)

    @cached_property
    def semi_axes(self) -> tuple[Real, ...]:
        """The two half axes, the longer one first; for a hyperbola the axis that meets it first; none for a
        parabola.
        """
        if self.centre is None:
            return ()
        # in the main axes the conic is λ x² + μ y² = −q(centre)
        trace = sum((row[i] for i, row in enumerate(self._quadratic)), start=NOTHING)
        spread, level = square_root(trace * trace - 4 * self._minor), -self._value(PointToAsk(self.centre, mpq(1)))[0]
        squares = [real(level) / ((real(trace) + s * spread) / 2) for s in (1, -1)]
        return tuple(square_root(abs(x)) for x in sorted(squares, reverse=True))

    @property
    def numbers(self) -> dict[str, tuple[Real, ...]]:
        """The centre and the half axes; for a parabola the vertex and the direction in which it opens."""
        in_space = {"normal": _reals(self.normal)} if self.normal else {}
        if self.centre is not None:
            return {"centre": _reals(self.centre), "half axes": self.semi_axes} | in_space
        vertex, opening = self._vertex
        return {"vertex": _reals(vertex), "axis": _reals(primitive(opening, oriented=True))} | in_space

    @property
    def _vertex(self) -> tuple[Point, Point]:
        """The vertex and the direction of a parabola ``q = λ (v·x)² + 2 b·x + c``; at the vertex the gradient is
        parallel to the axis.
        """
        a, b, c = self._quadratic, self._linear, self.matrix[-1][-1]
        k = max(range(len(a)), key=lambda i: abs(a[i][i]))
        across, share = tuple(a[k]), a[k][k]
        axis = cross_product(self.normal, across) if self.normal else (-across[1], across[0])
        opens = -sign(scalar(axis, b)) * sign(share)
        axis = tuple(opens * x for x in axis)
        # the quadratic part is (across·x)² / share
        along = -scalar(across, b) * share / scalar(across, across)
        level = -(along * along / share + c) / 2
        rest = scalar(b, across) / scalar(across, across)
        steep = scalar(axis, b) / scalar(axis, axis)
        height = (level - rest * along) / steep
        rows = [[x * y + u * v for y, v in zip(across, axis, strict=True)] for x, u in zip(across, axis, strict=True)]
        return self._where(rows, [x * along + u * height for x, u in zip(across, axis, strict=True)]), axis

    @cached_property
    def _bending(self) -> mpq:
        """Λ: a bound on the largest eigenvalue of the quadratic part."""
        return upper_square_root(sum((x * x for row in self._quadratic for x in row), start=NOTHING))

    def _value(self, of: Homogeneous) -> tuple[Any, Vector[Any]]:
        """q times w², and half its gradient times w."""
        coordinates = (*of.p, of.w)
        images = [scalar(coordinates, row) for row in self.matrix]
        return scalar(images, coordinates), Vector(*images[:-1])

    def parts(self, of: Homogeneous) -> Parts:
        """Functions that vanish on the shape."""
        value, gradient = self._value(of)
        own = [(value, of.w * of.w * scalar(gradient, gradient) * 4)]
        return [*own, *Plane(self.point, self.normal).parts(of)] if self.normal else own

    def margins(self, of: Homogeneous, within: mpq) -> Iterable[Any]:
        """Functions that are nowhere negative only if the whole curve is within this distance."""
        if self.normal:
            yield from Plane(self.point, self.normal).margins(of, within * ACROSS)
            within = within * IN_PLANE
        away, w2, (value, gradient) = within / ALONG_GRADIENT, of.w * of.w, self._value(of)
        steepness, step = scalar(gradient, gradient) * 4, away * away * self._bending
        reach, least = steepness * w2 * (away * away), STEEP * away * self._bending
        for s in (1, -1):
            yield reach - (value + w2 * (s * step)) * (value + w2 * (s * step))
        yield steepness - w2 * (least * least)

    def estimate(self, point: Point) -> mpq:
        """The approximate squared distance of a point, in the plane with as few operations as possible, because this
        method is called most often.
        """
        if len(point) > 2:
            return super().estimate(point)
        ((a, b, d), (_, c, e), (*_, f)), (x, y) = self.matrix, point
        u, v = a * x + b * y + d, b * x + c * y + e
        value, steepness = (u + d) * x + (v + e) * y + f, u * u + v * v
        return value * value / (4 * steepness) if steepness else value * value

    def advance(self, curve: Nurbs) -> BSpline:
        """A function with the sign of the speed of a curve along the shape."""
        return self._turning(self._value(curve)[1], curve)


def _ends(radius_squared: mpq, within: mpq) -> tuple[mpq, mpq]:
    """A radius minus a distance, rounded up, and the radius plus the distance, rounded down."""
    radius = upper_square_root(radius_squared)
    return radius - within, radius_squared / radius + within


def _square_margin(parts: Parts, within: mpq) -> Any:
    """A function that is not negative where the sum of the squares of parts with the same denominator is small."""
    left = parts[0][1] * (within * within)
    for n, _ in parts:
        left = left - n * n
    return left


def _from(of: Homogeneous, point: Point) -> Vector[Any]:
    """w times the vector from a point."""
    return Vector(*[x - of.w * a for x, a in zip(of.p, point, strict=True)])


def _beside(offset: Vector[Any], u: Point) -> Sequence[Any]:
    """The cross product with a constant vector; in the plane its one component."""
    return [offset[0] * u[1] - offset[1] * u[0]] if len(u) == 2 else cross_product(list(offset), u)


def cross_product(a: Sequence[Any], b: Sequence[Any]) -> tuple[Any, ...]:
    """The vector product of operands or numbers."""
    return tuple(a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3))


def _reals(point: Point) -> tuple[Real, ...]:
    return tuple(map(real, point))


def minus(a: Point, b: Point) -> Point:
    """The vector from b to a."""
    return tuple(map(sub, a, b))


def solved(rows: Sequence[Sequence[mpq]], right: Sequence[mpq]) -> list[mpq] | None:
    """The solution of a linear system; None unless there is exactly one."""
    n = len(right)
    matrix = flint.fmpq_mat(n, n, [to_fmpq(x) for row in rows for x in row])
    try:
        found = matrix.solve(flint.fmpq_mat(n, 1, [to_fmpq(x) for x in right]))
    except ZeroDivisionError:
        return None
    return [from_flint(found[i, 0]) for i in range(n)]


def upper_square_root(q: mpq) -> mpq:
    """A rational number that is at least √q and exceeds it by less than 2⁻⁴⁰ √q; exactly √q if this is rational.

    >>> upper_square_root(mpq(9, 4)), 2 < upper_square_root(mpq(2)) ** 2 < 2 + mpq(1, 2**38)
    (mpq(3,2), True)
    """
    if not q:
        return mpq(0)
    n = q.numerator * q.denominator
    shift = max(0, 96 - n.bit_length()) // 2 * 2
    scaled = n << shift
    root = isqrt(scaled)
    return mpq(root + (root * root != scaled), q.denominator << shift // 2)


def _shown(values: Sequence[Real]) -> str:
    texts = [x.shortly() for x in values]
    return texts[0] if len(texts) == 1 else f"({', '.join(texts)})"
