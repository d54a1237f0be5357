"""The import graph of exactspline, read from the code: packages as nodes, an arrow for every import.

python tests/support/import_graph.py          the picture in text, as docs/architecture.md holds it
python tests/support/import_graph.py --dot    for Graphviz
"""

from __future__ import annotations

import ast
import re
import sys
import tomllib
from collections import defaultdict
from functools import cache
from pathlib import Path

import exactspline

ROOT = Path(exactspline.__file__).parent
#: The contract of import-linter: a package imports only from those in lines above its own.
CONTRACTS_FILE = Path(__file__).parents[2] / "pyproject.toml"
CONTRACTS = tomllib.loads(CONTRACTS_FILE.read_text(encoding="utf-8"))
(LAYERS,) = (each["layers"] for each in CONTRACTS["tool"]["importlinter"]["contracts"] if each["id"] == "rooms")
ORDER = tuple(tuple(layer.split(" | ")) for layer in reversed(LAYERS) if layer != "__main__")
FLOOR = {package: i for i, packages in enumerate(ORDER) for package in packages}
#: A module, or something in one, named in a text: ``exactspline.roots``, ``roots.checker:check``.
NAMED = re.compile(r"(?:exactspline\.)?(\w+(?:\.\w+)*)\.?(?::\w+)?")
#: The tables that name what loads when it is used: the rows of these modules alone may name a room above their own.
TABLES = {"", "cli.common", "display.notebook", "display.plot.anything", "interchange.formats", "verification.judges"}
#: The rooms that they may name.
EXTRA = "extras"
#: What draws a paper's figures lies above all rooms, and is imported by nothing.
OF_FIGURES = re.compile(r"papers\.\w+\.figures\b.*")
#: What looks up a formula by its name: with a name in the code it is an import of its paper.
LOOK_UPS = {"find", "formula_of", "paper", "resolve"}


def module_name(path: Path) -> str:
    """The dotted name of a module below the package, the package itself the empty one."""
    parts = path.relative_to(ROOT).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


@cache
def files() -> dict[Path, ast.Module]:
    """The syntax tree of every file of the package, parsed once and changed by nobody."""
    return {p: ast.parse(p.read_text(encoding="utf-8")) for p in sorted(ROOT.rglob("*.py"))}


@cache
def nodes(tree: ast.AST) -> tuple[ast.AST, ...]:
    """All nodes of a syntax tree, gone through once."""
    return tuple(ast.walk(tree))


def trees() -> dict[str, ast.Module]:
    """The syntax tree of every module."""
    return {module_name(path): tree for path, tree in files().items()}


def imported(tree: ast.AST, modules: set[str], own: str = "") -> set[str]:
    """The modules of the package that a module imports: at its top or lazily, for type checkers alone, or by a name in
    a text (not that of a package around it: so its own files are found).
    """
    found = set()
    for node in nodes(tree):
        if isinstance(node, ast.Import):
            found |= {a.name.partition(".")[2] for a in node.names if a.name.split(".")[0] == "exactspline"}
        elif isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] == "exactspline":
            base = (node.module or "").partition(".")[2]
            for alias in node.names:
                inner = f"{base}.{alias.name}" if base else alias.name
                found.add(inner if inner in modules else base)
    return found | {
        name
        for name in named(tree, modules)
        if not f"{own}.".startswith(f"{name}.") and not (own in TABLES and name.split(".")[0] == EXTRA)
    }


def named(tree: ast.AST, modules: set[str]) -> set[str]:
    """The modules that a module names in its texts, and the papers where it looks up a formula by its name."""
    prose = {id(node.value) for node in nodes(tree) if isinstance(node, ast.Expr)}
    found = set()
    for node in nodes(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in prose:
            text = node.value
            if (
                (m := NAMED.fullmatch(text))
                and not text.endswith(".py")
                and (text.startswith("exactspline.") or "." in m[1] or ":" in text)
            ):
                parts = m[1].split(".")
                prefixes = [".".join(parts[:n]) for n in range(len(parts), 0, -1)]
                found |= {next((prefix for prefix in prefixes if prefix in modules), None)} - {None}
        elif isinstance(node, ast.Call) and node.args and isinstance(node.args[0], ast.Constant):
            name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
            if name in LOOK_UPS and isinstance(node.args[0].value, str) and not isinstance(node.func, ast.Attribute):
                found.add("papers")
    return found


def stubbed(stub: Path) -> set[str]:
    """The modules that a stub names, which its package imports when a name is first used."""
    room = ".".join(stub.relative_to(ROOT).parts[:-1])
    found = set()
    for node in ast.parse(stub.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.ImportFrom):
            names = [node.module] if node.module else [alias.name for alias in node.names]
            found |= {f"{room}.{name}".lstrip(".") for name in names}
    return found


@cache
def module_graph() -> dict[str, set[str]]:
    """Every module with those that it imports."""
    known = trees()
    graph = {name: imported(tree, set(known), name) - {name} for name, tree in known.items()}
    for stub in ROOT.rglob("*.pyi"):
        own = module_name(stub.with_suffix(".py"))
        graph[own] |= {name for name in stubbed(stub) if own not in TABLES or name.split(".")[0] != EXTRA}
    return graph


def package_graph(modules: dict[str, set[str]]) -> dict[str, set[str]]:
    """Every package (or module beside them) with those that it imports."""
    found: dict[str, set[str]] = defaultdict(set)
    for name, targets in modules.items():
        package = name.split(".")[0]
        if package in FLOOR and not OF_FIGURES.fullmatch(name):
            found[package] |= {t.split(".")[0] for t in targets} & FLOOR.keys() - {package}
    return dict(found)


def circles(modules: dict[str, set[str]]) -> list[list[str]]:
    """The strongly connected components of more than one module (Tarjan)."""
    index: dict[str, int] = {}
    low: dict[str, int] = {}
    stack: list[str] = []
    found: list[list[str]] = []

    def visit(name: str) -> None:
        index[name] = low[name] = len(index)
        stack.append(name)
        for other in modules.get(name, ()):
            if other not in index:
                visit(other)
                low[name] = min(low[name], low[other])
            elif other in stack:
                low[name] = min(low[name], index[other])
        if low[name] == index[name]:
            component = stack[stack.index(name) :]
            del stack[stack.index(name) :]
            if len(component) > 1:
                found.append(sorted(component))

    for name in modules:
        if name not in index:
            visit(name)
    return found


def text_picture(packages: dict[str, set[str]]) -> str:
    """One line a floor, and under it what each package imports."""
    lines = []
    for floor in ORDER:
        present = [package for package in floor if package in packages]
        for package in present:
            below = [other for row in ORDER for other in row if other in packages[package]]
            lines.append(f"{package:<13} ← {', '.join(below) or '–'}")
    return "\n".join(lines)


def dot_picture(packages: dict[str, set[str]]) -> str:
    """The same for Graphviz."""
    edges = [f'  "{a}" -> "{b}";' for a, targets in sorted(packages.items()) for b in sorted(targets)]
    return "digraph exactspline {\n  rankdir=BT;\n" + "\n".join(edges) + "\n}"


if __name__ == "__main__":
    graph = package_graph(module_graph())
    print(dot_picture(graph) if "--dot" in sys.argv[1:] else text_picture(graph))
