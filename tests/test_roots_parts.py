"""The parts of root finding, each held against what it means, with known answers."""

from math import nextafter

import pytest
from flint import fmpz_poly
from gmpy2 import mpq

from exactspline import BSpline, zeros
from exactspline.roots.enclosure import Enclosure, rounded_outwards, sign_at, value_at, values_between
from exactspline.roots.real import Real

T = BSpline.identity(0, 1)


def test_enclosures_are_rounded_outwards_and_say_their_middle():
    low, high = rounded_outwards(
        (mpq(1, 3), mpq(2, 3)) and type(values_between(T, mpq(0), mpq(1)))(mpq(1, 3), mpq(2, 3)), 2
    )
    assert (low, high) == (mpq(33, 100), mpq(67, 100))
    told = Enclosure(mpq(-1, 3), mpq(-1, 3), 4)
    assert str(told) == "-0.3333"
    assert mpq(-1, 3) in told
    assert mpq(1, 3) not in told
    assert str(Enclosure(mpq(5, 2), mpq(5, 2), 0)) == "3"
    assert str(Enclosure(mpq(-5, 2), mpq(-5, 2), 0)) == "-2"
    assert float(Enclosure(mpq(1, 3), mpq(1, 3), 3)) == 1 / 3
    assert Enclosure(mpq(0), mpq(1), 3).middle == mpq(1, 2)


def test_values_at_roots_are_as_narrow_as_asked():
    t = BSpline.identity(0, 2)
    (root,) = zeros(t * t - 2)
    for digits in (3, 12, 40):
        (square,) = value_at((t * t * t,), None, root, digits)
        assert square.high - square.low <= mpq(1, 10**digits)
        assert square.low**2 <= 8 <= square.high**2
        (quotient,) = value_at((t,), t * t, root, digits)
        assert quotient.low**2 <= mpq(1, 2) <= quotient.high**2
        assert quotient.high - quotient.low <= mpq(1, 10**digits)


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


@pytest.mark.parametrize("exponent", [1, 50, 120, 400])
def test_roots_that_nearly_coincide_are_told_apart(exponent):
    """(t − 1/3)(t − 1/3 − ε) with ε = 2⁻ᵉ, and (t − 1/3)² − ε: enclosed to any number of digits."""
    tiny = mpq(1, 2**exponent)
    f = (T - mpq(1, 3)) * (T - mpq(1, 3) - tiny) if exponent > 1 else (T - mpq(1, 3)) * (T - mpq(5, 6))
    assert len(zeros(f)) == 2
    close = (T - mpq(1, 3)) ** 2 - tiny / 16
    found = zeros(close)
    assert len(found) == 2
    for digits in (5, 60, 300):
        for root, sign in zip(found, (-1, 1), strict=True):
            low, high = root.refine(digits)
            assert low < high <= low + mpq(1, 10**digits) or low == high
            ends = sorted([(low - mpq(1, 3)) * sign, (high - mpq(1, 3)) * sign])
            assert ends[0] ** 2 <= tiny / 16 <= ends[1] ** 2


@pytest.mark.parametrize("sign", [1, -1, 0])
def test_the_root_of_a_quotient_at_a_root(sign):
    """√(t/3) and its negative at t = √2: the fourth power times 81/... is 2/9."""
    t = BSpline.identity(1, 2)
    told = Real.root_of_quotient_at(sign, t, t.constant(3), zeros(t * t - 2).roots[0])
    value = told.told(30)
    if sign == 0:
        assert value == 0
    else:
        assert sorted([value.low**4, value.high**4])[0] <= mpq(2, 9) <= sorted([value.low**4, value.high**4])[1]
        assert value.high - value.low <= mpq(1, 10**30)
        assert value.low * sign > 0
        nearest = sign * told.double()
        below, above = (mpq(nextafter(nearest, end)) for end in (0, 1))
        assert ((below + mpq(nearest)) / 2) ** 4 < mpq(2, 9) < ((mpq(nearest) + above) / 2) ** 4
        assert told.double("down") <= told.double("up")
    assert Real.root_of_quotient_at(1, t * t - 2, t, zeros(t * t - 2).roots[0]).told(5) == 0


@pytest.mark.parametrize("power", range(0, 60, 7))
def test_enclosures_are_narrow_enough_whatever_the_slope(power):
    t = BSpline.identity(0, 2)
    (root,) = zeros(t * t - 2)
    (value,) = value_at((t.scaled(3**power),), None, root, 40)
    assert value.high - value.low <= mpq(1, 10**40)
    assert value.low**2 <= 2 * mpq(9) ** power <= value.high**2
