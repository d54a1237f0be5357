"""Pictures: curves and functions with their control polygons, roots, features and evolutes. Needs matplotlib (the extra ``plot``).

All is computed exactly; numbers become floats only when matplotlib gets them. A function that draws takes the axes (None: those of a new figure)
and returns them. There is no state, neither pyplot nor a display. Colours after Okabe and Ito (2008), told apart by colour-blind readers too.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from importlib import import_module
from itertools import groupby, pairwise
from math import floor, log10
from pathlib import Path
from typing import Any

from gmpy2 import mpq

from exactspline.errors import ExactSplineError, ShapeError, shown
from exactspline.exact import rational
from exactspline.interrogate import derive
from exactspline.nurbs import Nurbs
from exactspline.spline import BSpline
from exactspline.writing import write_atomically
from exactspline.zeros import zeros

BLACK, GREY, SILVER = "#000000", "#7A7A7A", "#C4C4C4"
BLUE, SKY, GREEN, ORANGE, VERMILLION, PURPLE = "#0072B2", "#56B4E9", "#009E73", "#E69F00", "#D55E00", "#CC79A7"
#: Marker and colour of the roots of one panel after the other.
MARKS = (("D", GREEN), ("s", PURPLE), ("^", ORANGE), ("v", SKY))

#: Samples a segment, and about how many a picture gets in all when there are many segments.
SAMPLES, ALL_SAMPLES = 128, 8192
#: Beyond this, and below its reciprocal, matplotlib loses its way.
LARGEST = mpq(10) ** 100
#: A control polygon so many times higher than its graph, or a graph so many times higher than its median, gets no linear scale.
POLYGON_ABOVE_GRAPH, GRAPH_ABOVE_MEDIAN = 10, 50
#: Into how many pieces a leg of a control polygon is cut where the scale bends it.
BENDS = 64
#: How far an evolute is shown outside the box around its curve, in lengths of the box's longer side.
REACH = mpq(1, 2)

SCALES, SUFFIXES = ("linear", "symlog", "clip"), (".svg", ".png")
Point = tuple[mpq, ...]
Run = list[Point]
Box = tuple[Point, Point]


class PlotError(ExactSplineError):
    """A picture that cannot be drawn or written.

    >>> print(PlotError("cannot be written", where="a.gif", remedy="name it .svg or .png"))
    a.gif: cannot be written; name it .svg or .png
    """


def new_figure(width: float = 7, height: float = 5) -> Any:
    """An empty ``matplotlib.figure.Figure`` of so many inches, belonging to no window; `PlotError` without matplotlib."""
    return _library("matplotlib.figure").Figure(figsize=(width, height), layout="constrained")


def _library(module: str) -> Any:
    try:
        return import_module(module)
    except ImportError:
        raise PlotError("drawing needs matplotlib, which is not installed", remedy="pip install 'exactspline[plot]'") from None


def _axes(ax: Any, dimension: int = 2) -> Any:
    if dimension not in (2, 3):
        raise PlotError(f"a curve in R{dimension}", remedy="curves in the plane and in space can be drawn")
    if ax is None:
        return new_figure().add_subplot(projection="3d" if dimension == 3 else None)
    if (ax.name == "3d") != (dimension == 3):
        raise PlotError(f"axes that do not fit R{dimension}", where="ax", remedy="projection='3d' is for curves in space, and only for them")
    return ax


def _draw(ax: Any, points: Iterable[Sequence[mpq]], style: str = "-", **how: Any) -> None:
    """Exact points as a line or as dots: the one place where they become floats."""
    columns = list(zip(*points, strict=True))
    if any(abs(x) > LARGEST for column in columns for x in column):
        raise PlotError("a number beyond 1e100", remedy="scale the data")
    ax.plot(*[[float(x) for x in column] for column in columns], style, **how)


def _legend(ax: Any) -> None:
    """A legend under the axes, where it hides nothing."""
    handles, labels = ax.get_legend_handles_labels()
    below = _library("matplotlib.transforms").offset_copy(ax.transAxes, fig=ax.figure, y=-36 if ax.get_xlabel() else -20, units="points")
    place = {"loc": "upper center", "bbox_to_anchor": (0.5, 0), "bbox_transform": below}
    ax.legend(handles, labels, ncols=3, fontsize="small", frameon=False, **place)


def _segments(f: Any, breaks: Sequence[mpq]) -> Iterator[list[tuple[mpq, Any]]]:
    """Parameters and exact values segment by segment, both ends included, their limits taken from within."""
    count = max(8, min(SAMPLES, ALL_SAMPLES // (len(breaks) - 1)))
    for a, b in pairwise(breaks):
        inner = [a + (b - a) * mpq(k, count) for k in range(count)]
        yield [*[(t, f(t)) for t in inner], (b, f(b, "left"))]


def _parameter(t: Any, domain: tuple[mpq, mpq]) -> mpq:
    """An exact parameter: the number itself, or the middle of a root's interval, narrow beside the domain."""
    t = getattr(t, "parameter", t)
    if hasattr(t, "refine"):
        low, high = t.refine(20 + int(1 / (domain[1] - domain[0])).bit_length() // 3)
        return (low + high) / 2
    return rational(t)


def _joined(points: Iterable[Point | None]) -> list[Run]:
    """The runs of points between the gaps (None)."""
    return [[p for p in run if p is not None] for there, run in groupby(points, lambda p: p is not None) if there]


def _polygons(knots: Sequence[mpq], degree: int, points: Sequence[Point | None]) -> list[Run]:
    """Control points in runs that are drawn joined: not across a jump, nor where there is no point (None)."""
    spread: list[Point | None] = []
    for i, point in enumerate(points):
        jump = i > 0 and knots[i] == knots[i + degree] and point != points[i - 1]
        spread += [None, point] if jump else [point]
    return _joined(spread)


def _draw_polygons(ax: Any, runs: list[Run], count: int, bends: int = 1) -> None:
    """Legs in light grey, straight in the data (so bent by a scale that is not linear), and the control points."""
    for run in runs:
        legs = [[x + mpq(k, bends) * (y - x) for x, y in zip(p, q, strict=True)] for p, q in pairwise(run) for k in range(bends)]
        _draw(ax, [*legs, run[-1]], color=SILVER, linewidth=1, label="_legs", zorder=2)
        _draw(ax, run, "o", color=BLUE, markersize=5 if count < 100 else 3.5, label="_control points", zorder=2.2)
    nothing: list[list[float]] = [[]] * (3 if ax.name == "3d" else 2)
    ax.plot(*nothing, "o-", color=SILVER, markerfacecolor=BLUE, markeredgecolor=BLUE, markersize=5, label=f"control polygon ({count} points)")


def _name(curve: Nurbs) -> str:
    """The name as matplotlib shows it as it stands: neither dollars read as mathematics nor an underscore that hides it."""
    return curve.name.replace("$", r"\$").lstrip("_") or "curve"


def plot_curve(curve: Nurbs, ax: Any = None, *, control_polygon: bool = True, knots: bool = True, label: str | None = None) -> Any:
    """A curve in the plane or in space: its segments in alternating shades, its control polygon, and its knots as dots on the curve.

    The polygon is interrupted where the curve has a knot of multiplicity degree + 1, and at a control point of weight 0 (a direction, no point).

    >>> from exactspline.curves import example
    >>> ax = plot_curve(example("circle"))
    >>> [text.get_text() for text in ax.get_legend().get_texts()]
    ['control polygon (9 points)', 'circle', 'knots']

    Raises `PlotError` without matplotlib, for a curve neither in the plane nor in space, for axes that do not fit, and for numbers beyond 1e100.
    """
    ax = _axes(ax, curve.dimension)
    if control_polygon:
        points = [point if weight else None for point, weight in zip(curve.control_points, curve.weights, strict=True)]
        _draw_polygons(ax, _polygons(curve.knots.knots, curve.degree, points), len(points))
    for i, samples in enumerate(_segments(curve, curve.breakpoints)):
        shown_as = "_segment" if i else _name(curve) if label is None else label
        _draw(ax, [p for _, p in samples], color=GREY if i % 2 else BLACK, linewidth=2.2, label=shown_as, zorder=3)
    if knots:
        ends = dict.fromkeys(curve(t, side) for t in curve.breakpoints for side in ("left", "right"))
        _draw(ax, ends, "o", color=BLACK, markerfacecolor="white", markersize=3.5, label="knots", zorder=4)
    ax.set_aspect("equal", adjustable="box" if ax.name == "3d" else "datalim")
    _legend(ax)
    return ax


def plot_features(curve: Nurbs, points: Iterable[Any], ax: Any, *, marker: str = "D", label: str = "", color: str = GREEN, size: float = 7) -> Any:
    """Mark parameters on a curve: exact numbers, certified roots, or anything that carries one of them as its `parameter`.

    >>> from exactspline.curves import example
    >>> ax = plot_features(example("circle"), ["1/2", 3], plot_curve(example("circle")), label="marked")
    >>> [float(x) for x in ax.lines[-1].get_xdata()]
    [0.6, 0.0]

    Raises `DomainError` for a parameter outside the domain, otherwise as `plot_curve`.
    """
    ax = _axes(ax, curve.dimension)
    marked = [curve(_parameter(t, curve.domain)) for t in points]
    if marked:
        _draw(ax, marked, marker, color=color, markeredgecolor="white", markersize=size, label=label or "_features", zorder=6)
        _legend(ax)
    return ax


def plot_evolute(curve: Nurbs, ax: Any = None, *, label: str = "evolute", color: str = VERMILLION) -> Any:
    """The evolute of a plane curve, in the pieces in which it exists, none joined across a pole; the axes show what is near the curve.

    >>> from exactspline.curves import example
    >>> ax = plot_evolute(example("ellipse"))
    >>> float(max(x for line in ax.lines for x in line.get_xdata()))
    1.5

    Raises `ShapeError` for a curve in space and for a straight one, otherwise as `plot_curve`.
    """
    pieces = derive("evolute", curve).pieces
    ax = _axes(ax)
    box = _box(point for samples in _segments(curve, curve.breakpoints) for _, point in samples)
    near = _grown(box, REACH)
    runs = [run for piece in pieces for run in _evolute_runs(piece.value, _grown(near, mpq(1)))]
    limits = ax.dataLim.frozen()
    for i, run in enumerate(runs):
        style = "-" if 1000 * _longer_side(_box(run)) > _longer_side(near) else "."
        _draw(ax, run, style, color=color, linewidth=1.5, label="_evolute" if i else label, zorder=2.5)
    ax.dataLim.set(limits)
    ax.update_datalim([[float(x) for x in corner] for corner in _box([*box, *[p for run in runs for p in run if _inside(p, near)]])])
    ax.set_aspect("equal", adjustable="datalim")
    _legend(ax)
    return ax


def _box(points: Iterable[Point]) -> Box:
    """Lower left and upper right corner of the smallest box around the points."""
    columns = list(zip(*points, strict=True))
    return tuple(map(min, columns)), tuple(map(max, columns))


def _longer_side(box: Box) -> mpq:
    return max(high - low for low, high in zip(*box, strict=True))


def _grown(box: Box, by: mpq) -> Box:
    """The box with a margin, a multiple of its longer side, all round."""
    margin = by * _longer_side(box)
    return tuple(x - margin for x in box[0]), tuple(x + margin for x in box[1])


def _inside(point: Point, box: Box) -> bool:
    return all(low <= x <= high for low, x, high in zip(box[0], point, box[1], strict=True))


def _evolute_runs(value: Any, box: Box) -> list[Run]:
    """The points of a vector `Rational` inside a box, in runs that end at knots, at poles, and where the box is left."""
    denominator = value.denominator
    poles = {_parameter(t, denominator.domain) for t in zeros(denominator)}

    def near(t: mpq, side: str = "right") -> Point | None:
        point = value(t, side) if t not in poles and denominator(t, side) else None
        return point if point and _inside(point, box) else None

    parts = _segments(near, sorted({*denominator.breakpoints, *poles}))
    return _joined(point for part in parts for point in [*[p for _, p in part], None])


def greville_abscissae(f: BSpline) -> list[mpq]:
    """The parameters over which the control points of a function are drawn: means of n consecutive knots (of a constant: the middles of segments).

    >>> greville_abscissae(BSpline(2, [0, 0, 0, 1, 2, 2, 2], [0, 1, 0, 1]))
    [mpq(0,1), mpq(1,2), mpq(3,2), mpq(2,1)]
    """
    n, t = f.degree, f.knots.knots
    if n == 0:
        return [(a + b) / 2 for a, b in pairwise(t)]
    return [sum(t[i + 1 : i + n + 1], mpq(0)) / n for i in range(len(f.control_points))]


def plot_function(
    f: BSpline, ax: Any = None, *, control_polygon: bool = True, roots: Any = None, scale: str | None = None, label: str | None = None
) -> Any:
    """The graph of a scalar spline with its control polygon over the Greville abscissae, the zero line, and the roots.

    `roots` are parameters (as in `plot_features`) or a whole `ZeroSet`, whose jumps and stretches are marked too. Where the
    function jumps, graph and polygon have a gap. `scale` is ``linear``, ``symlog`` (linear around zero, logarithmic outside) or ``clip`` (the graph
    fills the axes, the polygon may leave them); by default ``symlog`` where control points or graph are of very different sizes, else ``linear``.
    Where all is beyond 1e100 or below 1e-100, values are divided by a power of ten that the axis names.

    >>> ax = plot_function(BSpline(1, [0, 0, 1, 2, 2], [1, -1, 1]), roots=["1/2", "3/2"])
    >>> [text.get_text() for text in ax.get_legend().get_texts()]
    ['control polygon (3 points)', 'graph', '2 roots']

    Raises `PlotError` without matplotlib and for an unknown scale, `ShapeError` for anything but a `BSpline`.
    """
    if type(f) is not BSpline:
        raise ShapeError(f"the graph of a {type(f).__name__}", remedy="give a BSpline, for a vector one component at a time")
    if scale is not None and scale not in SCALES:
        raise PlotError(f"{shown(scale)} is no scale", where="scale", remedy=f"scales are {', '.join(SCALES)}")
    ax = _axes(ax)
    spread: list[Point | None] = []
    for samples in _segments(f, f.breakpoints):
        spread += samples if not spread or spread[-1] == samples[0] else [None, *samples]
    graph = _joined(spread)
    points = list(zip(greville_abscissae(f), f.control_points, strict=True)) if control_polygon else []
    power = _power([y for _, y in [*points, *[p for run in graph for p in run]]])
    graph, points = [[(t, y / mpq(10) ** power) for t, y in run] for run in graph], [(t, y / mpq(10) ** power) for t, y in points]
    _scale(ax, [y for run in graph for _, y in run], [y for _, y in points], scale)
    ax.axhline(0, color=BLACK, linewidth=0.8, zorder=1)
    if points:
        _draw_polygons(ax, _polygons(f.knots.knots, f.degree, points), len(points), 1 if ax.get_yscale() == "linear" else BENDS)
    for i, run in enumerate(graph):
        _draw(ax, run, color=BLACK, linewidth=1.8, label="_graph" if i else label or "graph", zorder=3)
    for left, right in pairwise(graph):
        _draw(ax, left[-1:], "o", color=BLACK, markerfacecolor="white", markersize=5, label="_limit", zorder=4)
        _draw(ax, right[:1], "o", color=BLACK, markersize=5, label="_value", zorder=4)
    if roots is not None:
        _draw_roots(ax, roots, f.domain, *MARKS[0])
    ax.set_xlabel("parameter")
    ax.set_ylabel(f"value / $10^{{{power}}}$" if power else "value")
    _legend(ax)
    return ax


def _power(values: Iterable[mpq]) -> int:
    """The power of ten to divide by: 0 unless the numbers are too large or too small for a picture."""
    largest = max(map(abs, values))
    if not largest or 1 / LARGEST <= largest <= LARGEST:
        return 0
    return ((int(largest.numerator).bit_length() - int(largest.denominator).bit_length()) * 30103 + 50000) // 100000


def _scale(ax: Any, graph: Sequence[mpq], polygon: Sequence[mpq], scale: str | None) -> None:
    """Set the scale of the value axis, chosen by the sizes of graph and control points where none is asked for."""
    sizes = sorted(abs(y) for y in graph if y) or [mpq(1)]
    top, highest = sizes[-1], max([sizes[-1], *map(abs, polygon)])
    uneven = top > GRAPH_ABOVE_MEDIAN * sizes[len(sizes) // 2]
    if scale == "clip":
        low, high = min([*graph, mpq(0)]), max([*graph, mpq(0)])
        margin = (high - low or 1) / mpq(10)
        ax.set_ylim(float(low - margin), float(high + margin))
    elif scale != "linear" and (uneven or scale == "symlog" or highest > POLYGON_ABOVE_GRAPH * top):
        linear = float(max(sizes[len(sizes) // 10] if uneven else top, highest / LARGEST))
        last = floor(log10(highest))
        first = round(log10(linear))
        name, how = ("asinh", {"linear_width": linear}) if uneven else ("symlog", {"linthresh": linear, "linscale": 1 + max(0, last - first)})
        ax.set_yscale(name, **how)
        lowest = min(last, first + uneven * (1 + (last - first) // 8))
        ticks = [sign * 10.0**k for k in range(last, lowest - 1, -((last - lowest + 3) // 3)) for sign in (-1, 1)]
        ax.yaxis.set_major_locator(_library("matplotlib.ticker").FixedLocator([0, *ticks]))


def _draw_roots(ax: Any, roots: Any, domain: tuple[mpq, mpq], marker: str, color: str) -> None:
    """Roots on the zero line; of a `ZeroSet` also its jumps through zero, hollow, and its stretches, thick."""
    single, jumps = _marked(roots)
    for points, what, face, edge in ((single, "root{}", color, "white"), (jumps, "jump{} through zero", "white", color)):
        if points:
            counted = f"{len(points)} {what.format('s' * (len(points) > 1))}"
            at = [(_parameter(t, domain), mpq(0)) for t in points]
            _draw(ax, at, marker, color=color, markerfacecolor=face, markeredgecolor=edge, markersize=7, label=counted, zorder=5)
    for i, stretch in enumerate(getattr(roots, "stretches", [])):
        ends = [(stretch.low, mpq(0)), (min(stretch.high, domain[1]), mpq(0))]
        _draw(ax, ends, color=color, linewidth=5, label="_stretch" if i else "zero throughout", zorder=2.5)


def _marked(roots: Any) -> tuple[list[Any], list[Any]]:
    """What is marked as a root, and what as a jump through zero."""
    return list(roots or ()), [jump for jump in getattr(roots, "jumps", []) if jump.sign_change]


def inspect_figure(curve: Nurbs, panels: Sequence[tuple[str, BSpline, Any]], *, evolute: bool = False) -> Any:
    """One picture: on the left the curve with the parameters of every panel marked, on the right each function with its control polygon.

    A panel is ``(title, function, roots)``, roots as for `plot_function`. With `evolute` a plane curve is drawn with its own. Degrees and numbers of
    control points in the titles are those of the objects. Returns the ``matplotlib.figure.Figure``; raises what the functions above raise.

    >>> from exactspline.constructions import construction
    >>> from exactspline.curves import example
    >>> f = construction("zero_curvature").on(example("cubic_s"), "paper")
    >>> [ax.get_title() for ax in inspect_figure(example("cubic_s"), [("zero curvature", f, zeros(f))]).axes]
    ['cubic_s: degree 3, 4 control points', 'zero curvature: degree 3, 4 control points']
    """
    figure = new_figure(13, max(5.5, 3.4 * len(panels)))
    grid = figure.add_gridspec(max(1, len(panels)), 2 if panels else 1)
    ax = plot_curve(curve, figure.add_subplot(grid[:, 0], projection="3d" if curve.dimension == 3 else None))
    if evolute:
        plot_evolute(curve, ax)
    ax.set_title(f"{_name(curve)}: degree {curve.degree}, {len(curve.control_points)} control points")
    for i, (title, f, roots) in enumerate(panels):
        marker, color = MARKS[i % len(MARKS)]
        panel = plot_function(f, figure.add_subplot(grid[i, 1]))
        _draw_roots(panel, roots, f.domain, marker, color)
        _legend(panel)
        panel.set_title(f"{title}: degree {f.degree}, {len(f.control_points)} control points")
        single, jumps = _marked(roots)
        size = 7 + 3 * (len(panels) - 1 - i)
        plot_features(curve, [*single, *jumps], ax, marker=marker, color=color, label=f"zeros of {title}", size=size)
    return figure


def save(figure_or_ax: Any, path: str | os.PathLike[str]) -> None:
    """Write a figure, or the one that axes belong to, as SVG or PNG by the suffix of the path; the file is there whole or not at all.

    The same picture gives the same bytes. Raises `PlotError` for another suffix and where nothing can be written.
    """
    place = Path(path)
    suffix = place.suffix.lower()
    if suffix not in SUFFIXES:
        raise PlotError("is neither SVG nor PNG", where=str(place), remedy=f"use a name that ends in {' or '.join(SUFFIXES)}")
    figure = figure_or_ax if hasattr(figure_or_ax, "savefig") else figure_or_ax.figure
    metadata = {"Date": None} if suffix == ".svg" else {}
    with _library("matplotlib").rc_context({"svg.hashsalt": "exactspline"}):
        write_atomically(place, lambda stream: figure.savefig(stream, format=suffix[1:], dpi=150, metadata=metadata), PlotError)
