"""Polynomials in t whose coefficients are polynomials in one irrational root s: exact arithmetic in the field of s."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import zip_longest
from math import gcd, lcm

from flint import fmpq_poly, fmpz_mpoly, fmpz_poly, nmod_poly

from exactspline.polynomials.cost import QUESTION, check_reach
from exactspline.polynomials.two_parameters import rows_of

ZERO = fmpq_poly([])
#: Primes modulo which polynomials are tried.
PRIMES = tuple((1 << 61) - k for k in (1, 31, 45, 229, 259, 283, 339, 391, 403, 465))
#: Nanoseconds, per bit of the numbers with which Euclid's algorithm begins and times powers of the degrees (measured: 3
#: to 15).
EUCLID = 20


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
        """A polynomial in both parameters."""
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

    def gcd(self, other: OverRoot) -> OverRoot:
        """The greatest common divisor, its first coefficient 1: Euclid's algorithm.

        >>> modulus, s = fmpq_poly([-2, 0, 1]), fmpq_poly([0, 1])
        >>> OverRoot([-2, 0, 1], modulus).gcd(OverRoot([2, s], modulus)).coefficients
        (x, 1)
        """
        if self and other:
            most = _most(self, other)
            if most == 0:
                return OverRoot([1], self.modulus)
            cost = _cost(self, other, most)
            check_reach(cost, lambda: "a common divisor over the field of an irrational parameter", QUESTION)
        a, b = self, other
        while b:
            a, b = b, divmod(a, b)[1]
        return a * OverRoot([_inverse(a.coefficients[-1], self.modulus)], self.modulus) if a else a


def _cost(p: OverRoot, q: OverRoot, common: int) -> int:
    """An estimate of the time of Euclid's algorithm in nanoseconds; its numbers grow until the common degree is
    reached.
    """
    k, n = p.modulus.degree(), max(p.degree, q.degree)
    bits = max(max(c.numer().height_bits(), int(c.denom()).bit_length()) for f in (p, q) for c in f.coefficients if c)
    return EUCLID * n**2 * (n - common + 1) ** 2 * k**3 * bits


def _most(p: OverRoot, q: OverRoot) -> int:
    """A bound on the degree of a common divisor: that of the images at a simple root of the modulus modulo a prime,
    where one of them has the same degree as its image.
    """
    for prime in PRIMES:
        modulus = nmod_poly(p.modulus.numer(), prime)
        roots = [int(r) for r, times in modulus.roots() if times == 1]
        if modulus.degree() != p.modulus.degree() or not roots:
            continue
        images = [_image(f, roots[0], prime) for f in (p, q)]
        first, second = images
        if first is None or second is None or first.degree() != p.degree:
            continue
        return int(first.gcd(second).degree())
    return min(p.degree, q.degree)


def _image(p: OverRoot, root: int, prime: int) -> nmod_poly | None:
    """The polynomial modulo a prime at a root of the modulus; None where a denominator vanishes."""
    values = []
    for c in p.coefficients:
        below = int(c.denom()) % prime
        if not below:
            return None
        values.append(int(nmod_poly(c.numer(), prime)(root)) * pow(below, -1, prime))
    return nmod_poly([x % prime for x in values], prime)


def _inverse(x: fmpq_poly, modulus: fmpq_poly) -> fmpq_poly:
    """1/x; it exists because the modulus is irreducible."""
    divisor, inverse, _ = x.xgcd(modulus)
    return inverse / divisor[0]


def by_powers(polynomials: Sequence[OverRoot]) -> list[list[fmpz_poly]]:
    """Each as polynomials in t with integer coefficients, one for each power of s below the degree of the modulus, all
    multiplied by one positive number such that no common factor remains.
    """
    powers = range(polynomials[0].modulus.degree())
    rows = [[fmpq_poly([c[k] for c in p.coefficients]) for k in powers] for p in polynomials]
    bottom = 1
    for p in (p for row in rows for p in row):
        bottom = lcm(bottom, int(p.denom()))
    whole = [[(p * bottom).numer() for p in row] for row in rows]
    shared = gcd(*[int(p.content()) for row in whole for p in row]) or 1
    return [[p // shared for p in row] for row in whole]
