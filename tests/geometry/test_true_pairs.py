"""The trimmed bisector of two plane curves, held against distances that are computed in doubles."""

from collections import Counter
from itertools import pairwise, product
from random import Random

import numpy as np

import exactspline as xs
from exactspline import zeros
from exactspline.errors import ReachError
from exactspline.geometry.bisectors import plane_curves
from exactspline.geometry.bisectors.system import piece
from exactspline.numbers.exact import sign
from exactspline.numbers.intervals import UNIT, Box, Interval
from exactspline.polynomials.patch_forms import PatchForm
from tests.support.bisector_oracle import bezier
from tests.support.dials import over_dials
from tests.support.vectors import dot


def is_in(boxes, s, t):
    return any(box.first.low <= s <= box.first.high and box.second.low <= t <= box.second.high for box in boxes)


def distance(curve, point):
    """By de Casteljau's algorithm at many parameters, and around the nearest of them."""

    def at(t):
        rows = [np.array([float(x) * float(w) for x in p] + [float(w)])[:, None] + 0 * t for p, w in control]
        while len(rows) > 1:
            rows = [a * (1 - t) + b * t for a, b in pairwise(rows)]
        return np.hypot(*(rows[0][:2] / rows[0][2] - np.array(point, dtype=float)[:, None]))

    control, low, high = list(zip(curve.control_points, curve.weights, strict=True)), 0.0, 1.0
    for _ in range(6):
        t = np.linspace(low, high, 401)
        k = int(np.argmin(at(t)))
        low, high = t[max(k - 1, 0)], t[min(k + 1, 400)]
    return float(np.min(at(t)))


@over_dials
def test_pairs_are_kept_where_no_point_is_nearer(number):
    random, seen = Random(3), set()
    for degrees in ((1, 2), (2, 2), (3, 2), (2, 3)):
        first, second = (
            bezier(
                *[(number(random), number(random)) for _ in range(n + 1)], weights=random.choices((1, 2, 3), k=n + 1)
            )
            for n in degrees
        )
        found = xs.bisector(first, second)
        for s in (xs.rational(random.randint(1, 99)) / 100 for _ in range(4)):
            for root in zeros(found.function.at_s(s)):
                try:
                    point = [float(x) for x in found.point(s, root)]
                except ReachError:  # a curve has no tangent there
                    continue
                radius = np.hypot(*(np.array(point) - [float(x) for x in first(s)]))
                nearer = min(distance(curve, point) for curve in (first, second)) < radius * (1 - 1e-9)
                if not is_in(found.trimmed.undecided, s, root):
                    assert is_in(found.trimmed.kept, s, root) is not nearer
                    seen.add(nearer)
    assert seen == {True, False}


def test_the_axis_of_a_lens():
    """Between y = 1 − x² and y = x² − 1 a point (2x³ − x, 0) has its feet at x where x² ≥ 1/2: the centre is nearer to
    four points than to the two apexes. Behind each other the parabolas have all their feet.
    """
    inside = xs.bisector(bezier((-1, 0), (0, 2), (1, 0)), bezier((-1, 0), (0, -2), (1, 0))).trimmed
    places = [xs.rational(k) / 10 for k in range(1, 10)]
    assert [is_in(inside.kept, s, s) for s in places] == [(2 * s - 1) ** 2 >= 0.5 for s in places]
    assert not any(is_in(inside.undecided, s, s) for s in places)
    outside = xs.bisector(bezier((-1, 2), (0, 0), (1, 2)), bezier((-1, -2), (0, 0), (1, -2))).trimmed
    assert all(is_in(outside.kept, s, s) for s in (xs.rational(k) / 7 for k in range(1, 7)))


def test_a_point_of_another_segment_is_nearer():
    """The line y = 0 and y = 4 have all their pairs (s, s), until the second one comes down again."""
    line, bent = bezier((-4, 0), (4, 0)), xs.Nurbs(1, [0, 0, 1, 2, 2], [(-4, 4), (4, 4), (1, 2)])
    found = xs.bisector(line, bent)
    kept = [is_in(found.trimmed.kept, s, s) for s in map(xs.rational, ("1/16", "1/8", "1/2", "7/8"))]
    assert kept == [True, True, False, False]
    assert found.pairs.lines == ()


def test_next_to_a_point_without_a_tangent_pairs_are_decided():
    """The parabola stands still at its end (0, 1): all pairs (0, t) are zeros of the function, and no pairs of feet."""
    first, line = bezier((0, 1), (0, 1), (4, 3)), bezier((-1, 0), (4, 0))
    found = xs.bisector(first, line)
    assert [own.value for own in found.pairs.lines] == [0]
    assert found.trimmed.undecided == ()
    for s in map(xs.rational, ("1/4", "1/2", "3/4")):
        (t,) = zeros(found.function.at_s(s))
        assert is_in(found.trimmed.kept, s, t)


def test_a_point_instead_of_a_curve_is_undecided():
    standing, line = xs.Nurbs(1, [0, 0, 1, 2, 2], [(0, 1), (0, 1), (3, 2)]), bezier((0, 0), (4, 0))
    found = xs.bisector(standing, line).trimmed
    assert found.kept
    assert [box for box in found.undecided if box.first == (0, 1)] == [((0, 1), (0, 1))]


def test_what_is_not_looked_at_is_undecided(monkeypatch):
    """The work grows with the number of segments, not of their pairs."""
    monkeypatch.setattr(plane_curves, "BOXES", 30)
    knots = [0, *range(9), 8]
    curves = [xs.Nurbs(1, knots, [(i, y + i % 2) for i in range(9)]) for y in (0, 5)]
    found = plane_curves.true_pairs(*curves)
    assert not found.kept
    assert ((7, 8), (7, 8)) in found.undecided


def as_numbers(curve, t):
    """A point of a curve and w² times its derivative, from its control points, in rational numbers."""
    rows = [[*(x * w for x in p), w] for p, w in zip(curve.control_points, curve.weights, strict=True)]
    n, rows = len(rows) - 1, [[xs.rational(x) for x in row] for row in rows]
    while len(rows) > 2:
        rows = [[x * (1 - t) + y * t for x, y in zip(a, b, strict=True)] for a, b in pairwise(rows)]
    (*p, w), (*q, v) = rows
    at = [(x * (1 - t) + y * t) / (w * (1 - t) + v * t) for x, y in zip(p, q, strict=True)]
    return at, [n * (y * w - x * v) for x, y in zip(p, q, strict=True)]


def difference(a, b):
    return [a[0] - b[0], a[1] - b[1]]


def centre(point, tangent, other):
    """The point on the normal that is equally far from both points."""
    chord, normal = difference(other, point), [-tangent[1], tangent[0]]
    by = dot(chord, chord) / (2 * dot(chord, normal))
    return [x + by * y for x, y in zip(point, normal, strict=True)]


def nearer(middle, x, foot):
    """The sign of the square of the distance of a point less that of the foot."""
    a, b = difference(x, middle), difference(foot, middle)
    return sign(dot(a, a) - dot(b, b))


def test_forms_have_the_signs_of_differences_of_distances():
    """Whether a point of the curve is nearer than the foot, for all its segments and any pair of parameters."""
    random, seen = Random(8), set()
    for weights in (None, [2, 1, 3], [xs.rational("-1/2"), xs.rational("-1/3"), -1]):
        one, two, other = (
            bezier(
                *[(random.randint(-9, 9), random.randint(-9, 9)) for _ in range(n)], weights=weights if n == 3 else None
            )
            for n in (3, 3, 4)
        )
        segments = [piece(curve, 0) for curve in (one, two)]
        foot = plane_curves._Foot(segments, 0, piece(other, 0))
        for _ in range(12):
            s, t, u = (xs.rational(random.randint(1, 96)) / 97 for _ in range(3))
            point, tangent = as_numbers(one, s)
            middle, side = centre(point, tangent, as_numbers(other, t)[0]), foot.factors[0].value(s, t)
            compared = [as_numbers(curve, xs.rational("1/2"))[0] for curve in (one, two)]
            for form, x in zip(foot.against[1:], compared, strict=True):
                assert sign(form.value(s, t)) * sign(side) == nearer(middle, x, point)
                seen.add(sign(form.value(s, t)))
            for (sides, (square, twice)), curve in zip(foot.families, (one, two), strict=True):
                assert sides == (0, 1)
                value = square.value(s, u) * side - twice.value(s, u) * foot.factors[1].value(s, t)
                assert sign(value) * sign(side) == nearer(middle, as_numbers(curve, u)[0], point)
            # the first one: whether points at the foot itself are nearer
            step = xs.rational(1) / 10**9
            around = [nearer(middle, as_numbers(one, s + by)[0], point) for by in (step, -step)]
            assert around == [sign(foot.against[0].value(s, t)) * sign(side)] * 2
    assert seen == {1, -1}


def test_what_is_said_of_a_box_is_true_and_small_boxes_are_decided():
    """Of forms with any signs: N A − C M for N ≥ 0 and M over s and u, A and C over s and t."""
    random, told = Random(2), Counter()
    for _ in range(40):
        a, c, m = (PatchForm.of_net([[random.randint(-9, 30) for _ in "ab"] for _ in "abc"]) for _ in range(3))
        n = PatchForm.of_net([[random.randint(0, 30) for _ in "ab"] for _ in "abc"])
        for bits in (1, 3, 6):
            width = xs.rational(1) / 2**bits
            first, t = (Interval(k * width, (k + 1) * width) for k in (random.randrange(2**bits) for _ in range(2)))
            across, along = a.part(Box(first, t)), c.part(Box(first, t))
            if not (side := across.sign):
                continue
            places = [(first.at(x), t.at(y)) for x, y in product((0, xs.rational("1/2"), 1), repeat=2)]
            least = min(
                side * (n.value(x, u) * a.value(x, y) - c.value(x, y) * m.value(x, u))
                for x, y in places
                for u in (xs.rational(k) / 8 for k in range(9))
            )
            verdict = plane_curves.verdict_on(side, across, along, [n, m], first, UNIT.second)
            assert verdict is (least >= 0) or verdict is None
            told[bits, verdict] += 1
    assert told[6, None] <= 1
    nothing = PatchForm.of_net([[0, 0]])
    assert plane_curves.verdict_on(1, PatchForm.of_net([[1, 2]]), nothing, [nothing, nothing], *UNIT) is True
    assert min(told[bits, verdict] for bits in (3, 6) for verdict in (True, False)) >= 4


def test_a_nearer_point_is_found_on_a_short_part():
    """2 (64 u − 1)² − 1 is negative between u = 0 and u = 1/32 alone, and positive at both."""
    one, forms = PatchForm.of_net([[1]]), [PatchForm.of_net([[2, -126, 7938]]), PatchForm.of_net([[1, 1, 1]])]
    assert plane_curves.verdict_on(1, one, one, forms, *UNIT) is False


def test_no_point_beyond_the_end_of_a_segment_is_compared():
    """N A − C M is positive up to the end, and negative just behind it."""
    across, along = PatchForm.of_net([[100, 105]]), PatchForm.of_net([[100, 102]])
    forms = [PatchForm.of_net([[3300, 100]]), PatchForm.of_net([[99, 99]])]
    assert plane_curves.verdict_on(1, across, along, forms, *UNIT) is None


def test_the_work_of_one_pair_is_bounded(monkeypatch):
    parabola, other = bezier((-1, 0), (0, 2), (1, 0)), bezier((-1, 0), (0, -2), (1, 0))
    monkeypatch.setattr(plane_curves, "BOXES", 0)
    assert plane_curves.true_pairs(parabola, other).undecided == (UNIT,)
    monkeypatch.setattr(plane_curves, "BOXES", 100)
    found = plane_curves.true_pairs(parabola, other)
    assert 2 < len(found.undecided) < 100
    assert max(box.first.width for box in found.undecided) > xs.rational(1) / 2**6
    monkeypatch.undo()
    monkeypatch.setattr(plane_curves, "DEPTH", 7)
    found = plane_curves.true_pairs(parabola, other)
    assert {(box.first.width, box.second.width) for box in found.undecided} == {
        (xs.rational("1/16"), xs.rational("1/8"))
    }


def test_no_pair_of_segments_uses_up_what_is_there_for_all(monkeypatch):
    """Passed before: most pairs of a circle and an ellipse were not looked at, after the first had used up the work."""
    monkeypatch.setattr(plane_curves, "BOXES", 2000)
    found = plane_curves.true_pairs(xs.example("circle"), xs.example("ellipse"))
    assert found.kept
    assert max(box.first.width * box.second.width for box in found.undecided) <= xs.rational("1/16")
