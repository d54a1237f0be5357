"""The ruled bisector surface of a point and a space curve, before any trimming: in pieces that cover all of the
surface, and the places where there is no surface.

Parameters and coordinates are unitless exact numbers. "Bisector" means equal *critical* distances;
`exactspline.geometry.bisectors.trimmed` keeps the points of equal distance to a point and a plane curve.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum
from itertools import pairwise, starmap
from typing import Any, cast

from exactspline.errors import ShapeError, as_items, counted
from exactspline.geometry.bisectors.common import STILL, THROUGH, Bisector, is_zero_on
from exactspline.language.arguments import Curve
from exactspline.language.vector import Vector
from exactspline.numbers.exact import Number, mpq, rational
from exactspline.numbers.intervals import Interval
from exactspline.one_line import one_line, short_text
from exactspline.papers import find
from exactspline.reals.real import between
from exactspline.roots.root import Root, knot_root
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.lowest_terms import SplineSurface, common_factor
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of, of_dimension
from exactspline.words import choice


class PointVariant(StrEnum):
    """The method by which the surface of a point and a curve is computed."""

    NAIVE = "naive"
    EXPLICIT = "explicit"
    DIRECT = "direct"


#: Formulas by variant; the formulas of the direct approach are named after the moved component.
POINT_FORMS = {PointVariant.NAIVE: "point_bisector", PointVariant.EXPLICIT: "point_bisector_polynomial"}
AXES = "xyz"


@dataclass(frozen=True, repr=False)
class RuledPiece:
    """A part of a point/curve bisector: an interval of the curve's parameter, the component that was moved (empty in
    the explicit forms), and the ruled surface; with a component moved, the ruling parameter is that coordinate.
    """

    interval: Interval
    moved: str
    surface: SplineSurface

    @one_line
    def __repr__(self) -> str:
        return f"<RuledPiece on {self.interval}>"


@dataclass(frozen=True, repr=False)
class PointBisector(Bisector):
    """The ruled bisector surface of a point and a space curve.

    ``singular`` are the parameters at which the generator vanishes: the tangent or the curve passes through the point,
    or γ′ = 0. At a knot, one side is enough; the seam of a closed curve is counted at the start. ``missing`` are the
    intervals on which the generator vanishes identically, each with the reason.
    """

    variant: PointVariant
    pieces: tuple[RuledPiece, ...]
    singular: tuple[Root, ...]
    missing: tuple[tuple[Interval, str], ...]


def point_bisector(
    curve: Nurbs, point: Iterable[Number], variant: PointVariant | str = PointVariant.DIRECT
) -> PointBisector:
    """The bisector of a point and a space curve.

    `variant` is ``naive`` or ``explicit`` for the equations (31) and (34) of the paper (Chen, Riesenfeld and Cohen
    2007), or ``direct`` for the 2×2 system with a moved component, which is solvable on the whole piece. The component
    is chosen exactly: a component may be moved where its determinant, the same component of ``D1 × (p − wQ)``, has no
    zero. The curve is split so that the pieces cover all parameters except the singular ones, at which no component can
    be moved.

    >>> from exactspline.interchange.examples import example
    >>> found = point_bisector(example("ellipse_in_space"), (1, 1, 2))
    >>> [(piece.moved, str(piece.interval)) for piece in found.pieces][:2]
    [('x', '[0, 1/2]'), ('y', '[1/2, 3/2]')]

    Raises `ShapeError` for a curve or a point that is not in space, or if there is no surface at all; `FormulaError`
    for an unknown variant.
    """
    curve = curve_of(curve)
    chosen = choice(PointVariant, variant, "variant")
    c = curve.with_point(exact_point(curve, point, 3))
    generator, d1 = find("point_bisector_generator_polynomial")(c), find("D1")(c)
    missing, good = [], []
    for i, segment in enumerate(starmap(Interval, pairwise(curve.w.breakpoints))):
        if is_zero_on(generator, i):
            missing.append((segment, STILL if is_zero_on(d1, i) else THROUGH))
        else:
            good.append(segment)
    if not good:
        _refuse_point(curve)
        reasons = {why: [str(segment) for segment, own in missing if own == why] for _, why in missing}
        named = [why if len(reasons) == 1 else f"{', '.join(on)}: {why}" for why, on in reasons.items()]
        raise ShapeError(
            "there is no bisector surface: " + "; ".join(named), remedy="choose another point, or another curve"
        )
    parts = [
        part for a, b in good for part in (_cover(generator, a, b) if chosen is PointVariant.DIRECT else [(a, b, -1)])
    ]
    pieces = [
        RuledPiece(
            Interval(a, b),
            AXES[k] if k >= 0 else "",
            find(f"point_bisector_direct_{AXES[k]}" if k >= 0 else POINT_FORMS[chosen])(_cut(c, a, b)),
        )
        for a, b, k in _merged(parts)
    ]
    return PointBisector(chosen, tuple(pieces), _singular(generator, good, closed=curve.closed), tuple(missing))


def _refuse_point(curve: Nurbs) -> None:
    """Raise `ShapeError` for a curve that is a single point: the bisector of two points is a plane, not a surface over
    the curve.
    """
    if all(x.is_zero for x in find("D1")(curve)):
        where = ", ".join(map(short_text, curve(curve.domain[0])))
        raise ShapeError(
            f"the curve is one point, ({where})",
            remedy="give a curve that moves: two different points have a plane as their bisector",
        )


def _singular(generator: Vector[BSpline], segments: list[Interval], *, closed: bool) -> tuple[Root, ...]:
    """The zeros of the generator on some of the segments; at a knot it may vanish from one side only, and the surface
    of this side has a pole there.
    """
    roots = [root for a, b in segments for root in zeros(common_factor(Vector(*[x.restrict(a, b) for x in generator])))]
    low, high = generator[0].domain
    found = sorted(knot_root(low) if closed and root == high else root for root in roots)
    return tuple(root for i, root in enumerate(found) if i == 0 or found[i - 1] != root)


def _merged(parts: list[tuple[mpq, mpq, int]]) -> list[tuple[mpq, mpq, int]]:
    """Adjacent pieces with the same moved component, merged."""
    merged: list[tuple[mpq, mpq, int]] = []
    for a, b, k in parts:
        if merged and merged[-1][1:] == (a, k):
            merged[-1] = (merged[-1][0], b, k)
        else:
            merged.append((a, b, k))
    return merged


def exact_point(curve: Curve[BSpline], point: Iterable[Number], dimension: int) -> tuple[mpq, ...]:
    """The exact coordinates of a point in the space of a curve of that dimension; raises `ShapeError` if the number of
    coordinates is wrong.
    """
    coordinates = tuple(rational(x) for x in as_items(point, "the coordinates of a point"))
    of_dimension(curve, f"this needs a curve in R{dimension}", dimension)
    if len(coordinates) != dimension:
        raise ShapeError(
            f"a point of {counted(len(coordinates), 'coordinate')}", where="point", remedy=f"give {dimension}"
        )
    return coordinates


def _cut(c: Curve[BSpline], a: mpq, b: mpq) -> Curve[BSpline]:
    """The curve and the point over a part of the domain."""
    return cast("Curve[BSpline]", c.mapped(lambda f: f.restrict(a, b)))


def _cover(generator: Any, a: mpq, b: mpq) -> list[tuple[mpq, mpq, int]]:
    """Intervals that cover one segment, each with a component of the generator that has no zeros on it except those
    common to all three.
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
    """A spline of one segment divided by a common factor."""
    return BSpline.from_forms(
        f.degree - common.degree, f.mesh, (), [(f.numerators[0] // common.numerators[0], f.denominators[0])]
    )
