"""Points of curves at many parameters are the quotients of the values of their splines."""

import random
from fractions import Fraction

import pytest
from gmpy2 import mpq

from exactspline import Nurbs, Side, example, examples
from exactspline.errors import DomainError, NumberError


def one_by_one(curve, ts, side):
    return [tuple(x(t, side) / curve.w(t, side) for x in curve.p) for t in ts]


def parameters(curve, chance, below):
    a, b = curve.domain
    return [*curve.breakpoints, *[a + (b - a) * mpq(chance.randint(0, below), below) for _ in range(20)]]


@pytest.mark.parametrize("side", list(Side))
def test_points_of_examples_are_those_of_their_splines(side):
    chance = random.Random(5)
    for name in examples("curves"):
        curve = example(name)
        # few denominators, and denominators with which each parameter is alone
        for below in (60, 2**257 + 1):
            ts = parameters(curve, chance, below)
            chance.shuffle(ts)
            assert curve.points_at(ts, side) == one_by_one(curve, ts, side), name
            assert [curve(t, side) for t in ts] == one_by_one(curve, ts, side), name


def test_points_on_both_sides_of_a_jump():
    curve = Nurbs(1, [-1, -1, "1/3", "1/3", 2, 2], [(0, 0), (1, "1/2"), (5, 5), (6, 7)], [1, 2, 3, 4])
    assert curve.points_at(["1/3"], "left") == [(1, mpq(1, 2))]
    assert curve.points_at(["1/3"]) == [(5, 5)]
    assert curve.points_at([-1, 2], "left") == [(0, 0), (6, 7)] == curve.points_at([-1, 2])


def test_no_points_and_bad_parameters():
    curve = example("circle")
    assert curve.points_at([]) == []
    assert curve.points_at([Fraction(1, 2)]) == [curve("1/2")]
    with pytest.raises(DomainError, match="-1"):
        curve.points_at([0, -1])
    with pytest.raises(NumberError, match=r"parameters\[1\]"):
        curve.points_at([0, 0.5])
