"""Numbers as other libraries and Python take them: without a float on the way."""

import numbers
import re
from decimal import Context, Decimal
from fractions import Fraction
from random import Random

import mpmath
import numpy as np
import pytest
import sympy

import exactspline as xs
from exactspline import Real, square_root
from exactspline.errors import OpenError

QUARTIC = xs.zeros(xs.BSpline.bezier([-1, 0, 1, 2, 5])).roots[0]
LENGTH = xs.example("six_segment_cubic").length


def test_formats_are_those_of_decimals_with_all_digits_correct():
    """A negative number that is rounded to 0 has no sign; with ``g`` as of floats, of at most twelve digits."""
    random = Random(2028)
    for _ in range(1000):
        top, bottom = (random.randint(1, 10 ** random.randint(1, 20)) for _ in range(2))
        x = Fraction(random.choice([-1, 1]) * top, bottom)
        digits, kind = random.randint(0, 12), random.choice("efgEFG%")
        decimal = Context(prec=200).divide(Decimal(x.numerator), Decimal(x.denominator))
        expected = format(decimal, f".{digits}{kind}")
        if kind in "gG":
            expected = re.sub(r"([eE][+-])0(\d)", r"\1\2", format(float(x), f".{digits}{kind}"))
        if not expected.strip("-0.%"):
            expected = expected.removeprefix("-")
        assert format(Real(str(x)), f".{digits}{kind}") == expected, x


def test_a_tie_and_a_number_just_below_a_power_of_ten_are_rounded_exactly():
    assert f"{Real('1/8'):.2f}" == "0.12"
    assert f"{1 - Real(10) ** -40:.30e}" == f"1.{'0' * 30}e+0"
    assert f"{1 - Real(10) ** -40:.39e}" == f"9.{'9' * 39}e-1"
    assert f"{square_root(2):.60f}" == square_root(2).decimal(60)


FORMATS = """
1000 g 1000; 831516000000 .12g 831516000000; 1/100000 g 1e-5; 123456789 G 1.23457E+8; 0 g 0; 0 .5e 0.00000e+0;
1/2 f 0.500000; 1200 e 1.200000e+3; 1/3 *>7.3f **0.333; -5 08.2f -0005.00; 14142 .3 1.41e+4; 1/2000 +.2f +0.00
"""


@pytest.mark.parametrize(("x", "form", "text"), [row.split() for row in FORMATS.split(";")])
def test_formats_by_hand(x, form, text):
    assert format(Real(x), form) == text


@pytest.mark.parametrize("x", [QUARTIC, square_root("2/3"), square_root(2) + square_root(3), Real("22/7"), QUARTIC**2])
def test_sympy_takes_the_number_itself(x):
    """By its minimal polynomial and its place among the zeros; a double before."""
    taken = sympy.sympify(x)
    assert taken.is_algebraic
    assert not taken.has(sympy.Float)
    assert abs(Fraction(str(sympy.N(taken, 60))) / Fraction(x.decimal(70)) - 1) < Fraction(1, 10**50)
    assert (
        sympy.minimal_polynomial(taken, polys=True).all_coeffs()[::-1] == x.minimal_polynomial() or x.exact is not None
    )


def test_what_is_not_known_to_be_algebraic_is_no_float_for_sympy():
    with pytest.raises(OpenError, match="not known to be algebraic"):
        sympy.sympify(LENGTH)


def test_mpmath_takes_a_number_at_its_precision():
    with mpmath.workdps(50):
        assert abs(mpmath.mpf(1) + LENGTH - mpmath.mpf(LENGTH.decimal(60)) - 1) < mpmath.mpf(10) ** -47
        assert abs(mpmath.sin(square_root(2)) - mpmath.sin(mpmath.sqrt(2))) < mpmath.mpf(10) ** -48


def test_decimals_are_exact_numbers_and_what_is_none_is_not_compared():
    half = square_root("1/4")
    assert (half == Decimal("0.5"), half < Decimal("0.6"), half + Decimal("0.1") == Fraction(3, 5)) == (True,) * 3
    assert square_root(2) != Decimal("1.41421356237309504880168872420969807856967")
    assert half != Decimal("NaN")
    with pytest.raises(xs.ExactSplineError, match="is not a number"):
        half < Decimal("inf")  # noqa: B015


def test_a_real_number_is_one_and_no_float():
    assert isinstance(QUARTIC, numbers.Real)
    assert (QUARTIC.real, QUARTIC.imag, QUARTIC.conjugate()) == (QUARTIC, 0, QUARTIC)
    assert divmod(-square_root(2), Fraction(1, 2)) == (-3, Fraction(3, 2) - square_root(2))
    assert (7 // square_root(2), 7 % square_root(2)) == (4, 7 - 4 * square_root(2))
    assert np.array([QUARTIC, LENGTH], float).tolist() == [float(QUARTIC), float(LENGTH)]
    with pytest.raises(xs.ExactSplineError, match="is a root, which need not be rational"):
        xs.rational(QUARTIC)
    assert xs.rational(sympy.Rational(1, 3)) == Fraction(1, 3)
