"""Rows of the ledger: findings compared with the record."""

from __future__ import annotations

from exactspline.verification.claim import Claim
from exactspline.verification.verdict import INAPPLICABLE, PROVED, REFUTED, UNDECIDED, VACUOUS, VERIFIED, Finding, Row
from exactspline.verification.vocabulary import Reason, Status


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
        f.reason or "",
        _expected(claim, curve, f, is_example) if curve else claim.expected,
        seconds,
    )


def _statement(claim: Claim) -> str:
    return claim.statement + (" (as it must read)" if claim.status == Status.MEANT else "")


def _expected(claim: Claim, curve: str, finding: Finding, is_example: bool) -> str:
    if finding.verdict == INAPPLICABLE:
        return INAPPLICABLE
    if finding.reason in (Reason.LEFT, Reason.SAMPLED):
        return UNDECIDED
    if (finding.verdict == VACUOUS and not is_example) or (is_example and curve in claim.vacuous):
        return VACUOUS
    return VERIFIED if claim.expected in (PROVED, VERIFIED) else f"{REFUTED} or {VERIFIED}"
