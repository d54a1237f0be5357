"""Numbers in certificates: parsing of integers and fractions written as text, without using the library."""

from fractions import Fraction


def require(condition: bool, flaw: str) -> None:
    """Raise `ValueError` with the flaw unless a condition holds."""
    if not condition:
        raise ValueError(flaw)


def count(given: object) -> int:
    """A count, given as an integer."""
    if type(given) is not int:
        raise ValueError("not an integer, where one is counted")
    return given


def integer(given: object) -> int:
    """An integer written in decimal digits.

    >>> integer("-12")
    -12
    """
    text = _text(given)
    digits = text.removeprefix("-")
    require(digits.isascii() and digits.isdigit(), "a text that is not an integer")
    return -_value(digits) if text != digits else _value(digits)


def _text(given: object) -> str:
    if type(given) is not str:
        raise ValueError("a number that is not written as text")
    return given


def _value(digits: str) -> int:
    """The value of digits, converted in parts: Python does not convert thousands of digits in one step."""
    if len(digits) <= 600:
        return int(digits)
    half = len(digits) // 2
    return int(_value(digits[:-half]) * 10**half + _value(digits[-half:]))


def fraction(given: object) -> Fraction:
    """A fraction or an integer written in decimal digits.

    >>> fraction("2/6")
    Fraction(1, 3)
    """
    above, line, below = _text(given).partition("/")
    denominator = integer(below) if line else 1
    require(denominator > 0, "a denominator that is not positive")
    return Fraction(integer(above), denominator)
