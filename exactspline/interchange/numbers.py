"""Reading and writing numbers in text formats: decimals are converted exactly, never through a float."""

from __future__ import annotations

import operator
import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from math import inf
from typing import TypeAlias

from exactspline.errors import CurveFileError, NumberError, ShapeError, counted, shown
from exactspline.interchange.records import LARGER, Limits
from exactspline.numbers.exact import decimal_places, from_float, is_float, isqrt, mpq, mpz, rational

_DECIMAL = re.compile(r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eEdD]([+-]?\d{1,9}))?", re.ASCII)
_WHOLE = re.compile(r"[+-]?\d{1,9}", re.ASCII)


def decimal(text: str, limits: Limits) -> mpq:
    """The exact value of a decimal; a Fortran exponent as in ``1.5D-3`` is allowed.

    >>> decimal("0.1", Limits()), decimal("-2.5D1", Limits())
    (mpq(1,10), mpq(-25,1))

    Raises `NumberError` for anything else, and for numbers beyond the limits.
    """
    if len(text) > limits.digits:
        raise NumberError(f"a number of {counted(len(text), 'character')}", remedy=f"at most {limits.digits} are read")
    match = _DECIMAL.fullmatch(text)
    if not match:
        raise NumberError(f"{shown(text)} is not a decimal number", remedy='decimals look like "1.5" or "-2E-3"')
    if match[1] and abs(int(match[1])) > limits.exponent:
        raise NumberError(f"{shown(text)} has an exponent beyond {limits.exponent}", remedy="scale the data")
    return rational(text.replace("D", "e").replace("d", "e") if match[1] else text)


def last_digit(text: str) -> mpq:
    """The value of a unit of the last digit of a decimal.

    >>> last_digit("1.50E3")
    mpq(10,1)
    """
    mantissa, _, exponent = text.upper().replace("D", "E").partition("E")
    return mpq(10) ** (int(exponent or 0) - len(mantissa.partition(".")[2]))


def whole(text: str) -> int:
    """A small integer; raises `NumberError` otherwise.

    >>> whole("12")
    12
    """
    if not _WHOLE.fullmatch(text):
        raise NumberError(f"{shown(text)} is not a small integer", remedy='integers look like "12"')
    return int(text)


def is_decimal(text: str) -> bool:
    """Whether the text is a decimal number."""
    return bool(_DECIMAL.fullmatch(text))


def square_root(value: mpq) -> mpq | None:
    """The non-negative rational square root, or None if the square root is irrational.

    >>> square_root(mpq(9, 4)), square_root(mpq(2))
    (mpq(3,2), None)
    """
    if value < 0:
        return None
    root = mpq(isqrt(value.numerator), isqrt(value.denominator))
    return root if root * root == value else None


def root_below(square: mpq, error: mpq) -> mpq:
    """A multiple of a power of two that is at most `error` below the square root of a number."""
    scale = mpz(1) << int(1 / error).bit_length()
    return mpq(isqrt(square.numerator * scale * scale // square.denominator), scale)


def finite_double(value: mpq) -> float:
    """The correctly rounded double; raises `NumberError` beyond the range of doubles.

    >>> finite_double(mpq(1, 3))
    0.3333333333333333
    """
    try:
        result = int(value.numerator) / int(value.denominator)
    except OverflowError:
        result = inf
    if result == inf or (result == 0 and value):
        raise NumberError("a number beyond the range of doubles", remedy="scale the curve")
    return result


def decimal_text(value: mpq) -> str | None:
    """The shorter of plain and exponent notation for a number with a finite decimal expansion, None for others.

    >>> decimal_text(mpq(-1, 8)), decimal_text(mpq(1200)), decimal_text(mpq(1, 10**9)), decimal_text(mpq(1, 3))
    ('-0.125', '1200', '1E-9', None)
    """
    if (places := decimal_places(value)) is None:
        return None
    digits = str(abs(value.numerator) * 10**places // value.denominator)
    sign = "-" if value < 0 else ""
    if places and len(digits) + 4 < places:
        return f"{sign}{digits[0]}{'.' if digits[1:] else ''}{digits[1:]}E{len(digits) - 1 - places}"
    digits = digits.rjust(places + 1, "0")
    return f"{sign}{digits[:-places]}.{digits[-places:]}" if places else sign + digits


def with_point(text: str) -> str:
    """The text of a number with a decimal point, as IGES and STEP require for reals.

    >>> with_point("3"), with_point("1E-9"), with_point("0.5")
    ('3.', '1.E-9', '0.5')
    """
    mantissa, mark, exponent = text.partition("E")
    return (mantissa if "." in mantissa else f"{mantissa}.") + mark + exponent


@dataclass
class NumberText:
    """The way in which a writer writes numbers: exactly or, if rounding was requested, as the nearest doubles.
    `rounded` counts the rounded numbers.

    >>> numbers = NumberText(rounding=True)
    >>> numbers(mpq(1, 8)), numbers(mpq(1, 3)), numbers.rounded
    ('0.125', '0.3333333333333333', 1)
    >>> NumberText()(mpq(1, 3))
    Traceback (most recent call last):
    exactspline.errors.NumberError: 1/3 has no finite decimal expansion; choose the format json, or ask for rounding
    """

    rounding: bool = False
    longest: int = 4_000
    rounded: int = field(default=0, init=False)

    def __call__(self, value: mpq) -> str:
        """The text of a number; raises `NumberError` if it cannot be exact and rounding was not requested."""
        text = decimal_text(value)
        if text is not None and len(text) <= self.longest:
            return text
        if not self.rounding:
            problem = f"takes {counted(len(text or ''), 'character')}, but this format allows {self.longest}"
            problem = problem if text else "has no finite decimal expansion"
            raise NumberError(f"{shown(str(value)).strip(chr(39))} {problem}", remedy=_REMEDY)
        self.rounded += 1
        return repr(finite_double(value)).replace("e", "E")

    def double(self, value: mpq) -> float:
        """The number as a double; raises `NumberError` if that is not exact and rounding was not requested."""
        result = finite_double(value)
        if mpq(*result.as_integer_ratio()) != value:
            if not self.rounding:
                raise NumberError(f"{shown(str(value)).strip(chr(39))} is not a double", remedy=_REMEDY)
            self.rounded += 1
        return result


_REMEDY = "choose the format json, or ask for rounding"


# ---- words and numbers of a file, one at a time


#: A word, or the contents of a pair of brackets.
Nested: TypeAlias = "str | list[Nested]"
_WORD = re.compile(r"\S+")


def nested(tokens: Iterable[str], brackets: str, limits: Limits, extra: Callable[[], object]) -> list[Nested]:
    """Words in brackets as lists of lists; `extra` is called for a bracket that closes nothing.

    >>> nested(["a", "(", "b", ")"], "()", Limits(), list)
    ['a', ['b']]
    """
    opened: list[list[Nested]] = [[]]
    for token in tokens:
        if token not in (brackets[0], brackets[1]):
            opened[-1].append(token)
        elif token == brackets[1]:
            opened.pop() if len(opened) > 1 else extra()
        elif len(opened) > limits.depth:
            raise CurveFileError("brackets are nested too deeply", remedy=LARGER)
        else:
            inner: list[Nested] = []
            opened[-1].append(inner)
            opened.append(inner)
    if len(opened) > 1:
        raise CurveFileError(f"{counted(len(opened) - 1, 'bracket')} not closed", remedy="balance the brackets")
    return opened[0]


class Tokens:
    """The words of a text from a position on, read lazily.

    >>> words = Tokens("2 0.5 x", Limits())
    >>> words.whole(), words.number(), words.word(), words.ended
    (2, mpq(1,2), 'x', True)
    """

    def __init__(self, text: str, limits: Limits, position: int = 0) -> None:
        self.text, self.limits = text, limits
        self._counted = (0, 1)
        self.move(position)

    def move(self, position: int) -> None:
        """Continue reading at a later position."""
        self._matches: Iterator[re.Match[str]] = _WORD.finditer(self.text, position)
        self._next = next(self._matches, None)
        self.position = position

    @property
    def ended(self) -> bool:
        """Whether all words have been read."""
        return self._next is None

    @property
    def line(self) -> int:
        """The line of the last word read."""
        start, line = self._counted
        self._counted = (self.position, line + self.text.count("\n", start, self.position))
        return self._counted[1]

    def word(self) -> str:
        """The next word; raises `CurveFileError` at the end."""
        if self._next is None:
            raise CurveFileError("the file ends too early", where=f"line {self.line}", remedy="complete the file")
        self.position = self._next.start()
        word = self._next[0]
        self._next = next(self._matches, None)
        return word

    def number(self) -> mpq:
        """The next word as an exact decimal."""
        return decimal(self.word(), self.limits)

    def numbers(self, count: int) -> list[mpq]:
        """The next `count` words as decimals."""
        return [self.number() for _ in range(self._checked(count))]

    def rows(self, count: int, length: int) -> list[list[mpq]]:
        """The next `count` rows of `length` decimals."""
        self._checked(count * length)
        return [self.numbers(length) for _ in range(count)]

    def whole(self) -> int:
        """The next word as a small integer."""
        return whole(self.word())

    def count(self) -> int:
        """The next word as a count."""
        return self._checked(self.whole())

    def _checked(self, count: int) -> int:
        if not 0 <= count <= self.limits.objects:
            remedy = f"it must be between 0 and {self.limits.objects}"
            raise ShapeError(f"a count of {count}", where=f"line {self.line}", remedy=remedy)
        return count


# ---- numbers of other libraries


#: A knot or a coefficient may be moved by this many units in the last place of the largest one.
MOST_ULPS = 8


def exact(value: object) -> mpq:
    """The exact value of a Python or numpy integer or float of any width, or of an exact number.

    >>> exact(3), exact(0.5)
    (mpq(3,1), mpq(1,2))

    Raises `NumberError` for NaN, infinities, complex numbers and objects that are not numbers.
    """
    if type(value) is int:
        return mpq(value)
    if isinstance(value, type(mpq())):
        return value
    if is_float(value):
        return from_float(value)
    try:
        return mpq(operator.index(value))  # type: ignore[arg-type]  # checked to be an integer
    except TypeError:
        raise NumberError(f"{shown(value)} is not a finite number", remedy="pass integers or floats") from None


def doubles(values: Iterable[mpq]) -> list[float]:
    """The correctly rounded doubles; raises `NumberError` beyond their range."""
    return [finite_double(value) for value in values]
