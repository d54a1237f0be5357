"""Tables that are never cropped: in columns if there is room, with prose below its row if the columns are too wide,
otherwise one block per row. In a pipe there is one line per row. Tables are also written as CSV, Markdown and LaTeX.
"""

from __future__ import annotations

import ast
import re
import tokenize
from collections.abc import Iterable, Iterator, Sequence
from io import StringIO
from typing import TYPE_CHECKING

from rich.cells import cell_len

from exactspline.errors import written

if TYPE_CHECKING:
    from rich.console import Console, ConsoleOptions
    from rich.text import Text


# ---- lines


#: Control characters except tab and line break, and those that change the direction of text.
STEERING = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")


def hanging(text: str, width: int, indent: int = 2, first: int = 0) -> list[str]:
    """The lines of a text, at most this wide. The first line is indented by `first`, the others by `indent`.

    >>> hanging("the zero set of f0 is that of f2", 16)
    ['the zero set of', '  f0 is that of', '  f2']
    >>> hanging("123456789", 5)
    ['12345', '  678', '  9']
    """
    lines, current = [], " " * first
    empty = True
    for word in _words_in(visible(text)):
        rest = word
        if not empty and cell_len(current) + 1 + cell_len(rest) > width:
            lines.append(current)
            current, empty = " " * indent, True
        while empty and cell_len(current) + cell_len(rest) > width:
            part = _beginning(rest, max(1, width - cell_len(current)))
            lines.append(current + part)
            current, rest = " " * indent, rest[len(part) :]
        if rest:
            current += rest if empty else f" {rest}"
            empty = False
    return lines if empty else [*lines, current]


def visible(text: str) -> str:
    """A text with its control characters escaped, so that a file name cannot control the terminal.

    >>> visible("red\\x1b[31m, κ′ ≡ 0")
    'red\\\\x1b[31m, κ′ ≡ 0'
    """
    return STEERING.sub(lambda match: match[0].encode("unicode_escape").decode(), text)


def _words_in(text: str) -> Iterator[str]:
    """The words of a text, separated by blanks.

    >>> list(_words_in("2d − 3 points"))
    ['2d − 3', 'points']
    """
    held = ""
    words = text.split()
    for i, word in enumerate(words):
        held = f"{held} {word}" if held else word
        joined = word in "+−=≤≥" or (i + 1 < len(words) and words[i + 1] in "+−=≤≥")
        if not joined or cell_len(held) > LONGEST_JOINED:
            yield held
            held = ""
    if held:
        yield held


#: A sum or an equation of at most this length is not broken at its signs.
LONGEST_JOINED = 16


def _beginning(word: str, width: int) -> str:
    """The beginning of a text: as many characters as fit, and at least one."""
    end = 1
    while end < len(word) and cell_len(word[: end + 1]) <= width:
        end += 1
    return word[:end]


#: The indent of a continued line.
INDENT = "    "


def code_lines(line: str, width: int) -> list[str]:
    """Statements of Python, each broken into lines of at most that width wherever its tokens allow it.

    >>> for part in code_lines('print(max([3141592653, 2718281828, 1618033988]))', 30):
    ...     print(part)
    print(max([3141592653,
        2718281828, 1618033988]))
    >>> code_lines("from exactspline.papers import find", 30)
    ['from exactspline.papers \\\\', '    import find']
    """
    if cell_len(line) <= width:
        return [line]
    statements = [str(ast.get_source_segment(line, each)) for each in ast.parse(line).body]
    if len(statements) > 1:
        return [part for each in statements for part in code_lines(each, width)]
    lines, current, depth, empty = [], "", 0, True
    for blank, token in _tokens(line):
        room = width - (0 if depth else 2)
        if not empty and cell_len(current + blank + token) > room:
            lines.append(current if depth else f"{current} \\")
            current, empty = INDENT, True
        parts = [token]
        if token[0] in "\"'" and "\\" not in token and depth and cell_len(current + token) > width:
            parts = _split_text(token, max(4, width - len(INDENT)))
            lines += [f"{INDENT}{part}" for part in parts[:-1]]
        current, empty = current + ("" if empty else blank) + parts[-1], False
        depth += (token in "([{") - (token in ")]}") if len(token) == 1 else 0
    return [*lines, current]


def _tokens(line: str) -> list[tuple[str, str]]:
    """The tokens of a line of Python, each with the preceding blanks."""
    tokens, end = [], 0
    for token in tokenize.generate_tokens(StringIO(line).readline):
        if token.string.strip() and token.type != tokenize.ENDMARKER:
            tokens.append((line[end : token.start[1]], token.string))
            end = token.end[1]
    return tokens


def _split_text(token: str, width: int) -> list[str]:
    """A plain string literal as several adjacent literals, which Python concatenates."""
    quote, inner = token[0], token[1:-1]
    size = max(1, width - 2)
    return [f"{quote}{inner[i : i + size]}{quote}" for i in range(0, len(inner), size)]


#: A width beyond that of any terminal, so that output to a file or a pipe is not broken into lines or padded.
PIPE = 1 << 20
#: Blanks between two columns.
GAP = 2
#: The smallest width to which prose in a column is broken; below it rows become blocks.
NARROWEST = 24
#: Columns whose words the legend explains.
TAGGED = ("variant", "form", "verdict", "what", "piece")
#: In a pipe a cell longer than this shifts only its row.
LONGEST_ALIGNED = 72
#: Colours of verdicts, which are also given in words.
COLOURS = {
    "PROVED": "bold green",
    "VERIFIED": "green",
    "REFUTED": "bold magenta",
    "UNDECIDED": "yellow",
    "CONTRADICTION": "bold red",
    "NOT": "bold yellow",
}


class Sheet:
    """A table of texts under headings: one cell per column in each of the ``rows``.

    ``numbers`` names the columns that are aligned to the right, ``prose`` those whose cells may be broken into lines,
    ``lists`` those whose cells may be broken between their numbers.
    ``name`` is the subject of the table: CSV and Markdown put it into a separate column when several tables are
    combined. If rows become blocks, the first ``heads`` cells of a row are the heading of its block.

    >>> sheet = Sheet("curve", "degree", rows=[("circle", 2)], numbers=["degree"])
    >>> print(sheet.text(40))
    curve   degree
    circle       2
    >>> print(sheet.text(10))
    circle
      degree:
        2
    """

    def __init__(
        self,
        *columns: str,
        rows: Iterable[Sequence[object]] = (),
        title: str = "",
        name: str = "",
        numbers: Iterable[str] = (),
        prose: Iterable[str] = (),
        lists: Iterable[str] = (),
        heads: int = 1,
    ) -> None:
        self.columns, self.title, self.name, self.heads = columns, visible(title), visible(name), heads
        self.numbers, self.prose, self.lists = frozenset(numbers), frozenset(prose), frozenset(lists)
        self.rows: list[tuple[str, ...]] = []
        for row in rows:
            self.add_row(*row)

    def add_row(self, *cells: object) -> None:
        """Add a row, one cell per column; runs of blanks and line breaks in a cell become single blanks."""
        row = tuple("" if cell is None else visible(" ".join(written(cell).split())) for cell in cells)
        self.rows.append((row + ("",) * len(self.columns))[: len(self.columns)])

    @property
    def tags(self) -> list[str]:
        """The words in columns such as `verdict` that name kinds of things, each word once."""
        columns = [i for i, name in enumerate(self.columns) if name in TAGGED]
        return list(dict.fromkeys(row[i] for i in columns for row in self.rows))

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> Iterator[Text]:
        for line in self.lines(options.max_width):
            line.no_wrap, line.overflow = True, "ignore"
            yield line

    def text(self, width: int = PIPE) -> str:
        """Return the table as lines of at most that width."""
        return "\n".join(line.plain for line in self.lines(width))

    def lines(self, width: int = PIPE) -> list[Text]:
        """Return the styled lines of the table: none is longer than the width, and no cell is cropped."""
        from rich.text import Text  # imported only when a table is printed: help texts need no tables

        head = [Text(line, style="bold") for line in hanging(self.title, width)] if self.title else []
        if width >= PIPE:
            return head + self._aligned()
        widths = self._fitted(width)
        if widths is None:
            return head + (self._with_prose_below(width) or self._in_blocks(width))
        return head + self._in_columns(widths)

    def _fitted(self, width: int) -> list[int] | None:
        """The widths of the columns if only headings and prose are broken into lines; None if they do not fit."""
        free = width - GAP * (len(self.columns) - 1)
        cells = [max((cell_len(row[i]) for row in self.rows), default=0) for i in range(len(self.columns))]
        natural = list(map(max, cells, map(cell_len, self.columns)))
        if sum(natural) <= free:
            return natural
        headings = [max(map(cell_len, name.split()), default=0) for name in self.columns]
        least = list(map(max, cells, headings))
        for i, name in enumerate(self.columns):
            if name in self.prose | self.lists:
                longest = max((cell_len(word) for row in self.rows for word in _words_in(row[i])), default=0)
                least[i] = min(least[i], max(NARROWEST if name in self.prose else 0, longest, headings[i]))
        spare = free - sum(least)
        if spare < 0:
            return None
        for i in sorted(range(len(least)), key=lambda i: natural[i] - least[i]):
            more = min(spare, natural[i] - least[i])
            least[i], spare = least[i] + more, spare - more
        return least

    def _in_columns(self, widths: Sequence[int]) -> list[Text]:
        heading = self._row(self.columns, widths, heading=True)
        return [*heading, *[line for row in self.rows for line in self._row(row, widths)]]

    def _row(self, cells: Sequence[str], widths: Sequence[int], *, heading: bool = False) -> list[Text]:
        broken = [hanging(cell, width, indent=0) or [""] for cell, width in zip(cells, widths, strict=True)]
        height = max(map(len, broken))
        padded = [[""] * (height - len(c)) + c if heading else c + [""] * (height - len(c)) for c in broken]
        return [self._line(parts, widths, heading) for parts in zip(*padded, strict=True)]

    def _line(self, parts: Sequence[str], widths: Sequence[int], heading: bool) -> Text:
        from rich.text import Text

        line = Text()
        for name, part, width in zip(self.columns, parts, widths, strict=True):
            blank = " " * max(0, width - cell_len(part))
            style = "bold" if heading else COLOURS.get(part.split(" ")[0], "") if name == "verdict" else ""
            line.append(blank if name in self.numbers else "")
            line.append(part, style=style)
            line.append(("" if name in self.numbers else blank) + " " * GAP)
        line.rstrip()
        return line

    def _with_prose_below(self, width: int) -> list[Text]:
        """The table in columns, with the prose of a row indented below the row. It is empty if prose is not one of
        several columns, or if there is no room.
        """
        from rich.text import Text

        prose = [i for i, name in enumerate(self.columns) if name in self.prose]
        rest = [i for i in range(len(self.columns)) if i not in prose]
        narrow = Sheet(*[self.columns[i] for i in rest], numbers=self.numbers, lists=self.lists)
        narrow.rows = [tuple(row[i] for i in rest) for row in self.rows]
        widths = narrow._fitted(width) if len(prose) == 1 and len(rest) > 2 else None
        if widths is None:
            return []
        lines = list[Text]()
        for row, own in zip([self.columns, *self.rows], [narrow.columns, *narrow.rows], strict=True):
            heading = row is self.columns
            lines += narrow._row(own, widths, heading=heading)
            below = [" " * GAP * 2 + line for i in prose for line in hanging(row[i], width - 2 * GAP)]
            lines += [Text(line, style="bold" if heading else "") for line in below]
        return lines

    def _aligned(self) -> list[Text]:
        """The table with one line per row, however long."""
        widths = [
            max(cell_len(c) for c in (name, *[r[i] for r in self.rows if cell_len(r[i]) <= LONGEST_ALIGNED]))
            for i, name in enumerate(self.columns)
        ]
        return [self._line(self.columns, widths, True), *[self._line(row, widths, False) for row in self.rows]]

    def _in_blocks(self, width: int) -> list[Text]:
        """A row as a heading and, indented below it, the other cells with their headings; short cells are side by
        side.
        """
        from rich.text import Text

        lines: list[Text] = []
        for row in self.rows:
            heading = ", ".join(cell for cell in row[: self.heads] if cell)
            style = COLOURS.get(row[0].split(" ")[0], "bold")
            lines += [Text(line, style=style) for line in hanging(heading, width)]
            lines += map(Text, self._fields(row, width))
        return lines

    def _fields(self, row: Sequence[str], width: int) -> list[str]:
        lines, current = [], ""
        for name, cell in list(zip(self.columns, row, strict=True))[self.heads :]:
            field = f"{name}: {cell}"
            if not cell:
                continue
            if current and cell_len(current) + 3 + cell_len(field) <= width and name not in self.prose:
                current += f"   {field}"
                continue
            lines += [current] if current else []
            current = f"  {field}"
            if cell_len(current) > width:
                lines += [f"  {line}" for line in hanging(field, width - 2)]
                current = ""
        return [*lines, current] if current else lines

    def markdown(self) -> str:
        r"""Return the table in Markdown.

        >>> sheet = Sheet("form", "degree", numbers=["degree"])
        >>> sheet.add_row("|κ|", "2")
        >>> print(sheet.markdown())
        | form | degree |
        | --- | ---: |
        | \|κ\| | 2 |
        """
        rules = ["---:" if name in self.numbers else "---" for name in self.columns]
        rows = [self.columns, rules, *[[in_markdown(cell) for cell in row] for row in self.rows]]
        head = f"**{in_markdown(self.title)}**\n\n" if self.title else ""
        return head + "\n".join(f"| {' | '.join(row)} |" for row in rows)

    def latex(self) -> str:
        r"""Return the table as a LaTeX table.

        >>> print(Sheet("form", "degree", rows=[("f2", "9d − 6")], title="Of a curve", numbers=["degree"]).latex())
        % Of a curve
        \begin{tabular}{lr}
        form & degree \\
        \hline
        $f_{2}$ & $9d - 6$ \\
        \end{tabular}
        """
        from exactspline.display.latex_prose import prose

        head, *rows = [" & ".join(map(prose, row)) + r" \\" for row in (self.columns, *self.rows)]
        aligned = "".join("r" if name in self.numbers else "l" for name in self.columns)
        begun = [f"% {self.title}"] * bool(self.title) + [rf"\begin{{tabular}}{{{aligned}}}", head, r"\hline"]
        return "\n".join([*begun, *rows, r"\end{tabular}"])


#: Characters with a meaning in a cell of Markdown: of HTML, of the end of a cell, of a link.
_MEANT = {"&": "&amp;", "<": "&lt;", ">": "&gt;", "|": "\\|", "](": "]\\(", "\n": " ", "\r": " "}
#: The beginnings of texts that a spreadsheet evaluates.
_COMPUTED = tuple("=+-@＝＋－＠\t\r")
#: A printed number: abbreviated or not, a fraction, or infinite.
_NUMBER = re.compile(r"[-+−]?(∞|[\d.,/…]+([eE][-+]?\d+)?)")


def in_markdown(text: str) -> str:
    r"""A text escaped for a cell of Markdown, so that it is shown literally.

    >>> in_markdown("<img src=x> a | b [here](http://x)")
    '&lt;img src=x&gt; a \\| b [here]\\(http://x)'
    """
    return re.sub(r"[&<>|\n\r]|\]\(", lambda match: _MEANT[match[0]], text)


def _in_csv(text: str) -> str:
    """A text for a cell of a spreadsheet, escaped where it begins like a formula that would be evaluated; numbers are
    unchanged.

    >>> _in_csv("=1+1"), _in_csv("-x"), _in_csv("-1/2"), _in_csv("x = 1")
    ("'=1+1", "'-x", '-1/2', 'x = 1')
    """
    return f"'{text}" if text[:1] in _COMPUTED and not _NUMBER.fullmatch(text) else text


def csv_of(sheets: Sequence[Sheet], by: str = "", unchecked: Sequence[str] = ()) -> str:
    """Several tables with the same columns as one text of comma-separated values; `by` heads the column of their names.
    If files of formulas ran `unchecked`, a last column names them.

    >>> sheet = Sheet("form", "degree", name="circle")
    >>> sheet.add_row("f2", "3")
    >>> csv_of([sheet], "curve").splitlines()
    ['curve,form,degree', 'circle,f2,3']
    """
    out = StringIO()
    import csv

    writer = csv.writer(out, lineterminator="\n")
    if sheets:
        writer.writerow([*([by] if by else []), *sheets[0].columns, *(["unchecked"] if unchecked else [])])
    for sheet in sheets:
        writer.writerows(
            map(_in_csv, [*([sheet.name] if by else []), *row, *([", ".join(unchecked)] if unchecked else [])])
            for row in sheet.rows
        )
    return out.getvalue()
