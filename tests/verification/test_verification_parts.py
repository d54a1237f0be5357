"""The parts that verdicts are made of, each held against what it means on small cases with known answers."""

import json
from dataclasses import replace
from types import SimpleNamespace

import pytest
from gmpy2 import mpq

from exactspline import BSpline, Nurbs, NurbsSurface, TensorSpline, Verdict, claims, example, formula_of
from exactspline.language import Vector
from exactspline.language.kinds import PAIR, PLANE_POINT, POINT_IN_SPACE, SURFACE, kind_of
from exactspline.papers import all_formulas, known_as
from exactspline.readings import JetReading
from exactspline.symbolic.covariants import degree_at
from exactspline.symbolic.reduction import reduce, reduction
from exactspline.tables import measurable, measure, table_1_degrees
from exactspline.verification import judges
from exactspline.verification import phrases as say
from exactspline.verification.claims import matches
from exactspline.verification.decision import extra_zero, where_it_differs
from exactspline.verification.degree_tables import (
    BISECTORS,
    WITNESSES,
    bisected_pair,
    construction_table,
    formula_table,
    measured_degrees,
)
from exactspline.verification.evaluation import beginning, moved_copy, pair_with, point_beside
from exactspline.verification.evidence import At, Between, Relating
from exactspline.verification.generic_proof import joined_degree
from exactspline.verification.notation import degree_latex, factor_latex
from exactspline.verification.statement import numbered, remarks, sides, symbol_or_name
from tests.support.claims import claim
from tests.support.command import invoke
from tests.support.decided import errors_in_print, generic_rows
from tests.support.sampled import sample

T = BSpline.identity(0, 1)


# ---- what is said on one curve


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
    pair = pair_with(example("helix_like"))
    assert all(len(patch.numerators) == 1 for patch in pair.first.p)


def test_where_splines_differ_they_differ_by_what_is_said():
    f = BSpline(1, [0, 0, 1, 2, 2], [0, 0, 3])
    value, at = where_it_differs(f)
    assert f(at.parameter) == value != 0
    narrow = BSpline(1, [5, 5, "51/10", "51/10"], [1, 2])
    value, at = where_it_differs(narrow)
    assert narrow(at.parameter) == value != 0
    product = (T - mpq(1, 3)) * (T - mpq(1, 4))
    value, at = where_it_differs(product)
    assert product(at.parameter) == value != 0


def test_what_is_divided_is_not_said_to_be_the_difference():
    """Before: the difference times the denominators was printed, and 392/27 at −14/9 for 9/7."""
    f, below = T * (T - mpq(1, 4)), [T - mpq(1, 2), T]
    value, at = where_it_differs(f, below)
    t = at.parameter
    assert value == f(t) / below[0](t) / below[1](t) != 0
    net = TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[1, 2], [3, 5]])
    zero_on_lines = TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, "1/2", 1, 1], [[1, 0, -1], [1, 0, -1]])
    value, at = where_it_differs(net, [zero_on_lines])
    assert value == net(*at.about) / zero_on_lines(*at.about)


def test_a_difference_of_two_parameters_is_found_wherever_it_is():
    # zero where the second parameter is below 3/4
    net = [[0, 0, 0, 0, 1], [0, 0, 0, 0, 1]]
    f = TensorSpline((1, 2), [0, 0, 1, 1], [0, 0, 0, "1/2", "3/4", 1, 1, 1], net)
    value, at = where_it_differs(f)
    assert f(*at.about) == value != 0
    assert at.about[1] > mpq(3, 4)


def test_a_zero_that_the_other_does_not_have_is_found_with_its_place():
    assert extra_zero(T * (T - mpq(1, 2)), T) == At(mpq(1, 2))
    assert extra_zero(T, T * T) is None
    assert extra_zero(T, T - 1) == At(mpq(0))
    assert extra_zero(T - 1, T) == At(mpq(1), from_left=True)
    assert extra_zero((T - 1) * (T - 1), T - 1) is None
    # 2t² − 1 vanishes in (0, 1), t − 1 at 1 alone
    assert isinstance(extra_zero(2 * T * T - 1, T - 1), Between)
    assert isinstance(extra_zero((2 * T * T - 1) * (T - 1), T - 1), Between)
    assert extra_zero(T * 0, T) == say.on_all_of(mpq(0), mpq(1))
    assert extra_zero(T * 0, T * 0) is None
    shifted = BSpline.identity(2, 5)
    assert extra_zero(shifted - 3, shifted) == At(mpq(3))
    irrational = shifted * shifted - 10
    place = extra_zero(irrational, shifted)
    assert place.low**2 < 10 < place.high**2


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
    table = table_1_degrees()
    for one in "12":
        for name in ("p", "w"):
            assert str(getattr(table, name + one)) == f"d{one}"
        assert [str(x) for x in getattr(table, f"v{one}")] == [f"d{one}"] * 3


@pytest.mark.parametrize("name", ["evolute", "torsion", "osculating_circle_centre", "curvature_squared"])
@pytest.mark.parametrize("polynomial", [False, True])
def test_a_joined_degree_is_that_of_numerator_and_denominator(name, polynomial):
    dimension = min(formula_of(name).kind.dimensions)
    found = reduction(name, dimension, polynomial)
    jets = [jet for jet in found.joined if not jet.is_zero and jet.polynomial.total_degree() > 0]
    told = joined_degree(found)
    for d in range(8, 12):
        assert told.at({"d": d}) == degree_at(jets, d)


def test_a_joined_degree_leaves_out_what_is_constant():
    """γ′ of a polynomial curve over 1: its degree is d − 1, the 1 counts nothing."""
    assert str(joined_degree(reduce(formula_of("velocity"), dimension=2, polynomial=True))) == "d − 1"
    flat = reduce(lambda c: Vector(c.p[0].d(1), c.p[0] * 0), dimension=2, polynomial=True)
    assert str(joined_degree(flat)) == "d − 1"


def test_a_joined_degree_counts_components_that_are_constant_and_none_that_vanish():
    """(3, x‴) has degree 0 for d < 3; x‴ alone vanishes there."""
    joined = lambda function: str(joined_degree(reduce(function, dimension=2, polynomial=True)))  # noqa: E731
    assert joined(lambda c: Vector(c.p[0] * 0 + 3, c.p[0].d(3))) == "max(d − 3, 0)"
    assert joined(lambda c: Vector(c.p[0] * 0, c.p[0].d(3))) == "d − 3"
    assert joined(lambda c: Vector(c.p[0] * 0 + 3, c.p[0] * 0)) == "0"
    assert joined(lambda c: Vector(c.p[0] * 0, c.p[0] * 0)) == "−1"


def test_what_is_measured_are_the_formulas_of_the_dimension():
    assert {f.curve for f in measurable(2)} == {"plane", "curve"}
    assert {f.curve for f in measurable(3)} == {"space", "curve"}
    assert {f.curve for f in measurable(4)} == {"curve"}
    told = measure(formula_of("f2"), example("circle"))
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
    made = bisected_pair(PLANE_POINT, curve)
    assert [x(0) for x in made.point] == [2, 3]
    space = example("rational_space_cubic")
    assert [x(0) for x in bisected_pair(POINT_IN_SPACE, space).point] == [2, 3, 5]
    second = bisected_pair(PAIR, space).second
    told = [[x.d(i)(0) for i in range(2)] for x in (*second.p, second.w)]
    assert told == [[2, 3], [5, 7], [11, 13], [17, 19]]


@pytest.mark.parametrize(
    "one",
    sample(
        [
            c
            for c in claims()
            if c.kind == "degree"
            and c.measure not in ("nominal", "height")
            and (c.expected, c.relation) == ("PROVED", "=")
        ],
        50,
    ),
    ids=lambda c: c.key,
)
def test_a_degree_that_is_claimed_one_off_is_refuted(one):
    """Whatever is proved: one more as a lower bound and one less as an upper bound are refuted with a witness."""
    for relation, by in (("≥", "+ 1"), ("≤", "− 1")):
        if relation == "≤" and "−" in one.claimed and one.measure == "lowest terms":
            continue
        wrong = replace(one, relation=relation, claimed=f"{one.claimed} {by}", expected="REFUTED", status="ours")
        found = wrong.prove()[1]
        assert found.verdict == Verdict.REFUTED
        assert found.witness.relation == wrong.relation
        assert found.witness.at
        assert not wrong.relation.holds(found.witness.degree, found.witness.claimed)


# ---- notation


def test_factors_and_degrees_in_latex():
    assert factor_latex("-1 w^-3") == r"-1\,w^{-3}\,"
    assert factor_latex("W^2") == r"\bar w^{2}\,"
    assert factor_latex("1") == ""
    assert factor_latex("f2^2") == r"f_2^{2}\,"
    assert factor_latex("D1_squared") == r"\|D_1\|^2\,"
    assert degree_latex("max(d1 + d2, 3d1 − 2)") == r"\max(d_1 + d_2, 3d_1 - 2)"


@pytest.mark.parametrize("one", sample(claims(), 150), ids=lambda c: c.key)
def test_the_sides_of_a_claim_are_ranked_by_their_degrees(one):
    """The naive side has the highest nominal degree, the reduced one the lowest; equal ones have no such roles."""
    told = sides(one)
    assert {side.name for side in told} == set(one.named)
    roles = [side.role for side in told]
    if one.curve == "table" or any(one.find(side.name).kind.adjoins_roots for side in told):
        return
    if "naive" in roles:
        assert (roles[0], roles[-1]) == ("naive", "reduced")
        assert set(roles[1:-1]) <= {"formula"}
        assert told[0].degrees != told[-1].degrees
    else:
        assert set(roles) <= {"formula"}


# ---- errors in print


def test_the_errata_are_the_refuted_statements_in_print():
    found = list(errors_in_print())
    printed = [c for c in claims() if c.status == "printed" and c.expected == "REFUTED"]
    assert sorted(s.key for e in found for s in e.statements) == sorted(c.key for c in printed)
    listed = {row["key"] for row in json.loads(invoke("errata", "--json").stdout)["rows"]}
    assert {f"{erratum.paper}: {erratum.error}" for erratum in found} <= listed
    for erratum in found:
        assert erratum.id == erratum.statements[0].id
        meant = [c for c in claims() if c.status == "meant" and c.error == erratum.error]
        assert [(each.key, str(each)) for each in erratum.truth] == [
            (c.key, f"{numbered(c)} [{c.expected}]") for c in meant
        ]
        notes = [c.note for c in printed if c.error == erratum.error and c.note]
        assert list(erratum.why) == list(dict.fromkeys(notes))
        for each in erratum.statements:
            one = claim(each.key)
            assert each.words == one.words
            assert each.claimed == one.claims
            assert len(each.check) <= 3
            assert each.found
            assert one.place.split(",")[0] in each.place
            assert bool(each.witness) != isinstance(each.found, Relating)


def test_remarks_are_what_fails_and_nobody_says():
    for remark in remarks():
        assert all(claim(each.key).status == "ours" for each in remark.statements)


def test_an_identity_is_told_with_the_names_of_its_sides():
    (power,) = [e for e in errors_in_print() if e.error == "power-of-w"]
    assert str(power.statements[0].found) == "g1 = w⁸ · g0"
    assert power.statements[0].witness is None
    assert power.statements[0].check[-1] == 'print(factor_of(find("g1"), find("g0"), 2))'
    assert symbol_or_name(claim("C42b-g1-g0"), "g1") == "g1"
    assert symbol_or_name(claim("C43d-evolute_by_frenet-evolute"), "speed_squared") == "‖γ′‖²"
    assert symbol_or_name(claim("C42a-curvature_derivative_numerator-g0"), "curvature_derivative_numerator") == (
        "curvature_derivative_numerator"
    )
    assert numbered(claim("C42b-g1-g0")) == claim("C42b-g1-g0").statement


# ---- conditioning


def test_a_formula_is_known_by_a_name_that_finds_it():
    """Two papers may share a name: tables measure the one they speak of."""
    assert all(formula_of(known_as(f)) is f for f in all_formulas().values())
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


def test_degrees_in_the_bisector_table_are_those_of_the_larger_part_and_attained():
    """Of (34) on polynomials the numerator has 3d − 1, the denominator 2d − 2; rational ones have 4d − 2 in both."""
    rows = {row.object: row for row in generic_rows(polynomial=True) if row.object in BISECTORS}
    assert {(row.k, row.m, row.j, row.true) for row in rows.values()} == {(3, 1, 1, "3d − 1")}
    more = generic_rows(polynomial=False)[-len(BISECTORS) :]
    assert {(row.k, row.m, row.true) for row in more} == {(4, 1, "4d − 2")}
    for row in (*rows.values(), *more):
        assert (row.attained, row.absent, row.differ) == (tuple(WITNESSES), (), ())


def test_measured_degrees_of_a_product_add_up_with_exponents():
    """Of factors and a core on the patch (u, v, u v²)/(1 + u); nothing where a factor or the whole core vanishes."""
    ends = [0, 0, 1, 1]
    u, v = TensorSpline((1, 1), ends, ends, [[0, 0], [1, 1]]), TensorSpline((1, 1), ends, ends, [[0, 1], [0, 1]])
    patch = NurbsSurface.from_splines([u, v, u * v * v], u + 1)
    c = JetReading(1).argument(SURFACE, 3)
    x, y, z = c.p

    def measured(core, *kept):
        return measured_degrees(SimpleNamespace(core=core, kept=kept), patch)

    zero = x - x
    assert measured((x, y, z)) == (1, 2)
    assert (measured((x, zero)), measured((zero, y))) == ((1, 0), (0, 1))
    assert measured((x, y), (c.w, 2), (z, 3)) == (2 + 3 + 1, 6 + 1)
    assert measured((zero, zero), (c.w, 2)) == (-1, -1)
    assert measured((x, y), (c.w, 2), (zero, 1)) == (-1, -1)


def test_sympy_is_asked_about_polynomial_curves_where_the_claim_is():
    """Also with roots adjoined: there formulas of γ alone have indeterminate coordinates, others p and w."""
    framed = next(c for c in claims() if c.kind == "identity" and kind_of(c.curve).adjoins_roots)
    (dimension,) = kind_of(framed.curve).dimensions
    weighted = replace(framed, factor="w^2")
    assert judges.argument_for(weighted, dimension, True).polynomial
    assert not judges.argument_for(weighted, dimension, False).polynomial
    assert judges.argument_for(replace(framed, factor="1"), dimension, False).polynomial


def test_a_formula_that_is_out_of_reach_ends_no_table_of_degrees():
    """One error instead of 415 rows, where a single greatest common divisor is too expensive."""
    far, near = formula_of("petrunin_zamora_barrera:sphere_radius_squared"), formula_of("f2")
    curves = example("rational_space_cubic"), example("rational_cubic")
    (row,), (other,) = ([call() for call in formula_table(c, [f])] for c, f in zip(curves, (far, near), strict=True))
    assert (row.nominal, row.represented, row.true) == ("692d", None, None)
    assert "would take too long" in row.text
    assert (other.represented, other.true) == (6, 3)
