"""Words for evidence about types, and about the arguments of an equation."""

from __future__ import annotations

from exactspline.display.evidence.dispatch import words
from exactspline.display.numbers import EXACT, Numbers
from exactspline.verification import evidence as e


@words.register
def _(item: e.OfType, numbers: Numbers = EXACT) -> str:
    return str(item.type)


@words.register
def _(item: e.TypeOnExample, numbers: Numbers = EXACT) -> str:
    where = f"on the example curve {item.curve}" if item.curve else "for cubic polynomials"
    why = f"; {words(e.Fact.MADE_BY_ARITHMETIC, numbers)}" if item.rational_everywhere else ""
    return f"{item.type} {where}{why}"


@words.register
def _(item: e.TypeHere, numbers: Numbers = EXACT) -> str:
    if item.special:
        return f"it is {item.type} on it, as it may be on special curves"
    return f"it is {item.type} on this curve"


@words.register
def _(item: e.SpeaksOf, numbers: Numbers = EXACT) -> str:
    return f"its arguments are of the kind {item.kind!r}"


@words.register
def _(item: e.SpeaksOfAnother, numbers: Numbers = EXACT) -> str:
    return f"{item.formula} is a formula of {item.kind!r}, not of {item.asked!r}"
