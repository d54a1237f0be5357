"""The errors in an answer: phrases, and what they are about."""

from __future__ import annotations

from enum import Enum, StrEnum

from exactspline.errors import counted
from exactspline.extras.teaching.parts import Point
from exactspline.numbers.exact import mpq
from exactspline.verification.evidence import Evidence, Phrase, Said
from exactspline.verification.questions import Proof
from exactspline.verification.vocabulary import Name


class Entries(StrEnum):
    """The kinds of entries in an answer."""

    NUMBERS = "number"
    POINTS = "point"
    POLYNOMIALS = "polynomial"


class Wrong(Evidence, Enum):
    """An error that is not about a number."""

    CIRCLE = "it is a circle"
    NOT_A_CIRCLE = "it is not a circle"
    REVERSED = "it is reversed"


#: One error in an answer.
Difference = Said | Wrong


@Phrase
def other_count(of: Entries, right: int, given: int) -> str:
    """The answer has another number of entries."""
    return f"{counted(right, of)} required, not {given}"


@Phrase
def other_number(name: Name, right: mpq, given: mpq) -> str:
    """A named number is wrong."""
    return f"{name} is {right}, not {given}"


@Phrase
def other_point(index: int, right: Point, given: Point) -> str:
    """The control point of an index, from 0, is wrong."""
    return f"control point {index} is {right}, not {given}"


@Phrase
def other_coefficient(name: Name, power: int, right: mpq, given: mpq) -> str:
    """The coefficient of a power of t in a named polynomial is wrong."""
    return f"{name}: the coefficient of t^{power} is {right}, not {given}"


@Phrase
def other_value(name: Name | None, at: mpq, right: Point, given: Point) -> str:
    """At a parameter the value (of a polynomial that has a name) is wrong."""
    return f"{f'{name}: ' if name else ''}at t = {at} it gives {given} instead of {right}"


@Phrase
def missing(parameter: mpq) -> str:
    """A parameter is missing."""
    return f"t = {parameter} is missing"


@Phrase
def invented(parameter: mpq) -> str:
    """A parameter is not one of those asked for."""
    return f"t = {parameter} is not one of them"


@Phrase
def other_coordinates(right: int) -> str:
    """The points need this many coordinates."""
    return f"points with {counted(right, 'coordinate')} are required"


@Phrase
def other_dimension(right: int, given: int) -> str:
    """The curve is in a space of another dimension."""
    return f"it is in R{given}, not in R{right}"


@Phrase
def other_domain(right: mpq, right_end: mpq, given: mpq, given_end: mpq) -> str:
    """The curve has another domain."""
    return f"its domain is [{given}, {given_end}], not [{right}, {right_end}]"


@Phrase
def not_proved(proof: Proof) -> str:
    """The formula is not the reference."""
    return str(proof)


@Phrase
def other_on_example(curve: Name, at: mpq, right: Point | None, given: Point | None, factor: Name | None) -> str:
    """A formula differs from a factor (None: 1) times the reference at a parameter of an example curve; a value that
    does not exist there is None.
    """
    expected = f"{f'{factor} · ' if factor else ''}{right or 'no value'}"
    return f"on the example curve {curve} at t = {at} it gives {given or 'no value'} instead of {expected}"
