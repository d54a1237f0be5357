"""Surfaces as arguments of commands, and ``inspect`` of surfaces: which arguments are surfaces, and what is printed."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from exactspline.cli.common import at_standard_input, each_read, standard_input, tell_notes, tell_skipped, tell_written
from exactspline.cli.output import OptionsError, Output, leave_out
from exactspline.cli.parameters import Exit
from exactspline.errors import CurveFileError, ExactSplineError, command_name, counted

if TYPE_CHECKING:
    from exactspline.display.sheet import Sheet
    from exactspline.geometry.surface.inspection import SurfaceInspection
    from exactspline.interchange.records import Reading
    from exactspline.splines.surface import NurbsSurface


def is_surface(name: str, given: bytes | None = None) -> bool:
    """Whether a name, a file or standard input (``-``, which was read before) is meant as a surface.

    >>> is_surface("torus"), is_surface("circle")
    (True, False)
    """
    from exactspline.interchange.curve_files import looks_like_surface
    from exactspline.interchange.examples import example_names, example_surface_names
    from exactspline.interchange.json_files import MAX_BYTES

    if name == "-":
        return given is not None and len(given) <= MAX_BYTES and looks_like_surface(given.decode(errors="replace"))
    place = Path(name)
    if not place.is_file():
        return name in example_surface_names() and name not in example_names()
    if not name.lower().endswith(".json") or place.stat().st_size > MAX_BYTES:
        return False
    try:
        return looks_like_surface(place.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError):
        return False


#: Reads the surfaces that a name means.
Surfaces = Callable[[], "Sequence[NurbsSurface]"]


def surfaces_among(names: Sequence[str], given: bytes | None, *, requested: bool) -> dict[str, Surfaces]:
    """Those of some names that mean surfaces: examples, our JSON, files that hold surfaces and no curves; files with
    both where surfaces are `requested`.
    """
    found: dict[str, Surfaces] = {}
    for name in names:
        if is_surface(name, given):
            found[name] = partial(_one, name, given)
        elif reading := _with_surfaces(name, given, requested):
            found[name] = partial(_reported, reading, name)
    return found


def read_surfaces(name: str, given: bytes | None = None) -> Sequence[NurbsSurface]:
    """The surfaces that a name means: an example, those of a file in any format, or of standard input, `given` where it
    was read before; whatever is skipped is named on standard error, and so are notes.
    """
    given = standard_input() if name == "-" and given is None else given
    if is_surface(name, given) or not (name == "-" or Path(name).is_file()):
        return _one(name, given)
    from exactspline.interchange.files import read

    reading = read(name) if name != "-" or given is None else at_standard_input(lambda: read(given))
    if not reading.surfaces:
        tell_skipped(reading, name)
        where = "standard input" if name == "-" else name
        raise CurveFileError("holds no surface", where=where, remedy="name a file of surfaces")
    return _reported(reading, name, "not a surface")


def read_surface(name: str) -> NurbsSurface:
    """The one surface that a name, a file or standard input means."""
    found = read_surfaces(name)
    if len(found) > 1:
        raise CurveFileError(
            f"{counted(len(found), 'surface')}, where one is expected",
            where=name,
            remedy=f"take one: {command_name()} convert {name} one.json --surfaces --only NAME, of "
            f"{', '.join(surface.name for surface in found[:8])}{', …' if len(found) > 8 else ''}",
        )
    return found[0]


def _one(name: str, given: bytes | None) -> Sequence[NurbsSurface]:
    return [_loaded(name, given)]


def _reported(reading: Reading, name: str, why: str = "without --surfaces these are taken") -> Sequence[NurbsSurface]:
    """The surfaces of a file; what else is in it is named on standard error."""
    if reading.curves:
        leave_out()
        sys.stderr.write(f"skipped: {name}: {counted(len(reading.curves), 'curve')}: {why}\n")
    tell_skipped(reading, name, surfaces=False)
    tell_notes(reading, curves=False)
    return reading.surfaces


def _with_surfaces(name: str, given: bytes | None, requested: bool) -> Reading | None:
    """What is read of a file whose surfaces are meant; None for any other."""
    from exactspline.interchange.files import holds_surfaces, read

    place = given if name == "-" else name
    if place is None or (name != "-" and not Path(name).is_file()) or not holds_surfaces(place):
        return None
    try:
        reading = read(place)
    except ExactSplineError:
        return None
    return reading if reading.surfaces and (requested or not reading.curves) else None


def inspect_surfaces(out: Output, names: dict[str, Surfaces], digits: int, plot: str) -> None:
    """Print what surfaces have; a bad one is reported and the rest goes on."""
    read, good = each_read(names, lambda name: names[name]())
    surfaces = [surface for several in read for surface in several]
    if plot and len(surfaces) > 1:
        raise OptionsError("--plot and several surfaces", remedy="draw them one by one")
    inspected, all_good = each_read(surfaces, lambda surface: _inspected(surface, digits, plot))
    good = good and all_good
    out.give(
        "inspect surface",
        [{"key": str(data["surface"])} | data for data, _ in inspected],
        [sheet for _, sheet in inspected],
        by="surface",
    )
    if not good:
        raise Exit(2)


def _loaded(name: str, given: bytes | None) -> NurbsSurface:
    """The surface that a name, a file or standard input means."""
    from exactspline.interchange.curve_files import surface_from_text
    from exactspline.interchange.examples import load_surface

    if name != "-" or given is None:
        return load_surface(name)
    try:
        return surface_from_text(given.decode(errors="replace"), "stdin")
    except ExactSplineError as error:
        raise error.at("standard input") from None


def _inspected(surface: NurbsSurface, digits: int, plot: str) -> tuple[dict[str, object], Sheet]:
    """What a surface has as data and as a table, and the picture where one is requested."""
    from exactspline.display.surface_data import map_data, map_sheet, surface_inspection_data, surface_sheet
    from exactspline.geometry.planar_maps import jacobian_sign
    from exactspline.geometry.surface.inspection import inspect_surface

    if surface.dimension == 2:
        if plot:
            raise OptionsError("--plot and a map of the plane", remedy="surfaces in space are drawn")
        sign = jacobian_sign(surface)
        return map_data(sign, digits), map_sheet(sign)
    found = inspect_surface(surface)
    if plot:
        _drawn(found, plot)
    return surface_inspection_data(found, digits), surface_sheet(found, digits)


def _drawn(found: SurfaceInspection, plot: str) -> None:
    """A picture, or a page that turns."""
    if plot.lower().endswith(".html"):
        from exactspline.atomic_write import write_text
        from exactspline.display.plot.canvas import PlotError
        from exactspline.display.plot.html import page_of
        from exactspline.display.plot.turning_surface import inspected_scene

        scene = inspected_scene(found)
        write_text(plot, page_of([scene], scene["title"]), PlotError)
        tell_written(plot)
        return
    from exactspline.display.plot.canvas import save
    from exactspline.display.plot.patches import surface_figure

    save(surface_figure(found), plot)
    tell_written(plot)
