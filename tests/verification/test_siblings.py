"""One taken for all: values at one sample, the first of several, an error that ends more than what it is about."""

import pytest
from gmpy2 import mpq

import exactspline as xs
from exactspline import BSpline, Nurbs, Verdict, claims, decide, formula_of, paper
from exactspline.bivariate.across_borders import Place
from exactspline.bivariate.common_zeros import CommonZero
from exactspline.errors import FormulaError, ReachError
from exactspline.geometry.surfaces.umbilics import Umbilic, merged_umbilic
from exactspline.language.operand import Parameter
from exactspline.numbers.intervals import Box, Interval
from exactspline.polynomials import factors
from exactspline.polynomials.cost import Budget
from exactspline.verification import combined, generic_proof
from exactspline.verification.degree_tables import construction_table, formula_degrees
from exactspline.verification.ledger import audit
from tests.support.command import run
from tests.support.squares import parameters
from tests.verification.test_own_paper import plane_formulas, written

S, T = parameters()


def of_pairs(parameter):
    """A degree claim about two curves, whose own formula is not asked."""
    claim = next(c for c in claims() if c.kind == "degree" and c.curve == "pair")
    claim = claim.__class__.__new__(claim.__class__)
    vars(claim).update(parameter=parameter)
    return claim


@pytest.mark.parametrize(("parameter", "degree"), [(Parameter.FIRST, 1), (Parameter.SECOND, 1)])
def test_a_degree_in_lowest_terms_is_not_taken_at_one_value(parameter, degree):
    """Passed before: (s − t)/(s − 2/7) has the degree 0 in s, as it has for t = 2/7, the value that was tried."""
    value = (S - T) / (S - mpq(2, 7))
    claim = of_pairs(parameter)
    assert claim._lowest(value) == degree
    assert claim._lowest((S - T) * (S + 1) / ((S + 1) * (S - 3))) == degree
    assert claim._lowest((S - T) * (T + 1) / (T + 1)) == degree
    assert claim._lowest((S - S) / (S + 1)) == -1


def test_an_umbilic_of_two_kinds_is_of_unknown_kind():
    """Passed before: the kind of the patch that comes first, where the curvatures of two patches jump."""
    half = mpq(1, 2)
    sides = [
        Box(Interval(mpq(0), half), Interval(mpq(0), mpq(1))),
        Box(Interval(half, mpq(1)), Interval(mpq(0), mpq(1))),
    ]

    def seen(first, second):
        own = [
            Umbilic(Place(((i, 0),), CommonZero.at(box, (half, mpq(1, 3)))), kind)
            for i, (box, kind) in enumerate(zip(sides, (first, second), strict=True))
        ]
        found = merged_umbilic(own, (), Box(Interval(mpq(0), mpq(1)), Interval(mpq(0), mpq(1))), ())
        assert found.place.patches == ((0, 0), (1, 0))
        return found.kind

    star, lemon = "star", "lemon"
    assert seen(star, star) == star
    assert seen(star, lemon) == seen(lemon, star) == "of unknown kind"


@pytest.mark.parametrize("error", [ReachError("a common divisor"), FormulaError("a polynomial of a million terms")])
def test_one_formula_out_of_reach_ends_no_table(monkeypatch, error):
    """Before: `ReachError` for the whole table of degrees where one formula was out of reach."""

    def refuse(formula, **how):
        raise error

    monkeypatch.setattr(generic_proof, "reduce", refuse)
    generic_proof.cached_reduction.cache_clear()
    try:
        row, _ = (call() for call in formula_degrees([formula_of("f2")]))
        assert (row.nominal, row.lowest) == ("3d − 3", error.problem)
        gradings = {row.grading for call in construction_table(xs.example("rational_cubic")) for row in [call()]}
        assert gradings == {"–"}
    finally:
        generic_proof.cached_reduction.cache_clear()


def test_a_claim_out_of_reach_is_undecided_and_says_why(monkeypatch):
    """Before: the common divisors of a proof were computed whatever they cost, in calls that cannot be interrupted."""
    monkeypatch.setattr(factors, "DIVISOR_TERM", 10**13)
    monkeypatch.setattr(factors, "_certainly_coprime_on_a_line", lambda p, q: False)
    (claim,) = xs.claims("C1a-tangent_developable_by_unit_tangent")
    row = decide(claim)
    assert row.verdict == Verdict.UNDECIDED
    assert "the greatest common divisor of polynomials" in str(row.witness)


def test_verdicts_leave_out_whole_kinds():
    """Passed before: `verdicts(without="identity")` left out every kind whose name is a part of that word."""
    with pytest.raises(xs.ExactSplineError, match="kinds of claims"):
        xs.tables.verdicts("C4.1a", without="identity, degree")
    assert xs.tables.verdicts("C4.1a", without=["identity"])["verdict"] == []


def test_a_value_that_is_negative_on_a_short_interval_is_refuted_there(tmp_path):
    """Before: no end; the witness was sought among ever more samples, of which this interval needs 10⁶⁰."""
    t, a, width = BSpline.identity(0, 1), mpq(1, 3), mpq(1, 2**200)
    curve = Nurbs.from_splines([(t - a) * (t - a - width), t])
    claim = {"id": "1", "kind": "sign", "statement": "said", "curve": "plane", "formula": "f", "sign": "≥ 0"}
    (one,) = claims(paper=paper(written(tmp_path / "p", plane_formulas(f="c.p[0] * 1"), [claim])))
    (row,) = audit([one], [curve])
    assert row.verdict == Verdict.REFUTED
    assert a < row.finding.witness.parameter < a + width


@pytest.mark.parametrize("command", [("prove", "--claim", "L16", "--curve"), ("sweep", "--claim", "L16", "-q")])
def test_what_is_out_of_reach_is_named_and_is_not_another_verdict(command, monkeypatch):
    """Before, a claim left undecided because of its cost on a curve was one that DIFFERs from the record: status 1."""
    monkeypatch.setattr(combined, "Budget", lambda: Budget(1))
    said, strict = (run(*command, "rational_space_cubic", *more) for more in ([], ["--strict"]))
    assert (said.returncode, strict.returncode) == (0, 2)
    assert "UNDECIDED" in said.stdout
    assert "DIFFER" not in said.stdout
