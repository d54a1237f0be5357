"""What the judge tells beside its verdicts, and the cases in which it has no witness: each held against the definition,
found by changes of the code that no other test noticed.
"""

from dataclasses import replace

import pytest
from gmpy2 import mpq

from exactspline import Nurbs, TensorSpline, Verdict, claims, decide, example, formula_of, paper, verify
from exactspline.errors import ClaimError, FormulaError
from exactspline.language import Vector, formula, ruled
from exactspline.language.ruled import split
from exactspline.readings import parse_degree, trace
from exactspline.readings.jet import RationalJetReading
from exactspline.symbolic.assumptions import Assumption
from exactspline.tables import patch_table, table_1_splines
from exactspline.verification import phrases as say
from exactspline.verification.decision import DirectrixOf, Equation
from exactspline.verification.divisors import divided_by, divisors
from exactspline.verification.evaluation import Evaluation, on_segments
from exactspline.verification.evidence import At, DegreeFound, Evidence, ExactQuotient, Fact, OnExample
from exactspline.verification.judges import agreed
from exactspline.verification.kinds.degree import held_against
from exactspline.verification.kinds.types import on_cubics
from exactspline.verification.statement import check, true_relation
from exactspline.verification.verdict import Finding
from tests.support.claims import one_verdict
from tests.verification.test_own_paper import plane_formulas, written

FORMULAS = plane_formulas(
    f="det(c.p, c.p.d(1))",
    g="2 * det(c.p, c.p.d(1))",
    half="det(c.p, c.p.d(1)) / 2",
    point="c.p / c.w",
    velocity="(c.p / c.w).d(1)",
    acceleration="(c.p / c.w).d(2)",
    lifted_velocity="c.w * c.p.d(1) - c.p * c.w.d(1)",
    ninth="c.p.d(9)",
    square="c.p[0] * c.p[0]",
    first="c.p[0] * c.w",
    abscissa="c.p[0] / c.w",
    gamma="c.gamma * 1",
    three="join(c.p[0] / c.w, c.p[1] / c.w, c.w / c.w)",
    below="0 - c.p[0] * c.p[0]",
    mixed="c.p[0] + c.p[0].d(1)",
)
#: What takes long wherever all formulas are asked for.
LARGE = plane_formulas(large="c.w / (c.p[0] + c.p[1] + c.w + c.p[0].d(1) + c.p[1].d(1) + c.w.d(1))**60")


#: The kinds of arguments.
ON_CURVE, ON_POINT, ON_PAIR = (formula("a test", on=name)(abs).kind for name in ("curve", "plane point", "pair"))


@pytest.fixture
def claimed(tmp_path):
    """A claim about formulas of a plane curve."""

    def made(**entry):
        formulas = FORMULAS + LARGE * ("large" in entry.values())
        folder = written(tmp_path / "p", formulas, [{"id": "1", "statement": "said", "curve": "plane"} | entry])
        (claim,) = claims(paper=paper(folder))
        return claim

    return made


def two_pieces(first, second):
    """A curve of two quadratic segments on [0, 1] and [1, 2]."""
    return Nurbs(2, [0, 0, 0, 1, 1, 1, 2, 2, 2], [*first, *second])


PARABOLA = Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), ("1/2", 0), (1, 1)])


# ---- two judges


@pytest.mark.parametrize("own", [Verdict.PROVED, Verdict.REFUTED])
def test_a_contradiction_names_who_proves_who_refutes_and_where(own):
    other = Verdict.REFUTED if own is Verdict.PROVED else Verdict.PROVED
    findings = [Finding(v, witness=At(mpq(1)) if v is Verdict.REFUTED else Fact.NOTHING) for v in (own, other)]
    one, two = "one", "two"
    found = agreed(findings[0], one, findings[1], two)
    named = (one, two) if own is Verdict.PROVED else (two, one)
    assert (found.verdict, found.witness) == (Verdict.CONTRADICTION, say.judges_disagree(*named, At(mpq(1))))


# ---- equalities


def test_a_false_factor_has_the_true_one_as_its_witness(claimed):
    false, true = [claimed(kind="identity", left="f", right="g", factor=k).prove()[1] for k in ("3", "1/2")]
    assert (false.verdict, true.verdict) == (Verdict.REFUTED, Verdict.PROVED)
    assert isinstance(false.witness, ExactQuotient)
    assert str(false.factor) == str(true.factor) == "1/2"
    assert true.witness is None


def test_what_vanishes_on_all_examples_is_refuted_by_the_polynomial(claimed):
    """No example curve has a ninth derivative that is not zero."""
    found = claimed(kind="vanishing", left="ninth").prove()[1]
    assert (found.verdict, found.witness) == (Verdict.REFUTED, Fact.POLYNOMIAL_NOT_ZERO)
    found = claimed(kind="vanishing", left="f").prove()[1]
    assert isinstance(found.witness, OnExample)


def test_a_side_that_is_no_ruled_surface_is_named(tmp_path):
    formulas = "@formula('e', on='space')\ndef f(c):\n    return c.p * 1\n"
    formulas += "@formula('e', on='space')\ndef g(c):\n    return ruled(c.p * 1, c.p.d(1))\n"
    for left, right in (("f", "g"), ("g", "f")):
        entry = {"id": "1", "statement": "said", "kind": "same surface", "curve": "space", "left": left, "right": right}
        (claim,) = claims(paper=paper(written(tmp_path / "p", formulas, [entry])))
        with pytest.raises(FormulaError, match="'f' is not a ruled surface"):
            claim.prove()


def plane_and_space(plane, x, y, z):
    """A plane curve, and a ruled surface with a directrix, as a statement."""
    left = formula("a test", on="plane point")(plane)
    right = formula("a test", on="point")(lambda c: ruled(Vector(x(c), y(c), z(c)), c.p * 1))
    return DirectrixOf(left, right)


def zero(c):
    return c.w - c.w


@pytest.mark.parametrize("order", [(0, 1), (1, 0)])
def test_a_curve_is_no_directrix_where_one_coordinate_differs(order):
    """Where the curve is the origin, a directrix that is not 0 in x or in y is another curve; of the origin
    twice nothing is said.
    """
    c = RationalJetReading(1).argument(ON_POINT, 2)
    coordinates = [zero, lambda c: c.w * 1]
    x, y = (coordinates[k] for k in order)
    origin = lambda c: Vector(zero(c), zero(c))  # noqa: E731
    assert plane_and_space(origin, x, y, zero).decide(c).verdict == Verdict.REFUTED
    assert plane_and_space(origin, zero, zero, zero).decide(c).verdict == Verdict.VACUOUS
    own = lambda c: Vector(c.p[0], c.p[1])  # noqa: E731
    same = plane_and_space(own, lambda c: c.p[0], lambda c: c.p[1], zero)
    assert same.decide(c).verdict == Verdict.PROVED
    assert all(x.is_zero for x in same.residues(c))
    other = plane_and_space(own, lambda c: c.p[order[0]], lambda c: c.p[order[1]], zero)
    assert all(x.is_zero for x in other.residues(c)) == (order == (0, 1))


def test_what_remains_of_an_equation_vanishes_exactly_where_it_holds():
    c = RationalJetReading(3).argument(ON_CURVE, 2)
    for factor, holds in (("w", True), ("w^2", False), ("w^-1", False)):
        rest = Equation(formula_of("f1"), formula_of("f2"), factor).residues(c)
        assert all(x.is_zero for x in rest) is holds
    assert all(x.is_zero for x in Equation(formula_of("f2"), formula_of("f1"), "w^-1").residues(c))


@pytest.mark.parametrize(
    ("left", "right"), [("c.p * 1", "ruled(c.p.d(2), c.p.d(1))"), ("c.p.d(2) * 1", "ruled(c.p * 1, c.p * 2)")]
)
def test_a_curve_and_a_surface_of_different_orders_are_compared(tmp_path, monkeypatch, left, right):
    formulas = f"@formula('e', on='plane point')\ndef f(c):\n    return {left}\n"
    formulas += f"@formula('e', on='point')\ndef g(c):\n    return {right}\n"
    entry = {"id": "1", "statement": "said", "kind": "iso-curve", "curve": "plane point", "left": "f", "right": "g"}
    (claim,) = claims(paper=paper(written(tmp_path / "p", formulas, [entry])))
    found = claim.prove()[1]
    assert found.verdict == Verdict.REFUTED
    assert isinstance(found.witness, OnExample)
    # without an example that shows it, the difference for all curves is the witness
    monkeypatch.setattr(type(claim), "refuted_on_examples", lambda self: Finding(Verdict.UNDECIDED))
    assert claim.prove()[1].witness == Fact.CURVES_DIFFER


# ---- where


def test_the_parameter_of_a_witness_lies_in_its_segment():
    """Two values that differ for two values of a free operand, and one that vanishes where its segment begins."""
    line = Nurbs(1, [0, 0, 1, 3, 3], [(0, 0, 0), (1, 0, 0), (2, 5, 0)])
    segments = list(on_segments(ON_PAIR, line, 1))
    for segment in segments:
        bar = segment.argument.second.p
        at = segment.place(bar[0] - bar[1])
        assert isinstance(at, At)
        assert segment.low < at.parameter < segment.high
    at = segments[1].place(segments[1].argument.first.p[1])  # 5/2 (s − 1), zero at s = 1
    assert isinstance(at, At)
    assert 1 < at.parameter < 3


def test_a_negative_value_is_found_in_its_segment(claimed):
    """x w is negative on the first third of the second segment only; a square may vanish."""
    curve = two_pieces([(1, 0), (1, 1), (0, 0)], [(0, 0), (-1, 1), (4, 0)])
    found = claimed(kind="sign", formula="first").examine(curve, Evaluation(curve))
    assert found.verdict == Verdict.REFUTED
    assert isinstance(found.witness, At)
    assert 1 < found.witness.parameter < 2
    assert curve(found.witness.parameter)[0] < 0
    for sign, verdict in (("≥ 0", Verdict.VERIFIED), ("> 0", Verdict.REFUTED)):
        told = claimed(kind="sign", formula="square", sign=sign).examine(PARABOLA, Evaluation(PARABOLA))
        assert told.verdict == verdict


def test_an_assumption_about_a_pair_fails_on_one_patch():
    """Passed by a mutant: what vanishes on one of two patches "vanishes on none"."""
    curve = two_pieces([(0, 0), (1, 2), (2, 0)], [(2, 0), (3, 1), (5, 0)])

    def net(*values):
        return TensorSpline((1, 1), [0, 0, 1, 1, 2, 2], [0, 0, 1, 1], [[x, x] for x in values])

    def failing(spline, **options):
        told = Assumption("a", "a", "a", "a", lambda _: spline, ("pair",), **options)
        found = Evaluation(curve).failing("plane pair", [told])
        return found if found is None else found.about[1]

    assert failing(net(1, 2, 0, 0), everywhere=False) == say.on_whole_patch()
    assert failing(net(1, 2, 1, 0), everywhere=False) is None


def test_what_has_no_zero_has_none_for_any_other_parameter():
    """Before, a polynomial in both parameters "had no zero" when it had none on a line in the middle. 2(s + t − st) − 1
    is s on the line t = 1/2, and −1 at s = t = 0.
    """
    unit = [0, 0, 1, 1]
    curve = Nurbs(1, unit, [(0, 0), (1, 2)])
    both = TensorSpline((1, 1), unit, unit, [[-1, 1], [1, 1]])
    alone = TensorSpline((1, 1), unit, unit, [[-1, -1], [1, 1]])
    places = {}
    for name, spline in (("both", both), ("first", alone), ("positive", both + 2)):
        told = Assumption(name, "a", "a", "a", lambda _, spline=spline: spline, ("pair",))
        found = Evaluation(curve).failing("plane pair", [told])
        places[name] = found and found.about[1]
    assert places == {"both": say.on_patch(0, 0), "first": At(mpq(1, 2)), "positive": None}


# ---- invariance


@pytest.mark.parametrize(
    ("entry", "verdict"),
    [
        ({"formula": "point", "under": "translation", "nature": "point"}, Verdict.PROVED),
        ({"formula": "point", "under": "projective map", "nature": "point"}, Verdict.PROVED),
        ({"formula": "gamma", "under": "projective map", "nature": "point"}, Verdict.PROVED),
        ({"formula": "velocity", "under": "projective map", "nature": "point"}, Verdict.REFUTED),
        ({"formula": "velocity", "under": "translation", "nature": "vector"}, Verdict.PROVED),
        ({"formula": "velocity", "under": "translation", "nature": "point"}, Verdict.REFUTED),
        ({"formula": "velocity", "under": "rotation", "nature": "vector"}, Verdict.PROVED),
        ({"formula": "velocity", "under": "reparametrization", "weight": 1}, Verdict.PROVED),
        ({"formula": "acceleration", "under": "reparametrization", "weight": 2}, Verdict.REFUTED),
        ({"formula": "lifted_velocity", "under": "common factor", "weight": 2}, Verdict.PROVED),
        ({"formula": "lifted_velocity", "under": "common factor", "weight": 1}, Verdict.REFUTED),
    ],
)
def test_what_a_change_of_the_curve_does(claimed, entry, verdict):
    """The acceleration has no weight: a change of parameter with ρ′ ≠ 0 adds a multiple of the velocity."""
    for of in ("both", "polynomial", "rational"):
        assert claimed(kind="invariance", of=of, **entry).prove()[1].verdict == verdict


@pytest.mark.parametrize("under", ["projective map", "Möbius map", "reparametrization", "common factor"])
def test_what_moves_no_vector_is_refused(claimed, under):
    refused = claimed(kind="invariance", formula="velocity", under=under, nature="vector")
    assert refused.kind == "not asked"
    assert "is not linear" in refused.why or "moves nothing" in refused.why


@pytest.mark.parametrize("nature", ["point", "vector"])
@pytest.mark.parametrize("formula", ["first", "abscissa", "three"])
def test_a_point_has_as_many_components_as_the_space(claimed, nature, formula):
    """Before, x/w alone "moves like a point" under translations: PROVED, and VERIFIED on every curve; three components
    were a KeyError.
    """
    claim = claimed(kind="invariance", formula=formula, under="translation", nature=nature)
    for verdict_of in (claim.prove, lambda: claim.check(PARABOLA)):
        with pytest.raises(ClaimError, match=f"component.*, a {nature} has 2"):
            verdict_of()


# ---- degrees, counts, types


def test_a_quotient_has_no_true_degree_on_any_curve(claimed):
    """Before, "the true degree of x/w is 3" was refused for all curves and VERIFIED on a rational cubic."""
    claim = claimed(kind="degree", formula="abscissa", claimed="d", measure="true")
    for verdict_of in (claim.prove, lambda: claim.check(example("rational_cubic_s")), lambda: claim.check(PARABOLA)):
        with pytest.raises(FormulaError, match="abscissa is a quotient"):
            verdict_of()


def test_a_lower_degree_than_the_bound_is_within_it():
    """A parabola has a lower degree than the generic curve: that refutes no equation, and fulfils a bound."""
    (claim,) = claims("L12-f0")
    for relation, verdict in (("=", Verdict.INAPPLICABLE), ("≤", Verdict.VERIFIED)):
        one = replace(claim, relation=relation, claimed="9d", of="both")
        assert one.examine(PARABOLA, Evaluation(PARABOLA)).verdict == verdict


def test_a_bound_may_fail_at_an_exception_alone():
    """2d − 2 against max(d − 1, 3d − 5): 0 ≤ 0, 2 > 1, 4 ≤ 4, …; where the degree at d = 2 is 1, the bound holds."""
    (claim,) = claims("L12-f0")
    one = replace(claim, relation="≤", claimed="max(d-1, 3d-5)", of="both", least_d=1)
    found = DegreeFound(parse_degree("2d-2"))
    assert held_against(one, found, {2: 1}).verdict == Verdict.PROVED
    assert held_against(one, found, {2: 2}).verdict == Verdict.REFUTED
    assert held_against(one, found).verdict == Verdict.REFUTED


def test_a_curve_without_joints_has_no_continuity():
    (claim,) = claims("Fig2-g2-both")
    one = replace(claim, claimed="2 true continuity")
    assert one.examine(PARABOLA, Evaluation(PARABOLA)).computed is Fact.NO_JOINT


def test_the_type_of_a_unit_vector():
    """On the twisted cubic its root is no rational function. In a plane in space the root of ‖γ′×γ″‖² is a number or a
    polynomial, and the roots decide nothing.
    """
    (claim,) = claims("E13-unit_tangent")
    flat = Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0, 0), ("1/2", 0, 0), (1, 1, 0)])
    bent = Nurbs(3, [0] * 4 + [1] * 4, [(0, 0, 0), (1, 0, 0), (2, 1, 0), (3, 5, 0)])
    for curve, verdict in (
        (example("twisted_cubic"), Verdict.VERIFIED),
        (flat, Verdict.UNDECIDED),
        (bent, Verdict.UNDECIDED),
    ):
        assert claim.examine(curve, Evaluation(curve)).verdict == verdict


def test_functions_that_stand_for_a_table_are_not_proportional():
    """The quotient of two of their derivatives varies."""
    c = RationalJetReading(2).argument(ON_CURVE, 2)
    (value,) = split(c.p[0].d(1) / c.p[1].d(1))[0]
    assert not on_cubics(value).bottom.is_constant()


# ---- divisors


def test_a_divisor_that_is_too_large_is_named(claimed):
    """Nothing is known of its factors."""
    (text,) = divisors(claimed(kind="vanishing", left="large"))
    assert text.endswith("⁶⁰")


def test_numbers_are_no_divisors():
    half, quotient = (formula("a test", on="curve")(f) for f in (lambda c: c.w / 2, lambda c: c.p[0] / c.w / 2))
    assert [*divided_by(trace(half, 2))] == []
    assert len([*divided_by(trace(quotient, 2))]) == 1


# ---- parts that are said of all curves


@pytest.mark.parametrize("height", ["-1", "0"])
def test_what_is_not_homogeneous_has_no_height_that_is_known(claimed, height):
    """Passed before: x + x′ has the height −1, as if it were zero; any other one was refuted, "identically zero"."""
    claim = claimed(kind="degree", formula="mixed", measure="height", claimed=height)
    assert decide(claim).verdict == Verdict.UNDECIDED


def test_a_height_is_known_of_what_is_homogeneous(claimed):
    verdicts = [decide(claimed(kind="degree", formula="f", measure="height", claimed=x)).verdict for x in ("0", "1")]
    assert verdicts == [Verdict.PROVED, Verdict.REFUTED]


@pytest.mark.parametrize(("formula", "sign"), [("below", "≤ 0"), ("square", "≥ 0")])
def test_a_sign_is_that_of_the_squares(claimed, formula, sign):
    """A mutant passed: any polynomial less than or equal to 0, as 0 times it is not negative."""
    for said in ("≤ 0", "≥ 0", "< 0", "> 0"):
        claim = claimed(kind="sign", formula=formula, sign=said, squares=["abscissa"], factor="w^2")
        assert (decide(claim).verdict == Verdict.PROVED) == (said == sign)
        assert (claim.examine(PARABOLA, Evaluation(PARABOLA)).verdict == Verdict.VERIFIED) == (said == sign)


def test_evidence_is_a_value_that_cannot_be_changed():
    class Made(Evidence):
        number: int

    made = Made(3)
    assert made == Made(3)
    with pytest.raises(AttributeError, match="cannot assign"):
        made.number = 4


def test_a_check_says_that_its_paper_is_trusted(tmp_path):
    folder = written(
        tmp_path / "p", FORMULAS, [{"id": "1", "statement": "x", "kind": "vanishing", "curve": "plane", "left": "f"}]
    )
    for trust in (False, True):
        (claim,) = claims(paper=paper(folder, trust=trust))
        assert any("trust=True" in line for line in check(claim)) == trust


def test_the_true_relation_is_known_where_the_factor_is():
    (printed,), (other,) = claims("C42b-g1-g0"), claims("C43c-signed_curvature-inverted_curvature")
    relation = true_relation(printed, one_verdict(printed))
    assert relation is not None
    assert str(relation.factor) == "w⁸"
    assert true_relation(other, one_verdict(other)) is None


def test_the_words_of_a_question_name_both_formulas_and_what_is_counted():
    answer = verify("f1", "f2", example("rational_cubic"), "w")
    assert (answer.left, answer.right) == ("f1", "f2")
    with pytest.raises(FormulaError, match=r"no formula of surfaces among f2 \(plane\)"):
        patch_table([formula_of("f2")], (2, 2))


def test_rows_of_degrees_say_what_they_count():
    first, second = (operands.knots for operands in (table_1_splines(2, 3).p1, table_1_splines(2, 3).p2))
    assert [*first] == [0, 0, 0, 1, 2, 3, 3, 3]
    assert [*second] == [0, 0, 0, 0, mpq(1, 2), 2, 2, 3, 3, 3, 3]
