"""How far a curve may be changed before a feature vanishes or merges with another: a distance up to which it is proved
that the feature persists, and a curve without the feature at a larger distance.

The proved distance is the largest in a list for which `exactspline.geometry.rounded.features` finds the feature exactly
once in all curves within the distance. The other curve is sought by a sequence of linear programs, each for the form of
the curve found before: which change of all numbers by at most a distance raises the form most above zero between two
zeros? Each program is solved approximately, as a game: the best answer to the place where the form is least moves every
number by the whole distance, with the sign of its slope (Brown 1951: the mean of such answers). Exact arithmetic
decides that the curve found does not have the feature.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from heapq import merge
from itertools import pairwise
from math import copysign, inf

from flint import arb, ctx

from exactspline.errors import ShapeError, WeightError
from exactspline.geometry.curves import features
from exactspline.geometry.curves.features import SpaceFacts
from exactspline.geometry.curves.kinds import FeatureKind
from exactspline.geometry.curves.plane_programs import CRITICAL, CURVATURE, TORSION
from exactspline.geometry.derived.constructions import Variant
from exactspline.geometry.recognition.pieces import rounded_up
from exactspline.geometry.rounded.features import NearbyFeature, features_nearby
from exactspline.geometry.rounded.forms import PRECISION, CurvesNear, Family, with_positive_weights
from exactspline.numbers.exact import mpq, to_fmpq
from exactspline.one_line import one_line, short_text
from exactspline.questions.answers import Described
from exactspline.reals.real import Real, real
from exactspline.roots.answers import CurvePiece, OneNumber
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import in_plane_or_space

EXTREMA = FeatureKind.MAXIMUM, FeatureKind.MINIMUM
#: The kinds of features by the dimension, each with the construction whose zeros they are, and its form.
FORMS: dict[int, dict[FeatureKind, tuple[str, int]]] = {
    2: {FeatureKind.INFLECTION: ("zero_curvature", CURVATURE)}
    | dict.fromkeys(EXTREMA, ("critical_curvature", CRITICAL)),
    3: {FeatureKind.TORSION_ZERO: ("zero_torsion", TORSION)}
    | dict.fromkeys(EXTREMA, ("space_critical_curvature", CRITICAL)),
}
#: The distances that are tried, in units of the size of the curve.
DISTANCES = tuple(mpq(m, 8) * mpq(2) ** e for e in range(-60, 0) for m in (8, 10, 12, 14))
#: The number of places between two zeros of a form at which it is raised above zero, and of places beyond these zeros.
PLACES, BESIDE = 10, 2
#: To raise a form, distances are tried that begin with the least one that may be large enough: the factor by which each
#: exceeds the previous one, and their number.
STEP, MOST_STEPS = mpq(9, 8), 26
#: Rounds of the game by which a linear program is solved, and the fractions of its solution that are tried.
ROUNDS = 120
SHARES = 1.0, 0.3
#: Numbers are moved by multiples of the distance divided by this.
FINE = 2**16


@dataclass(frozen=True, repr=False)
class StableFeature(OneNumber, Described):
    """A feature of a curve, and bounds for the changes of the curve that the feature survives.

    Every curve whose control points and weights differ by at most `radius` has this feature exactly once near this
    place; `radius` is 0 if this is proved for no distance. `witness` is a curve with fewer features of this kind, whose
    numbers differ by at most `gone`; both are None if no such curve was found.
    """

    _number = "place"
    kind: FeatureKind
    place: Real
    radius: mpq
    witness: Nurbs | None = None
    gone: mpq | None = None

    @one_line
    def __repr__(self) -> str:
        end = "" if self.gone is None else f", destroyed at {short_text(self.gone)}"
        return f"<{self.kind} at {self.place.shortly()}: stable within {short_text(self.radius)}{end}>"

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
    control points and weights may be changed (each coordinate and each weight separately) before one of these features
    vanishes or merges with another. Zeros of the curvature of a space curve can vanish under arbitrarily small changes
    and are not listed.

    >>> from exactspline import example
    >>> for found in stability(example("cubic_s")):
    ...     print(found.kind, f"{float(found.radius):.3f} {float(found.gone):.3f}")
    minimum 0.031 1.110
    inflection 0.250 0.639
    maximum 0.031 1.110

    Raises `ShapeError` for a curve that is neither in the plane nor in space.
    """
    given = in_plane_or_space(curve, "the stability of a curve")
    positive = with_positive_weights(given)
    facts, radii = SpaceFacts(positive), _Radii(positive)
    with ctx.workprec(PRECISION):
        found = tuple(_stable(facts, kind, place, radii) for kind, place in _features(facts))
    return found if positive is given else tuple(map(_with_negative_weights, found))


def _with_negative_weights(found: StableFeature) -> StableFeature:
    """The feature with a witness whose weights are negative, like those of the curve."""
    c = found.witness
    if c is None:
        return found
    return replace(found, witness=Nurbs(c.degree, c.knots, c.control_points, [-w for w in c.weights]))


def _features(facts: SpaceFacts) -> list[tuple[FeatureKind, Real]]:
    """The features with their parameters, in order."""
    first = features.torsion_zeros if facts.curve.dimension == 3 else features.flat_points
    points = [*first(facts), *features.critical_points(facts)]
    forms = FORMS[facts.curve.dimension]
    found: list[tuple[FeatureKind, Real]] = [(point.kind, point.root) for point in points if point.kind in forms]
    found += [(FeatureKind.CORNER, real(joint.parameter)) for joint in facts.corners]
    return sorted(found, key=lambda each: each[1])


def _stable(facts: SpaceFacts, kind: FeatureKind, place: Real, radii: _Radii) -> StableFeature:
    curve, low, high = facts.curve, place, place
    if kind is FeatureKind.CORNER:
        moved = _straightened(curve, place)
    else:
        name, which = FORMS[curve.dimension][kind]
        variant = Variant.PAPER if which == TORSION and curve.dimension == 3 else Variant.MINIMAL
        around = _around(list(facts.zero_form(name, variant).zeros), place, curve)
        low, high = (real((a + b) / 2) for a, b in pairwise(around[1:4]))
        moved = _flattened(curve, which, around)
    before = len(_of_kind(facts, kind))
    witness = next((each for each in moved if _lacks(each, kind, before, low, high)), None)
    gone = None if witness is None else _difference(curve, witness)
    return StableFeature(kind, place, radii.of(kind, place), witness, gone)


def _around(zeros: Sequence[Real], place: Real, curve: Nurbs) -> list[mpq]:
    """The approximate places of a zero of a form, of the two zeros before it and of the two zeros behind it; the ends
    of the domain replace zeros that do not exist.
    """
    (start, end), near = curve.domain, sorted(zeros)
    before, behind = [x for x in near if x < place][-2:], [x for x in near if x > place][:2]
    found = [x.enclosure(20).middle for x in (*before, place, *behind)]
    return [start] * (2 - len(before)) + found + [end] * (2 - len(behind))


def _lacks(curve: Nurbs, kind: FeatureKind, before: int, low: Real, high: Real) -> bool:
    """Whether a curve has fewer features of a kind, by exact arithmetic, and none between these places, so that the
    missing feature is this one.
    """
    found = _of_kind(SpaceFacts(curve), kind)
    return len(found) < before and not any(low <= place <= high for place in found)


def _size(curve: Nurbs) -> mpq:
    return max(max(column) - min(column) for column in zip(*curve.control_points, strict=True)) or mpq(1)


class _Radii:
    """The largest distances for which features are certain, found by halving; results are shared by all features."""

    def __init__(self, curve: Nurbs) -> None:
        self.curve, self._found = curve, dict[int, tuple[NearbyFeature, ...]]()
        self.size = _size(curve)

    def of(self, kind: FeatureKind, place: Real) -> mpq:
        """The largest distance in the list for which a feature is certain; 0 if there is none."""
        low, high = -1, len(DISTANCES)
        while high - low > 1:
            tried = (low + high) // 2
            if any(x.single and x.kind is kind and x.place.low <= place <= x.place.high for x in self._nearby(tried)):
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


def _of_kind(facts: SpaceFacts, kind: FeatureKind) -> list[Real]:
    """The parameters of the features of a kind."""
    return [place for each, place in _features(facts) if each is kind]


def _difference(a: Nurbs, b: Nurbs) -> mpq:
    """The largest difference of coordinates of control points and of weights."""
    rows = zip((*a.control_points, a.weights), (*b.control_points, b.weights), strict=True)
    return max(abs(x - y) for row, other in rows for x, y in zip(row, other, strict=True))


def _straightened(curve: Nurbs, place: Real) -> Iterator[Nurbs]:
    """The curve without a corner: its control point there is moved half the way to the segment between its neighbours,
    and the neighbours half the way to this control point.
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


def _flattened(curve: Nurbs, which: int, around: Sequence[mpq]) -> Iterator[Nurbs]:
    """Curves near a curve, the nearest first, whose form has one sign around the third of five zeros and one of its
    neighbours.
    """
    lifting = _Lifting(curve, which)
    both = [lifting.curves(around[1:]), lifting.curves(around[3::-1])]
    return (found for _, found in merge(*both, key=lambda each: each[0]))


class _Lifting:
    """Changes of a curve that raise a form above zero."""

    def __init__(self, curve: Nurbs, which: int) -> None:
        self.curve, self.which, self.size = curve, which, _size(curve)
        self.width = curve.dimension + (not curve.polynomial)

    def curves(self, places: Sequence[mpq]) -> Iterator[tuple[mpq, Nurbs]]:
        """Curves whose form has, at some places around the second and the third of four zeros, the sign that it does
        not have between these zeros; with their increasing distances.
        """
        first, zero, other, last = places
        inner = _spread(zero, other, PLACES)
        outer = [*_spread((first + 3 * zero) / 4, zero, BESIDE), *_spread(other, (3 * other + last) / 4, BESIDE)]
        known = self._rows(self.curve, [*inner, *outer], 1)
        middle = known.get(inner[PLACES // 2])
        if zero == other or middle is None or not middle.height:
            return
        up = -1 if middle.height > 0 else 1
        # next to a zero the form may change its sign by a jump
        at = [t for t, row in known.items() if t in inner or row.height * up > 0]
        rows = self._rows(self.curve, at, up)
        hardest, steps = min(rows.values(), key=lambda row: row.height), dict[int, float]()
        distance = mpq(-hardest.height)
        for _ in range(MOST_STEPS if distance > 0 else 0):
            distance = rounded_up(distance * STEP)
            best = _best([*rows.values()], steps, float(distance))
            for share in SHARES:
                tried = {k: steps.get(k, 0.0) * (1 - share) + x * share for k, x in best.items()}
                with suppress(ShapeError, WeightError):
                    found = self._rows(self._moved(tried, distance), at, up)
                    if _least(found) > _least(rows):
                        steps, rows = tried, found
                        break
            if _least(rows) > 0:
                yield distance, self._moved(steps, distance)
            straight = {k: copysign(float(distance), x) for k, x in hardest.slopes.items()}
            with suppress(ShapeError, WeightError):
                if _least(self._rows(curve := self._moved(straight, distance), inner, up)) > 0:
                    yield distance, curve

    def _rows(self, curve: Nurbs, places: Sequence[mpq], up: int) -> dict[mpq, _Row]:
        """The form at some places, to first order; without places at which no change affects it."""
        forms, known, found = CurvesNear(curve, mpq(0)), dict[int, Family](), dict[mpq, _Row]()
        for t in places:
            i = curve.mesh.locate(t)
            if i not in known:
                known[i] = forms.form(self.which, i)
            value, *slopes = known[i].values(curve.mesh.local(i, t))[:-1]
            norm = sum(map(abs, slopes), start=arb(0))
            if norm > 0:
                first = forms.basis(i)[0] * self.width
                share = {first + k: up * float((x / norm).mid()) for k, x in enumerate(slopes) if x}
                found[t] = _Row(up * float((value / norm / to_fmpq(self.size)).mid()), share)
        return found

    def _moved(self, steps: dict[int, float], distance: mpq) -> Nurbs:
        """The curve with its numbers moved by these steps, rounded to fractions of a distance."""
        points, weights = [list(p) for p in self.curve.control_points], list(self.curve.weights)
        for k, step in steps.items():
            i, c = divmod(k, self.width)
            share = mpq(max(-FINE, min(FINE, round(step / float(distance) * FINE))), FINE)
            if c < self.curve.dimension:
                points[i][c] += share * distance * self.size
            else:
                weights[i] += share * distance * self.size
        return Nurbs(self.curve.degree, self.curve.knots, points, weights)


@dataclass(frozen=True)
class _Row:
    """A form at a place. `height` is the change of all numbers, in units of the size of the curve and with a sign, for
    which the form is 0; `slopes` are the effects of a change of each number.
    """

    height: float
    slopes: dict[int, float]

    def change(self, steps: dict[int, float]) -> float:
        """The change of the height by steps."""
        return sum(x * steps[k] for k, x in self.slopes.items() if k in steps)


def _least(rows: dict[mpq, _Row]) -> float:
    return min((row.height for row in rows.values()), default=-inf)


def _best(rows: Sequence[_Row], steps: dict[int, float], distance: float) -> dict[int, float]:
    """Steps, none longer than a distance, that make the least of the forms approximately as large as possible; `rows`
    are the forms after the given steps.
    """
    answers = [{k: copysign(distance, x) for k, x in row.slopes.items()} for row in rows]
    base = [row.height - row.change(steps) for row in rows]
    changes = [[row.change(answer) for answer in answers] for row in rows]
    means, times = [0.0] * len(rows), [0] * len(rows)
    for k in range(ROUNDS):
        least = min(range(len(rows)), key=lambda i: base[i] + means[i])
        times[least] += 1
        means = [mean + (own[least] - mean) / (k + 1) for mean, own in zip(means, changes, strict=True)]
    found = dict[int, float]()
    for n, answer in zip(times, answers, strict=True):
        for k, x in answer.items() if n else ():
            found[k] = found.get(k, 0.0) + x * n / ROUNDS
    return found


def _spread(a: mpq, b: mpq, count: int) -> list[mpq]:
    """Places from a to b, evenly, both included."""
    return [a + (b - a) * mpq(k, count) for k in range(count + 1)]
