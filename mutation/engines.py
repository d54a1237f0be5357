"""Mutants of the engines (readings, symbolic, roots, verification), judged by the tests that execute them.

A pytest plugin: the tests are collected once, then every mutant gets a forked process that runs its tests, fast ones
first, until one fails. The ledger is one of the tests.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from typing import Any

from mutation.coverage_map import ENGINE, MAP, ROOT
from mutation.forked import Result, forked
from mutation.mutants import Mutant, mutants


def files() -> list[str]:
    """The files of the engines."""
    return [
        path.relative_to(ROOT).as_posix()
        for room in ENGINE
        for path in sorted((ROOT / "exactspline" / room).rglob("*.py"))
    ]


def all_mutants() -> list[Mutant]:
    """Every mutant of every engine."""
    return [mutant for file in files() for mutant in mutants(file)]


class Judge:
    """The plugin: the verdicts instead of a run of the tests."""

    def __init__(
        self,
        chosen: list[Mutant],
        told: Callable[[Mutant, Result], bool],
        seconds: float = 120,
        jobs: int = 1,
        budget: float = 60,
    ) -> None:
        self.chosen, self.told, self.seconds, self.jobs, self.budget = chosen, told, seconds, jobs, budget
        self.map = json.loads(MAP.read_text(encoding="utf-8"))

    def pytest_runtestloop(self, session: Any) -> bool:
        """Every mutant, until `told` says that it is enough."""
        from _pytest.runner import runtestprotocol

        items = {item.nodeid: item for item in session.items}

        def work(mutant: Mutant) -> Result:
            tests, cut = self.selected(mutant, items)
            if not tests:
                return {"verdict": "survived", "by": "no test executes it"}
            mutant.apply()
            for item in tests:
                for report in runtestprotocol(item, log=False, nextitem=None):
                    if report.failed:
                        return {"verdict": "killed", "by": item.nodeid}
            return {"verdict": "survived", "by": f"{len(tests)} tests{', more would take too long' if cut else ''}"}

        for mutant, result in forked(self.chosen, work, self.seconds, self.jobs):
            if not self.told(mutant, result):
                break
        return True

    def selected(self, mutant: Mutant, items: dict[str, Any]) -> tuple[list[Any], bool]:
        """The tests that execute the function, fast ones first, as many as fit the budget; whether some do not."""
        names = self.map["functions"].get(f"{mutant.file}:{mutant.function}", [])
        known = self.map["seconds"]
        ordered = sorted((n for n in names if n in items), key=lambda n: known[n])
        chosen, total = [], 0.0
        for name in ordered:
            total += known[name]
            if total > self.budget:
                return chosen, True
            chosen.append(items[name])
        return chosen, False


def judged(chosen: list[Mutant], told: Callable[[Mutant, Result], bool], seconds: float, jobs: int) -> None:
    """Collect the tests and let the judge run."""
    import pytest

    arguments = ["-q", "-p", "no:cacheprovider", "-p", "no:warnings", "--rootdir", str(ROOT)]
    pytest.main(arguments, plugins=[Judge(chosen, told, seconds, jobs)])


def survivors(results: dict[str, Result]) -> Iterator[str]:
    """The names of those that survived."""
    return (name for name, result in results.items() if result["verdict"] == "survived")
