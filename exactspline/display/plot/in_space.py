"""The table of pictures in space, each drawn by a function that is loaded when it is asked for."""

from __future__ import annotations

from typing import Any

from exactspline.hooks import named

HOMES = {
    "surface": "exactspline.extras.pictures3d.surfaces:plot_surface",
    "ruled surface": "exactspline.extras.pictures3d.surfaces:plot_ruled_surface",
    "bisector": "exactspline.extras.pictures3d.surfaces:plot_bisector",
    "inspected surface": "exactspline.extras.pictures3d.patches:surface_figure",
    "page of an inspected surface": "exactspline.extras.pictures3d.turning_surface:inspected_page",
    "page": "exactspline.extras.pictures3d.html:turning_page",
    "bisector of plane curves": "exactspline.extras.pictures3d.bisectors:plot_plane_bisector",
    "bisector of curves": "exactspline.extras.pictures3d.bisectors:plot_curve_bisector",
    "bisector of a point": "exactspline.extras.pictures3d.bisectors:plot_point_bisector",
    "trimmed bisector": "exactspline.extras.pictures3d.bisectors:plot_trimmed_bisector",
}


def picture(what: str, *of: object, **how: object) -> Any:
    """Draw a picture of the table."""
    return named(HOMES[what])(*of, **how)
