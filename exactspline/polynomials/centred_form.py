"""Bounds of a polynomial over a narrow interval, in balls of about as many bits as the interval has.

At a root known to many digits, the exact value of a form of high degree, or its exact Bézier points over the interval,
have as many bits times the degree, of which only the leading ones matter.

Reference: Moore, Kearfott and Cloud, *Introduction to Interval Analysis*, section 6.4 (the mean value form).
"""

from __future__ import annotations

from flint import arb, arb_poly, ctx, fmpz, fmpz_poly

from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval, ball_around, ball_ends
from exactspline.polynomials.bernstein import Form, backwards, derivative, value

#: Guard bits in addition to those of the interval: rounding widens the bounds by this factor less than their width.
GUARD = 64
#: On wider intervals balls are much too large.
WIDE = mpq(1, 16)


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
    if high - low > WIDE:
        parts = [bounds_over(form, n, *half) for half in Interval(low, high).halves]
        return min(least for least, _ in parts), max(most for _, most in parts)
    if low + high > 1:  # so that t/(1 − t) is finite
        c, low, high = backwards(c, n), 1 - high, 1 - low
    with ctx.workprec(GUARD + int(1 / (high - low)).bit_length()):
        t = ball_around(low, high)
        bounds = _at(c, n, t.mid()) + _at(derivative(c, fmpz(n)), n - 1, t) * (t - t.mid())
    least, most = ball_ends(bounds)
    return least / int(m), most / int(m)


def _at(c: fmpz_poly, n: int, t: arb) -> arb:
    return arb_poly(c)(t / (1 - t)) * (1 - t) ** n
