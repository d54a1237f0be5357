"""Square roots of rational numbers in simplified form."""

from __future__ import annotations

from math import prod

from exactspline.numbers.exact import gcd, is_square, isqrt, mpq, mpz

#: The primes whose squares are removed from a radicand.
_PRIMES = [p for p in range(2, 1000) if all(p % q for q in range(2, int(isqrt(p)) + 1))]
_PRODUCT = prod(_PRIMES, start=mpz(1))


def square_root_parts(q: mpq) -> tuple[mpq, int]:
    """a and b with ``√q = a√b`` for a rational number q ≥ 0; b is 1 if the root is rational.

    >>> square_root_parts(mpq(9, 4)), square_root_parts(mpq(12))
    ((mpq(3,2), 1), (mpq(2,1), 3))
    """
    n = mpz(q.numerator * q.denominator)
    root, radicand = (isqrt(n), mpz(1)) if is_square(n) else without_square_factors(n)
    return mpq(root, q.denominator), int(radicand)


def without_square_factors(n: mpz) -> tuple[mpz, mpz]:
    """An integer n > 0 as ``r² m``, without the squares of small primes in m: r and m.

    >>> without_square_factors(mpz(12))
    (mpz(2), mpz(3))
    """
    root = mpz(1)
    once = gcd(n, _PRODUCT)
    if (twice := gcd(once, n // once)) > 1:
        for prime in (p for p in _PRIMES if twice % p == 0):
            while n % (prime * prime) == 0:
                n, root = n // (prime * prime), root * prime
    return root, n
