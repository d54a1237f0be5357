"""A sweep through the certified filter: the lines are those of exact arithmetic; what is rational is never told
irrational; and the summary says what the filter could decide.
"""

import json
import os
import random
from collections import Counter
from pathlib import Path

import pytest
from flint import fmpz_poly
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

import exactspline as xs
from exactspline import Family, Nurbs
from exactspline.batch import backends, inspections, sweep
from exactspline.batch.corpus import items
from exactspline.batch.lines import Summary, Way
from exactspline.batch.results import JsonLines
from exactspline.batch.sweep import Where, Work, sweep_into_file
from exactspline.geometry.analysis import curves as analysis
from exactspline.polynomials.elimination import without_rational_zero
from exactspline.polynomials.isolation import LocalPolynomial
from exactspline.programs import accelerator
from tests.geometry.test_filtered_splines import troubled

pytestmark = pytest.mark.skipif(accelerator.filter_curve is None, reason="without a compiler all is exact")
SHARED = Path(os.environ.get("EXACTSPLINE_CURVES", Path(__file__).resolve().parents[3] / "shared" / "curves")).parent


def exact_lines(curves, **how):
    """The lines by exact arithmetic alone; curves are made anew, since they keep what is known of them."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(analysis, "certain", lambda facts: None)
        made = [Nurbs(c.degree, c.knots, c.control_points, c.weights) if isinstance(c, Nurbs) else c for c in curves]
        return [Work.of(**how).line(item) for item in items(made)]


def same_lines(curves, **how):
    """Hold the lines against those of exact arithmetic: how the curves were decided."""
    lines = list(Work.of(**how).lines(list(items(curves))))
    for line, other in zip(lines, exact_lines(curves, **how), strict=True):
        assert line.found == other.found
        assert line.error == other.error
    return Counter(line.way for line in lines)


# ---- the same lines


@pytest.mark.parametrize("digits", [0, 3, 12, 40])
def test_any_number_of_digits(digits):
    family = Family.parsed("degree=3-5 segments=1-2 rational=half count=40 seed=12")
    assert same_lines([family], digits=digits)[Way.DECIDED] > 35


@pytest.mark.parametrize("seed", range(2))
def test_troubled_curves_and_everything_that_can_be_looked_for(seed):
    chance = random.Random(seed)
    ways = same_lines([troubled(chance) for _ in range(40)], find=["all"])
    assert ways[Way.DECIDED] > 3
    assert ways[Way.EXACT] > 4


#: Curves with rational zeros (at 1/2, 1/3, at a knot by a jump), cusps, zeros that nearly coincide, straight pieces,
#: weights of any sign and zero, numbers and breakpoints of any size.
HOSTILE = {
    "inflection at 1/2": ([(0, 0), (1, 2), (2, -2), (3, 0)], None),
    "extremum at 1/2": ([(0, 0), (1, 3), (4, 3), (5, 0)], None),
    "inflection at 1/3": ([(0, 0), (1, 0), (2, -1), (3, 0)], None),
    "rational, symmetric": ([(0, 0), (1, 2), (2, 2), (3, 0)], [1, 3, 3, 1]),
    "vertex of a parabola": ([(0, 0), (1, 5), (7, 1)], None),
    "cusp": ([(0, 0), (1, 1), (0, 1), (1, 0)], None),
    "all but a cusp": ([(0, 0), (10**9, 10**9), (1, 10**9), (10**9, 0)], None),
    "straight": ([(0, 0), (1, 1), (2, 2), (5, 5)], None),
    "all but straight": ([(0, 0), (1, 1), (2, 2), (5, mpq(5 * 10**12 + 1, 10**12))], None),
    "circle": ([(1, 0), (1, 1), (0, 1)], [1, 1, 2]),
    "negative weights": ([(0, 0), (1, 2), (2, -2), (3, 1)], [-1, -2, -3, -1]),
    "a weight of 0": ([(0, 0), (1, 2), (2, -2), (3, 1)], [1, 0, 3, 1]),
    "huge": ([(0, 0), (mpq(10) ** 400, 2), (2 * mpq(10) ** 400, -3), (3, mpq(10) ** 401)], None),
    "tiny": ([(0, 0), (mpq(1, 10**400), 2), (mpq(2, 10**400), -3), (3, mpq(1, 10**401))], None),
}


@pytest.mark.parametrize("name", HOSTILE)
@pytest.mark.parametrize("ends", [(0, 1), (mpq(-1, 3), mpq(1, 7)), (10**30, 10**30 + 1), (0, mpq(1, 10**30))])
def test_hostile_curves_of_one_segment(name, ends):
    points, weights = HOSTILE[name]
    knots = [t for t in ends for _ in points]
    same_lines([Nurbs(len(points) - 1, knots, points, weights)], find=["all"])


def test_parameters_that_are_rational_are_exact():
    curves = [Nurbs(3, [0] * 4 + [1] * 4, HOSTILE[f"inflection at {t}"][0]) for t in ("1/2", "1/3")]
    lines = list(Work.of(["inflections"]).lines(list(items(curves))))
    assert [[each.parameter for each in line.found["inflections"]] for line in lines] == [["1/2"], ["1/3"]]
    assert {line.way for line in lines} == {Way.DECIDED}


def test_a_jump_at_a_knot_is_at_the_knot():
    # κ of the quadratic changes its sign where two arcs meet
    curve = Nurbs(2, [0, 0, 0, mpq(1, 3), 1, 1, 1], [(0, 0), (1, 2), (2, 0), (3, 3)])
    (line,) = Work.of(["inflections"]).lines(list(items([curve])))
    assert [each.parameter for each in line.found["inflections"]] == ["1/3"]
    assert line.way is Way.DECIDED
    same_lines([curve])


@pytest.mark.parametrize("dimension", [2, 3])
def test_polygons_have_no_curvature(dimension):
    chance = random.Random(dimension)
    for k in range(40):
        inner = [t for t in range(1, 6) for _ in range(chance.choice([1, 1, 2]))]
        steps = [tuple(chance.randint(-1, 1) for _ in range(dimension)) for _ in range(len(inner) + 2)]
        points = steps[:-1] + steps[:1] if k % 2 else steps
        weights = chance.choice([None, [chance.randint(1, 3) for _ in points]])
        curve = Nurbs(1, [0, 0, *inner, 6, 6], points, weights)
        for name in ("inflections", "curvature_extrema", "critical_points"):
            found = inspections.inspected(curve, [name], 3)[name]
            pieces = [(str(piece.start), str(piece.end)) for piece in xs.analyse(curve).straight_pieces]
            assert [(each.kind, each.low, each.high) for each in found] == [("everywhere", *ends) for ends in pieces]


def test_examples_and_curves_in_space():
    """Before: an example that had been asked for the same before was not counted as decided."""
    ways = same_lines(xs.examples("curves"), find=["all"])
    assert ways == Counter(line.way for line in Work.of(["all"]).lines(list(items(xs.examples("curves")))))
    assert ways[Way.DECIDED] > 2
    assert ways[None] >= sum(xs.example(name).dimension == 3 for name in xs.examples("curves")) > 0


@pytest.mark.skipif(not SHARED.is_dir(), reason="no folder of real curves at hand")
@pytest.mark.parametrize("folder", ["curves", "files"])
def test_curves_of_others(folder):
    given = [item.given for item in items([str(SHARED / folder)]) if isinstance(item.given, Nurbs)]
    small = [curve for curve in given if curve.segments * curve.degree**3 < 1000]
    bent = [curve for curve in small if curve.dimension == 2 and curve.degree > 2]
    assert len(bent) > 10
    ways = same_lines([*bent[:100], *small[:100]])
    assert ways[Way.DECIDED] + ways[Way.EXACT] >= min(len(bent), 100)


# ---- what the tests here would see


def test_a_filter_that_calls_a_rational_parameter_irrational_would_be_seen(monkeypatch):
    points, _ = HOSTILE["inflection at 1/3"]
    exact = exact_lines([Nurbs(3, [0] * 4 + [1] * 4, points)])
    monkeypatch.setattr(LocalPolynomial, "without_rational_zero", True)
    (line,) = Work.of().lines(list(items([Nurbs(3, [0] * 4 + [1] * 4, points)])))
    assert line.found != exact[0].found


# ---- forms without a rational zero


def times(*factors):
    """The product of polynomials, constant terms first."""
    product = [1]
    for factor in factors:
        made = [0] * (len(product) + len(factor) - 1)
        for i, a in enumerate(product):
            for j, b in enumerate(factor):
                made[i + j] += a * b
        product = made
    return product


@given(
    st.lists(st.integers(-(10**30), 10**30), min_size=1, max_size=8),
    st.integers(-(10**20), 10**20),
    st.integers(1, 10**20),
)
def test_a_form_with_a_rational_zero_is_never_told_to_have_none(others, r, s):
    assert not without_rational_zero(fmpz_poly(times(others, [-r, s])))


def test_zeros_modulo_every_prime_say_nothing():
    assert without_rational_zero(fmpz_poly([-2, 0, 1]))
    assert not without_rational_zero(fmpz_poly(times([-2, 0, 1], [-3, 0, 1], [-6, 0, 1])))


def test_a_curve_whose_form_has_zeros_modulo_every_prime_is_computed_exactly():
    # κ vanishes where ∫∫ of the form does: the curve (t, F) with F″ = (t² − 2)(t² − 3)(t² − 6), over [1, 2]
    second = times([-2, 0, 1], [-3, 0, 1], [-6, 0, 1])
    height = [0, 0, *(mpq(c, (k + 1) * (k + 2)) for k, c in enumerate(second))]
    t = xs.BSpline.identity(1, 2)
    one = t.constant(1)
    value = one * 0
    for c in reversed(height):
        value = value * t + one * c
    curve = Nurbs.from_splines([t, value])
    (line,) = Work.of(["inflections"]).lines(list(items([curve])))
    assert [(each.parameter, each.low) for each in line.found["inflections"]] == [
        (None, "1.4142135623"),
        (None, "1.7320508075"),
    ]
    assert line.way is Way.DECIDED
    same_lines([curve], find=["inflections"])


# ---- groups, kills, counts


def test_groups_grow_and_are_bounded_by_the_work_in_them():
    def sizes(count, each, jobs=1):
        seen = []
        list(backends.mapped(lambda group: seen.append(len(group)) or group, range(count), "serial", jobs, "", each))
        return seen

    assert sizes(2000, lambda _: 1) == [16, 48, 192, 512, 512, 512, 208]
    assert sizes(40, lambda _: backends.HEAVY) == [1] * 40
    assert sizes(40, lambda _: backends.ALONE) == [1] * 40
    assert sizes(200, lambda _: backends.ALONE - 1) == [16, *[17] * 10, 14]
    assert sizes(10, lambda i: backends.ALONE * (i == 3)) == [4, 6]


def test_curves_that_take_long_are_sent_few_at_a_time():
    def weights(*words, **how):
        return [Work.of(**how).weight(item) for item in items([Family.parsed(each) for each in words])]

    heavy, light, space = weights("degree=60 segments=9 count=1", "degree=3 count=1", "degree=3 dimension=3 count=1")
    few = backends.ALONE
    assert heavy > backends.HEAVY > 512 * light
    assert space == few
    for how in ({"find": ["self_intersections"]}, {"find": ["cusps_within:1/10"]}, {"claims": ["C4.1a"]}):
        assert weights("degree=3 count=1", **how) == [few]
    assert Work.of().weight(next(items(["nothing"]))) == few


def test_a_bad_curve_in_a_group_is_a_line_and_the_others_are_whole():
    jumping = Nurbs(2, [0, 0, 0, 1, 1, 1, 2, 2, 2], [(0, 0), (1, 1), (2, 0), (5, 5), (6, 6), (7, 5)])
    lines = list(xs.sweep([xs.example("cubic_s"), "no_such_file", jumping, Nurbs(1, [0, 0, 1, 1], [(0,) * 4] * 2)]))
    assert [line.error and line.error.kind for line in lines] == [None, "CurveFileError", None, "ShapeError"]
    assert len(lines[0].found["curvature_extrema"]) == 2
    assert [line.index for line in lines] == [0, 1, 2, 3]


def counts(summary):
    return {entry.name: entry.count for entry in summary.entries() if entry.what == "filter"}


def test_a_sweep_continued_anywhere_has_the_same_lines_and_counts_what_it_computed(tmp_path):
    family, place = Family.parsed("degree=2-4 rational=half count=150 seed=14"), tmp_path / "lines.jsonl"

    def record(path):
        summary = Summary()
        sweep_into_file([family, "no_such_file"], Work.of(), Where("serial"), str(path), summary)
        return counts(summary)

    whole = record(place)
    assert sum(whole.values()) == 150
    assert whole["decided in doubles"] > 140
    expected = [json.loads(text) | {"seconds": 0} for text in place.read_text().splitlines()]
    text = place.read_bytes()
    ends = [i + 1 for i, byte in enumerate(text) if byte == ord("\n")]
    for done in (1, 16, 77, 150, 151):
        place.write_bytes(text[: ends[done - 1]])
        found = record(place)
        assert found["computed before"] == done
        assert sum(found.values()) == max(150, done)
        assert [json.loads(text) | {"seconds": 0} for text in place.read_text().splitlines()] == expected
    with JsonLines(place, json.loads(Path(f"{place}.settings.json").read_text())) as results:
        assert {line.way for line in results.existing()} == {None}


def test_what_the_filter_said_comes_back_from_other_processes(monkeypatch):
    monkeypatch.setattr(backends, "FEW", 0)
    given = [Family.parsed("degree=3 count=300 seed=15"), "rational_space_cubic"]
    here, there = (list(xs.sweep(given, backend="processes", jobs=jobs)) for jobs in (1, 2))
    assert here == there
    assert Counter(line.way for line in there)[Way.DECIDED] > 200


def test_without_the_extension_all_is_exact_and_the_summary_says_so(monkeypatch):
    family = Family.parsed("degree=3 count=20 seed=16")
    expected = list(xs.sweep(family))
    monkeypatch.setattr(accelerator, "filter_curve", None)
    monkeypatch.setattr(sweep, "filter_curve", None)
    summary, lines = Summary(), list(xs.sweep(family))
    for line in lines:
        summary.add(line)
    assert lines == expected
    assert counts(summary) == {Way.MISSING: 20}
