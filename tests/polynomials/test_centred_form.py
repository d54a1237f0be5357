"""Bounds of a form over a narrow interval: they hold its exact values there, and come together with the ends."""

import random
from itertools import pairwise

import pytest
from gmpy2 import mpq

from exactspline.polynomials.bernstein import from_bezier, value
from exactspline.polynomials.zero_places import bounds_over


def hostile_form(chance, n):
    """Bézier points that cancel, vanish at an end, are huge or tiny, or differ by hundreds of digits."""
    kind = chance.randrange(5)
    points = [mpq(chance.randint(-9, 9), chance.randint(1, 9)) for _ in range(n + 1)]
    if kind == 1:
        points = [x * mpq(10) ** chance.choice((-200, 0, 200)) for x in points]
    if kind == 2:
        points = [1 + x * mpq(1, 10**60) for x in points]
    if kind == 3:
        points = [mpq(0)] * (n // 2) + points[n // 2 :]
    if kind == 4:
        points = [x * (-1) ** i * mpq(10) ** 80 for i, x in enumerate(points)]
    return from_bezier(points)


def narrow_interval(chance):
    """Anywhere in [0, 1], at its ends too, from a tenth down to 300 digits wide."""
    width = mpq(chance.randint(1, 9), 10 ** chance.choice((1, 3, 20, 90, 300)))
    low = chance.choice([mpq(0), 1 - width, (1 - width) * mpq(chance.randint(0, 10**9), 10**9)])
    return low, low + width


@pytest.mark.parametrize("seed", range(8))
def test_values_are_between_the_bounds(seed):
    chance = random.Random(seed)
    for _ in range(100):
        n = chance.choice((0, 1, 2, 3, 7, 30))
        form, (low, high) = hostile_form(chance, n), narrow_interval(chance)
        least, most = bounds_over(form, n, low, high)
        for k in (0, 1, 3, 8, 13, 16):
            assert least <= value(form, n, low + (high - low) * k / 16) <= most


@pytest.mark.parametrize("seed", range(4))
def test_bounds_come_together_with_the_ends(seed):
    """At least as fast as the slope allows: nowhere is it steeper than n times the greatest step of Bézier points."""
    chance = random.Random(seed)
    for _ in range(50):
        n = chance.choice((1, 2, 3, 7, 30))
        points = [mpq(chance.randint(-99, 99)) for _ in range(n + 1)]
        low, high = narrow_interval(chance)
        steepest = n * max(abs(b - a) for a, b in pairwise(points)) * (1 + mpq(1, 2**30))
        curved = 4 * n * n * max(map(abs, points)) * 3**n
        least, most = bounds_over(from_bezier(points), n, low, high)
        assert most - least <= (2 * steepest + curved * (high - low)) * (high - low)


def test_one_parameter_is_a_value_and_a_constant_is_itself():
    form = from_bezier([mpq(1, 3), mpq(-7), mpq(5)])
    assert bounds_over(form, 2, mpq(2, 7), mpq(2, 7)) == (value(form, 2, mpq(2, 7)),) * 2
    assert bounds_over(from_bezier([mpq(4, 3)]), 0, mpq(0), mpq(1)) == (mpq(4, 3),) * 2


def test_at_a_double_zero_only_rounding_is_left():
    """(2t − 1)²: the slope is almost 0 there, so that the bounds are 2⁵⁰ times as narrow as the interval."""
    form, h = from_bezier([mpq(1), mpq(-1), mpq(1)]), mpq(1, 10**50)
    least, most = bounds_over(form, 2, mpq(1, 2) - h / 3, mpq(1, 2) + 2 * h / 3)
    assert least <= 0 <= most
    assert most - least <= h / 2**50
