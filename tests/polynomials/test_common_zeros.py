"""Certified zeros in two parameters: where the answer is known by construction, and what must not be claimed."""

import pickle
import random
from itertools import chain, pairwise, product

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from exactspline.bivariate.common_zeros import zeros_of
from exactspline.bivariate.signs import sign_on_patch
from exactspline.bivariate.zero_curve import Begun, ZeroCurve
from exactspline.bivariate.zero_lines import common_factor, odd_part, rational_lines, without_powers
from exactspline.numbers.intervals import UNIT, Box, Interval
from exactspline.polynomials.certified_boxes import Isolated, contracting, isolate, simplest
from exactspline.polynomials.patch_forms import PatchForm, Sized, clusters, of_powers, powers_of
from exactspline.polynomials.two_parameters import CONTEXT, S, T, as_form, as_polynomial

ONE = CONTEXT.from_dict({(0, 0): 1})


def pair(*polynomials):
    """Polynomials as forms."""
    return [as_form(p) for p in polynomials]


# ---- forms


@given(st.lists(st.integers(-9, 9), min_size=12, max_size=12), st.fractions(-1, 2, max_denominator=7))
def test_forms_are_the_polynomials_they_say(values, t):
    rows = [values[4 * i : 4 * i + 4] for i in range(3)]
    form = of_powers(rows)
    x, y = mpq(t.numerator, t.denominator), mpq(2, 7)
    value = sum(a * x**i * y**j for i, row in enumerate(rows) for j, a in enumerate(row))
    # a form is its polynomial times a positive constant
    other = mpq(3, 5)
    again = sum(a * other**i * y**j for i, row in enumerate(rows) for j, a in enumerate(row))
    raised = form.elevated((4, 4))
    for one in (form, raised):
        assert one.value(x, y) * again == one.value(other, y) * value
        assert one.value(x, y) * value >= 0
    assert [int(a) * b for a, b in zip(chain(*powers_of(form)), values, strict=True) if a * b < 0] == []
    low, high = map(int, form.range)
    assert low <= form.value(mpq(1, 2), mpq(1, 3)) <= high
    left, right = form.halves(1)
    assert left.value(x, mpq(1)) * right.value(mpq(0), mpq(0)) == right.value(x, mpq(0)) * left.value(mpq(0), mpq(1))


def test_borders_are_taken_off_and_nothing_else():
    form = as_form(S**2 * (ONE - T) ** 3 * (S - T) * (1 - S))
    bare, times = form.without_border()
    assert (bare.degree, tuple(times)) == ((1, 1), (2, 1, 0, 3))
    assert odd_part(as_form((S - T) ** 3 * (S + T) ** 2)).degree == (1, 1)
    assert common_factor([as_form(S * (S - T)), as_form((S - T) * (T + 1))]).degree == (1, 1)
    assert common_factor([as_form(S), as_form(T)]) is None


@pytest.mark.parametrize("place", [mpq(97, 100), mpq(29, 30), mpq(0.97)])
def test_the_box_of_a_zero_contains_it_however_far_it_is_refined(place):
    """x + 4(1 − x)⁵/25 has a slope of nearly 1 but close to 0. A mutant passed: Krawczyk's operator with the values at
    another point than the middle, to whose distance from the ends the radius then does not belong.
    """

    def vanishing_at(x, end):
        there = 25 * x + 4 * (1 - x) ** 5
        scale = int(there.denominator)
        return as_form((end * 25 + (1 - end) ** 5 * 4) * scale - int(there * scale)).elevated((5, 5))

    # the second zero is close to the other end
    zero = Isolated((vanishing_at(place, S), vanishing_at(place, 1 - T)), UNIT)
    for bits in (2, 9, 40, 200):
        box = zero.refine(bits)
        assert box.contains(Box.point(place, 1 - place))
        assert box.longest <= mpq(1, 1 << bits)


@pytest.mark.parametrize("n", [2, 40])
def test_derivatives_and_lines_of_forms_of_low_and_high_degree(n):
    """Differences of rows and products of matrices are the same; a line is the part of the form on it."""
    rng = random.Random(n)
    form = PatchForm.of_net([[rng.randint(-9, 9) for _ in range(4)] for _ in range(n + 1)])
    across = PatchForm(form.matrix.transpose())
    x, y, h = mpq(1, 3), mpq(2, 5), mpq(1, 10**40)
    for own, place, other in ((form, (x, y), (x + h, y)), (across, (y, x), (y, x + h))):
        k = int(own is across)
        slope = (own.value(*other) - own.value(*place)) / h
        assert abs(own.derivative(k).value(*place) - slope) < mpq(1, 10**20)
        line = own.on_line(k, x)
        expected = own.part(Box(*([Interval.point(x), Interval(mpq(0), mpq(1))][:: 1 - 2 * k]))).edge(k, 0)
        assert [a * line[0] for a in expected] == [b * expected[0] for b in line]
        assert line[0] * expected[0] > 0


# ---- signs


def test_signs_are_proved_or_left_open():
    third = (3 * S - 1) ** 2 + (3 * T - 1) ** 2
    assert sign_on_patch(as_form(third * 1000 + 1)).sign == "positive"
    assert sign_on_patch(as_form(third)).sign == "undecided"
    assert sign_on_patch(as_form(third * 1000 - 1)).sign == "both signs"
    half = sign_on_patch(as_form(-((2 * S - 1) ** 2) - (2 * T - 1) ** 2))
    assert (half.sign, half.zeros) == ("negative except at single zeros", ((mpq(1, 2), mpq(1, 2)),))
    assert sign_on_patch(PatchForm.of_net([[0, 0], [0, 0]])).sign == "zero"


# ---- common zeros


@given(
    st.lists(st.fractions(-1, 2, max_denominator=9), min_size=1, max_size=3, unique=True),
    st.lists(st.fractions(-1, 2, max_denominator=9), min_size=1, max_size=3, unique=True),
)
def test_a_grid_of_zeros_is_found_whole(xs, ys):
    f, g = ONE, ONE
    for x in xs:
        f = f * (x.denominator * S - x.numerator)
    for y in ys:
        g = g * (y.denominator * T - y.numerator)
    # sheared, so that neither form depends on one parameter alone
    found = zeros_of(pair(f + g, f - 2 * g))
    assert not found.undecided
    expected = {(mpq(x.numerator, x.denominator), mpq(y.numerator, y.denominator)) for x, y in product(xs, ys)}
    closed = {p for p in expected if all(0 <= t <= 1 for t in p)}
    places = {zero.exact for zero in found.zeros}
    assert len(places) == len(found.zeros)
    assert places == closed
    assert {zero.exact for zero in found.zeros if zero.is_inside} == {p for p in closed if all(0 < t < 1 for t in p)}


def test_the_simplest_number_of_an_interval_may_be_its_end():
    assert [simplest(*map(mpq, ends)) for ends in ((3, 3), ("5/2", 3), ("2/7", "2/7"))] == [3, 3, mpq(2, 7)]


def test_boxes_shrink_around_the_zero_and_keep_it():
    circle, line = S * S + T * T - 1, S - T
    (zero,) = zeros_of(pair(circle, line)).zeros
    for bits in (10, 50, 200):
        (a, b), (c, d) = zero.refine(bits)
        assert b - a <= mpq(1, 1 << bits)
        assert 2 * a * a < 1 < 2 * b * b
        assert 2 * c * c < 1 < 2 * d * d
    assert zero.exact is None


def test_what_nearly_meets_is_told_apart_from_what_touches():
    bowl = 1000 * (2 * S - 1) ** 2 - (T * 1000000 - 500000)
    assert len(zeros_of(pair(bowl, T * 1000000 - 500001)).zeros) == 2
    assert zeros_of(pair(bowl, T * 1000000 - 499999)) == ([], [], None)
    touching = pair(bowl, T * 1000000 - 500000)
    assert not isolate(touching).zeros
    assert [zero.exact for zero in zeros_of(touching).zeros] == [(mpq(1, 2), mpq(1, 2))]


def test_the_third_form_excludes():
    given = pair(2 * S - 1, 2 * T - 1)
    assert zeros_of([*given, as_form(S + T - 3)]).zeros == []
    assert zeros_of(given, also=[as_form(3 * S + T - 1)]).zeros == []
    assert zeros_of(given, not_positive=[as_form(3 * S + T - 1)]).zeros == []
    assert len(zeros_of(given, also=[as_form(S + T - 1)], not_positive=[as_form(S + T - 1)]).zeros) == 1
    assert simplest(mpq(1, 3), mpq(1, 2)) == mpq(1, 2)
    assert isolate(given, [as_form(S + T + 1)]) == ([], [])
    assert len(isolate(given, [as_form(S + T - 1)]).zeros) == 1


@pytest.mark.parametrize("seed", range(200))
def test_a_pair_that_contracts_is_dominant(seed):
    """Would pass otherwise: one zero at most in a box in which there are two."""
    draw = random.Random(seed)
    m, n = draw.randint(1, 2), draw.randint(1, 2)
    net = [
        [[12 * (i, j)[k] * (m, n)[1 - k] + draw.randint(-3, 3) for j in range(n + 1)] for i in range(m + 1)]
        for k in (0, 1)
    ]
    if seed % 2:
        net = [
            [[x + draw.choice([4, 6, 8, 12]) * (j, i)[k] for j, x in enumerate(row)] for i, row in enumerate(own)]
            for k, own in enumerate(net)
        ]
    forms = [PatchForm.of_net(own) for own in net]
    found = contracting(forms)
    for k, form in enumerate(forms):
        own, other = form.derivative(k).range, form.derivative(1 - k).range
        if found is not None:
            # Krawczyk's operator contracts each side by at least a quarter
            widest = own[1] - own[0] + 2 * max(abs(other[0]), abs(other[1]))
            assert 4 * widest <= 3 * (own[0] + own[1])
            assert own[0] > max(abs(other[0]), abs(other[1]))


def test_a_curve_is_open_only_where_it_meets_an_open_box():
    """Would pass otherwise: a loop around a box in which something is undecided was incomplete."""
    form = as_form((4 * S - 2) ** 2 + (4 * T - 2) ** 2 - 1)
    for x, shape in ((mpq(1, 2), "closed loop"), (mpq(1, 4), "arc into an undecided box")):
        box = Box(Interval(x - mpq(1, 32), x + mpq(1, 32)), Interval(mpq(15, 32), mpq(17, 32)))
        curve = ZeroCurve(form, begun=Begun([Sized(UNIT, [form])], (), [box]))
        assert curve.undecided == [box]
        assert {part.shape for part in curve.parts} == {shape}
        assert pickle.loads(pickle.dumps(curve)).undecided == [box]


def test_rational_lines_of_zeros():
    form = as_form((2 * S - 1) * (3 * S + 1) * (3 * T - 1) * (S + T))
    assert rational_lines(form, 0) == [mpq(-1, 3), mpq(1, 2)]
    assert rational_lines(form, 1) == [mpq(1, 3)]


def test_powers_are_divided_out_in_pairs_where_signs_are_kept():
    first, second = as_form(2 * S - 1), as_form(3 * T - 1)
    cube = as_form((2 * S - 1) ** 3 * (3 * T - 1))
    assert as_polynomial(without_powers(cube, first)) == as_polynomial(second)
    assert as_polynomial(without_powers(cube, first, even=True)) == as_polynomial(first) * as_polynomial(second)
    assert without_powers(first, first, even=True).degree == (1, 0)


# ---- curves


def shapes(p):
    curve = ZeroCurve(as_form(p))
    assert curve.complete
    return sorted(part.shape for part in curve.parts)


def circle(x, y, radius, scale=100):
    """A circle by hundredths."""
    return (scale * S - x) ** 2 + (scale * T - y) ** 2 - radius**2


@pytest.mark.parametrize(
    ("polynomial", "expected"),
    [
        (circle(50, 50, 30), ["closed loop"]),
        (circle(50, 50, 30) * circle(50, 50, 20), ["closed loop"] * 2),
        (circle(30, 30, 20) * circle(70, 70, 20), ["closed loop"] * 2),
        (circle(50, 50, 60), ["arc from border to border"] * 4),
        (circle(0, 0, 50), ["arc from border to border"]),
        (circle(50, 50, 50), ["closed loop"]),
        (circle(50, 50, 80), []),
        (2 * S - 1, ["arc from border to border"]),
        (3 * S - 3 * T, ["arc from border to border"]),
        ((3 * S - 1) * (3 * S - 2) * (5 * S - 1), ["arc from border to border"] * 3),
        ((3 * S - 1) * (3 * T - 1), ["branches that cross"]),
        ((3 * S - 1) ** 2 + (3 * T - 1) ** 2, ["single point"]),
        ((3 * S - 1) ** 2 + (3 * T - 1) ** 2 + 1, []),
        ((S - T) * (S + T - 1), ["branches that cross"]),
        (circle(40, 50, 20) * (100 * S - 40), ["branches that cross"]),
        # through the corner at which the square is first cut
        ((61 * S - 29) ** 2 + (61 * T - 9) ** 2 - 400, ["arc from border to border"]),
        ((61 * S - 29) ** 2 + (61 * T - 49) ** 2 - 400, ["arc from border to border"]),
        (2 * T - S, ["arc from border to border"]),
        (29 * (61 * T - 29) - 17 * (61 * S - 29), ["arc from border to border"]),
        # a lemniscate, and two crossings on one line
        (((3 * S - 1) ** 2 + (3 * T - 1) ** 2) ** 2 - (3 * S - 1) ** 2 + (3 * T - 1) ** 2, ["branches that cross"]),
        ((3 * T - 1) * ((4 * S - 2) ** 2 - (3 * T - 1) - 1), ["branches that cross"]),
    ],
)
def test_topology_of_curves_that_are_known(polynomial, expected):
    assert shapes(polynomial) == sorted(expected)


def test_a_cusp_is_passed():
    """All points are ((1 + p²)/2, (1 + p³)/2). Passed before: the cusp was undecided."""
    curve = ZeroCurve(as_form((2 * T - 1) ** 2 - (2 * S - 1) ** 3))
    assert curve.complete
    (part,) = curve.parts
    assert part.shape == "arc from border to border"
    for p in (mpq(k, 7) for k in (-6, -3, 3, 6)):
        place = (1 + p**2) / 2, (1 + p**3) / 2
        boxes = (*part.cells, *(arc.box for arc in part.arcs))
        assert any(all(a <= x <= b for x, (a, b) in zip(place, box, strict=True)) for box in boxes)
    ends = {(vertex.value, vertex.other) for vertex, count in part.ends.items() if count == 1}
    assert ends == {(1, 0), (1, 1)}


@pytest.mark.parametrize("seed", range(6))
def test_lines_across_meet_a_curve_where_its_arcs_say(seed):
    """On lines that were not used every change of sign is between points of one arc."""
    drawn = random.Random(seed)
    form = of_powers([[drawn.randint(-9, 9) for _ in range(4)] for _ in range(4)])
    curve = ZeroCurve(form)
    assert curve.complete
    for x in (mpq(k, 17) for k in range(1, 17)):
        crossings = 0
        for part in curve.parts:
            for arc in part.arcs:
                crossings += _crossings(curve, arc, x)
        values = [form.value(x, mpq(k, 400)) for k in range(401)]
        changes = sum((a < 0) != (b < 0) for a, b in pairwise(values))
        assert crossings >= changes
        assert (crossings - changes) % 2 == 0


def _crossings(curve, arc, x):
    """How often an arc meets the line of a first coordinate."""
    (a, b), (c, d) = arc.box
    if not a <= x <= b:
        return 0
    part = curve.form.part(((x, x), (c, d)))
    values = [part.value(mpq(0), mpq(k, 200)) for k in range(201)]
    changes = [(c + (d - c) * mpq(k, 200)) for k, (p, q) in enumerate(pairwise(values)) if (p < 0) != (q < 0)]
    if arc.direction == 0:
        return sum(1 for y in changes if arc.low <= y <= arc.high)
    return len(changes) if arc.low <= x <= arc.high else 0


def test_boxes_that_touch_are_one_cluster():
    """Of boxes in two groups, each of which touches in a chain."""

    def box(a, b):
        return Box(Interval(mpq(a), mpq(a + 1)), Interval(mpq(b), mpq(b + 1)))

    near, far = [box(0, 0), box(2, 1), box(1, 0)], [box(7, 7), box(8, 8)]
    for boxes in ([near[0], far[0], *near[1:], far[1]], [far[1], *near, far[0]]):
        assert sorted(hull for hull, _ in clusters(boxes)) == [((0, 3), (0, 2)), ((7, 9), (7, 9))]
    assert sorted(hull for hull, _ in clusters([near[0], *far])) == [near[0], ((7, 9), (7, 9))]
