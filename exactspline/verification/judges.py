"""Judges: provers that share no code decide the same claims; if one proves what another refutes, a contradiction is
reported.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import partial
from time import perf_counter
from typing import Protocol

from exactspline.errors import ClaimError, ExactSplineError, nearest
from exactspline.language.arguments import Evaluated
from exactspline.language.kinds import kind_of
from exactspline.readings.sympy_expression import SympyReading
from exactspline.symbolic.factorization import without_denominator
from exactspline.verification.claim import Claim
from exactspline.verification.combined import Proofs, fitting
from exactspline.verification.coq_judge import Coq
from exactspline.verification.evidence import Fact, JudgesDisagree
from exactspline.verification.kinds.equality import Identity
from exactspline.verification.ledger import Task
from exactspline.verification.notation import factor_formulas
from exactspline.verification.rows import Row, row
from exactspline.verification.verdict import CONTRADICTION, PROVED, REFUTED, UNDECIDED, Finding, undecided, worst_case
from exactspline.verification.vocabulary import Name


class Sympy:
    """The judge that decides equalities in expressions of sympy.

    >>> from exactspline.verification.claims import select
    >>> [str(Sympy().decide(claim).verdict) for claim in select(["C4.1a", "C4.2g"])]
    ['PROVED', 'PROVED', 'UNDECIDED']
    """

    name = Name(SympyReading.name)

    def decide(self, claim: Claim) -> Finding:
        """The worst finding over all cases: rational and polynomial curves of every dimension."""
        equality = claim.equality
        if equality is None:
            return Finding(UNDECIDED, witness=Fact.NOT_OF_THIS_JUDGE)
        return worst_case(
            lambda polynomial, n: equality.decide(argument_for(claim, n, polynomial)), claim.of.worlds, claim.dimensions
        )


def argument_for(claim: Claim, dimension: int, polynomial: bool) -> Evaluated:
    """The argument of a formula in this reading."""
    kind = kind_of(claim.curve)
    if kind.adjoins_roots:
        factor = claim.factor if isinstance(claim, Identity) else "1"
        named = [*map(claim.find, claim.named), *factor_formulas(factor, claim.find)]
        polynomial = polynomial or without_denominator(named, factor, dimension)
    return SympyReading().argument(kind, dimension, polynomial=polynomial)


class Judge(Protocol):
    """A prover that decides a claim for all arguments: the jets of this library, sympy, the kernel of Coq."""

    @property
    def name(self) -> Name:
        """Its name."""

    def decide(self, claim: Claim) -> Finding:
        """The finding; UNDECIDED where the judge does not handle claims of this kind."""


#: The judges other than the ledger's.
OTHERS: dict[str, type[Sympy | Coq]] = {"sympy": Sympy, "coq": Coq}


def judge_named(name: str) -> Sympy | Coq:
    """Another judge.

    Raises `ClaimError` with the existing names.
    """
    if name not in OTHERS:
        raise ClaimError(f"there is no judge called {name!r}", remedy=nearest(name, OTHERS))
    return OTHERS[name]()


def agreed(own: Finding, first: Name, other: Finding, second: Name) -> Finding:
    """The finding of a judge, compared with that of another one: a CONTRADICTION where one proves what the other one
    refutes.

    >>> from exactspline.verification.verdict import UNDECIDED
    >>> one, two = Name("one"), Name("two")
    >>> print(agreed(Finding(PROVED), one, Finding(REFUTED), two).witness)
    proved by one, but refuted by two
    >>> str(agreed(Finding(PROVED), one, Finding(UNDECIDED), two).verdict)
    'PROVED'
    """
    opposed = {own.verdict, other.verdict} == {PROVED, REFUTED}
    if not opposed:
        return own
    proved, refuted = (first, second) if own.verdict == PROVED else (second, first)
    witness = own.witness if own.verdict == REFUTED else other.witness
    return replace(own, verdict=CONTRADICTION, witness=JudgesDisagree(proved, refuted, witness))


def second_opinions(judge: Judge, claims: Iterable[Claim]) -> list[Task]:
    """The claims that state an equality, as calls that each return the row of another judge, compared with the jets.

    >>> from exactspline.verification.claims import select
    >>> [(str(task().factor), str(task().verdict)) for task in second_opinions(Sympy(), select(["C4.1a"]))]
    [('w', 'PROVED'), ('w⁻³', 'PROVED')]
    """
    proofs = Proofs()
    return [partial(judged, judge, claim, proofs) for claim in claims if claim.equality is not None]


def judged(judge: Judge, claim: Claim, proofs: Proofs) -> Row:
    """The row of a judge, a CONTRADICTION where the proof of the ledger decides the opposite."""
    start = perf_counter()
    try:
        finding = fitting(claim, partial(judge.decide, claim))
    except ExactSplineError as error:
        finding = undecided(error)
    seconds, (reading, proof) = perf_counter() - start, proofs[claim]
    return row(claim, judge.name, agreed(finding, judge.name, proof, reading), seconds)


def compared_rows(rows: Sequence[Row], judge: Judge) -> list[Row]:
    """Rows for all curves compared with the findings of another judge; those on single curves are returned
    unchanged.
    """
    return [
        each
        if each.curve
        else replace(each, finding=agreed(each.finding, each.reading, judge.decide(each.claim), judge.name))
        for each in rows
    ]
