"""Which tests execute which lines of the engines, and how long each test takes: a plugin that writes ``coverage.json``.

``python -m pytest -p workshop.mutation.coverage_map`` runs tests once under coverage, with a context per test; when
only a part of the suite is run, the map of the rest is kept. Every test starts with empty caches and fresh fixtures, so
that earlier tests do not hide which lines it executes; a test that fails without any mutant is omitted.
"""

from __future__ import annotations

import ast
import copy
import gc
import hashlib
import json
import os
from collections.abc import Iterator
from functools import _lru_cache_wrapper
from pathlib import Path
from time import perf_counter
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
#: The file that stores the map between runs.
MAP = ROOT / "workshop" / "mutation" / ".state" / "coverage.json"
#: The packages whose mutants are judged by tests.
ENGINE = (
    "certificates",
    "numbers",
    "polynomials",
    "reals",
    "splines",
    "readings",
    "programs",
    "roots",
    "symbolic",
    "geometry",
    "verification",
)
#: Caches of file contents, which are the same for every mutant.
READ = ("papers", "_formulas", "all_formulas", "example", "example_names")
#: The tests of a function by line, counted from its first line.
Lines = dict[str, list[str]]


def functions_of(path: Path) -> Iterator[tuple[str, ast.FunctionDef]]:
    """The functions and methods of a file by qualified name."""

    def visit(node: ast.AST, prefix: str) -> Iterator[tuple[str, ast.FunctionDef]]:
        for child in ast.iter_child_nodes(node):
            if isinstance(child, ast.ClassDef):
                yield from visit(child, f"{prefix}{child.name}.")
            elif isinstance(child, ast.FunctionDef):
                yield prefix + child.name, child

    yield from visit(ast.parse(path.read_text(encoding="utf-8")), "")


def fingerprint(function: ast.FunctionDef) -> str:
    """A digest of a function's source, independent of its position."""
    return hashlib.sha256(ast.unparse(function).encode()).hexdigest()[:16]


def meaning(function: ast.FunctionDef) -> str:
    """A digest of a function's code, without docstrings and annotations."""
    return fingerprint(_Bare().visit(copy.deepcopy(function)))


class _Bare(ast.NodeTransformer):
    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.AST:
        node.returns = None
        if ast.get_docstring(node, clean=False) is not None:
            node.body = node.body[1:] or [ast.Pass()]
        return self.generic_visit(node)

    def visit_arg(self, node: ast.arg) -> ast.AST:
        node.annotation = None
        return node

    def visit_AnnAssign(self, node: ast.AnnAssign) -> ast.AST:
        if node.value is None:
            return ast.copy_location(ast.Pass(), node)
        return self.generic_visit(ast.copy_location(ast.Assign([node.target], node.value), node))


def caches() -> list[Any]:
    """The caches of all functions of the project and its tests, except those of file contents."""
    wrappers = [o for o in gc.get_objects() if isinstance(o, _lru_cache_wrapper)]
    ours = ("exactspline", "tests", "test_", "proofs")
    return [c for c in wrappers if str(c.__module__).startswith(ours) and c.__name__ not in READ]


class Mapper:
    """Runs the tests, each in a separate coverage context."""

    def __init__(self) -> None:
        import coverage

        include = [str(ROOT / "exactspline" / room / "*") for room in ENGINE]
        self.measured = coverage.Coverage(data_file=None, include=include, config_file=False)
        self.seconds: dict[str, float] = {}

    def pytest_sessionstart(self) -> None:
        """Start measuring before the tests are collected."""
        self.measured.start()

    def pytest_runtestloop(self, session: Any) -> bool:
        """Run every test as if it were the only one."""
        from _pytest.runner import runtestprotocol

        emptied = caches()
        for item in session.items:
            for cache in emptied:
                cache.cache_clear()
            self.measured.switch_context(item.nodeid)
            start = perf_counter()
            reports = runtestprotocol(item, log=False, nextitem=None)
            if all(report.passed for report in reports):
                self.seconds[item.nodeid] = round(perf_counter() - start, 3)
            self.measured.switch_context("")
        return True

    def pytest_sessionfinish(self) -> None:
        """Write the map."""
        self.measured.stop()
        known = read_map() if MAP.is_file() else {"functions": {}, "seconds": {}}
        others = set(known["seconds"]) - set(self.seconds)
        functions = {}
        for room in ENGINE:
            for path in sorted((ROOT / "exactspline" / room).rglob("*.py")):
                contexts = self.measured.get_data().contexts_by_lineno(str(path))
                for name, node in functions_of(path):
                    key = f"{path.relative_to(ROOT).as_posix()}:{name}"
                    before = known["functions"].get(key, {"lines": {}})["lines"]
                    functions[key] = {
                        "fingerprint": fingerprint(node),
                        "lines": self._lines(node, contexts, before, others),
                    }
        write_map({"functions": functions, "seconds": {**known["seconds"], **self.seconds}})

    def _lines(self, node: ast.FunctionDef, contexts: dict[int, list[str]], before: Lines, others: set[str]) -> Lines:
        lines = {}
        for line in range(node.body[0].lineno, (node.end_lineno or node.lineno) + 1):
            offset = str(line - node.lineno)
            tests = {*self.seconds} & {*contexts.get(line, ())} | others & {*before.get(offset, ())}
            if tests:
                lines[offset] = sorted(tests)
        return lines


def write_map(coverage: dict[str, Any]) -> None:
    """Write a map: tests by number, and each set of tests once, since many lines share the same set."""
    number = {test: i for i, test in enumerate(coverage["seconds"])}
    sets: dict[tuple[int, ...], int] = {}
    functions = {}
    for name, entry in coverage["functions"].items():
        lines = {k: tuple(number[test] for test in tests) for k, tests in entry["lines"].items()}
        functions[name] = {**entry, "lines": {k: sets.setdefault(tests, len(sets)) for k, tests in lines.items()}}
    MAP.parent.mkdir(exist_ok=True)
    text = json.dumps({"seconds": coverage["seconds"], "sets": [*sets], "functions": functions}, ensure_ascii=False)
    MAP.write_text(text, encoding="utf-8")


def read_map() -> dict[str, Any]:
    """The map with the names of tests in their places."""
    stored = json.loads(MAP.read_text(encoding="utf-8"))
    tests = [*stored["seconds"]]
    sets = [[tests[i] for i in numbers] for numbers in stored["sets"]]
    for entry in stored["functions"].values():
        entry["lines"] = {k: sets[i] for k, i in entry["lines"].items()}
    return {"seconds": stored["seconds"], "functions": stored["functions"]}


def pytest_configure(config: Any) -> None:
    """Register the mapper, unless tests are distributed (then no process sees them all)."""
    if not os.environ.get("PYTEST_XDIST_WORKER"):
        config.pluginmanager.register(Mapper(), "coverage map")
