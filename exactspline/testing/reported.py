"""Cases from public bug reports, each with its link: the reported numbers, or a small curve that shows the same
defect. They are in ``reported.json`` beside this file.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from importlib.resources import files


@dataclass(frozen=True)
class Reported:
    """A curve of a bug report: of one segment where no knots are given."""

    key: str
    link: str
    note: str
    points: list[tuple[float, ...]]
    degree: int
    knots: list[float]
    weights: list[float] | None = None
    parameter: float | None = None


def _reported() -> list[Reported]:
    rows = json.loads(files(__package__).joinpath("reported.json").read_text(encoding="utf-8"))
    for row in rows:
        row["points"] = list(map(tuple, row["points"]))
        count = len(row["points"])
        row.setdefault("degree", count - 1)
        row.setdefault("knots", [*[0] * count, *[1] * count])
    return [Reported(**row) for row in rows]


REPORTED: list[Reported] = _reported()
