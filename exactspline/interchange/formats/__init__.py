"""The table of file formats. Files are recognized by content; the formats are tried in the order of this table.

A format is a module with a `FORMAT`. Formats of exactspline have a row here; `add_format` adds other formats.
"""

from __future__ import annotations

from exactspline.errors import as_instance
from exactspline.hooks import named
from exactspline.interchange.format import Format

#: The modules, loaded when the first file is read or written.
HOMES = (
    "exactspline.extras.cad.rhino",
    "exactspline.interchange.formats.fonts",
    "exactspline.extras.cad.step",
    "exactspline.extras.cad.brep",
    "exactspline.interchange.formats.svg",
    "exactspline.interchange.formats.glif",
    "exactspline.extras.cad.gismo",
    "exactspline.extras.cad.geomdl_json",
    "exactspline.interchange.curve_files",
    "exactspline.extras.cad.dxf",
    "exactspline.extras.cad.iges",
    "exactspline.extras.cad.g2",
    "exactspline.extras.cad.irit",
    "exactspline.interchange.formats.control_points",
)
_known: list[Format] = []
_added: list[Format] = []


def formats() -> tuple[Format, ...]:
    """The formats; added formats come first."""
    if not _known:
        _known.extend(named(f"{home}:FORMAT") for home in HOMES)
    return (*_added, *_known)


def add_format(format: Format) -> None:
    """Add a format: every function and command that is called afterwards reads its files, and writes them if the format
    has a writer. The added format is the first that is asked whether it recognizes a file; it replaces a format of its
    name.
    """
    as_instance(format, Format, "a format", "give a Format of exactspline.interchange.format")
    _added[:] = [format, *(each for each in _added if each.name != format.name)]
