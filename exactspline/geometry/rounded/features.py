"""The features of all curves whose control points and weights differ from those of a given curve by at most epsilon.
The forms of κ and κ′, in space of τ and κ′, are computed with balls as coefficients, which show where their signs are
certain.

If all coefficients of a form in the Bernstein basis have the same sign, all values have this sign, for all these
curves. Between two different certain signs each of the curves has a zero; between two equal certain signs some curves
may have zeros.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, groupby, pairwise

from flint import arb, ctx

from exactspline.geometry.curves.kinds import FeatureKind
from exactspline.geometry.curves.plane_programs import BENDING, CRITICAL, CURVATURE, SPEED, TORSION
from exactspline.geometry.rounded.forms import PRECISION, CurvesNear, Family
from exactspline.language.vector import Vector, cross
from exactspline.numbers.exact import Number, mpq, scalar
from exactspline.numbers.exact import sign as sign_of
from exactspline.numbers.intervals import Interval, ball_ends, joined
from exactspline.numbers.once import cached_property
from exactspline.questions.answers import Described
from exactspline.roots.answers import CurvePiece
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.precision import distance
from exactspline.splines.type_checks import in_plane_or_space

#: The narrowest part of a segment that is examined, in bits.
NARROWEST = 40
#: The narrowest part that is examined where no sign is to be expected.
SHALLOW = 3


@dataclass(frozen=True, repr=False)
class NearbyFeature(Described):
    """A feature of the curves within a distance of a given curve, in an interval of the parameter.

    ``robust``: each of these curves has the feature in the interval; ``single``: exactly once. If it is not robust,
    some of the curves may have it, any number of times, and others may not.
    """

    kind: FeatureKind
    piece: CurvePiece
    robust: bool
    single: bool = False

    @property
    def place(self) -> Interval:
        """The interval of the parameter."""
        return self.piece.parts[0]

    @property
    def facts(self) -> dict[str, bool]:
        """Whether the feature is robust, and whether it is single."""
        return {"robust": self.robust, "single": self.single}


@dataclass(frozen=True)
class _Part:
    """A part of the domain, and the sign of a form there for all curves; 0 if it is not certain. In this case a `slope`
    of 1 or −1 means that the form increases or decreases at all its zeros, for all curves. `ends` are the signs of the
    form of the curve itself at both ends.
    """

    low: mpq
    high: mpq
    sign: int
    slope: int = 0
    ends: tuple[int, int] = (0, 0)


def features_nearby(curve: Nurbs, epsilon: Number) -> tuple[NearbyFeature, ...]:
    """Inflections (in space: zeros of the torsion), extrema of the curvature, corners and singular points of all curves
    near a given curve, and those that only some of them may have. A curve is near if its coordinates and, for a
    rational curve, weights differ by at most epsilon (a number, or ``written``: see `exactspline.splines.precision`).

    `inflection` means any zero of κ, also a zero at which the sign of κ is kept or the domain ends; the same holds for
    zeros of the torsion. `maximum` and `minimum` include zeros of κ′ without an extremum, and `stop` means any singular
    point. Corners are at knots. Features at the seam of a closed curve are never robust, because other curves near it
    are not closed. In space κ may be zero for some of the curves, never for all, so that inflections are never robust.
    The features are in the order of the parameter.

    >>> from exactspline import example
    >>> for found in features_nearby(example("cubic_s"), "1/1000"):
    ...     print(found.kind, found.robust, found.single, *(round(float(t), 2) for t in found.place))
    minimum True True 0.19 0.19
    inflection True True 0.5 0.5
    maximum True True 0.81 0.81

    Raises `ShapeError` for a curve that is neither in the plane nor in space, for an epsilon that is not positive, and
    if a weight function of a near curve may vanish.
    """
    with ctx.workprec(PRECISION):
        found = list(_near(curve, epsilon).features())
    return tuple(sorted(found, key=lambda feature: (feature.place, feature.kind)))


def singular_points_nearby(curve: Nurbs, epsilon: Number) -> tuple[NearbyFeature, ...]:
    """The intervals, in order, in which curves near this one may have singular points, such as cusps; elsewhere none of
    them has a singular point. A curve is near if its coordinates and, for a rational curve, weights differ from the
    given ones by at most epsilon.

    >>> from exactspline import Nurbs, example
    >>> nearly = Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (1, 1), ("-1/1000", 1), (1, 0)])
    >>> [len(singular_points_nearby(nearly, epsilon)) for epsilon in ("1/10", "1/100000")]
    [1, 0]

    Raises `ShapeError` like `features_nearby`.
    """
    with ctx.workprec(PRECISION):
        return tuple(_near(curve, epsilon).singular_points())


def _near(curve: Nurbs, epsilon: Number) -> _Features:
    given = in_plane_or_space(curve, "curves near a curve")
    return _Features(given, distance(epsilon, given))


class _Features(CurvesNear):
    """The features of the curves near a curve."""

    def features(self) -> Iterator[NearbyFeature]:
        """The features of each kind."""
        singular = self.singular_points()
        yield from singular
        slow = [feature.place for feature in singular]
        yield from self._corners(slow)
        n = self.curve.degree
        extrema = {1: FeatureKind.MAXIMUM, -1: FeatureKind.MINIMUM}
        zeros = (CURVATURE, dict.fromkeys((1, -1), FeatureKind.INFLECTION), n)
        if self.curve.dimension == 3:
            flat = joined([*self._possible_zeros(BENDING), *map(Interval.point, self._reversals())])
            yield from (_feature(FeatureKind.INFLECTION, place, robust=False) for place in flat)
            slow += flat
            zeros = (TORSION, dict.fromkeys((1, -1), FeatureKind.TORSION_ZERO), n - 1)
        for which, kinds, least in (zeros, (CRITICAL, extrema, n - 1)):
            # at a knot of this multiplicity the tangent (the curvature, in space the osculating plane) may jump, so
            # that a sign may change without a zero
            open_places = joined([*slow, *(Interval.point(t) for _, t in self._knots(least))])
            # and at a knot of multiplicity one less the form itself may jump, so that slopes decide nothing there
            jumps = [Interval.point(t) for _, t in self._knots(least - 1)]
            parts = self._parts(which)
            found, start = [*self._zeros(parts, kinds, jumps)], Interval.point(parts[0].low)
            at_seam = self._at_seam(parts, kinds) - {each.kind for each in found if each.place.low == start.low}
            for feature in [*found, *(_feature(kind, start, robust=False) for kind in at_seam)]:
                doubtful = _meets_one(feature.place, open_places)
                yield replace(feature, robust=False, single=False) if doubtful else feature

    def singular_points(self) -> list[NearbyFeature]:
        """The parts of the domain in which γ′ may vanish for some of the curves."""
        return [_feature(FeatureKind.STOP, place, robust=False) for place in self._possible_zeros(SPEED)]

    def _possible_zeros(self, which: int) -> list[Interval]:
        """The parts of the domain in which a form that is a sum of squares may be 0 for some of the curves."""
        places = [Interval(part.low, part.high) for part in self._parts(which) if part.sign <= 0]
        start, end = self.curve.domain
        # features of a closed curve at its end are at its seam, the start
        seam = [Interval.point(start)] if places and places[-1].high == end and self._may_close else []
        return joined([*seam, *places])

    @cached_property
    def _may_close(self) -> bool:
        """Whether the ends of some of the curves may agree."""
        return self._may_meet(self.curve.segments - 1, 0)

    def _may_meet(self, before: int, behind: int) -> bool:
        """Whether the end of one segment and the start of another may be one point."""
        ends = zip(self._bezier_points(before)[-1], self._bezier_points(behind)[0], strict=True)
        return all(x.overlaps(y) for x, y in ends)

    def _bezier_points(self, i: int) -> list[list[arb]]:
        """The Bézier points of a segment, as balls."""
        first, basis = self.basis(i)
        net = zip(self.points[first : first + len(basis)], self.weights[first:], strict=False)
        columns = [*zip(*[[*[x * w for x in point], w] for point, w in net], strict=True)]
        rows = [[scalar(row, column) for column in columns] for row in zip(*basis, strict=True)]
        return [[x / row[-1] for x in row[:-1]] for row in rows]

    def _reversals(self) -> Iterator[mpq]:
        """The parameters at which κN may be reversed by a jump in some curves: knots, and the seam, at which κ may
        jump.
        """
        joints = [(i, i + 1, t) for i, t in self._knots(self.curve.degree - 1)]
        if self._may_close:
            joints.append((self.curve.segments - 1, 0, self.curve.domain[0]))
        for before, behind, t in joints if self.curve.degree > 1 else ():
            a, b, c = self._bezier_points(before)[:-4:-1]
            d, e, f = self._bezier_points(behind)[:3]
            # backwards in time γ′ changes its sign and γ″ does not
            left, right = (cross(Vector(*_minus(y, x)), Vector(*_minus(z, x))) for x, y, z in ((a, b, c), (d, e, f)))
            if not (scalar([*left], [*right]) < 0 or any(map(sign_of, cross(left, right)))):
                yield t

    def _knots(self, least: int) -> list[tuple[int, mpq]]:
        """The inner knots of at least this multiplicity, with the segments that end there."""
        knots = self.curve.knots
        times = dict(zip(knots.breakpoints, knots.multiplicities, strict=True))
        return [(i, t) for i, t in enumerate(self.curve.breakpoints[1:-1]) if times[t] >= least]

    def _parts(self, which: int) -> list[_Part]:
        """The parts of the domain, on each of which the sign is constant; neighbours with the same sign are joined."""
        mesh = pairwise(self.curve.breakpoints)
        found = [part for i, ends in enumerate(mesh) for part in _apart(_signs(self.form(which, i), Interval(*ends)))]
        return [_joined(group) for _, group in groupby(found, key=lambda part: part.sign)]

    def _zeros(
        self, parts: Sequence[_Part], kinds: dict[int, FeatureKind], jumps: Sequence[Interval]
    ) -> Iterator[NearbyFeature]:
        """The zeros inside the domain and at its ends; the kinds by the sign before the zero."""
        for before, part, behind in zip([None, *parts], parts, [*parts[1:], None], strict=False):
            if part.sign == 0:
                place = Interval(part.low, part.high)
                slope = 0 if _meets_one(place, jumps) else part.slope
                first, last = (x.sign if x is not None else 0 for x in (before, behind))
                if slope and (first == slope or last == -slope):
                    continue
                # between two zeros of one kind there is one of the other kind
                certain = kinds[first] if first * last < 0 else None
                for kind in dict.fromkeys(kinds[x] for x in ((-slope,) if slope else (-1, 1))):
                    yield _feature(kind, place, kind is certain, kind is certain and slope != 0)
            elif before is not None and before.sign == -part.sign:
                yield _feature(kinds[before.sign], Interval(part.low, part.low), robust=True, single=True)

    def _at_seam(self, parts: Sequence[_Part], kinds: dict[int, FeatureKind]) -> set[FeatureKind]:
        """The kinds that a closed curve among these may have at its seam."""
        left, right = ({part.sign} if part.sign else {-1, 1} for part in (parts[-1], parts[0]))
        return {kinds[x] for x in left if -x in right} if self._may_close else set()

    def _corners(self, slow: Sequence[Interval]) -> Iterator[NearbyFeature]:
        """Knots at which the tangents of both sides depend on different control points, or at which γ′ may vanish for
        some of the curves, and the seam.
        """
        if self._may_close:
            yield _feature(FeatureKind.CORNER, Interval.point(self.curve.domain[0]), robust=False)
        for i, t in self._knots(1):
            robust, place = False, Interval.point(t)
            (end, _), (start, _) = self.basis(i), self.basis(i + 1)
            last = end + self.curve.degree
            if last == start:
                left, right = (_minus(self.points[k + 1], self.points[k]) for k in (last - 1, start))
                turns = [left[k] * right[m] - left[m] * right[k] for k, m in combinations(range(len(left)), 2)]
                robust = any(map(sign_of, turns)) or bool(scalar(left, right) < 0)
            elif not (_meets_one(place, slow) if last > start else self._may_meet(i, i + 1)):
                continue
            yield _feature(FeatureKind.CORNER, place, robust, robust)


def _minus(a: Sequence[arb], b: Sequence[arb]) -> list[arb]:
    return [x - y for x, y in zip(a, b, strict=True)]


def _meets_one(place: Interval, sorted_places: Sequence[Interval]) -> bool:
    """Whether an interval meets one of others that have at most end points in common."""
    first = bisect_left(sorted_places, place.low, key=lambda other: other.high)
    return first < len(sorted_places) and sorted_places[first].low <= place.high


def _feature(kind: FeatureKind, place: Interval, robust: bool, single: bool = False) -> NearbyFeature:
    return NearbyFeature(kind, CurvePiece((place,)), robust, single)


def _signs(form: Family, ends: Interval, depth: int = 0) -> Iterator[_Part]:
    """The signs of a form on a segment, from left to right."""
    if form.sign:
        yield _Part(ends.low, ends.high, form.sign)
    elif form.crossing:
        yield from _narrowed(form, ends)
    elif depth == NARROWEST or (depth >= SHALLOW and form.uncertain):
        yield _Part(ends.low, ends.high, 0)
    else:
        for half, part in zip(form.halves(), ends.halves, strict=True):
            yield from _signs(half, part, depth + 1)


def _narrowed(form: Family, ends: Interval) -> Iterator[_Part]:
    """The signs of a form with at most one zero, with an interval that contains the zero of every curve that has a
    zero.
    """
    slope, zero = form.crossing, form.zero_of_curve()
    low = _certain(form, zero, mpq(0), -slope) if form.ordinates[0] * slope < 0 else mpq(0)
    high = _certain(form, zero, mpq(1), slope) if form.ordinates[-1] * slope > 0 else mpq(1)
    inside, signs = ends.part(Interval(low, high)), (sign_of(form.of_curve[0]), sign_of(form.of_curve[-1]))
    if ends.low < inside.low:
        yield _Part(ends.low, inside.low, -slope)
    yield _Part(inside.low, inside.high, 0, slope, signs)
    if inside.high < ends.high:
        yield _Part(inside.high, ends.high, slope)


def _apart(parts: Iterable[_Part]) -> Iterator[_Part]:
    """The parts of one segment. Where all zeros on the left of a place increase and all on the right decrease, or the
    other way around, no curve has a zero at this place: f′ + λ f and f′ + μ f have different signs there. The sign
    there is certain: it is that of the curve itself.
    """
    last: _Part | None = None
    for part in parts:
        if last is not None and last.slope * part.slope < 0 and last.ends[1]:
            yield _Part(part.low, part.low, last.ends[1])
        yield part
        last = part


def _certain(form: Family, zero: mpq, end: mpq, sign: int) -> mpq:
    """A place between a zero of the form of the curve and an end, close to the zero, where the forms of all curves have
    the same sign.
    """
    k = min(int(zero * form.degree), form.degree - 1)
    error, slope = form.at(zero).abs_upper(), form.degree * abs(form.of_curve[k + 1] - form.of_curve[k])
    step = max(ball_ends(error / slope).high, mpq(1, 2**NARROWEST)) if slope > 0 else mpq(1, 2**SHALLOW)
    while step < abs(end - zero):
        place = zero + step if end > zero else zero - step
        if form.at(place) * sign > 0:
            return place
        step *= mpq(5, 4)
    return end


def _joined(group: Iterable[_Part]) -> _Part:
    """One part made of neighbouring parts with the same sign."""
    parts = list(group)
    slopes = {part.slope for part in parts}
    return _Part(parts[0].low, parts[-1].high, parts[0].sign, slopes.pop() if len(slopes) == 1 else 0)
