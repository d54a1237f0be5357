"""Angles given as decimals in files. Only multiples of a right angle are accepted: of these, sine and cosine are
exactly known.
"""

from __future__ import annotations

from exactspline.errors import NumberError
from exactspline.interchange.limits import Limits
from exactspline.interchange.numbers import decimal
from exactspline.numbers.exact import mpq, rational

#: π/2 to 80 digits: more than any decimal in a file has.
_HALF_PI = rational("1.57079632679489661923132169163975144209858469968755291048747229615390820314310449")


def quarter_turns_of_degrees(degrees: mpq) -> int:
    """The number of right angles in an angle given in degrees.

    >>> quarter_turns_of_degrees(mpq(270))
    3

    Raises `NumberError` where this is not an integer.
    """
    turns = degrees / 90
    if turns.denominator != 1:
        raise NumberError("an angle that is not a multiple of 90 degrees", remedy="its sine or cosine is irrational")
    return int(turns)


def quarter_turns_of_radians(text: str) -> int:
    """The number of right angles in an angle given in radians as a decimal: the integer k such that k π/2 agrees with
    the decimal to its last digit, or to the precision of a double.

    >>> quarter_turns_of_radians("6.283185307179586"), quarter_turns_of_radians("3.14159")
    (4, 2)

    Raises `NumberError` where there is no such integer.
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
