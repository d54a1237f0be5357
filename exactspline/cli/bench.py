"""``exactspline bench``: times, of this library and of others."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from typing import TYPE_CHECKING, Annotated

import typer

from exactspline.cli.common import quiet_fonts
from exactspline.cli.output import Output, is_quiet, printing

if TYPE_CHECKING:
    from exactspline.batch.bench.row import Row


def _sections(given: str) -> list[str]:
    from exactspline.batch.bench.table import SECTIONS

    return [name for name in SECTIONS if name.startswith(given)]


@printing
def bench(
    out: Output,
    section: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="SECTION",
            help="features, forms, roots, splines, growth, linear, commands, sweep, memory; all if none is named.",
            autocompletion=_sections,
        ),
    ] = None,
    plot: Annotated[str, typer.Option("--plot", metavar="FILE", help="Draw the ratios into an SVG or PNG file.")] = "",
    full: Annotated[
        bool, typer.Option("--full", help="100,000 curves of a batch, all fonts of matplotlib: some 20 minutes.")
    ] = False,
    limit: Annotated[
        int, typer.Option("--limit", metavar="SECONDS", min=1, max=86_400, help="Processor time of one heavy case.")
    ] = 60,
    curves: Annotated[
        str, typer.Option("--curves", metavar="FOLDER", help="Curve files to inspect. [default: the example curves]")
    ] = "",
) -> None:
    """Measure every operation with a promised speed, here and in other libraries, in one run on the same input.
    Libraries that are not installed are listed (the extra bench installs them). Times are processor time, the best of
    several runs; ratios are ours divided by theirs.
    """
    from exactspline.batch.bench.row import Options
    from exactspline.batch.bench.table import chosen_sections, rows, sheet

    quiet_fonts()
    found = _told(rows(chosen_sections(section or []), Options(limit, curves, full)))
    out.give("bench", lambda: [row.data() for row in found], lambda: [sheet(found)], lambda: _print(out, found))
    if plot:
        from exactspline.batch.bench.picture import draw

        draw(found, plot)
    if any(row.met is False for row in found):
        raise typer.Exit(1)


def _told(measured: Iterable[Row]) -> list[Row]:
    """The rows; a terminal shows the case that was measured last."""
    if is_quiet() or not sys.stderr.isatty():
        return list(measured)
    from rich.console import Console

    found = []
    with Console(stderr=True).status("measuring") as status:
        for row in measured:
            found.append(row)
            status.update(f"{len(found)} measured; {row.section}: {row.case}")
    return found


def _print(out: Output, found: list[Row]) -> None:
    from exactspline.batch.bench.table import sheet
    from exactspline.display import console

    shown = console.console()
    shown.print(sheet(found))
    held = [row for row in found if row.met is not None]
    missed = [row for row in held if not row.met]
    if held:
        console.lines(shown, f"{len(held) - len(missed)} of {len(held)} targets met")
    if not out.quiet:
        console.lines(shown, "ours / theirs: processor time of exactspline divided by that of the other")
