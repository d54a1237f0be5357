"""The file formats, one module each. To add a format, write a module with a `FORMAT` and add its name to this list.

Files are recognized by content; the formats are tried in the order of this list.
"""

from __future__ import annotations

from exactspline.interchange import own_json
from exactspline.interchange.format import Format
from exactspline.interchange.formats import (
    brep,
    control_points,
    dxf,
    fonts,
    g2,
    geomdl_json,
    gismo,
    glif,
    iges,
    irit,
    rhino,
    step,
    svg,
)

FORMATS: tuple[Format, ...] = tuple(
    module.FORMAT
    for module in (
        rhino, fonts, step, brep, svg, glif, gismo, geomdl_json, own_json, dxf, iges, g2, irit, control_points
    )
)  # fmt: skip
