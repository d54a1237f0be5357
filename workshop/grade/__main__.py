"""``./run grade``: libraries that compute with splines in doubles, compared with exact answers.

Every answer is classified as right, wrong value, missed, invented, crashed, declined, timed out or tolerated. Exit
status: 0 graded; 2 bad input.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from exactspline.atomic_write import write_text
from exactspline.display.sheet import Sheet
from exactspline.errors import FormulaError, nearest
from exactspline.testing import all_cases
from workshop.grade.adapters import LIBRARIES
from workshop.grade.judge import OUTCOMES
from workshop.grade.report import PICTURE, draw, page, placed, rows, wrong
from workshop.grade.runner import failures, grade, sample
from workshop.grade.shrink import defects_of
from workshop.printing import add_formats, ended, on_a_terminal, show


def arguments(given: Sequence[str] | None) -> argparse.Namespace:
    """The parsed command line."""
    parser = argparse.ArgumentParser(
        prog="./run grade", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "library", nargs="*", metavar="LIBRARY", help=f"{', '.join(LIBRARIES)}; all installed ones if none is named"
    )
    parser.add_argument("--cases", metavar="N", type=int, default=0, help="the first N cases of each family; 0 for all")
    parser.add_argument(
        "--share",
        metavar="X",
        type=float,
        default=1.0,
        help="a part of them, the same at each run: each case with this probability; those of bug reports always",
    )
    parser.add_argument("--cache", metavar="FILE", type=Path, help="keep exact answers with certificates (.jsonl.gz)")
    parser.add_argument(
        "--page",
        metavar="FILE",
        default="",
        help="write the results in Markdown, and their picture; in a page with marks for them, between these",
    )
    parser.add_argument(
        "--failures",
        metavar="FILE",
        default="",
        help="write every wrong answer with what the library was given and the certified answer (JSON Lines)",
    )
    parser.add_argument(
        "--examples",
        action=argparse.BooleanOptionalAction,
        default=True,
        help="search for the smallest example of each defect",
    )
    add_formats(parser)
    return parser.parse_args(given)


def main(given: Sequence[str] | None = None) -> int:
    """Grade, print and write the page; returns the exit status."""
    options = arguments(given)
    for name in options.library:
        if name not in LIBRARIES:
            raise FormulaError(f"there is no library called {name!r}", remedy=nearest(name, LIBRARIES))
    chosen = list(sample(all_cases(options.cases or None), options.share))
    with _ticking(len(chosen), options.quiet) as tick:
        reports, truths = grade(options.library or LIBRARIES, chosen, options.cache, tick)
    if not reports:
        raise FormulaError("none of these libraries is installed", remedy="pip install scipy, for example")
    defects = [d for report in reports if options.examples for d in defects_of(report.library, wrong(report))]
    if options.page:
        share = f" --share {options.share:g}" if options.share < 1 else ""
        written = page(reports, defects, chosen, truths.uncertified, share)
        write_text(options.page, placed(Path(options.page), written))
        draw(reports, str(Path(options.page).parent / PICTURE))
    if options.failures:
        lines = [json.dumps(each, ensure_ascii=False) + "\n" for each in failures(reports)]
        write_text(options.failures, "".join(lines))
    data = rows(reports, defects)
    show(options.format, "grade", data, _sheet(data))
    return 0


def _sheet(data: list[dict[str, Any]]) -> Sheet:
    numbers = ("asked", *OUTCOMES)
    made = Sheet(
        "library", "version", "question", *numbers, "smallest example", numbers=numbers, prose=["smallest example"]
    )
    for row in data:
        example = row["example"]
        shown = "" if example is None else f"{example['note']}: {_points(example)}"
        made.add_row(row["library"], row["version"], row["question"], *(row[name] for name in numbers), shown)
    return made


def _points(example: dict[str, Any]) -> str:
    points = " ".join(f"({', '.join(p)})" for p in example["control_points"])
    return f"{points} at {example['parameter']}"


@contextmanager
def _ticking(count: int, quiet: bool) -> Iterator[Callable[[], None]]:
    """A progress bar on a terminal."""
    from rich.console import Console
    from rich.progress import Progress

    shown = on_a_terminal(quiet)
    with Progress(console=Console(stderr=True), transient=True, disable=not shown) as progress:
        task = progress.add_task("grading", total=count)
        yield lambda: progress.advance(task)


if __name__ == "__main__":
    sys.exit(ended(main))
