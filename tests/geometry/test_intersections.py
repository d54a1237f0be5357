"""Intersections of curves: a sample of the campaign, cases of public issues, knots and ends, arcs in common, space, and
curves of many segments.
"""

from contextlib import suppress
from fractions import Fraction
from random import Random

import pytest
from gmpy2 import mpq

from exactspline import Nurbs, example, intersections, rational, self_intersections
from exactspline.errors import ShapeError
from exactspline.geometry.pairs.intersections import CollectedPoints
from exactspline.geometry.pairs.lazy_intersections import PairForm
from tests.campaigns.intersections import FAMILIES, above_ceiling, bezier_rows, campaign, curve, multiplied
from tests.support.bisector_oracle import bezier
from tests.support.dials import factors, over_dials


def kinds(found):
    return [str(p.kind) for p in found]


def pairs(found):
    return [(round(float(p.first), 9), round(float(p.second), 9)) for p in found]


@pytest.mark.parametrize("family", FAMILIES)
def test_a_sample_of_the_campaign(family):
    found = campaign(60, 31, family)
    assert found["differences"] == []
    assert found["families"] == {family: 60}
    assert above_ceiling(found) == []


def test_what_is_left_out_is_counted_by_family():
    """Passed before: a family of which every tenth pair is left out; the counts were of all families together."""
    counted = {"families": {"a": 1000, "b": 9}, "left_out": {"a": 1, "b": 1}}
    assert above_ceiling(counted) == ["b"]


@pytest.mark.parametrize("k", range(1, 7))
def test_orders_of_contact(k):
    """y = (t − 1/2)ᵏ⁺¹ and the axis touch to order k at one half."""
    power = [Fraction(1)]
    for _ in range(k + 1):
        power = multiplied(power, [Fraction(-1, 2), Fraction(1)])
    (found,) = intersections(curve(bezier_rows([[0, 1], power, [1]])), bezier((0, 0), (1, 0)))
    assert (found.contact, found.multiplicity, str(found.kind)) == (k, k + 1, "crossing" if k % 2 == 0 else "touching")
    assert found.first == found.second == mpq(1, 2)
    assert found.point == (mpq(1, 2), mpq(0))


def test_answers_are_exact_numbers():
    parabola, line = bezier((0, 0), ("1/2", 0), (1, 1)), bezier((0, "1/2"), (1, "1/2"))
    (found,) = intersections(parabola, line)
    assert found.first.minimal_polynomial() == found.second.minimal_polynomial() == [-1, 0, 2]
    assert found.first == found.second
    x, y = found.point
    assert (x * x, y) == (mpq(1, 2), mpq(1, 2))


def test_through_knots_ends_and_the_seam():
    circle = example("circle")
    assert kinds(intersections(circle, bezier((-2, 0), (2, 0)))) == ["crossing", "crossing"]
    assert kinds(intersections(circle, bezier((0, 0), (2, 0)))) == ["crossing"]
    assert kinds(intersections(circle, bezier((1, 0), (2, 0)))) == ["end"]
    assert kinds(intersections(circle, bezier((-2, 1), (2, 1)))) == ["touching"]
    (at_seam,) = intersections(circle, bezier((1, -1), (1, 1)))
    assert (at_seam.first, at_seam.at_knot, str(at_seam.kind)) == (0, (True, False), "touching")


def test_at_two_knots_the_tangents_decide():
    roof = Nurbs(1, [0, 0, 1, 2, 2], [(-1, -1), (0, 0), (1, -1)])
    valley = Nurbs(1, [0, 0, 1, 2, 2], [(-1, 1), (0, 0), (1, 1)])
    zigzag = Nurbs(1, [0, 0, 1, 2, 2], [(0, -1), (0, 0), (0, 1)])
    assert kinds(intersections(roof, valley)) == ["touching"]
    assert kinds(intersections(roof, zigzag)) == ["crossing"]
    along = Nurbs(1, [0, 0, 1, 2, 2], [(-1, -1), (0, 0), (0, 1)])
    assert not intersections(roof, along).points
    assert len(intersections(roof, along).everywhere) == 1


def test_a_knot_against_an_inner_point():
    roof = Nurbs(1, [0, 0, 1, 2, 2], [(-1, -1), (0, 0), (1, -1)])
    assert kinds(intersections(roof, bezier((-1, 0), (1, 0)))) == ["touching"]
    assert kinds(intersections(bezier((0, -2), (0, 3)), roof)) == ["crossing"]


# ---- arcs in common


def test_a_part_of_a_curve_backwards_and_by_another_speed():
    cubic = bezier((0, 0), (3, 3), (-2, 3), (1, 0))
    part = cubic.restrict("1/4", "1/2").reverse()
    (arc,) = intersections(cubic, part).everywhere
    assert [float(x) for x in (*arc.first, *arc.second)] == [0.5, 0.25, 0.25, 0.5]
    assert arc.reversed
    n, d = ([rational(c) for c in each] for each in (arc.numerator, arc.denominator))
    t = mpq(1, 3)
    s = sum(c * t**k for k, c in enumerate(n)) / sum(c * t**k for k, c in enumerate(d))
    assert cubic(s) == part(t)


def test_a_circle_by_two_parametrizations():
    """The arcs of one circle that begin at other points: every pair of arcs that overlap, with its Möbius map."""
    circle = example("circle")
    turned = circle.transform([["3/5", "-4/5"], ["4/5", "3/5"]])
    found = intersections(circle, turned)
    assert not found.points
    assert len(found.everywhere) == 8
    for arc in found.everywhere:
        n, d = arc.numerator, arc.denominator
        t = (arc.second[0] + arc.second[1]) / 2
        assert t.exact is None or circle(_at(n, t.exact) / _at(d, t.exact)) == turned(t.exact)
    total = sum(float(arc.second[1] - arc.second[0]) for arc in found.everywhere)
    assert total == pytest.approx(4)


def _at(coefficients, t):
    return sum(mpq(c) * t**k for k, c in enumerate(coefficients))


def test_a_loop_and_its_part_cross_beside_their_arc():
    loop = bezier((0, 0), (3, 3), (-2, 3), (1, 0))
    found = intersections(loop, loop)
    assert len(found.everywhere) == 1
    assert [(float(p.first), p.multiplicity) for p in found] == [
        (pytest.approx(0.0669873), 1),
        (pytest.approx(0.9330127), 1),
    ]


def test_collinear_segments():
    one, other = bezier((0, 0), (2, 2)), bezier((3, 3), (1, 1))
    (arc,) = intersections(one, other).everywhere
    assert [str(x) for x in (*arc.first, *arc.second)] == ["1", "1/2", "1/2", "1"]
    assert intersections(one, bezier((2, 2), (3, 3))).points[0].multiplicity is None
    assert not intersections(one, bezier((3, 3), (4, 4)))
    there_and_back = bezier((0, 0), (4, 4), (0, 0))
    assert len(intersections(there_and_back, one).everywhere) == 2


def test_a_curve_that_stands_still():
    still, line = bezier((1, 1), (1, 1)), bezier((0, 0), (2, 2))
    (rest,) = intersections(still, line).everywhere
    assert [str(x) for x in (*rest.first, *rest.second)] == ["0", "1", "1/2", "1/2"]
    assert not intersections(still, bezier((0, 0), (2, 1)))


def polyline(points):
    n = len(points) - 1
    return Nurbs(1, [0, *range(n + 1), n], points)


@pytest.mark.parametrize(
    ("points", "meetings"),
    [
        ([(0, 0), (1, 0), (1, 1)], 0),
        ([(0, 0), (2, 0), (1, 1), (3, 3), (0, 4)], 0),
        ([(0, 0), (1, 0), (1, 1), (0, 0)], 0),  # closed
        ([(0, 0), (2, 0), (2, 1), (1, 1), (1, -1)], 1),
        ([(0, 0), (2, 0), (2, 2), (1, 2), (1, -1), (0, -1), (0, 0)], 1),
    ],
)
def test_a_doubled_control_point_is_met_by_nothing_that_was_not_met_before(points, meetings):
    """A simple polyline with a doubled control point met itself there; a curve that is one point did not."""
    for k in range(len(points)):
        for times in (2, 3):
            found = self_intersections(polyline([*points[:k], *[points[k]] * times, *points[k + 1 :]]))
            assert (len(found), found.everywhere, found.undecided) == (meetings, (), ())


def test_a_curve_meets_itself_where_it_passes_a_point_at_which_it_stood():
    assert not self_intersections(polyline([(0, 0)] * 2))
    assert not self_intersections(polyline([(0, 0)] * 4))
    (rest,) = self_intersections(polyline([(0, 0), (1, 0), (1, 0), (2, 1), (1, 1), (1, -1)])).everywhere
    assert [str(x) for x in (*rest.first, *rest.second)] == ["1", "2", "9/2", "9/2"]
    # away and back: what is between both ends stands still elsewhere
    knots = [0, 0, 1, 1, 2, 2, 3, 3]
    assert len(self_intersections(Nurbs(1, knots, [(0, 0), (1, 0), (5, 5), (5, 5), (1, 0), (1, 1)]))) == 1
    assert not self_intersections(Nurbs(1, knots, [(0, 0), (1, 0), (5, 5), (5, 5), (5, 5), (8, 1)]))


def test_what_is_out_of_reach_is_named():
    there_and_back = bezier((0, 0), (1, 0), (1, 2), (1, 0), (0, 0))
    found = intersections(there_and_back, there_and_back)
    assert found
    assert not found.points
    assert "run over one arc several times" in found.undecided[0]


# ---- a curve and itself


def test_nodes_cusps_and_corners():
    assert len(self_intersections(bezier((0, 0), (3, 3), (-2, 3), (1, 0)))) == 1
    assert not self_intersections(bezier((0, 0), (1, 1), (0, 1), (1, 0)))  # a cusp
    assert not self_intersections(example("circle"))
    eight = Nurbs(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (2, 2), (2, 0), (0, 2), (0, 0)])
    (node,) = self_intersections(eight)
    assert (node.first, node.second) == (mpq(1, 2), mpq(5, 2))


def test_a_curve_through_its_own_knot():
    bow = Nurbs(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (2, 0), (2, 2), (1, 0), (1, -1)])
    (found,) = self_intersections(bow)
    assert (found.first, found.second, str(found.kind)) == (mpq(1, 2), 3, "crossing")


def test_an_arc_that_a_closed_curve_runs_over_again_and_that_ends_at_its_seam():
    """Passed before: the end of the arc as a point, too, with the seam as 0 (seed 401962 of the campaign)."""
    corners = [(0, -2), (-1, 3), (0, -3), (0, 0), (0, -2)]
    found = self_intersections(Nurbs(1, [0, 0, 1, 2, 3, 4, 4], corners))
    assert not found.points
    (arc,) = found.everywhere
    assert [str(x) for x in (*arc.first, *arc.second)] == ["3", "7/3", "3", "4"]


# ---- space


def test_curves_in_space_meet_where_all_coordinates_agree():
    twisted = bezier((0, 0, 0), ("1/3", 0, 0), ("2/3", "1/3", 0), (1, 1, 1))
    through = bezier((0, 0, 0), (1, "1/2", "1/4"))  # meets at t = 1/2 as (1/2, 1/4, 1/8)
    found = intersections(twisted, through)
    assert [(p.first, p.second) for p in found] == [(0, 0), (mpq(1, 2), mpq(1, 2))]
    assert not intersections(twisted, bezier((0, 0, 1), (1, "1/2", "5/4")))


def test_crossing_shadows_are_not_points():
    above, below = bezier((0, 0, 1), (1, 1, 1)), bezier((0, 1, 0), (1, 0, 0))
    assert not intersections(above, below)
    assert len(intersections(above, bezier((0, 1, 1), (1, 0, 1)))) == 1


def test_arcs_in_space():
    helix = bezier((0, 0, 0), ("1/3", 0, 0), ("2/3", "1/3", 0), (1, 1, 1))
    (arc,) = intersections(helix, helix.restrict("1/4", "3/4")).everywhere
    assert [str(x) for x in arc.first] == ["1/4", "3/4"]


def test_lines_in_space_with_one_shadow():
    one, other = bezier((0, 0, 0), (2, 0, 2)), bezier((0, 0, 2), (2, 0, 0))
    (found,) = intersections(one, other)
    assert (found.first, found.second) == (mpq(1, 2), mpq(1, 2))


def test_irrational_points_in_space_are_compared_exactly():
    """A plane curve lifted to two graphs that agree at an irrational crossing."""
    parabola = bezier((0, 0, 0), ("1/2", 0, 0), (1, 1, 1))  # (t, t², t²)
    level = bezier((0, "1/2", "1/2"), (1, "1/2", "1/2"))
    (found,) = intersections(parabola, level)
    assert found.first.minimal_polynomial() == [-1, 0, 2]
    near = mpq(1, 2) + mpq(1, 1 << 200)
    assert not intersections(parabola, bezier((0, "1/2", near), (1, "1/2", near)))


TURNING = bezier((0, 0), (3, 3), (0, 0))
POINT = bezier(("3/4", "3/4"), ("3/4", "3/4"), weights=[1, 3])


@pytest.mark.parametrize(("first", "second"), [
    (TURNING, POINT), (POINT, POINT), (bezier((1, 2), (1, 2)), POINT), (TURNING, bezier((0, 0), (1, 1))),
    (TURNING, bezier((1, 1), (-1, -1), (2, 2))), (TURNING, bezier((0, 2), (2, 0))),
    (bezier((0, 0), (1, 2), (2, 0)), bezier((1, 1), (1, 1))),
    (bezier((0, 0), (1, 2), (2, 0)), bezier((0, 0), (1, 2), (2, 0)).restrict("1/3", 1).reverse()),
    (Nurbs(1, [0, 0, 1, 2, 3, 3], [(0, 0), (1, 0), (1, 0), (2, 1)]), bezier((1, -1), (1, 1))),
])  # fmt: skip
@over_dials
def test_curves_in_a_plane_of_space_meet_as_in_the_plane(first, second, number):
    """Undecided before: a point, or a piece that stands still, on a curve in space; segments that turn back."""
    random = Random(5)
    a, b, c, d, e, f = (x + random.randint(7, 9) * mpq(10) ** k for k, x in enumerate(factors(number, random, 6)))

    def placed(curve):
        points = [(a * x + b * y, c * x - d * y, e * x + f * y + 1) for x, y in curve.control_points]
        return Nurbs(curve.degree, curve.knots, points, curve.weights)

    for one, other in ((first, second), (second, first)):
        flat, found = intersections(one, other), intersections(placed(one), placed(other))
        assert [(p.first, p.second) for p in found] == [(p.first, p.second) for p in flat]
        assert [(arc.first, arc.second) for arc in found.everywhere] == [
            (arc.first, arc.second) for arc in flat.everywhere
        ]
        assert found.undecided == flat.undecided == ()


@pytest.mark.parametrize("along", [(-7, 4, 1), (0, 0, 1), (3, -5, 1)])
def test_segments_that_turn_back_in_a_plane_along_a_projection(along):
    """A plane that holds one of the directions of projection: the others decide."""

    def placed(curve):
        points = [tuple(x * a + y * b for a, b in zip(along, (1, 1, 0), strict=True)) for x, y in curve.control_points]
        return Nurbs(curve.degree, curve.knots, points)

    for other in (bezier((0, 0), (1, 1)), bezier((0, 2), (2, 0)), bezier((1, 1), (-1, -1), (2, 2))):
        flat, found = intersections(TURNING, other), intersections(placed(TURNING), placed(other))
        assert repr(found.everywhere) == repr(flat.everywhere)
        assert pairs(found) == pairs(flat)
        assert found.undecided == flat.undecided == ()


def test_a_point_on_a_curve_in_space():
    """Undecided before, with a remark that a curve stands still or turns back."""
    twisted = bezier((0, 0, 0), ("1/3", 0, 0), ("2/3", "1/3", 0), (1, 1, 1))
    for t in (0, mpq(1, 3), 1):
        (found,) = intersections(bezier(*[twisted(t)] * 3, weights=[1, 2, 5]), twisted).everywhere
        assert (found.first, found.second) == ((0, 1), (t, t))
    (found,) = intersections(bezier((2, 0, 0), (3, 1, 1)), bezier((2, 0, 0), (2, 0, 0))).everywhere
    assert (found.first, found.second) == ((0, 0), (0, 1))
    assert not intersections(twisted, bezier((1, 1, 0), (1, 1, 0)))


# ---- many segments


def wave(count, phase, degree=1):
    points = [(k, (k * (k + phase)) % 7) for k in range(count + 1)]
    return Nurbs(degree, [0, *range(count + 1), count], points)


def test_many_segments_meet_in_linear_time():
    """Only pairs whose boxes meet are decided: as many as there are segments, not their square."""
    from exactspline.geometry.pairs.box_tree import pairs_that_may_meet, segments_of

    first, second = wave(2000, 1), wave(2000, 3)
    trees = [segments_of(c).boxes(4) for c in (first, second)]
    assert len(list(pairs_that_may_meet(*trees))) < 3 * 2000


def test_polygons_against_all_pairs_of_edges():
    first, second = wave(30, 1), wave(30, 3)
    found = {(p.first, p.second) for p in intersections(first, second)}
    expected = set()
    for i in range(30):
        for j in range(max(0, i - 1), min(30, i + 2)):
            (a, b), (c, d) = (
                [[mpq(x) for x in p] for p in curve.control_points[k : k + 2]] for curve, k in ((first, i), (second, j))
            )
            turn = (b[0] - a[0]) * (d[1] - c[1]) - (b[1] - a[1]) * (d[0] - c[0])
            if turn:
                s = ((c[0] - a[0]) * (d[1] - c[1]) - (c[1] - a[1]) * (d[0] - c[0])) / turn
                t = ((c[0] - a[0]) * (b[1] - a[1]) - (c[1] - a[1]) * (b[0] - a[0])) / turn
                if 0 <= s <= 1 and 0 <= t <= 1:
                    expected.add((i + s, j + t))
    ends = {
        (x, y) for arc in intersections(first, second).everywhere for x, y in zip(arc.first, arc.second, strict=True)
    }
    assert found == expected - ends


# ---- the rest


def test_dimensions_must_agree():
    with pytest.raises(ShapeError, match="R3"):
        intersections(example("circle"), example("twisted_cubic"))
    with pytest.raises(ShapeError, match="R3"):
        self_intersections(example("twisted_cubic"))


def test_an_answer_without_points_says_so():
    assert not intersections(bezier((0, 0), (1, 0)), bezier((0, 1), (1, 1)))
    assert repr(intersections(bezier((0, 0), (1, 0)), bezier((0, 1), (1, 1)))) == "nowhere"


def test_at_two_knots_with_one_tangent_the_curvatures_decide():
    """Both have a knot at the origin and the tangent of x; each side is compared by its power series."""

    def bent(left, right):
        """y = left x² before the origin, right x² behind it."""
        return Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 2], [(-1, left), ("-1/2", 0), (0, 0), ("1/2", 0), (1, right)])

    for (a, b), (c, d), expected in (
        ((1, 1), (2, 2), "touching"),
        ((1, 1), (2, "1/2"), "crossing"),
        ((-1, 1), (1, 2), "touching"),
        ((1, 1), (-1, 3), "crossing"),
    ):
        (found,) = intersections(bent(a, b), bent(c, d))
        assert (str(found.kind), found.multiplicity, found.at_knot) == (expected, 2, (True, True))


def test_a_segment_that_turns_back_meets_a_loop_twice_in_a_point():
    """Passed before: a division by zero, where two parameters were compared whose polynomial has multiple factors."""
    loop = bezier(("67/4", "-3/8"), ("-53/4", "15/8"), ("55/4", "69/8"), ("-41/4", "-57/8"))
    found = intersections(loop, bezier(("5/2", "7/4"), ("-1/2", "17/4"), ("5/2", "7/4")))
    once, again, turn = found
    assert once.first == again.first
    assert once.second + again.second == 1
    assert (turn.first, turn.second, turn.multiplicity) == (mpq(1, 2), mpq(1, 2), 4)


def test_straight_curves_that_turn_back_at_irrational_parameters():
    """Each arc has one point at both of its ends, and the two parameters are told apart from all others exactly."""
    zigzag = bezier((0, 0), (5, 5), (-3, -3), (1, 1))
    arcs = self_intersections(zigzag).everywhere
    assert len(arcs) == 3
    for arc in arcs:
        for s, t in zip(arc.first, arc.second, strict=True):
            low, high = (zigzag.p[0](x.enclosure(30).middle) for x in (s, t))
            assert abs(low - high) < mpq(1, 10**25)
    turn = arcs[0].second[0]
    assert turn == arcs[0].first[0]
    assert turn.minimal_polynomial() == [5, -26, 25]
    other = zigzag.restrict("1/4", 1).reverse()
    assert len(intersections(zigzag, other).everywhere) == 8


@pytest.mark.parametrize("place", [mpq(1, 4), mpq(1, 3), mpq(1, 2), mpq(3, 4)])
@pytest.mark.parametrize("sign", [1, -1])
def test_straight_curves_that_slow_down_without_turning_back(place, sign):
    """Passed before: curves that overlap "meet nowhere"; whether x grows was read off its slope at a sample, 0 there.

    One is ``x = ± (t − r)³``, the other ``x = 2t²/3 − 1/4``, all on the line y = 0.
    """
    cubic = [sign * x for x in (-(place**3), place * place * (1 - place), -place * (1 - place) ** 2, (1 - place) ** 3)]
    one, other = bezier(*[(x, 0) for x in cubic]), bezier((mpq(-1, 4), 0), (mpq(-1, 4), 0), (mpq(5, 12), 0))
    low, high = max(min(cubic[0], cubic[3]), mpq(-1, 4)), min(max(cubic[0], cubic[3]), mpq(5, 12))
    for found, k in ((intersections(one, other), 0), (intersections(other, one), 1)):
        (arc,) = found.everywhere
        ends = sorted((arc.first, arc.second)[k], key=lambda t: t * sign)
        assert [sign * (t - place) * (t - place) * (t - place) for t in ends] == [low, high]
    assert not self_intersections(one).everywhere


def test_a_curve_that_runs_on_is_not_searched(monkeypatch):
    """Closed, broken and doubled chains of integers up to doubles: the answers are those of the search of all pairs. A
    search that took a gap for a joint, or a half turn for a cone, would have left out crossings.
    """
    chance, curves = Random(5), []
    for k in range(60):
        size, degree = chance.choice([2, 9, 10**17]), chance.randint(1, 3)
        points = [(chance.randint(-size, size), chance.randint(-size, size)) for _ in range(degree + 3)]
        if k % 3 == 0:
            points.sort()
        if k % 4 == 0:
            points[-1] = points[0]
        inner = [1] * chance.choice([1, degree + 1 if degree < 3 else 1]) + [2]
        inner = [*inner, 2][: len(points) - degree - 1] if k % 2 else inner
        inner += [3] * (len(points) - degree - 1 - len(inner))
        weights = [chance.choice([1, 2, "1/7"]) for _ in points] if k % 5 == 0 else None
        curves.append(
            Nurbs(degree, [0] * (degree + 1) + inner[: len(points) - degree - 1] + [4] * (degree + 1), points, weights)
        )
    found = [repr(self_intersections(c)) for c in curves]
    monkeypatch.setattr(CollectedPoints, "runs_on", lambda *_: False)
    assert found == [repr(self_intersections(c)) for c in curves]
    assert len(set(found)) > 20


def test_an_interrupt_while_points_are_listed_repeats_none(monkeypatch):
    """Before: asked again, six points were listed as eight."""
    drawn, knots = Random(1), [0] * 4 + [1] * 3 + [2] * 3 + [3] * 4
    points = [[(drawn.randint(-99, 99), drawn.randint(-99, 99)) for _ in range(10)] for _ in "ab"]
    found = intersections(*(Nurbs(3, knots, each) for each in points))
    made, calls = PairForm.parameters, []

    def interrupted(*given, **more):
        calls.append(given)
        if len(calls) == 3:
            raise KeyboardInterrupt
        return made(*given, **more)

    monkeypatch.setattr(PairForm, "parameters", interrupted)
    with suppress(KeyboardInterrupt):
        list(found)
    assert len(list(found)) == len(found) == len({pair.first for pair in found})


@pytest.mark.parametrize(
    ("heights", "count"), [((0, 0, mpq(2, 3), 2), 1), ((3, 3, 3, 3), 0)], ids=["meets", "passes above"]
)
def test_a_rational_parameter_of_one_curve_and_an_irrational_one_of_the_other_in_space(heights, count):
    """The projections of a line and of (2t² + (2t² − 1)t, 2 − 2t²) meet at 1 and at √2/2."""
    line = Nurbs(1, [0, 0, 1, 1], [(0, 0, 0), (1, 1, 1)])
    points = zip((0, mpq(-1, 3), 0, 3), (2, 2, mpq(4, 3), 0), heights, strict=True)
    bent = Nurbs(3, [0] * 4 + [1] * 4, [*points])
    for pair in ((line, bent), (bent, line)):
        found = intersections(*pair)
        assert (len(found), found.undecided) == (count, ())
