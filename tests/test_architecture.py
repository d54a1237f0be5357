"""The house: which room may import which, what a formula may contain, and how heavy an import is."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

import exactspline

ROOT = Path(exactspline.__file__).parent

#: A package imports only from those in lines above its own.
ORDER = [
    ["errors"],
    ["exact", "atomic_write"],
    ["language"],
    ["splines", "readings", "papers"],
    ["roots", "symbolic"],
    ["geometry"],
    ["verification"],
    ["display", "interchange"],
    ["cli"],
]
FLOOR = {room: i for i, rooms in enumerate(ORDER) for room in rooms}
MODULES = sorted(ROOT.rglob("*.py"))


def room_of(path: Path) -> str:
    return path.relative_to(ROOT).parts[0].removesuffix(".py")


def imports(tree: ast.AST) -> set[str]:
    """Rooms imported anywhere but under TYPE_CHECKING, lazily or not."""
    skipped = {
        id(inner)
        for node in ast.walk(tree)
        if isinstance(node, ast.If) and isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING"
        for inner in ast.walk(node)
    }
    found = set()
    for node in ast.walk(tree):
        if id(node) in skipped:
            continue
        names = []
        if isinstance(node, ast.ImportFrom) and node.module:
            names = [node.module] if node.module != "exactspline" else [f"exactspline.{a.name}" for a in node.names]
        elif isinstance(node, ast.Import):
            names = [a.name for a in node.names]
        found |= {name.split(".")[1] for name in names if name.startswith("exactspline.")}
    return found


@pytest.mark.parametrize("path", MODULES, ids=lambda p: str(p.relative_to(ROOT)))
def test_a_room_imports_only_from_floors_below(path):
    room = room_of(path)
    if room in ("__init__", "__main__"):
        return
    assert room in FLOOR, f"{room} has no floor"
    for other in imports(ast.parse(path.read_text(encoding="utf-8"))) - {room, "__version__"}:
        assert FLOOR[other] < FLOOR[room], f"{room} imports {other} from the same floor or above"


PAPERS = [p for p in MODULES if room_of(p) == "papers" and p.name != "__init__.py"]


def test_formulas_import_the_language_and_formulas_alone():
    for path in PAPERS:
        assert imports(ast.parse(path.read_text(encoding="utf-8"))) <= {"language", "papers"}


FORBIDDEN = (ast.If, ast.IfExp, ast.Compare, ast.While, ast.For, ast.BoolOp, ast.Try, ast.Match, ast.Assert, ast.Lambda)


@pytest.mark.parametrize("path", PAPERS, ids=lambda p: p.stem)
def test_formulas_contain_no_branch_no_comparison_no_float(path):
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        assert not isinstance(node, FORBIDDEN), f"line {node.lineno}: {type(node).__name__}"
        assert not (isinstance(node, ast.Constant) and isinstance(node.value, (float, complex, bool))), (
            f"line {node.lineno}: {node.value}"
        )


@pytest.mark.parametrize("path", MODULES, ids=lambda p: str(p.relative_to(ROOT)))
def test_rooms_are_small_and_without_floats(path):
    text = path.read_text(encoding="utf-8")
    assert text.count("\n") <= 500
    if room_of(path) not in ("display", "roots", "verification"):
        assert not [
            n.value for n in ast.walk(ast.parse(text)) if isinstance(n, ast.Constant) and isinstance(n.value, float)
        ]


@pytest.mark.parametrize("path", MODULES, ids=lambda p: str(p.relative_to(ROOT)))
def test_public_things_have_docstrings(path):
    tree = ast.parse(path.read_text(encoding="utf-8"))
    assert ast.get_docstring(tree)
    for node in tree.body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and not node.name.startswith("_"):
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
