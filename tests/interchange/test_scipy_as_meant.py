"""scipy's splines as their class says: smooth, closed, their extrema found, and how far they were moved."""

import re
from collections import Counter
from itertools import pairwise

import numpy as np
import pytest

import exactspline as xs
from exactspline.errors import ShapeError
from exactspline.interchange import read_scipy

si = pytest.importorskip("scipy.interpolate")
COUNT, PERIODIC, STEPS = 30, 20, 50


def curves():
    """30 cubic splines through random points of the plane, 20 of them periodic."""
    chance = np.random.default_rng(29)
    for k in range(COUNT):
        n = int(chance.integers(5, 24))
        t = np.cumsum(chance.uniform(0.2, 2, n))
        points = chance.normal(size=(n, 2)) * 10 ** chance.uniform(-3, 3)
        if k < PERIODIC:
            points[-1] = points[0]
        kind = "periodic" if k < PERIODIC else ("natural", "not-a-knot", "clamped")[k % 3]
        yield si.CubicSpline(t, points, bc_type=kind)


def units(note):
    return int(re.search(r"(\d+) units? in the last place", note)[1])


def missed(curve):
    """How many extrema of the curvature a fine grid shows that are not among those found; seams apart."""
    a, b = map(float, curve.domain)
    ts = np.linspace(a, b, STEPS * curve.segments + 1)[1:-1]
    slopes = np.diff(curve.floats(ts, of="curvature"))
    found = np.array([float(each) for each in curve.curvature_extrema])
    turns = [i for i, (left, right) in enumerate(pairwise(slopes)) if left * right < 0]
    step = ts[1] - ts[0]
    return sum(not np.any(np.abs(found - ts[i + 1]) <= step) for i in turns), len(turns), len(found)


def test_thirty_cubic_splines():
    """Before, every joint was a gap, and most periodic curves were not closed."""
    moved, shown, at_knots = Counter(), 0, 0
    for k, theirs in enumerate(curves()):
        curve, (note,) = read_scipy(theirs)
        assert xs.from_scipy(theirs) == curve
        assert curve.closed == (k < PERIODIC)
        assert all(f.continuity_at(t) >= 2 for f in curve.p for t in curve.breakpoints[1:-1])
        if k < PERIODIC:
            low, high = curve.domain
            assert all(curve.derivative(i, low) == curve.derivative(i, high, "left") for i in (1, 2))
        assert not curve.joints or all(joint.same_curvature for joint in curve.joints)
        lost, turns, _ = missed(curve)
        assert not lost, k
        shown += turns
        at_knots += sum(each.at_knot for each in curve.curvature_extrema)
        moved[units(note)] += 1
        literal = xs.from_scipy(theirs, literal=True)
        places = np.linspace(theirs.x[0], theirs.x[-1], 50)
        size = np.abs(theirs.c).max()
        assert np.allclose(curve.floats(places), literal.floats(places), rtol=0, atol=1e-13 * size)
    assert max(moved) <= 4
    assert shown > 250
    assert at_knots > 40


@pytest.mark.parametrize("kind", [si.Akima1DInterpolator, si.PchipInterpolator])
def test_splines_of_class_one(kind):
    chance = np.random.default_rng(1)
    for n in (5, 9, 20):
        t = np.cumsum(chance.uniform(0.2, 2, n))
        spline, notes = read_scipy(kind(t, chance.normal(size=n)))
        assert all(spline.continuity_at(x) >= 1 for x in spline.breakpoints[1:-1])
        assert all(note.startswith("made C1: ") and units(note) <= 8 for note in notes)


def test_what_is_periodic_is_closed():
    t = np.linspace(0, 2 * np.pi, 9)
    circle = np.column_stack([np.cos(t), np.sin(t)])
    circle[-1] = circle[0]
    (tck, _) = si.splprep(list(circle.T), per=1, s=0)
    for given in (tck, si.make_interp_spline(t, circle, bc_type="periodic")):
        curve, notes = read_scipy(given)
        assert curve.closed
        assert all(note.startswith("closed: ") for note in notes)
        assert not curve.corners
    assert not xs.from_scipy(tck, literal=True).closed
    scalar = xs.from_scipy(si.CubicSpline(t, circle[:, 1], bc_type="periodic"))
    assert all(scalar.d(k)(scalar.domain[0]) == scalar.d(k)(scalar.domain[1], "left") for k in range(3))
    low = si.PPoly(np.array([[1.0, -1.0], [0, 1]]), [0, 1, 2], extrapolate="periodic")
    assert xs.from_scipy(low).segments == 2


def test_what_would_be_moved_too_far():
    """A cubic spline whose coefficients somebody changed is no cubic spline any more."""
    spline = si.CubicSpline([0, 1, 2, 4], [0, 1, 0, 2])
    spline.c[3, 1] += 1e-9
    with pytest.raises(ShapeError, match=r"not C2: .* units in the last place of the largest; literal=True"):
        xs.from_scipy(spline)
    assert xs.from_scipy(spline, literal=True).continuity_at(1) == -1
    jumping = si.PchipInterpolator([0, 1, 2], [0, 1, 3], extrapolate=True)
    jumping.extrapolate = "periodic"
    with pytest.raises(ShapeError, match="and closed"):
        xs.from_scipy(jumping)


def test_the_other_classes():
    t = np.linspace(0, 3, 9)
    one = si.UnivariateSpline(t, np.sin(t), s=0)
    assert xs.from_scipy(one) == xs.from_scipy(one._eval_args)
    assert np.allclose(xs.from_scipy(one).floats(t), np.sin(t), atol=1e-14)
    two = si.RectBivariateSpline(t, t[:5], np.outer(np.sin(t), np.cos(t[:5])))
    f = xs.from_scipy(two)
    assert np.allclose(f.floats(t[:, None], t[:5]), two(t, t[:5]), atol=1e-13)
    net = np.arange(18.0).reshape(3, 2, 3) ** 2
    knots = np.array([0.0, 0, 0, 1, 1, 1]), np.array([0.0, 0, 1, 1])
    surface, scalar = (xs.from_scipy(si.NdBSpline(knots, c, (2, 1))) for c in (net, net[:, :, 0]))
    assert np.allclose(surface.floats(0.5, 0.25), si.NdBSpline(knots, net, (2, 1))((0.5, 0.25)))
    assert surface.p[0] == scalar
    line = xs.from_scipy(si.NdBSpline(knots[:1], net[:, 0], (2,)))
    assert line.control_points == tuple(tuple(map(int, row)) for row in net[:, 0])


def test_equal_coefficients_at_both_ends_do_not_make_a_spline_periodic():
    """Refused before: the knots are not periodic, so that this is a spline like any other."""
    knots = [0, 0.5, 1.25, 2, 3, 3.5, 4.75, 5, 6.5, 7, 8, 9, 9.5]
    interpolate = pytest.importorskip("scipy.interpolate")
    spline = interpolate.BSpline(knots, [1.0, 2, -1, 5, 3, 7, 1, 2, -1], 3)
    read = read_scipy(spline)
    assert [float(x) for x in read.curve.control_points] == list(spline.c)
    assert not read.notes
    assert read.curve(4) == xs.from_scipy(spline, literal=True)(4)
