"""``convert``: curves from one format to another, exactly."""

from __future__ import annotations

import sys
from dataclasses import replace
from typing import TYPE_CHECKING, Annotated, Any

from exactspline.cli.common import check_distance, check_output, tell_notes, tell_skipped
from exactspline.cli.output import OptionsError, Output, printing
from exactspline.cli.parameters import Argument, Exit, Option
from exactspline.display.data import picked
from exactspline.display.sheet import Sheet
from exactspline.numbers.exact import text

if TYPE_CHECKING:
    from exactspline.geometry.recognition.pieces import RecognizedPiece
    from exactspline.geometry.recognition.snapping import Snapped
    from exactspline.splines.nurbs import Nurbs


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
    snap: Annotated[
        str,
        Option(
            "--snap",
            metavar="line,circle",
            help="Replace pieces that are nearly lines or arcs of circles by exact ones with the same end points; each "
            "is listed with its proved distance.",
        ),
    ] = "",
    epsilon: Annotated[
        str,
        Option(
            "--epsilon",
            metavar="E",
            help="With --snap: how near (a number, or written); by default 1e-9 of the curve's size.",
        ),
    ] = "",
) -> None:
    """Convert curves between formats without rounding; whatever is skipped is named on standard error, and
    where a curve is among it, the exit status is 2.
    """
    from exactspline.display.serialize import described_data
    from exactspline.errors import CurveFileError, counted
    from exactspline.interchange.files import encoded, read, write

    if epsilon and not snap:
        raise OptionsError("--epsilon without --snap", remedy="say what to replace: --snap line,circle")
    if epsilon:
        check_distance(epsilon)
    check_output(target, source.rpartition(":")[0] or source, source)
    reading = read(source, from_format or None, degree=degree, knots=knots.replace(",", " ").split() or None)
    tell_skipped(reading)
    tell_notes(reading)
    chosen = [named for named in reading.curves if not only or named.name in only]
    repairs = [_repaired(named.curve, snap, epsilon) for named in chosen]
    curves = [
        replace(named, curve=repair.curve, notes=(*named.notes, *_told(repair)))
        for named, repair in zip(chosen, repairs, strict=True)
    ]
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
            "replaced": [described_data(piece) for piece in repair.replaced],
            "kept": [described_data(piece) for piece in repair.kept],
        }
        for i, (named, repair) in enumerate(zip(curves, repairs, strict=True))
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
        lambda: _report(
            out,
            [
                *(f"{named.name}: {told}" for named, each in zip(curves, repairs, strict=True) for told in _told(each)),
                *notes,
            ],
            f"{counted(len(curves), 'curve')} from {reading.format} to {target}",
        ),
    )
    if not reading.complete:
        raise Exit(2)


def _repaired(curve: Nurbs, snap: str, epsilon: str) -> Snapped:
    """The curve with its pieces near to the shapes that are named replaced by exact ones."""
    from exactspline.geometry.recognition.snapping import Snapped, snapped

    kinds = [word.strip() for word in snap.split(",")] if snap else []
    return snapped(curve, kinds, epsilon or None) if kinds else Snapped(curve, (), ())


def _told(repair: Snapped) -> list[str]:
    """What was replaced by what, and what was not, as text."""
    from exactspline.display.features import end_text, shape_text
    from exactspline.display.serialize import described_data

    def place(piece: RecognizedPiece) -> str:
        return f"[{end_text(text(piece.piece.start))}, {end_text(text(piece.piece.end))}]"

    replaced = [f"{place(x)} replaced by a {x.kind}: {shape_text(described_data(x))}" for x in repair.replaced]
    kept = [f"{place(x)} stays: no {x.kind} through its end points is near enough" for x in repair.kept]
    return replaced + kept


def _report(out: Output, notes: list[str], summary: str) -> None:
    """The outcome, on standard error, since standard output may hold the curves."""
    if not out.quiet:
        sys.stderr.writelines(f"note: {note}\n" for note in notes)
        sys.stderr.write(f"{summary}\n")
