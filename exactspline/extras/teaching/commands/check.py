"""``teach check``: a student's answer, proved right, or shown where it differs."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from exactspline.cli.common import Trust, load_curve
from exactspline.cli.output import OptionsError, Output, printing
from exactspline.cli.parameters import Argument, Exit, Option
from exactspline.display.sheet import Sheet
from exactspline.errors import CurveFileError

if TYPE_CHECKING:
    from exactspline.extras.teaching.answers import Finding


@printing
def check(
    out: Output,
    answer: Annotated[
        str, Argument(help="A file with the answer, - for standard input, or FILE.py:NAME for a formula.")
    ] = "",
    topic: Annotated[str, Option("--topic", metavar="TOPIC", help="The exercise's topic.")] = "",
    seed: Annotated[int, Option("--seed", metavar="N", min=0, help="The exercise's seed.")] = 0,
    text: Annotated[str, Option("--text", metavar="ANSWER", help="The answer itself, in place of a file.")] = "",
    reference: Annotated[
        str, Option("--reference", metavar="WHAT", help="A curve, or a formula where the answer is a formula.")
    ] = "",
    factor: Annotated[
        str, Option("--factor", metavar="F", help="A formula may be that factor times the reference: w^3.")
    ] = "1",
    hint: Annotated[bool, Option("--hint", help="Where it is wrong, say how to begin.")] = False,
    show: Annotated[bool, Option("--show", help="Where it is wrong, show the right values and the solution.")] = False,
    trust: Trust = False,
) -> None:
    """Prove an answer right, or say where it is wrong, without the right values unless they are asked for; exit status
    1 where it is wrong.
    """
    if bool(topic) == bool(reference):
        raise OptionsError("one of --topic and --reference is needed", remedy="say what the answer is compared with")
    if bool(text) == bool(answer) or (text and reference):
        raise OptionsError("one answer is needed", remedy="name a file, or write --topic TOPIC --text ANSWER")
    if hint and reference:
        raise OptionsError("--hint and --reference", remedy="there are hints for exercises")
    found, against = (
        _exercise(topic, seed, text or _read(answer)) if topic else _compared(answer, reference, factor, trust)
    )
    row = {"key": against, "right": found.right, "differences": list(map(str, found.differences))}

    cells = [("right" if found.right else "wrong", each) for each in found.differences or [""]]
    out.give(
        "check-answer",
        [row],
        [Sheet("answer", "difference", rows=cells, prose=["difference"])],
        lambda: _tell(out, found, topic, seed, hint, show),
    )
    if not found:
        raise Exit(1)


def _tell(out: Output, found: Finding, topic: str, seed: int, hint: bool, show: bool) -> None:
    from exactspline.display import console
    from exactspline.extras.teaching.display.exercises import hinted, solution_lines

    shown = console.console()
    console.lines(shown, "right" if found else "wrong", style="bold")
    for difference in dict.fromkeys(map(str if show else hinted, found.differences)):
        console.lines(shown, difference, indent=4, first=2)
    if found or out.quiet:
        return
    from exactspline.extras.teaching.topics import HINTS, exercise

    if hint:
        console.lines(shown, f"hint: {HINTS[topic]}")
    if show and topic:
        sys.stdout.write("\n".join(solution_lines(exercise(topic, seed), min(console.width(), 80))) + "\n")
    if not (hint or show):
        console.lines(shown, f"{'--hint says how to begin, ' if topic else ''}--show shows the right values")


def _exercise(topic: str, seed: int, given: str) -> tuple[Finding, str]:
    from exactspline.extras.teaching.topics import exercise

    made = exercise(topic, seed)
    return made.answer.check(given), f"{topic}, seed {seed}"


def _read(name: str) -> str:
    from exactspline.extras.teaching.reading import MAX_TEXT

    try:
        if name == "-":
            data = sys.stdin.buffer.read(4 * MAX_TEXT)
        else:
            with Path(name).open("rb") as stream:
                data = stream.read(4 * MAX_TEXT)
        return data.decode()
    except OSError as error:
        raise CurveFileError(
            f"cannot be read ({error.strerror})", where=name, remedy="name a file, or write --text ANSWER"
        ) from None
    except UnicodeDecodeError:
        raise CurveFileError("is not UTF-8 text", where=name, remedy="write numbers, points or polynomials") from None


def _compared(answer: str, reference: str, factor: str, trust: bool) -> tuple[Finding, str]:
    from exactspline.extras.teaching.comparison import compare_curves, compare_formulas
    from exactspline.papers import resolve

    if re.search(r"\.py:\w+$", answer):
        found = compare_formulas(resolve(answer, trust=trust), resolve(reference, trust=trust), factor)
    else:
        found = compare_curves(load_curve(answer), load_curve(reference))
    return found, reference
