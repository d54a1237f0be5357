"""For teachers: ``teach triangle``, ``teach exercise``, ``teach check``."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from exactspline.cli.common import load_curve
from exactspline.cli.output import Exit, OptionsError, Output, printing
from exactspline.display.sheet import Sheet
from exactspline.errors import CurveFileError

if TYPE_CHECKING:
    from exactspline.extras.teaching.answers import Finding
    from exactspline.extras.teaching.display.exercises import Scheme
    from exactspline.splines.bspline import BSpline
    from exactspline.splines.nurbs import Nurbs


# ---- triangle


@printing
def triangle(
    out: Output,
    curve: str,
    at: list[str] | None = None,
    insert: list[str] | None = None,
    times: int = 1,
    elevate: int = 0,
    product: str = "",
    latex: bool = False,
    html: bool = False,
) -> None:
    """Print the triangle of fractions of de Boor's algorithm, of knot insertion or of degree elevation, or the table of
    a product of two functions.
    """
    from exactspline.display import console
    from exactspline.extras.teaching.display.exercises import latex_text, scheme_data, schemes_page, sheets

    if latex + html + (not out.for_people) > 1:
        raise OptionsError("more than one format", remedy="choose one of --latex, --html, --json, --csv, --markdown")
    found = _schemes(load_curve(curve), at or [], insert or [], times, elevate, product)
    if latex:
        sys.stdout.write(latex_text(found) + "\n")
    elif html:
        sys.stdout.write(schemes_page(found, f"{curve}, step by step"))
    else:
        made = [x for s in found for x in sheets(s)]  # each says how its entries are computed: there is no legend
        out.give("triangle", map(scheme_data, found), made, lambda: console.below_each_other(console.console(), made))


def _schemes(curve: Nurbs, at: list[str], insert: list[str], times: int, elevate: int, product: str) -> list[Scheme]:
    from exactspline.extras.teaching.triangles import (
        de_boor_triangle,
        elevation_triangles,
        insertion_triangle,
        product_tables,
    )

    found: list[Scheme] = [de_boor_triangle(curve, t) for t in dict.fromkeys(at)]
    found += [insertion_triangle(curve, t, times) for t in dict.fromkeys(insert)]
    found += elevation_triangles(curve, elevate) if elevate else []
    found += product_tables(*_factors(curve, product)) if product else []
    if not found:
        raise OptionsError("nothing is asked", remedy="add --at T, --insert T, --elevate N or --product X,Y")
    return found


def _factors(curve: Nurbs, names: str) -> tuple[BSpline, BSpline]:
    """The two functions that the names mean; for a rational curve x and y are the numerators ``w x``, ``w y``."""
    known = dict(zip("xyz", curve.p, strict=False)) | {"w": curve.w}
    requested = [name.strip() for name in names.split(",")]
    if len(requested) != 2 or any(name not in known for name in requested):
        raise OptionsError(f"{names!r} does not name two functions", remedy=f"write two of {', '.join(known)}: x,y")
    return known[requested[0]], known[requested[1]]


# ---- exercise


@printing
def exercise(
    out: Output,
    topic: list[str] | None = None,
    seed: int = 0,
    count: int = 1,
    solutions: bool = False,
    latex: bool = False,
    html: bool = False,
) -> None:
    """Print exercises with small numbers, the same exercises for the same seed. `teach check` checks your answers."""
    from exactspline.extras.teaching.display.exercises import exercise_data, html_page, latex_document
    from exactspline.extras.teaching.topics import TOPICS, about, exercises

    if latex + html + (not out.for_people) > 1:
        raise OptionsError("more than one format", remedy="choose one of --latex, --html, --json, --csv, --markdown")
    if not topic:
        topics = [(name, about(name)) for name in TOPICS]
        rows = [{"key": name, "about": asks} for name, asks in topics]
        out.give("topics", rows, [Sheet("topic", "asks", rows=topics, prose=["asks"])])
        return
    made = [each for name in (TOPICS if topic == ["all"] else topic) for each in exercises(name, seed, count)]
    if latex or html:
        sys.stdout.write((latex_document if latex else html_page)(made, solutions=solutions))
        return

    data = [exercise_data(each, solutions=solutions) for each in made]
    columns = [name for name in data[0] if name != "key"]
    cells = [[row[name] for name in columns] for row in data]

    def people() -> None:
        from exactspline.display import console
        from exactspline.errors import command_name
        from exactspline.extras.teaching.display.exercises import text_lines

        # lines are also limited in a pipe
        width = min(console.width(), 80)
        sys.stdout.write("\n".join(text_lines(made, width, solutions=solutions)) + "\n")
        if not (solutions or out.quiet):
            first = made[0]
            command = f"{command_name()} teach check --topic {first.topic} --seed {first.seed} --text '…'"
            sys.stdout.write("\n")
            console.lines(console.console(), f"Check an answer: {command}")

    out.give("exercise", data, [Sheet(*columns, rows=cells, prose=["task", "form", "solution"])], people)


# ---- check


@printing
def check(
    out: Output,
    answer: str = "",
    topic: str = "",
    seed: int = 0,
    text: str = "",
    reference: str = "",
    factor: str = "1",
    hint: bool = False,
    show: bool = False,
    trust: bool = False,
) -> None:
    """Prove an answer right, or say where the answer is wrong; the right values are shown only with --show. The exit
    status is 1 for a wrong answer.
    """
    if bool(topic) == bool(reference):
        raise OptionsError("one of --topic and --reference is needed", remedy="say what the answer is compared with")
    if bool(text) == bool(answer) or (text and reference):
        raise OptionsError("one answer is needed", remedy="name a file, or write --topic TOPIC --text ANSWER")
    if hint and reference:
        raise OptionsError("--hint and --reference", remedy="omit one of them: only exercises have hints")
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
    from exactspline.extras.teaching.answers import MAX_TEXT

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
    from exactspline.extras.teaching.answers import compare_curves, compare_formulas
    from exactspline.papers import resolve

    if re.search(r"\.py:\w+$", answer):
        found = compare_formulas(resolve(answer, trust=trust), resolve(reference, trust=trust), factor)
    else:
        found = compare_curves(load_curve(answer), load_curve(reference))
    return found, reference
