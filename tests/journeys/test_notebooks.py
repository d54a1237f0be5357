"""The notebooks: each runs from a fresh kernel and shows pictures and tables, links to its neighbours, stores no
output, types in no result.
"""

import ast
import re
from pathlib import Path

import pytest

nbformat = pytest.importorskip("nbformat")
pytest.importorskip("IPython")
pytest.importorskip("matplotlib")

from docs.site.executed import code_cells, shown_by, store  # noqa: E402  # needs both
from docs.site.kept import kept  # noqa: E402
from tests.support.decided import handed_on  # noqa: E402
from tests.support.looking import unreadable  # noqa: E402

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


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda p: p.stem)
def test_a_notebook_runs_and_its_pictures_can_be_read(path, tmp_path):
    """The site shows what is run here, where the folder for that is named."""
    book, target = read(path), kept(path.name)
    shown = shown_by(code_cells(book), tmp_path, unreadable, handed_on(), narrow=bool(target))
    assert shown.error == ""
    assert {"text/html", "text/latex"} & shown.kinds
    assert shown.written == ""
    assert (shown.looked_at > 0) == ("image/png" in shown.kinds)
    assert shown.noted == ()
    if target:
        store(book, shown, target)


#: A picture whose title is too small.
SMALL = """
from io import BytesIO

from matplotlib.figure import Figure


class Picture:
    def _repr_png_(self):
        figure, data = Figure(), BytesIO()
        figure.subplots().set_title("small", fontsize=2)
        figure.savefig(data, format="png")
        return data.getvalue()


Picture()
"""


def test_what_goes_wrong_in_a_notebook_is_noticed(tmp_path):
    assert "ZeroDivisionError" in shown_by(["1", "1 / 0", "print(1)"], tmp_path).error
    assert "no more" in shown_by(["import warnings; warnings.warn('no more')"], tmp_path).written
    shown = shown_by([SMALL], tmp_path, unreadable)
    assert (shown.error, shown.kinds, shown.looked_at) == ("", {"text/plain", "image/png"}, 1)
    assert len(shown.noted) == 1


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


def sections(book):
    """The code of each section that computes something, by its heading."""
    found, heading = {}, ""
    for cell in book.cells:
        if cell.cell_type == "markdown":
            heading = (re.findall(r"^## (.*)", cell.source, re.MULTILINE) or [heading])[-1]
        elif heading:
            found[heading] = [*found.get(heading, []), *ast.walk(ast.parse(code_of(cell)))]
    return found


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda p: p.stem)
def test_every_section_asserts_something(path):
    """Whole sections showed a table or a picture and checked nothing."""
    for heading, nodes in sections(read(path)).items():
        assert any(isinstance(node, ast.Assert) for node in nodes) or "AssertionError" in {
            node.id for node in nodes if isinstance(node, ast.Name)
        }, heading
