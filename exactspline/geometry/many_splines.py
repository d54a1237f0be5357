"""Inflections and curvature extrema of thousands of plane curves of any degrees and numbers of segments, through the
certified filter.

All segments of one degree are filtered together (`exactspline.geometry.filtered`). A curve is decided where all of its
segments are, and every knot: with the same certain signs of a form on both sides a knot has no feature; otherwise its
continuity decides. The others are left to exact arithmetic. This module loads numpy.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import islice

import numpy as np

from exactspline.errors import ExactSplineError, ShapeError, as_items
from exactspline.geometry.filtered import AT_ONCE
from exactspline.geometry.many_curves import Found, ManyFeatures, exactly, in_order, joined
from exactspline.geometry.many_segments import Segments
from exactspline.polynomials.doubles import Flags
from exactspline.splines.expected import curve_of
from exactspline.splines.nurbs import Nurbs


def features_of_curves(curves: Iterable[Nurbs]) -> ManyFeatures:
    """Inflections and curvature extrema of plane curves, of any degrees, polynomial or rational. What is not a plane
    curve is refused; the others are computed.

    >>> from exactspline import example
    >>> found = features_of_curves([example("six_segment_cubic"), example("cubic_s")] * 2)
    >>> np.bincount(found.curve).tolist(), found.exact.tolist(), len(found.refused)
    ([10, 3, 10, 3], [], 0)
    """
    parts = list(curve_features_in_parts(curves))
    return joined(parts) if parts else in_order([], np.zeros(0, dtype=int), {})


def curve_features_in_parts(curves: Iterable[Nurbs], *, at_once: int = AT_ONCE) -> Iterator[ManyFeatures]:
    """The same, for this many curves at a time, so that partial results are available."""
    source, start = iter(as_items(curves, "curves")), 0
    while some := list(islice(source, at_once)):
        found = _features(some)
        refused = {i + start: error for i, error in found.refused.items()}
        yield found._replace(curve=found.curve + start, exact=found.exact + start, refused=refused)
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
    found: list[Found] = []
    left: list[int] = []
    for members in groups.values():
        for part in of_few_segments(curves, members):
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


def of_few_segments(curves: Sequence[Nurbs], members: Sequence[int]) -> Iterator[list[int]]:
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
    segments = Segments(curves)
    done, left = segments.filtered()
    if done is None:
        return [], left
    found = [(segments.inside(form, which)) for which, form in enumerate((done.curvature, done.critical))]
    at_knots = [segments.at_knots(jumps) for jumps in segments.jumps(done, left)]
    return [_where(each, ~left[each[0]]) for each in (*found, *at_knots)], left


def _where(found: Found, holds: Flags) -> Found:
    curve, kind, low, high, which = found
    return curve[holds], kind[holds], low[holds], high[holds], which[holds]
