"""Square roots of rational numbers: the exact values of curvatures and of lengths."""

from __future__ import annotations

from fractions import Fraction
from functools import total_ordering
from math import prod
from typing import TYPE_CHECKING

from exactspline.errors import NumberError
from exactspline.exact import Number, double_between, gcd, is_square, isqrt, mpq, mpz, text
from exactspline.language.immutable import Immutable, fill

if TYPE_CHECKING:
    from mpmath import mpf

_EXACT = (int, Fraction, type(mpz()), type(mpq()))


@total_ordering
class Surd(Immutable):
    """An irrational number ``a√b``, with rational a ≠ 0 and an integer b > 1 that is not a square.

    Made by `square_root`. Compares exactly with numbers of its kind and with rational ones, and is hashed accordingly;
    products and quotients with rational numbers are exact.

    >>> root = square_root(mpq(1, 8))
    >>> root, 4 * root, root**2, float(root), root < mpq(1, 2)
    (Surd(1/4, 2), Surd(1, 2), mpq(1,8), 0.3535533905932738, True)
    """

    __slots__ = ("coefficient", "radicand")
    coefficient: mpq
    radicand: int

    def __init__(self, coefficient: Number, radicand: int) -> None:
        a, b = mpq(coefficient), int(radicand)
        if a == 0 or b <= 1 or is_square(b):
            raise NumberError(
                f"{text(a)}√{b} is not an irrational number",
                remedy="use square_root, which returns rational roots as rational numbers",
            )
        fill(self, coefficient=a, radicand=b)

    def __reduce__(self) -> tuple[object, ...]:
        return Surd, (self.coefficient, self.radicand)

    @property
    def square(self) -> mpq:
        """Its square, a rational number."""
        return self.coefficient**2 * self.radicand

    @property
    def sign(self) -> int:
        """1 or −1."""
        return 1 if self.coefficient > 0 else -1

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Surd):
            return self.sign == other.sign and self.square == other.square
        return False if isinstance(other, _EXACT) else NotImplemented

    def __hash__(self) -> int:
        return hash((Surd, self.sign, self.square))

    def __lt__(self, other: object) -> bool:
        if isinstance(other, Surd):
            return _signed_square(self) < _signed_square(other)
        if isinstance(other, _EXACT):
            x = mpq(other)
            return _signed_square(self) < x * abs(x)
        return NotImplemented

    def __neg__(self) -> Surd:
        return Surd(-self.coefficient, self.radicand)

    def __abs__(self) -> Surd:
        return Surd(abs(self.coefficient), self.radicand)

    def __mul__(self, other: object) -> mpq | Surd:
        if isinstance(other, Surd):
            return square_root(self.square * other.square) * (self.sign * other.sign)
        if not isinstance(other, _EXACT):
            return NotImplemented
        return Surd(self.coefficient * mpq(other), self.radicand) if other else mpq(0)

    __rmul__ = __mul__

    def __truediv__(self, other: object) -> mpq | Surd:
        return self * (1 / mpq(other)) if isinstance(other, _EXACT) else NotImplemented

    def __pow__(self, exponent: int) -> mpq:
        if exponent != 2:
            return NotImplemented
        return self.square

    def enclosed(self, digits: int) -> tuple[mpq, mpq]:
        """Neighbouring multiples of ``10^−digits`` with the number between them.

        >>> square_root(mpq(2)).enclosed(3)
        (mpq(707,500), mpq(283,200))
        """
        scale = mpz(10) ** digits
        root = isqrt(mpz(self.square * scale**2))
        low, high = (root, root + 1) if self.sign > 0 else (-root - 1, -root)
        return mpq(low, scale), mpq(high, scale)

    def __float__(self) -> float:
        """The correctly rounded double."""
        return double_between(self.enclosed, lambda t: 1 if self > t else -1)

    def __repr__(self) -> str:
        return f"Surd({text(self.coefficient)}, {self.radicand})"

    def __str__(self) -> str:
        """``p√b/q``.

        >>> print(square_root(mpq(1, 8)), -square_root(mpq(2)), square_root(mpq(18, 25)))
        √2/4 -√2 3√2/5
        """
        p, q = self.coefficient.numerator, self.coefficient.denominator
        times = {1: "", -1: "-"}.get(int(p)) if abs(p) == 1 else text(mpq(p))
        return f"{times}√{self.radicand}" + (f"/{q}" if q != 1 else "")


#: Primes whose squares are removed from a radicand.
_PRIMES = [p for p in range(2, 1000) if all(p % q for q in range(2, int(isqrt(p)) + 1))]
_PRODUCT = prod(_PRIMES, start=mpz(1))


def square_root(q: mpq) -> mpq | Surd:
    """The square root of a rational number ≥ 0: rational, or a `Surd` without small square factors in its radicand.

    >>> square_root(mpq(9, 4)), square_root(mpq(12))
    (mpq(3,2), Surd(2, 3))

    Raises `NumberError` for a negative number.
    """
    if q < 0:
        raise NumberError(f"the square root of {text(q)}", remedy="give a number ≥ 0")
    n = mpz(q.numerator * q.denominator)
    if is_square(n):
        return mpq(isqrt(n), q.denominator)
    root = mpz(1)
    once = gcd(n, _PRODUCT)
    if (twice := gcd(once, n // once)) > 1:
        for prime in (p for p in _PRIMES if twice % p == 0):
            while n % (prime * prime) == 0:
                n, root = n // (prime * prime), root * prime
    return Surd(mpq(root, q.denominator), int(n))


def parts(number: mpq | Surd) -> tuple[mpq, int]:
    """The a and b of ``a√b``; b is 1 for a rational number.

    >>> parts(mpq(1, 2)), parts(square_root(mpq(12)))
    ((mpq(1,2), 1), (mpq(2,1), 3))
    """
    return (number.coefficient, number.radicand) if isinstance(number, Surd) else (number, 1)


def significant(number: mpq | Surd, digits: int) -> mpf:
    """A number as an mpmath number with a relative error below ``10^−digits``.

    >>> round(float(significant(square_root(mpq(2)), 20)), 6)
    1.414214
    """
    from mpmath import mp

    coefficient, radicand = parts(number)
    with mp.workdps(digits + 5):
        return mp.sqrt(radicand) * int(coefficient.numerator) / int(coefficient.denominator)


def _signed_square(x: Surd) -> mpq:
    return x.square * x.sign
