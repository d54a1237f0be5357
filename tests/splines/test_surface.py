"""Splines in two parameters against the recursion of B-splines, and the laws of their algebra."""

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from exactspline.errors import ReductionError
from exactspline.splines.tensor import TensorSpline


@st.composite
def knot_vectors(draw, degree):
    inner = [mpq(k, 3) for k in (1, 2) for _ in range(draw(st.integers(0, degree + 1)))]
    return [mpq(0)] * (degree + 1) + inner + [mpq(1)] * (degree + 1)


@st.composite
def tensor_splines(draw, most=3):
    m, n = draw(st.integers(0, most)), draw(st.integers(0, most))
    knots_s, knots_t = draw(knot_vectors(m)), draw(knot_vectors(n))
    rows, columns = len(knots_s) - m - 1, len(knots_t) - n - 1
    entry = st.sampled_from([mpq(k, 2) for k in range(-3, 4)])
    net = draw(st.lists(st.lists(entry, min_size=columns, max_size=columns), min_size=rows, max_size=rows))
    return TensorSpline((m, n), knots_s, knots_t, net), (knots_s, knots_t, net)


PLACES = st.sampled_from([mpq(0), mpq(1, 7), mpq(1, 3), mpq(5, 11), mpq(2, 3), mpq(9, 10)])


def basis(i, degree, knots, t):
    """The B-spline by the recursion of Cox and de Boor."""
    if degree == 0:
        return mpq(int(knots[i] <= t < knots[i + 1]))
    value, rise, fall = mpq(0), knots[i + degree] - knots[i], knots[i + degree + 1] - knots[i + 1]
    if rise:
        value += (t - knots[i]) / rise * basis(i, degree - 1, knots, t)
    if fall:
        value += (knots[i + degree + 1] - t) / fall * basis(i + 1, degree - 1, knots, t)
    return value


@given(tensor_splines(), PLACES, PLACES)
def test_values_are_those_of_the_recursion(given_spline, s, t):
    f, (knots_s, knots_t, net) = given_spline
    m, n = f.degree
    expected = sum(
        x * basis(i, m, knots_s, s) * basis(j, n, knots_t, t) for i, row in enumerate(net) for j, x in enumerate(row)
    )
    assert f(s, t) == f.at_t(t)(s) == f.at_s(s)(t) == f.transposed()(t, s) == expected


@given(tensor_splines(), tensor_splines(), PLACES, PLACES)
def test_the_algebra_is_that_of_the_values(one, other, s, t):
    f, g = one[0], other[0]
    assert (f + g)(s, t) == f(s, t) + g(s, t)
    assert (f - g)(s, t) == f(s, t) - g(s, t)
    assert (f * g)(s, t) == f(s, t) * g(s, t)
    assert f.scaled("2/3")(s, t) == f(s, t) * mpq(2, 3)
    assert f + g == g + f
    assert (f - f).is_zero


@given(tensor_splines(), tensor_splines())
def test_partial_derivatives_obey_the_product_rule(one, other):
    """Also where the degree in a parameter is 0, and the derivative is zero."""
    f, g = one[0], other[0]
    for i, j in ((1, 0), (0, 1)):
        assert (f * g).partial(i, j) == f.partial(i, j) * g + f * g.partial(i, j)
    assert f.partial(1, 1) == f.partial(0, 1).partial(1, 0) == f.transposed().partial(1, 1).transposed()
    assert f.partial(f.degree.s + 1, 0).is_zero
    assert f.partial(0, f.degree.t + 2).is_zero


@given(tensor_splines())
def test_other_representations_are_the_same_function(given_spline):
    f, _ = given_spline
    raised = f.elevate_degree(1, 2)
    assert raised.degree == (f.degree.s + 1, f.degree.t + 2)
    assert raised == f
    assert hash(raised) == hash(f)
    assert raised.true_degree == f.true_degree
    assert raised.reduce_degree(1, 2).control_points == f.control_points
    assert f.insert_knot(0, "1/2").insert_knot(1, "1/5") == f
    assert TensorSpline(f.degree, *[list(k.knots) for k in f.knots], f.control_points) == f


@given(tensor_splines(), PLACES, PLACES)
def test_a_part_is_the_function_there(given_spline, s, t):
    f, _ = given_spline
    part = f.restrict(("1/7", "10/11"), ("1/9", "19/20"))
    if mpq(1, 7) <= s <= mpq(10, 11) and mpq(1, 9) <= t:
        assert part(s, t) == f(s, t)


def test_a_degree_that_is_needed_is_not_taken():
    saddle = TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[0, 0], [0, 1]])
    with pytest.raises(ReductionError):
        saddle.reduce_degree(1, 0)
