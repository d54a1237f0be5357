"""The degree theorem: symbolic, against the reading at infinity, and on curves run through projectively."""

import random
import time
from itertools import count

import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from exactspline import BSpline, formula_of
from exactspline.errors import FormulaError, ReachError
from exactspline.language import Vector
from exactspline.language.arguments import Curve
from exactspline.language.kinds import CURVE
from exactspline.language.operand import Parameter
from exactspline.papers import all_formulas, known_as
from exactspline.readings import JetReading
from exactspline.readings.differential_order import is_polynomial, order_of
from exactspline.readings.leading_terms import LeadingTermsReading
from exactspline.symbolic import covariants
from exactspline.symbolic.covariants import TrueDegree, degree_of_product, generic_degree, graded, true_degree
from exactspline.symbolic.substitution import substitute
from tests.support.bisector_oracle import bezier

DIMENSIONS = {"plane": (2,), "space": (3,), "curve": (2, 3)}
POLYNOMIAL = [
    (known_as(f), n) for f in all_formulas().values() for n in DIMENSIONS.get(f.curve, ()) if is_polynomial(f, n)
]


def jets(name, dimension, *, polynomial=False):
    value = formula_of(name)(
        JetReading(order_of(formula_of(name), dimension)).argument(CURVE, dimension, polynomial=polynomial)
    )
    return list(value) if isinstance(value, Vector) else [value]


def at_infinity(name, i, dimension, *, polynomial):
    """Degree and weight of a homogeneous component, and how many of its leading terms vanish at infinity."""

    def leading(terms):
        value = formula_of(name)(LeadingTermsReading(terms).argument(CURVE, dimension, polynomial=polynomial))
        return (value[i] if isinstance(value, Vector) else value).leading

    (((k, m), (drop, _)),) = next(found for terms in count(1) if (found := leading(terms)) is not None).items()
    return k, m, drop


@pytest.mark.parametrize("polynomial", [False, True], ids=["rational", "polynomial"])
@pytest.mark.parametrize(("name", "dimension"), POLYNOMIAL)
def test_two_readings_agree_on_every_polynomial_formula(name, dimension, polynomial):
    """The height against the number of leading terms that vanish at infinity: two algorithms without a line in
    common.
    """
    for i, jet in enumerate(jets(name, dimension, polynomial=polynomial)):
        if jet.is_zero or len(graded(jet)) > 1 or jet.grading[0] == 0:
            continue

        found = true_degree(jet)
        k, m, drop = at_infinity(name, i, dimension, polynomial=polynomial)
        assert (k, m, m - drop) == (found.k, found.m, found.j)


def random_curve(draw_numbers, d, dimension):
    rows = [[draw_numbers() for _ in range(dimension)] for _ in range(d + 1)]
    return Curve(
        Vector(*[BSpline.bezier([row[i] for row in rows]) for i in range(dimension)]),
        BSpline.bezier([draw_numbers() for _ in rows]),
    )


#: Zero on every curve, or of components and summands of different degrees.
OF_NO_GRADING = ("D1_D2_D21", "first_components", "first_components_exchanged", "flat_and_stationary")


@pytest.mark.parametrize(("name", "dimension"), [(name, n) for name, n in POLYNOMIAL if name not in OF_NO_GRADING])
@pytest.mark.parametrize("d", [1, 2, 3, 4])
def test_the_true_degree_is_attained_for_every_small_d_too(name, dimension, d):
    """Exceptions included: where the theorem says −1 the form vanishes, elsewhere a fixed random curve has the degree
    exactly.
    """
    numbers = random.Random(101 * d + dimension)
    curve = random_curve(lambda: numbers.randint(-99, 99), d, dimension)
    value = formula_of(name)(curve)
    components = list(value) if isinstance(value, Vector) else [value]
    generic = jets(name, dimension)
    expected = -1 if all(jet.is_zero for jet in generic) else true_degree(generic).at(d)
    assert max(c.true_degree for c in components) == expected


MOBIUS = st.tuples(*[st.integers(1, 5)] * 2)
COVARIANT = [
    ("D1", 2),
    ("f2", 2),
    ("vertices_lifted", 2),
    ("osculating_circle", 2),
    ("torsion_zeros_lifted", 3),
    ("osculating_sphere", 3),
]
COVARIANT += [("space_critical_curvature_lifted", 3), ("rectifying_generator_lifted", 3), ("circle_sphere", 3)]


def after(change, row):
    """The Bézier points over the parameter that the change (a, b) makes, u ↦ au and v ↦ bv."""
    a, b = change
    return [x * a ** (len(row) - 1 - i) * b**i for i, x in enumerate(row)]


@pytest.mark.parametrize(("name", "dimension"), COVARIANT)
@settings(max_examples=8)
@given(data=st.data())
def test_covariants_follow_a_projective_change_of_parameter(name, dimension, data):
    """The change of parameter u ↦ au, v ↦ bv of [0, 1]: the form of the new curve is (ab)^m times that of the old one,
    moved likewise.
    """
    d = data.draw(st.integers(2, 4))
    a, b = data.draw(MOBIUS)
    numbers = st.integers(-9, 9)
    rows = [data.draw(st.lists(numbers, min_size=d + 1, max_size=d + 1)) for _ in range(dimension + 1)]

    def lowest(points):
        *p, w = [BSpline.bezier(row) for row in points]
        value = formula_of(name)(Curve(Vector(*p), w))
        return list(value) if isinstance(value, Vector) else [value]

    k, m = true_degree(jets(name, dimension)).k, true_degree(jets(name, dimension)).m
    surplus = min(m, k * d - m)
    if k * d - 2 * m < 0:
        assert all(c.is_zero for c in lowest(rows))
        return
    for old, new in zip(lowest(rows), lowest([after((a, b), row) for row in rows]), strict=True):
        plain, changed = old.reduce_degree(surplus).bezier_points[0], new.reduce_degree(surplus).bezier_points[0]
        assert tuple(x * (a * b) ** m for x in after((a, b), plain)) == changed


def test_what_is_no_covariant_does_not():
    d, change = 3, (2, 1)
    row, w = [1, 4, -2, 5], [1, 2, 3, 7]
    D2 = formula_of("D2")

    def lowest(x, w):
        return D2(Curve(Vector(BSpline.bezier(x), BSpline.bezier(x)), BSpline.bezier(w)))[0].reduce_degree(1)

    plain = after(change, lowest(row, w).bezier_points[0])
    changed = lowest(after(change, row), after(change, w)).bezier_points[0]
    assert len(plain) == 2 * d - 2
    assert len({x / y for x, y in zip(plain, changed, strict=True)}) > 1


def test_the_formula_behind_the_proof():
    """(∗) of docs/degree-theorem.md, on polynomials over ℚ: F[f](t) from the LⁿF at 1/t of the reversed curve."""
    from math import factorial

    from exactspline.symbolic.covariants import lowered_at

    d, t = 4, mpq(3, 7)
    F = jets("D2", 2)[0]
    x, w = [2, -1, 5, 3, 8], [1, 4, -2, 6, 5]

    def taylor(coefficients, at):
        """The derivatives at a parameter of a polynomial by its coefficients."""
        return [
            sum(c * factorial(i) // factorial(i - n) * at ** (i - n) for i, c in enumerate(coefficients) if i >= n)
            for n in range(d + 1)
        ]

    def value(polynomial, x, w, at):
        xs, ws = taylor(x, at), taylor(w, at)
        known = {("x", (i,)): xs[i] for i in range(d + 1)} | {("w", (i,)): ws[i] for i in range(d + 1)}
        total = mpq(0)
        for exponents, c in polynomial.terms():
            term = mpq(int(c.p), int(c.q))
            for variable, e in zip(F.ring.variables, exponents, strict=True):
                term *= known.get(variable, 0) ** int(e) if e else 1
            total += term
        return total

    k, m = F.grading
    image, total = F.polynomial, mpq(0)
    for n in range(m + 1):
        total += (-t) ** n / factorial(n) * value(image, x[::-1], w[::-1], 1 / t) if image else 0
        image = lowered_at(F.ring, image, d)
    assert value(F.polynomial, x, w, t) == (-1) ** m * t ** (k * d - 2 * m) * total


def test_heights_add():
    c = JetReading(3).argument(CURVE, 2)
    D2, D3 = formula_of("D2")(c)[0], formula_of("D3")(c)[0]
    assert true_degree(D2 * D3).j == true_degree(D2).j + true_degree(D3).j == 3
    assert true_degree(D2 * formula_of("f2")(c)).j == 1


def test_mixed_gradings_take_the_maximum():
    """x′² + y: true degree max(2d − 2, d), on a curve of each degree."""
    c = JetReading(1).argument(CURVE, 2, polynomial=True)
    mixed = c.p[0].d() ** 2 + c.p[1]
    with pytest.raises(FormulaError, match="gradings"):
        true_degree(mixed)
    assert str(generic_degree([mixed])) == "max(2d − 2, d)"
    numbers = random.Random(7)
    for d in (1, 2, 3, 4):
        points = [(numbers.randint(-99, 99), numbers.randint(-99, 99)) for _ in range(d + 1)]
        value = substitute(mixed, bezier(*points))
        assert value.true_degree == generic_degree([mixed]).at({"d": d})


def test_zero_has_no_degree():
    c = JetReading(1).argument(CURVE, 2)
    with pytest.raises(FormulaError, match="zero polynomial"):
        true_degree(c.w - c.w)


def test_heights_of_products_of_high_derivatives_are_out_of_reach():
    """Before: minutes, and gigabytes, in a loop over polynomials of hundreds of thousands of terms."""
    c = JetReading(8).argument(CURVE, 2)
    jet = (c.w.d(8) * c.p[0].d(8) * c.p[1].d(8)) ** 3
    start = time.process_time()
    with pytest.raises(ReachError, match="the height of a polynomial"):
        true_degree(jet)
    assert time.process_time() - start < 60


def test_a_derivative_of_high_order_has_its_degree():
    """Before: minutes, in substitutions of variables that do not occur."""
    assert str(true_degree(JetReading(100).argument(CURVE, 2).w.d(100)).generic) == "d − 100"


def test_the_degree_of_a_product_is_the_sum_and_lower_where_a_factor_is():
    """1·d at every d but 2, where it is 1; 0 at d = 1."""
    a = TrueDegree(1, 0, 0, ((1, -1), (2, 1)))
    b = TrueDegree(3, 3, 1, ())
    told = degree_of_product([(a, 1), (b, 2)])
    assert (told.k, told.m, told.j) == (7, 6, 2)
    assert told.lower == ((1, -1), (2, 1 + 2 * b.at(2)))
    assert [told.at(d) for d in (1, 2, 3)] == [-1, 1 + 2 * b.at(2), 3 + 2 * b.at(3)]
    assert b.at(5) == 3 * 5 - 6 + 1
    plain = degree_of_product([(b, 1)])
    assert plain == b
    same = TrueDegree(1, 0, 0, ((4, 4),))
    assert degree_of_product([(same, 1)]).lower == ()
    assert degree_of_product([(TrueDegree(1, 1, 0, ((4, 2),)), 1)]).lower == ()


@pytest.mark.parametrize("name", ["f2", "g2", "D1_squared", "vertices_lifted", "D1_D2_D3"])
def test_what_lowers_degrees_is_the_same_for_symbols_and_numbers(name):
    """L = Σ i (d − i + 1) f⁽ⁱ⁻¹⁾ ∂/∂f⁽ⁱ⁾."""
    n = 3 if name == "D1_D2_D3" else 2
    jet = formula_of(name)(JetReading(order_of(formula_of(name), n)).argument(CURVE, n))
    symbolic = covariants.lowered(jet.ring, covariants.with_degree(jet.ring, jet.polynomial), Parameter.FIRST)
    again = covariants.lowered(jet.ring, symbolic, Parameter.FIRST)
    gens = [jet.ring.context.gen(i) for i in range(len(jet.ring.gens))]
    for d in range(1, 9):
        at = lambda p, d=d: p.compose(jet.ring.context.constant(d), *gens, ctx=jet.ring.context)  # noqa: E731
        once = covariants.lowered_at(jet.ring, jet.polynomial, d)
        assert at(symbolic) == once
        assert at(again) == covariants.lowered_at(jet.ring, once, d)


def test_what_lowers_degrees_kills_covariants_and_lowers_one_derivative_at_a_time():
    c = JetReading(2).argument(CURVE, 2)
    x, y = c.p
    d = 7
    assert covariants.lowered_at(x.ring, (x * y.d(1) - x.d(1) * y).polynomial, d) == 0
    assert covariants.lowered_at(x.ring, (d * x * x.d(2) - (d - 1) * x.d(1) * x.d(1)).polynomial, d) == 0
    assert covariants.lowered_at(x.ring, x.d(2).polynomial, d) == (2 * (d - 1) * x.d(1)).polynomial
    assert covariants.lowered_at(x.ring, x.d(1).polynomial, d) == (d * x).polynomial
