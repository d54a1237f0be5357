"""The import graph of exactspline, read from the code: packages as nodes, an arrow for every import.

python tests/import_graph.py          the picture in text, as docs/architecture.md holds it
python tests/import_graph.py --dot    for Graphviz
"""

from __future__ import annotations

import ast
import sys
from collections import defaultdict
from pathlib import Path

import exactspline

ROOT = Path(exactspline.__file__).parent
#: A package imports only from those in lines above its own.
ORDER = (
    ("errors",),
    ("exact", "atomic_write"),
    ("language",),
    ("splines", "readings", "papers"),
    ("programs",),
    ("roots", "symbolic"),
    ("geometry",),
    ("verification",),
    ("classroom",),
    ("display", "interchange"),
    ("batch",),
    ("cli",),
)
FLOOR = {package: i for i, packages in enumerate(ORDER) for package in packages}


def module_name(path: Path) -> str:
    """The dotted name of a module below the package, the package itself the empty one."""
    parts = path.relative_to(ROOT).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def trees() -> dict[str, ast.Module]:
    """The syntax tree of every module."""
    return {module_name(p): ast.parse(p.read_text(encoding="utf-8")) for p in sorted(ROOT.rglob("*.py"))}


def _for_checkers_only(tree: ast.AST) -> set[int]:
    found: set[int] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.If) and isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING":
            found |= {id(inner) for inner in ast.walk(node)}
    return found


def imported(tree: ast.AST, modules: set[str]) -> set[str]:
    """The modules of the package that a module imports, lazily or not; what only type checkers see does not count."""
    skipped, found = _for_checkers_only(tree), set()
    for node in ast.walk(tree):
        if id(node) in skipped:
            continue
        if isinstance(node, ast.Import):
            found |= {a.name.partition(".")[2] for a in node.names if a.name.split(".")[0] == "exactspline"}
        elif isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] == "exactspline":
            base = (node.module or "").partition(".")[2]
            for alias in node.names:
                inner = f"{base}.{alias.name}" if base else alias.name
                found.add(inner if inner in modules else base)
    return found


def module_graph() -> dict[str, set[str]]:
    """Every module with those that it imports."""
    known = trees()
    return {name: imported(tree, set(known)) - {name} for name, tree in known.items()}


def package_graph(modules: dict[str, set[str]]) -> dict[str, set[str]]:
    """Every package (or module beside them) with those that it imports."""
    found: dict[str, set[str]] = defaultdict(set)
    for name, targets in modules.items():
        package = name.split(".")[0]
        if package in FLOOR:
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
