"""A second judge: claims for all curves decided once more by sympy, an algebra that shares nothing with the jets."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial, singledispatch
from time import perf_counter
from typing import Any

from exactspline.errors import ExactSplineError
from exactspline.language.arguments import embedded
from exactspline.language.kinds import kind_of
from exactspline.language.parts import split
from exactspline.language.ruled import differences
from exactspline.readings.sympy_expression import SympyReading
from exactspline.symbolic.factorization import without_denominator
from exactspline.verification.claim import Claim
from exactspline.verification.claim_factor import WEIGHTS, factor_of_text, factor_parts
from exactspline.verification.decision import Outcome, decide_identity
from exactspline.verification.kinds.identity import Identity, Vanishing
from exactspline.verification.kinds.surfaces import IsoCurve, SameSurface
from exactspline.verification.rows import row
from exactspline.verification.verdict import (
    PROVED,
    REFUTED,
    UNDECIDED,
    VACUOUS,
    Finding,
    Row,
    undecided,
    vacuous,
    worst,
)

#: The kinds of claims that it decides.
DECIDED = (Identity, Vanishing, SameSurface, IsoCurve)


def tasks(claims: Iterable[Claim]) -> list[Callable[[], Row]]:
    """The claims that sympy can decide, as calls that give a row of the ledger each.

    >>> from exactspline.verification.claims import select
    >>> [(task().factor, str(task().verdict)) for task in tasks(select(["C4.1a"]))]
    [('w', 'PROVED'), ('w^-3', 'PROVED')]
    """
    return [partial(judged, claim) for claim in claims if isinstance(claim, DECIDED)]


def judged(claim: Claim) -> Row:
    """A row of the ledger: the worst of all the cases, rational and polynomial curves of every dimension."""
    start = perf_counter()
    try:
        cases = [(n, polynomial) for polynomial in claim.of.worlds for n in claim.dimensions]
        finding = worst([decide(claim, _argument(claim, n, polynomial)) for n, polynomial in cases])
    except ExactSplineError as error:
        finding = undecided(claim.claims, error)
    return row(claim, SympyReading.name, "", finding, perf_counter() - start)


def _argument(claim: Claim, dimension: int, polynomial: bool) -> Any:
    kind = kind_of(claim.curve)
    if kind.adjoins_roots:
        factor = claim.factor if isinstance(claim, Identity) else "1"
        named = [*claim.named, *(name for name, _ in factor_parts(factor) if name[0].isalpha() and name not in WEIGHTS)]
        polynomial = polynomial or without_denominator([claim.find(name) for name in named], factor, dimension)
    return SympyReading().argument(kind, dimension, polynomial=polynomial)


@singledispatch
def decide(claim: Claim, c: object) -> Finding:
    """The finding of sympy on a claim for the indeterminate argument."""
    return Finding(UNDECIDED, claim.claims, witness="sympy does not decide this kind of claim")


@decide.register
def _(claim: Identity, c: Any) -> Finding:
    """``left = factor · right``."""
    factor = factor_of_text(claim.factor, c, claim.find)
    found = decide_identity(claim.find(claim.left)(c), claim.find(claim.right)(c), factor)
    if found.outcome is Outcome.EQUAL:
        return Finding(PROVED, claim.factor, claim.factor, claim.factor)
    if found.verdict(PROVED) == VACUOUS:
        return vacuous(claim.factor)
    told = "the factor is divided by zero" if found.outcome is Outcome.NO_FACTOR else "the sides differ"
    return Finding(REFUTED, claim.factor, "not identical", witness=f"{told}, component {found.component + 1}")


@decide.register
def _(claim: Vanishing, c: Any) -> Finding:
    """Every component is zero."""
    for i, part in enumerate(split(claim.find(claim.left)(c))[0]):
        if not part.is_zero:
            return Finding(REFUTED, "0", "not zero", witness=f"component {i + 1} is not zero")
    return Finding(PROVED, "0", "0")


@decide.register
def _(claim: SameSurface, c: Any) -> Finding:
    """Parallel generators, neither of them 0, and directrices that differ along them."""
    a, b = claim.find(claim.left)(c), claim.find(claim.right)(c)
    if any(surface.generator.is_zero for surface in (a, b)):
        return vacuous("one surface", "no surface: the generator vanishes")
    if all(part.is_zero for part in differences(a, b)):
        return Finding(PROVED, "one surface", "one surface")
    return Finding(REFUTED, "one surface", "two surfaces")


@decide.register
def _(claim: IsoCurve, c: Any) -> Finding:
    """The plane curve is the directrix on the same curve in space."""
    flat, directrix = claim.find(claim.left)(c), claim.find(claim.right)(embedded(c)).directrix
    agree = flat[0] == directrix[0] and flat[1] == directrix[1] and directrix[2].is_zero
    return Finding(PROVED if agree else REFUTED, "the curve ζ = 0", "the curve ζ = 0" if agree else "another curve")
