"""The parts of root finding, each held against what it means, with known answers."""

import random
from math import isqrt, nextafter

import pytest
from flint import fmpq, fmpq_poly, fmpz_poly
from gmpy2 import mpq

from exactspline import BSpline, zeros
from exactspline.certificates import check_certificate
from exactspline.certificates.zeros import product_of, sturm_count
from exactspline.errors import DomainError
from exactspline.numbers.intervals import Interval, rounded_outwards
from exactspline.polynomials import cells
from exactspline.polynomials.factors import factorize_square_free
from exactspline.polynomials.isolation import LocalPolynomial
from exactspline.polynomials.refinement import enclosures
from exactspline.reals.real import Real, between
from exactspline.roots.root import knot_root
from exactspline.roots.values import sign_at, signed_root, value_at


def test_enclosures_are_rounded_outwards_and_say_their_middle():
    low, high = rounded_outwards(Interval(mpq(1, 3), mpq(2, 3)), 2)
    assert (low, high) == (mpq(33, 100), mpq(67, 100))
    assert Real("-1/3").decimal(4) == "-0.3333"
    assert [Real(t).decimal(0) for t in ("5/2", "-5/2")] == ["3", "-2"]
    assert float(Real("1/3")) == 1 / 3
    assert Interval(mpq(0), mpq(1)).middle == mpq(1, 2)


def test_signs_at_roots_are_exact():
    t = BSpline.identity(0, 2)
    (root,) = zeros(t * t - 2)
    near = mpq(14142135623730950488016887242096980785696718753769, 10**49)
    assert sign_at(t - near, root) == 1
    assert sign_at(near - t, root) == -1
    assert sign_at(t * t - 2, root) == 0
    assert sign_at(t * 0, root) == 0
    assert sign_at(t - 1, mpq(1)) == 0
    jumping = BSpline(0, [0, 1, 2], [-1, 1])
    assert (sign_at(jumping, mpq(1), "left"), sign_at(jumping, mpq(1), "right")) == (-1, 1)


def test_a_root_is_one_of_exactly_the_polynomials_that_it_satisfies():
    t = BSpline.identity(0, 2)
    (root,) = zeros(t * t - 2)
    assert root.is_root_of(fmpz_poly([-2, 0, 1]))
    assert root.is_root_of(fmpz_poly([-2, 0, 1]) * fmpz_poly([5, 7, 1]))
    assert not root.is_root_of(fmpz_poly([-2, 1]))
    assert not root.is_root_of(fmpz_poly([2, 0, 1]))
    assert not root.is_root_of(fmpz_poly([1]))
    (half,) = zeros(2 * t - 1)
    assert half.is_root_of(fmpz_poly([-1, 2]))
    assert half.is_root_of(fmpz_poly([0, -1, 2]))
    assert not half.is_root_of(fmpz_poly([1, 2]))
    assert not half.is_root_of(fmpz_poly([1]))
    (at_zero,) = zeros(t)
    assert at_zero.is_root_of(fmpz_poly([0, 1]))
    assert not at_zero.is_root_of(fmpz_poly([1, 1]))


@pytest.mark.parametrize("sign", [1, -1, 0])
def test_the_root_of_a_quotient_at_a_root(sign):
    """√(t/3) and its negative at t = √2: the fourth power times 81/... is 2/9."""
    t = BSpline.identity(1, 2)
    told = signed_root(sign, value_at(t, t.constant(3), zeros(t * t - 2).roots[0]))
    value = told.enclosure(30)
    if sign == 0:
        assert told == 0
    else:
        assert sorted([value.low**4, value.high**4])[0] <= mpq(2, 9) <= sorted([value.low**4, value.high**4])[1]
        assert value.high - value.low <= mpq(1, 10**30)
        assert value.low * sign > 0
        nearest = sign * told.double()
        below, above = (mpq(nextafter(nearest, end)) for end in (0, 1))
        assert ((below + mpq(nearest)) / 2) ** 4 < mpq(2, 9) < ((mpq(nearest) + above) / 2) ** 4
        assert told.double("down") <= told.double("up")
    assert signed_root(1, value_at(t * t - 2, t, zeros(t * t - 2).roots[0])) == 0


@pytest.mark.parametrize("power", range(0, 60, 7))
def test_enclosures_are_narrow_enough_whatever_the_slope(power):
    t = BSpline.identity(0, 2)
    (root,) = zeros(t * t - 2)
    value = value_at(t.scaled(3**power), t.constant(1), root).enclosure(40)
    assert value.high - value.low <= mpq(1, 10**40)
    assert value.low**2 <= 2 * mpq(9) ** power <= value.high**2


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


@pytest.mark.parametrize(
    ("zeros_of", "expected"),
    [([], 0), ([1], 1), ([-1], 0), ([1, 2], 2), ([1, 1, 2], 2), ([-3, 5, 7, -2], 2), ([3] * 4, 1)],
)
def test_a_sturm_sequence_counts_the_distinct_positive_zeros(zeros_of, expected):
    for complex_pairs in ([], [[1, 0, 1]], [[1, 0, 1], [5, 4, 1]], [[5, -4, 1]]):
        c = [-2]
        for factor in [*[[-z, 1] for z in zeros_of], *complex_pairs]:
            c = product_of(c, factor)
        assert sturm_count(c) == expected


def test_a_certificate_of_a_spline_that_vanishes():
    nothing = BSpline(0, [0, 1, 2], [0, 0])
    told = zeros(nothing).certificate()
    assert check_certificate(told) == {"roots": 0, "jumps": 0, "intervals": 1}


@pytest.mark.parametrize("k", range(1, 12))
def test_a_number_between_is_strictly_between(k):
    """√2 and its decimals cut after k digits, from both sides."""
    t = BSpline.identity(0, 2)
    (root,) = zeros(t * t - 2)
    below = mpq(isqrt(2 * 100**k), 10**k)
    above = below + mpq(1, 10**k)
    assert below < between(below, root) < root < between(root, above) < above
    (other,) = zeros(t * t - (2 + mpq(1, 10**k)))
    middle = between(root, other)
    assert 2 < middle**2 < 2 + mpq(1, 10**k)
    assert bin(middle.denominator).count("1") == 1
    assert between(mpq(1), mpq(5, 4)) == mpq(9, 8)


def test_a_knot_as_a_root():
    told = knot_root(mpq(5, 3))
    assert told == mpq(5, 3)
    assert told.at_knot
    assert (told.multiplicity, told.left_multiplicity, told.right_multiplicity, told.signs) == (1, 1, 1, (0, 0))
    assert not told.sign_change


def test_cells_cover_an_interval_and_say_what_is_so():
    f = fmpq_poly([-1, 2]) * fmpq_poly([-2, 3]) ** 2 * fmpq_poly([1, 0, 1])
    found = cells.cells_of(f, mpq(0), mpq(1))
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


def test_halving_that_finds_no_end_is_given_up(monkeypatch):
    """Two zeros 2⁻⁴⁰ apart take some forty halvings."""
    third, near = fmpq(1, 3), fmpq(1, 3) + fmpq(1, 2**40)
    f = fmpq_poly([-third, 1]) * fmpq_poly([-near, 1])
    assert sum(cell.one for cell in cells.cells_of(f, mpq(0), mpq(1))) == 2
    monkeypatch.setattr(cells, "DEPTH", 33)
    with pytest.raises(DomainError, match="does not terminate"):
        cells.cells_of(f, mpq(0), mpq(1))
    monkeypatch.setattr(cells, "DEPTH", 60)
    assert sum(cell.one for cell in cells.cells_of(f, mpq(0), mpq(1))) == 2


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize(("digits", "close"), [(1, 20), (4, 60), (1, 200), (30, 90)])
def test_a_quotient_whose_denominator_is_hardly_positive(sign, digits, close):
    """±√(1/(t − 1.4142135…)) at t = √2."""
    t = BSpline.identity(0, 2)
    (root,) = zeros(t * t - 2)
    near = mpq(isqrt(2 * 100**close), 10**close)
    value = signed_root(sign, value_at(t.constant(1), t - near, root)).enclosure(digits)
    assert value.high - value.low <= mpq(1, 10**digits)
    ends = sorted(1 / end**2 + near for end in (value.low, value.high))
    assert ends[0] ** 2 <= 2 <= ends[1] ** 2
    assert value.low * sign > 0


@pytest.mark.parametrize("periodic", [False, True])
@pytest.mark.parametrize(
    ("points", "places", "signs"),
    [
        ([0, 0, 1, 1], [(0, 1)], (None, 1)),
        ([-1, -1, 0, 0], [(2, 3)], (-1, None)),
        ([1, 0, 0, -2], [(1, 2)], (1, -1)),
        ([0, 0, 0, 0], [(0, 3)], (None, None)),
    ],
)
def test_intervals_of_zeros_know_the_signs_on_both_sides(points, places, signs, periodic):
    f = BSpline(1, [0, 0, 1, 2, 3, 3], points)
    (found,) = zeros(f, periodic=periodic).intervals
    assert list(found.parts) == places
    left, right = f(0), f(3)
    if periodic and any(points):  # beyond an end is the other one
        beyond = [int(x > 0) - int(x < 0) for x in (right, left)]
        signs = tuple(beyond[i] if sign is None else sign for i, sign in enumerate(signs))
    assert found.signs == signs


def test_a_denominator_that_is_zero_at_the_end_of_the_interval_is_waited_for():
    t = BSpline.identity(0, 2)
    near = zeros(t * t - 2).roots[0].refine(6)[0]
    value = signed_root(1, value_at(t.constant(1), t - near, zeros(t * t - 2).roots[0])).enclosure(1)
    ends = sorted(1 / end**2 + near for end in (value.low, value.high))
    assert ends[0] ** 2 <= 2 <= ends[1] ** 2


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
