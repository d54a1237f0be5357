"""What is wrong in an answer, as data; `exactspline.display.evidence` puts it into words."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from exactspline.classroom.parts import Point
from exactspline.hooks import Worded
from exactspline.numbers.exact import mpq
from exactspline.verification.questions import Proof
from exactspline.verification.vocabulary import Name


class Difference(Worded):
    """One thing that is wrong."""

    __slots__ = ()


class Entries(Enum):
    """What an answer is a list of."""

    NUMBERS = "number"
    POINTS = "point"
    POLYNOMIALS = "polynomial"


class Shape(Difference, Enum):
    """What is wrong with an answer that is not a number."""

    CIRCLE = "it is a circle"
    NOT_A_CIRCLE = "it is not a circle"
    REVERSED = "it is reversed"


@dataclass(frozen=True)
class OtherCount(Difference):
    """The answer has another number of entries."""

    of: Entries
    right: int
    given: int


@dataclass(frozen=True)
class OtherNumber(Difference, words="{name} is {right}, not {given}"):
    """A named number is wrong."""

    name: Name
    right: mpq
    given: mpq


@dataclass(frozen=True)
class OtherPoint(Difference, words="control point {index} is {right}, not {given}"):
    """The control point of an index, from 0, is wrong."""

    index: int
    right: Point
    given: Point


@dataclass(frozen=True)
class OtherCoefficient(Difference, words="{name}: the coefficient of t^{power} is {right}, not {given}"):
    """The coefficient of a power of t in a named polynomial is wrong."""

    name: Name
    power: int
    right: mpq
    given: mpq


@dataclass(frozen=True)
class OtherValue(Difference, words="{name}{name?: }at t = {at} it gives {given} instead of {right}"):
    """At a parameter the value (of a polynomial that has a name) is wrong."""

    at: mpq
    right: Point
    given: Point
    name: Name | None = None


@dataclass(frozen=True)
class Missing(Difference, words="t = {parameter} is missing"):
    """A parameter is missing."""

    parameter: mpq


@dataclass(frozen=True)
class Invented(Difference, words="t = {parameter} is not one of them"):
    """A parameter is not one of those asked for."""

    parameter: mpq


@dataclass(frozen=True)
class OtherCoordinates(Difference):
    """The points need this many coordinates."""

    right: int


@dataclass(frozen=True)
class OtherDimension(Difference, words="it is in R{given}, not in R{right}"):
    """The curve is in a space of another dimension."""

    right: int
    given: int


@dataclass(frozen=True)
class OtherDomain(Difference):
    """The curve has another domain."""

    right: tuple[mpq, mpq]
    given: tuple[mpq, mpq]


@dataclass(frozen=True)
class NotProved(Difference, words="{proof}"):
    """The formula is not the reference."""

    proof: Proof


@dataclass(frozen=True)
class OtherOnExample(Difference):
    """A formula differs from a factor (None: 1) times the reference at a parameter of an example curve; a value that
    does not exist there is None.
    """

    curve: Name
    at: mpq
    right: Point | None
    given: Point | None
    factor: Name | None = None
