"""Winding numbers: against sums of angles, on curves through vertices and along the ray, and on the curve."""

from itertools import pairwise
from math import atan2, pi
from random import Random

import pytest
from gmpy2 import mpq

from exactspline import Nurbs, contains, example, winding_number
from exactspline.errors import DomainError, ShapeError

SQUARE = Nurbs(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (2, 0), (2, 2), (0, 2), (0, 0)])
STAR = Nurbs(1, [0, 0, 1, 2, 3, 4, 5, 5], [(0, 3), (2, -3), (-3, 1), (3, 1), (-2, -3), (0, 3)])


def closed_cubics(random, count):
    points = [(random.randint(-9, 9), random.randint(-9, 9)) for _ in range(3 * count)]
    knots = [0] * 4 + [k for k in range(1, count) for _ in range(3)] + [count] * 4
    return Nurbs(3, knots, [*points, points[0]])


def sum_of_angles(curve, point, steps):
    """The winding number from angles between many points, each turn below half a circle."""
    a, b = map(float, curve.domain)
    angles = []
    for k in range(steps + 1):
        x, y = map(float, curve(mpq(a) + (mpq(b) - mpq(a)) * mpq(k, steps)))
        angles.append(atan2(y - float(point[1]), x - float(point[0])))
    turns = [(v - u + pi) % (2 * pi) - pi for u, v in pairwise(angles)]
    return round(sum(turns) / (2 * pi))


@pytest.mark.parametrize("seed", range(6))
def test_the_winding_number_is_the_sum_of_angles(seed):
    random = Random(seed)
    curve = closed_cubics(random, random.randint(1, 3))
    for _ in range(6):
        point = mpq(random.randint(-60, 60), 7), mpq(random.randint(-60, 60), 11)
        assert winding_number(curve, point) == sum_of_angles(curve, point, 1500)
        assert winding_number(curve.reverse(), point) == -winding_number(curve, point)


@pytest.mark.parametrize(
    ("point", "expected"),
    [((1, 1), 1), ((-1, 0), 0), ((-1, 2), 0), ((-1, 1), 0), ((3, 2), 0), ((3, 0), 0), ((1, "1/9"), 1)],
)
def test_rays_through_vertices_and_along_edges(point, expected):
    assert winding_number(SQUARE, point) == expected
    assert winding_number(SQUARE.reverse(), point) == -expected


def test_a_star_is_twice_around_its_middle():
    assert abs(winding_number(STAR, (0, 0))) == 2
    assert [str(contains(STAR, (0, 0), rule)) for rule in ("nonzero", "even-odd")] == ["inside", "outside"]


@pytest.mark.parametrize("point", [(0, 0), (2, 2), (1, 0), (0, 1), (2, "1/3")])
def test_points_on_a_curve_are_named(point):
    assert contains(SQUARE, point) == "on a curve"
    with pytest.raises(DomainError, match="on the curve at the parameter"):
        winding_number(SQUARE, point)


def test_the_parameter_of_a_point_on_a_circle_is_exact():
    with pytest.raises(DomainError, match="at the parameter 1/2"):
        winding_number(example("circle"), example("circle")("1/2"))


def test_a_ray_that_touches_from_below_and_above_counts_nothing():
    bump = Nurbs(2, [0, 0, 0, 1, 2, 3, 3, 3], [(0, 0), (2, 2), (4, 0), (2, -4), (0, 0)])
    top = max(range(1, 64), key=lambda k: bump(mpq(k, 64))[1])
    height = bump(mpq(top, 64))[1]
    for point in ((-5, height), (-5, 0)):
        assert winding_number(bump, point) == 0


def test_curves_without_an_inside_are_refused():
    with pytest.raises(ShapeError, match="not closed"):
        winding_number(SQUARE.restrict(0, 3), (1, 1))
    with pytest.raises(ShapeError, match="R3"):
        winding_number(example("twisted_cubic"), (1, 1, 1))
    jumping = Nurbs(1, [0, 0, 1, 1, 2, 2], [(0, 0), (1, 0), (1, 1), (0, 0)])
    with pytest.raises(ShapeError, match="jumps"):
        winding_number(jumping, (2, 2))
