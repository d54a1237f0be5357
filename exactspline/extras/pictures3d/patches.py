"""A surface coloured by the sign of its curvature, with parabolic curves and umbilics; and the same in the plane of its
parameters, with lines of curvature.

Regions, curves and points are certified; colours between them and lines of curvature are computed in floats. The lines
are traced by steps along the principal directions, evenly spaced (Jobard and Lefer, Creating evenly-spaced streamlines
of arbitrary density, 1997).
"""

from __future__ import annotations

from bisect import bisect
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import product
from math import atan2, comb, cos, dist, hypot, inf, sin
from typing import TYPE_CHECKING, Any, NamedTuple

from exactspline.bivariate.across_borders import Place
from exactspline.bivariate.borders import Patch
from exactspline.bivariate.signs import Point
from exactspline.display.plot.canvas import BLACK, GREEN, GREY, PAGE, VERMILLION, draw, library, new_figure
from exactspline.errors import as_instance, counted
from exactspline.extras.pictures3d.surfaces import frame_faces, shaded, show_faces
from exactspline.formulas.surfaces.by_forms import area_of_forms, minimality_of_forms, parabolic_of_forms
from exactspline.geometry.analysis.surfaces import PatchInspection, PatchKind, SurfaceInspection
from exactspline.geometry.surfaces.forms import SurfaceForms
from exactspline.language.arguments import Operands
from exactspline.language.vector import Vector, cross, dot, norm2
from exactspline.numbers.exact import mpq
from exactspline.numbers.once import cached_property
from exactspline.roots.of_polynomials import enclosing
from exactspline.splines.surface import Along, NurbsSurface
from exactspline.splines.tensor import TensorSpline

if TYPE_CHECKING:
    import numpy
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    Floats = NDArray[numpy.float64]

#: Lists of tuples of numbers, row by row of a grid.
Rows = list[list[list[float]]]
#: Distance between lines and length of a step, as fractions of the size of the surface; the largest number of steps of
#: a line.
APART, STEP, MOST = 1 / 26, 1 / 400, 1200
#: The smallest number of steps of a line.
FEWEST = 12
#: A line ends where it comes nearer to another one than this fraction of their distance.
NEAR = 0.55


class _Lists(NamedTuple):
    us: list[float]
    vs: list[float]
    points: Rows
    directions: tuple[Rows, Rows]


@dataclass
class Samples:
    """A surface on a grid: parameters and points patch by patch, the sign of K, and principal directions over the
    whole rectangle.
    """

    surface: NurbsSurface
    us: list[Floats]
    vs: list[Floats]
    points: dict[Patch, Floats]
    signs: dict[Patch, Floats]
    #: The grid lines of the rectangle, the points on it, and the two principal directions as doubled angles.
    grid: tuple[Floats, Floats]
    whole: Floats
    directions: tuple[Floats, Floats]

    @classmethod
    def of(cls, surface: NurbsSurface, grid: int, least: int) -> Samples:
        """The samples of a surface: about this many in each direction, at least this many per patch."""
        np: Any = library("numpy")
        counts = [max(least, -(-grid // n)) for n in surface.patches]
        ts = [
            [np.linspace(float(a), float(b), count + 1) for a, b in zip(mesh.breaks, mesh.breaks[1:], strict=False)]
            for mesh, count in zip(surface.meshes, counts, strict=True)
        ]
        forms = SurfaceForms(surface)
        jets = {key: [f.partial(*key) for f in (*surface.p, surface.w)] for key in _ORDERS}
        points, signs, derivatives = {}, {}, {}
        for patch in forms.patches:
            at = [np.linspace(0, 1, count + 1) for count in counts]
            values = {key: [_on_grid(f, patch, *at) for f in own] for key, own in jets.items()}
            derivatives[patch] = _quotients(np, values)
            points[patch] = derivatives[patch][0, 0]
            signs[patch] = _on_grid(forms.parabolic, patch, *at)
        rows, columns = surface.patches

        def assembled(which: Any) -> Any:
            """Arrays of the patches joined over the whole rectangle; on common borders the later patch's values."""
            lines = [
                np.concatenate([which((i, j))[:, : None if j == columns - 1 else -1] for j in range(columns)], axis=1)
                for i in range(rows)
            ]
            return np.concatenate([line[: None if i == rows - 1 else -1] for i, line in enumerate(lines)], axis=0)

        whole = {key: assembled(lambda patch, key=key: derivatives[patch][key]) for key in _ORDERS}
        us, vs = (np.concatenate([*[t[:-1] for t in own[:-1]], own[-1]]) for own in ts)
        return cls(surface, ts[0], ts[1], points, signs, (us, vs), whole[0, 0], _principal(np, whole))

    @cached_property
    def _lists(self) -> _Lists:
        """The grid lines, the points and the directions as lists, since single numbers are read faster from lists."""
        us, vs, points, first, second = (each.tolist() for each in (*self.grid, self.whole, *self.directions))
        return _Lists(us, vs, points, (first, second))

    def lifted(self, line: Floats) -> list[list[float]]:
        """Points on the surface for points of the rectangle."""
        return [self.point(u, v) for u, v in line.tolist()]

    def point(self, u: float, v: float) -> list[float]:
        """The point on the surface for a point of the rectangle."""
        return _between(self._lists.points, *self._cell(u, v))

    def _cell(self, u: float, v: float) -> tuple[int, int, float, float]:
        """The grid cell that contains a point, and the point's position in it."""
        us, vs = self._lists.us, self._lists.vs
        i, j = (min(max(bisect(own, t) - 1, 0), len(own) - 2) for t, own in ((u, us), (v, vs)))
        return i, j, (u - us[i]) / (us[i + 1] - us[i]), (v - vs[j]) / (vs[j + 1] - vs[j])

    def direction(self, family: int, u: float, v: float) -> tuple[float, float]:
        """A principal direction in the parameters, of length 1 or zero."""
        x, y = _between(self._lists.directions[family], *self._cell(u, v))
        if x * x + y * y < 1e-4:
            return 0.0, 0.0
        angle = atan2(y, x) / 2
        return cos(angle), sin(angle)

    def velocity(self, u: float, v: float, du: float, dv: float) -> float:
        """The approximate length on the surface of a step of the parameters."""
        e = 1e-3
        us, vs, p, _ = self._lists
        (a, b), (c, d) = ((own[0], own[-1]) for own in (us, vs))
        u, v = min(max(u, a), b - e * (b - a)), min(max(v, c), d - e * (d - c))
        i, j, _, _ = self._cell(u, v)
        along_u, along_v = du / (us[i + 1] - us[i]), dv / (vs[j + 1] - vs[j])
        corners = zip(p[i][j], p[i + 1][j], p[i][j + 1], strict=True)
        return hypot(*((x - o) * along_u + (y - o) * along_v for o, x, y in corners))


_ORDERS = ((0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2))


def _on_grid(f: TensorSpline, patch: Patch, xs: Any, ys: Any) -> Any:
    """The values of a spline on a grid of one patch."""
    np: Any = library("numpy")
    if min(f.degree) < 0:
        return np.zeros((len(xs), len(ys)))
    net = np.array([[float(x) for x in row] for row in f.bezier_net(*patch)])
    left, right = (_bernstein(np, n, ts) for n, ts in zip(f.degree, (xs, ys), strict=True))
    return left @ net @ right.T


def _bernstein(np: Any, n: int, ts: Any) -> Any:
    return np.stack([comb(n, k) * ts**k * (1 - ts) ** (n - k) for k in range(n + 1)], axis=1)


def _quotients(np: Any, values: dict[tuple[int, int], list[Any]]) -> dict[tuple[int, int], Any]:
    """The derivatives of p/w to the second order, by Leibniz' rule."""
    derivatives: dict[tuple[int, int], Any] = {}
    w = {key: own[-1] for key, own in values.items()}
    for i, j in _ORDERS:
        own = np.stack(values[i, j][:-1], axis=-1)
        for (a, b), earlier in derivatives.items():
            if a <= i and b <= j:
                own = own - (comb(i, a) * comb(j, b) * w[i - a, j - b])[..., None] * earlier
        derivatives[i, j] = own / w[0, 0][..., None]
    return derivatives


def _principal(np: Any, s: dict[tuple[int, int], Any]) -> tuple[Any, Any]:
    """The two principal directions as doubled angles of (du, dv); zero where they are not determined."""
    by_u, by_v, *bent = (Vector(*np.moveaxis(s[key], -1, 0)) for key in ((1, 0), (0, 1), (2, 0), (1, 1), (0, 2)))
    n = cross(by_u, by_v)
    length = np.sqrt(norm2(n))
    n = n.mapped(lambda x: x / np.where(length > 0, length, 1))
    e, f, g, ll, m, k = (dot(a, b) for a, b in ((by_u, by_u), (by_u, by_v), (by_v, by_v), *((b, n) for b in bent)))
    forms = Operands(E=e, F=f, G=g, L=ll, M=m, N=k)
    area = area_of_forms(forms)
    area = np.where(area > 0, area, 1)
    mean, gauss = minimality_of_forms(forms) / (2 * area), parabolic_of_forms(forms) / area
    gap = np.sqrt(np.maximum(mean * mean - gauss, 0))
    families = []
    for kappa in (mean + gap, mean - gap):
        # (L − κE) du + (M − κF) dv = 0 = (M − κF) du + (N − κG) dv: the larger row determines the direction
        first, second, third = ll - kappa * e, m - kappa * f, k - kappa * g
        by_first = np.abs(first) >= np.abs(third)
        du, dv = np.where(by_first, -second, -third), np.where(by_first, first, second)
        angle = 2 * np.arctan2(dv, du)
        sure = (gap > 1e-9 * (np.abs(mean) + gap)) & (length > 0)
        families.append(np.stack([np.cos(angle) * sure, np.sin(angle) * sure], axis=-1))
    return families[0], families[1]


def _between(rows: Rows, i: int, j: int, x: float, y: float) -> list[float]:
    """Bilinear interpolation in a cell."""
    corners = zip(rows[i][j], rows[i + 1][j], rows[i][j + 1], rows[i + 1][j + 1], strict=True)
    return [(a * (1 - x) + b * x) * (1 - y) + (c * (1 - x) + d * x) * y for a, b, c, d in corners]


#: The names of the two families, and their colours.
FAMILIES = {"lines of the larger curvature": GREY, "lines of the smaller curvature": "#ffffff"}


def lines_of_curvature(samples: Samples) -> tuple[list[Floats], list[Floats]]:
    """The lines of both families (of the larger and of the smaller principal curvature, for the normal S_u × S_v) as
    points of the rectangle.
    """
    return _family(samples, 0), _family(samples, 1)


def _family(samples: Samples, family: int) -> list[Floats]:
    """Lines of one family, about equally far apart on the surface."""
    np: Any = library("numpy")
    flat = samples.whole.reshape(-1, 3)
    size = float(np.linalg.norm(flat.max(axis=0) - flat.min(axis=0)))
    us, vs, *_ = samples._lists
    seeds = [(us[i], vs[j]) for j in range(1, len(vs) - 1, 3) for i in range(1, len(us) - 1, 3)]
    # seeds from the middle outwards
    middle = (us[0] + us[-1]) / 2, (vs[0] + vs[-1]) / 2
    seeds.sort(
        key=lambda p: (p[0] - middle[0]) ** 2 / (us[-1] - us[0]) ** 2 + (p[1] - middle[1]) ** 2 / (vs[-1] - vs[0]) ** 2
    )
    near = _Neighbours(size * APART)
    lines = []
    for seed in seeds:
        if near.distance(samples.point(*seed)) < size * APART:
            continue
        first, closed = _half(samples, family, seed, 1.0, near, size)
        second, _ = ([], True) if closed else _half(samples, family, seed, -1.0, near, size)
        line = np.array([*second[::-1], seed, *first])
        if len(line) > FEWEST:
            lines.append(line)
            near.add(samples.lifted(line))
    return lines


def _half(
    samples: Samples, family: int, seed: tuple[float, float], sign: float, near: _Neighbours, size: float
) -> tuple[list[tuple[float, float]], bool]:
    """A line from a seed to one side, until it leaves the rectangle, comes near another line, or returns to the seed:
    then it is closed.
    """
    (a, b), (c, d) = ((own[0], own[-1]) for own in samples._lists[:2])
    u, v = seed
    du, dv = samples.direction(family, u, v)
    last = (du * sign, dv * sign)
    points: list[tuple[float, float]] = []
    start = samples.point(u, v)
    for step in range(MOST):
        speed = samples.velocity(u, v, *last)
        length = size * STEP / speed if speed > 0 else 0.0
        length = min(length, (b - a) / 40, (d - c) / 40)
        middle = _turned(samples.direction(family, u + last[0] * length / 2, v + last[1] * length / 2), last)
        u, v = u + middle[0] * length, v + middle[1] * length
        if middle == (0.0, 0.0) or not (a <= u <= b and c <= v <= d):
            break
        points.append((u, v))
        point = samples.point(u, v)
        if step > FEWEST and dist(point, start) < size * STEP:
            return [*points, seed], True
        if step % 4 == 3 and near.distance(point) < size * APART * NEAR:
            break
        last = _turned(samples.direction(family, u, v), middle)
        if last == (0.0, 0.0):
            break
    return points, False


def _turned(direction: tuple[float, float], last: tuple[float, float]) -> tuple[float, float]:
    """A direction or its opposite, whichever continues the line."""
    forward = direction[0] * last[0] + direction[1] * last[1] >= 0
    return direction if forward else (-direction[0], -direction[1])


class _Neighbours:
    """Points in space, indexed by cells of one size."""

    def __init__(self, size: float) -> None:
        self.size = size
        self.cells: dict[tuple[int, ...], list[list[float]]] = {}

    def _key(self, point: list[float]) -> tuple[int, ...]:
        return tuple(int(x // self.size) for x in point)

    def add(self, points: Iterable[list[float]]) -> None:
        """Keep points."""
        for point in points:
            self.cells.setdefault(self._key(point), []).append(point)

    def distance(self, point: list[float]) -> float:
        """The distance to the nearest point, if that is within one cell; otherwise infinite."""
        cells = product(*((i - 1, i, i + 1) for i in self._key(point)))
        return min((dist(point, other) for cell in cells for other in self.cells.get(cell, ())), default=inf)


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
