"""``inspect`` of surfaces: which arguments are surfaces, and what is printed of them."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from exactspline.cli.common import each_read
from exactspline.cli.output import OptionsError, Output
from exactspline.cli.parameters import Exit
from exactspline.errors import ExactSplineError

if TYPE_CHECKING:
    from exactspline.display.sheet import Sheet
    from exactspline.geometry.surface.inspection import SurfaceInspection
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


def inspect_surfaces(out: Output, names: Sequence[str], digits: int, plot: str, given: bytes | None = None) -> None:
    """Print what surfaces have; a bad one is reported and the rest goes on. `given` is what stands for ``-``."""
    if plot and len(names) > 1:
        raise OptionsError("--plot and several surfaces", remedy="draw them one by one")
    inspected, good = each_read(names, lambda name: _inspected(_loaded(name, given), digits, plot))
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
    from exactspline.geometry.surface.inspection import inspect_surface
    from exactspline.geometry.surface.planar_maps import jacobian_sign

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
        return
    from exactspline.display.plot.canvas import save
    from exactspline.display.plot.patches import surface_figure

    save(surface_figure(found), plot)
