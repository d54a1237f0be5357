"""Pairs of plane curves whose normals meet: the bisector of two curves, and the points at which an offset meets itself,
against the definition in exact numbers and against polygons of many sides.
"""

from itertools import pairwise
from math import hypot
from random import Random

import pytest
from gmpy2 import mpq

import exactspline as xs
from exactspline import Nurbs, analyse, bisector, example, intersections, self_intersections
from exactspline.errors import ReachError, ShapeError
from exactspline.geometry.bisectors.plane_pair import tangent
from tests.support.bisector_oracle import bezier
from tests.support.bisector_oracle import line as polyline


def drawn(random, dial, n, rational=False):
    """A random curve, in small integers or in doubles."""
    number = (lambda: random.randint(-5, 5)) if dial == "small" else (lambda: mpq(random.uniform(-5, 5)))
    points = [(number(), number()) for _ in range(n + 1)]
    return bezier(*points, weights=[random.randint(1, 4) for _ in points] if rational else None)


DIALS = ("small", "doubles")

# ---- bisectors


@pytest.mark.parametrize("dial", DIALS)
@pytest.mark.parametrize("seed", range(3))
def test_points_of_a_bisector_are_equally_far_on_both_normals(seed, dial):
    """A bisector of two plane curves was refused. Exactly, at all zeros on some lines s = constant."""
    random = Random(seed)
    first, second = drawn(random, dial, 2 + seed % 2, rational=seed % 3 == 0), drawn(random, dial, 2)
    found, count = bisector(first, second), 0
    assert found.missing == ()
    for s in (mpq(1, 3), mpq(4, 5)):
        for t in xs.zeros(found.function.at_s(s)):
            x, p, q = found.point(s, t), xs.evaluate(first, s), xs.evaluate(second, t)
            ways = [[b - a for a, b in zip(one, x, strict=True)] for one in (p, q)]
            one, other = (way[0] * way[0] + way[1] * way[1] for way in ways)
            assert one == other
            for curve, at, (a, b) in ((first, s, ways[0]), (second, t, ways[1])):
                u, v = (f.d() * curve.w - f * curve.w.d() for f in curve.p)
                assert xs.evaluate(u, at) * a + xs.evaluate(v, at) * b == 0
            count += 1
    signs = [_difference(first, second, mpq(1, 3), mpq(2 * k + 1, 160)) for k in range(80)]
    changes, zeros = sum(a * b < 0 for a, b in pairwise(signs)), len(xs.zeros(found.function.at_s(mpq(1, 3))))
    assert changes <= zeros
    assert (zeros - changes) % 2 == 0 or abs(signs[0] * signs[-1]) < 1e-3
    assert count or not found.pieces or seed


def _difference(first, second, s, t):
    """The difference of the squared distances of where the normals meet, times [a b], in doubles."""
    (p, a), (q, b) = (_frame(curve, x) for curve, x in ((first, s), (second, t)))
    across = a[0] * b[1] - a[1] * b[0]
    along = [((q[0] - p[0]) * c[0] + (q[1] - p[1]) * c[1]) for c in (b, a)]
    return (along[0] ** 2 * (a[0] ** 2 + a[1] ** 2) - along[1] ** 2 * (b[0] ** 2 + b[1] ** 2)) / across


def _frame(curve, t):
    """A point and a tangent in doubles."""
    step = 1e-6
    points = [[float(x) for x in xs.evaluate(curve, t + mpq(e))] for e in (0, step, -step)]
    return points[0], [(u - v) / (2 * step) for u, v in zip(points[1], points[2], strict=True)]


def test_known_bisectors():
    """Of two lines their angle bisectors; of a line and a circle the parabolas with its centre as focus, moved."""
    one, other = bezier((0, 0), (4, 0)), bezier((0, 1), (4, 4))
    found = bisector(one, other)
    for arc in found.pieces:
        x, y = found.point(*arc.start)
        assert (y * 5) * (y * 5) == (3 * x - 4 * y + 4) * (3 * x - 4 * y + 4)  # equal distances from both lines
    circle, line = example("circle"), bezier((-3, -2), (3, -2))
    found = bisector(line, circle)
    assert len(found.pieces) >= 2
    for arc in found.pieces:
        x, y = found.point(*arc.end)
        inner = (x * x + y * y - (y + 2 + 1) * (y + 2 + 1)) * (x * x + y * y - (y + 2 - 1) * (y + 2 - 1))
        assert inner == 0  # the distance from the circle is that from its centre, less or more by 1


def test_what_a_bisector_refuses():
    with pytest.raises(ShapeError):
        bisector(example("circle"), example("twisted_cubic"))
    parallel = bisector(bezier((0, 0), (2, 0)), bezier((0, 1), (2, 1)))
    with pytest.raises(ReachError, match="parallel"):
        parallel.point(0, 1)
    assert parallel.point(1, 1) == (mpq(2), mpq(1, 2))


# ---- offsets


def polygon(curve, distance, sides):
    """The offset as a polygon, in doubles."""
    points = []
    for k in range(sides + 1):
        t = mpq(k, sides) * (curve.domain[1] - curve.domain[0]) + curve.domain[0]
        (x, y), (u, v) = (
            [float(c) for c in xs.evaluate(curve, t)],
            [float(xs.evaluate(f, t)) for f in _velocity(curve)],
        )
        size = hypot(u, v)
        points.append((x - distance * v / size, y + distance * u / size))
    return points


def _velocity(curve):
    return tuple(f.d() * curve.w - f * curve.w.d() for f in curve.p)


def crossings(points):
    """How often a polygon crosses itself."""
    sides = list(pairwise(points))
    return sum(_cross(side, other) for i, side in enumerate(sides) for other in sides[i + 2 :])


def crossings_of(first, second):
    """How often two polygons cross."""
    return sum(_cross(side, other) for side in pairwise(first) for other in pairwise(second))


def _cross(side, other):
    (a, b), (c, d) = side, other
    return _side(a, b, c) * _side(a, b, d) < 0 and _side(c, d, a) * _side(c, d, b) < 0


def _side(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def test_the_bisector_at_corners_and_where_a_curve_has_no_tangent():
    """The point of an arc that ends in a corner was that of the other side, and at a cusp the middle of the chord."""
    corner, parabola = polyline((0, 0), (2, 0), (2, 3)), bezier((-1, 2), (1, 4), (3, 0))
    found, velocity, ends = bisector(corner, parabola), tangent(parabola), 0
    for place in (place for arc in found.pieces for place in (arc.start, arc.end) if place[0] == 1):
        x, y = found.point(*place)
        p, (u, v) = xs.evaluate(parabola, place[1]), (xs.evaluate(f, place[1]) for f in velocity)
        assert (x - 2) * (x - 2) + y * y == (x - p[0]) * (x - p[0]) + (y - p[1]) * (y - p[1])
        assert (x - p[0]) * u + (y - p[1]) * v == 0
        assert 0 in (x - 2, y)
        ends += 1
    assert ends > 1
    with pytest.raises(ReachError, match="no tangent"):
        bisector(example("cusp"), polyline((0, -3), (3, -3))).point("1/2", "1/3")


@pytest.mark.parametrize("dial", DIALS)
@pytest.mark.parametrize("seed", [102, 103, 104, 105, 107])
def test_offsets_meet_themselves_as_polygons_do(seed, dial):
    """There was no door for the self-intersections of an offset."""
    random = Random(seed)
    curve, distance = drawn(random, dial, 2 + seed % 2), random.choice([mpq(1, 2), mpq(-1), mpq(3, 2)])
    found = self_intersections(curve, offset=distance)
    assert found.undecided == ()
    assert len(found) == crossings(polygon(curve, float(distance), 230))
    for point in found:
        one, other = (point.point, _offset(curve, point.second, distance))
        assert all(abs(float(x) - y) < 1e-9 for x, y in zip(one, other, strict=True))
        assert (str(point.kind), point.multiplicity) == ("crossing", 1)


def _offset(curve, t, distance):
    (x, y), (u, v) = ([float(c) for c in xs.evaluate(curve, t)], [float(xs.evaluate(f, t)) for f in _velocity(curve)])
    return x - float(distance) * v / hypot(u, v), y + float(distance) * u / hypot(u, v)


def test_the_offset_of_a_parabola():
    """y = x² at d: the normals of ±x meet in (0, x² + 1/2), at the distance √(x² + 1/4)."""
    parabola = bezier((-2, 4), (0, -4), (2, 4))
    (found,) = self_intersections(parabola, offset="5/4")
    assert (found.point, found.first + found.second) == ((0, mpq(29, 16)), 1)
    assert (4 * found.first - 2) * (4 * found.first - 2) == mpq(21, 16)
    assert self_intersections(parabola, offset="1/2").points == ()  # the cusp is about to be born
    assert self_intersections(parabola, offset=-1).points == ()
    moved = parabola.insert_knot("1/5").insert_knot("4/5")
    (over_knots,) = self_intersections(moved, offset="5/4")
    assert (over_knots.point, over_knots.first) == (found.point, found.first)


def test_an_offset_that_touches_itself_where_normals_are_parallel():
    """Two sides that are 2 apart, and an ellipse whose offset touches itself in the middle."""
    horseshoe = bezier((0, 0), (0, 4), (2, 4), (2, 0))
    assert len(self_intersections(horseshoe, offset="-1/3")) == len(self_intersections(horseshoe, offset=-2)) == 0
    touching = self_intersections(horseshoe, offset=-1)
    assert [(p.first, p.second, str(p.kind), p.multiplicity) for p in touching] == [(0, 1, "knot", None)]
    (middle,) = self_intersections(example("ellipse"), offset=1)
    assert (middle.first, middle.second, middle.point) == (1, 3, (0, 0))
    (seam,) = self_intersections(example("ellipse"), offset=2)
    assert (seam.first, seam.second) == (0, 2)


def test_the_offset_at_corners():
    """At a corner the offset has two ends: the point was that of the wrong one, ends that meet in two different points
    were one pair, and the parameter of the end at the seam was that of the other one.
    """
    open_curve = self_intersections(polyline((-3, 0), (0, 0), (0, 3), (-1, 3), (-1, 1), (-3, 1)), offset=1)
    ends = [(p.point, p.sides) for p in open_curve if (p.first, p.second) == (1, 4)]
    assert ends == [((0, 1), ("left", "left")), ((-1, 0), ("right", "right"))]
    closed = polyline((0, 0), (8, 0), (8, 2), (1, 2), (1, 6), (0, 6), (0, 0))
    (at_corner,) = (p for p in self_intersections(closed, offset=1) if p.first == 3)
    assert (at_corner.second, at_corner.point, at_corner.sides) == (mpq(35, 6), (1, 1), ("left", "right"))
    seam = polyline((0, 0), (3, 0), (3, -3), (-2, -3), (-2, 1), (0, 1), (0, 0))
    (at_seam,) = (p for p in self_intersections(seam, offset=-1) if p.second == 6)
    assert (at_seam.first, at_seam.point) == (mpq(9, 2), (-1, 0))


def test_a_point_of_the_offset_at_a_smooth_knot_is_one():
    """Listed twice: at a seam, and where the offset has a cusp on one side of the knot alone."""
    corners, double = [(3, 1), (0, 4), (-4, 0), (0, -4), (3, -1)], [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 5]
    middles = [(3, 0), (2, 2), (-2, 2), (-2, -2), (2, -2), (3, 0)]
    points = [p for pair in zip(middles, corners, strict=False) for p in pair] + [middles[-1]]
    rounded = self_intersections(Nurbs(2, double, points), offset=3)
    assert [(p.second, p.at_knot) for p in rounded if p.first == 0] == [(mpq(k, 2), (True, False)) for k in (3, 5, 7)]
    points = [(-1, 1), ("-1/2", 0), (0, 0), ("1/4", 0), ("1/2", 0), ("1/2", "1/2"), ("1/2", 1)]
    (found,) = self_intersections(Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 3, 3, 3], points), offset="1/2")
    assert (found.first, found.second, found.multiplicity, found.point) == (1, mpq(5, 2), 1, (0, mpq(1, 2)))


def test_without_an_offset_and_what_is_left_out():
    loop = bezier((0, 0), (3, 3), (-2, 3), (1, 0))
    assert self_intersections(loop) == self_intersections(loop, offset=0)
    circle = example("circle")
    assert self_intersections(circle, offset="1/2").undecided == ()
    assert "single point" in self_intersections(circle, offset=1).undecided[0]
    assert "without a tangent" in self_intersections(example("cusp"), offset=1).undecided[0]
    assert len(analyse(loop).offset_cusps(1)) == 2  # cusps are another question
    with pytest.raises(ShapeError):
        self_intersections(example("twisted_cubic"), offset=1)


@pytest.mark.parametrize(
    ("distances", "dial"),
    [((1, 1), "small"), ((1, -1), "small"), ((mpq(1, 2), mpq(-3, 2)), "doubles"), ((2, 0), "doubles")],
)
def test_offsets_of_two_curves_meet_as_polygons_do(distances, dial):
    """There was no door for the common points of the offsets of two curves (OCCT#305: one of two was missed)."""
    random = Random(f"B {distances}")
    first, second = drawn(random, dial, 2), drawn(random, dial, 3)
    found = intersections(first, second, offset=distances)
    assert found.undecided == ()
    polygons = [polygon(curve, float(d), 200) for curve, d in zip((first, second), distances, strict=True)]
    assert len(found) == crossings_of(*polygons)
    for point in found:
        places = zip((first, second), (point.first, point.second), distances, strict=True)
        there = [_offset(curve, t, mpq(d)) for curve, t, d in places]
        assert all(abs(float(x) - y) < 1e-9 for each in there for x, y in zip(point.point, each, strict=True))
    exchanged = intersections(second, first, offset=distances[::-1])
    pairs = sorted((p.second, p.first, p.multiplicity) for p in exchanged)
    assert pairs == [(p.first, p.second, p.multiplicity) for p in found]


def test_offsets_of_two_ellipses_meet_in_both_points():
    """Two arcs of ellipses side by side, as in OCCT#305: their outer offsets meet above and below."""
    arcs = [example("ellipse").transform([["1641/1000", 0, x], [0, "3224/1000", -4]]) for x in (-10, -3)]
    assert intersections(*arcs).points == ()
    upper, lower = sorted((p.point for p in intersections(*arcs, offset=-1)), key=lambda p: -float(p[1]))
    assert upper[0] == lower[0] == mpq(-13, 2)
    assert upper[1] + lower[1] == -8


def test_offsets_that_touch_on_a_common_normal_or_run_along_each_other():
    line, far, back = (polyline((0, y), (x, y)) for x, y in ((4, 0), (4, 3), (-4, 3)))
    arch = bezier((0, 4), (2, 0), (4, 4))  # its lowest point is (2, 2)
    assert intersections(line, arch, offset=(1, -1)).points[0].point == (2, 1)
    assert intersections(line, arch.reverse(), offset=1).points[0].point == (2, 1)
    assert intersections(line, arch, offset=("1/2", -1)).points == ()
    assert intersections(line, far, offset=1) == intersections(line, far, offset=(1, "1/2"))
    assert "along each other" in intersections(line, far, offset=(1, -2)).undecided[0]
    assert "along each other" in intersections(line, back, offset=(1, 2)).undecided[0]
    corner = intersections(polyline((0, 0), (4, 0), (4, 4)), polyline((0, 2), (9, 2)), offset=(1, 0))
    assert [(p.first, p.second, p.point) for p in corner] == [(mpq(3, 2), mpq(1, 3), (3, 2))]
    with pytest.raises(ShapeError, match="offsets need curves in the plane"):
        intersections(example("twisted_cubic"), example("twisted_cubic"), offset=1)
    with pytest.raises(ShapeError, match="3 offsets"):
        intersections(line, far, offset=(1, 2, 3))


def test_offsets_of_curves_with_an_arc_in_common():
    """They were left out without a word: a curve and itself, a part of it, a curve that is covered twice."""
    parabola = bezier((-2, 4), (0, -4), (2, 4))
    for other, distances in (
        (parabola, (1, 1)),
        (parabola.restrict("1/4", 1), ("1/3", "1/3")),
        (parabola.restrict("1/4", 1).reverse(), (1, -1)),
    ):
        assert "along each other" in intersections(parabola, other, offset=distances).undecided[0]
    twice = Nurbs(3, [0] * 4 + [1] * 3 + [2] * 4, [(0, 0), (4, 0), (0, 4), (0, 0), (4, 0), (0, 4), (0, 0)])
    assert "along each other" in self_intersections(twice, offset="1/5").undecided[0]


def test_offsets_on_both_sides_of_an_arc_in_common():
    parabola = bezier((-2, 4), (0, -4), (2, 4))
    retraced = Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 2], [(-2, 4), (0, -4), (2, 4), (0, -4), (-2, 4)])
    assert self_intersections(retraced).everywhere
    (only,) = self_intersections(parabola, offset="5/4")
    (still,) = self_intersections(retraced, offset="5/4")
    assert (still.first, still.second) == (only.first, only.second)
    assert intersections(parabola, parabola.reverse(), offset="1/3") == intersections(
        parabola, parabola, offset=(3, -1)
    )
    halves = parabola.restrict(0, "1/2"), parabola.restrict("1/2", 1)
    (joint,) = intersections(*halves, offset="1/3")
    assert (joint.first, joint.second, joint.point) == (mpq(1, 2), mpq(1, 2), (0, mpq(1, 3)))
    (joint,) = intersections(halves[0], halves[1].reverse(), offset=("1/3", "-1/3"))
    assert (joint.first, joint.second, joint.point) == (mpq(1, 2), 1, (0, mpq(1, 3)))
    assert intersections(parabola.restrict(0, "1/3"), halves[1], offset="1/3").points == ()


def test_offsets_of_arcs_of_one_circle():
    circle = example("circle")
    assert not intersections(circle.restrict(0, 1), circle.restrict(2, 3), offset="1/2")  # nothing left out, either
    assert not intersections(circle, circle.transform([[2, 0, 0], [0, 2, 0]]), offset=("-1/3", "1/3"))
    line = polyline((0, 0), (4, 0))
    assert not intersections(line, line.restrict("1/3", 1).reverse(), offset=1)
    for other, distances in (
        (circle.restrict(1, 2), ("1/2", "1/2")),
        (circle.restrict("1/2", 2), ("1/2", "1/2")),
        (circle.transform([[2, 0, 0], [0, 2, 0]]), ("-1/2", "1/2")),
        (circle.restrict(1, 2), (1, "1/2")),
        (circle.restrict(1, 2), (1, 1)),
    ):
        assert intersections(circle.restrict(0, 1), other, offset=distances).undecided
