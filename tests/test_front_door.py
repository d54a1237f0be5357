"""The front door: every name a user looks for, the same whatever is imported, typed, lazily loaded; every service."""

import ast
import inspect
import pkgutil
import re
import subprocess
import sys
from importlib import import_module
from pathlib import Path

import pytest

import exactspline as xs
from exactspline.language.services import registered

ROOT = Path(xs.__file__).parent
#: What the design promises at top level.
PROMISED = [
    "BSpline",
    "Nurbs",
    "TensorSpline",
    "KnotVector",
    "Vector",
    "Direction",
    "Rational",
    "Root",
    "ZeroSet",
    "rational",
    "from_float",
    "from_floats",
    "load",
    "save",
    "example",
    "inflections",
    "curvature_extrema",
    "singular_points",
    "torsion_zeros",
    "zeros",
    "evolute",
    "focal_curve",
    "torsion",
    "curvature",
    "derive",
    "ruled_surface",
    "bisector",
    "trimmed_bisector",
    "formula",
    "dot",
    "cross",
    "det",
    "perp",
    "norm2",
    "triple",
    "generalized_cross",
    "wronskian",
    "prove",
    "verify",
    "reduction",
    "degree_table",
    "errata",
    "plot",
]


def test_every_promised_name_is_there():
    assert set(PROMISED) <= set(xs.__all__) == set(dir(xs))
    for name in xs.__all__:
        assert getattr(xs, name) is not None


def test_a_name_that_is_not_there():
    with pytest.raises(AttributeError, match="no attribute 'nurbs'"):
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
assert not any(isinstance(thing, types.ModuleType) for thing in before.values())
"""
    subprocess.run([sys.executable, "-c", code], check=True)


def test_no_submodule_is_called_like_a_name():
    own = {module.name for module in pkgutil.iter_modules(xs.__path__)}
    assert not own & set(xs.__all__)


def test_importing_the_package_loads_nothing_of_it_but_the_services():
    code = (
        "import sys, exactspline; print(*[m for m in sys.modules if m.startswith(('exactspline.', 'flint', 'gmpy2'))])"
    )
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert set(loaded) == {"exactspline.language", "exactspline.language.services"}


def typed_names() -> dict[str, str]:
    """What checkers read: name → ``module:attribute``, from the imports under TYPE_CHECKING."""
    tree = ast.parse((ROOT / "__init__.py").read_text(encoding="utf-8"))
    block = next(node for node in tree.body if isinstance(node, ast.If))
    return {
        alias.asname: f"{node.module.removeprefix('exactspline.')}:{alias.name}"
        for node in block.body
        for alias in node.names
    }


def test_checkers_and_the_interpreter_see_the_same_names():
    assert typed_names() == xs._HOMES


def test_checkers_know_the_types(tmp_path):
    pytest.importorskip("mypy")
    asked = {
        "xs.Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 1)])": "exactspline.splines.nurbs.Nurbs",
        "xs.zeros(xs.BSpline.bezier([1, -1]))": "exactspline.roots.zero_set.ZeroSet",
        'xs.example("circle").insert_knot("1/2")': "exactspline.splines.nurbs.Nurbs",
        'xs.prove("f1", "f2").holds': "bool",
    }
    file = tmp_path / "asks.py"
    file.write_text(
        "import exactspline as xs\n" + "".join(f"reveal_type({code})\n" for code in asked), encoding="utf-8"
    )
    command = [
        sys.executable,
        "-m",
        "mypy",
        "--cache-dir",
        str(tmp_path / "cache"),
        "--follow-imports=silent",
        str(file),
    ]
    done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=ROOT.parent)
    told = [kind.removeprefix("builtins.") for kind in re.findall(r'Revealed type is "(.*?)"', done.stdout)]
    assert told == list(asked.values()), done.stdout + done.stderr


# ---- services

SOURCES = sorted(ROOT.rglob("*.py"))


def calls_of_services() -> dict[str, list[tuple[str, ast.FunctionDef, ast.ClassDef | None]]]:
    """Every ``service("name")`` with the function around it."""
    found: dict[str, list[tuple[str, ast.FunctionDef, ast.ClassDef | None]]] = {}
    for path in SOURCES:
        tree = ast.parse(path.read_text(encoding="utf-8"))
        for cls in [node for node in ast.walk(tree) if isinstance(node, ast.ClassDef)]:
            for function in [node for node in cls.body if isinstance(node, ast.FunctionDef)]:
                for node in ast.walk(function):
                    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "service":
                        module = ".".join(path.relative_to(ROOT.parent).with_suffix("").parts)
                        found.setdefault(node.args[0].value, []).append((module, function, cls))
    return found


def test_every_service_resolves_and_is_called():
    assert set(calls_of_services()) == set(registered())
    for home in registered().values():
        module, _, function = home.partition(":")
        assert callable(getattr(import_module(module), function))


@pytest.mark.parametrize("name", ["at", "curvature", "torsion"])
def test_a_method_has_the_signature_of_its_service(name):
    module, _, function = registered()[name].partition(":")
    service = inspect.signature(getattr(import_module(module), function))
    ((where, method, cls),) = calls_of_services()[name]
    own = inspect.signature(getattr(getattr(import_module(where), cls.name), method.name))
    told = [[(p.name, p.kind, p.default) for p in list(s.parameters.values())[1:]] for s in (own, service)]
    assert told[0] == told[1]
    plain = [str(s.return_annotation).replace("Exact", "mpq | Surd") for s in (own, service)]
    assert plain[0] == plain[1]


def test_the_plot_of_a_curve_hands_on_what_its_service_takes():
    module, _, function = registered()["plot"].partition(":")
    parameters = list(inspect.signature(getattr(import_module(module), function)).parameters.values())
    assert parameters[1].name == "ax"
    assert all(p.kind is p.KEYWORD_ONLY for p in parameters[2:])


#: Modules that import by a name in a string: the front door, the services, papers (folders of data), the optional
#: drawing libraries, what a user names on the command line, and what only notebooks need.
IMPORT_BY_STRING = {
    "__init__.py",
    "batch/grade/adapters/__init__.py",
    "cli/__init__.py",
    "cli/reduce.py",
    "display/__init__.py",
    "display/plot/canvas.py",
    "display/plot/html.py",
    "language/services.py",
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
IMPORT = re.compile(r"^\s*(?:from\s+(exactspline[\w.]*)\s+import|import\s+(exactspline[\w.]*))", re.MULTILINE)


@pytest.mark.skipif(not (CHECKOUT / "README.md").exists(), reason="the README is in the checkout only")
def test_the_readme_imports_from_the_front_door_alone():
    text = (CHECKOUT / "README.md").read_text(encoding="utf-8")
    blocks = "\n".join(re.findall(r"```python\n(.*?)```", text, re.DOTALL))
    found = [a or b for a, b in IMPORT.findall(blocks)]
    assert found
    assert set(found) == {"exactspline"}


@pytest.mark.parametrize("path", sorted((CHECKOUT / "notebooks").glob("*.ipynb")), ids=lambda p: p.stem)
def test_a_notebook_imports_from_the_front_door_alone(path):
    nbformat = pytest.importorskip("nbformat")
    cells = [cell.source for cell in nbformat.read(path, as_version=4).cells if cell.cell_type == "code"]
    found = [a or b for cell in cells for a, b in IMPORT.findall(cell)]
    assert found
    assert set(found) == {"exactspline"}
