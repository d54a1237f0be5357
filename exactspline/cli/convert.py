"""``convert``: curves and surfaces from one format to another, exactly."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

from exactspline.cli.common import (
    Approximate,
    check_approximate,
    check_distance,
    check_output,
    tell_notes,
    tell_skipped,
)
from exactspline.cli.output import OptionsError, Output, leave_out, printing
from exactspline.cli.parameters import Argument, Exit, Option
from exactspline.display.data import picked
from exactspline.display.sheet import Sheet
from exactspline.errors import ShapeError, counted
from exactspline.numbers.exact import text

if TYPE_CHECKING:
    from exactspline.geometry.recognition.pieces import RecognizedPiece
    from exactspline.geometry.recognition.snapping import Snapped
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
    approximate: Approximate = "",
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
    """Convert curves or surfaces between formats without rounding; whatever is skipped is named on standard error, and
    where a curve is among it, the exit status is 2.
    """
    from exactspline.errors import CurveFileError
    from exactspline.interchange.files import read, write

    if epsilon and not snap:
        raise OptionsError("--epsilon without --snap", remedy="say what to replace: --snap line,circle")
    if epsilon:
        check_distance(epsilon)
    check_approximate(approximate)
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
        sys.stderr.write(
            f"skipped: {source}: {counted(len(reading.curves), 'curve')}: without --surfaces these are taken\n"
        )
    tell_skipped(reading, source, surfaces=not as_surfaces)
    tell_notes(reading, curves=not as_surfaces)
    known = [NamedSurface(each.name, each) for each in reading.surfaces] if as_surfaces else [*reading.curves]
    chosen = [named for named in known if not only or named.name in only]
    what = "surface" if as_surfaces else "curve"
    if not chosen:
        names = ", ".join(named.name for named in known[:10]) or "none"
        raise CurveFileError(f"no {what}s to convert", where=source, remedy=f"the {what}s that are read: {names}")
    if snap and as_surfaces:
        raise OptionsError("--snap and surfaces", remedy="it is for curves")
    repairs = [_repaired(each, snap, epsilon) for each in chosen]
    replacements = [
        f"{each.name}: {x}" for each, repair in zip(chosen, repairs, strict=True) for x in _replacements(repair)
    ]
    if snap and not replacements:
        replacements.append(f"no piece is near enough to a {snap.replace(',', ' or ')}; a larger --epsilon finds more")
    chosen = list(map(_with_repair, chosen, repairs))
    if target == "-":
        if not out.for_people:
            raise OptionsError("a report and the curves, both on standard output", remedy="name a file for the curves")
        data, notes = _encoded(chosen, to_format or "json", rounding)
        sys.stdout.buffer.write(data)
    else:
        notes = write([_written(each) for each in chosen], target, to_format or None, rounding=rounding)
    rows = [
        _row(each, reading, target, notes) | {"skipped": []} | _repair_data(repair)
        for each, repair in zip(chosen, repairs, strict=True)
    ]
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
        lambda: _report(
            out, [*replacements, *notes], f"{counted(len(chosen), what)} from {reading.format} to {target}"
        ),
    )
    if not reading.complete:
        raise Exit(2)


def _repaired(named: NamedCurve | NamedSurface, snap: str, epsilon: str) -> Snapped | None:
    """A curve with its pieces near to the shapes that are named replaced by exact ones. A curve for which that cannot
    be done is named, and stays as it is.
    """
    from exactspline.geometry.recognition.snapping import Snapped, checked_kinds, snapped

    if isinstance(named, NamedSurface):
        return None
    if snap:
        kinds = checked_kinds([word.strip() for word in snap.split(",")])
        try:
            return snapped(named.curve, kinds, epsilon or None)
        except ShapeError as error:
            leave_out()
            sys.stderr.write(f"not replaced: {named.name}: {error}\n")
    return Snapped(named.curve, (), ())


def _replacements(repair: Snapped | None) -> list[str]:
    """What was replaced by what, and what was not, as text."""
    from exactspline.display.described import shape_text
    from exactspline.display.features import end_text

    if repair is None:
        return []

    def place(piece: RecognizedPiece) -> str:
        return f"[{end_text(text(piece.piece.start))}, {end_text(text(piece.piece.end))}]"

    replaced = [f"{place(x)} replaced by a {x.kind}: {shape_text(x.shape.numbers, x.within)}" for x in repair.replaced]
    kept = [f"{place(x)} stays: no {x.kind} through its end points is near enough" for x in repair.kept]
    return replaced + kept


def _with_repair(named: NamedCurve | NamedSurface, repair: Snapped | None) -> NamedCurve | NamedSurface:
    if repair is None or isinstance(named, NamedSurface):
        return named
    return replace(named, curve=repair.curve, notes=(*named.notes, *_replacements(repair)))


def _repair_data(repair: Snapped | None) -> dict[str, Any]:
    from exactspline.display.serialize import described_data

    if repair is None:
        return {}
    return {name: [described_data(x) for x in getattr(repair, name)] for name in ("replaced", "kept")}


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
