"""The patches of a surface that are planes, spheres, cylinders, cones or tori, exactly or within a proved distance."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from math import prod
from typing import Any

import gmpy2
from gmpy2 import mpfr

from exactspline.bivariate.borders import Patch
from exactspline.bivariate.signs import Sign, sign_on_patch
from exactspline.geometry.recognition import candidates
from exactspline.geometry.recognition.candidates import FINE, ROUND, WORSE, farthest, rounded
from exactspline.geometry.recognition.coverage import between_poles, covers_once
from exactspline.geometry.recognition.pieces import SMALL, longest_side, proved_distance
from exactspline.geometry.recognition.shapes import (
    Cone,
    Cylinder,
    Plane,
    Point,
    Shape,
    ShapeKind,
    Sphere,
    Torus,
    cross_product,
    minus,
    solved,
    upper_square_root,
)
from exactspline.geometry.surfaces.forms import SurfaceForms
from exactspline.numbers.exact import Number, decimal_unit, mpq, scalar, sign
from exactspline.one_line import OneLine
from exactspline.reals.real import Real, real
from exactspline.splines.precision import distance
from exactspline.splines.surface import NurbsSurface
from exactspline.splines.tensor import TensorSpline
from exactspline.splines.type_checks import surface_of

# ---- candidates
# Only how small the proved distance is depends on the candidates.
#
# The normals of a surface of revolution meet its axis: in Plücker coordinates this is a linear condition (Pottmann and
# Wallner, Computational Line Geometry 2001). Then the distances from the shape are minimized by the Gauss-Newton method
# in long binary numbers; the numbers of a shape that seems to be exact are replaced by simple rational ones.


#: The bits of the numbers in which distances are minimized, and the step of difference quotients.
BITS, STEP = 256, mpq(1, 2**100)
#: Distances below this fraction of the size are assumed to be 0, and denominators of exact numbers to be at most this.
NOTHING, SIMPLE = mpq(1, 2**120), 10**20
#: The largest numbers of steps of the iteration, and of points that it uses.
STEPS, MOST_SAMPLES = 16, 64

Numbers = Sequence[mpfr]


@dataclass(frozen=True, repr=False)
class Sample(OneLine):
    """A point of a surface, and a normal vector there, which is 0 where there is no normal."""

    point: Point
    normal: Point


@dataclass(frozen=True)
class _Model:
    """A kind of shapes given by a point and the direction of its axis and by other numbers. `away` computes the
    distance of a point from the shape, by the distance of the point from the axis and its place along the axis; `shape`
    makes the shape from the exact squares of the other numbers.
    """

    away: Callable[[mpfr, mpfr, Numbers], mpfr]
    shape: Callable[..., Shape]
    #: Whether the point may be any point of the axis.
    slides: bool = False


CYLINDER = _Model(lambda rho, z, k: rho - k[0], lambda a, d, r: Cylinder(a, r, d), slides=True)
CONE = _Model(lambda rho, z, k: (rho - abs(z) * k[0]) / gmpy2.sqrt(1 + k[0] * k[0]), Cone)
TORUS = _Model(lambda rho, z, k: gmpy2.sqrt((rho - k[0]) * (rho - k[0]) + z * z) - k[1], Torus)


def proposed(samples: Sequence[Sample], limit: mpq) -> Iterator[Shape]:
    """Shapes within about a limit of the samples, the simplest first."""
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
    """Kinds of shapes with the numbers from which the iteration begins."""
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
        """The largest distance of a point."""
        return max(map(abs, self.away(x)))

    def improved(self, x: list[mpfr]) -> list[mpfr]:
        """Numbers for which the sum of the squares of the distances is approximately least."""
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
                row[k] += mpq(1, 2**60)  # the length of the axis vector, and possibly a place along the axis, are free
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
        """The shape in the coordinates of the points: with simple numbers if it seems to be exact, and with numbers as
        short as its distance from the points allows.
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
        """The point of the axis; if it may be any point of the axis, the one nearest to the origin."""
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


#: The possible signs of a form that is nowhere negative.
NOT_NEGATIVE = (Sign.POSITIVE, Sign.NOT_NEGATIVE, Sign.ZERO)
#: The local parameters, in each direction, of the points from which a shape is guessed.
PLACES = tuple(mpq(i, 32) for i in (1, 11, 21, 31))


@dataclass(frozen=True, repr=False)
class RecognizedPart(OneLine):
    """Patches of a surface, and the shape on which they lie exactly or nearly.

    Every point of these patches is at most `within` away from the shape, which is 0 if they lie on it exactly. `once`:
    no point of the shape is the nearest one to two points of these patches, so that every point of the covered part of
    the shape is also within this distance of the patches; False means that this is not proved. `whole`: these are all
    patches of the surface.
    """

    patches: tuple[Patch, ...]
    shape: Shape
    within: mpq
    whole: bool
    once: bool

    @property
    def kind(self) -> ShapeKind:
        """The kind of the shape."""
        return self.shape.kind

    @property
    def values(self) -> dict[str, tuple[Real, ...]]:
        """The distance, and the numbers of the shape."""
        return {"within": (real(self.within),), **self.shape.numbers}

    @property
    def exact(self) -> bool:
        """Whether the patches lie on the shape exactly."""
        return not self.within


def recognized_surface(surface: NurbsSurface, epsilon: Number | None = None) -> tuple[RecognizedPart, ...]:
    """The patches of a surface that lie on a plane, a sphere, a cylinder, a cone or a ring torus, within the distance
    epsilon; without it, within 10⁻⁹ of the size of the surface. All patches together are tried first; then the patches
    that are near the shape of one of them are reported together.

    >>> from exactspline import example
    >>> for name in ("sphere", "cylinder", "cone", "torus"):
    ...     (found,) = recognized_surface(example(name))
    ...     print(found.shape, found.exact, found.once)
    sphere: centre (0, 0, 0), radius 1 True True
    cylinder: point (0, 0, 0), axis (0, 0, 1), radius 1 True True
    cone: apex (0, 0, 2), axis (0, 0, 1), tan 1/2 True True
    torus: centre (0, 0, 0), axis (0, 0, 1), radii (2, 1) True True

    Raises `ShapeError` for a surface that is not in space and for an epsilon that is not positive.
    Theory: docs/rounded-input.md.
    """
    given = surface_of(surface)
    normal = SurfaceForms(given).normal
    samples = {
        (i, j): [Sample(given(*place), normal(*place)) for place in _places(given, (i, j))]
        for i, j in product(*map(range, given.patches))
    }
    size = longest_side([[x.point for x in own] for own in samples.values()])
    limit = size * SMALL if epsilon is None else distance(epsilon, given)
    everything = [x for own in samples.values() for x in own]
    for shape in _proposed(given, everything, limit):
        if (within := _proved(given, everything, shape, limit)) is not None:
            return (RecognizedPart(tuple(samples), shape, within, whole=True, once=covers_once(given, shape, within)),)
    return tuple(_by_patches(given, samples, limit)) if len(samples) > 1 else ()


def _proposed(surface: NurbsSurface, samples: Sequence[Sample], limit: mpq) -> Iterator[Shape]:
    """Shapes for all of a surface."""
    for shape in proposed(samples, limit):
        if (moved := between_poles(surface, shape)) is not None:
            yield moved
        yield shape


def _by_patches(surface: NurbsSurface, samples: dict[Patch, list[Sample]], limit: mpq) -> list[RecognizedPart]:
    """Groups of patches that are near the same shape, which is the shape of the first patch of the group."""
    found, done = [], set[Patch]()
    for patch, own in samples.items():
        if patch in done:
            continue
        for shape in proposed(own, limit):
            near: dict[Patch, mpq] = {}
            for other, points in samples.items():
                if other in done or (other != patch and patch not in near):
                    continue
                own_within = _proved(surface.restrict(*surface.w.patch(*other)), points, shape, limit)
                if own_within is not None:
                    near[other] = own_within
            if near:
                within = max(near.values())
                once = (block := _block(surface, [*near])) is not None and covers_once(block, shape, within)
                found.append(RecognizedPart(tuple(near), shape, within, whole=len(near) == len(samples), once=once))
                done |= set(near)
                break
    return found


def _block(surface: NurbsSurface, patches: Sequence[Patch]) -> NurbsSurface | None:
    """The part of the surface that consists of these patches; None if they do not form a rectangle."""
    ends = [(min(own), max(own)) for own in zip(*patches, strict=True)]
    if len(patches) != prod(last - first + 1 for first, last in ends):
        return None
    first, last = (surface.w.patch(*corner) for corner in zip(*ends, strict=True))
    return surface.restrict((first.first.low, last.first.high), (first.second.low, last.second.high))


def _places(surface: NurbsSurface, patch: Patch) -> list[tuple[mpq, mpq]]:
    sides = surface.w.patch(*patch)
    return [sides.at(x, y) for x, y in product(PLACES, repeat=2)]


def _proved(surface: NurbsSurface, samples: Sequence[Sample], shape: Shape, limit: mpq) -> mpq | None:
    """The proved distance; None if none below the limit is proved."""
    found = farthest(shape, [x.point for x in samples])
    if found > limit * limit:
        return None
    return proved_distance(shape, surface, upper_square_root(found), limit, _never_negative)


def _never_negative(f: TensorSpline) -> bool:
    """Whether a function is nowhere negative; False also if this is not decided."""
    first, second = (range(len(mesh)) for mesh in f.meshes)
    return all(sign_on_patch(f.patch_form(i, j)).sign in NOT_NEGATIVE for i, j in product(first, second))
