"""The concrete curve: what its constructors accept, what they refuse, and an exact circle."""

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from exactspline import BSpline, Direction, Nurbs
from exactspline.errors import DomainError, NumberError, ShapeError, WeightError
from exactspline.language import Rational, Vector, dot
from tests.support import oracles
from tests.support.strategies import TINY, nurbs

KNOTS = [0, 0, 0, 1, 1, 1]
POINTS = [(0, 0), (1, 1), (2, 0)]

#: Weight functions with a zero: degree, knots, weights and the parameters between which it lies (equal where it is
#: known exactly).
ZEROS = {
    "inside, double": (2, KNOTS, [1, -1, 1], "1/2", "1/2"),
    "inside, rational": (1, [0, 0, 3, 3], [2, -1], 2, 2),
    "at the start": (2, KNOTS, [0, 1, 1], 0, 0),
    "at the end": (2, KNOTS, [1, 1, 0], 1, 1),
    "at a knot": (1, [0, 0, 1, 2, 2], [1, 0, 1], 1, 1),
    "everywhere": (1, [0, 0, 1, 1], [0, 0], 0, 1),
    "on a segment": (1, [0, 0, 1, 2, 2], [1, 0, 0], 1, 1),
    "on an inner segment": (0, [0, 1, 2, 3], [1, 0, 1], 1, 2),
    "from the left of a jump": (1, [0, 0, 1, 1, 2, 2], [1, 0, 1, 1], 1, 1),
    "from the right of a jump": (1, [0, 0, 1, 1, 2, 2], [1, 1, 0, 1], 1, 1),
    "a jump over zero": (0, [0, 1, 2], [1, -1], 1, 1),
    "a jump over zero, degree 1": (1, [0, 0, 1, 1, 2, 2], [1, 2, -1, -3], 1, 1),
}


@pytest.mark.parametrize("what", ZEROS)
def test_a_zero_of_the_denominator_is_shown(what):
    n, knots, weights, low, high = ZEROS[what]
    with pytest.raises(WeightError, match="must keep its sign") as caught:
        Nurbs.from_homogeneous(n, knots, [(1, 2, w) for w in weights])
    assert caught.value.where == "weights"
    found_low, found_high = caught.value.data["witness"]
    assert mpq(low) <= found_low <= found_high <= mpq(high)
    if low == high:
        assert f"at the parameter {low}" in str(caught.value)


@pytest.mark.parametrize("weights", [[1, -1, "1/2"], [1, 1, -1], [2, -2, 1], [-1, 1, -1 + 2 * TINY]], ids=str)
def test_an_irrational_zero_is_enclosed(weights):
    """The sign of w changes (or has a double root) in the interval that is named."""
    with pytest.raises(WeightError, match="between the parameters") as caught:
        Nurbs(2, KNOTS, POINTS, weights)
    low, high = caught.value.data["witness"]
    w = BSpline.bezier(weights)
    assert 0 <= low < high <= 1
    assert w(low) * w(high) < 0


@pytest.mark.parametrize("weights", [[1, "-1/2", 1], [-1, -2, -3], [1, -1 + TINY, 1], [TINY, TINY, 1]], ids=str)
def test_weights_that_keep_their_sign_are_taken_whatever_their_signs_are(weights):
    curve = Nurbs(2, KNOTS, POINTS, weights)
    for k in range(8):
        t = mpq(k, 7)
        assert curve.w(t) == BSpline.bezier(weights)(t)
        assert curve.w(t) * curve.w(0) > 0


@given(nurbs())
def test_a_curve_is_the_quotient_of_its_splines(curve):
    knots, n = tuple(curve.knots), curve.degree
    lifted = [
        [x * w for x, w in zip(column, curve.weights, strict=True)]
        for column in zip(*curve.control_points, strict=True)
    ]
    for t, side in oracles.places(curve.p[0]):
        w = oracles.value(knots, n, curve.weights, t, side)
        point = tuple(oracles.value(knots, n, column, t, side) / w for column in lifted)
        assert curve(t, side) == point
        assert (tuple(x(t, side) for x in curve.gamma) if curve.polynomial else curve.gamma(t, side)) == point
    assert curve.segments == len(curve.breakpoints) - 1
    assert (curve.domain[0], curve.domain[1]) == (curve.breakpoints[0], curve.breakpoints[-1])


@given(nurbs(dimension=3), st.sampled_from([mpq(1), mpq(-2), mpq(1, 3)]))
def test_homogeneous_points_make_the_same_curve(curve, scale):
    rows = [
        tuple(scale * x for x in (*(c * w for c in row), w))
        for row, w in zip(curve.control_points, curve.weights, strict=True)
    ]
    other = Nurbs.from_homogeneous(curve.degree, curve.knots, rows)
    assert other.control_points == curve.control_points
    assert other.polynomial == curve.polynomial
    if curve.polynomial:
        assert other.p == curve.p
    else:
        assert other.weights == tuple(scale * w for w in curve.weights)
        assert other.p == scale * curve.p
        assert other.w == scale * curve.w


def test_a_homogeneous_point_of_weight_zero_is_a_control_vector():
    half = Nurbs.from_homogeneous(2, KNOTS, [(1, 0, 1), (0, 1, 0), (-1, 0, 1)])
    assert not half.polynomial
    assert half(mpq(1, 2)) == (0, 1)
    assert half.control_points[1] == Direction(0, 1) != (0, 1)
    assert dot(half.p, half.p) == half.w * half.w
    for rows in ([(1, 2), (3, 1)], [(1, 2, 1), (3, 1)]):
        with pytest.raises(ShapeError):
            Nurbs.from_homogeneous(1, [0, 0, 1, 1], rows)


@pytest.mark.parametrize("weights", [None, [1, 1, 1], ["1/2", "0.5", "5e-1"], [-3, -3, -3], [TINY] * 3], ids=str)
def test_equal_weights_mean_a_polynomial(weights):
    curve = Nurbs(2, KNOTS, POINTS, weights)
    assert curve.polynomial
    assert curve.w.degree == 0
    assert curve.w == curve.w.constant(1)
    assert curve.gamma is curve.p
    assert curve.p == Vector(BSpline.bezier([0, 1, 2]), BSpline.bezier([0, 1, 0]))
    assert curve.gamma.d().degree == 1


def test_unequal_weights_mean_a_quotient():
    curve = Nurbs(2, KNOTS, POINTS, [1, 1, 1 + TINY])
    assert not curve.polynomial
    assert isinstance(curve.gamma, Rational)
    assert curve.gamma.denominator is curve.w
    assert curve.w.degree == 2


CIRCLE = Nurbs(
    2,
    [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4],
    [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)],
    [1, 1, 2, 1, 1, 1, 2, 1, 1],
    name="circle",
)


def test_the_circle_is_a_circle():
    x, y = CIRCLE.p
    assert x * x + y * y == CIRCLE.w * CIRCLE.w
    assert CIRCLE.closed
    assert [CIRCLE(t) for t in range(5)] == [(1, 0), (0, 1), (-1, 0), (0, -1), (1, 0)]
    assert CIRCLE("1/2") == (mpq(3, 5), mpq(4, 5))
    assert CIRCLE.segments == 4
    assert "circle" in repr(CIRCLE)
    assert "rational" in repr(CIRCLE)
    radius = dot(CIRCLE.gamma, CIRCLE.gamma)
    assert radius.numerator == radius.denominator
    assert radius.degree == 4


def test_sides_and_ends():
    jump = Nurbs(1, [0, 0, 1, 1, 2, 2], [(0, 0), (2, 2), (4, 0), (0, 0)], [1, 2, 1, 1])
    assert (jump(1, "left"), jump(1), jump(1, "right")) == ((2, 2), (4, 0), (4, 0))
    assert jump.closed
    assert not Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 0)]).closed
    for t in (-TINY, 2 + TINY):
        with pytest.raises(DomainError):
            jump(t)
    with pytest.raises(NumberError):
        jump(0.5)
