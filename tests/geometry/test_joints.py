"""Joints where mutants passed: stops at knots, and gaps."""

import pytest
from gmpy2 import mpq

from exactspline import Nurbs, analyse
from exactspline.geometry.curves.joints import geometric_order


@pytest.mark.parametrize(("ahead", "degrees"), [((1, 0), None), ((0, 1), 90), ((-1, 0), 180)])
def test_a_stop_at_a_knot_has_a_direction_from_both_sides(ahead, degrees):
    """γ = (t³, 0) comes to rest in the direction of x. Passed by mutants: in the opposite one, or in none."""
    x, y = ahead
    curve = Nurbs(3, [0] * 4 + [1] * 3 + [2] * 4, [(-1, 0), (0, 0), (0, 0), (0, 0), (x, y), (2 * x, 2 * y), (5, 5)])
    joint = analyse(curve).joint(mpq(1))
    assert joint.kind == "singular"
    assert joint.order == (None if degrees is None else 0)
    assert (joint.angle and joint.angle.degrees(9)) == degrees


def test_a_gap_is_as_wide_as_it_is():
    """Passed by mutants: the distance of the left side from the origin; a TypeError for curves of degree 0."""
    joint = analyse(Nurbs(1, [0, 0, 1, 1, 2, 2], [(0, 0), (1, 2), (4, 6), (5, 5)])).joint(mpq(1))
    assert (joint.kind, joint.order, joint.gap) == ("gap", -1, 5)
    points = Nurbs(0, [0, 1, 2], [(0, 0), (3, 4)])
    assert (analyse(points).joint(mpq(1)).kind, analyse(points).joint(mpq(1)).gap) == ("gap", 5)
    assert analyse(Nurbs(0, [0, 1, 2], [(3, 4), (3, 4)])).joint(mpq(0)).kind == "standing still"
    here, there = (((x, 0), (1, 0), (0, 0), (0, 0)) for x in (0, 1))
    assert geometric_order(here, there) == -1
