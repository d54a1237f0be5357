"""O1: condition numbers against their definition, the theorem as a property, the witnesses either way, and what double
precision does.
"""

import json
from functools import cache
from math import nextafter

import mpmath
import pytest
from flint import fmpz_poly
from gmpy2 import mpq
from hypothesis import assume, given
from hypothesis import strategies as st

from exactspline import BSpline, example, zeros
from exactspline.errors import FormulaError, ShapeError
from exactspline.interchange import text
from exactspline.polynomials.bernstein import from_bezier
from exactspline.tables import construction
from exactspline.verification.conditioning import (
    WIDTH,
    Conditioning,
    Double,
    FormAtRoot,
    RootConditions,
    bisected,
    bracket,
    condition_number,
    conditioning,
    double_precision_root,
    local,
    quotient,
    segment_with,
    to_doubles,
)
from tests.campaigns.conditioning import Tally, search_witnesses
from tests.support.command import invoke

small = st.integers(-9, 9)


def by_definition(points, x, m):
    """``m! Σ|b_i|B_i(x)/|p⁽ᵐ⁾(x)|`` with splines and nothing of the room under test."""
    p = BSpline.bezier(points)
    slope = p.d(m)(x) if m else p(x)
    return mpq(int(mpmath.factorial(m))) * BSpline.bezier(map(abs, points))(x) / abs(slope)


@st.composite
def with_rational_zero(draw):
    """A polynomial with a simple zero at a rational place inside the segment: its Bézier points, the zero."""
    x = mpq(draw(st.integers(1, 11)), 12)
    rest = draw(st.lists(small, min_size=1, max_size=5))
    f = BSpline.bezier([-x, 1 - x]) * BSpline.bezier(rest)
    assume(BSpline.bezier(rest)(x) != 0)
    return f, x


def zero_at(f, x):
    """The certified zero there, known to be rational."""
    root = next(r for r in zeros(f) if r == x)
    root.minimal_polynomial()
    return root


def condition(f, root, m=1):
    return condition_number(f.forms[0], f.degree, root, m)


@given(with_rational_zero())
def test_a_simple_rational_zero_has_an_exact_condition_number(case):
    f, x = case
    assert condition(f, zero_at(f, x)) == (by_definition(f.control_points, x, 1),) * 2


@given(with_rational_zero(), st.lists(st.integers(0, 9), min_size=1, max_size=5))
def test_a_factor_of_one_sign_never_makes_it_worse(case, weights):
    (f, x), w = case, BSpline.bezier(weights)
    assume(any(weights) and w(x) != 0)
    root = zero_at(f, x)
    ours, theirs = condition(f * w, root)[0], condition(f, root)[0]
    assert ours <= theirs
    b = f.control_points
    near = any(b[i] * b[j] < 0 for i in range(len(b)) for j in range(i + 1, min(len(b), i + len(weights))))
    if all(weights) and near:
        assert ours < theirs


@given(with_rational_zero(), st.lists(small, min_size=1, max_size=5))
def test_any_factor_makes_it_worse_by_its_own_condition_at_most(case, factor):
    (f, x), w = case, BSpline.bezier(factor)
    assume(w(x) != 0)
    root = zero_at(f, x)
    growth = condition_number(w.forms[0], w.degree, root, 0)
    assert growth == (by_definition(factor, x, 0),) * 2
    assert growth[0] >= 1
    assert condition(f * w, root)[0] <= growth[0] * condition(f, root)[0]


def test_a_factor_with_two_signs_can_make_it_worse():
    f, w = BSpline.bezier([-1, 1]), BSpline.bezier([1, "-9/10", 1])
    root = zero_at(f, mpq(1, 2))
    assert condition(f * w, root)[0] > 5 * condition(f, root)[0]


@pytest.mark.parametrize("m", [1, 2, 3])
def test_it_is_how_far_the_worst_change_of_the_coefficients_moves_a_zero(m):
    """Coefficients changed by ε each in the worst direction: the zero of multiplicity m moves by C ε^(1/m)."""
    base = BSpline.bezier(["-1/3", "2/3"])
    f = base
    for _ in range(m - 1):
        f = f * base
    f = f * BSpline.bezier([2, 1, 3])
    epsilon = mpq(1, 10 ** (9 * m))
    sign = -1 if f.d(m)("1/3") > 0 else 1
    moved = f + BSpline.bezier([sign * epsilon * abs(b) for b in f.control_points])
    root = next(r for r in zeros(f) if r == mpq(1, 3))
    low, high = condition(f, root, m)
    distance = min(abs(r.refine(30)[0] - mpq(1, 3)) for r in zeros(moved) if r > mpq(1, 3))
    assert low * mpq(999, 1000) < distance * 10**9 < high * mpq(1001, 1000)


@pytest.mark.parametrize(("points", "m"), [([1, -2, "3/7", 1], 1), ([5, -3, 1, 1, -2], 1), ([2, 1, -3], 1)])
def test_enclosures_hold_the_number_and_are_close(points, m):
    f = BSpline.bezier(points)
    for root in zeros(f):
        low, high = condition(f, root, m)
        assert 0 < low < high <= low * (1 + WIDTH)
        with mpmath.workdps(50):
            x, n = root.mpf(45), f.degree
            b = [mpmath.mpf(int(y.numerator)) / int(y.denominator) for y in f.control_points]
            basis = [mpmath.binomial(n, i) * x**i * (1 - x) ** (n - i) for i in range(n + 1)]
            slope = n * sum(
                (b[i + 1] - b[i]) * mpmath.binomial(n - 1, i) * x**i * (1 - x) ** (n - 1 - i) for i in range(n)
            )
            expected = sum(abs(y) * z for y, z in zip(b, basis, strict=True)) / abs(slope)
            assert (
                mpmath.mpf(int(low.numerator)) / int(low.denominator)
                < expected
                < mpmath.mpf(int(high.numerator)) / int(high.denominator)
            )


def test_a_double_irrational_zero():
    g = BSpline.bezier([1, -1, "-1/2"])
    f = g * g
    (root,) = [r for r in zeros(f) if not r.at_knot]
    low, high = condition(f, root, 2)
    x = root.refine(40)[0]
    assert low**2 * (1 - WIDTH) < by_definition(f.control_points, x, 2) < high**2 * (1 + WIDTH)
    assert high - low <= WIDTH * low


@pytest.mark.parametrize("name", ["rational_cubic_s", "rational_quartic", "hyperbola"])
def test_what_the_reductions_leave_out(name):
    """f0 = w³ (u + v)³ f2 and g0 = w¹⁷ (u + v)⁶ g2 as naive numerators, with the degrees they have."""
    curve = example(name)
    for construction_name, naive, power, raised in (
        ("zero_curvature", "naive", 3, 3),
        ("critical_curvature", "direct", 17, 6),
    ):
        made = construction(construction_name)
        f, reduced = made.on(curve, naive), made.on(curve, "paper")
        assert f == curve.w**power * reduced
        assert f.degree == power * curve.degree + raised + reduced.degree


# ---- the witnesses


@cache
def compared(name, construction="critical_curvature"):
    return conditioning(example(name), construction)


def at_third(name):
    return next(row for row in compared(name).roots if row.root.exact == mpq(1, 3))


def test_the_reduced_form_is_worse_on_one_example_exactly():
    row = at_third("conditioning_reduced_worse")
    assert all(weight > 0 for weight in example("conditioning_reduced_worse").weights)
    exact = {f.form: f.condition[0] for f in row.forms}
    assert all(f.condition[0] == f.condition[1] and f.one_sign for f in row.forms)
    assert exact["squaring"] < exact["direct"] < exact["paper"] < exact["minimal"]
    assert 12 * exact["direct"] < exact["minimal"] < 13 * exact["direct"]
    assert row["minimal"].double.error > 4 * row["direct"].double.error > 4 * row["squaring"].double.error


def test_the_reduced_form_is_better_on_the_other_exactly():
    curve, row = example("conditioning_reduced_better"), at_third("conditioning_reduced_better")
    assert curve.w("1/3") == mpq(2, 225)
    exact = {f.form: f.condition[0] for f in row.forms}
    assert all(f.condition[0] == f.condition[1] for f in row.forms)
    assert exact["minimal"] == mpq(299, 9) < exact["paper"] < exact["direct"] < exact["squaring"]
    assert exact["direct"] > 10**36 * exact["minimal"]
    assert row["direct"].double.error is None
    assert 25 * row["minimal"].double.error < row["paper"].double.error


@pytest.mark.parametrize(
    "name", ["conditioning_reduced_worse", "conditioning_reduced_better", "rational_cubic_s", "ellipse_skew"]
)
def test_no_form_exceeds_the_bound_of_the_theorem(name):
    for row in compared(name).roots:
        for f in row.forms:
            assert f.condition[0] <= f.growth[1] * row["minimal"].condition[1]
            assert not (f.one_sign and row.compare(f.form) < 0)
        assert row.compare("minimal") == 0


def test_fig_2_has_no_better_condition():
    assert not compared("ellipse").roots
    assert len(compared("ellipse").skipped) == 5
    for row in compared("ellipse_skew").roots:
        assert all(row.compare(form) == 1 for form in ("direct", "squaring", "paper"))


def test_invented_zeros_and_stretches_are_told_and_not_compared():
    found = compared("rational_cubic_s")
    assert len(found.roots) == 2
    assert list(found.extraneous) == ["squaring"]
    (inflection,) = zeros(example_inflections())
    assert found.extraneous["squaring"] == (inflection,)
    assert compared("circle").skipped == ("[0, 4], where the form vanishes identically",)
    assert not compared("circle").verdicts


def example_inflections():
    from exactspline.papers import find

    return find("f2")(example("rational_cubic_s"))


def told(tally):
    return {
        **vars(tally),
        "smallest": json.loads(text(tally.smallest[1])),
        "largest": json.loads(text(tally.largest[1])),
    }


def test_the_search_repeats_itself_and_the_theorem_holds():
    found = search_witnesses(seed=2, count=2)
    assert list(map(told, found)) == list(map(told, search_witnesses(seed=2, count=2)))
    assert sum(t.proved for t in found) > 8
    assert not any(t.contradicted for t in found)
    assert not any(t.better for t in found if t.family != "a denominator near zero" and t.form != "squaring")
    assert any(t.better for t in found if t.family == "a denominator near zero" and t.form == "direct")
    with pytest.raises(ShapeError):
        search_witnesses(count=-1)


def test_what_has_no_zero_set_is_refused():
    with pytest.raises(FormulaError, match="not a zero set"):
        conditioning(example("ellipse"), "evolute")
    with pytest.raises(ShapeError, match="in the plane"):
        conditioning(example("twisted_cubic"))


# ---- double precision


@given(with_rational_zero())
def test_the_error_of_doubles_stays_below_its_bound(case):
    """``(2n + 2) C`` rounding units to first order, two more for the place itself."""
    f, x = case
    root = zero_at(f, x)
    c = condition(f, root)[0]
    others = [r.refine(30)[0] for r in zeros(f) if r != root]
    gap = min([x, 1 - x, *[abs(r - x) for r in others]]) / 2
    found = double_precision_root(f.forms[0], f.degree, x, (x - gap, x + gap))
    assert found.units <= (4 * f.degree + 4) * c + 2


def test_no_zero_is_found_where_the_signs_drown():
    w = BSpline.bezier([1, "-999999/1000000", 1])
    f = BSpline.bezier(["-1/3", "2/3"]) * w.reparametrize(0, 1) ** 6
    found = double_precision_root(
        f.forms[0], f.degree, mpq(1, 3), (mpq(1, 3) - mpq(1, 10**17), mpq(1, 3) + mpq(1, 10**17))
    )
    assert found.error is None
    assert found.reason == "no change of sign in doubles"


# ---- the command


def run(*arguments):
    return invoke("formula", "conditioning", *arguments)


def test_the_command_shows_both_witnesses():
    done = run()
    assert done.exit_code == 0
    assert "paper: the reduced form is worse conditioned at 3 of 3 zeros, better at 0" in done.stdout
    assert "paper: the reduced form is worse conditioned at 0 of 3 zeros, better at 3" in done.stdout


def test_the_command_writes_json():
    done = run("rational_cubic_s", "--construction", "zero_curvature", "--json")
    data = json.loads(done.stdout)
    (zero,) = data["rows"][0]["data"]["zeros"]
    assert [f["form"] for f in zero["forms"]] == ["naive", "paper", "minimal"]
    assert all(mpq(a) <= mpq(b) for a, b in (f["condition"] for f in zero["forms"]))


def test_the_command_reports_a_missing_curve():
    assert run("no_such_curve").exit_code == 2


# ---- small cases with known answers


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
    low, high = bracket(f.forms[0], f.degree, middle, zeros(f))
    assert abs(low - mpq(1, 3)) < mpq(1, 10**20)
    assert abs(high - mpq(5, 8)) < mpq(1, 10**20)
    first = next(r for r in zeros(f) if r == mpq(1, 6))
    assert bracket(f.forms[0], f.degree, first, zeros(f))[0] == 0
    on_two = BSpline(1, [0, 0, 3, 5, 5], [-1, -1, 1])
    (only,) = zeros(on_two)
    assert segment_with(on_two, only) == 1
    assert bracket(on_two.forms[1], 1, only, zeros(on_two)) == (0, 1)
    ended = BSpline.bezier([0, -1, 2])  # a zero at the start and one inside
    inner = next(r for r in zeros(ended) if not r.at_knot)
    x = local(inner)[0]
    assert bracket(ended.forms[0], 2, inner, zeros(ended)) == (x / 2, 1)


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
    assert bisected([first, last], 0.0, 1.0) == found


@pytest.mark.parametrize(("first", "last"), [(0, 1), (0, -1), (1, 0), (-1, 0), (1, 1), (-1, -1), (0, 0)])
def test_bisection_needs_two_signs(first, last):
    assert bisected([first, last], 0.0, 1.0) is None


def test_bisection_ends_between_neighbouring_doubles():
    low = bisected([-1, 2], 0.0, 1.0)
    assert mpq(low) <= mpq(1, 3) <= mpq(nextafter(low, 1))


def test_a_bracket_ends_with_its_segment():
    """Zeros at 1/10 of the first segment and 1/5 of the second."""
    f = BSpline(1, [0, 0, 1, 2, 2], [-1, 9, -36])
    first, second = zeros(f)
    assert bracket(f.forms[0], 1, first, zeros(f)) == (0, 1)
    assert bracket(f.forms[1], 1, second, zeros(f)) == (0, 1)


def test_a_bracket_is_one_of_the_local_parameter():
    """Zeros at 1/6, 1/2, 3/4 of the segment [3, 7]."""
    f = BSpline(
        3,
        [3] * 4 + [7] * 4,
        (BSpline.bezier([-1, 5]) * BSpline.bezier([-1, 1]) * BSpline.bezier([-3, 1])).control_points,
    )
    low, high = bracket(f.forms[0], 3, zeros(f)[1], zeros(f))
    assert abs(low - mpq(1, 3)) < mpq(1, 10**20)
    assert abs(high - mpq(5, 8)) < mpq(1, 10**20)


def test_points_are_scaled_to_the_range_of_doubles():
    points = [mpq(1, 3) * mpq(2) ** 1500, mpq(-1, 7) * mpq(2) ** 1490]
    told = to_doubles(points)
    assert 2.0**998 <= max(map(abs, told)) <= 2.0**1002
    assert told[0] / told[1] == pytest.approx(-7 * 1024 / 3, rel=1e-15)
    assert to_doubles([mpq(0), mpq(1)]) == [0, to_doubles([mpq(1)])[0]]
    assert to_doubles([mpq(1), mpq(1, 2**2100)]) is None


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
