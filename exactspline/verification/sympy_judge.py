"""A second judge: claims for all curves decided again by sympy, which shares no code with the jets."""

from __future__ import annotations

from exactspline.language.argument import Evaluated
from exactspline.language.kinds import kind_of
from exactspline.readings.sympy_expression import SympyReading
from exactspline.symbolic.factorization import without_denominator
from exactspline.verification.claim import Claim
from exactspline.verification.claim_factor import factor_formulas
from exactspline.verification.evidence import Fact
from exactspline.verification.kinds.identity import Identity
from exactspline.verification.verdict import UNDECIDED, Finding, worst
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
        cases = [(n, polynomial) for polynomial in claim.of.worlds for n in claim.dimensions]
        return worst([equality.decide(argument_for(claim, n, polynomial)) for n, polynomial in cases])


def argument_for(claim: Claim, dimension: int, polynomial: bool) -> Evaluated:
    """The argument of a formula in this reading."""
    kind = kind_of(claim.curve)
    if kind.adjoins_roots:
        factor = claim.factor if isinstance(claim, Identity) else "1"
        named = [*map(claim.find, claim.named), *factor_formulas(factor, claim.find)]
        polynomial = polynomial or without_denominator(named, factor, dimension)
    return SympyReading().argument(kind, dimension, polynomial=polynomial)
