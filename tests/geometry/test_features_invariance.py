"""What is told of a plane curve does not depend on how it is written down or where it lies."""

from gmpy2 import mpq
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from exactspline import Nurbs
from exactspline.geometry.analysis import analyse
from exactspline.geometry.kinds import FeatureKind, JointKind
from tests.support.answers import pieces, places
from tests.support.space_curves import backwards
from tests.support.strategies import nurbs

curves = nurbs(dimension=2, low=1, high=4)


def told(curve):
    """Everything that `inspect` finds but for the values and the joints."""
    found = {n: [(f.kind, f.root, f.by_jump, f.of_absolute) for f in group] for n, group in places(curve).items()}
    return found, pieces(curve)


def joints(curve):
    """The joints that are not smooth to third order, but for knots where the curve stands still on both sides."""
    found = [j for j in analyse(curve).joints if j.kind is not JointKind.STILL]
    return [(j.parameter, j.kind, j.order) for j in found if j.order is None or j.order < 3]


def rewritten(curve, change):
    """The curve with its homogeneous components changed as splines."""
    weights = [mpq(1)] * len(curve.control_points) if curve.polynomial else curve.w.control_points
    rows = zip(*[x.control_points for x in curve.p], weights, strict=True)
    plain = Nurbs.from_homogeneous(curve.degree, curve.p[0].knots, rows)
    components = [*plain.p, plain.w if not plain.polynomial else plain.p[0] * 0 + 1]
    parts = [change(x) for x in components]
    return Nurbs.from_homogeneous(parts[0].degree, parts[0].knots, zip(*[x.control_points for x in parts], strict=True))


@settings(max_examples=40)
@given(curves, st.integers(1, 12))
def test_inserted_knots_change_nothing(curve, k):
    a, b = curve.domain
    t = a + (b - a) * mpq(k, 13)
    assume(t not in curve.breakpoints)
    other = rewritten(curve, lambda x: x.insert_knot(t))
    assert other(t) == curve(t)
    assert told(other) == told(curve)
    assert joints(other) == joints(curve)


@settings(max_examples=40)
@given(curves)
def test_a_higher_degree_changes_nothing(curve):
    other = rewritten(curve, lambda x: x.elevate_degree())
    assert told(other) == told(curve)
    assert joints(other) == joints(curve)


@settings(max_examples=40)
@given(curves, st.sampled_from([-1, -3, mpq(2, 7)]))
def test_scaled_weights_change_nothing(curve, factor):
    other = Nurbs(curve.degree, curve.knots, curve.control_points, [w * factor for w in curve.weights])
    assert told(other) == told(curve)
    assert joints(other) == joints(curve)


@settings(max_examples=40)
@given(curves, st.tuples(st.integers(-5, 5), st.integers(-5, 5)), st.sampled_from([mpq(1, 5), mpq(10) ** 30]))
def test_similarities_change_nothing(curve, shift, scale):
    """A rotation by the angle of the 3-4-5 triangle, a scaling, and a translation."""
    points = [(scale * (3 * x - 4 * y) + shift[0], scale * (4 * x + 3 * y) + shift[1]) for x, y in curve.control_points]
    other = Nurbs(curve.degree, curve.knots, points, curve.weights)
    assert told(other) == told(curve)
    assert joints(other) == joints(curve)


@settings(max_examples=40)
@given(curves)
def test_reflections_turn_the_sign_of_the_curvature(curve):
    other = Nurbs(curve.degree, curve.knots, [(x, -y) for x, y in curve.control_points], curve.weights)
    found, straight = told(curve)
    extrema = (FeatureKind.MAXIMUM, FeatureKind.MINIMUM)
    turned = [(k.opposite if k in extrema else k, *rest) for k, *rest in found["critical_points"]]
    assert told(other) == (found | {"critical_points": turned}, straight)
    angles = [[j.angle for j in analyse(c).joints if j.angle] for c in (curve, other)]
    assert [(a.cosine, -a.sine) for a in angles[0]] == [(a.cosine, a.sine) for a in angles[1]]


@settings(max_examples=40)
@given(curves)
def test_running_backwards_mirrors_the_parameters(curve):
    assume(not curve.closed)
    other, total = backwards(curve), sum(curve.domain)
    (forward, own), (back, turned) = told(curve), told(other)
    extrema = (FeatureKind.MAXIMUM, FeatureKind.MINIMUM)
    for group, mirrored in zip(forward.values(), back.values(), strict=True):
        assert len(group) == len(mirrored)
        for (kind, root, jump, absolute), (kind_, root_, jump_, absolute_) in zip(
            group, reversed(mirrored), strict=True
        ):
            assert kind_ == (kind.opposite if kind in extrema else kind)
            assert (jump, absolute) == (jump_, absolute_)
            (low, high), (low_, high_) = root.refine(30), root_.refine(30)
            assert low + low_ <= total <= high + high_
    for name, group in own.items():
        assert turned[name] == [((total - b, total - a),) for ((a, b),) in reversed(group)]
    assert sorted((total - t, kind, order) for t, kind, order in joints(curve)) == joints(other)
