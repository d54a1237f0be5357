"""A verdict is one word, the same in the library, the command, and JSON; what contradicts is a verdict too."""

import json
from contextlib import suppress
from dataclasses import replace

import pytest

from exactspline import Nurbs, Verdict, claims, decide, example, examples, paper, verify
from exactspline.display.ledger import row_data
from exactspline.errors import FormulaError
from exactspline.papers import papers
from exactspline.tables import verdicts
from exactspline.verification.claims import claims_in
from exactspline.verification.ledger import audit
from tests.support.command import invoke
from tests.support.decided import decided_once
from tests.support.sampled import sample
from tests.verification.test_own_paper import written

#: Curves of which some claims do not speak, or say nothing.
SPECIAL = ("straight_line", "cusp", "space_line", "planar_in_space")


@pytest.mark.parametrize("name", ["straight_line", "planar_in_space", "rational_space_cubic"])
def test_library_command_and_json_say_one_word_on_every_claim(name):
    """Before, the library said UNDECIDED where the command said VACUOUS or INAPPLICABLE."""
    with decided_once():
        rows = json.loads(invoke("prove", "--paper", "all", "--curve", name, "--json").output)["rows"]
        own = list(audit(claims_in(papers()), [example(name)]))
    rows = [row for row in rows if row["curve"] == name]
    assert [(row.key, row.verdict) for row in own] == [(row["claim"], row["verdict"]) for row in rows]
    assert {row["verdict"] for row in rows} <= set(Verdict)
    assert name not in SPECIAL or {"VACUOUS", "INAPPLICABLE"} & {row["verdict"] for row in rows}
    told = [(row_data(row) | {"seconds": 0}) for row in own]
    for one, other in zip(told, rows, strict=True):
        assert {name: value for name, value in other.items() if name in one.keys() - {"key", "seconds"}} == {
            name: value for name, value in one.items() if name not in ("key", "seconds")
        }


def test_a_table_of_the_library_says_vacuous():
    """Before, `verdicts` said UNDECIDED of 0 = 0 on a straight line."""
    assert verdicts("C4.1a", curves=[example("straight_line")])["verdict"] == ["VACUOUS", "VACUOUS"]
    told = invoke("prove", "--claim", "C4.1a", "--curve", "straight_line", "--csv").output
    assert told.count("VACUOUS,") == 2


SIGN = "".join(
    f"@formula('e', on='plane')\ndef {name}(c):\n    return {body}\n"
    for name, body in {
        "turning": "det(c.gamma.d(1), c.gamma.d(2))",
        "one": "c.w * c.w * turning(c) / turning(c)",
        "root": "c.w * 1",
        "many": "turning(c) * turning(c) / turning(c)",
    }.items()
)

POSITIVE = {"id": "1", "kind": "sign", "statement": "w² > 0", "curve": "plane", "sign": "> 0", "assumes": ["w"]}


def test_a_value_whose_denominator_shares_its_zero_has_a_sign_wherever_it_exists(tmp_path):
    """Before, the whole run ended in "one of the readings is wrong: report this"."""
    folder = written(tmp_path / "p", SIGN, [POSITIVE | {"formula": "one", "squares": ["root"]}])
    done = invoke("prove", "--paper", folder)
    assert done.exit_code == 0
    rows = {row.curve: row.verdict for row in audit(claims(paper=paper(folder)))}
    assert (rows[""], rows["cubic_s"], rows["straight_line"]) == (Verdict.PROVED, Verdict.VERIFIED, "VACUOUS")


def test_a_zero_of_the_numerator_alone_still_refutes_a_sign(tmp_path):
    folder = written(
        tmp_path / "p", SIGN, [POSITIVE | {"formula": "turning"}, POSITIVE | {"id": "2", "formula": "many"}]
    )
    for claim in claims(paper=paper(folder)):
        assert claim.check(example("cubic_s")).verdict == "REFUTED"
    assert decide(claims(paper=paper(folder))[0]).verdict == "REFUTED"


def test_a_contradiction_is_a_row_and_the_others_stand(monkeypatch, tmp_path):
    """Before, a claim proved by one route and refuted by another ended the run: no other row was given."""
    right = claims("C4.1a")[1]
    entries = [
        {"id": "1", "kind": "identity", "statement": "right", "curve": "plane", "left": "f0", "right": "f2"}
        | {"factor": "w^-3"},
        {"id": "2", "kind": "identity", "statement": "wrong", "curve": "plane", "left": "f0", "right": "f2"}
        | {"factor": "w^-2"},
    ]
    folder = written(tmp_path / "p", "", entries, 'uses = ["chen_riesenfeld_cohen_2007"]\n')
    honest = type(right).decide

    def fooled(self, dimension, polynomial):
        found = honest(self, dimension, polynomial)
        return replace(found, verdict=Verdict.PROVED) if self.factor == "w^-2" else found

    monkeypatch.setattr(type(right), "decide", fooled)
    assert decide(right).verdict == Verdict.PROVED
    done = invoke("prove", "--paper", folder, "--json", "--rows")
    assert done.exit_code == 1
    rows = json.loads(done.output)["rows"]
    assert {row["verdict"] for row in rows if row["id"] == "1"} == {"PROVED", "VERIFIED", "VACUOUS"}
    wrong = {row["curve"]: row["verdict"] for row in rows if row["id"] == "2"}
    assert (wrong[""], wrong["circle"], wrong["parabola"]) == ("CONTRADICTION", "CONTRADICTION", Verdict.VERIFIED)
    text = invoke("prove", "--paper", folder)
    assert text.exit_code == 1
    assert "CONTRADICTION" in text.output
    assert "please report it" in text.output


def test_a_question_says_what_the_claim_says():
    """Before, `verify` refused with an error where a side does not exist on a segment, of which the claim says VACUOUS;
    a claim is inapplicable on a curve only for what it assumes and a question does not.
    """
    curves = [curve for curve in map(example, examples()) if isinstance(curve, Nurbs)]
    told = []
    for claim in sample([claim for claim in claims() if claim.kind == "identity"], 30):
        rows = {row.curve: row.verdict for row in audit([claim], curves) if row.curve}
        for curve in curves:
            if curve.name not in rows:
                continue
            # a question is asked of curves, claims are also about frames, points and pairs
            with suppress(FormulaError):
                asked = verify(claim.find(claim.left), claim.find(claim.right), curve, claim.factor).verdict
                told.append(asked)
                assert asked == rows[curve.name] or (rows[curve.name] == "INAPPLICABLE" and claim.assumes)
    assert set(told) == {"VERIFIED", "REFUTED", "VACUOUS"}
    assert len(told) > 150
