"""What is true of the zeros of every function of two parameters: the same curves, arcs and singular points after the
parameters are exchanged or turned, after the function is multiplied by one without zeros, and whatever knots cut it.
"""

from itertools import pairwise

import pytest
from gmpy2 import mpq

from exactspline import zero_curve
from exactspline.bivariate.zero_curve import FIRST_CUTS, ZeroCurve
from exactspline.bivariate.zero_lines import square_free, without_lines
from exactspline.numbers.intervals import UNIT
from exactspline.polynomials.two_parameters import S, T, as_form
from tests.support.squares import function

#: Curves in the square from −1 to 1, each with a point to be noticed.
CURVES = {
    "loops around each other": lambda x, y: (9 * x * x + 5 * y * y - 1) * (x * x + x * y + 2 * y * y - mpq(1, 2)),
    "loops that touch": lambda x, y: (9 * x * x + 4 * y * y - 1) * (x * x + 2 * y * y - mpq(1, 2)),
    "a node and a loop": lambda x, y: 2 * x**2 * (x + mpq(1, 2)) - y**2,
    "an irrational node": lambda x, y: (3 * x * x - 1) ** 2 - (y - x) ** 2,
    "a cusp upright": lambda x, y: (y - mpq(1, 3)) ** 3 - (x + mpq(1, 5)) ** 2,
    "a tacnode": lambda x, y: (x - mpq(1, 7)) ** 4 - y**2,
    "branches that touch and cross": lambda x, y: (y - x * x) * (y + 2 * x * x) * (y - x),
    "a cusp on the border": lambda x, y: (x + 1) ** 3 - y**2,
    "a node in a corner": lambda x, y: (2 * (x - 1) - (y + 1)) * ((x - 1) + 2 * (y + 1)) - (x - 1) ** 3,
    "touching the border": lambda x, y: (x * x + y * y - 1) * (x + y - mpq(1, 3)),
    "isolated points": lambda x, y: x**2 * (x - mpq(1, 2)) - y**2,
    "isolated at irrational places": lambda x, y: (2 * x * x - 1) ** 2 + (3 * y * y - 1) ** 2,
    "an isolated point on a branch": lambda x, y: (x * x + y**4) * (y - x * x + mpq(1, 5)),
    "lines": lambda x, y: (3 * x * x - 1) * (2 * y - 1) * (x + y),
    "a double curve": lambda x, y: (x * x - y * y * y) ** 2 * (x - mpq(1, 2)),
}  # fmt: skip


def told(found, back=lambda s, t: (s, t)):
    """The answer in numbers, in the parameters before a change of them."""

    def at(point):
        return tuple(round(x, 9) + 0 for x in back(*map(float, point)))

    assert found.complete
    arcs = [[*sorted(at(end) for end in (x.start, x.end) if end is not None), x.closed] for x in found.arcs]
    return (
        sorted(curve.shape for curve in found.curves),
        sorted(arcs, key=repr),
        sorted((at((x.first, x.second)), x.kind, x.multiplicity, x.milnor) for x in found.singular_points),
        sorted(at((x.first, x.second)) for x in found.points),
        len(found.lines),
    )


@pytest.mark.parametrize("name", CURVES)
def test_laws_of_curves_of_zeros(name):
    p = CURVES[name]
    plain = function(p, -1, 1)
    expected = told(zero_curve(plain))
    exchanged = function(lambda s, t: -3 * p(2 * t - 1, 2 * s - 1))
    assert told(zero_curve(exchanged), lambda s, t: (2 * t - 1, 2 * s - 1)) == expected
    turned = function(lambda x, y: p(-y, x) * (x + y * y + 3), -1, 1)
    assert told(zero_curve(turned), lambda x, y: (-y, x)) == expected
    cut = plain.insert_knot(0, mpq(2, 5)).insert_knot(1, mpq(0))
    assert told(zero_curve(cut)) == expected


@pytest.mark.parametrize("name", CURVES)
def test_arcs_join_and_their_points_are_on_the_curve(name):
    """Each arc begins where an earlier one ends, as far as the way is unique, and the form changes its sign there."""
    form, _ = without_lines(square_free(function(CURVES[name], -1, 1).patch_form(0, 0)), UNIT)
    curve = ZeroCurve(form)
    assert curve.complete
    for part in curve.parts:
        ends = part.ends
        assert (part.shape == "single point") == (not ends)
        if part.shape != "branches that cross" and not part.cells:
            joined = [{one.first, one.last} & {other.first, other.last} for one, other in pairwise(part.arcs)]
            assert all(joined)
            assert len({*part.vertices}) == len(part.arcs) + (part.shape == "arc from border to border")
            assert sorted({*ends.values()}) == [1, 2][part.shape == "closed loop" :][: len(part.arcs) + 1]
        for arc in part.arcs:
            points = curve.points(arc, 3)
            assert len(points) == 4
            for point, vertex in ((points[0], arc.first), (points[-1], arc.last)):
                assert all(abs(float(x) - float(y)) < 1e-2 for x, y in zip(point, curve.place(vertex), strict=True))
            along = [point[1 - arc.direction] for point in points]
            assert [along[1] - along[0]] * 3 == [b - a for a, b in pairwise(along)]
            for point in points[1:-1]:
                assert all(low <= x <= high for x, (low, high) in zip(point, arc.box, strict=True))
                step = arc.box[arc.direction].width / 2**23
                moved = [[x + by * (k == arc.direction) for k, x in enumerate(point)] for by in (-step, step)]
                assert curve.form.value(*moved[0]) * curve.form.value(*moved[1]) < 0


def test_zeros_of_different_forms_differ():
    one, other = (ZeroCurve(as_form((3 * S - 1) ** 2 + (3 * T - k) ** 2 - 1)) for k in (1, 2))
    assert one == ZeroCurve(one.form)
    assert one != other
    assert one != one.form
    assert len({one, ZeroCurve(one.form), other}) == 2


def test_a_line_on_which_the_square_is_cut_is_undecided(monkeypatch):
    """It is cut elsewhere where it can be: else the sides of boxes are zeros, and no box is a graph."""
    form = as_form((61 * S - 29) * (T * T + S + 1))
    curve = ZeroCurve(form)
    assert (curve.complete, [part.shape for part in curve.parts]) == (True, ["arc from border to border"])
    monkeypatch.setattr("exactspline.bivariate.zero_curve.FIRST_CUTS", FIRST_CUTS[:1])
    curve = ZeroCurve(form)
    assert {box.first for box in curve.undecided} == {(0, FIRST_CUTS[0]), (FIRST_CUTS[0], 1)}
    assert curve.parts == ()


@pytest.mark.parametrize(("line", "middle"), [(mpq(45, 61), mpq(3, 5)), (mpq(29, 122), mpq(7, 20))])
def test_no_box_is_halved_along_a_line_of_zeros(line, middle):
    """The line is in the middle of a part of the square, beside a loop for which the part is halved."""
    circle = (100 * S - int(100 * middle)) ** 2 + (100 * T - 30) ** 2 - 9
    curve = ZeroCurve(as_form((int(line.denominator) * S - int(line.numerator)) * circle))
    assert (curve.complete, sorted(part.shape for part in curve.parts)) == (
        True,
        ["arc from border to border", "closed loop"],
    )


def test_more_boxes_than_the_limit_are_undecided(monkeypatch):
    """Nothing is lost: the zeros are in boxes that are graphs, and in those that remain."""
    form = as_form((8 * S - 2) ** 2 + (8 * T - 2) ** 2 - 1)
    whole, near, counts = ZeroCurve(form), mpq(1, 2**20), []
    for limit in (1, 6):
        monkeypatch.setattr("exactspline.bivariate.zero_curve.BOXES", limit)
        curve = ZeroCurve(form)
        boxes = [*curve.undecided, *(arc.box for part in curve.parts for arc in part.arcs)]
        for part in whole.parts:
            for arc in part.arcs:
                (x, y), _ = whole.points(arc, 1)
                assert any(a - near <= x <= b + near and c - near <= y <= d + near for (a, b), (c, d) in boxes)
        counts.append(len(boxes))
    assert counts[0] < counts[1] < 6 * 6
    assert not curve.complete
    monkeypatch.undo()

    def longest(box):
        return max(side.width for side in box)

    monkeypatch.setattr("exactspline.bivariate.zero_curve.is_small", lambda box, form: longest(box) <= mpq(1, 3))
    undecided = ZeroCurve(form).undecided
    assert undecided
    assert all(mpq(1, 6) < longest(box) <= mpq(1, 3) for box in undecided)
