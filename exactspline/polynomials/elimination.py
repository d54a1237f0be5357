"""Discriminants and resultants of polynomials in two variables, by evaluation at integers and interpolation: an
interruptible loop with a cost that is bounded beforehand.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from itertools import chain, islice, pairwise, zip_longest

from flint import fmpq_poly, fmpz, fmpz_mat, fmpz_poly, nmod_poly

from exactspline.numbers.exact import mpq, mpz, sign, to_fmpq
from exactspline.numbers.intervals import Interval
from exactspline.polynomials.cost import LONGEST_LOOP, check_reach, height_bits
from exactspline.polynomials.factors import greatest_common_divisor

#: The costs in hundredths of a nanosecond per bit of a value: to compute it, times the product of the degrees, and to
#: interpolate, times the number of values (measured: 77 to 106, and 11 to 15). Then the cost in ten-thousandths of a
#: nanosecond per pair of bits to compute a value from its residues modulo many primes (measured for 5·10⁴ to 2·10⁶
#: bits: 1 to 18).
VALUE, INTERPOLATION, RESIDUES = 110, 15, 15


def discriminant(rows: Sequence[fmpz_poly]) -> fmpz_poly:
    """The discriminant with respect to u of ``Σ rows[j](z) uʲ``, of degree m > 1 in u.

    The discriminant is a form of degree 2m − 2 in the rows, so that its degree in z is bounded. The discriminant is
    determined by its values at sufficiently many consecutive integers at which the leading row does not vanish. Raises
    `ReachError` if this would take too long.

    >>> discriminant([fmpz_poly([0, 1]), fmpz_poly([3]), fmpz_poly([1, 1])])
    (-4)*x^2 + (-4)*x + 9
    """
    m = len(rows) - 1
    degree = max(row.degree() for row in rows)
    bound = (2 * m - 2) * degree
    bits = (2 * m - 1) * (bits_of_values(rows, bound) + m.bit_length())
    _check(bound + 1, m * m, bits, f"the discriminant of a polynomial of degree {degree} × {m}")
    start = first_integer(rows[-1], bound + 1)
    return _through_whole([_at(rows, k).discriminant() for k in range(start, start + bound + 1)], start)


def resultant(first: Sequence[fmpz_poly], second: Sequence[fmpz_poly]) -> fmpz_poly:
    """The resultant with respect to u of two sums as in `discriminant`, of degrees m and n in u. The resultant is a
    form of degree n in the rows of the first sum and of degree m in the rows of the second. Raises `ReachError` if this
    would take too long.

    >>> resultant([fmpz_poly([0, 1]), fmpz_poly([1])], [fmpz_poly([-2]), fmpz_poly([]), fmpz_poly([1])])
    x^2 + (-2)
    """
    m, n = len(first) - 1, len(second) - 1
    bound = n * max(row.degree() for row in first) + m * max(row.degree() for row in second)
    bits = n * bits_of_values(first, bound) + m * bits_of_values(second, bound) + (m + n) * (m + n).bit_length()
    _check(bound + 1, max(m, 1) * max(n, 1), bits, f"the resultant of degree {bound} of two polynomials")
    start = first_integer(first[-1] * second[-1], bound + 1)
    return _through_whole([_at(first, k).resultant(_at(second, k)) for k in range(start, start + bound + 1)], start)


def bits_of_values(rows: Sequence[fmpz_poly], count: int) -> int:
    """The number of bits of the values of the rows at this many consecutive integers around 0."""
    return max(height_bits(row.coeffs()) + (row.degree() + 1) * count.bit_length() for row in rows)


def _check(count: int, size: int, bits: int, what: str) -> None:
    cost = count * bits * (size * VALUE + count * INTERPOLATION + bits * RESIDUES // 100) // 100
    check_reach(cost, lambda: f"{what} with values of {bits} bits", LONGEST_LOOP)


def _at(rows: Sequence[fmpz_poly], k: int) -> fmpz_poly:
    return fmpz_poly([row(k) for row in rows])


def _through_whole(values: Sequence[fmpz], start: int) -> fmpz_poly:
    """The polynomial with these values at consecutive integers beginning at `start`."""
    return through([mpz(int(value)) for value in values])(fmpz_poly([-start, 1]))


def first_integer(leading: fmpz_poly, count: int) -> int:
    """The first of this many consecutive integers, close to 0, at which a polynomial does not vanish."""
    start = k = -(count // 2)
    while k < start + count:
        if leading(k) == 0:
            start = k + 1
        k += 1
    return start


def through(values: Sequence[mpz]) -> fmpz_poly:
    """The polynomial with these values at 0, 1, 2, …, with a degree less than their number and with integer
    coefficients, by Newton's forward differences.

    >>> through([mpz(1), mpz(2), mpz(5), mpz(10)])
    x^2 + 1
    """
    differences, row = [], list(values)
    factorial = mpz(1)
    for k in range(len(values)):
        differences.append(row[0])
        row = [b - a for a, b in pairwise(row)]
        factorial *= max(k, 1)
    # Horner's rule in x, x − 1, …, over a factorial as the common denominator, by which the result is divisible
    total, scale = fmpz_poly([]), mpz(1)
    for k in range(len(values) - 1, -1, -1):
        total = total * fmpz_poly([-k, 1]) + fmpz_poly([fmpz(int(differences[k] * scale))])
        scale *= max(k, 1)
    return total // fmpz(int(factorial))


# ---- polynomials that vanish at sums, products, … of algebraic numbers
#
# Each is a resultant `Res_y(p(y), h(x, y))` (`exactspline.polynomials.elimination`), whose cost is estimated
# beforehand; a `ReachError` is raised if it exceeds the bound.
#
# Source: Loos, Computing in algebraic extensions, 1982.


#: The highest degree of a polynomial that may be computed.
DEGREE = 200
#: The cost of arithmetic modulo a polynomial: nanoseconds per coefficient bit times the degree.
ARITHMETIC = 10
#: The nanoseconds per bit of the reduction of a lattice and of the number in it (measured: 500 to 8000), and the bound
#: on the sum of these bits.
LATTICE, REDUCTION = 8000, 10**9
#: The primes modulo which a polynomial is tested for rational zeros, and further ones for quadratic zeros.
PRIMES, FURTHER = (7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43), (47, 53, 59, 61, 67, 71, 73, 79, 83, 89, 97)
#: The polynomials x and 1.
X, ONE = fmpz_poly([0, 1]), fmpz_poly([1])


def _check_size(degree: int, bits: int) -> None:
    """Raise `ReachError` if a polynomial of this degree, with coefficients of this many bits, is too expensive."""
    cost = degree * degree * bits * ARITHMETIC
    check_reach(cost if degree <= DEGREE else max(cost, 10**10), lambda: f"a polynomial of degree {degree}")


def sum_of(p: fmpz_poly, q: fmpz_poly) -> fmpz_poly:
    """A polynomial that vanishes at all sums of a zero of p and a zero of q.

    >>> sum_of(fmpz_poly([-2, 0, 1]), fmpz_poly([-3, 0, 1]))
    x^4 + (-10)*x^2 + 1
    """
    n = q.degree()
    _check_size(p.degree() * n, 0)
    # q(x − y) = Σ q⁽ʲ⁾(x) (−y)ʲ / j!
    rows, derivative, factorial = [], q, fmpz(1)
    for j in range(n + 1):
        rows.append(derivative // factorial if j % 2 == 0 else -derivative // factorial)
        derivative, factorial = derivative.derivative(), factorial * (j + 1)
    return primitive(resultant(_rows(p), rows))


def product_of(p: fmpz_poly, q: fmpz_poly) -> fmpz_poly:
    """A polynomial that vanishes at all products of a zero of p and a zero of q.

    >>> product_of(fmpz_poly([-2, 0, 1]), fmpz_poly([-3, 1]))
    x^2 + (-18)
    """
    zeros = next(i for i in range(q.degree() + 1) if q[i] != 0)
    q = q.right_shift(zeros)
    n = q.degree()
    _check_size(p.degree() * n, 0)
    # yⁿ q(x/y) = Σ qₙ₋ᵢ xⁿ⁻ⁱ yⁱ
    product = primitive(resultant(_rows(p), [fmpz_poly([q[n - i]]).left_shift(n - i) for i in range(n + 1)]))
    return product * X if zeros and product[0] != 0 else product


def negated(p: fmpz_poly) -> fmpz_poly:
    """The polynomial whose zeros are the negatives of those of p."""
    return primitive(p(fmpz_poly([0, -1])))


def inverted(p: fmpz_poly) -> fmpz_poly:
    """The polynomial whose zeros are the reciprocals of the non-zero zeros of p.

    >>> inverted(fmpz_poly([0, -2, 0, 3]))
    2*x^2 + (-3)
    """
    return primitive(fmpz_poly([*reversed(p.coeffs())]))


def square_root_of(p: fmpz_poly) -> fmpz_poly:
    """The polynomial whose zeros are both square roots of every zero of p."""
    _check_size(2 * p.degree(), p.height_bits())
    return p(fmpz_poly([0, 0, 1]))


def quotient_at(m: fmpz_poly, top: fmpq_poly, bottom: fmpq_poly) -> fmpz_poly:
    """A polynomial that vanishes at ``top(α)/bottom(α)`` for all zeros α of m at which `top` and `bottom` do not both
    vanish.

    >>> quotient_at(fmpz_poly([-2, 0, 1]), fmpq_poly([1, 1]), fmpq_poly([0, 1]))  # (√2 + 1)/√2
    2*x^2 + (-4)*x + 1
    """
    f, g = integral(top, bottom)
    # m may have multiple factors
    while (common := greatest_common_divisor([f, g, m])).degree() > 0:
        m = m // common
    _check_size(m.degree(), max(f.height_bits(), g.height_bits()))
    return primitive(_over_quotients(*(tuple(p.coeffs()) for p in (m, f, g))))


@lru_cache(64)
def _over_quotients(m: tuple[fmpz, ...], f: tuple[fmpz, ...], g: tuple[fmpz, ...]) -> fmpz_poly:
    """The polynomial of all quotients. The polynomial is cached, because values of one function at several zeros of a
    polynomial are compared with one another.
    """
    return resultant(_rows(fmpz_poly(list(m))), [fmpz_poly([-a, b]) for a, b in zip_longest(f, g, fillvalue=fmpz())])


def without_quadratic_zero(m: fmpz_poly, top: fmpz_poly, bottom: fmpz_poly, *, squared: bool = False) -> bool:
    """Whether it is certain that no ``top(α)/bottom(α)``, for a zero α of m at which `bottom` does not vanish, is a
    zero of a polynomial of degree 1 or 2: modulo a prime that does not divide the leading coefficient, such a
    polynomial would be a factor of the polynomial whose zeros are all the quotients. False decides nothing. With
    `squared` the same about the square roots of the quotients.

    >>> alpha = fmpz_poly([-2, 0, 0, 1])
    >>> [without_quadratic_zero(alpha, fmpz_poly(top), fmpz_poly([3])) for top in ([1, 1], [0, 0, 0, 1])]
    [True, False]
    """
    first = _first_good_prime(tuple(m.coeffs()))
    return any(
        _is_large(nmod_poly(top, prime), nmod_poly(bottom, prime), over, far, squared=squared)
        for prime, over, far in (chain(first, _good_primes(m)) if first else ())
    )


def _good_primes(m: fmpz_poly) -> Iterator[tuple[int, nmod_poly, nmod_poly]]:
    """Primes p modulo which a polynomial keeps its degree and has no factor of degree 1 or 2, with the polynomial and
    ``x^(p²)`` modulo the prime.
    """
    for prime in (*PRIMES, *FURTHER) if m.degree() > 2 else ():
        over, x = nmod_poly(m, prime), nmod_poly(X, prime)
        if over.degree() == m.degree() and ((far := pow(x, prime**2, over)) - x).gcd(over).degree() < 1:
            yield prime, over, far


@lru_cache(256)
def _first_good_prime(coefficients: tuple[fmpz, ...]) -> list[tuple[int, nmod_poly, nmod_poly]]:
    """The first of these primes, if there is one. It is cached, because many values are computed at zeros of the same
    polynomial.
    """
    return [*islice(_good_primes(fmpz_poly(list(coefficients))), 1)]


def _is_large(f: nmod_poly, g: nmod_poly, over: nmod_poly, far: nmod_poly, *, squared: bool) -> bool:
    """Whether ``f/g``, or with `squared` its square root, has no degree below 3 modulo any factor of a polynomial, for
    a prime p of `_good_primes`: whether it is never its own p²-th power, for which x is replaced by the power of x.
    """
    f, g = f % over, g % over
    if squared:
        half = int(over.modulus()) ** 2 // 2
        rest = (pow(f, half, over) - pow(g, half, over)) * f
    else:
        rest = f.compose_mod(far, over) * g - g.compose_mod(far, over) * f
    return (rest * g).gcd(over).degree() < 1


def at_most_quadratic(
    enclosed: Callable[[int], Interval], bits: int, vanishes: Callable[[fmpz_poly], bool]
) -> fmpz_poly | None:
    """A polynomial of degree 1 or 2 with a given zero, which is given by enclosures to any number of digits; None if it
    is certain that no such polynomial has coefficients of at most this many bits.

    The coefficients A, B, C are a vector ``(A, B, 2ᵏ (A x² + B x + C))`` of a lattice, with x² and x rounded to
    multiples of 2⁻ᵏ. If x is a zero, the vector has at most the length ``√18 2ᵇⁱᵗˢ``. If all Gram–Schmidt vectors of a
    basis are longer, there is no such vector.

    >>> at_most_quadratic(lambda digits: Interval(mpq(2, 3), mpq(2, 3)), 3, lambda p: p(to_fmpq(mpq(2, 3))) == 0)
    3*x + (-2)

    Raises `ReachError` if this takes too many bits.

    Source: Kannan, Lenstra and Lovász, Polynomial factorization and nonrandomness of bits of algebraic and some
    transcendental numbers, Mathematics of Computation 1988.
    """
    size, exponent = enclosed(1).low, 3 * bits + 32
    while True:
        check_reach(exponent * LATTICE, lambda: f"a polynomial with coefficients of {bits} bits", REDUCTION)
        longest = fmpz(32) << 2 * bits
        x = enclosed((exponent + 2 * (abs(int(size)) + 2).bit_length()) * 30103 // 100000 + 1).middle
        scale = fmpz(1) << exponent
        square, single = (fmpz(int(power * int(scale) // 1)) for power in (x * x, x))
        basis = fmpz_mat([[1, 0, square], [0, 1, single], [0, 0, scale]]).lll()
        gram = basis * basis.transpose()
        first, both = gram[0, 0], gram[0, 0] * gram[1, 1] - gram[0, 1] ** 2
        if first > longest and both > longest * first and basis.det() ** 2 == scale**2 > longest * both:
            return None
        a, b, rest = (basis[0, k] for k in range(3))
        found = primitive(fmpz_poly([(rest - a * square - b * single) // scale, b, a]))
        if vanishes(found):
            return found
        exponent *= 2


def integral(top: fmpq_poly, bottom: fmpq_poly) -> tuple[fmpz_poly, fmpz_poly]:
    """Numerator and denominator of a quotient with integer coefficients."""
    return top.numer() * bottom.denom(), bottom.numer() * top.denom()


def _rows(p: fmpz_poly) -> list[fmpz_poly]:
    """A polynomial in y as a polynomial in x and y."""
    return [fmpz_poly([c]) for c in p.coeffs()]


def primitive(p: fmpz_poly) -> fmpz_poly:
    """The polynomial divided by its content, with a positive leading coefficient."""
    return p // (p.content() if p.leading_coefficient() > 0 else -p.content()) if p else p


def square_free(p: fmpz_poly) -> fmpz_poly:
    """The square-free part: the polynomial with the same zeros, all simple.

    >>> square_free(fmpz_poly([1, 2, 1]))
    x + 1
    """
    return primitive(p // greatest_common_divisor([p, p.derivative()]))


def without_rational_zero(p: fmpz_poly) -> bool:
    """Whether it is certain that no zero is rational: a rational zero is a zero modulo every prime that does not divide
    the leading coefficient. False decides nothing.

    >>> [without_rational_zero(fmpz_poly(c)) for c in ([-2, 0, 1], [-4, 0, 1])]
    [True, False]
    """
    return any(_no_zero_modulo(p, prime) for prime in PRIMES)


def _no_zero_modulo(p: fmpz_poly, prime: int) -> bool:
    """Whether a polynomial of degree at least 1 keeps its degree modulo a prime and has no zero modulo the prime."""
    residues, x = nmod_poly(p, prime), nmod_poly(X, prime)
    return residues.degree() == p.degree() > 0 and (pow(x, prime, residues) - x).gcd(residues).degree() < 1


def linear(value: mpq) -> fmpz_poly:
    """The primitive linear polynomial with a rational zero.

    >>> linear(mpq(2, 3))
    3*x + (-2)
    """
    return fmpz_poly([int(-value.numerator), int(value.denominator)])


def sign_of_value(p: fmpz_poly, t: mpq) -> int:
    """The sign of a polynomial at a rational number."""
    return sign(p(to_fmpq(t)))


class QuotientModulo:
    """``top(α)/bottom(α)`` for a zero α of a polynomial, with arithmetic `+ − * /`.

    >>> y = QuotientModulo(fmpz_poly([-2, 0, 1]), fmpq_poly([0, 1]))
    >>> ((y + y) * y).top, (y / y - y).top
    (4, x + (-2))
    """

    __slots__ = ("bottom", "modulus", "top")

    def __init__(self, modulus: fmpz_poly, top: fmpq_poly, bottom: fmpq_poly | None = None) -> None:
        self.modulus, self.top = modulus, top
        self.bottom = fmpq_poly([1]) if bottom is None else bottom

    def _made(self, top: fmpq_poly, bottom: fmpq_poly) -> QuotientModulo:
        n = self.modulus.degree()
        if top.degree() >= n or bottom.degree() >= n:
            m = fmpq_poly(self.modulus)
            top, bottom = top % m, bottom % m
        _check_size(n, max(p.numer().height_bits() + p.denom().bit_length() for p in (top, bottom)))
        return QuotientModulo(self.modulus, top, bottom)

    def __add__(self, other: QuotientModulo) -> QuotientModulo:
        if self.bottom == other.bottom:
            return self._made(self.top + other.top, self.bottom)
        return self._made(self.top * other.bottom + other.top * self.bottom, self.bottom * other.bottom)

    def __sub__(self, other: QuotientModulo) -> QuotientModulo:
        return self + QuotientModulo(self.modulus, -other.top, other.bottom)

    def __mul__(self, other: QuotientModulo) -> QuotientModulo:
        return self._made(self.top * other.top, self.bottom * other.bottom)

    def __truediv__(self, other: QuotientModulo) -> QuotientModulo:
        return self._made(self.top * other.bottom, self.bottom * other.top)
