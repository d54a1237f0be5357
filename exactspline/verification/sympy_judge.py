"""A second judge: claims for all curves decided once more by sympy, an algebra that shares nothing with the jets."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from time import perf_counter
from typing import Any

from exactspline.errors import ExactSplineError
from exactspline.geometry.ruled_surfaces import differences
from exactspline.language.arguments import DIMENSIONS, embedded
from exactspline.language.parts import split
from exactspline.papers import find
from exactspline.readings.sympy_expression import sympy_argument
from exactspline.verification.claim_factor import factor_of_text
from exactspline.verification.claims import Claim
from exactspline.verification.verdict import PROVED, REFUTED, UNDECIDED, VACUOUS, Finding, Row, row

READING = "sympy"


def tasks(claims: Iterable[Claim]) -> list[Callable[[], Row]]:
    """The claims that sympy can decide, as calls that give a row of the ledger each.

    >>> from exactspline.verification.claims import select
    >>> [(task().factor, task().verdict) for task in tasks(select(["C4.1a"]))]
    [('w', 'PROVED'), ('w^-3', 'PROVED')]
    """
    return [lambda claim=claim: judged(claim) for claim in claims if claim.kind in _DECIDED]


def judged(claim: Claim) -> Row:
    """A row of the ledger: the claim in every dimension that it speaks of; one that is refuted in one is refuted."""
    start = perf_counter()
    try:
        findings = [_DECIDED[claim.kind](claim, dimension) for dimension in DIMENSIONS[claim.curve]]
        finding = min(findings, key=lambda f: (REFUTED, UNDECIDED, PROVED).index(f.verdict))
    except ExactSplineError as error:
        finding = Finding(UNDECIDED, claim.factor, witness=str(error))
    return row(claim, READING, "", finding, perf_counter() - start)


def _argument(claim: Claim, dimension: int) -> Any:
    return sympy_argument(claim.curve, dimension, polynomial=claim.of == "polynomial")


def _identity(claim: Claim, dimension: int) -> Finding:
    """``left · bottom = right · top`` for the factor top/bottom, neither of them 0."""
    c = _argument(claim, dimension)
    left, right = split(find(claim.left)(c))[0], split(find(claim.right)(c))[0]
    top, bottom = factor_of_text(claim.factor, c)
    if top.is_zero or bottom.is_zero:
        return Finding(UNDECIDED, claim.factor, "the factor is 0 or 1/0", witness=VACUOUS)
    if all(x.is_zero for x in (*left, *right)):
        return Finding(UNDECIDED, claim.factor, "0 = 0", witness=VACUOUS)
    if len(left) != len(right):
        return Finding(REFUTED, claim.factor, f"{len(left)} components, and {len(right)}")
    for i, (a, b) in enumerate(zip(left, right, strict=True)):
        if not (a * bottom - b * top).is_zero:
            return Finding(REFUTED, claim.factor, "not identical", witness=f"component {i + 1} differs")
    return Finding(PROVED, claim.factor, claim.factor, claim.factor)


def _vanishing(claim: Claim, dimension: int) -> Finding:
    """Every component is zero."""
    for i, part in enumerate(split(find(claim.left)(_argument(claim, dimension)))[0]):
        if not part.is_zero:
            return Finding(REFUTED, "0", "not zero", witness=f"component {i + 1} is not zero")
    return Finding(PROVED, "0", "0")


def _same_surface(claim: Claim, dimension: int) -> Finding:
    """Parallel generators, neither of them 0, and directrices that differ along them."""
    c = _argument(claim, dimension)
    a, b = find(claim.left)(c), find(claim.right)(c)
    if any(surface.generator.is_zero for surface in (a, b)):
        return Finding(UNDECIDED, "one surface", "no surface: the generator vanishes", witness=VACUOUS)
    if all(part.is_zero for part in differences(a, b)):
        return Finding(PROVED, "one surface", "one surface")
    return Finding(REFUTED, "one surface", "two surfaces")


def _iso_curve(claim: Claim, dimension: int) -> Finding:
    """The plane curve is the directrix on the same curve in space."""
    c = _argument(claim, dimension)
    flat, directrix = find(claim.left)(c), find(claim.right)(embedded(c)).directrix
    agree = flat[0] == directrix[0] and flat[1] == directrix[1] and directrix[2].is_zero
    return Finding(PROVED if agree else REFUTED, "the curve ζ = 0", "the curve ζ = 0" if agree else "another curve")


_DECIDED: dict[str, Callable[[Claim, int], Finding]] = {
    "identity": _identity,
    "vanishing": _vanishing,
    "same surface": _same_surface,
    "iso-curve": _iso_curve,
}
