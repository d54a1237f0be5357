"""Second verifiers: provers that share no code decide the same claims. If one proves a claim that another refutes, a
contradiction is reported.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from functools import partial
from typing import Protocol, cast

from exactspline import hooks
from exactspline.errors import ClaimError, ExactSplineError, nearest
from exactspline.language.arguments import Evaluated
from exactspline.language.kinds import kind_of
from exactspline.polynomials.cost import within_seconds
from exactspline.readings.sympy_expression import SympyReading
from exactspline.symbolic.factorization import without_denominator
from exactspline.verification import phrases as say
from exactspline.verification.claim import Claim
from exactspline.verification.combined import fitting
from exactspline.verification.evidence import Fact
from exactspline.verification.kinds.equality import Identity
from exactspline.verification.ledger import Row
from exactspline.verification.notation import factor_formulas
from exactspline.verification.verdict import CONTRADICTION, PROVED, REFUTED, UNDECIDED, Finding, undecided, worst_case
from exactspline.verification.vocabulary import Extent, Name


class Sympy:
    """The verifier that decides equalities in expressions of sympy.

    >>> from exactspline.verification.claims import select
    >>> [str(Sympy().decide(claim).verdict) for claim in select(["C4.1a", "C4.2g"])]
    ['PROVED', 'PROVED', 'UNDECIDED']
    """

    name = column = Name(SympyReading.name)

    def __init__(self, claims: Iterable[Claim] = ()) -> None:
        """Make the verifier, which decides every claim by itself."""

    def decide(self, claim: Claim) -> Finding:
        """The worst finding over all cases: rational and polynomial curves of every dimension."""
        equality = claim.equality
        if equality is None or claim.on == Extent.CURVE:
            return Finding(UNDECIDED, witness=Fact.NOT_OF_THIS_JUDGE)
        return worst_case(
            lambda polynomial, n: equality.decide(argument_for(claim, n, polynomial)), claim.of.worlds, claim.dimensions
        )


def argument_for(claim: Claim, dimension: int, polynomial: bool) -> Evaluated:
    """The argument of a formula in expressions of sympy."""
    kind = kind_of(claim.curve)
    if kind.adjoins_roots:
        factor = claim.factor if isinstance(claim, Identity) else "1"
        named = [*map(claim.find, claim.named), *factor_formulas(factor, claim.find_in_factor)]
        polynomial = polynomial or without_denominator(named, factor, dimension)
    return SympyReading().argument(kind, dimension, polynomial=polynomial)


class Judge(Protocol):
    """A prover that decides a claim for all arguments: the jets of this library, sympy, the kernel of Coq."""

    @property
    def name(self) -> Name:
        """The name of the verifier."""

    @property
    def column(self) -> Name:
        """The heading of the column of its verdicts."""

    def decide(self, claim: Claim) -> Finding:
        """The finding; UNDECIDED if the verifier does not handle claims of this kind."""


#: The second verifiers, by name: the place of the class, or a function that makes one.
_others: dict[str, str | Callable[[Sequence[Claim]], Judge]] = {
    "sympy": "exactspline.verification.judges:Sympy",
    "coq": "exactspline.extras.coq.judge:Coq",
}


def add_judge(name: str, make: Callable[[Sequence[Claim]], Judge]) -> None:
    """Add a verifier for ``prove --judge NAME``. It is constructed with the claims that it has to decide."""
    _others[name] = make


def judge_named(name: str, claims: Sequence[Claim] = ()) -> Judge:
    """The second verifier with this name, for these claims.

    Raises `ClaimError` with the existing names.
    """
    if name not in _others:
        raise ClaimError(f"there is no judge called {name!r}", remedy=nearest(name, _others))
    made = _others[name]
    return cast(Judge, (hooks.named(made) if isinstance(made, str) else made)(claims))


def agreed(own: Finding, first: Name, other: Finding, second: Name) -> Finding:
    """The finding of a verifier, compared with that of another one: a CONTRADICTION if one proves a claim that the
    other one refutes.

    >>> from exactspline.verification.verdict import UNDECIDED
    >>> one, two = Name("one"), Name("two")
    >>> print(agreed(Finding(PROVED), one, Finding(REFUTED), two).witness)
    proved by one, but refuted by two
    >>> str(agreed(Finding(PROVED), one, Finding(UNDECIDED), two).verdict)
    'PROVED'
    """
    if {own.verdict, other.verdict} != {PROVED, REFUTED}:
        return own
    proved, refuted = (first, second) if own.verdict == PROVED else (second, first)
    witness = own.witness if own.verdict == REFUTED else other.witness
    return replace(own, verdict=CONTRADICTION, witness=say.judges_disagree(proved, refuted, witness))


def second_opinion(judge: Judge, own: Row, limit: int | None = None) -> Row:
    """A row for all curves with the finding of another verifier: a CONTRADICTION if one proves the claim and the other
    refutes it. A row on a single curve is returned unchanged, since other verifiers decide only for all curves. A claim
    that takes more than `limit` seconds of processor time is undecided.

    >>> from exactspline.verification.claims import select
    >>> from exactspline.verification.ledger import decide
    >>> claim = select(["C4.1a"])[0]
    >>> str(second_opinion(Sympy(), decide(claim)).second.verdict)
    'PROVED'
    """
    if own.curve:
        return own
    try:
        with within_seconds(limit):
            second = fitting(own.claim, partial(judge.decide, own.claim))
    except ExactSplineError as error:
        second = undecided(error)
    return replace(own, finding=agreed(own.finding, own.reading, second, judge.name), second=second)
