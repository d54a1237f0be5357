"""Factors of forms on a patch, from products whose factors are known."""

from itertools import product
from random import Random

import pytest
from flint import fmpz_poly
from gmpy2 import mpq

from exactspline.bivariate.zero_lines import (
    common_factor,
    divided,
    line_factor,
    odd_part,
    rational_lines,
    square_free,
    without_powers,
)
from exactspline.numbers.exact import sign
from exactspline.polynomials.two_parameters import S, T, as_form, as_polynomial, value_at

#: Irreducible factors: curves that cross the square, lines, and one without zeros.
FACTORS = (S - T, S * S + T * T - 1, 3 * S * T - 1, 2 * S - 1, 3 * T - 1, S + T + 1)
POINTS = [(mpq(a, 7), mpq(b, 11)) for a, b in product(range(8), range(12))]


def alike(p, q):
    """Whether two polynomials differ by a constant alone."""
    return p.total_degree() == q.total_degree() and p * q.leading_coefficient() == q * p.leading_coefficient()


def signs(p):
    return [sign(value_at(p, *place)) for place in POINTS]


@pytest.mark.parametrize("seed", range(8))
def test_products_and_their_parts(seed):
    random = Random(seed)
    times = [random.choice([0, 1, 1, 2, 3]) for _ in FACTORS]
    constant = random.choice([1, -1, 6, -6])
    whole, once, odd = S * 0 + constant, S * 0 + 1, S * 0 + sign(constant)
    for factor, k in zip(FACTORS, times, strict=True):
        whole, once, odd = whole * factor**k, once * factor ** min(k, 1), odd * factor ** (k % 2)
    assert alike(as_polynomial(square_free(as_form(whole))), once)
    own = as_polynomial(odd_part(as_form(whole)))
    assert alike(own, odd)
    assert signs(own) == signs(odd)
    for factor, k in zip(FACTORS, times, strict=True):
        rest = whole / factor**k
        assert alike(as_polynomial(without_powers(as_form(whole), as_form(factor))), rest)
        kept = as_polynomial(without_powers(as_form(whole), as_form(factor), even=True))
        assert alike(kept, rest * factor ** (k % 2))
        assert all(x == y for x, y in zip(signs(kept), signs(whole), strict=True) if y)
        if k:
            assert alike(as_polynomial(divided(as_form(whole), as_form(factor))), whole / factor)
    for direction, (k, zero, own_line) in enumerate(((times[3], mpq(1, 2), [-1, 2]), (times[4], mpq(1, 3), [-1, 3]))):
        assert rational_lines(as_form(whole), direction) == [zero] * (k > 0)
        assert line_factor(as_form(whole), direction) in (fmpz_poly(own_line) ** k, -(fmpz_poly(own_line) ** k))


def test_common_factors():
    p, q, r = FACTORS[:3]
    found = common_factor([as_form(p * q * 6), as_form(p * p * r * 4), as_form(p * q * r)])
    assert found is not None
    assert alike(as_polynomial(found), p)
    assert common_factor([as_form(p * 6), as_form(q * 4)]) is None
    assert common_factor([as_form(p * p)]).degree == (2, 2)


def test_lines_in_order():
    form = as_form((3 * S - 1) * (5 * S - 4) * (2 * S * S - 1) * (7 * S - 2) * (S - T))
    assert rational_lines(form, 0) == [mpq(2, 7), mpq(1, 3), mpq(4, 5)]
    assert rational_lines(form, 1) == []
    assert line_factor(form, 0).degree() == 5
    assert line_factor(as_form(S * 0 + 12), 0) == 1
