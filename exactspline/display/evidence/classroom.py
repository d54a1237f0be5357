"""Words for what is wrong in answers of students."""

from __future__ import annotations

from exactspline.classroom import differences as wrong
from exactspline.classroom.answers import shown
from exactspline.classroom.differences import Entries, Shape
from exactspline.classroom.parts import Point
from exactspline.display.evidence.dispatch import words
from exactspline.display.numbers import EXACT, Numbers
from exactspline.errors import counted
from exactspline.numbers.exact import text

ENTRIES = {Entries.NUMBERS: "number", Entries.POINTS: "point", Entries.POLYNOMIALS: "polynomial"}
SHAPES = {Shape.CIRCLE: "it is a circle", Shape.NOT_A_CIRCLE: "it is not a circle", Shape.REVERSED: "it is reversed"}


@words.register
def _(item: Shape, numbers: Numbers = EXACT) -> str:
    return SHAPES[item]


@words.register
def _(item: wrong.OtherCount, numbers: Numbers = EXACT) -> str:
    return f"{counted(item.right, ENTRIES[item.of])} required, not {item.given}"


@words.register
def _(item: wrong.OtherNumber, numbers: Numbers = EXACT) -> str:
    return f"{item.name} is {text(item.right)}, not {text(item.given)}"


@words.register
def _(item: wrong.OtherPoint, numbers: Numbers = EXACT) -> str:
    return f"control point {item.index} is {shown(item.right)}, not {shown(item.given)}"


@words.register
def _(item: wrong.OtherCoefficient, numbers: Numbers = EXACT) -> str:
    return f"{item.name}: the coefficient of t^{item.power} is {text(item.right)}, not {text(item.given)}"


@words.register
def _(item: wrong.OtherValue, numbers: Numbers = EXACT) -> str:
    of = f"{item.name}: " if item.name else ""
    return f"{of}at t = {text(item.at)} it gives {shown(item.given)} instead of {shown(item.right)}"


@words.register
def _(item: wrong.Missing, numbers: Numbers = EXACT) -> str:
    return f"t = {text(item.parameter)} is missing"


@words.register
def _(item: wrong.Invented, numbers: Numbers = EXACT) -> str:
    return f"t = {text(item.parameter)} is not one of them"


@words.register
def _(item: wrong.OtherCoordinates, numbers: Numbers = EXACT) -> str:
    return f"points with {counted(item.right, 'coordinate')} are required"


@words.register
def _(item: wrong.OtherDimension, numbers: Numbers = EXACT) -> str:
    return f"it is in R{item.given}, not in R{item.right}"


@words.register
def _(item: wrong.OtherDomain, numbers: Numbers = EXACT) -> str:
    here, there = (", ".join(map(text, domain)) for domain in (item.given, item.right))
    return f"its domain is [{here}], not [{there}]"


@words.register
def _(item: wrong.NotProved, numbers: Numbers = EXACT) -> str:
    return words(item.proof, numbers)


@words.register
def _(item: wrong.OtherOnExample, numbers: Numbers = EXACT) -> str:
    right = f"{item.factor} · {_value(item.right)}" if item.factor else _value(item.right)
    return f"on the example curve {item.curve} at t = {text(item.at)} it gives {_value(item.given)} instead of {right}"


def _value(value: Point | None) -> str:
    return "no value" if value is None else shown(value)
