"""Zero sets of splines: knots, intervals, jumps, the seam; and whatever hypothesis finds."""

import itertools
import re

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from exactspline import BSpline, ExactSplineError, check_certificate, zeros
from tests.support.strategies import DOMAINS, TINY, splines


def broken(*pieces):
    """A spline of degree 2 that jumps from one Bézier triple to the next, at 1, 2, ..."""
    knots = [i for i in range(len(pieces) + 1) for _ in range(3)]
    return BSpline(2, knots, [b for piece in pieces for b in piece])


def test_zero_function():
    for f in (BSpline.bezier([0, 0]), BSpline.bezier([1, 2]).d(3), broken((0, 0, 0), (0, 0, 0))):
        found = zeros(f)
        assert [(s.low, s.high, s.signs) for s in found.intervals] == [(*f.domain, (None, None))]
        assert not found.roots
        assert not found.jumps


def test_stretches_are_merged_and_know_their_neighbours():
    found = zeros(broken((1, 1, 0), (0, 0, 0), (0, 0, 0), (0, -1, -2), (0, 0, 0)))
    assert [(s.low, s.high, s.signs) for s in found.intervals] == [(1, 3, (1, -1)), (4, 5, (-1, None))]
    assert not found.roots
    assert [(j.parameter, j.left.value, j.right.multiplicity) for j in found.jumps] == [(4, -2, None)]
    (stretch,) = zeros(broken((-1, 4, 0), (0, 0, 0), (0, -4, 1))).intervals
    assert stretch.signs == (1, -1)  # next to it, not where the segments begin and end


def test_root_at_a_smooth_and_at_a_sharp_knot():
    smooth, sharp = BSpline(2, [0, 0, 0, 1, 2, 2, 2], [-1, "-1/2", "1/2", 2]), broken((1, 1, 0), (0, 0, 3))
    (root,) = zeros(smooth)
    assert (root.exact, root.multiplicity, root.sign_change, root.at_knot) == (1, 1, True, True)
    (root,) = zeros(sharp)
    assert (root.exact, root.left_multiplicity, root.right_multiplicity, root.multiplicity, root.sign_change) == (
        1,
        1,
        2,
        1,
        False,
    )


def test_jumps():
    found = zeros(broken((1, 1, 1), (-1, -1, 2), (3, 3, 3), (0, 1, 1), (1, 1, 1), (0, -1, -1)))
    assert [(j.parameter, j.left.value, j.right.value, j.sign_change) for j in found.jumps] == [
        (1, 1, -1, True), (3, 3, 0, False), (5, 1, 0, True)
    ]  # fmt: skip
    assert len(found) == 1
    assert 1 < found[0] < 2


def test_zero_on_both_sides_of_a_jump_in_the_derivative_is_one_root():
    found = zeros(broken((-1, 0, 0), (0, 0, 1)))
    assert [(r.exact, r.multiplicity, r.sign_change) for r in found] == [(1, 2, True)]


def test_seam():
    f = broken((0, 1, 1), (1, 0, 0))
    ends = zeros(f)
    assert [(r.exact, r.left_multiplicity, r.right_multiplicity, r.signs) for r in ends] == [
        (0, None, 1, (None, 1)),
        (2, 2, None, (1, None)),
    ]
    closed = zeros(f, periodic=True)
    assert [(r.exact, r.left_multiplicity, r.right_multiplicity, r.signs) for r in closed] == [(0, 2, 1, (1, 1))]
    open_ended = broken((-1, -1, 1), (1, 1, 1))
    assert not zeros(open_ended).jumps
    assert [(j.parameter, j.sign_change) for j in zeros(open_ended, periodic=True).jumps] == [(0, True)]
    across = zeros(broken((0, 0, 0), (0, 1, 0), (0, 0, 0)), periodic=True)
    assert [(s.parts, s.signs) for s in across.intervals] == [(((2, 3), (0, 1)), (1, 1))]


PIECES = st.sampled_from([(0, 0, 0), (0, 0, 0), (1, 1, 0), (0, 1, 1), (1, -1, 1), (0, 1, 0)])


@given(st.lists(PIECES, min_size=1, max_size=5))
def test_no_parameter_lies_outside_the_domain_and_the_stretches_are_all_that_is_zero(pieces):
    """Of a stretch across the seam, too: its parts, what it says of itself, and its certificate."""
    f = broken(*pieces)
    low, high = f.domain
    found = zeros(f, periodic=True)
    parts = [part for stretch in found.intervals for part in stretch.parts]
    assert all(low <= a < b <= high for a, b in parts)
    told = [mpq(t) for stretch in found.intervals for t in re.findall(r"-?\d+(?:/\d+)?", repr(stretch))]
    told += [mpq(t) for stretch in found.certificate()["intervals"] for t in stretch]
    assert all(low <= t <= high for t in told)
    covered = {a for a, b in itertools.pairwise(f.breakpoints) if any(c <= a and b <= d for c, d in parts)}
    assert covered == {a for a, p in zip(f.breakpoints, f.numerators, strict=False) if not p}
    assert all((stretch.high < stretch.low) == (len(stretch.parts) == 2) for stretch in found.intervals)
    check_certificate(found.certificate())


def test_one_periodic_segment():
    found = zeros(BSpline.bezier([0, 1, 0]), periodic=True)
    assert [(r.exact, r.signs, r.multiplicity) for r in found] == [(0, (1, 1), 1)]


def test_only_splines():
    with pytest.raises(ExactSplineError, match="give a BSpline"):
        zeros([1, 2])


@st.composite
def troubled(draw):
    """A product of linear and quadratic factors with repeated, nearly repeated, tiny-gap and complex zeros, and the
    expected real ones.
    """
    a, b = draw(st.sampled_from(DOMAINS))
    t, width = BSpline.identity(a, b), b - a
    places = st.sampled_from(
        [
            mpq(0),
            mpq(1),
            mpq(1, 2),
            mpq(3, 8),
            mpq(1, 3),
            mpq(1, 3) + TINY,
            mpq(1, 3) + TINY**8,
            TINY,
            1 - TINY,
            mpq(2, 7),
        ]
    )
    roots = draw(st.dictionaries(places, st.integers(1, 4), max_size=4))
    f = t.constant(draw(st.sampled_from([1, -7, mpq(10**20, 3)])))
    for place, times in roots.items():
        f = f * ((t - (a + width * place)) * (1 / width)) ** times
    for place in draw(st.lists(places, max_size=2)):
        f = f * (((t - (a + width * place)) * (1 / width)) ** 2 + draw(st.sampled_from([TINY**4, mpq(1)])))
    return f, {a + width * place: times for place, times in roots.items()}


@given(troubled())
def test_roots_put_in_are_the_roots_found(case):
    f, expected = case
    found = zeros(f)
    assert len(found) == len(expected)
    a, b = f.domain
    for root, (t, times) in zip(found, sorted(expected.items()), strict=True):
        assert root == t
        assert root.multiplicity == times
        assert root.sign_change == (a < t < b and times % 2 == 1)
        assert hash(root) == hash(t)
    assert check_certificate(found.certificate())["roots"] == len(expected)


@given(troubled(), troubled())
def test_roots_of_different_splines_compare_like_the_numbers_they_are(one, other):
    for root, t in zip(zeros(one[0]), sorted(one[1]), strict=True):
        for another, s in zip(zeros(other[0]), sorted(other[1]), strict=True):
            assert (root == another, root < another, root > another) == (t == s, t < s, t > s)
            assert (root == s, root < s) == (t == s, t < s)


@given(splines(high=5, most=2), st.booleans())
def test_every_certificate_holds_and_values_change_sign(f, periodic):
    found = zeros(f, periodic=periodic)
    result = check_certificate(found.certificate())
    assert result == {"roots": len(found), "jumps": len(found.jumps), "intervals": len(found.intervals)}
    found.refine(30)
    assert check_certificate(found.certificate()) == result
    assert all(x < y for x, y in zip(found.roots, found.roots[1:], strict=False))
    for root in found:
        assert root.high - root.low <= mpq(1, 10**30)
        if root.exact is not None:
            assert f(root.exact, "left" if root.exact == f.domain[1] else "right") == 0
        else:
            low, high = f(root.low), f(root.high)
            assert ((low > 0) - (low < 0), (high > 0) - (high < 0)) == root.signs


@given(splines(high=4, most=2))
def test_signs_between_the_zeros_are_constant(f):
    found = zeros(f)
    stops = sorted({*f.breakpoints, *(t for root in found for t in root.refine(25))})
    inside = [r for r in found if r.low < r.high]
    for a, b in itertools.pairwise(stops):
        if any(r.low == a and r.high == b for r in inside):
            continue
        signs = {(f(a + (b - a) * mpq(k, 7)) > 0) - (f(a + (b - a) * mpq(k, 7)) < 0) for k in range(1, 7)}
        assert len(signs) == 1


@pytest.mark.parametrize("periodic", [False, True])
@pytest.mark.parametrize(
    ("points", "places", "signs"),
    [
        ([0, 0, 1, 1], [(0, 1)], (None, 1)),
        ([-1, -1, 0, 0], [(2, 3)], (-1, None)),
        ([1, 0, 0, -2], [(1, 2)], (1, -1)),
        ([0, 0, 0, 0], [(0, 3)], (None, None)),
    ],
)
def test_intervals_of_zeros_know_the_signs_on_both_sides(points, places, signs, periodic):
    f = BSpline(1, [0, 0, 1, 2, 3, 3], points)
    (found,) = zeros(f, periodic=periodic).intervals
    assert list(found.parts) == places
    left, right = f(0), f(3)
    if periodic and any(points):  # beyond an end is the other one
        beyond = [int(x > 0) - int(x < 0) for x in (right, left)]
        signs = tuple(beyond[i] if sign is None else sign for i, sign in enumerate(signs))
    assert found.signs == signs


@pytest.mark.parametrize("values", [(0, 1), (1, 0), (0, -2)])
def test_the_limits_at_a_jump_from_a_piece_that_vanishes(values):
    (jump,) = zeros(BSpline(0, [0, 1, 2], values)).jumps
    assert (jump.left.value, jump.right.value) == values
