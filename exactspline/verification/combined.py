"""The one verdict on a claim: its proof, compared with the examples."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from exactspline.errors import ClaimError, ExactSplineError
from exactspline.symbolic.factorization import speaking_of
from exactspline.verification.claim import Claim
from exactspline.verification.verdict import CONTRADICTION, REFUTED, VERIFIED, Finding, compared, undecided
from exactspline.verification.vocabulary import Name

V = TypeVar("V")


def combined(claim: Claim) -> tuple[Name, Finding]:
    """The one verdict on a claim: the proof for all curves, compared with every example curve to which it applies; a
    CONTRADICTION when it is proved and fails on one of them.
    """
    with speaking_of(claim.source_paper):
        return _combined(claim)


def fitting(claim: Claim, call: Callable[[], V]) -> V:
    """The result of a call that decides a claim. Raises `ClaimError` where formulas of users are not of the form that
    the claim requires; an exception from formulas of the library is a defect of the library.
    """
    try:
        return call()
    except ExactSplineError:
        raise
    except (
        TypeError,
        ValueError,
        AttributeError,
        LookupError,
        ArithmeticError,
        AssertionError,
        RecursionError,
    ) as error:
        if claim.source_paper.package:
            raise
        raise ClaimError(
            f"{type(error).__name__}: {' '.join(str(error).split())}",
            where=f"{claim.paper}, {claim.key}",
            remedy="the formulas are not of the form that the claim requires",
        ) from None


def _combined(claim: Claim) -> tuple[Name, Finding]:
    try:
        reading, finding = fitting(claim, claim.prove)
    except ExactSplineError as error:
        return claim.reading, undecided(error)
    if finding.verdict in (REFUTED, VERIFIED, CONTRADICTION):
        return reading, finding
    example_finding = fitting(claim, claim.refuted_on_examples)
    return reading, compared(finding, example_finding) if example_finding.verdict == REFUTED else finding
