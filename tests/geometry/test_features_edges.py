"""Features where it is easy to be wrong: negative weight functions, seams, ends, corners, curves that stand still,
squaring.
"""

import pytest
from gmpy2 import mpq

from exactspline import Nurbs
from exactspline.geometry.analysis import analyse
from exactspline.geometry.inspection import Approach, inspect_curve
from exactspline.geometry.joints import geometric_order
from exactspline.interchange.examples import example
from exactspline.verification.claims import select
from exactspline.verification.ledger import audit


def bezier(points, weights=None):
    n = len(points)
    return Nurbs(n - 1, [0] * n + [1] * n, points, weights)


def test_a_negative_weight_function_changes_no_maximum_into_a_minimum():
    points, weights = [(0, 0), (1, 3), (3, -2), (4, 1)], [1, 2, 3, 1]
    plus, minus = bezier(points, weights), bezier(points, [-w for w in weights])
    for approach in Approach:
        found = [
            [(f.kind, f.of_absolute, f.root) for f in inspect_curve(c, approach).critical_points] for c in (plus, minus)
        ]
        assert found[0] == found[1]
        assert found[0]


def test_a_singular_seam_is_counted_once():
    curve = bezier([(0, 0), (0, 0), (3, 0), (1, 4), (0, 0), (0, 0)])
    assert [(f.kind, f.root.exact) for f in analyse(curve).singular_points] == [("corner", 0)]


def test_a_curve_that_starts_from_rest_is_singular_there():
    curve = bezier([(0, 0), (0, 0), (1, 1), (2, 0)])
    assert [(f.kind, f.root.exact) for f in analyse(curve).singular_points] == [("singular end", 0)]
    assert not [f for f in analyse(curve).inflections if f.root == 0]
    assert not [f for f in analyse(curve).critical_points if f.root == 0]


def test_squaring_keeps_an_extremum_where_the_curvature_vanishes():
    """y = x⁴: κ = κ′ = 0 at 0, a minimum; y = x³: κ = 0 there but κ′ is not."""
    quartic = bezier([(-1, 1), ("-1/2", -1), (0, 1), ("1/2", -1), (1, 1)])
    cubic = bezier([(-1, -1), ("-1/3", 1), ("1/3", -1), (1, 1)])
    for approach in Approach:
        assert ("minimum", mpq(1, 2)) in [
            (f.kind, f.root.exact) for f in inspect_curve(quartic, approach).critical_points
        ]
        assert not [f for f in inspect_curve(cubic, approach).critical_points if f.root == mpq(1, 2)]


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


@pytest.mark.parametrize(
    ("knots", "points"),
    [
        ([0] * 4 + [1] * 4 + [2] * 4, [(0, 0), (0, 1), (1, 1), (2, 1), (12, 0), (13, 0), (14, 0), (14, 5)]),
        ([0] * 4 + [1] * 3 + [2] * 4, [(0, 0), (0, 1), (1, 1), (2, 1), (2, 0), (2, -1), (3, -1)]),
    ],
    ids=["gap", "corner"],
)
def test_a_gap_or_a_corner_is_no_inflection(knots, points):
    assert not [f for f in analyse(Nurbs(3, knots, points)).inflections if f.root == 1]


def test_a_rest_is_no_cusp():
    curve = Nurbs(1, [0, 0, 1, 2, 3, 3], [(0, 0), (1, 0), (1, 0), (2, 0)])
    assert [(f.kind, f.root.exact) for f in analyse(curve).singular_points] == [("rest", 1), ("rest", 2)]


def test_pieces_end_at_corners_and_where_the_curvature_jumps():
    bent = Nurbs(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), (1, 1)])
    assert [p.parts for p in analyse(bent).straight_pieces] == [((0, 1),), ((1, 2),)]
    arcs = Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 2], [(1, 0), (1, 1), (0, 1), (-2, 1), (-2, -1)], weights=[1, 1, 2, 2, 4])
    assert [p.parts for p in analyse(arcs).constant_pieces] == [((0, 1),), ((1, 2),)]
    assert not analyse(arcs).curvature_extrema.points


#: Of what these claims speak exists on straight and planar curves, too: nothing is divided by κ or τ.
EXIST_ALL_THE_SAME = {"C43a-velocity_turned-velocity_turned_by_D1", "C54a-darboux_development", "E19-radius_vector"}


@pytest.mark.parametrize(
    ("name", "ids"),
    [
        ("straight_line", ["C4.3a", "E7", "E12"]),
        ("planar_in_space", ["E19", "C5.5b"]),
        ("space_line", ["C5.5c", "C5.4a"]),
    ],
)
def test_what_does_not_exist_is_not_verified(name, ids):
    """x/0 = y/0 is not a success, however true after multiplication."""
    rows = [
        row for row in audit(select(ids), [example(name)]) if row.status != "ours" and row.key not in EXIST_ALL_THE_SAME
    ]
    assert rows
    assert {row.verdict for row in rows if row.claim.kind != "degree"} <= {"VACUOUS", "INAPPLICABLE"}
    assert all(row.as_recorded for row in rows)


def test_unnamed_curves_are_judged_like_named_ones():
    rows = list(audit(select(["C4.1"]), [bezier([(0, 0), (1, 2), (3, 1)], [1, 2, 1])]))
    assert all(row.as_recorded for row in rows)
    line = list(audit(select(["C3b"]), [bezier([(0, 0), (1, 2)], [1, 2])]))
    assert all(row.as_recorded for row in line)
