"""Papers of anybody: folders loaded by path, formulas checked before they run, claims decided like those that come with
the library.
"""

import io
import re
import time
from contextlib import redirect_stdout, suppress
from dataclasses import fields
from enum import StrEnum
from html.parser import HTMLParser
from pathlib import Path
from random import Random
from shutil import copytree, ignore_patterns

import pytest
from typer.testing import CliRunner

import exactspline
from exactspline.cli import app
from exactspline.errors import ClaimError, ExactSplineError, FormulaError
from exactspline.papers import Table, load_paper, named_papers, paper, papers, resolve
from exactspline.papers.formula_check import formulas_of
from exactspline.papers.new import write_new_paper
from exactspline.splines.examples import example
from exactspline.symbolic.assumptions import Assumption
from exactspline.verification.claims import claim_of, claims_of
from exactspline.verification.evaluation import Evaluation
from exactspline.verification.ledger import audit, proved
from exactspline.verification.verdict import OUTSIDE, PROVED, REFUTED, VERIFIED
from tests.test_false_claims import MAKERS, false_claims, is_true_after_all

DOCS = Path(__file__).parent.parent / "docs" / "your-own-paper.md"
LANGUAGE = (
    "from exactspline import complex_product, cross, det, dot, formula, join, norm2, perp, rational, ruled, wronskian\n"
)


def run(*arguments):
    return CliRunner().invoke(app, [str(a) for a in arguments])


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
    assert run("new-paper", "my-paper").exit_code == 0
    assert run("prove", "--paper", "my-paper").exit_code == 0
    with Path("my-paper/formulas.py").open("a") as file:
        file.write("\n\n" + formula)
    with Path("my-paper/claims.toml").open("a") as file:
        file.write("\n" + claim)
    done = run("prove", "--paper", "my-paper", "--report", "report.html")
    assert done.exit_code == 1
    assert "REFUTED (recorded: PROVED)" in done.output
    assert "at the parameter" in done.output
    assert time.perf_counter() - start < 5
    told = run("errata", "--paper", "my-paper").output
    assert "1. under similarities" in told
    Path("my-paper/claims.toml").write_text(
        Path("my-paper/claims.toml").read_text().replace("weight = 1", "weight = 2")
    )
    assert run("prove", "--paper", "my-paper").exit_code == 0
    shown = io.StringIO()
    with redirect_stdout(shown):
        exec(python, {})  # the page's own words
    said = re.findall(r"# (.*)", python)
    assert shown.getvalue().splitlines()[: len(said)] == said


@pytest.mark.skipif(not DOCS.exists(), reason="the documents are in the checkout only")
def test_every_command_of_the_page_works(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    run("new-paper", "my-paper")
    exactspline.save(example("ellipse"), "my.json")
    lines = re.findall(r"^exactspline (.*?)\s{2,}#", DOCS.read_text(encoding="utf-8"), re.MULTILINE)
    tried = [line for line in lines if "new-paper" not in line and "--paper all" not in line]
    assert len(tried) >= 9
    for line in tried:
        arguments = [a.strip('"') for a in re.findall(r'"[^"]*"|\S+', line)]
        done = run(*arguments)
        assert done.exit_code == 0, (line, done.output, done.exception)


def test_the_new_paper_is_whole_and_nothing_is_overwritten(tmp_path):
    made = write_new_paper(tmp_path / "mine")
    assert {path.name for path in made} == {"formulas.py", "claims.toml", "README.md", "arch.json"}
    own = load_paper(tmp_path / "mine")
    assert own.title == "A small paper, to be changed"
    assert all(row.as_recorded for row in audit(claims_of(own)))
    with pytest.raises(ClaimError, match="is not empty"):
        write_new_paper(tmp_path / "mine")
    assert run("new-paper", tmp_path / "mine").exit_code == 2 or run("new-paper", tmp_path / "mine").exception


# ---- the same code for all


def test_a_built_in_paper_by_its_folder_is_the_paper():
    for each in papers():
        assert load_paper(str(each.folder)) is each
    assert named_papers(["all"]) == papers()
    assert named_papers([]) == tuple(p for p in papers() if p.default)


def test_a_copy_of_a_built_in_paper_is_decided_alike(tmp_path):
    """The same tables, the formulas named from the original: every verdict is the one of the original."""
    source = paper("lifted")
    copytree(str(source.folder), tmp_path / "copy", ignore=ignore_patterns("*.py*", "paper.toml"))
    told = f'claims = {text_of(source.claim_files)}\nuses = ["chen_riesenfeld_cohen_2007", "lifted"]\n'
    (tmp_path / "copy" / "paper.toml").write_text(told)
    copied = claims_of(load_paper(tmp_path / "copy"))
    assert [claim.key for claim in copied] == [claim.key for claim in claims_of(source)]
    for mine, original in list(zip(copied, claims_of(source), strict=True))[:12]:
        assert proved(mine).verdict == proved(original).verdict


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
    assert [proved(claims_of(source)[0]).verdict for source in sources] == [PROVED, REFUTED, REFUTED]
    assert resolve(f"{one}:f").name == "f"
    (one / "formulas.py").write_text(LANGUAGE + body.format("c.w", "c.w * 5"))
    assert proved(claims_of(load_paper(one))[0]).verdict == REFUTED


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
    exactspline.save(curve, own / "curves" / "half.json")
    (row,) = audit(claims_of(load_paper(own)))
    assert row.verdict in (VERIFIED, REFUTED)
    (own / "curves" / "bad.json").write_text("{")
    with pytest.raises(ExactSplineError, match=r"bad\.json"):
        claims_of(load_paper(own))


# ---- formulas are checked before they run


def formula(body, on="plane", before=""):
    lines = "".join(f"    {line}\n" for line in body.split("\n"))
    return f"{LANGUAGE}{before}@formula('e', on={on!r})\ndef f(c):\n{lines}"


ESCAPES = [
    "import os",
    "from os import system",
    "from exactspline.papers import run_file",
    "from exactspline.papers.loading import run_file",
    "from exactspline import *",
    "from . import x",
    "from exactspline import det as formula",
    "__import__('os').system('true')",
    "x = 1",
    "class A: pass",
    "async def f(c): return c.w",
    "@formula('x')\ndef f(c): return c.w",
    LANGUAGE + "@formula('x', on=open('x'))\ndef f(c): return c.w",
    LANGUAGE + "@formula(print(1))\ndef f(c): return c.w",
    LANGUAGE + "@formula(*'x')\ndef f(c): return c.w",
    LANGUAGE + "@formula('\\x1b[2J')\ndef f(c): return c.w",
    LANGUAGE + "@formula('x', symbol='<script>')\ndef f(c): return c.w",
    LANGUAGE + "@det\ndef f(c): return c.w",
    LANGUAGE + "@formula('x')\n@formula('x')\ndef f(c): return c.w",
    LANGUAGE + "@formula('x')\ndef f(c, d=print(1)): return c.w",
    LANGUAGE + "@formula('x')\ndef f(c: print(1)): return c.w",
    LANGUAGE + "@formula('x')\ndef f(c) -> print(1): return c.w",
    LANGUAGE + "@formula('x')\ndef f(*c): return c.w",
    LANGUAGE + "@formula('x')\ndef __f(c): return c.w",
    LANGUAGE + "@formula('x')\ndef det(c): return c.w",
    *map(
        formula,
        [
            "return ().__class__.__base__.__subclasses__()",
            "return c.__class__",
            "return c.p.__init__.__globals__",
            "return c.calls(c)",
            "return c.p.mapped(c)",
            "return c.p.components",
            "return c.w.ring",
            "return c.w.degree",
            "return c.p.d.__self__",
            "c = c.w\nreturn c.p",
            "return c.p.d.__func__(c.p)",
            "return (lambda: 1)()",
            "return [x for x in c.p]",
            "return {x: x for x in c.p}",
            "return f'{c.__class__}'",
            "return '{0.__class__}'.format(c)",
            "return c.w if c.w else c.p",
            "return c.w and c.p",
            "return not c.w",
            "return c.w < 1",
            "return c.w == 1",
            "return open('x')",
            "return eval('1')",
            "return getattr(c, 'p')",
            "return globals()",
            "return det.__globals__",
            "return det",
            "return f(c)",
            "return det(*c.p)",
            "return det(c.p, key=c.p)",
            "return rational(c.w)",
            "return rational('__import__')",
            "return rational('1/0')",
            "return formula('x')(det)",
            "return (y := c.w)",
            "return c.w**c.w",
            "return c.w**65",
            "return ((c.w**60)**60)**60",
            "return 9**64**64",
            "return c.p.d(21)",
            "return c.p.d(c.w)",
            "return c.p.d(1, by=c)",
            "return c.p[c.w]",
            "return c.p[-1:]",
            "return wronskian(c.p, order=c)",
            "return c.w @ c.w",
            "return c.w % 2",
            "return c.w // 2",
            "return c.w << 2",
            "return True * c.w",
            "return 0.5 * c.w",
            "return 1 / 2 * c.w",
            "return 'a'",
            "return None",
            "return {**c}",
            "return [*c.p]",
            "return c.q",
            "pass",
            "yield c.w",
            "return (yield c.w)",
            "global det\nreturn c.w",
            "nonlocal c\nreturn c.w",
            "del c\nreturn c",
            "import os\nreturn c.w",
            "for x in c.p: pass\nreturn c.w",
            "while 1: pass\nreturn c.w",
            "with c: pass\nreturn c.w",
            "try: pass\nexcept: pass\nreturn c.w",
            "assert c.w\nreturn c.w",
            "raise c.w",
            "x = c.p\nx.y = 1\nreturn x",
            "x = c.p\nx[0] = 1\nreturn x",
            "det = c.p\nreturn det(c.p)",
            "__builtins__ = c.p\nreturn c.w",
            "x = y = c.w\nreturn x",
            "x += c.w\nreturn x",
            "a, b = c.p\nreturn a",
            "a, *b = c.p, c.p\nreturn a",
            "x: open('x') = c.w\nreturn x",
            "def g(): pass\nreturn c.w",
            "match c:\n    case 1: pass\nreturn c.w",
            "return " + "c.w + " * 30000 + "c.w",
            "return " + "-" * 20000 + "c.w",
            "return " + "9" * 300,
            "return " + "9" * 5000,
        ],
    ),
    "\0",
    "def f(:",
    LANGUAGE
    + "def h0(x):\n    return x + x\n"
    + "".join(f"def h{i + 1}(x):\n    return h{i}(x) * h{i}(x)\n" for i in range(20)),
    "#" * 200_001,
]


@pytest.mark.parametrize("text", ESCAPES, ids=range(len(ESCAPES)))
def test_nothing_but_formulas_passes(text):
    with pytest.raises(FormulaError) as caught:
        formulas_of(text, "theirs.py", {})
    assert caught.value.where.startswith("theirs.py")
    assert caught.value.remedy


@pytest.mark.parametrize("name", ["ring", "mapped", "operands", "calls", "beside", "made", "p", "x", "__class__", "ρ"])
def test_a_constant_opens_no_other_door(name):
    """Its name could be that of something inside."""
    with pytest.raises(FormulaError):
        formulas_of(formula(f"return c.{name}", f"plane with {name}"), "f.py", {})


@pytest.mark.parametrize("body", ["return c.w.context", "return c.p[0].context", "x = c.w\nreturn x.context"])
def test_constants_are_those_of_the_argument(body):
    with pytest.raises(FormulaError, match="has no 'context'"):
        formulas_of(formula(body, "plane with context"), "f.py", {})
    helper = "def h(x):\n    return x.context\n"
    with pytest.raises(FormulaError, match="has no 'context'"):
        formulas_of(formula("return h(c.w)", "plane with context", helper), "f.py", {})
    assert formulas_of(formula("return c.context", "plane with context"), "f.py", {})


def test_what_is_a_formula_passes():
    text = formula(
        "a, b = c.p, c.p.d(2)\nx = h(a)\nreturn det(a, b) * rational('-1/2') ** 3 / x",
        before="def h(v):\n    return norm2(v)\n",
    )
    assert list(formulas_of(text, "f.py", {})) == ["f"]
    built_in = {"chen_riesenfeld_cohen_2007.plane:f2": resolve("f2")}
    imported = (
        "from __future__ import annotations\nfrom exactspline.papers.chen_riesenfeld_cohen_2007.plane import f2\n"
    )
    found = formulas_of(imported + formula("return f2(c) * c.delta", "plane with delta"), "f.py", built_in)
    assert list(found) == ["f"]


def test_no_line_runs_before_all_are_read(tmp_path):
    """The last line is wrong: the first has not run."""
    sign = tmp_path / "sign"
    text = f"open({str(sign)!r}, 'w').close()\n"
    with pytest.raises(FormulaError):
        formulas_of(LANGUAGE + text, "f.py", {})
    folder = written(tmp_path / "p", f"\n{text}@formula('e')\ndef f(c):\n    return c.w\n", [])
    with pytest.raises(FormulaError, match=r"line 3.*--trust"):
        load_paper(folder)
    assert not sign.exists()
    assert list(load_paper(folder, trust=True).formulas) == ["f"]
    assert sign.exists()


def test_formulas_cannot_reach_the_built_in_names():
    (found,) = formulas_of(formula("return c.w"), "f.py", {}).values()
    assert found.function.__globals__["__builtins__"] == {}


def test_links_lead_nowhere(tmp_path):
    folder = write_new_paper(tmp_path / "mine")[0].parent
    (folder / "curves" / "round").symlink_to(folder)
    (folder / "passwords").symlink_to("/etc/passwd")
    assert set(load_paper(folder).digests()) == {"README.md", "claims.toml", "curves/arch.json", "formulas.py"}


# ---- errors for authors


CLAIM = {"id": "1", "kind": "vanishing", "statement": "f is 0", "curve": "plane", "left": "f"}
ERRORS = {
    "return c.p + c.w": ("TypeError", "line 4"),
    "return c.p[5]": ("IndexError", "line 4"),
    "return dot(c.p, join(c.p, c.w))": ("vectors of 2 and 3 components", "line 4"),
    "return c.w / (c.w - c.w)": ("vanishes on every curve", "line 4"),
    "return c.w / 0": ("ZeroDivisionError", "line 4"),
    "return c.p * c.p": ("a product of two vectors", "line 4"),
    "return c": ("the value is a Curve", "f:"),
    "return 3": ("the number 3", "f:"),
    "return c.p[1:1]": ("without components", "f:"),
    "return join(3, 4)": ("vector of numbers", "f:"),
    "return ruled(c.w, c.w)": ("no vectors", "f:"),
    "return (norm2(c.gamma.d(1)) + norm2(c.gamma.d(2)) + c.gamma[0] * c.gamma.d(3)[1]) ** 10": ("terms", "line 4"),
}


@pytest.mark.parametrize("body", ERRORS)
def test_what_goes_wrong_in_a_formula_names_file_and_line(body, tmp_path):
    problem, line = ERRORS[body]
    folder = written(
        tmp_path / "p", f"@formula('e', on='plane')\ndef f(c):\n    return {body.removeprefix('return ')}\n", [CLAIM]
    )
    told = proved(claims_of(load_paper(folder))[0]).witness
    assert problem in told
    assert f"formulas.py, {line}" in told
    assert run("prove", "--paper", folder).exit_code in (1, 2)


def test_a_trusted_formula_that_branches_names_file_and_line(tmp_path):
    formulas = "@formula('e', on='plane')\ndef f(c):\n    return c.p if c.w else c.p.d(1)\n"
    folder = written(tmp_path / "p", formulas, [CLAIM])
    with pytest.raises(FormulaError, match=r"line 4: a formula branches"):
        load_paper(folder)
    told = proved(claims_of(load_paper(folder, trust=True))[0]).witness
    assert "formulas.py, line 4" in told
    assert "must not branch" in told


def test_a_derivative_that_the_kind_does_not_have(tmp_path):
    folder = written(
        tmp_path / "p",
        "@formula('e', on='implicit')\ndef f(c):\n    return c.fxx.d(2)\n",
        [CLAIM | {"curve": "implicit"}],
    )
    told = proved(claims_of(load_paper(folder))[0]).witness
    assert "formulas.py, line 4" in told
    assert (
        "partial derivatives up to order 3" in told.replace("those up", "partial derivatives up") or "order 3" in told
    )


def test_what_says_nothing_is_vacuous(tmp_path):
    formulas = plane_formulas(f="det(c.p, c.p)", g="c.w - c.w")
    claim = {"id": "1", "kind": "identity", "statement": "0 = 0", "curve": "plane", "left": "f", "right": "g"}
    folder = written(tmp_path / "p", formulas, [claim])
    done = run("prove", "--paper", folder)
    assert done.exit_code == 1
    assert "VACUOUS (recorded: PROVED)" in done.output


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"left": "turnign"}, "the nearest are turning"),
        ({"kind": "vanishng"}, "the nearest are vanishing"),
        ({"curve": "plain"}, "the nearest are plane"),
        ({"lefft": "turning"}, "the nearest are left"),
        ({"assumes": ["γ"]}, "nearest are"),
        ({"assumes": ["curvature_squared ≠ 0"]}, "no polynomial"),
        ({"assumes": ["nothing ≠ 0"]}, "vanishes on every curve"),
        ({"assumes": ["turnign ≠ 0"]}, "the nearest are turning"),
        ({"key": "2-left"}, "does not begin with the id"),
        ({"statement": 7}, "7 is no text"),
        ({"expected": "TRUE"}, "is unknown"),
        ({"statement": "\\u001b[2J"}, "cannot be printed"),
        ({"kind": "identity", "right": "turning_by_normal", "factor": "speed_squared^99999999"}, "too large"),
        ({"kind": "invariance", "left": None, "formula": "turning", "under": "scaling", "weight": 10**9}, "no weight"),
        ({"kind": "degree", "left": None, "formula": "turning", "claimed": "6d", "least_d": 10**9}, "no number"),
    ],
)
def test_words_that_nobody_knows(change, told, tmp_path):
    made = write_new_paper(tmp_path / "mine")[0].parent
    with (made / "formulas.py").open("a") as file:
        file.write('\n\n@formula("e", on="plane")\ndef nothing(c):\n    return c.w - c.w\n')
    entry = {"id": "9", "kind": "vanishing", "statement": "0", "curve": "plane", "left": "turning"} | change
    lines = [f"{k} = {text_of(v)}" for k, v in entry.items() if v is not None]
    (made / "claims.toml").write_text("\n".join(["[[claim]]", *lines]).replace("\\\\u", "\\u"))
    done = run("prove", "--paper", made)
    assert isinstance(done.exception, ExactSplineError)
    assert re.match(r"mine′*/claims\.toml, claim 1", str(done.exception))
    assert told in str(done.exception)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("[[claim]\n", "no TOML"),
        ("claim = 3\n", "no table of claims"),
        ("claim = [3]\n", "a claim is no table"),
        ("formulas = ['../../x']\n", "the file"),
        ("formulas = 'x'\n", "formulas is 'x'"),
        ("colour = 1\n", "no 'colour'"),
        ("uses = ['nobody']\n", "no paper is called"),
    ],
)
def test_tables_that_are_none(text, told, tmp_path):
    made = write_new_paper(tmp_path / "mine")[0].parent
    (made / "claims.toml").write_text(text)
    done = run("prove", "--paper", made)
    assert isinstance(done.exception, ExactSplineError)
    assert told in str(done.exception)


def test_folders_and_names_that_are_none(tmp_path):
    for name, told in ((tmp_path / "none", "no such folder"), (tmp_path, "no folder of a paper"), ("lifte", "nearest")):
        with pytest.raises(ExactSplineError, match=told):
            named_papers([str(name)])
    for name in ("none.py:f", f"{tmp_path}:f", "f2x"):
        with pytest.raises(ExactSplineError):
            resolve(name)


def test_an_assumption_of_the_author_is_checked_on_every_curve(tmp_path):
    formulas = plane_formulas(f="c.p[0] * c.w", g="c.w * 1", x="c.p[0]")
    claim = {"id": "1", "kind": "zero set", "statement": "one", "curve": "plane", "formulas": ["f", "g"]}
    folder = written(tmp_path / "p", formulas, [claim | {"assumes": ["w", "x ≠ 0"]}, claim | {"id": "2"}])
    assumed, plain = claims_of(load_paper(folder))
    row = proved(assumed)
    assert row.verdict == PROVED
    assert row.assumptions == ["x ≠ 0"]
    assert proved(plain).verdict == REFUTED
    finding = assumed.check(Evaluation(example("circle")))
    assert finding.witness.startswith(OUTSIDE + "x vanishes")


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
            for value in WEIRD[tried % 3 :: 3]:
                tried += 1
                with suppress(ClaimError):
                    claim_of(Table(table.place, table.entry | {field: value}), source)
    assert tried > 1000


def test_whatever_stands_in_a_file_of_formulas_is_read_or_refused():
    """Letters taken out, doubled, exchanged and put in, 400 times: nothing but an error of ours."""
    text, random, passed = formula("a = c.p.d(1)\nreturn det(a, c.p) / norm2(a) ** 2 - c.w * 3"), Random(5), 0
    for _ in range(400):
        letters = list(text)
        for _ in range(random.randrange(1, 4)):
            i = random.randrange(len(text) // 2, len(letters))
            letters[i : i + random.randrange(2)] = random.choice("().,*/+-[]:=@_ \n'0dcpw#\\{}é\0")
        with suppress(FormulaError):
            passed += bool(formulas_of("".join(letters), "f.py", {}))
    assert 0 < passed < 400


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
    folder = write_new_paper(tmp_path / "mine")[0].parent
    text = (folder / "claims.toml").read_text().replace("weight = -2", "weight = -1").replace("small paper", "<b>paper")
    (folder / "claims.toml").write_text(text)
    file = tmp_path / "report.html"
    done = run("prove", "--paper", folder, "--report", file)
    assert done.exit_code == 1
    page, read = file.read_text(encoding="utf-8"), Page()
    read.feed(page)
    assert read.asked == []
    assert "script" not in read.tags
    assert read.tags.count("article") == 4
    assert "A &lt;b&gt;paper" in page
    for word in ("REFUTED", "at the parameter", "python-flint", "Of 4 claims 3 hold and 1 fail"):
        assert word in page
    for name, digest in load_paper(folder).digests().items():
        assert name in page
        assert digest in page
    assert run("prove", "--paper", folder, "--report", tmp_path / "no" / "where.html").exit_code != 0


# ---- one identity


def test_one_identity_from_the_command_line(tmp_path, monkeypatch):
    write_new_paper(tmp_path / "mine")
    monkeypatch.chdir(tmp_path / "mine")
    assert "for all curves in R2" in run("prove", "--identity", "formulas.py:turning = w^-3 * f2").output
    assert run("prove", "--identity", "formulas.py:turning = formulas.py:turning_by_normal").exit_code == 0
    done = run("prove", "--identity", "formulas.py:turning = 2 * turning_by_normal")
    assert done.exit_code == 1
    assert "the quotient is 1" in done.output
    for wrong in ("turning", "a = ", "formulas.py:nothing = f2", "formulas.py:turning == f2", "f1 f2 = f2"):
        assert isinstance(run("prove", "--identity", wrong).exception, (ExactSplineError, SystemExit))


# ---- false claims of every kind in a folder

OWN = """
@formula("e", on="plane")
def turning(c):
    return det(c.gamma.d(1), c.gamma.d(2))


@formula("e", on="plane")
def velocity(c):
    return c.gamma.d(1)


@formula("e", on="plane")
def speed_squared(c):
    return norm2(velocity(c))


@formula("e", on="plane")
def curvature_squared(c):
    return turning(c) ** 2 / speed_squared(c) ** 3


@formula("e", on="plane pair")
def circle(c):
    first = c.first.gamma
    way = c.second.gamma - first
    return norm2(way) * det(first.d(1), first.d(2)) - 2 * norm2(first.d(1)) * det(first.d(1), way)


@formula("e", on="plane pair")
def tangent(c):
    return det(c.first.gamma.d(1), c.second.gamma - c.first.gamma)


@formula("e", on="hodograph")
def length(c):
    return norm2(c.gamma.d(1))


@formula("e", on="hodograph")
def speed(c):
    return c.speed * c.speed


@formula("e", on="implicit")
def bending(c):
    return det(c.gamma.d(1), c.gamma.d(2))


@formula("e", on="implicit")
def in_derivatives(c):
    t = perp(c.gradient_f)
    return c.pace**3 * (t[0] * dot(c.hessian_fx, t) + t[1] * dot(c.hessian_fy, t))


@formula("e", on="plane with delta")
def scaled(c):
    return norm2(c.gamma.d(1) * c.delta)


@formula("e", on="plane with delta")
def twice(c):
    return c.delta * c.delta * speed_squared(c)
"""
WEIGHTS = [
    *[
        ("turning", u, w)
        for u, w in (("reparametrization", 3), ("affine map", 1), ("similarity", 2), ("reflection", 1))
    ],
    *[("curvature_squared", u, w) for u, w in (("reparametrization", 0), ("similarity", -2), ("scaling", -2))],
    *[("speed_squared", u, w) for u, w in (("reparametrization", 2), ("Möbius map", 2), ("scaling", 2))],
]
SIDES = [
    ("length", "speed", "hodograph"),
    ("bending", "in_derivatives", "implicit"),
    ("scaled", "twice", "plane with delta"),
]


def of_own_kinds():
    """True claims of the kinds that authors make, each with what is made of it and false."""
    for name, under, weight in WEIGHTS:
        claim = {"kind": "invariance", "formula": name, "under": under, "weight": weight}
        yield claim, [claim | {"weight": weight + k} for k in (1, -1, 3)]
    for name, order in (("circle", 2), ("tangent", 1)):
        claim = {"kind": "contact", "curve": "plane pair", "formula": name, "order": order}
        wrong = [claim | {"order": n} for n in range(5) if n != order]
        yield claim, [*wrong, *[claim | {"order": order + k, "relation": "≥"} for k in (1, 2)]]
    claim = {"kind": "sign", "formula": "speed_squared", "squares": ["velocity"]}
    wrong = [{"sign": "≤ 0"}, {"sign": "< 0"}, {"sign": "> 0"}, {"squares": ["turning"]}, {"factor": "2"}]
    yield (
        claim,
        [*[claim | each for each in wrong], claim | {"formula": "turning"}, claim | {"squares": ["velocity"] * 2}],
    )
    strict = claim | {"sign": "> 0", "assumes": ["γ′"]}
    yield strict, [strict | {"assumes": []}, strict | {"assumes": ["w"]}, strict | {"assumes": ["γ′ ≢ 0"]}]
    for left, right, curve in SIDES:
        claim = {"kind": "identity", "left": left, "right": right, "curve": curve}
        yield claim, [claim | {"factor": factor} for factor in ("2", "-1", "1/3")]
        yield claim, [{"kind": "vanishing", "left": name, "curve": curve} for name in (left, right)]


def as_entry(claim):
    """A claim as it stands in a file."""
    left_out = {"paper", "id", "key", "error", "words", "place", "status", "expected", "source", "witness", "vacuous"}
    values = {f.name: getattr(claim, f.name) for f in fields(claim) if f.name not in left_out}
    told = {name: str(v) if isinstance(v, StrEnum) else v for name, v in values.items() if v not in ((), "")}
    return told | {"kind": claim.kind}


def test_the_claims_from_which_false_ones_are_made_hold(tmp_path):
    claims = [{"id": f"T{i}", "statement": "true", "curve": "plane"} | c for i, (c, _) in enumerate(of_own_kinds())]
    for claim in claims_of(load_paper(written(tmp_path / "true", OWN, claims))):
        assert proved(claim).verdict == PROVED, claim


def test_false_claims_of_every_kind_in_a_folder_are_never_proved(tmp_path):
    own = [{"curve": "plane"} | each for _, wrong in of_own_kinds() for each in wrong]
    others = []
    for kind in MAKERS:
        made = [f for claim, f, _ in false_claims(kind) if not is_true_after_all(claim, f) and cheap(f)]
        others += [as_entry(f) for f in made[:: max(1, len(made) // 25)]]
    head = 'uses = ["chen_riesenfeld_cohen_2007", "lifted"]\n'
    entries = [
        [{"id": f"F{i}", "statement": "false"} | each for i, each in enumerate(false)] for false in (own, others)
    ]
    claims = claims_of(load_paper(written(tmp_path / "own", OWN, entries[0])))
    claims += claims_of(load_paper(written(tmp_path / "others", "", entries[1], head)))
    assert len(claims) == len(own) + len(others) >= 200
    assert {claim.kind for claim in claims} >= {*MAKERS, "invariance", "contact", "sign"}
    fooled = [claim for claim in claims if proved(claim).verdict in (PROVED, VERIFIED)]
    assert fooled == []
    curve = Evaluation(example("rational_cubic_s"))
    everywhere = [c for c in claims[: len(own)] if c.kind != "sign" and c.speaks_of(2, False)]
    assert len(everywhere) > 40
    assert [claim for claim in everywhere if claim.check(curve).verdict == VERIFIED] == []


def cheap(claim):
    """Whether it takes less than a second to decide."""
    return "by_parameter" not in str(claim.named) and claim.curve != "pair"
