"""Enclosures, digits, doubles and text of real numbers that are known by arbitrarily narrow intervals."""

from __future__ import annotations

import numbers
import re
from contextlib import suppress
from decimal import Context, Decimal
from functools import cache
from typing import TYPE_CHECKING, cast, overload

from exactspline.errors import OpenError, ReachError, as_integer
from exactspline.numbers.exact import Rounding, decimal_unit, double_between, mpq, mpz
from exactspline.numbers.intervals import Interval, shifted
from exactspline.numbers.once import Immutable
from exactspline.one_line import LONGEST_NUMBER

if TYPE_CHECKING:
    import mpmath

ONE = mpq(1)
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
        return double_between(self._enclosed, self._against_number, rounding)

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
