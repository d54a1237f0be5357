"""How each span of a paper is read: the table beside its claims, and the text itself where it is at hand."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator
from pathlib import Path

from exactspline.papers import paper
from exactspline.papers.passages import Passage, ReadingTable, passages, reading_of
from reading.cutter import Span, spans, squeezed

ROOT = Path(__file__).resolve().parents[1]
#: The paper that is read.
NAME = "chen_riesenfeld_cohen_2007"
#: The text is not part of the repository.
TEXT = ROOT.parent / "shared" / "paper-raw.txt"
#: What a span can be.
READINGS = ("claims", "definition", "citation", "nothing", "open")
#: What asks for a reason where a span is said to decide nothing: numbers, formulas, and words of statements.
LOADED = re.compile(r"\d|[=+±×∗·‖κτγζλμΨ∑]|\b(degree|rational|zero|only|cannot|same)", re.IGNORECASE)


def table() -> ReadingTable:
    """The whole table, as it is written in its file."""
    return reading_of(paper(NAME))


def readings() -> tuple[Passage, ...]:
    """The readings of all spans, in the order of the text."""
    return passages(paper(NAME))


def spans_of_text() -> tuple[Span, ...]:
    """The spans of the text, cut anew."""
    return spans(TEXT.read_text(encoding="utf-8"), table()["cut"])


def needs_reason(text: str) -> bool:
    """Whether a span that decides nothing must say why.

    >>> needs_reason("However, more is possible."), needs_reason("with degree 6")
    (False, True)
    """
    return bool(LOADED.search(text))


def runs(of: Iterable[tuple[Passage, Span]], key: str) -> Iterator[str]:
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


def decided(own: Iterable[Passage]) -> tuple[int, int]:
    """How many spans make claims, and of how many of these the claims decide all that is said."""
    claiming = [one for one in own if one.claims]
    return len(claiming), sum("open" not in one.read for one in claiming)


def counted(own: Iterable[Passage]) -> dict[int, Counter[str]]:
    """How many spans of each page are read as what; one that is several things counts for each."""
    found: dict[int, Counter[str]] = {}
    for one in own:
        row = found.setdefault(one.page, Counter())
        row.update(["spans", *(name for name in (*READINGS, "slip") if name in one.read)])
    return found
