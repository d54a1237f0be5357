"""Bounds of a polynomial over a narrow interval, in integers of about as many bits as the interval has.

At a root known to many digits, the exact value of a form of high degree, or its exact Bézier points over the interval,
have as many bits times the degree, of which only the leading ones matter. Here every operation is rounded outwards to a
fixed number of binary places. (FLINT's balls could do the same, but their precision is a global setting of all
threads.)

Reference: Moore, Kearfott and Cloud, *Introduction to Interval Analysis*, section 6.4 (the mean value form).
"""

from __future__ import annotations

from flint import fmpz, fmpz_poly

from exactspline.numbers.exact import mpq, mpz
from exactspline.polynomials.bernstein import Form, derivative, value

#: Guard bits in addition to those of the interval: rounding widens the bounds by this factor less than their width.
GUARD = 64


def bounds_over(form: Form, n: int, low: mpq, high: mpq) -> tuple[mpq, mpq]:
    """Lower and upper bounds of the form of degree n ≥ 0 for all local parameters in [low, high] ⊆ [0, 1].

    By the mean value form: the value at the midpoint, plus the range of the slope times the distance from there. The
    bounds converge as the interval shrinks.

    >>> from exactspline.polynomials.bernstein import from_bezier
    >>> low, high = bounds_over(from_bezier([mpq(0), mpq(0), mpq(1)]), 2, mpq(1, 3), mpq(1001, 3000))
    >>> low <= mpq(1, 9), mpq(1001, 3000) ** 2 <= high, high - low < mpq(1, 4000)
    (True, True, True)
    """
    c, m = form
    if low == high or n == 0:
        exact = value(form, n, low)
        return exact, exact
    bits = GUARD + int(1 / (high - low)).bit_length()
    middle = _rounded_down((low + high) / 2, bits)
    least, most = _values(c, n, middle, middle, bits)
    slope = max(map(abs, _values(derivative(c, fmpz(n)), n - 1, low, high, bits)))
    reach = slope * max(middle - low, high - middle)
    return (least - reach) / int(m), (most + reach) / int(m)


def _rounded_down(t: mpq, bits: int) -> mpq:
    return mpq((t * (mpz(1) << bits)) // 1, mpz(1) << bits)


def _values(c: fmpz_poly, n: int, low: mpq, high: mpq, bits: int) -> tuple[mpq, mpq]:
    """Bounds of ``Σ c_i (1 − t)ⁿ⁻ⁱ tⁱ`` over [low, high], by Horner's rule; every product is rounded outwards to `bits`
    binary places, relative to the largest coefficient.
    """
    one = mpz(1) << bits
    v = (low * one) // 1, -((-high * one) // 1)
    u = one - v[1], one - v[0]
    scale = max(c.height_bits(), 1) - bits
    least = most = mpz(0)
    power = one, one
    for i in range(n, -1, -1):
        below, above = _shifted(c[i], scale)
        least = (least * v[least < 0] >> bits) + (below * power[below < 0] >> bits)
        most = -(-most * v[most >= 0] >> bits) - (-above * power[above >= 0] >> bits)
        power = power[0] * u[0] >> bits, -(-power[1] * u[1] >> bits)
    return _times_power(least, scale), _times_power(most, scale)


def _shifted(c: fmpz, scale: int) -> tuple[mpz, mpz]:
    """Integer lower and upper bounds of ``c / 2^scale``, at most 1 apart."""
    if scale <= 0:
        exact = mpz(int(c)) << -scale
        return exact, exact
    below = mpz(int(c >> scale))
    return below, below + 1


def _times_power(x: mpz, scale: int) -> mpq:
    return mpq(x << scale) if scale > 0 else mpq(x, mpz(1) << -scale)
