"""Polynomials in t whose coefficients are polynomials in one irrational root s: exact arithmetic in the field of s."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import reduce
from itertools import zip_longest
from math import gcd, lcm

from flint import fmpq, fmpq_poly, fmpz, fmpz_mpoly, fmpz_poly, nmod_poly

from exactspline.numbers.exact import mpq, to_fmpq
from exactspline.numbers.once import cached_property
from exactspline.polynomials.cost import QUESTION, check_reach
from exactspline.polynomials.two_parameters import rows_of

ZERO = fmpq_poly([])
#: Nanoseconds of one step of Euclid's algorithm modulo a prime, per coefficient (measured: 40 to 90).
IMAGE = 100
#: The nanoseconds to combine one coefficient with the residues modulo earlier primes, and per earlier prime (measured:
#: 500 to 1600, and 10).
COMBINED, COMBINED_PRIMES = 1500, 10
#: The nanoseconds per bit of the modulus to find a rational number from its residue, and the number of bits for each
#: further nanosecond (measured: 60 to 160, and 150); and the number of coefficients for which this is counted, because
#: most have the denominator of an earlier one.
RATIO, RATIO_BITS, RATIOS = 160, 128, 4
#: Nanoseconds per product in a field and square of its degree, and per bit of the coefficients (measured: half of
#: these).
PRODUCT, PRODUCT_BITS = 4000, 4


class OverRoot:
    """A polynomial in t with coefficients in ``Q[s]/(minimal)``, constant term first, without trailing zeros.

    >>> modulus = fmpq_poly([-2, 0, 1])
    >>> product = OverRoot([fmpq_poly([0, 1]), 1], modulus) * OverRoot([fmpq_poly([0, 1]), 1], modulus)
    >>> product.coefficients  # (t + √2)²
    (2, 2*x, 1)
    """

    __slots__ = ("coefficients", "modulus")

    def __init__(self, coefficients: Sequence[fmpq_poly | int], modulus: fmpq_poly) -> None:
        reduced = [fmpq_poly([x]) if isinstance(x, int) else x % modulus for x in coefficients]
        while reduced and not reduced[-1]:
            reduced.pop()
        self.coefficients, self.modulus = tuple(reduced), modulus

    @classmethod
    def of(cls, p: fmpz_mpoly, modulus: fmpq_poly) -> OverRoot:
        """A polynomial in both parameters, as a polynomial in t over the field."""
        return cls([fmpq_poly(row) for row in rows_of(p)], modulus)

    @property
    def degree(self) -> int:
        """The degree in t, −1 for 0."""
        return len(self.coefficients) - 1

    def __bool__(self) -> bool:
        return bool(self.coefficients)

    def __add__(self, other: OverRoot) -> OverRoot:
        pairs = zip_longest(self.coefficients, other.coefficients, fillvalue=ZERO)
        return OverRoot([a + b for a, b in pairs], self.modulus)

    def __neg__(self) -> OverRoot:
        return self * -1

    def __sub__(self, other: OverRoot) -> OverRoot:
        return self + -other

    def __mul__(self, other: OverRoot | int) -> OverRoot:
        if isinstance(other, int):
            return OverRoot([a * other for a in self.coefficients], self.modulus)
        products = [ZERO] * max(0, len(self.coefficients) + len(other.coefficients) - 1)
        for i, a in enumerate(self.coefficients):
            for j, b in enumerate(other.coefficients):
                products[i + j] += a * b
        return OverRoot(products, self.modulus)

    def __divmod__(self, other: OverRoot) -> tuple[OverRoot, OverRoot]:
        """Quotient and remainder as polynomials in t."""
        inverse, rest = _inverse(other.coefficients[-1], self.modulus), list(self.coefficients)
        quotient = [ZERO] * max(0, self.degree - other.degree + 1)
        for k in range(len(quotient) - 1, -1, -1):
            factor = quotient[k] = rest[k + other.degree] * inverse % self.modulus
            for j, b in enumerate(other.coefficients):
                rest[k + j] = (rest[k + j] - factor * b) % self.modulus
        return OverRoot(quotient, self.modulus), OverRoot(rest, self.modulus)

    def __floordiv__(self, other: OverRoot) -> OverRoot:
        return divmod(self, other)[0]

    def __call__(self, t: mpq) -> fmpq_poly:
        """The value, a polynomial in s."""
        x = to_fmpq(t)
        return reduce(lambda value, c: value * x + c, reversed(self.coefficients), ZERO)

    @property
    def derivative(self) -> OverRoot:
        """The derivative by t."""
        return OverRoot([c * k for k, c in enumerate(self.coefficients)][1:], self.modulus)

    @property
    def radical(self) -> OverRoot:
        """A polynomial with the same zeros, all simple; 0 for 0."""
        return self // self.gcd(self.derivative) if self.degree > 1 else self

    def gcd(self, other: OverRoot) -> OverRoot:
        """The greatest common divisor with the first coefficient 1, computed modulo primes. The result is proved: it
        divides both polynomials, and its degree is that of a common divisor modulo a prime, which is an upper bound.

        Raises `ReachError` if this would take too long.

        >>> modulus, s = fmpq_poly([-2, 0, 1]), fmpq_poly([0, 1])
        >>> OverRoot([-2, 0, 1], modulus).gcd(OverRoot([2, s], modulus)).coefficients
        (x, 1)
        """
        if not (self and other):
            given = self or other
            return given * OverRoot([_inverse(given.coefficients[-1], self.modulus)], self.modulus) if given else given
        images = _Images(self.modulus)
        spent = 0
        for step, prime in enumerate(large_primes()):
            is_tried = step & (step + 1) == 0  # after 1, 2, 4, 8, … primes
            cost = IMAGE * (self.degree + 1) * (other.degree + 1) * (self.modulus.degree() + 10) + images.cost(step)
            if is_tried:
                cost += images.cost_of_trial(self.degree + other.degree)
            check_reach(cost, lambda: "a common divisor over the field of an irrational parameter", QUESTION - spent)
            spent += cost
            image = _divisor_modulo(self, other, prime)
            if image is None or len(image) > images.length:
                continue
            if len(image) == 1:
                return OverRoot([1], self.modulus)
            images.add(image, prime)
            if is_tried:
                found = images.rational()
                if found is not None and not (divmod(self, found)[1] or divmod(other, found)[1]):
                    return found
        raise AssertionError("there are more primes")


class _Images:
    """Images modulo several primes of a polynomial with `length` coefficients, the first one 1, combined into one
    image. The others are multiplied by the derivative of the polynomial of the field: they then have much smaller
    numerators and denominators (R. Dedekind: an integral number times this derivative is a polynomial in the root with
    integer coefficients, if the polynomial is monic).
    """

    def __init__(self, field: fmpq_poly) -> None:
        self.field, self.size, self.length = field, field.degree(), 1 << 60
        self.slope = field.numer().derivative()
        self.values: list[fmpz] = []
        self.modulus = fmpz(1)

    def add(self, image: Sequence[nmod_poly], prime: int) -> None:
        """Combine with a further image; earlier images of a higher degree are wrong and dropped."""
        field, slope = (nmod_poly(p, prime) for p in (self.field.numer(), self.slope))
        own = [fmpz(int(c[k])) for c in (x * slope % field for x in image[:-1]) for k in range(self.size)]
        if len(image) < self.length:
            self.length, self.values, self.modulus = len(image), own, fmpz(prime)
            return
        inverse = fmpz(pow(int(self.modulus), -1, prime))
        self.values = [x + self.modulus * ((y - x) * inverse % prime) for x, y in zip(self.values, own, strict=True)]
        self.modulus *= prime

    def cost(self, primes: int) -> int:
        """The estimated nanoseconds to combine with one more image."""
        return len(self.values) * (COMBINED + COMBINED_PRIMES * primes)

    def cost_of_trial(self, degree: int) -> int:
        """The estimated nanoseconds to find the polynomial and to divide other polynomials, whose degrees have this
        sum, by it.
        """
        bits = self.modulus.bit_length()
        ratios = bits * (RATIOS * (RATIO + bits // RATIO_BITS) + len(self.values))
        return ratios + (degree + 2) * len(self.values) * self.size * (PRODUCT + PRODUCT_BITS * bits // 2)

    def rational(self) -> OverRoot | None:
        """The polynomial with small rational numbers of these images as its coefficients, if there is one; the
        denominators found are tried for the following coefficients.
        """
        found, bottom = list[fmpq](), fmpz(1)
        for x in self.values:
            value = _small_ratio(x * bottom % self.modulus, self.modulus)
            if value is None:
                return None
            found.append(value / bottom)
            bottom *= value.q
        rows = [found[k : k + self.size] for k in range(0, len(found), self.size)]
        return OverRoot([*(fmpq_poly(row) * self._per_slope for row in rows), 1], self.field)

    @cached_property
    def _per_slope(self) -> fmpq_poly:
        return _inverse(fmpq_poly(self.slope), self.field)


def large_primes() -> Iterator[int]:
    """Primes below 2⁶¹, descending."""
    number = (1 << 61) + 1
    while True:
        number -= 2
        if fmpz(number).is_prime():
            yield number


def _small_ratio(x: fmpz, modulus: fmpz) -> fmpq | None:
    """The rational number that is congruent to x modulo a number m, with numerator and denominator below ``√(m/2)``."""
    limit = (modulus // 2).isqrt()
    a, b, p, q = modulus, x, fmpz(0), fmpz(1)
    while b > limit:
        quotient, rest = divmod(a, b)
        a, b, p, q = b, rest, q, p - quotient * q
    return fmpq(b, q) if 0 < abs(q) <= limit else None


def _divisor_modulo(p: OverRoot, q: OverRoot, prime: int) -> list[nmod_poly] | None:
    """The greatest common divisor modulo a prime, with the first coefficient 1, by Euclid's algorithm; None if a
    denominator or a first coefficient is not invertible.
    """
    modulus = nmod_poly(p.modulus.numer(), prime)
    first, second = _modulo(p, prime), _modulo(q, prime)
    if first is None or second is None or modulus.degree() != p.modulus.degree():
        return None
    while second:
        divisor, inverse, _ = second[-1].xgcd(modulus)
        if divisor.degree() != 0:
            return None
        second = [c * inverse % modulus for c in second]
        while len(first) >= len(second):
            leading, shift = first[-1], len(first) - len(second)
            if leading:
                for k, c in enumerate(second[:-1]):
                    first[shift + k] = (first[shift + k] - leading * c) % modulus
            first.pop()
        while first and not first[-1]:
            first.pop()
        first, second = second, first
    return first


def _modulo(p: OverRoot, prime: int) -> list[nmod_poly] | None:
    """The coefficients modulo a prime; None if a denominator or the first coefficient vanishes."""
    images = []
    for c in p.coefficients:
        below = int(c.denom()) % prime
        if not below:
            return None
        images.append(nmod_poly(c.numer(), prime) * pow(below, -1, prime))
    return images if images[-1] else None


def _inverse(x: fmpq_poly, modulus: fmpq_poly) -> fmpq_poly:
    """1/x; it exists because the modulus is irreducible, and FLINT's common divisor is 1."""
    return x.xgcd(modulus)[1]


def by_powers(polynomials: Sequence[OverRoot]) -> list[list[fmpz_poly]]:
    """Each polynomial as a list of polynomials in t with integer coefficients, one for each power of s below the degree
    of the modulus; all are multiplied by the same positive number such that no common factor remains.
    """
    powers = range(polynomials[0].modulus.degree())
    rows = [[fmpq_poly([c[k] for c in p.coefficients]) for k in powers] for p in polynomials]
    bottom = 1
    for p in (p for row in rows for p in row):
        bottom = lcm(bottom, int(p.denom()))
    whole = [[(p * bottom).numer() for p in row] for row in rows]
    shared = gcd(*[int(p.content()) for row in whole for p in row]) or 1
    return [[p // shared for p in row] for row in whole]
