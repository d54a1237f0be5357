"""Places on surfaces: inside or on a border, singular or not, and the joints they lie on."""

import pytest
from gmpy2 import mpq

from exactspline import BSpline, NurbsSurface, TensorSpline, analyse, zeros
from exactspline.bivariate import common_zeros
from exactspline.bivariate.across_borders import Place
from exactspline.bivariate.borders import EDGES, vanishes_at
from exactspline.bivariate.common_zeros import CommonZero, zeros_of
from exactspline.geometry.surfaces.forms import lowest
from exactspline.geometry.surfaces.singular import Line, SingularPoints, ZerosOfFactor
from exactspline.numbers.intervals import UNIT, Box, Interval
from exactspline.polynomials.patch_forms import PatchForm
from exactspline.polynomials.two_parameters import S, T, as_form


def test_a_patch_is_regular_where_its_normal_vanishes_along_edges_at_most():
    edge, place = EDGES[0], Place(((0, 0),), CommonZero.at(UNIT, (mpq(0), mpq(0))))
    assert SingularPoints(edges=(edge,)).regular
    for told in (
        {"degenerate": True},
        {"places": (place,)},
        {"undecided": (UNIT,)},
        {"of_factor": ZerosOfFactor(lines=(Line(0, mpq(1)),))},
    ):
        assert not SingularPoints(edges=(edge,), **told).regular


def test_whether_an_irrational_zero_is_inside_is_decided_by_the_roots_on_the_border():
    """y = ε (4x − 1)(7 − 8x) meets 2x² = 1 so near to the border that only its roots tell it apart from one of them,
    with others on both sides of it; for ε = 0 it is a root itself, and for ε < 0 not on the patch.
    """
    ends = [0, 0, 1, 1]
    x, y = TensorSpline((1, 1), ends, ends, [[0, 0], [1, 1]]), TensorSpline((1, 1), ends, ends, [[0, 1], [0, 1]])
    sides = (x * 4 - 1) * (x * 8 - 7)
    for near in (0, mpq(1, 2**20), mpq(-1, 2**20), *[mpq(1, 2**k) for k in (50, 100, 200, 300)]):
        line, other = y + sides * near, sides * (x * x * 2 - 1) + y * 0
        found = zeros_of([f.patch_form(0, 0) for f in (line, other)]).zeros
        told = {tuple(round(float(a), 3) for a, _ in zero.refine(60)): zero.is_inside for zero in found}
        assert told.pop((0.707, 0.0), None) is (None if near < 0 else near > 0)
        assert told == {(0.25, 0.0): False, (0.875, 0.0): False}


def test_a_point_of_the_border_lies_on_a_form_in_corners_too():
    """x − y vanishes at (0, 0), not at (0, 1/3), whichever side the point was found on."""
    form = PatchForm.of_net([[0, -1], [1, 0]])
    (start,) = zeros(BSpline.bezier([0, 1]))
    (third,) = zeros(BSpline.bezier([-1, 2]))
    assert (start == 0, third == mpq(1, 3)) == (True, True)
    for place, on in (
        ((start, mpq(0)), True),
        ((mpq(0), start), True),
        ((mpq(0), third), False),
        ((third, mpq(0)), False),
    ):
        assert vanishes_at(form, place, UNIT) is on


@pytest.mark.parametrize("digits", [3, 30, 90])
def test_the_box_of_an_inner_zero_is_as_small_as_asked_for(digits):
    """Of x² + y² = 1 and x = y, on a patch that is 1000 long."""
    circle, line = (
        PatchForm.of_net([[-1, -1, 0], [-1, -1, 0], [0, 0, 1]]),
        PatchForm.of_net([[0, -1, -2], [1, 0, -1], [2, 1, 0]]),
    )
    (zero,) = zeros_of([circle, line], Box(Interval(mpq(0), mpq(1000)), Interval(mpq(-1), mpq(2)))).zeros
    (a, b), (c, d) = zero.box(digits)
    assert max(b - a, d - c) <= mpq(1, 10**digits)
    assert 2 * a * a <= 1000**2 <= 2 * b * b
    assert 2 * (c + 1) ** 2 <= 9 <= 2 * (d + 1) ** 2


@pytest.mark.parametrize(("steps", "torn"), [((0, 0, 1), [False, True]), ((0, 1, 1), [True, False])])
def test_a_surface_is_torn_at_its_own_knot(steps, torn):
    """Of three strips in either direction two neighbours do not fit."""
    ends = [0, 0, 1, 1, 2, 2, 3, 3]
    rows = [(x, z) for k, z in enumerate(steps) for x in (k, k + 1)]
    along_u = NurbsSurface((1, 1), ends, [0, 0, 1, 1], [[(x, y, z) for y in (0, 1)] for x, z in rows])
    along_v = NurbsSurface((1, 1), [0, 0, 1, 1], ends, [[(x, y, z) for x, z in rows] for y in (0, 1)])
    for surface, direction in ((along_u, "u"), (along_v, "v")):
        met = analyse(surface).joints
        told = [(one.across.value, one.value, one.kind == "torn") for one in met]
        assert told == [(direction, 1, torn[0]), (direction, 2, torn[1])]


@pytest.mark.parametrize("rows", [[[0, 0], [1, 1], [2, 2]], [[3, 3], [3, 3], [3, 3]], [[0, 1], [0, 1], [0, 1]]])
def test_lowest_degrees_are_the_true_ones(rows):
    """u, a constant, and v, as forms of degree (2, 1)."""
    f = TensorSpline((2, 1), [0, 0, 0, 2, 2, 2], [0, 0, 1, 1], rows)
    assert lowest(f).degree == f.true_degree
    assert lowest(f)(mpq(2, 3), mpq(1, 5)) == f(mpq(2, 3), mpq(1, 5))


@pytest.mark.parametrize(("third", "count", "undecided"), [(1, 0, 0), (0, 1, 0)])
def test_a_zero_of_two_forms_alone_is_no_common_zero(third, count, undecided):
    """Of forms two of which vanish at (√½, √½), whether the third vanishes there decides, for any choice of the two."""
    circle, line = S * S + T * T - 1, S - T
    other = (2 * S * T - 1) * 1000 + third
    for forms in ((circle, line, other), (other, line, circle), (line, other, circle)):
        found = zeros_of([as_form(p) for p in forms])
        assert (len(found.zeros), len(found.undecided)) == (count, undecided)


def test_a_cofactor_shows_that_a_form_vanishes_too(monkeypatch):
    """``(1 + S) f + (1 + T) g + h = 0``, so that each vanishes where the others do: nothing is eliminated."""
    f, g = S * S + T * T - 1, S - T
    forms = [as_form(p) for p in (f, g, -(1 + S) * f - (1 + T) * g)]
    cofactors = [[as_form(p)] for p in (1 + S, 1 + T, S * 0 + 1)]
    assert len(zeros_of(forms).zeros) == 1
    monkeypatch.setattr(common_zeros, "vanish_at", lambda *_: pytest.fail("the cofactor decides"))
    (zero,) = zeros_of(forms, cofactors=cofactors).zeros
    assert zero.is_inside
