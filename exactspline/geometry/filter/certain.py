"""Inflections and curvature extrema of one plane curve, decided in doubles with proved bounds by the optional
extension. The number of these features is known at once; the objects that describe the features are created on demand
and contain exact numbers.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, field
from functools import partial
from math import comb
from typing import Any, NamedTuple

from flint import fmpz, fmpz_poly

from exactspline.geometry.curves.facts import Facts
from exactspline.geometry.curves.features import critical_points, flat_points
from exactspline.geometry.curves.joints import end_direction
from exactspline.geometry.curves.kinds import Feature, FeatureKind
from exactspline.geometry.curves.plane_programs import CRITICAL, CURVATURE, SPEED, plane_program
from exactspline.geometry.derived.constructions import Variant
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval, Side
from exactspline.numbers.once import cached_property
from exactspline.polynomials.bernstein import ONE, raiser
from exactspline.polynomials.isolation import LocalPolynomial, LocalZero, isolate
from exactspline.programs import accelerator
from exactspline.programs.accelerator import SegmentZero, signs
from exactspline.programs.program import Program
from exactspline.roots.answers import CurvePiece, Places
from exactspline.roots.root import LazyRoot, Root
from exactspline.splines.blossom import CommonRows
from exactspline.splines.knots import mesh_of
from exactspline.splines.nurbs import Nurbs
from exactspline.system import collector_quiet

#: Forms and weights below this are not used: products of their powers could underflow.
SMALL = 2**-60
#: The relative error of a product of a dozen factors, the weight functions among them, is below this.
CLOSE = 2**-44


class Jump(NamedTuple):
    """A change of sign at a knot without a zero: the output, the index of the breakpoint (0: the start of the domain or
    the seam), and the sign before it.
    """

    output: int
    knot: int
    before: int


def _is_straight(operands: Sequence[fmpz_poly], degree: int) -> bool:
    """Whether a segment lies on a line, exactly: its two coordinates and its weight function are linearly dependent.

    >>> _is_straight([fmpz_poly([0, 3, 6, 3]), fmpz_poly([1, 3, 3, 1])], 3)
    True
    >>> _is_straight([fmpz_poly([0, 2, 2]), fmpz_poly([0, 2, 1])], 2)
    False
    """
    x, y = operands[:2]
    w = operands[2] if len(operands) > 2 else raiser(degree)
    first, second = x * w[0] - w * x[0], y * w[0] - w * y[0]
    k = next((k for k in range(degree + 1) if first[k] or second[k]), None)
    return k is None or first * second[k] == second * first[k]


def _jumps(facts: Facts, ends: Sequence[Sequence[float]], others: Set[int]) -> Iterator[Jump]:
    """The changes of sign of κ and κ′ by a jump at the knots of a plane curve, except at the ends of `others`: straight
    segments (a zero at an end of a straight piece belongs to the piece), and the segments decided exactly.

    `ends`: for every segment the numbers of `Signs.ends`; the signs of the ordinates are certain, and γ′ ≠ 0.
    """
    continuity = mesh_of(facts.curve.knots, facts.curve.degree)[1]
    for i in range(0 if facts.closed else 1, len(ends)):
        if others and (i in others or (i - 1) % len(ends) in others):
            continue
        left, right = ends[i - 1], ends[i]
        bends, turns = ((left[4 * k + 3] > 0) != (right[4 * k + 1] > 0) for k in (CURVATURE, CRITICAL))
        if not bends and not turns:
            continue
        smooth = continuity[i - 1] if i else 0
        if smooth < 1 and not facts.tangent_continuous(i):
            continue
        if bends:
            # κ jumps from one sign to the other, so that it has no extremum there
            yield Jump(CURVATURE, i, 1 if left[4 * CURVATURE + 3] > 0 else -1)
        elif smooth >= 2 or (not _differ(left, right) and facts.same_curvature(i)):
            yield Jump(CRITICAL, i, 1 if left[4 * CRITICAL + 3] > 0 else -1)


def _on_runs(curve: Nurbs, left: Set[int]) -> tuple[list[Feature], list[Feature]] | None:
    """The zeros of κ and of κ′ on some segments of a curve and at their ends, by exact arithmetic on these segments
    and one more on both sides. None where the whole curve must be decided: at a seam, where γ′ or a form vanishes on a
    whole segment, and where there are many such segments.
    """
    count = curve.segments
    if 2 * len(left) > count or (curve.closed and not left.isdisjoint((0, count - 1))):
        return None
    found: tuple[list[Feature], list[Feature]] = ([], [])
    starts = [i for i in sorted(left) if i - 1 not in left]
    for start, end in zip(starts, [i for i in sorted(left) if i + 1 not in left], strict=True):
        first, last = max(start - 1, 0), min(end + 2, count)
        facts = Facts(curve.restrict(curve.breakpoints[first], curve.breakpoints[last]))
        own = slice(start - first, end + 1 - first)
        forms = facts.zero_form("zero_curvature"), facts.zero_form("critical_curvature")
        if facts.closed or any(facts.standing[own]) or any(None in form.zeros.isolations[own] for form in forms):
            return None
        low, high = curve.breakpoints[start], curve.breakpoints[end + 1]
        for features, exact in zip(found, (flat_points(facts), critical_points(facts)), strict=True):
            features += [feature for feature in exact if low <= feature.root <= high]
    return found


def _differ(left: Sequence[float], right: Sequence[float]) -> bool:
    """Whether the curvatures of two sides, which have the same sign, certainly differ: κ² is ``K² w⁶ / S³`` for the
    forms K of κ and S of the speed, whatever the parameter, up to a factor that both sides share.
    """
    first, second = _squared(left, Side.LEFT), _squared(right, Side.RIGHT)
    return bool(first and second and (first[1] < second[0] or second[1] < first[0]))


def _squared(end: Sequence[float], side: Side) -> tuple[float, float] | None:
    """Bounds of the squared curvature at an end of a segment."""
    at, w = (3, end[-1]) if side is Side.LEFT else (1, end[-2])
    k, error = abs(end[4 * CURVATURE + at]), end[4 * CURVATURE + at + 1]
    s, off = end[4 * SPEED + at], end[4 * SPEED + at + 1]
    if min(k - error, s - off, w) < SMALL:
        return None
    w3 = w * w * w
    low, high = (k - error) * w3, (k + error) * w3
    slow, fast = s - off, s + off
    return low * low / (fast * fast * fast) * (1 - CLOSE), high * high / (slow * slow * slow) * (1 + CLOSE)


#: The kinds of an extremum.
KINDS = FeatureKind.MAXIMUM, FeatureKind.MINIMUM
#: A zero of κ or κ′.
Found = SegmentZero | Jump | Feature


@dataclass
class _Segment:
    """One segment of a curve: the integers of its operands, and its interval."""

    program: Program
    rows: CommonRows
    ends: Interval

    @cached_property
    def outputs(self) -> Sequence[Any]:
        """The integers of the outputs of the program."""
        operands, below = self.rows
        return self.program.run([[fmpz_poly(list(c))] for c in operands], [[fmpz(below)]], [(ONE, ONE)])[0]

    @cached_property
    def forms(self) -> tuple[_SegmentForm, _SegmentForm]:
        """κ and κ′ up to positive factors."""
        return _SegmentForm(self, CURVATURE), _SegmentForm(self, CRITICAL)


@dataclass
class _SegmentForm:
    """An output of a program on one segment."""

    segment: _Segment
    output: int

    @cached_property
    def form(self) -> LocalPolynomial:
        """The form as an integer polynomial."""
        return LocalPolynomial(self.segment.outputs[self.output])

    @cached_property
    def inner(self) -> list[LocalZero]:
        """The zeros of the form inside the segment, by exact arithmetic."""
        return isolate(self.form.polynomial, self.segment.program.terms[self.output].degrees[0]).inner


@dataclass
class Certain:
    """All zeros of κ and κ′ of a plane curve without circular arcs at its regular points, in the order of the
    parameter. Zeros on segments that are not decided in doubles are exact features.
    """

    degree: int
    rational: bool
    breaks: tuple[mpq, ...]
    rows: Sequence[CommonRows]
    zeros: tuple[list[Found], list[Found]]
    #: Whether κ is positive at the start of each segment.
    positive: Sequence[bool]
    #: The straight pieces: all pieces of constant curvature.
    straight: tuple[CurvePiece, ...]
    _segments: dict[int, _Segment] = field(default_factory=dict)

    @property
    def inflections(self) -> Places[Feature]:
        """The zeros of the curvature."""
        return self._places(CURVATURE)

    @property
    def critical_points(self) -> Places[Feature]:
        """The extrema of the curvature, and the points where κ′ = 0 without an extremum."""
        return self._places(CRITICAL)

    @property
    def only_extrema(self) -> bool:
        """Whether all critical points are extrema; those that are decided in doubles are."""
        return not any(isinstance(zero, Feature) and zero.kind not in KINDS for zero in self.zeros[CRITICAL])

    def _places(self, output: int) -> Places[Feature]:
        return Places.late(len(self.zeros[output]), partial(self._features, output), self.straight)

    def _segment(self, i: int) -> _Segment:
        """A segment, whose forms are computed once."""
        if i not in self._segments:
            program, ends = plane_program(self.degree, self.rational), Interval(*self.breaks[i : i + 2])
            self._segments[i] = _Segment(program, self.rows[i], ends)
        return self._segments[i]

    @collector_quiet()
    def _features(self, output: int) -> tuple[Feature, ...]:
        """The objects that describe the zeros."""
        bends = _bends(zero for zero in self.zeros[CURVATURE] if isinstance(zero, SegmentZero))
        breaks, found, number, last = self.breaks, [], 0, -1
        for zero in self.zeros[output]:
            if isinstance(zero, Feature):
                found.append(zero)
                continue
            if isinstance(zero, Jump):
                root = Root(breaks[zero.knot], breaks[zero.knot], (0, 0), (zero.before, -zero.before))
            else:
                number, last = number + 1 if zero.segment == last else 0, zero.segment
                segment = self._segment(last)
                late = LazyRoot(segment.forms[output], number, zero.before, zero[2:4])
                root = Root(None, None, (1, 1), late.signs, late, segment.ends)
            by_jump = isinstance(zero, Jump)
            if output == CURVATURE:
                found.append(Feature(FeatureKind.INFLECTION, root, Variant.MINIMAL, by_jump))
                continue
            kind, other = KINDS if zero.before > 0 else KINDS[::-1]
            of_absolute = kind if self._positive_at(zero, bends) else other
            found.append(Feature(kind, root, Variant.MINIMAL, by_jump, of_absolute))
        return tuple(found)

    def _positive_at(self, zero: SegmentZero | Jump, bends: Mapping[int, Sequence[SegmentZero]]) -> bool:
        """Whether κ is positive at a zero of κ′; `bends` are the zeros of κ by segment."""
        if isinstance(zero, Jump):
            return self.positive[zero.knot]
        before = sum(bend.high <= zero.low for bend in bends.get(zero.segment, ()))
        return self.positive[zero.segment] == (before % 2 == 0)


@collector_quiet()
def certain(facts: Facts) -> Certain | None:
    """The zeros of κ and κ′ decided in doubles; None where exact arithmetic must decide: without the extension for all
    curves except polygons.

    >>> from exactspline import analyse, example
    >>> known = certain(analyse(example("six_segment_cubic")))
    >>> known is None or [len(zeros) for zeros in known.zeros] == [2, 8]
    True
    """
    curve, rational = facts.curve, not facts.curve.polynomial
    if curve.degree == 1 and curve.dimension == 2:
        return _polygon(facts)
    if curve.dimension != 2 or accelerator.filter_curve is None:
        return None
    rows: Sequence[CommonRows] = curve.rows
    if rational and rows[0][0][-1][0] < 0:
        rows = [([[-x for x in c] for c in operands], below) for operands, below in rows]
    program = plane_program(curve.degree, rational)
    found = signs(program, rows, rational=rational)
    if found is None:
        return None
    again = {i for i, uncertain in enumerate(found.open) if any(uncertain)} | _entangled(found.zeros)
    if again:
        # all segments once more: results for different segments are compared, so that they must have the same unit
        nearer = [_moved(*row, rational=rational) if i in again else row for i, row in enumerate(rows)]
        del found
        found = signs(program, nearer, rational=rational)
        if found is None:
            return None
    uncertain = {i: slow for i, (open_, slow) in enumerate(found.open) if open_ or slow}
    straight = {
        i
        for i, slow in uncertain.items()
        if not slow and _is_straight([fmpz_poly(list(c)) for c in rows[i][0]], curve.degree)
    }
    left = (uncertain.keys() | _entangled(found.zeros)) - straight
    zeros: tuple[list[Found], list[Found]] = ([], [])
    if left:
        exactly = _on_runs(curve, left)
        if exactly is None:
            return None
        zeros[CURVATURE].extend(exactly[CURVATURE])
        zeros[CRITICAL].extend(exactly[CRITICAL])
    others = straight | left
    for zero in found.zeros:
        if zero.segment not in others:
            zeros[zero.output].append(zero)
    at_knots = list(_jumps(facts, found.ends, others))
    if at_knots or left:
        for jump in at_knots:
            zeros[jump.output].append(jump)
        for own in zeros:
            own.sort(key=partial(_place, facts.breaks))
    positive = [end[1 + 4 * CURVATURE] > 0 for end in found.ends]
    pieces = facts.straight_runs(straight) if straight else ()
    return Certain(curve.degree, rational, facts.breaks, rows, zeros, positive, pieces)


def _moved(operands: Sequence[Sequence[int]], below: int, *, rational: bool) -> CommonRows:
    """A segment of a plane curve moved so that it begins at the origin: this changes no sign of a form, but doubles
    lose less where a segment is short compared with its coordinates.

    >>> _moved([[3, 5], [2, 4]], 1, rational=False), _moved([[3, 5], [2, 4], [2, 3]], 1, rational=True)
    (([[0, 2], [0, 2]], 1), ([[0, 1], [0, 2], [4, 6]], 2))
    """
    degree = len(operands[0]) - 1
    w = operands[-1] if rational else [comb(degree, k) for k in range(degree + 1)]
    coordinates = operands[:-1] if rational else operands
    parts = [[x * w[0] - y * c[0] for x, y in zip(c, w, strict=True)] for c in coordinates]
    return ([*parts, [y * w[0] for y in w]] if rational else parts), below * w[0]


def _polygon(facts: Facts) -> Certain | None:
    """The zeros of κ and κ′ of a curve of degree 1 that is constant on no segment."""
    segments = range(facts.curve.segments)
    if not all(any(end_direction(facts.operands, i, Side.LEFT)) for i in segments):
        return None
    return Certain(1, False, facts.breaks, [], ([], []), [], facts.straight_runs(set(segments)))


def _place(breaks: Sequence[mpq], zero: Found) -> tuple[int, float]:
    """The sorting key by parameter: a knot comes before the zeros on the segment that it begins. Features are alone on
    their segments, in order.
    """
    if isinstance(zero, Feature):
        return bisect_right(breaks, zero.root.low) - 1, 0 if zero.at_knot else 1
    return (zero.knot, 0) if isinstance(zero, Jump) else (zero.segment, 1 + zero.low)


def _bends(zeros: Iterable[SegmentZero]) -> dict[int, list[SegmentZero]]:
    """The zeros of κ by segment."""
    bends: dict[int, list[SegmentZero]] = {}
    for zero in zeros:
        if zero.output == CURVATURE:
            bends.setdefault(zero.segment, []).append(zero)
    return bends


def _entangled(zeros: Sequence[SegmentZero]) -> set[int]:
    """The segments on which a zero of κ and one of κ′ are too close to tell which is first."""
    bends = _bends(zeros)
    return {
        zero.segment
        for zero in zeros
        if zero.output == CRITICAL
        and zero.segment in bends
        and any(bend.low < zero.high and zero.low < bend.high for bend in bends[zero.segment])
    }
