"""The parts of claims, each on small cases: what they assume, what they refuse, what is tried where."""

import json
from dataclasses import replace
from time import perf_counter

import pytest

from exactspline import BSpline, Nurbs, Verdict, claims, decide, example, prove, reduction
from exactspline.errors import ClaimError, FormulaError
from exactspline.language import Rational, Vector, join
from exactspline.verification import judges
from exactspline.verification.divisors import divisors
from exactspline.verification.evaluation import Evaluation, with_hodograph
from exactspline.verification.ledger import audit
from exactspline.verification.statement import check, unrecorded
from tests.support.claims import claim, lent, stated
from tests.support.command import invoke


def first(kind, curve=None, paper=None):
    """The first claim of a kind, on a kind of curve."""
    return next(c for c in claims(paper=paper) if c.kind == kind and curve in (None, c.curve))


def offset_claim(**changes):
    one = next(c for c in claims(paper="levien_parallel_curves") if c.curve == "plane with delta" and not c.assumes)
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
    one = first("contact", paper="petrunin_zamora_barrera")
    if fits:
        assert replace(one, order=order).order == order
    else:
        with pytest.raises(ClaimError):
            replace(one, order=order)


@pytest.mark.parametrize("formulas", [(), ("f1",), ("f1", "f1"), ("f1", "f2", "f1")])
def test_a_zero_set_is_compared_with_another(formulas):
    one = first("zero set", "plane")
    with pytest.raises(ClaimError):
        replace(one, formulas=formulas)
    assert replace(one, formulas=("f1", "f2")).formulas == ("f1", "f2")


@pytest.mark.parametrize("dimension", [2, 3])
def test_coefficients_are_those_of_polynomials_in_every_dimension(monkeypatch, dimension):
    partly = lent(monkeypatch, "partly", lambda c: c.p / c.w if len(c.p) == dimension else c.p * 1, "curve")
    with pytest.raises(ClaimError, match="quotient"):
        stated("coefficients", curve="curve", formula=partly)


# ---- what is said


@pytest.mark.parametrize(
    ("value", "verdict"),
    [
        (lambda c: c.w * c.p.d(1) - c.p * c.w.d(1), Verdict.PROVED),
        (lambda c: c.p * c.w, Verdict.UNDECIDED),
        (lambda c: c.p * c.w + c.p[0] * c.p * c.w, Verdict.UNDECIDED),
    ],
)
def test_a_reading_that_does_not_apply_decides_nothing(monkeypatch, value, verdict):
    """That of single terms: of what is linear in p and in w; a product of both has none."""
    name = lent(monkeypatch, "made", value, "plane")
    one = stated("coefficients", curve="plane", formula=name, curves="generic", of="rational")
    assert decide(one).verdict == verdict


def test_coefficients_of_the_generic_polynomial_curve_are_computed():
    """p is linear in p alone: what is proved for w of degree d does not hold for w = 1."""
    one = next(c for c in claims() if c.kind == "coefficients" and c.curves != "every curve")
    told = one.decide(2, polynomial=True)
    assert (told.verdict, told.reason) == (Verdict.UNDECIDED, "tried on a part")
    assert str(told.computed) == ("none vanishes for d = 2…6")


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


def test_no_factor_is_printed_over_roots_or_of_what_vanishes():
    for one in claims():
        if one.kind == "identity" and one.curve.startswith("framed"):
            assert "; print(claim." in check(one)[-1]
    nothing = first("vanishing", "plane").left
    assert "; print(claim." in check(replace(first("identity", "plane"), right=nothing))[-1]


def test_minimal_forms_are_told_with_their_grading():
    """k, m and j of the polynomial in lowest terms; none of a quotient."""
    told = json.loads(invoke("formula", "degrees", "evolute", "--curve", "rational_cubic", "--json").stdout)["rows"]
    assert told[0]["text"] == "γ + ‖γ′‖²/f0 γ′⊥"
    gradings = {row["variant"]: row["grading"] for row in told}
    assert gradings.pop("minimal") == "6, 3, 0"
    assert {*gradings.values()} == {"–"}


def test_a_curve_with_the_name_of_an_example_is_none():
    """On a line f1 = w f2 says nothing, which is on record for no example: there it would be an alarm."""
    one = claim("C41a-f1-f2")
    line = Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 1)], name="circle")
    (told,) = audit([one], [line])
    assert told.verdict == Verdict.VACUOUS
    assert told.as_recorded
    (own,) = audit([one], [example("circle")])
    assert (own.verdict, own.expected) == (Verdict.VERIFIED, (Verdict.VERIFIED,))


# ---- what a text states


def test_a_text_states_an_identity():
    assert prove("f1 = w * f2").holds
    assert prove("f1 = w · f2").holds
    assert not prove("f1 = f2").holds
    for said in ("f1", "f1 =", "= f2", "", "f1 = f2 = f1", "="):
        with pytest.raises(FormulaError, match="states no identity"):
            prove(said)
    with pytest.raises(FormulaError) as told:
        prove("f1 = nothing_known")
    assert "'nothing_known'" in str(told.value)
    assert "':nothing_known'" not in str(told.value)


def test_continuity_is_that_of_the_least_continuous_component(monkeypatch):
    smooth = BSpline(2, [0, 0, 0, 1, 2, 2, 2], [0, 1, 0, 2])
    corner = BSpline(2, [0, 0, 0, 1, 1, 2, 2, 2], [0, 1, 5, 0, 2])
    hidden = BSpline(2, [0, 0, 0, 1, 1, 2, 2, 2], [1, 1, 1, 1, 1])
    one = first("count")
    for parts, nominal, true in (
        ((smooth, corner), 0, 0),
        ((corner, smooth), 0, 0),
        ((smooth, smooth), 1, 1),
        ((smooth, hidden), 0, 1),
    ):
        made = lent(monkeypatch, "made", lambda c, parts=parts: Vector(*parts), "curve", source=one.paper)
        said = replace(one, formula=made, claimed=f"degree 2, {nominal} nominal continuity, {true} true continuity")
        own = Evaluation(example(one.example))
        assert said.examine(own.argument(one.curve), own).verdict == Verdict.VERIFIED
        other = replace(said, claimed=f"{nominal + 1} nominal continuity")
        assert other.examine(own.argument(one.curve), own).verdict == Verdict.REFUTED


def test_a_formula_is_missing_where_its_denominator_vanishes_on_one_segment():
    """The first segment is one point: γ′ = 0 there."""
    curve = Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 2], [(0, 0), (0, 0), (0, 0), (1, 2), (3, 1)])
    own, gone = Evaluation(curve), 0
    for one in [c for c in claims() if c.curve == "plane" and c.named]:
        values = [one.find(name)(own.argument("plane")) for name in one.named]
        nowhere = [v for v in values if isinstance(v, Rational) and v.denominator.vanishes_somewhere]
        assert bool(one.missing(own.argument("plane"))) is bool(nowhere)
        gone += bool(nowhere)
        if nowhere:
            assert one.missing(own.argument("plane")).about[0] in one.named
    assert gone > 3


def test_the_time_of_a_row_is_what_it_took():
    one = claim("C41a-f1-f2")
    start = perf_counter()
    rows = [decide(one), judges.second_opinion(judges.Sympy(), decide(one)), *audit([one], [example("circle")])]
    assert all(0 < each.seconds < perf_counter() - start for each in rows)


def test_nothing_is_assumed_of_two_curves():
    pair = next(c for c in claims() if c.of_pair and c.named)
    with pytest.raises(ClaimError, match="is not a function of one curve alone"):
        replace(pair, assumes=("bisector_determinant_symmetric ≠ 0",))
    plane = next(c for c in claims() if c.curve == "plane" and c.named)
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


def with_formula(monkeypatch, one, value, kind="curve"):
    return replace(one, formula=lent(monkeypatch, "made", value, kind, source=one.paper))


def test_a_vector_with_a_component_that_vanishes_is_no_zero(monkeypatch):
    value = lambda c: join(c.p[0], 0 * c.p[0], c.p[1])  # noqa: E731
    one = next(c for c in claims() if c.kind == "coefficients" and c.curves != "every curve")
    told = with_formula(monkeypatch, one, value).decide(2, polynomial=True)
    assert (told.verdict, told.reason) == (Verdict.UNDECIDED, "tried on a part")
    zero = lambda c: join(0 * c.w, 0 * c.w)  # noqa: E731
    assert with_formula(monkeypatch, one, zero).decide(2, polynomial=True).verdict == Verdict.REFUTED
    other = first("existence")
    for made, verdict in ((value, Verdict.REFUTED), (zero, Verdict.VACUOUS)):
        own, again = made, lambda c, made=made: made(c)
        names = [lent(monkeypatch, *named, "curve", source=other.paper) for named in (("own", own), ("again", again))]
        assert replace(other, formula=names[0], definition=names[1]).decide(2, polynomial=False).verdict == verdict


def test_zero_sets_depend_on_assumptions():
    """Passed before: no claim in lowest terms was proved, and none that is undecided said why."""
    one = replace(first("zero set", "plane"), formulas=("f1", "f2"))
    assert replace(one, assumes=("w",)).decide(2, False).verdict == Verdict.PROVED
    found = replace(one, assumes=()).decide(2, False)
    assert (found.verdict, str(found.witness)) == (Verdict.UNDECIDED, "w may have zeros: assume w")


def test_squares_are_those_of_one_curve():
    one = first("square class")
    pair = {"formula": "bisector_determinant_symmetric", "right": "bisector_determinant", "of": "both"}
    with pytest.raises(ClaimError, match="not decided"):
        replace(one, curve="pair", **pair)
    with pytest.raises(ClaimError, match="one formula"):
        replace(one, right=one.formula)


def test_the_degrees_of_formulas_are_told_of_rational_and_polynomial_curves():
    rows = json.loads(
        invoke(*["formula", "degrees", "--paper", "lifted", "--generic", "evolute_lifted", "--json"]).stdout
    )["rows"]
    assert [row["curves"] for row in rows] == ["rational", "polynomial"]
    lowest = [reduction("evolute_lifted", polynomial=world).main.generic_lowest for world in (False, True)]
    assert [row["lowest"] for row in rows] == [str(degree) for degree in lowest]
    assert rows[0]["nominal"] != rows[1]["nominal"]


def test_an_iso_curve_that_does_not_exist_on_one_segment_says_nothing():
    """The first of two segments is one point, where γ′ = 0."""
    one = first("iso-curve")
    curve = Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 2], [(0, 0), (0, 0), (0, 0), (1, 2), (3, 1)])
    own = Evaluation(curve)
    assert one.examine(own.argument(one.curve), own).verdict == Verdict.VACUOUS
    whole = Evaluation(example("rational_cubic"))
    assert one.examine(whole.argument(one.curve), whole).verdict == Verdict.VERIFIED


#: Where nothing is said of contact.
SINGULAR = "as a function of the point at s̄ it is singular where the points meet: it defines no object there"


@pytest.mark.parametrize("power", [2, 4, 6])
def test_a_power_of_a_difference_has_no_contact(monkeypatch, power):
    """Passed before: the plane x = x(s), counted several times, has contact of any order with every curve."""
    one = first("contact", paper="petrunin_zamora_barrera")
    value = lambda c: (c.second.p[0] * c.first.w - c.first.p[0] * c.second.w) ** power  # noqa: E731
    one = with_formula(monkeypatch, one, value, one.curve)
    for order, relation in ((power - 1, "="), (power - 1, "≥"), (power, "≥"), (0, "≥")):
        found = replace(one, order=order, relation=relation).decide(one.dimensions[0], False)
        assert (found.verdict, str(found.witness)) == (Verdict.UNDECIDED, SINGULAR)


@pytest.mark.parametrize(
    ("order", "relation", "verdict"), [(0, "=", Verdict.PROVED), (0, "≥", Verdict.PROVED), (1, "≥", Verdict.REFUTED)]
)
def test_a_plane_through_the_point_has_contact_of_order_0(monkeypatch, order, relation, verdict):
    one = first("contact", paper="petrunin_zamora_barrera")
    value = lambda c: c.second.p[0] * c.first.w - c.first.p[0] * c.second.w  # noqa: E731
    one = with_formula(monkeypatch, one, value, one.curve)
    found = replace(one, order=order, relation=relation).decide(one.dimensions[0], False)
    assert found.verdict == verdict


def test_a_claim_on_formulas_in_two_dimensions_divides_by_those_that_it_speaks_of():
    """The right side of an iso-curve is handed the curve in space."""
    assert {divisors(c) for c in claims() if c.kind == "iso-curve"} == {()}
