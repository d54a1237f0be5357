"""What a library documents about the size of what it tells apart, and whether a failure is a matter of that."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

from exactspline.errors import ExactSplineError
from exactspline.geometry.analysis.curves import analyse
from exactspline.geometry.curves.kinds import FeatureKind
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval
from exactspline.splines.nurbs import Nurbs
from exactspline.testing import Case
from workshop.grade.data import Answer
from workshop.grade.judge import INVENTED, MISSED, PLACE, RIGHT, TOLERATED, Verdict, note_of, pairs_compared

#: The distance within which points are one for Open CASCADE, its ``Precision::Confusion()``.
CONFUSION = mpq(1, 10**7)
#: For fontTools, a cubic s³ − 3Qs + 2R with R² and |Q|³ below this has a threefold root, rounded to this many digits.
THREEFOLD, ROUNDED = mpq(1, 10**10), 6
#: What each library documents.
DOCUMENTED = {
    "Open CASCADE": (
        "points within δ = 10⁻⁷, the distance of `Precision::Confusion()`, are considered to coincide. A feature may "
        "be missed if not all curves within δ have it, or if the radius of curvature is at most δ. A feature "
        "may be invented if some curve within δ may have it, or if a true feature is within δ in space. A common point "
        "of two curves may be invented where the curves are at most δ apart"
    ),
    "fontTools": (
        "`solveCubic` takes the real roots of s³ − 3Qs + 2R for 0 if R² and |Q|³ are below 10⁻¹⁰, as its examples with "
        "threefold roots show. The `precision` of 10⁻³ in `curveCurveIntersections` is an area: the points of a pair "
        "may be the square root of this area apart"
    ),
    "bezier-js": "the two points of a pair may be 10⁻⁵ apart, the threshold of `intersects`",
}
#: The features that a question asks for.
KINDS = {"inflections": (FeatureKind.INFLECTION,), "extrema": (FeatureKind.MAXIMUM, FeatureKind.MINIMUM)}


#: The distance of points that are one for each library, where it intersects curves.
MEETING = {"Open CASCADE": CONFUSION, "fontTools": mpq(316, 10**4), "bezier-js": mpq(1, 10**5)}


def tolerated(
    library: str, case: Case, question: str, verdict: Verdict, truth: Answer, answer: object = None
) -> Verdict:
    """The verdict without what is a matter of what the library documents; `TOLERATED` where nothing remains."""
    if verdict.outcome not in (MISSED, INVENTED):
        return verdict
    if library in MEETING and question == "meetings":
        within = pairs_compared(case, truth, answer, MEETING[library])
        return replace(within, outcome=TOLERATED, note=verdict.note) if within.outcome == RIGHT else within
    if library == "Open CASCADE" and question in KINDS:
        return _within(CONFUSION, case, question, verdict, truth)
    if library == "fontTools" and question == "roots":
        return _threefold(case.curve, verdict)
    return verdict


def _remaining(verdict: Verdict, missed: Iterable[mpq], invented: Iterable[mpq]) -> Verdict:
    """The verdict on these alone."""
    left, more = tuple(missed), tuple(invented)
    outcome = MISSED if left else INVENTED if more else TOLERATED
    return replace(verdict, outcome=outcome, note=note_of(outcome, left or more), missed=left, invented=more)


def _threefold(curve: Nurbs, verdict: Verdict) -> Verdict:
    """A cubic that is taken to have a threefold root: all its roots may be missed, and that one named."""
    if curve.degree != 3:
        return verdict
    y = [point[1] for point in curve.control_points]
    a, b, c = y[3] - 3 * y[2] + 3 * y[1] - y[0], 3 * (y[2] - 2 * y[1] + y[0]), 3 * (y[1] - y[0])
    if a == 0:
        return verdict
    b, c, d = b / a, c / a, y[0] / a
    q, r = (b * b - 3 * c) / 9, (2 * b**3 - 9 * b * c + 27 * d) / 54
    if r * r >= THREEFOLD or abs(q) ** 3 >= THREEFOLD:
        return verdict
    reach = mpq(1, 10**ROUNDED)
    return _remaining(verdict, (), [t for t in verdict.invented if abs(t + b / 3) > reach])


def _within(within: mpq, case: Case, question: str, verdict: Verdict, truth: Answer) -> Verdict:
    """Judged with a distance δ within which points are one.

    A place that was missed is a matter of it where not all curves within δ of the curve have it (as far as is proved),
    or where the radius of curvature is at most δ; one that was invented, where some curve within δ may have it, or
    where it is at most δ in space from a place that there is.
    """
    curve, kinds = case.curve, KINDS[question]
    try:
        features = analyse(curve).features_within(within)
    except ExactSplineError:
        return verdict
    certain = [each.place for each in features if each.robust and each.kind in kinds]
    possible = [each.place for each in features if not each.robust and each.kind in (*kinds, FeatureKind.STOP)]
    reach = PLACE * (curve.domain[1] - curve.domain[0])
    there = [mpq(root["low"]) for each in truth["certificates"] for root in _roots(each)]
    missed = [t for t in verdict.missed if _is_in(t, certain, reach) and not _bends_within(curve, t, within)]
    invented = [t for t in verdict.invented if not _is_in(t, possible, reach) and not _is_near(curve, t, there, within)]
    return _remaining(verdict, missed, invented)


def _roots(certificate: dict[str, Any]) -> list[dict[str, Any]]:
    roots: list[dict[str, Any]] = certificate["roots"]
    return roots


def _is_in(t: mpq, places: Sequence[Interval], reach: mpq) -> bool:
    return any(place.low - reach <= t <= place.high + reach for place in places)


def _bends_within(curve: Nurbs, t: mpq, within: mpq) -> bool:
    """Whether the radius of curvature is at most a distance: ``‖γ′‖³ ≤ δ |γ′ × γ″|``, squared."""
    (x, y), (a, b) = curve.derivative(1, t, "left"), curve.derivative(2, t, "left")
    return bool((x * x + y * y) ** 3 <= (within * (x * b - y * a)) ** 2)


def _is_near(curve: Nurbs, t: mpq, places: Sequence[mpq], within: mpq) -> bool:
    """Whether the point is at most so far from one of those at other parameters."""
    low, high = curve.domain
    if not low <= t <= high:
        return False
    point = curve(t, "left")
    return any(
        sum(((x - y) ** 2 for x, y in zip(point, curve(other, "left"), strict=True)), start=mpq(0)) <= within * within
        for other in places
    )
