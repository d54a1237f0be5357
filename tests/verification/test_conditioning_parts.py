"""The parts of condition numbers and of the experiment in doubles, each on small cases with known answers."""

from math import nextafter

import pytest
from flint import fmpz_poly
from gmpy2 import mpq

from exactspline import BSpline, zeros
from exactspline.interchange.examples import example
from exactspline.polynomials.bernstein import from_bezier
from exactspline.verification.conditioning import compare, double_precision
from exactspline.verification.conditioning.compare import Conditioning, FormAtRoot, RootConditions
from exactspline.verification.conditioning.condition_number import condition_number, local, quotient
from exactspline.verification.conditioning.double_precision import Double, double_precision_root
from exactspline.verification.conditioning.search import Tally

T = BSpline.identity(0, 1)


def conditions(condition, other, growth=None, one_sign=True, doubles=(None, None)):
    forms = [
        FormAtRoot("naive", 6, 1, other, growth, one_sign, doubles[1]),
        FormAtRoot("minimal", 3, 1, condition, None, False, doubles[0]),
    ]
    return RootConditions(zeros(T - mpq(1, 2))[0], tuple(forms))


def test_condition_numbers_compare_as_intervals():
    one, two = (mpq(1), mpq(2)), (mpq(3), mpq(4))
    assert (conditions(two, one).compare("naive"), conditions(one, two).compare("naive")) == (1, -1)
    assert conditions(one, (mpq(2), mpq(3))).compare("naive") == 0
    assert conditions((mpq(2), mpq(3)), one).compare("naive") == 0
    assert conditions(one, two).ratio("naive") == mpq(3, 7)


def test_verdicts_count_zeros_and_say_where_the_theorem_speaks():
    unit = (mpq(1), mpq(1))
    rows = (conditions((mpq(5), mpq(5)), unit), conditions(unit, (mpq(5), mpq(5))), conditions(unit, unit))
    told = Conditioning("c", "zero_curvature", rows, {}, ()).verdicts
    assert told == {"naive": "the reduced form is worse conditioned at 1 of 3 zeros, better at 1"}
    rows = (conditions((mpq(5), mpq(5)), unit, growth=unit), conditions(unit, unit, growth=unit, one_sign=False))
    told = Conditioning("c", "zero_curvature", rows[:1], {}, ()).verdicts["naive"]
    assert told == (
        "the reduced form is worse conditioned at 1 of 1 zero, better at 0; by the theorem it cannot be better at 1"
    )
    assert "theorem" not in Conditioning("c", "zero_curvature", rows[1:], {}, ()).verdicts["naive"]


def test_a_tally_counts_what_it_is_given():
    unit, five = (mpq(1), mpq(1)), (mpq(5), mpq(5))
    tally = Tally("f", "zero_curvature", "naive")
    first, second, third = (example(n) for n in ("circle", "ellipse", "parabola"))
    units = lambda n: Double(n * mpq(1, 2**53))  # noqa: E731
    tally.add(conditions(five, unit, doubles=(units(4), units(1))), first)
    tally.add(conditions(unit, five, growth=unit, doubles=(units(1), units(mpq(5, 2)))), second)
    tally.add(conditions(unit, unit, doubles=(Double(None), units(9))), third)
    tally.add(conditions(unit, unit, doubles=(units(2), Double(None))), third)
    tally.add(conditions(unit, unit, doubles=(units(2), units(1))), third)
    tally.add(conditions(unit, unit, doubles=(units(1), units(2))), third)
    assert (tally.worse, tally.better, tally.equal) == (1, 1, 4)
    assert (tally.proved, tally.contradicted) == (1, 1)
    assert tally.largest == (5, first)
    assert tally.smallest == (mpq(1, 5), second)
    assert (tally.double_worse, tally.double_better) == (2, 2)
    # of equal ratios the first curve stays
    tally.add(conditions(five, unit), third)
    tally.add(conditions(unit, five), third)
    assert (tally.largest, tally.smallest) == ((5, first), (mpq(1, 5), second))
    assert (tally.worse, tally.better, tally.equal, tally.proved) == (2, 2, 4, 1)


def test_a_bracket_reaches_halfway_to_the_next_zeros_and_ends():
    f = BSpline.bezier([-1, 5]) * BSpline.bezier([-1, 1]) * BSpline.bezier([-3, 1])  # zeros at 1/6, 1/2, 3/4
    middle = next(r for r in zeros(f) if r == mpq(1, 2))
    low, high = compare.bracket(f.forms[0], f.degree, middle, zeros(f))
    assert abs(low - mpq(1, 3)) < mpq(1, 10**20)
    assert abs(high - mpq(5, 8)) < mpq(1, 10**20)
    first = next(r for r in zeros(f) if r == mpq(1, 6))
    assert compare.bracket(f.forms[0], f.degree, first, zeros(f))[0] == 0
    on_two = BSpline(1, [0, 0, 3, 5, 5], [-1, -1, 1])
    (only,) = zeros(on_two)
    assert compare.segment_with(on_two, only) == 1
    assert compare.bracket(on_two.forms[1], 1, only, zeros(on_two)) == (0, 1)
    ended = BSpline.bezier([0, -1, 2])  # a zero at the start and one inside
    inner = next(r for r in zeros(ended) if not r.at_knot)
    x = local(inner)[0]
    assert compare.bracket(ended.forms[0], 2, inner, zeros(ended)) == (x / 2, 1)


def test_double_precision_finds_what_doubles_can_hold():
    exact = double_precision_root(from_bezier([mpq(-1), mpq(1)]), 1, mpq(1, 2), (mpq(0), mpq(1)))
    assert (exact.error, exact.units, exact.reason) == (0, 0, "")
    none = double_precision_root(from_bezier([mpq(1), mpq(1)]), 1, mpq(1, 2), (mpq(0), mpq(1)))
    assert (none.error, none.units, none.reason) == (None, None, "no change of sign in doubles")
    wide = double_precision_root(from_bezier([mpq(-1), mpq(1, 10**650)]), 1, mpq(1, 2), (mpq(0), mpq(1)))
    assert wide.reason == "the coefficients span more than the range of doubles"
    third = double_precision_root(from_bezier([mpq(-1), mpq(2)]), 1, mpq(1, 3), (mpq(0), mpq(1)))
    assert 0 < third.error == abs(mpq(*(1 / 3).as_integer_ratio()) - mpq(1, 3))
    assert third.units == third.error * 2**53


@pytest.mark.parametrize("k", range(8, 60, 3))
def test_the_condition_number_of_an_irrational_zero_is_enclosed(k):
    """(1 − t)² − c at 1 − √c: Σ |bᵢ| Bᵢ = 2c(1 − c) over the slope 2√c; C² = c(1 − c)²."""
    c = mpq(2, 100**k)
    f = BSpline.bezier([1 - c, -c, -c])
    (root,) = zeros(f)
    low, high = condition_number(f.forms[0], 2, root, 1)
    assert low**2 <= c * (1 - c) ** 2 <= high**2
    assert 0 < high - low <= mpq(1, 10**10) * low


@pytest.mark.parametrize(
    ("first", "last", "found"),
    [(1, -1, 0.5), (-1, 3, 0.25), (3, -1, 0.75), (1, -3, 0.25), (-3, 1, 0.75), (-0.5, 1.5, 0.25), (0.5, -1.5, 0.25)],
)
def test_bisection_ends_where_the_value_is_zero(first, last, found):
    assert double_precision.bisected([first, last], 0.0, 1.0) == found


@pytest.mark.parametrize(("first", "last"), [(0, 1), (0, -1), (1, 0), (-1, 0), (1, 1), (-1, -1), (0, 0)])
def test_bisection_needs_two_signs(first, last):
    assert double_precision.bisected([first, last], 0.0, 1.0) is None


def test_bisection_ends_between_neighbouring_doubles():
    low = double_precision.bisected([-1, 2], 0.0, 1.0)
    assert mpq(low) <= mpq(1, 3) <= mpq(nextafter(low, 1))


def test_a_bracket_ends_with_its_segment():
    """Zeros at 1/10 of the first segment and 1/5 of the second."""
    f = BSpline(1, [0, 0, 1, 2, 2], [-1, 9, -36])
    first, second = zeros(f)
    assert compare.bracket(f.forms[0], 1, first, zeros(f)) == (0, 1)
    assert compare.bracket(f.forms[1], 1, second, zeros(f)) == (0, 1)


def test_a_bracket_is_one_of_the_local_parameter():
    """Zeros at 1/6, 1/2, 3/4 of the segment [3, 7]."""
    f = BSpline(
        3,
        [3] * 4 + [7] * 4,
        (BSpline.bezier([-1, 5]) * BSpline.bezier([-1, 1]) * BSpline.bezier([-3, 1])).control_points,
    )
    low, high = compare.bracket(f.forms[0], 3, zeros(f)[1], zeros(f))
    assert abs(low - mpq(1, 3)) < mpq(1, 10**20)
    assert abs(high - mpq(5, 8)) < mpq(1, 10**20)


def test_points_are_scaled_to_the_range_of_doubles():
    points = [mpq(1, 3) * mpq(2) ** 1500, mpq(-1, 7) * mpq(2) ** 1490]
    told = double_precision.to_doubles(points)
    assert 2.0**998 <= max(map(abs, told)) <= 2.0**1002
    assert told[0] / told[1] == pytest.approx(-7 * 1024 / 3, rel=1e-15)
    assert double_precision.to_doubles([mpq(0), mpq(1)]) == [0, double_precision.to_doubles([mpq(1)])[0]]
    assert double_precision.to_doubles([mpq(1), mpq(1, 2**2100)]) is None


def test_quotients_of_forms_are_forms_of_the_difference_of_degrees():
    """As forms t² over 1 − t is none, although z²/1 is a polynomial; t(1 − t) over 1 − t is t."""
    one = from_bezier([mpq(1)])[1]
    form = lambda *c: (fmpz_poly(list(c)), one)  # noqa: E731
    assert quotient(form(0, 0, 1), 2, form(1), 1) is None
    assert quotient(form(0, 1), 2, form(1), 1)[0] == fmpz_poly([0, 1])
    assert quotient(form(-1, 0, 1), 2, form(-1, 1), 1)[0] == fmpz_poly([1, 1])
    assert quotient(form(-2, 0, 2), 2, form(-3, 3), 1)[0] == fmpz_poly([1, 1])
    assert quotient(form(1, 0, 1), 2, form(-1, 1), 1) is None
    assert quotient(form(1, 1), 1, form(-1, 0, 1), 2) is None
    assert quotient(form(), 1, form(1), 1) is None
    assert quotient(form(1), 1, form(), 1) is None
