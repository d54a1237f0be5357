"""The parts of the proofs that degrees are attained: combinations to 1, primes, small exact polynomials."""

import pytest
from flint import fmpz_poly, nmod_poly

from exactspline.certificates import check_certificate
from exactspline.certificates.degrees import is_prime
from exactspline.certificates.numbers import integer
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


def quotient(forms, cofactors):
    """A certificate of a quotient of degree 1, modulo 5."""
    segment = {"degree": 1, "prime": 5, "forms": forms, "cofactors": cofactors}
    return {"format": "exactspline certificate 1", "what": "degree", "kind": "quotient", "segments": [segment]}


def test_a_component_that_vanishes_does_not_lower_the_degree():
    """2 (1 + u) − (1 + 2u) = 1."""
    forms = [["1", "1"], ["0", "0"], ["1", "2"]]
    assert check_certificate(quotient(forms, [["2"], [], ["4"]])) == {"degree": 1}


@pytest.mark.parametrize("forms", [[["1", "1"], ["1"]], [["0", "0"], ["0", "0"]]])
def test_every_form_has_the_degree_claimed(forms):
    """A mutant passed: degree 1 proved of a form of degree 1 and a number."""
    with pytest.raises(ValueError, match="a form of another degree"):
        check_certificate(quotient(forms, [[], ["1"]]))


@pytest.mark.parametrize("length", [599, 600, 601, 602, 603, 1201, 1207])
def test_integers_of_many_digits_are_read_in_parts(length):
    """A mutant read digits twice where their number is odd."""
    digits = "".join(str(i * i % 9 + 1) for i in range(length))
    assert integer(digits) == sum(int(x) * 10**i for i, x in enumerate(reversed(digits)))


def zero_set(form, weight, cofactors):
    """A certificate of a zero set of degree 1, modulo 5."""
    segment = {"degree": 1, "prime": 5, "forms": [form], "weight": weight, "cofactors": cofactors}
    return quotient([], []) | {"kind": "zero set", "segments": [segment | {"irreducible modulo": None}]}


def test_a_form_of_lower_degree_in_the_parameter_is_refused():
    """A mutant passed: (1 − t) + t proved to be of degree 1; and it refused (1 − t) + 2t."""
    assert check_certificate(zero_set(["1", "2"], ["1", "1"], [["4"], ["2"]])) == {"degree": 1}
    with pytest.raises(ValueError, match="the degree in the parameter is lower"):
        check_certificate(zero_set(["1", "1"], ["1", "2"], [["2"], ["4"]]))


def test_a_prime_that_divides_the_highest_coefficient_shows_no_irreducibility():
    """A mutant passed: 1 + 10u irreducible modulo 5, where it is 1."""
    certificate = zero_set(["1", "10"], ["1", "1"], [["1"], []])
    assert check_certificate(certificate) == {"degree": 1}
    certificate["segments"][0]["irreducible modulo"] = 5
    with pytest.raises(ValueError, match="not irreducible"):
        check_certificate(certificate)
