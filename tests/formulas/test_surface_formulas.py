"""Formulas of surfaces: held against their definitions by routes that share no formula with them, known answers, and
statements that are false.
"""

import json
from dataclasses import replace
from pathlib import Path

import pytest
from gmpy2 import isqrt, mpq

import exactspline as xs
from exactspline import ExactSplineError, Verdict, claims, example, formula_of, paper
from exactspline.errors import ClaimError, FormulaError
from exactspline.language import Vector, cross, dot, norm2
from exactspline.language.arguments import Curve
from exactspline.language.kinds import CURVE_ON_SURFACE, FORMS, SURFACE
from exactspline.language.operand import Parameter
from exactspline.readings import DegreeReading, JetReading
from exactspline.readings.jet import RationalJetReading
from exactspline.readings.leading_terms import LeadingTermsReading
from exactspline.readings.sympy_expression import SympyReading
from exactspline.readings.taylor import DoubleTaylorReading, Series, double_taylor
from exactspline.symbolic.reduction import reduce
from exactspline.tables import patch_table, variants_table
from exactspline.verification.ledger import audit
from tests.support.command import invoke

SOURCE = paper("surfaces")
CURVED = ("ellipsoid", "torus", "cyclide", "rational_biquadratic", "monkey_saddle", "biquadratic", "enneper")
PLACES = ((mpq(1, 3), mpq(1, 5)), (mpq(3, 7), mpq(2, 3)))


def partials(surface, u, v):
    """The point's derivatives up to second order, by Leibniz' rule for w S."""
    return {(i, j): Vector(*surface.partial(i, j, u, v)) for i in range(3) for j in range(3 - i)}


def inside(surface, place):
    (a, b), (c, d) = surface.domain
    return a + (b - a) * place[0], c + (d - c) * place[1]


def at(name, surface, u, v, terms=4):
    """A formula at a point, by Taylor series."""
    series = DoubleTaylorReading(surface.remembering(), u, v, terms).argument(SURFACE, 3)
    return formula_of(f"surfaces:{name}")(series).value


@pytest.mark.parametrize("name", CURVED)
@pytest.mark.parametrize("place", PLACES)
def test_curvatures_are_those_of_the_shape_operator(name, place):
    """The normal is differentiated, its derivatives are written in the tangents by a linear system."""
    surface = example(name)
    u, v = inside(surface, place)
    d = partials(surface, u, v)
    a, b = d[1, 0], d[0, 1]
    n = cross(a, b)
    n_u = cross(d[2, 0], b) + cross(a, d[1, 1])
    n_v = cross(d[1, 1], b) + cross(a, d[0, 2])
    gram = dot(a, a) * dot(b, b) - dot(a, b) ** 2

    def in_tangents(x):
        first = (dot(x, a) * dot(b, b) - dot(x, b) * dot(a, b)) / gram
        second = (dot(x, b) * dot(a, a) - dot(x, a) * dot(a, b)) / gram
        return -first, -second

    (p, q), (r, s) = in_tangents(n_u), in_tangents(n_v)
    assert at("gaussian_curvature", surface, u, v) == (p * s - q * r) / norm2(n)
    assert at("mean_curvature_squared", surface, u, v) == ((p + s) / 2) ** 2 / norm2(n)
    # at an umbilic every direction is kept
    assert (at("umbilicity", surface, u, v) == 0) == ((p, q, r) == (s, 0, 0))


@pytest.mark.parametrize("name", CURVED)
@pytest.mark.parametrize("direction", [(1, 0), (0, 1), (2, -3)])
def test_normal_curvature_is_that_of_curves_on_the_surface(name, direction):
    """A line of parameters is a space curve: its curvature by the formula of curves, its acceleration on the normal."""
    surface = example(name)
    u, v = inside(surface, PLACES[1])
    alpha, beta = direction

    def along(spline):
        known, series = [mpq(0)] * 4, double_taylor(spline, u, v, 4)
        for (i, j), c in series.coefficients.items():
            known[i + j] += c * alpha**i * beta**j
        return Series(known)

    curve = Curve(Vector(*[along(x) for x in surface.p]), along(surface.w))
    first, second = (Vector(*[x.value for x in curve.gamma.d(k)]) for k in (1, 2))
    d = partials(surface, u, v)
    n = cross(d[1, 0], d[0, 1])
    e, f, g, low, m, high = (at(x, surface, u, v) for x in "EFGLMN")
    length = e * alpha**2 + 2 * f * alpha * beta + g * beta**2
    bent = low * alpha**2 + 2 * m * alpha * beta + high * beta**2
    assert length == norm2(first)
    assert bent == dot(second, n)
    geodesic = dot(cross(first, second), n)
    curvature = formula_of("space_curvature_squared")(curve).value
    assert curvature == bent**2 / (length**2 * norm2(n)) + geodesic**2 / (length**3 * norm2(n))


def value(name, surface):
    return formula_of(f"surfaces:{name}")(surface.remembering())


LINES = ("line_coefficient_uu_projective", "line_coefficient_uv_projective", "line_coefficient_vv_projective")


def test_known_surfaces():
    sphere, cylinder, cone = map(example, ("sphere", "cylinder", "cone"))
    curvature = value("gaussian_curvature", sphere)
    assert all(value(name, sphere).is_zero for name in LINES)
    assert (curvature.numerator - curvature.denominator).is_zero
    for flat in (cylinder, cone, example("developable")):
        assert value("parabolic_lifted", flat).is_zero
        assert not value("minimality_lifted", flat).is_zero
    assert value("minimality", example("enneper")).is_zero
    saddle = example("hyperbolic_paraboloid")
    assert at("gaussian_curvature", saddle, *inside(saddle, PLACES[0])) < 0


def test_centres_of_curvature():
    """Of a sphere its centre, twice; of a torus one on its axis and one on the circle of centres of its tubes."""
    for name in ("sphere", "torus"):
        surface = example(name)
        u, v = inside(surface, PLACES[0])
        k, h, a = (at(x, surface, u, v) for x in ("parabolic_lifted", "minimality_lifted", "area_squared_lifted"))
        w, normal = surface.w(u, v), tangent_normal(surface, u, v)
        root = sqrt_of(h**2 - 4 * w**2 * k * a)
        centres = []
        for sign in (1, -1):
            sigma = (h + sign * root) / (2 * w**2 * k)
            centres.append([(x(u, v) + sigma * n) / w for x, n in zip(surface.p, normal, strict=True)])
        if name == "sphere":
            assert centres == [[0, 0, 0]] * 2
        else:
            radii = sorted(x**2 + y**2 for x, y, _ in centres)
            on_axis, on_circle = sorted(centres, key=lambda c: c[0] ** 2 + c[1] ** 2)
            assert radii[0] == 0 != on_axis[2]
            assert on_circle[2] == 0
            assert radii[1] == torus_circle(surface)


def tangent_normal(surface, u, v):
    d = partials(surface, u, v)
    return [surface.w(u, v) ** 3 * x for x in cross(d[1, 0], d[0, 1])]


def sqrt_of(q):
    """The exact root of a square of a rational number."""
    top, bottom = isqrt(q.numerator), isqrt(q.denominator)
    assert top**2 == q.numerator
    assert bottom**2 == q.denominator
    return mpq(top, bottom)


def torus_circle(surface):
    """The squared radius of the circle of centres, from the largest and the smallest distance to the axis."""
    (a, b), (c, d) = surface.domain
    squared = {
        x**2 + y**2
        for i in range(5)
        for j in range(5)
        for x, y, _ in [surface(a + (b - a) * mpq(i, 4), c + (d - c) * mpq(j, 4))]
    }
    return ((sqrt_of(max(squared)) + sqrt_of(min(squared))) / 2) ** 2


def test_ridges_of_known_surfaces():
    """On a cyclide each principal curvature is constant along its own lines; an ellipsoid has ridges in its planes of
    symmetry, which its patch borders lie in, and elsewhere almost nowhere.
    """
    for name in ("torus", "cyclide"):
        assert value("ridges_lifted", example(name)).is_zero
    ellipsoid = example("ellipsoid")
    ridges = value("ridges_lifted", ellipsoid)
    (a, _), (c, _) = ellipsoid.domain
    assert not ridges.is_zero
    assert ridges.at_s(a).is_zero
    assert ridges.at_t(c).is_zero
    assert ridges(*inside(ellipsoid, PLACES[0])) != 0


def test_the_lifted_ridges_are_those_of_the_definition():
    surface = example("rational_biquadratic")
    for place in PLACES:
        u, v = inside(surface, place)
        lifted, plain = at("ridges_lifted", surface, u, v), at("ridges", surface, u, v)
        assert lifted == surface.w(u, v) ** 48 * plain != 0


@pytest.mark.parametrize("name", ["parabolic", "minimality", "ridges"])
def test_the_spline_reading_and_the_series_agree(name):
    surface = example("biquadratic")
    whole = value(name, surface)
    for place in PLACES:
        u, v = inside(surface, place)
        assert whole(u, v) == at(name, surface, u, v) != 0


# ---- what holds for all surfaces


@pytest.mark.parametrize(
    ("key", "change"),
    [
        ("S3-parabolic-parabolic_lifted", {"factor": "w^-7"}),
        ("S3-parabolic-parabolic_lifted", {"factor": "-1 w^-8"}),
        ("S7-line_coefficient_uu_lifted-line_coefficient_uu", {"right": "line_coefficient_vv"}),
        ("S7-line_coefficient_uv_lifted-line_coefficient_uv", {"factor": "w^10"}),
        ("S8-acceleration_on_normal-second_form", {"right": "first_form"}),
        ("S5-umbilicity_of_forms-line_discriminant_of_forms", {"right": "minimality_of_forms"}),
        ("S11-parabolic-rational-u", {"claimed": "8d_u - 9"}),
        ("S11-parabolic-polynomial-v", {"claimed": "6d_v - 4"}),
        ("S11-L_lifted-rational-v", {"claimed": "4d_v - 6"}),
        ("PM1-umbilicity-u", {"claimed": "10d_u - 7"}),
        ("S15-point_bisector_of_surface_divided-rational-u", {"claimed": "5d_u − 2"}),
        ("S15-point_bisector_of_surface_divided-rational-u-lowest", {"claimed": "5d_u − 1"}),
        ("S15-curve_condition_lifted-rational-v-lowest", {"claimed": "5d_v − 3"}),
        ("S15-surface_condition-surface_condition_lifted", {"factor": "1/2 w^-4 third_coordinate^-1"}),
        ("S15-surface_condition_lifted-rational-lowest", {"claimed": "4d − 1"}),
    ],
)
def test_false_statements_are_refuted(key, change):
    claim = next(c for c in claims(paper="surfaces") if c.key == key)
    assert claim.prove()[1].verdict == Verdict.PROVED
    assert replace(claim, **change).prove()[1].verdict == Verdict.REFUTED


def test_a_degree_is_one_in_u_or_in_v():
    claim = next(c for c in claims(paper="surfaces") if c.key == "S11-parabolic-rational-u")
    for parameter in (Parameter.FIRST, Parameter.SECOND):
        with pytest.raises(ClaimError, match="no parameter"):
            replace(claim, parameter=parameter).validate()


@pytest.mark.parametrize(
    "reading", [JetReading(2), RationalJetReading(2), LeadingTermsReading(3, 2, Parameter.U), SympyReading()]
)
def test_a_derivative_of_a_surface_names_its_parameter(reading):
    c = reading.argument(SURFACE, 3)
    with pytest.raises(FormulaError):
        c.w.d(1)
    mixed = c.w.d(1, by="u").d(1, by="v") - c.w.d(1, by="v").d(1, by="u")
    parts = getattr(mixed, "parts", {})
    assert all(not a for terms in parts.values() for a in terms) if parts else mixed.is_zero


def test_exchanging_the_parameters_exchanges_the_degrees():
    for one, other in (("L", "N"), ("line_coefficient_uu", "line_coefficient_vv"), ("parabolic", "parabolic")):
        for polynomial in (False, True):
            u, v = (
                str(reduce(SOURCE.find(name), polynomial=polynomial, parameter=parameter).main.generic)
                for name, parameter in ((one, Parameter.U), (other, Parameter.V))
            )
            assert u.replace("d_u", "d_v") == v


@pytest.mark.parametrize("degrees", [(1, 1), (1, 2), (2, 2), (3, 2)])
def test_degrees_on_patches_are_attained(degrees):
    names = ("normal", "L", "M", "parabolic", "minimality", "line_coefficient_uu", "gaussian_curvature", "jacobian")
    rows = [call() for call in patch_table([SOURCE.find(name) for name in names], degrees)]
    assert len(rows) == 2 * len(names)
    for row in rows:
        assert row.agrees
        assert row.true is None or all(n <= m for n, m in zip(row.true, row.naive, strict=True))


def test_what_table_1_counts_of_gaussian_curvature():
    curvature = SOURCE.find("gaussian_curvature")
    for parameter in SURFACE.counted:
        for polynomial, degree in ((False, f"32d_{parameter}"), (True, f"8d_{parameter} − 4")):
            counted = DegreeReading(parameter=parameter).argument(SURFACE, 3, polynomial=polynomial)
            assert str(curvature(counted).degree) == degree


def test_curves_on_surfaces_obey_the_chain_rule():
    c = JetReading(2).argument(CURVE_ON_SURFACE, 3, polynomial=True)
    u, v, x = c.u, c.v, c.p[0]
    total = x.d(1, by="u") * u.d(1) + x.d(1, by="v") * v.d(1)
    assert x.d(1) == total
    assert x.d(2) == total.d(1)
    assert x.d(2) == (
        x.d(2, by="u") * u.d(1) ** 2
        + x.d(1, by="u").d(1, by="v") * u.d(1) * v.d(1) * 2
        + x.d(2, by="v") * v.d(1) ** 2
        + x.d(1, by="u") * u.d(2)
        + x.d(1, by="v") * v.d(2)
    )


def test_forms_alone_say_nothing_of_a_surface():
    with pytest.raises((ExactSplineError, AttributeError)):
        SOURCE.find("gauss_map_area")(JetReading(2).argument(FORMS, 3))


def test_derive_writes_the_value_on_a_surface():
    for name, surface, degree in (("gaussian_curvature", "sphere", [0, 0]), ("parabolic_lifted", "torus", [8, 8])):
        done = invoke("derive", f"surfaces:{name}", surface)
        assert done.exit_code == 0
        assert json.loads(done.output)["degree"] == degree


@pytest.mark.parametrize(
    "words",
    [
        ["derive", "surfaces:jacobian", "sphere"],
        ["derive", "surfaces:gaussian_curvature", "ellipse"],
        ["formula", "degrees", "--patch", "3,3"],
        ["formula", "degrees", "--paper", "surfaces", "--curve", "ellipse"],
        ["formula", "degrees", "--paper", "surfaces", "--patch", "3"],
        ["formula", "degrees", "--paper", "surfaces", "--patch", "0,2", "parabolic"],
    ],
)
def test_what_does_not_fit_is_told(words):
    done = invoke(*words)
    assert isinstance(done.exception, ExactSplineError)


def test_degrees_on_a_patch_by_command():
    done = invoke("formula", "degrees", "--paper", "surfaces", "--patch", "2,2", "parabolic", "--json")
    rows = json.loads(done.output)["rows"]
    assert [(row["patches"], row["true"], row["agrees"]) for row in rows] == [
        ("rational", [8, 8], True),
        ("polynomial", [7, 7], True),
    ]


def test_the_page_tells_the_degrees_that_are_computed():
    page = (Path(__file__).parents[2] / "docs" / "surfaces.md").read_text(encoding="utf-8")
    table = [[cell.strip() for cell in line.split("|")[2:-1]] for line in page.splitlines() if line.startswith("| ")]
    rows = variants_table(SOURCE)
    assert [[*vars(row).values()][1:] for row in rows] == [
        cells for cells in table if "d" in cells[0] and cells[0] != "defined"
    ]


def test_the_projective_forms_of_lines_of_curvature_are_irreducible():
    for name in LINES:
        (factor,) = reduce(SOURCE.find(name)).main.powers
        assert (factor.above, factor.below) == (1, 0)


def test_a_stranger_writes_formulas_of_surfaces(tmp_path):
    folder = tmp_path / "mine"
    folder.mkdir()
    (folder / "formulas.py").write_text(
        "from exactspline.language import cross, dot, norm2, formula\n\n\n"
        '@formula("1", on="surface")\ndef tangents(c):\n    """Squared."""\n'
        '    return norm2(cross(c.S.d(1, by="u"), c.S.d(1, by="v")))\n\n\n'
        '@formula("2", on="surface")\ndef along(c):\n    """A form."""\n'
        '    return norm2(c.S.d(1, by="u")) * norm2(c.S.d(1, by="v")) - dot(c.S.d(1, by="u"), c.S.d(1, by="v"))**2\n'
        "\n\n"
        '@formula("3", on="curve on a surface")\ndef pace(c):\n    """The chain rule."""\n'
        '    return c.gamma.d(1) - c.S.d(1, by="u") * c.u.d(1) - c.S.d(1, by="v") * c.v.d(1)\n'
    )
    (folder / "claims.toml").write_text(
        '[[claim]]\nid = "1"\nkind = "identity"\nstatement = "Lagrange"\nleft = "tangents"\nright = "along"\n'
        'curve = "surface"\n'
        '[[claim]]\nid = "2"\nkind = "vanishing"\nstatement = "chain rule"\nleft = "pace"\n'
        'curve = "curve on a surface"\n'
        '[[claim]]\nid = "3"\nkind = "degree"\nstatement = "too low"\nformula = "tangents"\nclaimed = "4d_u"\n'
        'parameter = "u"\ncurve = "surface"\nof = "rational"\n'
    )
    rows = [row for row in audit(claims(paper=paper(folder))) if not row.curve]
    assert [row.verdict for row in rows] == [Verdict.PROVED, Verdict.PROVED, Verdict.REFUTED]


def test_questions_of_surfaces_are_answered_in_either_parameter():
    asked = [str(xs.degree("surfaces:L", parameter=parameter)) for parameter in (None, "u", "v")]
    assert asked[0] == asked[1] == "L in R3: nominal 8d_u, in lowest terms 4d_u"
    assert asked[2] == asked[1].replace("d_u", "d_v")
    assert str(xs.reduction("surfaces:L", parameter=Parameter.V).main.generic) == "4d_v − 2"
    assert bool(xs.prove("surfaces:L", "surfaces:L_lifted", "w^-4"))
    for name, parameter in (("f2", "u"), ("surfaces:L", "s")):
        with pytest.raises(FormulaError, match="function of"):
            xs.degree(name, parameter=parameter)
    with pytest.raises(ExactSplineError, match="surface"):
        xs.derive("surfaces:L", xs.example("ellipse_in_space"))
