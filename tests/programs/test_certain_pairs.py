"""Pairs of segments that the extension decides: as exact arithmetic decides them, in every rounding mode, with numbers
of any size; and the answers are the same without it.
"""

import os
import pickle
import subprocess
import sys
from contextlib import nullcontext
from fractions import Fraction
from operator import itemgetter
from random import Random

import pytest
from gmpy2 import mpq

from exactspline import Nurbs, intersections
from exactspline.geometry.pairs import lazy_intersections as late_meetings
from exactspline.numbers.intervals import UNIT
from exactspline.polynomials.plane_pairs import self_meetings
from exactspline.programs.certain_pairs import ARCH as PARABOLA
from exactspline.programs.certain_pairs import (
    EVERYWHERE,
    HIGHEST,
    LINE,
    certain_pair,
    closer,
    filter_pair,
    points_of,
    precise_table_of,
    segment_in_doubles,
    table_of,
)
from exactspline.roots.segment_forms import parameter, plane_forms, segment_rows
from tests.campaigns import certain_pairs as campaign
from tests.support.paths import plain_python
from tests.support.rounding import FLUSHED, MODES, rounding
from tests.support.sampled import FULL

needs_extension = pytest.mark.skipif(filter_pair is None, reason="there is no extension here")
WAVE = Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (1, 3), (2, -3), (3, 1)])
ARCH = Nurbs(3, [0] * 4 + [1] * 4, [(0, -1), (1, 2), (2, 2), (3, -1)])


@needs_extension
def test_what_is_certain_is_what_exact_arithmetic_decides():
    made, decided, _, wrong = campaign.campaign(3300 if FULL else 1650, 5)
    assert wrong == []
    assert campaign.below_floor(made, decided) == []


@needs_extension
@pytest.mark.parametrize("mode", [*MODES, *FLUSHED])
def test_answers_do_not_depend_on_the_rounding_of_the_processor(mode):
    def decide(*given):
        with rounding(mode):
            return certain_pair(*given)

    made, decided, _, wrong = campaign.campaign(330, 11, decide)
    assert wrong == []
    assert decided["cubics"] == made["cubics"]


@needs_extension
@pytest.mark.parametrize("mode", [*MODES, *FLUSHED])
def test_parameters_are_known_to_twice_the_precision_where_the_processor_rounds_to_nearest(mode):
    """Nearly all of them; in the other modes exact arithmetic decides."""
    chance, known, some = Random(6), 0, 0
    for _ in range(100):
        given = [segment_rows(campaign.pairs.curve(rows), 0) for rows in campaign.cubics(chance)]
        table, precise = table_of(given), precise_table_of(given, [0, 1, 2])
        for point in points_of(certain_pair(table, 0, table, 1) or []):
            with rounding(mode):
                near = closer(precise, 0, precise, 1, point[:4])
            known += len(near) == 8 and max(near[2], near[6]) < 2**-75
            some += 1
    assert known == (some if mode in ("nearest", *FLUSHED) else 0)
    assert some > 50


@needs_extension
def test_a_box_without_a_common_point_has_none():
    """Beside it, or where the curves only touch; and numbers that are too large or of too high degree."""
    other, large = [(1, [(x, 6), (y, y), (2, 2)]) for x, y in ((0, 4), (10**200, 3))]
    lines, table = precise_table_of([LINE, other, large], range(4)), precise_table_of([PARABOLA], range(2))
    box = (1 / 6 - 2**-30, 1 / 6 + 2**-30, 1 / 4 - 2**-30, 1 / 4 + 2**-30)
    assert closer(lines, 0, table, 0, box)
    assert closer(lines, 0, table, 0, [x + 2**-20 for x in box]) == ()
    assert closer(lines, 1, table, 0, (0.3, 0.4, 0.4, 0.6)) == ()
    assert closer(lines, 2, table, 0, box) == ()
    n = HIGHEST + 1
    assert closer(precise_table_of([(n, [(1,) * (n + 1)] * 3)], [0, 1]), 0, table, 0, box) == ()
    for ends, first in (((0, 1), 10**400), ((0, 10**400), 0)):
        open_table = precise_table_of([(1, [(first, 6), (3, 3), (2, 2)])], ends)
        assert closer(open_table, 0, table, 0, box) == closer(table, 0, open_table, 0, box) == ()


@pytest.mark.parametrize("places", [(0, 1), (mpq(1, 3), mpq(9, 7)), (-(10**20), 10**20 + 1)])
def test_doubles_of_parameters_are_the_nearest(places):
    """With and without the extension, on any domain."""
    chance, found = Random(9), 0
    knots = [places[0]] * 4 + [places[1]] * 4
    for _ in range(40):
        curves = [[[*row[:2]] for row in rows] for rows in campaign.cubics(chance)]
        told = []
        for decided in (nullcontext, plain_python):
            with decided():
                points = intersections(*(Nurbs(3, knots, points) for points in curves))
                told.append([(float(point.first), float(point.second)) for point in points])
        assert told[0] == told[1]
        found += len(told[0])
    assert found > 20


@needs_extension
@pytest.mark.parametrize("size", [Fraction(1, 2**3000), Fraction(1, 2**900), Fraction(2**350), Fraction(2**1100)])
def test_numbers_of_any_size_are_decided_rightly(size):
    chance = Random(3)
    for _ in range(20):
        rows = [[(x * size, y, w) for x, y, w in one] for one in campaign.cubics(chance)]
        for own in (
            rows,
            [[(y, x, w) for x, y, w in one] for one in rows],
            [[(x, y * size, w * size) for x, y, w in one] for one in rows],
        ):
            assert campaign.differing(own)[1] == ""


@needs_extension
@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("degree", [2, 3, 4, 5, 6, 8, HIGHEST])
def test_a_segment_meets_itself_where_exact_arithmetic_says(degree, mode):
    """Coordinates from few integers, where cusps and ends lie on the curve, to many; both parameters, in order."""
    chance, decided, count = Random(degree), 0, 120 if degree < 6 else 12
    for k in range(count):
        size = (2, 9, 100, 10**6)[k % 4]
        points = [(chance.randint(-size, size), chance.randint(-size, size)) for _ in range(degree + 1)]
        curve = Nurbs.bezier(points, [chance.randint(1, 9) for _ in points] if k % 8 > 3 else None)
        row = segment_rows(curve, 0)
        with rounding(mode):
            certain = certain_pair(table_of([row]), 0, None, 0)
        if certain is None:
            continue
        found = sorted(points_of(certain), key=itemgetter(2))
        decided += 1
        true = self_meetings(plane_forms(curve, 0))
        assert not true.arcs
        assert not true.rests
        numbers = sorted([parameter(local, *UNIT) for local in (p.second, p.first)] for p in true.points)
        assert len(numbers) == len(found)
        for (t, s), one in zip(numbers, found, strict=True):
            low, high, first, last = map(mpq, (*one[2:4], *one[:2]))
            assert first < s < last < low < t < high
    assert decided > count // 2


@needs_extension
def test_each_segment_of_a_table_is_as_it_is_alone():
    chance = Random(8)
    rows = [campaign.cubics(chance) for _ in range(40)]
    given = [[segment_rows(campaign.pairs.curve(pair[k]), 0) for pair in rows] for k in (0, 1)]
    first, second = map(table_of, given)
    for i, (one, other) in enumerate(zip(*given, strict=True)):
        alone = certain_pair(table_of([one]), 0, table_of([other]), 0)
        assert (
            alone == certain_pair(first, i, second, i) == certain_pair(table_of([other, one]), 1, table_of([other]), 0)
        )


@needs_extension
def test_points_are_counted_without_the_determinant_and_are_exact_when_asked_for(monkeypatch):
    with monkeypatch.context() as patch:
        patch.setattr(late_meetings, "elimination", None)
        found = intersections(WAVE, ARCH)
        assert len(found) == 2
        first, second = found
    numbers = [x for point in found for x in (point.first, point.second)]
    assert [round(float(x), 6) for x in numbers] == [0.281049, 0.281049, 0.879295, 0.879295]
    assert first.second.enclosure(60).width <= mpq(1, 10**60)
    assert first.first == first.second < second.first == second.second  # x = 3 s on both
    assert pickle.loads(pickle.dumps(found)) == found


@pytest.mark.parametrize(
    ("other", "at"),
    [
        (Nurbs(1, [0, 0, 1, 1], [(0, 3), (6, -9)]), (mpq(1, 3), mpq(1, 6))),
        (Nurbs(2, [0] * 3 + [1] * 3, [(0, -1), ("3/2", "3/2"), (3, 7)]), (mpq(1, 3), mpq(1, 3))),
    ],
)
def test_a_rational_parameter_is_told_as_such(other, at):
    """No subdivision in doubles hits these."""
    (point,) = intersections(Nurbs(1, [0, 0, 1, 1], [(0, 0), (3, 3)]), other)
    assert (point.first.exact, point.second.exact) == at
    assert point.point == (1, 1)


def test_without_the_extension_the_answers_are_the_same():
    code = (
        "from random import Random; from exactspline import intersections; "
        "from tests.campaigns import certain_pairs as c, intersections as p; r = Random(4); "
        "told = [intersections(*map(p.curve, f(r))) for f in c.FAMILIES for _ in range(8)]; "
        "told += [intersections(*map(p.curve, f(r)[:2])) for f in p.FAMILIES.values() for _ in range(6)]; "
        "print([(t, [x.point for x in t]) for t in told]); print(c.certain_pair.__globals__['filter_pair'] is None)"
    )
    told = []
    for library in ("none", ""):
        environment = os.environ | {"EXACTSPLINE_EXTENSION": library}
        done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True)
        told.append(done.stdout.splitlines())
    assert told[0][1] == "True"
    assert told[0][0] == told[1][0]


def test_the_determinant_of_a_pair_is_primitive_and_eliminates_the_lower_degree():
    """Whichever of the two comes first; its zeros are their common points."""
    given = [segment_rows(curve.elevate_degree() if i else curve, 0) for i, curve in enumerate((WAVE, ARCH))]
    for order in (1, -1):
        form = late_meetings.PairForm(*given[::order])
        assert form.exchanged is (order == -1)
        assert form.form.polynomial.content() == 1
        assert [zero.low <= x <= zero.high for zero, x in zip(form.inner, (0.281, 0.879), strict=True)] == [True, True]


def test_coefficients_are_rounded_once():
    """Measured from a double near the curve; what has no doubles, or another degree, is left open."""
    chance = Random(12)
    for _ in range(40):
        rows = campaign.of_some_degrees(chance)[0]
        n, forms = segment_rows(campaign.pairs.curve(rows), 0)
        own = segment_in_doubles(n, forms)
        degree, *ends, x, y = own[:7]
        assert degree == n
        blocks = [own[7 + k * (n + 1) :][: n + 1] for k in range(3)]
        assert len(own) == 7 + 3 * (n + 1)
        boxed = min(forms[2]) > 0 or max(forms[2]) < 0
        for k, at in enumerate((x, y)):
            points = [Fraction(int(c), int(w)) for c, w in zip(forms[k], forms[2], strict=True)]
            assert tuple(ends[2 * k :][:2]) == ((float(min(points)), float(max(points))) if boxed else EVERYWHERE[:2])
            assert min(points) <= Fraction(at) <= max(points) or at == float(points[0])
            exact = [float(int(c) - int(w) * Fraction(at)) for c, w in zip(forms[k], forms[2], strict=True)]
            assert blocks[k] == exact
        assert blocks[2] == [float(w) for w in forms[2]]
    line, above = [(0, 3), (1, 1), (1, 1)], HIGHEST + 1
    for n, forms in ((0, [(1,)] * 3), (above, [(1,) * (above + 1)] * 3), (1, [*line, (1, 1)])):
        assert segment_in_doubles(n, forms) == (0,)
    for forms in ([(0, 3), (1, 1), (1, 0)], [(0, 10**400), (1, 1), (1, 1)]):
        assert segment_in_doubles(1, forms) == (1, *EVERYWHERE, *[0] * 8)
