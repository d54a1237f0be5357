"""Splines in two parameters: laws of arithmetic, and agreement with the textbook algorithms on the knots and nets that
are printed.
"""

from itertools import pairwise

import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from exactspline import BSpline, TensorSpline
from exactspline.errors import KnotError, ReductionError
from exactspline.splines.tensor import lifted
from tests.support import oracles
from tests.support.laws import check_ring_axioms
from tests.support.oracles import assert_surface, surface_rebuilt, transposed
from tests.support.strategies import (
    DOMAINS,
    TINY,
    knot_vectors,
    numbers,
    splines,
    tensor_splines,
    tensor_splines_on_one_rectangle,
)

#: Every example of these looks at every patch at many places.
FEWER = settings(max_examples=12)

# ---- what is printed is the function


@FEWER
@given(st.data())
def test_values_are_those_of_the_double_de_boor_algorithm(data):
    m, n = data.draw(st.integers(0, 3)), data.draw(st.integers(0, 3))
    knots = [data.draw(knot_vectors(k, data.draw(st.sampled_from(DOMAINS)), 2)) for k in (m, n)]
    rows, columns = len(knots[0]) - m - 1, len(knots[1]) - n - 1
    net = [data.draw(st.lists(numbers(), min_size=columns, max_size=columns)) for _ in range(rows)]
    f = TensorSpline((m, n), *knots, net)
    for s, t in oracles.surface_places(f):
        assert f(s, t) == oracles.surface_value(knots, (m, n), net, s, t)
    assert_surface(f, f)


@FEWER
@given(tensor_splines_on_one_rectangle(3))
def test_computed_splines_print_what_they_are(fs):
    f, g, h = fs
    assert_surface(f + g, lambda s, t: f(s, t) + g(s, t))
    assert_surface(f - h, lambda s, t: f(s, t) - h(s, t))
    assert_surface(f * g, lambda s, t: f(s, t) * g(s, t))
    assert_surface(f * g - h, lambda s, t: f(s, t) * g(s, t) - h(s, t))
    assert_surface(f / 3 - mpq(1, 7), lambda s, t: f(s, t) / 3 - mpq(1, 7))
    assert_surface(f.transposed(), lambda s, t: f(t, s))


@given(tensor_splines_on_one_rectangle(2))
def test_degrees_and_knots_of_computed_splines(fs):
    f, g = fs
    total, product = f + g, f * g
    for i in range(2):
        assert total.degree[i] == max(f.degree[i], g.degree[i])
        assert product.degree[i] == f.degree[i] + g.degree[i]
        for x in (total, product):
            a, b = x.meshes[i].domain
            assert x.knots[i].multiplicity(a) == x.knots[i].multiplicity(b) == x.degree[i] + 1
            for t in x.meshes[i].breaks[1:-1]:
                inherited = [
                    y.knots[i].multiplicity(t) + x.degree[i] - y.degree[i] for y in (f, g) if t in y.knots[i].knots
                ]
                assert x.knots[i].multiplicity(t) == max(inherited, default=0)


# ---- laws


@FEWER
@given(tensor_splines_on_one_rectangle(3))
def test_ring_axioms(fs):
    check_ring_axioms(*fs)


@FEWER
@given(tensor_splines_on_one_rectangle(2))
def test_what_is_known_to_depend_on_one_parameter_computes_the_same(fs):
    """Rebuilt from its net nothing is known of a spline; nothing that is computed may change."""
    f, g = fs
    plain_f, plain_g = surface_rebuilt(f), surface_rebuilt(g)
    assert plain_f.profile is None
    for operation in (lambda x, y: x + y, lambda x, y: x - y, lambda x, y: x * y, lambda x, y: x * x * y - y * 3):
        for x, y in ((f, plain_g), (plain_f, g), (plain_f, plain_g)):
            result, expected = operation(x, y), operation(f, g)
            assert result == expected
            assert hash(result) == hash(expected)
            assert result.degree == expected.degree
    for change in (
        lambda x: x.partial(1, 0),
        lambda x: x.partial(0, 1),
        lambda x: x.partial(2, 1),
        lambda x: x.transposed(),
        lambda x: x.elevate_degree(1, 2),
        lambda x: x.elevate_degree(0, 1),
        lambda x: x.elevated_to(g),
        lambda x: x / 7,
    ):
        assert change(f) == change(plain_f)
        assert change(f).degree == change(plain_f).degree
        assert change(f).true_degree == change(plain_f).true_degree


@given(splines(high=4), splines(high=2), st.sampled_from([0, 1]))
def test_a_lifted_spline(f, g, direction):
    meshes = (f.mesh, g.mesh) if direction == 0 else (g.mesh, f.mesh)
    lift = lifted(f, meshes, direction)
    assert_surface(lift, lambda s, t: f(s if direction == 0 else t))
    (a, b), (c, d) = lift.domain
    along = lift.at_t((c + d) / 2) if direction == 0 else lift.at_s((a + b) / 2)
    across = lift.at_s((a + b) / 2) if direction == 0 else lift.at_t((c + d) / 2)
    assert along == f
    assert across == g.constant(f((f.domain[0] + f.domain[1]) / 2))
    for k in range(f.degree + 3):
        assert lift.d(k).at_t(c) == f.d(k) if direction == 0 else lift.d(k).at_s(a) == f.d(k)
        assert lift.d(k) == (lift.partial(k, 0) if direction == 0 else lift.partial(0, k))
    assert (lift.partial(0, 1) if direction == 0 else lift.partial(1, 0)).is_zero


# ---- derivatives


@FEWER
@given(tensor_splines(high=3))
def test_partial_derivatives_are_those_of_iso_curves(f):
    knots, (m, n), net = oracles.surface_data(f)
    for _, t in oracles.surface_places(f):
        curve = BSpline(m, knots[0], [oracles.value(knots[1], n, row, t) for row in net])
        assert f.at_t(t) == curve
        for k in range(1, m + 2):
            assert f.partial(k, 0).at_t(t) == curve.d(k)
    for s, _ in oracles.surface_places(f):
        curve = BSpline(n, knots[1], [oracles.value(knots[0], m, row, s) for row in transposed(net)])
        assert f.at_s(s) == curve
        for k in range(1, n + 2):
            assert f.partial(0, k).at_s(s) == curve.d(k)


@given(tensor_splines(high=3), st.integers(0, 4), st.integers(0, 4))
def test_mixed_partials_commute(f, i, j):
    mixed = f.partial(i, j)
    assert mixed == f.partial(i, 0).partial(0, j) == f.partial(0, j).partial(i, 0)
    beyond = i > f.degree.s or j > f.degree.t
    assert mixed.degree == ((0, 0) if beyond else (f.degree.s - i, f.degree.t - j))
    assert mixed.is_zero or not beyond
    assert f.transposed().partial(j, i).transposed() == mixed
    assert f.partial(0, 0) == f


@FEWER
@given(tensor_splines_on_one_rectangle(2))
def test_leibniz_rule(fs):
    f, g = fs
    for i, j in ((1, 0), (0, 1)):
        assert (f * g).partial(i, j) == f.partial(i, j) * g + f * g.partial(i, j)
        assert (f + g).partial(i, j) == f.partial(i, j) + g.partial(i, j)
    mixed = (
        f.partial(1, 1) * g
        + f.partial(1, 0) * g.partial(0, 1)
        + f.partial(0, 1) * g.partial(1, 0)
        + f * g.partial(1, 1)
    )
    assert (f * g).partial(1, 1) == mixed


@FEWER
@given(tensor_splines())
def test_continuity_is_as_it_is_said(f):
    for x in (f, f * f, f + f.partial(1, 0), f.partial(0, 1), f.transposed()):
        for s, t in oracles.surface_places(x):
            for curve, own, breaks, n in zip(
                (x.at_t(t), x.at_s(s)), x.continuity, (m.breaks[1:-1] for m in x.meshes), x.degree, strict=True
            ):
                assert all(curve.continuity_at(b) >= min(c, n) for b, c in zip(breaks, own, strict=True))


# ---- equality


@FEWER
@given(tensor_splines_on_one_rectangle(2), numbers())
def test_equality_is_equality_of_functions(fs, c):
    f, g = fs
    same = all(f(s, t) == g(s, t) for s, t in oracles.surface_places(f * g))
    assert (f == g) == same
    assert f.elevate_degree(2, 1) == f
    assert (f + c == f) == (c == 0)


@given(tensor_splines(), st.data())
def test_a_bump_on_one_patch_makes_a_difference(f, data):
    knots, (m, n), net = oracles.surface_data(f)
    i, j = data.draw(st.integers(0, len(net) - 1)), data.draw(st.integers(0, len(net[0]) - 1))
    bump = TensorSpline(
        (m, n), *knots, [[TINY if (h, k) == (i, j) else 0 for k in range(len(net[0]))] for h in range(len(net))]
    )
    assert f + bump != f
    assert not bump.is_zero
    assert (f + bump) - bump == f


@given(tensor_splines(), st.data())
def test_equal_functions_have_one_hash(f, data):
    others = [
        f.elevate_degree(1, 0),
        f.elevate_degree(0, 2),
        surface_rebuilt(f),
        (f + f) / 2,
        f.transposed().transposed(),
    ]
    for direction in range(2):
        a, b = f.domain[direction]
        others.append(
            f.insert_knot(direction, a + (b - a) * data.draw(st.sampled_from([mpq(1, 7), mpq(1, 4), mpq(3, 4)])))
        )
    for g in others:
        assert g == f
        assert hash(g) == hash(f)
    (a, b), (c, d) = f.domain
    assert f.restrict((a, (a + b) / 2), (c, d)) != f
    assert f != 3
    assert f != "f"


# ---- other representations


@FEWER
@given(tensor_splines(), st.integers(0, 2), st.integers(0, 2))
def test_degrees_raised_and_lowered(f, i, j):
    raised = f.elevate_degree(i, j)
    assert raised.degree == (f.degree.s + i, f.degree.t + j)
    assert_surface(raised, f)
    lowered = raised.reduce_degree(i, j)
    assert lowered == f
    assert lowered.degree == f.degree
    assert raised.true_degree == f.true_degree


@FEWER
@given(tensor_splines(high=3), st.integers(0, 1))
def test_what_is_done_patch_by_patch_is_done_line_by_line(f, direction):
    """Derivatives, true degrees and lower degrees on packed polynomials, and by splines in one parameter."""
    for g in (f, f * f):
        if g.degree[direction] > 0:
            by_lines, direct = g.along(direction, lambda line: line.d()), g.partial(1 - direction, direction)
            assert (direct.degree, direct.continuity) == (by_lines.degree, by_lines.continuity)
            assert direct == by_lines
        patches = [g.bezier_net(i, j) for i in range(len(g.meshes[0])) for j in range(len(g.meshes[1]))]
        both = (
            [column for net in patches for column in zip(*net, strict=True)],
            [row for net in patches for row in net],
        )
        assert g.true_degree == tuple(max(BSpline.bezier(points).true_degree for points in own) for own in both)
        high = g.elevate_degree(2, 1)
        lower = high.along(0, lambda line: line.reduce_degree(2)).along(1, lambda line: line.reduce_degree(1))
        if not g.is_zero:
            assert (high.reduce_degree(2, 1).degree, lower.degree) == (g.degree, g.degree)
        assert high.reduce_degree(2, 1) == lower


@given(tensor_splines(high=3))
def test_the_true_degree_is_that_of_the_last_derivative(f):
    s, t = f.true_degree
    assert f.partial(s + 1, 0).is_zero
    assert f.partial(0, t + 1).is_zero
    assert (s == -1) == (t == -1) == f.is_zero
    if not f.is_zero:
        assert not f.partial(s, 0).is_zero
        assert not f.partial(0, t).is_zero
        f.reduce_degree(f.degree.s - s, f.degree.t - t)
        for by in ((f.degree.s - s + 1, 0), (0, f.degree.t - t + 1)):
            with pytest.raises(ReductionError):
                f.reduce_degree(*by)


@FEWER
@given(tensor_splines(), st.sampled_from([0, 1]), st.sampled_from(["1/2", "1/3", "1/5", "0.000000000001"]))
def test_knots_inserted(f, direction, part):
    a, b = f.domain[direction]
    x = a + (b - a) * mpq(part)
    before = f.knots[direction].multiplicity(x)
    if before > f.degree[direction]:
        with pytest.raises(KnotError):
            f.insert_knot(direction, x)
        return
    g = f.insert_knot(direction, x)
    assert g.knots[direction].multiplicity(x) == before + 1
    assert g.knots[1 - direction].knots == f.elevate_degree(0, 0).knots[1 - direction].knots
    assert_surface(g, f)


@FEWER
@given(
    tensor_splines(),
    st.sampled_from(["0", "1/2", "1/3", "1/5", "0.000000000001"]),
    st.sampled_from(["3/4", "1", "2/3", "0.99"]),
)
def test_parts(f, low, high):
    (a, b), (c, d) = f.domain
    side_s, side_t = (a + (b - a) * mpq(low), a + (b - a) * mpq(high)), (c + (d - c) * mpq(1, 3), d)
    part = f.restrict(side_s, side_t)
    assert part.domain == (side_s, side_t)
    for s, t in oracles.surface_places(part):
        if s < side_s[1]:
            assert part(s, t) == f(s, t)
    assert surface_rebuilt(part) == part
    assert f.restrict((a, b), (c, d)) == f


@given(tensor_splines())
def test_bezier_nets(f):
    for i, (a, b) in enumerate(pairwise(f.meshes[0].breaks)):
        for j, (c, d) in enumerate(pairwise(f.meshes[1].breaks)):
            net = f.bezier_net(i, j)
            patch = TensorSpline(f.degree, [a] * len(net) + [b] * len(net), [c] * len(net[0]) + [d] * len(net[0]), net)
            assert patch == f.restrict((a, b), (c, d))
            assert patch.control_points == tuple(map(tuple, net))
