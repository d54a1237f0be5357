"""Text output: the console for results, its tables, legends and errors. Programs read JSON instead."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable

from rich.console import Console
from rich.text import Text

from exactspline.display.sheet import PIPE, Sheet, hanging

#: The smallest width that is assumed of a terminal.
NARROWEST = 20


def width() -> int:
    """The columns of the terminal; output to a file or a pipe is not limited, unless the environment sets
    ``COLUMNS``.
    """
    stream, columns = sys.stdout, os.environ.get("COLUMNS", "")
    if columns.isdigit() and int(columns):
        return max(NARROWEST, int(columns))
    try:
        return max(NARROWEST, os.get_terminal_size(stream.fileno()).columns) if stream.isatty() else PIPE
    except (OSError, ValueError):
        return 80 if stream.isatty() else PIPE


def console() -> Console:
    """A console on standard output; without colours where ``NO_COLOR`` is set."""
    plain = bool(os.environ.get("NO_COLOR"))
    return Console(
        file=sys.stdout,
        width=width(),
        highlight=False,
        emoji=False,
        markup=False,
        no_color=plain,
        color_system=None if plain else "auto",
    )


def lines(out: Console, text: str, indent: int = 2, style: str = "", first: int = 0) -> None:
    """Print a text in lines no longer than the width of the console, all but the first indented."""
    for line in hanging(text, out.width, indent, first) or [""]:
        unbroken(out, line, style)


def unbroken(out: Console, text: str, style: str = "") -> None:
    """Print a text as it is, to be copied: a line longer than the width of the console is not broken."""
    out.print(Text(text, style=style, no_wrap=True, overflow="ignore"), soft_wrap=True)


def below_each_other(out: Console, sheets: Iterable[Sheet]) -> None:
    """Print tables with an empty line between them."""
    for i, sheet in enumerate(sheets):
        if i:
            out.print()
        out.print(sheet)


def legend(out: Console, words: Iterable[str]) -> None:
    """Print the meanings of the words that are in the glossary, one line each."""
    from exactspline.display.glossary import explained  # loaded only when its texts are shown

    explanations = explained(words)
    if explanations:
        out.print()
    for term, meaning in explanations:
        lines(out, f"{term}: {meaning}")
