"""One conformance suite over all readings: every formula means the same whichever way it is read."""

import re
from collections import Counter
from functools import cache
from itertools import product
from types import SimpleNamespace

import pytest
from gmpy2 import mpq

from exactspline import BSpline, Nurbs, example
from exactspline.errors import FormulaError
from exactspline.language import Rational, Vector, det, generalized_cross, norm2
from exactspline.language.arguments import Curve
from exactspline.language.kinds import CURVE, TABLE
from exactspline.language.ruled import RuledSurface
from exactspline.papers import all_formulas
from exactspline.readings import DegreeReading, JetReading, series_curve, trace
from exactspline.readings.degree import Degree
from exactspline.readings.differential_order import Order, order_of
from exactspline.readings.jet import Jet
from exactspline.readings.printing import ATOMS, print_latex, print_text
from exactspline.readings.taylor import Series, taylor
from exactspline.readings.tree import TreeReading
from exactspline.verification.divisors import Evaluation
from tests.support.sampled import FULL, sample

#: The formulas of one curve; those of two curves, or of a curve and a point, are in test_pairs.py.
FORMULAS = {name: f for name, f in all_formulas().items() if f.curve in ("curve", "plane", "space", "table")}
CASES = [(name, dimension) for name, f in FORMULAS.items() for dimension in f.kind.dimensions]
OF_CURVES = [(name, dimension) for name, dimension in CASES if FORMULAS[name].curve != "table"]


@cache
def traced(name, dimension, expand):
    """The tree of a formula, those that it calls by name or written out."""
    return trace(FORMULAS[name], dimension, expand=expand)


over_cases = pytest.mark.parametrize(("name", "dimension"), CASES, ids=str)
over_curves = pytest.mark.parametrize(("name", "dimension"), OF_CURVES, ids=str)
#: Where it takes long: of one reading, whatever the formula; one takes as long as forty others.
LONG = set() if FULL else {("focal_curve_by_arc_length", 3)}
over_some_cases, over_some_curves = (
    pytest.mark.parametrize(("name", "dimension"), [case for case in sample(cases, 90) if case not in LONG], ids=str)
    for cases in (CASES, OF_CURVES)
)

#: Two segments and unequal weights in the plane and in space; without inflections where they are evaluated.
CURVES = {
    2: Nurbs(2, [0, 0, 0, 1, 2, 2, 2], [(0, 0), (1, 2), (3, "5/2"), (4, 0)], [1, 2, "3/2", 1]),
    3: Nurbs(3, [0, 0, 0, 0, 2, 2, 2, 2], [(0, 0, 0), (1, 2, 0), (3, 1, 1), (4, 0, 5)], [1, 2, "3/2", 1]),
}
POLYNOMIALS = {dimension: Nurbs(c.degree, c.knots, c.control_points) for dimension, c in CURVES.items()}


def table(scalar, vector):
    """The operands of Table 1, made by one function for scalars and one for vectors, of the number 1 or 2."""
    return SimpleNamespace(**{f"{x}{i}": (vector if x == "v" else scalar)(x, i) for x in "pwv" for i in (1, 2)})


def spline_table():
    def spline(i, seed):
        knots = ([0, 0, 1, 3, 3], [0, 0, 0, 2, 3, 3, 3])[i - 1]
        return BSpline(i, knots, [seed + 2, 7 - seed, *range(1, len(knots) - i - 2)])

    return table(lambda x, i: spline(i, "pw".index(x)), lambda x, i: Vector(*[spline(i, k) for k in range(3)]))


def series_table(t, terms):
    s = spline_table()
    return table(
        lambda x, i: taylor(getattr(s, f"{x}{i}"), t, terms),
        lambda x, i: Vector(*[taylor(c, t, terms) for c in getattr(s, f"{x}{i}")]),
    )


def jet_table():
    return JetReading(2).argument(TABLE, 3)


def degree_table():
    return table(lambda x, i: Degree.named(f"d{i}"), lambda x, i: Vector(*[Degree.named(f"d{i}") for _ in range(3)]))


def order_table():
    return table(lambda x, i: Order(0), lambda x, i: Vector(*[Order(0)] * 3))


def order_curve(dimension):
    return Curve(Vector(*[Order(0) for _ in range(dimension)]), Order(0))


READINGS = {
    "spline": lambda n: CURVES[n],
    "polynomial spline": lambda n: POLYNOMIALS[n],
    "jet": lambda n, order: JetReading(order).argument(CURVE, n),
    "polynomial jet": lambda n, order: JetReading(order).argument(CURVE, n, polynomial=True),
    "degree": lambda n: DegreeReading().argument(CURVE, n),
    "polynomial degree": lambda n: DegreeReading().argument(CURVE, n, polynomial=True),
    "series": lambda n: series_curve(CURVES[n], "1/2", 8),
    "order": order_curve,
}
TABLES = {
    "spline": spline_table,
    "jet": jet_table,
    "degree": degree_table,
    "series": lambda: series_table("1/2", 3),
    "order": order_table,
}


def parts(x):
    """What a result consists of, in a form that can be compared in any reading."""
    if isinstance(x, RuledSurface):
        return ("ruled", parts(x.directrix), parts(x.generator))
    if isinstance(x, Rational):
        return ("rational", parts(x.numerator), parts(x.denominator))
    if isinstance(x, Vector):
        return ("vector", *map(parts, x))
    if isinstance(x, Series):
        return ("series", x.coefficients)
    if isinstance(x, Order):
        return ("order", x.order)
    if isinstance(x, BSpline):
        return ("spline", x.degree, x)
    if isinstance(x, Degree):
        return ("degree", repr(x))
    assert isinstance(x, Jet)
    return ("jet", x)


@over_some_cases
def test_a_traced_formula_means_what_the_formula_means(name, dimension):
    f = FORMULAS[name]
    for reading in TABLES if f.curve == "table" else READINGS:
        order = [order_of(f, dimension)] if "jet" in reading and f.curve != "table" else []
        c = TABLES[reading]() if f.curve == "table" else READINGS[reading](dimension, *order)
        direct = parts(f(c))
        assert parts(Evaluation(c)(traced(name, dimension, False))) == direct, reading
        assert parts(Evaluation(c)(traced(name, dimension, True))) == direct, reading


# ---- degrees


@pytest.mark.parametrize("kind", ["rational", "polynomial"])
@over_some_curves
def test_the_represented_degree_is_the_counted_one(name, dimension, kind):
    curves = [(CURVES if kind == "rational" else POLYNOMIALS)[dimension]]
    if (name, kind) in product(("f2", "D1_D2_D3", "velocity", "evolute"), ("rational",)):
        curves.append(example("rational_cubic" if dimension == 2 else "rational_space_cubic"))
    for curve in curves:
        counted = FORMULAS[name](DegreeReading().argument(CURVE, dimension, polynomial=kind == "polynomial"))
        result = FORMULAS[name](curve)
        assert result.degree == counted.degree.at({"d": curve.degree})
        if isinstance(result, Rational):
            assert result.denominator.degree == counted.denominator.degree.at({"d": curve.degree})
            assert result.numerator.degree == counted.numerator.degree.at({"d": curve.degree})


#: The formulas that are polynomials in the curve. (Not so quotients: the quotient rule raises degrees, and a jet has
#: none to raise.)
HOMOGENEOUS = [
    (name, n)
    for name, n in OF_CURVES
    if name != "flat_and_stationary"  # f2² + g2², of two degrees
    if not isinstance(FORMULAS[name](DegreeReading().argument(CURVE, n)), (Rational, RuledSurface))
]


#: D1, D2 and D21 are in one plane, as §3 shows line by line; [p p] is 0.
VANISH = {"D1_D2_D21", "span_line_1", "span_line_2", "span_line_3", "bracket_of_p_with_itself"}


@pytest.mark.parametrize(("name", "dimension"), HOMOGENEOUS, ids=str)
def test_the_grading_of_a_jet_gives_its_degree(name, dimension):
    """Degree k in the curve and weight m mean nominal degree kd − m; only a formula that vanishes on every curve has
    none.
    """
    jet, degree = (
        FORMULAS[name](JetReading(6).argument(CURVE, dimension)),
        FORMULAS[name](DegreeReading().argument(CURVE, dimension)),
    )
    pairs = zip(jet, degree, strict=True) if isinstance(jet, Vector) else [(jet, degree)]
    for j, counted in pairs:
        assert j.is_zero == (name in VANISH)
        if not j.is_zero:
            k, m = j.grading
            assert all(counted.at({"d": d}) == k * d - m for d in (1, 2, 5, 17))


def test_the_graded_formulas_are_many():
    assert len(HOMOGENEOUS) >= 15
    assert {"D1", "D2", "D3", "D21", "f1", "f2", "g2", "D1_D2_D3"} <= {name for name, _ in HOMOGENEOUS}


def test_derivatives_of_constants_and_of_zero_are_zero():
    for polynomial in (False, True):
        c = JetReading(1).argument(CURVE, 2, polynomial=polynomial)
        assert c.p[0].constant(5).d(3).is_zero
        assert (c.p[0] - c.p[0]).d(2).is_zero
    assert JetReading(2).argument(CURVE, 2, polynomial=True).w.d(2).is_zero


def test_an_inhomogeneous_jet_has_no_grading():
    c = JetReading(2).argument(CURVE, 2)
    for x in (c.w + 1, c.w + c.w.d(), c.w * 0):
        with pytest.raises(FormulaError, match="homogeneous"):
            _ = x.grading
    with pytest.raises(FormulaError, match="order 3"):
        c.w.d(3)


@over_some_curves
def test_the_order_of_a_formula_is_the_highest_derivative_in_its_jet(name, dimension):
    order = order_of(FORMULAS[name], dimension)
    assert FORMULAS[name](JetReading(order).argument(CURVE, dimension)) is not None
    if order:
        with pytest.raises(FormulaError, match=f"the derivative of order {order}"):
            FORMULAS[name](JetReading(order - 1).argument(CURVE, dimension))


# ---- series against splines


def joined(x):
    """A ruled surface as one vector, directrix and generator side by side; anything else as it is."""
    return x.joined if isinstance(x, RuledSurface) else x


def numbers_of(x, t):
    """Value and first derivative at t of what a formula returned on splines, by numbers alone: n/w and (n′w −
    nw′)/w².
    """
    x = joined(x)
    tops = (
        list(x.numerator if isinstance(x, Rational) else x)
        if getattr(x, "is_vector", False)
        else [x.numerator if isinstance(x, Rational) else x]
    )
    if not isinstance(x, Rational):
        return [(n(t), n.d()(t)) for n in tops]
    w, dw = x.denominator(t), x.denominator.d()(t)
    return [(n(t) / w, (n.d()(t) * w - n(t) * dw) / w**2) for n in tops]


@over_some_curves
def test_series_are_the_values_and_derivatives_of_splines(name, dimension):
    terms = order_of(FORMULAS[name], dimension) + 2
    for curve in (CURVES[dimension], POLYNOMIALS[dimension]):
        value = FORMULAS[name](curve)
        for t in ("1/3", "1", "9/5"):
            series = joined(FORMULAS[name](series_curve(curve, t, terms)))
            components = list(series) if isinstance(series, Vector) else [series]
            assert [(s.value, s.d().value) for s in components] == numbers_of(value, mpq(t))


@pytest.mark.parametrize("name", [n for n, f in FORMULAS.items() if f.curve == "table"])
def test_series_are_the_values_and_derivatives_of_table_1(name):
    for t in ("1/2", "2", "0"):
        series = FORMULAS[name](series_table(t, 4))
        components = list(series) if isinstance(series, Vector) else [series]
        assert [(s.value, s.d().value) for s in components] == numbers_of(FORMULAS[name](spline_table()), mpq(t))


def test_series_at_a_knot_take_the_side_asked_for():
    kink = BSpline(1, [0, 0, 1, 2, 2], [0, 1, 5])
    assert taylor(kink, 1, 3, "left").coefficients == (1, 1, 0)
    assert taylor(kink, 1, 3).coefficients == (1, 4, 0)
    with pytest.raises(FormulaError, match="vanishes"):
        1 / taylor(kink, 0, 3)


# ---- trees and printers


def operation_counts(node):
    """How often each operation is carried out, shared nodes counted once."""
    seen, counts, todo = set(), Counter(), [node]
    while todo:
        n = todo.pop()
        if id(n) not in seen:
            seen.add(id(n))
            todo += n.args
            if n.op not in ATOMS:
                counts[n.op] += 1
    return counts


def test_a_tree_keeps_what_is_written():
    assert operation_counts(trace(FORMULAS["D1"])) == {"-": 1, "*": 2, "d": 2}
    assert operation_counts(trace(FORMULAS["T17"])) == {"/": 1, "d": 1}
    assert operation_counts(traced("f1", 2, True)) == operation_counts(traced("f1", 2, False))
    assert [print_text(traced("f1", 2, expand)) for expand in (False, True)] == [
        "[D1 D2]",
        "[(p′ w − p w′) (p″ w − p w″)]",
    ]
    square = TreeReading().argument(CURVE, 2).w
    assert operation_counts(square * square) == {"*": 1}


def test_formulas_called_within_one_another_are_evaluated_anew_on_every_curve():
    """What is remembered while one formula is evaluated is forgotten with it, also when it fails."""
    first, second = JetReading(1).argument(CURVE, 2), JetReading(2).argument(CURVE, 2)
    for _ in range(2):
        with pytest.raises(FormulaError, match="order 2"):
            FORMULAS["f1"](first)
        assert FORMULAS["D1"](first)[0] == first.p[0].d() * first.w - first.p[0] * first.w.d()
    assert FORMULAS["f1"](second) == second.w * FORMULAS["f2"](second)
    second.w = second.w * 2
    assert FORMULAS["f1"](second) == second.w * FORMULAS["f2"](second)


CLOSING = {")": "(", "]": "[", "}": "{"}


def assert_balanced(text):
    """Every bracket is closed by its own kind; \\left and \\right pair up."""
    open_ones = []
    for sign in text:
        if sign in CLOSING.values():
            open_ones.append(sign)
        elif sign in CLOSING:
            assert open_ones
            assert open_ones.pop() == CLOSING[sign]
    assert not open_ones
    assert text.count(r"\left(") == text.count(r"\right)")


#: One argument of a power: a group (two deep), a command or a sign.
ARGUMENT = r"(?:\{(?:[^{}]|\{[^{}]*\})*\}|\\[a-zA-Z]+|.)"
DOUBLE_SUPERSCRIPT = re.compile(rf"\^{ARGUMENT}(?:_{ARGUMENT})?(?:\^|')")


def assert_latex(text):
    assert_balanced(text)
    assert not DOUBLE_SUPERSCRIPT.search(text), text
    assert not re.search(r"(?<!\\)[⊥′″‴γκτ×·−]", text)


def assert_text(text):
    assert_balanced(text)
    assert "\\" not in text
    assert "{" not in text
    assert "_" not in text
    assert not re.search(r"[²³⁴⁵⁶⁷⁸⁹][²³⁴⁵⁶⁷⁸⁹′″‴]", text), text


@over_cases
def test_printed_formulas_are_well_formed(name, dimension):
    for expand in (False, True):
        tree = traced(name, dimension, expand)
        assert_latex(print_latex(tree))
        assert_text(print_text(tree))


@pytest.mark.parametrize("name", [n for n, f in FORMULAS.items() if f.symbol])
def test_symbols_can_be_raised_and_differentiated(name):
    """A named formula that another one squares or differentiates prints without two exponents on one base."""
    for outer in (lambda x: x**2, lambda x: x.d(1), lambda x: x.d(4), lambda x: x * x):
        node = outer(FORMULAS[name](TreeReading().argument(CURVE, 2)))
        assert_latex(print_latex(node))
        assert_text(print_text(node))


def test_a_squared_length_can_be_raised_to_a_power():
    c = TreeReading().argument(CURVE, 2)
    node = norm2(c.p.d(1)) ** 3 / norm2(c.p)
    assert_latex(print_latex(node))
    assert_text(print_text(node))
    assert_latex(print_latex(norm2(c.p).d(1)))


def test_printed_examples():
    assert print_text(trace(FORMULAS["f2"])) == "[p′ p″] w − [p p″] w′ − [p′ p] w″"
    assert print_latex(trace(FORMULAS["f2"])) == r"[p'\ p'']\,w - [p\ p'']\,w' - [p'\ p]\,w''"
    assert print_text(trace(FORMULAS["velocity_shared"])) == "D1/w²"
    assert print_latex(trace(FORMULAS["velocity_shared"])) == r"\frac{D_1}{w^{2}}"
    c = TreeReading().argument(CURVE, 3)
    assert print_text(c.p.d(1) - (c.p - c.p.d(2))) == "p′ − (p − p″)"
    assert print_text((c.w + 1) * (c.w - 1)) == "(w + 1) (w − 1)"
    assert print_text(c.w / (c.w * c.w)) == "w/(w w)"
    assert print_text((c.w + 1) ** 2 / 3) == "(w + 1)²/3"
    assert print_text((c.w * c.w).d(1)) == "(w w)′"
    assert print_text(-(c.w + 1)) == "−(w + 1)"
    assert print_text(c.w * mpq(1, 2)) == "w (1/2)"
    assert print_latex(mpq(1, 2) * c.w) == r"\tfrac{1}{2}\,w"
    assert print_text(c.p[0] * c.p.d(1)[2]) == "p[0] p′[2]"
    assert_balanced(print_latex(generalized_cross(c.p, c.p.d(1))))


def test_printed_text_tells_different_trees_apart():
    """The determinant of a product and a vector is not printed as one of three vectors; quotients of products are not
    products of quotients.
    """
    c = TreeReading().argument(CURVE, 3)
    assert print_text(det(c.p * c.w, c.p.d(1))) != "[p w p′]"
    assert print_text(c.w / (c.w * c.w)) != print_text((c.w / c.w) * c.w)
    assert print_text((c.w**2).d(1)) != print_text(c.w.d(1) ** 2)
    assert print_latex(c.w / (c.w / c.w)) != print_latex((c.w / c.w) / c.w)
    assert print_text(c.w - (c.w - c.w)) != print_text((c.w - c.w) - c.w)
