"""``teach exercise``: sheets of exercises with small answers, and their solutions."""

from __future__ import annotations

import sys
from typing import Annotated

from exactspline.cli.output import OptionsError, Output, printing
from exactspline.cli.parameters import Argument, Option
from exactspline.display.sheet import Sheet


@printing
def exercise(
    out: Output,
    topic: Annotated[
        list[str] | None, Argument(help="Topics, or all; without them the topics are listed.", metavar="TOPIC")
    ] = None,
    seed: Annotated[int, Option("--seed", metavar="N", min=0, help="The first exercise's number.")] = 0,
    count: Annotated[int, Option("--count", metavar="K", min=1, max=500, help="This many exercises per topic.")] = 1,
    solutions: Annotated[bool, Option("--solutions", help="With a sheet of solutions.")] = False,
    latex: Annotated[bool, Option("--latex", help="Print a LaTeX document.")] = False,
    html: Annotated[bool, Option("--html", help="Print an HTML page, for a browser or a printer.")] = False,
) -> None:
    """Exercises with small numbers, the same ones for the same seed; the answers are computed, and checked by
    teach check.
    """
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

        # these are paragraphs in a pipe, too
        width = min(console.width(), 80)
        sys.stdout.write("\n".join(text_lines(made, width, solutions=solutions)) + "\n")
        if not (solutions or out.quiet):
            first = made[0]
            command = f"{command_name()} teach check --topic {first.topic} --seed {first.seed} --text '…'"
            sys.stdout.write("\n")
            console.lines(console.console(), f"Check an answer: {command}")

    out.give("exercise", data, [Sheet(*columns, rows=cells, prose=["task", "form", "solution"])], people)
