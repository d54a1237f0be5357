"""Text output: the console for results, its tables, legends and errors. Programs read JSON instead."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path
from typing import cast

from rich.console import Console
from rich.text import Text

from exactspline.display.sheet import PIPE, Sheet, hanging
from exactspline.errors import ExactSplineError, nearest
from exactspline.papers.folder import read_toml

# ---- the glossary


class GlossaryError(ExactSplineError):
    """The error for a term that is not in the glossary."""


@cache
def glossary() -> dict[str, dict[str, str]]:
    """Terms and their meanings, by topic.

    >>> glossary()["verdicts"]["REFUTED"]
    'it fails, and a witness shows where'
    """
    from exactspline.geometry.analysis.ask import terms_of_questions  # loads the classes with questions

    return _written() | {"questions": terms_of_questions(_by_term(_written()))}


@cache
def _written() -> dict[str, dict[str, str]]:
    """The words of tables and their meanings, by topic."""
    written = read_toml(Path(__file__).with_name("glossary.toml"), "glossary.toml")
    return cast(dict[str, dict[str, str]], written)


def _by_term(topics: Mapping[str, Mapping[str, str]]) -> dict[str, str]:
    return {term: meaning for topic in topics.values() for term, meaning in topic.items()}


@cache
def _terms() -> dict[str, str]:
    """Every term with its meaning."""
    return _by_term(glossary())


def meaning(term: str) -> str:
    """The meaning of a term; upper and lower case are distinguished only where both are terms.

    >>> meaning("proved") == meaning("PROVED")
    True

    Raises `GlossaryError` with the nearest terms.
    """
    known = _terms()
    for each in (term, *[name for name in known if name.lower() == term.lower()]):
        if each in known:
            return known[each]
    raise GlossaryError(f"the glossary has no term {term!r}", remedy=nearest(term, known, listed_by="list words"))


def explained(words: Iterable[str]) -> list[tuple[str, str]]:
    """Those of the words that the glossary explains, each once, with their meanings.

    >>> [term for term, _ in explained(["curve", "nominal", "true", "nominal"])]
    ['nominal', 'true']
    """
    known = _by_term(_written())
    return [(word, known[word]) for word in dict.fromkeys(words) if word in known]


#: The smallest width that is assumed of a terminal.
NARROWEST = 20


def width() -> int:
    """The number of columns of the terminal; output to a file or a pipe has no limit unless the environment sets
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
    """Print a text in lines no longer than the width of the console; all lines except the first are indented."""
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

    explanations = explained(words)
    if explanations:
        out.print()
    for term, meaning in explanations:
        lines(out, f"{term}: {meaning}")
