"""Curves from points and pieces: each against what it is defined by, on random data, and against scipy's splines."""

import random

import numpy as np
import pytest
from gmpy2 import mpq

import exactspline as xs
from exactspline import interpolate
from exactspline.constructors import (
    arc_through,
    catmull_rom,
    closed,
    closed_spline,
    from_powers,
    hermite,
    joined,
    rotate,
)


def drawn(chance, count, dimension=2):
    return [tuple(mpq(chance.randint(-20, 20), chance.randint(1, 5)) for _ in range(dimension)) for _ in range(count)]


def steps(chance, count):
    found = [mpq(0)]
    while len(found) < count:
        found.append(found[-1] + mpq(chance.randint(1, 9), chance.randint(1, 4)))
    return found


def smooth(curve, order):
    return all(f.continuity_at(t) >= order for f in curve.p for t in curve.breakpoints[1:-1])


@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("ends", ["natural", "clamped", "periodic"])
def test_interpolation(ends, seed):
    chance = random.Random(seed)
    points, dimension = drawn(chance, chance.randint(3, 9)), 2
    t = steps(chance, len(points) + (ends == "periodic"))
    slopes = drawn(chance, 2) if ends == "clamped" else ()
    curve = interpolate(points, t, ends=ends, slopes=slopes)
    assert [curve(x) for x in t[: len(points)]] == points
    assert smooth(curve, 2)
    assert len(curve.breakpoints) == len(t)
    low, high = curve.domain
    if ends == "natural":
        assert curve.derivative(2, low) == curve.derivative(2, high) == (0,) * dimension
    elif ends == "clamped":
        assert [curve.derivative(1, low), curve.derivative(1, high)] == slopes
    else:
        assert curve.closed
        assert all(curve.derivative(k, low) == curve.derivative(k, high, "left") for k in (1, 2))
    theirs = pytest.importorskip("scipy.interpolate").CubicSpline(
        xs.floats(t), xs.floats([*points, *points[: ends == "periodic"]]),
        bc_type=[(1, xs.floats(m)) for m in slopes] if ends == "clamped" else ends,
    )  # fmt: skip
    places = np.linspace(float(low), float(high), 30)
    assert np.allclose(curve.floats(places), theirs(places), rtol=1e-9, atol=1e-9)


def test_chord_lengths_are_within_the_distance():
    """√2 and √5, each parameter less than the distance too small."""
    curve = xs.interpolate([(0, 0), (1, 1), (2, 3)], within="1e-3")
    for t, square in zip((curve.breakpoints[1], curve.breakpoints[2] - curve.breakpoints[1]), (2, 5), strict=True):
        assert t * t <= square < (t + mpq(1, 1000)) ** 2
    assert xs.interpolate([(0, 0), (3, 4)]).breakpoints == (0, 5)
    two = xs.interpolate([(0, 0), (3, 0), (0, 0)], ends="periodic")
    assert two.closed
    assert len(two.breakpoints) == 3
    assert smooth(two, 2)
    assert two.derivative(1, 0) == two.derivative(1, 6)
    uneven = xs.interpolate([(0, 0), (3, 0)], [0, 1, 3], ends="periodic")
    assert [uneven(t) for t in (0, 1, 3)] == [(0, 0), (3, 0), (0, 0)]


@pytest.mark.parametrize("is_closed", [False, True])
def test_catmull_rom(is_closed):
    points = drawn(random.Random(5), 5, 3)
    curve = catmull_rom(points, closed=is_closed)
    assert [curve(i) for i in range(5)] == points
    assert curve.closed == is_closed
    assert smooth(curve, 1)
    assert curve.derivative(1, 2) == tuple((b - a) / 2 for a, b in zip(points[1], points[3], strict=True))
    if is_closed:
        seam = tuple((b - a) / 2 for a, b in zip(points[4], points[1], strict=True))
        assert curve.derivative(1, 0) == curve.derivative(1, 5) == seam


def test_hermite_data_are_those_of_the_curve():
    chance = random.Random(3)
    points, slopes, t = drawn(chance, 4), drawn(chance, 4), steps(chance, 4)
    curve = hermite(points, slopes, t)
    assert [curve(x) for x in t] == points
    assert [curve.derivative(1, x) for x in t] == slopes
    assert smooth(curve, 1)


def test_powers():
    x, y = from_powers([[1, "1/2", 0, 3], [7]], 2, 5)("7/3")
    t = mpq(7, 3)
    assert (x, y) == (1 + t / 2 + 3 * t**3, 7)


@pytest.mark.parametrize("middle", [("3/5", "4/5"), ("-3/5", "4/5"), (0, -1), (-1, 0)])
def test_arcs_through_three_points(middle):
    start, end = (1, 0), ("3/5", "-4/5")
    arc = arc_through(start, middle, end)
    assert (arc(arc.domain[0]), arc(arc.domain[1])) == ((1, 0), (mpq(3, 5), mpq(-4, 5)))
    assert [near.distance for near in xs.nearest(arc, middle)] == [0]
    x, y = arc.p
    assert (x * x + y * y - arc.w * arc.w).is_zero


@pytest.mark.parametrize("degree", [1, 2, 3, 5])
def test_closed_splines(degree):
    """Also of fewer points than the degree; scipy's has the same control points over the same knots."""
    for count in (3, 4, 7):
        points = drawn(random.Random(count), count)
        curve = closed_spline(points, degree)
        assert curve.closed
        assert curve.domain == (0, count)
        assert all(curve.derivative(k, 0) == curve.derivative(k, count, "left") for k in range(1, degree))
    assert not xs.analyse(closed_spline([(0, 0), (3, 0), (3, 2), (0, 2)])).corners


@pytest.mark.parametrize("degrees", ["0.1", 60, -200, 1000])
def test_rotations(degrees):
    """Exact rotations, by the angle but for 10⁻¹² radians."""
    turned = rotate(xs.circle((0, 0), 1), degrees, within="1e-12")
    x, y = turned.p
    assert (x * x + y * y - turned.w * turned.w).is_zero
    angle = np.deg2rad(float(xs.rational(degrees)))
    assert np.allclose(turned.floats(0), [np.cos(angle), np.sin(angle)], rtol=0, atol=2e-12)
    with pytest.raises(xs.ExactSplineError):
        rotate(xs.example("twisted_cubic"), degrees)


def test_curves_joined():
    line, arc = xs.Nurbs.bezier([(0, 0), (1, 0)], a=2, b=5), arc_through((1, 0), (0, 1), (-1, 0))
    curve = joined([line, arc, xs.Nurbs.bezier([(-1, 0), (0, 0)])])
    assert curve.closed
    assert curve.degree == 2
    assert curve("1/2") == line("7/2")
    assert curve(2) == (0, 1)
    with pytest.raises(xs.ExactSplineError, match="does not begin"):
        joined([line, line])


def test_a_gap_is_closed_and_said():
    curve = xs.Nurbs(2, [0, 1, 2, 3, 4, 5, 6], [(0, 0), (1, 0), (1, 1), ("1e-9", "1e-9")])
    low, high = curve.domain
    gap = [b - a for a, b in zip(curve(low), curve(high), strict=True)]
    with pytest.raises(xs.ExactSplineError, match="apart"):
        closed(curve, within="1e-9")
    made = closed(curve, within=2)
    assert made.closed
    assert "was moved by at most" in made.note
    for t in (mpq(2), mpq(7, 3), mpq(7, 2), mpq(4)):
        moved = sum((b - a) ** 2 for a, b in zip(curve(t), made(t), strict=True))
        assert moved <= sum(x * x for x in gap)


@pytest.mark.parametrize("wrong", [
    lambda: interpolate([(0, 0)]), lambda: interpolate([(0, 0), (0, 0)]), lambda: interpolate([(0, 0), (1, 1)], [1, 0]),
    lambda: interpolate([(0, 0), (1, 1)], [0]), lambda: interpolate([(0, 0), (1, 1)], ends="clamped"),
    lambda: interpolate([(0, 0), (1, 1)], ends="open"), lambda: arc_through((0, 0), (1, 1), (2, 2)),
    lambda: from_powers([[1], []]), lambda: hermite([(0, 0), (1, 1)], [(0, 0)]), lambda: closed_spline([], 2),
    lambda: interpolate([(0, 0), (1, 1)], ends="clamped", slopes=[(0, 0), (1, 1, 1)]), lambda: catmull_rom([(0, 0)]),
    lambda: joined([]), lambda: interpolate([(0, 0), (1, 1)], within=0),
    lambda: interpolate([(0, 0), (1, 1)], ends="clamped", slopes=[(0, 0, 0), (1, 1, 1)]),
])  # fmt: skip
def test_what_is_refused(wrong):
    with pytest.raises(xs.ExactSplineError):
        wrong()
