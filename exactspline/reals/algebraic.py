"""A real number by a polynomial with this zero: equality, order, hash, whether it is rational, minimal polynomial.

Digits decide first. Polynomials are asked for where digits cannot decide, and their cost is bounded beforehand.
"""

from __future__ import annotations

from fractions import Fraction
from functools import total_ordering
from typing import Any, cast

from flint import arb_poly, ctx, fmpz, fmpz_poly

from exactspline.errors import OpenError, ReachError
from exactspline.numbers.exact import mpq, mpz, rational, text, to_fmpq
from exactspline.numbers.immutable import fill
from exactspline.numbers.intervals import ball_around
from exactspline.polynomials.annihilating import (
    changes_sign,
    irreducible_factors,
    linear,
    may_vanish,
    sign_at,
    square_free,
    without_rational_zero,
)
from exactspline.polynomials.factors import greatest_common_divisor
from exactspline.reals.digits import SUSPICIOUS, Digits

_RATIONAL = type(mpq())
#: The types that a real number is compared and computed with.
EXACT = (int, Fraction, type(mpz()), _RATIONAL, fmpz, type(to_fmpq(mpq())))
#: Digits beyond which it is left open whether two numbers are equal.
OPEN = 1500


@total_ordering
class Algebraic(Digits):
    """What a real number is asked that its digits cannot answer. A kind of number defines `_annihilator`."""

    __slots__ = ("_exact", "_isolating", "_minimal")
    #: The number itself where it was found to be rational; False where it was found not to be.
    _exact: mpq | bool | None
    _minimal: fmpz_poly | None
    #: A polynomial and an interval in which it has this zero and no other.
    _isolating: tuple[fmpz_poly, mpq, mpq] | None

    #: Digits from which on it is asked whether numbers that they do not separate are equal.
    _suspicious = SUSPICIOUS

    def _annihilator(self) -> fmpz_poly:
        """A polynomial with this zero."""
        raise NotImplementedError

    @property
    def closed_form(self) -> str | None:
        """Its text where it is known as ``p/q`` or ``a + b√c``, None elsewhere."""
        return text(self._exact) if isinstance(self._exact, _RATIONAL) else None

    def _isolated(self) -> tuple[fmpz_poly, mpq, mpq]:
        """A polynomial that has this number as a simple zero and no other between two numbers, at which it is not zero;
        the number itself twice where it is rational and was found.
        """
        if self._isolating is None:
            fill(self, _isolating=self._computed_isolating())
        return cast("tuple[fmpz_poly, mpq, mpq]", self._isolating)

    def _computed_isolating(self) -> tuple[fmpz_poly, mpq, mpq]:
        p, digits = square_free(self._annihilator()), 20
        slope, bits = p.derivative(), p.height_bits()
        while True:
            low, high = self._enclosed(digits)
            if low == high:
                return linear(low), low, low
            with ctx.workprec(bits + 4 * digits):
                certain = bool(arb_poly(slope)(ball_around(low, high)) != 0)
            for end in (low, high) if certain else ():
                if sign_at(p, end) == 0:
                    self._found(end)
                    return linear(end), end, end
            if certain:
                return p, low, high
            digits *= 2

    def _found(self, value: mpq) -> None:
        fill(self, _exact=value)

    @property
    def exact(self) -> mpq | None:
        """The number itself where it is rational, None where it is irrational: decided exactly, without factoring.

        The denominator of a rational zero divides the leading coefficient a of a polynomial: of the multiples of 1/a at
        most one is in an interval narrower than that.

        >>> from exactspline.reals.real import square_root
        >>> (square_root(2) * square_root(18)).exact, square_root(2).exact
        (mpq(6,1), None)
        """
        if self._exact is None:
            found = self._decided()
            fill(self, _exact=False if found is None else found)
        return None if isinstance(self._exact, bool) else self._exact

    def _decided(self) -> mpq | None:
        """The number where it is rational."""
        p, low, high = self._isolated()
        if low == high:
            return low
        if without_rational_zero(p):
            return None
        a = int(p.leading_coefficient())
        first, last = self._enclosed(a.bit_length() * 30103 // 100000 + 1)
        candidate = mpq(-((-first * a) // 1), a)
        if candidate > min(last, high) or candidate < low or not may_vanish(p, candidate):
            return None
        if sign_at(p, candidate) != 0:
            return None
        self._found(candidate)
        return candidate

    def minimal_polynomial(self) -> list[int]:
        """The irreducible integer polynomial with this zero, constant term first.

        >>> from exactspline.reals.real import square_root
        >>> (square_root(2) + square_root(8)).minimal_polynomial()
        [-18, 0, 1]

        Raises `ReachError` where computing it is too expensive.
        """
        return [int(x) for x in self._irreducible().coeffs()]

    def _irreducible(self) -> fmpz_poly:
        if self._minimal is None:
            fill(self, _minimal=self._computed_minimal())
        return cast(fmpz_poly, self._minimal)

    def _computed_minimal(self) -> fmpz_poly:
        p, low, high = self._isolated()
        if low == high:
            return linear(low)
        return next(f for f in irreducible_factors(p) if changes_sign(f, low, high))

    def is_root_of(self, polynomial: fmpz_poly) -> bool:
        """Whether a polynomial with integer coefficients vanishes here, exactly.

        >>> from exactspline.reals.real import square_root
        >>> square_root(2).is_root_of(fmpz_poly([0, -2, 0, 1])), square_root(2).is_root_of(fmpz_poly([-1, 1]))
        (True, False)
        """
        p, low, high = self._isolated()
        if low == high:
            return sign_at(polynomial, low) == 0
        # a divisor of `p` has no other zero between low and high, nor at them, and this one once at most
        common = greatest_common_divisor([p, polynomial])
        return common.degree() > 0 and changes_sign(common, low, high)

    # ---- comparisons

    def __bool__(self) -> bool:
        return self.sign != 0

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, (Algebraic, *EXACT)):
            return NotImplemented
        return self._against(other) == 0

    def __lt__(self, other: object) -> bool:
        if not isinstance(other, (Algebraic, *EXACT)):
            return NotImplemented
        return self._against(other) < 0

    def __hash__(self) -> int:
        """That of the number where it is rational, otherwise that of ``⌊2⁶⁴ x⌋``."""
        if (exact := self.exact) is not None:
            return hash(exact)
        digits = 20
        while True:
            low, high = (int((t * (1 << 64)) // 1) for t in self._enclosed(digits))
            if low == high:
                return hash((low, 64))
            digits *= 2

    def _against(self, other: Any) -> int:
        """The sign of the difference to another number."""
        if not isinstance(other, Algebraic):
            return self._against_number(rational(int(other) if isinstance(other, bool) else other))
        if self is other:
            return 0
        if isinstance(other._exact, _RATIONAL):
            return self._against_number(other._exact)
        if isinstance(self._exact, _RATIONAL):
            return -other._against_number(self._exact)
        return self._parted(other) or _order(self, other)

    def _parted(self, other: Algebraic) -> int:
        """The order of two numbers where it is known at little cost; 0 where it is not."""
        return 0

    def _against_number(self, t: mpq) -> int:
        """The sign of the number minus a rational one, exactly."""
        return _order(self, t)

    def _equals(self, other: Algebraic | mpq) -> bool:
        """Whether two numbers are equal: the common divisor of their polynomials changes sign at both, and once over
        both.
        """
        p, a, b = self._isolated()
        if not isinstance(other, Algebraic):
            return a <= other <= b and sign_at(p, other) == 0
        q, c, d = other._isolated()
        if a == b or c == d:
            return other._equals(a) if a == b else self._equals(c)
        common = greatest_common_divisor([p, q])
        if common.degree() < 1 or b <= c or d <= a:
            return False
        return changes_sign(common, a, b) and changes_sign(common, c, d) and changes_sign(common, min(a, c), max(b, d))


def _order(x: Algebraic, y: Algebraic | mpq) -> int:
    """The sign of ``x − y``: by digits, and where these do not separate the numbers by polynomials."""
    digits, suspected = 10, False
    suspicious = max(n._suspicious for n in (x, y) if isinstance(n, Algebraic))
    while True:
        a, b = x._enclosed(digits)
        c, d = y._enclosed(digits) if isinstance(y, Algebraic) else (y, y)
        if a == b == c == d:
            return 0
        if b < c or d < a:
            return -1 if b < c else 1
        if digits >= suspicious and not suspected:
            try:
                if x._equals(y):
                    return 0
                suspected = True
            except (ReachError, OpenError):
                # different numbers are separated by digits even where equality could not be shown
                if digits > OPEN:
                    raise
        digits *= 2
