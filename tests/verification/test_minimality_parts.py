"""The parts of the proofs that degrees are attained: combinations to 1, primes, small exact polynomials."""

import pytest
from flint import fmpz_poly, nmod_poly

from exactspline.certificates.degrees import is_prime
from exactspline.verification.minimality import bezout_combination


@pytest.mark.parametrize(
    "forms",
    [[[5]], [[7, 3], [2, 1]], [[1, 0, 1], [0, 0, 3]], [[-6, 1, 1], [4, 4, 1], [9]], [[2, 0, 2], [3, 3], [0, 5, 0, 1]]],
)
def test_polynomials_without_common_factor_are_combined_to_one(forms):
    polynomials = [fmpz_poly(c) for c in forms]
    p, cofactors = bezout_combination(polynomials, [len(c) - 1 for c in forms])
    total = nmod_poly([], p)
    for c, a in zip(polynomials, cofactors, strict=True):
        total = total + nmod_poly([int(x) for x in a], p) * nmod_poly(c.coeffs(), p)
    assert total == nmod_poly([1], p)
    assert any(int(c[len(f) - 1]) % p for c, f in zip(polynomials, forms, strict=True))


def test_primes_are_told_from_all_others():
    primes = [n for n in range(2, 2000) if all(n % q for q in range(2, int(n**0.5) + 1))]
    assert [n for n in range(-5, 2000) if is_prime(n)] == primes
    for n in (2**61 - 1, 10**18 + 9, 2**31 - 1, 1000003, 1000033):
        assert is_prime(n)
    for n in (561, 1105, 1729, 3215031751, 2**61 + 1, 1000003 * 1000033, 43 * 43, 318665857834031151167461):
        assert not is_prime(n)
    assert not is_prime(2**89 - 1)  # a prime, but beyond what the bases decide
