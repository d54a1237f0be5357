"""The certified filter on curves of several segments and mixed degrees: its answers are the exact ones, on families
biased to what could deceive it, and one bad curve does not stop the others.
"""

import random
from collections import Counter
from fractions import Fraction

import pytest
from gmpy2 import mpq

from exactspline import Nurbs, analyse, example, examples
from exactspline.batch.corpus import Family
from exactspline.errors import ExactSplineError, NumberError, ShapeError
from tests.campaigns import filter as campaign

np = pytest.importorskip("numpy")

from exactspline.geometry.analysis import curves as analysis  # noqa: E402  # needs numpy
from exactspline.geometry.analysis import many_curves  # noqa: E402
from exactspline.geometry.analysis.many_curves import curve_features_in_parts, features_of_curves  # noqa: E402


def same_as_exact(curves):
    """Hold every answer against the exact one: how many curves were decided in doubles, and how many jumps at knots."""
    found, decided, jumps = features_of_curves(curves), 0, 0
    for i, curve in enumerate(curves):
        own = found.curve == i
        facts = campaign.exact(curve)  # `analyse` would go through the filter itself
        true = [*facts.inflections, *facts.curvature_extrema]
        assert found.kind[own].tolist() == [str(feature.kind) for feature in true]
        for low, high, feature in zip(found.low[own].tolist(), found.high[own].tolist(), true, strict=True):
            assert Fraction(low) <= feature.root <= Fraction(high)
            # before: half a segment for curves of which single segments were decided exactly
            assert high - low <= max(1.1e-9, 4 * np.spacing(abs(high)))
        if i not in found.exact:
            decided += 1
            jumps += sum(feature.by_jump for feature in true)
    return decided, jumps


def troubled(chance):
    """A curve with what is not certain in doubles, or only seems so: knots of any multiplicity at any distance,
    repeated points, closed curves, numbers that cancel, zeros at knots, weights of either sign.
    """
    degree, knots, t = chance.randint(1, 4), [], mpq(0)
    distances = [1, 1, mpq(1, 3), mpq(5, 7), 1000, mpq(1, 10**9)]
    for _ in range(chance.randint(0, 3)):
        t += chance.choice(distances)
        knots += [t] * chance.choice([1, 1, 1, min(2, degree), degree])
    end = t + chance.choice([1, mpq(1, 2)])
    count, size = len(knots) + degree + 1, chance.choice([2, 10, 1000, 10**6])
    points = [(chance.randint(-size, size), chance.randint(-size, size)) for _ in range(count)]
    bent = {
        "closed": lambda: [*points[:-1], points[0]],
        "parabola": lambda: [(i, i * i) for i in range(count)],
        "repeated": lambda: [points[0], points[0], *points[2:]],
        "cancelling": lambda: [(x * 10**9 + 1, y) for x, y in points],
        "fractions": lambda: [(mpq(x, 3**40), mpq(y, 7)) for x, y in points],
    }
    kind = chance.choice([*bent, *["random"] * 6])
    points = bent[kind]() if kind in bent else points
    sign = chance.choice([1, 1, 1, -1])
    weights = [sign * chance.choice([1, 1, 2, 3, mpq(1, 5), 10**6]) for _ in points]
    return Nurbs(degree, [0] * (degree + 1) + knots + [end] * (degree + 1), points, chance.choice([None, weights]))


@pytest.mark.parametrize("seed", range(2))
def test_troubled_curves_are_decided_as_exact_arithmetic_decides(seed):
    chance = random.Random(seed)
    decided, jumps = same_as_exact([troubled(chance) for _ in range(250)])
    assert decided > 30
    assert jumps > 5


def test_a_zero_that_is_all_but_a_knot_stays_inside_its_interval():
    # the inflection is 10⁻²⁵ before the knot, the nearest double below 10⁻⁹ is farther away
    near = mpq(1, 10**9)
    points = [(0, 1), (0, 0), (-1, 0), (-2, -1), (1, 0)]
    same_as_exact([Nurbs(3, [0] * 4 + [near] + [1 + near] * 4, points, [1, 1, 1, 3, 3])])


@pytest.mark.parametrize(
    ("size", "shift"), [(mpq(1, 2**1040), 0), (mpq(1, 2**1022), 0), (mpq(2) ** 1022, -3), (mpq(1, 2**890), 1)]
)
def test_breakpoints_of_any_size(size, shift):
    # a width that is not a double, zeros nearer to each other than doubles are, knots that are one double
    curve = example("six_segment_cubic")
    a, b = curve.domain
    knots = [((t - a) * 6 / (b - a) + shift) * size for t in curve.knots]
    moved = Nurbs(3, knots, curve.control_points)
    found = features_of_curves([moved])
    facts = analyse(moved)
    true = [*facts.inflections, *facts.curvature_extrema]
    assert len(true) == 10
    assert sorted(found.kind.tolist()) == sorted(str(feature.kind) for feature in true)
    bounds = zip(found.low.tolist(), found.high.tolist(), found.kind.tolist(), strict=True)
    for low, high, kind in bounds:
        inside = [feature for feature in true if Fraction(low) <= feature.root <= Fraction(high)]
        assert kind in [str(feature.kind) for feature in inside]


def test_the_jump_of_curvature_at_a_knot_decides():
    # κ′ changes its sign at the knot of all three, C¹; κ jumps on the first two, on the third it does not
    arcs = [[(0, 0), (1, 2), (3, 2), (5, -1)], [(0, 0), (1, 2), (3, 2), (4, 1)], [(0, 0), (1, 1), (3, 1), (4, 0)]]
    curves = [Nurbs(2, [0, 0, 0, 1, 2, 2, 2], points) for points in arcs]
    joints = [analyse(curve).joints[0] for curve in curves]
    assert [joint.same_curvature for joint in joints] == [False, False, True]
    found = features_of_curves(curves)
    assert 2 in found.exact
    same_as_exact(curves)


def test_the_examples_and_those_that_are_no_plane_curves():
    curves = [example(name) for name in examples("curves")]
    found = features_of_curves(curves)
    in_a_plane = [all(point[2:] in ((), (0,)) for point in curve.control_points) for curve in curves]
    assert sorted(found.refused) == [i for i, flat in enumerate(in_a_plane) if not flat] != []
    assert {type(error) for error in found.refused.values()} == {ShapeError}
    assert any(flat and curve.dimension == 3 for flat, curve in zip(in_a_plane, curves, strict=True))
    same_as_exact([curve for curve, flat in zip(curves, in_a_plane, strict=True) if flat])


def test_what_is_no_curve_is_refused_like_a_bad_curve():
    found = features_of_curves(["cubic_s", np.zeros((4, 2)), None, example("cubic_s")])
    assert [str(found.refused[i]).split(";")[0] for i in range(3)] == [
        "curves[0]: a str, where a curve is expected",
        "curves[1]: a ndarray, where a curve is expected",
        "curves[2]: a NoneType, where a curve is expected",
    ]
    assert set(found.curve.tolist()) == {3}


def test_a_bad_curve_does_not_stop_the_others(monkeypatch):
    family = Family.parsed("degree=3 count=6")
    curves = [family.curve(i) for i in range(6)]
    far = Nurbs(3, [10**400] * 4 + [10**400 + 1] * 4, curves[0].control_points)
    whole, found = features_of_curves(curves), features_of_curves([far, *curves])
    assert isinstance(found.refused[0], NumberError)
    assert (found.curve - 1).tolist() == whole.curve.tolist()
    assert found.low.tolist() == whole.low.tolist()

    class Failing(analysis.Analysis):
        @property
        def inflections(self):
            if self.curve is flat:
                raise ExactSplineError("cannot", remedy="none")
            return super().inflections

    monkeypatch.setattr(many_curves, "Analysis", Failing)
    flat = Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (1, 0), (2, 0), (3, 1)])
    found = features_of_curves([flat, *curves])
    assert list(found.refused) == [0]
    assert found.kind.tolist() == whole.kind.tolist()


def test_stopping_early_keeps_what_was_done():
    family = Family.parsed("degree=2-3 segments=1-3 rational=half count=30")
    curves = [family.curve(i) for i in range(30)]
    taken = []
    parts = curve_features_in_parts((taken.append(c) or c for c in curves), at_once=10)
    first, second = next(parts), next(parts)
    assert len(taken) == 20
    whole = features_of_curves(curves)
    upto = whole.curve < 20
    for name in ("curve", "kind", "low", "high"):
        assert [*getattr(first, name), *getattr(second, name)] == getattr(whole, name)[upto].tolist()
    assert features_of_curves([]).curve.tolist() == []


def test_curves_left_for_no_exact_reason_have_a_ceiling():
    """Passed before: a family of which every tenth curve is left to exact arithmetic."""
    made = {"contour": 4000, "near_cusp": 4000}
    assert campaign.above_ceiling(made, {"contour": Counter({"": 4}), "near_cusp": Counter({"": 2900})}) == []
    left = {"contour": Counter({"": 5, "a multiple zero": 90}), "near_cusp": Counter({"": 3001})}
    assert campaign.above_ceiling(made, left) == ["contour", "near_cusp"]
