"""Bisectors and intersections of offsets as questions: of two curves, and of a curve and a point."""

import json
from random import Random

import jsonschema
import pytest
from gmpy2 import mpq

import exactspline as xs
from exactspline.geometry.analysis.pairs import CurvePair
from tests.support.command import invoke, schema_of
from tests.support.drawn import light_curve
from workshop.vectors.items import items


def segment(*points):
    """A polygon."""
    n = len(points) - 1
    return xs.Nurbs(1, [0, *range(n + 1), n], points)


CIRCLE = xs.example("circle")
UPRIGHT = segment((3, -1), (3, 1))
LINE = segment((-4, 0), (4, 0))


def squared(p, q):
    """The square of a distance."""
    return sum((x - y) * (x - y) for x, y in zip(p, q, strict=True))


def test_the_points_of_arcs_are_equally_far_from_their_feet():
    """Exactly, whatever the curves; at a corner the feet are there all the same."""
    checked = 0
    for seed in range(6):
        random = Random(seed)
        first, second = (light_curve(2, random) for _ in range(2))
        for found in items(CurvePair(first, second), "bisector"):
            for end in ("start", "end", "parameter"):
                values = found.values
                if f"{end} x" in values:
                    point = values[f"{end} x"], values[f"{end} y"]
                    feet = xs.evaluate(first, values[end]), xs.evaluate(second, values[f"other {end}"])
                    assert squared(point, feet[0]) == squared(point, feet[1])
                    checked += 1
    assert checked > 40


def test_arcs_run_on_over_a_seam():
    """Before they were cut there: three arcs."""
    arcs = items(CurvePair(CIRCLE, UPRIGHT), "bisector")
    names = ("start", "end", "other start", "other end")
    told = [[found.values[name].exact for name in names] for found in arcs]
    assert told == [[mpq(1, 4), mpq(15, 4), 1, 0], [mpq(3, 2), mpq(5, 2), 0, 1]]


def test_a_seam_at_a_corner_is_two_places():
    """The point of a pair there is on the normal of the side on which it was found."""
    square = segment((0, 0), (2, 0), (2, 2), (0, 2), (0, 0))
    other = segment((-1, -2), (4, -3))
    for curve in (square, segment((2, 0), (2, 2), (0, 2), (0, 0), (2, 0))):
        arcs = [found.values for found in items(CurvePair(curve, other), "bisector")]
        ends = [(values, end) for values in arcs for end in ("start", "end") if f"{end} x" in values]
        assert len(ends) >= 8
        for values, end in ends:
            point = [values[f"{end} {axis}"] for axis in "xy"]
            feet = xs.evaluate(curve, values[end]), xs.evaluate(other, values[f"other {end}"])
            assert squared(point, feet[0]) == squared(point, feet[1])


def test_beside_a_piece_on_which_a_curve_stands_still_points_are_those_of_the_other_side():
    """At its end arcs had no point, though they end there at one."""
    for points in ([(0, 0), (2, 0), (2, 0)], [(2, 0), (2, 0), (0, 0)]):
        curve, other = segment(*points), segment((0, 1), (4, 3))
        arcs = [
            found.values
            for found in items(CurvePair(curve, other), "bisector")
            if found.what == "correspondence of parameters"
        ]
        ends = [(values, end) for values in arcs for end in ("start", "end") if values[end] == 1]
        assert ends
        for values, end in ends:
            point = [values[f"{end} {axis}"] for axis in "xy"]
            assert point[0] == 2
            assert squared(point, (2, 0)) == squared(point, xs.evaluate(other, values[f"other {end}"]))


def test_in_the_plane_z_0_they_are_bisectors_in_the_plane():
    flat = xs.Nurbs(1, [0, 0, 1, 1], [(-4, 0, 0), (4, 0, 0)])
    assert items(flat, "bisector:0,2") == items(LINE, "bisector:0,2")
    assert xs.ask((flat, CIRCLE), "bisector").pieces == xs.ask((LINE, CIRCLE), "bisector").pieces


def test_in_the_plane_z_0_all_doors_have_the_bisector_in_the_plane(tmp_path):
    """The command and `bisector` had that in space: lines."""
    pairs = [segment((0, 0), (2, 0)), segment((0, 1), (3, 4))]
    flat = [xs.Nurbs(1, curve.knots, [(*p, 0) for p in curve.control_points]) for curve in pairs]
    assert xs.bisector(*flat).pieces == xs.bisector(*pairs).pieces
    found = []
    for curves in (pairs, flat):
        files = [str(tmp_path / f"{name}.json") for name in "ab"]
        for curve, file in zip(curves, files, strict=True):
            xs.write(curve, file)
        for arguments in (["bisector", *files], ["bisector", files[0], "--point", "1,1"]):
            row = json.loads(invoke(*arguments, "--json").stdout)["rows"][0]
            found.append(row["pieces"])
    assert found[:2] == found[2:]


def test_a_point_at_infinity_is_left_out():
    arc, *ends = items(LINE, "bisector:0,2")
    assert [arc.values[name].exact for name in ("start x", "start y", "end x", "end y")] == [-4, 5, 4, 5]
    assert [("start x" in found.values, "end x" in found.values) for found in ends] == [(False, True), (True, False)]


def test_a_bisector_in_space_has_no_list_of_points():
    with pytest.raises(xs.ExactSplineError, match="surface"):
        items(xs.example("twisted_cubic"), "bisector:1,2,3")
    assert len(xs.ask(xs.example("ellipse_in_space"), "bisector:1,1,2").pieces) == 3


def test_a_pole_at_the_seam_is_told_once():
    """A tangent through the point: it was told at both ends."""
    points = [(0, 0, 0), (4, 0, 1), (3, 5, -1), (-1, 2, 3)]
    curve = xs.Nurbs(2, [*range(9)], [*points, *points[:2]])
    start = curve.domain[0]
    place = ",".join(str(x + y) for x, y in zip(curve(start), curve.derivative(1, start), strict=True))
    assert [x.exact for x in xs.ask(curve, f"bisector:{place}").singular] == [start]


def test_each_offset_has_its_own_sign():
    """An offset to the left is one to the right of the reversed curve."""
    ellipse = xs.example("ellipse")
    found = xs.ask((ellipse, LINE), "offset_intersections:1/4,1/2")
    other = xs.ask((ellipse, LINE.reverse()), "offset_intersections:1/4,-1/2")
    assert found
    assert [x.first for x in found] == [x.first for x in other]
    assert [x.point[1] for x in found] == [mpq(1, 2)] * len(found)


@pytest.mark.parametrize(
    "arguments",
    [
        ["between", "circle", "ellipse", "--ask", "bisector", "--ask", "offset_intersections:-1/4,1/4"],
        ["inspect", "circle", "--ask", "offset_intersections:ellipse,-1/4,1/4", "--ask", "bisector:0,1/2"],
    ],
)
def test_they_are_asked_by_commands(arguments):
    document = json.loads(invoke(*arguments, "--json").stdout)
    jsonschema.Draft202012Validator(schema_of("answers")).validate(document)
    assert all(row["answer"] and not row["error"] for row in document["rows"])
