"""The distance of two curves: against dense samples, at ends, knots and inside, in space, and where it is not
decided.
"""

from random import Random

import pytest
from gmpy2 import mpq

from exactspline import BSpline, Nurbs, distance, example
from exactspline.errors import ShapeError
from exactspline.language import Vector
from tests.support.bisector_oracle import bezier


@pytest.mark.parametrize("seed", range(12))
def test_no_pair_of_samples_is_nearer(seed):
    random = Random(seed)
    first, second = (
        bezier(*[(random.randint(0, 9) + shift, random.randint(0, 9)) for _ in range(random.randint(2, 4))])
        for shift in (0, random.choice([6, 12]))
    )
    found = distance(first, second)
    assert not found.left_out
    samples = [[c(mpq(k, 40)) for k in range(41)] for c in (first, second)]
    least = min(sum((x - y) ** 2 for x, y in zip(p, q, strict=True)) for p in samples[0] for q in samples[1])
    assert found.squared <= least
    assert float(found.value) > float(least) ** 0.5 - 1


def test_two_pairs_at_one_distance_are_both_found():
    parabola, below = (
        bezier((-1, 1), (0, -1), (1, 1)),
        bezier((-1, -1), (0, 1), (1, -1)).transform([[1, 0, 0], [0, 1, -3]]),
    )
    found = distance(parabola, below)
    assert [(p.first, p.second) for p in found.pairs] == [(mpq(1, 2), mpq(1, 2))]
    wide = bezier((-3, 1), (0, -5), (3, 1))
    assert len(distance(wide, bezier((-3, 3), (0, -3), (3, 3))).pairs) == 2


def test_curves_that_meet_have_the_distance_0():
    found = distance(example("circle"), bezier((0, 0), (2, 0)))
    assert (found.value, found.pairs[0].first, found.pairs[0].second) == (0, 0, mpq(1, 2))


def test_an_end_against_an_inner_point_and_a_seam():
    found = distance(example("circle"), bezier((2, 0), (3, 5)))
    assert found.value == 1
    assert {str(p.second) for p in found.pairs} == {"0"}


def test_in_space():
    assert distance(bezier((0, 0, 0), (2, 2, 0)), bezier((0, 2, 3), (2, 0, 3))).squared == 9


def test_parallel_segments_are_named_and_bounded():
    found = distance(bezier((0, 0), (1, 0)), bezier((0, 1), (1, 1)))
    assert found.squared == 1
    assert found.left_out
    assert mpq(99, 100) < found.lower <= 1


def test_dimensions_must_agree():
    with pytest.raises(ShapeError, match="R3"):
        distance(example("circle"), example("twisted_cubic"))


def arcs_of(found):
    return [(*map(str, arc.first), *map(str, arc.second)) for arc in found.everywhere]


@pytest.mark.parametrize(("first", "second", "value", "arcs"), [
    (bezier((0, 0), (1, 0)), bezier(("1/2", 0), (3, 0)), 0, [("1/2", "1", "0", "1/5")]),
    (example("circle"), bezier((0, 0), (0, 0)), 1, [("0", "4", "0", "1")]),
    (bezier((0, 0), (0, 0)), example("circle"), 1, [("0", "1", "0", "4")]),
    (example("circle").restrict(0, 1), bezier((0, 0), (-5, -5)), 1, [("0", "1", "0", "0")]),
    (bezier((1, 2, 2), (1, 2, 2)), bezier((0, 0, 0), (0, 0, 0)), 3, [("0", "1", "0", "1")]),
    (bezier((0, 0, 3), (0, 0, 3)), bezier((0, 0, 0), (1, 0, 0)), 3, [("0", "1", "0", "0")]),
    (bezier((0, 3), (1, 4)), bezier((0, 0), (1, 0)), 3, []),
], ids=["common", "about a point", "a point", "about an end", "two points", "a point in space", "none"])  # fmt: skip
def test_arcs_of_nearest_points_are_named(first, second, value, arcs):
    """False before: the ends of arcs were all pairs. A point with a circle around it, or two points: `ValueError`."""
    found = distance(first, second)
    assert found.value == value
    assert arcs_of(found) == arcs
    assert not found.left_out
    assert len({(p.first, p.second) for p in found.pairs}) == len(found.pairs)


def test_what_intersections_leave_out_is_left_out_of_the_distance():
    """False before: "these pairs" at the distance 0, where the common points of two segments are undecided."""
    t = BSpline.identity(0, 1)
    twice, again = (Nurbs.from_splines(Vector(u, u * u), t.constant(1)) for u in (4 * t * (1 - t), 3 * t * t - 2 * t))
    more = [*twice.control_points, (1, 0), (2, 0), (3, 2), (0, 1)]  # over an arc of y = x² to and fro, then across it
    found = distance(Nurbs(4, [0] * 5 + [1] * 4 + [2] * 5, more), again)
    assert (found.value, found.lower) == (0, 0)
    assert found.left_out
