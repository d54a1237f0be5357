"""Composition of splines: values, chain rule, and what happens where knots meet."""

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from exactspline import BSpline
from exactspline.errors import DomainError, ReductionError
from tests.support import oracles
from tests.support.oracles import rebuilt
from tests.support.strategies import JUMP, KINK, TINY, numbers, splines


@st.composite
def compositions(draw):
    """An outer spline over [0, 1] and an inner one with values there; knots of the outer one often lie at values at
    knots of the inner one.
    """
    parts = st.sampled_from([mpq(0), mpq(1), mpq(1, 2), mpq(1, 2), mpq(1, 3), mpq(1, 4), TINY])
    inner = draw(splines(low=0, high=3, domain=(mpq(0), mpq(1)), values=parts))
    at_knots = [x for t in inner.breakpoints for x in (inner(t), inner(t, "left")) if 0 < x < 1]
    n = draw(st.integers(1, 3))
    knots = sorted(draw(st.lists(st.sampled_from([*at_knots, mpq(1, 2), mpq(1, 3)]), max_size=2, unique=True)))
    inside = [t for t in knots for _ in range(draw(st.integers(1, n + 1)))]
    count = n + 1 + len(inside)
    return BSpline(
        n, [*[0] * (n + 1), *inside, *[1] * (n + 1)], draw(st.lists(numbers(), min_size=count, max_size=count))
    ), inner


def assert_composition(outer, inner):
    h = outer.compose(inner)
    assert h.degree == outer.degree * inner.degree
    assert rebuilt(h) == h
    for t in oracles.inner_parameters(h, h.degree + 1):
        s = inner(t)
        assert h(t) == outer(s) or (s in outer.breakpoints and h(t) == outer(s, "left"))
        assert oracles.value(*oracles.data(h), t) == h(t)
    return h


@given(compositions())
def test_composition_and_its_derivative(pair):
    outer, inner = pair
    irrational = None
    try:
        h = assert_composition(outer, inner)
    except ReductionError as error:
        irrational = error.data["polynomial"]
    if irrational is not None:
        assert len(irrational) > 2
        assert inner.degree >= 2
        return
    if inner.degree > 0:
        assert h.d() == outer.d().compose(inner) * inner.d()


@given(
    splines(low=1, high=3, domain=(mpq(0), mpq(1))),
    st.sampled_from([(0, 1), (1, 0), ("1/3", "1/2"), ("1/2", "1/2"), (0, "0.000000000001")]),
)
def test_composition_with_lines(outer, ends):
    inner = BSpline.bezier(ends, 2, 3)
    h = assert_composition(outer, inner)
    if mpq(ends[0]) < mpq(ends[1]):
        assert h == outer.restrict(*ends).reparametrize(2, 3)
    if ends == (1, 0):
        assert h == outer.reverse().reparametrize(2, 3)


def test_composition_where_an_inner_knot_meets_an_outer_one():
    """The inner knot is smoother than the outer one: the kink must survive in the printed data."""
    inner = BSpline.identity(0, 1).elevate_degree().insert_knot("1/2")
    h = KINK.compose(inner)
    assert h == KINK
    assert h.continuity_at("1/2") == 0
    assert h.knots.multiplicity("1/2") == 2
    assert rebuilt(h) == h


def test_composition_that_arrives_at_a_jump_and_stays():
    inner = BSpline(1, [0, 0, "1/2", 1, 1], [0, "1/2", "1/2"])
    h = JUMP.compose(inner)
    assert (h("1/4"), h("3/4")) == (0, 1)
    assert rebuilt(h) == h


def test_composition_that_touches_a_jump_or_passes_it_at_an_inner_knot():
    touching = JUMP.compose(BSpline.bezier([0, 1, 0]))
    assert [touching(t) for t in (0, "1/4", "3/4", 1)] == [0, 0, 0, 0]
    assert JUMP.compose(BSpline.bezier([1, 0, 1])) == JUMP.constant(1)
    for k in range(1, 6):
        u = BSpline.identity(0, 1) - mpq(k, 6)
        assert JUMP.compose(mpq(1, 2) - mpq(18, 25) * u * u) == JUMP.constant(0)
    for values in (["0", "1/2", "1"], ["1", "1/2", "0"], ["0", "1/2", "0"], ["1", "1/2", "1/2"]):
        h = assert_composition(JUMP, BSpline(1, [0, 0, "1/2", 1, 1], values).elevate_degree(2))
        assert [h("1/4"), h("3/4")] == [int(mpq(values[0]) > mpq(1, 2)), int(mpq(values[2]) >= mpq(1, 2))]


def test_composition_with_irrational_preimages_is_refused():
    with pytest.raises(ReductionError, match="the knot 1/2 of the outer spline has an irrational preimage on"):
        KINK.compose(BSpline.bezier([0, 0, 1]))
    assert KINK.compose(BSpline.bezier([0, "1/2", "1/2"]))(1) == 1
    with pytest.raises(DomainError, match="leaves the outer domain"):
        KINK.compose(BSpline.bezier([0, 3, 0, 0]).reparametrize(0, 5))
    touching = BSpline.bezier([0, 1, 0])
    assert KINK.compose(touching) == BSpline(2, [0, 0, 0, 1, 1, 1], [0, 2, 0])


def test_composition_with_a_zero_function_of_negative_degree():
    outer, zero = BSpline.bezier([5, 1, 2]), BSpline.bezier([3]).d()
    h = outer.compose(zero)
    assert [h(t) for t in (0, mpq(1, 3), 1)] == [5, 5, 5]
