"""The house: which room may import which, what a formula may contain, and how heavy an import is."""

import ast
import re
import subprocess
import sys
from pathlib import Path

import pytest

from exactspline.cli.commands import leaves
from tests.support import import_graph

ARCHITECTURE = Path(__file__).parents[2] / "docs" / "architecture.md"

#: Above every floor: the front door and the two ways to start the command line.
FRONT = {"", "__main__"}


def test_a_package_imports_only_from_those_below_it():
    packages = import_graph.package_graph(import_graph.module_graph())
    assert set(packages) == {name.split(".")[0] for name in import_graph.module_graph()} - FRONT
    for package, targets in packages.items():
        for other in targets:
            assert import_graph.FLOOR[other] < import_graph.FLOOR[package], f"{package} imports {other}"


def test_no_circle_of_modules_lazy_imports_and_types_included():
    """Passed before: 38 modules in one circle, tied by services and by imports for types alone."""
    assert import_graph.circles(import_graph.module_graph()) == []


def test_nothing_imports_the_front_door():
    assert [name for name, targets in import_graph.module_graph().items() if "" in targets and name not in FRONT] == []


def test_nothing_imports_what_draws_the_figures_of_a_paper():
    """They lie in the folder of their paper, and above all rooms."""
    graph = import_graph.module_graph()
    figures = {name for name in graph if import_graph.OF_FIGURES.fullmatch(name)}
    assert "extras" in {target.split(".")[0] for name in figures for target in graph[name]}
    assert {name for name, targets in graph.items() if figures & targets} <= figures


PLANTED = {
    "at the top": "from exactspline.cli import prove",
    "lazily": "def f():\n    from exactspline.cli.prove import prove",
    "for types alone": "if TYPE_CHECKING:\n    from exactspline.cli import prove",
    "by import_module": "prove = import_module('exactspline.cli.prove')",
    "by a place in a text": "HOMES = {'prove': 'cli.prove:prove'}",
}


@pytest.mark.parametrize("code", PLANTED.values(), ids=PLANTED)
def test_an_import_is_seen(code):
    """Passed before: an import for types alone, or by a name in a text, points up unseen."""
    found = import_graph.imported(ast.parse(code), {"cli", "cli.prove"}, "language.kinds")
    assert found == {"cli.prove"}
    packages = import_graph.package_graph({"language.kinds": found})
    assert not import_graph.FLOOR["cli"] < import_graph.FLOOR["language"]
    assert packages == {"language": {"cli"}}


@pytest.mark.parametrize(("module", "seen"), [("interchange.formats", set()), ("interchange.files", {"extras.cad"})])
def test_the_tables_alone_name_what_loads_when_it_is_used(module, seen):
    """A row of a table is no import, the same text elsewhere is one, and so is an import in a table."""
    known = {"extras.cad", "extras.coq"}
    assert import_graph.imported(ast.parse("HOME = 'exactspline.extras.cad:FORMAT'"), known, module) == seen
    assert import_graph.imported(ast.parse("from exactspline.extras import coq"), known, module) == {"extras.coq"}


def test_a_formula_that_is_looked_up_by_its_name_is_an_import():
    """Passed before: a room below the papers looks up one of their formulas by its name."""
    assert import_graph.imported(ast.parse("find('f2')"), set(import_graph.module_graph()), "language.kinds") == {
        "papers"
    }
    assert (
        import_graph.imported(ast.parse("'a text about x.y: f2'; text.find('f2')"), set(import_graph.module_graph()))
        == set()
    )


def test_a_circle_is_seen():
    """Passed before: a circle of modules one of whose imports is for types alone."""
    assert import_graph.circles({"a": {"b"}, "b": {"c"}, "c": {"a"}, "d": {"a"}}) == [["a", "b", "c"]]
    code = "if TYPE_CHECKING:\n    from exactspline.a import A", "from exactspline.b import B"
    graph = {name: import_graph.imported(ast.parse(c), {"a", "b"}) for name, c in zip("ba", code, strict=True)}
    assert import_graph.circles(graph) == [["a", "b"]]


def test_only_the_front_door_and_tables_name_modules_of_other_rooms_in_texts():
    """What a user's formulas may import are texts of the check of such files; the command line asks whether a module
    below it was loaded.
    """
    trees = import_graph.trees()
    named = {name: import_graph.named(tree, set(trees)) - {"papers"} for name, tree in trees.items()}
    found = {name for name, targets in named.items() if {t.split(".")[0] for t in targets} - {name.split(".")[0]}}
    assert found == {*import_graph.TABLES, "cli.output", "papers.formula_check"}
    assert {entry.home.split(".")[0] for entry in leaves().values()} == {"cli", import_graph.EXTRA}


@pytest.mark.skipif(not ARCHITECTURE.exists(), reason="the documents are in the checkout only")
def test_the_picture_in_the_documents_is_that_of_the_code():
    assert import_graph.text_picture(import_graph.package_graph(import_graph.module_graph())) in ARCHITECTURE.read_text(
        encoding="utf-8"
    )


#: A module of formulas: of a paper, or of the room of those that belong to none.
OF_FORMULAS = re.compile(r"papers\.\w+\.\w+|formulas\.\w+(\.\w+)*")


def formulas():
    """The modules of formulas with their syntax trees."""
    return {
        name: tree
        for name, tree in import_graph.trees().items()
        if OF_FORMULAS.fullmatch(name) and not import_graph.OF_FIGURES.fullmatch(name)
    }


def test_formulas_import_the_language_and_formulas_alone():
    assert len(formulas()) > 30
    for name, tree in formulas().items():
        own = {"papers"} if name.startswith("papers.") else set()
        found = import_graph.imported(tree, set(import_graph.module_graph()))
        assert {other.split(".")[0] for other in found} <= {"language", "formulas"} | own


def test_nothing_outside_papers_names_one():
    papers = {name.split(".")[1] for name in formulas() if name.startswith("papers.")}
    pattern = re.compile(rf"papers\.({'|'.join(papers)})\b|paper\(['\"]({'|'.join(papers)})['\"]")
    mentioned = re.compile("|".join(papers))
    for path, tree in import_graph.files().items():
        name = import_graph.module_name(path)
        if name.split(".")[0] != "papers" and mentioned.search(path.read_text(encoding="utf-8")):
            prose = {id(node.value) for node in import_graph.nodes(tree) if isinstance(node, ast.Expr)}
            for node in import_graph.nodes(tree):
                if id(node) not in prose and isinstance(node, NAMES_PAPERS):
                    assert not pattern.search(ast.unparse(node)), name


#: An import, a text, or a call.
NAMES_PAPERS = (ast.Import, ast.ImportFrom, ast.Constant, ast.Call)


FORBIDDEN = (ast.If, ast.IfExp, ast.Compare, ast.While, ast.For, ast.BoolOp, ast.Try, ast.Match, ast.Assert, ast.Lambda)


def test_formulas_contain_no_branch_no_comparison_no_float():
    def is_forbidden(node):
        rounded = isinstance(node, ast.Constant) and isinstance(node.value, (float, complex, bool))
        return isinstance(node, FORBIDDEN) or rounded

    for name, tree in formulas().items():
        assert [f"{name}, line {node.lineno}" for node in import_graph.nodes(tree) if is_forbidden(node)] == []


#: `testing` has curves whose numbers are doubles, for libraries that compute in them.
ROOMS_WITH_FLOATS = "display", "verification", "testing", "extras.pictures3d"
#: The certified filter, which proves what rounding does to its doubles.
PROVED_FLOATS = "programs.doubles", "polynomials.doubles"
#: Witnesses and places of zeros are proposed in doubles, and each is proved exactly before it is one.
PROPOSED_FLOATS = ("geometry.rounded.stability",)


def test_rooms_are_without_floats():
    for name, tree in import_graph.trees().items():
        draws = name.startswith(ROOMS_WITH_FLOATS) or import_graph.OF_FIGURES.fullmatch(name)
        if not draws and name not in (*PROVED_FLOATS, *PROPOSED_FLOATS):
            constants = [n.value for n in import_graph.nodes(tree) if isinstance(n, ast.Constant)]
            assert not any(isinstance(value, float) for value in constants), name


def test_public_things_have_docstrings():
    for name, tree in import_graph.trees().items():
        assert ast.get_docstring(tree), name
        for node in tree.body:
            if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and not node.name.startswith("_"):
                if any(ast.unparse(mark) == "overload" for mark in node.decorator_list):
                    continue  # the docstring is at the definition that follows
                assert ast.get_docstring(node), f"{name}: {node.name}"


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
        "from click.testing import CliRunner; from exactspline.cli import app; assert "
        "CliRunner().invoke(app, ['--help']).exit_code == 0"
    )
    assert not HEAVY & loaded_after(code)


def test_proving_needs_no_sympy():
    code = (
        "from exactspline.verification.ledger import audit; from exactspline.verification.claims import "
        "select; assert all(r.as_recorded for r in audit(select(['C4.1'])))"
    )
    assert "sympy" not in loaded_after(code)


def private_imports(code: str) -> list[str]:
    """The names with an underscore that a module imports from the package or the workshop."""
    return [
        f"{node.module}.{alias.name}"
        for node in ast.walk(ast.parse(code))
        if isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] in ("exactspline", "workshop")
        for alias in node.names
        if alias.name.startswith("_")
    ]


def test_tests_import_public_names_alone():
    """Passed before: 26 private functions in twelve files, whose names could not change."""
    tests = Path(__file__).parents[1]
    imported = {
        str(path.relative_to(tests)): private_imports(path.read_text(encoding="utf-8"))
        for path in sorted(tests.rglob("*.py"))
    }
    assert {path: names for path, names in imported.items() if names} == {}


def test_a_private_import_is_found():
    assert private_imports("def f():\n    from exactspline.reals.real import Real, _shown") == [
        "exactspline.reals.real._shown"
    ]
