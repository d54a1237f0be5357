"""One polynomial on one segment: a homogeneous binary form in the scaled Bernstein basis.

``P(u, v) = (c_0 uⁿ + c_1 uⁿ⁻¹v + … + c_n vⁿ) / m`` with ``u = 1 − t``, ``v = t``, integers ``c_i = m·C(n, i)·b_i`` and
``m > 0``; the ``b_i`` are the Bézier points. A form is the pair ``(c, m)``: an ``fmpz_poly`` in ``z = v/u`` and an
``fmpz``; its formal degree n is stored separately, because leading zeros are significant here. Multiplication is
convolution, degree elevation is multiplication by ``u + v``, exact degree reduction is division by ``u + v``, and the
derivative is ``∂v − ∂u``. All operations stay in the Bernstein basis.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cache
from itertools import pairwise
from math import comb

from flint import fmpz, fmpz_poly

from exactspline.numbers.exact import (
    common_multiple,
    from_flint,
    lcm,
    mpq,
    over_one_denominator,
    ratio,
    to_fmpq,
    to_fmpz,
)
from exactspline.polynomials.factors import factorize_square_free

Form = tuple[fmpz_poly, fmpz]

NOTHING, ONE = fmpz(0), fmpz(1)
ZERO_FORM: Form = (fmpz_poly([]), ONE)
U_PLUS_V = fmpz_poly([1, 1])
ONE_PLUS_2Z = fmpz_poly([1, 2])
#: From this degree, linear polynomials are substituted by Taylor shifts.
BY_SHIFTS = 24


@cache
def raiser(by: int) -> fmpz_poly:
    """``(u + v)`` to the power `by`."""
    return U_PLUS_V**by


def from_bezier(points: Sequence[mpq]) -> Form:
    """The form with the given Bézier points.

    >>> from_bezier([mpq(0), mpq(1, 2), mpq(1)])
    (x^2 + x, 1)
    """
    n = len(points) - 1
    integers, m = over_one_denominator([comb(n, i) * b for i, b in enumerate(points)])
    return fmpz_poly(integers), fmpz(m)


def from_integers(points: Sequence[fmpz]) -> fmpz_poly:
    """The polynomial, over the denominator 1, of the form with integer Bézier points.

    >>> from_integers([fmpz(1), fmpz(2), fmpz(1)])
    x^2 + 4*x + 1
    """
    n = len(points) - 1
    return fmpz_poly([comb(n, i) * b for i, b in enumerate(points)])


def bezier(form: Form, n: int) -> list[mpq]:
    """The n+1 Bézier points of a form of degree n (none when n < 0)."""
    c, m = form
    return [ratio(c[i], m * comb(n, i)) for i in range(n + 1)]


def derivative(c: fmpz_poly, n: fmpz) -> fmpz_poly:
    """``(∂v − ∂u)`` of a form of degree n ≥ 1: the derivative with respect to the local parameter, of formal degree
    n−1.
    """
    return c.derivative() * U_PLUS_V - n * c


def quotient_slope(top: fmpz_poly, bottom: fmpz_poly) -> fmpz_poly:
    """The numerator of the derivative of a quotient of two forms of degree n, a form of degree 2n − 2, up to a positive
    constant and a square: its sign is that of the derivative.

    >>> quotient_slope(fmpz_poly([0, 1]), fmpz_poly([1, 1]))  # t
    1
    """
    return top.derivative() * bottom - top * bottom.derivative()


def over_common_denominator(forms: Sequence[Form]) -> tuple[list[fmpz_poly], fmpz]:
    """The polynomials of one or more forms over their least common denominator, and this denominator.

    >>> over_common_denominator([(fmpz_poly([1, 1]), fmpz(2)), (fmpz_poly([1]), fmpz(3))])
    ([3*x + 3, 2], 6)
    """
    common = common_multiple(m for _, m in forms)
    return [c if m == common else c * (common // m) for c, m in forms], common


def add(a: Form, b: Form) -> Form:
    """The sum of two forms of the same degree."""
    (p, k), (q, m) = a, b
    if k == m:
        return p + q, k
    g = k.gcd(m)
    return p * (m // g) + q * (k // g), k * (m // g)


def common_denominators(
    p: Sequence[fmpz_poly], k: Sequence[fmpz], q: Sequence[fmpz_poly], m: Sequence[fmpz]
) -> tuple[tuple[fmpz_poly, ...], tuple[fmpz_poly, ...], tuple[fmpz, ...]]:
    """Two lists of polynomials over the denominators k and m, brought to common denominators."""
    shared = [x // x.gcd(y) for x, y in zip(k, m, strict=True)]
    denominators = tuple([x * y for x, y in zip(shared, m, strict=True)])
    return _times(p, [d // x for d, x in zip(denominators, k, strict=True)]), _times(q, shared), denominators


def _times(polynomials: Sequence[fmpz_poly], factors: Sequence[fmpz]) -> tuple[fmpz_poly, ...]:
    return tuple([c if x == 1 else c * x for c, x in zip(polynomials, factors, strict=True)])


def value(form: Form, n: int, t: mpq) -> mpq:
    """The value of a form of degree n at the local parameter t.

    >>> value(from_bezier([mpq(0), mpq(1, 2), mpq(1)]), 2, mpq(1, 3))
    mpq(1,3)
    """
    c, m = form
    if n < 0:
        return mpq(0)
    if t == 1 or not t:
        return ratio(c[n] if t else c[0], m)
    if n > LONG:
        return _long_value(form, n, t)
    u = 1 - t
    return from_flint(c(to_fmpq(t / u))) * u**n / int(m)


#: From this degree, integers are cheaper than intermediate fractions in lowest terms.
LONG = 24


def _long_value(form: Form, n: int, t: mpq) -> mpq:
    """``Σ c_i bⁿ⁻ⁱ aⁱ / (m qⁿ)`` at ``t = a/q`` with ``b = q − a``, with a single fraction at the end."""
    a, q = to_fmpz(t.numerator), to_fmpz(t.denominator)
    b, power, c = q - a, ONE, form[0].coeffs()
    c += [NOTHING] * (n + 1 - len(c))
    for i in range(n - 1, -1, -1):
        power = power * b
        c[i] = c[i] * power
    return ratio(fmpz_poly(c)(a), form[1] * q**n)


def substituted(c: fmpz_poly, n: int, u: fmpz_poly, v: fmpz_poly) -> fmpz_poly:
    """``Σ c_i uⁿ⁻ⁱ vⁱ`` for two polynomials: restriction, reversal and composition are special cases."""
    if n >= BY_SHIFTS and u.degree() == 1 and v.degree() <= 1:
        return _by_shifts(c, n, u, v)
    result, power = fmpz_poly([]), fmpz_poly([1])
    for i in range(n, -1, -1):
        result = result * v + c[i] * power if i < n else fmpz_poly([c[n]])
        power = power * u if i < n else u
    return result


def _by_shifts(c: fmpz_poly, n: int, u: fmpz_poly, v: fmpz_poly) -> fmpz_poly:
    """The sum `substituted` for linear polynomials, u not constant: with ``u₁ v = v₁ u + Δ`` it is ``uⁿ h(1/u)/u₁ⁿ``
    for a polynomial ``h(y) = Σ c_i u₁ⁿ⁻ⁱ (v₁ + Δ y)ⁱ``, so that two substitutions of linear polynomials in FLINT
    suffice.

    >>> c, u, v = fmpz_poly([1, 2, 3]), fmpz_poly([5, -2]), fmpz_poly([-1, 3])
    >>> _by_shifts(c, 2, u, v) == u * u + 2 * u * v + 3 * v * v
    True
    """
    first, second = u[1], v[1]
    scaled, power = c.coeffs(), fmpz(1)
    for i in range(n, -1, -1):
        if i < len(scaled):
            scaled[i] = scaled[i] * power
        power = power * first
    h = fmpz_poly(scaled)(fmpz_poly([second, first * v[0] - second * u[0]]))
    return backwards(h, n)(u) // first**n


def restrict(form: Form, n: int, a: mpq, b: mpq) -> Form:
    """The form on the part [a, b] of its segment, which may extend beyond the segment, in the local parameter of the
    part.

    >>> restrict(from_bezier([mpq(0), mpq(1)]), 1, mpq(1, 2), mpq(3, 4))
    (3*x + 2, 4)
    """
    if n < 0 or (a == 0 and b == 1):
        return form
    m = int(lcm(a.denominator, b.denominator))
    ia, ib = int(a * m), int(b * m)
    c = substituted(form[0], n, fmpz_poly([m - ia, m - ib]), fmpz_poly([ia, ib]))
    return without_content((c, form[1] * fmpz(m) ** n))


def in_parameter(c: fmpz_poly, n: int, side: Sequence[mpq]) -> tuple[fmpz_poly, fmpz]:
    """A form of degree n over an interval as a polynomial in the parameter, over a positive integer.

    >>> in_parameter(fmpz_poly([0, 0, 1]), 2, (mpq(0), mpq(1, 2)))
    (4*x^2, 1)
    """
    a, b = side
    m = int(lcm(a.denominator, b.denominator))
    low, high = int(a * m), int(b * m)
    return substituted(c, n, fmpz_poly([high, -m]), fmpz_poly([-low, m])), fmpz(high - low) ** n


def of_parameter(p: fmpz_poly, n: int, a: mpq, b: mpq) -> fmpz_poly:
    """The form of degree n over [a, b] of a polynomial, up to a positive constant that depends only on n."""
    m = int(lcm(a.denominator, b.denominator))
    return substituted(p, n, fmpz_poly([m, m]), fmpz_poly([int(a * m), int(b * m)]))


def without_content(form: Form) -> Form:
    """The form without common integer factors of coefficients and denominator."""
    c, m = form
    if not c:
        return ZERO_FORM
    g = c.content().gcd(m)
    return (c // g, m // g) if g != 1 else form


def reverse(form: Form, n: int) -> Form:
    """The reversed form, in 1 − t."""
    c, m = form
    return backwards(c, n), m


def divide_u_plus_v(c: fmpz_poly, at_most: int) -> tuple[fmpz_poly, int]:
    """The quotient after dividing by ``u + v`` while the division is exact, at most this many times; and the number of
    divisions.
    """
    times = 0
    while times < at_most and c(-1) == 0:
        c, times = c // U_PLUS_V, times + 1
    return c, times


def true_degree(form: Form, n: int) -> int:
    """The degree of the polynomial in the parameter, −1 for zero.

    >>> true_degree(from_bezier([mpq(0), mpq(1, 2), mpq(1)]), 2)
    1
    """
    c, _ = form
    return n - divide_u_plus_v(c, n)[1] if c else -1


def blossom(points: Sequence[mpq], arguments: Iterable[mpq]) -> mpq:
    """The polar form of the polynomial with the given Bézier points, at as many local arguments as its degree.

    Arguments 0 and 1 take no arithmetic: they drop the last or the first point.

    >>> blossom([mpq(0), mpq(1, 2), mpq(1)], [mpq(1, 4), mpq(3, 4)])
    mpq(1,2)
    """
    arguments = list(arguments)
    zeros, ones = arguments.count(mpq(0)), arguments.count(mpq(1))
    points = list(points[ones : len(points) - zeros])
    for t in arguments:
        if t not in (0, 1):
            points = [(1 - t) * a + t * b for a, b in pairwise(points)]
    return points[0]


def is_square_class(c: fmpz_poly, n: int) -> bool:
    """Whether the polynomial of a form of degree n is a constant times a square; powers of ``u + v`` are ignored,
    because ``u + v = 1``.

    >>> is_square_class(3 * fmpz_poly([1, 2, 1]), 2), is_square_class(fmpz_poly([1, 2, 1]), 3)
    (True, False)
    >>> is_square_class(2 * fmpz_poly([1, 1]), 1)  # the constant 2
    True
    """
    c, times = divide_u_plus_v(c, n) if c else (c, 0)
    n -= times
    return bool(c) and (n - c.degree()) % 2 == 0 and all(e % 2 == 0 for _, e in factorize_square_free(c).powers)


def compose(outer: Form, n: int, inner: Form, degree: int) -> Form:
    """``outer ∘ inner`` for an inner form of the given degree with values in the local parameter of the outer form."""
    (c, m), (v, k) = outer, inner
    u = k * raiser(degree) - v
    return without_content((substituted(c, n, u, v), m * k**n)) if n > 0 else outer


def variations(c: fmpz_poly) -> int:
    """The number of sign changes in the coefficients: an upper bound for the number of roots inside the segment, with
    the same parity (Descartes).
    """
    changes, last = -1, None
    for x in c.coeffs():
        if x:
            positive = x > NOTHING
            if positive is not last:
                changes, last = changes + 1, positive
    return max(changes, 0)


def halves(c: fmpz_poly, n: int) -> tuple[fmpz_poly, fmpz_poly]:
    """The form on the left and right half of its segment, up to positive constants.

    In ``z = v/u`` the right half is ``z ↦ 1 + 2z``, and the left half is obtained in the same way from the reversed
    form: two Taylor shifts in FLINT.
    """
    return backwards(backwards(c, n)(ONE_PLUS_2Z), n), c(ONE_PLUS_2Z)


def backwards(c: fmpz_poly, n: int) -> fmpz_poly:
    """The integers of a form of degree n in reverse order: the reversed form."""
    coefficients = c.coeffs()
    return fmpz_poly([fmpz(0)] * (n + 1 - len(coefficients)) + coefficients[::-1])
