"""Text output: the console for results, its tables, legends and errors. Programs read JSON instead."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable
from io import StringIO
from typing import IO

from rich.console import Console, RenderableType
from rich.text import Text

from exactspline.display.sheet import PIPE
from exactspline.display.wrapping import hanging, visible

#: The smallest width that is assumed of a terminal.
NARROWEST = 20


def width(stream: IO[str] | None = None) -> int:
    """The columns of the terminal behind a stream; output to a file or a pipe is not limited, unless the environment
    sets ``COLUMNS``.
    """
    stream = stream or sys.stdout
    columns = os.environ.get("COLUMNS", "")
    if columns.isdigit() and int(columns):
        return max(NARROWEST, int(columns))
    try:
        return max(NARROWEST, os.get_terminal_size(stream.fileno()).columns) if stream.isatty() else PIPE
    except (OSError, ValueError):
        return 80 if stream.isatty() else PIPE


def console(stream: IO[str] | None = None) -> Console:
    """A console on a stream (by default standard output); without colours where ``NO_COLOR`` is set."""
    stream = stream or sys.stdout
    plain = bool(os.environ.get("NO_COLOR"))
    return Console(
        file=stream,
        width=width(stream),
        highlight=False,
        emoji=False,
        markup=False,
        no_color=plain,
        color_system=None if plain else "auto",
    )


def lines(out: Console, text: str, indent: int = 2, style: str = "", first: int = 0) -> None:
    """Print a text in lines no longer than the width of the console, all but the first indented."""
    for line in hanging(text, out.width, indent, first) or [""]:
        out.print(Text(line, style=style, no_wrap=True, overflow="ignore"), soft_wrap=True)


def legend(out: Console, words: Iterable[str]) -> None:
    """Print the meanings of the words that are in the glossary, one line each."""
    from exactspline.display.glossary import explained  # loaded only when its texts are shown

    explanations = explained(words)
    if explanations:
        out.print()
    for term, meaning in explanations:
        lines(out, f"{term}: {meaning}")


def plain(made: RenderableType, columns: int = 160) -> str:
    """The text that a console would show, for use without a terminal."""
    written = StringIO()
    Console(highlight=False, width=columns, color_system=None, file=written, force_jupyter=False).print(made)
    return "\n".join(line.rstrip() for line in written.getvalue().splitlines())


def show_error(error: object) -> None:
    """Print an error as one line on standard error."""
    Console(stderr=True, highlight=False, emoji=False, soft_wrap=True).print(visible(f"error: {error}"), markup=False)
