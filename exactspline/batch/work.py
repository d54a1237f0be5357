"""The work on each curve of a sweep, picklable, so that it can be done in any process; and what the certified filter
knows of the curves of a group together.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache, partial
from importlib.util import find_spec
from time import process_time
from typing import TYPE_CHECKING

from exactspline.batch.backends import ALONE
from exactspline.batch.corpus import Item, Member, Problem
from exactspline.batch.inspections import USUAL, checked_names, entry_of, inspected
from exactspline.batch.lines import Found, Judged, Line, Way
from exactspline.errors import as_flag, as_integer, as_texts
from exactspline.splines.nurbs import Nurbs

if TYPE_CHECKING:
    from exactspline.geometry.many_roots import Settled
    from exactspline.verification.claim import Claim
    from exactspline.verification.combined import Proofs

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
    if not isinstance(given, Nurbs) or not _spoken_of(given):
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


#: The default and the largest number of digits of irrational parameters.
DIGITS, MOST_DIGITS = 10, 10_000
#: With more digits than this the intervals of the certified filter contain a decimal too often.
FILTERED_DIGITS = 12


@dataclass(frozen=True)
class Work:
    """The features to search for on each curve, by the names of questions; the claims that are checked on it, by
    paper and key; the digits of irrational parameters; and whether points get their coordinates and curvature.

    >>> from exactspline.batch.corpus import items
    >>> line = Work.of().line(next(items(["six_segment_cubic"])))
    >>> line.segments, {name: len(points) for name, points in line.found.items()}, line.error
    (6, {'inflections': 2, 'curvature_extrema': 8, 'corners': 0}, None)
    """

    find: tuple[str, ...]
    claims: tuple[tuple[str, str], ...]
    digits: int
    values: bool = False

    @classmethod
    def of(
        cls, find: Iterable[str] | None = None, claims: Iterable[str] = (), digits: int = DIGITS, values: bool = False
    ) -> Work:
        """The work that the arguments describe: names of questions (by default `USUAL`, or none where claims are given)
        and ids of claims.

        Raises `FormulaError` or `ClaimError` with the nearest names.
        """
        digits = as_integer(digits, "a number of digits", 0, MOST_DIGITS)
        located = _located(as_texts(claims, "ids of claims", "the id of a claim"))
        usual = () if located else USUAL
        return cls(
            checked_names(usual if find is None else find),
            located,
            digits,
            as_flag(values, "whether points get their values"),
        )

    def settings(self) -> dict[str, object]:
        """On what the lines depend, as data."""
        return {
            "find": list(self.find),
            "claims": [list(claim) for claim in self.claims],
            "digits": self.digits,
            "values": self.values,
        }

    def line(self, item: Item) -> Line:
        """The line of one curve, in exact arithmetic. An error is recorded in the line, so that other curves are not
        affected.
        """
        return self._line(Asked.of(item))

    def lines(self, group: list[Item]) -> Iterator[Line]:
        """The lines of several curves, which are removed from the list so that none is kept when its line is done. The
        lines equal those of `line`; what the certified filter decides for the curves together is not computed again.
        """
        rest = deque(map(Asked.of, group))
        group.clear()
        if self._asks:
            ask([made for made in rest if made.curve is not None])
        while rest:
            yield self._line(rest.popleft())

    def weight(self, item: Item) -> int:
        """How much of a group a curve fills; `ALONE` where the filter is not used, so that nothing is computed
        together.
        """
        filtered = weight(item) if self._asks else None
        return ALONE if filtered is None else filtered

    @property
    def _asks(self) -> bool:
        """Whether the certified filter is used."""
        features = any(entry_of(asked)[0].about.known for asked in self.find)
        return features and not self.claims and self.digits <= FILTERED_DIGITS

    def _line(self, made: Asked) -> Line:
        item, curve, error = made.item, made.curve, made.error
        begun = partial(Line, item.index, item.source, item.name, notes=item.notes, curve_digest=item.digest)
        if curve is None:
            return begun(error=error, seconds=made.seconds)
        shape = curve.degree, curve.dimension, curve.segments, curve.polynomial
        start = process_time()
        found: dict[str, tuple[Found, ...]] = {}
        judged: tuple[Judged, ...] = ()
        try:
            found = inspected(curve, self.find, self.digits, made.settled, self.values)
            judged = self._judged(curve)
        # one curve must not end a sweep of a million: an unexpected exception is recorded by its type
        except Exception as failure:
            found, error = {}, Problem.of(failure)
        seconds = made.seconds + process_time() - start
        return begun(*shape, found=found, claims=judged, error=error, seconds=seconds, way=made.way)

    def _judged(self, curve: Nurbs) -> tuple[Judged, ...]:
        if not self.claims:
            return ()
        from exactspline.display.evidence import worded
        from exactspline.verification.evaluation import Evaluation
        from exactspline.verification.ledger import UNNAMED, checked
        from exactspline.verification.vocabulary import Name

        evaluation = Evaluation(curve)
        speaking = [claim for claim in _claims(self.claims) if claim.applies_to(curve.dimension, curve.polynomial)]
        rows = [(claim, checked(claim, evaluation, Name(curve.name) or UNNAMED, _proofs())) for claim in speaking]
        return tuple(Judged(claim.key, row.verdict, row.as_recorded, worded(row.witness)) for claim, row in rows)


def _located(ids: Sequence[str]) -> tuple[tuple[str, str], ...]:
    if not ids:
        return ()
    from exactspline.verification.claims import all_claims, located

    keep = {claim for name in ids for claim in located(name)}
    return tuple((claim.paper, claim.key) for claim in all_claims() if claim in keep)


@cache
def _claims(keys: tuple[tuple[str, str], ...]) -> tuple[Claim, ...]:
    from exactspline.verification.claims import all_claims

    return tuple(claim for claim in all_claims() if (claim.paper, claim.key) in keys)


@cache
def _proofs() -> Proofs:
    """The proofs of this process, each made once: they are needed where a claim is refuted on a curve."""
    from exactspline.verification.combined import Proofs

    return Proofs()
