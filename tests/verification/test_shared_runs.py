"""Runs of the ledger own what they remember: several of them may share curves."""

import pickle
from concurrent.futures import ThreadPoolExecutor

from exactspline.display.ledger import row_data
from exactspline.interchange.examples import example
from exactspline.symbolic.assumptions import ASSUMPTIONS
from exactspline.verification.claims import all_claims, select
from exactspline.verification.evaluation import Evaluation
from exactspline.verification.ledger import audit


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
