"""One refused claim never hides the paper: all other rows are printed, the refused one with its reason, and the exit
status is 2.
"""

import csv
import io
import json
import re

import pytest

from exactspline import Verdict, example, paper, write
from exactspline.errors import ClaimError, FormulaError
from exactspline.papers import Table
from exactspline.verification.claims import claim_of, claims_of
from exactspline.verification.ledger import audit
from tests.support.command import invoke
from tests.verification.test_own_paper import plane_formulas, written

FORMULAS = plane_formulas(f="det(c.p, c.p.d(1))", g="2 * det(c.p, c.p.d(1))", v="c.p")
GOOD = {"id": "1", "kind": "identity", "statement": "g is 2 f", "curve": "plane", "left": "g", "right": "f"}
GOOD |= {"factor": "2"}
FALSE = GOOD | {"id": "2", "statement": "g is 3 f", "factor": "3"}
REFUSED = [
    {"id": "3", "kind": "implication", "statement": "where f = 0, g = 0"},
    {"id": "4", "kind": "vanishing", "statement": "no formula", "curve": "plane"},
    {"id": "5", "kind": "vanishing", "statement": "a misspelled formula", "curve": "plane", "left": "h"},
    {"id": "6", "kind": "vanishing", "statement": "other arguments", "curve": "space", "left": "f"},
    {"id": "\\u001b[2J", "kind": "vanishing", "statement": "\\u001b[2J", "curve": "plane", "left": "f"},
    {"id": 8, "kind": 8, "statement": 8},
    {"kind": "vanishing", "statement": "without an id", "curve": "plane", "left": "f"},
    GOOD | {"statement": "the same id and kind again"},
    GOOD | {"id": "9", "expected": "NOT ASKED"},
]


def folder_with(tmp_path, *claims):
    folder = written(tmp_path / "p", FORMULAS, claims)
    file = folder / "claims.toml"
    file.write_text(file.read_text().replace("\\\\u", "\\u"))
    return folder


def rows_of(*arguments):
    return json.loads(invoke("prove", *arguments, "--json").output)["rows"]


@pytest.mark.parametrize("refused", REFUSED)
def test_one_refused_claim_hides_no_other(refused, tmp_path):
    """Before, the first refused entry ended the command, and no verdict was printed."""
    folder = folder_with(tmp_path, GOOD, refused, FALSE)
    general = [row for row in rows_of("--paper", folder) if not row["curve"]]
    assert [row["verdict"] for row in general] == ["PROVED", "NOT ASKED", "REFUTED"]
    assert "claims.toml, claim 2" in general[1]["witness"]
    done = invoke("prove", "--paper", folder)
    assert done.exit_code == 2
    assert "NOT ASKED" in done.output
    said = " ".join(done.output.split())
    assert re.search(r"; 1 could not be asked \(--rows [^)]*\); \d+ DIFFER from the record", said)
    assert "\x1b[2J" not in done.output
    table = list(csv.DictReader(io.StringIO(invoke("prove", "--paper", folder, "--csv").output)))
    assert [row["verdict"][:9] for row in table[:3]] == ["PROVED", "NOT ASKED", "REFUTED (recorded: PROVED)"[:9]]


def test_all_of_them_together_and_every_command(tmp_path):
    folder = folder_with(tmp_path, GOOD, *REFUSED)
    own = claims_of(paper(folder))
    assert len(own) == len(REFUSED) + 1 == len({claim.key for claim in own})
    found = [row.verdict for row in audit(own) if not row.curve]
    assert found == [Verdict.PROVED, *[Verdict.NOT_ASKED] * len(REFUSED)]
    for command in (["show"], ["show", "1"], ["errata"], ["prove", "--rows"], ["prove", "--claim", "1"]):
        done = invoke(*command, "--paper", folder)
        assert done.exit_code in (0, 2), done.exception
        assert done.output
    for option in ("--report", "--html"):
        invoke("prove", "--paper", folder, option, tmp_path / "page.html")
        assert (tmp_path / "page.html").read_text().count("NOT ASKED") >= len(REFUSED)


def test_what_is_said_not_to_be_asked_is_as_recorded(tmp_path):
    said = {"id": "3", "kind": "not asked", "statement": "∫κ ds is the angle", "why": "an integral"}
    folder = folder_with(tmp_path, GOOD, said)
    done = invoke("prove", "--paper", folder)
    assert done.exit_code == 0
    assert "an integral" in done.output
    assert invoke("prove", "--paper", folder, "--strict").exit_code == 2
    (row,) = [row for row in audit(claims_of(paper(folder))) if row.verdict == Verdict.NOT_ASKED]
    assert str(row.witness) == "an integral"
    assert row.as_recorded


def test_what_is_not_asked_never_counts_as_holding(tmp_path):
    """A refused entry that its author expects to be REFUTED is not so."""
    folder = folder_with(tmp_path, REFUSED[0] | {"expected": "REFUTED", "place": "eq. (3)", "words": "so"})
    (row,) = audit(claims_of(paper(folder)))
    assert row.verdict not in (Verdict.PROVED, Verdict.REFUTED)
    assert not row.as_recorded
    assert row.refused


def test_papers_of_the_library_are_refused_whole():
    with pytest.raises(ClaimError, match="the field 'why' is missing"):
        claim_of(Table("here", {"id": "1", "kind": "not asked", "statement": "s"}), paper("lifted"))


def test_a_claim_that_differs_is_printed_once(tmp_path):
    """Before, "Not as recorded" repeated a claim for every curve on which it fails."""
    folder = folder_with(tmp_path, GOOD, FALSE)
    told = invoke("prove", "--paper", folder).output
    _, below = re.split(r"Not as recorded \(once per claim; \d\d rows with --rows\)", told)
    assert below.count("REFUTED (recorded") == 1


SPOILT = """
import os
@formula("e", on="plane")
def f(c):
    return det(c.p, c.p.d(1))
@formula("e", on="plane")
def g(c):
    return 2 * f(c)
@formula("e", on="plane")
def rounded(c):
    return 0.5 * f(c)
@formula("e", on="plane")
def calls(c):
    return rounded(c)
@formula("e", on="plane")
def same(c):
    return f(c)
@formula("e", on="plane")
def same(c):
    return os.system("echo > ran")
@formula("e", on="plane")
def by_twice(c):
    return c.p.d(1, by="s", by="s")
"""
#: Claims about them, and what must be told of each.
ABOUT = {
    "rounded": "the float 0.5",
    "calls": "'rounded' is unknown",
    "same": "'same' is taken",
    "h": "no formula called",
}


def spoilt(tmp_path):
    claims = [GOOD, *[FALSE | {"id": f"{i}", "left": name} for i, name in enumerate(ABOUT, 3)]]
    claims.append({"id": "7", "kind": "at", "statement": "s", "curve": "plane", "formula": "f", "example": "bad"})
    claims[-1] |= {"parameter": "1/2", "claimed": "1"}
    folder = written(tmp_path / "p", SPOILT, [*claims, FALSE])
    (folder / "curves").mkdir()
    (folder / "curves" / "bad.json").write_text("{")
    (folder / "curves" / "several.json").write_text('{"curves": []}')
    write(example("parabola"), folder / "curves" / "arch.json")
    return folder


def test_refused_formulas_and_curves_hide_nothing(tmp_path, monkeypatch):
    """Before, one of them ended the command, and no verdict was printed."""
    monkeypatch.chdir(tmp_path)
    rows = rows_of("--paper", spoilt(tmp_path))
    general = {row["id"]: row for row in rows if not row["curve"]}
    assert (general["1"]["verdict"], general["2"]["verdict"]) == ("PROVED", "REFUTED")
    assert [row["verdict"] for row in rows if row["curve"] == "parabola"] == ["VERIFIED", "REFUTED"]
    for i, why in enumerate([*ABOUT.values(), "'bad' cannot be read"], 3):
        assert general[f"{i}"]["verdict"] == "NOT ASKED"
        assert why in general[f"{i}"]["witness"]
    refused = ["line 3", "rounded", "calls", "same", "by_twice", "curves/bad.json", "curves/several.json"]
    assert [row for row in general if not row.isdigit()] == refused
    assert all(general[name]["witness"] for name in refused)
    assert invoke("prove", "--paper", "p").exit_code == 2
    assert not (tmp_path / "ran").exists()


def test_a_file_of_formulas_that_cannot_be_read_is_the_reason(tmp_path):
    folder = folder_with(tmp_path, GOOD)
    (folder / "formulas.py").write_text("def f(c):\n  return (\n")
    rows = rows_of("--paper", folder)
    assert [row["verdict"] for row in rows] == ["NOT ASKED"] * 2
    assert all("line 2" in row["witness"] for row in rows)


def test_elsewhere_what_is_refused_is_an_error(tmp_path):
    folder = spoilt(tmp_path)
    with pytest.raises(FormulaError, match="import os"):
        paper(folder)
    assert isinstance(invoke("formula", "degrees", "--paper", folder).exception, FormulaError)
    assert invoke("identity", f"{folder}:g = 2 * {folder}:f").exit_code == 0
    for name, why in ABOUT.items():
        assert why in str(invoke("identity", f"{folder}:{name} = 2 * {folder}:f").exception)


@pytest.mark.parametrize("text", ["[[claim]\n", "claim = 1\n", "common = 1\n"])
def test_a_file_of_claims_that_cannot_be_read_hides_no_other(tmp_path, text):
    """Before, no claim of the other files was decided."""
    folder = folder_with(tmp_path, GOOD, FALSE)
    (folder / "paper.toml").write_text('claims = ["later.toml", "claims.toml"]\n')
    (folder / "later.toml").write_text(text)
    rows = [row for row in rows_of("--paper", folder) if not row["curve"]]
    assert [row["verdict"] for row in rows] == ["PROVED", "REFUTED", "NOT ASKED"]
    assert "later.toml" in rows[2]["witness"]
    assert invoke("prove", "--paper", folder).exit_code == 2


def test_a_refused_formula_hides_no_error_of_a_paper(tmp_path):
    """Before, `errata` ended at the formula, and listed nothing."""
    folder = written(tmp_path / "p", FORMULAS + plane_formulas(h="c.nothing"), [GOOD, FALSE])
    done = invoke("errata", "--paper", folder)
    assert done.exit_code == 2
    assert "which says: g is 3 f" in done.output
    assert "h-not-asked-3 (NOT ASKED)" in done.output


def test_a_statement_that_its_author_does_not_ask_is_no_bad_input_of_errata(tmp_path):
    own = {"id": "3", "kind": "not asked", "statement": "an integral", "why": "no kind expresses it"}
    assert invoke("errata", "--paper", folder_with(tmp_path, FALSE, own)).exit_code == 0


def test_a_degree_that_no_curve_of_a_kind_has_is_refused_for_that_reason(tmp_path):
    """Before, the remedy was a degree "in numbers alone", which was refused, too."""
    claim = {"id": "1", "kind": "degree", "statement": "s", "curve": "curve on a surface", "formula": "f"}
    formula = "@formula('e', on='curve on a surface')\ndef f(c):\n    return c.gamma.d(1)\n"
    rows = rows_of("--paper", written(tmp_path / "p", formula, [claim | {"claimed": "2d"}]))
    assert "'curve on a surface' has no degrees" in rows[0]["witness"]
