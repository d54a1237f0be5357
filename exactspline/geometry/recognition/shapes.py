"""Lines, circles and conics, and what it means that a curve lies within a distance E of one and runs over an arc of it
once: polynomials in the parameter that must keep one sign.

Let q be a polynomial of degree at most 2 whose zeros are the shape, and Λ a bound on half of its second derivatives.
From a point x, a step of length E along the gradient changes q by at least ``E‖∇q‖ − E²Λ`` towards the shape; so
``|q| + E²Λ ≤ E‖∇q‖`` shows that x is at most E away from the shape. Where ``‖∇q‖ ≥ 64 EΛ``, the lines along the
gradient lead from the curve to the shape within 17/16 E, and meet no other; the curve goes on along the shape where
``[∇q, γ′]`` keeps its sign. For lines and circles both are said more simply, with the same meaning.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from operator import mul, sub

from gmpy2 import isqrt

from exactspline.language.vector import Vector, cross, det, dot, norm2
from exactspline.language.wronskians import wronskians
from exactspline.numbers.exact import mpq, sign
from exactspline.reals.real import Real, real, square_root
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.words import Word

Point = tuple[mpq, ...]
NOTHING = mpq(0)
#: Steps along the gradient lead to the shape within this multiple of E.
ALONG_GRADIENT = mpq(17, 16)
#: How much larger than EΛ the gradient has to be for that.
STEEP = 64


class ShapeKind(Word):
    """The kinds of shapes."""

    LINE = "line"
    CIRCLE = "circle"
    ELLIPSE = "ellipse"
    PARABOLA = "parabola"
    HYPERBOLA = "hyperbola"


class Shape(ABC):
    """A line, a circle or a conic."""

    kind: ShapeKind
    #: Whether it closes, so that a curve can run over it more than once.
    closes = False

    @property
    @abstractmethod
    def numbers(self) -> dict[str, tuple[Real, ...]]:
        """What describes it, by name: centre, radius, …"""

    def __str__(self) -> str:
        numbers = ", ".join(f"{name} {_shown(values)}" for name, values in self.numbers.items())
        return f"{self.kind}: {numbers}" if numbers else str(self.kind)

    @property
    def most(self) -> mpq | None:
        """The largest distance for which `margins` may be asked, None for any."""
        return None

    @abstractmethod
    def estimate(self, point: Point) -> mpq:
        """About the square of the distance of a point: where to begin the search for a bound that is proved."""

    @abstractmethod
    def holds(self, curve: Nurbs) -> bool:
        """Whether the whole curve lies on the shape."""

    @abstractmethod
    def margins(self, curve: Nurbs, within: mpq) -> Sequence[BSpline]:
        """Functions that are nowhere negative only where the curve lies within this distance of the shape."""

    @abstractmethod
    def advance(self, curve: Nurbs) -> BSpline:
        """A function with the sign of the speed at which the curve runs along the shape."""


@dataclass(frozen=True)
class Line(Shape):
    """The line through a point in a direction, in the plane or in space."""

    point: Point
    direction: Point
    kind = ShapeKind.LINE

    @property
    def numbers(self) -> dict[str, tuple[Real, ...]]:
        """A point of it, and its direction."""
        return {"point": tuple(map(real, self.point)), "direction": tuple(map(real, self.direction))}

    @cached_property
    def _square(self) -> mpq:
        return scalar(self.direction, self.direction)

    def estimate(self, point: Point) -> mpq:
        """About the square of the distance of a point."""
        offset = minus(point, self.point)
        along = scalar(offset, self.direction)
        return scalar(offset, offset) - along * along / self._square

    def _away(self, curve: Nurbs) -> BSpline:
        """‖u‖² w² times the square of the distance from the line."""
        offset = _from(curve, self.point)
        if curve.dimension == 2:
            across = offset[0] * self.direction[1] - offset[1] * self.direction[0]
            return across * across
        u = self.direction
        return norm2(Vector(*[offset[i - 2] * u[i - 1] - offset[i - 1] * u[i - 2] for i in range(3)]))

    def holds(self, curve: Nurbs) -> bool:
        """Whether the whole curve lies on it."""
        return self._away(curve).is_zero

    def margins(self, curve: Nurbs, within: mpq) -> Sequence[BSpline]:
        """Functions that are nowhere negative only where the curve lies within this distance."""
        return (curve.w * curve.w * (within * within * self._square) - self._away(curve),)

    def advance(self, curve: Nurbs) -> BSpline:
        """A function with the sign of the speed along it."""
        return _along(wronskians(curve.w, curve.p), self.direction)


@dataclass(frozen=True)
class Circle(Shape):
    """A circle by its centre and the square of its radius; in space with a vector orthogonal to its plane."""

    centre: Point
    radius_squared: mpq
    normal: Point = ()
    kind = ShapeKind.CIRCLE
    closes = True

    @property
    def radius(self) -> Real:
        """The radius."""
        return square_root(self.radius_squared)

    @property
    def most(self) -> mpq | None:
        """The largest distance for which `margins` may be asked."""
        return self.radius_squared / upper_square_root(self.radius_squared) / 8

    @property
    def numbers(self) -> dict[str, tuple[Real, ...]]:
        """Centre and radius, in space the normal of its plane."""
        found = {"centre": tuple(map(real, self.centre)), "radius": (self.radius,)}
        return found | {"normal": tuple(map(real, self.normal))} if self.normal else found

    def estimate(self, point: Point) -> mpq:
        """About the square of the distance of a point."""
        offset = minus(point, self.centre)
        distance = scalar(offset, offset) - self.radius_squared
        radial = distance * distance / (4 * self.radius_squared)
        if not self.normal:
            return radial
        height = scalar(offset, self.normal)
        return radial + height * height / scalar(self.normal, self.normal)

    def _height(self, curve: Nurbs) -> BSpline:
        return _along(_from(curve, self.centre), self.normal)

    def holds(self, curve: Nurbs) -> bool:
        """Whether the whole curve lies on it."""
        on_sphere = norm2(_from(curve, self.centre)) - curve.w * curve.w * self.radius_squared
        return on_sphere.is_zero and not (self.normal and not self._height(curve).is_zero)

    def margins(self, curve: Nurbs, within: mpq) -> Sequence[BSpline]:
        """Functions that are nowhere negative only where the curve lies within this distance."""
        squared, w2 = norm2(_from(curve, self.centre)), curve.w * curve.w
        if not self.normal:
            return _in_ring(squared, w2, self.radius_squared, within)
        # e = 5/8 E away from the plane and from the sphere: at most √(e² + (e + e²/(r − e))²) < E, as E ≤ r/8
        part, height = within * 5 / 8, self._height(curve)
        flat = w2 * (part * part * scalar(self.normal, self.normal)) - height * height
        return (flat, *_in_ring(squared, w2, self.radius_squared, part))

    def advance(self, curve: Nurbs) -> BSpline:
        """A function with the sign of the speed along it."""
        offset, velocity = _from(curve, self.centre), wronskians(curve.w, curve.p)
        return _along(cross(offset, velocity), self.normal) if self.normal else det(offset, velocity)


@dataclass(frozen=True)
class Conic(Shape):
    """A conic of the plane, ``(x, y, 1) Q (x, y, 1)ᵀ = 0`` with a symmetric matrix Q that is regular."""

    matrix: tuple[tuple[mpq, ...], ...]

    @cached_property
    def kind(self) -> ShapeKind:  # type: ignore[override]  # known when the matrix is
        """Ellipse, parabola or hyperbola."""
        kinds = {1: ShapeKind.ELLIPSE, 0: ShapeKind.PARABOLA, -1: ShapeKind.HYPERBOLA}
        return kinds[sign(self._minor)]

    @property
    def closes(self) -> bool:  # type: ignore[override]  # likewise
        """Whether it is an ellipse."""
        return self.kind is ShapeKind.ELLIPSE

    @cached_property
    def _minor(self) -> mpq:
        (a, b, _), (_, c, _), _ = self.matrix
        return a * c - b * b

    @cached_property
    def determinant(self) -> mpq:
        """det Q: 0 for pairs of lines."""
        (a, b, d), (_, c, e), (_, _, f) = self.matrix
        return a * (c * f - e * e) - b * (b * f - d * e) + d * (b * e - c * d)

    @cached_property
    def centre(self) -> Point | None:
        """The centre of an ellipse or a hyperbola."""
        (a, b, d), (_, c, e), _ = self.matrix
        m = self._minor
        return ((b * e - c * d) / m, (b * d - a * e) / m) if m else None

    @cached_property
    def semi_axes(self) -> tuple[Real, ...]:
        """The two half axes, the longer one first; of a hyperbola the one that meets it first, of a parabola none."""
        (a, b, _), (_, c, _), _ = self.matrix
        if not self._minor:
            return ()
        # in the main axes the conic is λ x² + μ y² = −det Q / (λ μ)
        spread, level = square_root((a - c) * (a - c) + 4 * b * b), -self.determinant / self._minor
        squares = [real(level) / ((real(a + c) + s * spread) / 2) for s in (1, -1)]
        return tuple(square_root(abs(x)) for x in sorted(squares, reverse=True))

    @property
    def numbers(self) -> dict[str, tuple[Real, ...]]:
        """Centre and half axes, of a parabola nothing."""
        if self.centre is None:
            return {}
        return {"centre": tuple(map(real, self.centre)), "half axes": self.semi_axes}

    def estimate(self, point: Point) -> mpq:
        """About the square of the distance of a point."""
        homogeneous = (*point, mpq(1))
        images = [scalar(row, homogeneous) for row in self.matrix]
        value = scalar(homogeneous, images)
        slope = 4 * (images[0] * images[0] + images[1] * images[1])
        return value * value / slope if slope else value * value

    @cached_property
    def _bending(self) -> mpq:
        """Λ: a bound on the largest eigenvalue of the quadratic part."""
        (a, b, _), (_, c, _), _ = self.matrix
        return upper_square_root(a * a + 2 * b * b + c * c)

    def _images(self, curve: Nurbs) -> tuple[BSpline, ...]:
        coordinates = (*curve.p, curve.w)
        return tuple(_along(Vector(*coordinates), row) for row in self.matrix)

    def _value(self, curve: Nurbs) -> BSpline:
        value: BSpline = dot(Vector(*curve.p, curve.w), Vector(*self._images(curve)))
        return value

    def holds(self, curve: Nurbs) -> bool:
        """Whether the whole curve lies on it."""
        return self._value(curve).is_zero

    def margins(self, curve: Nurbs, within: mpq) -> Sequence[BSpline]:
        """Functions that are nowhere negative only where the curve lies within this distance."""
        away, w2, value = within / ALONG_GRADIENT, curve.w * curve.w, self._value(curve)
        gradient, step = norm2(Vector(*self._images(curve)[:2])) * 4, away * away * self._bending
        reach, least = gradient * w2 * (away * away), STEEP * away * self._bending
        near = [reach - (value + w2 * (s * step)) * (value + w2 * (s * step)) for s in (1, -1)]
        return (*near, gradient - w2 * (least * least))

    def advance(self, curve: Nurbs) -> BSpline:
        """A function with the sign of the speed along it."""
        return det(Vector(*self._images(curve)[:2]), wronskians(curve.w, curve.p))


def _in_ring(squared: BSpline, w2: BSpline, radius_squared: mpq, within: mpq) -> tuple[BSpline, ...]:
    """Functions that are not negative where the distance from a centre differs from a radius by at most a bound."""
    radius = upper_square_root(radius_squared)
    excess = radius - radius_squared / radius
    inner, outer = radius - within, radius - excess + within
    return w2 * (outer * outer) - squared, squared - w2 * (inner * inner)


def _from(curve: Nurbs, point: Point) -> Vector[BSpline]:
    """w times the vector from a point to the curve."""
    return Vector(*[x - curve.w * a for x, a in zip(curve.p, point, strict=True)])


def _along(vector: Vector[BSpline], direction: Sequence[mpq]) -> BSpline:
    """The scalar product with a constant vector."""
    total = vector[0] * direction[0]
    for x, u in zip(vector[1:], direction[1:], strict=True):
        total = total + x * u
    return total


def scalar(a: Sequence[mpq], b: Sequence[mpq]) -> mpq:
    """The scalar product of two tuples of numbers."""
    return sum(map(mul, a, b), start=NOTHING)


def minus(a: Point, b: Point) -> Point:
    """The vector from b to a."""
    return tuple(map(sub, a, b))


def upper_square_root(q: mpq) -> mpq:
    """A rational number that is at least √q, by less than 2⁻⁴⁰ of it; exactly √q where that is rational.

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
    return str(values[0]) if len(values) == 1 else f"({', '.join(map(str, values))})"
