"""The second reader: a drawn tenth of the spans, read from the text before the table was looked at."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from pathlib import Path
from random import Random

from exactspline.papers.passages import Passage
from reading.readings import readings

SECOND = Path(__file__).resolve().parent / "second_reading.toml"
#: The seed of the draw, its size, and the page with which it begins: earlier readings had been seen.
SEED, SIZE, FIRST_PAGE = 20, 64, 5


@dataclass(frozen=True)
class SecondReading:
    """What the second reader wrote of one span: what it is, what it states, and whether that holds (in words).

    `outcome` is "mended" or "kept" where the record read something else, `why` the reason; else both are empty.
    """

    page: int
    order: int
    digest: str
    read: str
    states: str
    holds: str = ""
    outcome: str = ""
    why: str = ""


def drawn() -> tuple[Passage, ...]:
    """The spans that were drawn, in the order of the text."""
    own = [one for one in readings() if one.page >= FIRST_PAGE]
    return tuple(own[i] for i in sorted(Random(SEED).sample(range(len(own)), SIZE)))


def second_readings() -> tuple[SecondReading, ...]:
    """All that the second reader wrote."""
    return tuple(SecondReading(**entry) for entry in tomllib.loads(SECOND.read_text(encoding="utf-8"))["span"])
