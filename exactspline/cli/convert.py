"""``convert``: curves and surfaces from one format to another, exactly."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

from exactspline.cli.common import check_output, tell_notes, tell_skipped
from exactspline.cli.output import OptionsError, Output, leave_out, printing
from exactspline.cli.parameters import Argument, Exit, Option
from exactspline.display.data import picked
from exactspline.display.sheet import Sheet
from exactspline.errors import counted

if TYPE_CHECKING:
    from exactspline.interchange.records import NamedCurve, Reading
    from exactspline.splines.surface import NurbsSurface


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
    surfaces: Annotated[bool, Option("--surfaces", help="Of files with curves and surfaces: the surfaces.")] = False,
    approximate: Annotated[
        str,
        Option(
            "--approximate",
            metavar="E",
            help="Replace an arc of SVG with an irrational centre by a rational one that is nowhere further from it "
            "than E.",
        ),
    ] = "",
    degree: Annotated[int | None, Option("--degree", metavar="N", help="For files of control points alone.")] = None,
    knots: Annotated[
        str, Option("--knots", metavar="KNOTS", help="For files of control points alone: all knots.")
    ] = "",
) -> None:
    """Convert curves or surfaces between formats without rounding; whatever is skipped is named on standard error, and
    where a curve is among it, the exit status is 2.
    """
    from exactspline.errors import CurveFileError
    from exactspline.interchange.files import read, write

    check_output(target, source.rpartition(":")[0] or source, source)
    reading = read(
        source,
        from_format or None,
        degree=degree,
        knots=knots.replace(",", " ").split() or None,
        approximate=approximate or None,
    )
    as_surfaces = bool(reading.surfaces) and (surfaces or not reading.curves)
    if as_surfaces and reading.curves:
        leave_out()
        sys.stderr.write(f"skipped: {counted(len(reading.curves), 'curve')}: without --surfaces these are taken\n")
    tell_skipped(reading, surfaces=not as_surfaces)
    tell_notes(reading)
    known = [NamedSurface(each.name, each) for each in reading.surfaces] if as_surfaces else [*reading.curves]
    chosen = [named for named in known if not only or named.name in only]
    what = "surface" if as_surfaces else "curve"
    if not chosen:
        names = ", ".join(named.name for named in known[:10]) or "none"
        raise CurveFileError(f"no {what}s to convert", where=source, remedy=f"the {what}s that are read: {names}")
    if target == "-":
        if not out.for_people:
            raise OptionsError("a report and the curves, both on standard output", remedy="name a file for the curves")
        data, notes = _encoded(chosen, to_format or "json", rounding)
        sys.stdout.buffer.write(data)
    else:
        notes = write([_written(each) for each in chosen], target, to_format or None, rounding=rounding)
    rows = [_row(each, reading, target, notes) | {"skipped": []} for each in chosen]
    rows[0]["skipped"] = [f"{s.where}: {s.what}: {s.why}" for s in reading.skipped]
    numbers = ("degree", "dimension", "control points")
    cells = [
        (row["key"], row["format"], *(_cell(row[each.replace(" ", "_")]) for each in numbers), "; ".join(row["notes"]))
        for row in rows
    ]
    columns = (what, "read as", *numbers, "notes")
    out.give(
        "convert surface" if as_surfaces else "convert",
        rows,
        [Sheet(*columns, rows=cells, numbers=numbers, prose=["notes"])],
        lambda: _report(out, [*notes], f"{counted(len(chosen), what)} from {reading.format} to {target}"),
    )
    if not reading.complete:
        raise Exit(2)


class NamedSurface(NamedTuple):
    """A surface with its name in the file."""

    name: str
    surface: NurbsSurface


def _written(named: NamedCurve | NamedSurface) -> Any:
    return named.surface if isinstance(named, NamedSurface) else named


def _encoded(chosen: Sequence[NamedCurve | NamedSurface], format: str, rounding: bool) -> tuple[bytes, tuple[str, ...]]:
    from exactspline.interchange.files import encoded, encoded_surfaces

    surfaces = [each.surface for each in chosen if isinstance(each, NamedSurface)]
    if surfaces:
        return encoded_surfaces(surfaces, format, rounding=rounding)
    return encoded([_written(each) for each in chosen], format, rounding=rounding)


def _row(named: NamedCurve | NamedSurface, reading: Reading, target: str, notes: Sequence[str]) -> dict[str, Any]:
    if isinstance(named, NamedSurface):
        made, net = picked(named.surface, "degree", "dimension"), named.surface.control_points
        count, own = sum(map(len, net)), list[str]()
    else:
        made, own = picked(named.curve, "degree", "dimension"), [*named.notes]
        count = len(named.curve.control_points)
    row: dict[str, Any] = {"key": named.name, "format": reading.format, "target": target, **made}
    return row | {"control_points": count, "notes": [*own, *reading.notes, *notes]}


def _cell(value: object) -> object:
    return " × ".join(map(str, value)) if isinstance(value, list) else value


def _report(out: Output, notes: list[str], summary: str) -> None:
    """The outcome, on standard error, since standard output may hold the curves."""
    if not out.quiet:
        sys.stderr.writelines(f"note: {note}\n" for note in notes)
        sys.stderr.write(f"{summary}\n")
