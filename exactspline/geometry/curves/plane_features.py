"""Inflections, curvature extrema and special pieces of a plane curve, from its facts. All are zeros of a form of the
curve (see `exactspline.geometry.derived.constructions`), found by `exactspline.roots`; a zero at which γ′ = 0 is
reported as a singular point only. On a closed curve the seam is a knot like any other and counts once.
"""

from __future__ import annotations

from exactspline.geometry.curves.facts import Facts, ZeroForm
from exactspline.geometry.curves.kinds import Feature, FeatureKind
from exactspline.geometry.derived.constructions import Variant
from exactspline.roots.root import Root


def flat_points(facts: Facts) -> list[Feature]:
    """The zeros of the curvature at regular points."""
    features = []
    for root, by_jump in facts.regular(facts.zero_form("zero_curvature").zeros):
        if root.at_knot and facts.has_corner(root.low):
            continue
        joint = facts.joint(root.low) if root.at_knot else None
        if joint is None or joint.tangent_continuous:
            features.append(Feature(_flat(root), root, Variant.MINIMAL, by_jump))
    return features


def _flat(root: Root) -> FeatureKind:
    if None in root.signs:
        return FeatureKind.FLAT_END
    return FeatureKind.INFLECTION if root.sign_change else FeatureKind.UNDULATION


def critical_points(facts: Facts) -> list[Feature]:
    """The extrema of the curvature and the points where κ′ = 0 without an extremum (``stationary``)."""
    features, curvature = [], facts.zero_form("zero_curvature")
    for root, by_jump in facts.regular(facts.zero_form("critical_curvature").zeros):
        if root.at_knot and facts.has_corner(root.low):
            continue
        joint = facts.joint(root.low) if root.at_knot else None
        if joint is None or joint.same_curvature:
            features.append(_extremum(curvature, root, by_jump=by_jump))
    return features


def _extremum(curvature: ZeroForm, root: Root, *, by_jump: bool) -> Feature:
    """A zero of κ′, classified by the signs of κ′ on both sides and by that of κ there."""
    left, right = root.signs
    if not left or not right or left == right:
        return Feature(FeatureKind.STATIONARY, root, Variant.MINIMAL)
    kind = FeatureKind.MAXIMUM if left > 0 else FeatureKind.MINIMUM
    sign = curvature.sign_at(root)
    of_absolute = FeatureKind.MINIMUM if sign == 0 else kind if sign > 0 else kind.opposite
    return Feature(kind, root, Variant.MINIMAL, by_jump, of_absolute)
