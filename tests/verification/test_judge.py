"""The judge cannot be fooled: statements that are false, each of which was once PROVED or VERIFIED."""

from dataclasses import replace

import pytest

from exactspline import Nurbs, Verdict, claims, example, examples, formula_of, paper
from exactspline.errors import ClaimError
from exactspline.language import Vector, det, dot
from exactspline.language.ruled import RuledSurface
from exactspline.readings.leading_terms import generic_true_degree
from exactspline.symbolic.assumptions import ASSUMPTIONS, assumption
from exactspline.verification import phrases as say
from exactspline.verification.evidence import Fact, OnExample
from exactspline.verification.ledger import audit
from tests.support.claims import lent, one_verdict, stated
from tests.support.command import new_paper


def verdict(claim):
    return claim.prove()[1].verdict


def degree(formula, claimed, **more):
    return stated("degree", **{"curve": formula_of(formula).curve, "formula": formula, "claimed": claimed} | more)


@pytest.fixture
def also(monkeypatch):
    """Formulas that a paper has while a test runs."""

    def add(name, function, kind):
        return lent(monkeypatch, name, function, kind)

    return add


# ---- scope


@pytest.mark.parametrize(
    ("formula", "false", "true", "least"), [("f2", "3d − 6", "2d − 4", 2), ("D1", "2d − 2", "d − 1", 1)]
)
def test_true_degrees_of_polynomial_curves_are_those_of_polynomial_curves(formula, false, true, least):
    claim = degree(formula, false, of="polynomial", measure="true", least_d=least)
    assert verdict(claim) == Verdict.REFUTED
    assert verdict(replace(claim, claimed=true)) == Verdict.PROVED
    assert verdict(replace(claim, of="rational")) == Verdict.PROVED


@pytest.mark.parametrize(
    ("formula", "measure", "false"), [("f0", "reduced", "3d − 6"), ("evolute", "lowest terms", "6d − 6")]
)
def test_what_holds_of_rational_curves_alone_does_not_hold_of_both(formula, measure, false):
    claim = degree(formula, false, measure=measure, least_d=3)
    assert verdict(claim) == Verdict.REFUTED
    assert verdict(replace(claim, of="rational")) == Verdict.PROVED


def test_the_parameter_is_the_one_that_is_named():
    claim = degree("second_normal", "0", of="rational", measure="reduced")
    assert verdict(claim) == Verdict.PROVED
    assert verdict(replace(claim, parameter="s̄")) == Verdict.REFUTED
    assert verdict(replace(claim, parameter="s̄", claimed="2d − 2")) == Verdict.PROVED
    curve = example("rational_space_cubic")
    assert replace(claim, parameter="s̄", claimed="2d − 3").check(curve).verdict == Verdict.REFUTED
    assert replace(claim, parameter="s̄", claimed="2d − 2").check(curve).reason == "tried on a part"


def test_identities_and_vanishing_keep_to_their_curves():
    zero = stated("vanishing", **{"curve": "curve", "left": "D21", "of": "polynomial"})
    assert (verdict(zero), verdict(replace(zero, of="rational")), verdict(replace(zero, of="both"))) == (
        Verdict.PROVED,
        Verdict.REFUTED,
        Verdict.REFUTED,
    )
    same = stated("identity", **{"curve": "plane", "left": "f0", "right": "f2", "of": "polynomial"})
    assert (verdict(same), verdict(replace(same, of="both"))) == (Verdict.PROVED, Verdict.REFUTED)


# ---- zero


def test_zero_has_no_zero_set_in_common_with_anything():
    claim = stated("zero set", **{"curve": "space", "formulas": ["D1_D2_D21", "D1_D2_D3"]})
    for order in (claim.formulas, claim.formulas[::-1]):
        assert verdict(replace(claim, formulas=order)) == Verdict.REFUTED
        assert replace(claim, formulas=order).check(example("rational_space_cubic")).verdict == Verdict.REFUTED


def test_zero_is_in_no_square_class():
    claim = stated("square class", **{"curve": "space", "formula": "D1_D2_D21", "right": "speed_squared"})
    assert claim.prove()[1].verdict == Verdict.VACUOUS
    assert claim.check(example("rational_space_cubic")).verdict == Verdict.VACUOUS


def test_nothing_is_divided_by_zero():
    told = {"curve": "space", "left": "D1_D2_D3", "right": "velocity_acceleration_jerk", "of": "rational"}
    claim = stated("identity", **told | {"factor": "w^6 D1_D2_D21^-1"})
    assert verdict(claim) == Verdict.REFUTED
    assert claim.check(example("rational_space_cubic")).verdict == Verdict.VACUOUS
    on_line = stated(
        "identity", **{"curve": "plane", "left": "D1_squared", "right": "speed_squared", "factor": "w^4 f2 f2^-1"}
    )
    assert verdict(on_line) == Verdict.PROVED
    assert on_line.check(example("straight_line")).verdict == Verdict.VACUOUS


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_formula_that_divides_by_zero_applies_to_nothing(also, dimension):
    """It was PROVED to apply, which said only that its operands were there."""
    kind = {2: "plane", 3: "space"}[dimension]
    name = also("by_zero", lambda c: c.gamma / dot(c.gamma - c.gamma, c.gamma), kind)
    claim = stated("applies", **{"curve": kind, "formula": name})
    assert verdict(claim) == Verdict.VACUOUS
    assert claim.check(example({2: "cubic_s", 3: "twisted_cubic"}[dimension])).verdict == Verdict.VACUOUS


def test_a_ruled_surface_needs_a_generator(also):
    name = also("pointlike", lambda c: RuledSurface(c.gamma, c.gamma.d(1) - c.gamma.d(1)), "space")
    claim = stated("same surface", **{"curve": "space", "left": "tangent_developable", "right": name})
    for left, right in ((claim.left, name), (name, claim.left)):
        assert verdict(replace(claim, left=left, right=right)) == Verdict.VACUOUS
        assert replace(claim, left=left, right=right).check(example("twisted_cubic")).verdict == Verdict.VACUOUS


# ---- assumptions


@pytest.mark.parametrize(
    "claim", [c for c in claims() if c.kind == "zero set" and c.expected == Verdict.PROVED], ids=lambda c: c.key
)
def test_no_zero_set_is_proved_without_the_assumptions_it_uses(claim):
    _, finding = claim.prove()
    assert finding.assumptions
    for name in finding.assumptions:
        left = tuple(each for each in claim.assumes if each.name != name)
        # w is a factor of the torsion's numerator and denominator alike: without it the statement stays true
        still_true = (claim.key, name) == ("C52c-torsion-D1_D2_D3", "w")
        assert (verdict(replace(claim, assumes=left)) == Verdict.PROVED) == still_true


def test_to_vanish_on_no_whole_segment_is_less_than_to_have_no_zero():
    (claim,) = [c for c in claims("C5.2c") if c.kind == "zero set" and c.expected == Verdict.PROVED]
    weaker = tuple(assumption("γ′×γ″ ≢ 0") if a.name == "γ′×γ″" else a for a in claim.assumes)
    assert verdict(replace(claim, assumes=weaker)) != Verdict.PROVED


def test_a_curve_that_does_not_satisfy_the_assumptions_is_no_witness():
    (claim,) = [c for c in claims("C5.2c") if c.kind == "zero set" and c.expected == Verdict.PROVED]
    finding = claim.check(example("flat_point"))
    assert finding.verdict == Verdict.INAPPLICABLE
    assert str(finding.witness).startswith("γ′×γ″ vanishes at the parameter 1/2")
    loose = tuple(a for a in claim.assumes if a.name != "γ′×γ″")
    assert replace(claim, assumes=loose).check(example("flat_point")).verdict == Verdict.REFUTED


def test_every_witness_satisfies_the_assumptions_of_its_claim():
    from exactspline.verification.evaluation import Evaluation

    met = 0
    for claim in claims():
        if claim.expected == Verdict.REFUTED and claim.kind in ("zero set", "identity", "vanishing"):
            witness = claim.prove()[1].witness
            if isinstance(witness, OnExample):
                assert not Evaluation(example(witness.name)).failing(claim.curve, claim.assumes)
                met += 1
    assert met


def test_every_assumption_fails_somewhere_or_is_checked():
    """Assumptions are not decoration: all can be checked on a curve."""
    from exactspline.verification.evaluation import Evaluation

    cusp, line, flat = (Evaluation(example(name)) for name in ("cusp", "straight_line", "flat_point"))
    assert cusp.failing("plane", [ASSUMPTIONS["γ′"]]).about[0] == ASSUMPTIONS["γ′"].subject
    assert not cusp.failing("plane", [ASSUMPTIONS["γ′ ≢ 0"], ASSUMPTIONS["w"]])
    assert line.failing("plane", [ASSUMPTIONS["[γ′ γ″] ≢ 0"]]).about[1].phrase is say.on_all_of
    assert flat.failing("space", [ASSUMPTIONS["γ′×γ″"]])
    pair = Evaluation(example("rational_space_cubic"))
    assert not pair.failing("pair", [ASSUMPTIONS[name] for name in ("w", "w̄", "γ′", "γ̄′", "[γ′ γ̄′ γ−γ̄] ≢ 0")])


def test_no_formula_is_called_like_a_denominator(also):
    """In a factor w is the denominator, whatever formula an author calls w."""
    named = also("w", lambda c: c.p[0], "plane")
    with pytest.raises(ClaimError, match="denominator in factors"):
        stated("identity", **{"curve": "plane", "left": named, "right": "f2"})
    with pytest.raises(ClaimError, match="denominator in factors"):
        stated("zero set", **{"curve": "plane", "formulas": ["f2", "f1"], "assumes": ["w ≠ 0"]})


# ---- parts


def test_zero_sets_of_vectors_compare_all_components(also):
    padded = also(
        "padded",
        lambda c: Vector(formula_of("f2")(c) * c.p[0], formula_of("f2")(c) * c.p[1], formula_of("f2")(c)),
        "plane",
    )
    shifted = also("shifted", lambda c: Vector(formula_of("f2")(c), formula_of("g2")(c)), "plane")
    claim = stated("zero set", **{"curve": "plane", "formulas": ["f2", padded], "of": "rational"})
    assert claim.check(example("rational_cubic_s")).verdict == Verdict.VERIFIED
    assert replace(claim, formulas=("f2", shifted)).check(example("rational_cubic_s")).verdict == Verdict.REFUTED


def test_a_zero_set_is_that_of_the_values(also):
    """Passed before, of the numerators as they come: x²/y and x have one zero set on (t, t³), where x²/y is 1/t."""
    padded = also("padded", lambda c: formula_of("f2")(c) * c.p[0] / c.p[0], "plane")
    claim = stated("zero set", **{"curve": "plane", "formulas": ["f2", padded]})
    assert verdict(claim) == Verdict.PROVED
    x, square = also("x", lambda c: c.p[0], "plane"), also("square", lambda c: c.p[0] * c.p[0] / c.p[1], "plane")
    cubic = Nurbs(3, [-1] * 4 + [1] * 4, [(-1, -1), ("-1/3", 1), ("1/3", -1), (1, 1)])
    for formulas in ((x, square), (square, x)):
        one = replace(claim, formulas=formulas, assumes=[assumption("w")])
        assert (one.check(cubic).verdict, verdict(one)) == (Verdict.REFUTED, Verdict.REFUTED)


def test_where_one_of_two_equal_surfaces_has_no_ruling_is_named():
    (claim,) = [c for c in claims("C6.2c") if c.kind == "same surface" and c.right == "point_bisector"]
    _, finding = claim.prove()
    assert (finding.verdict, str(finding.computed).startswith("one surface, except where ")) == (Verdict.PROVED, True)


# ---- almost all d, and sums of different degree


def test_a_claim_for_all_d_fails_if_it_fails_for_one():
    claim = degree("f2", "max(3d − 3, 2000)", of="rational")
    assert verdict(claim) == Verdict.REFUTED
    assert verdict(replace(claim, relation="≤")) == Verdict.PROVED
    assert verdict(replace(claim, relation="≥", claimed="3d − 4")) == Verdict.PROVED
    reduced = degree("f0", "3d − 6", of="rational", measure="reduced")
    assert verdict(reduced) == Verdict.REFUTED
    assert "(identically zero for d = 1)" in str(reduced.prove()[1].computed)
    assert verdict(replace(reduced, least_d=2)) == Verdict.PROVED


def test_where_a_value_vanishes_it_has_no_degree(also):
    """w [p γ‴] is 0 on curves of degree 2, where 2d − 4 is 0."""
    jerk = also("jerk", lambda c: c.w * det(c.p, c.gamma.d(3)), "plane")
    told = {"curve": "plane", "formula": jerk, "measure": "lowest terms", "of": "polynomial"}
    claim = stated("degree", **told, claimed="2d − 4", least_d=2)
    assert str(claim.prove()[1].witness) == "at d = 2: identically zero, not 0"
    assert verdict(replace(claim, relation="≥")) == Verdict.REFUTED
    assert verdict(replace(claim, relation="≤")) == Verdict.PROVED
    assert verdict(replace(claim, least_d=3)) == Verdict.PROVED


def test_zero_has_no_degree_that_a_formula_in_d_gives_it():
    """[γ′ γ″] is 0 on lines: its degree is not 2 · 1 − 4."""
    claim = degree("f2", "2d − 4", of="polynomial", measure="true")
    assert str(claim.prove()[1].witness) == "at d = 1: identically zero, not -2"
    assert verdict(replace(claim, least_d=2)) == Verdict.PROVED
    assert verdict(replace(claim, claimed="max(2d − 4, d − 2)")) == Verdict.PROVED
    assert verdict(replace(claim, claimed="max(2d − 4, 0)")) == Verdict.REFUTED
    assert verdict(replace(claim, claimed="max(2d − 4, 2000 − d)")) == Verdict.REFUTED


def test_a_claim_says_nothing_of_curves_outside_its_assumptions():
    """Neither that it is false on them, nor that it is 0 = 0."""
    (claim,) = [c for c in claims(paper="petrunin_zamora_barrera") if c.key == "PZ7c-off_the_osculating_circle"]
    found = claim.check(example("straight_cubic"))
    assert found.verdict == Verdict.INAPPLICABLE
    assert str(found.witness) == "[γ′ γ″] vanishes on a whole patch"
    without = replace(claim, assumes=()).check(example("straight_cubic"))
    assert without.verdict == Verdict.VACUOUS


def test_what_is_zero_has_no_coefficient_but_zero(also):
    third = also("third", lambda c: c.p.d(3) * c.w, "plane")
    claim = stated("coefficients", **{"curve": "plane", "formula": third, "curves": "generic", "of": "rational"})
    assert str(claim.prove()[1].witness) == "it is zero for every curve of degree 2"


def test_leading_terms_of_a_sum_of_different_degrees_keep_the_dominant_one(also):
    mixed = also("mixed", lambda c: formula_of("D1")(c)[0] + c.w, "curve")
    assert str(generic_true_degree(paper("lifted").find(mixed), 2)) == "max(2d − 2, d)"
    told = {"curve": "curve", "formula": mixed, "measure": "true", "of": "rational"}
    assert verdict(stated("degree", **told, claimed="d")) == Verdict.REFUTED
    assert verdict(stated("degree", **told, claimed="max(2d − 2, d)")) == Verdict.PROVED


# ---- bounds, and two verdicts


def test_a_curve_of_lower_degree_decides_nothing_of_the_generic_one():
    """4d − 1 is false of all curves: no curve verifies it; 4d − 2, which is true, is met by this one."""
    rows = list(audit([c for c in claims("C6.1d") if c.curve == "plane point"], [example("rational_cubic")]))
    assert [(row.claimed, str(row.computed), str(row.finding.relation), str(row.verdict)) for row in rows] == [
        ("11", "10", "=", "INAPPLICABLE"),
        ("10", "10", "=", "UNDECIDED"),  # with one point
    ]
    assert rows[0].witness is Fact.LOWER_DEGREE_HERE
    assert all(row.as_recorded for row in rows)


def test_no_row_verifies_an_equality_that_does_not_hold():
    rows = audit([c for c in claims() if c.kind == "degree"], [example("circle"), example("rational_space_cubic")])
    for row in rows:
        if row.verdict == Verdict.VERIFIED:
            claimed, computed = (
                int(text.split()[-1 if "≤" in text or "≥" in text else 0].replace("−", "-"))
                for text in (row.claimed, str(row.computed).split(" (")[0])
            )
            assert {"=": claimed == computed, "≤": computed <= claimed, "≥": computed >= claimed}[row.finding.relation]


def test_a_contradiction_between_readings_is_an_alarm(monkeypatch):
    """The whole run ended, before, and no other row was given; the proof stood where it was printed first."""
    false = replace(claims("C4.1a")[0], factor="w^2")
    assert one_verdict(false).verdict == Verdict.REFUTED
    honest = type(false).decide

    def fooled(self, dimension, polynomial):
        found = honest(self, dimension, polynomial)
        return replace(found, verdict=Verdict.PROVED) if self.factor == "w^2" else found

    monkeypatch.setattr(type(false), "decide", fooled)
    (row,) = audit([false], [example("rational_cubic")])
    assert (row.verdict, row.as_recorded) == (Verdict.CONTRADICTION, False)
    found = one_verdict(false)
    assert found.verdict == Verdict.CONTRADICTION
    assert str(found.witness).startswith("proved for all curves, but refuted: on the example curve")
    # a proof that contradicts a curve is an alarm also where the record expects the refutation
    rows = list(audit([replace(false, expected=Verdict.REFUTED, error="span"), claims("C4.1a")[1]]))
    own = [row for row in rows if row.key == false.key]
    assert (own[0].curve, own[0].verdict) == ("", Verdict.CONTRADICTION)
    assert {row.verdict for row in own[1:]} >= {Verdict.CONTRADICTION, Verdict.VERIFIED}
    assert all(row.as_recorded for row in rows if row.key != false.key)


def test_vacuous_rows_are_on_record():
    (claim,) = [c for c in claims("C4.1a") if c.right == "f2" and c.left == "f1"]
    assert "straight_line" in claim.vacuous
    (row,) = audit([replace(claim, vacuous=())], [example("straight_line")])
    assert (row.verdict, row.as_recorded) == (Verdict.VACUOUS, False)
    (row,) = audit([replace(claim, vacuous=("circle",))], [example("circle")])
    assert (row.verdict, row.as_recorded) == (Verdict.VERIFIED, False)


def test_what_is_proved_of_the_generic_curve_is_met_by_an_example():
    """Were every curve told to be of lower degree, nothing would be verified and every row would be as recorded."""
    generic = [
        c
        for c in claims()
        if c.kind == "degree" and c.measure.is_generic and c.relation == "=" and c.expected == "PROVED"
    ]
    rows = audit(generic, map(example, examples("curves")))
    met = {row.key for row in rows if row.verdict == Verdict.VERIFIED or row.finding.reason == "tried on a part"}
    spoken_of = [
        c for c in generic if any(c.applies_to(example(n).dimension, example(n).polynomial) for n in examples("curves"))
    ]
    assert spoken_of
    assert [c.key for c in spoken_of if c.key not in met] == []


def test_a_wrong_degree_is_shown_where_the_degree_is_the_usual_one(tmp_path):
    """The witness against 2d − 5 was the exceptional d = 1: "−1, not −3", beside "(0 for d = 1)"."""
    text = """
id = "9"
kind = "degree"
of = "polynomial"
statement = "the degree of the turning"
formula = "turning"
claimed = "2d - 5"
measure = "lowest terms"
"""
    folder = new_paper(tmp_path / "mine")
    with (folder / "claims.toml").open("a", encoding="utf-8") as file:
        file.write(f"\n[[claim]]{text}")
    claim = next(each for each in claims(paper=paper(folder)) if each.id == "9")
    finding = claim.prove()[1]
    assert finding.verdict == Verdict.REFUTED
    assert str(finding.witness) == "at d = 3: 2, not 1"
    assert "polynomial" in claim.assumed
