"""Bisectors, before any trimming: what a user calls, in pieces that cover what there is, with the places where there is
nothing named.

The bisector of two curves is a surface over the pairs of parameters that have one point, and beside it the lines and
planes of the pairs that have more (`exactspline.geometry.bisector.special_pairs`).

Parameters and coordinates are unitless exact numbers. "Bisector" means equal *critical* distances;
`exactspline.geometry.trimmed_bisector` keeps the points of equal distance of a planar point/curve bisector.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from enum import StrEnum
from functools import cached_property
from itertools import pairwise, product
from typing import Any

from exactspline.errors import FormulaError, ShapeError
from exactspline.exact import Number, mpq, rational, text
from exactspline.geometry.bisector.components import LineComponent, PlaneComponent, PoleCurve, SinglePair, SpecialPairs
from exactspline.geometry.bisector.special_pairs import special_pairs
from exactspline.geometry.domain import part
from exactspline.language.arguments import Curve
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector, cross
from exactspline.papers import find
from exactspline.roots.root import Root, between
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.lowest_terms import common_factor
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.tensor import TensorSpline, surface_pair
from exactspline.splines.tensor_lowest_terms import in_lowest_terms
from exactspline.splines.values import SplineSurface

Interval = tuple[mpq, mpq]

#: Formulas of the bisector of two space curves by variant, and of a point and a space curve.
CURVE_FORMS = {
    "naive": "bisector",
    "levelled": "bisector_levelled",
    "paper": "bisector_polynomial",
    "symmetric": "bisector_symmetric",
    "minimal": "bisector_symmetric",
}
POINT_FORMS = {"naive": "point_bisector", "explicit": "point_bisector_polynomial"}
AXES = "xyz"


@dataclass(frozen=True)
class BisectorPatch:
    """A part of the bisector of two curves: a rectangle of parameters, and a `Rational` of splines in both."""

    sides: tuple[Interval, Interval]
    value: Rational[TensorSpline]


class SurfaceVariant(StrEnum):
    """How the surface of two space curves is computed."""

    NAIVE = "naive"
    LEVELLED = "levelled"
    PAPER = "paper"
    SYMMETRIC = "symmetric"
    MINIMAL = "minimal"


@dataclass(frozen=True)
class CurveBisector:
    """The bisector of two space curves: the surface in patches, the rectangles on which no pair in general position has
    one point, each with the reason, and (computed when first asked for) all pairs that have more than a point.

    Together ``patches``, ``lines``, ``planes`` and ``pairs`` are all points with two equal critical distances, but for
    what ``left_out`` names; along ``poles`` the surface is at infinity.
    """

    variant: SurfaceVariant
    patches: tuple[BisectorPatch, ...]
    missing: tuple[tuple[tuple[Interval, Interval], str], ...]
    curves: tuple[Nurbs, Nurbs] = field(repr=False)

    @cached_property
    def special(self) -> SpecialPairs:
        """The pairs of parameters that have no single point."""
        return special_pairs(*self.curves)

    @property
    def lines(self) -> tuple[LineComponent, ...]:
        """Lines of solutions along curves of pairs."""
        return self.special.lines

    @property
    def planes(self) -> tuple[PlaneComponent, ...]:
        """Planes of solutions along curves of pairs."""
        return self.special.planes

    @property
    def pairs(self) -> tuple[SinglePair, ...]:
        """Single pairs with a line, a plane or all of space for their solutions."""
        return self.special.pairs

    @property
    def poles(self) -> tuple[PoleCurve, ...]:
        """The curves of pairs along which the surface is at infinity."""
        return self.special.poles

    @property
    def left_out(self) -> tuple[str, ...]:
        """What could not be decided; empty where the answer is complete."""
        return self.special.left_out

    def __call__(self, s: Any, t: Any) -> tuple[mpq, ...]:
        """The point for two parameters; `ZeroDivisionError` at a pole, `ShapeError` where there is no surface."""
        s, t = rational(s), rational(t)
        for patch in self.patches:
            if all(a <= x <= b for x, (a, b) in zip((s, t), patch.sides, strict=True)):
                point: tuple[mpq, ...] = patch.value(s, t)
                return point
        raise ShapeError(
            f"there is no surface at ({text(s)}, {text(t)})", remedy="; ".join(reason for _, reason in self.missing)
        )


def curve_bisector(first: Nurbs, second: Nurbs, variant: str = SurfaceVariant.MINIMAL) -> CurveBisector:
    """The bisector of two space curves.

    `variant` is ``naive`` (22), ``levelled`` (26), ``paper`` (27), ``symmetric`` (27 for both curves) or ``minimal``
    (that in lowest terms).

    >>> from exactspline.splines.examples import example
    >>> found = curve_bisector(example("rational_space_cubic"), example("twisted_cubic"))
    >>> found.patches[0].value.degree, len(found.pairs), found.left_out
    (Degrees(s=10, t=8), 3, ())

    Raises `ShapeError` for curves that are not in space, `FormulaError` for an unknown variant.
    """
    if variant not in tuple(SurfaceVariant):
        raise FormulaError(f"no variant is called {variant!r}", remedy=f"there are {', '.join(SurfaceVariant)}")
    for c in (first, second):
        if c.dimension != 3:
            raise ShapeError(
                f"a curve in R{c.dimension}",
                remedy="the bisector of two plane curves is no rational curve; use curves in space",
            )
    patches, missing = _surface(first, second, SurfaceVariant(variant))
    return CurveBisector(SurfaceVariant(variant), patches, missing, (first, second))


def _surface(
    first: Nurbs, second: Nurbs, variant: SurfaceVariant
) -> tuple[tuple[BisectorPatch, ...], tuple[tuple[tuple[Interval, Interval], str], ...]]:
    pair = surface_pair(first, second)
    determinant = find("bisector_determinant_symmetric")(pair)
    missing: list[tuple[Any, str]] = []
    found: list[Any] = []
    d1, other = find("D1")(pair.first), find("D1")(pair.second)
    parallel = cross(d1, other)
    sides = [list(pairwise(mesh.breaks)) for mesh in determinant.meshes]
    for at, rectangle in enumerate(product(*sides)):
        if determinant.polynomials[at]:
            found.append(rectangle)
        else:
            still = any(_is_zero_on(v, at) for v in (d1, other))
            missing.append((rectangle, STILL if still else PARALLEL if _is_zero_on(parallel, at) else COPLANAR))
    parts: list[Any] = (
        [(pair.first.w.domain, pair)]
        if not missing
        else [(r, surface_pair(part(first, *r[0]), part(second, *r[1]))) for r in found]
    )
    values = [(r, find(CURVE_FORMS[variant])(p)) for r, p in parts]
    lowest = variant is SurfaceVariant.MINIMAL
    return tuple(BisectorPatch(r, in_lowest_terms(v) if lowest else v) for r, v in values), tuple(missing)


STILL = "the curve stands still here, and has no normals"
PARALLEL = "the tangents are parallel everywhere, so are the normal planes"
COPLANAR = "the curves lie in one plane, and all three planes of the system are perpendicular to it"


def _is_zero_on(v: Vector[BSpline], at: int) -> bool:
    """Whether a vector of splines vanishes on all of the segment or patch with this number."""
    return not any(x.polynomials[at] for x in v)


@dataclass(frozen=True)
class RuledPiece:
    """A part of a point/curve bisector: an interval of the curve's parameter, the component that was moved (empty in
    the explicit forms), and the ruled surface; with a component moved, the ruling parameter is that coordinate.
    """

    interval: Interval
    moved: str
    surface: SplineSurface


@dataclass(frozen=True)
class PointBisector:
    """The ruled bisector surface of a point and a space curve.

    ``singular`` are the parameters at which the generator vanishes (the tangent passes through the point, or the curve
    does, or γ′ = 0), at a knot from one side at least; ``missing`` the intervals on which it vanishes throughout, each
    with the reason.
    """

    variant: str
    pieces: tuple[RuledPiece, ...]
    singular: tuple[Root, ...]
    missing: tuple[tuple[Interval, str], ...]


THROUGH = "the curve is straight here and its line passes through the point"


def point_bisector(curve: Nurbs, point: Iterable[Number], variant: str = "direct") -> PointBisector:
    """The bisector of a point and a space curve.

    `variant` is ``naive`` (31), ``explicit`` (34) or ``direct``: the 2×2 system with a component moved that is solvable
    on the whole piece. Which one is decided exactly: a component may be moved where its determinant, the same component
    of ``D1 × (p − wQ)``, has no zero; the curve is split so that the pieces cover all but the singular parameters, at
    which none can be moved.

    >>> from exactspline.splines.examples import example
    >>> found = point_bisector(example("ellipse_in_space"), (1, 1, 2))
    >>> [(piece.moved, piece.interval) for piece in found.pieces][:2]
    [('x', (mpq(0,1), mpq(1,2))), ('y', (mpq(1,2), mpq(3,2)))]

    Raises `ShapeError` for a curve or a point that is not in space, or where there is no surface at all; `FormulaError`
    for an unknown variant.
    """
    if variant not in (*POINT_FORMS, "direct"):
        raise FormulaError(f"no variant is called {variant!r}", remedy=f"there are {', '.join(POINT_FORMS)}, direct")
    c = curve.with_point(exact_point(curve, point, 3))
    generator, d1 = find("point_bisector_generator_polynomial")(c), find("D1")(c)
    missing, good = [], []
    for i, (a, b) in enumerate(pairwise(curve.w.breakpoints)):
        if _is_zero_on(generator, i):
            missing.append(((a, b), STILL if _is_zero_on(d1, i) else THROUGH))
        else:
            good.append((a, b))
    if not good:
        raise ShapeError(
            "there is no bisector surface: " + missing[0][1], remedy="choose another point, or another curve"
        )
    parts = [found for a, b in good for found in (_cover(generator, a, b) if variant == "direct" else [(a, b, -1)])]
    pieces = [
        RuledPiece(
            (a, b),
            AXES[k] if k >= 0 else "",
            find(f"point_bisector_direct_{AXES[k]}" if k >= 0 else POINT_FORMS[variant])(_cut(c, a, b)),
        )
        for a, b, k in _merged(parts)
    ]
    return PointBisector(variant, tuple(pieces), _singular(generator, good), tuple(missing))


def _singular(generator: Vector[BSpline], segments: list[Interval]) -> tuple[Root, ...]:
    """Where the generator vanishes on some of the segments, at a knot also from one side only: there the surface of
    that side has a pole.
    """
    roots = [root for a, b in segments for root in zeros(common_factor(Vector(*[x.restrict(a, b) for x in generator])))]
    return tuple(root for i, root in enumerate(roots) if i == 0 or roots[i - 1] != root)


def _merged(parts: list[tuple[mpq, mpq, int]]) -> list[tuple[mpq, mpq, int]]:
    """Neighbours with one component moved as one piece."""
    merged: list[tuple[mpq, mpq, int]] = []
    for a, b, k in parts:
        if merged and merged[-1][1:] == (a, k):
            merged[-1] = (merged[-1][0], b, k)
        else:
            merged.append((a, b, k))
    return merged


def exact_point(curve: Curve[BSpline], point: Iterable[Number], dimension: int) -> tuple[mpq, ...]:
    """The exact coordinates of a point beside a curve of that dimension; `ShapeError` when the numbers of coordinates
    are wrong.
    """
    coordinates = tuple(rational(x) for x in point)
    if curve.dimension != dimension:
        raise ShapeError(f"a curve in R{curve.dimension}", remedy=f"this needs a curve in R{dimension}")
    if len(coordinates) != dimension:
        raise ShapeError(f"a point of {len(coordinates)} coordinates", where="point", remedy=f"give {dimension}")
    return coordinates


def _cut(c: Curve[BSpline], a: mpq, b: mpq) -> Curve[BSpline]:
    """The curve and the point over a part of the domain."""
    part: Curve[BSpline] = c.mapped(lambda f: f.restrict(a, b))
    return part


def _cover(generator: Any, a: mpq, b: mpq) -> list[tuple[mpq, mpq, int]]:
    """Intervals that cover one segment, each with a component of the generator that has no zero on it but the common
    ones of all three.
    """
    parts = [x.restrict(a, b) for x in generator]
    common = common_factor(Vector(*parts))
    order = sorted((k for k in range(3) if not parts[k].is_zero), reverse=True)
    roots = {k: list(zeros(_divided(parts[k], common))) for k in order}
    pieces: list[tuple[mpq, mpq, int]] = []
    low = a
    while True:
        ahead = {k: next((r for r in roots[k] if r >= low), None) for k in order}
        free = next((k for k in order if ahead[k] is None), None)
        if free is not None:
            return [*pieces, (low, b, free)]
        stops: list[tuple[Root, int]] = [(root, k) for k, root in ahead.items() if isinstance(root, Root)]
        stop, best = max(stops, key=lambda pair: (pair[0], pair[1]))
        after = next(k for k in order if all(r != stop for r in roots[k]))
        # the roots are in order
        before = [r for r in roots[after] if low < r < stop]
        cut = between(before[-1] if before else low, stop)
        pieces.append((low, cut, best))
        low = cut


def _divided(f: BSpline, common: BSpline) -> BSpline:
    """A spline of one segment without a common factor."""
    return BSpline.from_forms(
        f.degree - common.degree, f.mesh, (), [(f.polynomials[0] // common.polynomials[0], f.denominators[0])]
    )
