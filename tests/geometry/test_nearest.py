"""Nearest points: against dense samples, with ties, at ends and knots, everywhere on arcs."""

from random import Random

import pytest
from gmpy2 import mpq

from exactspline import Nurbs, example, nearest, square_root
from exactspline.errors import ShapeError


def curve_of(random, dimension, *, rational):
    count = random.randint(4, 7)
    points = [[random.randint(-9, 9) for _ in range(dimension)] for _ in range(count)]
    knots = [0] * 4 + list(range(1, count - 3)) + [count - 3] * 4
    return Nurbs(3, knots, points, [random.randint(1, 4) for _ in points] if rational else None)


@pytest.mark.parametrize("seed", range(20))
def test_no_sample_is_nearer_and_the_distance_is_that_of_the_point(seed):
    random = Random(seed)
    dimension = random.choice([2, 2, 3])
    curve = curve_of(random, dimension, rational=seed % 2 == 1)
    point = [random.randint(-9, 9) for _ in range(dimension)]
    found = nearest(curve, point)
    assert found
    a, b = curve.domain
    samples = curve.points_at([a + (b - a) * mpq(k, 400) for k in range(401)])
    least = min(sum((x - y) ** 2 for x, y in zip(sample, point, strict=True)) for sample in samples)
    assert all(p.squared <= least for p in found)
    for p in found:
        at = sum(((x - y) * (x - y) for x, y in zip(p.point, point, strict=True)), start=mpq(0))
        assert abs(float(p.squared) - float(at)) < 1e-9


def test_two_points_at_exactly_the_same_distance():
    parabola = Nurbs(2, [0, 0, 0, 1, 1, 1], [(-1, 1), (0, -1), (1, 1)])
    first, second = nearest(parabola, (0, 1))
    assert first.squared == second.squared == mpq(3, 4)
    assert first.distance == square_root("3/4")
    assert first.parameter + second.parameter == 1


def test_one_of_two_is_nearer_by_less_than_any_double_tells():
    parabola = Nurbs(2, [0, 0, 0, 1, 1, 1], [(-1, 1), (0, -1), (1, 1)])
    (found,) = nearest(parabola, (mpq(1, 1 << 120), 1))
    assert found.parameter > mpq(1, 2)


def test_ends_knots_and_the_seam_count_once():
    polygon = Nurbs(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (2, 0), (2, 2), (0, 2), (0, 0)])
    assert [p.parameter for p in nearest(polygon, (-1, -1))] == [0]
    assert [p.parameter for p in nearest(polygon, (3, 3))] == [2]
    assert [p.parameter for p in nearest(polygon, (1, 1))] == [mpq(1, 2), mpq(3, 2), mpq(5, 2), mpq(7, 2)]
    assert [p.parameter for p in nearest(polygon.restrict(0, 3), (-1, -1))] == [0]


@pytest.mark.parametrize("reverse", [False, True])
def test_the_end_of_an_arc_at_the_seam_is_not_listed_again(reverse):
    """The point (0, 1) was in the list beside the quarter circle that ends there, at the end of the domain."""
    weights = [1, 1, 1, 1, 2]
    closed = Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 2], [(0, 1), (5, 5), (1, 0), (1, 1), (0, 1)], weights)
    found = nearest(closed.reverse() if reverse else closed, (0, 0))
    assert [str(piece) for piece in found.everywhere] == ["[0, 1]" if reverse else "[1, 2]"]
    assert found.points == ()


def test_everywhere_on_arcs_around_the_point():
    circle = example("circle")
    assert not nearest(circle, (0, 0)).points
    assert str(nearest(circle, (0, 0)).everywhere[0]) == "[0, 4]"
    quarter = circle.restrict(1, 2)
    assert [str(piece) for piece in nearest(quarter, (0, 0)).everywhere] == ["[1, 2]"]


def test_a_point_of_another_dimension():
    with pytest.raises(ShapeError, match="2 coordinates"):
        nearest(example("twisted_cubic"), (0, 0))
