"""Formulas of others are checked before they run: nothing but formulas passes, and nothing runs before all is read."""

from contextlib import suppress
from random import Random

import pytest

from exactspline import paper
from exactspline.errors import FormulaError
from exactspline.papers import resolve
from exactspline.papers.formula_check import formulas_of
from tests.support.command import new_paper
from tests.verification.test_own_paper import LANGUAGE, written


def formula(body, on="plane", before=""):
    lines = "".join(f"    {line}\n" for line in body.split("\n"))
    return f"{LANGUAGE}{before}@formula('e', on={on!r})\ndef f(c):\n{lines}"


@pytest.mark.parametrize(
    ("kind", "by", "known"),
    [("surface", "s", 'by="u" or by="v"'), ("plane", "u", 'by="s"'), ("plane", "s̄", 'by="s"'), ("pair", "v", "s̄")],
)
def test_a_parameter_that_the_kind_lacks_is_refused_at_load(kind, by, known):
    """Before: any of the four letters passed, and the formula was refused when it was first evaluated."""
    operand = {"surface": "c.S", "pair": "c.first.p"}.get(kind, "c.p")
    with pytest.raises(FormulaError, match="the parameter of a derivative") as error:
        formulas_of(formula(f"return {operand}.d(1, by={by!r})", kind), "f.py", {})
    assert known in str(error.value)


ESCAPES = [
    "import os",
    "from os import system",
    "from exactspline.papers import run_file",
    "from exactspline.papers.loading import run_file",
    "from exactspline import *",
    "from . import x",
    "from exactspline.language import det as formula",
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


@pytest.mark.parametrize(
    "name", ["ring", "mapped", "operands", "calls", "additional", "made", "p", "x", "__class__", "ρ"]
)
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
    built_in = {"papers.chen_riesenfeld_cohen_2007.plane:f2": resolve("f2")}
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
        paper(folder)
    assert not sign.exists()
    assert list(paper(folder, trust=True).formulas) == ["f"]
    assert sign.exists()


def test_formulas_cannot_reach_the_built_in_names():
    (found,) = formulas_of(formula("return c.w"), "f.py", {}).values()
    assert found.function.__globals__["__builtins__"] == {}


def test_links_lead_nowhere(tmp_path):
    folder = new_paper(tmp_path / "mine")
    (folder / "curves" / "round").symlink_to(folder)
    (folder / "passwords").symlink_to("/etc/passwd")
    assert set(paper(folder).digests()) == {"README.md", "claims.toml", "curves/arch.json", "formulas.py"}


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
