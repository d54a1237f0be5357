"""What comes out at the true degree: known curves, continuity at knots, polynomial curves, every library function by
default.
"""

from functools import reduce
from itertools import product

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from exactspline import BSpline, Nurbs, analyse, derive, example, examples, formula_of
from exactspline.errors import ShapeError
from exactspline.geometry.derived.constructions import all_constructions
from exactspline.language import Vector, det, formula, kinds, wronskian
from exactspline.language.arguments import Curve
from exactspline.language.ruled import split
from exactspline.language.wronskians import logarithmic_numerator, osculating, wronskians
from exactspline.programs.program import operands_of, program_of
from exactspline.splines.lowest_terms import primitive, primitive_part, true_degree, without_factor
from exactspline.symbolic.reduction import reduction
from exactspline.tables import Variant, construction
from exactspline.verification.generic_proof import minimum_at, symbolic_minimum
from tests.support.sampled import sample
from tests.support.strategies import nurbs, splines_on_one_domain

SPACE = [name for name in examples("curves") if example(name).dimension == 3]


def test_the_evolute_of_a_circle_is_its_centre():
    pieces = derive("evolute", example("circle")).pieces
    assert all(piece.value.degree == 0 for piece in pieces)
    assert pieces[0].value(0) == (0, 0)


@pytest.mark.parametrize("name", [n for n in SPACE if example(n).degree == 3 and not example(n).polynomial])
def test_a_nondegenerate_rational_space_cubic_has_a_constant_torsion_numerator(name):
    form = formula_of("torsion_zeros_lifted")(example(name))
    if form.is_zero:
        assert all(x.is_zero for x in split(formula_of("D1_D2_D3")(example(name)))[0])
        return
    assert form.true_degree == 0
    assert construction("zero_torsion").on(example(name), Variant.MINIMAL).degree == 0


def test_a_pythagorean_hodograph_quintic_loses_more_than_the_generic_quintic():
    """‖γ′‖² = σ², and the evolute ``p + σ² γ′⊥/f`` of degree 3d − 3 = 12 over f of degree 2d − 4 = 6; the vertex form
    loses a factor σ.
    """
    curve = example("ph_quintic")
    vertices = construction("critical_curvature").on(curve, Variant.MINIMAL)
    assert vertices.degree == minimum_at(construction("critical_curvature"), 5, polynomial=True) == 13
    speed = formula_of("speed_squared")(curve)
    sigma = BSpline.from_forms(4, speed.mesh, (), [(root_of(c), m) for c, m in primitive(speed).forms])
    assert primitive(sigma * sigma) == primitive(speed)
    # κ = f/σ³, so κ′ = (f′σ − 3fσ′)/σ⁴, and the vertex form of degree 4d − 7 is that numerator times σ
    f = formula_of("f2")(curve)
    reduced = f.d() * sigma - 3 * f * sigma.d()
    assert primitive(reduced * sigma) in (primitive(vertices), primitive(-vertices))


def root_of(c):
    _, factors = c.factor_squarefree()
    assert all(e % 2 == 0 for _, e in factors)
    root = c * 0 + 1
    for p, e in factors:
        root = root * p ** (e // 2)
    return root


@pytest.mark.parametrize(("curve", "name"), sample([*product(examples("curves"), all_constructions())], 60))
def test_no_curve_exceeds_the_proved_degree(name, curve):
    c, made = example(curve), construction(name)
    if c.dimension != made.dimension:
        return
    proved = symbolic_minimum(made, made.dimension, polynomial=c.polynomial).at({"d": max(c.degree, 3)})
    try:
        pieces = derive(name, c).pieces
    except ShapeError:
        return
    assert all(true_degree(piece.value) <= proved for piece in pieces)


@pytest.mark.parametrize("name", ["zero_curvature", "critical_curvature"])
@given(curve=nurbs(2, 2, 4))
def test_the_theorem_guarantees_the_division(name, curve):
    """The lifted form of any curve can be lowered by m − j, on every segment, and stays the same function."""
    made = construction(name)
    part = reduction(made.lifted, 2, curve.polynomial).main
    form = made.on(curve, Variant.LIFTED)
    if form.degree < 0:
        return
    lowered = form.reduce_degree(min(part.true.surplus, form.degree))
    assert lowered == form
    assert lowered.degree == max(part.true.k * curve.degree - 2 * part.true.m + part.true.j, 0)


@pytest.mark.parametrize(("name", "less"), [("inflections_lifted", 2), ("vertices_lifted", 3)])
@pytest.mark.parametrize("curve", ["six_segment_cubic", "rational_cubic_spline", "ellipse"])
def test_continuity_of_a_lifted_form(name, less, curve):
    """It is nominally as continuous as the curve less the derivatives taken, and lowering the degree leaves that as it
    is.
    """
    c = example(curve)
    form = formula_of(name)(c)
    inner = c.breakpoints[1:-1]
    of_curve = dict(zip(inner, c.p[0].continuity, strict=True))
    assert dict(zip(inner, form.continuity, strict=True)) == {t: max(r - less, -1) for t, r in of_curve.items()}
    assert all(form.continuity_at(t) >= r for t, r in zip(inner, form.continuity, strict=True) if r >= 0)
    lowered = form.reduce_degree(form.degree - form.true_degree)
    assert lowered == form
    for t in lowered.breakpoints[1:-1]:
        assert lowered.continuity_at(t) >= min(max(of_curve[t] - less, -1), lowered.degree)


@pytest.mark.parametrize("curve", ["six_segment_cubic", "rational_cubic_spline"])
def test_continuity_of_the_minimal_form_of_a_zero_set(curve):
    """Where no segment has a factor in common with w the minimal form is the lifted one times a constant."""
    c = example(curve)
    made = construction("zero_curvature")
    lifted, minimal = made.on(c, Variant.LIFTED), made.on(c, Variant.MINIMAL)
    assert without_factor(lifted, c.w, 3) is lifted
    assert primitive(lifted) == minimal
    assert minimal.continuity == tuple(min(r, minimal.degree) for r in lifted.continuity)


def test_continuity_of_a_quotient_in_lowest_terms():
    """Numerator and denominator are only C⁻¹; the curve they describe is as continuous as it was."""
    c = Nurbs(4, [0] * 5 + [1] + [2] * 5, [(0, 0), (1, 3), (3, 4), (5, 1), (6, 5), (8, 2)], [1, 2, 1, 3, 1, 2])
    value = derive("evolute", c).pieces[0].value
    assert value.numerator[0].continuity == (-1,)
    assert value(1, "left") == value(1)
    assert value.d()(1, "left") == value.d()(1)


def test_a_segment_that_shares_a_factor_with_w_is_divided_alone():
    """Signs and zeros stay; the values do not."""
    t = BSpline(1, [0, 0, 2, 2], [0, 2])
    w = BSpline(1, [0, 0, 1, 2, 2], [1, 1, 2]).elevate_degree() + t * t * 0
    f = w * (t - mpq(1, 2))
    left = without_factor(f, w, 2)
    assert left != f
    assert left.continuity == (-1,)
    for x in (mpq(1, 4), mpq(1, 2), mpq(3, 4), mpq(5, 4), mpq(2)):
        a, b = left(x), f(x)
        assert (a > 0, a < 0) == (b > 0, b < 0)


def lowest(f, curve):
    """A formula on a curve, read at its true degree."""
    given = operands_of(kinds.PLANE if curve.dimension == 2 else kinds.SPACE, curve, true_degree=True)
    return program_of(f, given.signature).on(given)


@given(data=st.data())
def test_a_wronskian_at_its_true_degree_is_the_wronskian(data):
    """From partial derivatives and from derivatives: the same function, over segments of any width, and of degree N(n −
    N + 1).
    """
    size = data.draw(st.integers(3, 4))
    components = data.draw(splines_on_one_domain(size, 0, 4))
    breaks = {t for f in components for t in f.breakpoints}
    w, *p = [reduce(BSpline.insert_knot, sorted(breaks.difference(f.breakpoints)), f) for f in components]
    found = lowest(formula_of("inflections_lifted" if size == 3 else "torsion_zeros_lifted"), Curve(Vector(*p), w))
    rows = [Vector(*components)]
    for _ in p:
        rows.append(Vector(*[f.d() for f in rows[-1]]))
    assert found == det(*rows)
    n = max(f.degree for f in components)
    assert found.degree == (size * (n - size + 1) if n >= size - 1 else 0)


OPERATIONS = {
    "a Wronskian with a number": lambda c: wronskian(Vector(c.p[0], c.w.constant(3), c.p[1])),
    "a Wronskian with two numbers": lambda c: wronskian(Vector(c.w.constant(2), c.w.constant(3), c.p[1])),
    "with each component": lambda c: wronskians(c.w, c.p),
    "a plane": lambda c: osculating(Vector(c.p[0], c.w.constant(1), c.p[1], c.w), 3),
    "of degree 0": lambda c: logarithmic_numerator((c.p[0], 2), (c.w, 1), (c.p[1], -3)),
    "of another degree": lambda c: logarithmic_numerator((c.p[0], 2), (c.w, 1), (c.p[1], 3)),
    "with numbers": lambda c: logarithmic_numerator((c.p[0], 2), (c.w.constant(5), 7), (c.w, -2)),
    "of numbers": lambda c: logarithmic_numerator((c.w.constant(5), 7)),
    "with zero": lambda c: logarithmic_numerator((c.p[0], 2), (c.w.constant(0), 7), (c.w, -2)),
}


@pytest.mark.parametrize("operation", OPERATIONS.values(), ids=OPERATIONS)
@pytest.mark.parametrize("name", ["rational_cubic_spline", "circle", "rational_quartic"])
def test_what_is_carried_out_at_its_true_degree_is_the_same_function(operation, name):
    """Signs, constants and widths of segments: nothing but the degree changes, and it becomes no higher."""
    f, c = formula("here", on="plane")(operation), example(name)
    low, written_out = lowest(f, c), f(c)
    assert low == written_out
    assert low.is_zero or low.degree <= written_out.degree


def test_the_degree_falls_where_it_should():
    c = example("rational_quartic")
    for name, degree in (("with each component", 6), ("of degree 0", 10), ("of another degree", 11)):
        assert lowest(formula("here", on="plane")(OPERATIONS[name]), c).degree == degree


def test_inflections_do_not_depend_on_the_form():
    for name in ("rational_cubic_s", "cubic_s", "six_segment_cubic"):
        facts = analyse(example(name))
        found = [
            [(root, by_jump) for root, by_jump in facts.regular(facts.zero_form("zero_curvature", form).zeros)]
            for form in ("naive", "paper", Variant.LIFTED, Variant.MINIMAL)
        ]
        assert found[0]
        assert all(other == found[0] for other in found[1:])


def test_a_primitive_part_points_where_the_vector_does():
    """(t, t²) on [0, 1] and (2, 2 t) on [1, 2]: parts of degree 1 and unequal content."""
    x = BSpline(2, [0, 0, 0, 1, 1, 1, 2, 2, 2], [0, "1/2", 1, 2, 2, 2])
    y = BSpline(2, [0, 0, 0, 1, 1, 1, 2, 2, 2], [0, 0, 1, 2, 3, 4])
    z = BSpline(2, [0, 0, 0, 1, 1, 1, 2, 2, 2], [0, 0, 2, 1, 3, 9])
    for vector in (Vector(x, y), Vector(x, y, z), Vector(x, x, x * 3)):
        part = primitive_part(vector)
        for i in range(9):
            t = mpq(2 * i + 1, 10) if i != 4 else mpq(19, 10)
            own, told = [f(t) for f in vector], [f(t) for f in part]
            k = next(i for i, a in enumerate(own) if a)
            assert [told[k] * a for a in own] == [own[k] * b for b in told]
            assert (told[k] > 0) == (own[k] > 0)
    assert primitive_part(Vector(x, x, x * 3)).degree == 0


def test_a_primitive_part_vanishes_nowhere():
    """(t, 2t²) on [0, 1] is t (1, 2t), of lower degree than what follows: it stays (1, 2) at the end."""
    x = BSpline(2, [0, 0, 0, 1, 1, 1, 2, 2, 2], [0, "1/2", 1, 2, 2, 2])
    z = BSpline(2, [0, 0, 0, 1, 1, 1, 2, 2, 2], [0, 0, 2, 1, 3, 9])
    part = primitive_part(Vector(x, z))
    assert part.degree == 2
    a, b = (f(1, "left") for f in part)
    assert b == 2 * a > 0
    a, b = (f(0) for f in part)
    assert (a > 0, b) == (True, 0)
