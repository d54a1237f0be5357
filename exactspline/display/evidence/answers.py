"""Words for answers to questions about formulas, and for the results of a proof assistant."""

from __future__ import annotations

from exactspline.display.evidence.dispatch import worded, words
from exactspline.display.numbers import EXACT, Numbers
from exactspline.verification.questions import Check, Proof
from exactspline.verification.verdict import Finding
from exactspline.verification.vocabulary import Verdict


def opinion(item: Finding) -> str:
    """The result of a proof assistant's kernel for a claim."""
    says = {Verdict.PROVED: "holds, ", Verdict.REFUTED: "fails, "}.get(item.verdict, "")
    return says + worded(item.witness or item.computed)


def _equation(left: str, factor: str, right: str) -> str:
    return f"{left} = {'' if factor == '1' else f'{factor} · '}{right}"


@words.register
def _(item: Proof, numbers: Numbers = EXACT) -> str:
    stated, where = _equation(item.left, item.factor, item.right), f"in R{item.dimension}"
    if item.holds:
        return f"{stated} for all curves {where}"
    if item.verdict == Verdict.VACUOUS:
        return f"{stated} decides nothing {where}: {worded(item.finding.computed)}"
    different = "they differ" if item.roots else "they are not parallel"
    return f"not {stated} {where}: {different if item.quotient is None else f'the quotient is {item.quotient}'}"


@words.register
def _(item: Check, numbers: Numbers = EXACT) -> str:
    stated = _equation(item.left, item.factor, item.right)
    if item.vacuous:
        return f"{stated} does not apply to this curve: both sides are 0 there, or the factor is 1/0"
    return f"{stated} on this curve" if item.holds else f"not {stated} at the parameter {item.parameter}"
