"""Inflections and curvature extrema of thousands of plane curves of any degrees and numbers of segments, through the
certified filter.

All segments of one degree are filtered together (`exactspline.geometry.filtered`). A curve is decided when all of its
segments and all of its knots are: where a form has the same certified sign on both sides, the knot has no feature;
otherwise its continuity decides. The other curves are decided in exact arithmetic. This module loads numpy.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import islice, pairwise
from typing import NamedTuple

import numpy as np
from flint import fmpz_poly
from numpy.typing import NDArray

from exactspline.errors import ExactSplineError, ShapeError, as_items
from exactspline.geometry.filtered import AT_ONCE, Filtered, Form, filtered
from exactspline.geometry.many_curves import KINDS, Found, ManyFeatures, exactly, in_order, joined, outside
from exactspline.numbers.exact import mpq
from exactspline.polynomials.doubles import Bounded, Flags, Integers
from exactspline.polynomials.roundings import ROUNDING
from exactspline.splines.bspline import BSpline
from exactspline.splines.expected import curve_of
from exactspline.splines.nurbs import Nurbs

#: The relative error (with respect to the ends of its segment) of a parameter inside.
WIDER = 16 * ROUNDING
#: Widths of segments with a larger relative error than this are not used.
LITTLE = 1 / 1024
#: Cubes of quotients of widths below this are not used: a product with a larger one loses at most `UNDERFLOW`, and the
#: bounds of both forms are larger than that.
FLAT = 1 / 2**300
#: Breakpoints other than 0 whose sizes are outside this range are handled in exact arithmetic: the width of a segment
#: could overflow, and numbers below `UNDERFLOW` differ from the nearest double by more than a rounding.
SIZES = mpq(1, 2**900), mpq(2**1000)
#: Continuity at the seam of a closed curve: that of its points.
SEAM = 0


class Jumps(NamedTuple):
    """The indices of knots where a form changes its sign by a jump, the kind of each, and which form it is."""

    knot: Integers
    kind: NDArray[np.str_]
    which: int


class Segments:
    """The segments of curves of one degree, all polynomial or all rational, and the knots between them, seams
    included.
    """

    def __init__(self, curves: Sequence[Nurbs]) -> None:
        self.curves = curves
        rows: list[list[list[float]]] = [[] for _ in range(2 if curves[0].polynomial else 3)]
        owner: list[int] = []
        ends: list[tuple[float, float]] = []
        knots: list[tuple[int, int, int, float, float]] = []
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
            smooth = curve.p[0].continuity
            knots += [(first + k - 1, first + k, smooth[k - 1], *places[k]) for k in range(1, count)]
            if curve.closed:
                knots.append((first + count - 1, first, SEAM, *places[0]))
        #: The scaled coefficients of every segment, and the curve it belongs to.
        self.operands = [np.array(row) for row in rows]
        self.owner = np.array(owner)
        self._ends = np.array(ends)
        numbers = np.array(knots, dtype=float).reshape(-1, 5)
        #: The segments before and behind each knot.
        self.before, self.behind, self._smooth = (numbers[:, k].astype(int) for k in range(3))
        self._low, self._high = numbers[:, 3], numbers[:, 4]

    def filtered(self, *, narrow: bool = True) -> tuple[Filtered | None, Flags]:
        """What is certified for the segments, and the curves for which something is not."""
        done = filtered(self.curves[0].degree, self.operands, narrow=narrow)
        if done is None:
            return None, np.ones(len(self.curves), dtype=bool)
        undecided = self.unfit.copy()
        undecided[self.owner[done.open]] = True
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
        """The changes of sign of κ and κ′ by a jump; where it is not certain that there is one, or of which kind, the
        curve is added to the undecided ones.
        """
        bends, turns = (self._differ(form) for form in (done.curvature, done.critical))
        smooth, jumps = self._smooth, self._jumps(done.curvature.rows)
        inflection, extremum = bends & (smooth == 1), turns & (smooth >= 2)
        # with one tangent and a curvature that jumps κ′ has no extremum there
        nothing = turns & (smooth == 1) & jumps
        open_ = (bends & ~inflection) | (turns & ~extremum & ~nothing)
        undecided[self.owner[self.before[open_]]] = True
        bent, turned = np.flatnonzero(inflection), np.flatnonzero(extremum)
        kinds = np.where(done.critical.rows.values[self.before[turned], -1] > 0, *KINDS[1:])
        return Jumps(bent, np.full(len(bent), KINDS[0]), 0), Jumps(turned, kinds, 1)

    def at_knots(self, jumps: Jumps) -> Found:
        """Changes of sign by a jump, by the parameter of their curve."""
        here = jumps.knot
        owner = self.owner[self.before[here]]
        return owner, jumps.kind, self._low[here], self._high[here], np.full(len(owner), jumps.which)

    def _differ(self, form: Form) -> Flags:
        """Where a form has different signs before and after a knot; they are certain on segments that are decided."""
        values = form.rows.values
        differ: Flags = (values[self.before, -1] > 0) != (values[self.behind, 0] > 0)
        return differ

    def _jumps(self, rows: Bounded) -> Flags:
        """Where the curvature of two sides with the same first derivatives certainly differs: the form of κ in local
        parameters is κ‖γ′‖³ times the cube of the width of a segment, up to what both sides have in common.
        """
        with np.errstate(all="ignore"):
            width = self._ends[:, 1] - self._ends[:, 0]
            error = WIDER * (np.abs(self._ends).sum(axis=1)) / width
            ratio = (width[self.behind] / width[self.before]) ** 3
            unsure = 4 * (error[self.behind] + error[self.before]) + 8 * ROUNDING
            left, right = rows.values[self.before, -1] * ratio, rows.values[self.behind, 0]
            bound = rows.errors[self.before, -1] * ratio * 2 + rows.errors[self.behind, 0] * 2
            bound += 2 * np.abs(left) * unsure + 4 * ROUNDING * np.abs(right)
            jumps: Flags = (unsure < LITTLE) & (ratio > FLAT) & (np.abs(left - right) > bound)
        return jumps


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
