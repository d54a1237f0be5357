"""Inflections and curvature extrema of thousands of plane curves of any degrees and numbers of segments, through the
certified filter.

All segments of one degree are filtered together (`exactspline.geometry.filtered`). A curve is decided when all of its
segments and all of its knots are: where a form has the same certified sign on both sides, the knot has no feature;
otherwise its continuity decides. The other curves are decided in exact arithmetic. This module loads numpy.
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
