"""Components made together are those made one by one; corners found without angles are those of the joints."""

import random

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from exactspline import BSpline, Direction, KnotVector, Nurbs, analyse, example, examples
from exactspline.errors import KnotError, ShapeError
from exactspline.polynomials.bernstein import over_common_denominator
from exactspline.splines import blossom
from exactspline.splines.common import splines_over
from tests.support.strategies import DOMAINS, knot_vectors, numbers


@st.composite
def columns_over_knots(draw):
    """A degree, knots of any kind, and columns of control points."""
    degree = draw(st.integers(0, 4))
    knots = KnotVector(draw(knot_vectors(degree, draw(st.sampled_from(DOMAINS)))))
    count = len(knots) - degree - 1
    column = st.lists(numbers(), min_size=count, max_size=count).map(lambda row: tuple(map(mpq, row)))
    return degree, knots, draw(st.lists(column, min_size=1, max_size=3))


@given(columns_over_knots())
def test_components_made_together_are_those_made_one_by_one(drawn):
    degree, knots, columns = drawn
    expected = [BSpline(degree, knots, column) for column in columns]
    together = [over_common_denominator(forms) for forms in zip(*[x.forms for x in expected], strict=True)]
    for _ in range(degree + 2):  # from the last time on by weights for these knots
        made = splines_over(degree, knots, columns)
        for k, (x, y) in enumerate(zip(made, expected, strict=True)):
            assert list(x.forms) == [(numerators[k], below) for numerators, below in together]
            assert (x.degree, x.continuity, x.mesh.breaks) == (y.degree, y.continuity, y.mesh.breaks)
            assert (x.knots, x.control_points) == (y.knots, y.control_points)


def test_weights_are_computed_for_what_is_met_again_and_forgotten_in_time(monkeypatch):
    monkeypatch.setattr(blossom, "_met", type(blossom._met)())
    monkeypatch.setattr(blossom, "_weights", {})
    monkeypatch.setattr(blossom, "_along", {})
    monkeypatch.setattr(blossom, "PATTERNS", 5)
    monkeypatch.setattr(blossom, "ALONG", 5)
    t, column = [mpq(k) for k in [0] * 6 + [1] * 6], [[mpq(k) for k in (1, 2, 5, 7, 0, 1)]]
    found = [(blossom.common_rows(t, 5, column, [5]), len(blossom._weights)) for _ in range(3)]
    assert [count for _, count in found] == [0, 1, 1]
    assert found[0][0] == found[1][0] == found[2][0]
    for k in range(2, 40):  # every time another knot
        blossom.common_rows([*t[:6], *[mpq(1, k)], *t[6:]], 5, [[mpq(1)] * 7], [5, 6])
    assert len(blossom._met) < 10
    assert len(blossom._weights) < 10
    assert len(blossom._along) < 10


def test_knots_that_carry_one_degree_are_checked_for_another():
    knots = KnotVector([0, 0, 0, 0, 1, 1, 1, 1])
    BSpline(3, knots, [0, 1, 2, 3])
    for _ in range(2):
        with pytest.raises(KnotError):
            BSpline(2, knots, [0, 1, 2, 3, 4])
    assert BSpline(3, knots, [0, 1, 2, 3]).continuity == ()


def same_corners(curve):
    fresh = Nurbs(curve.degree, curve.knots, curve.control_points, curve.weights)
    expected = [joint for joint in analyse(fresh).joints if joint.angle is not None]
    assert list(analyse(curve).corners) == expected
    return len(expected)


def joined(chance, dimension):
    """A curve of arcs that meet smoothly, in corners, gaps and cusps, or stand still; now and then closed."""
    degree, steps = chance.randint(1, 3), [-1, 0, 0, 1, 2]
    multiplicities = [chance.choice([1, degree, degree, degree + 1]) for _ in range(chance.randint(1, 4))]
    inner = [k for k, m in enumerate(multiplicities, 1) for _ in range(m)]
    knots = [0] * (degree + 1) + inner + [len(multiplicities) + 1] * (degree + 1)
    points = [tuple(chance.choice(steps) for _ in range(dimension))]
    while len(points) < len(knots) - degree - 1:
        points.append(tuple(x + chance.choice(steps) for x in points[-1]) if chance.random() < 0.8 else points[-1])
    if chance.random() < 0.4:
        points[-1] = points[0]
    sign = chance.choice([1, -1])
    weights = chance.choice([None, [sign * chance.randint(1, 3) for _ in points]])
    return Nurbs(degree, knots, points, weights)


@pytest.mark.parametrize("dimension", [2, 3])
def test_corners_are_those_of_the_joints(dimension):
    chance = random.Random(dimension)
    found = [same_corners(joined(chance, dimension)) for _ in range(80)]
    assert sum(found) > 50
    assert 0 in found


def test_corners_of_examples_and_of_curves_with_points_at_infinity():
    for name in examples("curves"):
        same_corners(example(name))
    lens = Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 2], [(1, 0), Direction(0, 1), (-1, 0), Direction(0, -1), (1, 0)])
    sharp = Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 2], [(1, 0), Direction(0, 1), (-1, 0), (0, -2), (1, 0)])
    assert (same_corners(lens), same_corners(sharp)) == (0, 2)


def test_a_curve_in_four_dimensions_is_refused():
    with pytest.raises(ShapeError):
        analyse(Nurbs(1, [0, 0, 1, 2, 2], [(0, 0, 0, 0), (1, 0, 0, 0), (1, 1, 0, 0)])).corners  # noqa: B018
