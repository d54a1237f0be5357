"""Bisector surfaces as a user calls them: against the definition, in pieces, and on degenerate input."""

from fractions import Fraction
from itertools import pairwise, product
from random import Random

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from exactspline import Nurbs, example, examples, formula_of, zeros
from exactspline.errors import FormulaError, ShapeError
from exactspline.geometry.bisectors.point_and_curve import AXES, point_bisector
from exactspline.geometry.bisectors.two_curves import CURVE_FORMS, curve_bisector
from tests.support.bisector_oracle import mapped
from tests.support.dials import factors, over_dials
from tests.support.strategies import nurbs

SPACE = [name for name in examples("curves") if example(name).dimension == 3]
PAIRS = [
    ("rational_space_cubic", "twisted_cubic"),
    ("helix_like", "ellipse_in_space"),
    ("rational_space_cubic_spline", "space_quartic"),
]


def square(a, b):
    return sum((x - y) ** 2 for x, y in zip(a, b, strict=True))


def slope(curve, t, b):
    """(B − γ)·D1: zero when B lies in the normal plane."""
    return sum((y - x) * d(t) for x, y, d in zip(curve(t), b, formula_of("D1")(curve), strict=True))


def places(interval, count=3):
    a, b = interval
    return [a + (b - a) * mpq(2 * k + 1, 2 * count + 1) for k in range(count)]


@pytest.mark.parametrize("variant", [*CURVE_FORMS, "minimal"])
@pytest.mark.parametrize(("one", "other"), PAIRS)
def test_a_bisector_point_lies_in_both_normal_planes_and_is_equidistant(one, other, variant):
    """At every size of numbers it is so by the sample of `tests.campaigns.bisectors`."""
    first, second = example(one), example(other)
    found = curve_bisector(first, second, variant)
    assert found.unreduced == ()
    for patch in found.patches:
        for s, t in product(*map(places, patch.sides)):
            b = patch.value(s, t)
            assert slope(first, s, b) == 0
            assert slope(second, t, b) == 0
            assert square(b, first(s)) == square(b, second(t))


def test_the_minimal_form_loses_a_degree_in_each_parameter():
    first, second = example("rational_space_cubic"), example("rational_space_cubic_spline")
    symmetric, minimal = (
        curve_bisector(first, second, variant).patches[0].value for variant in ("symmetric", "minimal")
    )
    assert tuple(symmetric.degree) == (11, 11)
    assert tuple(minimal.degree) == (10, 10)
    assert symmetric == minimal


@pytest.mark.parametrize("name", SPACE)
@pytest.mark.parametrize("point", [("1/2", "1/3", 2), (0, 0, 0), (-1, 4, "-7/3")])
def test_a_ruled_bisector_is_a_bisector(name, point):
    curve, q = example(name), tuple(mpq(Fraction(x)) for x in point)
    try:
        found = point_bisector(curve, point)
    except ShapeError:
        assert formula_of("point_bisector_generator_polynomial")(curve.with_point(q)).is_zero
        return
    for piece in found.pieces:
        k = AXES.index(piece.moved)
        for s, height in product(places(piece.interval), (0, mpq(-5, 2))):
            b = piece.surface.at(height)(s)
            assert slope(curve, s, b) == 0
            assert square(b, curve(s)) == square(b, q)
            assert b[k] == height


@pytest.mark.parametrize("name", SPACE)
@pytest.mark.parametrize("point", [("1/2", "1/3", 2), (0, 0, 0), (1, 1, 1)])
def test_the_pieces_cover_the_curve_and_have_no_pole_but_the_singular_parameters(name, point):
    curve = example(name)
    try:
        found = point_bisector(curve, point)
    except ShapeError:
        return
    covered = sorted([piece.interval for piece in found.pieces] + [interval for interval, _ in found.missing])
    assert covered[0][0] == curve.domain[0]
    assert covered[-1][1] == curve.domain[1]
    assert all(a[1] == b[0] for a, b in pairwise(covered))
    for piece in found.pieces:
        for root in zeros(piece.surface.directrix.denominator):
            assert any(root == singular for singular in found.singular)


@pytest.mark.parametrize("name", ["helix_like", "ellipse_in_space", "rational_space_cubic"])
def test_explicit_and_direct_form_are_one_surface(name):
    """A point of the one lies on the line of the other with the same foot."""
    curve, point = example(name), (1, -2, "1/2")
    direct, explicit = point_bisector(curve, point), point_bisector(curve, point, "explicit")
    for piece in direct.pieces:
        for s in places(piece.interval):
            whole = next(p.surface for p in explicit.pieces if p.interval[0] <= s <= p.interval[1])
            offset = [a - b for a, b in zip(piece.surface.directrix(s), whole.directrix(s), strict=True)]
            g = whole.generator(s)
            assert [offset[i] * g[j] - offset[j] * g[i] for i, j in ((0, 1), (1, 2), (2, 0))] == [0, 0, 0]


def test_a_generator_is_evaluated_whether_it_is_a_quotient_or_not():
    """On a polynomial curve the generator of the explicit form is a vector of splines."""
    surface = point_bisector(example("twisted_cubic"), (1, 2, 3), "explicit").pieces[0].surface
    line = [b - a for a, b in zip(surface.at(0)("1/3"), surface.at(1)("1/3"), strict=True)]
    assert list(surface.generator("1/3")) == line


def test_degrees_of_figures_4_and_5():
    for name in ("helix_like", "ellipse_in_space"):
        assert {piece.surface.degree for piece in point_bisector(example(name), (1, 1, 2)).pieces} == {7}
        assert {piece.surface.degree for piece in point_bisector(example(name), (1, 1, 2), "explicit").pieces} == {17}


def test_the_planar_bisector_is_an_iso_curve_of_the_direct_form_in_planes_of_constant_height_only():
    """In the plane z = x the direct surface meets the plane of curve and point at a height that changes; the explicit
    directrix stays in it.
    """
    curve, point = Nurbs(2, [0, 0, 0, 1, 1, 1], [(-1, 1, -1), (0, -1, 0), (1, 1, 1)]), (0, 3, 0)
    explicit = point_bisector(curve, point, "explicit").pieces[0].surface.directrix
    direct = point_bisector(curve, point).pieces[0].surface
    heights = []
    for s in ("1/4", "1/3"):
        x, _, z = explicit(s)
        assert x == z
        low, slope_up = ((b[2] - b[0]) for b in (direct.directrix(s), direct.generator(s)))
        heights.append(-low / slope_up)
    assert heights[0] != heights[1]


# ---- degenerate input


def test_a_point_on_the_curve_is_a_singular_parameter():
    found = point_bisector(example("twisted_cubic"), (0, 0, 0))
    assert [root.exact for root in found.singular] == [0]


def two_parabolas(*points):
    return Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 2], points)


AHEAD, ASIDE = (2, 0, 0), (1, 2, 0)


@pytest.mark.parametrize(
    ("curve", "singular"),
    [
        (two_parabolas((0, 0, 0), (1, 0, 0), AHEAD, (3, 0, 0), (4, 1, 1)), [1]),
        (two_parabolas((0, 0, 0), (1, 0, 0), AHEAD, (3, 1, 0), (4, 1, 1)), []),
        (two_parabolas((0, 1, 1), (1, 0, 0), AHEAD, (3, 1, 0), (4, 1, 1)), [1]),
        (two_parabolas((0, 1, 1), ASIDE, ASIDE, (3, 1, 0), (4, 1, 1)), [1]),
    ],
    ids=[
        "after a missing piece",
        "missing piece, then a corner",
        "corner with one tangent through the point",
        "stop before a corner",
    ],
)
def test_a_parameter_may_be_singular_from_one_side(curve, singular):
    """The generator vanishes at the knot from one side only; the surface has a pole there, from that side."""
    found = point_bisector(curve, (-1, 0, 0))
    assert [root.exact for root in found.singular] == singular
    denominators = [piece.surface.directrix.denominator for piece in found.pieces]
    assert sorted({t for w in denominators for t in w.breakpoints if 0 in (w(t, "left"), w(t, "right"))}) == singular


def test_a_curve_that_stands_still_has_no_normals():
    standing = Nurbs(1, [0, 0, 1, 2, 3, 3], [(0, 0, 0), (1, 0, 0), (1, 0, 0), (1, 2, 3)])
    assert [
        (interval, "stands still" in reason) for interval, reason in point_bisector(standing, (-1, 5, 0)).missing
    ] == [((1, 2), True)]
    assert all("stands still" in reason for _, reason in curve_bisector(standing, example("twisted_cubic")).missing)
    with pytest.raises(ShapeError, match="the curve is one point"):
        point_bisector(Nurbs(1, [0, 0, 1, 1], [(1, 0, 0), (1, 0, 0)]), (-1, 5, 0))


def test_a_line_through_the_point_has_no_bisector_surface():
    with pytest.raises(ShapeError, match="passes through the point"):
        point_bisector(example("space_line"), example("space_line")(0))


def test_curves_in_one_plane_have_no_surface_but_lines_and_planes():
    found = curve_bisector(example("ellipse_in_space"), example("ellipse_in_space"))
    assert found.patches == ()
    assert all("one plane" in reason for _, reason in found.missing)
    assert {plane.equation.text for plane in found.planes} == {"s - t"}
    assert len(found.lines) > 0


def test_curves_with_pieces_in_one_plane_lack_these_patches():
    def polygon(*points):
        return Nurbs(1, [0, 0, 1, 2, 2], points)

    found = curve_bisector(polygon((0, 0, 0), (1, 0, 0), (1, 1, 0)), polygon((0, 3, 0), (2, 4, 0), (2, 5, 1)))
    assert len(found.missing) == 2
    assert all("one plane" in reason for _, reason in found.missing)
    assert len(found.patches) == 2
    with pytest.raises(ShapeError, match="no surface"):
        found("1/2", "1/2")
    b = found("1/2", "3/2")
    assert square(b, (mpq(1, 2), 0, 0)) == square(b, (2, mpq(9, 2), mpq(1, 2)))


def test_a_curve_and_itself_meet_on_the_diagonal():
    """On the diagonal the system is singular; the variant in lowest terms goes on to a point of the normal plane."""
    c = example("rational_space_cubic")
    with pytest.raises(ZeroDivisionError):
        curve_bisector(c, c, "symmetric")("1/2", "1/2")
    found = curve_bisector(c, c)
    assert slope(c, mpq(1, 2), found("1/2", "1/2")) == 0
    b = found("1/3", "1/2")
    assert square(b, c("1/3")) == square(b, c("1/2"))


def test_bad_input_is_refused():
    with pytest.raises(ShapeError, match="R2"):
        curve_bisector(example("circle"), example("helix_like"))
    with pytest.raises(FormulaError, match=r"the variant .* is unknown"):
        curve_bisector(example("helix_like"), example("twisted_cubic"), "best")
    with pytest.raises(FormulaError, match=r"the variant .* is unknown"):
        point_bisector(example("helix_like"), (0, 0, 0), "best")
    with pytest.raises(ShapeError, match="2 coordinates"):
        point_bisector(example("helix_like"), (0, 0))


@given(nurbs(dimension=3, low=1, high=2, most=1), st.tuples(*[st.integers(-3, 3)] * 3))
def test_random_curves_and_points(curve, point):
    generator = formula_of("point_bisector_generator_polynomial")(curve.with_point(tuple(map(mpq, point))))
    if generator.is_zero:
        with pytest.raises(ShapeError, match=r"passes through the point|stands still|is one point"):
            point_bisector(curve, point)
        return
    found = point_bisector(curve, point)
    for piece in found.pieces:
        s = next(s for s in places(piece.interval, 5) if s not in found.singular)
        b = piece.surface.at(1)(s)
        assert slope(curve, s, b) == 0
        assert square(b, curve(s)) == square(b, tuple(map(mpq, point)))


@over_dials
@pytest.mark.parametrize("name", ["helix_like", "ellipse_in_space"])
def test_a_ruled_bisector_at_every_dial(name, number):
    """Before: the curves of the examples alone, whose numbers are short."""
    random = Random(3)
    a, b, c, d, e, f = factors(number, random, 6)
    curve = mapped(example(name), lambda x, y, z: (a * x + b, c * y + d, e * z + f))
    point = tuple(factors(number, random, 3))
    for piece in point_bisector(curve, point).pieces:
        s = places(piece.interval, 1)[0]
        for zeta in (0, 1):
            b = piece.surface.at(zeta)(s)
            assert slope(curve, s, b) == 0
            assert square(b, curve(s)) == square(b, point)
