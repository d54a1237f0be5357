"""The ledger: one row per claim, reading and curve."""

from __future__ import annotations

from dataclasses import asdict, dataclass, replace

from exactspline.errors import ExactSplineError, InapplicableError
from exactspline.hooks import Displayed
from exactspline.verification.vocabulary import Reason, Relation, Status, Verdict

PROVED, VERIFIED, REFUTED, UNDECIDED = Verdict.PROVED, Verdict.VERIFIED, Verdict.REFUTED, Verdict.UNDECIDED
VACUOUS, INAPPLICABLE, CONTRADICTION = Verdict.VACUOUS, Verdict.INAPPLICABLE, Verdict.CONTRADICTION
#: How `witness` begins where a claim is decided for all alone.
LEFT = "left to the proof for all: "
#: How `witness` begins where a claim holds on the part on which it was tried.
SAMPLED = "it holds, but was tried on a part only: "
#: Why a curve of lower degree decides nothing about the generic one.
LOWER_HERE = "the degree is lower on it, as it may be on special ones"
#: Why a count says nothing of a patch of low degree.
NO_DERIVATIVES = "its degree is lower than the order of a derivative"


class ContradictionError(ExactSplineError):
    """Two readings contradict each other: proved for all curves, and refuted on one of them. One of them is wrong."""


@dataclass(frozen=True)
class Finding:
    """What one check found: computed value, factor, witness and verdict, before it is compared with the record.

    ``relation`` is the one that was decided, ``assumptions`` the names of those that the decision rests on, ``reason``
    tells why nothing was decided.
    """

    verdict: Verdict
    claimed: str = ""
    computed: str = ""
    factor: str = ""
    witness: str = ""
    relation: Relation = Relation.EQUAL
    assumptions: tuple[str, ...] = ()
    reason: Reason | None = None


def undecided(claimed: str, error: ExactSplineError) -> Finding:
    """Undecided because of an error; inapplicable, or a contradiction, where the error says so."""
    contradiction, outside = isinstance(error, ContradictionError), isinstance(error, InapplicableError)
    verdict = CONTRADICTION if contradiction else INAPPLICABLE if outside else UNDECIDED
    return Finding(verdict, claimed, witness=str(error))


def left(claimed: str, why: str) -> Finding:
    """Not tried on this curve: the proof for all decides it."""
    return Finding(UNDECIDED, claimed, witness=LEFT + why, reason=Reason.LEFT)


def sampled(found: Finding, part: str) -> Finding:
    """A finding that something holds, where it was tried on a part only: no verdict."""
    return replace(found, verdict=UNDECIDED, witness=SAMPLED + part, reason=Reason.SAMPLED)


def vacuous(claimed: str, computed: str = "0 = 0", factor: str = "") -> Finding:
    """Nothing to decide: both sides vanish, or do not exist on a whole segment."""
    return Finding(VACUOUS, claimed, computed, factor)


def inapplicable(claimed: str, why: str, computed: str = "", relation: Relation = Relation.EQUAL) -> Finding:
    """The claim does not speak of this curve, for a reason."""
    return Finding(INAPPLICABLE, claimed, computed, witness=why, relation=relation)


def worst(found: list[Finding]) -> Finding:
    """The least favourable finding: a contradiction, a refutation, then what is not decided, then what holds on the
    curves tried.
    """
    order = (CONTRADICTION, REFUTED, UNDECIDED, INAPPLICABLE, VACUOUS, VERIFIED, PROVED)
    return min(found, key=lambda finding: order.index(finding.verdict))


def compared(proof: Finding, refutation: Finding) -> Finding:
    """A refutation on one curve, compared with the proof for all: a CONTRADICTION where there is one, because one of
    the two is wrong.
    """
    if proof.verdict != PROVED:
        return refutation
    return replace(
        refutation, verdict=CONTRADICTION, witness=f"proved for all curves, but refuted: {refutation.witness}"
    )


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
    reason: str
    expected: str
    seconds: float

    @property
    def as_recorded(self) -> bool:
        """Whether the verdict is the one on record."""
        return self.verdict in self.expected.split(" or ")

    def data(self) -> dict[str, object]:
        """The row as data."""
        return asdict(self)
