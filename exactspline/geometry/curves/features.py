"""Zeros and extrema of the curvature of a curve, and zeros of the torsion, from its facts. All are zeros of a form
(see `exactspline.geometry.derived.constructions`), found by `exactspline.roots`. On a closed curve the seam is a knot
like any other and counts once.

In space κ ≥ 0. Where κ = 0 (γ′ × γ″ = 0 at a regular point) it has a minimum: these points are listed by their own
kinds, and not again among the extrema. The form [D1 D2 D3] of the torsion vanishes there whether or not τ does, so that
τ itself, in lowest terms, decides. A zero at which γ′ = 0 is reported as a singular point only.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable

from exactspline.formulas.lifted import torsion_zeros_lifted
from exactspline.geometry.curves.facts import Facts, ZeroForm, among
from exactspline.geometry.curves.joints import Joint, Point, limit_direction, same_direction
from exactspline.geometry.curves.kinds import Feature, FeatureKind, JointKind
from exactspline.geometry.derived.constructions import Variant
from exactspline.geometry.derived.derive import space
from exactspline.language.rational import Rational
from exactspline.language.vector import norm2
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Side
from exactspline.questions.entry import Fact
from exactspline.roots.root import Root, knot_root
from exactspline.splines.bspline import BSpline
from exactspline.splines.lowest_terms import common_factor, where_it_exists

BINORMAL, TORSION = "binormal_form", "D1_D2_D3"


class SpaceFacts(Facts):
    """The facts of one curve, also those that only a space curve has."""

    @Fact
    def bending(self) -> ZeroForm:
        """A spline that vanishes exactly where all components of γ′ × γ″ do, and its zeros."""
        return self.solved(lambda: common_factor(self.binormal))

    @Fact
    def reduced_torsion(self) -> Rational[BSpline]:
        """τ as a quotient in lowest terms, segment by segment; 0/1 where the curve is straight."""
        w, bend = self.operands.w, norm2(self.binormal)
        return where_it_exists(Rational(self._twist if self.operands.polynomial else self._twist * w * w, bend))

    @Fact
    def _twist(self) -> BSpline:
        """``[γ′ γ″ γ‴]`` times a power of the weight function."""
        space(self.operands)
        form = self.lowest_of(torsion_zeros_lifted)
        assert isinstance(form, BSpline)
        return form

    @Fact
    def torsion_numerator(self) -> ZeroForm:
        """The numerator of τ in lowest terms."""
        return self.solved(lambda: self.reduced_torsion.scalar)

    def bend(self, t: mpq, side: Side | str) -> Point:
        """A positive multiple of γ′ × γ″ at a parameter, its limit at a knot; zeros where κ = 0."""
        left, right = self.sides(t)
        return tuple(c(left if side == Side.LEFT else right, side) for c in self.binormal)

    def is_flat(self, root: Root) -> bool:
        """Whether γ′ × γ″ = 0 at a root (at a knot: seen from both sides)."""
        if root.low == root.high:
            return not any(any(self.bend(root.low, side)) for side in Side)
        roots = self.bending.zeros.roots
        position = bisect_left(roots, root)
        return position < len(roots) and roots[position] == root


def flat_points(facts: Facts) -> list[Feature]:
    """The zeros of the curvature at regular points; in space also where κN is reversed by a jump."""
    if isinstance(facts, SpaceFacts) and facts.curve.dimension == 3:
        return _flat_in_space(facts)
    zeros = facts.regular(facts.zero_form("zero_curvature").zeros)
    regular = [(root, by_jump) for root, by_jump in zeros if _inside_or_at(facts, root, lambda x: x.tangent_continuous)]
    return [Feature(_flat(root), root, Variant.MINIMAL, by_jump) for root, by_jump in regular]


def _inside_or_at(facts: Facts, root: Root, smooth: Callable[[Joint], bool]) -> bool:
    """Whether a root is inside a segment, or at a knot where the curve is smooth enough."""
    if root.at_knot and facts.has_corner(root.low):
        return False
    joint = facts.joint(root.low) if root.at_knot else None
    return joint is None or smooth(joint)


def _flat(root: Root) -> FeatureKind:
    if None in root.signs:
        return FeatureKind.FLAT_END
    return FeatureKind.INFLECTION if root.sign_change else FeatureKind.UNDULATION


def _flat_in_space(facts: SpaceFacts) -> list[Feature]:
    least = FeatureKind.MINIMUM
    features = [
        Feature(
            FeatureKind.INFLECTION if root.multiplicity % 2 else FeatureKind.UNDULATION,
            root,
            BINORMAL,
            of_absolute=least,
        )
        for root, by_jump in facts.regular(facts.bending.zeros)
        if not root.at_knot and not by_jump
    ]
    features += [f for joint in facts.joints if joint.tangent_continuous for f in _flat_knot(facts, joint.parameter)]
    if not facts.closed:
        for t, side in ((facts.breaks[0], Side.RIGHT), (facts.breaks[-1], Side.LEFT)):
            flat = not any(facts.bend(t, side)) and any(limit_direction(facts.binormal, t, side))
            if flat and not facts.is_singular(knot_root(t)):
                features.append(Feature(FeatureKind.FLAT_END, knot_root(t), BINORMAL, of_absolute=least))
    return sorted(features, key=lambda f: f.root)


def _flat_knot(facts: SpaceFacts, t: mpq) -> list[Feature]:
    """The zero of the curvature at a knot with one tangent, if there is one, or its reversal by a jump."""
    left, right = facts.bend(t, Side.LEFT), facts.bend(t, Side.RIGHT)
    flat = not any(left) and not any(right)
    if not any(left) or not any(right):
        left, right = facts.directions(facts.binormal, t)
    if not any(left) or not any(right):
        return []
    if same_direction(left, tuple(-x for x in right)):
        kind = FeatureKind.INFLECTION
    elif not flat:
        return []
    else:
        kind = FeatureKind.UNDULATION if same_direction(left, right) else FeatureKind.FLAT_POINT
    absolute = FeatureKind.MINIMUM if flat else None
    return [Feature(kind, knot_root(t), BINORMAL, kind is FeatureKind.INFLECTION and not flat, absolute)]


def torsion_zeros(facts: SpaceFacts) -> list[Feature]:
    """The zeros of the torsion at regular points, and its changes of sign by a jump."""
    zeros = facts.regular(facts.zero_form("zero_torsion", Variant.PAPER).zeros)
    true = among([root for root, _ in zeros], facts.torsion_numerator.zeros.roots)
    features = []
    for (root, by_jump), zero in zip(zeros, true, strict=True):
        if root.at_knot:
            features += _torsion_at_knot(facts, root, root.sign_change or by_jump)
        elif zero:
            features.append(Feature(_torsion_kind(root), root, TORSION))
    return features


def _torsion_kind(root: Root) -> FeatureKind:
    if None in root.signs:
        return FeatureKind.TORSION_END
    return FeatureKind.TORSION_ZERO if root.sign_change else FeatureKind.TORSION_TOUCH


def _torsion_at_knot(facts: SpaceFacts, root: Root, changes: bool) -> list[Feature]:
    """A zero of the torsion at a knot where the two sides have one osculating plane: of τ itself on both sides, or a
    change of its sign.
    """
    t, torsion, joint = root.low, facts.reduced_torsion, facts.joint(root.low)
    if t in facts.curve.domain and not facts.closed:
        at_end = torsion(t, Side.LEFT if t == facts.breaks[-1] else Side.RIGHT) == 0
        return [Feature(FeatureKind.TORSION_END, root, TORSION)] if at_end else []
    if joint is not None and (not joint.tangent_continuous or joint.kind is JointKind.TURN):
        return []
    left, right = facts.sides(t)
    if torsion(left, Side.LEFT) == torsion(right, Side.RIGHT) == 0:
        return [Feature(_torsion_kind(root), root, TORSION)]
    return [Feature(FeatureKind.TORSION_ZERO, root, TORSION, by_jump=True)] if changes else []


def critical_points(facts: Facts) -> list[Feature]:
    """The extrema of the curvature and the points where κ′ = 0 without an extremum (``stationary``); in space except
    those where κ = 0.
    """
    space_facts = facts if isinstance(facts, SpaceFacts) and facts.curve.dimension == 3 else None
    zeros = facts.regular(facts.zero_form("space_critical_curvature" if space_facts else "critical_curvature").zeros)
    return [
        _extremum(facts, root, by_jump=by_jump)
        for root, by_jump in zeros
        if _inside_or_at(facts, root, lambda joint: joint.same_curvature)
        and not (space_facts and space_facts.is_flat(root))
    ]


def _extremum(facts: Facts, root: Root, *, by_jump: bool) -> Feature:
    """A zero of κ′, classified by the signs of κ′ on both sides and by that of κ there."""
    left, right = root.signs
    if not left or not right or left == right:
        return Feature(FeatureKind.STATIONARY, root, Variant.MINIMAL)
    kind = FeatureKind.MAXIMUM if left > 0 else FeatureKind.MINIMUM
    sign = 1 if facts.curve.dimension == 3 else facts.sign_of("zero_curvature", root)
    of_absolute = FeatureKind.MINIMUM if sign == 0 else kind if sign > 0 else kind.opposite
    return Feature(kind, root, Variant.MINIMAL, by_jump, of_absolute)
