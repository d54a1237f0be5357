"""How large exactspline is, room by room: ``python -m tests.support.count_lines [REVISION]``; with ``--check`` the exit
status is 1 where it has more lines of statements than `CEILING` allows.

*Statements* are the lines that hold code other than comments, docstrings, imports and signatures (with what decorates
them); of templates, JavaScript, style sheets, C and tables of data there are none. *Imports* are the lines of imports;
*once* are the functions whose name occurs once in the package besides their definition; *alone* are the public names
at the top of a file that no other file of the package names. Papers, Coq's theory and example curves are counted apart.
"""

from __future__ import annotations

import ast
import io
import re
import subprocess
import sys
import tokenize
import tomllib
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
#: The one running ceiling of statements, and what raised and lowered it.
CEILING = ROOT / "tests" / "support" / "ceiling.toml"
OTHERS = (".js", ".css", ".html", ".c", ".json", ".toml", ".jinja", ".txt")
LAYOUT = {"COMMENT", "NL", "NEWLINE", "INDENT", "DEDENT", "ENCODING", "ENDMARKER"}
#: What is counted apart from the rest.
APART = ("papers", "coq theory", "curves")
#: Rooms of rooms: each of their folders has a row of its own.
DIVIDED = ("geometry", "extras")
OWNERS = (ast.Module, ast.ClassDef, ast.FunctionDef)
COLUMNS = ("files", "lines", "statements", "imports", "names", "alone", "once")


def sources(revision: str = "") -> dict[str, str]:
    """The files of the package by path, as they are now or in a revision."""
    listing = ["git", "ls-files"] if not revision else ["git", "ls-tree", "-r", "--name-only", revision]
    names = subprocess.run([*listing, "exactspline"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    wanted = [name for name in names.split() if name.endswith((".py", ".v", *OTHERS))]
    if not revision:
        return {name: (ROOT / name).read_text(encoding="utf-8") for name in wanted if (ROOT / name).exists()}
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
    """The room of a file.

    >>> room("exactspline/roots/root.py"), room("exactspline/geometry/pairs/nearest.py")
    ('roots', 'geometry/pairs')
    """
    parts = name.split("/")
    if name.endswith(".v"):
        return "coq theory"
    if parts[-1].endswith(".json") and "curves" in parts[:-1] and "papers" not in parts:
        return "curves"
    if len(parts) > 3 and parts[1] in DIVIDED:
        return "/".join(parts[1:3])
    return parts[1] if len(parts) > 2 else "front door and others"


def lines_of(node: ast.stmt | ast.expr) -> set[int]:
    """The numbers of the lines of a node."""
    return set(range(node.lineno, (node.end_lineno or node.lineno) + 1))


def statements_and_imports(text: str) -> tuple[int, int]:
    """The lines of statements of a file, and those of its imports.

    >>> statements_and_imports('\"\"\"Why.\"\"\"\\nimport ast\\n\\ndef f(\\n    a,\\n): # one\\n    return (1,\\n2)\\n')
    (2, 1)
    """
    beside: set[int] = set()
    imports: set[int] = set()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, OWNERS) and ast.get_docstring(node, clean=False) is not None:
            beside |= lines_of(node.body[0])
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            imports |= lines_of(node)
        elif isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            beside |= set(range(node.lineno, max(node.body[0].lineno, node.lineno + 1)))
            beside |= {line for mark in node.decorator_list for line in lines_of(mark)}
    code: set[int] = set()
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if tokenize.tok_name[token.type] not in LAYOUT:
            code |= set(range(token.start[0], token.end[0] + 1))
    return len(code - beside - imports), len(code & imports)


def counted(files: dict[str, str]) -> dict[str, Counter[str]]:
    """The numbers of every room."""
    words = {path: Counter(re.findall(r"\w+", text)) for path, text in files.items()}
    everywhere = sum(words.values(), Counter[str]())
    holders = Counter(word for own in words.values() for word in own)
    found: dict[str, Counter[str]] = {}
    for path, text in files.items():
        own = found.setdefault(room(path), Counter())
        own.update(files=1, lines=text.count("\n"))
        if not path.endswith(".py"):
            continue
        statements, imports = statements_and_imports(text)
        own.update(statements=statements, imports=imports)
        tree = ast.parse(text)
        top = [each for each in tree.body if isinstance(each, (ast.FunctionDef, ast.ClassDef)) and each.name[0] != "_"]
        own.update(names=len(top), alone=sum(holders[each.name] == 1 for each in top))
        functions = [each.name for each in ast.walk(tree) if isinstance(each, ast.FunctionDef)]
        own.update(once=sum(everywhere[name] == 2 for name in functions))
    return found


def ceiling() -> int:
    """The lines of statements that the package may have."""
    return sum(each["lines"] for each in tomllib.loads(CEILING.read_text(encoding="utf-8"))["change"])


def total(rooms: dict[str, Counter[str]]) -> Counter[str]:
    """The numbers of all rooms but those that are counted apart."""
    return sum((own for where, own in rooms.items() if where not in APART), Counter[str]())


def main(*arguments: str) -> int:
    """Print the table, and say whether there are too many lines of statements."""
    rooms = counted(sources(*[each for each in arguments if each != "--check"]))
    order = sorted(rooms, key=lambda where: (where in APART, -rooms[where]["statements"]))
    print(f"{'room':<24}" + "".join(f"{name:>11}" for name in COLUMNS))
    for where, own in [*((each, rooms[each]) for each in order), ("without the last", total(rooms))]:
        print(f"{where:<24}" + "".join(f"{own[name]:>11}" for name in COLUMNS))
    too_many = total(rooms)["statements"] - ceiling()
    print(f"ceiling: {ceiling()} lines of statements, {'exceeded by' if too_many > 0 else 'left:'} {abs(too_many)}")
    return int("--check" in arguments and too_many > 0)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
