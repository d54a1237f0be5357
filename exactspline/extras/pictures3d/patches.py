"""Pictures of a surface in space and of its parameter plane: coloured by the sign of the curvature, with parabolic
curves, umbilics and lines of curvature.

Regions, curves and points are certified; colours between them and lines of curvature are computed in floats.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, pi, radians, sin
from typing import TYPE_CHECKING, Any

from exactspline.bivariate.across_borders import Place
from exactspline.bivariate.signs import Point
from exactspline.display.plot.canvas import BLACK, GREEN, PAGE, VERMILLION, draw, library, new_figure
from exactspline.errors import as_instance, counted
from exactspline.extras.pictures3d.curvature_lines import FAMILIES, Samples, lines_of_curvature
from exactspline.extras.pictures3d.surfaces import shaded
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
#: The part of the axes that a surface fills, relative to the norm of its extents, by which matplotlib scales.
FILLED = 0.93
#: The number of points of a drawn arc.
STEPS = 4
#: The width of a surface in points, about, the sides of the polygon that is a dot, and the width of every edge.
POINTS, SIDES_OF_DOT, EDGE = 230, 16, 0.2


def surface_figure(inspection: SurfaceInspection) -> Figure:
    """The picture of an inspected surface: in space, and in the plane of its parameters.

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
    _in_space(space, inspection, samples, lines)
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


def _in_space(ax: Any, inspection: SurfaceInspection, samples: Samples, lines: Any) -> None:
    """The shaded surface with its curves and points."""
    np, to_rgb = library("numpy"), library("matplotlib.colors").to_rgb
    faces, shades = [], []
    for one in inspection.patches:
        points, signs = samples.points[one.patch], samples.signs[one.patch]
        for i in range(points.shape[0] - 1):
            for j in range(points.shape[1] - 1):
                corner = [tuple(points[k, h]) for k, h in ((i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j))]
                faces.append(corner)
                middle = signs[i : i + 2, j : j + 2].mean()
                shades.append(shaded(corner, to_rgb(colour_of(one, middle))))
    lows, highs = (pick([p for face in faces for p in face], axis=0) for pick in (np.min, np.max))
    paint = _Paint(ax, faces, float((highs - lows).max()) or 1.0)
    surface = inspection.surface
    marks = [
        (paint.line(samples.lifted(line), 0.5), color)
        for family, color in zip(lines, FAMILIES.values(), strict=True)
        for line in family
    ]
    marks += [(paint.line([surface(*p) for p in run], 1.6), BLACK) for run in parabolic_runs(inspection)]
    marks += [(paint.spot(surface(*p), 6, SIDES_OF_DOT), VERMILLION) for p in umbilic_spots(inspection)]
    marks += [(paint.spot(surface(*p), 6, 4), GREEN) for p in singular_spots(inspection)]
    colors = [*shades, *[to_rgb(color) for polygons, color in marks for _ in polygons]]
    collection = library("mpl_toolkits.mplot3d.art3d").Poly3DCollection
    every = _of_one_length([*faces, *[polygon for polygons, _ in marks for polygon in polygons]])
    ax.add_collection3d(
        collection(every, facecolors=colors, edgecolors=colors, linewidths=EDGE, rasterized=True, zorder=1)
    )
    ax.set_proj_type("ortho")
    # a surface that is a single point has no extent: its box is a box around the point
    extent = np.maximum(highs - lows, (highs - lows).max() / 1000 or 1)
    for axis, low, length in zip("xyz", lows, extent, strict=True):
        getattr(ax, f"set_{axis}lim")(low, low + length)
    ax.set_box_aspect(extent, zoom=FILLED * float(np.linalg.norm(extent)) / paint.seen)
    ax.set_axis_off()


def _of_one_length(polygons: list[Any]) -> list[Any]:
    """The polygons, all with as many vertices as the longest one, by repeating the last vertex: for unequal numbers,
    matplotlib 3.11 computes with uninitialized memory.
    """
    most = max(map(len, polygons))
    return [[*polygon, *[polygon[-1]] * (most - len(polygon))] for polygon in polygons]


class _Paint:
    """Lines and dots on a surface as small polygons that face the viewer and lie a little before it: matplotlib, which
    orders polygons from back to front, then covers them where the surface covers them.
    """

    def __init__(self, ax: Any, faces: Any, size: float) -> None:
        self.np: Any = library("numpy")
        e, a = radians(ax.elev), radians(ax.azim)
        self.view = self.np.array([cos(e) * cos(a), cos(e) * sin(a), sin(e)])
        self.right = self.np.array([-sin(a), cos(a), 0.0])
        self.up = self.np.cross(self.view, self.right)
        corners = self.np.array(faces)
        flat = corners.reshape(-1, 3) @ self.np.array([self.right, self.up]).T
        #: The larger of the surface's width and height as it is seen.
        self.seen = float((flat.max(axis=0) - flat.min(axis=0)).max()) or size
        #: The distance in front of the surface: the size of the faces.
        depths = corners @ self.view
        self.lift = self.view * float((depths.max(axis=1) - depths.min(axis=1)).max())
        #: The length of a point of the picture.
        self.point = self.seen / POINTS

    def line(self, points: Any, width: float) -> list[Any]:
        """A line of a width in points."""
        own = self.np.array([[float(x) for x in p] for p in points])
        across = self.np.cross(own[1:] - own[:-1], self.view)
        length = self.np.linalg.norm(across, axis=1)
        seen = length > 0
        half = across[seen] / length[seen, None] * self.point * (width - EDGE) / 2
        p, q = own[:-1][seen], own[1:][seen]
        return [*(self.np.stack([p - half, p + half, q + half, q - half], axis=1) + self.lift)]

    def spot(self, place: Any, width: float, sides: int) -> list[Any]:
        """A regular polygon around a point."""
        turns = [2 * pi * (k + 0.5) / sides for k in range(sides)]
        ring = self.np.array([cos(t) * self.right + sin(t) * self.up for t in turns]) * self.point * width / 2
        return [self.np.array([float(x) for x in place]) + 2 * self.lift + ring]


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
