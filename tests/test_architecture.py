"""The house: which room may import which, what a formula may contain, and how heavy an import is."""

import ast
import re
import subprocess
import sys
from pathlib import Path

import pytest

import exactspline
from tests import import_graph

ROOT = Path(exactspline.__file__).parent
ARCHITECTURE = Path(__file__).parent.parent / "docs" / "architecture.md"

MODULES = sorted(ROOT.rglob("*.py"))
GRAPH = import_graph.module_graph()
#: Above every floor: the front door and the two ways to start the command line.
FRONT = {"", "__main__"}


def test_a_package_imports_only_from_those_left_of_it():
    packages = import_graph.package_graph(GRAPH)
    assert set(packages) == {name.split(".")[0] for name in GRAPH} - FRONT
    for package, targets in packages.items():
        for other in targets:
            assert import_graph.FLOOR[other] < import_graph.FLOOR[package], f"{package} imports {other}"


def test_no_circle_of_modules_lazy_imports_included():
    assert import_graph.circles(GRAPH) == []


def test_nothing_imports_the_front_door():
    assert [name for name, targets in GRAPH.items() if "" in targets and name not in FRONT] == []


def test_a_circle_and_an_arrow_that_points_up_are_seen():
    assert import_graph.circles({"a": {"b"}, "b": {"c"}, "c": {"a"}, "d": {"a"}}) == [["a", "b", "c"]]
    lazily = ast.parse("def f():\n    from exactspline.cli import prove")
    assert import_graph.imported(lazily, {"cli", "cli.prove"}) == {"cli.prove"}


@pytest.mark.skipif(not ARCHITECTURE.exists(), reason="the documents are in the checkout only")
def test_the_picture_in_the_documents_is_that_of_the_code():
    assert import_graph.text_picture(import_graph.package_graph(GRAPH)) in ARCHITECTURE.read_text(encoding="utf-8")


def in_a_paper(path: Path) -> bool:
    return path.relative_to(ROOT).parts[0] == "papers" and len(path.relative_to(ROOT).parts) > 2


PAPERS = [p for p in MODULES if in_a_paper(p) and p.name != "__init__.py"]


def test_formulas_import_the_language_and_formulas_alone():
    for path in PAPERS:
        names = import_graph.imported(ast.parse(path.read_text(encoding="utf-8")), set(GRAPH))
        assert {name.split(".")[0] for name in names} <= {"language", "papers"}


def test_nothing_outside_papers_names_one():
    names = {path.parent.name for path in PAPERS}
    for path in MODULES:
        if path.relative_to(ROOT).parts[0] != "papers":
            code = ast.unparse(without_docstrings(ast.parse(path.read_text(encoding="utf-8"))))
            assert not [name for name in names if re.search(rf"papers\.{name}\b|paper\(['\"]{name}['\"]", code)], path


def without_docstrings(tree: ast.Module) -> ast.Module:
    for node in ast.walk(tree):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)) and ast.get_docstring(node) is not None:
            node.body = node.body[1:] or [ast.Pass()]
    return tree


FORBIDDEN = (ast.If, ast.IfExp, ast.Compare, ast.While, ast.For, ast.BoolOp, ast.Try, ast.Match, ast.Assert, ast.Lambda)


@pytest.mark.parametrize("path", PAPERS, ids=lambda p: p.stem)
def test_formulas_contain_no_branch_no_comparison_no_float(path):
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        assert not isinstance(node, FORBIDDEN), f"line {node.lineno}: {type(node).__name__}"
        assert not (isinstance(node, ast.Constant) and isinstance(node.value, (float, complex, bool))), (
            f"line {node.lineno}: {node.value}"
        )


ROOMS_WITH_FLOATS = "display", "roots", "verification"
#: The certified filter, which proves what rounding does to its doubles.
PROVED_FLOATS = [ROOT / "programs" / "doubles.py"]


@pytest.mark.parametrize("path", MODULES, ids=lambda p: str(p.relative_to(ROOT)))
def test_rooms_are_small_and_without_floats(path):
    text = path.read_text(encoding="utf-8")
    assert text.count("\n") <= 500
    # what libraries in doubles are given and asked is doubles
    grading = path.relative_to(ROOT).parts[:2] == ("batch", "grade")
    if path.relative_to(ROOT).parts[0] not in ROOMS_WITH_FLOATS and path not in PROVED_FLOATS and not grading:
        assert not [
            n.value for n in ast.walk(ast.parse(text)) if isinstance(n, ast.Constant) and isinstance(n.value, float)
        ]


@pytest.mark.parametrize("path", MODULES, ids=lambda p: str(p.relative_to(ROOT)))
def test_public_things_have_docstrings(path):
    tree = ast.parse(path.read_text(encoding="utf-8"))
    assert ast.get_docstring(tree)
    for node in tree.body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and not node.name.startswith("_"):
            if any(ast.unparse(mark) == "overload" for mark in node.decorator_list):
                continue  # the docstring is at the definition that follows
            assert ast.get_docstring(node), node.name


def loaded_after(code: str) -> set[str]:
    done = subprocess.run(
        [sys.executable, "-c", f"{code}\nimport sys; print(*sys.modules)"], capture_output=True, text=True, check=True
    )
    return {name.split(".")[0] for name in done.stdout.split()}


HEAVY = {"sympy", "matplotlib", "numpy", "mpmath"}


def test_importing_is_light():
    assert not HEAVY & loaded_after("import exactspline; exactspline.BSpline; exactspline.Nurbs")


def test_help_is_light():
    code = (
        "from typer.testing import CliRunner; from exactspline.cli import app; assert "
        "CliRunner().invoke(app, ['--help']).exit_code == 0"
    )
    assert not HEAVY & loaded_after(code)


def test_proving_needs_no_sympy():
    code = (
        "from exactspline.verification.ledger import audit; from exactspline.verification.claims import "
        "select; assert all(r.as_recorded for r in audit(select(['C4.1'])))"
    )
    assert "sympy" not in loaded_after(code)
