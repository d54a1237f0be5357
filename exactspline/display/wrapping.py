"""Texts broken into lines at blanks; words longer than a line are broken at its end."""

from __future__ import annotations

import re
from collections.abc import Iterator

from rich.cells import cell_len

#: Control characters except tab and line break, and those that change the direction of text.
STEERING = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")


def hanging(text: str, width: int, indent: int = 2, first: int = 0) -> list[str]:
    """The lines of a text, at most this wide; all but the first are indented by `indent`, the first by `first`.

    >>> hanging("the zero set of f0 is that of f2", 16)
    ['the zero set of', '  f0 is that of', '  f2']
    >>> hanging("123456789", 5)
    ['12345', '  678', '  9']
    """
    lines, current = [], " " * first
    empty = True
    for word in words_in(visible(text)):
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


def words_in(text: str) -> Iterator[str]:
    """The words of a text, separated by blanks.

    >>> list(words_in("2d − 3 points"))
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
    """As many characters as fit, but at least one."""
    end = 1
    while end < len(word) and cell_len(word[: end + 1]) <= width:
        end += 1
    return word[:end]
