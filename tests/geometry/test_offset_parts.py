"""The true parts of the offset of a simple closed curve, between exact ends."""

import pytest
from gmpy2 import mpq

from exactspline import Nurbs, analyse, ask, example, square_root
from exactspline.errors import ReachError, ShapeError
from tests.campaigns import offset_parts as campaign
from tests.support.dials import ALWAYS

CORNERED = Nurbs(1, [0, 0, 1, 2, 3, 4, 5, 6, 6], [(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4), (0, 0)])
SQUARE = Nurbs(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (4, 0), (4, 4), (0, 4), (0, 0)])


def parts(curve, d):
    return [(x.what, {name: str(value) for name, value in x.values.items()}) for x in ask(curve, f"offset_parts:{d}")]


@pytest.mark.parametrize("dial", ALWAYS)
@pytest.mark.parametrize("family", campaign.FAMILIES)
def test_against_dense_samples(family, dial):
    assert campaign.differs(family, dial, 1) == ""


@pytest.mark.parametrize("change", ["longer", "missing", "no arc", "none"])
def test_parts_that_are_wrong_are_found(monkeypatch, change):
    """The oracle sees what is too long, what is missing, and an offset that is not empty."""
    true = ask(CORNERED, "offset_parts:1/2")

    def wrong(curve, question):
        if question == "corners":
            return ask(curve, question)
        first = type(true[0])("part", {"start": true[0].values["start"] - mpq(1, 20), "end": true[0].values["end"]})
        return {"longer": (first, *true[1:]), "missing": true[1:], "no arc": true[:-1], "none": ()}[change]

    monkeypatch.setitem(campaign.FAMILIES, "planted", lambda number, random: CORNERED)
    monkeypatch.setattr(campaign, "drawn_distance", lambda random, size: mpq(1, 2))
    monkeypatch.setattr(campaign, "turned", lambda curve, random: curve)
    assert campaign.differs("planted", "thirds", 1) == ""
    monkeypatch.setattr(campaign, "ask", wrong)
    assert campaign.differs("planted", "thirds", 1) != ""


def test_an_arc_about_a_corner_that_turns_away():
    """It is left when both sides of the corner are gone; where these meet the other sides, the ends are irrational."""
    assert parts(CORNERED, "1/2")[-1] == (
        "arc about a corner",
        {"corner": "3", "start x": "3/2", "start y": "2", "end x": "2", "end y": "3/2"},
    )
    first, second, arc = ask(CORNERED, "offset_parts:11/10")
    assert first.values["end"] == (10 - square_root(10)) / 20
    assert arc.values["start y"] == (10 - square_root(10)) / 5
    assert second.what == "part"


def test_whether_anything_is_left():
    """The largest disc in it has its centre (r, r) at the distance r from the corner (2, 2): r = 4 − 2√2."""
    largest = 4 - 2 * square_root(2)
    low, high = largest.enclosure(20)
    assert ask(CORNERED, f"offset_parts:{low}")
    assert not ask(CORNERED, f"offset_parts:{high}")
    assert parts(SQUARE, 3) == []
    assert parts(SQUARE, -3)[0] == ("part", {"start": "0", "end": "4"})
    assert parts(example("ellipse"), "1/2") == [("part", {"start": "0", "end": "4"})]
    assert parts(example("ellipse"), 1) == []


def test_a_part_that_runs_on_across_the_seam_ends_below_its_start():
    from_middle = Nurbs(1, [0, 0, 1, 2, 3, 4, 5, 5], [(2, 0), (4, 0), (4, 4), (0, 4), (0, 0), (2, 0)])
    assert parts(from_middle, 1)[-1] == ("part", {"start": "9/2", "end": "1/2"})


def test_at_the_radius_of_the_largest_circle_inside_points_are_left():
    """Of the triangle with the sides 3, 4, 5 that is 1: the offset at it is one point, and no part."""
    triangle = Nurbs(1, [0, 0, 1, 2, 3, 3], [(0, 0), (3, 0), (0, 4), (0, 0)])
    assert [len(parts(triangle, d)) for d in (mpq(99, 100), 1, mpq(101, 100))] == [3, 0, 0]


def test_what_is_refused():
    eight = Nurbs(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (2, 2), (2, 0), (0, 2), (0, 0)])
    spike = Nurbs(1, [0, 0, 1, 2, 3, 3], [(0, 0), (2, 0), (1, 0), (0, 0)])
    for curve, d in ((eight, 1), (spike, 1), (SQUARE, 0), (example("cubic_s"), 1)):
        with pytest.raises(ShapeError, match="closed plane curve"):
            analyse(curve).offset_parts(d)
    with pytest.raises(ShapeError, match="meets itself: <crossing at 1/2 and 5/2>"):
        analyse(eight).offset_parts(1)
    for curve, d in ((SQUARE, 2), (example("circle"), 1)):
        with pytest.raises(ReachError):
            analyse(curve).offset_parts(d)
