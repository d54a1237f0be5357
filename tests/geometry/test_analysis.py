"""One curve, one analysis: what is computed is computed once, in time linear in the segments, and is not a part of the
curve's value.
"""

import pickle
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from random import Random

import pytest
from gmpy2 import mpq

from exactspline import Nurbs, analyse, example, examples
from exactspline.errors import ShapeError
from exactspline.geometry.analysis.inspection import inspect_curve, solved
from exactspline.geometry.curves import facts as facts_module
from exactspline.geometry.curves import features
from exactspline.geometry.curves.joints import Ends
from exactspline.geometry.derived.constructions import Construction
from exactspline.papers.chen_riesenfeld_cohen_2007.figures import compare_approaches
from exactspline.polynomials import isolation as isolation_module
from exactspline.programs import accelerator
from exactspline.roots import zero_set as zero_set_module
from exactspline.roots.answers import CurvePiece


def spline(segments, dimension, seed=1):
    """A cubic spline with knots 0, 1, 2, …, that runs along x."""
    random = Random(seed)
    points = [[i, *(random.randint(-9, 9) for _ in range(dimension - 1))] for i in range(segments + 3)]
    return Nurbs(3, [0] * 3 + list(range(segments + 1)) + [segments] * 3, points)


class Counted:
    """Counts the calls of what costs time."""

    def __init__(self, monkeypatch):
        self.calls, self.patch = Counter(), monkeypatch
        self.count(facts_module, "zeros")
        self.count(facts_module, "common_factor")
        self.count(features, "common_factor")
        self.count(facts_module, "geometric_order")
        self.count(Construction, "form_on")
        self.count(Ends, "jet")
        self.count(zero_set_module, "isolate")
        self.count(isolation_module, "variations")

    def count(self, owner, name):
        original = getattr(owner, name)

        def counting(*arguments, **named):
            self.calls[name] += 1
            return original(*arguments, **named)

        self.patch.setattr(owner, name, counting)


#: Forms whose zeros are found: κ and κ′ in the plane; τ, κ′, γ′ × γ″, and τ in lowest terms in space. That γ′ has no
#: zero between knots is seen from its signs.
FORMS = {2: 2, 3: 4}


@pytest.mark.parametrize("dimension", [2, 3])
def test_everything_is_computed_once_and_in_linear_time(monkeypatch, dimension):
    per_segment = {}
    for segments in (10, 50):
        curve = spline(segments, dimension)
        with monkeypatch.context() as patch:
            # with the extension single segments would be decided apart
            patch.setattr(accelerator, "filter_curve", None)
            counted = Counted(patch)
            inspect_curve(curve).answers  # noqa: B018
            first = Counter(counted.calls)
            assert first["zeros"] == FORMS[dimension]
            assert first["form_on"] == 2
            assert first["common_factor"] == dimension - 2
            assert first["geometric_order"] == segments - 1
            assert first["jet"] == 2 * (segments - 1)
            # and of the few segments that seem to be near an arc, whether they are
            assert first["isolate"] <= FORMS[dimension] * segments + 1 + segments // 50
            inspect_curve(curve).answers  # noqa: B018
            solved(curve)
            assert counted.calls == first
            compare_approaches(curve)
            assert counted.calls["form_on"] == 6
        per_segment[segments] = first["variations"] / segments
    assert per_segment[50] < 2 * per_segment[10]


def test_roots_are_compared_a_bounded_number_of_times_a_segment(monkeypatch):
    """Comparisons grow as those of a binary search at most, not with the number of segments."""
    from exactspline import Root

    counts = {}
    for segments in (100, 1000):
        curve = spline(segments, 2)
        with monkeypatch.context() as patch:
            calls, original = Counter(), Root._against

            def counting(self, other, calls=calls, original=original):
                calls["compared"] += 1
                return original(self, other)

            patch.setattr(Root, "_against", counting)
            inspect_curve(curve).answers  # noqa: B018
        counts[segments] = calls["compared"] / segments
    assert counts[1000] < 2 * counts[100]


def test_an_analysis_belongs_to_one_curve_and_is_no_part_of_it():
    curve, same = spline(4, 2), spline(4, 2)
    found = analyse(curve)
    assert analyse(curve) is found
    assert curve == same
    for other in (pickle.loads(pickle.dumps(curve)), curve.elevate_degree()):
        assert other == curve
        assert analyse(other) is not found
    assert analyse(same) is not found
    assert analyse(same).critical_points is not found.critical_points


@pytest.mark.parametrize("name", examples("curves"))
def test_the_sign_of_a_form_is_that_of_its_values(name):
    """At every root of every other form, asked of the certified zeros alone, and held against interval evaluation."""
    curve = example(name)
    found = analyse(curve)
    names = ("zero_torsion",) if found.in_space else ("zero_curvature", "critical_curvature")
    forms = [found.zero_form(n) for n in (*names, found.critical_form)]
    for form in forms:
        for other in forms:
            for root in other.zeros:
                if root.exact is not None:
                    value = form.form(root.exact)
                    assert form.sign_at(root) == (value > 0) - (value < 0)
                    continue
                low, high = root.refine(60)
                values = [form.form(t) for t in (low, high)]
                sign = form.sign_at(root)
                assert sign == 0 or all(v * sign > 0 for v in values)
                assert (sign == 0) == (values == [0, 0] or root in form.zeros.roots)


def test_eight_threads_find_one_analysis():
    curve = spline(60, 3)
    with ThreadPoolExecutor(8) as pool:
        found = list(pool.map(lambda _: analyse(curve), range(16)))
    assert all(one.critical_points == found[0].critical_points for one in found)
    assert all(a is b for one in found for a, b in zip(one.critical_points, found[0].critical_points, strict=True))
    alone = analyse(spline(60, 3))
    for name in ("singular_points", "inflections", "critical_points"):
        assert [(f.kind, f.root) for f in getattr(found[0], name)] == [(f.kind, f.root) for f in getattr(alone, name)]


@pytest.mark.parametrize("name", ["cusp", "cubic_s", "twisted_cubic", "straight_between_arcs"])
def test_what_is_handed_out_is_nobody_elses(name):
    """No list whose change would change the analysis that is kept with the curve."""
    found = analyse(example(name))
    for n in [n for n in dir(found) if not n.startswith("_")]:
        try:
            value = getattr(found, n)
        except ShapeError:  # of plane curves alone, or of space curves
            continue
        if isinstance(value, (list, dict, set)):
            value.clear()
            assert getattr(found, n) is not value, n
    again = Nurbs(*[getattr(found.curve, n) for n in ("degree", "knots", "control_points", "weights")])
    for asked in ("inflections", "singular_points", "curvature_extrema", "joints", "corners", "straight_pieces"):
        assert getattr(found, asked) == getattr(analyse(again), asked)


def test_a_piece_across_the_seam_contains_its_ends():
    piece = CurvePiece(((mpq(3), mpq(4)), (mpq(0), mpq(1, 2))))
    assert (piece.start, piece.end, piece.across_seam) == (3, mpq(1, 2), True)
    assert not CurvePiece(piece.parts[:1]).across_seam
    assert [t in piece for t in map(mpq, (0, "1/4", "1/2", "3/4", 2, 3, 4))] == [True] * 3 + [False] * 2 + [True] * 2
