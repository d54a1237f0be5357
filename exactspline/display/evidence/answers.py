"""Words for answers to questions about formulas, and for what a proof assistant says."""

from __future__ import annotations

from exactspline.display.evidence.dispatch import worded, words
from exactspline.display.numbers import EXACT, Numbers
from exactspline.verification.questions import Check, Proof
from exactspline.verification.verdict import Finding
from exactspline.verification.vocabulary import Verdict


def opinion(found: Finding) -> str:
    """What the kernel of a proof assistant says of a claim."""
    says = {Verdict.PROVED: "holds, ", Verdict.REFUTED: "fails, "}.get(found.verdict, "")
    return says + worded(found.witness or found.computed)


def _equation(left: str, factor: str, right: str) -> str:
    return f"{left} = {'' if factor == '1' else f'{factor} · '}{right}"


@words.register
def _(found: Proof, numbers: Numbers = EXACT) -> str:
    stated, where = _equation(found.left, found.factor, found.right), f"in R{found.dimension}"
    if found.holds:
        return f"{stated} for all curves {where}"
    if found.verdict == Verdict.VACUOUS:
        return f"{stated} says nothing {where}: {worded(found.finding.computed)}"
    different = "they differ" if found.roots else "they are not parallel"
    return f"not {stated} {where}: {different if found.quotient is None else f'the quotient is {found.quotient}'}"


@words.register
def _(found: Check, numbers: Numbers = EXACT) -> str:
    stated = _equation(found.left, found.factor, found.right)
    if found.vacuous:
        return f"{stated} says nothing on this curve: both sides are 0 there, or the factor is 1/0"
    return f"{stated} on this curve" if found.holds else f"not {stated} at the parameter {found.parameter}"
