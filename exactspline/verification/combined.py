"""The proofs of one run, and the one verdict on a claim: its proof, compared with the examples."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TypeVar

from exactspline.errors import ClaimError, ExactSplineError
from exactspline.numbers.once import while_set
from exactspline.papers import papers
from exactspline.papers.folder import Paper
from exactspline.polynomials.cost import Budget, drawing_on
from exactspline.symbolic.factorization import SharedJets, named_by, sharing
from exactspline.verification.claim import Claim
from exactspline.verification.evaluation import sharing_evaluations
from exactspline.verification.evidence import Stopped
from exactspline.verification.verdict import CONTRADICTION, REFUTED, VERIFIED, Finding, compared, undecided
from exactspline.verification.vocabulary import Name

V = TypeVar("V")
#: The evaluation mode in which a claim was decided, and the finding.
Decided = tuple[Name, Finding]


class Proofs:
    """The proofs of one run, each computed once, and the verdicts that follow from them and the examples."""

    def __init__(self) -> None:
        self._made: dict[tuple[Paper, Claim], Decided] = {}
        self._combined: dict[tuple[Paper, Claim], Decided] = {}
        self._jets: SharedJets = {}

    def __getstate__(self) -> object:
        """The state for another process: without indeterminate curves, and without papers that are not in the
        library.
        """
        state = {name: {k: found for k, found in own.items() if k[0] in papers()} for name, own in vars(self).items()}
        return state | {"_jets": {}}

    def update(self, other: Proofs) -> None:
        """Take over the proofs of another run of the same engine."""
        self._made |= other._made
        self._combined |= other._combined

    def __contains__(self, claim: Claim) -> bool:
        """Whether a claim has been decided in this run."""
        return (claim.source_paper, claim) in self._made

    def take(self, claim: Claim, decided: Decided) -> None:
        """Take over how a claim was decided in an earlier run."""
        self._made[claim.source_paper, claim] = decided

    def __getitem__(self, claim: Claim) -> Decided:
        """The evaluation mode in which a claim is decided for all curves, and the finding."""
        key = claim.source_paper, claim
        if key not in self._made:
            with sharing(self._jets), named_by(claim.source_paper):
                try:
                    self._made[key] = fitting(claim, claim.prove)
                except ExactSplineError as error:
                    self._made[key] = claim.reading, undecided(error)
        return self._made[key]

    def combined(self, claim: Claim) -> Decided:
        """The proof, compared with every example to which the claim applies."""
        key = claim.source_paper, claim
        if key not in self._combined:
            reading, finding = proof = self[claim]
            if finding.verdict not in (REFUTED, VERIFIED, CONTRADICTION) and not isinstance(finding.witness, Stopped):
                with sharing(self._jets), named_by(claim.source_paper):
                    refuted = fitting(claim, lambda: claim.refuted_on_examples(lambda: proof))
                finding = compared(finding, refuted) if refuted.verdict == REFUTED else finding
            self._combined[key] = reading, finding
        return self._combined[key]


_RUN: ContextVar[Proofs | None] = ContextVar("the proofs of this run", default=None)


@contextmanager
def computed_once(proofs: Proofs | None = None) -> Iterator[None]:
    """A context in which the verdicts on many claims share their computations: verdicts, the indeterminate curves of
    proofs, and the values of formulas on the example curves. A nested context is the same as the outer one. The context
    begins with `proofs`, if they are given.
    """
    if _RUN.get() is not None:
        yield
        return
    with while_set(_RUN, proofs or Proofs()), sharing_evaluations():
        yield


def proofs_of_this_run() -> Proofs:
    """The proofs that are shared inside `computed_once`; new ones outside."""
    return _RUN.get() or Proofs()


def combined(claim: Claim) -> Decided:
    """The one verdict on a claim: the proof for all curves, compared with every example curve to which it applies; a
    CONTRADICTION when it is proved and fails on one of them.

    >>> from exactspline.verification.claims import select
    >>> first = select(["C4.1a"])[0]
    >>> with computed_once():
    ...     combined(first) is combined(first), str(combined(first)[1].verdict)
    (True, 'PROVED')
    """
    return proofs_of_this_run().combined(claim)


#: The errors of Python for a value of a formula that does not have the form that a claim requires.
NOT_FITTING = (TypeError, ValueError, AttributeError, LookupError, ArithmeticError, AssertionError, RecursionError)


def fitting(claim: Claim, call: Callable[[], V]) -> V:
    """The result of a call that decides a claim. The whole call has one budget, since many cheap products may be
    expensive together. Raises `ClaimError` for formulas of users that do not have the form that the claim requires; an
    exception from formulas of the library is a defect of the library.
    """
    try:
        with drawing_on(Budget()):
            return call()
    except ExactSplineError:
        raise
    except NOT_FITTING as error:
        if claim.source_paper.package:
            raise
        raise ClaimError(
            f"{type(error).__name__}: {' '.join(str(error).split())}",
            where=f"{claim.paper}, {claim.key}",
            remedy="the formulas are not of the form that the claim requires",
        ) from None
