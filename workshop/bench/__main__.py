"""``./run bench``: every operation with a promised speed, measured here and in other libraries, in one run on the same
input.

Libraries that are not installed are listed. Times are processor time, the best of several runs; ratios are ours divided
by theirs. Exit status: 0 every target is met; 1 a target is missed; 2 bad input.
"""

from __future__ import annotations

import argparse
import logging
import sys
from collections.abc import Iterable, Sequence

from exactspline.display import console
from workshop.bench import table
from workshop.bench.picture import draw
from workshop.bench.row import Options, Row
from workshop.printing import add_formats, ended, on_a_terminal, show


def arguments(given: Sequence[str] | None) -> argparse.Namespace:
    """The parsed command line."""
    parser = argparse.ArgumentParser(
        prog="./run bench", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "section", nargs="*", metavar="SECTION", help=f"{', '.join(table.SECTIONS)}; all sections if none is named"
    )
    parser.add_argument("--plot", metavar="FILE", default="", help="draw the ratios into an SVG or PNG file")
    parser.add_argument(
        "--full", action="store_true", help="batches of 100,000 curves, all fonts of matplotlib: about 20 minutes"
    )
    parser.add_argument(
        "--limit", metavar="SECONDS", type=int, default=60, help="limit on the processor time of one heavy case (60)"
    )
    parser.add_argument(
        "--curves", metavar="FOLDER", default="", help="curve files to inspect, instead of the example curves"
    )
    add_formats(parser)
    return parser.parse_args(given)


def main(given: Sequence[str] | None = None) -> int:
    """Measure, print and draw; returns the exit status."""
    options = arguments(given)
    # warnings about dates in fonts do not concern outlines
    logging.getLogger("fontTools").setLevel(logging.ERROR)
    sections = table.chosen_sections(options.section)
    rows = _watched(table.rows(sections, Options(options.limit, options.curves, options.full)), options.quiet)
    show(options.format, "bench", [row.data() for row in rows], table.sheet(rows))
    held = [row for row in rows if row.met is not None]
    if held and options.format is None:
        met = sum(bool(row.met) for row in held)
        console.lines(console.console(), f"{met} of {len(held)} targets met")
    if options.format is None and not options.quiet:
        explanation = "ours / theirs: processor time of exactspline divided by that of the other"
        console.lines(console.console(), explanation)
    if options.plot:
        draw(rows, options.plot)
    return int(any(row.met is False for row in held))


def _watched(measured: Iterable[Row], quiet: bool) -> list[Row]:
    """The rows; on a terminal the case measured last is shown."""
    if not on_a_terminal(quiet):
        return list(measured)
    from rich.console import Console

    rows = []
    with Console(stderr=True).status("measuring") as status:
        for row in measured:
            rows.append(row)
            status.update(f"{len(rows)} measured; {row.section}: {row.case}")
    return rows


if __name__ == "__main__":
    sys.exit(ended(main))
