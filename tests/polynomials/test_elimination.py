"""Resultants and discriminants against FLINT's in two variables; common divisors over a field against known ones, with
primes so small that all of what may go wrong does.
"""

from random import Random

import pytest
from flint import fmpq, fmpq_poly, fmpz_poly
from gmpy2 import mpq

from exactspline.numbers.exact import mpz
from exactspline.polynomials import elimination, over_root
from exactspline.polynomials.elimination import discriminant, resultant, through
from exactspline.polynomials.isolation import isolate
from exactspline.polynomials.over_root import OverRoot, by_powers
from exactspline.polynomials.two_parameters import S, T, in_one, lifted
from exactspline.polynomials.zero_places import Place, at, places


def rows(draw, n, degree):
    """Rows of a polynomial of this degree in t; its leading one often vanishes at integers close to 0."""
    found = [fmpz_poly([draw.randint(-9, 9) for _ in range(degree + 1)]) for _ in range(n)]
    leading = fmpz_poly([draw.choice([-2, 1, 3])])
    for _ in range(draw.randint(0, degree)):
        leading *= fmpz_poly([draw.randint(-3, 3), 1])
    return [*found, leading]


def as_sum(own):
    return sum((lifted(row, 0) * T**j for j, row in enumerate(own)), S * 0)


@pytest.fixture
def counted(monkeypatch):
    """How many values were computed for each polynomial."""
    counts, plain = [], elimination.through

    def count(values):
        counts.append(len(values))
        return plain(values)

    monkeypatch.setattr(elimination, "through", count)
    return counts


@pytest.mark.parametrize("seed", range(40))
def test_resultants_are_those_of_flint(seed, counted):
    draw = Random(seed)
    (m, n), (a, b) = ([draw.randint(0, 3) for _ in range(2)] for _ in range(2))
    first, second = rows(draw, m, a), rows(draw, n, b)
    if m + n:
        assert resultant(first, second) == in_one(as_sum(first).resultant(as_sum(second), "t"), 0)
        # as many values as a polynomial of the greatest degree needs, where all rows have it
        widths = [max(row.degree() for row in own) for own in (first, second)]
        assert counted == [n * widths[0] + m * widths[1] + 1]
    if m > 1:
        assert discriminant(first) == in_one(as_sum(first).discriminant("t"), 0)
        assert counted[-1] == (2 * m - 2) * max(row.degree() for row in first) + 1


def test_values_begin_close_to_0_where_the_leading_row_does_not_vanish():
    def start(zeros, count):
        leading = fmpz_poly([1])
        for zero in zeros:
            leading *= fmpz_poly([-zero, 1])
        return elimination.first_integer(leading, count)

    assert [start([], count) for count in (1, 2, 5)] == [0, -1, -2]
    assert [start([0], 1), start([0], 5), start([-2, 2, 3], 5), start([3], 5)] == [1, 1, 4, -2]
    assert through([mpz(x**3 - x) for x in range(5)]) == fmpz_poly([0, -1, 0, 1])


# ---- over a field

MODULI = [fmpq_poly([-2, 0, 1]), fmpq_poly([-7, 0, 0, 5]), fmpq_poly([fmpq(1, 3), -1, 0, 2, 15]), fmpq_poly([-5, 3])]


def element(draw, modulus):
    return fmpq_poly([fmpq(draw.randint(-5, 5), draw.choice([1, 1, 2, 3, 7])) for _ in range(modulus.degree())])


def polynomial(draw, modulus, degree):
    leading = fmpq_poly([0])
    while not leading:
        leading = element(draw, modulus)
    return OverRoot([element(draw, modulus) for _ in range(degree)] + [leading], modulus)


@pytest.mark.parametrize("modulus", MODULI, ids=str)
@pytest.mark.parametrize("is_small", [True, False])
def test_common_divisors_of_known_factors(modulus, is_small, monkeypatch):
    """Small primes divide denominators, leading coefficients and resultants: images of other degrees, or none."""
    if is_small:
        primes = [p for p in range(2, 4000) if all(p % k for k in range(2, int(p**0.5) + 1))]
        monkeypatch.setattr(over_root, "large_primes", lambda: iter(primes))
    draw, trivial = Random(str(modulus)), 0
    for _ in range(12):
        g, a, b = (polynomial(draw, modulus, draw.randint(0, 2)) for _ in range(3))
        found = (g * a).gcd(g * b)
        assert not (g * a - a * g)
        assert found.coefficients[-1] == 1
        for p in (g * a, g * b):
            quotient, rest = divmod(p, found)
            assert not rest
            assert not quotient * found - p
            assert p // found == quotient or not (p // found - quotient)
        assert not divmod(found, g)[1]
        # nothing else is common: a and b less the divisor have a resultant that is not zero
        coprime = a.degree == 0 or b.degree == 0 or found.degree == g.degree
        assert coprime or divmod(a, found // g)[1].degree < 0
        trivial += found.degree == g.degree
        nothing = OverRoot([], modulus)
        assert nothing.gcd(g * a).coefficients == (g * a).gcd(nothing).coefficients
        assert not (nothing.gcd(g) * g - g.gcd(nothing) * g)
        assert nothing.gcd(g).coefficients[-1] == 1
    assert trivial > 8
    assert not nothing.gcd(nothing)


def test_values_of_products_and_remainders():
    """At a number of the field, by evaluation of both sides."""
    for modulus in MODULI:
        draw = Random(str(modulus))
        x = element(draw, modulus)

        def value(p, at=x, by=modulus):
            total = fmpq_poly([0])
            for c in reversed(p.coefficients):
                total = (total * at + c) % by
            return total

        for m, n in ((3, 1), (2, 2), (1, 3), (0, 0)):
            p, q = polynomial(draw, modulus, m), polynomial(draw, modulus, n)
            quotient, rest = divmod(p, q)
            assert rest.degree < max(q.degree, 1)
            assert value(p * q) == value(p) * value(q) % modulus
            assert value(p + q) == value(p) + value(q)
            assert value(p - q) == value(p) - value(q)
            assert value(p * 3) == value(p) * 3
            assert value(quotient) * value(q) % modulus + value(rest) == value(p)


def test_integer_parts_by_powers_of_the_root():
    for modulus in MODULI:
        draw = Random(str(modulus))
        given = [polynomial(draw, modulus, n) for n in (2, 0)] + [OverRoot([], modulus)]
        parts = by_powers(given)
        assert all(len(row) == modulus.degree() for row in parts)
        assert len({int(x) for row in parts for p in row for x in p.coeffs()} - {0}) > 1
        content = fmpz_poly([int(p.content()) for row in parts for p in row])
        assert content.content() == 1
        ratios = set()
        for p, row in zip(given, parts, strict=True):
            for j, c in enumerate(p.coefficients):
                for k in range(modulus.degree()):
                    assert bool(c[k]) == bool(row[k][j])
                    if c[k]:
                        ratios.add(str(fmpq(row[k][j]) / c[k]))
        (ratio,) = ratios
        assert not ratio.startswith("-")


# ---- places


def test_signs_at_places_are_those_of_the_numbers():
    """Of forms at rational places and irrational ones, at both ends, close to a zero and in one."""
    # z (2 z² − 3)(2 z − 1) of degree 6: zeros at 0, 1/2, √(3/2), and twice at the end
    form = fmpz_poly([0, 1]) * fmpz_poly([-3, 0, 2]) * fmpz_poly([-1, 2])
    found = places(isolate(form, 6))
    assert [place.multiplicity for place in found] == [1, 1, 1, 2]
    assert [place.rational for place in found] == [0, mpq(1, 3), None, 1] == [place.exact for place in found]
    root = found[2]
    assert root.irreducible == fmpz_poly([-3, 0, 2])
    assert found[1].irreducible == fmpz_poly([-1, 2])
    (wide,) = isolate(fmpz_poly([1, 0, -2]), 2).inner
    assert Place(wide).refine(1).width <= mpq(1, 2) < wide.high - wide.low
    for bits in (0, 5, 300):
        low, high = root.refine(bits)
        assert high - low <= mpq(1, 1 << bits)
        assert 2 * (low / (1 - low)) ** 2 < 3 < 2 * (high / (1 - high)) ** 2
    forms = [form, fmpz_poly([-1, 1]), fmpz_poly([5, -4]), fmpz_poly([-3, 0, 2]) * fmpz_poly([1, 1]), fmpz_poly([])]
    signs = [[place.sign(c, 6) for c in forms] for place in found]
    assert signs == [[0, -1, 1, -1, 0], [0, -1, 1, -1, 0], [0, 1, 1, 0, 0], [0, 0, 0, 0, 0]]
    assert [found[3].sign(c, n) for c, n in ((forms[1], 1), (forms[2], 1), (form, 4))] == [1, -1, 1]
    elements = [fmpz_poly([-6, 5]), fmpz_poly([-5, 4]), fmpz_poly([-3, 0, 2]), fmpz_poly([])]
    assert [root.sign(p, p.degree()) for p in elements] == [1, -1, 0, 0]


def test_a_zero_whose_factor_has_others_is_told_from_them():
    """A rational one that is not isolated as such, and two that are close together."""
    close = fmpz_poly([-(10**30 + 1), 10**30]) * fmpz_poly([-(10**30), 10**30 - 1])
    for zero in isolate(close * fmpz_poly([-2, 0, 1]), 4).inner:
        place = Place(zero)
        signs = [place.sign(f, 2) for f in (close, fmpz_poly([-2, 0, 1]))]
        assert sorted(map(abs, signs)) == [0, 1]
        expected = None if signs[1] == 0 else place.rational
        assert place.rational == expected
        p = place.irreducible
        assert place.sign(p, p.degree()) == 0
        assert p.degree() == (2 if expected is None else 1)
    assert at(mpq(1), 2).rational == 1
