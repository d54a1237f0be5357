"""Findings: a verdict, the reason why nothing was decided, the computed value, and a witness. All of them are data, not
sentences.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from itertools import product

from exactspline.errors import ExactSplineError, InapplicableError, ReachError
from exactspline.one_line import OneLine
from exactspline.verification import phrases as say
from exactspline.verification.evidence import Evidence, Fact, Found, HeldOn, Stopped
from exactspline.verification.vocabulary import Name, Reason, Relation, Verdict

PROVED, VERIFIED, REFUTED, UNDECIDED = Verdict.PROVED, Verdict.VERIFIED, Verdict.REFUTED, Verdict.UNDECIDED
VACUOUS, INAPPLICABLE, CONTRADICTION = Verdict.VACUOUS, Verdict.INAPPLICABLE, Verdict.CONTRADICTION
NOT_ASKED = Verdict.NOT_ASKED


class ContradictionError(ExactSplineError):
    """The error for a claim that is proved for all curves and refuted on one of them: one of these results is wrong."""


@dataclass(frozen=True, repr=False)
class Finding(OneLine):
    """The result of one check: computed value, factor, witness and verdict, before it is compared with the record.

    ``relation`` is the relation that was decided, ``assumptions`` are the names of the assumptions that the decision
    uses, and ``reason`` says why nothing was decided.
    """

    verdict: Verdict
    computed: Found | None = None
    factor: Found | None = None
    witness: Evidence | None = None
    relation: Relation = Relation.EQUAL
    assumptions: tuple[Name, ...] = ()
    reason: Reason | None = None


def undecided(error: ExactSplineError) -> Finding:
    """The finding after an error: undecided, or for errors of these types inapplicable or a contradiction."""
    contradiction, outside = isinstance(error, ContradictionError), isinstance(error, InapplicableError)
    verdict = CONTRADICTION if contradiction else INAPPLICABLE if outside else UNDECIDED
    return Finding(verdict, witness=Stopped(error), reason=Reason.COST if isinstance(error, ReachError) else None)


def left(why: Evidence) -> Finding:
    """The finding on a curve that is not tried, since the proof for all curves decides the claim."""
    return Finding(UNDECIDED, witness=say.left_to_the_proof(why), reason=Reason.LEFT)


def sampled(finding: Finding, part: Evidence, stopped_by: ExactSplineError | None = None) -> Finding:
    """The finding that a claim holds on the part that was tried: undecided."""
    return replace(finding, verdict=UNDECIDED, witness=HeldOn(part, stopped_by), reason=Reason.SAMPLED)


def vacuous(computed: Evidence = Fact.NOTHING, factor: Found | None = None) -> Finding:
    """The finding that there is nothing to decide: both sides vanish, or do not exist on a whole segment."""
    return Finding(VACUOUS, computed, factor)


def inapplicable(why: Evidence, computed: Found | None = None, relation: Relation = Relation.EQUAL) -> Finding:
    """The finding that the claim does not apply to this curve, with the reason."""
    return Finding(INAPPLICABLE, computed, witness=why, relation=relation)


def worst(findings: list[Finding]) -> Finding:
    """The least favourable finding: a contradiction before a refutation, then undecided, then verified on the curves
    tried.
    """
    order = (CONTRADICTION, REFUTED, UNDECIDED, INAPPLICABLE, VACUOUS, VERIFIED, PROVED)
    return min(findings, key=lambda finding: order.index(finding.verdict))


def worst_case(decide: Callable[..., Finding], *choices: Iterable[object]) -> Finding:
    """The least favourable finding over all combinations of choices. An error in one combination is raised unless
    another combination refutes the claim.
    """
    findings, errors = [], []
    for case in product(*choices):
        try:
            findings.append(decide(*case))
        except ExactSplineError as error:
            errors.append(error)
    found = worst(findings) if findings else None
    if found is None or (errors and found.verdict not in (REFUTED, CONTRADICTION)):
        raise errors[0]
    return found


def compared(proof: Finding, refutation: Finding) -> Finding:
    """A refutation on one curve, compared with a proof for all curves: if there is such a proof, it is a CONTRADICTION,
    because one of the two is wrong.
    """
    if proof.verdict != PROVED:
        return refutation
    return replace(refutation, verdict=CONTRADICTION, witness=say.refutes(refutation.witness))
