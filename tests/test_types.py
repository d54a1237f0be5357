"""Types: no Any in a public signature, why types are ignored, what a checker sees at the front door."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

import exactspline
from tests.precision import precision

ROOT = Path(exactspline.__file__).parent
CHECKOUT = ROOT.parent


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
    return found


def test_no_public_signature_has_any():
    assert loose_signatures() == set()


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
