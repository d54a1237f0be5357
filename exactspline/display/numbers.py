"""Readable exact numbers: a long fraction is shown as a decimal, or in full when asked for."""

from __future__ import annotations

import re

from exactspline.numbers.exact import mpq

_NUMBER = re.compile(r"(?<![\w/.])-?\d+/\d+(?![\w/.])|(?<![\w/.])-?\d{25,}(?![\w/.])")
_BETWEEN = re.compile(r"between the parameters (-?\d+(?:/\d+)?) and (-?\d+(?:/\d+)?)")
#: A number with more characters than this is shown as a decimal.
LONGEST = 14
#: Its significant digits.
DIGITS = 6


def decimals(text: str, digits: int = 0, *, exact: bool = False) -> str:
    """A text with its exact numbers made readable: a long one as a decimal (whole where `exact`), every one with so
    many digits beside it when asked for.

    >>> decimals("at the parameter 1/3", 5)
    'at the parameter 1/3 ≈ 0.33333'
    >>> decimals("differs by -37571202085457847/1220703125000000000")
    'differs by ≈ -0.0307783'
    >>> decimals("differs by -37571202085457847/1220703125000000000", exact=True)
    'differs by -37571202085457847/1220703125000000000'
    """

    def shown(match: re.Match[str]) -> str:
        if len(match[0]) <= LONGEST or exact:
            return f"{match[0]} ≈ {decimal(mpq(match[0]), digits)}" if digits else match[0]
        return f"≈ {decimal(mpq(match[0]), digits or DIGITS)}"

    return _NUMBER.sub(shown, text if exact else _BETWEEN.sub(_near, text))


def _near(match: re.Match[str]) -> str:
    """An isolating interval by the digits on which its ends agree; a wide one in full."""
    low, high = mpq(match[1]), mpq(match[2])
    if max(len(match[1]), len(match[2])) <= LONGEST:
        return match[0]
    digits = next((n for n in range(DIGITS, 1, -1) if decimal(low, n) == decimal(high, n)), 0)
    if digits:
        return f"near the parameter {decimal(low, digits)}"
    return f"between the parameters {decimal(low, DIGITS)} and {decimal(high, DIGITS)}"


def decimal(value: mpq, digits: int) -> str:
    """An exact number rounded to so many significant digits.

    >>> decimal(mpq(1, 3), 5)
    '0.33333'
    """
    from mpmath import mp

    with mp.workdps(digits + 5):
        return str(mp.nstr(mp.mpf(int(value.numerator)) / int(value.denominator), digits))


def decimal_milliseconds(seconds: float) -> str:
    """A time in milliseconds, to a tenth.

    >>> decimal_milliseconds(0.01234)
    '12.3'
    """
    return f"{1000 * seconds:.1f}"
