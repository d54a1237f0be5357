"""Arcs with irrational ends or axes, read within E: on the exact circle, in the right order, no further than said."""

import math

import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from exactspline import read
from exactspline.errors import ShapeError
from exactspline.interchange.collector import whole
from exactspline.interchange.segments import (
    DEGREES,
    RADIANS,
    Affine,
    Round,
    axes,
    dot,
    on_circle,
    through_ends,
    turn_near,
)
from tests.support.interchange_seeds import dxf

numbers = st.fractions(-50, 50, max_denominator=40).map(lambda x: mpq(x.numerator, x.denominator))
errors = st.integers(1, 12).map(lambda n: mpq(1, 10**n))
vectors = st.lists(numbers, min_size=3, max_size=3)


@given(numbers, numbers, errors)
def test_a_point_of_the_circle_is_in_the_direction_that_is_asked(x, y, error):
    if not (x or y):
        return
    cosine, sine = on_circle(x, y, error)
    assert cosine**2 + sine**2 == 1
    # the sine of the angle between, exactly, and on the same side
    assert (cosine * y - sine * x) ** 2 <= error**2 * (x * x + y * y)
    assert cosine * x + sine * y > 0


@given(numbers, errors)
def test_turns_near_an_angle(degrees, error):
    for angle, right in ((10 * degrees, DEGREES), (degrees, RADIANS)):
        cosine, sine = turn_near(angle, right, error)
        turned = math.radians(angle) if right == DEGREES else float(angle)
        assert cosine**2 + sine**2 == 1
        assert math.dist((cosine, sine), (math.cos(turned), math.sin(turned))) < error + mpq(1, 10**12)


@settings(max_examples=60)
@given(vectors, vectors, errors)
def test_axes_are_perpendicular_unit_vectors_near_to_those_that_are_meant(along, normal, error):
    try:
        (x, y, z), near = axes(along, normal, error)
    except (ShapeError, ZeroDivisionError):
        assert (
            not any(normal) or not any(along) or abs(dot(along, normal)) ** 2 == dot(along, along) * dot(normal, normal)
        )
        return
    for u in (x, y, z):
        assert dot(u, u) == 1
    assert dot(x, y) == dot(y, z) == dot(z, x) == 0
    length = math.sqrt(dot(normal, normal))
    assert math.dist(z, [float(c) / length for c in normal]) <= error + mpq(1, 10**12)
    assert near or dot(z, normal) ** 2 == dot(normal, normal)
    assert dot(x, along) >= 0


@pytest.mark.parametrize("normal", [(0, 0, 1), (1, 1, 0), (1, 2, -3), (0, 0, -1), (-1, -1, -1)])
def test_a_circle_of_dxf_in_any_plane(normal):
    """By the arbitrary axis algorithm; without E only axes of rational length are read."""
    words = f"0 ARC 10 3 20 -4 30 2 40 5 50 20 51 200 210 {normal[0]} 220 {normal[1]} 230 {normal[2]}"
    assert "--approximate E" in read(dxf(words)).skipped[0].why
    error = mpq(1, 10**8)
    [named] = read(dxf(words), approximate=error).curves
    curve = named.curve
    length = math.sqrt(sum(c * c for c in normal))
    n = [c / length for c in normal]
    side = (0, 1, 0) if abs(n[0]) < 1 / 64 > abs(n[1]) else (0, 0, 1)
    across = cross(side, n)
    size = math.hypot(*across)
    across = [c / size for c in across]
    up = cross(n, across)
    for t, degrees in ((curve.domain[0], 20), (curve.domain[1], 200)):
        u, v = 3 + 5 * math.cos(math.radians(degrees)), -4 + 5 * math.sin(math.radians(degrees))
        expected = [u * a + v * b + 2 * c for a, b, c in zip(across, up, n, strict=True)]
        point = [float(x) for x in curve(t, "left" if t else "right")]
        assert math.dist(point + [0.0] * (3 - len(point)), expected) < error + mpq(1, 10**12)
    middle = curve((curve.domain[0] + curve.domain[1]) / 2)
    assert middle != curve(curve.domain[0])


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def test_ends_nearer_than_the_error_are_refused():
    """Otherwise the ends of a short arc might be read in the wrong order: nearly the whole circle."""
    words = "0 ARC 10 0 20 0 40 1 50 10 51 10.001"
    assert "smaller --approximate" in read(dxf(words), approximate="0.1").skipped[0].why
    [named] = read(dxf(words), approximate="1e-7").curves
    assert named.curve.segments == 1


def test_an_ellipse_that_misses_the_ends_of_its_arc_passes_through_them():
    one, notes = mpq(1), []
    form = [one / 9, mpq(0), one / 4, mpq(0), mpq(0), -one]
    start, end = (mpq(3) + mpq(1, 10**7), mpq(0)), (mpq(1, 10**8), mpq(2))
    found, last = through_ends(form, start, end, mpq(1, 10**5), notes)
    for x, y in (start, last):
        assert found[0] * x * x + found[2] * y * y + found[5] == 0
    assert len(notes) == 2
    assert abs(last[0] - end[0]) + abs(last[1] - end[1]) < mpq(1, 10**6)
    with pytest.raises(ShapeError, match="not near"):
        through_ends(form, (mpq(4), mpq(0)), end, mpq(1, 10**5), [])


@given(st.integers(1, 5), st.integers(1, 7), st.integers(0, 4), st.randoms(use_true_random=False))
def test_one_period_is_continued_by_the_period(degree, count, times, random):
    """Of any multiplicities: the knots repeat by the period, and there are as many control points as they need."""
    times = min(times, degree - 1) + 1
    inner = sorted(random.choice(range(1, 8)) for _ in range(max(count - times, 0)))
    if any(inner.count(t) > degree for t in inner):
        return
    knots = [mpq(t) for t in [0] * times + inner + [8] * times]
    points = len(knots) - times
    full, more, notes = whole(degree, knots, points)
    assert len(full) == points + more + degree + 1
    assert all(b - a == 8 for a, b in zip(full, full[points:], strict=False))
    assert (full[degree], full[-degree - 1]) == (0, 8)
    assert notes


def test_a_radius_of_zero_is_named():
    with pytest.raises(ShapeError, match="radius 0"):
        Round(Affine([[0, 0, 1], [0, 0, 2]]), None)


def test_a_spline_without_its_end_knots_is_named():
    words = "0 SPLINE 70 8 71 3 72 6 73 4 40 0 40 0 40 0 40 1 40 1 40 1 10 0 20 0 10 1 20 1 10 2 20 1 10 3 20 0"
    assert "as openNURBS writes them" in read(dxf(words)).skipped[0].why
