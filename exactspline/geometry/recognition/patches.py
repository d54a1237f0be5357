"""The patches of a surface that are planes, spheres, cylinders, cones or tori, exactly or within a proved distance."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from math import prod

from exactspline.bivariate.borders import Patch
from exactspline.bivariate.signs import Sign, sign_on_patch
from exactspline.geometry.recognition.candidates import farthest
from exactspline.geometry.recognition.coverage import between_poles, covers_once
from exactspline.geometry.recognition.pieces import SMALL, longest_side
from exactspline.geometry.recognition.proof import proved_distance
from exactspline.geometry.recognition.shapes import Shape, ShapeKind, upper_square_root
from exactspline.geometry.recognition.surface_candidates import Sample, proposed
from exactspline.geometry.surfaces.forms import SurfaceForms
from exactspline.numbers.exact import Number, mpq
from exactspline.one_line import OneLine
from exactspline.reals.real import Real, real
from exactspline.splines.precision import distance
from exactspline.splines.surface import NurbsSurface
from exactspline.splines.tensor import TensorSpline
from exactspline.splines.type_checks import surface_of

#: What is known of a form that is nowhere negative.
NOT_NEGATIVE = (Sign.POSITIVE, Sign.NOT_NEGATIVE, Sign.ZERO)
#: Where on a patch points are taken to guess a shape, in each direction.
PLACES = tuple(mpq(i, 32) for i in (1, 11, 21, 31))


@dataclass(frozen=True, repr=False)
class RecognizedPart(OneLine):
    """Patches of a surface and the shape on which they are, or to which they are near.

    Every point of these patches is at most `within` away from the shape, 0 where they lie on it exactly. `once`: no
    point of the shape is the nearest one to two points of these patches, so that every point of the part that they
    cover is at most as far from them; where it is False, that was not shown. `whole`: these are all patches of the
    surface.
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
    epsilon; without it, within 10⁻⁹ of the size of the surface. All patches together are tried first; then those that
    are near the shape of one of them are given together.

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
    """Patches that are near one shape, that of the first of them."""
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
    """The part that consists of these patches, None where it is not a rectangle of them."""
    ends = [(min(own), max(own)) for own in zip(*patches, strict=True)]
    if len(patches) != prod(last - first + 1 for first, last in ends):
        return None
    first, last = (surface.w.patch(*corner) for corner in zip(*ends, strict=True))
    return surface.restrict((first.first.low, last.first.high), (first.second.low, last.second.high))


def _places(surface: NurbsSurface, patch: Patch) -> list[tuple[mpq, mpq]]:
    sides = surface.w.patch(*patch)
    return [sides.at(x, y) for x, y in product(PLACES, repeat=2)]


def _proved(surface: NurbsSurface, samples: Sequence[Sample], shape: Shape, limit: mpq) -> mpq | None:
    """The distance that is proved, up to a limit."""
    found = farthest(shape, [x.point for x in samples])
    if found > limit * limit:
        return None
    return proved_distance(shape, surface, upper_square_root(found), limit, _never_negative)


def _never_negative(f: TensorSpline) -> bool:
    """Whether a function is nowhere negative; False also where that was not decided."""
    first, second = (range(len(mesh)) for mesh in f.meshes)
    return all(sign_on_patch(f.patch_form(i, j)).sign in NOT_NEGATIVE for i, j in product(first, second))
