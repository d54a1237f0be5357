"""An answer does not depend on how its object is written, nor on the way by which it is asked: every question of the
registry against every change, and every path. The seed goes with the day; `EXACTSPLINE_SEED` gives another one.
"""

import inspect
import os
import sys
import textwrap
import time
from collections import Counter
from dataclasses import dataclass, replace
from itertools import product
from random import Random

import pytest
from gmpy2 import mpq

from exactspline import NurbsSurface, TensorSpline, analyse
from exactspline.geometry.analysis import curves, many_curves
from exactspline.geometry.analysis.ask import REGISTRY
from exactspline.geometry.analysis.pairs import CurvePair
from exactspline.geometry.analysis.surfaces import SurfaceInspection
from exactspline.geometry.curves.kinds import FeatureKind
from exactspline.geometry.pairs import nearest as nearest_points
from exactspline.interchange.examples import example
from exactspline.questions.entry import Of, Question, question, question_with
from exactspline.questions.takes import Takes
from exactspline.reals.real import Real
from tests.campaigns.offset_parts import FAMILIES
from tests.support.changes import CHANGES
from tests.support.dials import DIALS
from tests.support.drawn import DRAWN, light_curve, light_pair, light_surface, round_loop, smooth_loop
from tests.support.exemptions import EXEMPTIONS
from tests.support.images import TILTED
from tests.support.matrix import (
    Counts,
    Letter,
    ask,
    cells,
    compared,
    differing,
    drawn,
    exempt,
    exempt_cells,
    given_to,
    kind_of,
    questions,
    run_word,
    text_of,
    without_transport,
)
from tests.support.parts import differing_parts, of_parts, somewhere
from tests.support.paths import (
    IN_ANY_PLANE,
    after_all_others,
    after_others,
    again,
    as_data,
    in_another_plane,
    in_the_plane_z_0,
    pair_by_commands,
    pair_in_another_plane,
    plain_python,
    said,
    same_by_batch,
    same_by_command,
    same_by_sweep,
    swept,
    without_extension,
)
from tests.support.transport import same, shown

#: How many seeds take turns: all of them have been seen to pass, so that no other change is blamed for a bad draw. The
#: campaign draws anew.
SEEDS = 14
#: Another one every day; a failure is printed with it.
SEED = int(os.environ.get("EXACTSPLINE_SEED", time.time() // 86400 % SEEDS))
#: The largest number of cells that are not compared.
MOST_EXEMPT = 61
CURVES = [Of.PLANE_CURVE, Of.SPACE_CURVE]
#: What is drawn where the usual things take too long.
LIGHT = {Of.SURFACE: light_surface}
#: How many words begin with each change, where it is more than one.
TIMES = {Of.PLANE_CURVE: 2}


def report(failures):
    """Failures as text, with the seed that leads to them."""
    return "\n".join([f"EXACTSPLINE_SEED={SEED}", *map(str, failures)])


# ---- the table


def test_every_type_of_answer_has_a_transport():
    assert without_transport() == []


#: Something new that a question takes.
ANGLE = Takes("30", lambda given, facts: given)


@dataclass(frozen=True)
class Sample:
    """A value of a new kind."""


def test_a_new_question_without_a_transport_is_named():
    class Asked:
        @question(Of.PLANE_CURVE)
        def samples(self) -> tuple[Sample, ...]:
            """Samples."""

        @question_with(ANGLE, Of.PLANE_CURVE)
        def inflections_of(self, order: int) -> int:
            """Numbers."""

    entries = {name: vars(Asked)[name] for name in ("samples", "inflections_of")}
    assert isinstance(entries["samples"], Question)
    registry = REGISTRY | {Of.PLANE_CURVE: entries}
    assert without_transport(registry) == [
        "samples of a plane curve: Sample",
        "inflections_of of a plane curve: takes 30",
    ]


def test_exemptions_are_few_and_each_is_of_something():
    exempted, known = (
        set(exempt_cells()),
        set(cells()) | {(of, x.name, "split") for of in CURVES for x in questions(of)},
    )
    assert len(exempted) <= MOST_EXEMPT < len(cells()) / 8
    for kinds, names, changes, reason in EXEMPTIONS:
        assert reason
        assert {(of, name, change) for of in kinds for name in names for change in changes} <= known, (names, changes)


# ---- changes


@pytest.mark.parametrize("of", CHANGES, ids=str)
def test_every_question_after_every_change(of):
    counts = Counts()
    for change in CHANGES[of]:
        for i in range(TIMES.get(of, 1)):
            run_word(of, Random(f"{SEED} {of} {change} {i}"), counts, first=change, drawing=LIGHT.get(of))
    assert not counts.failures, report(counts.failures)
    expected = {cell for cell in cells(dear=False) if cell[0] is of and not exempt(*cell)}
    assert expected <= counts.compared.keys()


@pytest.mark.parametrize("change", CHANGES[Of.TWO_CURVES])
def test_dear_questions_of_two_curves_after_every_change(change):
    """Bisectors and intersections of offsets, of curves of few segments and small integers."""
    counts, random = Counts(), Random(f"{SEED} light {change} 0")
    pair, letters = drawn(Of.TWO_CURVES, random, change, light_pair)
    for name in ("bisector", "offset_intersections"):
        compared(pair, REGISTRY[Of.TWO_CURVES][name], letters, random, counts)
    assert not counts.failures, report(counts.failures)


@pytest.mark.parametrize("change", CHANGES[Of.PLANE_CURVE])
def test_self_intersections_of_offsets_after_every_change(change):
    """Of curves of few segments and small integers."""
    counts, random = Counts(), Random(f"{SEED} offset {change} 0")
    curve, letters = drawn(Of.PLANE_CURVE, random, change, lambda random: light_curve(2, random))
    compared(curve, REGISTRY[Of.PLANE_CURVE]["offset_self_intersections"], letters, random, counts)
    assert not counts.failures, report(counts.failures)


@pytest.mark.parametrize("change", CHANGES[Of.PLANE_CURVE])
def test_parts_of_offsets_after_every_change(change):
    """Of closed curves of lines, or on another day of lines and arcs, with small integers."""
    i = (SEED + [*CHANGES[Of.PLANE_CURVE]].index(change)) % 2
    counts, random = Counts(), Random(f"{SEED} parts {change} {i}")
    letters = (Letter(change, random.randrange(1 << 30)),)
    curve = FAMILIES[("polygons", "arcs")[i]](DIALS["small integers"], random)
    compared(curve, REGISTRY[Of.PLANE_CURVE]["offset_parts"], letters, random, counts)
    assert not counts.failures, report(counts.failures)


@pytest.mark.parametrize("change", ["reversed", "other seam", "moebius", "rotated"])
def test_nearest_points_on_an_arc_that_ends_at_the_seam(change):
    """As seen from the centre of the arc."""
    assert not circles_compared(change), SEED


def circles_compared(change):
    """What differs of curves with an arc that begins or ends at the seam, asked at its centre."""
    found = []
    for seam in (1, 3, 4):
        random = Random(f"{SEED} round {change} {seam}")
        curve, centres = round_loop(random, seam)
        letters = (Letter(change, random.randrange(1 << 30)),)
        for centre, name in product(centres, ("nearest", "bisector", "winding_number")):
            given = (",".join(map(str, centre)),)
            found.append(differing(curve, REGISTRY[Of.PLANE_CURVE][name], given, letters))
    return [each for each in found if each]


EXAMPLES = [
    "ellipse",
    "rational_cubic",
    "cubic_s",
    "jump",
    "cusp",
    "six_segment_cubic",
    "straight_between_arcs",
    "rational_space_cubic",
    "twisted_cubic",
    "space_quartic",
    "planar_in_space",
    "flat_point",
]


#: Each change with every fourth example, each example with every fourth change.
CHANGED = [
    (name, change)
    for (i, name), (k, change) in product(enumerate(EXAMPLES), enumerate(CHANGES[Of.PLANE_CURVE]))
    if i % 4 == k % 4
]


@pytest.mark.parametrize(("name", "change"), CHANGED)
def test_examples_after_a_change(name, change):
    """The same every day."""
    counts, random, curve = Counts(), Random(f"{name} {change}"), example(name)
    for entry in questions(kind_of(curve)):
        compared(curve, entry, (Letter(change, 1),), random, counts)
    assert not counts.failures, report(counts.failures)


#: On the unit square.
U, V = (TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], rows) for rows in ([[0, 0], [1, 1]], [[0, 1], [0, 1]]))
X, Y = 2 * U - 1, 2 * V - 1
#: Surfaces with lines without tangent planes, or of umbilics, at u = 1/2 or v = 1/2.
WITH_LINES = {
    "contracted": [X * V, X * V * V, U],
    "cuspidal edge": [X * X, V, X**3],
    "two that cross": [X**3, Y**3, X**3 + Y * Y],
    "crossed by a curve": [X * X, (U - V) ** 2, X**3 + V],
    "umbilics": [U, V, X**3],
}


@pytest.mark.parametrize("name", WITH_LINES)
def test_lines_of_surfaces_after_a_knot_on_them(name):
    """They are poles, and parts of umbilics, wherever knots are."""
    counts, surface = Counts(), NurbsSurface.from_splines([f + 0 * U * V for f in WITH_LINES[name]])
    for seed, entry in product(range(2), questions(Of.SURFACE)):
        compared(surface, entry, (Letter("knot on what was found", seed),), Random(seed), counts)
    assert not counts.failures, report(counts.failures)
    facts = analyse(surface)
    assert bool(facts.poles) == (name not in ("umbilics", "crossed by a curve"))
    assert not (facts.singular_curves or facts.umbilic_curves) or name == "crossed by a curve"


def test_curves_of_umbilics_from_corner_to_corner_after_a_knot():
    """And parabolic ones: single points are those that are on none of them."""
    assert not curves_of_umbilics_compared()


def curves_of_umbilics_compared():
    """What differs after a knot across such a curve."""
    d, counts = U - V, Counts()
    for form, seed in product((d**4, d**2 + d**3), range(2)):
        surface = NurbsSurface.from_splines([U, V, form])
        for name in ("umbilics", "umbilic_curves", "parabolic_points", "singular_points"):
            letters = (Letter("knot on what was found", seed),)
            compared(surface, REGISTRY[Of.SURFACE][name], letters, Random(seed), counts)
            if counts.failures:
                return counts.failures
    return []


@pytest.mark.parametrize("bits", [30, 300])
def test_a_map_with_a_knot_next_to_another_one(bits):
    """Its curves of zeros cross at a corner of the patch between them."""
    rows = [[(0, 1), (0, 0), (1, 3)], [(0, 0), (2, 1), (2, 1)], [(2, 1), (1, 1), (1, 1)]]
    surface = NurbsSurface((2, 2), [0, 0, 0, 1, 1, 1], [0, 0, 0, 1, 1, 1], rows)
    for way, end in product("uv", (0, 1)):
        facts = analyse(surface.insert_knot(way, abs(end - mpq(1, 2**bits))))
        assert (facts.zeros.points, facts.complete, len(facts.zero_curves)) == ((), True, 2)


@pytest.mark.parametrize("of", CURVES, ids=str)
def test_parts_together_have_what_the_whole_has(of):
    for i in range(6):
        random = Random(f"{SEED} {of} parts {i}")
        curve = DRAWN[of](random)
        t = somewhere(curve, random)
        for entry in questions(of):
            if of_parts(entry) and not exempt(of, entry.name, "split"):
                found = differing_parts(curve, entry, given_to(entry, curve, random), t)
                assert not found, (SEED, entry.name, curve.knots, curve.control_points, t, found)


# ---- paths


def asked_of(of, name):
    """A curve, and all questions with givens."""
    random = Random(f"{SEED} {of} {name}")
    curve = DRAWN[of](random)
    return curve, [(entry, given_to(entry, curve, random)) for entry in questions(of)]


@pytest.mark.parametrize("of", CURVES, ids=str)
def test_before_and_after_other_questions_and_without_the_extension(of):
    for i in range(2):
        curve, asking = asked_of(of, i)
        alone = [said(again(curve), text_of(*each)) for each in asking]
        assert after_others(curve, asking) == alone, (SEED, i)
        assert [without_extension(curve, *each) for each in asking] == alone, (SEED, i)


@pytest.mark.parametrize("of", CURVES, ids=str)
def test_by_python_by_the_command_and_in_a_sweep(of, tmp_path):
    curve, asking = asked_of(of, "doors")
    for entry, given in asking:
        by_python = said(again(curve), text_of(entry, given))
        assert same_by_command(curve, entry, given, tmp_path), (SEED, entry.name)
        found = None if isinstance(by_python, str) else swept(curve, entry, given)
        assert found is None or same_by_sweep(by_python, found), (SEED, entry.name, by_python, found)


def test_two_curves_by_python_and_by_both_commands(tmp_path):
    pair = light_pair(Random(f"{SEED} two doors"))
    for entry in questions(Of.TWO_CURVES, dear=True):
        found = pair_by_commands(pair, entry, given_to(entry, pair, Random(SEED)), tmp_path)
        assert all(each == found[0] for each in found), (SEED, entry.name, found)


@pytest.mark.parametrize("of", [Of.SURFACE, Of.PLANAR_MAP], ids=str)
def test_surfaces_by_python_and_by_the_command(of, tmp_path):
    surface = LIGHT.get(of, DRAWN[of])(Random(f"{SEED} doors"))
    for entry in questions(of):
        assert same_by_command(surface, entry, given_to(entry, surface, Random(SEED)), tmp_path), (SEED, entry.name)


@pytest.mark.parametrize("of", [Of.TWO_CURVES, Of.TWO_SURFACES, Of.SURFACE, Of.PLANAR_MAP, Of.REGION], ids=str)
def test_pairs_and_surfaces_before_and_after_other_questions(of):
    """Pairs of curves also without the extension."""
    for i in range(1 if of is Of.SURFACE else 2):
        random = Random(f"{SEED} {of} order {i}")
        thing = {Of.TWO_CURVES: light_pair, **LIGHT}.get(of, DRAWN[of])(random)
        asking = [(entry, given_to(entry, thing, random)) for entry in questions(of, dear=of is Of.TWO_CURVES)]
        alone = [as_data(thing, text_of(*each)) for each in asking]
        assert any(each != "refused" for each in alone)
        assert after_all_others(thing, asking) == alone, (SEED, i)
        with plain_python():
            assert of is not Of.TWO_CURVES or [as_data(thing, text_of(*each)) for each in asking] == alone, (SEED, i)


def test_in_the_plane_z_0():
    """A curve there is a plane curve to every question about plane curves, whose answers have no z."""
    for i in range(3):
        curve, asking = asked_of(Of.PLANE_CURVE, f"z = 0, {i}")
        for entry, given in [*asking, (REGISTRY[Of.PLANE_CURVE]["evolute"], ())]:
            found = in_the_plane_z_0(curve, entry, given)
            assert found == said(again(curve), text_of(entry, given)), (SEED, entry.name)


@pytest.mark.parametrize("tilt", range(len(TILTED)))
def test_in_another_plane(tilt):
    """What needs no lengths is asked of a curve there as of a plane curve, with the sides of its plane."""
    compared = Counter()
    for i in range(6):
        curve, asking = asked_of(Of.PLANE_CURVE, f"tilted {tilt} {i}")
        for entry, given in asking:
            if entry.name in IN_ANY_PLANE:
                found, expected = in_another_plane(curve, entry, given, TILTED[tilt])
                assert same(found, expected), (SEED, i, entry.name, given, shown(found), shown(expected))
                compared[entry.name] += 1
        pair = CurvePair(curve, DRAWN[Of.PLANE_CURVE](Random(f"{SEED} {tilt} {i}")))
        found, expected = pair_in_another_plane(pair, TILTED[tilt])
        assert same(found, expected), (SEED, i, shown(found), shown(expected))
    assert compared == dict.fromkeys(IN_ANY_PLANE, 6)


def test_in_a_batch():
    """Also Bézier curves that are closed and smooth at the seam, where batches have a way of their own."""
    for i in range(48):
        random = Random(f"{SEED} batch {i}")
        curve = smooth_loop(DIALS["small integers"], 2, random) if i % 8 else DRAWN[Of.PLANE_CURVE](random)
        assert same_by_batch(curve), (SEED, i)


# ---- planted faults


def points_of(answer):
    """The places of an answer; none of one that has no places."""
    return [x for x in answer if hasattr(x, "root")] if hasattr(answer, "where") else []


def lost_seam(thing, name, given=()):
    """What stands at the seam of a closed curve is left out."""
    answer = ask(thing, name, given)
    at_seam = points_of(answer) and thing.closed
    return answer.where(lambda x: x.root != thing.domain[0]) if at_seam else answer


def lost_sign(thing, name, given=()):
    """All extrema are told as maxima."""
    answer = ask(thing, name, given)
    if not points_of(answer):
        return answer
    return tuple(replace(x, kind=FeatureKind.MAXIMUM) if x.kind == "minimum" else x for x in answer)


def twice_at_a_knot(thing, name, given=()):
    """What stands at a knot is told from both sides."""
    answer = ask(thing, name, given)
    twice = [x for x in points_of(answer) if x.root.at_knot]
    return (*answer, *twice) if twice else answer


def dropped_given(thing, name, given=()):
    """What is given behind the name is not read."""
    return ask(thing, name, tuple(each.example for each in REGISTRY[Of.PLANE_CURVE][name].about.takes))


def cached():
    """What is known is kept by the control points, without knots and weights."""
    kept = {}

    def asking(thing, name, given=()):
        key = thing.degree, thing.control_points, name, given
        return kept.setdefault(key, ask(thing, name, given))

    return asking


FAULTS = {
    "a lost seam": (lost_seam, "other seam"),
    "a lost sign": (lost_sign, "reversed"),
    "a duplicate at a knot": (twice_at_a_knot, "knot on what was found"),
    "a dropped given": (dropped_given, "scaled"),
    "a cache": (cached(), "affine"),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_a_planted_fault_is_found(fault):
    """Whatever the day: by at most sixty words, each shrunk to one change."""
    asking, change = FAULTS[fault]
    counts, n = Counts(), 0
    while not counts.failures and n < 60:
        run_word(Of.PLANE_CURVE, Random(f"{fault} {n}"), counts, first=change, asking=asking)
        n += 1
    assert counts.failures
    assert any(len(failure.letters) == 1 for failure in counts.failures)


# ---- what was mended, as it was


def as_before(monkeypatch, owner, name, new, old, *, also=()):
    """A function of a module or a class as it was: with another text in it; `also` names modules that import it."""
    text = textwrap.dedent(inspect.getsource(vars(owner)[name]))
    assert text.count(new) == 1
    space = dict(vars(sys.modules[owner.__module__] if isinstance(owner, type) else owner))
    exec(compile(f"from __future__ import annotations\n{text.replace(new, old)}", name, "exec"), space)
    for each in (owner, *also):
        monkeypatch.setattr(each, name, space[name])


def test_a_seam_that_batches_leave_out_is_found(monkeypatch):
    """26.9: curves whose ends are equal went through the numbers of many curves."""
    as_before(monkeypatch, many_curves, "_features", " | (p[:, 0] == p[:, -1]).all(axis=1)", "")
    with pytest.raises(AssertionError):
        test_in_a_batch()


def test_umbilics_told_beside_their_curve_are_found(monkeypatch):
    """26.11: points on curves of umbilics, and of points without a tangent plane, were told one by one."""
    old = "set()"
    new = "{spot for curve in curves for spot, arcs in curve.met.items() if arcs}"
    as_before(monkeypatch, SurfaceInspection, "_single", new, old)
    assert curves_of_umbilics_compared()


def test_the_end_of_an_arc_told_again_at_the_seam_is_found(monkeypatch):
    """26.13 (a): of an arc of nearest points."""
    new, old = "{low if end == high and curve.closed else end for", "{end for"
    as_before(monkeypatch, nearest_points, "nearest", new, old, also=[curves])
    assert circles_compared("reversed")
    assert circles_compared("other seam")


def test_a_number_that_is_rational_once_that_was_asked_is_found(monkeypatch):
    """26.15: what a number is was read where it had been decided, and was null elsewhere."""

    def exact(number):
        return number._exact if isinstance(number._exact, type(mpq())) else None

    monkeypatch.setattr(Real, "exact", property(exact))
    counts, n = Counts(), 0
    while not counts.failures and n < 40:
        run_word(Of.PLANE_CURVE, Random(f"{SEED} exact {n}"), counts)
        n += 1
    assert counts.failures
