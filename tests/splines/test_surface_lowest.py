"""Quotients of splines in two parameters in lowest terms: the same function, and nothing left to cancel, by sympy's
gcd.
"""

from functools import reduce
from itertools import product
from math import comb

import pytest
import sympy
from flint import fmpz_poly
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from exactspline import TensorSpline
from exactspline.errors import ReductionError
from exactspline.language import Rational, Vector
from exactspline.splines.lowest_terms import CONTEXT, as_mpoly, as_packed, surface_in_lowest_terms
from tests.support import oracles
from tests.support.strategies import DOMAINS, numbers, positive_numbers, tensor_splines

S, T = sympy.symbols("s t")


def powers(f, i, j):
    """A patch as a sympy polynomial in the local parameters."""
    (m, n), net = f.degree, f.bezier_net(i, j)
    terms = [
        sympy.Rational(str(b)) * comb(m, h) * S**h * (1 - S) ** (m - h) * comb(n, k) * T**k * (1 - T) ** (n - k)
        for h, row in enumerate(net)
        for k, b in enumerate(row)
    ]
    return sympy.Poly(sum(terms), S, T, domain="QQ")


def assert_lowest(value):
    """Numerator and denominator have no factor in common on any patch, and no lower degrees would do for all of
    them.
    """
    parts = [*(value.numerator if value.is_vector else [value.numerator]), value.denominator]
    assert len({f.degree for f in parts}) == 1
    needed = []
    for i, j in product(*[range(len(mesh)) for mesh in value.denominator.meshes]):
        forms = [powers(f, i, j) for f in parts]
        assert reduce(sympy.Poly.gcd, forms).total_degree() == 0
        needed += [(form.degree(S), form.degree(T)) for form in forms if not form.is_zero]
    assert tuple(value.denominator.degree) == (max(s for s, _ in needed), max(t for _, t in needed))


@st.composite
def quotients(draw):
    """A quotient of small degrees, and a factor to multiply both its parts with; every operand has knots of its own."""
    domains = draw(st.sampled_from(DOMAINS[:3])), draw(st.sampled_from(DOMAINS[:3]))
    numerators = [draw(tensor_splines(domains, high=1, values=numbers())) for _ in range(draw(st.integers(1, 2)))]
    below, factor = (draw(tensor_splines(domains, high=1, values=positive_numbers())) for _ in range(2))
    return numerators, below, factor


@given(quotients())
def test_the_same_function_in_lowest_terms(given_quotient):
    numerators, below, factor = given_quotient
    plain = Rational(Vector(*numerators), below)
    value = Rational(Vector(*[x * factor for x in numerators]), below * factor)
    lowest = surface_in_lowest_terms(value)
    assert lowest == plain
    assert lowest == surface_in_lowest_terms(plain)
    assert lowest.degree == surface_in_lowest_terms(plain).degree
    assert_lowest(lowest)
    for s, t in oracles.surface_places(below):
        assert lowest(s, t) == plain(s, t)
    scalar = surface_in_lowest_terms(Rational(numerators[0] * factor, below * factor))
    assert scalar == Rational(numerators[0], below)
    assert_lowest(scalar)


def test_operands_over_different_meshes_of_as_many_patches():
    f = TensorSpline((0, 0), [0, "1/3", 1], [0, 1], [[1], [2]])
    g = TensorSpline((0, 0), [0, "1/2", 1], [0, 1], [[3], [5]])
    lowest = surface_in_lowest_terms(Rational(f, g))
    assert [lowest(s, 0) for s in ("1/4", "2/5", "3/4")] == [mpq(1, 3), mpq(2, 3), mpq(2, 5)]
    assert lowest == Rational(f, g)


def test_factors_at_the_ends_of_the_patch_and_at_infinity():
    """(1 − s) t cancels, though in z = v/u one of them is a missing degree; a raised degree is lowered."""
    f = TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[0, 1], [0, 0]])
    g = TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[1, 2], [3, 5]])
    lowest = surface_in_lowest_terms(Rational((f * g).elevate_degree(2, 1), (f * (g + 1)).elevate_degree(2, 1)))
    assert lowest.degree == (1, 1)
    assert lowest("1/3", "1/2") == g("1/3", "1/2") / (g("1/3", "1/2") + 1)
    assert_lowest(lowest)


def test_numerator_zero():
    one = TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[1, 2], [3, 5]])
    lowest = surface_in_lowest_terms(Rational(Vector(one - one, one * 0), one))
    assert lowest.degree == (0, 0)
    assert lowest("1/3", "1/2") == (0, 0)


def test_a_denominator_that_vanishes_names_the_patch():
    step = TensorSpline((0, 0), [0, "1/2", 1], [0, 1, 2], [[1, 1], [1, 0]])
    with pytest.raises(ReductionError, match=r"\[1/2, 1\] × \[1, 2\]"):
        surface_in_lowest_terms(Rational(step.constant(1), step))


def test_packed_patches_are_polynomials_in_two_variables():
    c = fmpz_poly([5, 0, 7, 0, -3, 1, 0, 0, 9])
    assert as_packed(as_mpoly(c, 3), 3) == c
    z, y = CONTEXT.gens()
    assert as_mpoly(fmpz_poly([5, 0, 7, 0, -3]), 3) == 5 + 7 * z**2 - 3 * z * y
    assert as_packed(2 * z * y**2 + y, 4) == fmpz_poly([0, 0, 0, 0, 1, 0, 0, 0, 0, 2])
    assert as_packed(z * 0, 4) == 0
