"""``float(root)``: the correctly rounded double, against mpmath and against the rounding interval itself."""

import math
import random

import mpmath
import pytest
from gmpy2 import mpq

import exactspline as xs
from exactspline import square_root
from exactspline.numbers.exact import double_between


def line_root(value):
    """The rational number as a root that is not known to be one: of (t − value)(t² + 1)."""
    t = xs.BSpline.identity(value - mpq(3, 7), value + mpq(5, 3))
    (root,) = xs.zeros((t - value) * ((t - value) ** 2 + 1))
    return root


def exactly(x):
    return mpq(*x.as_integer_ratio())


def is_nearest(x, root):
    """Whether the root is in the rounding interval of a double, its ends only where the double is even."""
    below, above = math.nextafter(x, -math.inf), math.nextafter(x, math.inf)
    low = (exactly(below) + exactly(x)) / 2 if math.isfinite(below) else exactly(x) - exactly(math.ulp(x)) / 2
    high = (exactly(x) + exactly(above)) / 2 if math.isfinite(above) else exactly(x) + exactly(math.ulp(x)) / 2
    even = int(exactly(x) / exactly(math.ulp(x))) % 2 == 0 if x else True
    return low <= root <= high if even else low < root < high


def test_two_thousand_irrational_roots_against_mpmath():
    random_numbers = random.Random(2007)
    t = xs.BSpline.identity(0, 2)
    mistakes = 0
    for _ in range(2000):
        p, q = random_numbers.randrange(1, 1 << 60), random_numbers.randrange(1 << 58, 1 << 60)
        value = mpq(p, q)
        (root,) = xs.zeros(t * t - value) if value < 4 else [None]
        with mpmath.workprec(200):
            nearest = float(mpmath.sqrt(mpmath.mpf(p) / q))
        mistakes += float(root) != nearest
    assert mistakes == 0


@pytest.mark.parametrize("shift", range(-8, 9))
def test_ties_go_to_the_even_double(shift):
    """Halfway between two doubles, and beside it by next to nothing."""
    for x in (1.0, 0.1, 1.5 * 2**-500, 1e300, 5e-324, 2.2250738585072014e-308, 1.7976931348623155e308):
        upper = math.nextafter(x, math.inf)
        half = (exactly(x) + exactly(upper)) / 2
        value = half + shift * exactly(math.ulp(x)) / 10**30
        root = line_root(value)
        found = float(root)
        assert found == (x if shift < 0 else upper if shift > 0 else int(half.numerator) / int(half.denominator))
        assert is_nearest(found, root)


@pytest.mark.parametrize("exponent", [-1100, -1080, -1074, -1060, -1022, -500, 0, 500, 1000, 1022])
def test_roots_of_any_size_are_in_the_rounding_interval(exponent):
    """(t/2^e)² = 2 + 1/3 has the roots ±2^e √(7/3)."""
    scale = mpq(2) ** exponent
    t = xs.BSpline.bezier([-scale * 3, scale * 3], -scale * 3, scale * 3)
    for root in xs.zeros(t * t - scale * scale * mpq(7, 3)):
        assert is_nearest(float(root), root)


def test_overflow_and_the_last_double():
    largest = exactly(math.nextafter(math.inf, 0))
    edge = largest + exactly(math.ulp(float(math.nextafter(math.inf, 0)))) / 2
    assert float(line_root(largest)) == float(largest)
    assert float(line_root(edge - mpq(1, 10**20))) == float(largest)
    assert float(line_root(-edge + 1)) == -float(largest)
    for value in (edge, edge + 1, mpq(2) ** 1024, -(mpq(10) ** 400)):
        with pytest.raises(OverflowError):
            float(line_root(value))


def test_zero_and_what_is_too_small():
    assert float(line_root(mpq(0))) == 0.0
    assert float(line_root(mpq(1, 2) ** 1076)) == 0.0
    assert float(line_root(mpq(1, 2) ** 1075)) == 0.0, "a tie: zero is even"
    assert float(line_root(mpq(1, 2) ** 1075 * 3)) == 2 * 5e-324, "a tie between 1 and 2 units: 2 is even"
    assert float(line_root(mpq(1, 2) ** 1075 + mpq(1, 10**400))) == 5e-324
    assert math.copysign(1, float(line_root(-(mpq(1, 2) ** 1080)))) == -1.0


def test_square_roots_are_rounded_the_same_way():
    random_numbers = random.Random(1)
    for _ in range(200):
        q = mpq(random_numbers.randrange(1, 10**30), random_numbers.randrange(1, 10**30))
        root = square_root(q)
        assert is_nearest(float(root), root)
        assert float(-root) == -float(root)


def test_a_wrong_side_would_be_seen():
    """The rounding is that of the number whose side is told: nothing rests on how the interval lies."""
    third = mpq(1, 3)

    def enclosed(digits):
        width = mpq(1, 10**digits)
        return third - width / 3, third + width / 7

    assert double_between(enclosed, lambda t: (third > t) - (third < t)) == 1 / 3
