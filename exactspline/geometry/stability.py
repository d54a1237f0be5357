"""How far a curve may be changed until a feature vanishes or merges with another: a distance for which it is
proved that no such change does it, and a curve, at a distance not much larger, without the feature.

The distance is the largest of a list for which `exactspline.geometry.nearby` finds the feature once in all curves that
near. The other curve moves each control point by the same amount, in the direction in which the form of the feature
grows fastest where it is hardest to lift over zero; that it lacks a feature is decided in exact arithmetic.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from itertools import pairwise

from flint import arb, ctx

from exactspline.errors import ShapeError, WeightError
from exactspline.geometry import plane_features, space_features
from exactspline.geometry.constructions import Variant
from exactspline.geometry.facts import Facts
from exactspline.geometry.kinds import FeatureKind
from exactspline.geometry.nearby import NearbyFeature, features_nearby
from exactspline.geometry.nearby_forms import PRECISION, CurvesNear, Family, best_factor
from exactspline.geometry.plane_programs import CRITICAL, CURVATURE, TORSION
from exactspline.geometry.recognition.proof import rounded_up
from exactspline.geometry.space_features import SpaceFacts
from exactspline.numbers.exact import mpq, sign
from exactspline.numbers.intervals import ball_ends
from exactspline.questions.answers import CurvePiece, Described
from exactspline.reals.real import Real, real
from exactspline.splines.expected import curve_of
from exactspline.splines.nurbs import Nurbs

EXTREMA = FeatureKind.MAXIMUM, FeatureKind.MINIMUM
#: Kinds of features by the dimension, with the constructions of which they are zeros, and their forms.
FORMS: dict[int, dict[FeatureKind, tuple[str, int]]] = {
    2: {FeatureKind.INFLECTION: ("zero_curvature", CURVATURE)}
    | dict.fromkeys(EXTREMA, ("critical_curvature", CRITICAL)),
    3: {FeatureKind.TORSION_ZERO: ("zero_torsion", TORSION)}
    | dict.fromkeys(EXTREMA, ("space_critical_curvature", CRITICAL)),
}
#: The distances that are tried, in units of the size of the curve.
DISTANCES = tuple(mpq(m, 8) * mpq(2) ** e for e in range(-60, 0) for m in (8, 10, 12, 14))
#: Where, between two zeros of a form, it may be hardest to lift over zero.
PLACES = tuple(mpq(k, 12) for k in range(1, 12))
#: How many places at which two zeros may merge are tried.
MERGED = 3
#: Multiples of the distance that the linear part of the form asks for.
FACTORS = tuple(mpq(n, 16) for n in (17, 20, 24, 32, 48, 64, 96, 128, 256))


@dataclass(frozen=True)
class StableFeature(Described):
    """A feature of a curve, and how far the curve may be changed.

    Every curve whose control points and weights differ by at most `radius` has this feature exactly once near this
    place; 0 where nothing like that is proved. `witness` is a curve with fewer features of this kind, whose numbers
    differ by at most `gone`; None where none was found.
    """

    kind: FeatureKind
    place: Real
    radius: mpq
    witness: Nurbs | None = field(default=None, repr=False)
    gone: mpq | None = None

    @property
    def piece(self) -> CurvePiece:  # type: ignore[override]  # an enclosure of the parameter
        """The parameter, enclosed to twenty digits."""
        return CurvePiece((self.place.enclosure(20),))

    @property
    def values(self) -> dict[str, tuple[Real, ...]]:
        """The two distances."""
        known = {"radius": self.radius, "gone": self.gone}
        return {name: (real(value),) for name, value in known.items() if value is not None}


def stability(curve: Nurbs) -> tuple[StableFeature, ...]:
    """Inflections (in space: zeros of the torsion), extrema of the curvature and corners of a curve, and how far its
    control points and weights may be changed (each coordinate and each weight for itself) without one of them vanishing
    or merging with another. Zeros of the curvature of a space curve vanish by any change, so that they are not here.

    >>> from exactspline import example
    >>> for found in stability(example("cubic_s")):
    ...     print(found.kind, f"{float(found.radius):.3f} {float(found.gone):.3f}")
    minimum 0.031 1.000
    inflection 0.250 0.756
    maximum 0.031 1.000

    Raises `ShapeError` for a curve that is neither in the plane nor in space.
    """
    given = curve_of(curve)
    if given.dimension not in FORMS:
        raise ShapeError(
            f"the stability of a curve in R{given.dimension}", remedy="this needs a curve in the plane or in space"
        )
    facts, radii = _facts(given), _Radii(given)
    with ctx.workprec(PRECISION):
        return tuple(_stable(facts, kind, place, radii) for kind, place in _features(facts))


def _facts(curve: Nurbs) -> Facts:
    return Facts(curve) if curve.dimension == 2 else SpaceFacts(curve)


def _features(facts: Facts) -> list[tuple[FeatureKind, Real]]:
    """The features with their parameters, in order."""
    if isinstance(facts, SpaceFacts):
        points = [*space_features.torsion_zeros(facts), *space_features.critical_points(facts, Variant.MINIMAL)]
    else:
        points = [*plane_features.flat_points(facts), *plane_features.critical_points(facts, Variant.MINIMAL)]
    forms = FORMS[facts.curve.dimension]
    found: list[tuple[FeatureKind, Real]] = [(point.kind, point.root) for point in points if point.kind in forms]
    found += [(FeatureKind.CORNER, real(joint.parameter)) for joint in facts.corners]
    return sorted(found, key=lambda each: each[1])


def _stable(facts: Facts, kind: FeatureKind, place: Real, radii: _Radii) -> StableFeature:
    curve, low, high = facts.curve, place, place
    if kind is FeatureKind.CORNER:
        moved = _straightened(curve, place)
    else:
        name, which = FORMS[curve.dimension][kind]
        variant = Variant.PAPER if which == TORSION and curve.dimension == 3 else Variant.MINIMAL
        low, high = _neighbours(list(facts.zero_form(name, variant).zeros), place, curve)
        moved = _flattened(curve, which, (low, place, high))
    before = len(_of_kind(facts, kind))
    witness = next((each for each in moved if _lacks(each, kind, before, low, high)), None)
    gone = None if witness is None else _difference(curve, witness)
    return StableFeature(kind, place, radii.of(kind, place), witness, gone)


def _neighbours(zeros: Sequence[Real], place: Real, curve: Nurbs) -> tuple[Real, Real]:
    """The zeros before and behind one, or the ends of the domain."""
    start, end = map(real, curve.domain)
    before, behind = [x for x in zeros if x < place], [x for x in zeros if x > place]
    return before[-1] if before else start, behind[0] if behind else end


def _lacks(curve: Nurbs, kind: FeatureKind, before: int, low: Real, high: Real) -> bool:
    """Whether a curve has fewer features of a kind, by exact arithmetic, and none of them between these places, so that
    it is not another one that is missing.
    """
    found = _of_kind(_facts(curve), kind)
    return len(found) < before and not any(low <= place <= high for place in found)


class _Radii:
    """The largest distances for which features are certain, found by halving; what is computed serves all features."""

    def __init__(self, curve: Nurbs) -> None:
        self.curve, self._found = curve, dict[int, tuple[NearbyFeature, ...]]()
        columns = list(zip(*curve.control_points, strict=True))
        self.size = max(max(column) - min(column) for column in columns) or mpq(1)

    def of(self, kind: FeatureKind, place: Real) -> mpq:
        """The largest distance that is tried for a feature, 0 for none."""
        low, high = -1, len(DISTANCES)
        while high - low > 1:
            tried = (low + high) // 2
            if any(_is_here(near, kind, place) for near in self._nearby(tried)):
                low = tried
            else:
                high = tried
        return DISTANCES[low] * self.size if low >= 0 else mpq(0)

    def _nearby(self, index: int) -> tuple[NearbyFeature, ...]:
        if index not in self._found:
            try:
                self._found[index] = features_nearby(self.curve, DISTANCES[index] * self.size)
            except ShapeError:  # a weight function may vanish at this distance
                self._found[index] = ()
        return self._found[index]


def _is_here(near: NearbyFeature, kind: FeatureKind, place: Real) -> bool:
    """Whether it is this feature, and all curves have it once."""
    return near.single and near.kind is kind and near.place.low <= place <= near.place.high


def _of_kind(facts: Facts, kind: FeatureKind) -> list[Real]:
    """Where a curve has features of a kind."""
    return [place for each, place in _features(facts) if each is kind]


def _difference(a: Nurbs, b: Nurbs) -> mpq:
    """The largest difference of coordinates of control points and of weights."""
    rows = zip((*a.control_points, a.weights), (*b.control_points, b.weights), strict=True)
    return max(abs(x - y) for row, other in rows for x, y in zip(row, other, strict=True))


def _straightened(curve: Nurbs, place: Real) -> Iterator[Nurbs]:
    """The curve without a corner: its control point there moved half the way to the segment between its neighbours,
    and they half the way to it.
    """
    t, points = place.exact, list(curve.control_points)
    # a seam, or two control points at the corner
    if t is None or t in curve.domain or curve.knots.multiplicity(t) != curve.degree:
        return
    first = next(i for i, knot in enumerate(curve.knots) if knot == t)
    before, at, behind = points[first - 2 : first + 1]
    along = [b - a for a, b in zip(before, behind, strict=True)]
    square = sum(x * x for x in along)
    if not square:
        return
    share = sum((x - a) * u for x, a, u in zip(at, before, along, strict=True)) / square
    share = min(max(share, mpq(1, 16)), mpq(15, 16))
    half = [(a + share * u - x) / 2 for x, a, u in zip(at, before, along, strict=True)]
    for i, ahead in ((first - 2, -1), (first - 1, 1), (first, -1)):
        points[i] = tuple(x + ahead * h for x, h in zip(points[i], half, strict=True))
    yield Nurbs(curve.degree, curve.knots, points, curve.weights)


def _flattened(curve: Nurbs, which: int, places: tuple[Real, Real, Real]) -> Iterator[Nurbs]:
    """Curves near a curve, the nearest first, whose form is lifted over zero between the middle one of three places, a
    zero, and one of the others, or which has a double zero there.
    """
    gradients = _Gradients(curve, which)
    lifts = [[list(gradients.lifts(t)) for t in _samples(*gap, curve)] for gap in pairwise(places)]
    nearest = [max((single for single, *_ in own), key=_distance) for own in lifts]
    nearest += sorted((double for own in lifts for _, *both in own for double in both), key=_distance)[:MERGED]
    tried = [(lift.distance * factor, lift) for lift in nearest for factor in FACTORS]
    for distance, lift in sorted(tried, key=lambda each: each[0]):
        if distance:
            with suppress(WeightError):
                yield lift.applied(curve, rounded_up(distance))


def _distance(lift: _Lift) -> mpq:
    return lift.distance


def _samples(low: Real, high: Real, curve: Nurbs) -> list[mpq]:
    """Places between two zeros, with those of them that are ends of the domain."""
    a, b = low.enclosure(20).middle, high.enclosure(20).middle
    return [a + (b - a) * share for share in PLACES] + [t for t in (a, b) if t in curve.domain]


@dataclass(frozen=True)
class _Lift:
    """By how much control points must be moved, at first order, so that the form vanishes at a place, or has a double
    zero there: each coordinate and weight of the control points from `first` on by a share of `distance`.
    """

    distance: mpq
    first: int
    shares: tuple[tuple[mpq, ...], ...]

    def applied(self, curve: Nurbs, distance: mpq) -> Nurbs:
        """The curve with its control points moved by this distance."""
        return _moved(curve, {self.first + i: [s * distance for s in row] for i, row in enumerate(self.shares)})


def _moved(curve: Nurbs, steps: dict[int, Sequence[mpq]]) -> Nurbs:
    """The curve with control points moved by these steps, each for all coordinates and, perhaps, the weight."""
    points, weights = list(curve.control_points), list(curve.weights)
    for i, row in steps.items():
        points[i] = tuple(x + step for x, step in zip(points[i], row, strict=False))
        weights[i] += sum(row[curve.dimension :])
    return Nurbs(curve.degree, curve.knots, points, weights)


class _Gradients:
    """A form of a curve, and how it changes with the control points, segment by segment."""

    def __init__(self, curve: Nurbs, which: int) -> None:
        self.curve, self.which = curve, which
        self.forms, self._known = CurvesNear(curve, mpq(0)), dict[int, Family]()

    def lifts(self, t: mpq) -> Iterator[_Lift]:
        """What lifts the form to zero at a parameter, and what makes that a double zero there."""
        i = self.curve.mesh.locate(t)
        if i not in self._known:
            self._known[i] = self.forms.form(self.which, i)
        first = self.forms.basis(i)[0]
        own, derivatives = (
            [*map(_middle, x)][:-1] for x in self._known[i].values_and_slopes(self.curve.mesh.local(i, t))
        )
        yield self._lift(own, first)
        free, factor = best_factor(own, derivatives)
        if free is None:
            return
        lift = self._lift([d + factor * v for d, v in zip(derivatives, own, strict=True)], first)
        shares = [x for row in lift.shares for x in row]
        # one number is free: the form itself vanishes, too
        rest = own[0] + lift.distance * sum(
            x * v for k, (x, v) in enumerate(zip(shares, own[1:], strict=True)) if k != free
        )
        if lift.distance and abs(share := -rest / (own[1 + free] * lift.distance)) <= 1:
            shares[free] = share
            yield _Lift(lift.distance, first, self._by_points(shares))

    def _lift(self, numbers: Sequence[mpq], first: int) -> _Lift:
        value, *slopes = numbers
        norm = sum(map(abs, slopes))
        shares = [mpq(-sign(value) * sign(x)) for x in slopes]
        return _Lift(abs(value) / norm if norm else mpq(0), first, self._by_points(shares))

    def _by_points(self, shares: Sequence[mpq]) -> tuple[tuple[mpq, ...], ...]:
        width = self.forms.per_point
        return tuple(tuple(shares[k : k + width]) for k in range(0, len(shares), width))


def _middle(x: arb) -> mpq:
    return ball_ends(x).middle
