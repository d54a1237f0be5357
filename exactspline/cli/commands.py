"""Every command: its module, a short description, examples, and the meaning of its exit status."""

from __future__ import annotations

from dataclasses import dataclass, field


@dataclass(frozen=True)
class Entry:
    """A command (``module:function`` of exactspline), or a group of commands."""

    short: str
    examples: tuple[str, ...]
    home: str = ""
    status_1: str = ""
    status_2: str = "bad input"
    commands: dict[str, Entry] = field(default_factory=dict)


DIFFERS = "a verdict differs from the record"

FORMULA = {
    "degrees": Entry(
        "Print degrees and numbers of control points.",
        ("formula degrees --generic", "formula degrees --at 3", "formula degrees evolute --curve my.json"),
        "cli.formula:degrees",
        "a degree differs from the printed one",
    ),
    "reduce": Entry(
        "Factor a formula, also your own.",
        ("formula reduce rectifying_developable", "formula reduce my_formulas.py:pedal"),
        "cli.formula:reduce",
    ),
    "conditioning": Entry(
        "Print condition numbers of the zeros of variants.",
        ("formula conditioning", "formula conditioning my.json"),
        "cli.formula:conditioning",
    ),
}
PAPER = {
    "new": Entry("Begin a paper of your own.", ("paper new my-paper",), "cli.paper:new"),
    "figures": Entry(
        "Draw the figures of the paper.",
        ("paper figures --out pictures", "paper figures --out pictures --figure 2"),
        "cli.paper:figures",
    ),
}
TEACH = {
    "triangle": Entry(
        "Print de Boor's algorithm, step by step.",
        (
            "teach triangle cubic_s --at 1/3",
            "teach triangle my.json --insert 1/2 --times 2 --html > page.html",
            "teach triangle parabola --elevate 1 --product x,y --latex",
        ),
        "extras.teaching.commands:triangle",
    ),
    "exercise": Entry(
        "Print exercises with small answers.",
        (
            "teach exercise",
            "teach exercise evaluation --seed 1 --count 6 --solutions",
            "teach exercise all --html --solutions > sheet.html",
        ),
        "extras.teaching.commands:exercise",
    ),
    "check": Entry(
        "Check a student's answer.",
        (
            "teach check --topic evaluation --seed 0 --text '1, -1'",
            "teach check my.json --reference cubic_s",
            "teach check mine.py:kappa --reference f2 --factor w",
        ),
        "extras.teaching.commands:check",
        "the answer is not right",
    ),
}
LIST = {
    "curves": Entry("List the example curves.", ("list curves", "list curves --json"), "cli.list:curves"),
    "surfaces": Entry("List the example surfaces.", ("list surfaces",), "cli.list:surfaces"),
    "formulas": Entry("List constructions and formulas.", ("list formulas",), "cli.list:formulas"),
    "papers": Entry("List the papers that are included.", ("list papers",), "cli.list:papers"),
    "questions": Entry("List questions about curves, surfaces, pairs.", ("list questions",), "cli.list:questions"),
    "words": Entry("Explain words and signs.", ("list words", "list words nominal"), "cli.list:words"),
}
COMMANDS = {
    "prove": Entry(
        "Decide every claim of a paper.",
        (
            "prove",
            "prove --paper my-paper --report report.html",
            "prove --curve my.json",
            "prove --section 4.2 --verdict refuted",
        ),
        "cli.prove:prove",
        DIFFERS,
    ),
    "show": Entry("Spell out one claim.", ("show", 'show "eq. (12)"', "show C4.2 --latex"), "cli.show:show", DIFFERS),
    "errata": Entry("List the errors of the paper.", ("errata", "errata C4.2b"), "cli.show:errata"),
    "identity": Entry(
        "Decide one identity.",
        ('identity "f1 = w * f2"', 'identity "file.py:left = w^3 * file.py:right"'),
        "cli.formula:identity",
        "the identity does not hold",
    ),
    "inspect": Entry(
        "Find certified features of curves and surfaces.",
        (
            "inspect ellipse",
            "inspect my.json --digits 50",
            "inspect font.ttf:ampersand --plot glyph.svg",
            "inspect circle --ask value@1/3 --ask length",
        ),
        "cli.inspect:inspect",
    ),
    "derive": Entry(
        "Compute evolutes, focal curves, … exactly.",
        ("derive evolute my.json -o evolute.json", "derive f2 cubic_s"),
        "cli.derive:derive",
    ),
    "between": Entry(
        "Find where two curves meet, or are nearest.",
        ("between circle ellipse", "between a.json b.svg --plot both.svg", "between a.json b.json --json"),
        "cli.between:between",
    ),
    "bisector": Entry(
        "Compute bisectors of curves and points.",
        (
            "bisector ellipse --point 1,1/2",
            "bisector cubic_s parabola --plot bisector.svg",
            "bisector twisted_cubic helix_like -o surface.json",
        ),
        "cli.bisector:bisector",
    ),
    "formula": Entry(
        "Compute properties of a formula.", ("formula reduce f0", "formula degrees evolute"), commands=FORMULA
    ),
    "sweep": Entry(
        "Inspect many curves, one line each.",
        (
            "sweep fonts/ drawings/*.dxf -o lines.jsonl --jobs 2",
            "sweep --random degree=2-5 count=1000 seed=1 --find inflections",
            "sweep curves/ --claim C4.1 -o verdicts.parquet",
        ),
        "cli.sweep:sweep",
        f"{DIFFERS}, or the program failed on a curve",
        "bad input, or a curve that cannot be read; 130 interrupted",
    ),
    "convert": Entry(
        "Convert files of curves.",
        ("convert drawing.dxf curves.json", "convert font.ttf:ampersand ampersand.json"),
        "cli.convert:convert",
    ),
    "paper": Entry("Begin a paper of your own; draw figures.", ("paper new my-paper",), commands=PAPER),
    "coq": Entry(
        "Write theorems for the proof assistant Coq.",
        ("coq theorems", "coq theorems --claim C4.1"),
        "extras.coq.command:coq",
    ),
    "teach": Entry(
        "Print triangles and exercises; check answers.", ("teach triangle cubic_s --at 1/3",), commands=TEACH
    ),
    "list": Entry("List curves, surfaces, formulas, papers, words.", ("list curves",), commands=LIST),
    "schema": Entry("Print the JSON Schema of a command.", ("schema", "schema prove"), "cli.schema:schema"),
}
#: Words that users try as commands, and the commands that they mean.
ELSEWHERE = {"intersections": "between", "distance": "between", "nearest": "between", "features": "inspect"}


def leaves(commands: dict[str, Entry] = COMMANDS, above: str = "") -> dict[str, Entry]:
    """Every command, without the groups of commands, by the words that call it.

    >>> [name for name in leaves() if name.startswith("teach")]
    ['teach triangle', 'teach exercise', 'teach check']
    """
    found: dict[str, Entry] = {}
    for name, entry in commands.items():
        found |= leaves(entry.commands, f"{above}{name} ") if entry.commands else {f"{above}{name}": entry}
    return found
