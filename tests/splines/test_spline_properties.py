"""B-splines: laws of arithmetic, and agreement with the textbook algorithms on the knots and control points that are
printed.
"""

from itertools import pairwise
from math import comb

import pytest
from gmpy2 import mpq
from hypothesis import assume, given, reject
from hypothesis import strategies as st

from exactspline import BSpline, Nurbs
from exactspline.errors import DomainError, KnotError, ReductionError, ShapeError
from exactspline.numbers.exact import from_float
from exactspline.splines import blossom
from tests.support import oracles
from tests.support.laws import check_ring_axioms
from tests.support.oracles import assert_function, polar, rebuilt
from tests.support.strategies import HUGE, JUMP, KINK, TINY, numbers, splines, splines_on_one_domain

# ---- what is printed is the function


@given(splines(high=6))
def test_values_are_those_of_the_de_boor_algorithm(f):
    knots, n, points = oracles.data(f)
    assert_function(f, lambda t, side: oracles.value(knots, n, points, t, side))


@given(splines_on_one_domain(3, high=3))
def test_computed_splines_print_what_they_are(fs):
    f, g, h = fs
    assert_function(f + g, lambda t, s: f(t, s) + g(t, s))
    assert_function(f - g, lambda t, s: f(t, s) - g(t, s))
    assert_function(f * g - h, lambda t, s: f(t, s) * g(t, s) - h(t, s))
    assert_function(f / 3 - mpq(1, 7), lambda t, s: f(t, s) / 3 - mpq(1, 7))


@given(splines(low=1, high=6))
def test_derivatives_are_differences_of_control_points(f):
    for t, side in oracles.places(f):
        expected = oracles.derivative_values(*oracles.data(f), t, side)
        assert [f.d(k)(t, side) for k in range(f.degree + 1)] == expected
        assert f.d(f.degree + 1)(t, side) == 0
    for k in range(1, f.degree + 1):
        assert f.d(k).degree == f.degree - k
        assert rebuilt(f.d(k)) == f.d(k)


@given(splines(high=4))
def test_knots_of_computed_splines_are_clamped_and_as_many_as_continuity_asks(f):
    for g in (f.d(), f * f, f + f.d()):
        if g.degree < 0:
            continue
        a, b = g.domain
        assert g.knots.multiplicity(a) == g.knots.multiplicity(b) == g.degree + 1
        assert len(g.control_points) == len(g.knots) - g.degree - 1
        for t in f.breakpoints[1:-1]:
            lost = f.knots.multiplicity(t) - f.degree
            assert g.knots.multiplicity(t) == min(
                g.degree + max(lost, -g.degree) + (0 if g.degree == 2 * f.degree and f.degree else 1), g.degree + 1
            )


# ---- laws


@given(splines_on_one_domain(3, high=4))
def test_ring_axioms(fs):
    check_ring_axioms(*fs)


@given(splines_on_one_domain(2, high=4))
def test_leibniz_rule(fs):
    f, g = fs
    assert (f * g).d() == f.d() * g + f * g.d()
    assert (f * g).d(2) == f.d(2) * g + 2 * f.d() * g.d() + f * g.d(2)
    assert (f + g).d() == f.d() + g.d()
    assert (f * mpq(2, 3)).d(2) == f.d(2) * mpq(2, 3)


@given(splines_on_one_domain(2, high=3), numbers())
def test_equality_is_equality_of_functions(fs, c):
    f, g = fs
    same = all(f(t, side) == g(t, side) for t, side in oracles.places(f * g))
    assert (f == g) == same
    assert f.elevate_degree(2) == f
    assert (f + c == f) == (c == 0)


@given(splines(high=4), st.data())
def test_a_bump_on_one_segment_makes_a_difference(f, data):
    n, i = f.degree, data.draw(st.integers(0, len(f.control_points) - 1))
    bump = BSpline(n, f.knots, [TINY if k == i else 0 for k in range(len(f.control_points))])
    g = f + bump
    a, b = f.domain
    visible = f.knots[i] < b and f.knots[i + n + 1] > a
    assert (f != g) == visible
    assert bump.is_zero != visible
    if not visible:
        assert hash(f) == hash(g)


@given(splines(high=4), st.sampled_from(["1/2", "1/3", "1/5", "999999999999/1000000000000"]))
def test_equal_splines_have_one_hash(f, part):
    a, b = f.domain
    t = a + (b - a) * mpq(part)
    others = [f.elevate_degree(), f + f.constant(0), (f * 2) / 2, f.reverse().reverse()]
    if f.knots.multiplicity(t) <= f.degree:
        others.append(f.insert_knot(t))
    for g in others:
        assert g == f
        assert hash(g) == hash(f)


def test_equality_needs_one_domain_and_a_spline():
    f = BSpline.bezier([0, 1])
    assert f != BSpline.bezier([0, 2], 0, 2)
    assert f != BSpline.bezier([0, 1], 0, 2)
    assert f != 0
    assert (f - f) != 0
    assert BSpline.bezier([2]) != 2
    assert f != "f"
    assert len({f, f.elevate_degree(), f.reverse()}) == 2


def test_representation_is_told_apart_from_the_function():
    f = BSpline.bezier([0, 1, 4])
    assert f.same_representation(BSpline(2, [0, 0, 0, 1, 1, 1], ["0", 1, "4.0"]))
    assert not f.same_representation(f.elevate_degree())
    assert not f.same_representation(f.insert_knot("1/2"))


# ---- other representations


@given(st.integers(1, 4), st.data())
def test_knots_are_inserted_at_ends_that_are_not_clamped(degree, data):
    """DomainErrors before, of both ends of every domain."""
    count = data.draw(st.integers(degree + 1, 8))
    numbers = st.fractions(0, 4, max_denominator=3) | st.floats(0, 4).map(from_float)
    knots = sorted(data.draw(st.lists(numbers, min_size=count + degree + 1, max_size=count + degree + 1)))
    points = data.draw(st.lists(st.tuples(st.integers(-9, 9), st.integers(1, 9)), min_size=count, max_size=count))
    try:
        f, curve = BSpline(degree, knots, [x for x, _ in points]), Nurbs(degree, knots, points, [w for _, w in points])
    except KnotError:
        reject()
    for t in f.domain:
        room = degree + 1 - f.knots.multiplicity(t)
        for times in range(1, room + 1):
            g, other = f.insert_knot(t, times), curve.insert_knot(t, times)
            assert g.knots == other.knots == f.knots.insert(t, times)
            assert BSpline(degree, g.knots, g.control_points) == g == f
            assert (other, other.domain, len(other.control_points)) == (curve, curve.domain, count + times)
        for refused in (f, curve):
            with pytest.raises((DomainError, KnotError)):
                refused.insert_knot(t, room + 1)


@given(
    splines(low=0, high=5),
    st.sampled_from(["1/2", "1/3", "2/7", "0.000000000001", "0.999999999999"]),
    st.integers(1, 6),
)
def test_insert_knot_keeps_the_function_and_remove_knot_undoes_it(f, part, times):
    a, b = f.domain
    t = a + (b - a) * mpq(part)
    room = f.degree + 1 - f.knots.multiplicity(t)
    if times > room:
        with pytest.raises(KnotError, match="multiplicity"):
            f.insert_knot(t, times)
        return
    g = f.insert_knot(t, times)
    assert g.knots.multiplicity(t) == f.knots.multiplicity(t) + times
    assert_function(g, f)
    h = g.remove_knot(t, times)
    assert h.knots.multiplicity(t) == f.knots.multiplicity(t)
    assert h.degree == f.degree
    assert_function(h, f)


@given(splines(low=0, high=4), st.integers(1, 3))
def test_elevate_then_reduce(f, by):
    g = f.elevate_degree(by)
    assert g.degree == f.degree + by
    for t in f.breakpoints[1:-1]:
        assert g.knots.multiplicity(t) == f.knots.multiplicity(t) + by
    assert_function(g, f)
    h = g.reduce_degree(by)
    assert h.degree == f.degree
    assert_function(h, f)
    for t in f.breakpoints[1:-1]:
        assert h.knots.multiplicity(t) <= f.knots.multiplicity(t)


@given(splines(low=0, high=5))
def test_true_degree_is_where_differences_vanish(f):
    true = -1
    for a, b in zip(f.breakpoints, f.breakpoints[1:], strict=False):
        row = [f(a + (b - a) * mpq(k + 1, f.degree + 2)) for k in range(f.degree + 1)]
        order = 0
        while row:
            true = max(true, order) if any(row) else true
            row, order = [y - x for x, y in pairwise(row)], order + 1
    assert f.true_degree == true
    least = max(true, 0)
    assert f.reduce_degree(f.degree - least) == f
    if least < f.degree:
        assert f.reduce_degree(f.degree - least).degree == least
    if 0 <= true <= f.degree and f.degree > 0 and true > 0:
        with pytest.raises(ReductionError) as caught:
            f.reduce_degree(f.degree - true + 1)
        assert f"can be lowered to {true}" in caught.value.remedy


def test_degree_reduction_names_the_segment():
    f = BSpline(2, [0, 0, 0, 1, 1, 1 + 1, 2, 2], [0, 1, 2, 3, 5])
    with pytest.raises(ReductionError, match=r"segment 1: the segment \[1, 2\] has true degree 2") as caught:
        f.reduce_degree()
    assert caught.value.data == {"segment": 1, "true_degree": 2}
    with pytest.raises(ReductionError, match="cannot be lowered by 3"):
        f.reduce_degree(3)
    with pytest.raises(ShapeError):
        f.reduce_degree(-1)
    with pytest.raises(ShapeError):
        f.elevate_degree(-1)


@given(splines(low=0, high=5))
def test_continuity_is_that_of_one_sided_derivatives(f):
    for t in f.breakpoints[1:-1]:
        left, right = (oracles.derivative_values(*oracles.data(f), t, side) for side in ("left", "right"))
        agreeing = next((k for k, (x, y) in enumerate(zip(left, right, strict=True)) if x != y), f.degree + 1) - 1
        assert f.continuity_at(t) == agreeing
        removable = min(agreeing - (f.degree - f.knots.multiplicity(t)), f.knots.multiplicity(t))
        if agreeing == f.degree:
            removable = f.knots.multiplicity(t)
        assert removable >= 0
        if removable:
            g = f.remove_knot(t, removable)
            assert g.knots.multiplicity(t) == f.knots.multiplicity(t) - removable
            assert_function(g, f)
        with pytest.raises((ReductionError, KnotError)):
            f.remove_knot(t, removable + 1)
    a, b = f.domain
    elsewhere = a + (b - a) * mpq(11, 100)
    if elsewhere not in f.breakpoints:
        assert f.continuity_at(elsewhere) == f.degree


def test_a_knot_that_must_stay_tells_the_derivative_that_jumps():
    f = BSpline(2, [0, 0, 0, 1, 1, 2, 2, 2], [0, 0, 1, 5, 5])
    with pytest.raises(ReductionError, match="the derivative of order 1 jumps at 1 by 6") as caught:
        f.remove_knot(1)
    assert caught.value.data["continuity"] == 0
    with pytest.raises(ReductionError, match="the derivative of order 0 jumps at 1/2 by 1"):
        JUMP.remove_knot("1/2")
    with pytest.raises(KnotError, match="1 of 0 knots at 1/3"):
        KINK.remove_knot("1/3")


def test_a_constant_has_no_knot_to_remove_at_a_breakpoint():
    with pytest.raises(KnotError, match="1 of 0 knots at 1/2"):
        KINK.constant(3).remove_knot("1/2")


@given(
    splines(high=4),
    st.sampled_from(["1/2", "1/3", "1/5", "3/7", "0.000000000001"]),
    st.sampled_from(["3/4", "1", "2/3", "0.99"]),
)
def test_parts(f, low, high):
    a, b = f.domain
    low, high = a + (b - a) * mpq(low), a + (b - a) * mpq(high)
    part = f.restrict(low, high)
    assert part.domain == (low, high)

    def inside(t, side):
        return f(t, {low: "right", high: "left"}.get(t, side))

    assert_function(part, inside)
    assert f.restrict(a, b) == f
    left, right = f.split(low)
    assert (left.domain, right.domain) == ((a, low), (low, b))
    assert right.restrict(low, high) == part
    assert left == f.restrict(a, low)
    if low not in f.breakpoints:
        assert left(low) == right(low) == f(low)


@given(splines(high=4))
def test_reverse_and_reparametrize(f):
    a, b = f.domain
    assert_function(f.reverse(), lambda t, side: f(a + b - t, "left" if side == "right" else "right"))
    assert (
        f.reverse().reverse().same_representation(f + f.constant(0))
        or f.knots[0] != a
        or f.knots[len(f.knots) - 1] != b
    )
    g = f.reparametrize(-1, HUGE)
    assert g.domain == (-1, HUGE)
    assert_function(g, lambda t, side: f(a + (t + 1) * (b - a) / (HUGE + 1), side))
    assert g.d().reparametrize(a, b) * (HUGE + 1) == f.d() * (b - a)
    with pytest.raises(DomainError):
        f.reparametrize(1, 1)


@given(splines(high=5))
def test_bezier_segments(f):
    segments = f.bezier_segments()
    assert [s.domain for s in segments] == list(zip(f.breakpoints, f.breakpoints[1:], strict=False))
    for s, points in zip(segments, f.bezier_points, strict=True):
        low, high = s.domain
        assert s.control_points == tuple(points)
        assert s == BSpline.bezier(points, low, high)
        assert (s(low), s(high)) == (f(low), f(high, "left"))
        for t in oracles.inner_parameters(s, f.degree + 1):
            assert s(t) == f(t)


@given(
    st.integers(0, 9), st.integers(1, 6), st.sampled_from([3, 10**17]), st.booleans(), st.randoms(use_true_random=False)
)
def test_the_form_of_a_span_has_the_blossom_for_its_points(n, runs, denominator, is_clamped, numbers):
    """Knots of any multiplicity, clamped or not: each form is in lowest terms, and its Bézier points are the polar form
    at the ends of the span.
    """
    places = sorted({mpq(numbers.randint(0, 99 * denominator), denominator) for _ in range(runs + 1)} | {mpq(-1)})
    multiplicities = [numbers.randint(1, n + 1) for _ in places]
    if is_clamped or sum(multiplicities) < 2 * n + 2:
        multiplicities[0] = multiplicities[-1] = n + 1
    knots = [t for t, m in zip(places, multiplicities, strict=True) for _ in range(m)]
    points = [mpq(numbers.randint(-9, 9), numbers.randint(1, denominator)) for _ in range(len(knots) - n - 1)]
    spans = [j for j in range(n, len(knots) - n - 1) if knots[j] < knots[j + 1]]
    assume(spans)
    for j, (c, m) in zip(spans, blossom.forms_of(knots, n, points, spans), strict=True):
        a, b = knots[j], knots[j + 1]
        expected = [polar(knots, n, points, j, [a] * (n - k) + [b] * k) for k in range(n + 1)]
        assert [mpq(int(c[k]), int(m) * comb(n, k)) for k in range(n + 1)] == expected
        assert m > 0
        assert c.content().gcd(m) == 1
