"""How far one curve is from another, in bounds, and whether it is at most a number."""

import pytest
from gmpy2 import mpq

from exactspline import Nurbs, ask, example, square_root
from exactspline.errors import ReachError, ShapeError
from exactspline.geometry.analysis.pairs import CurvePair
from exactspline.geometry.pairs import deviation as engine
from tests.campaigns import deviation as campaign
from tests.support.dials import ALWAYS

LINE = Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 0)])
CUBIC = Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (1, 2), (3, 2), (4, 0)])


def moved(curve, x, y):
    return curve.transform([[1, 0, x], [0, 1, y]])


def holds(first, second, bound):
    return [found.facts["holds"] for found in ask((first, second), f"deviation_within:{bound}")]


def bounds(first, second):
    return [(found.values["low"], found.values["high"]) for found in ask((first, second), "deviation")]


@pytest.mark.parametrize("dial", ALWAYS)
@pytest.mark.parametrize("family", campaign.FAMILIES)
def test_against_dense_samples(family, dial):
    assert campaign.differs(family, dial, 1) == ""


@pytest.mark.parametrize("factor", ["98/100", "102/100"])
def test_bounds_that_do_not_contain_the_deviation_are_found(monkeypatch, factor):
    """The oracle sees them, too low and too high."""
    curves = CUBIC, Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), (2, 3), (4, 0)])
    found = ask(curves, "deviation")[0]
    values = {name: found.values[name] * mpq(factor) for name in ("low", "high")}
    wrong = type(found)(found.what, dict(found.values) | values)
    assert campaign.differs_way(curves, found, 0, mpq(4)) == ""
    assert campaign.differs_way(curves, wrong, 0, mpq(4)) != ""


def test_each_direction_has_its_own():
    """A part is nowhere far from the whole."""
    (first, second) = bounds(LINE, Nurbs(1, [0, 0, 1, 1], [(-1, 0), (3, 0)]))
    assert first == (0, 0)
    assert second[0] == 2 < second[1] <= mpq(202, 100)


@pytest.mark.parametrize(
    "other",
    [CUBIC, CUBIC.elevate_degree(2), CUBIC.insert_knot("1/3"), CUBIC.reverse(), campaign.squared(CUBIC)],
    ids=["itself", "degree", "knot", "reversed", "another parameter"],
)
def test_what_is_written_otherwise_has_no_deviation(other):
    assert bounds(CUBIC, other) == [(0, 0), (0, 0)]
    assert holds(CUBIC, other, 0) == ["yes", "yes"]


def test_a_common_start_alone_is_no_reason_for_0():
    """The ends of both are common points, and so is a point between."""
    wave = Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), ("1/3", 1), ("2/3", -1), (1, 0)])
    assert all(low > 0 for low, _ in bounds(wave, LINE))
    assert holds(wave, LINE, 0) == ["no", "no"]
    beside = Nurbs(1, [0, 0, 1, 2, 2], [(0, 0), ("1/2", 0), (1, "1/1000000000")])
    assert all(0 < low < high < mpq(11, 10**10) for low, high in bounds(LINE, beside))


def test_a_distance_that_is_attained_is_decided():
    """Of circles, where it is constant, and where it is attained at two parameters; of parallel lines."""
    circle = example("circle")
    wide = circle.transform([["9/5", "-12/5", 0], ["12/5", "9/5", 0]])
    for second, bound in ((wide, mpq(2)), (moved(circle, "1/2", 0), mpq(1, 2)), (moved(circle, 0, "1/7"), mpq(1, 7))):
        assert holds(circle, second, bound) == ["yes", "yes"]
        assert holds(circle, second, bound * (1 - mpq(1, 10**30))) == ["no", "no"]
    assert holds(LINE, moved(LINE, 0, 3), 3) == ["yes", "yes"]
    assert holds(LINE, moved(LINE, 0, 3), "2.9999999999999999999") == ["no", "no"]


def test_a_bound_that_is_attained_at_an_irrational_place():
    """Of y = x³ − 2x from the line y = −2 the farthest points have 3x² = 2, and there y = ∓ 4x/3."""
    cubic = Nurbs(3, [0] * 4 + [1] * 4, [(-1, 1), ("-1/3", "5/3"), ("1/3", "-5/3"), (1, -1)])
    line = Nurbs(1, [0, 0, 1, 1], [(-2, -2), (2, -2)])
    low, high = bounds(cubic, line)[0]
    assert low < 2 + 4 * square_root("2/3") / 3 < high
    # y = x² from the point (0, 2) has the farthest points of a part at its ends, x = ∓ 3/2, and from (0, 5/2) at 0
    parabola = Nurbs(2, [0, 0, 0, 1, 1, 1], [("-3/2", "9/4"), (0, "-9/4"), ("3/2", "9/4")])
    for y, bound in ((2, 2), ("5/2", "5/2")):
        point = Nurbs(1, [0, 0, 1, 1], [(0, y), (0, y)])
        assert holds(parabola, point, bound)[0] == "yes"
        assert holds(parabola, point, mpq(bound) * (1 - mpq(1, 10**40)))[0] == "no"


def test_jumps_and_pieces_that_stand_still():
    jump = example("jump")
    assert bounds(jump, jump) == [(0, 0), (0, 0)]
    still = Nurbs(1, [0, 0, 1, 2, 2], [(2, 0), (2, 0), (2, 1)])
    assert bounds(LINE, still)[0][0] == 2
    assert holds(LINE, Nurbs(1, [0, 0, 1, 1], [(0, 0), (0, 0)]), 1) == ["yes", "yes"]


def test_the_point_that_is_told_is_beyond_the_bound():
    found = CurvePair(CUBIC, LINE).deviation_within("1/2")[0]
    assert found.facts == {"holds": "no"}
    assert found.values["distance"] > mpq(1, 2)
    assert list(found.values) == ["bound", "distance", "at", "nearest"]
    assert list(CurvePair(CUBIC, LINE).deviation[1].values) == ["low", "high", "at", "nearest"]


def test_what_is_refused():
    with pytest.raises(ShapeError, match="R2 and one in R3"):
        ask((LINE, example("twisted_cubic")), "deviation")
    four = Nurbs(1, [0, 0, 1, 1], [(0, 0, 0, 0), (1, 2, 3, 4)])
    with pytest.raises(ShapeError, match="a curve in R4"):
        CurvePair(four, four).deviation_within(1)
    with pytest.raises(ShapeError, match="not negative"):
        ask((LINE, LINE), "deviation_within:-1")


def test_arcs_in_common_that_are_out_of_reach_are_named(monkeypatch):
    met = engine.intersections(CUBIC, LINE)
    monkeypatch.setattr(engine, "intersections", lambda *curves: type(met)((), (), ("the segments over [0, 1]",)))
    with pytest.raises(ReachError, match="arcs in common: the segments"):
        ask((CUBIC, campaign.squared(CUBIC)), "deviation")
