"""Surfaces as arguments of commands: functions that find and read them, and the output of ``inspect`` for surfaces."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from exactspline.cli.common import each_read, only_one, reading_of, tell_notes, tell_skipped, tell_written
from exactspline.cli.output import OptionsError, Output, leave_out, to_stderr
from exactspline.cli.parameters import Exit
from exactspline.errors import CurveFileError, counted

if TYPE_CHECKING:
    from exactspline.display.sheet import Sheet
    from exactspline.geometry.analysis.surfaces import SurfaceInspection
    from exactspline.interchange.records import Reading
    from exactspline.splines.surface import NurbsSurface


def surfaces_among(readings: Sequence[tuple[str, Reading]], *, requested: bool) -> list[tuple[str, Reading]]:
    """The readings of files that hold surfaces and no curves; if surfaces are requested, also of files with both."""
    return [(name, each) for name, each in readings if each.surfaces and (requested or not each.curves)]


def read_surfaces(name: str) -> Sequence[NurbsSurface]:
    """The surfaces that a name means: an example, or the surfaces of a file in any format or of standard input.
    Whatever else the file holds is named on standard error.
    """
    reading = reading_of(name)
    if not reading.surfaces:
        tell_skipped(reading, name)
        raise CurveFileError("holds no surface", where=name, remedy="name a file of surfaces")
    return surfaces_in(name, reading, "not a surface")


def read_surface(name: str) -> NurbsSurface:
    """The one surface that a name, a file or standard input means."""
    return only_one(read_surfaces(name), "surface", name, "--surfaces ")


def surfaces_in(name: str, reading: Reading, why: str = "without --surfaces these are taken") -> Sequence[NurbsSurface]:
    """The surfaces of a file; whatever else the file holds is named on standard error."""
    if reading.curves:
        leave_out()
        to_stderr(f"skipped: {name}: {counted(len(reading.curves), 'curve')}: {why}")
    tell_skipped(reading, name, surfaces=False)
    tell_notes(reading, curves=False)
    return reading.surfaces


def inspect_surfaces(
    out: Output,
    surfaces: Sequence[NurbsSurface],
    digits: int,
    plot: str,
    epsilon: str,
    *,
    good: bool,
    with_all: bool = False,
) -> None:
    """Print the features of surfaces; a surface that fails is reported, and the others are inspected. `good` is whether
    all could be read.
    """
    if plot and len(surfaces) > 1:
        raise OptionsError("--plot and several surfaces", remedy="draw them one by one")
    inspected, all_good = each_read(surfaces, lambda surface: _inspected(surface, digits, plot, epsilon, with_all))
    good = good and all_good
    out.give(
        "inspect surface",
        [{"key": str(data["surface"])} | data for data, _ in inspected],
        [sheets[0] for _, sheets in inspected],
        lambda: out.show([sheet for _, sheets in inspected for sheet in sheets]),
        by="surface",
    )
    if not good:
        raise Exit(2)


def _inspected(
    surface: NurbsSurface, digits: int, plot: str, epsilon: str, with_all: bool
) -> tuple[dict[str, object], list[Sheet]]:
    """The features of a surface as data and as tables, and the picture where one is requested."""
    from exactspline.display.answer_forms import FORMS, FORMS_BESIDE, surface_inspection_data
    from exactspline.display.forms import list_of
    from exactspline.display.surface_data import map_sheet, nearby_umbilics_sheet, surface_sheet
    from exactspline.geometry.analysis.planar_maps import jacobian_sign
    from exactspline.geometry.analysis.surfaces import inspect_surface
    from exactspline.geometry.recognition.patches import RecognizedPart

    if surface.dimension == 2:
        if plot:
            raise OptionsError("--plot and a map of the plane", remedy="omit --plot: only surfaces in space are drawn")
        sign = jacobian_sign(surface)
        return surface_inspection_data(sign, digits), [map_sheet(sign)]
    found = inspect_surface(surface)
    if plot:
        _drawn(found, plot)
    data = surface_inspection_data(found, digits)
    if not epsilon:
        return data, [surface_sheet(found, digits, with_all=with_all)]
    shapes, umbilics = found.shapes_within(epsilon), found.umbilics_within(epsilon)
    data |= {"shapes": list_of(FORMS[RecognizedPart]).write(shapes, digits), "epsilon": epsilon}
    data["umbilics_within"] = FORMS_BESIDE["inspect surface"]["umbilics_within"].write(umbilics, digits)
    sheets = [surface_sheet(found, digits, shapes, with_all=with_all)]
    if umbilics:
        sheets.append(nearby_umbilics_sheet(umbilics, f"All surfaces within {epsilon} of {surface.name}"))
    return data, sheets


def _drawn(found: SurfaceInspection, plot: str) -> None:
    """Write a picture, or an interactive page, of an inspected surface."""
    from exactspline.display.plot.anything import picture

    if plot.lower().endswith(".html"):
        from exactspline.atomic_write import write_text
        from exactspline.display.plot.canvas import PlotError

        write_text(plot, picture("page of an inspected surface", found), PlotError)
        tell_written(plot)
        return
    from exactspline.display.plot.canvas import save

    save(picture("inspected surface", found), plot)
    tell_written(plot)
