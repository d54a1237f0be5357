"""Numbers of mpmath that print their significant digits. Importing this module loads mpmath."""

from __future__ import annotations

from mpmath import libmp, mp, nstr

from exactspline.numbers.exact import mpq


class _ShownMpf(mp.mpf):  # type: ignore[misc]  # mpmath has no types
    """An mpf that prints a fixed number of significant digits, independently of the working precision of mpmath;
    results of computations with it are ordinary mpf numbers.
    """

    __slots__ = ("digits",)
    digits: int

    def __repr__(self) -> str:
        return f"mpf('{self!s}')"  # mpmath 1.4 has its own format

    def __str__(self) -> str:
        return str(nstr(mp.make_mpf(self._mpf_), self.digits, strip_zeros=True))

    def __reduce__(self) -> tuple[object, ...]:
        return _made, (tuple(int(part) for part in self._mpf_), self.digits)


def _made(value: tuple[int, ...], digits: int) -> _ShownMpf:
    sign, mantissa, exponent, bits = value
    made = _ShownMpf.__new__(_ShownMpf)
    made._mpf_ = sign, libmp.MPZ(mantissa), exponent, bits
    made.digits = digits
    return made


def shown(value: mpq, digits: int) -> _ShownMpf:
    """A number with an error far below ``10^−digits``, printed with this many digits after the decimal point."""
    whole = int(abs(value))
    bits = whole.bit_length() + (10 ** max(digits, 0)).bit_length() + 4
    return _made(
        libmp.from_rational(int(value.numerator), int(value.denominator), bits),
        max(digits, 1) + (len(str(whole)) if whole else 0),
    )


def significant(value: mpq, digits: int) -> _ShownMpf:
    """A number with a relative error far below ``10^−digits``, printed with this many significant digits."""
    bits = (10 ** max(digits, 0)).bit_length() + 8
    return _made(libmp.from_rational(int(value.numerator), int(value.denominator), bits), max(digits, 1))
