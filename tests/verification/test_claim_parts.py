"""The parts of claims, each on small cases: what they assume, what they refuse, what is tried where."""

from dataclasses import replace
from time import perf_counter

import pytest

from exactspline import BSpline, Nurbs, decide, example
from exactspline.display.evidence import worded
from exactspline.errors import ClaimError, FormulaError
from exactspline.language import Rational, Vector, join
from exactspline.language.formula import Formula
from exactspline.language.kinds import CURVE, PLANE, kind_of
from exactspline.papers import all_formulas, find
from exactspline.readings import trace
from exactspline.readings.printing import print_text, symbol_text
from exactspline.symbolic.covariants import true_degree
from exactspline.symbolic.reduction import reduction
from exactspline.verification import judges
from exactspline.verification.claims import all_claims, claims_of
from exactspline.verification.degree_tables import construction_table, formula_degrees
from exactspline.verification.divisors import divisors
from exactspline.verification.errata import check, unrecorded
from exactspline.verification.evaluation import Evaluation, with_hodograph
from exactspline.verification.evidence import Fact
from exactspline.verification.kinds.coefficients import Coefficients, is_decided
from exactspline.verification.kinds.contact import Contact
from exactspline.verification.kinds.equality import Identity, IsoCurve, Vanishing
from exactspline.verification.kinds.examples import Count
from exactspline.verification.kinds.invariance import times_unit
from exactspline.verification.kinds.types import Existence
from exactspline.verification.kinds.zeros import SquareClass, ZeroSet
from exactspline.verification.ledger import Proofs, checked
from exactspline.verification.questions import proof_of
from exactspline.verification.statement import telling_tree
from exactspline.verification.verdict import PROVED, REFUTED, UNDECIDED, VACUOUS, VERIFIED
from exactspline.verification.vocabulary import Counter, Reason
from tests.support.claims import claim

T = BSpline.identity(0, 1)


def offset_claim(**changes):
    one = next(c for c in claims_of("levien_parallel_curves") if c.curve == "plane with delta" and not c.assumes)
    return replace(one, **changes)


# ---- what is assumed


@pytest.mark.parametrize(("sign", "everywhere"), [("≠", True), ("≢", False)])
def test_what_an_author_assumes_of_a_constant(sign, everywhere):
    (told,) = offset_claim(assumes=(f"delta {sign} 0",)).assumes
    assert told.everywhere is everywhere
    assert told.name == f"delta {sign} 0"
    assert told.words == ("delta has no zero" if everywhere else "delta vanishes on no whole segment")


@pytest.mark.parametrize("name", ["x ≠ 0", "p ≠ 0", "s ≠ 0", "nobody ≠ 0", "delta ≠ 1", "delta", "delta = 0"])
def test_nothing_else_is_assumed(name):
    with pytest.raises((ClaimError, FormulaError)):
        offset_claim(assumes=(name,))


# ---- what is refused


@pytest.mark.parametrize(("order", "fits"), [(-1, False), (0, True), (12, True), (13, False), (True, False)])
def test_orders_of_contact(order, fits):
    one = next(c for c in claims_of("petrunin_zamora_barrera") if isinstance(c, Contact))
    if fits:
        assert replace(one, order=order).order == order
    else:
        with pytest.raises(ClaimError):
            replace(one, order=order)


@pytest.mark.parametrize("formulas", [(), ("f1",), ("f1", "f1"), ("f1", "f2", "f1")])
def test_a_zero_set_is_compared_with_another(formulas):
    one = next(c for c in all_claims() if isinstance(c, ZeroSet) and c.curve == "plane")
    with pytest.raises(ClaimError):
        replace(one, formulas=formulas)
    assert replace(one, formulas=("f1", "f2")).formulas == ("f1", "f2")


def test_coefficients_are_those_of_polynomials_in_every_dimension(monkeypatch):
    one = next(c for c in all_claims() if isinstance(c, Coefficients) and c.curve == "curve")
    for dimension in (2, 3):
        partly = Formula(lambda c, n=dimension: c.p / c.w if len(c.p) == n else c.p, "partly", CURVE, "")
        monkeypatch.setattr(Coefficients, "find", lambda self, name, formula=partly: formula)
        with pytest.raises(ClaimError, match="quotient"):
            one.validate()


# ---- what is said


def test_a_reading_that_does_not_apply_decides_nothing():
    def fails():
        raise FormulaError("no", remedy="none")

    assert not is_decided(fails)
    assert not is_decided(lambda: None)
    assert is_decided(lambda: 0)


def test_coefficients_of_the_generic_polynomial_curve_are_computed():
    """p is linear in p alone: what is proved for w of degree d does not hold for w = 1."""
    one = next(c for c in all_claims() if isinstance(c, Coefficients) and c.curves != "every curve")
    told = one.decide(2, polynomial=True)
    assert (told.verdict, told.reason) == (UNDECIDED, Reason.SAMPLED)
    assert worded(told.computed) == ("none vanishes for d = 2…6")


def test_the_hodograph_of_an_argument_is_made_of_its_operands():
    curve = example("rational_cubic")
    handed = with_hodograph(curve, {})
    (u, v), h = curve.p, curve.w
    assert handed.p[0].d(1) == (u * u - v * v) * h
    assert handed.p[1].d(1) == 2 * u * v * h
    assert handed.w == handed.w * handed.w
    assert not handed.w.is_zero
    assert (handed.u, handed.v, handed.h) == (u, v, h)
    assert handed.speed == (u * u + v * v) * h


def identities(*, roots):
    return [c for c in all_claims() if isinstance(c, Identity) and kind_of(c.curve).adjoins_roots is roots]


def test_no_factor_is_printed_over_roots_or_of_what_vanishes():
    for one in identities(roots=True):
        assert "; print(claim." in check(one)[-1]
    nothing = next(c.left for c in all_claims() if isinstance(c, Vanishing) and c.curve == "plane")
    one = next(c for c in identities(roots=False) if c.curve == "plane")
    assert "; print(claim." in check(replace(one, right=nothing))[-1]


def test_minimal_forms_are_told_with_their_grading():
    curve = example("rational_cubic")
    rows = [call() for call in construction_table(curve) if call.args[0].name == "evolute"]
    found = true_degree(reduction("evolute_lifted", 2, curve.polynomial).main.lowest[0])
    assert {row.variant: row.grading for row in rows}["minimal"] == f"{found.k}, {found.m}, {found.j}"
    assert {row.grading for row in rows if row.variant != "minimal"} == {"–"}


def test_a_curve_with_the_name_of_an_example_is_none():
    """On a line f1 = w f2 says nothing, which is on record for no example: there it would be an alarm."""
    one = claim("C41a-f1-f2")
    line = Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 1)], name="circle")
    told = checked(one, Evaluation(line), "circle", Proofs())
    assert told.verdict == VACUOUS
    assert told.as_recorded
    own = checked(one, Evaluation(example("circle")), "circle", Proofs())
    assert (own.verdict, own.expected) == (VERIFIED, (VERIFIED,))


# ---- what a text states


def test_a_text_states_an_identity():
    assert proof_of("f1 = w * f2").holds
    assert proof_of("f1 = w · f2").holds
    assert not proof_of("f1 = f2").holds
    for said in ("f1", "f1 =", "= f2", "", "f1 = f2 = f1", "="):
        with pytest.raises(FormulaError, match="states no identity"):
            proof_of(said)
    with pytest.raises(FormulaError) as told:
        proof_of("f1 = nothing_known")
    assert "'nothing_known'" in str(told.value)
    assert "':nothing_known'" not in str(told.value)


def test_continuity_is_that_of_the_least_continuous_component(monkeypatch):
    smooth = BSpline(2, [0, 0, 0, 1, 2, 2, 2], [0, 1, 0, 2])
    corner = BSpline(2, [0, 0, 0, 1, 1, 2, 2, 2], [0, 1, 5, 0, 2])
    hidden = BSpline(2, [0, 0, 0, 1, 1, 2, 2, 2], [1, 1, 1, 1, 1])
    one = next(c for c in all_claims() if isinstance(c, Count))
    for parts, nominal, true in (
        ((smooth, corner), 0, 0),
        ((corner, smooth), 0, 0),
        ((smooth, smooth), 1, 1),
        ((smooth, hidden), 0, 1),
    ):
        made = Formula(lambda c, parts=parts: Vector(*parts), "made", CURVE, "")
        monkeypatch.setattr(Count, "find", lambda self, name, made=made: made)
        said = replace(
            one, claimed=f"degree 2, {nominal} {Counter.NOMINAL_CONTINUITY}, {true} {Counter.TRUE_CONTINUITY}"
        )
        own = Evaluation(one.curve_named(one.example))
        assert said.examine(own.argument(one.curve), own).verdict == VERIFIED
        other = replace(one, claimed=f"{nominal + 1} {Counter.NOMINAL_CONTINUITY}")
        assert other.examine(own.argument(one.curve), own).verdict == REFUTED


def test_a_tree_is_spelled_out_only_where_it_would_repeat_the_symbol():
    spelled = 0
    for formula in [f for f in all_formulas().values() if f.kind in (CURVE, PLANE) and f.symbol]:
        tree = print_text(trace(formula, 2))
        told = print_text(telling_tree(formula, 2))
        repeats = tree == symbol_text(formula.symbol)
        assert told == (print_text(trace(formula, 2, expand=True)) if repeats else tree)
        spelled += repeats
    assert spelled


def test_a_formula_is_missing_where_its_denominator_vanishes_on_one_segment():
    """The first segment is one point: γ′ = 0 there."""
    curve = Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 2], [(0, 0), (0, 0), (0, 0), (1, 2), (3, 1)])
    own, gone = Evaluation(curve), 0
    for one in [c for c in all_claims() if c.curve == "plane" and c.named]:
        values = [one.find(name)(own.argument("plane")) for name in one.named]
        nowhere = [v for v in values if isinstance(v, Rational) and v.denominator.vanishes_somewhere]
        assert bool(one.missing(own.argument("plane"))) is bool(nowhere)
        gone += bool(nowhere)
        if nowhere:
            assert one.missing(own.argument("plane")).formula in one.named
    assert gone > 3


def test_the_time_of_a_row_is_what_it_took():
    one = claim("C41a-f1-f2")
    start = perf_counter()
    rows = [
        decide(one),
        judges.second_opinion(judges.Sympy(), decide(one)),
        checked(one, Evaluation(example("circle")), "circle", Proofs()),
    ]
    assert all(0 < each.seconds < perf_counter() - start for each in rows)


def test_nothing_is_assumed_of_two_curves():
    pair = next(c for c in all_claims() if c.of_pair and c.named)
    with pytest.raises(ClaimError, match="is not a function of one curve alone"):
        replace(pair, assumes=("bisector_determinant_symmetric ≠ 0",))
    plane = next(c for c in all_claims() if c.curve == "plane" and c.named)
    assert replace(plane, assumes=("curvature_squared ≠ 0",)).assumes[0].everywhere
    (told,) = replace(plane, assumes=("f2 ≢ 0",)).assumes
    assert not told.everywhere


def test_what_fails_and_is_not_recorded_is_an_erratum_of_its_own():
    good = claim("C41a-f1-f2")
    wrong = replace(good, factor="w^2", status="ours", note="")
    recorded = replace(wrong, expected="REFUTED")
    (told,) = unrecorded([good, wrong, recorded])
    assert [each.key for each in told.statements] == [wrong.key]
    assert told.why == ()
    (noted,) = unrecorded([replace(wrong, note="a slip")])
    assert noted.why == ("a slip",)


# ---- formulas made for it


def with_formula(monkeypatch, one, value, kind=CURVE):
    made = Formula(value, "made", kind, "")
    monkeypatch.setattr(type(one), "find", lambda self, name: made)
    return one


def test_a_vector_with_a_component_that_vanishes_is_no_zero(monkeypatch):
    value = lambda c: join(c.p[0], 0 * c.p[0], c.p[1])  # noqa: E731
    one = next(c for c in all_claims() if isinstance(c, Coefficients) and c.curves != "every curve")
    told = with_formula(monkeypatch, one, value).decide(2, polynomial=True)
    assert (told.verdict, told.reason) == (UNDECIDED, Reason.SAMPLED)
    zero = lambda c: join(0 * c.w, 0 * c.w)  # noqa: E731
    assert with_formula(monkeypatch, one, zero).decide(2, polynomial=True).verdict == REFUTED
    other = next(c for c in all_claims() if isinstance(c, Existence))
    assert with_formula(monkeypatch, other, value).decide(2, polynomial=False).verdict == REFUTED
    assert with_formula(monkeypatch, other, zero).decide(2, polynomial=False).verdict == VACUOUS


def test_zero_sets_depend_on_assumptions():
    """Passed before: no claim in lowest terms was proved, and none that is undecided said why."""
    one = next(c for c in all_claims() if isinstance(c, ZeroSet) and c.curve == "plane")
    one = replace(one, formulas=("f1", "f2"))
    assert replace(one, assumes=("w",)).decide(2, False).verdict == PROVED
    found = replace(one, assumes=()).decide(2, False)
    assert (found.verdict, str(found.witness)) == (UNDECIDED, "w may have zeros: assume w")


def test_squares_are_those_of_one_curve():
    one = next(c for c in all_claims() if isinstance(c, SquareClass))
    pair = {"formula": "bisector_determinant_symmetric", "right": "bisector_determinant", "of": "both"}
    with pytest.raises(ClaimError, match="not decided"):
        replace(one, curve="pair", **pair)
    with pytest.raises(ClaimError, match="one formula"):
        replace(one, right=one.formula)


def test_the_degrees_of_formulas_are_told_of_rational_and_polynomial_curves():
    rows = [call() for call in formula_degrees([find("f0")])]
    assert [row.curves for row in rows] == ["rational", "polynomial"]
    polynomial = [reduction("f0", 2, world).main.generic_lowest for world in (False, True)]
    assert [row.lowest for row in rows] == [str(degree) for degree in polynomial]
    assert rows[0].nominal != rows[1].nominal


def test_an_iso_curve_that_does_not_exist_on_one_segment_says_nothing():
    """The first of two segments is one point, where γ′ = 0."""
    one = next(c for c in all_claims() if isinstance(c, IsoCurve))
    curve = Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 2], [(0, 0), (0, 0), (0, 0), (1, 2), (3, 1)])
    own = Evaluation(curve)
    assert one.examine(own.argument(one.curve), own).verdict == VACUOUS
    whole = Evaluation(example("rational_cubic"))
    assert one.examine(whole.argument(one.curve), whole).verdict == VERIFIED


@pytest.mark.parametrize("power", [2, 4, 6])
def test_a_power_of_a_difference_has_no_contact(monkeypatch, power):
    """Passed before: the plane x = x(s), counted several times, has contact of any order with every curve."""
    one = next(c for c in claims_of("petrunin_zamora_barrera") if isinstance(c, Contact))
    value = lambda c: (c.second.p[0] * c.first.w - c.first.p[0] * c.second.w) ** power  # noqa: E731
    with_formula(monkeypatch, one, value, kind_of(one.curve))
    for order, relation in ((power - 1, "="), (power - 1, "≥"), (power, "≥"), (0, "≥")):
        found = replace(one, order=order, relation=relation).decide(one.dimensions[0], False)
        assert (found.verdict, found.witness) == (UNDECIDED, Fact.SINGULAR_CONTACT)


@pytest.mark.parametrize(("order", "relation", "verdict"), [(0, "=", PROVED), (0, "≥", PROVED), (1, "≥", REFUTED)])
def test_a_plane_through_the_point_has_contact_of_order_0(monkeypatch, order, relation, verdict):
    one = next(c for c in claims_of("petrunin_zamora_barrera") if isinstance(c, Contact))
    value = lambda c: c.second.p[0] * c.first.w - c.first.p[0] * c.second.w  # noqa: E731
    with_formula(monkeypatch, one, value, kind_of(one.curve))
    found = replace(one, order=order, relation=relation).decide(one.dimensions[0], False)
    assert found.verdict == verdict


def test_a_claim_on_formulas_in_two_dimensions_divides_by_those_that_it_speaks_of():
    """The right side of an iso-curve is handed the curve in space."""
    assert {divisors(c) for c in all_claims() if isinstance(c, IsoCurve)} == {()}


def test_what_has_no_unit_has_no_weight():
    assert times_unit([T], None, 2) == [T]
    assert times_unit([T], T + 1, 0) == [T]
    assert times_unit([T], T + 1, 2) == [T * (T + 1) * (T + 1)]
