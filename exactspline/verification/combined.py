"""The one verdict on a claim: its proof, compared with the examples."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import partial
from typing import TypeVar

from exactspline.errors import ClaimError, ExactSplineError
from exactspline.papers.folder import Paper
from exactspline.symbolic.factorization import sharing, speaking_of
from exactspline.verification.claim import Claim
from exactspline.verification.evaluation import sharing_evaluations
from exactspline.verification.verdict import CONTRADICTION, REFUTED, VERIFIED, Finding, compared, undecided
from exactspline.verification.vocabulary import Name

V = TypeVar("V")
Combined = tuple[Name, Finding]
_KNOWN: ContextVar[dict[tuple[Paper, Claim], Combined] | None] = ContextVar("known verdicts", default=None)


@contextmanager
def computed_once() -> Iterator[None]:
    """A context in which the verdicts on many claims share what they compute: each verdict, the indeterminate curves of
    proofs, the values of formulas on the example curves; within one there is no other.
    """
    if _KNOWN.get() is not None:
        yield
        return
    token = _KNOWN.set({})
    try:
        with sharing({}), sharing_evaluations():
            yield
    finally:
        _KNOWN.reset(token)


def combined(claim: Claim) -> Combined:
    """The one verdict on a claim: the proof for all curves, compared with every example curve to which it applies; a
    CONTRADICTION when it is proved and fails on one of them.

    >>> from exactspline.verification.claims import select
    >>> first = select(["C4.1a"])[0]
    >>> with computed_once():
    ...     combined(first) is combined(first), str(combined(first)[1].verdict)
    (True, 'PROVED')
    """
    known, key = _KNOWN.get(), (claim.source_paper, claim)
    if known is not None and key in known:
        return known[key]
    with speaking_of(claim.source_paper):
        found = _combined(claim)
    if known is not None:
        known[key] = found
    return found


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


def _combined(claim: Claim) -> Combined:
    try:
        reading, finding = fitting(claim, claim.prove)
    except ExactSplineError as error:
        return claim.reading, undecided(error)
    if finding.verdict in (REFUTED, VERIFIED, CONTRADICTION):
        return reading, finding
    example_finding = fitting(claim, partial(claim.refuted_on_examples, lambda: (reading, finding)))
    return reading, compared(finding, example_finding) if example_finding.verdict == REFUTED else finding
