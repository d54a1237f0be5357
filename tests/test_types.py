"""Types: what may be Any in a public signature, why types are ignored, what a checker sees at the front door."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

import exactspline
from tests.precision import precision

ROOT = Path(exactspline.__file__).parent
CHECKOUT = ROOT.parent

#: What a formula returns depends on the formula and on the reading: a number, a spline, a vector, a surface, a tree.
RESULT = "what a formula returns depends on the formula and on the reading"
DEGREE = "a degree is a number, two of them or an expression, as the reading counts"
OPERANDS = "operands are of one reading, which the argument does not know"
DATA = "data just parsed: what it holds is what is checked"
PEERS = "runs over the polynomials of any library, typed or not"
#: Folders that speak to what has no types.
UNTYPED = {"batch/grade/": "asks other libraries, some in other processes and languages, and reads their JSON"}
#: Public signatures with Any, each with its reason.
ALLOWED: dict[str, str] = {
    "batch/bench/inline.py: bisector_patch": PEERS,
    "batch/bench/inline.py: cross": PEERS,
    "batch/bench/inline.py: differences": PEERS,
    "batch/bench/inline.py: dot": PEERS,
    "batch/bench/inline.py: f2": PEERS,
    "batch/bench/inline.py: g2": PEERS,
    "batch/bench/inline.py: one_parameter": PEERS,
    "batch/bench/inline.py: torsion": PEERS,
    "batch/bench/inline.py: vertices": PEERS,
    "language/argument.py: Argument.calls": RESULT,
    "language/argument.py: Evaluated.calls": RESULT,
    "language/argument.py: Evaluated.mapped": OPERANDS,
    "language/argument.py: Evaluated.operands": OPERANDS,
    "language/arguments.py: Operands.mapped": OPERANDS,
    "language/arguments.py: Operands.operands": OPERANDS,
    "language/kind.py: Kind.rules": OPERANDS,
    "language/operand.py: Counted.degree": DEGREE,
    "language/rational.py: Rational.degree": DEGREE,
    "language/reading.py: Reading.of": RESULT,
    "language/services.py: service": "a service is whatever was registered under its name",
    "programs/compiled.py: compiled": "runs over whatever integers and polynomials it is given",
    "readings/tree.py: Traced.calls": RESULT,
    "readings/tree.py: applied": RESULT,
    "readings/tree.py: evaluate": RESULT,
    "verification/coq/explicit.py: ExplicitCurve.argument": RESULT,
    "verification/coq/settings.py: Setting.argument": RESULT,
}


def modules() -> list[Path]:
    """All modules but those of single papers, whose formulas keep their plain form."""
    return [p for p in sorted(ROOT.rglob("*.py")) if p.parent.parent != ROOT / "papers"]


def loose_names(tree: ast.Module) -> set[str]:
    """Any, and the names of types that are made of it in this module."""
    found = {"Any"}
    for node in tree.body:
        if not isinstance(node, (ast.Assign, ast.AnnAssign)):
            continue
        named = node.targets[0] if isinstance(node, ast.Assign) else node.target
        is_type = isinstance(node.value, (ast.Name, ast.Subscript, ast.BinOp))
        if isinstance(named, ast.Name) and is_type and mentions(node.value, found):
            found.add(named.id)
    return found


def mentions(tree: ast.AST | None, names: set[str]) -> bool:
    """Whether one of the names stands somewhere in a syntax tree."""
    return tree is not None and any(isinstance(n, ast.Name) and n.id in names for n in ast.walk(tree))


def loose(body: list[ast.stmt], names: set[str], owner: str = "") -> list[str]:
    """The public functions and methods that have one of the names in their signature."""
    found = []
    for node in body:
        if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
            found += loose(node.body, names, f"{node.name}.")
        elif isinstance(node, ast.FunctionDef) and not node.name.startswith("_"):
            a = node.args
            given = [*a.posonlyargs, *a.args, *a.kwonlyargs, *filter(None, (a.vararg, a.kwarg))]
            if any(mentions(each, names) for each in (*[arg.annotation for arg in given], node.returns)):
                found.append(owner + node.name)
    return found


def loose_signatures() -> set[str]:
    found = set()
    for path in modules():
        tree = ast.parse(path.read_text(encoding="utf-8"))
        found |= {f"{path.relative_to(ROOT).as_posix()}: {name}" for name in loose(tree.body, loose_names(tree))}
    return {each for each in found if not each.startswith(tuple(UNTYPED))}


def test_no_public_signature_has_any_without_a_reason():
    assert loose_signatures() - set(ALLOWED) == set()


def test_no_reason_outlives_its_signature():
    assert set(ALLOWED) - loose_signatures() == set()


def test_any_is_seen_wherever_it_stands_in_a_signature():
    text = """
Data = dict[str, Any]
def a(x: list[Any]): ...
def b(*, x: int = 0) -> Data: ...
def c(**how: Any): ...
def d(x: int) -> str: ...
def _e(x: Any): ...
class F:
    def g(self, *x: Any): ...
    def __add__(self, other: Any): ...
"""
    tree = ast.parse(text)
    assert loose(tree.body, loose_names(tree)) == ["a", "b", "c", "F.g"]


@pytest.mark.parametrize("folder", ["exactspline", "stubs", "tests", "mutation", "benchmarks"])
def test_types_are_ignored_for_a_reason(folder):
    ignored = re.compile(r"# type: ignore(?!\[[\w, -]+\]  # \w)")
    found = [
        f"{path.relative_to(CHECKOUT)}:{i}"
        for path in sorted((CHECKOUT / folder).rglob("*.py*"))
        if path.suffix in (".py", ".pyi") and path != Path(__file__)
        for i, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1)
        if ignored.search(line)
    ]
    assert found == []


def test_a_type_checker_sees_through_the_front_door(tmp_path):
    api = pytest.importorskip("mypy.api")
    asked = {
        "exactspline.Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 1)])": "exactspline.splines.nurbs.Nurbs",
        "exactspline.example('circle').split('1/2')[0]": "exactspline.splines.nurbs.Nurbs",
        "exactspline.example('circle').w": "exactspline.splines.bspline.BSpline",
        "exactspline.zeros(exactspline.example('circle').w)": "exactspline.roots.zero_set.ZeroSet",
        "exactspline.zeros(exactspline.example('circle').w).roots[0]": "exactspline.roots.root.Root",
    }
    snippet = tmp_path / "snippet.py"
    snippet.write_text("import exactspline\n" + "".join(f"reveal_type({code})\n" for code in asked), encoding="utf-8")
    config = CHECKOUT / "pyproject.toml"
    cache = CHECKOUT / ".mypy_cache"  # that of the checker, which is told the same
    told, errors, _ = api.run(["--config-file", str(config), "--cache-dir", str(cache), str(snippet)])
    assert re.findall(r'Revealed type is "([^"]*)"', told) == list(asked.values()), told + errors


def test_the_precision_leaves_the_formulas_out():
    report = """
                 Name   Anys   Exprs   Coverage
  exactspline.exact      5     100     95.00%
  exactspline.papers     5     100     95.00%
  exactspline.papers.lifted.curves    100     100     0.00%
  Total    110     300     63.33%
"""
    assert precision(report) == 95
