"""Operations on a real number that use a polynomial with this zero: equality, order, hash, rationality, minimal
polynomial.

Enclosures are tried first. Polynomials are used only if enclosures cannot decide, and their cost is bounded beforehand.
"""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from functools import total_ordering
from typing import Any, cast

from flint import arb_poly, ctx, fmpz, fmpz_poly

from exactspline.errors import OpenError, ReachError
from exactspline.numbers.exact import mpq, mpz, rational, to_fmpq
from exactspline.numbers.intervals import Interval, ball_around
from exactspline.numbers.once import fill
from exactspline.polynomials.elimination import changes_sign, irreducible_factors, linear, sign_of_value, square_free
from exactspline.polynomials.factors import greatest_common_divisor
from exactspline.reals.digits import SUSPICIOUS, Digits

_RATIONAL = type(mpq())
#: The types with which a real number can be compared and combined.
EXACT = (int, Fraction, Decimal, type(mpz()), _RATIONAL, fmpz, type(to_fmpq(mpq())))
#: The number of digits after which it remains undecided whether two numbers are equal.
OPEN = 1500


@total_ordering
class Algebraic(Digits):
    """Operations on real numbers that enclosures cannot decide. Subclasses define `_annihilator`."""

    __slots__ = ("_closed", "_exact", "_isolating", "_minimal")
    #: The number itself if it is known to be rational; False if it is known to be irrational.
    _exact: mpq | bool | None
    #: The number as a rational or quadratic one; False if it is proved to be neither, None if this has not been decided
    #: yet.
    _closed: Algebraic | bool | None
    _minimal: fmpz_poly | None
    #: A polynomial and an interval in which this number is its only zero.
    _isolating: tuple[fmpz_poly, mpq, mpq] | None

    #: The number of digits after which numbers not yet separated are tested for equality.
    suspicious_digits = SUSPICIOUS

    def _annihilator(self) -> fmpz_poly:
        """A nonzero polynomial that vanishes at this number."""
        raise NotImplementedError

    def _isolated(self) -> tuple[fmpz_poly, mpq, mpq]:
        """A polynomial with this number as a simple zero, and two numbers between which it has no other zero and at
        which it is not zero; if the number is known to be rational, both are this number.
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
                if sign_of_value(p, end) == 0:
                    self._set_rational(end)
                    return linear(end), end, end
            if certain:
                return p, low, high
            digits *= 2

    def _set_rational(self, value: mpq) -> None:
        fill(self, _exact=value)

    @property
    def exact(self) -> mpq | None:
        """The rational value of the number, or None if the number is irrational.

        >>> from exactspline.reals.real import square_root
        >>> (square_root(2) * square_root(18)).exact, square_root(2).exact
        (mpq(6,1), None)
        """
        if self._exact is None:
            value = self._decided()
            if value is None:
                fill(self, _exact=False)
            else:
                self._set_rational(value)
        return None if isinstance(self._exact, bool) else self._exact

    def _decided(self) -> mpq | None:
        """The number if it is rational, else None."""
        raise NotImplementedError

    def around(self, digits: int) -> Interval:
        """Return the number itself if it is known to be rational. Otherwise return the interval between the two
        neighbours of the nearest multiple of ``10^−digits``, which are multiples, too.

        >>> from exactspline.reals.real import square_root
        >>> square_root(2).around(2)
        Interval(7/5, 71/50)
        """
        if isinstance(self._exact, _RATIONAL):
            return Interval.point(self._exact)
        nearest, unit = self._near(digits), mpq(1, mpz(10) ** digits)
        return Interval(nearest - unit, nearest + unit)

    def minimal_polynomial(self) -> list[int]:
        """Return the coefficients of the irreducible integer polynomial that vanishes at this number, constant term
        first.

        >>> from exactspline.reals.real import square_root
        >>> (square_root(2) + square_root(8)).minimal_polynomial()
        [-18, 0, 1]

        Raises `ReachError` if the computation would be too expensive.
        """
        return [int(x) for x in self.irreducible_polynomial().coeffs()]

    def irreducible_polynomial(self) -> fmpz_poly:
        """Return the polynomial whose coefficients `minimal_polynomial` lists. The polynomial is shared and must not be
        changed.
        """
        if self._minimal is None:
            fill(self, _minimal=self._computed_minimal())
        return cast(fmpz_poly, self._minimal)

    def _computed_minimal(self) -> fmpz_poly:
        p, low, high = self._isolated()
        return linear(low) if low == high else next(f for f in irreducible_factors(p) if changes_sign(f, low, high))

    def is_root_of(self, polynomial: fmpz_poly) -> bool:
        """Return whether a polynomial with integer coefficients vanishes at this number.

        >>> from exactspline.reals.real import square_root
        >>> square_root(2).is_root_of(fmpz_poly([0, -2, 0, 1])), square_root(2).is_root_of(fmpz_poly([-1, 1]))
        (True, False)
        """
        p, low, high = self._isolated()
        if low == high:
            return sign_of_value(polynomial, low) == 0
        # a divisor of `p` has no other zero in [low, high], and this one with multiplicity at most one
        common = greatest_common_divisor([p, polynomial])
        return common.degree() > 0 and changes_sign(common, low, high)

    # ---- comparisons

    def __bool__(self) -> bool:
        return self.sign != 0

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, (Algebraic, *EXACT)):
            return NotImplemented
        if isinstance(other, Decimal) and not other.is_finite():
            return False
        return self._against(other) == 0

    def __lt__(self, other: object) -> bool:
        if not isinstance(other, (Algebraic, *EXACT)):
            return NotImplemented
        return self._against(other) < 0

    def __hash__(self) -> int:
        """The hash of the number if it is rational, otherwise the hash of ``⌊2⁶⁴ x⌋``."""
        if (exact := self.exact) is not None:
            return hash(exact)
        digits = 20
        while True:
            low, high = (int((t * (1 << 64)) // 1) for t in self._enclosed(digits))
            if low == high:
                return hash((low, 64))
            digits *= 2

    def _against(self, other: Any) -> int:
        """The sign of the difference from another number."""
        if not isinstance(other, Algebraic):
            return self._against_number(rational(int(other) if isinstance(other, bool) else other))
        if self is other:
            return 0
        if isinstance(other._exact, _RATIONAL):
            return self._against_number(other._exact)
        if isinstance(self._exact, _RATIONAL):
            return -other._against_number(self._exact)
        return _order(self, other)

    def _against_number(self, t: mpq) -> int:
        """The exact sign of the number minus a rational number."""
        return _order(self, t)

    def _equals(self, other: Algebraic | mpq) -> bool:
        """Whether two numbers are equal: the gcd of their polynomials changes sign in the isolating interval of each,
        and only once in their union.
        """
        p, a, b = self._isolated()
        if not isinstance(other, Algebraic):
            return a <= other <= b and sign_of_value(p, other) == 0
        q, c, d = other._isolated()
        if a == b or c == d:
            return other._equals(a) if a == b else self._equals(c)
        common = greatest_common_divisor([p, q])
        if common.degree() < 1 or b <= c or d <= a:
            return False
        return changes_sign(common, a, b) and changes_sign(common, c, d) and changes_sign(common, min(a, c), max(b, d))


def _order(x: Algebraic, y: Algebraic | mpq) -> int:
    """The sign of ``x − y``, by enclosures or, if these do not separate the numbers, by polynomials."""
    digits, suspected = 7, False
    suspicious = max(n.suspicious_digits for n in (x, y) if isinstance(n, Algebraic))
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
                # different numbers are separated by enclosures even if equality could not be decided
                if digits > OPEN:
                    raise
        digits *= 2
