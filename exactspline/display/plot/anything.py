"""Pictures of all objects that can be drawn."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, cast

from exactspline.display.plot.canvas import axes_for, check_names
from exactspline.display.plot.curves import plot_curve, plot_quotient
from exactspline.display.plot.functions import plot_function
from exactspline.errors import ShapeError
from exactspline.geometry.analysis.surfaces import SurfaceInspection
from exactspline.geometry.bisectors.point_and_curve import PointBisector, RuledPiece
from exactspline.geometry.bisectors.two_curves import CurveBisector
from exactspline.geometry.derived.derive import Derived
from exactspline.hooks import named
from exactspline.interchange.records import Reading
from exactspline.language.rational import Rational
from exactspline.language.ruled import RuledSurface
from exactspline.language.vector import Vector
from exactspline.roots.zero_set import ZeroSet
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface
from exactspline.splines.tensor import TensorSpline
from exactspline.splines.type_checks import of_file

if TYPE_CHECKING:
    from matplotlib.axes import Axes


# ---- the table of pictures in space


HOMES = {
    "surface": "exactspline.extras.pictures3d.surfaces:plot_surface",
    "ruled surface": "exactspline.extras.pictures3d.surfaces:plot_ruled_surface",
    "bisector": "exactspline.extras.pictures3d.surfaces:plot_bisector",
    "inspected surface": "exactspline.extras.pictures3d.patches:surface_figure",
    "page of an inspected surface": "exactspline.extras.pictures3d.html:inspected_page",
    "page": "exactspline.extras.pictures3d.html:turning_page",
    "bisector of plane curves": "exactspline.extras.pictures3d.bisectors:plot_plane_bisector",
    "bisector of curves": "exactspline.extras.pictures3d.bisectors:plot_curve_bisector",
    "bisector of a point": "exactspline.extras.pictures3d.bisectors:plot_point_bisector",
    "trimmed bisector": "exactspline.extras.pictures3d.bisectors:plot_trimmed_bisector",
}


def picture(what: str, *of: object, **how: object) -> Any:
    """Draw the picture that has this name in the table."""
    return named(HOMES[what])(*of, **how)


def plot(*things: object, ax: Axes | None = None, **how: object) -> Axes:
    """Draw one or several objects (curves, functions, zero sets, derived curves, surfaces, bisectors) into matplotlib's
    axes, by default those of a new figure, and return the axes. The analysis of a surface is drawn in a figure of its
    own. `how` is passed to the function of `exactspline.display.plot` for this type of object.

    >>> from exactspline import BSpline, example, zeros
    >>> f = BSpline.bezier([1, -1, 1])
    >>> [plot(x).get_legend().get_texts()[-1].get_text() for x in (example("circle"), f, zeros(f))]
    ['knots', 'graph', '1 root']

    Raises `PlotError` without matplotlib and for unknown options, `ShapeError` for other objects.
    """
    for thing in _listed(things):
        ax = _drawn(of_file(thing), ax, how)
    return axes_for(None) if ax is None else ax


def _listed(things: Iterable[object]) -> list[object]:
    """The given things, with lists and the contents of files that were read replaced by their elements."""
    nested = [thing.curves if isinstance(thing, Reading) else thing for thing in things]
    return [one for thing in nested for one in (thing if isinstance(thing, list | tuple) else [thing])]


def _drawn(thing: object, ax: Axes | None, how: dict[str, object]) -> Axes:
    """Draw one thing into axes or a new figure."""
    if isinstance(thing, SurfaceInspection) and ax is None and not how:
        return cast("Axes", picture("inspected surface", thing).axes[0])
    if isinstance(thing, CurveBisector):
        of_two: Callable[..., Axes] = named(HOMES["bisector"])
        check_names(of_two, how)
        return of_two(*thing.curves, ax, **how)
    if isinstance(thing, PointBisector | Derived):
        for piece in thing.pieces:
            ax = _drawn(piece.surface if isinstance(piece, RuledPiece) else piece.value, ax, how)
        return axes_for(None) if ax is None else ax
    draw, shown = _way_to_draw(thing)
    check_names(draw, how)
    if isinstance(thing, ZeroSet):
        how = {"roots": thing} | how
    return draw(shown, ax=ax, **how)


def _way_to_draw(thing: object) -> tuple[Callable[..., Axes], object]:
    """The function that draws things of this type, and the arguments for it."""
    if isinstance(thing, Nurbs):
        return plot_curve, thing
    if isinstance(thing, BSpline):
        return plot_function, thing
    if isinstance(thing, ZeroSet):
        return plot_function, thing.spline
    if isinstance(thing, RuledSurface):
        return named(HOMES["ruled surface"]), thing
    if isinstance(thing, NurbsSurface):
        return named(HOMES["surface"]), thing.S
    parts = thing.numerator if isinstance(thing, Rational) else thing
    if isinstance(parts, Vector):
        in_two = any(isinstance(part, TensorSpline) for part in parts)
        return (named(HOMES["surface"]) if in_two else plot_quotient), thing
    raise ShapeError(
        f"a {type(thing).__name__} cannot be drawn",
        remedy="draw a curve, a spline, a zero set, a vector or quotient of splines, or a ruled surface",
    )
