"""Inflections and curvature extrema of one plane curve, decided in doubles with proved bounds by the optional
extension. The number of these features is known at once; the objects that describe the features are created on demand
and contain exact numbers.
"""

from __future__ import annotations

from array import array
from bisect import bisect_right
from collections.abc import Iterator, Sequence, Set
from dataclasses import dataclass, field
from functools import partial
from math import nan
from typing import Any, NamedTuple

from flint import fmpz, fmpz_poly

from exactspline.geometry.curves.facts import Facts
from exactspline.geometry.curves.features import critical_points, flat_points
from exactspline.geometry.curves.joints import end_direction
from exactspline.geometry.curves.kinds import Feature, FeatureKind
from exactspline.geometry.curves.plane_programs import CRITICAL, CURVATURE, plane_program
from exactspline.geometry.derived.constructions import Variant
from exactspline.numbers.exact import Rounding, mpq
from exactspline.numbers.intervals import Interval, Side
from exactspline.numbers.once import cached_property
from exactspline.polynomials.bernstein import ONE, raiser
from exactspline.polynomials.isolation import LocalPolynomial, LocalZero, isolate
from exactspline.programs import accelerator
from exactspline.programs.accelerator import (
    BENDS,
    DIFFERENT,
    ENTANGLED,
    OF_ZERO,
    SLOW,
    TURNS,
    UNCERTAIN,
    SegmentZero,
    Signs,
    nearest,
    signs,
)
from exactspline.programs.program import Program
from exactspline.roots.answers import CurvePiece, Places
from exactspline.roots.root import LazyRoot, Root, root_inside
from exactspline.splines.evaluation import Evaluation
from exactspline.splines.knots import mesh_of
from exactspline.splines.nurbs import Nurbs
from exactspline.system import collector_quiet

#: This many zeros are rounded to doubles at once.
BLOCK = 64


class Jump(NamedTuple):
    """A change of sign at a knot without a zero: the output, the index of the breakpoint (0: the start of the domain or
    the seam), and the sign before it.
    """

    output: int
    knot: int
    before: int


#: Zeros of κ and of κ′ that are not certain in doubles, but at knots or decided exactly.
Apart = tuple[list[Jump | Feature], list[Jump | Feature]]


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


def _jumps(facts: Facts, found: Signs, others: Set[int]) -> Iterator[Jump]:
    """The changes of sign of κ and κ′ by a jump at the knots of a plane curve, except at the ends of `others`: straight
    segments (a zero at an end of a straight piece belongs to the piece), and the segments decided exactly. γ′ ≠ 0.
    """
    continuity, count = mesh_of(facts.curve.knots, facts.curve.degree)[1], facts.curve.segments
    for i, flags in enumerate(found.of_segments):
        if not flags & (BENDS | TURNS) or not (i or facts.closed) or not others.isdisjoint((i, (i - 1) % count)):
            continue
        smooth = continuity[i - 1] if i else 0
        if smooth < 1 and not facts.tangent_continuous(i):
            continue
        # where κ jumps from one sign to the other it has no extremum
        output = CURVATURE if flags & BENDS else CRITICAL
        if output == CURVATURE or smooth >= 2 or (not flags & DIFFERENT and facts.same_curvature(i)):
            yield Jump(output, i, -1 if found.positive(output, i) else 1)


def _on_runs(curve: Nurbs, left: Set[int]) -> Apart | None:
    """The zeros of κ and of κ′ on some segments of a curve and at their ends, by exact arithmetic on these segments
    and one more on both sides. None where the whole curve must be decided: at a seam, where γ′ or a form vanishes on a
    whole segment, and where there are many such segments.
    """
    count = curve.segments
    if 2 * len(left) > count or (curve.closed and not left.isdisjoint((0, count - 1))):
        return None
    found: Apart = ([], [])
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


#: The signs on both sides of a zero, by the sign before it.
SIDES = {1: (1, -1), -1: (-1, 1)}
#: The kinds of an extremum.
KINDS = FeatureKind.MAXIMUM, FeatureKind.MINIMUM


@dataclass
class _SegmentForm:
    """An output of a program on one segment, as an integer polynomial."""

    form: LocalPolynomial
    degree: int

    @cached_property
    def inner(self) -> list[LocalZero]:
        """The zeros of the form inside the segment, by exact arithmetic."""
        return isolate(self.form.polynomial, self.degree).inner


class _CurveZero(LazyRoot):
    """A zero that is certain in doubles, on a segment over an interval; `number` is its number among the zeros of its
    output on the segment.
    """

    near, _found = (), None

    def __init__(self, curve: Certain, place: int, before: int, number: int, side: Interval) -> None:
        self.curve, self.place, self.number, self.side = curve, place, number, side
        self.before, self.signs = before, SIDES[before]

    @cached_property
    def interval(self) -> Sequence[float]:  # type: ignore[override]  # read when it is needed
        """The ends of its interval."""
        return self.curve.found.some(self.place, 1)[2:]

    @cached_property
    def form(self) -> _SegmentForm:  # type: ignore[override]  # computed when it is needed
        """The output on its segment."""
        code, segment, *_ = map(int, self.curve.found.some(self.place, 1))
        return self.curve.form(code // 4, segment)

    def nearest(self, side: Interval | None, rounding: str) -> float:
        """The double nearest to the parameter, from C, as for `InDoubles`."""
        return self.curve.nearest(self.place) if side is self.side and rounding == Rounding.NEAREST else nan


@dataclass
class Certain:
    """All zeros of κ and κ′ of a plane curve without circular arcs at its regular points, in the order of the
    parameter. Zeros on segments that are not decided in doubles are exact features.
    """

    program: Program
    breaks: tuple[mpq, ...]
    evaluation: Evaluation
    #: What is certain of its segments in doubles.
    found: Signs
    #: The zeros of κ and of κ′ at knots, and those on the segments that are not decided in doubles; these segments, and
    #: straight ones.
    others: Apart
    apart: Set[int]
    #: The straight pieces: all pieces of constant curvature.
    straight: tuple[CurvePiece, ...]
    #: By the number of a segment, and of a block of zeros, what was computed when it was first needed.
    _outputs: dict[int, Sequence[Any]] = field(default_factory=dict)
    _nearest: dict[int, Sequence[float]] = field(default_factory=dict)

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
        return not any(isinstance(zero, Feature) and zero.kind not in KINDS for zero in self.others[CRITICAL])

    def form(self, output: int, segment: int) -> _SegmentForm:
        """An output of the program on a segment."""
        if segment not in self._outputs:
            rows, rational = self.evaluation.rows, self.evaluation.weights is not None
            (operands, below), sign = rows[segment], -1 if rational and rows[0][0][-1][0] < 0 else 1  # as in C
            forms = [[sign * fmpz_poly(list(c))] for c in operands]
            self._outputs[segment] = self.program.run(forms, [[fmpz(below)]], [(ONE, ONE)])[0]
        degree, *_ = self.program.terms[output].degrees
        return _SegmentForm(LocalPolynomial(self._outputs[segment][output]), degree)

    def nearest(self, index: int) -> float:
        """The double nearest to the parameter of a zero, given by its number among all that are certain in doubles; not
        a number if C does not decide it.
        """
        block, k = divmod(index, BLOCK)
        if block not in self._nearest:
            zeros = self.found.some(block * BLOCK, BLOCK)
            first, stop = int(zeros[1]), int(zeros[1 - OF_ZERO]) + 1
            ends = self.breaks[first : stop + 1]
            self._nearest[block] = nearest(self.program, self.evaluation.forms(first, stop), zeros, ends)
        return self._nearest[block][k]

    def _places(self, output: int) -> Places[Feature]:
        count = len(self._zeros(output)) if self.apart else self.found.count(output) + len(self.others[output])
        return Places.late(count, partial(self._features, output), self.straight)

    def _zeros(self, output: int) -> list[SegmentZero]:
        """The zeros of an output, those that are not certain in doubles without the last numbers."""
        zeros = [zero for zero in self.found.zeros(output) if zero[0] not in self.apart]
        own = [(*_place(self.breaks, each), k, -1) for k, each in enumerate(self.others[output])]
        return sorted([*zeros, *own]) if own else zeros

    @collector_quiet()
    def _features(self, output: int) -> tuple[Feature, ...]:
        """The objects that describe the zeros."""
        breaks, found, number, last, side = self.breaks, list[Feature](), 0, -1, Interval(mpq(0), mpq(0))
        for segment, _, k, code in self._zeros(output):
            zero = self.others[output][k] if code < 0 else None
            if isinstance(zero, Feature):
                found.append(zero)
                continue
            before = zero.before if zero else 1 if code > 1 else -1
            if zero:
                root = Root(breaks[segment], breaks[segment], (0, 0), (before, -before))
            else:
                if segment != last:
                    number, last, side = 0, segment, Interval(*breaks[segment : segment + 2])
                root = root_inside(_CurveZero(self, k, before, number, side), side)
                number += 1
            if output == CURVATURE:
                found.append(Feature(FeatureKind.INFLECTION, root, Variant.MINIMAL, bool(zero)))
                continue
            kind, other = KINDS if before > 0 else KINDS[::-1]
            positive = self.found.positive(CURVATURE, segment) if zero else code % 2
            found.append(Feature(kind, root, Variant.MINIMAL, bool(zero), kind if positive else other))
        return tuple(found)


@collector_quiet()
def certain(facts: Facts) -> Certain | None:
    """The zeros of κ and κ′ decided in doubles; None where exact arithmetic must decide: without the extension for all
    curves except polygons.

    >>> from exactspline import analyse, example
    >>> known = certain(analyse(example("six_segment_cubic")))
    >>> known is None or [len(known.inflections), len(known.critical_points)] == [2, 8]
    True
    """
    curve, rational = facts.curve, not facts.curve.polynomial
    if curve.degree == 1 and curve.dimension == 2:
        return _polygon(facts)
    if curve.dimension != 2 or accelerator.filter_curve is None:
        return None
    program, count, unclear = plane_program(curve.degree, rational), curve.segments, UNCERTAIN | SLOW | ENTANGLED
    found = signs(program, curve.evaluation.forms(0, count), count)
    if found is None:
        return None
    apart = {i: flags for i, flags in enumerate(found.of_segments) if flags & unclear} if found.flags & unclear else {}
    straight = {
        i
        for i, flags in apart.items()
        if not flags & SLOW and _is_straight([fmpz_poly(list(c)) for c in curve.rows[i][0]], curve.degree)
    }
    others = _on_runs(curve, apart.keys() - straight)
    if others is None:
        return None
    if found.flags & (BENDS | TURNS) or facts.closed:
        for jump in _jumps(facts, found, apart.keys()):
            others[jump.output].append(jump)
    pieces = facts.straight_runs(straight) if straight else ()
    return Certain(program, facts.breaks, curve.evaluation, found, others, apart.keys(), pieces)


def _polygon(facts: Facts) -> Certain | None:
    """The zeros of κ and κ′ of a curve of degree 1 that is constant on no segment."""
    segments = range(facts.curve.segments)
    if not all(any(end_direction(facts.operands, i, Side.LEFT)) for i in segments):
        return None
    straight = facts.straight_runs(set(segments))
    nothing = Signs(array("d", bytes(24)), 3, 3)
    program = plane_program(1, rational=False)
    return Certain(program, facts.breaks, facts.curve.evaluation, nothing, ([], []), set(), straight)


def _place(breaks: Sequence[mpq], zero: Jump | Feature) -> tuple[int, float]:
    """The sorting key by parameter: a knot comes before the zeros on the segment that it begins. Features are alone on
    their segments, in order.
    """
    if isinstance(zero, Feature):
        return bisect_right(breaks, zero.root.low) - 1, 0 if zero.at_knot else 1
    return zero.knot, 0
