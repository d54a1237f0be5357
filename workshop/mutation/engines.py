"""Mutants of the engines (all rooms of `ENGINE`), judged by the tests that execute them.

A pytest plugin: everything is imported and collected once, then every mutant gets a forked process that runs the tests
of its line until one fails: first the tests that detected other mutants of the function, then the fast ones. The ledger
is one of the tests.
"""

from __future__ import annotations

import ast
import gc
import json
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from time import process_time
from typing import Any

from workshop.mutation.coverage_map import ENGINE, ROOT, caches, fingerprint, read_map
from workshop.mutation.forked import Result, end_after, forked
from workshop.mutation.mutants import Mutant, made_inside, mutants, node_of

#: Which test detected each mutant, stored in the repository: with it a sample is judged without a map.
WITNESSES = ROOT / "workshop" / "mutation" / "witnesses.json"


def files() -> list[str]:
    """The files of the engines, without the Coq printers, whose output Coq itself checks."""
    return [
        path.relative_to(ROOT).as_posix()
        for room in ENGINE
        for path in sorted((ROOT / "exactspline" / room).rglob("*.py"))
        if "coq" not in path.parts
    ]


def all_mutants() -> list[Mutant]:
    """Every mutant of every engine."""
    return [mutant for file in files() for mutant in mutants(file)]


def place(mutant: Mutant) -> str:
    """The function that a mutant changes."""
    return f"{mutant.file}:{mutant.function}"


def lines(mutant: Mutant) -> range:
    """The lines of the changed statement (of a compound one the head), counted from the function's first line."""
    node = node_of(mutant.file, mutant.function)
    around = [s for s in ast.walk(node) if isinstance(s, ast.stmt) and s is not node and _holds(s, mutant.line)]
    inner = max(around, key=lambda s: s.lineno)
    return range(inner.lineno - node.lineno, _last(inner) - node.lineno + 1)


def _holds(statement: ast.stmt, line: int) -> bool:
    return statement.lineno <= line <= _last(statement)


def _last(statement: ast.stmt) -> int:
    body = getattr(statement, "body", None)
    return body[0].lineno - 1 if body else statement.end_lineno or statement.lineno


class Tests:
    """Which tests execute a mutant, and how long they take."""

    def __init__(self) -> None:
        map_of_tests = read_map()
        self.seconds: dict[str, float] = map_of_tests["seconds"]
        self.functions = map_of_tests["functions"]
        self.noticed: dict[str, Counter[str]] = {}

    @property
    def files(self) -> list[str]:
        """The files of the tests."""
        return sorted({name.partition("::")[0] for name in self.seconds})

    def learn(self, known: Iterable[tuple[Mutant, Result]]) -> None:
        """Learn which test detected which mutant."""
        for mutant, result in known:
            if result["verdict"] == "killed" and result["by"] in self.seconds:
                self.noticed.setdefault(place(mutant), Counter())[result["by"]] += 1
                self.noticed.setdefault(mutant.file, Counter())[result["by"]] += 1

    def of(self, mutant: Mutant) -> list[str]:
        """The tests of the changed line in the order in which they are run; the tests of the whole function where that
        was edited since.
        """
        entry = self.functions.get(place(mutant), {"fingerprint": "", "lines": {}})
        fresh = entry["fingerprint"] == fingerprint(node_of(mutant.file, mutant.function))
        chosen = [str(k) for k in lines(mutant)] if fresh else [*entry["lines"]]
        tests = {test for k in chosen for test in entry["lines"].get(k, ())}
        near, far = (self.noticed.get(key, Counter[str]()) for key in (place(mutant), mutant.file))
        promising = {t for t in tests if self.seconds[t] < 3 and (near[t] or far[t] > 1)}
        first = sorted(promising, key=lambda t: (-near[t], -far[t], self.seconds[t]))[:12]
        return first + self._in_turn(tests - {*first})

    def _in_turn(self, tests: set[str]) -> list[str]:
        """Fast tests first; every test function gets the same time for its cases, which are similar."""
        spent, turn = Counter[str](), {}
        for test in sorted(tests, key=lambda t: (self.seconds[t], t)):
            function = test.partition("[")[0]
            spent[function] += self.seconds[test]
            turn[test] = spent[function]
        return sorted(tests, key=lambda t: (turn[t], t))


class Witnesses:
    """The recorded test for each detected mutant, by which a sample is judged where there is no map."""

    def __init__(self) -> None:
        self.recorded: dict[str, str] = json.loads(WITNESSES.read_text(encoding="utf-8"))
        self.seconds: dict[str, float] = {}

    def of(self, mutant: Mutant) -> list[str]:
        """The recorded test of the mutant, then those of other mutants of the function."""
        of_function = [test for name, test in self.recorded.items() if name.startswith(f"{place(mutant)}#")]
        of_mutant = [self.recorded[mutant.key]] if mutant.key in self.recorded else []
        return list(dict.fromkeys([*of_mutant, *of_function]))

    def of_edited(self, mutants: Iterable[Mutant]) -> list[Mutant]:
        """The mutants at the places of mutants that were detected in the same function before it was edited."""
        current = list(mutants)
        stale = {name.partition("@")[0] for name in self.recorded.keys() - {m.key for m in current}}
        return [m for m in current if m.key not in self.recorded and m.key.partition("@")[0] in stale]

    def files(self, chosen: list[Mutant]) -> list[str]:
        """The files of the tests."""
        return sorted({test.partition("::")[0] for mutant in chosen for test in self.of(mutant)})


def recorded(mutants: Iterable[Mutant], known: dict[str, Result]) -> dict[str, str]:
    """Every mutant that a test detected, by its key, with that test: as judged now or recorded before."""
    before, detected = Witnesses().recorded, {}
    for mutant in mutants:
        result = known.get(mutant.key, {"verdict": "killed", "by": before.get(mutant.key, "")})
        if result["verdict"] == "killed" and "::" in result["by"]:
            detected[mutant.key] = result["by"]
    return detected


class Judge:
    """The plugin that judges mutants instead of running the tests."""

    def __init__(self, chosen: list[Mutant], tests: Tests | Witnesses, budget: float, jobs: int = 1) -> None:
        self.chosen, self.tests, self.budget, self.jobs = chosen, tests, budget, jobs
        self.write_verdict: Callable[[Mutant, Result], bool] = lambda mutant, result: True
        self.sound: dict[str, bool] = {}

    def pytest_runtestloop(self, session: Any) -> bool:
        """Judge every mutant, until `write_verdict` returns False. A test that fails without any mutant detects
        nothing.
        """
        from _pytest.runner import runtestprotocol

        items, emptied, todo = {item.nodeid: item for item in session.items}, caches(), self.chosen
        made_inside()
        gc.freeze()  # so that garbage collection in forked processes does not copy memory

        def fails(name: str) -> bool:
            end_after(3 + 5 * self.tests.seconds.get(name, 1))
            return any(report.failed for report in runtestprotocol(items[name], log=False, nextitem=None))

        def work(mutant: Mutant) -> Result:
            mutant.apply()
            for cache_of in emptied:
                cache_of.cache_clear()
            ran = 0
            for name in self.within(mutant, items):
                ran += 1
                if fails(name):
                    return {"verdict": "killed", "by": name}
            return {"verdict": "survived", "by": f"{ran} tests" if ran else "no test executes it"}

        def unchanged(name: str) -> Result:
            return {"verdict": "killed" if fails(name) else "survived"}

        while todo:
            again = []
            for mutant, result in forked(todo, work, 60 + 20 * self.budget, self.jobs):
                name = result.get("by", "")
                if name in items and name not in self.sound:
                    ((_, plain),) = forked([name], unchanged, 60 + 20 * self.budget, 1)
                    self.sound[name] = plain["verdict"] == "survived"
                if not self.sound.get(name, True):
                    again.append(mutant)
                elif not self.write_verdict(mutant, result):
                    return True
            todo = again
        return True

    def within(self, mutant: Mutant, items: dict[str, Any]) -> Iterator[str]:
        """The tests of a mutant, as many as fit into the budget of processor time, without those that fail anyway."""
        for name in self.tests.of(mutant):
            if process_time() > self.budget:
                break
            if name in items and self.sound.get(name, True):
                yield name


def judged(judge: Judge, write_verdict: Callable[[Mutant, Result], bool], where: Iterable[str] = ()) -> None:
    """Collect the tests (only those of the files in `where`, if any are named), and run the judge."""
    import pytest

    judge.write_verdict = write_verdict
    arguments = ["-q", "-p", "no:cacheprovider", "-p", "no:warnings", "--rootdir", str(ROOT), *where]
    pytest.main(arguments, plugins=[judge])
