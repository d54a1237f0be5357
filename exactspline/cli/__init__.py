"""The command line. Exit status 0: everything as recorded; 1: a verdict differs from the record; 2: bad input."""

from __future__ import annotations

import gc
import sys
from collections.abc import Iterable
from importlib import import_module
from typing import TYPE_CHECKING, Annotated

import typer
from typer.core import TyperCommand

from exactspline.cli.output import guard_output
from exactspline.errors import ExactSplineError

if TYPE_CHECKING:
    from typer._click.core import Context, Parameter

    app: typer.Typer

#: This many new objects before Python looks for unused cycles among them: what a command makes mostly stays to its end.
YOUNG = 100_000
EXIT_STATUS = "Exit status: 0 success; 1 a verdict differs from the record; 2 bad input."
#: What exit status 1 of a command means; the other commands do not use it.
STATUS_1 = {
    "prove": "a verdict differs from the record, or an --identity does not hold",
    "show": "a verdict differs from the record",
    "degrees": "a degree differs from the printed one",
    "check_answer": "the answer is not right",
    "sweep": "a verdict differs from the record, or the program failed on a curve",
}
#: Further meanings of status 2.
STATUS_2 = {"sweep": "bad input, or a curve that cannot be read; 130 interrupted"}
#: Every command, by the name of its module and function: what it does in a few words, and examples of its use.
COMMANDS: dict[str, tuple[str, ...]] = {
    "prove": (
        "Decide every claim of a paper.",
        "prove",
        "prove --paper my-paper --report report.html",
        "prove --curve my.json",
        "prove --section 4.2 --verdict refuted",
    ),
    "show": ("Spell out one claim.", "show", 'show "eq. (12)"', "show C4.2 --latex"),
    "errata": ("List the errors of the paper.", "errata", "errata C4.2b"),
    "degrees": ("Degrees and control points.", "degrees --generic", "degrees evolute --curve my.json"),
    "new_paper": ("Begin a paper of your own.", "new-paper my-paper"),
    "reduce": ("Factor a formula, your own too.", "reduce rectifying_developable", "reduce my_formulas.py:pedal"),
    "derive": ("Evolutes, focal curves, … exactly.", "derive", "derive evolute my.json -o evolute.json"),
    "inspect": (
        "Features of curves, certified.",
        "inspect ellipse",
        "inspect my.json --digits 50",
        "inspect font.ttf:ampersand --plot glyph.svg",
    ),
    "oracle": (
        "Exact answers for kernels that compute in doubles.",
        "oracle circle --ask value@1/3 --ask length",
        "oracle drawing.svg --ask inflections --ask bounding_box --json",
        "oracle --list",
    ),
    "bisector": (
        "Bisectors of curves and points.",
        "bisector ellipse --point 1,1/2",
        "bisector twisted_cubic helix_like -o surface.json",
    ),
    "triangle": (
        "De Boor, step by step, in fractions.",
        "triangle cubic_s --at 1/3",
        "triangle my.json --insert 1/2 --times 2 --html > insertion.html",
        "triangle parabola --elevate 1 --product x,y --latex",
    ),
    "exercise": (
        "Exercises with small answers.",
        "exercise",
        "exercise evaluation --seed 1 --count 6 --solutions",
        "exercise all --html --solutions > sheet.html",
    ),
    "check_answer": (
        "Is a student's answer right?",
        "check-answer --topic evaluation --seed 0 --text '1, -1'",
        "check-answer my.json --reference cubic_s",
        "check-answer mine.py:kappa --reference f2 --factor w",
    ),
    "conditioning": ("Condition numbers of zeros.", "conditioning", "conditioning my.json"),
    "figures": ("Draw the figures of the paper.", "figures --out pictures", "figures --out pictures --figure 2"),
    "curves": ("List the example curves.", "curves", "curves --json"),
    "sweep": (
        "Many curves, one line each.",
        "sweep fonts/ drawings/*.dxf -o lines.jsonl --jobs 2",
        "sweep --random degree=2-5 count=1000 seed=1 --find inflections",
        "sweep curves/ --claim C4.1 -o verdicts.parquet",
    ),
    "convert": (
        "Convert files of curves.",
        "convert drawing.dxf curves.json",
        "convert font.ttf:ampersand ampersand.json",
    ),
    "glossary": ("Explain words and signs.", "glossary", "glossary nominal"),
    "schema": ("The JSON Schema of a command.", "schema", "schema prove"),
}


class Command(TyperCommand):
    """A command whose help names its arguments in capitals, without the types of Python."""

    def get_params(self, ctx: Context) -> list[Parameter]:
        """The parameters, arguments under names in capitals."""
        found = super().get_params(ctx)
        for parameter in found:
            if parameter.param_type_name == "argument":
                parameter.metavar = parameter.metavar or str(parameter.name).upper()
                vars(parameter)["display_type_rich"] = lambda ctx: None
        return found


def _epilog(name: str, examples: list[str]) -> str:
    """Examples a line each: click keeps the lines of a paragraph that begins with a backspace."""
    lines = "\n".join(f"  exactspline {example}" for example in examples)
    one = f" 1 {STATUS_1[name]};" if name in STATUS_1 else ""
    return f"\b\nExamples:\n{lines}\n\nExit status: 0 success;{one} 2 {STATUS_2.get(name, 'bad input')}."


def _version(wanted: bool) -> None:
    if wanted:
        from importlib.metadata import version

        sys.stdout.write(f"exactspline {version('exactspline')}\n")
        raise typer.Exit


def options(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Show the version and exit.")
    ] = False,
) -> None:
    """B-splines and NURBS in exact rational arithmetic: identities proved or refuted, never 'up to 1e-9'."""


def app_of(names: Iterable[str]) -> typer.Typer:
    """The command line with some of the commands: their modules alone are imported."""
    made = typer.Typer(
        help="B-splines and NURBS in exact rational arithmetic: identities proved or refuted, never 'up to 1e-9'.",
        epilog="\b\nBegin with:\n  exactspline prove\n  exactspline errata\n  exactspline inspect ellipse\n\n"
        + EXIT_STATUS,
        no_args_is_help=True,
        pretty_exceptions_enable=False,
        rich_markup_mode=None,
    )
    made.callback()(options)
    for name in names:
        short, *examples = COMMANDS[name]
        command = getattr(import_module(f"exactspline.cli.{name}"), name)
        made.command(short_help=short, epilog=_epilog(name, examples), cls=Command)(command)
    return made


def _asked() -> Iterable[str]:
    """The command of which the command line speaks; all of them where it names none."""
    name = sys.argv[1] if len(sys.argv) > 1 else ""
    return [each for each in COMMANDS if each.replace("_", "-") == name] or COMMANDS


if not TYPE_CHECKING:

    def __getattr__(name):
        """The command line with all its commands, made when it is first asked for."""
        if name != "app":
            raise AttributeError(f"module 'exactspline.cli' has no attribute {name!r}")
        found = globals()["app"] = app_of(COMMANDS)
        return found


def main() -> None:
    """Entry point: bad input ends in one line on standard error and exit status 2."""
    gc.set_threshold(YOUNG)
    guard_output()
    try:
        try:
            app_of(_asked())(prog_name="exactspline")
        finally:
            gc.freeze()  # the process ends: looking through a million objects for circles would only delay it
            sys.stdout.flush()
    except ExactSplineError as error:
        from exactspline.display.console import show_error

        show_error(error)
        sys.exit(2)
    except OSError as error:
        # what could not be written must not be tried again when Python closes its files
        sys.stdout = None  # Python itself sets it so where there is none
        sys.stderr.write(f"error: the output cannot be written ({error.strerror})\n")
        sys.exit(2)
