"""Inflections and curvature extrema of one plane curve where all of them are certain in doubles, by the optional
extension: how many there are is known at once; the objects that describe them are made when they are asked for, and
the numbers in them are exact.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from math import comb

from flint import fmpz, fmpz_poly

from exactspline.geometry.curves.facts import Facts
from exactspline.geometry.curves.joints import end_direction
from exactspline.geometry.curves.kinds import Feature, FeatureKind
from exactspline.geometry.derived.constructions import Variant
from exactspline.geometry.filter.jumps_at_knots import Jump, is_straight, jumps, on_runs
from exactspline.geometry.filter.plane_programs import CRITICAL, CURVATURE, plane_program
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval
from exactspline.numbers.once import cached_property
from exactspline.numbers.sides import Side
from exactspline.polynomials.bernstein import ONE
from exactspline.polynomials.isolation import LocalPolynomial, LocalZero, isolate
from exactspline.programs import accelerator
from exactspline.programs.accelerator import SegmentZero, signs
from exactspline.roots.answers import CurvePiece, Places
from exactspline.roots.lazy_root import LazyRoot
from exactspline.roots.root import Root
from exactspline.splines.blossom import CommonRows

#: A zero of κ or κ′.
Found = SegmentZero | Jump | Feature


@dataclass
class _SegmentForm:
    """An output of a program on one segment, from the integers of its operands."""

    degree: int
    rational: bool
    output: int
    rows: CommonRows

    @cached_property
    def form(self) -> LocalPolynomial:
        """Its integers."""
        program, (operands, below) = plane_program(self.degree, self.rational), self.rows
        forms = program.run([[fmpz_poly(list(c))] for c in operands], [[fmpz(below)]], [(ONE, ONE)])[0]
        return LocalPolynomial(fmpz_poly(forms[self.output]))

    @cached_property
    def inner(self) -> list[LocalZero]:
        """Its zeros inside the segment, by exact arithmetic."""
        return isolate(
            self.form.polynomial, plane_program(self.degree, self.rational).terms[self.output].degrees[0]
        ).inner


@dataclass
class Certain:
    """What is certain of a plane curve: its zeros of κ and κ′ at regular points, in the order of the parameter; it has
    no others, and no arc of a circle. Those on segments that are not certain in doubles are exact features.
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

    @property
    def inflections(self) -> Places[Feature]:
        """The zeros of the curvature."""
        return self._places(CURVATURE)

    @property
    def critical_points(self) -> Places[Feature]:
        """The extrema of the curvature, and the points where κ′ = 0 without one."""
        return self._places(CRITICAL)

    @property
    def only_extrema(self) -> bool:
        """Whether all critical points are known to be extrema."""
        return not any(isinstance(zero, Feature) for zero in self.zeros[CRITICAL])

    def _places(self, output: int) -> Places[Feature]:
        return Places.late(len(self.zeros[output]), partial(self._features, output), self.straight)

    def _features(self, output: int) -> tuple[Feature, ...]:
        """The objects that describe the zeros."""
        bends = _bends(zero for zero in self.zeros[CURVATURE] if isinstance(zero, SegmentZero))
        forms: dict[int, tuple[_SegmentForm, Interval]] = {}
        breaks, found, number = self.breaks, [], 0
        for zero in self.zeros[output]:
            if isinstance(zero, Feature):
                found.append(zero)
                continue
            if isinstance(zero, Jump):
                root = Root(breaks[zero.knot], breaks[zero.knot], (0, 0), (zero.before, -zero.before))
            else:
                i = zero.segment
                if i not in forms:
                    number = 0
                    form = _SegmentForm(self.degree, self.rational, output, self.rows[i])
                    forms[i] = form, Interval(breaks[i], breaks[i + 1])
                form, ends = forms[i]
                low, high = ends.at(mpq(zero.low)), ends.at(mpq(zero.high))
                late = LazyRoot(form, number, zero.before)
                root = Root(low, high, (1, 1), (zero.before, -zero.before), late, ends)
                number += 1
            by_jump = isinstance(zero, Jump)
            if output == CURVATURE:
                found.append(Feature(FeatureKind.INFLECTION, root, Variant.MINIMAL, by_jump))
                continue
            kind = FeatureKind.MAXIMUM if zero.before > 0 else FeatureKind.MINIMUM
            of_absolute = kind if self._positive_at(zero, bends) else kind.opposite
            found.append(Feature(kind, root, Variant.MINIMAL, by_jump, of_absolute))
        return tuple(found)

    def _positive_at(self, zero: SegmentZero | Jump, bends: Mapping[int, Sequence[SegmentZero]]) -> bool:
        """Whether κ is positive at a zero of κ′; `bends` are the zeros of κ by segment."""
        if isinstance(zero, Jump):
            return self.positive[zero.knot]
        before = [bend for bend in bends.get(zero.segment, ()) if bend.high <= zero.low]
        return self.positive[zero.segment] == (len(before) % 2 == 0)


def certain(facts: Facts) -> Certain | None:
    """What is certain of a curve; None where exact arithmetic must decide, as without the extension for all curves but
    polygons.

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
    straight, left = set[int](), set[int]()
    for i, (open_, slow) in enumerate(found.open):
        if slow:
            left.add(i)
        elif open_:
            (straight if is_straight([fmpz_poly(list(c)) for c in rows[i][0]], curve.degree) else left).add(i)
    left |= _entangled(found.zeros) - straight
    if left:
        # all once more: the results for different segments are compared, so that they must be in one unit
        nearer = [_moved(*row, rational=rational) if i in left else row for i, row in enumerate(rows)]
        found = signs(program, nearer, rational=rational)
        if found is None:
            return None
        left = {i for i, (open_, slow) in enumerate(found.open) if slow or (open_ and i not in straight)}
        straight -= left
        left |= _entangled(found.zeros) - straight
    zeros: tuple[list[Found], list[Found]] = ([], [])
    if left:
        exactly = on_runs(curve, left)
        if exactly is None:
            return None
        zeros[CURVATURE].extend(exactly[CURVATURE])
        zeros[CRITICAL].extend(exactly[CRITICAL])
    others = straight | left
    for zero in found.zeros:
        if zero.segment not in others:
            zeros[zero.output].append(zero)
    at_knots = list(jumps(facts, found.ends, found.weights, others))
    if at_knots or left:
        for jump in at_knots:
            zeros[jump.output].append(jump)
        for own in zeros:
            own.sort(key=partial(_place, facts.breaks))
    positive = [end[4 * CURVATURE] > 0 for end in found.ends]
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
    """What is certain of a curve of degree 1 that nowhere stands still."""
    segments = range(facts.curve.segments)
    if not all(any(end_direction(facts.operands, i, Side.LEFT)) for i in segments):
        return None
    return Certain(1, False, facts.breaks, [], ([], []), [], facts.straight_runs(set(segments)))


def _place(breaks: Sequence[mpq], zero: Found) -> tuple[int, float]:
    """In the order of the parameter: a knot before what is on the segment behind it. Features are alone on their
    segments, in order.
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
