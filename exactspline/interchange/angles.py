"""Angles given as decimals in files. Only of multiples of a right angle sine and cosine are exactly known; near any
other angle there is one of which both are rational.
"""

from __future__ import annotations

from flint import arb, ctx

from exactspline.errors import NumberError
from exactspline.interchange.limits import Limits
from exactspline.interchange.numbers import decimal
from exactspline.numbers.exact import mpq, rational, to_fmpq
from exactspline.numbers.intervals import ball_ends

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


def turn_near(degrees: mpq, within: mpq) -> tuple[mpq, mpq]:
    """The cosine and sine, both rational, of an angle that differs from one in degrees by at most this many radians.

    >>> cosine, sine = turn_near(mpq(120), mpq(1, 1000))
    >>> cosine**2 + sine**2 == 1, abs(cosine + mpq(1, 2)) < mpq(1, 1000)
    (True, True)
    """
    turns = int((degrees / 90 + mpq(1, 2)) // 1)
    t = _half_tangent(degrees - 90 * turns, within / 2)
    cosine, sine = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    for _ in range(turns % 4):
        cosine, sine = -sine, cosine
    return cosine, sine


def _half_tangent(degrees: mpq, error: mpq) -> mpq:
    """The tangent of half of an angle, off by at most an error: the angle 2 atan t then is by at most twice that."""
    bits = int(1 / error).bit_length() + 8
    while True:
        with ctx.workprec(bits):
            ends = ball_ends((arb.pi() * arb(to_fmpq(degrees / 360))).tan())
        if ends.width <= error:
            return (ends.low + ends.high) / 2
        bits *= 2


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
