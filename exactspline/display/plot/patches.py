"""A surface coloured by the sign of its curvature, with parabolic curves, umbilics and lines of curvature; beside it
the same in the plane of its parameters.

Regions, curves and points are those that were certified; colours between them and lines of curvature are drawn from
floats.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from exactspline.display.plot.canvas import BLACK, GREEN, GREY, PAGE, VERMILLION, draw, library, new_figure
from exactspline.display.plot.curvature_lines import Samples, lines_of_curvature
from exactspline.display.plot.surfaces import shaded
from exactspline.display.plot.visibility import Visibility
from exactspline.errors import as_instance
from exactspline.geometry.surface.inspection import PatchInspection, PatchKind, SurfaceInspection
from exactspline.geometry.surface.places import Place, enclosing
from exactspline.geometry.surface.signs import Point
from exactspline.numbers.exact import mpq
from exactspline.splines.surface import Along

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Colours of elliptic, hyperbolic and flat points.
ELLIPTIC, HYPERBOLIC, FLAT = "#F3C46B", "#7FBFE6", "#D9D9D9"
#: Rows and columns of faces, in all and at least this many per patch.
GRID, LEAST = 72, 6
#: How much of the axes a surface fills, beside the norm of its extents, by which matplotlib scales.
FILLED = 0.93
#: Points of an arc that is drawn.
STEPS = 4


def surface_figure(found: SurfaceInspection) -> Figure:
    """The picture of a surface that was inspected: in space, and its parameters.

    >>> from exactspline import analyse, example
    >>> [ax.name for ax in surface_figure(analyse(example("biquadratic"))).axes]
    ['3d', 'rectilinear']

    Raises `PlotError` without matplotlib.
    """
    remedy = "give what exactspline.inspect_surface returns"
    found = as_instance(found, SurfaceInspection, "an inspection of a surface", remedy)
    figure = new_figure(PAGE, 5)
    grid = figure.add_gridspec(1, 2, width_ratios=(1.35, 1))
    space, plane = figure.add_subplot(grid[0], projection="3d"), figure.add_subplot(grid[1])
    samples = Samples.of(found.surface, GRID, LEAST)
    lines = lines_of_curvature(samples) if has_lines(found) else ([], [])
    _in_space(space, found, samples, lines)
    _in_the_plane(plane, found, samples, lines)
    figure.suptitle(found.surface.name.replace("_", " ") or "surface")
    _legend(figure, found, bool(lines[0]))
    return figure


def has_lines(found: SurfaceInspection) -> bool:
    """Whether lines of curvature are determined on some patch."""
    none = (PatchKind.PLANAR, PatchKind.CURVE, PatchKind.POINT)
    return any(not one.umbilics.everywhere and one.kind not in none for one in found.patches)


# ---- colours


def colour_of(one: PatchInspection, sign: float) -> str:
    """The colour of a face: by what was proved of its patch; where K has both signs, by the sign at its middle."""
    if one.kind in (PatchKind.ELLIPTIC, PatchKind.ELLIPTIC_BUT, PatchKind.SPHERICAL):
        return ELLIPTIC
    if one.kind in (PatchKind.HYPERBOLIC, PatchKind.HYPERBOLIC_BUT):
        return HYPERBOLIC
    if one.kind in (PatchKind.MIXED, PatchKind.UNDECIDED):
        return ELLIPTIC if sign > 0 else HYPERBOLIC
    return FLAT


def _in_space(ax: Any, found: SurfaceInspection, samples: Samples, lines: Any) -> None:
    """The shaded surface with what is on it."""
    np, to_rgb = library("numpy"), library("matplotlib.colors").to_rgb
    faces, shades = [], []
    for one in found.patches:
        points, signs = samples.points[one.patch], samples.signs[one.patch]
        for i in range(points.shape[0] - 1):
            for j in range(points.shape[1] - 1):
                corner = [tuple(points[k, h]) for k, h in ((i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j))]
                faces.append(corner)
                middle = signs[i : i + 2, j : j + 2].mean()
                shades.append(shaded(corner, to_rgb(colour_of(one, middle))))
    collection = library("mpl_toolkits.mplot3d.art3d").Poly3DCollection
    ax.add_collection3d(
        collection(faces, facecolors=shades, edgecolors=shades, linewidths=0.2, rasterized=True, zorder=1)
    )
    ax.computed_zorder = False
    ax.set_proj_type("ortho")
    seen = Visibility(samples.points.values(), ax.elev, ax.azim)
    for family, color in zip(lines, (GREY, "white"), strict=True):
        for line in family:
            for run in seen.runs(samples.lifted(line)):
                ax.plot(*run.T, color=color, linewidth=0.5, zorder=2)
    surface = found.surface
    for curve in parabolic_runs(found):
        for run in seen.runs([[float(x) for x in surface(*p)] for p in curve]):
            ax.plot(*run.T, color=BLACK, linewidth=1.6, zorder=3)
    for places, color, marker in ((umbilic_spots(found), VERMILLION, "o"), (singular_spots(found), GREEN, "s")):
        spots = [surface(*p) for p in places]
        dots = [p for p in spots if seen.of([[float(x) for x in p]])[0]]
        _dots(ax, dots, color, marker)
    lows, highs = (pick([p for face in faces for p in face], axis=0) for pick in (np.min, np.max))
    # a surface that is a point has no extent: a box around it
    extent = np.maximum(highs - lows, (highs - lows).max() / 1000 or 1)
    for axis, low, length in zip("xyz", lows, extent, strict=True):
        getattr(ax, f"set_{axis}lim")(low, low + length)
    ax.set_box_aspect(extent, zoom=FILLED * float(np.linalg.norm(extent)) / (seen.seen or 1))
    ax.set_axis_off()


def _in_the_plane(ax: Axes, found: SurfaceInspection, samples: Samples, lines: Any) -> None:
    """The regions of the parameters."""
    for one in found.patches:
        us, vs, signs = samples.us[one.patch[0]], samples.vs[one.patch[1]], samples.signs[one.patch]
        if one.kind in (PatchKind.MIXED, PatchKind.UNDECIDED):
            largest = abs(signs).max() or 1.0
            ax.contourf(us, vs, signs.T / largest, levels=[-2, 0, 2], colors=[HYPERBOLIC, ELLIPTIC], zorder=1)
        else:
            ax.fill_between([us[0], us[-1]], vs[0], vs[-1], color=colour_of(one, 1.0), linewidth=0, zorder=1)
    for family, color in zip(lines, (GREY, "white"), strict=True):
        for line in family:
            ax.plot(line[:, 0], line[:, 1], color=color, linewidth=0.5, zorder=2)
    for k, mesh in enumerate(found.surface.meshes):
        for t in mesh.breaks[1:-1]:
            (ax.axvline if k == 0 else ax.axhline)(float(t), color="white", linewidth=0.8, linestyle=":", zorder=2.5)
    for run in parabolic_runs(found):
        draw(ax, run, color=BLACK, linewidth=1.6, zorder=3)
    _dots(ax, list(umbilic_spots(found)), VERMILLION, "o")
    _dots(ax, list(singular_spots(found)), GREEN, "s")
    (a, b), (c, d) = found.surface.domain
    ax.set_xlim(float(a), float(b))
    ax.set_ylim(float(c), float(d))
    ax.set_xlabel("u")
    ax.set_ylabel("v")


# ---- what was certified


def parabolic_runs(found: SurfaceInspection) -> Iterator[list[Point]]:
    """All parabolic curves, in the parameters of the surface."""
    yield from _curves(found)
    yield from _lines(found)


def _curves(found: SurfaceInspection) -> Iterator[list[Point]]:
    """The parabolic curves inside patches, arc by arc."""
    for one in found.patches:
        if one.curve is not None:
            for part in one.parabolic:
                for arc in part.arcs:
                    yield [_placed(point, one) for point in one.curve.points(arc, STEPS)]


def _lines(found: SurfaceInspection) -> Iterator[list[Point]]:
    """Parabolic isoparametric lines."""
    for line in found.parabolic_lines:
        at = enclosing(line.value, 8).middle
        ts = [line.interval.at(mpq(k, GRID)) for k in range(GRID + 1)]
        yield [(t, at) if line.along is Along.U else (at, t) for t in ts]


def umbilic_spots(found: SurfaceInspection) -> Iterator[Point]:
    """The umbilics, in the parameters of the surface."""
    return (_middle(umbilic.place) for umbilic in found.umbilics)


def singular_spots(found: SurfaceInspection) -> Iterator[Point]:
    """The singular points, in the parameters of the surface."""
    return map(_middle, found.singular_points)


def _middle(place: Place) -> Point:
    return place.box(8).middle


def _placed(point: Point, one: PatchInspection) -> Point:
    x, y = (min(max(t, mpq(0)), mpq(1)) for t in point)
    return one.sides.at(x, y)


def _dots(ax: Any, points: list[Any], color: str, marker: str) -> None:
    if points:
        draw(ax, points, color=color, marker=marker, linestyle="", markersize=6, markeredgecolor="white", zorder=4)


def _legend(figure: Figure, found: SurfaceInspection, lines: bool) -> None:
    """What the colours and marks mean: those that occur."""
    patch, line = library("matplotlib.patches").Patch, library("matplotlib.lines").Line2D
    kinds = set(found.kinds)
    shown = [
        (
            bool(kinds & {PatchKind.ELLIPTIC, PatchKind.ELLIPTIC_BUT, PatchKind.SPHERICAL, PatchKind.MIXED}),
            "K > 0",
            ELLIPTIC,
        ),
        (bool(kinds & {PatchKind.HYPERBOLIC, PatchKind.HYPERBOLIC_BUT, PatchKind.MIXED}), "K < 0", HYPERBOLIC),
        (bool(kinds & {PatchKind.PLANAR, PatchKind.DEVELOPABLE}), "K = 0", FLAT),
    ]
    handles: list[Any] = [patch(facecolor=color, label=label) for there, label, color in shown if there]
    if next(_curves(found), None) or found.parabolic_lines:
        handles.append(line([], [], color=BLACK, linewidth=1.6, label="parabolic curve"))
    if lines:
        handles.append(line([], [], color=GREY, linewidth=0.7, label="lines of curvature"))
    if found.umbilics.points:
        count = len(found.umbilics)
        label = f"{count} umbilic{'s' if count > 1 else ''}"
        handles.append(line([], [], color=VERMILLION, marker="o", linestyle="", label=label))
    if found.singular_points.points:
        handles.append(line([], [], color=GREEN, marker="s", linestyle="", label="singular point"))
    figure.legend(handles=handles, loc="outside lower center", ncols=len(handles), frameon=False, fontsize="small")
