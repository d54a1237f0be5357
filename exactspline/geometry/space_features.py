"""Points of interest of a space curve: zeros of the torsion, extrema and zeros of the curvature, singular points, and
intervals that are special.

In space κ ≥ 0. Where κ = 0 (γ′ × γ″ = 0 at a regular point) it is smallest: these points are listed as inflections,
undulations and flat points (`flat_points`) and not once more among the extrema. The form [D1 D2 D3] of the torsion
vanishes there whatever τ does, so that τ itself, in lowest terms, decides. A zero where γ′ vanishes is a singular point
and nothing else.
"""

from __future__ import annotations

from functools import cached_property, lru_cache
from typing import Any

from gmpy2 import mpq

from exactspline.geometry.constructions import MINIMAL
from exactspline.geometry.continuity import (
    CONTINUOUS,
    CURVATURE_JUMP,
    TURN,
    inside,
    limit_direction,
    same_direction,
    sides,
    tangent_joint,
)
from exactspline.geometry.domain import space
from exactspline.geometry.singular_points import Feature, singularities
from exactspline.geometry.zero_forms import split_at_joints, zero_form
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector, cross
from exactspline.papers import find
from exactspline.readings.taylor import series_curve
from exactspline.roots.root import Root, knot_root
from exactspline.roots.zero_set import ZeroSet, jump_root, zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.lowest_terms import common_factor, where_it_exists

Interval = tuple[mpq, mpq]


class Shape:
    """What the features of one space curve are read from, computed once."""

    def __init__(self, curve: Any) -> None:
        self.curve = space(curve)
        self.d1, self.b = find("D1")(curve), find("binormal_form")(curve)

    @cached_property
    def singular(self) -> list[Feature]:
        """The singular points."""
        return singularities(self.curve)

    @cached_property
    def common(self) -> tuple[BSpline, ZeroSet]:
        """The common factor of the components of γ′ × γ″, and its zeros."""
        factor = common_factor(self.b)
        return factor, zeros(factor, periodic=self.curve.closed)

    @cached_property
    def torsion(self) -> Rational:
        """τ in lowest terms, 0 where the curve is straight."""
        return where_it_exists(find("torsion_reduced")(self.curve))

    def is_singular(self, root: Root) -> bool:
        """Whether γ′ = 0 at a root."""
        return any(root == f.root for f in self.singular)

    def is_flat(self, root: Root) -> bool:
        """Whether γ′ × γ″ = 0 at a root (at a knot: seen from both sides)."""
        if root.exact is None:
            return any(root == other for other in self.common[1])
        return not any(any(self.bend(root.exact, side)) for side in ("left", "right"))

    def bend(self, t: mpq, side: str) -> tuple[mpq, ...]:
        """The direction of γ′ × γ″ at a parameter (turned round where w < 0), its limit at a knot; zeros where κ =
        0.
        """
        left, right = sides(self.curve, t)
        return tuple(c(left if side == "left" else right, side) for c in self.b)

    def limits(self, t: mpq) -> tuple[tuple[mpq, ...], tuple[mpq, ...]]:
        """The directions of the binormal just left and just right of a knot; zeros where the curve is straight."""
        left, right = sides(self.curve, t)
        return limit_direction(self.b, left, "left"), limit_direction(self.b, right, "right")

    def same_curvature(self, t: mpq) -> bool:
        """Whether tangent and curvature are continuous at a knot."""
        if tangent_joint(self.curve, self.d1, t):
            return False
        ends = zip(sides(self.curve, t), ("left", "right"), strict=True)
        a, b = [find("space_curvature_squared")(series_curve(self.curve, s, 3, side)).value for s, side in ends]
        return bool(a == b)

    def joint(self, t: mpq) -> str:
        """What happens at a knot (see `joint`)."""
        if kind := tangent_joint(self.curve, self.d1, t):
            return kind
        left, right = self.limits(t)
        if any(left) and any(right) and any(cross(Vector(*left), Vector(*right))):
            return TURN
        bends = [self.bend(t, side) for side in ("left", "right")]
        same = self.same_curvature(t) and (not any(bends[0]) or same_direction(*bends))
        return CONTINUOUS if same else CURVATURE_JUMP


@lru_cache(maxsize=4)
def _shape(curve: Any) -> Shape:
    return Shape(curve)


def space_joint(curve: Any, t: mpq) -> str:
    """What happens at a knot: a gap, a corner, a singular point, a jump of the osculating plane, a jump of the
    curvature (of κN, the osculating plane being one), or nothing up to second order.

    >>> from exactspline.splines.examples import example
    >>> space_joint(example("space_quartic"), mpq(1, 2))
    'continuous curvature'
    """
    return _shape(curve).joint(t)


def curvature_zeros(curve: Any) -> tuple[BSpline, ZeroSet]:
    """A spline that vanishes exactly where all components of γ′ × γ″ do, and its zeros.

    >>> from exactspline.splines.examples import example
    >>> curvature_zeros(example("flat_point"))[1].roots
    (<Root 1/2: multiplicity 1, sign − to +>,)
    """
    return _shape(curve).common


def curvature_sign_in_space(curve: Any, root: Root, side: str = "right") -> int:
    """1, or 0 where κ = 0 (at a knot: seen from the side asked for)."""
    shape = _shape(curve)
    return int(not shape.is_flat(root) if root.exact is None else any(shape.bend(root.exact, side)))


def torsion_in_lowest_terms(curve: Any) -> Rational:
    """τ as a quotient in lowest terms, segment by segment; 0/1 where the curve is straight.

    >>> from exactspline.splines.examples import example
    >>> torsion_in_lowest_terms(example("flat_point"))("1/2")
    mpq(2,1)
    """
    return _shape(curve).torsion


def flat_points(curve: Any) -> list[Feature]:
    """The zeros of the curvature at regular points.

    ``inflection``: the direction of κN is turned round; ``undulation``: it is kept; ``flat end``: the domain ends
    there; ``flat point``: at a knot, the osculating planes of the two sides differ. At a knot κN may also be turned
    round by a jump. Straight intervals are not listed here.

    >>> from exactspline.splines.examples import example
    >>> [(f.kind, f.root.exact) for f in flat_points(example("flat_point"))]
    [('inflection', mpq(1,2))]

    Raises `ShapeError` for a curve that is not in space.
    """
    shape = _shape(curve)
    features = [
        Feature("inflection" if root.multiplicity % 2 else "undulation", root, "binormal_form", of_absolute="minimum")
        for root in shape.common[1]
        if not root.at_knot and not shape.is_singular(root)
    ]
    a, b = curve.domain
    knots = [*([a] if curve.closed else []), *curve.breakpoints[1:-1]]
    features += [f for f in (_flat_knot(shape, t) for t in knots) if f is not None]
    if not curve.closed:
        ends = [
            t
            for t, side in ((a, "right"), (b, "left"))
            if not any(shape.bend(t, side)) and any(limit_direction(shape.b, t, side))
        ]
        features += [
            Feature("flat end", r, "binormal_form", of_absolute="minimum")
            for r in map(knot_root, ends)
            if not shape.is_singular(r)
        ]
    return sorted(features, key=lambda f: f.root)


def _flat_knot(shape: Shape, t: mpq) -> Feature | None:
    """The zero of the curvature at a knot, if there is one, or its being turned round by a jump."""
    if tangent_joint(shape.curve, shape.d1, t):
        return None
    left, right = shape.limits(t)
    if not any(left) or not any(right):
        return None
    flat = not any(shape.bend(t, "left")) and not any(shape.bend(t, "right"))
    absolute = "minimum" if flat else ""
    if same_direction(left, tuple(-x for x in right)):
        return Feature("inflection", knot_root(t), "binormal_form", by_jump=not flat, of_absolute=absolute)
    if not flat:
        return None
    return Feature(
        "undulation" if same_direction(left, right) else "flat point",
        knot_root(t),
        "binormal_form",
        of_absolute=absolute,
    )


def torsion_zeros(curve: Any) -> list[Feature]:
    """The zeros of the torsion at regular points.

    ``torsion zero``: τ changes its sign; ``torsion touch``: it does not; ``torsion end``: the domain ends there. At a
    knot with one osculating plane the sign may change by a jump. Planar intervals are not listed here
    (`planar_pieces`).

    >>> from exactspline.splines.examples import example
    >>> [(f.kind, f.root.exact) for f in torsion_zeros(example("space_quartic"))]
    []

    Raises `ShapeError` for a curve that is not in space.
    """
    shape = _shape(curve)
    _, found = zero_form(curve, "zero_torsion")
    true = list(zeros(shape.torsion.scalar))
    features = []
    for root in found:
        if shape.is_singular(root):
            continue
        if root.at_knot:
            features += _torsion_at_knot(shape, root, root.sign_change)
        elif not shape.is_flat(root) or any(root == other for other in true):
            features.append(Feature(_torsion_kind(root), root, "D1_D2_D3"))
    for jump in found.jumps:
        if jump.sign_change:
            features += _torsion_at_knot(shape, jump_root(jump), changes=True)
    return sorted(features, key=lambda f: f.root)


def _torsion_kind(root: Root) -> str:
    if None in root.signs:
        return "torsion end"
    return "torsion zero" if root.sign_change else "torsion touch"


def _torsion_at_knot(shape: Shape, root: Root, changes: bool) -> list[Feature]:
    """A zero of the torsion at a knot where the two sides have one osculating plane: of τ itself on both sides, or a
    change of its sign.
    """
    t, torsion = root.low, shape.torsion
    if not inside(shape.curve, t):
        return (
            [Feature("torsion end", root, "D1_D2_D3")]
            if torsion(t, "left" if t == shape.curve.domain[1] else "right") == 0
            else []
        )
    if shape.joint(t) not in (CURVATURE_JUMP, CONTINUOUS):
        return []
    left, right = sides(shape.curve, t)
    if torsion(left, "left") == torsion(right, "right") == 0:
        return [Feature(_torsion_kind(root), root, "D1_D2_D3")]
    return [Feature("torsion zero", root, "D1_D2_D3", by_jump=True)] if changes else []


def space_critical_points(curve: Any, variant: str = MINIMAL) -> list[Feature]:
    """The extrema of the curvature and the points where κ′ = 0 without an extremum (``stationary``), but for those
    where κ = 0.

    Inside segments, and at knots where κ is continuous and κ′ changes its sign, with or without a jump.

    >>> from exactspline.splines.examples import example
    >>> [f.kind for f in space_critical_points(example("rational_space_cubic"))]
    ['maximum', 'minimum']

    Raises `ShapeError` for a curve that is not in space.
    """
    shape = _shape(curve)
    _, found = zero_form(curve, "space_critical_curvature", variant)
    features = []
    for root in found:
        if shape.is_singular(root) or shape.is_flat(root):
            continue
        if not root.at_knot or not inside(curve, root.low) or shape.same_curvature(root.low):
            features.append(_extremum(root, variant, by_jump=False))
    for jump in found.jumps:
        root = jump_root(jump)
        if jump.sign_change and shape.same_curvature(jump.parameter) and not shape.is_flat(root):
            features.append(_extremum(root, variant, by_jump=True))
    return sorted(features, key=lambda f: f.root)


def _extremum(root: Root, variant: str, *, by_jump: bool) -> Feature:
    left, right = root.signs
    if left is None or right is None or left * right >= 0:
        return Feature("stationary", root, variant)
    kind = "maximum" if left > 0 else "minimum"
    return Feature(kind, root, variant, by_jump, kind)


def space_straight_pieces(curve: Any) -> list[Interval]:
    """The intervals on which a space curve is straight.

    >>> from exactspline.splines.examples import example
    >>> space_straight_pieces(example("space_line"))
    [(mpq(0,1), mpq(1,1))]
    """
    shape = _shape(curve)
    return split_at_joints(curve, shape.common[1], lambda t: shape.joint(t) == CONTINUOUS)


def space_constant_pieces(curve: Any) -> list[Interval]:
    """The intervals on which the curvature of a space curve is constant: circular arcs, straight pieces, and whatever
    else has it.
    """
    shape = _shape(curve)
    return split_at_joints(curve, zero_form(curve, "space_critical_curvature")[1], shape.same_curvature)
