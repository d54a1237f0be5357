"""What a stranger writes into a folder is data: it is quoted where it becomes code, bounded in what it costs, and said
where it ran unchecked.
"""

import csv
import io
import json
import re
import time
from dataclasses import replace

import pytest

import exactspline as xs
from exactspline import Nurbs, Verdict, decide, example, formula_of, paper
from exactspline.display.sheet import Sheet, code_lines, csv_of
from exactspline.errors import ClaimError, FormulaError
from exactspline.extras.coq.answers import theorem_of
from exactspline.papers import papers, resolve
from exactspline.tables import errata
from exactspline.verification.claims import claims_of, select
from exactspline.verification.judges import Sympy
from exactspline.verification.ledger import audit
from tests.support.claims import one_verdict, refusal
from tests.support.command import invoke
from tests.support.decided import errors_in_print
from tests.verification.test_own_paper import plane_formulas, written

FALSE = {"id": "1", "kind": "identity", "statement": "f is g", "curve": "plane", "left": "f", "right": "g"}
FORMULAS = plane_formulas(f="det(c.p, c.p.d(1))", g="2 * det(c.p, c.p.d(1))", v="c.p * c.w")


# ---- code


KINDS = {
    "identity": FALSE,
    "vanishing": {"kind": "vanishing", "left": "f"},
    "degree": {"kind": "degree", "formula": "f", "claimed": "d"},
    "lowest": {"kind": "degree", "formula": "f", "claimed": "d", "measure": "lowest terms"},
    "count": {"kind": "count", "formula": "f", "example": "circle", "claimed": "9 roots"},
}


@pytest.mark.parametrize("kind", KINDS)
def test_a_check_to_paste_runs_nothing_but_itself(kind, tmp_path, monkeypatch, capsys):
    """Before, the name of the folder stood unquoted in the check: pasted, it ran what its name says."""
    monkeypatch.chdir(tmp_path)
    name = 'p")) or open("pwned", "w") or print(("\\'
    claim = {"id": "1", "statement": "false", "curve": "plane"} | KINDS[kind] | {"words": "said", "expected": "REFUTED"}
    folder = written(tmp_path / name, FORMULAS, [claim | {"error": "e"}], '[errors]\ne = "an error"\n')
    (found,) = errata([paper(folder)])
    (refuted,) = found.statements
    pasted = "\n".join(refuted.check)
    exec(pasted, {})
    assert capsys.readouterr().out.strip()
    for width in (20, 40, 80):
        exec("\n".join(part for line in refuted.check for part in code_lines(line, width)), {})
    assert not (tmp_path / "pwned").exists()


def test_checks_of_papers_that_come_along_still_run(capsys):
    found = [each for entry in errors_in_print() for each in entry.statements]
    for each in found[:6]:
        exec("\n".join(each.check), {})
    assert len(capsys.readouterr().out.splitlines()) >= 6


@pytest.mark.parametrize("name", ["*) Axiom false : False. (*", "(**)", '"', "*)*)", "(*)"])
def test_a_name_stays_in_its_comment(name):
    """Before, a curve named "*) Axiom …" closed the comment, and its name was read by Coq."""
    text = theorem_of(Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), (1, 2), (2, 0)], name=name))
    comment = text[: text.index("Require Import")]
    assert (comment.count("(*"), comment.count("*)"), comment.count('"')) == (1, 1, 0)


@pytest.mark.parametrize(
    "symbol", [r"\input{/etc/passwd}", r"\write18{x}", r"\href{x}{y}", r"\def\x{y}", "a^^5cinput", "a%b", r"a\\b", "a}",
               "{" * 101 + "}" * 101, r"\left("]
)  # fmt: skip
def test_a_symbol_is_a_sign_and_nothing_else(symbol, tmp_path):
    r"""Before, \input and \href stood in the LaTeX and in the pages; later still 10⁴ braces, and a \left alone."""
    body = f"@formula('e', on='plane', symbol={symbol!r})\ndef f(c):\n    return c.w * 1\n"
    with pytest.raises(FormulaError, match=r"line \d: the symbol"):
        paper(written(tmp_path / "p", body, []))


def test_symbols_of_the_papers_are_signs(tmp_path):
    symbols = sorted({f.symbol for p in papers() for f in p.formulas.values() if f.symbol})
    head = "@formula('e', on='plane', symbol={!r})\ndef f{}(c):\n    return c.w * 1\n"
    body = "".join(head.format(symbol, k) for k, symbol in enumerate(symbols))
    assert len(paper(written(tmp_path / "p", body, [])).formulas) == len(symbols)


# ---- tables


CELLS = [
    "=1+1",
    "+cmd|x",
    "-x",
    "@SUM(A1)",
    "-1+cmd",
    "＝1+1",
    "-1/2",
    "-0.333…",
    "1",
    "−3",
    "x = 1",
    "",
    "-∞",
    "+1e-3",
]


def test_no_cell_of_text_is_computed_and_numbers_stay():
    """Before, a spreadsheet computed a claim that begins with an equals sign."""
    sheet = Sheet("cell", name="=A1")
    for cell in CELLS:
        sheet.add_row(cell)
    rows = list(csv.reader(io.StringIO(csv_of([sheet], "curve"))))[1:]
    assert {row[0] for row in rows} == {"'=A1"}
    assert [row[1] for row in rows] == [f"'{cell}" for cell in CELLS[:6]] + CELLS[6:]


def test_markdown_has_no_html_and_no_link_of_a_stranger(tmp_path):
    """Before, a statement with <img onerror=…> stood in the Markdown as it is."""
    said = '<img src=x onerror="alert(1)"> [here](javascript:x) a|b'
    folder = written(tmp_path / "p", FORMULAS, [FALSE | {"statement": said}])
    for command in (["prove", "--rows"], ["errata"]):
        text = invoke(*command, "--paper", folder, "--markdown").output
        assert "&lt;img" in text
        assert not re.search(r"<\w|\]\(", text)
    sheet = Sheet("a", title="<b>|</b>")
    sheet.add_row("x\ny")
    assert "<b>" not in sheet.markdown()
    assert "| x y |" in sheet.markdown()


# ---- costs


@pytest.mark.parametrize(
    "body",
    [
        "wronskian(join(c.p, c.p, c.p, c.p, c.p, c.p, c.p, c.w))",
        "wronskian(join(c.p, c.w), order=15)",
        "wronskian(twice(twice(twice(c.p))))",
        f"det({', '.join(['c.p'] * 15)})",
        f"dot(generalized_cross({', '.join(['c.p'] * 12)}), c.p)",
    ],
)
def test_a_determinant_counts_as_what_it_costs(body, tmp_path):
    """Before, a Wronskian of 15 components counted as one operation, took 3 GB and ended the process."""
    helper = "def twice(v):\n    return join(v, v)\n"
    formulas = "from exactspline.language import generalized_cross\n" + helper + plane_formulas(f=body)
    with pytest.raises(FormulaError, match="of more than 40320 products"):
        paper(written(tmp_path / "p", formulas, []))


def test_a_wronskian_of_a_few_components_is_decided(tmp_path):
    formulas = plane_formulas(f="wronskian(join(c.p, c.w))", g="c.w * 1")
    folder = written(tmp_path / "p", formulas, [])
    assert resolve(f"{folder}:f").name == "f"


@pytest.mark.parametrize("factor", ["w^2000", "w^65", "w^-9999", "w^40 v^-40", "w " * 70, "w^" + "9" * 300])
def test_a_factor_has_few_powers(factor, tmp_path):
    """Before, `factor = "w^2000"` did not end."""
    folder = written(tmp_path / "p", FORMULAS, [FALSE | {"factor": factor}])
    start = time.perf_counter()
    assert "too large" in refusal(folder)
    assert time.perf_counter() - start < 5


def test_many_products_are_bounded_together(tmp_path):
    """Before, each of sixty products was within its bound, on every segment: minutes for one row of the ledger."""
    total = "c.p[0] + c.p[1] + c.w + c.p[0].d(1) + c.p[1].d(1) + c.w.d(1)"
    formulas = plane_formulas(f=f"({total})**60 * (c.w - c.w)")
    claim = {"id": "1", "statement": "said", "curve": "plane", "kind": "invariance", "formula": "f", "under": "motion"}
    (one,) = claims_of(paper(written(tmp_path / "p", formulas, [claim])))
    start = time.process_time()
    rows = audit([one], [example("rational_cubic_s"), example("six_segment_cubic")])
    assert [row.verdict for row in rows] == [Verdict.UNDECIDED, Verdict.UNDECIDED]
    assert time.process_time() - start < 20


# ---- what is read, and what ran


def test_what_is_read_is_in_the_digests(tmp_path):
    """Before, a symlinked formula file ran and was missing from the digests of the report."""
    real = written(tmp_path / "real", FORMULAS, [FALSE])
    folder = tmp_path / "p"
    (folder / "deep").mkdir(parents=True)
    (folder / "formulas.py").symlink_to(real / "formulas.py")
    (folder / "claims.toml").symlink_to(real / "claims.toml")
    (folder / "deep" / "circle").symlink_to(folder)
    own = paper(folder)
    assert own.digests() == paper(real).digests()
    page = tmp_path / "report.html"
    invoke("prove", "--paper", folder, "--report", page)
    assert own.digests()["formulas.py"] in page.read_text(encoding="utf-8")


def test_that_formulas_ran_unchecked_is_said_everywhere(tmp_path):
    """Before, only the report said so."""
    folder = written(tmp_path / "p", FORMULAS, [FALSE])
    file = str(folder / "formulas.py")
    for trust in (True, False):
        words = ["prove", "--paper", folder, *(["--trust"] if trust else [])]
        text, table, markdown = (invoke(*words, *more).output for more in ([], ["--csv"], ["--markdown"]))
        data = json.loads(invoke(*words, "--json").output)
        assert data.get("unchecked") == ([file] if trust else None)
        assert ("unchecked (--trust)" in text) == trust == ("unchecked (--trust)" in markdown)
        rows = list(csv.reader(io.StringIO(table)))
        assert (rows[0][-1] == "unchecked") == trust
        assert all((row[-1] == file) == trust for row in rows[1:])
        derived = json.loads(invoke("derive", f"{folder}:f", "circle", *words[3:]).output)
        assert derived.get("unchecked") == ([file] if trust else None)
        page = tmp_path / "page.html"
        invoke(*words, "--html", page)
        assert ("unchecked (--trust)" in page.read_text(encoding="utf-8")) == trust


@pytest.mark.parametrize(
    "head",
    ['claims = ["clams.toml"]', 'formulas = ["formulas", "plane"]', 'claims = ["claims.toml", "deep/more.toml"]'],
)
def test_a_file_that_is_listed_must_exist(head, tmp_path):
    """Before: "no verdicts", and exit status 0."""
    folder = written(tmp_path / "p", FORMULAS, [FALSE])
    (folder / "paper.toml").write_text(head + "\n")
    with pytest.raises(ClaimError, match="does not exist"):
        paper(folder)
    assert invoke("prove", "--paper", folder).exit_code != 0


def test_a_folder_without_claims_is_told(tmp_path):
    """Before: "no verdicts", and exit status 0."""
    folder = written(tmp_path / "p", FORMULAS, [FALSE])
    (folder / "claims.toml").rename(folder / "claim.toml")
    with pytest.raises(ClaimError, match="states no claims"):
        raise invoke("prove", "--paper", folder).exception


# ---- names, judges, theorems


def test_a_name_of_several_papers_is_ambiguous(tmp_path):
    """Before, `find("normal")` took the one of the default paper, without a word."""
    with pytest.raises(FormulaError, match="surfaces:normal"):
        formula_of("normal")
    assert formula_of("surfaces:normal") is not formula_of("chen_riesenfeld_cohen_2007:normal")
    assert formula_of("f2").name == "f2"
    uses = 'uses = ["chen_riesenfeld_cohen_2007", "surfaces"]\n'
    folder = written(tmp_path / "p", "", [FALSE | {"left": "chord", "right": "normal", "curve": "pair"}], uses)
    assert "is a formula of chen_riesenfeld_cohen_2007 and of surfaces" in refusal(folder)


def test_a_broken_formula_elsewhere_changes_no_verdict(tmp_path):
    """Before, REFUTED became UNDECIDED, because every formula of the paper was tried for a name of a factor."""
    broken = plane_formulas(a="c.w / (c.w - c.w)", b="c.p[7]", d="dot(c.p, join(c.p, c.w))")
    claims = [FALSE, FALSE | {"id": "2", "left": "h"}]
    formulas = broken + FORMULAS + plane_formulas(h="(c.w + c.p[0]) * det(c.p, c.p.d(1))")
    found = [decide(claim) for claim in claims_of(paper(written(tmp_path / "p", formulas, claims)))]
    assert [row.verdict for row in found] == [Verdict.REFUTED, Verdict.REFUTED]
    assert str(found[0].factor) == "1/2"
    right = [FALSE | {"factor": "1/2"}]
    assert decide(claims_of(paper(written(tmp_path / "p", formulas, right)))[0]).verdict == Verdict.PROVED


def test_a_denominator_that_vanishes_where_w_is_1_does_not_hide_a_refutation(tmp_path):
    """Before, UNDECIDED, "division by an expression that vanishes on every curve": it does where w = 1 alone, and on
    rational curves the claim is false.
    """
    formulas = plane_formulas(a="c.p[0] / c.w.d(1)", b="(c.p[0] + c.w) / c.w.d(1)", h="(2 * c.p[0]) / (2 * c.w.d(1))")
    claim = {"id": "1", "kind": "identity", "statement": "a = b", "curve": "plane", "left": "a", "right": "b"}
    same = claim | {"id": "2", "right": "h"}
    claims = claims_of(paper(written(tmp_path / "p", formulas, [claim, same])))
    assert [decide(each).verdict for each in claims] == [Verdict.REFUTED, Verdict.UNDECIDED]
    assert Sympy().decide(claims[0]).verdict == Verdict.REFUTED


def test_a_curve_on_which_a_check_fails_does_not_hide_a_refutation(monkeypatch):
    """Before, the error on the first example curve turned a refutation into UNDECIDED, and ended `errata`."""
    false = replace(next(c for c in select(["C3c"]) if c.kind == "vanishing"), left="D1_D2_D3")
    honest, calls = type(false).check, []

    def failing(self, curve, proof):
        calls.append(curve)
        if len(calls) == 1:
            raise FormulaError("it does not fit this curve")
        return honest(self, curve, proof)

    monkeypatch.setattr(type(false), "check", failing)
    found = one_verdict(false)
    assert found.verdict == Verdict.REFUTED
    assert str(found.witness).startswith("on the example curve")


def test_errata_name_what_is_not_decided(tmp_path):
    """Passed before: "0 errors of the paper", where a claim of it was not decided at all."""
    formulas = FORMULAS + plane_formulas(a="c.p[0] / c.w.d(1)", h="(2 * c.p[0]) / (2 * c.w.d(1))")
    folder = written(tmp_path / "p", formulas, [FALSE, FALSE | {"id": "2", "left": "a", "right": "h"}])
    told = invoke("errata", "--paper", folder).output
    assert "neither proved nor refuted: 2-identity (UNDECIDED)" in told


def test_the_kernel_says_why_it_says_nothing(tmp_path):
    """Before, the column of the kernel was blank for every claim of a user's paper."""
    pytest.importorskip("sympy")
    folder = written(tmp_path / "p", FORMULAS, [FALSE])
    for asked, why in (
        (("--paper", folder), "formulas of users' folders are not written in Coq"),
        (("--claim", "C4.1c"), "claims of the kind 'degree' are not equalities"),
    ):
        told = invoke("prove", *asked, "--judge", "coq", "--csv").stdout
        assert f"not stated, {why}" in told


def test_the_theorem_of_one_claim_is_written(tmp_path):
    """Before, `prove --claim ID --emit-coq DIR` was refused."""
    done = invoke("coq", "--claim", "C4.1a", tmp_path / "coq")
    assert done.exit_code == 0
    assert "2 theorems" in done.output
    (file,) = (tmp_path / "coq" / "claims").iterdir()
    assert len(re.findall("^Theorem", file.read_text(encoding="utf-8"), re.MULTILINE)) == 2
    assert f"claims/{file.name}" in (tmp_path / "coq" / "_CoqProject").read_text(encoding="utf-8")
    told = invoke("coq", "--claim", "C4.1c", tmp_path / "none")
    assert isinstance(told.exception, ClaimError)
    assert "are not equalities" in str(told.exception)
    assert not (tmp_path / "none").exists()
    folder = written(tmp_path / "p", FORMULAS, [FALSE])
    assert "users' folders" in str(invoke("coq", "--paper", folder, tmp_path / "none").exception)


def test_one_identity_that_says_nothing_is_no_success(tmp_path, monkeypatch):
    """Before, `prove --identity "zero = 0/0 · f"` ended with status 0."""
    monkeypatch.chdir(tmp_path)
    written(tmp_path / "p", plane_formulas(zero="c.w - c.w", f="c.w * c.w", g="c.w * 1"), [])
    for text in ("p:zero = p:zero * p:f", "p:zero = p:zero"):
        done = invoke("identity", text.replace("p:", f"{tmp_path}/p/formulas.py:", 1).replace("p:", ""))
        assert (done.exit_code, xs.verify("f1", "f2", example("straight_line")).verdict) == (1, "VACUOUS")


@pytest.mark.parametrize(
    ("kind", "text"),
    [
        ("plane with delta", "norm2(c.gamma.d(1)) * (29 * c.delta - 37)"),
        ("plane point", "norm2(c.gamma.d(1)) * (3 * c.point[0] - 1)"),
    ],
)
def test_what_vanishes_for_the_operand_tried_only_is_refuted(kind, text, tmp_path):
    """Before, UNDECIDED: the proof asked the examples, and these asked for the proof."""
    formulas = f"@formula('f', on={kind!r})\ndef f(c):\n    return {text}\n"
    claim = {"id": "1", "kind": "vanishing", "statement": "f is zero", "curve": kind, "left": "f"}
    folder = written(tmp_path / "p", formulas, [claim | {"expected": "REFUTED"}])
    (false,) = claims_of(paper(str(folder), trust=True))
    assert one_verdict(false).verdict == Verdict.REFUTED
    rows = json.loads(invoke("prove", "--paper", str(folder), "--trust", "--json").output)["rows"]
    assert [row["verdict"] for row in rows if not row["curve"]] == ["REFUTED"]


@pytest.mark.parametrize("line", ["f = c.w.d(1, by='s', by='s')", "def g(a, a): return a"])
def test_what_the_compiler_refuses_is_named_with_its_line(line, tmp_path):
    """Before, the SyntaxError of `compile`, for what `ast.parse` accepts, was a traceback."""
    body = line if line.startswith("def") else f"def h(c): return {line.partition('= ')[2]}"
    folder = written(tmp_path / "own", f"{body}\n{plane_formulas(f='c.w')}", [])
    with pytest.raises(FormulaError, match=r"formulas\.py, line \d+: not Python: .*; correct the syntax"):
        len(paper(folder).formulas)
