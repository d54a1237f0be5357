"""``convert``: curves and surfaces from one format to another, exactly."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from exactspline.cli.common import (
    check_approximate,
    check_distance,
    check_output,
    surfaces_in,
    tell_notes,
    tell_skipped,
)
from exactspline.cli.output import Exit, OptionsError, Output, leave_out, printing, ticking, to_stderr
from exactspline.display.forms import picked
from exactspline.display.sheet import Sheet
from exactspline.errors import CurveFileError, ShapeError, counted

if TYPE_CHECKING:
    from exactspline.geometry.recognition.pieces import RecognizedPiece
    from exactspline.geometry.recognition.snapping import Snapped
    from exactspline.interchange.records import NamedCurve, Reading
    from exactspline.splines.surface import NurbsSurface


@printing
def convert(
    out: Output,
    source: str,
    target: str,
    from_format: str = "",
    to_format: str = "",
    rounding: bool = False,
    only: list[str] | None = None,
    surfaces: bool = False,
    approximate: str = "",
    degree: int | None = None,
    knots: str = "",
    snap: str = "",
    epsilon: str = "",
) -> None:
    """Convert curves or surfaces between formats without rounding. Skipped entities are named on standard error; if a
    curve is skipped, the exit status is 2.
    """
    from exactspline.interchange.files import encoded, read, write

    if epsilon and not snap:
        raise OptionsError("--epsilon without --snap", remedy="say what to replace: --snap line,circle")
    check_distance(epsilon)
    check_approximate(approximate)
    check_output(target, source.rpartition(":")[0] or source, source)
    own = knots.replace(",", " ").split() or None
    with ticking(f"reading {source}", 1):
        reading = read(source, from_format or None, degree=degree, knots=own, approximate=approximate or None)
    what = "surface" if reading.surfaces and (surfaces or not reading.curves) else "curve"
    chosen = _chosen(reading, what, source, only or [])
    if snap and what == "surface":
        raise OptionsError("--snap and surfaces", remedy="omit --snap: it is only for curves")
    repairs = [_repaired(each, snap, epsilon) for each in chosen]
    replacements = _all_replacements(chosen, repairs, snap)
    chosen = list(map(_with_repair, chosen, repairs))
    if target == "-":
        if not out.for_people:
            raise OptionsError("a report and the curves, both on standard output", remedy="name a file for the curves")
        data, notes = encoded(chosen, to_format or "json", rounding=rounding)
        sys.stdout.buffer.write(data)
    else:
        notes = write(chosen, target, to_format or None, rounding=rounding)
    rows = [_row(*each, reading, target, notes) for each in zip(chosen, repairs, strict=True)]
    rows[0]["skipped"] = [f"{s.where}: {s.what}: {s.why}" for s in reading.skipped]
    out.give(
        "convert surface" if what == "surface" else "convert",
        rows,
        [_sheet(what, rows)],
        lambda: _report(
            out, [*replacements, *notes], f"{counted(len(chosen), what)} from {reading.format} to {target}"
        ),
    )
    if not reading.complete:
        raise Exit(2)


def _chosen(reading: Reading, what: str, source: str, only: Sequence[str]) -> list[NamedCurve | NurbsSurface]:
    """The curves or surfaces to convert: those with the names in `only`, or all. Skipped entities are named on standard
    error.
    """
    known: Sequence[NamedCurve | NurbsSurface] = reading.curves
    if what == "surface":
        known = surfaces_in(source, reading)
    else:
        tell_skipped(reading, source)
        tell_notes(reading)
    chosen = [named for named in known if not only or named.name in only]
    if not chosen:
        names = ", ".join(named.name for named in known[:10])
        remedy = f"the {what}s that are read: {names}" if names else "give a file of which some are read"
        raise CurveFileError(f"no {what}s to convert", where=source, remedy=remedy)
    return chosen


def _sheet(what: str, rows: Sequence[dict[str, Any]]) -> Sheet:
    numbers = ("degree", "dimension", "control points")
    cells = [
        (row["key"], row["format"], *(_cell(row[each.replace(" ", "_")]) for each in numbers), "; ".join(row["notes"]))
        for row in rows
    ]
    return Sheet(what, "read as", *numbers, "notes", rows=cells, numbers=numbers, prose=["notes"])


def _repaired(named: NamedCurve | NurbsSurface, snap: str, epsilon: str) -> Snapped | None:
    """A curve whose pieces near one of the shapes `snap` are replaced by exact ones. A curve for which that cannot be
    done is reported and kept as it is.
    """
    from exactspline.geometry.recognition.snapping import Snapped, checked_kinds, snapped
    from exactspline.interchange.records import NamedCurve

    if not isinstance(named, NamedCurve):
        return None
    if snap:
        kinds = checked_kinds([word.strip() for word in snap.split(",")])
        try:
            return snapped(named.curve, kinds, epsilon or None)
        except ShapeError as error:
            leave_out()
            to_stderr(f"not replaced: {named.name}: {error}")
    return Snapped(named.curve, (), ())


def _replacements(repair: Snapped | None) -> list[str]:
    """The replaced pieces, each with its shape, and the pieces that were kept, as text."""
    from exactspline.display.forms import real_text
    from exactspline.display.numbers import shape_text

    if repair is None:
        return []

    def place(piece: RecognizedPiece) -> str:
        return f"[{real_text(piece.piece.start)}, {real_text(piece.piece.end)}]"

    replaced = [f"{place(x)} replaced by a {x.kind}: {shape_text(x.shape.numbers, x.within)}" for x in repair.replaced]
    return replaced + [f"{place(x)} stays: no {x.kind} through its end points is near enough" for x in repair.kept]


def _all_replacements(
    chosen: Sequence[NamedCurve | NurbsSurface], repairs: Sequence[Snapped | None], snap: str
) -> list[str]:
    found = [f"{each.name}: {x}" for each, repair in zip(chosen, repairs, strict=True) for x in _replacements(repair)]
    if snap and not found:
        found.append(f"no piece is near enough to a {snap.replace(',', ' or ')}; a larger --epsilon finds more")
    return found


def _with_repair(named: NamedCurve | NurbsSurface, repair: Snapped | None) -> NamedCurve | NurbsSurface:
    from exactspline.interchange.records import NamedCurve

    if repair is None or not isinstance(named, NamedCurve):
        return named
    return replace(named, curve=repair.curve, notes=(*named.notes, *_replacements(repair)))


def _row(
    named: NamedCurve | NurbsSurface, repair: Snapped | None, reading: Reading, target: str, notes: Sequence[str]
) -> dict[str, Any]:
    from exactspline.display.answer_forms import FORMS
    from exactspline.display.forms import DIGITS
    from exactspline.geometry.recognition.pieces import RecognizedPiece
    from exactspline.interchange.records import NamedCurve

    if isinstance(named, NamedCurve):
        made, own = picked(named.curve, "degree", "dimension"), [*named.notes]
        count = len(named.curve.control_points)
    else:
        made, own = picked(named, "degree", "dimension"), list[str]()
        count = sum(map(len, named.control_points))
    row: dict[str, Any] = {"key": named.name, "format": reading.format, "target": target, **made}
    row |= {"control_points": count, "notes": [*own, *reading.notes, *notes], "skipped": []}
    if repair is not None:
        row |= {
            name: [FORMS[RecognizedPiece].write(x, DIGITS) for x in getattr(repair, name)]
            for name in ("replaced", "kept")
        }
    return row


def _cell(value: object) -> object:
    return " × ".join(map(str, value)) if isinstance(value, list) else value


def _report(out: Output, notes: list[str], summary: str) -> None:
    """The outcome, on standard error, since standard output may hold the curves."""
    if not out.quiet:
        for line in (*(f"note: {note}" for note in notes), summary):
            to_stderr(line)
