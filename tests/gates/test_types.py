"""Types: no Any in a public signature, why types are ignored."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

import exactspline
from tests.support.precision import precision

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


def public(name: str) -> bool:
    """Whether a name is public: operators and other methods that Python calls are."""
    return not name.startswith("_") or (name.startswith("__") and name.endswith("__"))


def loose(body: list[ast.stmt], names: set[str], owner: str = "") -> list[str]:
    """The public functions and methods that have one of the names in their signature."""
    found = []
    for node in body:
        if isinstance(node, ast.ClassDef) and public(node.name):
            found += loose(node.body, names, f"{node.name}.")
        elif isinstance(node, ast.FunctionDef) and public(node.name):
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


#: Formulas keep their plain form: nothing in them is annotated, so no checker knows what one returns. It depends on its
#: body (a scalar, a vector, a ruled surface) and on the reading of its argument. Nor what a table names by a text.
UNTYPED = {"language/formula.py: Formula.__call__", "hooks.py: named", "display/plot/anything.py: picture"}
#: Likewise what is written once for numbers, points, curves and surfaces, and for doubles and rational numbers.
OF_SEVERAL = re.compile(
    r"numbers/exact\.py: scalar|geometry/recognition/shapes\.py: (\w+\.(margins|parts|p|w)|cross_product)"
    # polynomials with integers or fractions as coefficients
    r"|certificates/(elimination\.py: (trimmed|total|value|on_interval|strict_sign|sign_at_root|at_height|integral"
    r"|sign_over)|zeros\.py: product_of)"
    # data in the form that is given with it
    r"|certificates/numbers\.py: read"
)


def test_no_public_signature_has_any_but_the_call_of_a_formula():
    assert {each for each in loose_signatures() if not OF_SEVERAL.fullmatch(each)} == UNTYPED


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
    def _h(self) -> Any: ...
"""
    tree = ast.parse(text)
    assert loose(tree.body, loose_names(tree)) == ["a", "b", "c", "F.g", "F.__add__"]


@pytest.mark.parametrize("folder", ["exactspline", "stubs", "tests", "workshop"])
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


def test_the_precision_leaves_the_formulas_out():
    report = """
                 Name   Anys   Exprs   Coverage
  exactspline.numbers.exact      5     100     95.00%
  exactspline.papers     5     100     95.00%
  exactspline.papers.lifted.curves    100     100     0.00%
  Total    110     300     63.33%
"""
    assert precision(report) == 95
