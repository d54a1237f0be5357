"""Second readers: of a drawn tenth of the spans, from the text before the table was looked at; and of all spans with
claims, to say what of their words the claims do not decide.
"""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from pathlib import Path
from random import Random

from exactspline.papers.passages import Passage
from reading.readings import readings

SECOND = Path(__file__).resolve().parent / "second_reading.toml"
UNDECIDED = SECOND.with_name("undecided.toml")
#: How many spans had claims when they were read again.
READ = 337
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


@dataclass(frozen=True)
class Undecided:
    """A span of which claims decided a part ("partly") or "nothing": what was missing, and the claims added for it."""

    page: int
    order: int
    digest: str
    decided: str
    missing: str
    added: tuple[str, ...] = ()


def undecided() -> tuple[Undecided, ...]:
    """All that was found missing."""
    entries = tomllib.loads(UNDECIDED.read_text(encoding="utf-8"))["span"]
    return tuple(Undecided(**entry | {"added": tuple(entry.get("added", ()))}) for entry in entries)
