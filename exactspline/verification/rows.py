"""Rows of the ledger, findings compared with the record; and what is counted of papers: the ledger, the errata, reports
and pages count by these functions alone.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from exactspline.hooks import Displayed
from exactspline.one_line import one_line
from exactspline.verification.claim import Claim
from exactspline.verification.evidence import DegreeHere, Evidence, Found, ZeroHere
from exactspline.verification.verdict import (
    INAPPLICABLE,
    NOT_ASKED,
    PROVED,
    REFUTED,
    UNDECIDED,
    VACUOUS,
    VERIFIED,
    Finding,
)
from exactspline.verification.vocabulary import Name, Reason, Status, Verdict

#: The name shown in place of a curve's where all curves are meant.
ALL_CURVES = Name("")


@dataclass(frozen=True)
class Row(Displayed):
    """A line of the ledger: the finding of a check of a claim, for all curves (``curve`` is empty) or on one.

    ``reading`` is the reading in which it was decided, ``beside`` are the operands in addition to the curve;
    ``expected`` are the verdicts that agree with the record, ``second`` is what another judge found, where one was
    asked.
    """

    claim: Claim
    reading: Name
    curve: Name
    finding: Finding
    expected: tuple[Verdict, ...]
    seconds: float
    beside: Evidence | None = None
    second: Finding | None = None

    @one_line
    def __repr__(self) -> str:
        return f"<Row {self.claim.key}: {self.finding.verdict}>"

    @property
    def id(self) -> str:
        """The id of the claim."""
        return self.claim.id

    @property
    def key(self) -> str:
        """Its key."""
        return self.claim.key

    @property
    def paper(self) -> str:
        """Its paper."""
        return self.claim.paper

    @property
    def status(self) -> Status:
        """Whether the statement is printed, corrected, or ours."""
        return self.claim.status

    @property
    def statement(self) -> str:
        """The statement, with a mark where the paper prints another one."""
        return self.claim.statement + (" (corrected)" if self.status == Status.MEANT else "")

    @property
    def claimed(self) -> str:
        """The claimed value, for one curve as a number."""
        here = self.computed
        return here.relation.bound(here.claimed) if isinstance(here, DegreeHere | ZeroHere) else self.claim.claims

    @property
    def verdict(self) -> Verdict:
        """The verdict."""
        return self.finding.verdict

    @property
    def computed(self) -> Found | None:
        """The computed value."""
        return self.finding.computed

    @property
    def factor(self) -> Found | None:
        """The factor between two sides."""
        return self.finding.factor

    @property
    def witness(self) -> Evidence | None:
        """Where it fails, or why nothing was decided."""
        return self.finding.witness

    @property
    def as_recorded(self) -> bool:
        """Whether the verdict is the recorded one."""
        return self.verdict in self.expected

    @property
    def out_of_reach(self) -> bool:
        """Whether the claim, or the opinion of a second judge, was left undecided because of its cost."""
        return any(each and each.reason == Reason.COST for each in (self.finding, self.second))

    @property
    def differs(self) -> bool:
        """Whether it contradicts the record, by its own verdict or that of the second judge: undecided because of its
        cost, or not asked, is not another verdict.
        """
        second = self.second.verdict if self.second else UNDECIDED
        opposed = second in (PROVED, REFUTED) and (second == REFUTED) != (REFUTED in self.expected)
        return opposed or not (self.as_recorded or self.refused or self.finding.reason == Reason.COST)

    @property
    def refused(self) -> bool:
        """Whether the claim could not be asked, though its author meant it to be."""
        return self.verdict == NOT_ASKED and not self.as_recorded


def row(
    claim: Claim,
    reading: Name,
    finding: Finding,
    seconds: float,
    *,
    curve: Name = ALL_CURVES,
    beside: Evidence | None = None,
    is_example: bool = False,
) -> Row:
    """A finding compared with the record. The record is about all curves. On one curve a claim that holds must be
    VERIFIED, unless it is vacuous there, which is recorded for the example curves; one that fails in general may well
    hold there.
    """
    expected = _expected(claim, curve, finding, is_example) if curve else (claim.expected,)
    return Row(claim, reading, curve, finding, expected, seconds, beside)


def _expected(claim: Claim, curve: Name, finding: Finding, is_example: bool) -> tuple[Verdict, ...]:
    if finding.verdict == INAPPLICABLE:
        return (INAPPLICABLE,)
    if finding.reason in (Reason.LEFT, Reason.SAMPLED):
        return (UNDECIDED,)
    if (finding.verdict == VACUOUS and not is_example) or (is_example and curve in claim.vacuous):
        return (VACUOUS,)
    return (VERIFIED,) if claim.expected in (PROVED, VERIFIED) else (REFUTED, VERIFIED)


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


def recorded_counts(claims: Iterable[Claim]) -> dict[Status, Counts]:
    """The counts by status of the verdicts on record."""
    return count_statements((claim, claim.expected) for claim in claims)


def _counts(decided: list[tuple[Claim, Verdict]]) -> Counts:
    fails = [claim for claim, verdict in decided if verdict == REFUTED]
    holds = sum(verdict in (PROVED, VERIFIED) for _, verdict in decided)
    return Counts(len(decided), holds, len(fails), len({(claim.paper, error_of(claim)) for claim in fails}))


def error_of(claim: Claim) -> str:
    """The error to which a refuted statement belongs: an error of its own where none is recorded."""
    return claim.error or claim.key
