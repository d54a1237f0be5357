"""Curves in another plane of space than z = 0: what needs no lengths is asked of them as of plane curves."""

import pytest
from gmpy2 import mpq

import exactspline as xs
from exactspline.errors import ShapeError
from exactspline.geometry.curves.planarity import in_common_plane

THIRD = mpq(1, 3)


def tilted(point):
    """A motion of the plane into the plane 2x + y + 2z = 12, left as seen from the tip of (2, 1, 2)."""
    x, y = map(mpq, point)
    return (x - 2 * y) * THIRD + 1, (2 * x + 2 * y) * THIRD, (-2 * x + y) * THIRD + 5


def polygon(*points):
    """A closed polygon in that plane."""
    n = len(points)
    return xs.Nurbs(1, [0, *range(n + 1), n], [tilted(p) for p in (*points, points[0])])


SQUARE = polygon((0, 0), (2, 0), (2, 2), (0, 2))
LINE = xs.Nurbs(1, [0, 0, 1, 1], [tilted((-1, 1)), tilted((3, 1))])


def test_the_winding_number_has_its_sign_by_the_normal():
    """It was refused."""
    middle = ",".join(map(str, tilted((1, 1))))
    assert xs.ask(SQUARE, f"winding_number:{middle}") == 1
    assert xs.ask(SQUARE.reverse(), f"winding_number:{middle}") == -1
    assert str(xs.analyse(SQUARE).plane) == "2x + y + 2z = 12"
    mirrored = xs.Nurbs(1, SQUARE.knots, [(-x, y, z) for x, y, z in SQUARE.control_points])
    x, y, z = tilted((1, 1))
    # the normal is now (2, −1, −2), and the motion turned left to right
    assert xs.winding_number(mirrored, (-x, y, z)) == 1


def test_a_point_outside_of_the_plane_is_refused():
    with pytest.raises(ShapeError, match="in one plane"):
        xs.winding_number(SQUARE, (0, 0, 0))


def test_of_a_straight_curve_the_plane_is_that_of_the_point():
    there_and_back = polygon((0, 0), (2, 0))
    assert xs.winding_number(there_and_back, (7, 8, 9)) == 0


def test_curves_in_one_plane_cross_and_touch_there():
    """They had common points of no kind and without multiplicity."""
    found = xs.ask((SQUARE, LINE), "intersections")
    assert [(str(x.kind), x.multiplicity) for x in found] == [("crossing", 1), ("crossing", 1)]
    assert [x.point for x in found] == [tilted((2, 1)), tilted((0, 1))]
    parabola = xs.Nurbs(2, [0, 0, 0, 1, 1, 1], [tilted(p) for p in ((0, 3), (1, -1), (2, 3))])
    (touching,) = xs.intersections(LINE, parabola)
    assert (str(touching.kind), touching.multiplicity) == ("touching", 2)
    elsewhere = xs.Nurbs(1, [0, 0, 1, 1], [tilted((1, 1)), (0, 0, 0)])
    twisted = xs.intersections(xs.example("twisted_cubic"), xs.Nurbs(1, [0, 0, 1, 1], [(0, 0, 0), (1, 2, 4)]))
    assert in_common_plane(SQUARE, elsewhere) is None
    assert [str(x.kind) for x in twisted] == ["end"]
    assert [(str(x.kind), x.multiplicity) for x in xs.intersections(polygon((0, 0), (2, 0), (2, 2)), elsewhere)] == [
        ("end", None)
    ]


@pytest.mark.parametrize("name", ["area", "evolute", "offset_cusps:1"])
def test_what_needs_lengths_is_refused_there(name):
    with pytest.raises(xs.ExactSplineError, match="in another plane than z = 0; it is asked of a plane curve"):
        xs.ask(SQUARE, name)
