"""Roots: comparison, hash, refinement in steps, interrupts."""

from fractions import Fraction
from random import Random

import pytest
from flint import fmpz_poly
from gmpy2 import mpq

from exactspline import BSpline, zeros
from exactspline.errors import NumberError
from exactspline.roots.of_polynomials import as_splines
from exactspline.roots.root import knot_root

T = BSpline.identity(0, 2)


def roots(f):
    return zeros(f).roots


def test_equal_roots_of_different_splines():
    golden = roots(T * T - T - 1)[0]
    among = roots((T * T - T - 1) * (T**3 - 2) * (T - 1))
    knotted = roots((T * T - T - 1).insert_knot("8/5").insert_knot("17/10"))
    multiple = roots((T * T - T - 1) ** 3 * (7 * T - 1))[1]
    assert [r == golden for r in among] == [False, False, True]
    assert knotted == (golden,)
    assert multiple == golden
    assert multiple.multiplicity == 3
    assert len({golden, among[2], knotted[0], multiple}) == 1
    assert len({*among, golden}) == 3


def test_order_of_close_roots():
    near = mpq(1, 10**60)
    first, second = roots(T * T - 2), roots(T * T - 2 - near)
    assert first[0] < second[0]
    assert first[0] != second[0]
    assert sorted([*second, *first]) == [*first, *second]


def test_conjugates_and_common_factors_are_told_apart():
    # both intervals overlap at first, and the polynomials share a factor without sharing these roots
    f = roots((T * T - 2) * (T**2 - mpq(2000001, 1000000)))
    g = roots((T * T - 2) * (T**2 - mpq(1999999, 1000000)))
    assert g[0] < f[0] == g[1] < f[1]


def test_against_numbers():
    (root,) = roots(T * T - 2)
    assert mpq(141, 100) < root < Fraction(142, 100)
    assert 1 < root < 2
    assert root != 1
    assert root != "1.41"
    (half,) = roots((T**3 + 1) * (3 * T - 2))
    assert half == mpq(2, 3)
    assert half.exact == mpq(2, 3)
    with pytest.raises(TypeError):
        assert root < 1.41


def test_a_rational_root_is_found_without_factoring():
    (root,) = roots((3 * T - 2) * (T**2 + 5 * T + 7) * (T + 1))
    assert root.low < root.high
    assert root.exact == root.low == root.high == mpq(2, 3)
    assert root.minimal_polynomial() == [-2, 3]
    assert hash(root) == hash(mpq(2, 3))


def test_polynomial_is_primitive_and_in_the_parameter_of_the_spline():
    f = BSpline.bezier([-1, 5, "1/3", 7], "1/3", "22/7")
    (root,) = roots(f)
    low, high = root.refine(40)
    at = [sum(c * t**i for i, c in enumerate(root.polynomial)) for t in (low, high)]
    assert at[0] * at[1] < 0
    assert root.polynomial[-1] > 0
    scale = {
        sum(c * mpq(t) ** i for i, c in enumerate(root.polynomial)) / f(t) for t in (1, 2, "5/2") for t in (mpq(t),)
    }
    assert len(scale) == 1


def test_digits_go_on_from_where_they_are():
    (root,) = roots(T * T - 2)
    few = root.refine(20)
    many = root.refine(300)
    assert few[0] <= many[0] < many[1] <= few[1]
    assert root.refine(10) == many
    assert root.refine(0) == many
    with pytest.raises(NumberError):
        root.refine(1.5)


def test_any_steps_reach_the_same_digits():
    """A root near 2⁻⁵⁷: an end of the interval reached may be nearer to it than the next precision can tell, and
    halving from there takes one step for every bit.
    """
    random = Random(1)
    form = fmpz_poly([-1, *[random.randint(0, 2**60) for _ in range(20)]])
    at_once, *others = (as_splines([form], mpq(0), mpq(1))[0] for _ in range(3))
    (root,) = roots(at_once)
    low, high = root.refine(9000)
    for f, steps in zip(others, ((20, 154, 308, 616, 1200, 2400, 9000), (1000, 1001, 2002, 9000)), strict=True):
        (other,) = roots(f)
        for digits in steps:
            a, b = other.refine(digits)
        assert a < high
        assert low < b
        assert (b - a) * mpq(10) ** 9000 <= 1
        assert other == root


def test_value_has_the_digits_it_says():
    import mpmath

    before = mpmath.mp.prec
    (root,) = roots(T * T - 2)
    value = root.mpf(200)
    assert mpmath.mp.prec == before
    with mpmath.workdps(220):
        assert abs(value - mpmath.sqrt(2)) < mpmath.mpf(10) ** -200


def test_interrupt_loses_nothing():
    (root,) = roots(T**5 - 7)
    reached = []

    def interrupt(digits):
        reached.append(digits)
        if digits > 500:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        root.refine(5000, interrupt)
    assert reached == sorted(reached)
    assert root.high - root.low < mpq(1, 10**500)
    assert root.high - root.low > mpq(1, 10**4000)
    again = []
    root.refine(5000, again.append)
    assert again[0] > 500
    assert root.high - root.low <= mpq(1, 10**5000)
    assert root.low**5 < 7 < root.high**5


def test_zero_set_reports_progress():
    seen = []
    found = zeros(BSpline.bezier([1, -2, 1]))
    intervals = found.refine(60, lambda done, of: seen.append((done, of)))
    assert seen == [(1, 2), (2, 2)]
    assert intervals == [(r.low, r.high) for r in found]


def test_global_precision_is_left_alone():
    import flint

    before = flint.ctx.prec
    zeros(BSpline.bezier([1, -2, 1])).refine(500)
    assert flint.ctx.prec == before


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


def test_a_knot_as_a_root():
    told = knot_root(mpq(5, 3))
    assert told == mpq(5, 3)
    assert told.at_knot
    assert (told.multiplicity, told.left_multiplicity, told.right_multiplicity, told.signs) == (1, 1, 1, (0, 0))
    assert not told.sign_change
