"""A surface coloured by the sign of its curvature, with parabolic curves and umbilics; and the same in the plane of its
parameters, with lines of curvature.

Regions, curves and points are certified; colours between them and lines of curvature are computed in floats.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from typing import TYPE_CHECKING, Any

from exactspline.bivariate.across_borders import Place
from exactspline.bivariate.signs import Point
from exactspline.display.plot.canvas import BLACK, GREEN, PAGE, VERMILLION, draw, library, new_figure
from exactspline.errors import as_instance, counted
from exactspline.extras.pictures3d.curvature_lines import FAMILIES, Samples, lines_of_curvature
from exactspline.extras.pictures3d.surfaces import frame_faces, shaded, show_faces
from exactspline.geometry.analysis.surfaces import PatchInspection, PatchKind, SurfaceInspection
from exactspline.numbers.exact import mpq
from exactspline.roots.of_polynomials import enclosing
from exactspline.splines.surface import Along

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Colours of elliptic, hyperbolic and flat points.
ELLIPTIC, HYPERBOLIC, FLAT = "#F3C46B", "#7FBFE6", "#D9D9D9"
#: Rows and columns of faces, in total and at least per patch.
GRID, LEAST = 72, 6
#: How much larger a surface is drawn without its axes.
ZOOM = 1.25
#: The number of points of a drawn arc.
STEPS = 4


def surface_figure(inspection: SurfaceInspection) -> Figure:
    """Draw an inspected surface in space and in the plane of its parameters, and return the figure.

    >>> from exactspline import analyse, example
    >>> [ax.name for ax in surface_figure(analyse(example("biquadratic"))).axes]
    ['3d', 'rectilinear']

    Raises `PlotError` without matplotlib.
    """
    remedy = "give the result of exactspline.inspect_surface"
    inspection = as_instance(inspection, SurfaceInspection, "an inspection of a surface", remedy)
    figure = new_figure(PAGE, 5)
    grid = figure.add_gridspec(1, 2, width_ratios=(1.35, 1))
    space, plane = figure.add_subplot(grid[0], projection="3d"), figure.add_subplot(grid[1])
    samples = Samples.of(inspection.surface, GRID, LEAST)
    lines = lines_of_curvature(samples) if has_lines(inspection) else ([], [])
    _in_space(space, inspection, samples)
    _in_the_plane(plane, inspection, samples, lines)
    figure.suptitle(inspection.surface.name.replace("_", " ") or "surface")
    _legend(figure, inspection, bool(lines[0]))
    return figure


def has_lines(inspection: SurfaceInspection) -> bool:
    """Whether lines of curvature are determined on some patch."""
    none = (PatchKind.PLANAR, PatchKind.CURVE, PatchKind.POINT)
    return any(not one.umbilics.everywhere and one.kind not in none for one in inspection.patches)


# ---- colours


def colour_of(one: PatchInspection, sign: float) -> str:
    """The colour of a face, by the proved sign of K on its patch; if K has both signs there, by the sign at the
    middle.
    """
    if one.kind in (PatchKind.ELLIPTIC, PatchKind.ELLIPTIC_BUT, PatchKind.SPHERICAL):
        return ELLIPTIC
    if one.kind in (PatchKind.HYPERBOLIC, PatchKind.HYPERBOLIC_BUT):
        return HYPERBOLIC
    if one.kind in (PatchKind.MIXED, PatchKind.UNDECIDED):
        return ELLIPTIC if sign > 0 else HYPERBOLIC
    return FLAT


def _in_space(ax: Any, inspection: SurfaceInspection, samples: Samples) -> None:
    """The shaded surface, translucent, with its curves and points, which are seen through it."""
    to_rgb, surface = library("matplotlib.colors").to_rgb, inspection.surface
    faces, shades = [], []
    for one in inspection.patches:
        points, signs = samples.points[one.patch], samples.signs[one.patch]
        for i, j in product(*(range(n - 1) for n in signs.shape)):
            faces.append([tuple(points[k, h]) for k, h in ((i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j))])
            shades.append(shaded(faces[-1], to_rgb(colour_of(one, signs[i : i + 2, j : j + 2].mean()))))
    show_faces(ax, faces, shades)
    for run in parabolic_runs(inspection):
        draw(ax, [surface(*p) for p in run], color=BLACK, linewidth=1.6, zorder=3)
    _dots(ax, [surface(*p) for p in umbilic_spots(inspection)], VERMILLION, "o")
    _dots(ax, [surface(*p) for p in singular_spots(inspection)], GREEN, "s")
    frame_faces(ax, faces)
    ax.set_box_aspect([high - low for low, high in (ax.get_xlim(), ax.get_ylim(), ax.get_zlim())], zoom=ZOOM)
    ax.set_axis_off()


def _in_the_plane(ax: Axes, inspection: SurfaceInspection, samples: Samples, lines: Any) -> None:
    """The regions of the parameters."""
    for one in inspection.patches:
        us, vs, signs = samples.us[one.patch[0]], samples.vs[one.patch[1]], samples.signs[one.patch]
        if one.kind in (PatchKind.MIXED, PatchKind.UNDECIDED):
            largest = abs(signs).max() or 1.0
            ax.contourf(us, vs, signs.T / largest, levels=[-2, 0, 2], colors=[HYPERBOLIC, ELLIPTIC], zorder=1)
        else:
            ax.fill_between([us[0], us[-1]], vs[0], vs[-1], color=colour_of(one, 1.0), linewidth=0, zorder=1)
    for family, color in zip(lines, FAMILIES.values(), strict=True):
        for line in family:
            ax.plot(line[:, 0], line[:, 1], color=color, linewidth=0.5, zorder=2)
    for k, mesh in enumerate(inspection.surface.meshes):
        for t in mesh.breaks[1:-1]:
            (ax.axvline if k == 0 else ax.axhline)(float(t), color="white", linewidth=0.8, linestyle=":", zorder=2.5)
    for run in parabolic_runs(inspection):
        draw(ax, run, color=BLACK, linewidth=1.6, zorder=3)
    _dots(ax, list(umbilic_spots(inspection)), VERMILLION, "o")
    for place, umbilic in zip(umbilic_spots(inspection), inspection.umbilics, strict=True):
        halo = [library("matplotlib.patheffects").withStroke(linewidth=2, foreground="white")]
        beside: dict[str, Any] = {"xytext": (5, 5), "textcoords": "offset points", "annotation_clip": True}
        u, v = map(float, place)
        ax.annotate(umbilic.kind.value, (u, v), fontsize="small", zorder=5, path_effects=halo, **beside)
    _dots(ax, list(singular_spots(inspection)), GREEN, "s")
    (a, b), (c, d) = inspection.surface.domain
    ax.set_xlim(float(a), float(b))
    ax.set_ylim(float(c), float(d))
    ax.set_xlabel("u")
    ax.set_ylabel("v")


# ---- certified curves and points


def parabolic_runs(inspection: SurfaceInspection) -> Iterator[list[Point]]:
    """All parabolic curves, in the parameters of the surface."""
    yield from _curves(inspection)
    yield from _lines(inspection)


def _curves(inspection: SurfaceInspection) -> Iterator[list[Point]]:
    """The parabolic curves inside patches, arc by arc."""
    for one in inspection.patches:
        if one.curve is not None:
            for part in one.parabolic:
                for arc in part.arcs:
                    yield [_placed(point, one) for point in one.curve.points(arc, STEPS)]


def _lines(inspection: SurfaceInspection) -> Iterator[list[Point]]:
    """Parabolic isoparametric lines."""
    for line in inspection.parabolic_lines:
        at = enclosing(line.value, 8).middle
        ts = [line.interval.at(mpq(k, GRID)) for k in range(GRID + 1)]
        yield [(t, at) if line.along is Along.U else (at, t) for t in ts]


def umbilic_spots(inspection: SurfaceInspection) -> Iterator[Point]:
    """The umbilics, in the parameters of the surface."""
    return (_middle(umbilic.place) for umbilic in inspection.umbilics)


def singular_spots(inspection: SurfaceInspection) -> Iterator[Point]:
    """The singular points, in the parameters of the surface."""
    return map(_middle, inspection.singular_points)


def _middle(place: Place) -> Point:
    return place.box(8).middle


def _placed(point: Point, one: PatchInspection) -> Point:
    x, y = (min(max(t, mpq(0)), mpq(1)) for t in point)
    return one.sides.at(x, y)


def _dots(ax: Any, points: list[Any], color: str, marker: str) -> None:
    if points:
        draw(ax, points, color=color, marker=marker, linestyle="", markersize=6, markeredgecolor="white", zorder=4)


def _legend(figure: Figure, inspection: SurfaceInspection, lines: bool) -> None:
    """The meanings of the colours and marks that occur."""
    patch, line = library("matplotlib.patches").Patch, library("matplotlib.lines").Line2D
    kinds = set(inspection.kinds)
    shown = [
        ({PatchKind.ELLIPTIC, PatchKind.ELLIPTIC_BUT, PatchKind.SPHERICAL, PatchKind.MIXED}, "K > 0", ELLIPTIC),
        ({PatchKind.HYPERBOLIC, PatchKind.HYPERBOLIC_BUT, PatchKind.MIXED}, "K < 0", HYPERBOLIC),
        ({PatchKind.PLANAR, PatchKind.DEVELOPABLE}, "K = 0", FLAT),
    ]
    handles: list[Any] = [patch(facecolor=color, label=label) for these, label, color in shown if kinds & these]
    if next(_curves(inspection), None) or inspection.parabolic_lines:
        handles.append(line([], [], color=BLACK, linewidth=1.6, label="parabolic curve"))
    if lines:
        outline = [library("matplotlib.patheffects").withStroke(linewidth=2.6, foreground="#999999")]
        handles += [
            line([], [], color=color, linewidth=1.2, label=label, path_effects=outline)
            for label, color in FAMILIES.items()
        ]
    if inspection.umbilics.points:
        label = counted(len(inspection.umbilics), "umbilic")
        handles.append(line([], [], color=VERMILLION, marker="o", linestyle="", label=label))
    if inspection.singular_points.points:
        handles.append(line([], [], color=GREEN, marker="s", linestyle="", label="singular point"))
    figure.legend(
        handles=handles, loc="outside lower center", ncols=min(len(handles), 4), frameon=False, fontsize="small"
    )
