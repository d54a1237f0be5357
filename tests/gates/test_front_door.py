"""The front door: every name a user looks for, the same whatever is imported, typed, lazily loaded; what it lends."""

import ast
import importlib
import pkgutil
import re
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

import exactspline as xs
from exactspline import hooks

ROOT = Path(xs.__file__).parent


def test_the_front_door_fits_on_a_screen():
    assert {*xs.__all__, *hooks.first_guesses()[hooks.QUESTIONS]} == set(dir(xs))
    assert len(xs.__all__) <= 63


def test_every_name_is_used_in_a_page():
    """Passed before: `examples` stood in no page, no notebook and not in the README; `write` and `torsion` only as
    words and as functions of papers.
    """
    root = ROOT.parent
    if not (root / "docs").is_dir():
        pytest.skip("the pages are not installed")
    pages = [root / "README.md", *(root / "docs").rglob("*.md"), *(root / "notebooks").glob("*.ipynb")]
    text = "\n".join(page.read_text(encoding="utf-8") for page in pages)
    ways = r"\b(xs|exactspline)\.{0}\b|\bfrom exactspline import [^\n]*\b{0}\b"
    assert [name for name in xs.__all__[:-1] if not re.search(ways.format(name), text)] == []


def test_a_name_that_is_not_there():
    with pytest.raises(AttributeError, match="has no attribute 'nurbs'; the nearest are Nurbs"):
        xs.nurbs  # noqa: B018
    with pytest.raises(ImportError):
        exec("from exactspline import nothing_of_the_kind")


def test_importing_every_submodule_hides_no_name():
    code = """
import pkgutil, importlib, types
import exactspline as xs
before = {name: getattr(xs, name) for name in xs.__all__}
for module in pkgutil.walk_packages(xs.__path__, "exactspline."):
    if not module.name.endswith("__main__"):
        importlib.import_module(module.name)
assert all(getattr(xs, name) is thing for name, thing in before.items())
rooms = {name for name, thing in before.items() if isinstance(thing, types.ModuleType)}
assert rooms == {"constructors", "teaching", "display", "interchange", "language", "readings", "tables"}
for room in (xs.teaching, xs.display, xs.interchange, xs.language, xs.readings):
    assert not any(isinstance(getattr(room, name), types.ModuleType) for name in room.__all__)
"""
    subprocess.run([sys.executable, "-c", code], check=True)


def test_no_submodule_is_called_like_a_name():
    modules = {module.name for module in pkgutil.iter_modules(xs.__path__)}
    assert modules & set(xs.__all__) == {"constructors", "display", "interchange", "language", "readings", "tables"}


def test_importing_the_package_loads_nothing_of_it_but_the_hooks():
    code = (
        "import sys, exactspline; print(*[m for m in sys.modules if m.startswith(('exactspline.', 'flint', 'gmpy2'))])"
    )
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert set(loaded) == {"exactspline.hooks", "exactspline.one_line", "exactspline.release"}


def test_every_name_of_a_stub_is_there():
    """A type checker and the interpreter read the same list: each of its names can be imported."""
    stubs = sorted(ROOT.rglob("__init__.pyi"))
    assert len(stubs) >= 6
    for stub in stubs:
        room = ".".join(("exactspline", *stub.parent.relative_to(ROOT).parts))
        module = importlib.import_module(room)
        tree = ast.parse(stub.read_text(encoding="utf-8"))
        names = [alias for node in tree.body if isinstance(node, ast.ImportFrom) for alias in node.names]
        assert all(alias.asname == alias.name for alias in names), "only such a name is public for checkers"
        assert sorted(alias.name for alias in names) == sorted(set(module.__all__) - {"__version__"}), room
        for alias in names:
            assert getattr(module, alias.name) is not None


# ---- functions, not methods of lower rooms

SOURCES = sorted(ROOT.rglob("*.py"))


@pytest.mark.parametrize("name", ["plot", "curvature", "torsion", "ask", "analyse"])
@pytest.mark.parametrize(
    "thing", [xs.example("circle"), xs.example("sphere"), xs.BSpline.identity(0, 1)], ids=["curve", "surface", "spline"]
)
def test_functions_of_the_front_door_are_lent_to_objects(thing, name):
    """AttributeErrors before, which named the function."""
    lent = getattr(thing, name)
    assert lent.__func__ is getattr(xs, name) is getattr(type(thing), name)
    assert lent.__self__ is thing


def test_functions_that_do_not_take_the_object_first_are_named():
    with pytest.raises(AttributeError, match=r"has no attribute 'derive'; write exactspline\.derive$"):
        xs.example("circle").derive("evolute")


def test_other_missing_attributes_name_nothing():
    for name in ("nothing_of_the_kind", "Vector", "__version__", "_repr_svg_"):
        with pytest.raises(AttributeError, match=f"'Nurbs' object has no attribute '{name}'$"):
            getattr(xs.example("circle"), name)


def test_a_notebook_shows_what_the_printers_write():
    curve = xs.example("circle")
    told = []
    curve.w._repr_pretty_(SimpleNamespace(text=told.append), False)
    assert "B-spline function" in curve.w._repr_html_()
    assert told == [repr(curve.w)]
    assert xs.formula_of("D1")._repr_latex_() == "$$D_1 = p'\\,w - p\\,w'$$"


def test_without_printers_a_notebook_shows_the_text(monkeypatch):
    monkeypatch.setattr(hooks, "_printers", [hooks._plain])
    told = []
    xs.example("circle").w._repr_pretty_(SimpleNamespace(text=told.append), False)
    assert told == [repr(xs.example("circle").w)]
    assert xs.example("circle").w._repr_html_() is None


#: Modules that import by a name in a string: the front door, papers (folders of data), the optional
#: drawing libraries, what a user names on the command line, and what only notebooks need.
IMPORT_BY_STRING = {
    "__init__.py",
    "hooks.py",
    "papers/loading.py",
    "display/plot/canvas.py",
    "extras/pictures3d/html.py",
    "papers/folder.py",
}


def test_nothing_else_imports_by_string():
    for path in SOURCES:
        text = path.read_text(encoding="utf-8")
        own = str(path.relative_to(ROOT))
        if "import_module" in text or "__import__" in text:
            assert own in IMPORT_BY_STRING, own


# ---- README and notebooks

CHECKOUT = ROOT.parent
#: What a page imports from.
PUBLIC = {
    "exactspline",
    *(f"exactspline.{room}" for room in ("constructors", "display", "interchange", "language", "readings", "tables")),
    *("exactspline.display.plot", "exactspline.display.figures"),
    *("exactspline.extras.pictures3d", "exactspline.extras.teaching"),
    "exactspline.papers.chen_riesenfeld_cohen_2007.figures",
}
IMPORT = re.compile(r"^\s*(?:from\s+(exactspline[\w.]*)\s+import|import\s+(exactspline[\w.]*))", re.MULTILINE)


@pytest.mark.skipif(not (CHECKOUT / "README.md").exists(), reason="the README is in the checkout only")
def test_the_readme_imports_public_names_alone():
    text = (CHECKOUT / "README.md").read_text(encoding="utf-8")
    blocks = "\n".join(re.findall(r"```python\n(.*?)```", text, re.DOTALL))
    found = [a or b for a, b in IMPORT.findall(blocks)]
    assert found
    assert set(found) <= PUBLIC


@pytest.mark.parametrize("path", sorted((CHECKOUT / "notebooks").glob("*.ipynb")), ids=lambda p: p.stem)
def test_a_notebook_imports_public_names_alone(path):
    nbformat = pytest.importorskip("nbformat")
    cells = [cell.source for cell in nbformat.read(path, as_version=4).cells if cell.cell_type == "code"]
    found = [a or b for cell in cells for a, b in IMPORT.findall(cell)]
    assert found
    assert set(found) <= PUBLIC


def test_attributes_are_found_without_a_detour():
    """False before: a `__getattr__` made every attribute slower, products and sums of splines by a third."""
    for kind in (xs.BSpline, xs.Nurbs, xs.NurbsSurface):
        assert not hasattr(kind, "__getattr__")
        assert kind.__mro__[-3:-1] == (hooks.FunctionsOutside, hooks.OtherNames)


def test_what_is_listed_is_there():
    curve = xs.example("circle")
    assert {"plot", "analyse", "evolute"} <= set(dir(curve))
    assert {"degree", "knots", "reverse", "floats"} <= set(dir(curve))
    assert all(hasattr(curve, name) for name in {*dir(curve)}.difference(hooks.first_guesses()[hooks.QUESTIONS]))
