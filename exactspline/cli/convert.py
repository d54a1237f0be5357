"""``exactspline convert``: curves from one format to another, exactly."""

from __future__ import annotations

import sys
from typing import Annotated

import typer

from exactspline.cli.common import check_output, tell_skipped


def convert(
    source: Annotated[str, typer.Argument(metavar="IN", help="A file, font.ttf:glyph, or - for standard input.")],
    target: Annotated[str, typer.Argument(metavar="OUT", help="A file, or - for standard output.")],
    from_format: Annotated[
        str, typer.Option("--from", metavar="FORMAT", help="The format of IN; by default told by its content.")
    ] = "",
    to_format: Annotated[
        str, typer.Option("--to", metavar="FORMAT", help="The format of OUT; by default told by its suffix.")
    ] = "",
    rounding: Annotated[
        bool, typer.Option("--round", help="Round what the format cannot hold exactly to the nearest doubles.")
    ] = False,
    only: Annotated[
        list[str] | None, typer.Option("--only", metavar="NAME", help="The name of a curve to take; repeatable.")
    ] = None,
    degree: Annotated[
        int | None, typer.Option("--degree", metavar="N", help="For files of control points alone.")
    ] = None,
    knots: Annotated[
        str, typer.Option("--knots", metavar="KNOTS", help="For files of control points alone: all knots.")
    ] = "",
) -> None:
    """Convert curves between formats without rounding; what is not read is named on standard error."""
    from exactspline.errors import CurveFileError
    from exactspline.interchange.files import encoded, read, write

    check_output(target, source.rpartition(":")[0] or source, source)
    reading = read(source, from_format or None, degree=degree, knots=knots.replace(",", " ").split() or None)
    tell_skipped(reading)
    for named in reading.curves:
        sys.stderr.writelines(f"note: {named.name}: {note}\n" for note in named.notes)
    curves = [named for named in reading.curves if not only or named.name in only]
    if not curves:
        names = ", ".join(named.name for named in reading.curves[:10]) or "none"
        raise CurveFileError("no curves to convert", where=source, remedy=f"the curves that are read: {names}")
    if target == "-":
        data, notes = encoded(curves, to_format or "json", rounding=rounding)
        sys.stdout.buffer.write(data)
    else:
        notes = write(curves, target, to_format or None, rounding=rounding)
    sys.stderr.writelines(f"note: {note}\n" for note in notes)
    sys.stderr.write(f"{len(curves)} curve{'s' if len(curves) > 1 else ''} from {reading.format} to {target}\n")
