"""The output of the workshop's programs: a table for people, JSON, CSV or Markdown for programs."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable, Mapping, Sequence

from exactspline.cli.output import to_stderr
from exactspline.display import console
from exactspline.display.sheet import Sheet, csv_of
from exactspline.errors import ExactSplineError

#: The version of the JSON documents; it increases when a field changes its meaning or is removed.
VERSION = 3


def add_formats(parser: argparse.ArgumentParser) -> None:
    """Add the options that choose the format."""
    formats = parser.add_mutually_exclusive_group()
    for name, form in (("json", "JSON (see schema.json)"), ("csv", "comma-separated values"), ("markdown", "Markdown")):
        formats.add_argument(f"--{name}", dest="format", action="store_const", const=name, help=f"print {form}")
    parser.add_argument("-q", "--quiet", action="store_true", help="no progress bar, no comments")


def show(chosen: str | None, schema: str, rows: Sequence[Mapping[str, object]], sheet: Sheet) -> None:
    """Print rows as JSON, or their table as CSV, Markdown or text."""
    if chosen == "json":
        document = {"schema": f"exactspline/{schema}", "version": VERSION, "rows": list(rows)}
        sys.stdout.write(json.dumps(document, ensure_ascii=False, indent=1) + "\n")
    elif chosen == "csv":
        sys.stdout.write(csv_of([sheet]))
    elif chosen == "markdown":
        sys.stdout.write(sheet.markdown() + "\n")
    else:
        console.console().print(sheet)


def on_a_terminal(quiet: bool) -> bool:
    """Whether a person watches standard error."""
    return not quiet and sys.stderr.isatty()


def ended(run: Callable[[], int]) -> int:
    """The exit status of a program: bad input ends in one line on standard error and exit status 2."""
    try:
        return run()
    except ExactSplineError as error:
        to_stderr(f"error: {error}")
        return 2
