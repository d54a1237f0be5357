"""How each span of a paper is read: the table beside its claims, and the text itself where it is at hand."""

from __future__ import annotations

import re
import tomllib
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from reading.cutter import Span, spans, squeezed

ROOT = Path(__file__).resolve().parents[1]
TABLE = ROOT / "exactspline" / "papers" / "chen_riesenfeld_cohen_2007" / "reading.toml"
#: The text is not part of the repository.
TEXT = ROOT.parent / "shared" / "paper-raw.txt"
#: What a span can be.
READINGS = ("claims", "definition", "citation", "nothing", "open")
#: What asks for a reason where a span is said to decide nothing: numbers, formulas, and words of statements.
LOADED = re.compile(r"\d|[=+±×∗·‖κτγζλμΨ∑]|\b(degree|rational|zero|only|cannot|same)", re.IGNORECASE)


@dataclass(frozen=True)
class Reading:
    """One span of the table: where it stands, its first letters, its digest, and how it is read."""

    page: int
    order: int
    begins: str
    digest: str
    read: dict[str, Any]

    @property
    def claims(self) -> tuple[str, ...]:
        """The keys of the claims that it makes."""
        return tuple(self.read.get("claims", ()))

    @property
    def place(self) -> str:
        """Where it stands, with its first letters."""
        return f"p. {self.page}, span {self.order}: {self.begins}"


def table(file: Path = TABLE) -> dict[str, Any]:
    """The whole table, as it stands in its file."""
    return tomllib.loads(file.read_text(encoding="utf-8"))


def readings(file: Path = TABLE) -> tuple[Reading, ...]:
    """The readings of all spans, in the order of the text."""
    found = []
    for page in table(file)["page"]:
        for order, entry in enumerate(page["spans"], 1):
            rest = dict(entry)
            begins, digest = rest.pop("begins"), rest.pop("digest")
            found.append(Reading(page["number"], order, begins, digest, rest))
    return tuple(found)


def spans_of_text() -> tuple[Span, ...]:
    """The spans of the text, cut anew."""
    return spans(TEXT.read_text(encoding="utf-8"), table()["cut"])


def needs_reason(text: str) -> bool:
    """Whether a span that decides nothing must say why.

    >>> needs_reason("However, more is possible."), needs_reason("with degree 6")
    (False, True)
    """
    return bool(LOADED.search(text))


def runs(of: Iterable[tuple[Reading, Span]], key: str) -> Iterator[str]:
    """The letters of each run of neighbouring spans that name a claim."""
    letters, last = "", (0, 0)
    for one, span in of:
        if key not in one.claims:
            continue
        neighbour = (one.page, one.order - 1) == last
        if letters and not neighbour:
            yield letters
        letters = (letters if neighbour else "") + squeezed(span.text)
        last = (one.page, one.order)
    if letters:
        yield letters


def counted(own: Iterable[Reading]) -> dict[int, Counter[str]]:
    """How many spans of each page are read as what; one that is several things counts for each."""
    found: dict[int, Counter[str]] = {}
    for one in own:
        row = found.setdefault(one.page, Counter())
        row.update(["spans", *(name for name in (*READINGS, "slip") if name in one.read)])
    return found
