"""The ledger: one row per claim, reading and curve."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING

from exactspline.errors import ExactSplineError, InapplicableError
from exactspline.language.services import Displayed
from exactspline.verification.vocabulary import Relation, Status, Verdict

if TYPE_CHECKING:
    from exactspline.verification.claim import Claim

PROVED, VERIFIED, REFUTED, UNDECIDED = Verdict.PROVED, Verdict.VERIFIED, Verdict.REFUTED, Verdict.UNDECIDED
#: What `witness` says where both sides vanish: no success, and no failure either.
VACUOUS = "vacuous: 0 = 0, or 0/0 on a whole segment"
#: How `witness` begins where the claim does not apply to a curve.
OUTSIDE = "the claim says nothing of this curve: "
#: How `witness` begins where a claim is decided for all alone.
LEFT = "left to the proof for all: "
#: Why a curve of lower degree decides nothing about the generic one.
LOWER_HERE = "the degree is lower on it, as it may be on special ones"
#: Why a count says nothing of a patch of low degree.
NO_DERIVATIVES = "its degree is lower than the order of a derivative"


class ContradictionError(ExactSplineError):
    """Two readings contradict each other: proved for all curves, and refuted on one of them. One of them is wrong."""


@dataclass(frozen=True)
class Finding:
    """What one check found: computed value, factor, witness and verdict, before it is compared with the record.

    ``relation`` is the one that was decided, ``assumptions`` the names of those that the decision rests on.
    """

    verdict: Verdict
    claimed: str = ""
    computed: str = ""
    factor: str = ""
    witness: str = ""
    relation: Relation = Relation.EQUAL
    assumptions: tuple[str, ...] = ()

    @property
    def is_vacuous(self) -> bool:
        """Whether nothing was decided because there is nothing to decide."""
        return self.verdict == UNDECIDED and self.witness == VACUOUS

    @property
    def is_outside(self) -> bool:
        """Whether nothing was decided because the claim does not speak of the curve."""
        return self.verdict == UNDECIDED and self.witness.startswith(OUTSIDE)

    @property
    def is_left(self) -> bool:
        """Whether it was not tried to decide anything here."""
        return self.verdict == UNDECIDED and self.witness.startswith(LEFT)


def undecided(claimed: str, error: ExactSplineError) -> Finding:
    """Undecided because of an error; inapplicable where the error says so."""
    outside = OUTSIDE if isinstance(error, InapplicableError) else ""
    return Finding(Verdict.UNDECIDED, claimed, witness=f"{outside}{error}")


def vacuous(claimed: str, computed: str = "0 = 0", factor: str = "") -> Finding:
    """Nothing to decide."""
    return Finding(UNDECIDED, claimed, computed, factor, VACUOUS)


@dataclass
class Row(Displayed):
    """A line of the ledger."""

    id: str
    key: str
    paper: str
    status: Status
    kind: str
    source: str
    statement: str
    assumes: str
    assumptions: list[str]
    reading: str
    curve: str
    relation: Relation
    claimed: str
    computed: str
    factor: str
    witness: str
    verdict: Verdict
    expected: str
    seconds: float

    @property
    def as_recorded(self) -> bool:
        """Whether the verdict is the one on record."""
        return self.verdict in self.expected.split(" or ")

    def data(self) -> dict[str, object]:
        """The row as data."""
        return asdict(self)


def row(claim: Claim, reading: str, curve: str, finding: Finding, seconds: float, *, is_example: bool = False) -> Row:
    """A finding compared with the record. The record is about all curves. On one curve a claim that holds must be
    VERIFIED, unless it is vacuous there, which is on record for the example curves; one that fails in general may well
    hold there.
    """
    f = finding
    return Row(
        claim.id,
        claim.key,
        claim.paper,
        claim.status,
        claim.kind,
        claim.source,
        _statement(claim),
        claim.assumed,
        list(f.assumptions),
        reading,
        curve,
        f.relation,
        f.claimed,
        f.computed,
        f.factor,
        f.witness,
        f.verdict,
        _expected(claim, curve, f, is_example) if curve else claim.expected,
        seconds,
    )


def _statement(claim: Claim) -> str:
    return claim.statement + (" (as it must read)" if claim.status == Status.MEANT else "")


def _expected(claim: Claim, curve: str, finding: Finding, is_example: bool) -> str:
    undecided_here = finding.is_outside or finding.is_left
    if undecided_here or (finding.is_vacuous and not is_example) or (is_example and curve in claim.vacuous):
        return UNDECIDED
    return VERIFIED if claim.expected in (PROVED, VERIFIED) else f"{REFUTED} or {VERIFIED}"
