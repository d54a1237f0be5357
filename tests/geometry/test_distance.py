"""The distance of two curves: against dense samples, at ends, knots and inside, in space, along arcs, near ties, and
where it is not decided.
"""

from itertools import product
from random import Random

import pytest
from gmpy2 import mpq

from exactspline import BSpline, Nurbs, distance, example, square_root
from exactspline.errors import ShapeError
from exactspline.language import Vector
from exactspline.polynomials.cost import Budget, drawing_on
from tests.campaigns import distance as campaign
from tests.support.bisector_oracle import bezier


@pytest.mark.parametrize("seed", range(12))
def test_no_pair_of_samples_is_nearer(seed):
    random = Random(seed)
    first, second = (
        bezier(*[(random.randint(0, 9) + shift, random.randint(0, 9)) for _ in range(random.randint(2, 4))])
        for shift in (0, random.choice([6, 12]))
    )
    found = distance(first, second)
    assert not found.undecided
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
    assert not found.undecided
    assert len({(p.first, p.second) for p in found.pairs}) == len(found.pairs)


def test_what_intersections_leave_out_is_left_out_of_the_distance():
    """False before: "these pairs" at the distance 0, where the common points of two segments are undecided."""
    t = BSpline.identity(0, 1)
    twice, again = (Nurbs.from_splines(Vector(u, u * u), t.constant(1)) for u in (4 * t * (1 - t), 3 * t * t - 2 * t))
    more = [*twice.control_points, (1, 0), (2, 0), (3, 2), (0, 1)]  # over an arc of y = x² to and fro, then across it
    found = distance(Nurbs(4, [0] * 5 + [1] * 4 + [2] * 5, more), again)
    assert (found.value, found.lower) == (0, 0)
    assert found.undecided


# ---- arcs of pairs at one distance

T = BSpline.identity(0, 1)
CIRCLE = example("circle")


def polynomial(*coordinates):
    return Nurbs.from_splines(Vector(*(T * 0 + x for x in coordinates)), T.constant(1))


def scaled(x, y=None):
    """The unit circle as a circle, or as an ellipse."""
    return CIRCLE.transform([[x, 0, 0], [0, x if y is None else y, 0]])


def in_space(curve, *heights):
    return Nurbs(
        curve.degree, curve.knots, [(*p, z) for p, z in zip(curve.control_points, heights, strict=True)], curve.weights
    )


PARABOLA = polynomial(2 * T - 1, (2 * T - 1) * (2 * T - 1))
#: A cubic whose tangent has a rational length: its derivative is (1 − t², 2t).
CUBIC = (T - T * T * T.scaled(mpq(1, 3)), T * T)
SPEED = T * T + 1
OFFSET = Nurbs.from_splines(
    Vector(CUBIC[0] * SPEED - T, CUBIC[1] * SPEED + (1 - T * T).scaled(mpq(1, 2))), SPEED
)  # by 1/2


def at_start(t, curve):
    """The seam of a closed curve is its start."""
    return curve.domain.low if curve.closed and t == curve.domain.high else t


@pytest.mark.parametrize(("first", "second", "squared", "arcs"), [
    (bezier((0, 0), (1, 0)), bezier((0, 1), (1, 1)), 1, [("0", "1", "0", "1")]),
    (bezier((0, 0), (1, 0)), bezier((3, 2), ("1/2", 2)), 4, [("1", "1/2", "4/5", "1")]),
    (bezier((0, 0), (1, 0)), bezier((2, 1), (3, 1)), 2, []),
    (bezier((0, 0), (1, 0)), bezier((1, 1), (2, 1)), 1, []),
    (polynomial(4 * T * (1 - T), 0), polynomial(T, 1), 1, [("0", "1/2", "0", "1"), ("1", "1/2", "0", "1")]),
    (polynomial((2 * T - 1) * (2 * T - 1), 0), polynomial(mpq(1, 9) - (2 * T - 1) * (2 * T - 1), 1), 1,
     [("1/2", "1/3", "1/3", "1/2"), ("1/3", "1/2", "1/2", "2/3"), ("1/2", "2/3", "1/3", "1/2"),
      ("2/3", "1/2", "1/2", "2/3")]),
    (CIRCLE, scaled(2), 1, [(str(k), str(k + 1), str(k), str(k + 1)) for k in range(4)]),
    (polynomial(*CUBIC), OFFSET, mpq(1, 4), [("0", "1", "0", "1")]),
    (in_space(CIRCLE, *[0] * 9), bezier((0, 0, -1), (0, 0, 2)), 1,
     [(str(k), str(k + 1), "1/3", "1/3") for k in range(4)]),
    (bezier((0, 0, 0), (0, 0, 8)), in_space(CIRCLE, *range(9)), 1,
     [(str(mpq(k, 4)), str(mpq(k + 1, 4)), str(k), str(k + 1)) for k in range(4)]),
], ids=["parallel", "antiparallel", "beside", "one pair", "to and fro", "a loop of pairs", "circles", "offset",
        "an axis", "around an axis"])  # fmt: skip
def test_curves_that_run_beside_each_other(first, second, squared, arcs):
    """False before: undecided, for parallel segments, circles about one point, offsets; for a circle and its axis,
    where one derivative vanishes throughout, "these five pairs" and no arc.
    """
    found = distance(first, second)
    assert (found.squared, found.undecided, found.lower) == (squared, (), None)
    assert sorted(arcs_of(found)) == sorted(arcs)
    ends = [pair for arc in found.everywhere for pair in zip(arc.first, arc.second, strict=True)]
    pairs = {(str(p.first), str(p.second)) for p in found.pairs}
    assert {tuple(str(at_start(t, c)) for t, c in zip(pair, (first, second), strict=True)) for pair in ends} <= pairs
    assert not campaign.difference((first, second), {}, Random(1))


def test_circles_whose_radii_have_an_irrational_ratio():
    """The common factor is of degree 2 in both parameters, and another branch of it is at the distance √2 + 1."""
    found = distance(CIRCLE, CIRCLE.transform([[1, -1, 0], [1, 1, 0]]))
    assert found.value == square_root(2) - 1
    assert len(found.everywhere) == len(found.pairs) == 8
    assert found.everywhere[0].first[0].minimal_polynomial() == [-1, 2, 1]
    assert not found.undecided


def test_the_map_along_an_arc():
    (arc,) = distance(bezier((0, 0), (1, 0)), bezier((3, 2), ("1/2", 2))).everywhere
    assert (arc.numerator, arc.denominator, arc.of_second, arc.reversed) == ((6, -5), (2,), False, True)  # s = 3 − 5t/2


# ---- near ties, exact numbers


@pytest.mark.parametrize(("by", "count"), [(0, 2), (mpq(1, 10**60), 1), (mpq(-1, 10**300), 1)])
def test_ties_of_critical_pairs_are_decided(by, count):
    """False before: 48 digits decided."""
    cup = bezier((-3, 3), (0, -3), (3, 3)).transform([[1, 0, by], [0, 1, 0]])
    found = distance(bezier((-3, 1), (0, -5), (3, 1)), cup)
    assert len(found.pairs) == count
    assert not found.undecided


@pytest.mark.parametrize("digits", [10, 250, 300])
def test_a_critical_pair_next_to_a_knot(digits):
    """Before: `ZeroDivisionError` for the first line, which is at the foot next to its end (from 60 digits on); for the
    second one two pairs, or the end instead of the foot, since 48 digits decided.
    """
    e = mpq(1, 10**digits)
    part = PARABOLA.restrict(0, mpq(1, 2) + e)
    for line, at_foot in ((bezier((-1, -1), (3 * e, -1), (4 * e, -1)), None), (bezier((-1, -1), (1, -1)), mpq(1, 2))):
        (pair,) = distance(line, part).pairs
        assert (pair.second, pair.squared) == (mpq(1, 2), 1)
        assert at_foot is None or pair.first.exact == at_foot
        assert -e / 10 <= line(pair.first.enclosure(2 * digits).low)[0] <= 0


def test_distances_are_exact_numbers():
    """Before: `OpenError`, "not known to be algebraic"."""
    found = distance(scaled(2, 1), scaled(3, 2))
    assert len(found.pairs) == 4
    assert all(p.squared == mpq(14, 15) for p in found.pairs)
    assert (found.squared.exact, found.value) == (mpq(14, 15), square_root("14/15"))
    assert found.pairs[0].first.exact is None
    assert len(found.pairs[0].first.minimal_polynomial()) > 2
    assert len({hash(p) for p in found.pairs}) == 4


def test_both_points_at_a_jump_count():
    """False before: √2, since the point before the jump was no end."""
    jump = Nurbs(1, [0, 0, 1, 1, 2, 2], [(0, 0), (1, 0), (5, 5), (6, 5)])
    assert distance(jump, bezier((2, -1), (2, 1))).squared == 1


def test_knots_on_an_arc_are_no_pairs():
    """False before: of a half circle around a point the knot in the middle was a pair beside the arc."""
    found = distance(CIRCLE.restrict(0, 2), bezier((0, 0), (0, 0)))
    assert {p.first for p in found.pairs} == {0, 2}
    assert arcs_of(found) == [("0", "2", "0", "1")]


def test_what_takes_too_long_is_named_and_bounded():
    with drawing_on(Budget(10)):
        found = distance(bezier((-1, 0), (0, 2), (1, 0)), bezier((-1, 3), (0, 2), (1, 3)))
    assert found.undecided
    assert 0 < found.lower <= found.squared


def test_a_sample_of_the_campaign():
    cases = product(campaign.FAMILIES, ("small integers", "doubles · 1e-300"))
    assert [case for case in cases if campaign.differs(*case, 300)] == []


def test_the_campaign_notices_what_is_wrong(monkeypatch):
    one = bezier((0, 0), (0, 9))
    right = distance(PARABOLA, bezier((0, 2), (0, 2)))
    monkeypatch.setattr(campaign, "distance", lambda *curves: type(right)(right.pairs[:1], everywhere=right.everywhere))
    assert campaign.difference((PARABOLA, bezier((0, 2), (0, 2))), {"point": 1}, Random(1))
    assert campaign.difference((PARABOLA, one), {"symmetric": True}, Random(1))
