"""Cusps of parallel curves: a question added by one entry, held against evaluation of the speed 1 − dκ."""

from itertools import pairwise

import pytest
from gmpy2 import mpq
from mpmath import mp

import exactspline as xs
from exactspline import analyse
from exactspline.errors import ShapeError
from workshop.vectors.items import items

PLANE = [name for name in xs.examples("curves") if xs.example(name).dimension == 2]


def speeds(curve, distance, samples=400):
    """1 − dκ at many parameters inside segments, in 50 digits, None where γ′ = 0."""
    found = []
    for a, b in pairwise(curve.breakpoints):
        for k in range(1, samples):
            t = a + (b - a) * mpq(k, samples)
            try:
                curvature = xs.curvature(curve, t)
            except xs.ExactSplineError:
                found.append((t, None))
                continue
            found.append((t, 1 - mp.mpf(str(distance)) * mp.mpf(str(float(curvature)))))
    return found


@pytest.mark.parametrize("name", PLANE)
@pytest.mark.parametrize("distance", ["1/2", "-1/3", "2"])
def test_the_speed_changes_its_sign_where_a_cusp_is_found_and_nowhere_else(name, distance):
    curve = xs.example(name)
    found = analyse(curve).offset_cusps(distance)
    cusps = [f.root for f in found if f.kind == "cusp"]
    values = [(t, v) for t, v in speeds(curve, float(mpq(distance)), 60) if v is not None]
    for (s, v), (t, w) in pairwise(values):
        if any(s <= b <= t for b in curve.breakpoints) or any(p.start <= s <= p.end for p in found.everywhere):
            continue
        if any(s < f.root < t for f in analyse(curve).singular_points):
            continue
        assert (v * w < 0) == (sum(s < root < t for root in cusps) % 2 == 1), (s, t)


def test_of_what_it_is_not_asked():
    with pytest.raises(ShapeError, match="plane curve"):
        analyse(xs.example("twisted_cubic")).offset_cusps(1)
    with pytest.raises(ShapeError, match="not 0"):
        analyse(xs.example("ellipse")).offset_cusps(0)


def test_an_arc_shrinks_to_its_centre():
    circle = xs.example("circle")
    assert [str(piece) for piece in analyse(circle).offset_cusps(1).everywhere] == ["[0, 4]"]
    assert not analyse(circle).offset_cusps(-1)
    assert not analyse(circle).offset_cusps("1/2")
    assert [item.what for item in items(circle, "offset_cusps:1")] == ["everywhere"]


def test_doubles_of_17_digits():
    points = [(0.1, 0.7071067811865476), (1.3333333333333333, 2.2), (2.718281828459045, -2.1), (3.14159265358979, 0.5)]
    curve = xs.Nurbs.from_floats(3, [0] * 4 + [1] * 4, points)
    for distance in ("1/7", "0.30000000000000004", "-5"):
        for f in analyse(curve).offset_cusps(distance):
            value = xs.curvature(curve, f.root)
            assert abs(float(value) * float(mpq(xs.rational(distance))) - 1) < 1e-12


@pytest.mark.parametrize("distance", ["1/100", "1", "-1", "100", "-100"])
def test_where_the_curvature_jumps_its_sign_counts(distance):
    """False before: a cusp where κ jumps from -2/d to 1/(2d), and none where it jumps from -2/d to 2/d."""
    curve = xs.Nurbs(2, [0, 0, 0, 1, 2, 2, 2], [(0, 0), (1, 2), (3, -2), (4, 0)])
    (joint,) = analyse(curve).joints
    left, right = joint.curvatures
    d = xs.rational(distance)
    jumps = [f for f in analyse(curve).offset_cusps(d) if f.by_jump]
    assert bool(jumps) == ((1 - d * left).sign * (1 - d * right).sign < 0)


@pytest.mark.parametrize(
    ("bend", "kinds"),
    [("1/2", [("stop", True)]), (2, [("cusp", True)]), (1, [("stop", False)]), (-1, [("stop", True)])],
)
@pytest.mark.parametrize("turned", [False, True])
@pytest.mark.parametrize("sign", [1, -1])
def test_a_speed_that_vanishes_on_one_side_of_a_knot(bend, kinds, turned, sign):
    """Before: nothing, where κ jumps and 1 − dκ = 0 on exactly one side. Left of 0 the curve is y = x²/2, with κ < 1
    and κ = 1 at 0; behind it y = bend · x²/2.
    """
    k = xs.rational(bend) / 2
    points = [(-1, "1/2"), ("-1/2", 0), (0, 0), ("1/2", 0), (1, k)]
    curve = xs.Nurbs(2, [-1] * 3 + [0, 0] + [1] * 3, [(x, sign * xs.rational(y)) for x, y in points])
    if turned:
        sign, curve = -sign, xs.Nurbs(2, curve.knots, curve.control_points[::-1])
    found = [f for f in analyse(curve).offset_cusps(sign) if f.root == 0]
    assert [(f.kind.value, f.by_jump) for f in found] == kinds
