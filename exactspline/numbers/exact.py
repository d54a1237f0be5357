"""The only conversions of other numbers to ``gmpy2.mpq``, and between gmpy2 and FLINT.

gmpy2 accepts floats silently (``mpq(0.1)`` is a 55-bit number that nobody wrote, ``mpq(1, 3) + 0.5`` is an ``mpfr``),
so every number from a user passes through :func:`rational`, and no other code in the package makes an ``mpq`` from
input data. The package imports all names of gmpy2 from here, so that another implementation could replace it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from decimal import Decimal
from enum import StrEnum
from fractions import Fraction
from functools import reduce
from math import inf, isfinite, nextafter
from numbers import Integral, Rational, Real
from operator import add, mul
from typing import Any, SupportsIndex, TypeAlias, TypeGuard, cast, overload

import flint
from gmpy2 import gcd, iroot, is_square, isqrt, lcm, mpq, mpz

from exactspline.errors import NumberError, as_items, counted, shown
from exactspline.numbers.once import Immutable

__all__ = ["gcd", "iroot", "is_square", "isqrt", "lcm", "mpq", "mpz"]

#: The types that :func:`rational` accepts as exact numbers; ``SupportsIndex`` covers the integers of other libraries.
Number: TypeAlias = int | str | Fraction | Decimal | mpz | mpq | flint.fmpz | flint.fmpq | SupportsIndex

_RATIONAL = type(mpq())
_TYPES = {type(mpz()), int, Fraction}
#: Largest decimal or binary exponent read from text: a few characters with a larger one could exhaust the memory.
MAX_EXPONENT = 100_000
#: Longest text read as one number.
MAX_TEXT = 4_000_000

#: Maximal nesting depth of lists of numbers: rows of points of a surface have three levels.
DEEPEST = 8

#: Polynomials are compared modulo this prime before they are compared over the integers. It fits into 32 bits, the size
#: of an unsigned long on some platforms (such as WebAssembly).
PRIME = (1 << 31) - 1

#: More bits than a double, or the midpoint of two doubles, has.
ROOT_BITS = 64

_FRACTION = re.compile(r"\s*([+-]?\d+)\s*/\s*([+-]?\d+)\s*", re.ASCII)
_DECIMAL = re.compile(r"\s*([+-]?)(\d*)(?:\.(\d*))?(?:[eE]([+-]?\d{1,9}))?\s*", re.ASCII)
_HEX = re.compile(r"\s*([+-]?)0[xX]([0-9a-fA-F]*)(?:\.([0-9a-fA-F]*))?(?:[pP]([+-]?\d{1,9}))?\s*", re.ASCII)


def rational(value: Number) -> mpq:
    """Return the exact value of a number as a ``gmpy2.mpq``.

    The number may be an ``int``, a ``Fraction``, an ``mpz``, an ``mpq``, a finite ``Decimal``, FLINT's ``fmpz`` or
    ``fmpq``, an integer or a fraction of another library (such as numpy or sympy), or a text such as ``"3/4"``,
    ``"0.1"``, ``"1e-6"`` or the C99 hex float ``"0x1.8p-3"``.

    >>> rational("0.1"), rational("3/4"), rational("0x1.8p-3")
    (mpq(1,10), mpq(3,4), mpq(3,16))

    Raises `NumberError` for anything else: floats (also mpfr and numpy floats) are rejected, because the decimal that a
    float prints is not its value.

    >>> rational(0.1)  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    exactspline.errors.NumberError: 0.1 is a float, whose exact value is not what it shows; write "0.1" ...
    """
    given = cast(Any, value)  # compared by type, so that a bool, which is an int, is rejected
    kind = type(given)
    if kind is _RATIONAL:
        return cast(mpq, given)
    if kind in _TYPES:
        return mpq(given)
    if kind is str:
        return _from_text(given)
    if kind is Decimal:
        if not given.is_finite():
            raise NumberError(f"{value} is not a number", remedy="write a finite number")
        return _from_text(str(given))
    if kind in (flint.fmpq, flint.fmpz):
        return from_flint(given)
    if isinstance(value, Rational) and not isinstance(value, int):
        return mpq(int(given.numerator), int(given.denominator))
    if is_float(value):
        raise _refuse_float(given)
    name = f"{kind.__module__}.{kind.__qualname__}".removeprefix("builtins.")
    if hasattr(given, "refine") and hasattr(given, "exact"):
        raise NumberError(
            f"{shown(value)} is a root, which need not be rational",
            remedy="the function exactspline.evaluate takes one; root.exact is its rational value, if any",
        )
    several = isinstance(value, Iterable) and not isinstance(value, str | bytes)
    raise NumberError(
        f"{shown(value)} is of type {name}, which is not taken as an exact number", remedy=_MANY if several else _ONE
    )


_ONE = 'pass an int, a Fraction, an mpq, a Decimal or text such as "3/4" or "0.1"; √2 is exactspline.square_root(2)'
_MANY = (
    'pass an int, a Fraction or text; curve.floats(ts), curve.floats(ts, of="curvature") and so on evaluate at many '
    "parameters, exactspline.from_floats(rows) takes doubles as data"
)


def from_float(value: float) -> mpq:
    """The exact binary value of a Python or numpy float: the only way to convert a float.

    >>> from_float(0.5), from_float(0.1) == rational("0.1")
    (mpq(1,2), False)

    Raises `NumberError` for NaN, infinities and anything that is not a float.
    """
    if not is_float(value):
        raise NumberError(f"{shown(value)} is not a float", remedy="exact numbers go through rational()")
    if not isfinite(value):
        raise NumberError(f"{float(value)} has no exact value", remedy="write a finite number")
    return mpq(*map(int, value.as_integer_ratio()))


def is_float(value: object) -> TypeGuard[float]:
    """Whether an object is a Python or numpy float of any width.

    >>> is_float(0.5), is_float(1), is_float("0.5")
    (True, False, False)
    """
    return isinstance(value, float) or (
        isinstance(value, Real) and not isinstance(value, Rational | Decimal | Immutable)
    )


@overload
def from_floats(values: float, *, snap: bool = ...) -> mpq:
    """The exact value of a float."""


@overload
def from_floats(values: Iterable[float], *, snap: bool = ...) -> list[mpq]:
    """The exact values of floats in a sequence."""


@overload
def from_floats(values: Iterable[Iterable[float]], *, snap: bool = ...) -> list[list[mpq]]:
    """The exact values of rows of floats."""


def from_floats(
    values: float | Iterable[float] | Iterable[Iterable[float]], *, snap: bool = False
) -> mpq | list[mpq] | list[list[mpq]]:
    """Return the exact binary value of a float, of floats in a sequence, or of rows of floats such as control points.
    With `snap`, the value is the shortest decimal as which the float prints. Integers are unchanged.

    >>> from_floats(0.1) == rational("0.1"), from_floats(0.1, snap=True)
    (False, mpq(1,10))
    >>> from_floats([(0.5, 1.0), (0.25, -2.0)])
    [[mpq(1,2), mpq(1,1)], [mpq(1,4), mpq(-2,1)]]

    Raises `NumberError`, with the position, for an element that is neither a float nor an integer.
    """
    if type(values) is int:
        return rational(values)
    return _from_float(values, snap) if is_float(values) else _from_floats(values, DEEPEST, snap)


def _from_float(value: float, snap: bool) -> mpq:
    """The binary value of a float or, with `snap`, its shortest decimal."""
    return rational(str(value)) if snap and isfinite(value) else from_float(value)


def _from_floats(values: Any, depth: int, snap: bool) -> list[Any]:
    """The values of floats in nested sequences, up to a depth."""
    if depth == 0:
        raise NumberError(
            f"lists nested more than {DEEPEST} levels deep", remedy="give a list of floats, or of rows of floats"
        )
    given: Sequence[float | Iterable[float]] = [*as_items(values, "floats")]
    if not snap and all(type(x) is float and isfinite(x) for x in given):
        return [mpq(*cast(Any, x).as_integer_ratio()) for x in given]
    values_found: list[Any] = []
    for i, value in enumerate(given):
        try:
            if isinstance(value, Iterable) and not isinstance(value, str):
                values_found.append(_from_floats(value, depth - 1, snap))
            else:
                values_found.append(rational(value) if isinstance(value, Integral) else _from_float(value, snap))
        except NumberError as error:
            raise error.at(f"[{i}]") from None
    return values_found


class Rounding(StrEnum):
    """The rounding mode from a real number to a double."""

    #: To the nearest double, ties to even.
    NEAREST = "nearest"
    #: To the largest double not above the number, and to the smallest not below it.
    DOWN = "down"
    UP = "up"


def checked_rounding(rounding: str) -> Rounding:
    """The rounding mode with this name. Raises `NumberError`, which lists the modes, for an unknown one."""
    if type(rounding) is Rounding:
        return rounding
    if isinstance(rounding, str) and rounding in list(Rounding):
        return Rounding(rounding)
    raise NumberError(f"there is no rounding mode called {shown(rounding)}", remedy=f"{', '.join(Rounding)}")


def double(value: mpq, rounding: str = Rounding.NEAREST) -> float:
    """The correctly rounded double of a rational number.

    >>> double(mpq(1, 3)), double(mpq(1, 3), "up") - double(mpq(1, 3), "down") == 2.0**-54
    (0.3333333333333333, True)

    Raises `OverflowError` for a number beyond the largest double (unless it is rounded to that double), like ``float``
    of an int; `NumberError` for an unknown rounding mode.
    """
    return _finite(_rounded(value, checked_rounding(rounding)))


def double_root(sign: int, top: int, bottom: int, rounding: str = Rounding.NEAREST) -> float:
    """The correctly rounded double of ``±√(top/bottom)``, with the given sign: integers ``top ≥ 0`` and ``bottom > 0``.

    >>> double_root(1, 2, 1), double_root(-1, 1, 4), double_root(-1, 2, 1, "up") + double_root(1, 2, 1, "down")
    (1.4142135623730951, -0.5, 0.0)

    Raises the errors of `double`.
    """
    # enough bits, so that no rounding boundary is between two neighbouring integers
    shift = max(ROOT_BITS + (bottom.bit_length() - top.bit_length()) // 2, 0)
    whole, rest = divmod(top << (2 * shift), bottom)
    root = int(isqrt(whole))
    if rest or root * root != whole:
        root, shift = 2 * root + 1, shift + 1
    return double(mpq(sign * root, 1 << shift), rounding)


def double_between(
    enclosed: Callable[[int], tuple[mpq, mpq]], sign_above: Callable[[mpq], int], rounding: str = Rounding.NEAREST
) -> float:
    """The correctly rounded double of a real number.

    ``enclosed(digits)`` returns rational bounds of the number, at most ``10^−digits`` apart, and ``sign_above(t)`` the
    exact sign of the number minus t.

    >>> third = mpq(1, 3)
    >>> double_between(lambda digits: (third, third), lambda t: (third > t) - (third < t)) == 1 / 3
    True

    Raises the errors of `double`. Source: A. Ziv, Fast evaluation of elementary mathematical functions with correctly
    rounded last bit, ACM TOMS 1991; a number at a rounding boundary is decided exactly.
    """
    way, digits = checked_rounding(rounding), 20
    while True:
        low, high = (_rounded(end, way) for end in enclosed(digits))
        if low == high:
            # 0.0, not −0.0, if an enclosure contains both zeros
            return _finite(high)
        if nextafter(low, inf) == high:
            return _finite(_one_of(low, high, sign_above, way))
        digits *= 2


def _one_of(low: float, high: float, sign_above: Callable[[mpq], int], rounding: Rounding) -> float:
    """The one of two neighbouring doubles to which a number between them is rounded."""
    if rounding is Rounding.DOWN:
        return high if sign_above(_unrounded(high)) >= 0 else low
    if rounding is Rounding.UP:
        return low if sign_above(_unrounded(low)) <= 0 else high
    middle = (_unrounded(low) + _unrounded(high)) / 2
    side = sign_above(middle)
    return high if side > 0 else low if side < 0 else _rounded(middle, rounding)


def _rounded(value: mpq, rounding: Rounding) -> float:
    """The rounded double; beyond the largest double it is infinity or, if rounded towards zero, the largest double."""
    try:
        double_value = int(value.numerator) / int(value.denominator)
    except OverflowError:
        double_value = inf if value > 0 else -inf
    if rounding is Rounding.DOWN and (double_value == inf or _unrounded(double_value) > value):
        return nextafter(double_value, -inf)
    if rounding is Rounding.UP and (double_value == -inf or _unrounded(double_value) < value):
        return nextafter(double_value, inf)
    return double_value


def _unrounded(value: float) -> mpq:
    """The value of a double; infinity has the value that the next larger double would have."""
    if isfinite(value):
        return mpq(*value.as_integer_ratio())
    return mpq(2) ** 1024 * (1 if value > 0 else -1)


def _finite(value: float) -> float:
    if not isfinite(value):
        raise OverflowError("the number is too large for a float")
    return value


def to_fmpq(value: mpq | int) -> flint.fmpq:
    """An ``mpq`` (or int, ``mpz``) as FLINT's ``fmpq``.

    >>> to_fmpq(mpq(-3, 4))
    -3/4
    """
    return flint.fmpq(int(value.numerator), int(value.denominator))


def to_fmpz(value: int) -> flint.fmpz:
    """An ``mpz`` (or int) as FLINT's ``fmpz``.

    >>> to_fmpz(mpz(7))
    7
    """
    return flint.fmpz(int(value))


def ratio(numerator: flint.fmpz, denominator: flint.fmpz) -> mpq:
    """The quotient of two FLINT integers as an ``mpq``.

    >>> ratio(flint.fmpz(6), flint.fmpz(-4))
    mpq(-3,2)
    """
    return mpq(int(numerator), int(denominator))


def from_flint(value: flint.fmpq | flint.fmpz) -> mpq:
    """A rational number or an integer of FLINT as an ``mpq``.

    >>> from_flint(flint.fmpq(-3, 4)), from_flint(flint.fmpz(7))
    (mpq(-3,4), mpq(7,1))
    """
    return mpq(int(value.p), int(value.q)) if isinstance(value, flint.fmpq) else mpq(int(value))


def sign(value: mpq | mpz | int | flint.fmpz | flint.fmpq | flint.arb) -> int:
    """The sign, 1, −1 or 0, of an exact number of any library, or of the numbers in a ball, 0 if it contains 0.

    >>> sign(mpq(1, 2)), sign(flint.fmpz(-3)), sign(0), sign(flint.arb(1, 2))
    (1, -1, 0, 0)
    """
    return (value > 0) - (value < 0)


def scalar(a: Iterable[Any], b: Iterable[Any]) -> Any:
    """The scalar product of two vectors, whose components are numbers or operands.

    >>> scalar((1, 2), (3, 4))
    11
    """
    return reduce(add, map(mul, a, b))


def content(values: Iterable[mpq]) -> mpq:
    """The content of rational numbers that are not all 0: the positive number such that they are its multiples by
    coprime integers.

    >>> content([mpq(4, 3), mpq(-2)])
    mpq(2,3)
    """
    numbers = list(values)
    return mpq(gcd(*[x.numerator for x in numbers]), lcm(*[x.denominator for x in numbers]))


def primitive(vector: Iterable[mpq], *, oriented: bool = False) -> tuple[mpq, ...]:
    """The multiple of a vector with coprime integers; a zero vector is unchanged. The first nonzero integer is positive
    unless the vector is `oriented`; then the sense of the vector is kept.

    >>> primitive([mpq(0), mpq(-4, 3), mpq(2)]), primitive([mpq(-4, 3), mpq(2)], oriented=True)
    ((mpq(0,1), mpq(2,1), mpq(-3,1)), (mpq(-2,1), mpq(3,1)))
    """
    numbers = tuple(vector)
    sense = 1 if oriented else sign(next(filter(None, numbers), mpq(1)))
    unit = content(numbers) * sense or 1
    return tuple([x / unit for x in numbers])


def common_multiple(numbers: Iterable[flint.fmpz]) -> flint.fmpz:
    """The least common multiple of FLINT's integers; 1 if there are none.

    >>> common_multiple([flint.fmpz(4), flint.fmpz(6)])
    12
    """
    return reduce(flint.fmpz.lcm, numbers, flint.fmpz(1))


def common_divisor(numbers: Iterable[flint.fmpz]) -> flint.fmpz:
    """The greatest common divisor of FLINT's integers; 0 if there are none. Once it is 1, no more integers are
    computed.

    >>> common_divisor([flint.fmpz(4), flint.fmpz(6)])
    2
    """
    common = flint.fmpz(0)
    for x in numbers:
        common = common.gcd(x)
        if common == 1:
            break
    return common


def over_one_denominator(values: Iterable[mpq | int]) -> tuple[list[int], int]:
    """The numerators of rational numbers over their least common denominator, and this denominator.

    >>> over_one_denominator([mpq(1, 2), mpq(-2, 3)])
    ([3, -4], 6)
    """
    numbers = list(values)
    common = lcm(*[x.denominator for x in numbers])
    if common == 1:
        return [int(x.numerator) for x in numbers], 1
    return [int(x.numerator * (common // x.denominator)) for x in numbers], int(common)


def decimal_places(x: mpq) -> int | None:
    """The number of digits of a number after the decimal point; None if there are infinitely many.

    >>> decimal_places(mpq(3, 8)), decimal_places(mpq(7)), decimal_places(mpq(1, 3))
    (3, 0, None)
    """
    denominator, fives = x.denominator, 0
    while denominator % 5 == 0:
        denominator, fives = denominator // 5, fives + 1
    twos = denominator.bit_length() - 1
    return max(twos, fives) if denominator == 1 << twos else None


def decimal_unit(x: mpq) -> mpq:
    """The largest power of ten up to a positive number.

    >>> decimal_unit(mpq(125)), decimal_unit(mpq(1, 100)), decimal_unit(mpq(1, 300))
    (mpq(100,1), mpq(1,100), mpq(1,1000))
    """
    if x >= 1:
        return mpq(10) ** (len(str(x.numerator // x.denominator)) - 1)
    return mpq(1, 10 ** len(str(-(-x.denominator // x.numerator) - 1)))


def text(value: mpq | mpz | int) -> str:
    """The shortest exact text of an exact number, which :func:`rational` can read. The text can have any length,
    although Python does not convert an int of more than 4,300 digits.

    >>> text(mpq(3, 4)), text(mpq(-2)), len(text(10**5000))
    ('3/4', '-2', 5001)
    """
    return str(mpz(value) if type(value) is int else value)


def point_text(point: Sequence[mpq]) -> str:
    """A number, or a point in parentheses, as text.

    >>> point_text([mpq(1)]), point_text([mpq(1), mpq(1, 2)])
    ('1', '(1, 1/2)')
    """
    return text(point[0]) if len(point) == 1 else f"({', '.join(map(text, point))})"


def _refuse_float(value: float) -> NumberError:
    if not isfinite(value):
        return NumberError(f"{value} is not a number", remedy="write a finite number")
    return NumberError(
        f"{value} is a float, whose exact value is not what it shows",
        remedy=f'write "{value}" for the decimal, exactspline.from_floats({float(value)}) for the binary value; '
        f"curve.floats({float(value)}) evaluates there",
    )


def _from_text(value: str) -> mpq:
    if len(value) > MAX_TEXT:
        raise NumberError(f"a number of {counted(len(value), 'character')}", remedy=f"at most {MAX_TEXT} are read")
    if match := _FRACTION.fullmatch(value):
        numerator, denominator = mpz(match[1].lstrip("+")), mpz(match[2].lstrip("+"))
        if denominator == 0:
            raise NumberError(
                f"{value.strip()[:40]!r} has a zero denominator", remedy="write a fraction with a non-zero denominator"
            )
        return mpq(numerator, denominator)
    for pattern, radix, per_digit in ((_DECIMAL, 10, 1), (_HEX, 16, 4)):
        match = pattern.fullmatch(value)
        if match and (match[2] or match[3]):
            return _positional(match, radix, per_digit, value)
    raise NumberError(f"{value[:40]!r} is not a number", remedy='write for example "3/4", "-0.1", "1e-6" or "0x1.8p-3"')


def _positional(match: re.Match[str], radix: int, per_digit: int, value: str) -> mpq:
    whole, part = match[2] or "", match[3] or ""
    exponent = int(match[4] or 0)
    if abs(exponent) > MAX_EXPONENT:
        raise NumberError(f"{value.strip()[:40]!r} has an exponent beyond {MAX_EXPONENT}", remedy="scale the data")
    mantissa = mpz(whole + part, radix) * (-1 if match[1] == "-" else 1)
    exponent -= per_digit * len(part)
    scale = mpz(10 if radix == 10 else 2) ** abs(exponent)
    return mpq(mantissa * scale) if exponent >= 0 else mpq(mantissa, scale)
