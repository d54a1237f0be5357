"""Engines on pairs of paths that nearly coincide: what each made of them, and the judgement on it."""

from __future__ import annotations

import shutil
import sys
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from enum import StrEnum
from importlib import resources
from importlib.util import find_spec

from exactspline.errors import ExactSplineError
from exactspline.geometry.pairs.winding import FillRule
from exactspline.numbers.exact import mpq, text
from workshop.boolean.angles import confirms, farthest, suspects
from workshop.boolean.judge import Judgement, Operation, judged, judged_at
from workshop.boolean.pairs import Pair
from workshop.boolean.pieces import Region
from workshop.boolean.python_engines import ENGINES as IN_PYTHON
from workshop.grade.runner import Worker
from workshop.npm import folder_of

#: Engines of npm.
OF_NPM = ("paper", "pathkit-wasm", "path-bool")
ENGINES = (*IN_PYTHON, *OF_NPM)


#: How many points are judged by themselves before the whole plane is, and their denominator.
SUSPECTS, GRID = 8, 64


class Outcome(StrEnum):
    """What is said of a result."""

    RIGHT = "right"
    WRONG = "wrong"
    RAISED = "raised"
    UNDECIDED = "undecided"


@dataclass(frozen=True)
class Graded:
    """One operation of an engine on a pair: its outcome, and the witness of a wrong one; whether sums of angles in
    doubles say the same there.
    """

    engine: str
    operation: Operation
    pair: Pair
    outcome: Outcome
    made: str = ""
    rule: str = ""
    why: str = ""
    confirmed: bool | None = None
    #: Of a wrong result, about how far its segments are from the paths: more than ε where a segment is none of theirs.
    farthest: float | None = None

    def data(self) -> dict[str, object]:
        """All of it as data."""
        return {
            "engine": self.engine,
            "operation": self.operation,
            "first": self.pair.first,
            "second": self.pair.second,
            "exponent": self.pair.exponent,
            "outcome": self.outcome,
            "made": self.made,
            "rule": self.rule,
            "why": self.why,
            "confirmed": self.confirmed,
            "farthest": self.farthest,
        }


def started(engine: str) -> Worker:
    """An engine in a process of its own; ImportError where it is not installed."""
    if engine in IN_PYTHON:
        # FontForge comes with the Python of the system
        here = engine != "FontForge" or find_spec("fontforge") is not None
        script = resources.files(__package__).joinpath("python_engines.py")
        return Worker(engine, (sys.executable if here else "/usr/bin/python3", str(script), engine))
    folder, node = folder_of(engine), shutil.which("node")
    if node is None or folder is None:
        raise ImportError(engine)
    script = resources.files(__package__).joinpath("engines.mjs")
    return Worker(engine, (node, str(script), engine, str(folder.parent)))


def graded(
    worker: Worker, pairs: Iterable[Pair], operations: Iterable[Operation], within: mpq, *, whole: bool = True
) -> Iterator[Graded]:
    """The judgements on what an engine makes of pairs; without `whole` at some points alone, by which nothing is found
    right.
    """
    chosen = tuple(operations)
    for pair in pairs:
        for operation in chosen:
            reply = worker.exchange({"first": pair.first, "second": pair.second, "operation": operation.value})
            if "declined" not in reply:
                yield _graded(worker.library, operation, pair, reply, within, whole)


def _graded(engine: str, operation: Operation, pair: Pair, reply: dict[str, str], within: mpq, whole: bool) -> Graded:
    if "path" not in reply:
        return Graded(engine, operation, pair, Outcome.RAISED, why=reply.get("raised") or reply["late"])
    made, rule = reply["path"], reply["rule"]
    first, second = Region.of(pair.first), Region.of(pair.second)
    try:
        result = Region.of(made, FillRule(rule)) if made else Region(())
    except ExactSplineError as error:
        return Graded(engine, operation, pair, Outcome.RAISED, made, rule, f"not path data: {error}")
    points = suspects(first, second, operation, result, float(within))[:SUSPECTS]
    exact = [(mpq(round(GRID * point.real), GRID), mpq(round(GRID * point.imag), GRID)) for point in points]
    shown = (judged_at(point, first, second, operation, result, within) for point in exact)
    found = next(filter(None, shown), None) or (
        judged(first, second, operation, result, within) if whole else Judgement(None)
    )
    if found.right is not False:
        return Graded(engine, operation, pair, Outcome.RIGHT if found.right else Outcome.UNDECIDED, made, rule)
    assert found.witness is not None
    x, y = map(text, found.witness)
    why = f"({x}, {y}) is {'outside' if found.inside else 'inside'}"
    confirmed = confirms(found, first, second, operation, result)
    far = farthest(first, second, result)
    return Graded(engine, operation, pair, Outcome.WRONG, made, rule, why, confirmed, far)
