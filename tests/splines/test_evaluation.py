"""Points of curves at many parameters are the quotients of the values of their splines."""

import random
from fractions import Fraction
from math import comb

import pytest
from gmpy2 import mpq

from exactspline import Direction, Nurbs, Side, example, examples
from exactspline.errors import DomainError, NumberError
from exactspline.splines import evaluation


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


def curves():
    """Data of curves: numbers of many sizes, weights of either sign, jumps, directions, ends that are not clamped."""
    chance = random.Random(11)
    for degree, knots in (
        (1, [0, 0, 1, 1, 3, 3]),
        (2, [0, 0, 0, "1/3", 2, 2, 2]),
        (3, range(-3, 9)),
        (4, [0] * 5 + [7] * 5),
    ):
        for size in (9, 10**30):
            points = [
                tuple(Fraction(chance.randint(-size, size), 7) for _ in range(2))
                for _ in range(len(knots) - degree - 1)
            ]
            weights = [chance.randint(1, 9) for _ in points]
            yield degree, knots, points, None
            yield degree, knots, points, weights
            yield degree, knots, [(x / 2**70, y / 10**40) for x, y in points], [-w for w in weights]
            if degree > 1:
                yield degree, knots, [points[0], Direction(*points[1]), *points[2:]], [weights[0], 0, *weights[2:]]


@pytest.mark.skipif(evaluation._in_c("curve_points") is None, reason="there is no extension here")
def test_many_points_in_c_are_those_without(monkeypatch):
    chance, in_c, calls = random.Random(3), evaluation._in_c("curve_points"), []
    counted = lambda *given: calls.append(len(given)) or in_c(*given)  # noqa: E731  # one expression
    for data in curves():
        curve, again = Nurbs(*data), Nurbs(*data)
        a, b = curve.domain
        ts = parameters(curve, chance, 1000)
        doubles = [*[float(t) for t in ts[-20:]], float(a), float(b)]
        for side in Side:
            monkeypatch.setattr(evaluation, "_in_c", lambda *_: counted)
            points, found = curve.points_at(ts, side), curve.floats(doubles, side=side).tolist()
            monkeypatch.setattr(evaluation, "_in_c", lambda *_: None)
            assert points == again.points_at(ts, side)
            assert found == again.floats(doubles, side=side).tolist()
            exact = again.points_at([mpq(*t.as_integer_ratio()) for t in doubles], side)
            assert found == [[int(x.numerator) / int(x.denominator) for x in point] for point in exact]
    assert len(calls) > 40


def moved(curve):
    """The quotients of the integers of every segment, moved to the origin, and of its denominator."""
    binomials = [comb(curve.degree, k) for k in range(curve.degree + 1)]
    for rows, below in curve.rows:
        *coordinates, w = rows if not curve.polynomial else (*rows, binomials)
        parts = [[x * w[0] - c[0] * y for x, y in zip(c, w, strict=True)] for c in coordinates]
        parts += [] if curve.polynomial else [[y * w[0] for y in w]]
        yield [[mpq(int(x), int(below * w[0])) for x in part] for part in parts]


@pytest.mark.skipif(evaluation._in_c("curve_points") is None, reason="there is no extension here")
@pytest.mark.parametrize("run", [1, 512])
def test_forms_in_c_are_the_first_bits_of_the_moved_integers(run, monkeypatch):
    """With weights for C, and without them: knots of 17 digits have none."""
    monkeypatch.setattr(evaluation, "RUN", run)
    irregular = [0] * 4 + [mpq(k) / 3 + mpq(0.1) ** k for k in (1, 2)] + [3] * 4
    for degree, knots, *data in [*curves(), (3, irregular, [(k, mpq(0.7) ** k) for k in range(6)], None)]:
        curve = Nurbs(degree, knots, *data)
        near, rest = [[mpq(x) for x in own] for own in curve.evaluation.forms(0, curve.segments)]
        exact, count = list(moved(curve)), curve.segments
        for segment, below in enumerate(range(len(near) - count, len(near))):
            assert 1 <= abs(near[below]) < 2 >= abs(rest[below]) * 2**52
            for c, part in enumerate(exact[segment]):
                for i, x in enumerate(part):
                    k = (c * count + segment) * (degree + 1) + i
                    whole = x * (near[below] + rest[below])
                    assert abs(near[k] - whole) * 2**52 < abs(whole) * (1 + mpq(1, 2**40)) or near[k] == whole == 0
                    assert abs(near[k] + rest[k] - whole) * 2**102 <= abs(whole)


WHOLE = 2**53 + 1
#: Values just below, at and just above the middle of two neighbouring doubles, and integers near powers of 2.
NEAR_THE_MIDDLE = [
    (WHOLE + d) * mpq(2) ** power
    for power in (0, 64, 900, -900, -1070)
    for d in (0, mpq(1, 2**60), -mpq(1, 2**60), mpq(1, 3), mpq(1, 10**40))
]
WHOLES = [mpq(0), *[mpq(2**k + d) for k in (0, 53, 63, 64, 65, 127, 128, 129) for d in (-1, 0, 1)]]


@pytest.mark.parametrize("values", [NEAR_THE_MIDDLE, WHOLES])
@pytest.mark.parametrize("sign", [1, -1])
def test_doubles_of_special_values_are_the_nearest_ones(values, sign):
    """The values are vertices of a polygon."""
    knots = [0, *range(len(values)), len(values) - 1]
    for weights in (None, [2 + k % 3 for k in range(len(values))], [-2 - k % 3 for k in range(len(values))]):
        curve = Nurbs(1, knots, [(sign * x, 1) for x in values], weights)
        found = curve.floats([float(k) for k in range(len(values))])[:, 0].tolist()
        assert found == [sign * int(x.numerator) / int(x.denominator) for x in values]


def test_coordinates_beyond_the_largest_double_are_infinite():
    curve = Nurbs(1, [0, 0, 1, 1], [(0, 2**1100), (1, -(2**1100))])
    assert curve.floats([0.0, 0.25, 0.5, 0.75, 1.0])[:, 1].tolist() == [float("inf")] * 2 + [0.0] + [-float("inf")] * 2
