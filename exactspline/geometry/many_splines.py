"""Inflections and curvature extrema of thousands of plane curves of any degrees and numbers of segments, through the
certified filter.

All segments of one degree are filtered together (`exactspline.geometry.filtered`). A curve is decided when all of its
segments are, or are straight; what happens at its knots is decided by `exactspline.geometry.at_knots`. The other curves
are decided in exact arithmetic. This module loads numpy.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import islice, pairwise
from typing import NamedTuple

import numpy as np
from flint import fmpz_poly
from numpy.typing import NDArray

from exactspline.errors import ExactSplineError, ShapeError, as_items
from exactspline.geometry.at_knots import Jump, is_straight, jumps
from exactspline.geometry.facts import Facts
from exactspline.geometry.filtered import AT_ONCE, Filtered, Form, filtered
from exactspline.geometry.many_curves import KINDS, Found, ManyFeatures, exactly, in_order, joined, outside
from exactspline.geometry.plane_programs import CRITICAL, CURVATURE
from exactspline.numbers.exact import mpq
from exactspline.polynomials.doubles import Flags, Integers
from exactspline.polynomials.roundings import ROUNDING
from exactspline.questions.answers import CurvePiece
from exactspline.splines.bspline import BSpline
from exactspline.splines.expected import curve_of
from exactspline.splines.nurbs import Nurbs

#: The relative error (with respect to the ends of its segment) of a parameter inside.
WIDER = 16 * ROUNDING
#: Breakpoints other than 0 whose sizes are outside this range are handled in exact arithmetic: the width of a segment
#: could overflow, and numbers below `UNDERFLOW` differ from the nearest double by more than a rounding.
SIZES = mpq(1, 2**900), mpq(2**1000)


class Jumps(NamedTuple):
    """Knots where a form changes its sign by a jump: the curve, the index of the breakpoint, and the kind of each; and
    which form it is.
    """

    curve: Integers
    knot: Integers
    kind: NDArray[np.str_]
    which: int


class Segments:
    """The segments of curves of one degree, all polynomial or all rational."""

    def __init__(self, curves: Sequence[Nurbs]) -> None:
        self.curves = curves
        rows: list[list[list[float]]] = [[] for _ in range(2 if curves[0].polynomial else 3)]
        owner: list[int] = []
        ends: list[tuple[float, float]] = []
        #: Curves whose breakpoints are too large or too small.
        self.unfit = np.zeros(len(curves), dtype=bool)
        #: The first segment of each curve.
        self.first: list[int] = []
        for i, curve in enumerate(curves):
            first, count = len(owner), curve.segments
            self.first.append(first)
            places = _places(curve.breakpoints)
            self.unfit[i] = places is None
            places = places or [(0, 0)] * (count + 1)
            for k, own in enumerate(_doubles(curve)):
                rows[k] += own
            owner += [i] * count
            ends += [(a, b) for (a, _), (_, b) in pairwise(places)]
        #: The scaled coefficients of every segment, and the curve it belongs to.
        self.operands = [np.array(row) for row in rows]
        self.owner = np.array(owner)
        self._ends = np.array(ends)
        #: The straight pieces of a curve that has some.
        self.straight: dict[int, tuple[CurvePiece, ...]] = {}

    def filtered(self, *, narrow: bool = True) -> tuple[Filtered | None, Flags]:
        """What is certified for the segments, and the curves for which something is not. Straight segments are
        recognized exactly and have no zeros.
        """
        done = filtered(self.curves[0].degree, self.operands, narrow=narrow)
        if done is None:
            return None, np.ones(len(self.curves), dtype=bool)
        undecided = self.unfit.copy()
        undecided[self.owner[done.slow]] = True
        for row in np.flatnonzero(done.open & ~undecided[self.owner]).tolist():
            i = int(self.owner[row])
            polynomials = [x._polynomials[row - self.first[i]] for x in components(self.curves[i])]
            if not is_straight(polynomials, self.curves[i].degree):
                undecided[i] = True
        return done, undecided

    def inside(self, form: Form, which: int) -> Found:
        """The zeros inside segments, by the parameter of their curve. The ends of a segment are off by one rounding
        each; with the four roundings of a + (b − a)·x this is less than `WIDER` of both.
        """
        row, low, high, before = form.zeros
        a, b = self._ends[row].T
        more = WIDER * (np.abs(a) + np.abs(b))
        low, high = (np.clip(a + (b - a) * x + side * more, a, b) for x, side in ((low, -1), (high, 1)))
        kinds = np.where(before > 0, *KINDS[1:]) if which else np.full(len(row), KINDS[0])
        return self.owner[row], kinds, low, high, np.full(len(row), which)

    def jumps(self, done: Filtered, undecided: Flags) -> tuple[Jumps, Jumps]:
        """The changes of sign of κ and κ′ by a jump on decided curves."""
        rows = done.curvature.rows, done.critical.rows, done.speed
        ends = np.concatenate([np.stack([r.values[:, k], r.errors[:, k]], 1) for r in rows for k in (0, -1)], axis=1)
        weights = self.operands[2][:, [0, -1]] if len(self.operands) > 2 else np.ones((len(self.owner), 2))
        found: list[tuple[int, Jump]] = []
        for i in np.flatnonzero(~undecided).tolist():
            curve, first = self.curves[i], self.first[i]
            if curve.segments > 1 or curve.closed:
                own = slice(first, first + curve.segments)
                straight = set(np.flatnonzero(done.open[own]).tolist())
                facts = Facts(curve)
                own_ends, own_weights = ends[own].tolist(), weights[own].tolist()
                found += [(i, jump) for jump in jumps(facts, own_ends, own_weights, straight)]
                if straight:
                    self.straight[i] = facts.straight_runs(straight)
            elif done.open[first]:
                self.straight[i] = Facts(curve).straight_runs({0})
        return self._jumps(CURVATURE, found), self._jumps(CRITICAL, found)

    def _jumps(self, which: int, found: Sequence[tuple[int, Jump]]) -> Jumps:
        own = [(i, jump) for i, jump in found if jump.output == which]
        kinds = [str(KINDS[0] if which == CURVATURE else KINDS[1 if jump.before > 0 else 2]) for _, jump in own]
        curve, knot = (np.array(column, dtype=int) for column in ([i for i, _ in own], [j.knot for _, j in own]))
        return Jumps(curve, knot, np.array(kinds, dtype=str), which)

    def at_knots(self, jumps: Jumps) -> Found:
        """Changes of sign by a jump, by the parameter of their curve."""
        curves = zip(jumps.curve.tolist(), jumps.knot.tolist(), strict=True)
        places = [outside(t, t) for t in (self.curves[i].breakpoints[k] for i, k in curves)]
        low, high = (np.array([ends[k] for ends in places], dtype=float) for k in (0, 1))
        return jumps.curve, jumps.kind, low, high, np.full(len(places), jumps.which)


def _places(breaks: Sequence[mpq]) -> list[tuple[float, float]] | None:
    """Breakpoints enclosed between doubles, None where one is too large or too small."""
    least, largest = SIZES
    return [outside(t, t) for t in breaks] if all(t == 0 or least <= abs(t) <= largest for t in breaks) else None


def components(curve: Nurbs) -> tuple[BSpline, ...]:
    """The coordinates of a curve, or of its numerator, and then its weight function; segment by segment over one
    denominator.
    """
    return (*curve.p,) if curve.polynomial else (*curve.p, curve.w)


def whole(c: fmpz_poly, degree: int) -> list[int]:
    """The coefficients of a form."""
    row = [int(x) for x in c.coeffs()]
    return row + [0] * (degree + 1 - len(row))


def _doubles(curve: Nurbs) -> Iterator[list[list[float]]]:
    """The scaled coefficients of each component (and of the weight function), segment by segment, each rounded once;
    all coordinates, and all weights, divided by one power of two, so that none is larger than 1.
    """
    below = [int(m) for m in curve.p[0].denominators]
    rows = [[whole(c, curve.degree) for c in x._polynomials] for x in components(curve)]
    for columns in (rows,) if curve.polynomial else (rows[:-1], rows[-1:]):
        sizes = [
            max(map(abs, row)).bit_length() - m.bit_length() + 1
            for column in columns
            for row, m in zip(column, below, strict=True)
            if any(row)
        ]
        size = max(sizes, default=0)
        for column in columns:
            yield [rounded(row, m, size) for row, m in zip(column, below, strict=True)]


def rounded(row: Sequence[int], m: int, size: int) -> list[float]:
    """Integers over ``2^size · m`` as doubles, each rounded once."""
    below, above = m << max(size, 0), max(-size, 0)
    return [(x << above) / below for x in row]


def features_of_curves(curves: Iterable[Nurbs]) -> ManyFeatures:
    """Inflections and curvature extrema of plane curves, of any degrees, polynomial or rational. Curves that are not in
    the plane are refused; the others are computed.

    >>> from exactspline import example
    >>> features = features_of_curves([example("six_segment_cubic"), example("cubic_s")] * 2)
    >>> np.bincount(features.curve).tolist(), features.exact.tolist(), len(features.refused)
    ([10, 3, 10, 3], [], 0)
    """
    parts = list(curve_features_in_parts(curves))
    return joined(parts) if parts else in_order([], np.zeros(0, dtype=int), {})


def curve_features_in_parts(curves: Iterable[Nurbs], *, at_once: int = AT_ONCE) -> Iterator[ManyFeatures]:
    """The same as `features_of_curves`, for this many curves at a time, so that partial results are available."""
    source, start = iter(as_items(curves, "curves")), 0
    while some := list(islice(source, at_once)):
        features = _features(some)
        refused = {i + start: error for i, error in features.refused.items()}
        yield features._replace(curve=features.curve + start, exact=features.exact + start, refused=refused)
        start += len(some)


def _features(curves: Sequence[Nurbs]) -> ManyFeatures:
    groups: dict[tuple[int, bool], list[int]] = {}
    refused: dict[int, ExactSplineError] = {}
    for i, curve in enumerate(curves):
        try:
            curve_of(curve)
        except ShapeError as error:
            refused[i] = ShapeError(error.problem, where=f"curves[{i}]", remedy=error.remedy)
            continue
        if curve.dimension != 2:
            refused[i] = ShapeError(f"a curve in {curve.dimension} dimensions", where=f"curves[{i}]", remedy="in 2")
        else:
            groups.setdefault((curve.degree, curve.polynomial), []).append(i)
    parts: list[Found] = []
    unsettled: list[int] = []
    for members in groups.values():
        for part in of_few_segments(curves, members):
            own, undecided = decided([curves[i] for i in part])
            numbers = np.array(part)
            parts += [(numbers[rows], kinds, low, high, which) for rows, kinds, low, high, which in own]
            unsettled += numbers[undecided].tolist()
    exact: list[int] = []
    for i in sorted(unsettled):
        try:
            parts.append(exactly(i, curves[i]))
            exact.append(i)
        except ExactSplineError as error:
            refused[i] = error
    return in_order(parts, np.array(exact, dtype=int), refused)


def of_few_segments(curves: Sequence[Nurbs], members: Sequence[int]) -> Iterator[list[int]]:
    """The members in order, in parts of about as many segments as are filtered together."""
    part: list[int] = []
    count = 0
    for i in members:
        part.append(i)
        count += curves[i].segments
        if count >= AT_ONCE:
            yield part
            part, count = [], 0
    if part:
        yield part


def decided(curves: Sequence[Nurbs]) -> tuple[list[Found], Flags]:
    """The features of plane curves of one degree, all polynomial or all rational, where they are certified, and the
    curves for which they are not.
    """
    segments = Segments(curves)
    done, undecided = segments.filtered()
    if done is None:
        return [], undecided
    zeros = [(segments.inside(form, which)) for which, form in enumerate((done.curvature, done.critical))]
    at_knots = [segments.at_knots(jumps) for jumps in segments.jumps(done, undecided)]
    return [_where(each, ~undecided[each[0]]) for each in (*zeros, *at_knots)], undecided


def _where(zeros: Found, holds: Flags) -> Found:
    curve, kind, low, high, which = zeros
    return curve[holds], kind[holds], low[holds], high[holds], which[holds]
