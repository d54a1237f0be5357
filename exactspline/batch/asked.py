"""The curves of a group of a sweep, and what the certified filter knows of them together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from importlib.util import find_spec
from time import process_time
from typing import TYPE_CHECKING

from exactspline.batch.corpus import Item, Member, Problem
from exactspline.batch.lines import Way
from exactspline.splines.nurbs import Nurbs

if TYPE_CHECKING:
    from exactspline.geometry.many_roots import Settled

#: The filter is used for curves that together have this many segments of one degree: for fewer it takes longer than
#: exact arithmetic.
TOGETHER = 24


@dataclass
class Asked:
    """A curve of a corpus, or the problem with it; the processor time spent on it; what the filter decided about it."""

    item: Item
    curve: Nurbs | None
    error: Problem | None
    seconds: float
    way: Way | None = None
    settled: Settled | None = None

    @classmethod
    def of(cls, item: Item) -> Asked:
        """The curve of an item, generated where necessary."""
        if isinstance(item.given, Problem):
            return cls(item, None, item.given, 0)
        start = process_time()
        try:
            return cls(item, item.curve(), None, process_time() - start)
        # one curve must not end a sweep of a million: an unexpected exception is recorded by its type
        except Exception as error:
            return cls(item, None, Problem.of(error), process_time() - start)


def weight(item: Item) -> int | None:
    """A rough measure of the work on a curve that is given to the filter: its number of segments times the cube of its
    degree; for a family the largest such value. None for other curves.

    >>> from exactspline.batch.corpus import items
    >>> from exactspline.batch.families import Family
    >>> families = [Family.parsed(f"degree=2-5 dimension={n} count=1") for n in (2, 3)]
    >>> [weight(item) for item in items(["six_segment_cubic", *families])]
    [162, 125, None]
    """
    given = item.given
    if isinstance(given, Member):
        return given.family.segments[1] * given.family.degree[1] ** 3 if given.family.dimension == 2 else None
    if isinstance(given, Problem) or not _spoken_of(given):
        return None
    return int(given.segments * given.degree**3)


def ask(curves: Sequence[Asked]) -> None:
    """Apply the filter to the plane curves among these. The processor time of curves computed together is divided in
    proportion to their segments.
    """
    kinds: dict[tuple[int, bool], list[Asked]] = {}
    for each in curves:
        if each.curve is not None and _spoken_of(each.curve):
            kinds.setdefault((each.curve.degree, each.curve.polynomial), []).append(each)
    for alike in kinds.values():
        if sum(_segments(each) for each in alike) < TOGETHER:
            continue
        if find_spec("numpy") is None:
            for each in alike:
                each.way = Way.MISSING
            continue
        _ask(alike)


def _spoken_of(curve: Nurbs) -> bool:
    """Whether the filter is worthwhile: for a plane curve, except quadratics with multiple knots, which have straight
    pieces, corners, and vertices at rational parameters only.
    """
    if curve.dimension != 2 or curve.degree < 2:
        return False
    return curve.degree > 2 or not curve.polynomial or all(smooth == 1 for smooth in curve.p[0].continuity)


def _segments(each: Asked) -> int:
    return 0 if each.curve is None else each.curve.segments


def _ask(alike: Sequence[Asked]) -> None:
    from exactspline.geometry.many_roots import settled

    start = process_time()
    answers = settled([each.curve for each in alike if each.curve is not None])
    try:
        for numbers, found in answers:
            own = [alike[i] for i in numbers]
            seconds, start = process_time() - start, process_time()
            total = sum(map(_segments, own))
            for each, known in zip(own, found, strict=True):
                each.settled, each.way = known, Way.EXACT if known is None else Way.DECIDED
                each.seconds += seconds * _segments(each) / total
    # what the filter cannot decide is computed exactly, and the failure is counted
    except Exception:
        for each in alike:
            each.way = each.way or Way.FAILED
