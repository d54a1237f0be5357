"""The work on each curve of a sweep: picklable, so that it can be done in any process."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache, partial
from time import process_time
from typing import TYPE_CHECKING

from exactspline.batch.asked import Asked, ask, weight
from exactspline.batch.backends import ALONE
from exactspline.batch.corpus import Item, Problem
from exactspline.batch.inspections import USUAL, checked_names, entry_of, inspected
from exactspline.batch.lines import Found, Judged, Line
from exactspline.errors import as_integer, as_texts
from exactspline.splines.nurbs import Nurbs

if TYPE_CHECKING:
    from exactspline.verification.claim import Claim
    from exactspline.verification.combined import Proofs

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
        return cls(checked_names(usual if find is None else find), located, digits, bool(values))

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
