"""``convert``: curves from one format to another, exactly."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Annotated

from exactspline.cli.common import check_output, tell_notes, tell_skipped
from exactspline.cli.output import OptionsError, Output, printing
from exactspline.cli.parameters import Argument, Exit, Option

if TYPE_CHECKING:
    from exactspline.display.sheet import Sheet
    from exactspline.interchange.records import NamedCurve


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
    rows = [_row(named, reading.format, target, [*named.notes, *reading.notes, *notes]) for named in curves]
    skipped = [f"{s.where}: {s.what}: {s.why}" for s in reading.skipped]
    out.give(
        "convert",
        lambda: [row | {"skipped": skipped if i == 0 else []} for i, row in enumerate(rows)],
        lambda: [_sheet(rows)],
        lambda: _told(out, [*notes], f"{counted(len(curves), 'curve')} from {reading.format} to {target}"),
    )
    if not reading.complete:
        raise Exit(2)


def _row(named: NamedCurve, read_as: str, target: str, notes: list[str]) -> dict[str, object]:
    c = named.curve
    row: dict[str, object] = {"key": named.name, "format": read_as, "target": target, "degree": c.degree}
    return row | {"dimension": c.dimension, "control_points": len(c.control_points), "notes": notes}


def _sheet(rows: list[dict[str, object]]) -> Sheet:
    from exactspline.display.sheet import Sheet

    numbers = ("degree", "dimension", "control points")
    made = Sheet("curve", "read as", *numbers, "notes", numbers=numbers, prose=["notes"])
    for row in rows:
        notes = row["notes"]
        assert isinstance(notes, list)
        made.add_row(
            row["key"], row["format"], row["degree"], row["dimension"], row["control_points"], "; ".join(notes)
        )
    return made


def _told(out: Output, notes: list[str], summary: str) -> None:
    """The outcome, on standard error, since standard output may hold the curves."""
    if not out.quiet:
        sys.stderr.writelines(f"note: {note}\n" for note in notes)
        sys.stderr.write(f"{summary}\n")
