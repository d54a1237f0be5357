"""Points of interest of a plane curve: singular points, inflections, extrema of the curvature, each certified and told
apart exactly.

All are zeros of a form of the curve (see `exactspline.geometry.constructions`), found by `exactspline.roots`; a zero
where γ′ vanishes is a singular point and nothing else. On a closed curve the seam is a knot like any other and counts
once.
"""

from __future__ import annotations

from typing import Any

from gmpy2 import mpq

from exactspline.geometry.constructions import MINIMAL
from exactspline.geometry.continuity import (
    CONTINUOUS,
    CORNER,
    CURVATURE_JUMP,
    GAP,
    SINGULAR,
    inside,
    sides,
    tangent_joint,
)
from exactspline.geometry.domain import plane
from exactspline.geometry.singular_points import Feature, cusps, singularities
from exactspline.geometry.zero_forms import split_at_joints, zero_form
from exactspline.papers import find
from exactspline.roots.root import Root
from exactspline.roots.zero_set import jump_root, zeros

__all__ = [
    "CONTINUOUS",
    "CORNER",
    "CURVATURE_JUMP",
    "GAP",
    "SINGULAR",
    "Feature",
    "constant_pieces",
    "critical_points",
    "curvature_extrema",
    "curvature_sign",
    "cusps",
    "inflections",
    "joint",
    "singularities",
    "straight_pieces",
    "zero_form",
]

#: The form whose sign is that of κκ′; the sign of all others is that of κ′.
SQUARING = "squaring"


def joint(curve: Any, t: mpq) -> str:
    """What happens at a knot: a gap, a corner, a singular point, a jump of the curvature, or nothing up to second
    order.

    >>> from exactspline.splines.examples import example
    >>> joint(example("circle"), mpq(1)), joint(example("jump"), mpq(1))
    ('continuous curvature', 'gap')
    """
    if kind := tangent_joint(curve, find("D1")(plane(curve)), t):
        return kind
    (left, right), kappa = sides(curve, t), find("curvature_squared")(curve)
    turning = find("f2")(curve)
    signs = [(turning * curve.w)(s, side) for s, side in ((left, "left"), (right, "right"))]
    same = kappa(left, "left") == kappa(right, "right") and signs[0] * signs[1] >= 0
    return CONTINUOUS if same else CURVATURE_JUMP


def inflections(curve: Any, variant: str = MINIMAL) -> list[Feature]:
    """The zeros of the curvature at regular points: inflections, and undulations where its sign stays.

    At a knot with a common tangent the curvature may change its sign by a jump. Pieces that are straight are not listed
    here (`straight_pieces`).

    >>> from exactspline.splines.examples import example
    >>> [f.kind for f in inflections(example("six_segment_cubic"))]
    ['inflection', 'inflection']

    Raises `ShapeError` for a curve that is not in the plane.
    """
    singular = {f.root for f in singularities(curve)}
    _, found = zero_form(curve, "zero_curvature", variant)
    features = [
        Feature(_flat(root), root, variant) for root in found if root not in singular and _tangent_at(curve, root)
    ]
    for jump in found.jumps:
        if jump.sign_change and joint(curve, jump.parameter) in (CURVATURE_JUMP, CONTINUOUS):
            features.append(Feature("inflection", jump_root(jump), variant, by_jump=True))
    return sorted(features, key=lambda f: f.root)


def _tangent_at(curve: Any, root: Root) -> bool:
    """Whether the curve has one tangent at a root: everywhere but at knots that are gaps, corners or singular."""
    return not root.at_knot or not inside(curve, root.low) or joint(curve, root.low) in (CURVATURE_JUMP, CONTINUOUS)


def _flat(root: Root) -> str:
    if None in root.signs:
        return "flat end"
    return "inflection" if root.sign_change else "undulation"


def straight_pieces(curve: Any) -> list[tuple[mpq, mpq]]:
    """The intervals on which the curve is straight.

    >>> from exactspline.splines.examples import example
    >>> straight_pieces(example("straight_between_arcs"))
    [(mpq(1,1), mpq(2,1))]
    """
    return split_at_joints(curve, zero_form(curve, "zero_curvature")[1], lambda t: joint(curve, t) == CONTINUOUS)


def constant_pieces(curve: Any) -> list[tuple[mpq, mpq]]:
    """The intervals on which the curvature is constant: circular arcs and straight pieces."""
    return split_at_joints(curve, zero_form(curve, "critical_curvature")[1], lambda t: joint(curve, t) == CONTINUOUS)


def curvature_extrema(curve: Any, variant: str = MINIMAL) -> list[Feature]:
    """The extrema of the curvature: inside segments, and at knots where κ is continuous and κ′ changes its sign, with
    or without a jump.

    >>> from exactspline.splines.examples import example
    >>> found = curvature_extrema(example("six_segment_cubic"))
    >>> len(found), sum(f.by_jump for f in found)
    (8, 2)
    >>> [f.kind for f in curvature_extrema(example("ellipse"))]
    ['maximum', 'minimum', 'maximum', 'minimum']

    Raises `ShapeError` for a curve that is not in the plane.
    """
    return [f for f in critical_points(curve, variant) if f.kind != "stationary"]


def critical_points(curve: Any, variant: str = MINIMAL) -> list[Feature]:
    """The extrema of the curvature and the points where κ′ = 0 without an extremum (``stationary``)."""
    singular = {f.root for f in singularities(curve)}
    _, found = zero_form(curve, "critical_curvature", variant)
    true = list(zero_form(curve, "critical_curvature")[1]) if variant == SQUARING else []
    features = []
    for solved in found:
        # squaring adds roots where κ = 0; what remains is judged by κ′ itself
        root = next((r for r in true if r == solved), None) if variant == SQUARING else solved
        if (
            root is None
            or root in singular
            or (root.at_knot and inside(curve, root.low) and joint(curve, root.low) != CONTINUOUS)
        ):
            continue
        features.append(_extremum(curve, root, variant, by_jump=False))
    for jump in found.jumps:
        if jump.sign_change and joint(curve, jump.parameter) == CONTINUOUS:
            features.append(_extremum(curve, jump_root(jump), variant, by_jump=True))
    return sorted(features, key=lambda f: f.root)


def _extremum(curve: Any, root: Root, variant: str, *, by_jump: bool) -> Feature:
    left, right = root.signs
    if left is None or right is None or left * right >= 0:
        return Feature("stationary", root, variant)
    sign = curvature_sign(curve, root)
    if variant == SQUARING and by_jump:
        left *= sign
    if left == 0:
        return Feature("stationary", root, variant)
    kind = "maximum" if left > 0 else "minimum"
    if sign == 0:
        return Feature(kind, root, variant, by_jump, "minimum")
    return Feature(
        kind, root, variant, by_jump, kind if sign > 0 else {"maximum": "minimum", "minimum": "maximum"}[kind]
    )


def curvature_sign(curve: Any, root: Root) -> int:
    """The sign of κ at a root of another form, exactly: 0 when the root is one of the curvature's too."""
    turning = find("f2")(curve) * curve.w
    if root.exact is not None:
        return _sign(turning(root.exact))
    if any(root == other for other in zeros(turning)):
        return 0
    digits = 10
    while True:
        low, high = root.refine(digits)
        if (
            not any(
                low <= other.low <= high or low <= other.high <= high for other in zeros(turning.restrict(low, high))
            )
            or low == high
        ):
            return _sign(turning((low + high) / 2))
        digits *= 2


def _sign(value: mpq) -> int:
    return int(value > 0) - int(value < 0)
