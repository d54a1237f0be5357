"""A text as it was extracted from a PDF, cut into spans: page by page into sentences, display lines, cells of a table,
captions, footnotes, headings, entries of the list of references.

The cut is made by rules alone, so that it is the same wherever the text is at hand. What is particular to one paper
(the line that begins a page, the row of its table) is data beside the readings of its spans.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from hashlib import sha256
from itertools import chain, groupby

#: What is written in two ways.
ALIKE = {"″": "′′", "‴": "′′′", "’": "'"} | dict(zip("⁰¹²³⁴⁶⁷⁻⁽ⁱ⁾", "0123467−(i)", strict=True))
#: Words of one or two letters by which prose is known; a display has letters of one kind alone.
SHORT = "a|an|as|at|be|by|if|in|is|it|of|on|or|So|to|we"
WORD = re.compile(rf"[A-Za-z]?[a-z]{{2,}}|(?<![^\s(])(?:{SHORT})(?![\w′])")
HEADING = re.compile(r"(\d\.(\d\.)*) [A-Z]|References$")
#: A line with which a span begins, whatever stands before it.
BEGINNING = re.compile(r"[a-e](?=[A-Z][a-z]|or,|It )|Fig\. \d\. |\([a-d]\) (?!and)|\(\d\) [a-z]|Remark \d\.\d\. ")
CAPTION_PART = re.compile(r"(?<=[^\s]) (?=\([b-d]\) (?:[A-Z]|the ))")
ENTRY = re.compile(r"(?:^|(?<=\d\.)|(?<=\s))(?=\d{1,2}\. (?:[A-Z]|K M))")
#: The end of a sentence, with its raised numbers of references.
NOT_AFTER = (r"Fig\.", r"^Fig\. \d\.", r"Figs\.", r"Eq\.", r"Ref\.", r"cf\.", r"Rm\.", r"\bS\.", r"\bF\.")
NOT_AFTER += (r"Remark \d\.\d\.", r"^\d\.", r"^\d\.\d\.", r"^\d\.\d\.\d\.")
ABBREVIATED = "".join(f"(?<!{each})" for each in NOT_AFTER)
SENTENCE = re.compile(rf"(?<=[.!?])(?:\d+(?:,\d+)*)?(?:\)|”)?{ABBREVIATED}\s+(?=[A-Z(∗�])|(?<=�)\s+(?=[A-Z])")


def squeezed(words: str) -> str:
    """Without spaces and hyphens (lines are broken anywhere), and bold letters once: the text has each three times.

    >>> squeezed("polynomial B-\\nspline γγγ′")
    'polynomialBsplineγ′'
    """
    for theirs, ours in ALIKE.items():
        words = words.replace(theirs, ours)
    return re.sub(r"([^\W\d_]′*)\1\1", r"\1", re.sub(r"[\s\-]", "", words))


@dataclass(frozen=True)
class Span:
    """A piece of the text: its page, its place on it (from 1), and its words."""

    page: int
    order: int
    text: str

    @property
    def digest(self) -> str:
        """Eight hexadecimal digits by which it is known where the text is not at hand."""
        return sha256(squeezed(self.text).encode()).hexdigest()[:8]

    @property
    def begins(self) -> str:
        """Its first letters, for people."""
        words = re.sub(r"([^\W\d_]′*)\1\1", r"\1", self.text)
        return words if len(words) <= 28 else f"{words[:27].rstrip()}…"


def spans(text: str, cut: Mapping[str, object]) -> tuple[Span, ...]:
    """All spans of a text, in its order. `cut` has ``header``, the line that begins a page; ``begins``, a regular
    expression of lines with which a span begins whatever stands before it; ``table_page`` and ``table_row``, one whose
    groups are the cells of a row.
    """
    found, begins = [], re.compile(f"{BEGINNING.pattern}|{cut['begins']}")
    references = False
    for page, content in enumerate(text.split(str(cut["header"]))):
        lines = [line.strip() for line in content.splitlines() if line.strip()]
        if references := references or "References" in lines:
            at = lines.index("References") + 1 if "References" in lines else 1
            pieces = [*_pieces(lines[:at], begins), *_entries(lines[at:])]
        elif page == cut["table_page"]:
            pieces = list(_cells(lines, str(cut["table_row"])))
        else:
            pieces = list(_pieces(lines, begins))
        head = [str(cut["header"])] if page else []
        found += [Span(page, i, piece) for i, piece in enumerate([*head, *pieces], 1)]
    return tuple(found)


def _pieces(lines: list[str], begins: re.Pattern[str]) -> Iterator[str]:
    """The running head, and what follows it: prose by sentences, displays by lines."""
    yield from lines[:1]
    for display, block in _blocks(chain.from_iterable(CAPTION_PART.split(line) for line in lines[1:]), begins):
        if display:
            yield from _display_lines(block)
        else:
            yield from filter(None, (each.strip() for each in SENTENCE.split(" ".join(block))))


def _blocks(lines: Iterable[str], begins: re.Pattern[str]) -> Iterator[tuple[bool, list[str]]]:
    """Runs of lines of one kind, displays or prose; a heading, a footnote, a caption begins one."""
    number = 0
    marked = []
    heading = False
    for line in lines:
        display = is_display(line)
        goes_on = heading and line[0].islower()
        heading = (bool(HEADING.match(line)) and not display) or goes_on
        number += bool(begins.match(line)) or (heading and not goes_on) or bool(marked and marked[-1][2] > heading)
        marked.append((number, display, heading, line))
    for (_, display), run in groupby(marked, key=lambda each: each[:2]):
        yield display, [each[-1] for each in run]


def is_display(line: str) -> bool:
    """Whether a line belongs to a displayed formula: no word of a language stands in it.

    >>> is_display("w2+ (p′p′p′w − ppp w′)("), is_display("degree 3d−1 polynomial B-spline."), is_display("(3d−3).")
    (True, False, True)
    """
    return not WORD.search(squeezed_letters(line))


def squeezed_letters(line: str) -> str:
    """Bold letters once, and no products of letters: what is left of length two or more is a word."""
    once = re.sub(r"([^\W\d_]′*)\1\1(\1\1)*", r"\1", line)
    return re.sub(r"(?<![A-Za-z])(pw|wp|ww|pp)(?![A-Za-z])", "", once)


def _display_lines(block: list[str]) -> Iterator[str]:
    """A display, one span for each line of a chain of equalities."""
    line: list[str] = []
    for piece in block:
        if line and re.search(r"(^|[^≤≥])=", piece) and any("=" in each for each in line):
            yield " ".join(line)
            line = []
        line.append(piece)
    yield " ".join(line)


def _cells(lines: list[str], row: str) -> Iterator[str]:
    """A page with a table: its head, and the cells of its rows."""
    at = next(i for i, line in enumerate(lines) if re.match("[^A-Za-z]*(\\w)\\1\\1", line))
    yield from lines[:at]
    for match in re.finditer(row, " ".join(lines[at:])):
        yield from (cell.strip() for cell in match.groups())


def _entries(lines: list[str]) -> Iterator[str]:
    """The entries of a list of references."""
    yield from filter(None, (each.strip() for each in ENTRY.split(" ".join(lines))))
