"""Which tests execute which functions, and how long each test takes: a pytest plugin that writes ``coverage.json``.

``python -m pytest -p mutation.coverage_map`` runs the suite once under coverage, a context for each test; of a part of
the suite what is known of the rest is kept.
"""

from __future__ import annotations

import ast
import json
import os
from collections.abc import Iterator
from pathlib import Path
from time import perf_counter
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parent.parent
#: Where the map is kept between runs.
MAP = ROOT / "mutation" / ".state" / "coverage.json"
#: The packages whose mutants are judged by tests.
ENGINE = ("readings", "symbolic", "roots", "verification")


def functions_of(path: Path) -> list[tuple[str, int, int]]:
    """The functions and methods of a file: qualified name, first and last line of the body."""
    found: list[tuple[str, int, int]] = []

    def visit(node: ast.AST, prefix: str) -> None:
        for child in ast.iter_child_nodes(node):
            if isinstance(child, ast.ClassDef):
                visit(child, f"{prefix}{child.name}.")
            elif isinstance(child, ast.FunctionDef):
                found.append((prefix + child.name, child.body[0].lineno, child.end_lineno or child.lineno))

    visit(ast.parse(path.read_text(encoding="utf-8")), "")
    return found


def key(path: Path, name: str) -> str:
    """A function by its file and its qualified name."""
    return f"{path.relative_to(ROOT).as_posix()}:{name}"


class Mapper:
    """Collects the lines of each test."""

    def __init__(self) -> None:
        import coverage

        source = [str(ROOT / "exactspline" / room) for room in ENGINE]
        self.measured = coverage.Coverage(data_file=None, include=[f"{room}/*" for room in source], config_file=False)
        self.seconds: dict[str, float] = {}

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_protocol(self, item: Any) -> Iterator[None]:
        """A context for each test."""
        self.measured.switch_context(item.nodeid)
        start = perf_counter()
        yield
        self.seconds[item.nodeid] = round(perf_counter() - start, 3)
        self.measured.switch_context("")

    def pytest_sessionstart(self) -> None:
        """Measuring begins before the tests are collected."""
        self.measured.start()

    def pytest_sessionfinish(self) -> None:
        """The map is written."""
        self.measured.stop()
        data, by_function = self.measured.get_data(), {}
        for room in ENGINE:
            for path in sorted((ROOT / "exactspline" / room).rglob("*.py")):
                contexts = data.contexts_by_lineno(str(path))
                for name, low, high in functions_of(path):
                    tests = {t for line in range(low, high + 1) for t in contexts.get(line, ()) if t}
                    by_function[key(path, name)] = sorted(tests)
        MAP.parent.mkdir(exist_ok=True)
        if MAP.is_file():
            known = json.loads(MAP.read_text(encoding="utf-8"))
            others = set(known["seconds"]) - set(self.seconds)
            for name, tests in known["functions"].items():
                by_function[name] = sorted({*by_function.get(name, ()), *others.intersection(tests)})
            self.seconds = {**known["seconds"], **self.seconds}
        text = json.dumps({"functions": by_function, "seconds": self.seconds}, ensure_ascii=False, indent=0)
        MAP.write_text(text, encoding="utf-8")


def pytest_configure(config: Any) -> None:
    """Register the mapper, unless tests are distributed (then nobody sees them all)."""
    if not os.environ.get("PYTEST_XDIST_WORKER"):
        config.pluginmanager.register(Mapper(), "coverage map")
