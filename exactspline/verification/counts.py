"""What is counted of papers: statements, those that hold and that are refuted, errors. The ledger, the errata, reports
and pages count by these functions alone.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from exactspline.verification.claim import Claim
from exactspline.verification.verdict import PROVED, REFUTED, VERIFIED
from exactspline.verification.vocabulary import Status, Verdict


@dataclass(frozen=True)
class Counts:
    """How many statements of one status there are, how many of them hold and how many are refuted, and of how many
    errors.
    """

    statements: int
    hold: int
    refuted: int
    errors: int

    @property
    def neither(self) -> int:
        """How many neither hold nor are refuted."""
        return self.statements - self.hold - self.refuted


def count_statements(decided: Iterable[tuple[Claim, Verdict]]) -> dict[Status, Counts]:
    """The counts by status of claims with their verdicts for all curves.

    >>> from exactspline.verification.claims import select
    >>> count_statements((claim, claim.expected) for claim in select(["C4.2b"]))[Status.PRINTED]
    Counts(statements=2, hold=1, refuted=1, errors=1)
    """
    pairs = list(decided)
    return {status: _counts([pair for pair in pairs if pair[0].status == status]) for status in Status}


def recorded(claims: Iterable[Claim]) -> dict[Status, Counts]:
    """The counts by status of the verdicts on record."""
    return count_statements((claim, claim.expected) for claim in claims)


def _counts(decided: list[tuple[Claim, Verdict]]) -> Counts:
    fails = [claim for claim, verdict in decided if verdict == REFUTED]
    holds = sum(verdict in (PROVED, VERIFIED) for _, verdict in decided)
    return Counts(len(decided), holds, len(fails), len({(claim.paper, error_of(claim)) for claim in fails}))


def error_of(claim: Claim) -> str:
    """The error to which a refuted statement belongs: an error of its own where none is recorded."""
    return claim.error or claim.key
