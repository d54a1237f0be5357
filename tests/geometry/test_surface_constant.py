"""Where K is constant, in which directions a surface does not bend, and how it bends along curves on it: held against
definitions that share no formula with them; and statements that are false.
"""

import pytest
from gmpy2 import isqrt, mpq

from exactspline import NurbsSurface, analyse, example, formula_of
from exactspline.bivariate.signs import sign_on_patch
from exactspline.geometry.surfaces.forms import SurfaceForms, constant_curvature, has_curvature
from exactspline.language import Vector, cross, dot
from exactspline.language.arguments import Operands
from exactspline.language.kinds import FORMS, SURFACE
from exactspline.language.operand import Parameter
from exactspline.polynomials.patch_forms import PatchForm
from exactspline.readings import JetReading
from exactspline.readings.taylor import DoubleTaylorReading
from exactspline.symbolic.covariants import degree_on_patch
from tests.support.space_curves import TURNED

CURVED = ("ellipsoid", "torus", "cyclide", "rational_biquadratic", "monkey_saddle", "enneper")
PLACE = mpq(1, 3), mpq(2, 7)


def formula(name):
    return formula_of(f"surfaces:{name}")


def inside(surface, place=PLACE):
    (a, b), (c, d) = surface.domain
    return a + (b - a) * place[0], c + (d - c) * place[1]


# ---- constant curvature


@pytest.mark.parametrize("name", ["sphere", "cylinder", "cone", "developable", "torus", "ellipsoid", "enneper"])
def test_the_curvature_is_constant_exactly_where_it_is_that_of_two_places(name):
    """Held against K at places by its Taylor series there."""
    surface = example(name)
    values = set()
    for place in (PLACE, (mpq(3, 5), mpq(4, 7)), (mpq(1, 9), mpq(8, 9))):
        series = DoubleTaylorReading(surface, *inside(surface, place), 4).argument(SURFACE, 3)
        values.add(formula("gaussian_curvature")(series).value)
    found = analyse(surface).constant_curvature
    assert (found is not None) == (len(values) == 1) == (name in ("sphere", "cylinder", "cone", "developable"))
    assert found is None or values == {found}


@pytest.mark.parametrize("radius", [1, mpq(7, 3)])
def test_a_sphere_has_one_over_its_squared_radius_wherever_it_is(radius):
    turned = [[radius * mpq(x, 3) for x in row] + [5] for row in TURNED]
    found = analyse(example("sphere").transform(turned))
    assert found.constant_curvature == 1 / radius**2 == 1 / found.patches[0].radius_squared
    assert {one.curvature for one in found.patches} == {found.constant_curvature}


def test_no_constant_is_told_of_a_patch_that_agrees_in_points_only():
    forms = SurfaceForms(example("torus"))
    surface = forms.surface
    for place in (PLACE, (mpq(1, 11), mpq(5, 6))):
        value = formula("gaussian_curvature_lifted")(surface)(*inside(surface, place))
        assert not any(has_curvature(forms, patch, value) for patch in forms.patches)
    assert constant_curvature(forms, (0, 0)) is None


def test_patches_of_two_curvatures_have_none_in_common():
    """A flat patch beside one of a hyperbolic paraboloid, torn apart."""
    flat, saddle = [[(i, j, 0) for j in (0, 1)] for i in (-2, -1)], [[(i, j, i * j) for j in (0, 1)] for i in (0, 1)]
    found = analyse(NurbsSurface((1, 1), [0, 0, 1, 1, 2, 2], [0, 0, 1, 1], flat + saddle))
    assert [one.curvature for one in found.patches] == [0, None]
    assert found.constant_curvature is None


def test_a_form_that_touches_zero_on_an_edge_is_cut_there():
    """``(3y − 1)² + x²`` on the unit square: its zero is not a point of a subdivision into halves."""
    form = PatchForm.of_net([[1, -2, 4], [1, -2, 4], [2, -1, 5]])
    found = sign_on_patch(form)
    assert (found.sign, found.zeros) == ("positive except at single zeros", ((0, mpq(1, 3)),))
    below = PatchForm.of_net([[0, -3, 3], [0, -3, 3], [1, -2, 4]])
    assert sign_on_patch(below).sign == "both signs"


# ---- asymptotic directions


def coefficients(surface, u, v):
    """L, M, N by partial derivatives of the surface."""
    at = {(i, j): Vector(*surface.partial(i, j, u, v)) for i in range(3) for j in range(3 - i)}
    n = cross(at[1, 0], at[0, 1])
    return at, tuple(dot(at[key], n) for key in ((2, 0), (1, 1), (0, 2)))


@pytest.mark.parametrize("name", CURVED)
def test_asymptotic_directions_where_the_root_is_rational(name):
    """Forms with the values of a surface but for N, which makes δ a square."""
    surface = example(name)
    _, (first, mixed, _) = coefficients(surface, *inside(surface))
    first = first or mpq(1)
    last = (mixed**2 - 9) / first
    delta = formula("asymptotic_discriminant")(Operands(L=first, M=mixed, N=last))
    assert delta == 9
    for root in (3, -3):
        for du, dv in ((root - mixed, first), (last, -mixed - root)):
            assert first * du**2 + 2 * mixed * du * dv + last * dv**2 == 0


def test_asymptotic_directions_of_the_saddle_are_its_rulings():
    surface = example("hyperbolic_paraboloid")
    _, (first, mixed, last) = coefficients(surface, *inside(surface))
    assert first == last == 0 != mixed


def test_lines_through_a_point_do_not_bend():
    """On the rotated saddle z = x² − y² over squares the straight lines are the diagonals."""
    net = [[(mpq(i), mpq(j), mpq([1, -1, 1][i + 1] - [1, -1, 1][j + 1])) for j in (-1, 0, 1)] for i in (-1, 0, 1)]
    surface = NurbsSurface((2, 2), [-1] * 3 + [1] * 3, [-1] * 3 + [1] * 3, net)
    for place in (PLACE, (mpq(4, 5), mpq(1, 9))):
        u, v = inside(surface, place)
        assert surface(u, v)[2] == u**2 - v**2
        _, (first, mixed, last) = coefficients(surface, u, v)
        root = isqrt(int((delta := mixed**2 - first * last).numerator)) / mpq(isqrt(int(delta.denominator)))
        assert root**2 == delta
        assert {(s * root - mixed) / first for s in (1, -1)} == {1, -1}


@pytest.mark.parametrize("degree", [1, 2, 3])
def test_rulings_of_all_patches_that_are_ruled_are_asymptotic(degree):
    """N vanishes for all patches of degrees (n, 1), rational ones too; L for those of degrees (1, 1)."""
    argument = JetReading(2).argument(SURFACE, 3)
    patch = {Parameter.U: degree, Parameter.V: 1}
    assert degree_on_patch([formula("N_lifted")(argument)], patch, Parameter.V) == -1
    assert degree_on_patch([formula("L_lifted")(argument)], patch, Parameter.V) == (2 if degree > 1 else -1)
    assert degree_on_patch([formula("N_lifted")(argument)], patch | {Parameter.V: 2}, Parameter.V) > -1


def test_the_other_sign_of_the_root_in_the_wrong_place_is_noticed():
    """The direction (√δ + M, L) is none of them: what a wrong sign in the formula would say."""
    c = JetReading(0).argument(FORMS, 3)
    form = c.L * (c.M * c.M + (c.M**2 - c.L * c.N)) + 2 * c.M * c.M * c.L + c.N * c.L * c.L
    assert not form.is_zero
    assert all(part.is_zero for part in formula("second_form_of_asymptotic")(c))


# ---- the normal curvature along a curve


@pytest.mark.parametrize("name", CURVED)
@pytest.mark.parametrize(("du", "dv"), [(1, 0), (0, 1), (2, -3)])
def test_the_normal_curvature_along_a_line_of_parameters_is_that_of_its_bending(name, du, dv):
    """``(γ″ · n)²/(‖γ′‖⁴ ‖n‖²)`` for γ(t) = S(u + t du, v + t dv)."""
    surface = example(name)
    u, v = inside(surface)
    at, _ = coefficients(surface, u, v)
    n = cross(at[1, 0], at[0, 1])
    pace = at[1, 0] * mpq(du) + at[0, 1] * mpq(dv)
    bend = at[2, 0] * mpq(du**2) + at[1, 1] * mpq(2 * du * dv) + at[0, 2] * mpq(dv**2)
    expected = dot(bend, n) ** 2 / (dot(pace, pace) ** 2 * dot(n, n))
    argument = surface.remembering()
    forms = {
        key: argument.calls(formula(f"{key}_lifted" if key in "LMN" else f"{key}_reduced"))(u, v) for key in "EFGLMN"
    }
    second = forms["L"] * du**2 + 2 * forms["M"] * du * dv + forms["N"] * dv**2
    first = forms["E"] * du**2 + 2 * forms["F"] * du * dv + forms["G"] * dv**2
    area, w = argument.calls(formula("area_squared_lifted"))(u, v), surface.w(u, v)
    assert expected == w**6 * second**2 / (first**2 * area)


# ---- singular points that are not simple


@pytest.mark.parametrize("ends", [(-1, 1), (-1, 2), (mpq(-1, 3), mpq(3, 4))])
def test_the_apex_of_a_cone_that_is_parametrized_by_squares(ends):
    """(u², v², uv) lies on the cone xy = z²: its normal vanishes twice at the apex, and nowhere else."""
    a, b = ends
    squares, lines = (mpq(a) ** 2, mpq(a * b), mpq(b) ** 2), (mpq(a), mpq(a + b) / 2, mpq(b))
    net = [[(x, y, u * v) for y, v in zip(squares, lines, strict=True)] for x, u in zip(squares, lines, strict=True)]
    surface = NurbsSurface((2, 2), [a] * 3 + [b] * 3, [a] * 3 + [b] * 3, net)
    x, y, z = surface(b, (a + b) / mpq(2))
    assert x * y == z * z
    found = analyse(surface)
    assert found.complete
    assert found.constant_curvature == 0
    assert [place.exact for place in found.singular_points] == [(0, 0)]
    assert not found.umbilics
