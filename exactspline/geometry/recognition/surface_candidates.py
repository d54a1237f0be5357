"""Planes, spheres, cylinders, cones and tori on which points may lie: guesses, from which a proof begins. Nothing rests
on them but how close they come.

The normals of a surface of revolution meet its axis: in Plücker's coordinates a linear condition (Pottmann and Wallner,
Computational Line Geometry 2001). From there on the distances from the shape are made least by Gauss's and Newton's
method in long binary numbers; numbers of a shape that seems to be exact are replaced by simple rational ones.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import gmpy2
from gmpy2 import mpfr

from exactspline.geometry.recognition import candidates
from exactspline.geometry.recognition.candidates import FINE, ROUND, WORSE, rounded
from exactspline.geometry.recognition.shapes import (
    Cone,
    Cylinder,
    Plane,
    Point,
    Shape,
    Sphere,
    Torus,
    cross_product,
    minus,
    scalar,
    solved,
)
from exactspline.numbers.exact import decimal_unit, mpq, sign
from exactspline.one_line import OneLine

#: Bits of the numbers in which distances are made least, and of the steps that show how they change.
BITS, STEP = 256, mpq(1, 2**100)
#: Distances below this fraction of the size are thought to be 0, and denominators of exact numbers to be at most this.
NOTHING, SIMPLE = mpq(1, 2**120), 10**20
#: The most steps of the iteration, and the points it uses, at most.
STEPS, MOST_SAMPLES = 16, 64

Numbers = Sequence[mpfr]


@dataclass(frozen=True, repr=False)
class Sample(OneLine):
    """A point of a surface, and a vector orthogonal to it there, 0 where there is none."""

    point: Point
    normal: Point


@dataclass(frozen=True)
class _Model:
    """A kind of shapes by numbers: a point and a direction of the axis, and others. `away` are the distances of a
    point, by its distance from the axis and its place along it from the point on; `shape` of the exact squares of the
    other numbers.
    """

    away: Callable[[mpfr, mpfr, Numbers], mpfr]
    shape: Callable[..., Shape]
    #: Whether the point may be any point of the axis.
    slides: bool = False


CYLINDER = _Model(lambda rho, z, k: rho - k[0], lambda a, d, r: Cylinder(a, r, d), slides=True)
CONE = _Model(lambda rho, z, k: (rho - abs(z) * k[0]) / gmpy2.sqrt(1 + k[0] * k[0]), Cone)
TORUS = _Model(lambda rho, z, k: gmpy2.sqrt((rho - k[0]) * (rho - k[0]) + z * z) - k[1], Torus)


def proposed(samples: Sequence[Sample], limit: mpq) -> Iterator[Shape]:
    """Shapes, the simplest first, which come about as close to samples as a limit."""
    points = [x.point for x in samples]
    found = False
    for plane in candidates.planes(points, limit):
        found = True
        yield plane
    if not found and (sphere := candidates.sphere(points, limit)) is not None:
        found = True
        yield Sphere(sphere.centre, sphere.radius_squared)
    if not found:
        with gmpy2.context(gmpy2.get_context(), precision=BITS):
            made = list(_around_axes(samples, limit))
        yield from made


def _around_axes(samples: Sequence[Sample], limit: mpq) -> Iterator[Shape]:
    """Cylinders, cones and tori."""
    few = samples[:: -(-len(samples) // MOST_SAMPLES)]
    middle, size = candidates.box([x.point for x in few])
    local = [
        (
            tuple(rounded((x - m) / size, ROUND) for x, m in zip(each.point, middle, strict=True)),
            tuple(rounded(n / max(map(abs, each.normal)), ROUND) for n in each.normal),
        )
        for each in few
        if any(each.normal)
    ]
    for model, start in _starts(local):
        fitted = _Fit(model, [[(x - m) / size for x, m in zip(each.point, middle, strict=True)] for each in few])
        if fitted.worst(start) * size > limit * WORSE and fitted.worst(start) > mpq(1, 64):
            continue
        for shape in fitted.shapes(fitted.improved(start), middle, size):
            if candidates.all_near(shape, [x.point for x in samples], limit * limit):
                yield shape
                break


def _starts(local: Sequence[tuple[Point, Point]]) -> Iterator[tuple[_Model, list[mpfr]]]:
    """Kinds of shapes with numbers from which to begin."""
    if axis := candidates.least([n for _, n in local]):
        square = scalar(axis, axis)
        flat = [tuple(x - scalar(p, axis) / square * u for x, u in zip(p, axis, strict=True)) for p, _ in local]
        circle = candidates.fitted_circle(flat, Plane((mpq(0),) * 3, tuple(axis)))
        if circle is not None:
            yield CYLINDER, _numbers(circle.centre, axis, gmpy2.sqrt(mpfr(circle.radius_squared)))
    complex_ = candidates.least([(*cross_product(p, n), *n) for p, n in local])
    if not any(complex_[:3]):
        return
    axis, moment = complex_[:3], complex_[3:]
    square = scalar(axis, axis)
    foot = tuple(x / square for x in cross_product(axis, moment))
    profile, halves = [], []
    for p, n in local:
        rho, z = map(mpq, _seen(p, _numbers(foot, axis)))
        profile.append((z, rho))
        # the normals of both halves of a cone lean to opposite sides
        leaning = scalar(n, axis) * (scalar(n, minus(p, foot)) * square - scalar(n, axis) * scalar(p, axis))
        halves.append((z, rho * sign(leaning)))
    for given in (profile, halves):
        if (line := candidates.least([(z, rho, mpq(1)) for z, rho in given])) and line[0] and line[1]:
            along = -line[2] / line[0] / gmpy2.sqrt(mpfr(square))
            apex = [x + along * u for x, u in zip(foot, axis, strict=True)]
            yield CONE, _numbers(apex, axis, abs(mpfr(line[0] / line[1])))
    if (circle := candidates.fitted_circle(profile, None)) is not None:
        along = circle.centre[0] / gmpy2.sqrt(mpfr(square))
        centre = [x + along * u for x, u in zip(foot, axis, strict=True)]
        yield TORUS, _numbers(centre, axis, circle.centre[1], gmpy2.sqrt(mpfr(circle.radius_squared)))


class _Fit:
    """A shape of one kind that comes close to points."""

    def __init__(self, model: _Model, points: Sequence[Sequence[mpq]]) -> None:
        self.model, self.points = model, [[mpfr(x) for x in p] for p in points]

    def away(self, x: Numbers) -> list[mpfr]:
        """The distances of the points."""
        return [self.model.away(*_seen(p, x), x[6:]) for p in self.points]

    def worst(self, x: Numbers) -> mpfr:
        """The largest of them."""
        return max(map(abs, self.away(x)))

    def improved(self, x: list[mpfr]) -> list[mpfr]:
        """Numbers for which the sum of the squares of the distances is about least."""
        own = self.away(x)
        for _ in range(STEPS):
            total = scalar(own, own)
            columns = []
            for k in range(len(x)):
                other = [y + STEP * (i == k) for i, y in enumerate(x)]
                columns.append([mpq((b - a) / STEP) for a, b in zip(own, self.away(other), strict=True)])
            exact = [mpq(a) for a in own]
            normal = [[scalar(a, b) for b in columns] for a in columns]
            for k, row in enumerate(normal):
                row[k] += mpq(1, 2**60)  # the length of the axis, and possibly a place along it, are free
            step = solved([[rounded(a, NOTHING) for a in row] for row in normal], [scalar(a, exact) for a in columns])
            if step is None:
                break
            tried = [y - d for y, d in zip(x, step, strict=True)]
            own_there = self.away(tried)
            if not scalar(own_there, own_there) < total:
                break
            x, own = tried, own_there
        return x

    def shapes(self, x: list[mpfr], middle: Point, size: mpq) -> Iterator[Shape]:
        """The shape in the coordinates of the points: with simple numbers where it seems to be exact, and with numbers
        as short as its distance from them allows.
        """
        left = mpq(self.worst(x))
        largest = max(x[3:6], key=abs)
        axis = [mpq(u / largest) for u in x[3:6]]
        point = [m + mpq(a) * size for m, a in zip(middle, x[:3], strict=True)]
        if left < NOTHING:
            axis = [_simple(u) for u in axis]
            radii = [_simple(mpq(k * k)) for k in x[6:]]
            point = [_simple(a / size) * size for a in self._foot(point, axis)]
            yield self._shape(point, axis, radii, size)
        unit = decimal_unit(max(left, NOTHING) * FINE)
        axis = [rounded(u, unit) for u in axis]
        radii = [rounded(mpq(k), unit) ** 2 for k in x[6:]]
        yield self._shape([rounded(a, size * unit) for a in self._foot(point, axis)], axis, radii, size)

    def _foot(self, point: Sequence[mpq], axis: Sequence[mpq]) -> Sequence[mpq]:
        """The point, or that of the axis nearest to the origin where it may be any."""
        if not self.model.slides:
            return point
        along = scalar(point, axis) / scalar(axis, axis)
        return [a - along * u for a, u in zip(point, axis, strict=True)]

    def _shape(self, point: Sequence[mpq], axis: Sequence[mpq], squares: Sequence[mpq], size: mpq) -> Shape:
        scale = 1 if self.model is CONE else size * size
        return self.model.shape(tuple(point), tuple(axis), *[k * scale for k in squares])


def _numbers(*groups: object) -> list[mpfr]:
    return [mpfr(x) for group in groups for x in (group if isinstance(group, list | tuple) else [group])]


def _seen(point: Sequence[Any], x: Numbers) -> tuple[mpfr, mpfr]:
    """The distance from an axis, and the place along it."""
    offset: list[mpfr] = [a - b for a, b in zip(point, x[:3], strict=True)]
    beside = cross_product(offset, x[3:6])
    along: mpfr = scalar(offset, x[3:6])
    length = gmpy2.sqrt(mpfr(scalar(x[3:6], x[3:6])))
    return gmpy2.sqrt(mpfr(scalar(beside, beside))) / length, along / length


def _simple(x: mpq) -> mpq:
    """The nearest number with a short denominator."""
    near = Fraction(int(x.numerator), int(x.denominator)).limit_denominator(SIMPLE)
    return mpq(near.numerator, near.denominator)
