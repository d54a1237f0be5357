"""Intervals with rational ends around a real number: rounding, quotients, square roots, FLINT's balls, decimals."""

from __future__ import annotations

from itertools import takewhile
from typing import NamedTuple

from flint import arb

from exactspline.numbers.exact import isqrt, mpq, mpz, rational, to_fmpq


class Bounds(NamedTuple):
    """Rational bounds of a real number, which is between them or one of them."""

    low: mpq
    high: mpq

    @property
    def width(self) -> mpq:
        """Their distance."""
        return self.high - self.low

    @property
    def middle(self) -> mpq:
        """The middle, off by at most half the width."""
        return (self.low + self.high) / 2


def rounded_outwards(b: Bounds, digits: int) -> Bounds:
    """The nearest multiples of ``10^−digits`` below and above.

    >>> rounded_outwards(Bounds(mpq(1, 3), mpq(1, 2)), 1)
    Bounds(low=mpq(3,10), high=mpq(1,2))
    """
    scale = mpz(10) ** digits
    return Bounds(mpq((b.low * scale) // 1, scale), mpq(-((-b.high * scale) // 1), scale))


def quotient(a: Bounds, b: Bounds) -> Bounds:
    """Bounds of a quotient whose denominator is not zero.

    >>> quotient(Bounds(mpq(-1), mpq(2)), Bounds(mpq(1), mpq(4)))
    Bounds(low=mpq(-1,1), high=mpq(2,1))
    """
    ends = [x / y for x in a for y in b]
    return Bounds(min(ends), max(ends))


def root_of(b: Bounds, digits: int) -> Bounds:
    """Bounds of the square root of a quantity that is not negative, multiples of ``10^−digits``.

    >>> root_of(Bounds(mpq(2), mpq(2)), 2)
    Bounds(low=mpq(141,100), high=mpq(71,50))
    """
    scale = mpz(10) ** digits
    low, high = (isqrt(mpz((max(x, mpq(0)) * scale**2) // 1)) for x in b)
    return Bounds(mpq(low, scale), mpq(high + 1, scale))


def ball_ends(ball: arb) -> Bounds:
    """The ends of a ball, exactly.

    >>> ball_ends(arb("1.5"))
    Bounds(low=mpq(3,2), high=mpq(3,2))
    """
    middle, radius = (_dyadic(*part.man_exp()) for part in (ball.mid(), ball.rad()))
    return Bounds(middle - radius, middle + radius)


def _dyadic(mantissa: object, exponent: object) -> mpq:
    m, e = int(mantissa), int(exponent)  # type: ignore[call-overload]  # FLINT's integers
    return mpq(m << e) if e >= 0 else mpq(m, 1 << -e)


def ball_around(low: mpq, high: mpq) -> arb:
    """A ball, of FLINT's present precision, that holds an interval.

    >>> ball_around(mpq(1, 2), mpq(1, 2))
    0.500000000000000
    """
    first = arb(to_fmpq(low))
    return first if low == high else first.union(arb(to_fmpq(high)))


def certain(b: Bounds, digits: int) -> str:
    """The decimals on which both ends agree, followed by dots; where they agree on none, the two ends.

    >>> certain(Bounds(mpq(1, 3), mpq(3334, 10000)), 6), certain(Bounds(mpq(-1, 100), mpq(1, 100)), 2)
    ('0.333…', '-0.01 … 0.01')
    """
    ends = [_truncated(end, digits) for end in b]
    agreed = len(list(takewhile(lambda pair: pair[0] == pair[1], zip(*ends, strict=False))))
    if "." not in ends[0][:agreed]:
        return " … ".join(ends)
    return ends[0] if b.low == b.high == rational(ends[0]) else f"{ends[0][:agreed]}…"


def _truncated(q: mpq, digits: int) -> str:
    """A number to this many digits behind the point, cut off towards zero."""
    return shifted(int(abs(q) * mpz(10) ** digits) * (-1 if q < 0 else 1), digits, negative=q < 0)


def shifted(scaled: int, digits: int, *, negative: bool = False) -> str:
    """An integer divided by a power of ten, as a decimal with this many digits behind the point.

    >>> shifted(-25, 3), shifted(7, 0)
    ('-0.025', '7')
    """
    # those of Python are not written beyond 4300 digits
    whole, part = divmod(mpz(abs(scaled)), mpz(10) ** digits)
    decimals = f".{str(part).rjust(digits, '0')}" if digits else ""
    return f"{'-' if negative or scaled < 0 else ''}{whole}{decimals}"
