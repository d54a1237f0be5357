"""The notebooks: each runs from a fresh kernel and shows pictures and tables, links to its neighbours, stores no
output, types in no result.
"""

import ast
import re
from pathlib import Path

import pytest

nbformat = pytest.importorskip("nbformat")
nbclient = pytest.importorskip("nbclient")

FOLDER = Path(__file__).resolve().parents[2] / "notebooks"
NOTEBOOKS = sorted(FOLDER.glob("*.ipynb"))
#: The parts that every notebook after the guide has.
PARTS = ("**Idea.**", "## Exercise")
DERIVATIONS = [path for path in NOTEBOOKS if path.stem[:2] != "00"]
#: Numbers that something may be compared with in an assertion; any other would be a result typed in.
HARMLESS = {0, 1, 2}

pytestmark = pytest.mark.skipif(not NOTEBOOKS, reason="the notebooks are not beside the tests")


def read(path):
    return nbformat.read(path, as_version=4)


def text(book, kind):
    return "\n".join(cell.source for cell in book.cells if cell.cell_type == kind)


def code_of(cell):
    return "\n".join(line for line in cell.source.splitlines() if not line.startswith("%"))


def links(book):
    return re.findall(r"\]\((\w+\.ipynb)\)", text(book, "markdown"))


#: Run by a kernel before the notebook: notes what cannot be read in a picture that is shown.
LOOK = """
import sys

sys.path.append({root!r})
from matplotlib.figure import Figure
from tests.support.looking import unreadable

plain = Figure.savefig


def savefig(figure, *given, **options):
    plain(figure, *given, **options)
    with open({file!r}, "a", encoding="utf-8") as noted:
        noted.writelines(f"{{line}}\\n" for line in unreadable(figure))


Figure.savefig = savefig
"""


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda p: p.stem)
def test_a_notebook_runs_from_a_fresh_kernel_and_its_pictures_can_be_read(path, tmp_path, monkeypatch):
    monkeypatch.setenv("IPYTHONDIR", str(tmp_path / "ipython"))
    startup, noted = tmp_path / "ipython" / "profile_default" / "startup", tmp_path / "unreadable"
    startup.mkdir(parents=True)
    code = LOOK.format(root=str(FOLDER.parent), file=str(noted))
    (startup / "look.py").write_text(code, encoding="utf-8")
    monkeypatch.setenv("JUPYTER_RUNTIME_DIR", str(tmp_path / "runtime"))
    book = read(path)
    nbclient.NotebookClient(
        book, timeout=240, kernel_name="python3", resources={"metadata": {"path": str(tmp_path)}}
    ).execute()
    shown = [
        kind
        for cell in book.cells
        if cell.cell_type == "code"
        for output in cell.outputs
        for kind in output.get("data", {})
    ]
    assert {"text/html", "text/latex"} & set(shown)
    noise = [
        o.text for cell in book.cells if cell.cell_type == "code" for o in cell.outputs if o.get("name") == "stderr"
    ]
    assert not noise
    assert noted.exists() == ("image/png" in shown)
    assert not noted.exists() or noted.read_text(encoding="utf-8") == ""


def test_every_notebook_links_to_its_neighbours():
    names = [path.name for path in NOTEBOOKS]
    for i, path in enumerate(NOTEBOOKS):
        found = links(read(path))
        assert set(found) <= set(names)
        assert {names[k] for k in (i - 1, i + 1) if 0 <= k < len(names)} <= set(found)
    assert set(links(read(NOTEBOOKS[0]))) == set(names)


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda p: p.stem)
def test_no_output_is_stored(path):
    book = read(path)
    nbformat.validate(book)
    for cell in book.cells:
        if cell.cell_type == "code":
            assert not cell.outputs
            assert cell.execution_count is None


@pytest.mark.parametrize("path", DERIVATIONS, ids=lambda p: p.stem)
def test_a_derivation_ends_in_an_assertion_and_types_in_no_result(path):
    book = read(path)
    assert all(part in text(book, "markdown") for part in PARTS)
    assert "$" not in text(book, "markdown"), "formulas are printed from the ones that run"
    cells = [ast.parse(code_of(cell)) for cell in book.cells if cell.cell_type == "code"]
    assertions = [node for cell in cells for node in ast.walk(cell) if isinstance(node, ast.Assert)]
    assert assertions
    compared = [
        side for a in assertions for n in ast.walk(a) if isinstance(n, ast.Compare) for side in (n.left, *n.comparators)
    ]
    literals = [n for side in compared if isinstance(side, (ast.Constant, ast.Tuple, ast.List)) for n in ast.walk(side)]
    typed = {n.value for n in literals if isinstance(n, ast.Constant) and isinstance(n.value, (int, float))}
    assert typed <= HARMLESS, "a result is computed or read out of a claim, not typed in"
