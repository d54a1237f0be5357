"""The errors in an answer, as data; `exactspline.display.evidence` puts them into words."""

from __future__ import annotations

from enum import Enum
from typing import ClassVar

from exactspline.extras.teaching.parts import Point
from exactspline.hooks import WordedData
from exactspline.numbers.exact import mpq
from exactspline.verification.questions import Proof
from exactspline.verification.vocabulary import Name


class Difference(WordedData):
    """One error in an answer; its `hint` does not contain the right value."""

    hint: ClassVar[str] = ""

    def __init_subclass__(cls, words: str = "", hint: str = "") -> None:
        super().__init_subclass__(words)
        cls.hint = hint


class Entries(Enum):
    """The kinds of entries in an answer."""

    NUMBERS = "number"
    POINTS = "point"
    POLYNOMIALS = "polynomial"


class Wrong(Difference, Enum, words="{value}"):
    """An error that is not about a number."""

    CIRCLE = "it is a circle"
    NOT_A_CIRCLE = "it is not a circle"
    REVERSED = "it is reversed"


class OtherCount(Difference):
    """The answer has another number of entries."""

    of: Entries
    right: int
    given: int


class OtherNumber(Difference, words="{name} is {right}, not {given}", hint="{name} is not {given}"):
    """A named number is wrong."""

    name: Name
    right: mpq
    given: mpq


class OtherPoint(
    Difference, words="control point {index} is {right}, not {given}", hint="control point {index} is not {given}"
):
    """The control point of an index, from 0, is wrong."""

    index: int
    right: Point
    given: Point


class OtherCoefficient(
    Difference,
    words="{name}: the coefficient of t^{power} is {right}, not {given}",
    hint="{name}: the coefficient of t^{power} is not {given}",
):
    """The coefficient of a power of t in a named polynomial is wrong."""

    name: Name
    power: int
    right: mpq
    given: mpq


class OtherValue(
    Difference,
    words="{name}{name?: }at t = {at} it gives {given} instead of {right}",
    hint="{name}{name?|it} is not {given} at t = {at}",
):
    """At a parameter the value (of a polynomial that has a name) is wrong."""

    at: mpq
    right: Point
    given: Point
    name: Name | None = None


class Missing(Difference, words="t = {parameter} is missing", hint="a parameter is missing"):
    """A parameter is missing."""

    parameter: mpq


class Invented(Difference, words="t = {parameter} is not one of them"):
    """A parameter is not one of those asked for."""

    parameter: mpq


class OtherCoordinates(Difference):
    """The points need this many coordinates."""

    right: int


class OtherDimension(Difference, words="it is in R{given}, not in R{right}"):
    """The curve is in a space of another dimension."""

    right: int
    given: int


class OtherDomain(Difference, words="its domain is [{given:, }], not [{right:, }]"):
    """The curve has another domain."""

    right: tuple[mpq, mpq]
    given: tuple[mpq, mpq]


class NotProved(Difference, words="{proof}"):
    """The formula is not the reference."""

    proof: Proof


class OtherOnExample(
    Difference,
    words="on the example curve {curve} at t = {at} it gives {given?{given}|no value} instead of {factor?{factor} · }"
    "{right?{right}|no value}",
):
    """A formula differs from a factor (None: 1) times the reference at a parameter of an example curve; a value that
    does not exist there is None.
    """

    curve: Name
    at: mpq
    right: Point | None
    given: Point | None
    factor: Name | None = None
