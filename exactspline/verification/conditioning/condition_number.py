"""Condition numbers of zeros in the Bernstein basis: exact, or enclosed by exact numbers."""

from __future__ import annotations

from math import factorial

from flint import fmpz, fmpz_poly

from exactspline.numbers.exact import iroot, mpq, mpz
from exactspline.numbers.intervals import Interval
from exactspline.polynomials.bernstein import ONE, Form, derivative, value
from exactspline.roots.root import Root

#: Relative width of an enclosure of a condition number.
WIDTH = mpq(1, 10**10)
#: Bits to which the ends of an enclosure are rounded, and the initial digits of the zero.
BITS, START = 64, 30
#: Digits of a zero with which a double is compared.
DIGITS = 60


def local(root: Root, digits: int = DIGITS) -> Interval:
    """A zero inside a segment in the segment's local parameter, in an interval of width at most ``10^−digits`` times
    the segment.
    """
    assert root.segment is not None
    interval = root.refine(digits + max(0, len(str(int(1 / root.segment.width)))))
    return Interval(*map(root.segment.local, interval))


def condition_number(form: Form, n: int, root: Root, m: int) -> Interval:
    """The condition number of a zero of multiplicity m of a form of degree n, the local parameter being that of the
    zero's segment.

    Both ends are the number itself where the zero is rational and m = 1; otherwise they enclose it, with a relative
    width below `WIDTH`. For m = 0 it is ``Σ |b_i| B_i(x) / |p(x)|``, the condition number of evaluating p at x.

    >>> from exactspline import BSpline
    >>> from exactspline.roots.zero_set import zeros
    >>> f = BSpline.bezier([-1, 3])
    >>> condition_number(f.forms[0], 1, zeros(f)[0], 1)  # (3/4 + 3/4) / 4
    Interval(3/8, 3/8)
    """
    digits = START
    while True:
        x = local(root, digits)
        top = _range((fmpz_poly([abs(c) for c in form[0].coeffs()]), form[1]), n, x)
        bottom = _range(_derivative(form, n, m), n - m, x)
        if bottom[0] > 0 or bottom[1] < 0:
            small, large = sorted(map(abs, bottom))
            low, high = factorial(m) * top[0] / large, factorial(m) * top[1] / small
            if low == high and m <= 1:
                return Interval(low, high)
            low, high = _root_below(low, max(m, 1)), 1 / _root_below(1 / high, max(m, 1))
            if high - low <= WIDTH * low:
                return Interval(low, high)
        digits *= 2


def _derivative(form: Form, n: int, m: int) -> Form:
    c = form[0]
    for k in range(m):
        c = derivative(c, fmpz(n - k))
    return c, form[1]


def _range(form: Form, n: int, x: Interval) -> Interval:
    """Bounds of a form over an interval: those of its positive and of its negative terms, each of which increases with
    v/u and decreases with 1/u.
    """
    low, high = x
    shrink = ((1 - high) / (1 - low)) ** n
    parts = [(fmpz_poly([max(sign * c, fmpz(0)) for c in form[0].coeffs()]), form[1]) for sign in (1, -1)]
    (up, top), (down, bottom) = ((value(part, n, low) * shrink, value(part, n, high) / shrink) for part in parts)
    return Interval(up - bottom, top - down)


def _root_below(q: mpq, m: int) -> mpq:
    """A short number just below the m-th root of a positive one."""
    shift = m * (BITS + max(0, int(1 / q).bit_length() // m + 1))
    return mpq(iroot(mpz(q * mpz(2) ** shift), m)[0], mpz(2) ** (shift // m))


def quotient(form: Form, n: int, by: Form, m: int) -> Form | None:
    """The quotient of the first form by the second one, of degree n − m, up to a constant; None if there is none.

    >>> quotient((fmpz_poly([-1, 0, 1]), ONE), 2, (fmpz_poly([-1, 1]), ONE), 1)
    (x + 1, 1)
    """
    (c, _), (b, _) = form, by
    if not c or not b or n < m:
        return None
    q, rest = divmod(c // c.content(), b // b.content())
    return None if rest or q.degree() > n - m else (q, ONE)
