"""The parts that readings are made of, each held against what it means, with known answers."""

from math import comb

import pytest
import sympy
from flint import Ordering, fmpq, fmpq_mpoly_ctx
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from exactspline import BSpline
from exactspline.errors import FormulaError
from exactspline.language import Vector, cross, det, dot, join, perp
from exactspline.language.kinds import CURVE, PAIR, PLANE, SPACE, SURFACE, kind_of
from exactspline.readings import DegreeReading, JetReading, parse_degree
from exactspline.readings.bernstein_term import GenericReading
from exactspline.readings.degree import Degree, equal_from
from exactspline.readings.differential_order import is_polynomial, order_of
from exactspline.readings.factored_jet import divided_out
from exactspline.readings.jet import InOtherParameter, JetRing, RationalJetReading, derivative_mark, polynomial_text
from exactspline.readings.leading_terms import LeadingTermsReading, common_roots
from exactspline.readings.printing import print_latex, print_text, symbol_text
from exactspline.readings.sympy_expression import FIRST, Fractions, exact_quotient
from exactspline.readings.taylor import DoubleSeries, Series
from exactspline.readings.tree import TreeReading

T = BSpline.identity(0, 1)
fractions = st.fractions(min_value=-5, max_value=5, max_denominator=9)


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
    a, b = parse_degree(one), parse_degree(other)
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


def test_symbols_as_text():
    assert symbol_text(r"\mathbf{T}") == "𝐓"
    assert symbol_text(r"\|D_1\|^2") == "‖D1‖²"
    assert symbol_text(r"\frac{a}{b}") == "a/b"
    assert symbol_text(r"f_{12}''") == "f12″"


def test_how_often_one_polynomial_divides_another():
    x, y = fmpq_mpoly_ctx.get(["x", "y"], Ordering.degrevlex).gens()
    assert divided_out([(x + y) ** 3 * x], x + y) == (3, [x])
    assert divided_out([x], x + y) == (0, [x])


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


@pytest.mark.parametrize("order", range(1, 13))
def test_derivatives_of_any_order_in_print(order):
    w = TreeReading().argument(CURVE, 2).w.d(order)
    assert print_latex(w) == ("w" + "'" * order if order < 4 else f"w^{{({order})}}")
    raised = str(order).translate(str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹"))
    assert print_text(w) == "w" + {1: "′", 2: "″", 3: "‴"}.get(order, f"⁽{raised}⁾")


def test_operands_in_another_parameter_are_equal_when_their_values_are():
    c = RationalJetReading(2).argument(kind_of("plane with rho"), 2)
    x, y = (InOtherParameter(c.p[i], c.rho) for i in (0, 1))
    assert x * y == y * x
    assert x != y
    assert x != c.p[0]
    assert x.d(0) == x
    assert x.d(1) != x
    assert x.d(2) == x.d(1).d(1)


def test_a_jet_equals_no_other_jet_and_nothing_else():
    c = JetReading(1).argument(CURVE, 2)
    assert c.w != c.p[0]
    assert c.w != c.w.polynomial
    assert c.w == c.w * 1


def test_what_does_not_vanish_exactly_is_resolved_by_more_terms():
    """Of a sum of two gradings each gives its own leading term, as soon as that is known."""
    c = LeadingTermsReading(1, 2).argument(CURVE, 2)
    bend = lambda c: c.p[0].d(1) * c.p[1].d(2) - c.p[0].d(2) * c.p[1].d(1)  # noqa: E731
    assert bend(c).leading is None
    ((drop, _),) = bend(LeadingTermsReading(2, 2).argument(CURVE, 2)).leading.values()
    assert drop == 1
    assert (c.w - c.w).leading is None
    assert (c.w * 0).leading == {}


def test_quotients_of_sparse_polynomials_are_exact_or_none():
    x, y = (sympy.Function(name)(FIRST) for name in "xy")
    a, b = Fractions(x + y).ring.gens
    for p in (a + b, a - 2 * b, 3 * a * b + 1, a**2 - b**3):
        for q in (a + 3, b - a, 2 * a**2 * b - 5 * b):
            assert exact_quotient(p * q, p) == q
            assert exact_quotient(p * q + 1, p) is None
            assert exact_quotient(p, p * q) is None
    assert exact_quotient(a**2 + b, 2 * a) is None


@pytest.mark.parametrize("terms", [1, 2, 4])
def test_a_constant_at_infinity_is_known_to_as_many_terms_as_the_curve(terms):
    w = LeadingTermsReading(terms, 1).argument(CURVE, 2).w
    for number in (5, mpq(-2, 3)):
        ((grading, known),) = w.constant(number).parts.items()
        assert grading == (0, 0)
        assert known == [fmpq(int(mpq(number).numerator), int(mpq(number).denominator)), *[0] * (terms - 1)]
    assert w.constant(0).parts == {}
    assert (w * 3).parts == (w * w.constant(3)).parts == (w + w + w).parts
    assert w.constant(7).d(1).parts == {}


@pytest.mark.parametrize("degree", [1, 2, 3])
def test_generic_segments_multiply_and_differentiate_like_their_numbers(degree):
    """Forms Σ cᵢ (1 − t)ⁿ⁻ⁱ tⁱ with indeterminates for coefficients, held against splines with numbers for them."""
    c = GenericReading(degree).argument(CURVE, 2)
    context = c.w.context
    numbers = [fmpq(3 * i + 1, i + 2) for i in range(len(context.gens()))]

    def spline(f):
        values = [
            x.compose(*[context.constant(q) for q in numbers], ctx=context).leading_coefficient()
            for x in f.coefficients
        ]
        n = f.degree
        return BSpline.bezier([mpq(int(v.p), int(v.q)) / comb(n, i) for i, v in enumerate(values)])

    x, w = c.p[0], c.w
    a, b = spline(x), spline(w)
    assert spline(x * w) == a * b
    assert spline(x.d(1)) == a.d(1)
    assert spline(x * w + x) == a * b + a
    assert spline(x - w * w) == a - b * b
    assert (x - x).is_zero
    assert x.d(degree + 1).is_zero
    assert (x.d(degree + 1) * w).is_zero
    polynomial = GenericReading(degree).argument(CURVE, 2, polynomial=True)
    assert polynomial.w.coefficients == [1]
    assert polynomial.p[0] * polynomial.w == polynomial.p[0]


@pytest.mark.parametrize("order", range(12))
def test_marks_of_derivatives(order):
    raised = str(order).translate(str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹"))
    assert derivative_mark(("s",), (order,)) == ["", "′", "″", "‴", f"⁽{raised}⁾"][min(order, 4)]
    assert derivative_mark(("u", "v"), (order, 0)) == ("_" + "u" * order if order else "")
    assert derivative_mark(("u", "v"), (order, 2)) == "_" + "u" * order + "vv"


def test_the_variables_of_a_ring_are_derivatives_and_constants_once_each():
    ring = JetRing(kind_of("plane with delta"), 2, 2)
    assert sorted(ring.variables) == sorted([*[(n, (k,)) for n in ("x", "y", "w") for k in range(3)], ("delta", (0,))])
    assert ring.constants == ("delta",)
    hodograph = JetRing(kind_of("hodograph"), 2, 1)
    assert len(set(hodograph.variables)) == len(hodograph.variables)
    assert [n for n, _ in hodograph.variables if n in hodograph.rules] == list(hodograph.rules)


@pytest.mark.parametrize("terms", [1, 3])
def test_the_denominator_of_a_polynomial_curve_is_one_at_infinity(terms):
    c = LeadingTermsReading(terms, 1).argument(CURVE, 2, polynomial=True)
    ((grading, known),) = c.w.parts.items()
    assert grading == (0, 0)
    assert known == [1, *[0] * (terms - 1)]
    assert (c.p[0] * c.w).parts == c.p[0].parts


def test_derivatives_by_the_parameters_of_a_surface_are_subscripts():
    x = TreeReading().argument(SURFACE, 3).p[0]
    assert print_text(x.d(1, by="u")) == "p[0]_u"
    assert print_text(x.d(2, by="u").d(1, by="v")) == "p[0]_uuv"
    assert print_text((x.d(1, by="u") * 2).d(1, by="v")) == "(2 p[0]_u)_v"
    curve = TreeReading().argument(PAIR, 3).first
    assert print_text(curve.w.d(1, by="s")) == "∂_s w"
    assert print_text(curve.w.d(1)) == "w′"


def test_nodes_divide_and_are_divided_by_nodes_and_constants_alone():
    c = TreeReading().argument(CURVE, 2)
    assert print_text(c.w.dividing(c.p[0])) == "p[0]/w"
    assert print_text(c.w.dividing(3)) == "3/w"
    assert c.w.dividing(c.p).is_vector
    assert not c.w.dividing(c.p[0]).is_vector
    assert c.w.dividing(object()) is NotImplemented


places = st.tuples(st.integers(0, 3), st.integers(0, 3))


@given(st.dictionaries(places, fractions), st.dictionaries(places, fractions), st.integers(1, 4), st.integers(1, 4))
def test_a_product_of_series_in_two_variables_is_known_as_far_as_both(a, b, m, n):
    """Held against the product of polynomials in packed exponents: h = x, k = x¹⁶."""
    first, second = (
        DoubleSeries({p: mpq(x) for p, x in a.items()}, m),
        DoubleSeries({p: mpq(x) for p, x in b.items()}, n),
    )
    dense = {}
    for (i, j), x in first.coefficients.items():
        for (k, o), y in second.coefficients.items():
            dense.setdefault(i + k + 16 * (j + o), []).append(x * y)
    product = first * second
    assert product.terms == min(m, n)
    expected = {(e % 16, e // 16): sum(parts) for e, parts in dense.items() if e % 16 + e // 16 < min(m, n)}
    assert product.coefficients == {place: x for place, x in sorted(expected.items()) if x}
    assert first.__mul__("h") is NotImplemented
