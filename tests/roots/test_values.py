"""Values of splines and quotients at roots: their signs, and enclosures as narrow as asked."""

from math import isqrt, nextafter

import pytest
from gmpy2 import mpq

from exactspline import BSpline, zeros
from exactspline.roots.values import sign_at, signed_root, value_at


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


def test_a_denominator_that_is_zero_at_the_end_of_the_interval_is_waited_for():
    t = BSpline.identity(0, 2)
    near = zeros(t * t - 2).roots[0].refine(6)[0]
    value = signed_root(1, value_at(t.constant(1), t - near, zeros(t * t - 2).roots[0])).enclosure(1)
    ends = sorted(1 / end**2 + near for end in (value.low, value.high))
    assert ends[0] ** 2 <= 2 <= ends[1] ** 2
