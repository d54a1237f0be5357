"""The parts that verdicts are made of, each held against what it means on small cases with known answers."""

import re

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from exactspline import BSpline, Nurbs, zeros
from exactspline.language.kinds import PAIR, PLANE_POINT, POINT_IN_SPACE
from exactspline.language.vector import Vector
from exactspline.papers import all_formulas, find, known_as
from exactspline.splines.bernstein import from_bezier
from exactspline.splines.examples import example
from exactspline.symbolic.covariants import degree_at
from exactspline.symbolic.reduction import reduce, reduction
from exactspline.verification.check_arguments import beginning, moved_copy, pair_with, point_beside
from exactspline.verification.claims import all_claims, matches, select
from exactspline.verification.conditioning import compare
from exactspline.verification.conditioning.compare import Conditioning, FormAtRoot, RootConditions, conditioning
from exactspline.verification.conditioning.condition_number import condition_number, local
from exactspline.verification.conditioning.double_precision import Double, double_precision_root
from exactspline.verification.conditioning.search import Tally
from exactspline.verification.curve_check import extra_zero, where_it_differs
from exactspline.verification.degree_tables import _bisected, construction_table, formula_table
from exactspline.verification.errata import errata, name_of, numbered, remarks
from exactspline.verification.evaluation import Evaluation, between, zero_of
from exactspline.verification.generic_degree import joined_degree
from exactspline.verification.generic_proof import degree_table
from exactspline.verification.ledger import Proofs, checked, proved
from exactspline.verification.measure import measurable, measure
from exactspline.verification.notation import degree_latex, factor_latex
from exactspline.verification.statement import sides
from exactspline.verification.verdict import REFUTED, UNDECIDED, VACUOUS, VERIFIED, Finding

T = BSpline.identity(0, 1)


def claim(key):
    (found,) = select([key])
    return found


# ---- what is said on one curve


@pytest.mark.parametrize("name", ["rational_cubic", "cusp", "twisted_cubic"])
@pytest.mark.parametrize("one", [c for c in all_claims() if c.curve != "table"], ids=lambda c: c.key)
def test_what_is_not_outside_is_as_recorded(one, name):
    """Claim by claim, so that what goes wrong has a name."""
    curve = example(name)
    if one.speaks_of(curve.dimension, curve.polynomial):
        row = checked(one, Evaluation(curve), name, Proofs())
        assert row.as_recorded
        assert 0 <= row.seconds < 60


@pytest.mark.parametrize("one", [c for c in all_claims() if c.kind != "zero set"], ids=lambda c: c.key)
def test_what_holds_of_all_curves_is_as_recorded(one):
    row = proved(one)
    assert row.as_recorded
    assert 0 <= row.seconds < 60
    assert bool(row.witness) or row.verdict != REFUTED


def test_a_point_beside_is_the_mean_moved_by_unequal_parts_of_the_extent():
    """Of (0, 0), (6, 3), (3, 0): mean (3, 1), extents 6 and 3, parts 1/9 and 2/11; of one point extents are 1."""
    curve = Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), (6, 3), (3, 0)])
    assert point_beside(curve) == (3 + mpq(6, 9), 1 + mpq(6, 11))
    still = Nurbs(1, [0, 0, 1, 1], [(5, 5, 7), (5, 5, 7)])
    assert point_beside(still) == (5 + mpq(1, 9), 5 + mpq(2, 11), 7 + mpq(3, 13))


def test_the_moved_copy_is_the_curve_with_its_coordinates_exchanged_and_moved():
    curve = example("rational_space_cubic")
    moved, (a, b, c) = moved_copy(curve), point_beside(curve)
    for t in (mpq(1, 3), mpq(3, 4)):
        x, y, z = curve(t)
        w = moved.w(t)
        assert tuple(p(t) / w for p in moved.p) == (y + a, z + b, x + c)


def test_pairs_are_made_of_first_segments():
    curve = example("six_segment_cubic")
    first = beginning(curve)
    assert first.w.breakpoints == curve.breakpoints[:2]
    assert beginning(curve, 3).w.breakpoints == curve.breakpoints[:4]
    assert beginning(curve, 99).w.breakpoints == curve.breakpoints
    pair = pair_with(example("helix_like"))
    assert all(len(patch.polynomials) == 1 for patch in pair.first.p)


def test_where_splines_differ_they_differ_by_what_is_said():
    f = BSpline(1, [0, 0, 1, 2, 2], [0, 0, 3])
    told = re.fullmatch(r"by (\S+) at the parameter (\S+)", where_it_differs(f))
    assert f(mpq(told[2])) == mpq(told[1]) != 0
    assert where_it_differs(f * 0) == "nowhere"
    narrow = BSpline(1, [5, 5, "51/10", "51/10"], [1, 2])
    told = re.fullmatch(r"by (\S+) at the parameter (\S+)", where_it_differs(narrow))
    assert narrow(mpq(told[2])) == mpq(told[1]) != 0
    product = (T - mpq(1, 3)) * (T - mpq(1, 4))
    told = re.fullmatch(r"by (\S+) at the parameter (\S+)", where_it_differs(product))
    assert product(mpq(told[2])) == mpq(told[1]) != 0


def test_a_zero_that_the_other_does_not_have_is_found_with_its_place():
    assert extra_zero(T * (T - mpq(1, 2)), T) == "at the parameter 1/2"
    assert extra_zero(T, T * T) == ""
    assert extra_zero(T, T - 1) == "at the parameter 0"
    assert extra_zero(T - 1, T) == "at the parameter 1 (from the left)"
    assert extra_zero(T * 0, T) == "on all of [0, 1]"
    assert extra_zero(T * 0, T * 0) == ""
    shifted = BSpline.identity(2, 5)
    assert extra_zero(shifted - 3, shifted) == "at the parameter 3"
    irrational = shifted * shifted - 10
    low, high = map(mpq, re.findall(r"[\d/]+", extra_zero(irrational, shifted)))
    assert low**2 < 10 < high**2


def test_zeros_have_their_places_in_the_parameter_of_the_curve():
    shifted = BSpline.identity(3, 7)
    assert zero_of(shifted - 4) == "at the parameter 4"
    assert zero_of(shifted) == ""
    assert zero_of(shifted * 0) == "on all of [3, 7]"
    assert between(mpq(3), mpq(7), (mpq(1, 4), mpq(1, 2))) == "between the parameters 4 and 5"
    assert between(mpq(3), mpq(7), (mpq(1, 4), mpq(1, 4))) == "at the parameter 4"


def test_vacuous_is_undecided_for_one_reason():
    assert Finding(UNDECIDED, "", witness=VACUOUS).is_vacuous
    assert not Finding(VERIFIED, "", witness=VACUOUS).is_vacuous
    assert not Finding(UNDECIDED, "", witness="another").is_vacuous


def test_ids_select_what_they_begin_but_no_other_number():
    assert matches("C4.1a", "c4.1")
    assert matches("T1", "T1")
    assert not matches("T17", "T1")
    assert matches("C4.2i", "C4")
    assert matches("L15", "L")
    assert not matches("C4.1a", "C4.1ab")
    assert matches("E13b", "E13")


# ---- degrees


def test_the_operands_of_table_1_have_the_degrees_of_their_index():
    table = degree_table()
    for one in "12":
        for name in ("p", "w"):
            assert str(getattr(table, name + one)) == f"d{one}"
        assert [str(x) for x in getattr(table, f"v{one}")] == [f"d{one}"] * 3


@pytest.mark.parametrize("name", ["evolute", "torsion", "osculating_circle_centre", "curvature_squared"])
@pytest.mark.parametrize("polynomial", [False, True])
def test_a_joined_degree_is_that_of_numerator_and_denominator(name, polynomial):
    dimension = min(find(name).kind.dimensions)
    found = reduction(name, dimension, polynomial)
    jets = [jet for jet in found.joined if not jet.is_zero and jet.polynomial.total_degree() > 0]
    told = joined_degree(found)
    for d in range(8, 12):
        assert told.at({"d": d}) == degree_at(jets, d)


def test_a_joined_degree_leaves_out_what_is_constant():
    """γ′ of a polynomial curve over 1: its degree is d − 1, the 1 counts nothing."""
    assert str(joined_degree(reduce(find("velocity"), dimension=2, polynomial=True))) == "d − 1"
    flat = reduce(lambda c: Vector(c.p[0].d(1), c.p[0] * 0), dimension=2, polynomial=True)
    assert str(joined_degree(flat)) == "d − 1"


def test_what_is_measured_are_the_formulas_of_the_dimension():
    assert {f.curve for f in measurable(2)} == {"plane", "curve"}
    assert {f.curve for f in measurable(3)} == {"space", "curve"}
    assert {f.curve for f in measurable(4)} == {"curve"}
    told = measure(find("f2"), example("circle"))
    assert (told.formula, str(told.nominal)) == ("f2", "3d − 3")


def test_rows_of_degree_tables_are_measured():
    curve = example("rational_cubic")
    for call in (*construction_table(curve), *formula_table(curve)):
        row = call()
        assert 0 <= row.seconds < 60
        assert row.data()["formula"] == row.formula
        if row.true is not None and row.represented is not None:
            assert row.true <= row.represented


def test_what_a_curve_is_bisected_with_are_primes():
    curve = example("rational_cubic")
    made = _bisected(PLANE_POINT, curve)
    assert [x(0) for x in made.point] == [2, 3]
    space = example("rational_space_cubic")
    assert [x(0) for x in _bisected(POINT_IN_SPACE, space).point] == [2, 3, 5]
    second = _bisected(PAIR, space).second
    told = [[x.d(i)(0) for i in range(2)] for x in (*second.p, second.w)]
    assert told == [[2, 3], [5, 7], [11, 13], [17, 19]]


@pytest.mark.parametrize(
    ("key", "verdict"), [(c.key, c.expected) for c in all_claims() if c.kind == "degree" and c.measure != "nominal"]
)
def test_a_degree_that_is_claimed_one_off_is_refuted(key, verdict):
    """Whatever is proved: one more as a lower bound and one less as an upper bound are refuted with a witness."""
    from dataclasses import replace

    one = claim(key)
    if verdict != "PROVED" or one.relation != "=" or one.measure == "height":
        return
    for relation, by in (("≥", "+ 1"), ("≤", "− 1")):
        if relation == "≤" and "−" in one.claimed and one.measure == "lowest terms":
            continue
        wrong = replace(one, relation=relation, claimed=f"{one.claimed} {by}", expected="REFUTED", status="ours")
        found = wrong.prove()[1]
        assert found.verdict == REFUTED
        assert re.match(r"at .*: -?\d+, not -?\d+", found.witness)
        numbers = re.match(r"at .*: (-?\d+), not (-?\d+)", found.witness)
        assert not wrong.relation.holds(int(numbers[1]), int(numbers[2]))


# ---- notation


def test_factors_and_degrees_in_latex():
    assert factor_latex("-1 w^-3") == r"-1\,w^{-3}\,"
    assert factor_latex("W^2") == r"\bar w^{2}\,"
    assert factor_latex("1") == ""
    assert factor_latex("f2^2") == r"f_2^{2}\,"
    assert factor_latex("D1_squared") == r"\|D_1\|^2\,"
    assert degree_latex("max(d1 + d2, 3d1 − 2)") == r"\max(d_1 + d_2, 3d_1 - 2)"


@pytest.mark.parametrize("one", all_claims(), ids=lambda c: c.key)
def test_the_sides_of_a_claim_are_ranked_by_their_degrees(one):
    """The naive side has the highest nominal degree, the reduced one the lowest; equal ones have no such roles."""
    told = sides(one)
    assert {side.name for side in told} == set(one.named)
    roles = [side.role for side in told]
    if one.curve == "table" or any(find(side.name).kind.adjoins_roots for side in told):
        return
    if "naive" in roles:
        assert (roles[0], roles[-1]) == ("naive", "reduced")
        assert set(roles[1:-1]) <= {"formula"}
        assert told[0].degrees != told[-1].degrees
    else:
        assert set(roles) == {"formula"}


# ---- errors in print


def test_the_errata_are_the_refuted_statements_in_print():
    found = list(errata())
    printed = [c for c in all_claims() if c.status == "printed" and c.expected == "REFUTED"]
    assert sorted(s.key for e in found for s in e.statements) == sorted(c.key for c in printed)
    for erratum in found:
        data = erratum.data()
        assert data["key"] == f"{erratum.paper}: {erratum.error}"
        assert erratum.id == erratum.statements[0].id
        meant = [c for c in all_claims() if c.status == "meant" and c.error == erratum.error]
        assert list(erratum.truth) == [f"{numbered(c)} [{c.expected}]" for c in meant]
        notes = [c.note for c in printed if c.error == erratum.error and c.note]
        assert list(erratum.why) == list(dict.fromkeys(notes))
        for each in erratum.statements:
            one = claim(each.key)
            assert each.words == one.words
            assert each.claimed == one.claims
            assert len(each.check) == 3
            assert each.found
            assert one.place.split(",")[0] in each.place
            factor = one.kind == "identity" and " = " in each.found
            assert bool(each.witness) != factor


def test_remarks_are_what_fails_and_nobody_says():
    for remark in remarks():
        assert all(claim(each.key).status == "ours" for each in remark.statements)


def test_an_identity_is_told_with_the_names_of_its_sides():
    (power,) = [e for e in errata() if e.error == "power-of-w"]
    assert power.statements[0].found == "g1 = w⁸ · g0"
    assert power.statements[0].witness == ""
    assert power.statements[0].check[1] == 'factor = factor_of("g1", "g0", 2)'
    assert name_of(claim("C42b-g1-g0"), "g1") == "g1"
    assert name_of(claim("C43d-evolute_by_frenet-evolute"), "speed_squared") == "‖γ′‖²"
    assert name_of(claim("C42a-curvature_derivative_numerator-g0"), "curvature_derivative_numerator") == (
        "curvature_derivative_numerator"
    )
    assert numbered(claim("C42b-g1-g0")) == claim("C42b-g1-g0").statement


# ---- conditioning


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


def test_a_bracket_reaches_halfway_to_the_next_zeros_and_ends():
    f = BSpline.bezier([-1, 5]) * BSpline.bezier([-1, 1]) * BSpline.bezier([-3, 1])  # zeros at 1/6, 1/2, 3/4
    middle = next(r for r in zeros(f) if r == mpq(1, 2))
    low, high = compare._bracket(f.forms[0], f.degree, middle, zeros(f))
    assert abs(low - mpq(1, 3)) < mpq(1, 10**20)
    assert abs(high - mpq(5, 8)) < mpq(1, 10**20)
    first = next(r for r in zeros(f) if r == mpq(1, 6))
    assert compare._bracket(f.forms[0], f.degree, first, zeros(f))[0] == 0
    on_two = BSpline(1, [0, 0, 3, 5, 5], [-1, -1, 1])
    (only,) = zeros(on_two)
    assert compare._segment_of(on_two, only) == 1
    assert compare._bracket(on_two.forms[1], 1, only, zeros(on_two)) == (0, 1)
    ended = BSpline.bezier([0, -1, 2])  # a zero at the start and one inside
    inner = next(r for r in zeros(ended) if not r.at_knot)
    x = local(inner)[0]
    assert compare._bracket(ended.forms[0], 2, inner, zeros(ended)) == (x / 2, 1)


@given(st.lists(st.integers(-9, 9), min_size=2, max_size=5), st.integers(1, 11))
def test_a_condition_number_of_order_zero_is_the_sum_of_the_sizes_over_the_size(points, k):
    x = mpq(k, 12)
    f = BSpline.bezier(points)
    if not f(x):
        return
    low, high = condition_number(f.forms[0], f.degree, zeros(T - x)[0], 0)
    expected = BSpline.bezier(list(map(abs, points)))(x) / abs(f(x))
    assert low <= expected <= high
    assert high - low <= mpq(1, 10**10) * low


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


def test_what_conditioning_leaves_out_is_named():
    flat = Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 1)])
    told = conditioning(flat, "zero_curvature", doubles=False)
    assert told.left_out == ("[0, 1], where the form vanishes identically",)
    assert told.roots == ()
    assert told.verdicts == {}


def test_a_formula_is_known_by_a_name_that_finds_it():
    """Two papers may share a name: tables measure the one they speak of."""
    assert all(find(known_as(f)) is f for f in all_formulas().values())
    assert len({known_as(f) for f in all_formulas().values()}) == len(all_formulas())
    curve = example("rational_cubic")
    told = [measure(f, curve).formula for f in measurable(2)]
    assert len(set(told)) == len(told)


@pytest.mark.parametrize(("relation", "sign"), [("=", ""), ("≤", "≤ "), ("≥", "≥ ")])
def test_a_bound_is_claimed_with_its_sign(relation, sign):
    from dataclasses import replace

    one = replace(claim("C42g-g2"), relation=relation, expected="PROVED")
    assert one.claims == f"{sign}9d − 6"
    assert "\\" not in one.claims
