"""What all curves have in common whose control points and weights differ from those of a curve by at most epsilon: the
forms of κ and κ′ with balls as coefficients, and where their signs are certain.

A Bézier point of a segment is a mean of control points with weights that are not negative, so that it moves by no more
than they do. The forms are computed by the programs of the certified filter, over balls instead of doubles; a sign that
the coefficients of a form in the Bernstein basis have in common is that of all values, for all these curves. Between
two certain signs that differ every one of the curves has a zero; between two that agree some may have zeros.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import reduce
from itertools import groupby, pairwise
from math import comb
from typing import Any

from flint import arb, arb_poly, ctx, fmpz

from exactspline.errors import ShapeError
from exactspline.geometry.kinds import FeatureKind
from exactspline.geometry.plane_programs import programs
from exactspline.numbers.exact import Number, mpq, rational, to_fmpq
from exactspline.numbers.intervals import Interval, ball_ends
from exactspline.programs.program import Program
from exactspline.questions.answers import CurvePiece, Described
from exactspline.splines.expected import curve_of
from exactspline.splines.nurbs import Nurbs

#: Bits of the balls, and the narrowest part of a segment that is looked at, in bits.
PRECISION, NARROWEST = 192, 40
HALF = mpq(1, 2)


@dataclass(frozen=True)
class NearbyFeature(Described):
    """A feature of the curves near a curve, in an interval of the parameter.

    ``certain``: every one of these curves has it there, and an odd number of such points in all; ``single``: exactly
    one. Otherwise some of them may have it, any number of times, and others may not.
    """

    kind: FeatureKind
    piece: CurvePiece
    certain: bool
    single: bool = False

    @property
    def place(self) -> Interval:
        """The interval."""
        return self.piece.parts[0]

    @property
    def facts(self) -> dict[str, bool]:
        """Whether it is certain, and single."""
        return {"certain": self.certain, "single": self.single}


@dataclass(frozen=True)
class _Part:
    """A part of the domain, and the sign that a form has there, for all curves: 0 where it is not certain; `single`:
    where every curve has exactly one zero.
    """

    low: mpq
    high: mpq
    sign: int
    single: bool = False


def features_nearby(curve: Nurbs, epsilon: Number) -> tuple[NearbyFeature, ...]:
    """Inflections, extrema of the curvature, corners and singular points that all curves near a plane curve have, and
    those that some of them may have: all whose coordinates and, for a rational curve, weights differ by at most
    epsilon.

    Corners stand at knots; an end of the domain is not looked at beyond. In the order of the parameter.

    >>> from exactspline import example
    >>> for found in features_nearby(example("cubic_s"), "1/1000"):
    ...     print(found.kind, found.certain, found.single, *(round(float(t), 2) for t in found.place))
    minimum True False 0.18 0.2
    inflection True True 0.5 0.5
    maximum True False 0.64 0.88

    Raises `ShapeError` for a curve that is not in the plane, for an epsilon that is not positive, and where it lets a
    weight function vanish.
    """
    given, within = curve_of(curve), rational(epsilon)
    if given.dimension != 2:
        raise ShapeError(f"curves near a curve in R{given.dimension}", remedy="this needs a plane curve")
    if within <= 0:
        raise ShapeError(f"the distance {epsilon}", remedy="give a number above 0")
    with ctx.workprec(PRECISION):
        found = list(CurvesNear(given, within).features())
    return tuple(sorted(found, key=lambda feature: (feature.place, feature.kind)))


class CurvesNear:
    """The forms of the curves near a curve, segment by segment; for the distance 0 those of the curve itself."""

    def __init__(self, curve: Nurbs, within: mpq) -> None:
        self.curve, self.rational = curve, not curve.polynomial
        self.mesh = list(pairwise(curve.breakpoints))
        radii = self._radii(within)
        splines = (*curve.p, curve.w) if self.rational else tuple(curve.p)
        #: The Bézier ordinates of the homogeneous coordinates, segment by segment, as balls.
        self.segments = [
            [[_ball(x, radius) for x in row] for row, radius in zip(rows, radii, strict=True)]
            for rows in zip(*[f.segments for f in splines], strict=True)
        ]
        if self.rational and not all(x > 0 for _, _, w in self.segments for x in w):
            raise ShapeError(f"curves within {within}", remedy="weights that stay positive: a smaller epsilon")

    def _radii(self, within: mpq) -> list[mpq]:
        """By how much the homogeneous coordinates of control points differ at most."""
        if not self.rational:
            return [within, within]
        # a weight w and a coordinate x that differ by at most E change w x by at most (|w| + |x|) E + E²
        weight = max(abs(w) for w in self.curve.weights)
        largest = [max(abs(x) for x in column) for column in zip(*self.curve.control_points, strict=True)]
        return [(weight + x) * within + within * within for x in largest] + [within]

    def ordinates(self, program: Program, i: int) -> list[arb]:
        """A form on a segment in the Bernstein basis."""
        scaled = [arb_poly([x * comb(len(row) - 1, k) for k, x in enumerate(row)]) for row in self.segments[i]]
        below = [[fmpz(1)]] * len(program.groups)
        run: Any = program.run  # it computes with whatever polynomials it is given
        form = run([[x] for x in scaled], below, [(fmpz(1), fmpz(1))])[0][0]
        n = program.terms[0].degrees[0]
        return [form[k] / comb(n, k) for k in range(n + 1)]

    def features(self) -> Iterator[NearbyFeature]:
        """Of each kind."""
        curvature, critical, speed = programs(self.curve.degree, self.rational)
        slow = [Interval(part.low, part.high) for part in self._parts(speed) if part.sign <= 0]
        yield from (_feature(FeatureKind.STOP, place, certain=False) for place in slow)
        n = self.curve.degree
        inflections = dict.fromkeys((1, -1), FeatureKind.INFLECTION)
        extrema = {1: FeatureKind.MAXIMUM, -1: FeatureKind.MINIMUM}
        for program, kinds, least in ((curvature, inflections, n), (critical, extrema, n - 1)):
            # at a knot of this multiplicity the tangent (the curvature) may jump, so that a sign may change without one
            open_places = sorted([*slow, *(Interval.point(t) for _, t in self._knots(least))])
            for feature in self._zeros(program, kinds):
                doubtful = _meets_one(feature.place, open_places)
                yield replace(feature, certain=False, single=False) if doubtful else feature
        yield from self._corners()

    def _knots(self, least: int) -> list[tuple[int, mpq]]:
        """The inner knots of at least this multiplicity, with the segments that end there."""
        knots = self.curve.knots
        times = dict(zip(knots.breakpoints, knots.multiplicities, strict=True))
        return [(i, t) for i, t in enumerate(self.curve.breakpoints[1:-1]) if times[t] >= least]

    def _parts(self, program: Program) -> list[_Part]:
        """The parts of the domain with one sign each, neighbours with the same sign joined."""
        found = [
            part for i, ends in enumerate(self.mesh) for part in _signs(self.ordinates(program, i), Interval(*ends))
        ]
        return [_joined(group) for _, group in groupby(found, key=lambda part: part.sign)]

    def _zeros(self, program: Program, kinds: dict[int, FeatureKind]) -> Iterator[NearbyFeature]:
        """The kinds by the sign before the zero."""
        parts = self._parts(program)
        for before, part, behind in zip([None, *parts], parts, [*parts[1:], None], strict=False):
            if part.sign == 0:
                place = Interval(part.low, part.high)
                signs = {x.sign for x in (before, behind) if x is not None}
                certain = signs == {1, -1}
                possible = {before.sign} if certain and before is not None else {1, -1}
                for kind in dict.fromkeys(kinds[x] for x in sorted(possible)):
                    yield _feature(kind, place, certain, certain and part.single)
            elif before is not None and before.sign == -part.sign:
                yield _feature(kinds[before.sign], Interval(part.low, part.low), certain=True, single=True)

    def _corners(self) -> Iterator[NearbyFeature]:
        """Knots at which the tangents of both sides are independent control points."""
        for i, t in self._knots(self.curve.degree):
            left, right = self._direction(i, -1), self._direction(i + 1, 0)
            turn, ahead = left[0] * right[1] - left[1] * right[0], left[0] * right[0] + left[1] * right[1]
            certain = turn > 0 or turn < 0 or ahead < 0
            yield _feature(FeatureKind.CORNER, Interval(t, t), bool(certain), bool(certain))

    def _direction(self, i: int, end: int) -> tuple[arb, arb]:
        """The direction of the curve at an end of a segment."""
        n = self.curve.degree
        a, b = (n - 1, n) if end else (0, 1)
        x, y, *rest = self.segments[i]
        w = rest[0] if rest else [arb(1)] * (n + 1)
        return x[b] * w[a] - x[a] * w[b], y[b] * w[a] - y[a] * w[b]


def _meets_one(place: Interval, sorted_places: Sequence[Interval]) -> bool:
    """Whether an interval meets one of others that have at most end points in common."""
    first = bisect_left(sorted_places, place.low, key=lambda other: other.high)
    return first < len(sorted_places) and sorted_places[first].low <= place.high


def _feature(kind: FeatureKind, place: Interval, certain: bool, single: bool = False) -> NearbyFeature:
    return NearbyFeature(kind, CurvePiece((place,)), certain, single)


def _ball(x: mpq, radius: mpq) -> arb:
    """A ball that contains all numbers this near to a number."""
    return arb(to_fmpq(x)) + arb(0, arb(to_fmpq(radius)).upper())


def _signs(ordinates: Sequence[arb], ends: Interval, depth: int = 0) -> Iterator[_Part]:
    """The signs of a form on a segment, from left to right."""
    if all(x > 0 for x in ordinates) or all(x < 0 for x in ordinates):
        yield _Part(ends.low, ends.high, 1 if ordinates[0] > 0 else -1)
    elif depth == NARROWEST or all(x.contains(0) for x in ordinates):
        yield _Part(ends.low, ends.high, 0)
    elif _rises_through_zero(ordinates) or _rises_through_zero([-x for x in ordinates]):
        yield from _narrowed(ordinates, ends)
    else:
        for half, part in zip(_split(ordinates, HALF), ends.halves, strict=True):
            yield from _signs(half, part, depth + 1)


def _rises_through_zero(ordinates: Sequence[arb]) -> bool:
    """Whether it is negative at the start, positive at the end, and increasing."""
    return bool(ordinates[0] < 0 < ordinates[-1]) and all(b - a > 0 for a, b in pairwise(ordinates))


def _narrowed(ordinates: Sequence[arb], ends: Interval) -> Iterator[_Part]:
    """The single zero of a monotonic form, enclosed by Newton's method on intervals."""
    sign, place = (-1 if ordinates[0] < 0 else 1), Interval(mpq(0), mpq(1))
    while True:
        slopes = [b - a for a, b in pairwise(_restricted(ordinates, place))]
        slope = reduce(arb.union, slopes) * len(slopes) / arb(to_fmpq(place.width))
        if slope.contains(0):
            break
        step = ball_ends(value_at(ordinates, place.middle) / slope)
        low, high = max(place.low, place.middle - step.high), min(place.high, place.middle - step.low)
        if (high - low) * 2 > place.width:
            break
        place = Interval(low, high)
    inside = ends.part(place)
    if ends.low < inside.low:
        yield _Part(ends.low, inside.low, sign)
    yield _Part(inside.low, inside.high, 0, single=True)
    if inside.high < ends.high:
        yield _Part(inside.high, ends.high, -sign)


def value_at(ordinates: Sequence[arb], t: mpq) -> arb:
    """The value of a form at a local parameter."""
    return _split(ordinates, t)[1][0]


def _restricted(ordinates: Sequence[arb], place: Interval) -> list[arb]:
    """The ordinates on a part of [0, 1]."""
    left, _ = _split(ordinates, place.high)
    return _split(left, place.low / place.high)[1] if place.low else left


def _split(ordinates: Sequence[arb], t: mpq) -> tuple[list[arb], list[arb]]:
    """The ordinates before and behind a place, by de Casteljau's algorithm."""
    # a ball times 1 − t and a ball times t: a + (b − a) t would count the radius of a twice
    share, rest = arb(to_fmpq(t)), arb(to_fmpq(1 - t))
    row, left, right = list(ordinates), [ordinates[0]], [ordinates[-1]]
    while len(row) > 1:
        row = [a * rest + b * share for a, b in pairwise(row)]
        left.append(row[0])
        right.append(row[-1])
    return left, right[::-1]


def _joined(group: Iterable[_Part]) -> _Part:
    """Neighbours with one sign as one part."""
    parts = list(group)
    return _Part(parts[0].low, parts[-1].high, parts[0].sign, len(parts) == 1 and parts[0].single)
