"""What the audit says: one row a claim, a reading and a curve."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any

from exactspline.language.services import Displayed
from exactspline.verification.claims import Claim

PROVED, VERIFIED, REFUTED, UNDECIDED = "PROVED", "VERIFIED", "REFUTED", "UNDECIDED"
#: What `witness` says where both sides vanish: no success, and no failure either.
VACUOUS = "vacuous: 0 = 0, or 0/0 on a whole segment"


@dataclass
class Finding:
    """What one check found: computed value, factor, witness and verdict, before it is held against the record."""

    verdict: str
    claimed: str = ""
    computed: str = ""
    factor: str = ""
    witness: str = ""


@dataclass
class Row(Displayed):
    """A line of the ledger."""

    id: str
    kind: str
    source: str
    statement: str
    assumes: str
    reading: str
    curve: str
    claimed: str
    computed: str
    factor: str
    witness: str
    verdict: str
    expected: str
    seconds: float

    @property
    def as_recorded(self) -> bool:
        """Whether the verdict is the one on record."""
        return self.verdict in self.expected.split(" or ")

    def data(self) -> dict[str, Any]:
        """The row for a program."""
        return asdict(self)


def row(claim: Claim, reading: str, curve: str, finding: Finding, seconds: float) -> Row:
    """A finding held against the record.

    The record speaks of all curves. On one curve a claim that holds must be VERIFIED, unless it is vacuous there; one
    that fails in general may well hold there.
    """
    expected = claim.expected
    if curve:
        holds = expected in (PROVED, VERIFIED)
        expected = VERIFIED if holds else f"{REFUTED} or {VERIFIED}"
        if finding.witness == VACUOUS:
            expected = UNDECIDED
    statement = claim.statement + (" (as it must read)" if claim.as_meant else "")
    f = finding
    return Row(
        claim.id,
        claim.kind,
        claim.source,
        statement,
        claim.assumes,
        reading,
        curve,
        f.claimed,
        f.computed,
        f.factor,
        f.witness,
        f.verdict,
        expected,
        seconds,
    )
