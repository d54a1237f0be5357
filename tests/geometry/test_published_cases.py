"""Intersections that other programs got wrong, as their users reported them; and the test cases of the library bezier,
where they are at hand.
"""

import json
import os
from fractions import Fraction
from pathlib import Path

import pytest

from exactspline import example, intersections, nearest
from tests.campaigns.intersections import difference
from tests.support.bisector_oracle import bezier

#: The folder ``tests/functional`` of https://github.com/dhermes/bezier, which is not part of this project.
CASES = os.environ.get("EXACTSPLINE_BEZIER_CASES", "")
#: Their expected parameters are doubles.
NEAR = 2e-15


def test_overlaps_tangents_and_ends():
    """axom#71: overlapping curves, tangent ones and those that meet at the end of an interval are not handled, and
    curves whose control points crowd at one end are feared.
    """
    cubic = bezier((0, 0), (1, 2), (2, -1), (3, 1))
    (arc,) = intersections(cubic, cubic.restrict("1/3", "2/3")).everywhere
    assert [str(s) for s in arc.first] == ["1/3", "2/3"]
    (touched,) = intersections(bezier((0, 1), (1, -1), (2, 1)), bezier((0, 0), (2, 0)))
    assert (str(touched.kind), touched.multiplicity) == ("touching", 2)
    (end,) = intersections(cubic, bezier((3, 1), (4, 4)))
    assert (end.first, end.second, str(end.kind)) == (1, 0, "end")
    crowded = bezier((0, 0), *[(Fraction(k, 10**6), Fraction(k * k, 10**6)) for k in range(1, 7)], (1, 1))
    diagonal, found = bezier((0, 1), (1, 0)), intersections(crowded, bezier((0, 1), (1, 0)))
    assert len(found) == 1
    assert [round(float(x), 12) for x in found[0].point] == [
        round(float(x), 12) for x in diagonal(found[0].second.enclosure(40).middle)
    ]


def test_circles_that_touch_at_knots_of_both():
    """axom#1869: none of the arcs of circles of radius 1 around (0, 0) and (2, 0) are found to touch at (1, 0)."""
    circle = example("circle")
    other = circle.transform([[1, 0, 2], [0, 1, 0]])
    (found,) = intersections(circle, other)
    assert (found.point, str(found.kind), found.multiplicity, found.at_knot) == ((1, 0), "touching", 2, (True, True))
    for start, first in ((0, circle.restrict(0, 1)), (3, circle.restrict(3, 4))):
        for end, second in ((1, other.restrict(1, 2)), (2, other.restrict(2, 3))):
            (found,) = intersections(first, second)
            assert (found.first, found.second, str(found.kind)) == ((0 if start == 0 else 4), 2, "end"), (start, end)


def as_campaign(*points):
    """Rows of a polynomial curve, for the oracle."""
    return [(*map(Fraction, p), Fraction(1)) for p in points]


def test_a_line_and_a_parabola():
    """bezier#234: the crossing is not found before one of the curves is subdivided."""
    line = as_campaign((2.8888563469481592, 10.700182708846356), (-1.5080712474161317, -8.8105073796645534))
    parabola = as_campaign((0, 0), (0.5, 0.20000000298023224), (1, 0))
    assert difference(line, parabola, {}) == ("", 1)


def test_a_point_next_to_an_almost_straight_cubic():
    """kurbo#446: a point 0.17 away is told, though one of the curve is 3·10⁻¹² away at the parameter `near`."""
    curve = bezier((461, 123), (Fraction(460.99999999999994), Fraction(123.00000000000004)), (111, 319), (111, 319))
    x, y = map(Fraction, (282.0379003395483, 223.21877580985594))

    def squared(t):
        rest = 1 - t
        p, q = (
            sum(c * Fraction(k) for c, k in zip((rest**3, 3 * rest**2 * t, 3 * rest * t**2, t**3), own, strict=True))
            for own in ((461, 460.99999999999994, 111, 111), (123, 123.00000000000004, 319, 319))
        )
        return (p - x) ** 2 + (q - y) ** 2

    (found,) = nearest(curve, (x, y))
    low, high = (Fraction(int(t.numerator), int(t.denominator)) for t in found.parameter.enclosure(40))
    middle, step = (low + high) / 2, Fraction(1, 10**30)
    assert squared(middle) < squared(middle - step)
    assert squared(middle) < squared(middle + step)
    assert squared(middle) <= min(squared(Fraction(k, 997)) for k in range(998))
    assert squared(middle) <= squared(Fraction(0.5075474297354187)) < Fraction(1, 10**22)


@pytest.mark.parametrize(("last", "count"), [((3, 0), 1), ((-0.19959947101662578, 0.20031960128096571), 0)])
def test_cubics_that_an_arrangement_does_not_take(last, count):
    """CGAL#9176: an assertion fails for the second of these first curves, which has a loop."""
    first = as_campaign((0, 0), (1, 2), (2, -1), last)
    other = as_campaign((-2, 6), (2, 3 + 1 / 3), (3 + 1 / 3, 1 / 3), (2, -3))
    assert difference(first, other, {}) == ("", count)
    assert difference(first, first, {"itself": True}) == ("", 1 - count)


# ---- the cases of the library bezier


def exact(number):
    if isinstance(number, str):
        return Fraction(float.fromhex(number)) if "0x" in number else Fraction(number)
    return Fraction(number)


def cases():
    folder = Path(CASES)
    curves = json.loads((folder / "curves.json").read_text(encoding="utf-8"))
    for case in json.loads((folder / "curve_intersections.json").read_text(encoding="utf-8")):
        points = [curves[case[name]]["control_points"] for name in ("curve1", "curve2")]
        yield case, *[bezier(*zip(*[map(exact, x) for x in each], strict=True)) for each in points]


@pytest.mark.skipif(not CASES, reason="EXACTSPLINE_BEZIER_CASES is not set")
def test_the_cases_of_bezier():
    """53 pairs: every pair of parameters that is expected there, and no other. Of the curves of number 46 it is said
    there that they touch up to the precision of doubles: as given they cross twice within 10⁻⁸.
    """
    different = []
    for case, *pair in cases():
        found = intersections(*pair)
        assert not found.undecided
        ours = [(float(p.first), float(p.second)) for p in found]
        assert case["type"] == "coincident" or not found.everywhere
        for arc in found.everywhere:
            ours += [(float(s), float(t)) for s, t in zip(arc.first, arc.second, strict=True)]
        theirs = zip(*[[float(exact(x)) for x in case[f"curve{k}_params"]] for k in "12"], strict=True)
        if not agree(sorted(ours), sorted(theirs)):
            different.append((case["id"], ours))
    ((number, ours),) = different
    assert (number, len(ours)) == (46, 4)
    assert 0 < ours[1][0] - ours[0][0] < 1e-8


def agree(ours, theirs):
    return len(ours) == len(theirs) and all(
        abs(a - b) <= NEAR for p, q in zip(ours, theirs, strict=True) for a, b in zip(p, q, strict=True)
    )
