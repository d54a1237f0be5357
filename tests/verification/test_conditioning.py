"""O1: condition numbers against their definition, the theorem as a property, the witnesses either way, and what double
precision does.
"""

import json
from functools import cache

import mpmath
import pytest
from click.testing import CliRunner
from flint import fmpz_poly
from gmpy2 import mpq
from hypothesis import assume, given
from hypothesis import strategies as st

from exactspline import BSpline
from exactspline.cli import app
from exactspline.errors import FormulaError, ShapeError
from exactspline.geometry.constructions import construction
from exactspline.interchange.curve_files import curve_data
from exactspline.interchange.examples import example
from exactspline.polynomials.bernstein import ONE, bezier, from_bezier
from exactspline.roots.zero_set import zeros
from exactspline.verification.conditioning.compare import conditioning
from exactspline.verification.conditioning.condition_number import WIDTH, condition_number, quotient
from exactspline.verification.conditioning.double_precision import double_precision_root
from exactspline.verification.conditioning.search import search_witnesses

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


def test_the_quotient_of_forms():
    assert quotient(from_bezier([mpq(1), mpq(0), mpq(-1)]), 2, from_bezier([mpq(2), mpq(-2)]), 1) == (
        fmpz_poly([1, 1]),
        ONE,
    )
    assert quotient(from_bezier([mpq(1), mpq(1)]), 1, from_bezier([mpq(1), mpq(-2)]), 1) is None
    assert quotient(from_bezier([mpq(1)]), 0, from_bezier([mpq(1), mpq(1)]), 1) is None


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
    assert len(compared("ellipse").left_out) == 5
    for row in compared("ellipse_skew").roots:
        assert all(row.compare(form) == 1 for form in ("direct", "squaring", "paper"))


def test_invented_zeros_and_stretches_are_told_and_not_compared():
    found = compared("rational_cubic_s")
    assert len(found.roots) == 2
    assert list(found.extraneous) == ["squaring"]
    (inflection,) = zeros(example_inflections())
    assert found.extraneous["squaring"] == (inflection,)
    assert compared("circle").left_out == ("[0, 4], where the form vanishes identically",)
    assert not compared("circle").verdicts


def example_inflections():
    from exactspline.papers import find

    return find("f2")(example("rational_cubic_s"))


def told(tally):
    return {**vars(tally), "smallest": curve_data(tally.smallest[1]), "largest": curve_data(tally.largest[1])}


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


def test_coefficients_beyond_the_range_of_doubles_are_told():
    found = double_precision_root(from_bezier([mpq(-1), mpq(1, 10**700)]), 1, mpq(1), (mpq(0), mpq(1)))
    assert found.error is None
    assert "range" in found.reason
    huge = from_bezier([mpq(-(10**400)), mpq(2 * 10**400)])
    assert double_precision_root(huge, 1, mpq(1, 3), (mpq(0), mpq(1))).units <= 1
    assert bezier(huge, 1)[0] == -(10**400)


# ---- the command


def run(*arguments):
    return CliRunner().invoke(app, ["formula", "conditioning", *arguments])


def test_the_command_shows_both_witnesses():
    done = run()
    assert done.exit_code == 0
    assert "paper: the reduced form is worse conditioned at 3 of 3 zeros, better at 0" in done.stdout
    assert "paper: the reduced form is worse conditioned at 0 of 3 zeros, better at 3" in done.stdout


def test_the_command_writes_json():
    done = run("rational_cubic_s", "--construction", "zero_curvature", "--search", "1", "--seed", "3", "--json")
    data = json.loads(done.stdout)
    told = {what: [row["data"] for row in data["rows"] if row["what"] == what] for what in ("curve", "search")}
    (zero,) = told["curve"][0]["zeros"]
    assert [f["form"] for f in zero["forms"]] == ["naive", "paper", "minimal"]
    assert all(mpq(a) <= mpq(b) for a, b in (f["condition"] for f in zero["forms"]))
    assert {t["family"] for t in told["search"]} <= {
        "positive weights",
        "a weight near zero",
        "a denominator near zero",
    }


def test_the_command_reports_a_missing_curve():
    assert run("no_such_curve").exit_code == 2
