"""Angles that files give as decimals, where they are multiples of a right angle; only there are sine and cosine both
rational.
"""

from __future__ import annotations

from exactspline.errors import NumberError
from exactspline.interchange.limits import Limits
from exactspline.interchange.numbers import decimal
from exactspline.numbers.exact import mpq, rational

#: π/2 to 80 digits: longer than any such decimal in a file.
_HALF_PI = rational("1.57079632679489661923132169163975144209858469968755291048747229615390820314310449")


def quarter_turns_of_degrees(degrees: mpq) -> int:
    """How many right angles.

    >>> quarter_turns_of_degrees(mpq(270))
    3

    Raises `NumberError` where it is not an integer of them.
    """
    turns = degrees / 90
    if turns.denominator != 1:
        raise NumberError("an angle that is not a multiple of 90 degrees", remedy="its sine or cosine is irrational")
    return int(turns)


def quarter_turns_of_radians(text: str) -> int:
    """How many right angles a decimal means: the multiple of π/2 that it is rounded from, by its own last digit or as a
    double.

    >>> quarter_turns_of_radians("6.283185307179586"), quarter_turns_of_radians("3.14159")
    (4, 2)

    Raises `NumberError` where it is not such a number.
    """
    value = decimal(text, Limits())
    if not value:
        return 0
    mantissa, _, exponent = text.upper().replace("D", "E").partition("E")
    last_digit = mpq(10) ** (int(exponent or 0) - len(mantissa.partition(".")[2]))
    turns = (2 * value / _HALF_PI + 1) // 2
    slack = max(last_digit, mpq(1, 2**50))
    if abs(value - turns * _HALF_PI) > slack or slack > mpq(1, 10_000):
        raise NumberError("an angle that is not a multiple of π/2", remedy="its sine or cosine is irrational")
    return int(turns)
