"""What is true of all curves and surfaces near one does not depend on how the weights are written."""

import re

import pytest
from gmpy2 import mpq

import exactspline as xs
from exactspline import Direction, Nurbs, NurbsSurface, example
from exactspline.errors import ShapeError
from tests.support.command import run

POINTS = [(0, 0), (1, 2), (2, -2), (3, 1)]
IN_SPACE = [(*point, k % 2) for k, point in enumerate(POINTS)]
QUESTIONS = "features_within:1/100", "self_intersections_within:1/100", "cusps_within:1/100", "stability"


def bezier(points, weights):
    return Nurbs(3, [0] * 4 + [1] * 4, points, weights, name="c")


def answers(curve, question, folder):
    """What the command says of a curve, without the digest of its data."""
    xs.write(curve, folder / "c.json")
    done = run("inspect", folder / "c.json", "--ask", question, "--json")
    assert done.returncode == 0, done.stderr
    return re.sub(r'"digest": "\w+"', "", done.stdout)


@pytest.mark.parametrize(
    ("points", "weights", "question"),
    [(POINTS, (1, 2, 1, 3), question) for question in QUESTIONS] + [(IN_SPACE, (1,) * 4, QUESTIONS[0])],
)
def test_weights_multiplied_by_minus_one_change_no_answer(points, weights, question, tmp_path):
    """Before: refused with “weights that stay positive: a smaller epsilon”, which no epsilon helped."""
    positive, negative = bezier(points, weights), bezier(points, [-w for w in weights])
    assert answers(negative, question, tmp_path) == answers(positive, question, tmp_path)


def test_common_points_too():
    """Before: refused."""
    first, line = bezier(POINTS, (1, 2, 1, 3)), Nurbs(1, [0, 0, 1, 1], [(0, "1/2"), (4, "1/3")])
    negative = bezier(POINTS, (-1, -2, -1, -3))
    found = xs.ask((first, line), "intersections_within:1/1000")
    assert [each.robust for each in found] == [True]
    assert xs.ask((negative, line), "intersections_within:1/1000") == found


def test_surfaces_too():
    """Before: refused, whatever the epsilon."""
    found = example("biquadratic")
    weights = [[-w for w in row] for row in found.weights]
    negative = NurbsSurface(found.degree, *found.knots, found.control_points, weights)
    assert xs.analyse(negative).umbilics_within("1/100000") == xs.analyse(found).umbilics_within("1/100000")


def test_the_curves_that_show_where_a_feature_is_gone_are_near_the_curve_as_it_is_written():
    negative = bezier(POINTS, [-1, -2, -1, -3])
    for found in xs.analyse(negative).stability:
        near = found.witness
        assert near is not None
        differences = [abs(a - b) for a, b in zip(negative.weights, near.weights, strict=True)]
        assert max(differences) <= found.gone


def test_what_is_advised_for_weights_of_both_signs_helps():
    """Before: “a smaller epsilon”, which did not."""
    curve = Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), (1, 2), (3, 0)], [1, "-1/10", 1])
    for epsilon in ("1/100", mpq(1, 10**30)):
        with pytest.raises(ShapeError, match="insert knots until all weights"):
            xs.analyse(curve).features_within(epsilon)
    inserted = curve.insert_knot("1/2")
    assert min(inserted.weights) > 0
    assert xs.analyse(inserted).features_within(mpq(1, 10**6))
    with pytest.raises(ShapeError, match="a smaller epsilon"):
        xs.analyse(inserted).features_within(1)


def test_a_direction_is_no_point_near_others():
    """Wrong before: its coordinates were those of a point of weight 0, so that a maximum was said to be certain at
    4.5236 and nowhere else, of a curve whose maximum is at 4.5020.
    """
    points = [(0, 0), (1, 0), Direction(1, 2), (3, 0), (4, 3)]
    curve = Nurbs(3, range(9), points, [1, 1, 0, 1, 1])
    epsilon = mpq(1, 10**5)
    for asked in (lambda: xs.analyse(curve).features_within(epsilon), lambda: xs.analyse(curve).stability):
        with pytest.raises(ShapeError, match="a direction among its control points; restrict it"):
            asked()
    curve = curve.restrict(3, 5).insert_knot(4, 2)
    places = [found.place for found in xs.analyse(curve).features_within(epsilon) if found.robust]
    extrema = [float(found.root) for found in xs.analyse(curve).curvature_extrema]
    assert [any(a <= t <= b for a, b in places) for t in extrema] == [True, True]
