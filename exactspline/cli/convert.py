"""``convert``: curves from one format to another, exactly."""

from __future__ import annotations

import sys
from typing import Annotated, Any

from exactspline.cli.common import check_output, tell_notes, tell_skipped
from exactspline.cli.output import OptionsError, Output, printing
from exactspline.cli.parameters import Argument, Exit, Option
from exactspline.display.data import picked
from exactspline.display.sheet import Sheet


@printing
def convert(
    out: Output,
    source: Annotated[str, Argument(metavar="IN", help="A file, font.ttf:glyph, or - for standard input.")],
    target: Annotated[str, Argument(metavar="OUT", help="A file, or - for standard output.")],
    from_format: Annotated[
        str, Option("--from", metavar="FORMAT", help="The format of IN; recognized by its content by default.")
    ] = "",
    to_format: Annotated[
        str, Option("--to", metavar="FORMAT", help="The format of OUT; recognized by its suffix by default.")
    ] = "",
    rounding: Annotated[
        bool, Option("--round", help="Round what the format cannot hold exactly to the nearest doubles.")
    ] = False,
    only: Annotated[
        list[str] | None, Option("--only", metavar="NAME", help="The name of a curve to take; repeatable.")
    ] = None,
    degree: Annotated[int | None, Option("--degree", metavar="N", help="For files of control points alone.")] = None,
    knots: Annotated[
        str, Option("--knots", metavar="KNOTS", help="For files of control points alone: all knots.")
    ] = "",
) -> None:
    """Convert curves between formats without rounding; whatever is skipped is named on standard error, and
    where a curve is among it, the exit status is 2.
    """
    from exactspline.errors import CurveFileError, counted
    from exactspline.interchange.files import encoded, read, write

    check_output(target, source.rpartition(":")[0] or source, source)
    reading = read(source, from_format or None, degree=degree, knots=knots.replace(",", " ").split() or None)
    tell_skipped(reading)
    tell_notes(reading)
    curves = [named for named in reading.curves if not only or named.name in only]
    if not curves:
        names = ", ".join(named.name for named in reading.curves[:10]) or "none"
        raise CurveFileError("no curves to convert", where=source, remedy=f"the curves that are read: {names}")
    if target == "-":
        if not out.for_people:
            raise OptionsError("a report and the curves, both on standard output", remedy="name a file for the curves")
        data, notes = encoded(curves, to_format or "json", rounding=rounding)
        sys.stdout.buffer.write(data)
    else:
        notes = write(curves, target, to_format or None, rounding=rounding)
    skipped = [f"{s.where}: {s.what}: {s.why}" for s in reading.skipped]
    rows: list[dict[str, Any]] = [
        {
            "key": named.name,
            "format": reading.format,
            "target": target,
            **picked(named.curve, "degree", "dimension"),
            "control_points": len(named.curve.control_points),
            "notes": [*named.notes, *reading.notes, *notes],
            "skipped": [] if i else skipped,
        }
        for i, named in enumerate(curves)
    ]
    numbers = ("degree", "dimension", "control points")
    cells = [
        (row["key"], row["format"], *(row[each.replace(" ", "_")] for each in numbers), "; ".join(row["notes"]))
        for row in rows
    ]
    columns = ("curve", "read as", *numbers, "notes")
    out.give(
        "convert",
        rows,
        [Sheet(*columns, rows=cells, numbers=numbers, prose=["notes"])],
        lambda: _report(out, [*notes], f"{counted(len(curves), 'curve')} from {reading.format} to {target}"),
    )
    if not reading.complete:
        raise Exit(2)


def _report(out: Output, notes: list[str], summary: str) -> None:
    """The outcome, on standard error, since standard output may hold the curves."""
    if not out.quiet:
        sys.stderr.writelines(f"note: {note}\n" for note in notes)
        sys.stderr.write(f"{summary}\n")
