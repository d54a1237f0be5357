"""Exact circles and conics: on their equation, from end to end, the right way round, with positive weights."""

import math
from itertools import pairwise

import pytest
from gmpy2 import mpq
from hypothesis import assume, given
from hypothesis import strategies as st

from exactspline import circle
from exactspline.constructors import arc, conic, ellipse
from exactspline.errors import ShapeError
from exactspline.interchange.segments import DEGREES, RADIANS, Affine, quarter_turns

numbers = st.builds(mpq, st.integers(-20, 20), st.integers(1, 7))
circle_points = st.one_of(
    st.sampled_from([(1, 0), (0, 1), (-1, 0), (0, -1)]),
    numbers.map(lambda t: ((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t))),
)


def samples(curve, count=12):
    a, b = curve.domain
    return [curve(a + (b - a) * i / count) for i in range(count)] + [curve(b, "left")]


def angle(u, v):
    """The angle counter-clockwise from u to v, a full turn when they agree."""
    if u == v:
        return 2 * math.pi
    return (math.atan2(float(v[1]), float(v[0])) - math.atan2(float(u[1]), float(u[0]))) % (2 * math.pi)


def turned(points):
    """By how much the direction from the origin turns along the points, from float angles."""
    angles = [math.atan2(float(y), float(x)) for x, y in points]
    return sum((b - a + math.pi) % (2 * math.pi) - math.pi for a, b in pairwise(angles))


@given(circle_points, circle_points, numbers, numbers, numbers)
def test_an_arc_is_on_its_circle_and_runs_counter_clockwise(u, v, x, y, scale):
    assume(scale)
    start, end = ((x + scale * p, y + scale * q) for p, q in (u, v))
    curve = arc((x, y), start, end)
    assert (curve(curve.domain[0]), curve(curve.domain[1], "left")) == (start, end)
    assert min(curve.weights) > 0
    around = [(p - x, q - y) for p, q in samples(curve, 16)]
    assert all(p * p + q * q == scale * scale for p, q in around)
    assert turned(around) == pytest.approx(angle(u, v), abs=1e-9)


@given(circle_points, circle_points, st.lists(numbers, min_size=4, max_size=4), numbers, numbers)
def test_an_arc_of_any_ellipse(u, v, linear, x, y):
    """The unit circle, moved by an affine map: its equation moves by the inverse map."""
    a, b, c, d = linear
    determinant = a * d - b * c
    assume(determinant > 0)
    moved = Affine([[a, b, x], [c, d, y]])
    # |M⁻¹ (p − shift)|² = 1, multiplied by the determinant squared
    p, q, r = c * c + d * d, -2 * (a * c + b * d), a * a + b * b
    form = [p, q, r, -2 * p * x - q * y, -q * x - 2 * r * y, p * x * x + q * x * y + r * y * y - determinant**2]
    start, end = moved(u), moved(v)
    curve = conic(form, start, end)
    assert (curve(curve.domain[0]), curve(curve.domain[1], "left")) == (start, end)
    assert min(curve.weights) > 0
    points = samples(curve, 10)
    for px, py in points:
        assert sum(k * m for k, m in zip(form, (px * px, px * py, py * py, px, py, 1))) == 0
    back = [((d * (px - x) - b * (py - y)), (-c * (px - x) + a * (py - y))) for px, py in points]
    assert turned(back) == pytest.approx(angle(u, v), abs=1e-9)


def test_parabola_and_hyperbola():
    for form, start, end in (
        ([1, 0, 0, 0, -1, 0], (-2, 4), (3, 9)),
        ([0, 1, 0, 0, 0, -1], ("1/5", 5), (3, "1/3")),
        ([1, 0, -1, 0, 0, -1], ("5/3", "4/3"), ("5/4", "-3/4")),
    ):
        curve = conic(form, start, end)
        assert min(curve.weights) > 0
        for x, y in samples(curve):
            assert sum(k * m for k, m in zip(form, (x * x, x * y, y * y, x, y, 1))) == 0


@pytest.mark.parametrize(("form", "start", "end", "why"), [
    ([1, 0, 1, 0, 0, -1], (1, 0), (1, 1), "not exactly on the conic"),
    ([0, 1, 0, 0, 0, -1], (1, 1), (-1, -1), "no such arc"),
    ([0, 1, 0, 0, 0, -1], (1, 1), (-2, "-1/2"), "different branches"),
    ([0, 1, 0, 0, 0, -1], (1, 1), (1, 1), "not closed"),
    ([1, 0, -1, 0, 0, 0], (1, 1), (2, 2), "pair of lines"),
    ([1, 0, 1, 0, 0, 0], (0, 0), (0, 0), "pair of lines"),
    ([0, 0, 0, 0, 0, 0], (0, 0), (1, 1), "pair of lines"),
    ([0, 0, 0, 1, 0, 0], (0, 0), (0, 1), "pair of lines"),
])  # fmt: skip
def test_what_is_no_conic_arc_is_refused(form, start, end, why):
    with pytest.raises(ShapeError, match=why):
        conic(form, start, end)


def test_circles_that_are_none():
    with pytest.raises(ShapeError, match="positive"):
        circle((0, 0), 0)
    with pytest.raises(ShapeError, match="one circle"):
        arc((0, 0), (1, 0), (0, "1.0000001"))
    assert ellipse((0, 0), (1, 0), (0, 2)).closed


@pytest.mark.parametrize(("text", "turns"), [
    ("0", 0), ("0.0", 0), ("6.283185307179586", 4), ("3.141592653589793", 2), ("1.5707963268", 1), ("-1.57079633", -1),
    ("4.71238898038469", 3), ("31.41592653589793", 20),
])  # fmt: skip
def test_decimals_that_mean_right_angles(text, turns):
    assert quarter_turns(mpq(text), RADIANS, last_digit(text)) == turns


def last_digit(text):
    return mpq(1, 10 ** len(text.partition(".")[2]))


@pytest.mark.parametrize("text", ["1", "3", "3.14", "1.57", "1.5708963", "1.570796326794890"])
def test_decimals_that_do_not(text):
    """A decimal that its own last digit tells apart from the multiple of π/2 is none, nor is one of two digits."""
    assert quarter_turns(mpq(text), RADIANS, last_digit(text)) is None


def test_degrees_and_radians_are_near_to_right_angles_by_one_rule():
    """Rounded to its last digit, a multiple of 90 degrees is itself; doubles beside it are roundings of it."""
    for degrees in ("-270", "-270.00000000000006", "-269.9999999999999"):
        assert quarter_turns(mpq(degrees), DEGREES, last_digit(degrees)) == -3
    assert quarter_turns(mpq("0.000000000000006"), DEGREES, mpq("1e-15")) == 0
    for degrees in ("90.000000000001", "89.99999", "90.1", "89"):
        assert quarter_turns(mpq(degrees), DEGREES, last_digit(degrees)) is None
    for k in range(-8, 9):
        for unit, right in ((math.pi / 2, RADIANS), (90.0, DEGREES)):
            for double in (k * unit, math.nextafter(k * unit, math.inf), math.nextafter(k * unit, -math.inf)):
                assert quarter_turns(mpq(*double.as_integer_ratio()), right) == k
