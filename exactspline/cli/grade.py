"""``grade``: other people's libraries compared with exact answers."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from exactspline.cli.output import OptionsError, Output, is_quiet, printing

if TYPE_CHECKING:
    from exactspline.display.sheet import Sheet


@printing
def grade(
    out: Output,
    library: Annotated[
        list[str] | None, typer.Argument(metavar="LIBRARY", help="Libraries by name; all that are installed if none.")
    ] = None,
    cases: Annotated[
        int, typer.Option("--cases", metavar="N", min=0, help="The first N cases of each family; 0 for all.")
    ] = 0,
    cache: Annotated[
        str, typer.Option("--cache", metavar="FILE", help="Keep exact answers with certificates (.jsonl.gz).")
    ] = "",
    page: Annotated[str, typer.Option("--page", metavar="FILE", help="Write the scoreboard in Markdown.")] = "",
    examples: Annotated[
        bool, typer.Option("--examples/--no-examples", help="Search for the smallest example of each defect.")
    ] = True,
) -> None:
    """Grade libraries that compute with splines in doubles: right, off, missed, invented, crashed."""
    from exactspline.batch.grade.adapters import LIBRARIES
    from exactspline.batch.grade.cases import all_cases
    from exactspline.batch.grade.report import page as page_of
    from exactspline.batch.grade.report import rows, wrong
    from exactspline.batch.grade.runner import grade as graded
    from exactspline.batch.grade.shrink import defects_of

    names = _known(library or list(LIBRARIES), LIBRARIES)
    chosen = list(all_cases(cases or None))
    with _ticking(len(chosen)) as tick:
        reports, truths = graded(names, chosen, Path(cache) if cache else None, tick)
    if not reports:
        raise OptionsError("none of these libraries is installed", remedy="pip install scipy, for example")
    defects = [d for report in reports for d in (defects_of(report.library, wrong(report)) if examples else [])]
    if page:
        from exactspline.atomic_write import write_atomically

        written = page_of(reports, defects, chosen, truths.uncertified)
        write_atomically(page, lambda stream: stream.write(written.encode()))
    found = rows(reports, defects)
    out.give("grade", lambda: found, lambda: [_sheet(found)])


def _known(names: list[str], libraries: dict[str, str]) -> list[str]:
    from exactspline.errors import nearest

    for name in names:
        if name not in libraries:
            raise OptionsError(
                f"there is no library called {name!r}", remedy=nearest(name, libraries, listed_by="grade")
            )
    return names


def _sheet(found: list[dict[str, Any]]) -> Sheet:
    from exactspline.batch.grade.judge import OUTCOMES
    from exactspline.display.sheet import Sheet

    numbers = ("asked", *OUTCOMES)
    made = Sheet(
        "library", "version", "question", *numbers, "smallest example", numbers=numbers, prose=["smallest example"]
    )
    for row in found:
        example = row["example"]
        shown = "" if example is None else f"{example['note']}: {_points(example)}"
        made.add_row(row["library"], row["version"], row["question"], *(row[name] for name in numbers), shown)
    return made


def _points(example: dict[str, Any]) -> str:
    points = " ".join(f"({', '.join(p)})" for p in example["control_points"])
    return f"{points} at {example['parameter']}"


def _ticking(count: int) -> Any:
    """A progress bar on a terminal."""
    import sys
    from contextlib import contextmanager

    from rich.console import Console
    from rich.progress import Progress

    @contextmanager
    def bar() -> Any:
        console = Console(stderr=True)
        with Progress(console=console, transient=True, disable=is_quiet() or not sys.stderr.isatty()) as progress:
            task = progress.add_task("grading", total=count)
            yield lambda: progress.advance(task)

    return bar()
