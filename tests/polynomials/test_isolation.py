"""Zeros isolated one by one: rational ones, those near an end, and cells for answers that Coq proves."""

import random

import pytest
from flint import fmpq, fmpq_poly, fmpz_poly
from gmpy2 import mpq

from exactspline.errors import DomainError
from exactspline.polynomials import isolation, zero_places
from exactspline.polynomials.isolation import LocalPolynomial, isolate
from exactspline.polynomials.zero_places import Place, enclosures


def test_cells_cover_an_interval_and_say_what_is_so():
    f = fmpq_poly([-1, 2]) * fmpq_poly([-2, 3]) ** 2 * fmpq_poly([1, 0, 1])
    found = isolation.cells_of(f, mpq(0), mpq(1))
    assert [c.low for c in found] == [mpq(0), *[c.high for c in found[:-1]]]
    assert found[-1].high == 1
    for cell in found:
        places = [cell.low + (cell.high - cell.low) * mpq(k, 40) for k in range(1, 40)]
        values = [f(fmpq(int(t.numerator), int(t.denominator))) for t in places]
        if not cell.one:
            assert all((v > 0) == cell.sign for v in values)
        else:
            assert sum(cell.low < z < cell.high for z in (mpq(1, 2), mpq(2, 3))) == 1
            told = cell.factor or f
            assert (told(fmpq(int(cell.low.numerator), int(cell.low.denominator))) > 0) == cell.sign
        if cell.factor is not None:
            assert cell.power == 2
            assert cell.factor**2 * cell.rest == f
            assert all((cell.rest(fmpq(int(t.numerator), int(t.denominator))) > 0) == cell.rest_sign for t in places)
    assert any(cell.factor is not None for cell in found)
    # the coefficients −1 and 2; a mutant passed: nothing is negative
    (cell,) = isolation.cells_of(fmpq_poly([-1, 3]), mpq(0), mpq(1))
    assert (cell.one, cell.sign) == (True, False)


def test_halving_that_finds_no_end_is_given_up(monkeypatch):
    """Two zeros 2⁻⁴⁰ apart take some forty halvings."""
    third, near = fmpq(1, 3), fmpq(1, 3) + fmpq(1, 2**40)
    f = fmpq_poly([-third, 1]) * fmpq_poly([-near, 1])
    assert sum(cell.one for cell in isolation.cells_of(f, mpq(0), mpq(1))) == 2
    monkeypatch.setattr(isolation, "CELL_DEPTH", 33)
    with pytest.raises(DomainError, match="does not terminate"):
        isolation.cells_of(f, mpq(0), mpq(1))
    monkeypatch.setattr(isolation, "CELL_DEPTH", 60)
    assert sum(cell.one for cell in isolation.cells_of(f, mpq(0), mpq(1))) == 2


def test_a_polynomial_with_a_rational_zero_is_never_said_to_have_none():
    chance = random.Random(5)
    said = 0
    for _ in range(300):
        other = fmpz_poly([chance.randint(-(2**40), 2**40) or 1 for _ in range(chance.randint(1, 9))])
        # denominators and numerators that are divisible by the primes tried, and others
        p, q = (chance.choice([1, 5, 7, 35, 11 * 13, 5 * 7 * 11 * 13 * 17 * 19, 2, 9]) for _ in range(2))
        assert not LocalPolynomial(fmpz_poly([-p, q]) * other).without_rational_zero
        said += LocalPolynomial(other).without_rational_zero
    assert said > 150


@pytest.mark.parametrize("power", [5, 40, 114])
@pytest.mark.parametrize("bits", [0, 3, 7, 40])
def test_a_zero_next_to_one_end_in_an_interval_from_the_other(power, bits):
    far = 1 << power
    factor = fmpz_poly([-3 * far, 2]) * fmpz_poly([5 * far * far, far, 9]) * fmpz_poly([7, 1])
    zero = mpq(3 * far, 3 * far + 2)
    for low, high in enclosures(LocalPolynomial(factor), mpq(0), 1 - mpq(1, 4 * far), -1, bits):
        assert low == high == zero or low < zero < high
    assert high - low <= mpq(1, 1 << bits)


def test_a_place_is_rational_where_its_irreducible_factor_is_linear():
    """Zeros in z = t/(1 − t): 1/2, √2 and 7/3. Mutants passed: other numbers, none, or all."""
    z = fmpz_poly([0, 1])
    found = [Place(zero) for zero in isolate((2 * z - 1) * (3 * z - 7) * (z * z - 2), 4).inner]
    assert [place.exact for place in found] == [None] * 3
    assert [place.rational for place in found] == [mpq(1, 3), None, mpq(7, 10)]
    assert [place.exact for place in found] == [mpq(1, 3), None, mpq(7, 10)]


def test_an_interval_around_a_zero_is_narrow_and_has_its_signs():
    """The zero is between its ends, whose signs differ, in both halves of the segment."""
    chance = random.Random(11)
    for _ in range(120):
        form = fmpz_poly([chance.randint(-99, 99) or 1 for _ in range(7)])
        for zero in isolate(form, 6).inner:
            if zero.low == zero.high:
                continue
            *_, (low, high) = enclosures(zero.factor, zero.low, zero.high, zero.sign, 40)
            assert zero.low <= low <= high <= zero.high
            assert high - low <= mpq(1, 2**40)
            if low < high:
                g = zero.factor.polynomial
                before = zero.sign if low == zero.low else zero_places.sign_at(g, low)
                behind = -zero.sign if high == zero.high else zero_places.sign_at(g, high)
                assert (before, behind) == (zero.sign, -zero.sign)
