"""Formulas of two curves, or of a curve and a point, mean the same in every reading."""

from fractions import Fraction

import pytest
from gmpy2 import mpq

from exactspline import Nurbs, formula_of
from exactspline.language import Rational, Vector, cross, dot, norm2, ruled
from exactspline.language.arguments import Curve, Pair
from exactspline.language.kinds import PAIR, POINT_IN_SPACE, kind_of
from exactspline.language.ruled import RuledSurface
from exactspline.papers import all_formulas
from exactspline.readings import DegreeReading, JetReading, parse_degree, trace
from exactspline.readings.differential_order import Order, order_of
from exactspline.readings.jet import RationalJetReading
from exactspline.readings.leading_terms import generic_true_degree
from exactspline.readings.printing import print_latex, print_text
from exactspline.readings.taylor import taylor
from exactspline.symbolic.substitution import substitute
from exactspline.verification.divisors import Evaluation
from exactspline.verification.evaluation import moved_copy, pair_with, point_beside

FORMULAS = {name: f for name, f in all_formulas().items() if f.curve in ("pair", "point", "plane point")}
over_formulas = pytest.mark.parametrize("name", FORMULAS)

SPACE = Nurbs(3, [0, 0, 0, 0, 2, 2, 2, 2], [(0, 0, 0), (1, 2, 0), (3, 1, 1), (4, 0, 5)], [1, 2, "3/2", 1])
PLANE = Nurbs(2, [0, 0, 0, 1, 2, 2, 2], [(0, 0), (1, 2), (3, "5/2"), (4, 0)], [1, 2, "3/2", 1])


def argument(kind, *, polynomial=False):
    """A pair, or a curve and a point, on concrete splines."""
    curve = PLANE if kind == "plane point" else SPACE
    if polynomial:
        curve = Nurbs(curve.degree, curve.knots, curve.control_points)
    if kind == "pair":
        return pair_with(curve, moved_copy(curve))
    return curve.with_point(point_beside(curve))


def series(kind, s, t, terms, *, polynomial=False):
    """The same as Taylor series, each curve at a parameter of its own."""
    curve = PLANE if kind == "plane point" else SPACE
    if polynomial:
        curve = Nurbs(curve.degree, curve.knots, curve.control_points)
    if kind == "pair":
        first, second = Curve(curve.p, curve.w, polynomial=curve.polynomial), moved_copy(curve)
        return Pair(first.mapped(lambda f: taylor(f, s, terms)), second.mapped(lambda f: taylor(f, t, terms)))
    return curve.with_point(point_beside(curve)).mapped(lambda f: taylor(f, s, terms))


def dimension(f):
    return f.kind.dimensions[0]


def values(x, *place):
    """The components of a result at parameters, as exact numbers."""
    x = getattr(x, "joined", x)
    if isinstance(x, Rational):
        found = x(*place)
        return found if isinstance(found, tuple) else (found,)
    return tuple(a(*place) for a in (x if isinstance(x, Vector) else [x]))


@pytest.mark.parametrize("polynomial", [False, True])
@over_formulas
def test_series_are_the_values_of_splines(name, polynomial):
    f = FORMULAS[name]
    place = ("1/3", "8/5") if f.curve == "pair" else ("1/3",)
    found = f(series(f.curve, place[0], place[-1], order_of(f, dimension(f)) + 1, polynomial=polynomial))
    found = getattr(found, "joined", found)
    assert tuple(x.value for x in (found if isinstance(found, Vector) else [found])) == values(
        f(argument(f.curve, polynomial=polynomial)), *place
    )


@pytest.mark.parametrize("polynomial", [False, True])
@over_formulas
def test_represented_degrees_are_counted_degrees(name, polynomial):
    f = FORMULAS[name]
    given = argument(f.curve, polynomial=polynomial)
    d = 2 if f.curve == "plane point" else 3
    represented = f(given).degree
    for parameter in ("s", "s̄") if f.curve == "pair" else ("s",):
        counted = f(DegreeReading(parameter=parameter).argument(f.kind, dimension(f), polynomial=polynomial)).degree
        in_parameter = represented if f.curve != "pair" else represented.s if parameter == "s" else represented.t
        assert in_parameter == counted.at({"d": d})


@over_formulas
def test_a_tree_evaluates_to_the_formula_and_prints(name):
    f = FORMULAS[name]
    tree = trace(f, dimension(f))
    given = series(f.curve, "1/3", "8/5", order_of(f, dimension(f)) + 1)
    direct, by_tree = (getattr(x, "joined", x) for x in (f(given), Evaluation(given)(tree)))
    pairs = zip(direct, by_tree, strict=True) if isinstance(direct, Vector) else [(direct, by_tree)]
    assert all(a.value == b.value for a, b in pairs)
    assert "\\" not in print_text(tree)
    assert "_" not in print_text(tree)
    latex = print_latex(tree)
    assert latex.count("{") == latex.count("}")
    assert not any(ord(sign) > 127 for sign in latex)


def test_the_second_curve_gets_a_bar():
    assert print_text(trace(formula_of("bisector_determinant"))) == "[γ′ γ̄′ (γ − γ̄)]"
    assert (
        print_latex(trace(formula_of("bisector_determinant")))
        == r"[\gamma'\ \bar{\gamma}'\ \left(\gamma - \bar{\gamma}\right)]"
    )
    assert print_text(trace(formula_of("bisector_determinant_symmetric"))) == "[D1 D̄1 C]"


@over_formulas
def test_jets_have_the_order_that_was_found(name):
    f = FORMULAS[name]
    order = order_of(f, dimension(f))
    assert f(JetReading(order).argument(f.kind, dimension(f))) is not None
    assert f(RationalJetReading(order).argument(f.kind, dimension(f))) is not None


def test_a_jet_of_two_curves_is_substituted_by_their_splines():
    jets = JetReading(1).argument(PAIR, 3)
    value = formula_of("bisector_determinant_symmetric")(jets)
    given = argument("pair")
    assert substitute(value, given) == formula_of("bisector_determinant_symmetric")(given)
    jets = JetReading(1).argument(POINT_IN_SPACE, 3)
    given = argument("point")
    value = formula_of("direct_determinant_z")(jets)
    assert substitute(value, given) == formula_of("direct_determinant_z")(given)


def test_the_point_is_constant():
    ring = JetReading(1).argument(POINT_IN_SPACE, 2)
    assert ring.point[0].d().is_zero
    assert (ring.point[0] * ring.p[0]).d() == ring.point[0] * ring.p[0].d()


@pytest.mark.parametrize("kind", ["curve", "pair", "point"])
def test_operands_are_what_was_assembled(kind):
    made = {}

    def operand(name):
        made[name] = Order(len(made))
        return made[name]

    assert kind_of(kind).argument(3, lambda symbol: operand(symbol.name), Order(0)).operands() == made


def test_the_true_degree_in_one_parameter():
    """D1 loses one degree at infinity, the rest nothing: kd − m − 1 for the determinant in either curve's parameter."""
    assert generic_true_degree(formula_of("bisector_determinant_symmetric"), 3) == parse_degree("3d - 2")


def test_a_bisector_point_by_hand():
    """Two skew lines: the bisector of the x axis and of the parallel of the y axis at height 1 is a hyperbolic
    paraboloid.
    """
    first = Nurbs(1, [0, 0, 1, 1], [(0, 0, 0), (1, 0, 0)])
    second = Nurbs(1, [0, 0, 1, 1], [(0, 0, 1), (0, 1, 1)])
    surface = formula_of("bisector")(pair_with(first, second))
    for s, t in (("1/3", "1/2"), (0, 1), ("2/7", 0)):
        x, y, z = surface(s, t)
        assert (x, y) == (mpq(Fraction(s)), mpq(Fraction(t)))
        assert y * y + z * z == x * x + (z - 1) ** 2


def test_the_order_of_addition_counts_where_two_terms_share_a_denominator():
    """Cramer's rule for (31): the terms of the first and the last row are over one denominator; the claims add row by
    row.
    """
    c = DegreeReading().argument(POINT_IN_SPACE, 3)
    generator, offset, velocity = formula_of("point_bisector_generator")(c), c.gamma - c.point, c.gamma.d(1)
    first = cross(generator, offset) * formula_of("normal_height")(c)
    second = cross(offset, velocity) * dot(c.point, generator)
    third = cross(velocity, generator) * ((norm2(c.gamma) - norm2(c.point)) / 2)
    below = formula_of("point_bisector_determinant")(c)
    assert (
        ((first + second + third) / below).degree
        == formula_of("point_bisector_directrix")(c).degree
        == parse_degree("26d")
    )
    shared_first = (first + third + second) / below
    assert shared_first.degree == parse_degree("19d")
    assert ruled(shared_first, generator).degree == parse_degree("22d")


def test_a_point_and_a_line_give_a_parabolic_cylinder():
    line = Nurbs(1, [0, 0, 1, 1], [(0, 0, 0), (1, 0, 0)])
    surface = formula_of("point_bisector_direct_z")(line.with_point((mpq(0), mpq(1), mpq(0))))
    assert isinstance(surface, RuledSurface)
    for s in ("0", "1/3", "7/8"):
        x, y, z = surface.at(5)(s)
        assert (x, z) == (mpq(Fraction(s)), 5)
        assert y * y + z * z == x * x + (y - 1) ** 2 + z * z
