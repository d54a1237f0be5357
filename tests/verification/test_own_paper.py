"""Papers of anybody: folders loaded by path, formulas checked before they run, claims decided like those that come with
the library.
"""

import io
import json
import re
import time
from contextlib import redirect_stdout, suppress
from html.parser import HTMLParser
from pathlib import Path
from shutil import copytree, ignore_patterns

import pytest

import exactspline
from exactspline import ExactSplineError, Verdict, decide, example, paper
from exactspline.errors import ClaimError, FormulaError
from exactspline.papers import Table, named_papers, papers, resolve
from exactspline.symbolic.assumptions import Assumption
from exactspline.verification.claims import claim_of, claims_of
from exactspline.verification.evaluation import Evaluation
from exactspline.verification.ledger import audit
from exactspline.verification.statement import check
from tests.support.claims import refusal
from tests.support.command import invoke, new_paper

DOCS = Path(__file__).parents[2] / "docs" / "your-own-paper.md"
WORDS = "complex_product, cross, det, dot, formula, join, norm2, perp, ruled, wronskian"
LANGUAGE = f"from exactspline import rational; from exactspline.language import {WORDS}\n"


def text_of(value):
    """A value as TOML writes it."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, int):
        return str(value)
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(map(text_of, value))}]"
    text = str(value.name if isinstance(value, Assumption) else value)
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def written(folder, formulas, claims, head=""):
    """A folder with formulas and claims."""
    folder.mkdir(exist_ok=True)
    (folder / "formulas.py").write_text(LANGUAGE + formulas)
    entries = ["\n".join(f"{name} = {text_of(value)}" for name, value in claim.items()) for claim in claims]
    (folder / "claims.toml").write_text(head + "".join(f"\n[[claim]]\n{entry}\n" for entry in entries))
    return folder


def plane_formulas(**bodies):
    """Formulas of a plane curve by their names."""
    return "".join(f"@formula('e', on='plane')\ndef {name}(c):\n    return {body}\n" for name, body in bodies.items())


# ---- a new user


@pytest.mark.skipif(not DOCS.exists(), reason="the documents are in the checkout only")
def test_a_new_user_follows_the_page(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    page, start = DOCS.read_text(encoding="utf-8"), time.perf_counter()
    formula, python = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    claim = re.search(r"```toml\n(.*?)```", page, re.DOTALL)[1]
    assert invoke("paper", "new", "my-paper").exit_code == 0
    assert invoke("prove", "--paper", "my-paper").exit_code == 0
    with Path("my-paper/formulas.py").open("a") as file:
        file.write("\n\n" + formula)
    with Path("my-paper/claims.toml").open("a") as file:
        file.write("\n" + claim)
    done = invoke("prove", "--paper", "my-paper", "--report", "report.html")
    assert done.exit_code == 1
    assert "REFUTED (recorded: PROVED)" in done.output
    assert "at the parameter" in done.output
    # the page said 9 rows where there are 10
    (rows,) = re.findall(r"^\d+ rows …$", page, re.MULTILINE)
    assert rows.removesuffix(" …") in done.output
    assert time.perf_counter() - start < 5
    told = invoke("errata", "--paper", "my-paper").output
    assert "1. under similarities" in told
    Path("my-paper/claims.toml").write_text(
        Path("my-paper/claims.toml").read_text().replace("weight = 1", "weight = 2")
    )
    assert invoke("prove", "--paper", "my-paper").exit_code == 0
    shown = io.StringIO()
    with redirect_stdout(shown):
        exec(python, {})  # the page's own words
    said = re.findall(r"# (.*)", python)
    assert shown.getvalue().splitlines()[: len(said)] == said


@pytest.mark.skipif(not DOCS.exists(), reason="the documents are in the checkout only")
def test_every_command_of_the_page_works(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    invoke("paper", "new", "my-paper")
    exactspline.write(example("ellipse"), "my.json")
    lines = re.findall(r"^\./run (.*?)\s{2,}#", DOCS.read_text(encoding="utf-8"), re.MULTILINE)
    tried = [line for line in lines if "paper new" not in line and "--paper all" not in line]
    assert len(tried) >= 9
    for line in tried:
        arguments = [a.strip('"') for a in re.findall(r'"[^"]*"|\S+', line)]
        done = invoke(*arguments)
        assert done.exit_code == 0, (line, done.output, done.exception)


def test_the_new_paper_is_whole_and_nothing_is_overwritten(tmp_path):
    mine = new_paper(tmp_path / "mine")
    assert {path.relative_to(mine).as_posix() for path in mine.rglob("*") if path.is_file()} == {
        "formulas.py", "claims.toml", "README.md", "curves/arch.json",
    }  # fmt: skip
    own = paper(mine)
    assert own.title == "A small paper, to be changed"
    assert all(row.as_recorded for row in audit(claims_of(own)))
    refused = invoke("paper", "new", mine).exception
    assert isinstance(refused, ClaimError)
    assert "is not empty" in str(refused)


# ---- the same code for all


def test_a_built_in_paper_by_its_folder_is_the_paper():
    for each in papers():
        assert paper(str(each.folder)) is each
    assert named_papers(["all"]) == papers()
    assert named_papers([]) == tuple(p for p in papers() if p.default)


def test_a_copy_of_a_built_in_paper_is_decided_alike(tmp_path):
    """The same tables, the formulas named from the original: every verdict is the one of the original."""
    source = paper("lifted")
    copytree(str(source.folder), tmp_path / "copy", ignore=ignore_patterns("*.py*", "paper.toml"))
    told = f'claims = {text_of(source.claim_files)}\nuses = ["chen_riesenfeld_cohen_2007", "lifted"]\n'
    (tmp_path / "copy" / "paper.toml").write_text(told)
    copied = claims_of(paper(tmp_path / "copy"))
    assert [claim.key for claim in copied] == [claim.key for claim in claims_of(source)]
    for mine, original in list(zip(copied, claims_of(source), strict=True))[:12]:
        assert decide(mine).verdict == decide(original).verdict


def test_two_papers_may_have_formulas_of_one_name(tmp_path):
    body = (
        '\n@formula("e", on="plane")\ndef f(c):\n    return {}\n@formula("e", on="plane")\ndef g(c):\n    return {}\n'
    )
    claim = {"id": "1", "kind": "identity", "statement": "f is g", "curve": "plane", "left": "f", "right": "g"}
    one = written(tmp_path / "one", body.format("c.w", "c.w * 1"), [claim])
    two = written(tmp_path / "two", body.format("c.w", "c.w * 2"), [claim])
    (tmp_path / "deep").mkdir()
    again = written(tmp_path / "deep" / "one", body.format("c.w", "c.w * 3"), [claim])
    sources = named_papers([str(one), str(two), str(again)])
    assert [source.name for source in sources] == ["one", "two", "one′"]
    assert [decide(claims_of(source)[0]).verdict for source in sources] == [
        Verdict.PROVED,
        Verdict.REFUTED,
        Verdict.REFUTED,
    ]
    assert resolve(f"{one}:f").name == "f"
    (one / "formulas.py").write_text(LANGUAGE + body.format("c.w", "c.w * 5"))
    assert decide(claims_of(paper(one))[0]).verdict == Verdict.REFUTED


def test_a_paper_has_curves_of_its_own(tmp_path):
    own = written(
        tmp_path / "p",
        '\n@formula("e", on="plane")\ndef height(c):\n    return 2 * c.gamma[1] - 1\n',
        [
            {"id": "1", "kind": "count", "statement": "one root", "curve": "plane", "formula": "height"}
            | {"example": "half", "claimed": "1 roots", "expected": "VERIFIED", "of": "polynomial"}
        ],
    )
    (own / "curves").mkdir()
    curve = example("parabola")
    exactspline.write(curve, own / "curves" / "half.json")
    (row,) = audit(claims_of(paper(own)))
    assert row.verdict in (Verdict.VERIFIED, Verdict.REFUTED)
    (own / "curves" / "bad.json").write_text("{")
    (row, refused) = audit(claims_of(paper(own)))
    assert row.verdict in (Verdict.VERIFIED, Verdict.REFUTED)
    assert "bad.json" in str(refused.witness)


# ---- errors for authors


CLAIM = {"id": "1", "kind": "vanishing", "statement": "f is 0", "curve": "plane", "left": "f"}
ERRORS = {
    "return c.p + c.w": ("TypeError", "line 4"),
    "return c.p[5]": ("IndexError", "line 4"),
    "return dot(c.p, join(c.p, c.w))": ("vectors of 2 and 3 components", "line 4"),
    "return c.w / (c.w - c.w)": ("vanishes identically", "line 4"),
    "return c.w / 0": ("ZeroDivisionError", "line 4"),
    "return c.p * c.p": ("a product of two vectors", "line 4"),
    "return c": ("the value is a Curve", "f:"),
    "return 3": ("the number 3", "f:"),
    "return c.p[1:1]": ("without components", "f:"),
    "return join(3, 4)": ("vector of numbers", "f:"),
    "return ruled(c.w, c.w)": ("not vectors", "f:"),
    "return (norm2(c.gamma.d(1)) + norm2(c.gamma.d(2)) + c.gamma[0] * c.gamma.d(3)[1]) ** 10 * det(c.p, c.p)": (
        "terms",
        "line 4",
    ),
}


@pytest.mark.parametrize("body", ERRORS)
def test_what_goes_wrong_in_a_formula_names_file_and_line(body, tmp_path):
    problem, line = ERRORS[body]
    folder = written(
        tmp_path / "p", f"@formula('e', on='plane')\ndef f(c):\n    return {body.removeprefix('return ')}\n", [CLAIM]
    )
    told = str(decide(claims_of(paper(folder))[0]).witness)
    assert problem in told
    assert f"formulas.py, {line}" in told
    assert invoke("prove", "--paper", folder, "--strict").exit_code in (1, 2)


def test_a_trusted_formula_that_branches_names_file_and_line(tmp_path):
    formulas = "@formula('e', on='plane')\ndef f(c):\n    return c.p if c.w else c.p.d(1)\n"
    folder = written(tmp_path / "p", formulas, [CLAIM])
    with pytest.raises(FormulaError, match=r"line 4: a formula branches"):
        paper(folder)
    told = str(decide(claims_of(paper(folder, trust=True))[0]).witness)
    assert "formulas.py, line 4" in told
    assert "must not branch" in told


MISFITS = [
    {"kind": "identity", "left": "f", "right": "v"},
    {"kind": "identity", "left": "v", "right": "f"},
    {"kind": "identity", "left": "f", "right": "f2", "factor": "v"},
    {"kind": "zero set", "formulas": ["f", "v", "s"]},
    {"kind": "same surface", "left": "f", "right": "v"},
    {"kind": "same surface", "left": "s", "right": "v"},
    {"kind": "square class", "formula": "v", "right": "s"},
    {"kind": "sign", "formula": "v"},
    {"kind": "sign", "formula": "s"},
    {"kind": "sign", "formula": "f", "squares": ["v", "s"]},
    {"kind": "invariance", "formula": "s", "under": "rotation"},
    {"kind": "invariance", "formula": "f", "under": "rotation", "nature": "point"},
    {"kind": "count", "formula": "s", "example": "circle", "claimed": "1 roots"},
    {"kind": "condition", "left": "v", "right": "s", "example": "circle"},
    {"kind": "coefficients", "formula": "s"},
    {"kind": "vanishing", "left": "s"},
]


def test_claims_that_do_not_fit_their_formulas_are_told(tmp_path):
    formulas = plane_formulas(f="det(c.p, c.p.d(1))", f2="c.w", v="c.p", s="ruled(c.p, c.p.d(1))")
    claims = [{"id": f"M{i}", "statement": "a misfit", "curve": "plane"} | each for i, each in enumerate(MISFITS)]
    for claim in claims:
        folder = written(tmp_path / claim["id"], formulas, [claim])
        with suppress(ExactSplineError):
            (own,) = claims_of(paper(folder))
            rows = [decide(own), *audit([own], [example("cubic_s"), example("rational_cubic")])]
            assert not any(row.verdict in (Verdict.PROVED, Verdict.VERIFIED) for row in rows), claim


def test_a_derivative_that_the_kind_does_not_have(tmp_path):
    folder = written(
        tmp_path / "p",
        "@formula('e', on='implicit')\ndef f(c):\n    return c.fxx.d(2)\n",
        [CLAIM | {"curve": "implicit"}],
    )
    told = str(decide(claims_of(paper(folder))[0]).witness)
    assert "formulas.py, line 4" in told
    assert (
        "partial derivatives up to order 3" in told.replace("those up", "partial derivatives up") or "order 3" in told
    )


@pytest.mark.parametrize("sides", [{"right": "g"}, {"right": "h", "factor": "g"}])
def test_what_says_nothing_is_vacuous(tmp_path, sides):
    formulas = plane_formulas(f="det(c.p, c.p)", g="c.w - c.w", h="det(c.p, c.p.d(1))")
    claim = {"id": "1", "kind": "identity", "statement": "0 = 0", "curve": "plane", "left": "f"} | sides
    folder = written(tmp_path / "p", formulas, [claim])
    done = invoke("prove", "--paper", folder)
    assert done.exit_code == 1
    assert "VACUOUS (recorded: PROVED)" in done.output
    rows = json.loads(invoke("prove", "--paper", folder, "--rows", "--json").output)["rows"]
    assert len(rows) > 1
    assert {row["verdict"] for row in rows} <= {"VACUOUS", "INAPPLICABLE"}


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"left": "turnign"}, "the nearest are turning"),
        ({"kind": "vanishng"}, "the nearest are vanishing"),
        ({"curve": "plain"}, "the nearest are plane"),
        ({"lefft": "turning"}, "the nearest are left"),
        ({"assumes": ["γ"]}, "nearest are"),
        ({"assumes": ["nothing ≠ 0"]}, "vanishes on every curve"),
        ({"assumes": ["turnign ≠ 0"]}, "the nearest are turning"),
        ({"expected": "TRUE"}, "is unknown"),
        ({"expected": "CONTRADICTION"}, "a contradiction as the recorded verdict"),
        ({"statement": "\\u001b[2J"}, "cannot be printed"),
        ({"kind": "identity", "right": "turning_by_normal", "factor": "speed_squared^99999999"}, "too large"),
        (
            {"kind": "invariance", "left": None, "formula": "turning", "under": "scaling", "weight": 10**9},
            "not a weight",
        ),
        ({"kind": "degree", "left": None, "formula": "turning", "claimed": "6d", "least_d": 10**9}, "not a number"),
    ],
)
def test_words_that_nobody_knows(change, told, tmp_path):
    made = new_paper(tmp_path / "mine")
    with (made / "formulas.py").open("a") as file:
        file.write('\n\n@formula("e", on="plane")\ndef nothing(c):\n    return c.w - c.w\n')
    entry = {"id": "9", "kind": "vanishing", "statement": "0", "curve": "plane", "left": "turning"} | change
    lines = [f"{k} = {text_of(v)}" for k, v in entry.items() if v is not None]
    (made / "claims.toml").write_text("\n".join(["[[claim]]", *lines]).replace("\\\\u", "\\u"))
    assert invoke("prove", "--paper", made).exit_code == 2
    assert re.match(r"mine′*/claims\.toml, claim 1", refusal(made))
    assert told in refusal(made)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("[[claim]\n", "not TOML"),
        (".".join("a" * 5000) + " = 1\n", "not TOML"),
        ("claim = 3\n", "not a table of claims"),
        ("claim = [3]\n", "a claim is not a table"),
        ("formulas = ['../../x']\n", "the file"),
        ("formulas = 'x'\n", "formulas is 'x'"),
        ("colour = 1\n", "no 'colour'"),
        ("uses = ['nobody']\n", "there is no paper called"),
    ],
)
def test_tables_that_are_none(text, told, tmp_path):
    made = new_paper(tmp_path / "mine")
    (made / "claims.toml").write_text(text)
    done = invoke("prove", "--paper", made)
    assert done.exit_code != 0
    assert isinstance(done.exception, ExactSplineError) or "NOT ASKED" in done.output
    assert told in " ".join(f"{done.exception} {done.output}".split())


def test_folders_and_names_that_are_none(tmp_path):
    unknown = ((tmp_path / "none", "no such folder"), (tmp_path, "not the folder of a paper"), ("lifte", "nearest"))
    for name, told in unknown:
        with pytest.raises(ExactSplineError, match=told):
            named_papers([str(name)])
    for name in ("none.py:f", f"{tmp_path}:f", "f2x"):
        with pytest.raises(ExactSplineError):
            resolve(name)


def test_an_assumption_of_the_author_is_checked_on_every_curve(tmp_path):
    formulas = plane_formulas(f="c.p[0] * c.w", g="c.w * 1", x="c.p[0]")
    claim = {"id": "1", "kind": "zero set", "statement": "one", "curve": "plane", "formulas": ["f", "g"]}
    folder = written(tmp_path / "p", formulas, [claim | {"assumes": ["w", "x ≠ 0"]}, claim | {"id": "2"}])
    assumed, plain = claims_of(paper(folder))
    row = decide(assumed)
    assert row.verdict == Verdict.PROVED
    assert row.finding.assumptions == ("x ≠ 0",)
    assert decide(plain).verdict == Verdict.REFUTED
    finding = assumed.check(Evaluation(example("circle")))
    assert str(finding.witness).startswith("x vanishes")


WEIRD = [
    3,
    -1,
    1.5,
    True,
    [],
    [[]],
    {},
    "",
    " ",
    "x" * 10**5,
    ["x"],
    [3],
    "\x1b[2J",
    "f2^",
    "9d-",
    "max(",
    "1/0",
    10**30,
]
WEIRD += [float("nan"), "((" * 900, [["f2"]], "plane with " + "a," * 900 + "a", "9" * 1900, "2(d-1", "²", "f２"]


def test_whatever_stands_in_a_claim_is_read_or_refused():
    """One claim of every kind, each field in turn replaced by what nobody expects."""
    tried, kinds = 0, {}
    for source in papers():
        for table in source.claim_tables():
            kinds.setdefault(table.entry["kind"], (source, table))
    for source, table in kinds.values():
        for field in {*table.entry, "assumes", "curve", "of", "example", "witness", "expected"}:
            for value in WEIRD[tried % 6 :: 6]:
                tried += 1
                with suppress(ClaimError):
                    claim_of(Table(table.place, table.entry | {field: value}), source)
    assert tried > 500


# ---- the report


class Page(HTMLParser):
    """What a page asks of the network, and the words of its articles."""

    def __init__(self):
        super().__init__()
        self.asked, self.tags = [], []

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        self.asked += [value for name, value in attrs if name in ("src", "href")]


def test_the_report_is_complete_in_itself(tmp_path):
    folder = new_paper(tmp_path / "mine")
    text = (folder / "claims.toml").read_text().replace("weight = -2", "weight = -1").replace("small paper", "<b>paper")
    (folder / "claims.toml").write_text(text)
    file = tmp_path / "report.html"
    done = invoke("prove", "--paper", folder, "--report", file)
    assert done.exit_code == 1
    page, read = file.read_text(encoding="utf-8"), Page()
    read.feed(page)
    assert read.asked == []
    assert "script" not in read.tags
    assert read.tags.count("article") == 4
    assert "A &lt;b&gt;paper" in page
    for word in (
        "REFUTED",
        "at the parameter",
        "python-flint",
        "4 statements of the paper: 3 hold, 1 is refuted (1 error)",
    ):
        assert word in page
    for name, digest in paper(folder).digests().items():
        assert name in page
        assert digest in page
    assert invoke("prove", "--paper", folder, "--report", tmp_path / "no" / "where.html").exit_code != 0


# ---- one identity


def test_an_identity_holds_in_every_dimension_or_names_one_in_which_it_fails(tmp_path, monkeypatch):
    """Passed before: Lagrange's identity of the plane "for all curves", of which only those in the plane were asked."""
    bodies = {
        "speed": "norm2(c.gamma.d(1))",
        "area": "norm2(c.gamma.d(1)) * norm2(c.gamma.d(2)) - dot(c.gamma.d(1), c.gamma.d(2)) ** 2",
        "shadow": "(c.gamma.d(1)[0] * c.gamma.d(2)[1] - c.gamma.d(1)[1] * c.gamma.d(2)[0]) ** 2",
        "product": "dot(c.gamma.d(1), c.gamma.d(1)) * area(c)",
        "other": "speed(c) * area(c)",
    }
    text = "".join(f"@formula('e', on='curve')\ndef {name}(c):\n    return {body}\n" for name, body in bodies.items())
    monkeypatch.chdir(written(tmp_path / "paper", text, []))
    done = invoke("identity", "formulas.py:area = formulas.py:shadow")
    assert (done.exit_code, "not formulas.py:area = formulas.py:shadow in R3" in done.output) == (1, True)
    done = invoke("identity", "formulas.py:product = formulas.py:other")
    assert (done.exit_code, done.output.strip()) == (
        0,
        "formulas.py:product = formulas.py:other for all curves in R2 and R3",
    )


def test_one_identity_from_the_command_line(tmp_path, monkeypatch):
    new_paper(tmp_path / "mine")
    monkeypatch.chdir(tmp_path / "mine")
    assert "for all curves in R2" in invoke("identity", "formulas.py:turning = w^-3 * f2").output
    assert invoke("identity", "formulas.py:turning = formulas.py:turning_by_normal").exit_code == 0
    done = invoke("identity", "formulas.py:turning = 2 * turning_by_normal")
    assert done.exit_code == 1
    assert "the quotient is 1" in done.output
    for wrong in ("turning", "a = ", "formulas.py:nothing = f2", "formulas.py:turning == f2", "f1 f2 = f2"):
        assert isinstance(invoke("identity", wrong).exception, (ExactSplineError, SystemExit))


@pytest.mark.parametrize("trust", [True, False])
def test_an_error_names_its_line_and_a_degree_that_is_not_known_is_not_shown(trust, tmp_path):
    """Before, an unchecked formula failed in "line 0", and the degree found was ", not ≤ 0"."""
    formulas = plane_formulas(turn="det(c.gamma.d(1), c.gamma.d(2))", part="det(c.gamma.d(1), c.gamma)[0]")
    claims = [
        {"id": "1", "kind": "degree", "statement": "a", "curve": "plane", "formula": "turn", "claimed": "0"}
        | {"relation": "≤", "measure": "true"},
        {"id": "2", "kind": "vanishing", "statement": "b", "curve": "plane", "left": "part"},
    ]
    folder = written(tmp_path / "p", formulas, claims)
    rows = invoke("prove", "--paper", str(folder), "--json", *["--trust"] * trust)
    degree, vanishing = [row for row in json.loads(rows.output)["rows"] if not row["curve"]]
    line = next(i for i, text in enumerate((folder / "formulas.py").read_text().splitlines(), 1) if "[0]" in text)
    assert f"formulas.py, line {line}, part: " in vanishing["witness"]
    assert degree["verdict"] == "REFUTED", "where w = 1 the degree is known"
    text = invoke("prove", "--paper", str(folder), *["--trust"] * trust).output.split("On the")[0]
    assert not re.search(r"(^|\s), not ≤ 0", text)


def test_the_check_of_a_degree_shows_the_degree_that_is_claimed(tmp_path, monkeypatch, capsys):
    """Before, it printed the nominal degree whatever the measure, and that of rational curves in lowest terms."""
    monkeypatch.chdir(tmp_path)
    degree = {"kind": "degree", "statement": "s", "curve": "plane", "of": "polynomial", "expected": "REFUTED"}
    told = {
        "true": (degree | {"id": "1", "formula": "turn", "claimed": "2d - 3"}, "at d = 3: 2, not 3"),
        "lowest terms": (degree | {"id": "2", "formula": "v", "claimed": "d"}, "d − 1"),
    }
    formulas = plane_formulas(turn="det(c.gamma.d(1), c.gamma.d(2))", v="c.gamma.d(1)")
    folder = written(tmp_path / "p", formulas, [claim | {"measure": name} for name, (claim, _) in told.items()])
    for claim, (_, shown) in zip(claims_of(paper(folder)), told.values(), strict=True):
        exec("\n".join(check(claim)), {})
        assert shown in capsys.readouterr().out
