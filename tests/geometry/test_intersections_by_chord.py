"""Where the determinant is out of reach, the common points are common zeros of the coordinates of the chord: the same
ones, of the same kinds.
"""

import random
from itertools import pairwise

import pytest

from exactspline import Nurbs, example, intersections, self_intersections
from exactspline.errors import ReachError
from exactspline.geometry.pairs import intersections as module

#: Of small integers, of fractions, and of doubles of 17 digits.
DIAL = [lambda r: r.randint(-5, 5), lambda r: f"{r.randint(-99, 99)}/7", lambda r: repr(r.uniform(-3, 3))]


def drawn(seed):
    """A random plane curve of one or two segments, every third one rational."""
    r = random.Random(seed)
    number, degree, segments = DIAL[seed % 3], r.randint(2, 4), r.randint(1, 2)
    knots = [0] * (degree + 1) + [1] * (segments - 1) + [segments] * (degree + 1)
    points = [(number(r), number(r)) for _ in range(degree + segments)]
    weights = [r.randint(1, 4) for _ in points] if seed % 3 == 1 else None
    return Nurbs(degree, knots, points, weights)


def said(found):
    return [(point.first, point.second, point.kind, point.multiplicity, point.at_knot) for point in found]


@pytest.fixture
def out_of_reach(monkeypatch):
    """No pair of segments is decided by a determinant, nor in doubles."""

    def refused(*_):
        raise ReachError("a determinant")

    monkeypatch.setattr(module, "meetings", refused)
    monkeypatch.setattr(module, "self_meetings", refused)
    monkeypatch.setattr(module, "certain_pair", lambda *_: None)


def test_both_ways_find_the_same_points(request):
    curves = [drawn(seed) for seed in range(48)]
    pairs = list(pairwise(curves))
    before = [[said(self_intersections(c)) for c in curves], [said(intersections(*pair)) for pair in pairs]]
    request.getfixturevalue("out_of_reach")
    after = [[said(self_intersections(c)) for c in curves], [said(intersections(*pair)) for pair in pairs]]
    assert sum(map(len, before[0])) > 3
    assert sum(map(len, before[1])) > 10
    assert after == before


@pytest.mark.usefixtures("out_of_reach")
def test_a_cusp_a_seam_and_a_tangent_point():
    """A cusp is no self-intersection, the seam of a closed curve neither, and a tangent has multiplicity 2."""
    cusp = Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (1, 1), (0, 1), (1, 0)])
    assert said(self_intersections(cusp)) == []
    drop = Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), (2, 3), (0, 0)])
    assert self_intersections(drop).undecided  # the segment runs back along itself
    assert said(self_intersections(Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (3, 1), (-3, 1), (0, 0)]))) == []
    parabola = Nurbs(2, [0, 0, 0, 1, 1, 1], [(-1, 1), (0, -1), (1, 1)])
    (touching,) = intersections(parabola, Nurbs(1, [0, 0, 1, 1], [(-1, 0), ("3/2", 0)]))
    assert (touching.kind, touching.multiplicity) == ("touching", 2)


@pytest.mark.usefixtures("out_of_reach")
def test_an_arc_in_common_stays_undecided():
    """It was not decided before either; nothing is listed in its place."""
    circle = example("circle")
    assert intersections(circle, circle.restrict(0, 1)).undecided
