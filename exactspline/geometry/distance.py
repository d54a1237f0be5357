"""The distance of two curves: the pairs of nearest points, each certified, and the arcs of such pairs.

A pair at the least distance is a common point, or has an end or a knot of one of the curves, or is a common zero of the
two derivatives of the squared distance. These are isolated by boxes (`exactspline.roots.common_zeros`), where the
distance is not above that of a pair already known.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import partial, reduce
from operator import add
from typing import TypeVar

from flint import arb, fmpz_mpoly, fmpz_poly

from exactspline.errors import ShapeError
from exactspline.geometry.box_tree import IntegerBox, box_of, shift_for
from exactspline.geometry.intersections import Intersections, Overlap, intersections
from exactspline.geometry.nearest import nearest
from exactspline.hooks import Displayed
from exactspline.numbers.exact import from_flint, mpq, to_fmpq, to_fmpz
from exactspline.numbers.intervals import Box, Interval, ball_around
from exactspline.polynomials.bernstein import quotient_slope
from exactspline.polynomials.patch_forms import PatchForm
from exactspline.polynomials.two_parameters import at, enclosed, lifted, rows_of
from exactspline.reals.ball import InBalls
from exactspline.reals.real import Real, square_root
from exactspline.roots.common_zeros import CommonZero, zeros_of
from exactspline.roots.local_parameters import SegmentForms, segment_forms
from exactspline.splines.expected import curve_of
from exactspline.splines.nurbs import Nurbs

T = TypeVar("T")
#: How near a lower bound is brought to a bound: by a factor of 1 − 2^−k with k below this.
NARROW = 40
#: The digits to which squared distances are compared before pairs count as equally near.
TIED = 60
#: The digits of the bound by which pairs are excluded.
BOUND = 12


@dataclass(frozen=True)
class ClosestPair:
    """A parameter of each curve, at the least distance."""

    first: Real
    second: Real
    squared: Real = field(compare=False)

    def __repr__(self) -> str:
        return f"<closest at {self.first.shortly()} and {self.second.shortly()}>"


@dataclass(frozen=True, repr=False)
class Distance(Displayed):
    """The least distance of two curves, and the pairs of points at it; several are equally near to `TIED` digits.

    `everywhere` are the arcs all of whose points are at it, by their parameters on both curves: arcs in common, arcs of
    a circle about a point of the other curve, and pieces that stand still (with an arc of a circle, all pairs of
    both). Their ends are among the pairs, the points between are not listed. `left_out` names what could not be
    decided: pairs of segments near each other along arcs, say. Then the square of the distance is at least `lower`, a
    rational number; otherwise `lower` is None.
    """

    pairs: tuple[ClosestPair, ...]
    lower: mpq | None = None
    left_out: tuple[str, ...] = ()
    everywhere: tuple[Overlap, ...] = ()

    @property
    def squared(self) -> Real:
        """The square of the distance of the pairs."""
        return self.pairs[0].squared

    @property
    def value(self) -> Real:
        """The distance of the pairs."""
        return square_root(self.squared)

    def __repr__(self) -> str:
        arcs = f", everywhere on {list(self.everywhere)}" if self.everywhere else ""
        doubt = f", undecided: {'; '.join(self.left_out)}" if self.left_out else ""
        return f"<Distance {self.value.shortly()} between {list(self.pairs)}{arcs}{doubt}>"


def distance(first: Nurbs, second: Nurbs) -> Distance:
    """The distance of two curves in the plane or in space, and the pairs of parameters at which they are nearest.

    >>> from exactspline import Nurbs
    >>> parabola = Nurbs(2, [0, 0, 0, 1, 1, 1], [(-1, 1), (0, -1), (1, 1)])  # y = x²
    >>> line = Nurbs(1, [0, 0, 1, 1], [(-1, -2), (1, 0)])  # y = x − 1
    >>> found = distance(parabola, line)
    >>> found
    <Distance 3√2/8 between [<closest at 3/4 and 15/16>]>

    Raises `ShapeError` for curves of different dimensions.
    """
    if curve_of(first).dimension != curve_of(second).dimension:
        raise ShapeError(
            f"a curve in R{first.dimension} and one in R{second.dimension}", remedy="give curves of one dimension"
        )
    return nearest_pairs(first, second, intersections(first, second))


def nearest_pairs(first: Nurbs, second: Nurbs, meeting: Intersections) -> Distance:
    """The same of curves whose common points are known."""
    zero = Real(0)
    if meeting.points or meeting.everywhere:
        pairs = [ClosestPair(p.first, p.second, zero) for p in meeting]
        for arc in meeting.everywhere:
            pairs += _ends(arc, zero)
        lower = mpq(0) if meeting.left_out else None
        return Distance(_each_once(pairs), lower, meeting.left_out, meeting.everywhere)
    return _Search(first, second, meeting.left_out).answer()


def _ends(arc: Overlap, squared: Real) -> list[ClosestPair]:
    """The pairs at the ends of an arc."""
    return [ClosestPair(s, t, squared) for s, t in zip(arc.first, arc.second, strict=True)]


def _within(arc: Overlap, other: Overlap) -> bool:
    """Whether an arc is a part of another one."""
    sides = (arc.first, other.first), (arc.second, other.second)
    return arc is not other and all(c <= a and b <= d for (a, b), (c, d) in sides)


def _each_once(pairs: Iterable[ClosestPair]) -> tuple[ClosestPair, ...]:
    each: list[ClosestPair] = []
    for pair in pairs:
        if not any(_same(pair, other) for other in each):
            each.append(pair)
    return tuple(each)


class _Search:
    """The pairs of nearest points of curves that do not meet."""

    def __init__(self, first: Nurbs, second: Nurbs, left_out: tuple[str, ...]) -> None:
        self.curves, self.left_out = (first, second), list(left_out)
        self.lower: mpq | None = mpq(0) if left_out else None
        self.segments = [[segment_forms(curve, i) for i in range(curve.segments)] for curve in self.curves]
        self.arcs: list[tuple[Overlap, Real]] = []
        self.found = [pair for k in (0, 1) for pair in self._at_knots(k)]
        self.bound = min(pair.squared.enclosure(BOUND).high for pair in self.found)
        for i, j in self._near_pairs():
            self._inside(i, j)

    def _at_knots(self, k: int) -> Iterator[ClosestPair]:
        """The points of curve k nearest to the ends and knots of the other one, and to its pieces that stand still."""
        for place in self._places(1 - k):
            centre = self.curves[1 - k](place.low)
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
                yield from _ends(arc, squared)

    def _places(self, k: int) -> list[Interval]:
        """The pieces of a curve that stand still, and its ends and knots that belong to none of them."""
        curve = self.curves[k]
        sides = [Interval(*curve.breakpoints[i : i + 2]) for i in range(curve.segments)]
        still = [side for side, (degree, _) in zip(sides, self.segments[k], strict=True) if degree == 0]
        return still + [Interval(t, t) for t in curve.breakpoints if not any(low <= t <= high for low, high in still)]

    def _near_pairs(self) -> Iterator[tuple[int, int]]:
        """The pairs of segments that may be nearer than the bound."""
        shift = shift_for([segment for segments in self.segments for segment in segments])
        boxes = [[box_of(segment, shift) for segment in segments] for segments in self.segments]
        limit = self.bound * (1 << 2 * shift)
        for i, one in enumerate(boxes[0]):
            for j, other in enumerate(boxes[1]):
                moving = self.segments[0][i][0] > 0 and self.segments[1][j][0] > 0
                if moving and _squared_gap(one, other) <= limit:
                    yield i, j

    def _inside(self, i: int, j: int) -> None:
        """The critical pairs inside two segments at which the distance is not above the bound."""
        first, second = (Interval(*c.breakpoints[k : k + 2]) for c, k in zip(self.curves, (i, j), strict=True))
        forms = _Forms(self.segments[0][i], self.segments[1][j])
        # pairs with an end are found otherwise
        zeros = zeros_of(forms.slopes, not_positive=[forms.excess(self.bound)])
        self.found += [_pair(zero, first, second, forms) for zero in zeros.zeros if zero.is_inside]
        if zeros.undecided:
            self.left_out.append(f"the points inside the segments over {first.shortly} and {second.shortly}")
            least = forms.least(zeros.undecided, self.bound)
            self.lower = least if self.lower is None else min(self.lower, least)

    def answer(self) -> Distance:
        """The nearest of the pairs."""
        digits, found = BOUND, self.found
        while len(found) > 1 and digits <= TIED:
            bounds = [pair.squared.enclosure(digits) for pair in found]
            limit = min(high for _, high in bounds)
            found = [pair for pair, (low, _) in zip(found, bounds, strict=True) if low <= limit]
            digits *= 2
        each, least = _each_once(found), found[0].squared.enclosure(TIED).high
        near = dict.fromkeys(arc for arc, squared in self.arcs if squared.enclosure(TIED).low <= least)
        arcs = tuple(arc for arc in near if not any(_within(arc, other) for other in near))
        if self.lower is not None and each[0].squared < self.lower:
            return Distance(each, everywhere=arcs)
        return Distance(each, self.lower, tuple(self.left_out), arcs)


def _same(one: ClosestPair, other: ClosestPair) -> bool:
    """Whether both are one pair, to `TIED` digits."""
    ends = (one.first, other.first), (one.second, other.second)
    return all(a.enclosure(TIED).meets(b.enclosure(TIED)) for a, b in ends)


def _squared_gap(one: IntegerBox, other: IntegerBox) -> int:
    """A lower bound of the squared distance of what is in two boxes."""
    if one is None or other is None:
        return 0
    return sum(max(c - b, a - d, 0) ** 2 for (a, b), (c, d) in zip(one, other, strict=True))


class _Forms:
    """The squared distance of two segments and its derivatives, as forms on the square of their local parameters; here
    s and t are those of ``z = v/u`` of each segment.
    """

    def __init__(self, first: SegmentForms, second: SegmentForms) -> None:
        (m, (*p, w)), (n, (*q, v)) = first, second
        self.degrees = m, n
        chord = [lifted(x, 0) * lifted(v, 1) - lifted(w, 0) * lifted(y, 1) for x, y in zip(p, q, strict=True)]
        self.squared, self.weight = _total([e * e for e in chord]), lifted(w * w, 0) * lifted(v * v, 1)
        self.sums = (
            _total([e * lifted(quotient_slope(x, w), 0) for e, x in zip(chord, p, strict=True)]),
            _total([e * lifted(quotient_slope(y, v), 1) for e, y in zip(chord, q, strict=True)]),
        )

    @property
    def slopes(self) -> tuple[PatchForm, PatchForm]:
        """The derivatives of the squared distance, up to positive factors."""
        m, n = self.degrees
        return _form(self.sums[0], 3 * m - 2, n), _form(self.sums[1], m, 3 * n - 2)

    def excess(self, bound: mpq) -> PatchForm:
        """Positive where the squared distance is above a bound."""
        top, bottom = to_fmpz(bound.numerator), to_fmpz(bound.denominator)
        m, n = self.degrees
        return _form(self.squared * bottom - self.weight * top, 2 * m, 2 * n)

    def least(self, boxes: Sequence[Box], bound: mpq) -> mpq:
        """A lower bound of the squared distance on all boxes, near to a bound if that is possible."""
        least = mpq(0)
        for k in range(1, NARROW):
            closer = bound * (1 - mpq(1, 1 << k))
            excess = self.excess(closer)
            if any(excess.part(box).sign != 1 for box in boxes):
                break
            least = closer
        return least

    def value(self, s: mpq, t: mpq) -> mpq:
        """The squared distance at rational parameters inside the segments."""
        z = s / (1 - s), t / (1 - t)
        top, bottom = (from_flint(at(p, 0, z[0])(to_fmpq(z[1]))) for p in (self.squared, self.weight))
        return top / bottom

    def near(self, box: Box) -> arb:
        """A ball around the squared distance on a box; FLINT's precision is the caller's."""
        s, t = (ball_around(low / (1 - low), high / (1 - high)) for low, high in box)
        return enclosed(self.squared, s, t) / enclosed(self.weight, s, t)


def _total(terms: list[T]) -> T:
    return reduce(add, terms)


def _form(p: fmpz_mpoly, m: int, n: int) -> PatchForm:
    rows = rows_of(p)
    return PatchForm.of_rows([*rows, *[fmpz_poly([])] * (n + 1 - len(rows))], m)


def _pair(zero: CommonZero, first: Interval, second: Interval, forms: _Forms) -> ClosestPair:
    """A critical pair: numbers known by their enclosures."""
    if (exact := zero.exact) is not None:
        return ClosestPair(Real(first.at(exact[0])), Real(second.at(exact[1])), Real(forms.value(*exact)))
    parameters = [InBalls(partial(_enclosing, zero, k, side)) for k, side in enumerate((first, second))]
    return ClosestPair(parameters[0], parameters[1], InBalls(partial(_squared, zero, forms)))


def _enclosing(zero: CommonZero, k: int, side: Interval, bits: int) -> arb:
    return ball_around(*side.part(zero.refine(bits)[k]))


def _squared(zero: CommonZero, forms: _Forms, bits: int) -> arb:
    return forms.near(zero.refine(bits))
