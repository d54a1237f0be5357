"""Square roots of rational numbers, and the angles between rational directions: exactly and to any number of digits."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from gmpy2 import isqrt, mpq, mpz

from exactspline.errors import NumberError
from exactspline.exact import text

#: Square factors below this are always taken out of a radicand.
TRIED = 1000


@dataclass(frozen=True, eq=False)
class Surd:
    """``coefficient · √radicand`` with a rational coefficient and a positive integer under the root.

    The radicand is 1 exactly where the number is rational; it is free of squares of primes below 1000.

    >>> print(square_root(mpq(8, 9)), square_root(mpq(1, 4)), -square_root(mpq(3)))
    2/3·√2 1/2 −√3
    """

    coefficient: mpq
    radicand: int = 1

    @property
    def exact(self) -> mpq | None:
        """The number itself where it is rational, else None."""
        return self.coefficient if self.radicand == 1 else None

    @property
    def sign(self) -> int:
        """−1, 0 or 1."""
        return int(self.coefficient > 0) - int(self.coefficient < 0)

    @property
    def squared(self) -> mpq:
        """Its square."""
        return self.coefficient * self.coefficient * mpq(self.radicand)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Surd) and (self.sign, self.squared) == (other.sign, other.squared)

    def __hash__(self) -> int:
        return hash((self.sign, self.squared))

    def __neg__(self) -> Surd:
        return Surd(-self.coefficient, self.radicand)

    def mpf(self, digits: int) -> Any:
        """An mpmath number that is relatively off by less than ``10^−digits``."""
        from mpmath import mp

        with mp.workdps(digits + 5):
            q = self.coefficient
            return mp.sqrt(self.radicand) * int(q.numerator) / int(q.denominator)

    def __str__(self) -> str:
        q = self.coefficient
        if self.radicand == 1 or q == 0:
            return text(q).replace("-", "−")
        front = {1: "", -1: "−"}.get(int(q)) if q.denominator == 1 else None
        return f"{text(q)}·√{self.radicand}".replace("-", "−") if front is None else f"{front}√{self.radicand}"


def square_root(q: mpq) -> Surd:
    """The square root of a rational number that is not negative; `NumberError` for a negative one.

    >>> square_root(mpq(12))
    Surd(coefficient=mpq(2,1), radicand=3)
    """
    if q < 0:
        raise NumberError(f"the square root of {text(q)}", remedy="give a number that is not negative")
    if q == 0:
        return Surd(mpq(0))
    n, root = mpz(q.numerator * q.denominator), mpq(1, q.denominator)
    whole = isqrt(n)
    if whole * whole == n:
        return Surd(root * whole)
    for prime in range(2, TRIED):
        while n % (prime * prime) == 0:
            n, root = n // (prime * prime), mpq(root * prime)
    whole = isqrt(n)
    return Surd(root * whole) if whole * whole == n else Surd(root, int(n))


@dataclass(frozen=True)
class Angle:
    """The angle between two directions by its cosine and sine, exactly; in the plane positive to the left.

    In space it is without a sign: between 0° and 180°.

    >>> angle = angle_between((mpq(1), mpq(0)), (mpq(1), mpq(-1)))
    >>> print(angle.cosine, angle.sine, angle.degrees(10))
    1/2·√2 −1/2·√2 -45.0
    """

    cosine: Surd
    sine: Surd

    def degrees(self, digits: int) -> Any:
        """The angle in degrees, in (−180, 180], as an mpmath number to so many significant digits."""
        from mpmath import mp

        with mp.workdps(digits + 10):
            turned = mp.atan2(self.sine.mpf(digits + 10), self.cosine.mpf(digits + 10))
            if self.sine.sign == 0 or self.cosine.sign == 0:
                return mp.mpf(int(mp.nint(turned * 180 / mp.pi)))
            return +(turned * 180 / mp.pi)


def angle_between(a: Sequence[mpq], b: Sequence[mpq]) -> Angle:
    """The angle from one direction to another, neither of them zero.

    >>> print(angle_between((mpq(1), mpq(0), mpq(0)), (mpq(0), mpq(0), mpq(2))).sine)
    1
    """
    lengths = _dot(a, a) * _dot(b, b)
    product = _dot(a, b)
    across = lengths - product * product
    sine = square_root(across / lengths)
    if len(a) == 2 and a[0] * b[1] < a[1] * b[0]:
        sine = -sine
    cosine = square_root(product * product / lengths)
    return Angle(-cosine if product < 0 else cosine, sine)


def _dot(a: Sequence[mpq], b: Sequence[mpq]) -> mpq:
    return sum((x * y for x, y in zip(a, b, strict=True)), start=mpq(0))
