"""Runs of the ledger own what they remember: several of them may share curves."""

import pickle
from concurrent.futures import ThreadPoolExecutor

from exactspline import Verdict, decide, example, paper
from exactspline.display.ledger import row_data
from exactspline.polynomials.cost import Budget
from exactspline.symbolic.assumptions import ASSUMPTIONS
from exactspline.verification import combined
from exactspline.verification.claims import all_claims, claims_of, select
from exactspline.verification.combined import Proofs
from exactspline.verification.evaluation import Evaluation
from exactspline.verification.ledger import audit
from tests.verification.test_own_paper import plane_formulas, written


def told(row):
    return {name: value for name, value in row_data(row).items() if name != "seconds"}


def test_eight_threads_run_the_ledger_over_one_curve():
    curve = example("rational_cubic_s")
    claims = [claim for claim in all_claims() if claim.id[:2] in ("C4", "C3", "E1", "L3")]

    def run(_):
        return [told(row) for row in audit(claims, [curve])]

    alone = run(0)
    assert len(alone) > 40
    with ThreadPoolExecutor(8) as pool:
        assert all(rows == alone for rows in pool.map(run, range(8)))


def test_an_evaluation_does_not_outlive_its_run():
    curve = example("circle")
    one, two = Evaluation(curve), Evaluation(curve)
    assert one.argument("plane") is one.argument("plane")
    assert one.argument("plane") is not two.argument("plane")
    assert curve._values is None


def test_claims_and_assumptions_survive_pickling():
    for claim in select(["C4.1", "C5.2c", "Fig. 1"]):
        assert pickle.loads(pickle.dumps(claim)) == claim
    for each in ASSUMPTIONS.values():
        assert pickle.loads(pickle.dumps(each)) is each


def test_a_claim_near_the_bound_does_not_depend_on_what_was_asked_before(tmp_path, monkeypatch):
    """Before: values kept from an earlier claim cost nothing: the second claim was PROVED in a run, UNDECIDED alone."""
    total = "(c.p[0] + c.p[1] + c.w + c.p[0].d(1) + c.p[1].d(1) + c.w.d(1))"
    formulas = plane_formulas(f=f"{total}**14", g=f"f(c) * {total} - f(c) * {total} + c.w - c.w")
    claims = [{"id": f, "kind": "vanishing", "statement": "s", "curve": "plane", "left": f} for f in "fg"]
    first, second = claims_of(paper(written(tmp_path / "p", formulas, claims)))
    spent = []

    def verdict_within(claim, proofs, bound):
        budget = Budget(bound)
        monkeypatch.setattr(combined, "Budget", lambda: budget)
        found = decide(claim, proofs).verdict
        spent.append(budget.total - budget.remaining)
        return found

    shared, much = Proofs(), Budget().total
    assert verdict_within(second, Proofs(), much) == Verdict.PROVED
    assert [verdict_within(claim, shared, much) for claim in (first, second)] == [Verdict.REFUTED, Verdict.PROVED]
    assert spent[0] == spent[2] > spent[1] > 0
    shared, little = Proofs(), sum(spent[1:]) // 2
    assert [verdict_within(claim, shared, little) for claim in (first, second)] == [Verdict.REFUTED, Verdict.UNDECIDED]
    assert verdict_within(second, Proofs(), little) == Verdict.UNDECIDED
