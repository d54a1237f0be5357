"""Real numbers by their enclosures: digits, doubles, decimals; and the operations that use a polynomial with this zero:
equality, order, hash, rationality, minimal polynomial.

Enclosures are tried first. Polynomials are used only if enclosures cannot decide, and their cost is bounded beforehand.
"""

from __future__ import annotations

import numbers
import re
from collections.abc import Callable
from contextlib import suppress
from decimal import Context, Decimal
from fractions import Fraction
from functools import cache, lru_cache, total_ordering
from typing import TYPE_CHECKING, Any, TypeVar, cast, overload

from flint import arb, arb_poly, ctx, fmpz, fmpz_poly

from exactspline.errors import OpenError, ReachError, as_integer
from exactspline.numbers.exact import Rounding, decimal_unit, double_between, mpq, mpz, rational, to_fmpq
from exactspline.numbers.intervals import Interval, ball_around, double_in, shifted
from exactspline.numbers.once import Immutable, fill
from exactspline.one_line import LONGEST_NUMBER
from exactspline.polynomials.elimination import linear, primitive, sign_of_value, square_free
from exactspline.polynomials.factors import factorize, greatest_common_divisor

if TYPE_CHECKING:
    import mpmath


T = TypeVar("T")
ONE, HALF = mpq(1), arb((1, -1))
#: The precision of the balls around numbers that are at hand.
PRECISION = 128
#: The number of digits at which numbers not yet separated are suspected to be equal.
SUSPICIOUS = 10
#: The maximal number of digits after the decimal point in a text.
LONGEST = 400
#: The digits of a number for which no more digits can be computed.
FEW = 3


class Digits(Immutable):
    """Numerical representations of a real number. Subclasses define `_enclosed` and `_against_number`."""

    __slots__ = ()

    def _enclosed(self, digits: int) -> Interval:
        """A closed interval that contains the number, at most ``10^−digits`` wide."""
        raise NotImplementedError

    def _against_number(self, t: mpq) -> int:
        """The exact sign of the number minus a rational number."""
        raise NotImplementedError

    def _at_hand(self) -> arb | None:
        """A small ball around the number that takes no refinement; None if there is none."""
        return None

    def _by_ball(self, by: Callable[[arb], T]) -> T | None:
        """What the ball at hand tells, None if there is none."""
        if (ball := self._at_hand()) is None:
            return None
        with ctx.workprec(PRECISION):
            return by(ball)

    @property
    def closed_form(self) -> str | None:
        """The number as text ``p/q`` or ``(a + b√c)/d``, or None if the number has no such form."""
        raise NotImplementedError

    @property
    def sign(self) -> int:
        """The sign of the number: −1, 0 or 1."""
        return self._against_number(mpq(0))

    def enclosure(self, digits: int) -> Interval:
        """Return a closed interval with rational ends, at most ``10^−digits`` wide, that contains this number.

        >>> from exactspline.reals.real import square_root
        >>> square_root(2).enclosure(3)
        Interval(707/500, 283/200)
        """
        return self._enclosed(as_integer(digits, "a number of digits"))

    def double(self, rounding: str = Rounding.NEAREST) -> float:
        """Return the correctly rounded double: to nearest (ties to even), or rounded ``up`` or ``down``.

        Raises `OverflowError` beyond the largest double.
        """
        found = self._by_ball(double_in) if rounding == Rounding.NEAREST else None
        return double_between(self._enclosed, self._against_number, rounding) if found is None else found

    def doubles(self) -> dict[str, float]:
        """Return the correctly rounded doubles for the three rounding modes, each under the name of the mode."""
        enclosed = cache(self._enclosed)
        return {str(way): double_between(enclosed, self._against_number, way) for way in Rounding}

    def __float__(self) -> float:
        """The correctly rounded double."""
        return self.double()

    def __floor__(self) -> int:
        return self._floor(mpq(0))

    def __ceil__(self) -> int:
        integer = self._floor(mpq(0))
        return integer + (self._against_number(mpq(integer)) > 0)

    def __trunc__(self) -> int:
        return self.__ceil__() if self.sign < 0 else self.__floor__()

    __int__ = __trunc__

    @overload
    def __round__(self) -> int: ...
    @overload
    def __round__(self, digits: int) -> mpq: ...
    def __round__(self, digits: int | None = None) -> int | mpq:
        """The nearest integer, or the nearest rational number with this many digits after the decimal point; ties are
        rounded to even.

        >>> from math import floor
        >>> from exactspline.reals.real import Real, square_root
        >>> floor(-square_root(2)), int(-square_root(2)), round(square_root(2), 2), round(Real("5/2"))
        (-2, -1, mpq(141,100), 2)
        """
        unit = mpq(1, mpz(10) ** (0 if digits is None else as_integer(digits, "a number of digits")))
        multiple = self._nearest_multiple(unit)
        return multiple if digits is None else multiple * unit

    def _nearest_multiple(self, unit: mpq) -> int:
        """``x/unit``, rounded to the nearest integer, ties to even."""
        multiple = self._floor(unit / 2, unit)
        return multiple - (multiple % 2 == 1 and self._against_number((multiple - mpq(1, 2)) * unit) == 0)

    def __format__(self, form: str) -> str:
        """The number as Python writes a `Decimal` (with ``g`` as a float), all digits correct; without a type and a
        precision as `str` writes it.

        >>> from exactspline.reals.real import Real, square_root
        >>> f"{square_root(2):.20f}", f"{square_root(2) / 1000:.3e}", f"{square_root(2):>4}", f"{Real(1500):g}"
        ('1.41421356237309504880', '1.414e-3', '  √2', '1500')
        """
        found = re.fullmatch(r"(.*?)(?:\.(\d+))?([eEfFgG%]?)", form)
        before, precision, kind = found.groups() if found else ("", None, "")
        if not kind and precision is None:
            return format(str(self), form)
        kind = kind or "g"
        digits = max(int(precision or 6), int(kind in "gG"))
        near = abs(self.rational_near(digits + 5))
        if kind in "fF%" or not near:
            unit = mpq(1, mpz(10) ** (digits + 2 * (kind == "%")))
        else:
            unit = decimal_unit(near) / mpz(10) ** (digits - (kind in "gG"))
        exponent = len(str(unit.numerator)) - len(str(unit.denominator))
        number = Decimal(f"{self._nearest_multiple(unit)}E{exponent}")
        if kind in "gG":
            shown = Context(prec=digits).create_decimal(number).normalize()
            behind = -cast(int, shown.as_tuple().exponent)
            as_it_is = -5 < shown.adjusted() < digits
            digits, kind = (max(behind, 0), "f") if as_it_is else (behind + shown.adjusted(), "eE"[kind == "G"])
        return format(number, f"{before}.{digits}{kind}")

    def _mpmath_(self, bits: int, rounding: str) -> mpmath.mpf:
        """The number as an mpmath number, at the working precision of mpmath."""
        from mpmath import libmp, mp

        value = self.rational_near(bits // 3 + 5)
        return mp.make_mpf(libmp.from_rational(int(value.numerator), int(value.denominator), bits, rounding))

    def _floor(self, shift: mpq, unit: mpq = ONE) -> int:
        """``⌊(x + shift)/unit⌋``."""
        digits = 5
        while True:
            low, high = (int((end + shift) // unit) for end in self._enclosed(digits))
            if low == high:
                return low
            if high == low + 1:
                return high if self._against_number(high * unit - shift) >= 0 else low
            digits *= 2

    def decimal(self, digits: int) -> str:
        """Return the number rounded to the nearest decimal with this many digits after the point (a tie upwards).

        >>> from exactspline.reals.real import Real, square_root
        >>> square_root(2).decimal(5), Real("2/3").decimal(3)
        ('1.41421', '0.667')
        """
        return shifted(self._multiple(as_integer(digits, "a number of digits")), digits)

    def _multiple(self, digits: int) -> int:
        """``⌊10ᵈⁱᵍⁱᵗˢ x + 1/2⌋``, independent of earlier computations; if it cannot be decided on which side of a tie
        the number is, it is treated as a tie.
        """
        scale, reached = mpz(10) ** digits, digits + 2
        whole = self._by_ball(lambda ball: (ball * int(scale) + HALF).floor().unique_fmpz())
        if whole is not None:
            return int(whole)
        while True:
            low, high = (int((2 * scale * end + 1) // 2) for end in self._enclosed(reached))
            if low == high:
                return high
            if reached > digits + SUSPICIOUS:
                with suppress(ReachError, OpenError):
                    return high - (self._against_number(mpq(2 * high - 1, 2 * scale)) < 0)
                return high
            reached += SUSPICIOUS

    def mpf(self, digits: int = 15) -> mpmath.mpf:
        """Return an ``mpmath.mpf`` with an error of at most ``10^−digits`` that prints this many digits. The working
        precision of mpmath is not changed.

        >>> from exactspline.reals.real import square_root
        >>> square_root(2).mpf(30)
        mpf('1.41421356237309504880168872421')
        """
        from exactspline.reals.shown_mpf import shown

        return shown(self._near(as_integer(digits, "a number of digits") + 1), digits)

    def _near(self, digits: int) -> mpq:
        return mpq(self._multiple(digits), mpz(10) ** digits)

    def significant(self, digits: int) -> mpmath.mpf:
        """Return an ``mpmath.mpf`` with a relative error below ``10^−digits``, or 0 if the number is 0."""
        from exactspline.reals.shown_mpf import significant

        return significant(self.rational_near(digits), digits)

    def rational_near(self, digits: int) -> mpq:
        """Return a rational number with a relative error below ``10^−digits``, or 0 if the number is 0.

        >>> from exactspline.reals.real import square_root
        >>> abs(square_root(2).rational_near(5) ** 2 - 2) < mpq(4, 10**5)
        True
        """
        requested = as_integer(digits, "a number of digits", 1) + 2
        while True:
            value = self._near(requested)
            if abs(value) >= mpq(1, mpz(10) ** (requested - digits - 1)):
                return value
            if value == 0 and requested > SUSPICIOUS and self.sign == 0:
                return value
            requested *= 2

    def shortly(self, digits: int = 6) -> str:
        """Return the closed form if it is short; otherwise return this many significant digits followed by dots, or
        fewer digits if more digits would take too long. A number that is only known to be close to 0 is shown as ``0 ±
        1e-n``.

        >>> from exactspline.reals.real import square_root
        >>> str(square_root(2) + square_root(3) - square_root(5 + 2 * square_root(6)))
        '0'
        """
        with suppress(ReachError, OpenError):
            if (known := self.closed_form) is not None and len(known) <= LONGEST_NUMBER:
                return known
        shown, requested = "…", 2 * as_integer(digits, "a number of digits", 1) + 2
        try:
            while True:
                value = self._near(requested)
                if abs(value) >= mpq(1, mpz(10) ** (requested - digits - 2)):
                    break
                if requested > LONGEST and not value:
                    shown = f"0 ± 1e-{requested}"
                    if self.sign == 0:
                        return "0"
                requested *= 2
            from exactspline.reals.shown_mpf import significant

            return f"{significant(value, digits)}…"
        except (ReachError, OpenError):
            return shown if shown != "…" or digits <= FEW else self.shortly(FEW)

    def __str__(self) -> str:
        return self.shortly(15)

    def __repr__(self) -> str:
        return f"<Real {self.shortly(8)}>"


numbers.Real.register(Digits)


_RATIONAL = type(mpq())
#: The types with which a real number can be compared and combined.
EXACT = (int, Fraction, Decimal, type(mpz()), _RATIONAL, fmpz, type(to_fmpq(mpq())))
#: The number of digits after which it remains undecided whether two numbers are equal.
OPEN = 1500


@lru_cache(64)
def _factors(*coefficients: fmpz) -> tuple[fmpz_poly, ...]:
    return tuple(primitive(p) for p in factorize(fmpz_poly(list(coefficients))).bases)


def _changes_sign(p: fmpz_poly, low: mpq, high: mpq) -> bool:
    """Whether a polynomial has opposite signs at two numbers."""
    return sign_of_value(p, low) * sign_of_value(p, high) < 0


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
        nearest, scale = self._multiple(digits), mpz(10) ** digits
        return Interval(mpq(nearest - 1, scale), mpq(nearest + 1, scale))

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
        return linear(low) if low == high else next(f for f in _factors(*p.coeffs()) if _changes_sign(f, low, high))

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
        return common.degree() > 0 and _changes_sign(common, low, high)

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
        return (
            _changes_sign(common, a, b) and _changes_sign(common, c, d) and _changes_sign(common, min(a, c), max(b, d))
        )


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
