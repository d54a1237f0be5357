"""How large exactspline is, room by room: ``python -m tests.support.count_lines [REVISION]``.

Lines are all lines of a file; lines of code are those that hold a token other than a comment or a docstring. Templates,
JavaScript, style sheets, C and tables of data in the package count as lines of code where they are not blank. Papers
and Coq's theory are counted apart.
"""

from __future__ import annotations

import ast
import io
import statistics
import subprocess
import sys
import tokenize
from collections import Counter, defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
OTHERS = (".js", ".css", ".html", ".c", ".json", ".toml", ".jinja", ".txt")
SILENT = {
    tokenize.COMMENT,
    tokenize.NL,
    tokenize.NEWLINE,
    tokenize.INDENT,
    tokenize.DEDENT,
    tokenize.ENCODING,
    tokenize.ENDMARKER,
}
#: What is counted apart from the rest.
APART = ("papers", "coq theory", "curves")
OWNERS = (ast.Module, ast.ClassDef, ast.FunctionDef)


def sources(revision: str = "") -> dict[str, str]:
    """The files of the package by path, as they are now or in a revision."""
    listing = ["git", "ls-files"] if not revision else ["git", "ls-tree", "-r", "--name-only", revision]
    names = subprocess.run([*listing, "exactspline"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    wanted = [name for name in names.split() if name.endswith((".py", ".v", *OTHERS))]
    if not revision:
        return {name: (ROOT / name).read_text(encoding="utf-8") for name in wanted}
    batch = "".join(f"{revision}:{name}\n" for name in wanted).encode()
    data = subprocess.run(["git", "cat-file", "--batch"], cwd=ROOT, input=batch, capture_output=True, check=True).stdout
    found, at = {}, 0
    for name in wanted:
        end = data.index(b"\n", at)
        size = int(data[at:end].split()[2])
        found[name] = data[end + 1 : end + 1 + size].decode()
        at = end + size + 2
    return found


def room(name: str) -> str:
    """The room of a file."""
    parts = name.split("/")
    if name.endswith(".v"):
        return "coq theory"
    if parts[-1].endswith(".json") and "curves" in parts[:-1] and "papers" not in parts:
        return "curves"
    return parts[1] if len(parts) > 2 else "front door and others"


def code_lines(text: str) -> int:
    """The lines of Python that hold code.

    >>> code_lines('\"\"\"What it is.\"\"\"\\nx = 1  # one\\n\\n# nothing\\ny = (2,\\n     3)\\n')
    3
    """
    prose: set[int] = set()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, OWNERS) and ast.get_docstring(node, clean=False) is not None:
            prose |= set(range(node.body[0].lineno, (node.body[0].end_lineno or 0) + 1))
    lines: set[int] = set()
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type not in SILENT:
            lines |= set(range(token.start[0], token.end[0] + 1))
    return len(lines - prose)


def main(revision: str = "") -> None:
    """Print the table."""
    files, lines, code, names = Counter[str](), Counter[str](), Counter[str](), Counter[str]()
    lengths: dict[str, list[int]] = defaultdict(list)
    longest, public, told, tried = 0, 0, 0, 0
    for path, text in sources(revision).items():
        where = room(path)
        files[where] += 1
        lines[where] += text.count("\n")
        if not path.endswith(".py"):
            code[where] += sum(bool(line.strip()) for line in text.splitlines())
            continue
        code[where] += code_lines(text)
        longest = max(longest, *map(len, text.splitlines()), 0)
        tree = ast.parse(text)
        for node in ast.walk(tree):
            if isinstance(node, ast.FunctionDef):
                lengths[where].append((node.end_lineno or 0) - node.lineno + 1)
        for node in tree.body:
            if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and not node.name.startswith("_"):
                names[where] += 1
                if where not in APART:
                    public += 1
                    docstring = ast.get_docstring(node) or ""
                    told, tried = told + bool(docstring), tried + (">>>" in (ast.get_source_segment(text, node) or ""))
    print(f"{'room':<22}{'files':>7}{'lines':>8}{'code':>8}{'names':>7}{'median function':>17}")
    for where in sorted(lines, key=lambda each: (each in APART, -lines[each])):
        median = statistics.median(lengths[where]) if lengths[where] else 0
        print(f"{where:<22}{files[where]:>7}{lines[where]:>8}{code[where]:>8}{names[where]:>7}{median:>17}")
    rooms = [where for where in lines if where not in APART]
    every = [length for where in rooms for length in lengths[where]]
    total = [sum(counted[where] for where in rooms) for counted in (files, lines, code, names)]
    print(f"{'without the last':<22}{total[0]:>7}{total[1]:>8}{total[2]:>8}{total[3]:>7}{statistics.median(every):>17}")
    print(f"longest line {longest}; functions over 60 lines: {sum(length > 60 for length in every)}")
    print(f"public classes and functions: {public}, with a docstring {told}, with a doctest {tried}")


if __name__ == "__main__":
    main(*sys.argv[1:])
