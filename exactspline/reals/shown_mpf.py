"""Numbers of mpmath that show the digits they have. This module loads mpmath."""

from __future__ import annotations

from mpmath import libmp, mp, nstr

from exactspline.numbers.exact import mpq


class ShownMpf(mp.mpf):  # type: ignore[misc]  # mpmath has no types
    """An mpf that shows its own number of significant digits, whatever the precision that mpmath works with; what is
    computed with it is an ordinary mpf.
    """

    __slots__ = ("digits",)
    digits: int

    def __repr__(self) -> str:
        return f"mpf('{self}')"

    def __str__(self) -> str:
        return str(nstr(mp.make_mpf(self._mpf_), self.digits, strip_zeros=True))

    def __reduce__(self) -> tuple[object, ...]:
        return _made, (tuple(int(part) for part in self._mpf_), self.digits)


def _made(value: tuple[int, ...], digits: int) -> ShownMpf:
    sign, mantissa, exponent, bits = value
    found = ShownMpf.__new__(ShownMpf)
    found._mpf_ = sign, libmp.MPZ(mantissa), exponent, bits
    found.digits = digits
    return found


def shown(value: mpq, digits: int) -> ShownMpf:
    """A number with an error far below ``10^−digits``, that shows as many digits behind the point."""
    whole = int(abs(value))
    bits = whole.bit_length() + (10 ** max(digits, 0)).bit_length() + 4
    return _made(
        libmp.from_rational(int(value.numerator), int(value.denominator), bits),
        max(digits, 1) + (len(str(whole)) if whole else 0),
    )


def significant(value: mpq, digits: int) -> ShownMpf:
    """A number with a relative error far below ``10^−digits``, that shows as many significant digits."""
    bits = (10 ** max(digits, 0)).bit_length() + 8
    return _made(libmp.from_rational(int(value.numerator), int(value.denominator), bits), max(digits, 1))
