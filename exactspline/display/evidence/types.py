"""Words for evidence of types, and of what an equation speaks."""

from __future__ import annotations

from exactspline.display.evidence.dispatch import words
from exactspline.display.numbers import EXACT, Numbers
from exactspline.verification import evidence as e


@words.register
def _(found: e.OfType, numbers: Numbers = EXACT) -> str:
    return str(found.type)


@words.register
def _(found: e.TypeOnExample, numbers: Numbers = EXACT) -> str:
    where = f"on the example curve {found.curve}" if found.curve else "for cubic polynomials"
    why = f"; {words(e.Fact.MADE_BY_ARITHMETIC, numbers)}" if found.rational_everywhere else ""
    return f"{found.type} {where}{why}"


@words.register
def _(found: e.TypeHere, numbers: Numbers = EXACT) -> str:
    if found.special:
        return f"it is {found.type} on it, as it may be on special curves"
    return f"it is {found.type} on this curve"


@words.register
def _(found: e.SpeaksOf, numbers: Numbers = EXACT) -> str:
    return f"it speaks of {found.kind!r}"


@words.register
def _(found: e.SpeaksOfAnother, numbers: Numbers = EXACT) -> str:
    return f"{found.formula} is a formula of {found.kind!r}, not of {found.asked!r}"
