"""Factorizations and eliminations: right for coefficients of any size, and refused beforehand where they would hang."""

import time
from itertools import product
from math import prod
from random import Random

import pytest
from flint import Ordering, fmpq, fmpq_mpoly_ctx, fmpq_poly, fmpz, fmpz_mpoly_ctx, fmpz_poly, nmod_poly
from gmpy2 import mpq

from exactspline.errors import ReachError
from exactspline.extras.coq.theorems import Nonzero
from exactspline.polynomials import elimination, factors
from exactspline.polynomials.cost import Budget, affords, check_reach, drawing_on, height_bits
from exactspline.polynomials.elimination import discriminant
from exactspline.polynomials.factors import (
    Factorization,
    factorize,
    factorize_square_free,
    greatest_common_divisor,
    power_text,
    prime_factors,
)
from exactspline.polynomials.over_root import OverRoot, large_primes
from exactspline.roots.of_polynomials import check_isolation
from exactspline.verification.divisors import factored

CONTEXT = fmpz_mpoly_ctx.get(["s", "t"], Ordering.lex)
S, T = CONTEXT.gens()
Z = fmpz_poly([0, 1])
SIZES = {"small": 5, "32 bits": 1 << 32, "doubles": 1 << 110, "1e300": 10**300}
over_sizes = pytest.mark.parametrize("size", SIZES.values(), ids=SIZES)


def product_of(found, one):
    return prod((base**e for base, e in found.powers), start=one) * found.constant


@over_sizes
def test_factors_in_two_variables_of_any_size(size):
    """Before: `OverflowError` from FLINT's order of two factors whose coefficients are beyond 31 bits."""
    random = Random(1)
    for _ in range(40):
        a, b, c, d = (random.randint(1, size) for _ in range(4))
        p = (a * S - b * T + c) ** 2 * (a * S + d * T + 1) * (S * T * c - d) * -6
        found = factorize(p)
        assert product_of(found, S * 0 + 1) == p
        assert len(found.bases) == 3
        assert all(base.leading_coefficient() > 0 for base in found.bases)


@over_sizes
def test_factors_in_one_variable_of_any_size(size):
    random = Random(2)
    for _ in range(20):
        a, b, c = (random.randint(1, size) for _ in range(3))
        p = (a * Z - b) ** 2 * (c * Z * Z + b * Z + a) * -4
        assert product_of(factorize(p), fmpz_poly([1])) == p
        assert product_of(factorize_square_free(p), fmpz_poly([1])) == p


def test_factors_over_the_rationals_and_modulo_a_prime():
    s, t = fmpq_mpoly_ctx.get(["s", "t"], Ordering.lex).gens()
    assert product_of(factorize((s - t) * (s + t) / 3), s * 0 + 1) == (s - t) * (s + t) / 3
    assert [e for _, e in factorize(nmod_poly([1, 2, 1], 7)).powers] == [2]


def test_a_factorization_that_is_wrong_is_not_believed():
    with pytest.raises(ArithmeticError, match="is not the polynomial"):
        factors._believed(Z * Z - 1, 1, [(Z - 1, 2)])


@pytest.mark.parametrize("size", [100, 10**60, 10**300])
def test_what_is_called_irreducible_modulo_primes_is(size):
    """Products are never called irreducible, most others are."""
    random = Random(3)

    def some(*degrees):
        terms = {(i, j): random.randint(-size, size) for i in range(degrees[0] + 1) for j in range(degrees[1] + 1)}
        return CONTEXT.from_dict(terms)

    called = 0
    for _ in range(20):
        called += factors._certainly_irreducible(some(4, 3))
        assert not factors._certainly_irreducible(some(2, 1) * some(2, 2))
        assert not factors._certainly_irreducible(some(3, 0) * some(2, 3))
        assert not factors._certainly_irreducible(some(0, 2) * some(2, 3))
        coefficients = [random.randint(1, size) for _ in range(4)]
        assert not factors._certainly_irreducible(fmpz_poly(coefficients) * fmpz_poly(coefficients[:3]))
    assert called > 10


def test_divisors_are_those_of_flint(monkeypatch):
    monkeypatch.setattr(factors, "WORTH_A_TRY", 0)
    random = Random(4)
    for k in range(60):
        a, b, c = (
            CONTEXT.from_dict({(i, j): random.randint(-3, 3) for i in range(3) for j in range(3)}) for _ in range(3)
        )
        p, q = (a * c, b * c) if k % 2 else (a * 6, b * 4)
        assert greatest_common_divisor([p, q]) == p.gcd(q)


def test_what_would_take_too_long_is_refused_at_once():
    """Before: a call into FLINT that cannot be interrupted, for as long as it takes (here about a minute)."""
    random = Random(5)

    def some(degree, bits):
        return CONTEXT.from_dict(
            {(i, j): random.getrandbits(bits) for i in range(degree + 1) for j in range(degree + 1)}
        )

    common = some(10, 8000)
    long, other = common * some(10, 8000), common * some(10, 8000)
    rows = [fmpz_poly([random.getrandbits(900) for _ in range(30)]) for _ in range(30)]
    start = time.process_time()
    for refused in (
        lambda: factorize(long),
        lambda: factorize_square_free(long),
        lambda: greatest_common_divisor([long, other]),
        lambda: elimination.discriminant(rows),
        lambda: elimination.resultant(rows, rows[::-1]),
    ):
        with pytest.raises(ReachError, match="would take too long"):
            refused()
    assert time.process_time() - start < 10


def test_an_irreducible_polynomial_of_many_bits_needs_no_factorization():
    random = Random(6)
    p = CONTEXT.from_dict({(i, j): random.getrandbits(30000) for i in range(12) for j in range(12)})
    assert len(factorize(p).bases) == 1


def test_the_longest_estimate_is_not_refused():
    check_reach(10, lambda: "", 10)
    with pytest.raises(ReachError) as refused:
        check_reach(11 * 10**9, lambda: "this", 10)
    assert refused.value.data == {"seconds": 11}


def test_prime_factors_of_any_integer_or_none():
    """Passed before: trial division, that never ends for a weight of 10¹⁵ + 37."""
    random, began = Random(4), time.process_time()
    large = 10**15 + 37, (1 << 61) - 1
    for n in (
        1,
        -1,
        *large,
        large[0] ** 3 * -12,
        prod(large) * 2**70,
        *(random.getrandbits(90) | 1 for _ in range(20)),
    ):
        found = prime_factors(n)
        assert prod(p**e for p, e in found.items()) == abs(n)
        assert list(found) == sorted(found)
        assert all(fmpz(p).is_prime() for p in found)
    with pytest.raises(ReachError, match="the prime factors of a number of"):
        prime_factors(6 * ((1 << 127) - 1) * ((1 << 507) - 19))
    assert time.process_time() - began < 20


def test_a_prime_weight_of_any_size_is_a_unit_of_a_theorem():
    units = Nonzero()
    units.recognize(factored(mpq(10**15 + 37)))
    assert units.atoms == [10**15 + 37]


@pytest.mark.parametrize("content", [6, -6])
def test_what_is_seen_modulo_a_prime_is_what_flint_finds(monkeypatch, content):
    """The way of long polynomials, taken by short ones: square-free, irreducible, with a content and any sign."""
    square_free, irreducible = (Z * Z - 2) * (Z - 3) * content, (Z * Z + Z + 3) * content
    both = (S * S - T * T * 2 + 1) * content
    plain = [[factorize(p), factorize_square_free(p)] for p in (square_free, irreducible, both)]
    monkeypatch.setattr(factors, "WORTH_A_TRY", 0)
    for p, found in zip((square_free, irreducible, both), plain, strict=True):
        for way, before in zip((factorize, factorize_square_free), found, strict=True):
            told = way(p)
            assert told.constant == before.constant
            assert sorted(map(str, told.powers)) == sorted(map(str, before.powers))


def at(rows, z):
    """A polynomial in the second parameter, where the first is an integer."""
    return fmpz_poly([row(z) for row in rows])


@pytest.mark.parametrize("k", range(-6, 7))
def test_resultants_are_those_of_the_values(k):
    """Wherever the leading rows vanish: there FLINT takes polynomials of another degree. Compared at other places."""
    first, second = [3 * Z + 1, Z**2 - 2, Z - k], [Z + 5, fmpz_poly([2]), Z + k - 1]
    found, discriminant = elimination.resultant(first, second), elimination.discriminant(first)
    for z in (50, -71, 1000, -(10**20)):
        assert found(z) == at(first, z).resultant(at(second, z))
        assert discriminant(z) == at(first, z).discriminant()
    longer = elimination.resultant([*first, fmpz_poly([k * 7 + 1])], [Z - k, fmpz_poly([5])])
    assert longer(99) == at([*first, fmpz_poly([k * 7 + 1])], 99).resultant(fmpz_poly([99 - k, 5]))


def test_values_have_no_more_bits_than_is_said():
    random = Random(7)
    for _ in range(30):
        rows = [fmpz_poly([random.randint(-99, 99) for _ in range(random.randint(1, 6))] + [1]) for _ in range(3)]
        count = random.randint(2, 60)
        most = max(abs(row(z)).height_bits() for row in rows for z in range(-count, count + 1))
        assert most <= elimination.bits_of_values(rows, count) <= 4 * most + 20 * count.bit_length()


def test_a_common_divisor_modulo_one_prime_need_not_be_one():
    """Would pass otherwise: what divides one of two polynomials, and the other modulo the first prime alone."""
    modulus = fmpq_poly([-2, 0, 1])
    other = OverRoot([-3, fmpq_poly([0, 1]), 1], modulus)
    shifted = OverRoot([-3 + next(large_primes()), fmpq_poly([0, 1]), 1], modulus)
    assert shifted.gcd(other).coefficients == other.gcd(shifted).coefficients == (1,)


def test_the_estimate_of_an_isolation_grows_with_everything_that_it_takes():
    """The square of the degree, the height, and the bits of the ends, these as often as the degree."""

    def cost(n, height, bits):
        with drawing_on(Budget(10**15)) as budget:
            check_isolation(fmpz_poly([1] * n + [2**height]), bits)
        return budget.total - budget.remaining

    for n, height, bits in product((8, 40), (8, 4000), (0, 100)):
        least = cost(n, height, bits)
        assert cost(2 * n, height, bits) >= 4 * least - 400
        assert cost(n, 2 * height, bits) > least
        assert cost(n, height, bits + 100) >= least + n * n * n * 100 * 80 // 100 - n * n


def test_an_estimate_is_about_the_time_that_is_measured():
    """Refused beforehand is what takes too long, and nothing else: within a factor of ten."""
    random = Random(8)
    first, second = ([fmpz_poly([random.getrandbits(300) + 1 for _ in range(4)]) for _ in range(17)] for _ in range(2))
    with drawing_on(Budget()) as budget:
        start = time.process_time()
        elimination.resultant(first, second)
        measured = int(10**9 * (time.process_time() - start))
    assert measured / 10 < budget.total - budget.remaining < 10 * measured


def test_a_factorization_as_text():
    assert [str(Factorization(powers)) for powers in ([], [("w", 1)], [("w", 2), ("f2", -1)])] == ["1", "w", "w² f2⁻¹"]


@pytest.mark.parametrize("digit", "⁰¹²³⁴⁵⁶⁷⁸⁹")
def test_a_power_of_a_power_has_parentheses(digit):
    assert power_text(f"w¹{digit}", 3) == f"(w¹{digit})³"
    assert power_text("w₁", 10) == "w₁¹⁰"


def test_what_need_not_be_done_is_paid_for_or_left():
    assert not affords(11, longest=10)
    assert affords(10, longest=10)
    with drawing_on(Budget(20)) as budget:
        assert not affords(21)
        assert not affords(11, longest=10)
        assert budget.remaining == 20
        assert affords(20, longest=20)
        assert (budget.remaining, budget.spent) == (0, True)
        with pytest.raises(ReachError, match=r"\(less than a second\) exceeds the rest") as refused:
            check_reach(1, lambda: "this")
    assert refused.value.data == {"seconds": 1}
    assert [Budget(100, left).spent for left in (0, 1, 2, 3)] == [True, True, False, False]
    with drawing_on(Budget(5)) as budget:
        check_reach(5, lambda: "what the budget just pays for")
        assert budget.remaining == 0
    assert [Budget(5000, left).spent for left in (99, 100)] == [True, False]
    with pytest.raises(ReachError, match="more than a week"):
        check_reach(10**15, lambda: "this")
    with pytest.raises(ReachError, match="about 999999 s"):
        check_reach(10**15 - 1, lambda: "this")
    assert (height_bits([]), height_bits([fmpz(0)]), height_bits([fmpz(3), fmpz(-8)])) == (0, 0, 4)


@pytest.mark.parametrize("powers", [(1,), (2,), (3, 1), (1, 2), (2, 2), (0, 3, 1), (1, 2, 3)])
def test_square_free_factors_with_their_multiplicities(powers):
    bases = [fmpq_poly([-1, 2]), fmpq_poly([1, 0, 1]), fmpq_poly([-3, 1, 5])]
    f = fmpq_poly([fmpq(7, 3)])
    for base, power in zip(bases, powers, strict=False):
        f = f * base**power
    found = sorted(((fmpq_poly(p), m) for p, m in factorize_square_free(f.numer()).powers), key=lambda pair: pair[1])
    expected = {
        m: [base for base, power in zip(bases, powers, strict=False) if power == m] for m in sorted({*powers} - {0})
    }
    assert [m for _, m in found] == list(expected)
    for factor, m in found:
        together = fmpq_poly([1])
        for base in expected[m]:
            together = together * base
        assert factor / factor.leading_coefficient() == together / together.leading_coefficient()


@pytest.mark.parametrize("root", range(-6, 7))
@pytest.mark.parametrize("degree", [1, 2])
def test_the_discriminant_of_a_quadratic_is_known_wherever_it_is_none(root, degree):
    """b² − 4ac, also where a vanishes at an integer."""
    a, b, c = fmpz_poly([-root, 1]) ** degree, fmpz_poly([2, 0, 3][: degree + 1]), fmpz_poly([1, -1, 5])
    assert discriminant([c, b, a]) == b * b - 4 * a * c
