"""The parts that readings, reductions and roots are made of, each held against what it means, with known answers."""

from math import nextafter

import pytest
from flint import Ordering, fmpq, fmpq_mpoly_ctx, fmpz_poly
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from exactspline import BSpline, zeros
from exactspline.errors import FormulaError
from exactspline.language.kinds import CURVE, PAIR, PLANE, SPACE
from exactspline.language.vector import Vector, cross, det, dot, join, perp
from exactspline.papers import find
from exactspline.readings.degree import Degree, DegreeReading, equal_from, parse
from exactspline.readings.differential_order import is_polynomial, order_of
from exactspline.readings.factored_jet import FactoredJetReading, divided_out
from exactspline.readings.jet import JetReading, polynomial_text
from exactspline.readings.leading_terms import LeadingTermsReading, common_roots
from exactspline.readings.printing.latex import print_latex
from exactspline.readings.printing.text import print_text, symbol_text
from exactspline.readings.rational_jet import RationalJetReading
from exactspline.readings.taylor import Series, taylor
from exactspline.readings.tree import TreeReading, trace
from exactspline.roots.enclosure import Enclosure, rounded_outwards, sign_at, value_at, values_between
from exactspline.roots.real import Real
from exactspline.splines.examples import example
from exactspline.symbolic.assumptions import ASSUMPTIONS, assumption, zero_free
from exactspline.symbolic.covariants import TrueDegree, product_of, true_degree
from exactspline.symbolic.factorization import Factor, find_factor, jets_for, name_of_vector
from exactspline.symbolic.motions import _rotation as rotation
from exactspline.symbolic.reduction import reduce, reduction
from exactspline.symbolic.substitution import substitute

T = BSpline.identity(0, 1)
fractions = st.fractions(min_value=-5, max_value=5, max_denominator=9)


# ---- series


@given(st.lists(fractions, min_size=3, max_size=5))
def test_a_constant_series_is_known_to_as_many_terms(coefficients):
    h = Series(map(mpq, coefficients))
    assert h.constant(7).coefficients == (7, *[0] * (len(coefficients) - 1))
    assert (h + 2 - h).coefficients == h.constant(2).coefficients
    if coefficients[0]:
        assert (h * h.reciprocal()).coefficients == h.constant(1).coefficients
    assert h.d().coefficients == tuple(i * a for i, a in enumerate(map(mpq, coefficients)) if i)
    assert h.d(2).coefficients == h.d().d().coefficients
    with pytest.raises(FormulaError):
        h.d(len(coefficients))
    assert not (h - h + 1).is_zero
    assert (h - h).is_zero


def test_a_series_holds_the_values_and_derivatives_of_the_spline():
    f = BSpline(3, [0, 0, 0, 0, 1, 1, 1, 1], [1, -2, 5, "1/3"])
    told = taylor(f, "1/3", 6)
    assert told.coefficients == (f("1/3"), f.d(1)("1/3"), f.d(2)("1/3") / 2, f.d(3)("1/3") / 6, 0, 0)


# ---- orders and degrees


def test_orders_are_those_of_the_highest_derivative():
    assert order_of(lambda c: c.w.constant(5), 2) == 0
    assert order_of(lambda c: c.w.constant(5) * c.p[0].d(3), 2) == 3
    assert order_of(lambda c: Vector(c.p[0], c.w.d(2)), 2) == 2
    assert order_of(lambda c: c.p[0] / c.w.d(4), 2) == 4
    assert is_polynomial(lambda c: Vector(c.p[0], c.w.d(2)), 2)
    assert not is_polynomial(lambda c: c.p[0] / c.w, 2)


@pytest.mark.parametrize(
    ("one", "other", "start"),
    [
        ("3d − 6", "3d − 6", 1),
        ("max(2d, 3d − 4)", "3d − 4", 4),
        ("d", "2d", None),
        ("max(7, d)", "d", 7),
        ("5", "5", 1),
    ],
)
def test_degrees_are_equal_from_the_first_d_on(one, other, start):
    a, b = parse(one), parse(other)
    assert equal_from(a, b) == start
    if start is not None:
        assert all(a.at({"d": d}) == b.at({"d": d}) for d in range(start, start + 20))
        assert start == 1 or a.at({"d": start - 1}) != b.at({"d": start - 1})


def test_degrees_of_sums_products_and_derivatives():
    d = Degree.named("d")
    assert str(d * d) == "2d"
    assert str(d.max(Degree.number(3))) in ("max(d, 3)", "max(3, d)")
    assert (d * d).at({"d": 5}) == 10
    c = DegreeReading().argument(CURVE, 2)
    assert str((c.p[0] * c.w).degree) == "2d"
    assert str((c.p[0] + c.p[0] * c.w).degree) == "2d"
    assert str(c.p[0].d(1).degree) == "d − 1"
    assert str((c.p[0] / c.w).d(1).degree) == "2d"


# ---- leading terms


def test_a_factor_of_higher_degree_has_no_root_of_its_own():
    """d² − 3d + 3 has no root, although −p₀/p₁ = 1; d² + 1 has no linear term."""
    d, x = fmpq_mpoly_ctx.get(["d", "x"], Ordering.degrevlex).gens()
    assert common_roots((d**2 - 3 * d + 3) * x) == ()
    assert common_roots((d**2 + 1) * x) == ()
    assert common_roots((2 * d - 3) * x) == ()
    assert common_roots((d - 1) * x) == (1,)
    assert common_roots(d * x) == ()


def test_the_second_curve_stays_where_it_is_at_infinity():
    c = LeadingTermsReading(2, 1).argument(PAIR, 3)
    assert c.first.p[0].parts.keys() == {(1, 0)}
    assert c.second.p[0].parts.keys() == {(0, 0)}
    assert c.second.p[0].d(1).leading[0, 0][0] == 0
    assert c.second.p[0].d(1).leading[0, 0][1] != c.second.p[0].leading[0, 0][1]
    ((drop, term),) = (c.first.p[0] * c.second.w.d(1)).leading.values()
    assert drop == 0
    assert len(term) == 1


# ---- trees


def test_trees_know_which_of_their_nodes_are_vectors():
    c = TreeReading().argument(CURVE, 3)
    assert (c.p * c.w).is_vector
    assert (c.w * c.p).is_vector
    assert not (c.w * c.w).is_vector
    assert (2 * c.p).is_vector
    assert (-c.p).is_vector
    assert c.p.d(1).is_vector
    assert c.p[0:2].is_vector
    assert not c.p[0].is_vector
    assert (c.p / c.w).is_vector
    assert join(c.p[0], 1, c.w).is_vector
    assert c.dimension == 3
    with pytest.raises(FormulaError, match="has no operand 'q'"):
        _ = c.q


def test_of_two_curves_the_second_one_has_a_bar():
    tree = trace(find("chord"))
    assert print_text(tree) == "p w̄ − p̄ w"
    assert print_latex(tree) == r"p\,\bar{w} - \bar{p}\,w"
    assert print_text(trace(find("second_normal"))) != print_text(trace(find("velocity")))


def test_symbols_as_text():
    assert symbol_text(r"\mathbf{T}") == "𝐓"
    assert symbol_text(r"\|D_1\|^2") == "‖D1‖²"
    assert symbol_text(r"\frac{a}{b}") == "a/b"
    assert symbol_text(r"f_{12}''") == "f12″"


# ---- jets


def test_factored_jets_are_the_jets():
    """Sums of products with common factors, derivatives of powers; multiplied out they are what plain jets are."""

    def value(c):
        x, y, w = *c.p, c.w
        a, b = x.d(1) * w - x * w.d(1), y * w * w
        return (a * a * b - a * b * b).d(1) * w + a.scaled(mpq(-2, 3)) - (a * w).d(2)

    plain, factored = (reading(4).argument(CURVE, 2) for reading in (JetReading, FactoredJetReading))
    assert value(factored).expanded() == value(plain).polynomial
    x = factored.p[0]
    assert (x - x).is_zero
    assert ((x - x) * x).is_zero
    assert (x * 0).is_zero
    assert (x - 2 * x).expanded() == -x.expanded()
    assert (x + (x - x)) == x == (x - x) + x
    assert ((x - x) - x) == -x
    assert x != 2 * x


def test_how_often_one_polynomial_divides_another():
    x, y = fmpq_mpoly_ctx.get(["x", "y"], Ordering.degrevlex).gens()
    assert divided_out((x + y) ** 3 * x, x + y) == (3, x)
    assert divided_out(x, x + y) == (0, x)


def test_quotients_are_equal_when_they_are_the_same_function():
    c = RationalJetReading(2).argument(CURVE, 2)
    x, y = c.gamma
    assert x * y == y * x
    assert x / y == (x * c.w) / (y * c.w)
    assert x != y
    assert x / y != y / x
    assert x != x * 2
    assert (x / y).d(1) == (x.d(1) * y - x * y.d(1)) / (y * y)
    assert x != "x"
    assert (x - x).is_zero
    assert (x * 0).bottom.is_one()


def test_polynomials_are_cut_after_so_many_terms():
    c = JetReading(1).argument(CURVE, 2)
    jet = c.p[0] * 2 - c.w.d(1) * c.p[1] + 1
    assert polynomial_text(jet, 1).endswith("… (3 terms)")
    assert polynomial_text(jet) in ("−y·w′ + 2·x + 1", "−w′·y + 2·x + 1")
    assert polynomial_text(jet * 0) == "0"


# ---- substitution


@pytest.mark.parametrize("name", ["f2", "vertices_lifted", "D1_squared", "g2"])
def test_a_jet_on_a_curve_is_the_formula_there(name):
    curve = example("rational_cubic")
    f = find(name)
    jet = f(JetReading(order_of(f, 2)).argument(CURVE, 2))
    assert substitute(jet, curve) == f(curve)


def test_a_jet_with_constants_on_a_curve():
    curve, c = example("rational_cubic"), JetReading(1).argument(CURVE, 2)
    x, y, w = *c.p, c.w
    p, q, v = *curve.p, curve.w
    for jet, expected in (
        (x * x * x + 2 * x + 1, p * p * p + 2 * p + 1),
        (x * x + y * w - 3, p * p + q * v - 3),
        (5 - x * x * w + x * y, 5 - p * p * v + p * q),
        (x * y * y + x * x * y + y, p * q * q + p * p * q + q),
        (w.constant(4), v.constant(4)),
        (x - x, v.constant(0)),
        (x.d(1) * y + 2, p.d(1) * q + 2),
    ):
        assert substitute(jet, curve) == expected


# ---- assumptions and names


def test_assumptions_speak_of_the_curve_that_they_name():
    pair = JetReading(1).argument(PAIR, 3)
    assert assumption("w").polynomial(pair) == pair.first.w
    assert assumption("w̄").polynomial(pair) == pair.second.w
    assert assumption("γ′").polynomial(pair) == find("D1_squared")(pair.first)
    assert assumption("γ̄′").polynomial(pair) == find("D1_squared")(pair.second)
    name = "[γ′ γ̄′ γ−γ̄] ≢ 0"
    assert assumption(name).polynomial(pair) == find("bisector_determinant_symmetric")(pair)
    space = JetReading(2).argument(SPACE, 3)
    bend = find("binormal_form")(space)
    assert assumption("γ′×γ″").polynomial(space) == sum((x * x for x in bend), space.w.constant(0))
    assert {each.everywhere for name, each in ASSUMPTIONS.items() if "≢" in name} == {False}


def test_what_has_no_zero_is_what_divides_a_polynomial_without_one():
    plane = JetReading(1).argument(CURVE, 2)
    assert zero_free(find("D1_squared")(plane)).name == "γ′"
    assert zero_free(plane.w).name == "w"
    assert zero_free(plane.p[0]) is None
    assert zero_free(plane.w, [assumption("γ′")]) is None
    assert zero_free(plane.w, [assumption("γ′ ≢ 0")]) is None
    space = JetReading(2).argument(SPACE, 3)
    assert zero_free(assumption("γ′×γ″").polynomial(space)).name == "γ′×γ″"
    assert zero_free(find("D1_squared")(JetReading(1).argument(SPACE, 3))).name == "γ′"
    polynomial = JetReading(1).argument(CURVE, 2, polynomial=True)
    assert zero_free(find("D1_squared")(polynomial)).name == "γ′"
    assert zero_free(polynomial.w).name == "γ′"


def test_vectors_are_named_by_what_they_are_multiples_of():
    c = JetReading(2).argument(SPACE, 3)
    first = list(find("D1")(c))
    assert name_of_vector(first) == ("D1", 1)
    assert name_of_vector([-3 * x for x in first]) == ("D1", -3)
    assert name_of_vector([x * 0 for x in first]) == ("0", 1)
    assert name_of_vector([first[0], first[1], first[0]])[0].startswith("(")
    x, w = c.p[0], c.w
    name, unit = name_of_vector([(-4 * x * w.d(1)), 6 * w * w])
    assert unit == -2
    assert name == "(2·x·w′, −3·w²)"
    name, unit = name_of_vector([x * mpq(2, 3), w * w * mpq(4, 9)])
    assert (name, unit) == ("(3·x, 2·w²)", mpq(2, 9))
    assert name_of_vector([first[2], x * w])[0].startswith("(")
    assert name_of_vector([x * 0, first[1], first[2] * 2])[0].startswith("(")


def test_factors_are_quotients():
    c = jets_for(("f1", "f2"), 2)
    f1, f2 = find("f1")(c), find("f2")(c)
    assert str(find_factor(f1, f2)) == "w"
    assert str(find_factor(f2, f1)) == "w⁻¹"
    zero = find_factor(f1 * 0, f2)
    assert zero.is_zero
    assert not zero.is_one
    assert find_factor(-f2, f2).constant == -1
    assert not find_factor(-f2, f2).is_zero
    assert not find_factor(-f2, f2).is_one
    assert find_factor(f2, f2).is_one
    assert str(find_factor(f2 * mpq(3, 2), f2)) == "3/2"
    assert find_factor(Vector(f1, f2), Vector(f2, f1)) is None
    assert str(find_factor(Vector(f1, f1), Vector(f2, f2))) == "w"
    assert isinstance(zero, Factor)


# ---- degrees of products and reductions


def test_the_degree_of_a_product_is_the_sum_and_lower_where_a_factor_is():
    """1·d at every d but 2, where it is 1; 0 at d = 1."""
    a = TrueDegree(1, 0, 0, ((1, -1), (2, 1)))
    b = TrueDegree(3, 3, 1, ())
    told = product_of([(a, 1), (b, 2)])
    assert (told.k, told.m, told.j) == (7, 6, 2)
    assert told.lower == ((1, -1), (2, 1 + 2 * b.at(2)))
    assert [told.at(d) for d in (1, 2, 3)] == [-1, 1 + 2 * b.at(2), 3 + 2 * b.at(3)]
    assert b.at(5) == 3 * 5 - 6 + 1
    plain = product_of([(b, 1)])
    assert plain == b
    same = TrueDegree(1, 0, 0, ((4, 4),))
    assert product_of([(same, 1)]).lower == ()
    assert product_of([(TrueDegree(1, 1, 0, ((4, 2),)), 1)]).lower == ()


def test_a_product_in_jets_has_the_degree_of_its_factors():
    c = JetReading(2).argument(CURVE, 2)
    f2, w = find("f2")(c), c.w
    told = product_of([(true_degree(f2), 2), (true_degree(w), 3)])
    direct = true_degree(f2 * f2 * w * w * w)
    assert (told.k, told.m, told.j) == (direct.k, direct.m, direct.j)
    assert [told.at(d) for d in range(1, 9)] == [direct.at(d) for d in range(1, 9)]


def test_reduced_forms_keep_what_the_numerator_has_more():
    """f2³ w / (f2 w³): kept is f2², a pole nothing, cancelled w⁻²."""
    f2 = find("f2")
    part = reduce(lambda c: f2(c) ** 3 * c.w / (f2(c) * c.w**3), dimension=2).main
    c = JetReading(2).argument(CURVE, 2)
    own = f2(c)
    assert part.reduced == (own * own,)
    assert str(part.rooted) == "f2²"
    assert part.poles.is_one
    top, bottom = part.lowest
    assert top[0] * c.w * c.w == own * own * bottom
    upside = reduce(lambda c: c.w / f2(c) ** 2, dimension=2).main
    assert str(upside.poles) == "f2²"
    assert upside.rooted.is_one
    assert str(upside.generic_lowest) == "max(6d − 12, d)"
    assert upside.data()["k"] == 0
    assert str(part.generic) == "6d − 12"
    assert str(part.generic_lowest) == "max(6d − 12, 2d)"


def test_what_vanishes_has_no_degree_over_whatever_stands():
    nothing = reduce(lambda c: (c.p[0] - c.p[0]) / find("f2")(c), dimension=2).main
    assert nothing.is_zero
    assert str(nothing.generic) == str(nothing.generic_lowest) == "−1"
    assert nothing.text == "0"
    assert nothing.true is None
    data = nothing.data()
    assert (data["k"], data["m"], data["j"], data["nominal"], data["lower"]) == (None, None, None, "", {})
    some = reduction("f0", 2).main.data()
    assert (some["k"], some["m"], some["j"], some["nominal"]) == (3, 3, 0, "3d − 3")
    assert some["true"] == "3d − 6"


# ---- roots


def test_enclosures_are_rounded_outwards_and_say_their_middle():
    low, high = rounded_outwards(
        (mpq(1, 3), mpq(2, 3)) and type(values_between(T, mpq(0), mpq(1)))(mpq(1, 3), mpq(2, 3)), 2
    )
    assert (low, high) == (mpq(33, 100), mpq(67, 100))
    told = Enclosure(mpq(-1, 3), mpq(-1, 3), 4)
    assert str(told) == "-0.3333"
    assert mpq(-1, 3) in told
    assert mpq(1, 3) not in told
    assert str(Enclosure(mpq(5, 2), mpq(5, 2), 0)) == "3"
    assert str(Enclosure(mpq(-5, 2), mpq(-5, 2), 0)) == "-2"
    assert float(Enclosure(mpq(1, 3), mpq(1, 3), 3)) == 1 / 3
    assert Enclosure(mpq(0), mpq(1), 3).middle == mpq(1, 2)


def test_values_at_roots_are_as_narrow_as_asked():
    t = BSpline.identity(0, 2)
    (root,) = zeros(t * t - 2)
    for digits in (3, 12, 40):
        (square,) = value_at((t * t * t,), None, root, digits)
        assert square.high - square.low <= mpq(1, 10**digits)
        assert square.low**2 <= 8 <= square.high**2
        (quotient,) = value_at((t,), t * t, root, digits)
        assert quotient.low**2 <= mpq(1, 2) <= quotient.high**2
        assert quotient.high - quotient.low <= mpq(1, 10**digits)


def test_signs_at_roots_are_exact():
    t = BSpline.identity(0, 2)
    (root,) = zeros(t * t - 2)
    near = mpq(14142135623730950488016887242096980785696718753769, 10**49)
    assert sign_at(t - near, root) == 1
    assert sign_at(near - t, root) == -1
    assert sign_at(t * t - 2, root) == 0
    assert sign_at(t * 0, root) == 0
    assert sign_at(t - 1, mpq(1)) == 0
    jumping = BSpline(0, [0, 1, 2], [-1, 1])
    assert (sign_at(jumping, mpq(1), "left"), sign_at(jumping, mpq(1), "right")) == (-1, 1)


def test_a_root_is_one_of_exactly_the_polynomials_that_it_satisfies():
    t = BSpline.identity(0, 2)
    (root,) = zeros(t * t - 2)
    assert root.is_root_of(fmpz_poly([-2, 0, 1]))
    assert root.is_root_of(fmpz_poly([-2, 0, 1]) * fmpz_poly([5, 7, 1]))
    assert not root.is_root_of(fmpz_poly([-2, 1]))
    assert not root.is_root_of(fmpz_poly([2, 0, 1]))
    assert not root.is_root_of(fmpz_poly([1]))
    (half,) = zeros(2 * t - 1)
    assert half.is_root_of(fmpz_poly([-1, 2]))
    assert half.is_root_of(fmpz_poly([0, -1, 2]))
    assert not half.is_root_of(fmpz_poly([1, 2]))
    assert not half.is_root_of(fmpz_poly([1]))
    (at_zero,) = zeros(t)
    assert at_zero.is_root_of(fmpz_poly([0, 1]))
    assert not at_zero.is_root_of(fmpz_poly([1, 1]))


@pytest.mark.parametrize("exponent", [1, 50, 120, 400])
def test_roots_that_nearly_coincide_are_told_apart(exponent):
    """(t − 1/3)(t − 1/3 − ε) with ε = 2⁻ᵉ, and (t − 1/3)² − ε: enclosed to any number of digits."""
    tiny = mpq(1, 2**exponent)
    f = (T - mpq(1, 3)) * (T - mpq(1, 3) - tiny) if exponent > 1 else (T - mpq(1, 3)) * (T - mpq(5, 6))
    assert len(zeros(f)) == 2
    close = (T - mpq(1, 3)) ** 2 - tiny / 16
    found = zeros(close)
    assert len(found) == 2
    for digits in (5, 60, 300):
        for root, sign in zip(found, (-1, 1), strict=True):
            low, high = root.refine(digits)
            assert low < high <= low + mpq(1, 10**digits) or low == high
            ends = sorted([(low - mpq(1, 3)) * sign, (high - mpq(1, 3)) * sign])
            assert ends[0] ** 2 <= tiny / 16 <= ends[1] ** 2


def test_plane_and_space_have_their_own_jets():
    assert len(JetReading(1).argument(PLANE, 2).p) == 2
    assert LeadingTermsReading(1).argument(CURVE, 3).p[2].leading[1, 0][0] == 0
    assert fmpq(1) == RationalJetReading(0).argument(CURVE, 2).w.constant(1).top.leading_coefficient()


# ---- what others build on


@given(st.tuples(fractions, fractions, fractions))
def test_a_rotation_keeps_lengths_and_orientation_and_its_axis(quaternion):
    """R Rᵀ = 1, det R = 1; the axis (a, b, c) stays; about the third axis it is the rotation of the plane."""
    a, b, c = map(mpq, quaternion)
    rows = rotation(3, {"turn1": a, "turn2": b, "turn3": c})
    assert [[sum(x * y for x, y in zip(p, q, strict=True)) for q in rows] for p in rows] == [
        [int(i == j) for j in range(3)] for i in range(3)
    ]
    assert det(*[Vector(*row) for row in rows]) == 1
    assert [row[0] * a + row[1] * b + row[2] * c for row in rows] == [a, b, c]
    flat, about = rotation(2, {"turn1": c}), rotation(3, {"turn1": 0, "turn2": 0, "turn3": c})
    assert [row[:2] for row in about[:2]] == flat
    cosine, sine = (1 - c * c) / (1 + c * c), 2 * c / (1 + c * c)
    assert flat == [[cosine, -sine], [sine, cosine]]


@pytest.mark.parametrize("sign", [1, -1, 0])
def test_the_root_of_a_quotient_at_a_root(sign):
    """√(t/3) and its negative at t = √2: the fourth power times 81/... is 2/9."""
    t = BSpline.identity(1, 2)
    told = Real.root_of_quotient_at(sign, t, t.constant(3), zeros(t * t - 2).roots[0])
    value = told.told(30)
    if sign == 0:
        assert value == 0
    else:
        assert sorted([value.low**4, value.high**4])[0] <= mpq(2, 9) <= sorted([value.low**4, value.high**4])[1]
        assert value.high - value.low <= mpq(1, 10**30)
        assert value.low * sign > 0
        nearest = sign * told.double()
        below, above = (mpq(nextafter(nearest, end)) for end in (0, 1))
        assert ((below + mpq(nearest)) / 2) ** 4 < mpq(2, 9) < ((mpq(nearest) + above) / 2) ** 4
        assert told.double("down") <= told.double("up")
    assert Real.root_of_quotient_at(1, t * t - 2, t, zeros(t * t - 2).roots[0]).told(5) == 0


def test_products_of_vectors_are_vectors_or_numbers_in_trees():
    c = TreeReading().argument(SPACE, 3)
    v = c.p.d(1)
    assert cross(c.p, v).is_vector
    assert not dot(c.p, v).is_vector
    assert not det(c.p, v, v.d(1)).is_vector
    assert perp(TreeReading().argument(PLANE, 2).p).is_vector


def test_derivatives_by_one_of_two_parameters_are_written_with_it():
    c = TreeReading().argument(PAIR, 3)
    assert r"\partial_{s} " in print_latex(c.first.w.d(1, by="s"))
    assert r"\partial_{s}^{2} " in print_latex(c.first.w.d(2, by="s"))


def test_a_vector_times_itself_is_a_squared_length_and_no_other_product_is():
    c = TreeReading().argument(PLANE, 2)
    p, v = c.p, c.p.d(1)
    assert print_text(dot(p, p)) == "‖p‖²"
    assert print_text(dot(p, v)) == "p · p′"
    assert print_latex(dot(p, p)) == r"\|p\|^2"
    assert "\\|" not in print_latex(dot(v, p))


@pytest.mark.parametrize("power", range(0, 60, 7))
def test_enclosures_are_narrow_enough_whatever_the_slope(power):
    t = BSpline.identity(0, 2)
    (root,) = zeros(t * t - 2)
    (value,) = value_at((t.scaled(3**power),), None, root, 40)
    assert value.high - value.low <= mpq(1, 10**40)
    assert value.low**2 <= 2 * mpq(9) ** power <= value.high**2
