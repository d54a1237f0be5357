"""The distance of two curves: the certified pairs of nearest points, and the arcs along which the least distance is
attained.

A pair at the least distance is a common point, or contains an end or a knot of one of the curves, or is a common zero
of the two partial derivatives of the squared distance. Along the zeros of a common factor of these derivatives the
distance is constant; such zeros form arcs and single points (`exactspline.bivariate.quotients`). All other common zeros
at which the distance is at most that of a known pair are isolated by boxes (`exactspline.bivariate.common_zeros`).
Nearly equal distances are compared exactly.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import reduce
from operator import add, itemgetter
from typing import TypeVar

from flint import fmpz_mpoly

from exactspline.bivariate.common_zeros import CommonZero
from exactspline.bivariate.quotients import BOUND, TIED, MonotoneArc, Quotient, keep_least
from exactspline.errors import ReachError, counted
from exactspline.geometry.curves.planarity import check_in_one_space, in_one_plane
from exactspline.geometry.pairs.box_tree import IntegerBox, segments_of, shift_for
from exactspline.geometry.pairs.intersections import Intersections, Overlap, from_seam, intersections
from exactspline.geometry.pairs.nearest import nearest
from exactspline.hooks import Written
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import UNIT, Box, Interval, Side, joined
from exactspline.one_line import one_line
from exactspline.polynomials.bernstein import in_parameter, quotient_slope
from exactspline.polynomials.cost import bounded
from exactspline.polynomials.patch_forms import PatchForm
from exactspline.polynomials.two_parameters import S, T, as_form, lifted, over, rows_of
from exactspline.reals.real import Real, real, square_root
from exactspline.roots.answers import OneNumber
from exactspline.roots.segment_forms import SegmentForms
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of

V = TypeVar("V")
Point = tuple[mpq, ...]
#: A lower bound is raised to 1 − 2^−k times another bound, with k below this number.
NARROW = 40


@dataclass(frozen=True)
class ClosestPair:
    """A parameter of each curve; the distance of the two points is the least distance."""

    first: Real
    second: Real
    squared: Real = field(compare=False)

    @one_line
    def __repr__(self) -> str:
        return f"<closest at {self.first.shortly()} and {self.second.shortly()}>"


@dataclass(frozen=True, repr=False)
class Distance(OneNumber, Written):
    """The least distance of two curves, and all pairs of points at this distance, with exact parameters.

    `everywhere` are the arcs along which the least distance is attained, by their parameters on both curves: arcs in
    common, arcs at this constant distance (of parallel segments, of concentric circles), arcs of a circle about a point
    of the other curve, and pieces on which a curve is constant (with an arc of a circle, all pairs of both). The ends
    of these arcs are among the pairs; points between the ends are not listed. `undecided` lists the decisions that
    would take too long. If there are any, the square of the distance is at least `lower`, a rational number; otherwise
    `lower` is None.

    >>> from exactspline import distance, example
    >>> float(distance(example("circle"), example("ellipse")))
    0.0
    """

    _number = "value"
    pairs: tuple[ClosestPair, ...]
    lower: mpq | None = None
    undecided: tuple[str, ...] = ()
    everywhere: tuple[Overlap, ...] = ()

    @property
    def squared(self) -> Real:
        """The square of the distance of the pairs."""
        return self.pairs[0].squared

    @property
    def value(self) -> Real:
        """The distance of the pairs."""
        return square_root(self.squared)

    @one_line
    def __repr__(self) -> str:
        arcs = f", everywhere on {list(self.everywhere)}" if self.everywhere else ""
        doubt = f", undecided: {'; '.join(self.undecided)}" if self.undecided else ""
        return f"<Distance {self.value.shortly()} between {list(self.pairs)}{arcs}{doubt}>"


def distance(first: Nurbs, second: Nurbs) -> Distance:
    """Return the distance of two curves in the plane or in space, and the pairs of parameters of their nearest points.

    >>> from exactspline import Nurbs
    >>> parabola = Nurbs(2, [0, 0, 0, 1, 1, 1], [(-1, 1), (0, -1), (1, 1)])  # y = x²
    >>> line = Nurbs(1, [0, 0, 1, 1], [(-1, -2), (1, 0)])  # y = x − 1
    >>> found = distance(parabola, line)
    >>> found
    <Distance 3√2/8 between [<closest at 3/4 and 15/16>]>
    >>> distance(line, Nurbs(1, [0, 0, 1, 1], [(-1, -1), (0, 0)])).everywhere  # y = x
    (<overlap of [1/4, 3/4] and [0, 1]>,)

    Raises `ShapeError` for curves of different dimensions.
    """
    first, second = in_one_plane(curve_of(first), curve_of(second))
    check_in_one_space(first, second)
    return nearest_pairs(first, second, intersections(first, second))


def nearest_pairs(first: Nurbs, second: Nurbs, meeting: Intersections) -> Distance:
    """The distance of two curves whose common points are known, and the pairs of nearest points."""
    zero = Real(0)
    if meeting.points or meeting.everywhere:
        pairs = [ClosestPair(p.first, p.second, zero) for p in meeting]
        for arc in meeting.everywhere:
            pairs += _ends(arc, zero, (first, second))
        undecided = list(meeting.undecided)
        each = _each_once(pairs, undecided)
        return Distance(each, mpq(0) if undecided else None, tuple(undecided), meeting.everywhere)
    return _Search(first, second, meeting.undecided).answer()


def _ends(arc: Overlap, squared: Real, curves: tuple[Nurbs, Nurbs]) -> list[ClosestPair]:
    """The pairs at the ends of an arc."""
    pairs = zip(arc.first, arc.second, strict=True)
    return [ClosestPair(from_seam(curves[0], s), from_seam(curves[1], t), squared) for s, t in pairs]


def _within(arc: Overlap, other: Overlap) -> bool:
    """Whether an arc is a part of another one."""
    return all(c <= a and b <= d for (a, b), (c, d) in ((arc.first, other.first), (arc.second, other.second)))


def _largest(arcs: Iterable[tuple[Overlap, Real]]) -> list[tuple[Overlap, Real]]:
    """The arcs that are not parts of other arcs, each once."""
    kept: list[tuple[Overlap, Real]] = []
    for arc, squared in arcs:
        if not any(_within(arc, other) for other, _ in kept):
            kept = [*(one for one in kept if not _within(one[0], arc)), (arc, squared)]
    return kept


def _between(pair: ClosestPair, arc: Overlap) -> bool:
    """Whether a pair is on an arc, or on a piece all of whose pairs have the least distance, but not at an end."""
    sides = (pair.first, arc.first), (pair.second, arc.second)
    return all(low <= t <= high for t, (low, high) in sides) and any(t not in ends for t, ends in sides)


def _each_once(pairs: Sequence[ClosestPair], undecided: list[str]) -> tuple[ClosestPair, ...]:
    """The pairs without repetitions; comparisons that would take too long are reported as undecided."""
    each: list[ClosestPair] = []
    try:
        for pair in pairs:
            if not any(pair == other for other in each):
                each.append(pair)
    except ReachError as error:
        undecided.append(f"which of {counted(len(pairs), 'pair')} are the same: {error.problem}")
        return tuple(pairs)
    return tuple(each)


class _Search:
    """The pairs of nearest points of curves that do not meet."""

    def __init__(self, first: Nurbs, second: Nurbs, undecided: tuple[str, ...]) -> None:
        self.curves, self.undecided = (first, second), list(undecided)
        self.lower: mpq | None = mpq(0) if undecided else None
        self.prepared = [segments_of(curve) for curve in self.curves]
        self.segments = [own.forms for own in self.prepared]
        self.arcs: list[tuple[Overlap, Real]] = []
        self.found = [pair for k in (0, 1) for pair in self._at_knots(k)]
        self.digits, self.bound = _bound([pair.squared for pair in self.found])
        self.arcs = _largest(self.arcs)
        self.found = [pair for pair in self.found if not any(_between(pair, arc) for arc, _ in self.arcs)]
        for i, j in self._near_pairs():
            with bounded():
                self._inside(i, j)

    def _at_knots(self, k: int) -> Iterator[ClosestPair]:
        """The points of curve k nearest to the ends, the knots and the constant pieces of the other curve."""
        for place, centre in self._places(1 - k):
            around = nearest(self.curves[k], centre)
            arcs = [(part, point.squared) for point in around for part in [(point.parameter,) * 2]]
            for low, high in (part for piece in around.everywhere for part in piece.parts):
                squared = Real(_total([(x - y) ** 2 for x, y in zip(self.curves[k](low), centre, strict=True)]))
                arcs.append(((Real(low), Real(high)), squared))
            for part, squared in arcs:
                sides = ((Real(place.low), Real(place.high)), part)
                arc = Overlap(sides[1 - k], sides[k], None, None)
                if place.low < place.high or part[0] < part[1]:
                    self.arcs.append((arc, squared))
                yield from _ends(arc, squared, self.curves)

    def _places(self, k: int) -> Iterator[tuple[Interval, Point]]:
        """The constant pieces of a curve, and the ends and knots outside these pieces, with the points: two points
        where the curve jumps.
        """
        curve, still = self.curves[k], dict[Point, list[Interval]]()
        for i, (degree, _) in enumerate(self.segments[k]):
            if degree == 0:
                still.setdefault(curve(curve.breakpoints[i]), []).append(Interval(*curve.breakpoints[i : i + 2]))
        for t in curve.breakpoints:
            for point in dict.fromkeys(curve(t, side) for side in Side):
                if not any(low <= t <= high for low, high in still.get(point, ())):
                    yield Interval(t, t), point
        yield from ((piece, point) for point, pieces in still.items() for piece in joined(pieces))

    def _near_pairs(self) -> Iterator[tuple[int, int]]:
        """The pairs of segments that may be nearer than the bound."""
        shift = shift_for(*self.prepared)
        boxes = [own.boxes(shift).boxes for own in self.prepared]
        limit = self.bound * (1 << 2 * shift)
        for i, one in enumerate(boxes[0]):
            for j, other in enumerate(boxes[1]):
                moving = self.segments[0][i][0] > 0 and self.segments[1][j][0] > 0
                if moving and _squared_gap(one, other) <= limit:
                    yield i, j

    def _inside(self, i: int, j: int) -> None:
        """The critical pairs inside two segments at which the distance is not above the bound."""
        first, second = (Interval(*c.breakpoints[k : k + 2]) for c, k in zip(self.curves, (i, j), strict=True))
        forms = Forms(self.segments[0][i], self.segments[1][j], Box(first, second))
        undecided = [UNIT]
        if forms.excess(self.bound).sign == 1:
            return
        try:
            # pairs with an end are found elsewhere
            points, arcs, undecided = forms.critical(self.bound)
            self.found += [_pair(zero, forms, pair) for zero, pair in points]
            for factor, arc in arcs:
                squared = forms.value(*arc.inner)
                if squared.enclosure(self.digits).low <= self.bound:
                    self.arcs.append((_overlap(factor, arc, forms.sides), squared))
        except ReachError:
            pass  # the segments are added to `undecided` below
        if undecided:
            self.undecided.append(f"the points inside the segments over {first} and {second}")
            least = forms.least(undecided, self.bound)
            self.lower = least if self.lower is None else min(self.lower, least)

    def answer(self) -> Distance:
        """The nearest of the pairs, and the arcs of such pairs."""
        found: list[tuple[Real, ClosestPair | Overlap]] = [(pair.squared, pair) for pair in self.found]
        found += [(squared, arc) for arc, squared in self.arcs]
        try:
            keep_least(found, self.digits)
        except ReachError as error:
            self.undecided.append(f"which of {counted(len(found), 'pair or arc')} are the nearest: {error.problem}")
            self.lower = min(squared.enclosure(self.digits + TIED).low for squared, _ in found)
        pairs = _each_once([one for _, one in found if isinstance(one, ClosestPair)], self.undecided)
        arcs = tuple(one for _, one in found if isinstance(one, Overlap))
        if self.lower is not None and pairs[0].squared < self.lower:
            return Distance(pairs, everywhere=arcs)
        return Distance(pairs, self.lower, tuple(self.undecided), arcs)


def _bound(values: Sequence[Real]) -> tuple[int, mpq]:
    """An upper bound of the least of some numbers, at most twice this number, and the digits to which it is known."""
    digits = BOUND
    while True:
        low, high = (min(ends) for ends in zip(*[value.enclosure(digits) for value in values], strict=True))
        if high <= 2 * low:
            return digits, high
        digits *= 2


def _overlap(factor: fmpz_mpoly, arc: MonotoneArc, sides: Box) -> Overlap:
    """An arc along which the distance is constant, by the parameters of both curves."""
    ends = sorted((CommonZero(sides, end).place for end in (arc.start, arc.end)), key=itemgetter(1))
    first, second = ((real(a), real(b)) for a, b in zip(*ends, strict=True))
    return Overlap(first, second, *_map(over(as_form(factor), sides)))


def _map(p: fmpz_mpoly) -> tuple[tuple[int, ...] | None, tuple[int, ...] | None, bool]:
    """For a polynomial in both parameters that is linear in one of them: this parameter as a function of the other one
    where the polynomial vanishes, by numerator and denominator, and whether it is the parameter of the second curve.
    None if there is no such function.
    """
    for of_second, q in enumerate((p.compose(T, S), p)):
        rows = rows_of(q)
        if len(rows) == 2 and max(row.degree() for row in rows) > 0:
            sign = -1 if rows[1].leading_coefficient() < 0 else 1
            top, bottom = (tuple(int(x) * sign for x in row.coeffs()) for row in (-rows[0], rows[1]))
            return top, bottom, bool(of_second)
    return None, None, False


def _squared_gap(one: IntegerBox, other: IntegerBox) -> int:
    """A lower bound of the squared distance between points of two boxes."""
    if one is None or other is None:
        return 0
    return sum(max(c - b, a - d, 0) ** 2 for (a, b), (c, d) in zip(one, other, strict=True))


class Forms(Quotient):
    """The squared distance of two segments over these sides as a quotient, and its derivatives, as polynomials in the
    local parameters s and t of the segments.
    """

    def __init__(self, first: SegmentForms, second: SegmentForms, sides: Box) -> None:
        (*p, w), (*q, v) = ([in_parameter(x, n, UNIT.first)[0] for x in forms] for n, forms in (first, second))
        chord = [lifted(x, 0) * lifted(v, 1) - lifted(w, 0) * lifted(y, 1) for x, y in zip(p, q, strict=True)]
        super().__init__(_total([e * e for e in chord]), lifted(w * w, 0) * lifted(v * v, 1), sides)
        #: The derivatives of the squared distance, up to positive factors.
        self.slopes = [
            _total([e * lifted(quotient_slope(x, w), 0) for e, x in zip(chord, p, strict=True)]),
            _total([e * lifted(quotient_slope(y, v), 1) for e, y in zip(chord, q, strict=True)]),
        ]

    def least(self, boxes: Sequence[Box], bound: mpq) -> mpq:
        """A lower bound of the squared distance on all boxes, close to the given bound if possible."""
        least = mpq(0)
        for k in range(1, NARROW):
            closer = bound * (1 - mpq(1, 1 << k))
            excess = self.excess(closer)
            if any(excess.part(box).sign != 1 for box in boxes):
                break
            least = closer
        return least


def _total(terms: list[V]) -> V:
    return reduce(add, terms)


def _pair(zero: CommonZero, forms: Forms, pair: Sequence[PatchForm]) -> ClosestPair:
    """A critical pair, which is a common zero of two forms: its numbers are enclosed by boxes, and computed exactly on
    demand.
    """
    return ClosestPair(*zero.on(forms.sides).numbers, forms.at(zero, pair))
