"""The parts of claims, each on small cases: what they assume, what they refuse, what is tried where."""

from dataclasses import replace
from time import perf_counter

import pytest
from gmpy2 import mpq

from exactspline import BSpline, Nurbs, zeros
from exactspline.errors import ClaimError, FormulaError
from exactspline.exact import text
from exactspline.language.formula import Formula
from exactspline.language.kinds import CURVE, PLANE, kind_of
from exactspline.language.parts import split
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector
from exactspline.papers import all_formulas, find
from exactspline.readings.printing.text import print_text, symbol_text
from exactspline.readings.tree import trace
from exactspline.splines.examples import example, example_names
from exactspline.splines.tensor import surface_pair
from exactspline.symbolic.covariants import true_degree
from exactspline.symbolic.reduction import reduction
from exactspline.verification import coq_judge, sympy_judge
from exactspline.verification.check_arguments import beginning, with_hodograph
from exactspline.verification.claims import all_claims, claims_of, select
from exactspline.verification.curve_check import spline_table
from exactspline.verification.degree_tables import construction_table
from exactspline.verification.errata import _unrecorded, check
from exactspline.verification.evaluation import Evaluation
from exactspline.verification.generic_proof import factor_of
from exactspline.verification.kinds import Contact, Count, DegreeClaim
from exactspline.verification.kinds.coefficients import NONE, Coefficients, _exists
from exactspline.verification.kinds.condition import _place
from exactspline.verification.kinds.identity import Identity, Vanishing
from exactspline.verification.kinds.zero_set import ZeroSet
from exactspline.verification.ledger import Proofs, checked, proved, tasks
from exactspline.verification.questions import proof_of
from exactspline.verification.statement import _size, sides, telling_tree
from exactspline.verification.verdict import PROVED, REFUTED, UNDECIDED, VERIFIED, Finding, row
from exactspline.verification.vocabulary import ArgumentKind, Counter


def claim(key):
    (found,) = select([key])
    return found


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

    assert not _exists(fails)
    assert not _exists(lambda: None)
    assert _exists(lambda: 0)


def test_coefficients_of_the_generic_polynomial_curve_are_computed():
    """p is linear in p alone: what is proved for w of degree d says nothing of w = 1."""
    one = next(c for c in all_claims() if isinstance(c, Coefficients) and c.curves != "every curve")
    told = one.decide(2, polynomial=True)
    assert told.verdict == VERIFIED
    assert (told.claimed, told.computed) == (NONE, "none vanishes for d = 2…6")


def test_what_stands_beside_a_curve():
    assert Evaluation(example("ellipse")).beside("plane") == ""
    assert Evaluation(example("ellipse")).beside("plane point").startswith(", with the point (")
    assert Evaluation(spline_table()).beside(ArgumentKind.TABLE) == ""


def test_operands_of_table_1_have_the_degrees_that_they_are_said_to_have():
    made = spline_table(2, 4)
    for degree, operands in ((2, (made.p1, made.w1, *made.v1)), (4, (made.p2, made.w2, *made.v2))):
        assert all(f.degree == degree == f.true_degree for f in operands)
        assert len({f.control_points for f in operands}) == 5
    assert min(*made.w1.control_points, *made.w2.control_points) > 0
    assert tuple(made.p1.breakpoints) == (0, 1, 2, 3)
    assert tuple(made.p2.breakpoints) == (0, mpq(1, 2), 2, 3)
    assert tuple(made.p2.continuity) == (3, 2)


def test_the_hodograph_of_an_argument_is_made_of_its_operands():
    curve = example("rational_cubic")
    handed = with_hodograph(curve)
    (u, v), h = curve.p, curve.w
    assert handed.p[0].d(1) == (u * u - v * v) * h
    assert handed.p[1].d(1) == 2 * u * v * h
    assert handed.w == handed.w * handed.w
    assert not handed.w.is_zero
    assert (handed.u, handed.v, handed.h) == (u, v, h)
    assert handed.speed == (u * u + v * v) * h


def identities(*, roots):
    return [c for c in all_claims() if isinstance(c, Identity) and kind_of(c.curve).adjoins_roots is roots]


def test_the_factor_is_printed_where_there_is_one():
    for one in [c for c in identities(roots=False) if c.curve == "plane"]:
        factor = factor_of(one.find(one.left), one.find(one.right), one.dimensions[0])
        assert check(one)[-1].startswith("print(factor)" if factor is not None else "print(claim.")


def test_no_factor_is_printed_over_roots_or_of_what_vanishes():
    for one in identities(roots=True):
        assert check(one)[-1].startswith("print(claim.")
    nothing = next(c.left for c in all_claims() if isinstance(c, Vanishing) and c.curve == "plane")
    one = next(c for c in identities(roots=False) if c.curve == "plane")
    assert check(replace(one, right=nothing))[-1].startswith("print(claim.")


def test_minimal_forms_are_told_with_their_grading():
    curve = example("rational_cubic")
    rows = [call() for call in construction_table(curve) if call.args[0].name == "evolute"]
    found = true_degree(reduction("evolute_lifted", 2, curve.polynomial).main.lowest[0])
    assert {row.variant: row.grading for row in rows}["minimal"] == f"{found.k}, {found.m}, {found.j}"
    assert {row.grading for row in rows if row.variant != "minimal"} == {"–"}


def test_one_claim_makes_its_tasks():
    one = next(c for c in all_claims() if c.key == "C41a-f1-f2")
    assert len(tasks([one])) == 1 + sum(
        one.speaks_of(example(n).dimension, example(n).polynomial) for n in example_names()
    )


def test_a_curve_with_the_name_of_an_example_is_none():
    """On a line f1 = w f2 says nothing, which is on record for no example: there it would be an alarm."""
    one = next(c for c in all_claims() if c.key == "C41a-f1-f2")
    line = Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 1)], name="circle")
    told = checked(one, Evaluation(line), "circle", Proofs())
    assert told.verdict == UNDECIDED
    assert told.as_recorded
    own = checked(one, Evaluation(example("circle")), "circle", Proofs())
    assert (own.verdict, own.expected) == (VERIFIED, VERIFIED)


def test_a_profile_is_taken_inside_the_domain():
    """Two curves over [0, 2] and [5, 8]: lines of either parameter are at a parameter of the other."""
    first, second = (
        beginning(Nurbs(2, [a] * 3 + [b] * 3, [(0, 0, 0), (1, 2, 3), (4, 1, 7)], [1, 2, 5]))
        for a, b in ((0, 2), (5, 8))
    )
    value = find("bisector_determinant_symmetric")(surface_pair(first, second))
    degrees = [c for c in all_claims() if isinstance(c, DegreeClaim) and c.of_pair]
    assert {one.parameter for one in degrees} == {"s", "s̄"}
    for one in degrees:
        line = value.at_t(5 + mpq(6, 7)) if one.parameter == "s" else value.at_s(mpq(4, 7))
        assert split(one._profile(value))[0] == split(line)[0]


def test_contact_of_too_high_an_order_is_refuted_with_the_true_one():
    one = next(c for c in claims_of("petrunin_zamora_barrera") if isinstance(c, Contact) and c.expected == "PROVED")
    for order in range(4):
        told = replace(one, order=order, relation="≥").decide(one.dimensions[0], False)
        assert told.verdict == (PROVED if order <= one.order else REFUTED)
        if order > one.order:
            assert told.computed == str(one.order)


# ---- what a text states


def test_a_text_states_an_identity():
    assert proof_of("f1 = w * f2").holds
    assert proof_of("f1 = w · f2").holds
    assert not proof_of("f1 = f2").holds
    for said in ("f1", "f1 =", "= f2", "", "f1 f2 = f2", "="):
        with pytest.raises(FormulaError, match="states no identity"):
            proof_of(said)
    with pytest.raises(FormulaError) as told:
        proof_of("f1 = nothing_known")
    assert "'nothing_known'" in str(told.value)
    assert "':nothing_known'" not in str(told.value)


# ---- what Coq answers


def test_what_coq_says_of_axioms():
    assert coq_judge._told("about x\nClosed under the global context\n") == "no axioms"
    said = "about x\nAxioms:\nfunctional_extensionality_dep : forall A,\n  (B : A)\nclassic\n  : forall P\n"
    assert coq_judge._told(said) == "axioms functional_extensionality_dep, classic"


def test_the_least_favourable_opinion_counts():
    said = [coq_judge.Opinion("", each) for each in ("holds", "not stated", "fails", "not accepted", coq_judge.MISSING)]
    assert coq_judge._together(said).says == "not accepted"
    assert coq_judge._together(said[:3]).says == "not stated"
    assert coq_judge._together([said[0], said[2]]).says == "holds"
    assert coq_judge._together([said[0], said[4]]).says == coq_judge.MISSING
    assert str(coq_judge.Opinion("t", "holds", "no axioms")) == "holds, no axioms"
    assert str(coq_judge.Opinion("t", "holds")) == "holds"


def test_what_coq_is_asked_to_compile(monkeypatch):
    """A file of which no theorem is chosen is not compiled; of one that is not accepted every theorem is tried alone;
    what others are built on is compiled anyhow.
    """
    asked = []

    class Made:
        files = ("Base", "None", "Good", "Bad")

        def write(self, place):
            asked.append("written")

    class Theorem:
        reason = ""

        def __init__(self, name):
            self.name = name

    monkeypatch.setattr(coq_judge, "compile_file", lambda place, name: asked.append(name) or name != "Bad")
    monkeypatch.setattr(coq_judge, "_alone", lambda place, name, each: asked.append(each.name) or each.name == "c")
    monkeypatch.setattr(coq_judge, "assumptions", lambda place, name, names: dict.fromkeys(names, name))
    chosen = {"None": (), "Good": (Theorem("a"),), "Bad": (Theorem("b"), Theorem("c"))}
    found = coq_judge._compiled(Made(), chosen)
    assert asked == ["written", "Base", "Good", "Bad", "b", "c"]
    assert found == {"a": "Good", "c": "Bad_c"}


def test_what_is_asked_of_theorems_and_what_is_told(monkeypatch, tmp_path):
    asked = {}

    def coqc(place, file):
        asked[file] = (place / file).read_text(encoding="utf-8")
        return True, "about a\nClosed under the global context\nabout b\nAxioms:\nclassic : forall P, P \\/ ~ P\n"

    monkeypatch.setattr(coq_judge, "_coqc", coqc)
    told = coq_judge.assumptions(tmp_path, "papers/one", ["a", "b"])
    assert told == {"a": "no axioms", "b": "axioms classic"}
    text = asked["Ask.v"]
    assert text.startswith(f"Require {coq_judge.ROOT}.papers.one.\n")
    for name in "ab":
        assert f'idtac "about {name}"' in text
        assert f"Print Assumptions {coq_judge.ROOT}.papers.one.{name}.\n" in text
    monkeypatch.setattr(coq_judge, "_coqc", lambda place, file: (False, "about a\nClosed under the global context"))
    assert coq_judge.assumptions(tmp_path, "papers/one", ["a", "b"]) == {}


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
        own = Evaluation(example(one.example))
        assert said.examine(own.handed(one.curve), own).verdict == VERIFIED
        other = replace(one, claimed=f"{nominal + 1} {Counter.NOMINAL_CONTINUITY}")
        assert other.examine(own.handed(one.curve), own).verdict == REFUTED


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
        values = [one.find(name)(own.handed("plane")) for name in one.named]
        nowhere = [v for v in values if isinstance(v, Rational) and v.denominator.vanishes_somewhere]
        assert bool(one.missing(own.handed("plane"))) is bool(nowhere)
        gone += bool(nowhere)
        if nowhere:
            assert one.missing(own.handed("plane")).endswith("does not exist on all of this curve: 0/0")
    assert gone > 3


def test_what_is_proved_of_coefficients_is_what_is_linear():
    one = next(c for c in all_claims() if isinstance(c, Coefficients) and c.curves != "every curve")
    assert one.decide(2, polynomial=False).verdict == PROVED
    told = replace(one, formula="f2", curve="plane").decide(2, polynomial=False)
    assert told.verdict == VERIFIED


def test_the_place_of_a_zero():
    t = BSpline.identity(0, 2)
    (at_end,) = zeros(t)
    (inside,) = zeros(t * t - 2)
    assert _place(at_end) == "at the knot 0"
    low, high = inside.low, inside.high
    assert _place(inside) == f"between {text(low)} and {text(high)}"


def test_a_row_says_of_a_statement_that_it_must_read_so():
    for one in all_claims():
        told = row(one, "", "", Finding(UNDECIDED), 0).statement
        assert told == one.statement + (" (as it must read)" if one.status == "meant" else "")


def test_the_time_of_a_row_is_what_it_took():
    one = next(c for c in all_claims() if c.key == "C41a-f1-f2")
    start = perf_counter()
    rows = [proved(one), sympy_judge.judged(one), checked(one, Evaluation(example("circle")), "circle", Proofs())]
    assert all(0 < each.seconds < perf_counter() - start for each in rows)


def test_nothing_is_assumed_of_two_curves():
    pair = next(c for c in all_claims() if c.of_pair and c.named)
    with pytest.raises(ClaimError, match="is not a polynomial in one curve"):
        replace(pair, assumes=("bisector_determinant_symmetric ≠ 0",))
    plane = next(c for c in all_claims() if c.curve == "plane" and c.named)
    with pytest.raises(ClaimError, match="is not a polynomial in one curve"):
        replace(plane, assumes=("curvature_squared ≠ 0",))
    (told,) = replace(plane, assumes=("f2 ≢ 0",)).assumes
    assert not told.everywhere


def test_what_fails_and_is_not_recorded_is_an_erratum_of_its_own():
    good = next(c for c in all_claims() if c.key == "C41a-f1-f2")
    wrong = replace(good, factor="w^2", status="ours", note="")
    recorded = replace(wrong, expected="REFUTED")
    (told,) = _unrecorded([good, wrong, recorded])
    assert [each.key for each in told.statements] == [wrong.key]
    assert told.why == ()
    (noted,) = _unrecorded([replace(wrong, note="a slip")])
    assert noted.why == ("a slip",)


def test_sides_are_naive_and_reduced_where_their_degrees_differ():
    for one in [c for c in all_claims() if isinstance(c, Identity) and c.curve == "plane"]:
        told = sides(one)
        sizes = [_size(side.name, one) for side in told]
        assert sizes == sorted(sizes, reverse=True)
        roles = [side.role for side in told]
        if sizes[0] == sizes[-1]:
            assert set(roles) == {"formula"}
        else:
            assert (roles[0], roles[-1]) == ("naive", "reduced")
            assert set(roles[1:-1]) <= {"formula"}
