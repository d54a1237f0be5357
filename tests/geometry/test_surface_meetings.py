"""A surface with a point, a line, a plane; its bounding box; lemons and monstars."""

import pickle
from contextlib import suppress
from random import Random

import pytest
from gmpy2 import mpq

from exactspline import NurbsSurface, Real, TensorSpline, ask, example, square_root
from exactspline.bivariate import quotients
from exactspline.errors import ReachError, ShapeError
from exactspline.geometry.analysis.ask import questions
from exactspline.questions import takes
from tests.campaigns import surface_meetings as campaign
from tests.support.dials import ALWAYS, DIALS

U, V = (TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], rows) for rows in ([[0, 0], [1, 1]], [[0, 1], [0, 1]]))
X, Y = 2 * U - 1, 2 * V - 1


def surface(*coordinates):
    """A polynomial surface over the unit square."""
    return NurbsSurface.from_splines([f + 0 * U * V for f in coordinates])


def places(answer):
    """The rational places of an answer."""
    return [place.exact for place in answer]


# ---- nearest points


def test_a_nearest_point_inside_on_an_edge_and_at_a_corner():
    plane = surface(X, Y, 0 * U)
    for point, place, squared in [
        ((0, "1/2", 3), (mpq(1, 2), mpq(3, 4)), 9),
        ((2, 0, 0), (1, mpq(1, 2)), 1),
        ((-2, 2, 1), (0, 1), 3),
    ]:
        found = ask(plane, f"nearest:{','.join(map(str, point))}")
        assert (places(found), found.squared, found.everywhere) == ([place], squared, ())


@pytest.mark.parametrize("dial", ALWAYS)
def test_boxes_and_elimination_have_the_same_nearest_points(monkeypatch, dial):
    """Near a point that is found by Newton's method, and without it."""
    random, answers = Random(dial), []
    nets = [[[[DIALS[dial](random) for _ in range(3)] for _ in range(3)] for _ in range(3)] for _ in range(4)]
    weights = [[random.randint(1, 3) for _ in range(3)] for _ in range(3)]
    for levels in (quotients.LEVELS, 0):
        monkeypatch.setattr(quotients, "LEVELS", levels)
        for net, own in zip(nets, (None, weights) * 2, strict=True):
            knots = [0, 0, 0, 1, 1, 1]
            found = NurbsSurface((2, 2), knots, knots, net, own).nearest(net[0][1])
            answers.append((found.distance.significant(30), [[x.decimal(30) for x in foot] for foot in found.feet]))
    assert answers[:4] == answers[4:]


def test_a_nearest_point_on_a_crease():
    """There neither side has a derivative that vanishes."""
    knots = [0, 0, 1, 2, 2]
    roof = NurbsSurface(
        (1, 1), knots, [0, 0, 1, 1], [[(x, y, z) for y in (0, 2)] for x, z in ((-1, 0), (0, 1), (1, 0))]
    )
    found = ask(roof, "nearest:0,1,2")
    assert (places(found), found.distance) == ([(1, mpq(1, 2))], 1)


def test_both_sides_of_a_surface_that_jumps():
    """The limit from the left is nearer, and is no value of the surface from the right."""
    net = [[(x, y, z) for y in (0, 2)] for x, z in ((0, 1), (1, 1), (1, 5), (2, 5))]
    torn = NurbsSurface((1, 1), [0, 0, 1, 1, 2, 2], [0, 0, 1, 1], net)
    found = ask(torn, "nearest:1,1,0")
    assert (found.distance, [place.patches for place in found]) == (1, [((0, 0),)])


def test_everywhere_on_a_sphere_along_a_circle_and_at_a_pole():
    centre = ask(example("sphere"), "nearest:0,0,0")
    assert (centre.points, centre.distance, len(centre.everywhere)) == ((), 1, 8)
    ring = ask(example("cylinder"), "nearest:0,0,1/3")
    assert (ring.points, ring.distance, len(ring.everywhere)) == ((), 1, 4)
    pole = ask(example("sphere"), "nearest:0,0,3")
    assert (pole.distance, {part.sides.second for part in pole.everywhere}) == (2, {(2, 2)})


def test_along_a_circle_at_an_irrational_parameter():
    """Points at which the circle meets the borders of patches are no single points."""
    found = ask(example("torus"), "nearest:0,0,5")
    assert (found.points, found.distance) == ((), square_root(Real(29)) - 1)
    assert {part.along_curve for part in found.everywhere} == {True}


def test_ties_that_are_equal_and_one_that_is_missed_by_little():
    saddle = example("hyperbolic_paraboloid")
    assert places(ask(saddle, "nearest:0,0,3")) == [(-1, -1), (1, 1)]
    near = ask(saddle, f"nearest:1/{10**40},0,3")
    assert places(near) == [(1, 1)]


def test_three_ties_at_irrational_parameters():
    """Equal because they are, not because forty digits agree."""
    found = ask(example("monkey_saddle"), "nearest:0,0,1")
    assert len(found) == 3
    assert len(ask(example("monkey_saddle"), f"nearest:1/{10**30},0,1")) == 1


def test_a_point_of_the_surface_is_at_the_distance_0():
    bicubic = example("bicubic")
    found = ask(bicubic, f"nearest:{','.join(map(str, bicubic('1/3', '2/7')))}")
    assert (places(found), float(found)) == ([(mpq(1, 3), mpq(2, 7))], 0)


def test_the_feet_are_at_the_places():
    found = ask(example("sphere"), "nearest:1,2,3")
    root = square_root(Real(14))
    assert [x * root for x in found.feet[0]] == [1, 2, 3]
    assert found.distance == root - 1


def test_a_seam_is_told_once():
    assert places(ask(example("sphere"), "nearest:3,0,0")) == [(0, 1)]


def test_a_degenerate_surface():
    point = surface(0 * U + 1, 0 * U + 2, 0 * U)
    found = ask(point, "nearest:1,0,0")
    assert (found.points, found.distance, len(found.everywhere)) == ((), 2, 1)


def test_an_answer_can_be_pickled():
    found = ask(example("biquadratic"), "nearest:1,2,3")
    again = pickle.loads(pickle.dumps(found))
    assert (again.distance == found.distance, float(again)) == (True, float(found))
    assert [place.spot for place in again] == [place.spot for place in found]


# ---- lines


def test_a_line_a_ray_and_a_segment():
    sphere = example("sphere")
    assert [x.parameter for x in ask(sphere, "line_intersections:0,0,0,0,1/2,0")] == [-2, 2]
    assert [x.parameter for x in ask(sphere, "ray_intersections:0,0,0,0,1/2,0")] == [2]
    assert [x.parameter for x in ask(sphere, "segment_intersections:0,0,0,0,4,0")] == [mpq(1, 4)]
    assert not ask(sphere, "segment_intersections:0,0,0,0,1/2,0")


def test_the_first_hit_is_first():
    """By the parameters u and v it is the last one."""
    hits = ask(example("torus"), "ray_intersections:-5,0,0,1,0,0")
    assert [x.parameter for x in hits] == [2, 4, 6, 8]


def test_a_tangent_has_multiplicity_2():
    paraboloid = surface(X, Y, X * X + Y * Y)
    (one,) = ask(paraboloid, "line_intersections:0,0,0,1,0,0")
    assert (one.zero.kind, one.zero.multiplicity, one.zero.where) == ("touching", 2, "inside a patch")
    # neither of the two planes that are taken is the tangent plane
    turned = paraboloid.transform([[0, 2, -1, 0], [1, 1, 1, 0], [1, 0, -2, 0]])
    (other,) = ask(turned, "line_intersections:0,0,0,0,1,1")
    assert (other.zero.kind, other.zero.multiplicity) == ("touching", 2)
    flat = surface(X, Y, X**3 + Y * Y)
    assert [x.zero.multiplicity for x in ask(flat, "line_intersections:0,0,0,1,0,0")] == [3]


def test_a_ray_from_a_point_with_irrational_parameters():
    """Its start counts, and is not taken for a point before it by a rounded number."""
    sphere = example("sphere")
    (hit,) = ask(sphere, "ray_intersections:2/3,2/3,1/3,2/3,2/3,1/3")
    assert hit.parameter == 0
    assert not ask(sphere, f"ray_intersections:{mpq(2, 3) + mpq(1, 10**40)},2/3,1/3,2/3,2/3,1/3")
    assert len(ask(sphere, "segment_intersections:0,0,0,2/3,2/3,1/3")) == 1


def test_a_line_in_the_surface():
    saddle = surface(X, Y, X * Y)
    found = ask(saddle, "line_intersections:0,0,0,1,0,0")
    assert (found.points, len(found.everywhere)) == ((), 1)
    with pytest.raises(ShapeError) as caught:
        ask(saddle, "ray_intersections:1/2,0,0,1,0,0")
    remedy = caught.value.remedy.split()[0]
    assert ask(saddle, remedy).everywhere
    diagonal = ask(surface(U, V, (U - V) * U), "line_intersections:0,0,0,1,1,0")
    assert [part.along_curve for part in diagonal.everywhere] == [True]


def test_a_seam_is_met_once():
    (hit,) = ask(example("sphere"), "ray_intersections:0,0,0,1,0,0")
    assert (hit.zero.kind, hit.zero.multiplicity) == ("transversal", 1)


@pytest.mark.parametrize(
    "question",
    [
        "line_intersections:0,0,0,0,0,0",
        "segment_intersections:1,2,3,1,2,3",
        "plane_section:0,0,0,1",
        "ray_intersections:1,2,3",
    ],
)
def test_what_is_no_line_or_plane_is_refused(question):
    with pytest.raises(takes.QuestionError, match="expected"):
        ask(example("sphere"), question)


# ---- planes


def test_sections_of_a_torus():
    torus = example("torus")
    shapes = {
        level: sorted(str(x.shape) for x in ask(torus, f"plane_section:1,0,0,{level}").curves)
        for level in ("0", "1/2", 1, 2)
    }
    assert shapes == {"0": [], "1/2": ["closed loop", "closed loop"], 1: ["branches that cross"], 2: ["closed loop"]}
    assert [line.value for line in ask(torus, "plane_section:1,0,0,0").lines] == [1, 3]
    (point,) = ask(torus, "plane_section:1,0,0,3").points
    assert (point.first, point.second) == (0, 0)


def test_a_plane_that_has_a_patch_of_the_surface():
    (part,) = ask(surface(X, Y, 0 * U), "plane_section:0,0,2,0").everywhere
    assert part.sides == ((0, 1), (0, 1))


# ---- the bounding box


def test_a_bounding_box_with_irrational_ends():
    box = ask(surface(U, V, U - 3 * U**3 + V**2), "bounding_box")
    assert [side.values["high"] for side in box] == [1, 1, 1 + Real(2) / 9]
    assert box[2].values["low"] == -2


# ---- umbilics of index 1/2


def darboux(a, b, c):
    """Darboux's normal form at (0, 0)."""
    cubic = (X**3).scaled(mpq(a) / 6) + (X * Y * Y).scaled(mpq(b) / 2) + (Y**3).scaled(mpq(c) / 6)
    return surface(X, Y, (X * X + Y * Y).scaled("1/2") + cubic)


@pytest.mark.parametrize(
    ("numbers", "kind"),
    [
        ((4, 1, 0), "lemon"),
        (("3/2", 1, 0), "monstar"),
        (("1/2", 1, 0), "star"),
        ((f"{2 * 10**30 + 1}/{10**30}", 1, 0), "lemon"),
        ((f"{2 * 10**30 - 1}/{10**30}", 1, 0), "monstar"),
        ((2, 1, 0), "lemon or monstar"),
        ((3, 1, 4), "monstar"),
    ],
)
def test_the_kinds_of_darboux(numbers, kind):
    found = [str(one.kind) for one in ask(darboux(*numbers), "umbilics") if one.place.exact == (mpq(1, 2), mpq(1, 2))]
    assert found == [kind]


def test_a_lemon_on_one_side_of_a_knot_and_a_monstar_on_the_other():
    """The index is ½ from both."""
    x, y = (
        TensorSpline((1, 1), [-1, -1, 0, 1, 1], [-1, -1, 1, 1], rows)
        for rows in ([[-1, -1], [0, 0], [1, 1]], [[-1, 1]] * 3)
    )
    bend = TensorSpline((1, 0), [-1, -1, 0, 1, 1], [-1, 1], [[0], [0], [1]])
    f = (
        (x * x + y * y).scaled("1/2")
        + (x * y * y).scaled("1/2")
        + (x**3).scaled("1/4")
        + (bend * bend * bend).scaled("1/2")
    )
    (one,) = [each for each in ask(NurbsSurface.from_splines([x, y, f]), "umbilics") if each.place.exact == (0, 0)]
    assert one.kind == "lemon or monstar"


# ---- all of it


def test_the_questions_are_in_the_registry():
    forms = {each.form for each in questions() if "surface in space" in each.of}
    assert {"nearest:0,0,2", "bounding_box", "line_intersections:0,0,2,1/2,0,-1", "plane_section:0,0,1,1/2"} <= forms


@pytest.mark.parametrize("family", campaign.FAMILIES)
def test_against_searches_from_many_starts(family):
    for dial in ALWAYS:
        with suppress(ReachError):
            assert not campaign.differs(family, dial, 2), (family, dial)
