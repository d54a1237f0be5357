"""The minimal forms: identical to the naive ones, of the degree proved for symbolic d, and no lower on generic
curves.
"""

import random
from functools import cache

import pytest
from gmpy2 import mpq

from exactspline import BSpline, Nurbs, example, formula_of
from exactspline.errors import FormulaError, ReductionError
from exactspline.geometry.derived.constructions import all_constructions
from exactspline.geometry.derived.ruled_surfaces import same_surface
from exactspline.language.ruled import split
from exactspline.splines.lowest_terms import in_lowest_terms, lowest_terms, true_degree
from exactspline.tables import Variant, construction
from exactspline.verification.generic_proof import symbolic_minimum

DIMENSION = {"plane": 2, "space": 3}


def generic(degree, dimension, *, polynomial):
    """A Bézier curve without coincidences in its data: random integers, the same every time."""
    numbers = random.Random(17 * degree + dimension)
    points = [[numbers.randint(-50, 50) for _ in range(dimension)] for _ in range(degree + 1)]
    weights = None if polynomial else [numbers.randint(1, 30) for _ in points]
    return Nurbs(degree, [0] * (degree + 1) + [1] * (degree + 1), points, weights)


@cache
def proved_degree(name, polynomial):
    c = construction(name)
    return symbolic_minimum(c, DIMENSION[c.curve], polynomial=polynomial)


@pytest.mark.parametrize("polynomial", [False, True], ids=["rational", "polynomial"])
@pytest.mark.parametrize("degree", [2, 3, 4, 5, 6])
@pytest.mark.parametrize("name", all_constructions())
def test_generic_curves_attain_the_proved_degree_and_no_lower(name, degree, polynomial):
    c = construction(name)
    dimension = DIMENSION[c.curve]
    curve = generic(degree, dimension, polynomial=polynomial)
    try:
        value = c.on(curve, Variant.MINIMAL)
    except ReductionError:
        assert degree == 2  # a parabola in space has no torsion and no focal curve
        return
    proved = proved_degree(name, polynomial).at({"d": degree})
    if dimension == 3 and degree == 2:
        assert true_degree(value) <= max(proved, 6)  # a conic is planar: its degrees are those of §4
        return
    assert true_degree(value) == proved


@pytest.mark.parametrize("name", all_constructions())
def test_the_minimal_form_is_the_naive_one_in_lowest_terms(name):
    c = construction(name)
    curve = example("rational_cubic_spline" if c.curve == "plane" else "rational_space_cubic")
    naive, minimal = c.formula(next(iter(c.variants)))(curve), c.on(curve, Variant.MINIMAL)
    if c.ruled:
        reduced = in_lowest_terms(naive)
        assert same_surface(naive, reduced) is not None
        assert same_surface(c.formula("paper")(curve), reduced) is not None
        assert reduced.degree == minimal.degree <= naive.degree
        return
    lowest = in_lowest_terms(naive)
    (ps, k), (qs, m) = split(naive), split(lowest)
    for p, q in zip(ps, qs, strict=True):
        assert p * m == q * k
    if not c.zero_set:
        assert minimal == lowest
        assert true_degree(minimal) == max(n for _, n in lowest_terms(naive))
        return
    assert minimal.degree == minimal.true_degree == in_lowest_terms(lowest.numerator).degree
    for i, (p, q) in enumerate(zip(minimal.numerators, in_lowest_terms(lowest.numerator).numerators, strict=True)):
        assert p * q.leading_coefficient() == q * p.leading_coefficient(), i
        assert p.leading_coefficient() * q.leading_coefficient() > 0


def test_the_minimal_form_loses_what_it_shares_with_the_weight_function():
    """An ellipse as a quadratic curve has a Wronskian of degree 0; multiplied through by (1 + t²) it has one with a
    power of that factor.
    """
    plain = Nurbs(2, [0] * 3 + [1] * 3, [(1, 0), (1, 1), (0, 1)], [1, 1, 2])
    t = BSpline.identity(0, 1)
    common = t * t + 1
    rows = [(x * common).control_points for x in (*plain.p, plain.w)]
    curve = Nurbs.from_homogeneous(4, [0] * 5 + [1] * 5, list(zip(*rows, strict=True)))
    made = construction("zero_curvature")
    assert made.on(curve, Variant.LIFTED).true_degree == 6
    assert made.on(curve, Variant.MINIMAL) == made.on(plain, Variant.MINIMAL) == t.constant(1)


def test_a_vertex_form_of_the_ellipse_has_degree_four():
    """96 by squaring, 12 in the paper, 4 in lowest terms; and an ellipse has four vertices."""
    ellipse = example("ellipse_skew")
    made = construction("critical_curvature")
    assert [made.on(ellipse, variant).degree for variant in ("squaring", "paper", Variant.MINIMAL)] == [96, 12, 4]


def test_unknown_names_are_refused():
    with pytest.raises(FormulaError, match="no construction"):
        construction("involute")


def test_a_denominator_that_vanishes_on_a_segment_is_named():
    with pytest.raises(ReductionError, match=r"\[1, 2\]"):
        lowest_terms(formula_of("evolute")(example("straight_between_arcs")))


@pytest.mark.parametrize("name", [c.name for c in all_constructions().values() if c.zero_set])
def test_the_minimal_form_has_the_sign_of_the_first_whatever_that_of_w(name):
    made = all_constructions()[name]
    curve = example("rational_cubic" if made.dimension == 2 else "rational_space_cubic")
    first = next(iter(made.variants))
    for sign in (1, -1):
        own = Nurbs(curve.degree, curve.knots, curve.control_points, [sign * w for w in curve.weights])
        minimal, form = made.on(own, Variant.MINIMAL), made.on(own, first)
        assert any(minimal.forms[0][0])
        for k in range(1, 12):
            t = mpq(k, 12)
            assert minimal(t) * form(t) >= 0
            assert bool(minimal(t)) or not form(t)
