"""Our own statements: the forms from the lifts of a curve, and that no form has a lower degree.

For all curves each lifted form agrees with the form of the paper, up to the factor stated; on the example curves this
is verified. The geometry of each form is checked separately: contact with lines, planes, circles and spheres, counted
on exact Taylor series. The degree theorem is stated and proved in docs/degree-theorem.md; its numbers are compared here
with those of the ledger.
"""

import pytest
from gmpy2 import mpq
from theorem import establish, verdict_for_all

from exactspline.geometry.derived.constructions import all_constructions, construction
from exactspline.interchange.examples import example, example_names
from exactspline.language import Vector, dot
from exactspline.language.kinds import CURVE
from exactspline.papers import find
from exactspline.readings.jet import JetReading
from exactspline.readings.taylor import Series, series_curve
from exactspline.symbolic.covariants import true_degree
from exactspline.symbolic.reduction import reduction
from exactspline.verification.generic_proof import attained, symbolic_minimum

PLANE = [name for name in example_names() if example(name).dimension == 2 and not find("f2")(example(name)).is_zero]
SPACE = [
    name for name in example_names() if example(name).dimension == 3 and not find("D1_D2_D3")(example(name)).is_zero
]


def parameters(curve, count=4):
    """Rational parameters inside the domain, none of them a knot of the example curves."""
    a, b = curve.domain
    return [a + (b - a) * mpq(2 * i + 1, 2 * count + 7) for i in range(count)]


def test_lifted_forms_are_the_forms_of_the_paper():
    """Claims L1 to L9: the forms agree up to the factor stated, for all curves; L10: the ruled surfaces are the same
    surfaces.
    """
    for claim in ("L1", "L2", "L3", "L4", "L5", "L6", "L7", "L8", "L9", "L10", "L15", "L16"):
        assert set(verdict_for_all(claim)) == {"PROVED"}


def test_nominal_degrees_of_the_lifted_forms():
    """Claim L11: the nominal degree is kd − m."""
    assert set(verdict_for_all("L11")) == {"PROVED"}


@pytest.mark.parametrize("claim", ["L12", "L13"])
def test_true_degrees(claim):
    """The true degree is kd − 2m + j for the remaining factor of the naive form, rational and polynomial."""
    assert set(verdict_for_all(claim)) == {"PROVED"}


def test_covariants():
    """Claim L14: the lifted forms are covariants of binary forms; D2, D3 and D21 are not."""
    assert set(verdict_for_all("L14")) == {"PROVED"}
    assert {str(row.computed) for row in establish("L14") if not row.curve and row.claim.kind == "degree"} == {
        "0",
        "1",
        "2",
    }


def test_a_wronskian_of_functions_of_degree_d_is_a_covariant():
    """The Wronskian of n functions of degree d is a covariant with k = n, weight n(n − 1)/2 and height 0, so that its
    order is n(d − n + 1).
    """
    for n in (2, 3, 4):
        c = JetReading(n - 1).argument(CURVE, n, polynomial=True)
        from exactspline.language import wronskian

        found = true_degree(wronskian(c.p) if n > 2 else c.p[0] * c.p[1].d() - c.p[1] * c.p[0].d())
        assert (found.k, found.m, found.j) == (n, n * (n - 1) // 2, 0)
        assert [found.at(d) for d in range(n - 1, 9)] == [n * (d - n + 1) for d in range(n - 1, 9)]


def contact(series):
    """The order of vanishing at the parameter."""
    return next((i for i, x in enumerate(series.coefficients) if x), len(series.coefficients))


@pytest.mark.parametrize("name", PLANE)
def test_the_osculating_circle_has_three_point_contact(name):
    """a‖γ‖² + b·γ + c vanishes to third order, and to fourth exactly where the Wronskian of X is zero."""
    curve = example(name)
    for t in parameters(curve):
        circle = [component(t) for component in find("osculating_circle")(curve)]
        x = find("conformal_lift")(series_curve(curve, t, 6))
        meeting = dot(Vector(*[x[0].constant(s) for s in circle]), x)
        if any(circle):
            assert contact(meeting) >= 3
            assert (contact(meeting) >= 4) == (find("vertices_lifted")(curve)(t) == 0)


#: The objects that touch a space curve, each with its lift and the order of contact.
CONTACTS = [
    ("osculating_sphere", "conformal_lift", 4),
    ("osculating_plane", "projective_lift", 3),
    ("circle_sphere", "conformal_lift", 3),
]


@pytest.mark.parametrize("name", SPACE)
def test_the_osculating_sphere_has_four_point_contact_and_the_plane_three(name):
    """The plane has four-point contact exactly where the Wronskian of P is zero."""
    curve = example(name)
    for t in parameters(curve):
        series = series_curve(curve, t, 6)
        for form, lift, order in (
            ("osculating_sphere", "conformal_lift", 4),
            ("osculating_plane", "projective_lift", 3),
            ("circle_sphere", "conformal_lift", 3),
        ):
            covector = [component(t) for component in find(form)(curve)]
            x = find(lift)(series)
            meeting = dot(Vector(*[x[0].constant(s) for s in covector]), x)
            if any(covector):
                assert contact(meeting) >= order
                if form == "osculating_plane":
                    assert (contact(meeting) >= 4) == (find("torsion_zeros_lifted")(curve)(t) == 0)


@pytest.mark.parametrize("name", SPACE)
def test_the_centre_of_the_osculating_circle_lies_in_the_osculating_plane(name):
    curve = example(name)
    for t in parameters(curve):
        a, *normal = (component(t) for component in find("osculating_plane")(curve))
        if find("binormal_form_squared")(curve)(t):
            centre = find("circle_centre_lifted")(curve)(t)
            assert a + sum(n * x for n, x in zip(normal, centre, strict=True)) == 0


@pytest.mark.parametrize("name", all_constructions())
def test_no_degree_can_be_dropped_on_the_generic_curve(name):
    """A certified witness curve attains the degree for each d from 2 to 6, rational and polynomial."""
    for polynomial in (False, True):
        for d in range(2, 7):
            assert attained(name, d, polynomial=polynomial).agrees


def test_an_ellipse_has_as_many_vertices_as_its_form_has_degrees():
    """The form has degree 96 by squaring, 12 in the paper, and 4 at the lowest, which is the number of vertices."""
    assert symbolic_minimum(construction("critical_curvature"), 2).at({"d": 2}) == 4
    form = construction("critical_curvature").on(example("ellipse_skew"), "minimal")
    assert form.degree == form.true_degree == 4


def test_what_reduce_finds_is_what_the_lifts_give():
    """The reduced form of the naive formula is the lifted form itself, not only a multiple of it."""
    for naive, lifted in (
        ("g0", "vertices_lifted"),
        ("velocity_acceleration_jerk", "torsion_zeros_lifted"),
        ("binormal", "binormal_lifted"),
    ):
        dimension = 2 if naive == "g0" else 3
        found = reduction(naive, dimension).main.reduced
        value = find(lifted)(JetReading(3).argument(CURVE, dimension))
        expected = list(value) if isinstance(value, Vector) else [value]
        assert [jet.polynomial.terms() and dict(by_names(jet)) for jet in found] == [
            dict(by_names(jet)) for jet in expected
        ]
    assert isinstance(series_curve(example("circle"), 0, 3).w, Series)


def by_names(jet):
    """The terms of a jet polynomial, independent of the order of the variables of its ring."""
    for exponents, c in jet.polynomial.terms():
        yield frozenset((variable, int(e)) for variable, e in zip(jet.ring.variables, exponents, strict=True) if e), c
