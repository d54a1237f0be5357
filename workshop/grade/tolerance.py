"""What a library documents about the size of what it tells apart, and whether a failure is a matter of that."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from exactspline.errors import ExactSplineError
from exactspline.geometry.analysis import analyse
from exactspline.geometry.kinds import FeatureKind
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval
from exactspline.splines.nurbs import Nurbs
from exactspline.testing import Case
from workshop.grade.data import Answer
from workshop.grade.judge import INVENTED, MISSED, PLACE, TOLERATED, Verdict


@dataclass(frozen=True)
class Documented:
    """A distance within which points are one for a library, and where it says so."""

    distance: mpq
    where: str


DOCUMENTED = {
    "Open CASCADE": Documented(
        mpq(1, 10**7), "`Precision::Confusion()`: points at most 10⁻⁷ apart are considered to coincide"
    )
}
#: The features that a question asks for.
KINDS = {"inflections": (FeatureKind.INFLECTION,), "extrema": (FeatureKind.MAXIMUM, FeatureKind.MINIMUM)}


def tolerated(library: str, case: Case, question: str, verdict: Verdict, truth: Answer) -> Verdict:
    """The verdict without what is a matter of the library's documented distance δ; `TOLERATED` where nothing remains.

    A place that was missed is such a matter where not all curves within δ of the curve have it (as far as is proved),
    or where the radius of curvature is at most δ; one that was invented, where some curve within δ may have it, or
    where it is at most δ in space from a place that there is.
    """
    documented = DOCUMENTED.get(library)
    if documented is None or question not in KINDS or verdict.outcome not in (MISSED, INVENTED):
        return verdict
    curve, within, kinds = case.curve, documented.distance, KINDS[question]
    try:
        features = analyse(curve).features_within(within)
    except ExactSplineError:
        return verdict
    certain = [each.place for each in features if each.certain and each.kind in kinds]
    possible = [each.place for each in features if not each.certain and each.kind in (*kinds, FeatureKind.STOP)]
    reach = PLACE * (curve.domain[1] - curve.domain[0])
    there = [mpq(root["low"]) for each in truth["certificates"] for root in _roots(each)]
    missed = [t for t in verdict.missed if _is_in(t, certain, reach) and not _bends_within(curve, t, within)]
    invented = [t for t in verdict.invented if not _is_in(t, possible, reach) and not _is_near(curve, t, there, within)]
    outcome = MISSED if missed else INVENTED if invented else TOLERATED
    return replace(verdict, outcome=outcome, missed=tuple(missed), invented=tuple(invented))


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
