"""The passages of a source in order: its sentences, displays, cells, captions and footnotes, each with its
classification.

The passages are listed in ``reading.toml`` in the folder of the paper. A passage is identified by its page, its place
on it and the digest of its letters; only its first letters are in the table. A passage can be one or several of these:
``claims`` (their keys), a ``definition``, a ``citation``, ``nothing`` (with a word and a ``reason`` why), a ``slip`` of
notation, ``open``.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TypedDict, cast

from exactspline.errors import ClaimError
from exactspline.one_line import OneLine
from exactspline.papers.folder import Paper, read_toml

FILE = "reading.toml"
_NUMBER = re.compile(r"\d+(\.\d+)*(?=\.? )")


#: One passage as it is written, and one page of passages.
Entry = dict[str, str | list[str]]


class Page(TypedDict):
    """The passages of a page."""

    number: int
    spans: list[Entry]


class ReadingTable(TypedDict, total=False):
    """The table: how the text is divided, the titles of sections by number, words for parts that are not text, and the
    pages.
    """

    cut: dict[str, str | int]
    sections: dict[str, str]
    furniture: dict[str, list[str]]
    page: list[Page]


@dataclass(frozen=True, repr=False)
class Passage(OneLine):
    """One passage: its page, its place on the page, its section, its first letters, its digest, and its
    classification.
    """

    page: int
    order: int
    section: str
    begins: str
    digest: str
    read: Entry

    @property
    def claims(self) -> tuple[str, ...]:
        """The keys of the claims that the passage makes."""
        return tuple(self.read.get("claims", ()))

    @property
    def place(self) -> str:
        """The place of the passage, with its first letters."""
        return f"p. {self.page}, span {self.order}: {self.begins}"


def reading_of(source: Paper) -> ReadingTable:
    """The table as it is written; empty for a paper without a table."""
    return cast(ReadingTable, read_toml(source.folder.joinpath(FILE), f"{source.name}/{FILE}"))


def passages(source: Paper) -> tuple[Passage, ...]:
    """The passages of a source in the order of its text.

    >>> from exactspline.papers import paper
    >>> own = passages(paper("chen_riesenfeld_cohen_2007"))
    >>> next(each.place for each in own if each.section == "4.1" and each.claims)
    'p. 8, span 11: This achieves significant d…'
    """
    return tuple(_read(reading_of(source)))


def sections_of(source: Paper) -> dict[str, str]:
    """The sections of a source by number, with their titles."""
    return reading_of(source).get("sections", {})


def _read(table: ReadingTable) -> Iterator[Passage]:
    sections = list(table.get("sections", {}))
    section = next(iter(sections), "")
    for page in table.get("page", ()):
        for order, entry in enumerate(page["spans"], 1):
            read = dict(entry)
            if "begins" not in read:
                where = f"{FILE}, page {page['number']}, span {order}"
                raise ClaimError("a span without its first letters", where=where, remedy='write begins = "…"')
            begins, digest = str(read.pop("begins")), str(read.pop("digest", ""))
            if read.get("nothing") == "heading":
                section = _section(begins, sections)
            yield Passage(page["number"], order, section, begins, digest, read)


def _section(heading: str, sections: list[str]) -> str:
    """The section that a heading opens: its own number, the first one in it, or the one that contains it; none for a
    heading without a number.
    """
    found = _NUMBER.match(heading)
    number = found[0] if found else ""
    inside = (each for each in sections if number and each.startswith(f"{number}."))
    around = (each for each in sections if number.startswith(f"{each}."))
    return number if number in sections else next(inside, next(around, ""))
