"""A real number that is known by intervals around it, as narrow as asked: its digits, doubles and text."""

from __future__ import annotations

from typing import TYPE_CHECKING

from exactspline.errors import NumberError
from exactspline.numbers.exact import Rounding, double_between, mpq, mpz
from exactspline.numbers.immutable import Immutable
from exactspline.numbers.intervals import Interval, shifted

if TYPE_CHECKING:
    import mpmath

#: Digits at which numbers that are still not separated are suspected to be equal.
SUSPICIOUS = 10
#: Digits behind the point beyond which a text shows no more.
LONGEST = 400


class Digits(Immutable):
    """What a real number shows of itself. A kind of number defines `_enclosed` and `_against_number`."""

    __slots__ = ()

    def _enclosed(self, digits: int) -> Interval:
        """An interval with the number in it, or at an end of it, at most ``10^−digits`` wide."""
        raise NotImplementedError

    def _against_number(self, t: mpq) -> int:
        """The sign of the number minus a rational one, exactly."""
        raise NotImplementedError

    @property
    def closed_form(self) -> str | None:
        """Its text where it is known as ``p/q`` or ``a + b√c``, None elsewhere."""
        return None

    @property
    def sign(self) -> int:
        """−1, 0 or 1."""
        return self._against_number(mpq(0))

    def enclosure(self, digits: int) -> Interval:
        """Rational numbers, at most ``10^−digits`` apart, with this number between them or at one of them.

        >>> from exactspline.reals.real import square_root
        >>> square_root(2).enclosure(3)
        Interval(low=mpq(707,500), high=mpq(283,200))
        """
        if type(digits) is not int:
            raise NumberError(f"{digits!r} digits", where="digits", remedy="an integer")
        return self._enclosed(digits)

    def double(self, rounding: str = Rounding.NEAREST) -> float:
        """The correctly rounded double: the nearest (of two equally near the even one), or the one ``up`` or ``down``.

        Raises `OverflowError` beyond the largest.
        """
        return double_between(self._enclosed, self._against_number, rounding)

    def doubles(self) -> dict[str, float]:
        """All three correctly rounded doubles by the names of the rounding modes."""
        return {str(way): self.double(way) for way in Rounding}

    def __float__(self) -> float:
        """The correctly rounded double."""
        return self.double()

    def __floor__(self) -> int:
        return self._floor(mpq(0))

    def __ceil__(self) -> int:
        found = self._floor(mpq(0))
        return found + (self._against_number(mpq(found)) > 0)

    def __round__(self) -> int:
        """The nearest integer, of two equally near the even one.

        >>> from math import floor
        >>> from exactspline.reals.real import Real, square_root
        >>> floor(-square_root(2)), round(square_root(2)), round(Real("5/2"))
        (-2, 1, 2)
        """
        found = self._floor(mpq(1, 2))
        tie = found % 2 == 1 and self._against_number(found - mpq(1, 2)) == 0
        return found - tie

    def _floor(self, shift: mpq) -> int:
        """``⌊x + shift⌋``."""
        digits = 5
        while True:
            low, high = (int((end + shift) // 1) for end in self._enclosed(digits))
            if low == high:
                return low
            if high == low + 1:
                return high if self._against_number(high - shift) >= 0 else low
            digits *= 2

    def decimal(self, digits: int) -> str:
        """The number to this many digits behind the point, off by less than the last of them.

        >>> from exactspline.reals.real import Real, square_root
        >>> square_root(2).decimal(5), Real("2/3").decimal(3)
        ('1.41421', '0.667')
        """
        middle = self.enclosure(digits + 1).middle
        return shifted(int((2 * middle * mpz(10) ** digits + 1) // 2), digits)

    def mpf(self, digits: int = 15) -> mpmath.mpf:
        """An ``mpmath.mpf`` that is off by at most ``10^−digits`` and shows these digits; mpmath's own precision is not
        touched.

        >>> from exactspline.reals.real import square_root
        >>> square_root(2).mpf(30)
        mpf('1.41421356237309504880168872421')
        """
        from exactspline.reals.shown_mpf import shown

        return shown(self.enclosure(digits + 1).middle, digits)

    def significant(self, digits: int) -> mpmath.mpf:
        """An ``mpmath.mpf`` with a relative error below ``10^−digits``; exactly 0 where the number is 0."""
        from exactspline.reals.shown_mpf import significant

        wanted = digits + 2
        while True:
            found = self.enclosure(wanted)
            if self._reached_zero(found, wanted):
                return significant(mpq(0), digits)
            least = min(abs(found.low), abs(found.high))
            if found.low * found.high > 0 and found.width * mpz(10) ** digits <= least:
                return significant(found.middle, digits)
            wanted *= 2

    def _reached_zero(self, found: Interval, digits: int) -> bool:
        return found.low <= 0 <= found.high and (found.width == 0 or (digits > SUSPICIOUS and self.sign == 0))

    def shortly(self, digits: int = 6) -> str:
        """Its closed form, or this many significant digits and dots."""
        if (known := self.closed_form) is not None:
            return known
        wanted = digits + 14
        while True:
            found = self.enclosure(wanted)
            least = min(abs(found.low), abs(found.high))
            if found.width * 10 ** (digits + 2) <= least or wanted > LONGEST:
                break
            wanted *= 2
        from exactspline.reals.shown_mpf import significant

        return f"{significant(found.middle, digits)}…"

    def __str__(self) -> str:
        return self.shortly(15)

    def __repr__(self) -> str:
        return f"<Real {self.shortly(8)}>"
