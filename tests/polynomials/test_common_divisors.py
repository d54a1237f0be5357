"""Greatest common divisors and products in many variables: those of FLINT, of a cost that is bounded beforehand."""

import time
from operator import add, mul
from random import Random

import pytest
from flint import Ordering, fmpq, fmpq_mpoly_ctx, fmpq_poly

from exactspline.errors import ReachError
from exactspline.language.kinds import CURVE
from exactspline.polynomials import factors
from exactspline.polynomials.cost import Budget, drawing_on
from exactspline.polynomials.factors import bounded_product, greatest_common_divisor
from exactspline.polynomials.over_root import OverRoot
from exactspline.readings.jet import JetFraction, RationalJetReading

NAMES = [f"x{i}" for i in range(8)]
RING = fmpq_mpoly_ctx.get(NAMES, Ordering.degrevlex)


def polynomial(random, terms, degree=3, bits=8):
    """A sparse polynomial with a constant term."""
    found = {(0,) * len(NAMES): fmpq(1)}
    for _ in range(terms):
        exponents = [0] * len(NAMES)
        for _ in range(degree):
            exponents[random.randrange(len(NAMES))] += 1
        found[tuple(exponents)] = fmpq(random.getrandbits(bits) + 1, random.randint(1, 3))
    return RING.from_dict(found)


def test_divisors_are_those_of_flint():
    random = Random(17)
    for _ in range(20):
        g, a, b = (polynomial(random, 4) for _ in range(3))
        assert greatest_common_divisor([g * a, g * b]) == (g * a).gcd(g * b)
        p, q, r = (fmpq_poly([fmpq(random.randint(-9, 9), 7) for _ in range(4)]) for _ in range(3))
        assert greatest_common_divisor([p * r, q * r]) == (p * r).gcd(q * r)
    zero = RING.constant(0)
    assert greatest_common_divisor([zero, g]) == g / g.leading_coefficient()
    assert greatest_common_divisor([zero, zero]) == 0
    assert greatest_common_divisor([fmpq_poly([]), fmpq_poly([2, 4])]) == fmpq_poly([fmpq(1, 2), 1])


def test_a_divisor_in_many_variables_out_of_reach_is_refused_at_once(monkeypatch):
    """Passed before: whatever FLINT takes, in one call. That there is no common factor is still seen on a line."""
    random = Random(3)
    monkeypatch.setattr(factors, "DIVISOR_TERM", 10**9)
    g, a, b = (polynomial(random, 6) for _ in range(3))
    assert (a.gcd(b)).is_one()
    assert greatest_common_divisor([a, b]).is_one()
    with pytest.raises(ReachError, match="the greatest common divisor of polynomials of") as error:
        greatest_common_divisor([g * a, g * b])
    assert error.value.data["seconds"] > 10
    with drawing_on(Budget(10**4)), pytest.raises(ReachError):
        greatest_common_divisor([a, b])


def test_a_line_never_hides_a_common_factor():
    random = Random(8)
    for terms in (1, 2, 5):
        for _ in range(30):
            g, a, b = (polynomial(random, terms, degree=2) for _ in range(3))
            assert not factors._certainly_coprime_on_a_line(g * a, g * b)
    x, y = RING.gens()[:2]
    assert not factors._certainly_coprime_on_a_line(x * (y + 1), x * (y + 2))
    assert factors._certainly_coprime_on_a_line(x * (y + 1), y)


def test_what_the_bound_allows_is_done_within_it():
    """The estimate is an upper one: of sparse and of dense polynomials, of long coefficients."""
    random = Random(5)
    for terms, degree, bits in ((30, 3, 8), (30, 6, 8), (20, 3, 300), (60, 8, 8)):
        p, q = (polynomial(random, terms, degree, bits) for _ in range(2))
        g = polynomial(random, terms, degree, bits)
        p, q, budget = g * p, g * q, Budget(10**12)
        start = time.process_time()
        with drawing_on(budget):
            greatest_common_divisor([p, q])
        assert time.process_time() - start < (budget.total - budget.remaining) / 10**9


def test_products_of_too_many_pairs_are_refused(monkeypatch):
    monkeypatch.setattr(factors, "PAIRS", 30)
    random = Random(2)
    p, q = polynomial(random, 4), polynomial(random, 9)
    assert bounded_product(p, p) == p * p
    with pytest.raises(ReachError, match="a product of"):
        bounded_product(p, q)
    monkeypatch.setattr(factors, "TERMS", 3)
    with pytest.raises(ReachError, match="a polynomial of"):
        bounded_product(p, p)


def test_sums_of_quotients_are_bounded_like_products(monkeypatch):
    """Passed before: the numerators of a sum were multiplied whatever their number of terms."""
    c = RationalJetReading(1).argument(CURVE, 2)
    x, y, w = *c.p, c.w
    one, other = (x + y + w) / (x + w), (x - y) / (y + w + 1)
    assert isinstance(one + other, JetFraction)
    monkeypatch.setattr(factors, "PAIRS", 4)
    for combine in (add, mul):
        with pytest.raises(ReachError, match="a product of"):
            combine(one, other)
    with pytest.raises(ReachError, match="a product of"):
        (one / other).d()


def test_a_divisor_over_a_field_is_counted_with_its_reconstruction():
    """Passed before: a minute in the search for rational numbers modulo primes, of which nothing was counted."""
    modulus, shared = fmpq_poly([-2, 0, 0, 0, 0, 1]), [fmpq_poly([1 << 3000, 3, 1 << 2999]), 1]
    one, other = (OverRoot(shared, modulus) * OverRoot([k, 1], modulus) for k in (2, 5))
    with drawing_on(Budget()) as paid:
        assert one.gcd(other).coefficients == OverRoot(shared, modulus).coefficients
    assert paid.total - paid.remaining > 20 * 10**6
    with drawing_on(Budget(10**7)), pytest.raises(ReachError, match="a common divisor over the field"):
        one.gcd(other)


def test_primes_that_divide_a_denominator_are_passed_over():
    """A mutant ended in an error: the first prime below 2⁶¹ is the denominator of a coefficient of either operand."""
    modulus, prime = fmpq_poly([-2, 0, 1]), (1 << 61) - 1
    shared, one, other = (OverRoot([fmpq_poly([fmpq(1, k)]), 1], modulus) for k in (prime, 3, 5))
    for first, second in ((shared * one, shared), (shared, shared * other), (shared * one, shared * other)):
        assert first.gcd(second).coefficients == shared.coefficients
    assert one.gcd(shared).coefficients == shared.gcd(one).coefficients == OverRoot([1], modulus).coefficients
