"""Inflections and curvature extrema of thousands of plane curves of any degrees and numbers of segments, through the
certified filter.

All segments of one degree are filtered together (`exactspline.geometry.filtered`). A curve is decided where all of its
segments are, and every knot: with the same certain signs of a form on both sides a knot has no feature; otherwise its
continuity decides. The others are left to exact arithmetic. This module loads numpy.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import islice, pairwise

import numpy as np
from flint import fmpz_poly
from numpy.typing import NDArray

from exactspline.errors import ExactSplineError, ShapeError
from exactspline.exact import mpq
from exactspline.geometry.filtered import AT_ONCE, Filtered, Form, filtered
from exactspline.geometry.many_curves import KINDS, Found, ManyFeatures, exactly, in_order, joined, outside
from exactspline.programs.doubles import ROUNDING
from exactspline.roots.doubles import Flags, Rows
from exactspline.splines.nurbs import Nurbs

#: The share of the ends of a segment that a parameter inside can be off by.
WIDER = 16 * ROUNDING
#: Widths of segments that are known less well than this say nothing.
LITTLE = 1 / 1024
#: Cubes of quotients of widths below this say nothing: a product with a larger one loses `UNDERFLOW` at most, and the
#: bounds of both forms are larger than that.
FLAT = 1 / 2**300
#: Breakpoints other than 0 whose sizes are outside are left to exact arithmetic: the width of a segment could overflow,
#: and numbers below `UNDERFLOW` are farther from the nearest double than by a rounding.
SIZES = mpq(1, 2**900), mpq(2**1000)
#: Continuity at the seam of a closed curve: that of its points.
SEAM = 0


def features_of_curves(curves: Iterable[Nurbs]) -> ManyFeatures:
    """Inflections and curvature extrema of plane curves, of any degrees, polynomial or rational. What is no plane curve
    is refused; the others are computed.

    >>> from exactspline import example
    >>> found = features_of_curves([example("six_segment_cubic"), example("cubic_s")] * 2)
    >>> np.bincount(found.curve).tolist(), found.exact.tolist(), len(found.refused)
    ([10, 3, 10, 3], [], 0)
    """
    parts = list(curve_features_in_parts(curves))
    return joined(parts) if parts else in_order([], np.zeros(0, dtype=int), {})


def curve_features_in_parts(curves: Iterable[Nurbs], *, at_once: int = AT_ONCE) -> Iterator[ManyFeatures]:
    """The same, for so many curves at a time, so that partial results are available."""
    source, start = iter(curves), 0
    while some := list(islice(source, at_once)):
        found = _features(some)
        refused = {i + start: error for i, error in found.refused.items()}
        yield found._replace(curve=found.curve + start, exact=found.exact + start, refused=refused)
        start += len(some)


def _features(curves: Sequence[Nurbs]) -> ManyFeatures:
    groups: dict[tuple[int, bool], list[int]] = {}
    refused: dict[int, ExactSplineError] = {}
    for i, curve in enumerate(curves):
        if not isinstance(curve, Nurbs):
            told = f"is of type {type(curve).__name__}"
            refused[i] = ShapeError(told, where=f"curves[{i}]", remedy="a `Nurbs` curve; for arrays `features_of_many`")
        elif curve.dimension != 2:
            refused[i] = ShapeError(f"a curve in {curve.dimension} dimensions", where=f"curves[{i}]", remedy="in 2")
        else:
            groups.setdefault((curve.degree, curve.polynomial), []).append(i)
    found: list[Found] = []
    left: list[int] = []
    for members in groups.values():
        for part in _of_few_segments(curves, members):
            own, undecided = decided([curves[i] for i in part])
            numbers = np.array(part)
            found += [(numbers[rows], kinds, low, high, which) for rows, kinds, low, high, which in own]
            left += numbers[undecided].tolist()
    exact: list[int] = []
    for i in sorted(left):
        try:
            found.append(exactly(i, curves[i]))
            exact.append(i)
        except ExactSplineError as error:
            refused[i] = error
    return in_order(found, np.array(exact, dtype=int), refused)


def _of_few_segments(curves: Sequence[Nurbs], members: Sequence[int]) -> Iterator[list[int]]:
    """The members in order, in parts of about as many segments as are filtered at once."""
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
    """The features of plane curves of one degree, all polynomial or all rational, where they are certain, and the
    curves of which they are not.
    """
    segments = _Segments(curves)
    done = filtered(curves[0].degree, segments.operands)
    if done is None:
        return [], np.ones(len(curves), dtype=bool)
    left = segments.unfit.copy()
    left[segments.owner[done.open]] = True
    at_knots = segments.at_knots(done, left)
    found = [(segments.inside(form, which)) for which, form in enumerate((done.curvature, done.critical))]
    return [_where(each, ~left[each[0]]) for each in (*found, *at_knots)], left


def _where(found: Found, holds: Flags) -> Found:
    curve, kind, low, high, which = found
    return curve[holds], kind[holds], low[holds], high[holds], which[holds]


class _Segments:
    """The segments of curves of one degree in doubles, and the knots between them, seams included."""

    def __init__(self, curves: Sequence[Nurbs]) -> None:
        rows: list[list[list[float]]] = [[] for _ in range(2 if curves[0].polynomial else 3)]
        owner: list[int] = []
        ends: list[tuple[float, float]] = []
        knots: list[tuple[int, int, int, float, float]] = []
        #: Curves whose breakpoints are too large or too small.
        self.unfit = np.zeros(len(curves), dtype=bool)
        for i, curve in enumerate(curves):
            first, count = len(owner), curve.segments
            places = _places(curve.breakpoints)
            self.unfit[i] = places is None
            places = places or [(0, 0)] * (count + 1)
            for k, own in enumerate(_numbers(curve)):
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
        self._before, self._behind, self._smooth = (numbers[:, k].astype(int) for k in range(3))
        self._low, self._high = numbers[:, 3], numbers[:, 4]

    def inside(self, form: Form, which: int) -> Found:
        """The zeros inside segments, by the parameter of their curve. Its ends are off by a rounding each; with the
        four roundings of a + (b − a)·x this is less than `WIDER` of both.
        """
        row, low, high, before = form.zeros
        a, b = self._ends[row].T
        more = WIDER * (np.abs(a) + np.abs(b))
        low, high = (np.clip(a + (b - a) * x + side * more, a, b) for x, side in ((low, -1), (high, 1)))
        kinds = np.where(before > 0, *KINDS[1:]) if which else np.full(len(row), KINDS[0])
        return self.owner[row], kinds, low, high, np.full(len(row), which)

    def at_knots(self, done: Filtered, left: Flags) -> list[Found]:
        """The changes of sign of κ and κ′ by a jump; where it is not certain that there is one, or what it is, the
        curve is left.
        """
        bends, turns = (self._differ(form) for form in (done.curvature, done.critical))
        smooth, jumps = self._smooth, self._jumps(done.curvature.rows)
        inflection, extremum = bends & (smooth == 1), turns & (smooth >= 2)
        # with one tangent and a curvature that jumps κ′ has no extremum there
        nothing = turns & (smooth == 1) & jumps
        open_ = (bends & ~inflection) | (turns & ~extremum & ~nothing)
        left[self.owner[self._before[open_]]] = True
        rising = done.critical.rows.values[self._before, -1] > 0
        kinds = np.where(rising, *KINDS[1:]), np.full(len(rising), KINDS[0])
        return [self._found(extremum, kinds[0], 1), self._found(inflection, kinds[1], 0)]

    def _found(self, here: Flags, kinds: NDArray[np.str_], which: int) -> Found:
        owner = self.owner[self._before[here]]
        return owner, kinds[here], self._low[here], self._high[here], np.full(len(owner), which)

    def _differ(self, form: Form) -> Flags:
        """Where a form has other signs before a knot and behind; they are certain on segments that are not open."""
        values = form.rows.values
        found: Flags = (values[self._before, -1] > 0) != (values[self._behind, 0] > 0)
        return found

    def _jumps(self, rows: Rows) -> Flags:
        """Where the curvature of two sides with the same first derivatives differs for sure: the form of κ by local
        parameters is κ‖γ′‖³ times the cube of the width of a segment, up to what both sides have in common.
        """
        with np.errstate(all="ignore"):
            width = self._ends[:, 1] - self._ends[:, 0]
            error = WIDER * (np.abs(self._ends).sum(axis=1)) / width
            ratio = (width[self._behind] / width[self._before]) ** 3
            unsure = 4 * (error[self._behind] + error[self._before]) + 8 * ROUNDING
            left, right = rows.values[self._before, -1] * ratio, rows.values[self._behind, 0]
            bound = rows.errors[self._before, -1] * ratio * 2 + rows.errors[self._behind, 0] * 2
            bound += 2 * np.abs(left) * unsure + 4 * ROUNDING * np.abs(right)
            found: Flags = (unsure < LITTLE) & (ratio > FLAT) & (np.abs(left - right) > bound)
        return found


def _places(breaks: Sequence[mpq]) -> list[tuple[float, float]] | None:
    """Breakpoints between doubles, None where one is too large or too small."""
    least, largest = SIZES
    return [outside(t, t) for t in breaks] if all(t == 0 or least <= abs(t) <= largest for t in breaks) else None


def _numbers(curve: Nurbs) -> Iterator[list[list[float]]]:
    """The scaled coefficients of each component (and of the weight function), segment by segment, each rounded once;
    all coordinates, and all weights, over one power of two, so that none is larger than 1.
    """
    for splines in (curve.p,) if curve.polynomial else (curve.p, (curve.w,)):
        columns = [(x._polynomials, x.denominators) for x in splines]
        sizes = [
            int(c.height_bits()) - int(m).bit_length() + 1
            for polynomials, denominators in columns
            for c, m in zip(polynomials, denominators, strict=True)
            if c
        ]
        size = max(sizes, default=0)
        for polynomials, denominators in columns:
            yield [_row(c, int(m), size, curve.degree) for c, m in zip(polynomials, denominators, strict=True)]


def _row(c: fmpz_poly, m: int, size: int, degree: int) -> list[float]:
    """The coefficients of a form over ``2^size · m`` as doubles."""
    below, above = m << max(size, 0), max(-size, 0)
    row = [(int(x) << above) / below for x in c.coeffs()]
    return row + [0] * (degree + 1 - len(row))
