"""Texts and code broken into lines: texts at blanks (words longer than a line at its end), code between two tokens, so
that it can still be pasted.
"""

from __future__ import annotations

import ast
import re
import tokenize
from collections.abc import Iterator
from io import StringIO

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


#: The indent of a continued line.
INDENT = "    "


def code_lines(line: str, width: int) -> list[str]:
    """A statement broken into lines of at most that width where its tokens allow it; several ones, each for itself.

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
    """The tokens of a line, each with the preceding blanks."""
    tokens, end = [], 0
    for token in tokenize.generate_tokens(StringIO(line).readline):
        if token.string.strip() and token.type != tokenize.ENDMARKER:
            tokens.append((line[end : token.start[1]], token.string))
            end = token.end[1]
    return tokens


def _split_text(token: str, width: int) -> list[str]:
    """A plain string literal as several adjacent ones, which Python concatenates."""
    quote, inner = token[0], token[1:-1]
    size = max(1, width - 2)
    return [f"{quote}{inner[i : i + size]}{quote}" for i in range(0, len(inner), size)]
