"""Largest speed, curvature, its derivative and torsion, where the curvature is above a number, and how ends meet."""

import pytest

from exactspline import Nurbs, analyse, ask, example
from exactspline.errors import DomainError, ShapeError
from exactspline.geometry.analysis.pairs import CurvePair
from tests.campaigns import bounds as campaign
from tests.support.dials import ALWAYS

LINE = Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 0)])
FOUR = Nurbs(1, [0, 0, 1, 1], [(0, 0, 0, 0), (1, 2, 3, 4)])


def listed(answer):
    """What is said, with the numbers as text."""
    return [(x.what, {name: str(value) for name, value in x.values.items()}, dict(x.facts)) for x in answer]


@pytest.mark.parametrize("dial", ALWAYS)
@pytest.mark.parametrize("family", campaign.FAMILIES)
def test_against_sixty_digits(family, dial):
    assert [campaign.differs(family, dial, seed) for seed in range(2)] == ["", ""]


def test_a_largest_value_that_is_too_small_is_found(monkeypatch):
    """The oracle sees it: that of a part alone."""
    curve = example("cubic_s")
    part = ask(curve.split("1/10")[0], "largest_curvature")
    monkeypatch.setattr(campaign, "ask", lambda curve, name: part)
    assert "above" in campaign.differs_largest(curve, "largest_curvature")


def test_limits_at_a_knot_count_from_each_side():
    """Arcs of parabolas before and behind a line."""
    found = listed(analyse(example("straight_between_arcs")).largest_curvature)
    assert found == [
        ("largest curvature", {"parameter": "1", "curvature": "1"}, {"side": "left"}),
        ("largest curvature", {"parameter": "2", "curvature": "1"}, {"side": "right"}),
    ]


def test_pieces_of_the_largest_curvature_run_on_across_the_seam():
    circle = example("circle")
    first, second = circle.split(1)
    joined = listed(analyse(circle.insert_knot("1/3")).largest_curvature)
    assert joined == [("largest curvature on a piece", {"curvature": "1", "start": "0", "end": "4"}, {})]
    assert [listed(analyse(x).largest_curvature)[0][1]["end"] for x in (first, second)] == ["1", "4"]


def test_a_piece_that_ends_at_the_seam_has_the_limit_behind_it():
    """A line of speed 2 up to the seam, from which a parabola begins with that speed."""
    points = [(0, 0), (1, 0), (1, 1), (0, 1), (-2, 0), (-1, 0), (0, 0)]
    curve = Nurbs(2, [0, 0, 0, 1, 1, 11, 11, 12, 12, 12], points)
    assert listed(curve.largest_speed) == [
        ("largest speed", {"parameter": "1", "speed": "2"}, {"side": "left"}),
        ("largest speed on a piece", {"speed": "2", "start": "11", "end": "12"}, {}),
    ]


def test_near_a_cusp_nothing_is_bounded_and_a_stop_is_a_point_like_others():
    assert listed(ask(example("cusp"), "largest_curvature")) == [("unbounded near", {"parameter": "1/2"}, {})]
    cubed = [0, 0, 0, 1]
    parabola = Nurbs(6, [0] * 7 + [1] * 7, [*zip([*cubed, 4, 10, 20], [0] * 6 + [20], strict=True)])
    (found,) = listed(analyse(parabola).largest_curvature)
    assert (found[1]["parameter"], found[2]) == ("0", {})
    with pytest.raises(DomainError, match="γ′ = 0"):
        ask(parabola, "curvature_derivative@0")


def test_what_stands_still_or_is_straight_has_no_largest_torsion_or_curvature():
    still = Nurbs(1, [0, 0, 1, 1], [(1, 2), (1, 2)])
    assert analyse(still).largest_curvature == analyse(still).largest_curvature_derivative == ()
    assert listed(analyse(still).largest_speed) == [
        ("largest speed on a piece", {"speed": "0", "start": "0", "end": "1"}, {})
    ]
    assert listed(ask(still, "curvature_at_most:1")) == [("curvature bound", {"bound": "1"}, {"holds": "yes"})]
    straight = Nurbs(1, [0, 0, 1, 1], [(0, 0, 0), (1, 2, 3)])
    assert analyse(straight).largest_torsion == ()
    assert str(analyse(straight).largest_curvature_derivative[0].values["curvature derivative"]) == "0"
    with pytest.raises(ShapeError, match="torsion of a curve in R2"):
        _ = analyse(LINE).largest_torsion
    with pytest.raises(ShapeError, match="R4"):
        analyse(FOUR).curvature_at_most(1)


def test_in_space_the_derivative_of_the_curvature_has_two_limits_where_it_vanishes():
    curve = example("flat_point")
    values = [ask(curve, f"curvature_derivative@{t}")[0].values["curvature derivative"] for t in ("1/2-", "1/2+")]
    assert values[0] == -values[1] != 0


def test_parts_above_a_number_run_on_across_knots_and_the_seam():
    ellipse = example("ellipse")
    (holds, first, second) = analyse(ellipse).curvature_at_most(1)
    assert holds.facts == {"holds": "no"}
    assert first.values["start"] < 2 < first.values["end"] < second.values["start"]
    assert second.values["end"] < 1
    assert listed(analyse(ellipse).curvature_at_most(2)) == [("curvature bound", {"bound": "2"}, {"holds": "yes"})]
    assert listed(analyse(example("circle")).curvature_at_most("0.99"))[1:] == [
        ("above", {"start": "0", "end": "4"}, {})
    ]
    with pytest.raises(ShapeError, match="not negative"):
        analyse(ellipse).curvature_at_most(-1)


def test_arcs_joined_to_their_lines_in_a_road():
    """A quarter of a circle between two straight ones, at each end a jump of the curvature."""
    first, second = (Nurbs(1, [0, 0, 1, 1], points) for points in ([(1, -2), (1, 0)], [(0, 1), (-2, 1)]))
    arc = example("circle").split(1)[0]
    near = CurvePair(first, arc).junctions[0]
    assert listed([near])[0][1] == {"first": "1", "second": "0", "gap": "0", "angle": "0", "curvature jump": "1"}
    assert near.facts == {"geometric": 1, "parametric": 1}
    assert CurvePair(second, arc).junctions[0].values["second"] == 1
    assert CurvePair(first, arc).junctions_within("1/1000")[0].facts == {"geometric": 1}
    assert CurvePair(first, arc).junctions_within(1)[0].facts == {"geometric": 2}


def test_all_four_pairs_of_ends_the_nearest_first():
    other = Nurbs(1, [0, 0, 1, 1], [(3, 1), (1, "1/100")])
    found = CurvePair(LINE, other).junctions
    assert [(int(x.values["first"]), int(x.values["second"])) for x in found] == [(1, 1), (0, 1), (1, 0), (0, 0)]
    assert [x.facts["geometric"] for x in found] == [-1] * 4
    assert CurvePair(LINE, example("circle")).junctions == ()
    with pytest.raises(ShapeError, match="positive"):
        CurvePair(LINE, other).junctions_within(0)
    for curves, message in (((LINE, example("twisted_cubic")), "R2 and one in R3"), ((FOUR, FOUR), "a curve in R4")):
        with pytest.raises(ShapeError, match=message):
            _ = CurvePair(*curves).junctions
        with pytest.raises(ShapeError, match=message):
            CurvePair(*curves).junctions_within(1)


def test_ends_without_a_tangent():
    """Where γ′ = 0 the direction is known, and no curvature."""
    stop = Nurbs(3, [0] * 4 + [1] * 4, [(1, 0), (1, 0), (1, 0), (2, 0)])
    (found, *_) = CurvePair(LINE, stop).junctions
    assert listed([found])[0][1:] == (
        {"first": "1", "second": "0", "gap": "0", "angle": "0"},
        {"geometric": "unknown", "parametric": 0},
    )
    assert CurvePair(LINE, stop).junctions_within("1/9")[0].facts == {"geometric": 1}
    assert CurvePair(stop.reverse(), LINE).junctions[0].facts["geometric"] == "unknown"
