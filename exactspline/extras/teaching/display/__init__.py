"""Sheets, schemes and sentences of the lessons; importing it lets notebooks and messages show their objects."""

from __future__ import annotations

from exactspline.display.evidence import filled, words
from exactspline.display.numbers import EXACT, Numbers
from exactspline.errors import counted
from exactspline.extras.teaching import differences as wrong

# ---- the errors in an answer, in words


@words.register
def _(item: wrong.Difference, numbers: Numbers = EXACT) -> str:
    return filled(item.template, item, numbers)


@words.register
def _(item: wrong.OtherCount, numbers: Numbers = EXACT) -> str:
    return f"{counted(item.right, item.of.value)} required, not {item.given}"


@words.register
def _(item: wrong.OtherCoordinates, numbers: Numbers = EXACT) -> str:
    return f"points with {counted(item.right, 'coordinate')} are required"
