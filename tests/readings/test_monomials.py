"""The monomial reading against the generic Bézier segments of single degrees."""

from dataclasses import replace
from functools import reduce
from math import comb

import pytest
from flint import fmpq

from exactspline import claims, formula_of
from exactspline.errors import FormulaError
from exactspline.language.kinds import CURVE
from exactspline.readings.bernstein_term import BernsteinTermReading, GenericReading, every_coefficient


@pytest.mark.parametrize("degree", [1, 2, 3, 5])
@pytest.mark.parametrize("name", ["D1", "D2", "D21"])
def test_the_coefficients_are_those_of_every_single_degree(name, degree):
    """Term by term: what the symbolic monomials give at d, a, b is the coefficient of the product of control point a
    and weight b.
    """
    symbolic = formula_of(name)(BernsteinTermReading().argument(CURVE, 2))[0]
    concrete = formula_of(name)(GenericReading(degree).argument(CURVE, 2))[0]
    expected = [{} for _ in concrete.coefficients]
    for a in range(degree + 1):
        for b in range(degree + 1):
            for (_, j), c in symbolic.terms.items():
                number = c.compose(*[c.context().constant(x) for x in (degree, a, b)], ctx=c.context())
                if number != 0:
                    row = expected[a + b - j]
                    row[a, b] = row.get((a, b), 0) + fmpq(number.leading_coefficient()) * comb(degree, a) * comb(
                        degree, b
                    )
    for row, polynomial in zip(expected, concrete.coefficients, strict=True):
        found = {}
        for exponents, c in polynomial.terms():
            e = [int(x) for x in exponents]
            found[e[: degree + 1].index(1), e[2 * (degree + 1) :].index(1)] = c
        assert found == row


def test_every_coefficient_of_d1_is_proved_and_of_others_computed():
    chosen = next(c for c in claims("C3f") if c.curves == "generic")
    reading, finding = chosen.prove()
    assert (reading, finding.verdict) == ("generic", "PROVED")
    assert "d ≥ 1" in str(finding.computed)
    told = replace(chosen, formula="D2").prove()[1]
    assert (told.verdict, told.reason) == ("UNDECIDED", "tried on a part")  # for d = 2…6


def test_what_is_not_of_that_kind_is_not_proved():
    """w′p has p_(k+1) w_k with the factor k, zero for k = 0; (w p)′ with a polynomial in d; D2 has three terms; nothing
    comes of p alone.
    """
    c = BernsteinTermReading().argument(CURVE, 2)
    for value in (c.p * c.w.d(1), (c.p * c.w).d(1), formula_of("D2")(c), c.p.d(1), c.w.d(1), c.p - c.p):
        assert every_coefficient(value) is None


def test_terms_of_different_degree_are_not_added():
    c = BernsteinTermReading().argument(CURVE, 2)
    with pytest.raises(FormulaError, match="different degree"):
        c.p[0] + c.w


@pytest.mark.parametrize("order", range(6))
def test_derivatives_of_a_term_are_those_of_its_powers(order):
    """``(∂v − ∂u)ᵏ u^U v^V`` by the binomial theorem, with falling factorials of U = d − a and V = a."""
    p = BernsteinTermReading().argument(CURVE, 2).p[0]
    d, a, _ = p.exponents[0].context().gens()

    def falling(x, k):
        return reduce(lambda product, i: product * (x - i), range(k), d * 0 + 1)

    expected = {
        (i, order - i): (-1) ** i * comb(order, i) * falling(d - a, i) * falling(a, order - i) for i in range(order + 1)
    }
    assert p.d(order).terms == expected
    assert p.d(order).exponents == (d - a, a)
    assert (p.d(order) - p.d(order)).is_zero


def test_the_denominator_of_a_polynomial_curve_is_one():
    c = BernsteinTermReading().argument(CURVE, 2, polynomial=True)
    assert c.w.terms == {(0, 0): 1}
    assert c.w.exponents == (0, 0)
    assert (c.p[0] * c.w).terms == c.p[0].terms == {(0, 0): 1}
    assert c.w.d(1).is_zero
