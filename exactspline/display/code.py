"""Python code in short lines that can still be pasted: broken only between two tokens."""

from __future__ import annotations

import tokenize
from io import StringIO

from rich.cells import cell_len

#: The indent of a continued line.
INDENT = "    "


def code_lines(line: str, width: int) -> list[str]:
    """A statement broken into lines of at most that width where its tokens allow it.

    >>> for part in code_lines('print(max([3141592653, 2718281828, 1618033988]))', 30):
    ...     print(part)
    print(max([3141592653,
        2718281828, 1618033988]))
    >>> code_lines("from exactspline.papers import find", 30)
    ['from exactspline.papers \\\\', '    import find']
    """
    if cell_len(line) <= width:
        return [line]
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
