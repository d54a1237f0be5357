"""Graphs of scalar splines with their control polygons and roots, and whole pictures that compare several things."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import compress, pairwise
from math import floor, log10
from typing import TYPE_CHECKING, cast

from exactspline.display.numbers import rounded_down
from exactspline.display.plot.canvas import (
    BLACK,
    GREEN,
    LARGEST,
    MARKS,
    ORANGE,
    PAGE,
    SILVER,
    SKY,
    VERMILLION,
    PlotError,
    Point,
    Run,
    axes_for,
    check_options,
    draw,
    draw_polygons,
    draw_runs,
    legend_below,
    legend_once,
    library,
    new_figure,
    parameter,
    polygons,
    runs_between_gaps,
    sampled,
    shown_name,
)
from exactspline.display.plot.curves import plot_curve, plot_evolute, plot_features
from exactspline.errors import ShapeError, as_instance, as_items, counted, shown
from exactspline.geometry.analysis.curves import QUESTIONS, analyse, questions_about
from exactspline.geometry.curves.facts import among, located
from exactspline.geometry.curves.joints import Joint
from exactspline.geometry.curves.kinds import Feature, FeatureKind, kind_name
from exactspline.numbers.exact import mpq
from exactspline.questions.entry import Answered
from exactspline.roots.root import Root, knot_root
from exactspline.roots.zero_set import ZeroSet
from exactspline.splines.bspline import BSpline
from exactspline.splines.control_points import greville_abscissae
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Ratio of the heights of control polygon and graph, or of graph and its median, above which the scale is not linear.
POLYGON_ABOVE_GRAPH, GRAPH_ABOVE_MEDIAN = 10, 50
#: The number of pieces of a leg of a control polygon on a nonlinear scale.
BENDS = 64
#: The label of intervals on which a function vanishes.
ZERO = "zero throughout"
SCALES = ("linear", "symlog", "clip")


def plot_function(
    f: BSpline,
    ax: Axes | None = None,
    *,
    control_polygon: bool = True,
    roots: ZeroSet | Sequence[Root] | None = None,
    scale: str | None = None,
    label: str | None = None,
    polygon_color: str = SILVER,
    color: str = BLACK,
) -> Axes:
    """Draw the graph of a scalar spline with its control polygon over the Greville abscissae, the zero line, and the
    roots.

    `roots` are parameters (as in `plot_features`) or a `ZeroSet`, whose jumps and intervals are marked too. Where the
    function jumps, graph and polygon have a gap. `scale` is ``linear``, ``symlog`` (linear around zero, logarithmic
    outside) or ``clip`` (the graph fills the axes, the polygon may leave them); the default is ``symlog`` if the
    control points or the values have very different sizes, otherwise ``linear``. If all values are beyond 1e100 or
    below 1e-100, they are divided by a power of ten, which is written at the axis.

    >>> ax = plot_function(BSpline(1, [0, 0, 1, 2, 2], [1, -1, 1]), roots=["1/2", "3/2"])
    >>> [text.get_text() for text in ax.get_legend().get_texts()]
    ['control polygon (3 points)', 'graph', '2 roots']

    Raises `PlotError` without matplotlib and for an unknown scale, `ShapeError` for anything but a `BSpline`.
    """
    check_options(control_polygon=control_polygon, label=label, polygon_color=polygon_color, color=color)
    if type(f) is not BSpline:
        raise ShapeError(
            f"the graph of a {type(f).__name__}", remedy="give a BSpline, for a vector one component at a time"
        )
    if scale is not None and (not isinstance(scale, str) or scale not in SCALES):
        raise PlotError(f"{shown(scale)} is not a scale", where="scale", remedy=f"scales are {', '.join(SCALES)}")
    ax = axes_for(ax)
    graph = _runs(f)
    points = list(zip(greville_abscissae(f), f.control_points, strict=True)) if control_polygon else []
    power = _power([y for _, y in [*points, *[p for run in graph for p in run]]])
    graph, points = (
        [[(t, y / mpq(10) ** power) for t, y in run] for run in graph],
        [(t, y / mpq(10) ** power) for t, y in points],
    )
    _scale(ax, [y for run in graph for _, y in run], [y for _, y in points], scale)
    ax.axhline(0, color=BLACK, linewidth=0.8, zorder=1)
    if points:
        bends = 1 if ax.get_yscale() == "linear" else BENDS
        draw_polygons(ax, polygons(f.knots.knots, f.degree, points), len(points), bends, polygon_color)
    _draw_graph(ax, graph, color, label or "graph")
    if roots is not None:
        draw_roots(ax, roots, f.domain, *MARKS[0])
    ax.set_xlabel("parameter")
    ax.set_ylabel(f"value / $10^{{{power}}}$" if power else "value")
    legend_below(ax)
    return ax


def _runs(f: BSpline) -> list[list[Point]]:
    """The points of the graph, in runs without a jump."""
    spread: list[Point | None] = []
    for samples in sampled(f, f.breakpoints):
        spread += samples if not spread or spread[-1] == samples[0] else [None, *samples]
    return runs_between_gaps(spread)


def _draw_graph(ax: Axes, graph: Sequence[Sequence[Point]], color: str, label: str) -> None:
    """Draw the runs of a graph, and at jumps the limit from the left and the value."""
    draw_runs(ax, graph, label, color=color, linewidth=1.8, zorder=3)
    for left, right in pairwise(graph):
        draw(ax, left[-1:], "o", color=color, markerfacecolor="white", markersize=5, label="_limit", zorder=4)
        draw(ax, right[:1], "o", color=color, markersize=5, label="_value", zorder=4)


def _power(values: Iterable[mpq]) -> int:
    """The power of ten to divide by: 0 unless the numbers are too large or too small for a picture."""
    largest = max(map(abs, values))
    if not largest or 1 / LARGEST <= largest <= LARGEST:
        return 0
    return ((int(largest.numerator).bit_length() - int(largest.denominator).bit_length()) * 30103 + 50000) // 100000


def _scale(ax: Axes, graph: Sequence[mpq], polygon: Sequence[mpq], scale: str | None) -> None:
    """Set the scale of the value axis; by default it is chosen by the sizes of graph and control points."""
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
        if uneven:
            ax.set_yscale("asinh", linear_width=linear)
        else:
            ax.set_yscale("symlog", linthresh=linear, linscale=1 + max(0, last - first))
        lowest = min(last, first + uneven * (1 + (last - first) // 8))
        ticks = [sign * 10.0**k for k in range(last, lowest - 1, -((last - lowest + 3) // 3)) for sign in (-1, 1)]
        ax.yaxis.set_major_locator(library("matplotlib.ticker").FixedLocator([0, *ticks]))


def draw_roots(
    ax: Axes,
    roots: ZeroSet | Sequence[Root] | None,
    domain: tuple[mpq, mpq],
    marker: str,
    color: str,
    name: str = "root",
) -> None:
    """Draw roots on the zero line; for a `ZeroSet` also its jumps through zero (hollow) and its intervals (thick)."""
    single, jumps = _marked(roots)
    for points, what, face, edge in (
        (single, name + "{}", color, "white"),
        (jumps, "jump{} through zero", "white", color),
    ):
        if points:
            counted = f"{len(points)} {what.format('s' * (len(points) > 1))}"
            at = [(parameter(t, domain), mpq(0)) for t in points]
            colors = {"color": color, "markerfacecolor": face, "markeredgecolor": edge}
            draw(ax, at, marker, markersize=7, label=counted, zorder=5, **colors)
    draw_runs(ax, _zero_runs(roots, 0), ZERO, color=color, linewidth=5, zorder=2.5)


def _zero_runs(roots: ZeroSet | Sequence[Root] | None, height: int) -> list[Run]:
    """The intervals on which the function vanishes, cut at the seam, at a height."""
    parts = [part for interval in getattr(roots, "intervals", []) for part in interval.parts]
    return [[(t, mpq(height)) for t in part] for part in parts]


def _marked(roots: ZeroSet | Sequence[Root] | None) -> tuple[list[Root], list[Root]]:
    """The parameters marked as roots, and those marked as jumps through zero."""
    single = [] if roots is None else list(as_items(roots, "roots"))
    return single, [jump for jump in getattr(roots, "jumps", []) if jump.sign_change]


def plot_roots(roots: ZeroSet | Sequence[Root], ax: Axes | None = None, *, color: str = GREEN) -> Axes:
    """Draw certified roots with their isolating intervals, one above the other: each interval is a bar that contains
    exactly one root, and the root is a dot.

    The current interval is drawn: `Root.refine` makes it narrower. Intervals on which the function vanishes are thick
    bars at the bottom.

    >>> from exactspline.roots.zero_set import zeros
    >>> ax = plot_roots(zeros(BSpline.bezier([1, "-1/2", "-2/3", 1], 0, 3)))
    >>> [text.get_text() for text in ax.get_yticklabels()]
    ['0.937', '2.13']

    Raises `PlotError` without matplotlib.
    """
    check_options(color=color)
    ax = axes_for(ax)
    certified = [as_instance(root, Root, "a root", "give exactspline.zeros(f)") for root in as_items(roots, "roots")]
    bars = [(root.low, root.high) for root in certified]
    at = [
        (low + high) / 2 if low == high else root.refine(20)[0]
        for root, (low, high) in zip(certified, bars, strict=True)
    ]
    for i, (low, high) in enumerate(bars):
        bar, label = [(low, mpq(i)), (high, mpq(i))], "_interval" if i else "isolating interval"
        draw(ax, bar, "|-", color=BLACK, linewidth=2, markersize=12, label=label)
        kind = f"{color}" if certified[i].sign_change else "white"
        draw(ax, [(at[i], mpq(i))], "o", color=color, markerfacecolor=kind, markersize=7, label="_root", zorder=3)
    empty: list[float] = []
    ax.plot(empty, empty, "o", color=color, label="root (filled: the sign changes)")
    draw_runs(ax, _zero_runs(roots, -1), ZERO, color=color, linewidth=6)
    ax.set_yticks(range(len(bars)), [f"{float(t):.3g}" for t in at])
    ax.set_ylabel("root")
    ax.set_xlabel("parameter")
    legend_below(ax)
    return ax


#: The marks in a picture of several curves: a question of the registry, and the marker with size and colour.
_MARKED: tuple[tuple[str, str, int, str], ...] = (
    ("corners", "s", 11, VERMILLION),
    ("cusps", "X", 9, BLACK),
    ("turning_points", "o", 7, SKY),
    ("curvature_extrema", "^", 7, ORANGE),
    ("inflections", "D", 7, GREEN),
)


#: Marker and colour of the features whose stability is drawn.
STABLE = {FeatureKind.INFLECTION: ("D", GREEN), FeatureKind.MAXIMUM: ("^", ORANGE), FeatureKind.MINIMUM: ("v", SKY)}


def _places(curve: Nurbs, name: str) -> list[Root]:
    """The single points in the answer to a question; a question about a coordinate is asked for every coordinate."""
    entry, facts = QUESTIONS[name], analyse(curve)
    arguments = map(str, range(curve.dimension)) if entry.about.argument else ("",)
    answers = [
        each for argument in arguments for each in cast(Iterable[Feature | Joint], entry.answer(facts, argument))
    ]
    return [knot_root(each.parameter) if isinstance(each, Joint) else each.root for each in answers]


def _kinds(curve: Nurbs, places: list[Root]) -> str:
    """The kinds of the features at some places, in the words of the table of features."""
    found: list[Feature] = []
    for entry in questions_about(curve).values():
        if entry.about.answered is Answered.PLACES and entry.about.reported:
            features = [*cast(Iterable[Feature], entry.answer(analyse(curve)))]
            found += compress(features, among([each.root for each in features], places))
    return ", ".join(dict.fromkeys(kind_name(each.kind) for each in found))


def inspect_figure(
    curve: Nurbs, panels: Sequence[tuple[str, BSpline, ZeroSet]], *, evolute: bool = False, stability: bool = False
) -> Figure:
    """One picture: on the left the curve with the parameters of every panel, its corners and cusps marked, on the right
    each function with its control polygon.

    A panel is ``(title, function, zeros)``, where zeros is a `ZeroSet`. With `evolute` a plane curve is drawn together
    with its evolute; with `stability` its marks are those of `plot_stability`. Degrees and numbers of control points in
    the titles are those of the objects. Returns the ``matplotlib.figure.Figure``; raises the errors of `plot_curve`,
    `plot_function` and `plot_evolute`.

    >>> from exactspline.geometry.derived.constructions import construction
    >>> from exactspline.interchange.examples import example
    >>> from exactspline.roots.zero_set import zeros
    >>> f = construction("zero_curvature").on(example("cubic_s"), "paper")
    >>> [ax.get_title() for ax in inspect_figure(example("cubic_s"), [("zero curvature", f, zeros(f))]).axes]
    ['cubic s: degree 3, 4 control points', 'zero curvature: degree 3, 4 points']
    """
    figure = new_figure(PAGE, max(4.6, 3 * len(panels)))
    grid = figure.add_gridspec(max(1, len(panels)), 2 if panels else 1)
    ax = plot_curve(curve, figure.add_subplot(grid[:, 0], projection="3d" if curve.dimension == 3 else None))
    if evolute:
        plot_evolute(curve, ax)
    ax.set_title(f"{shown_name(curve)}: degree {curve.degree}, {counted(len(curve.control_points), 'control point')}")
    for i, (title, f, roots) in enumerate(panels):
        marker, color = MARKS[i % len(MARKS)]
        panel = plot_function(f, figure.add_subplot(grid[i, 1]))
        draw_roots(panel, roots, f.domain, marker, color)
        legend_below(panel)
        form = f"form for {title}" if "=" in title else title
        panel.set_title(f"{form}: degree {f.degree}, {counted(len(f.control_points), 'point')}")
        size = 7 + 3 * (len(panels) - 1 - i)
        places = [root for root, _ in located(roots)]
        label = ": ".join(filter(None, (f"{title} ({len(places)})", _kinds(curve, places))))
        if not stability:
            plot_features(curve, places, ax, marker=marker, color=color, label=label, size=size)
    if stability:
        plot_stability(curve, ax)
        return figure
    for name, marker, size, color in _MARKED[:2]:
        places = _places(curve, name)
        plot_features(curve, places, ax, marker=marker, color=color, label=f"{name} ({len(places)})", size=size)
    return figure


def plot_stability(curve: Nurbs, ax: Axes | None = None) -> Axes:
    """Inflections (in space: zeros of the torsion), extrema of the curvature and corners of a curve as marks whose area
    grows with the logarithm of the proved distance up to which the feature persists: full size from a 16th of the
    curve's size on, the smallest size up to 10⁻⁶ of it, and hollow if no distance is proved.

    >>> from exactspline.interchange.examples import example
    >>> ax = plot_stability(example("cubic_s"), plot_curve(example("cubic_s")))
    >>> [text.get_text() for text in ax.get_legend().get_texts()][-1]
    'maximum of κ (up to 0.031)'

    Raises `ShapeError` for a curve that is neither in the plane nor in space, otherwise as `plot_curve`.
    """
    curve = curve_of(curve)
    ax = axes_for(ax, curve.dimension)
    columns = list(zip(*curve.control_points, strict=True))
    whole = float(max(max(column) - min(column) for column in columns)) or 1.0
    for found in analyse(curve).stability:
        marker, color = STABLE.get(found.kind, ("s", VERMILLION))
        share = float(found.radius) / whole
        size = 4 + 10 * min(max(log10(share * 1e6) / log10(1e6 / 16), 0.0), 1.0) if share else 6
        said = f"up to {float(rounded_down(found.radius, 2)):.2g}" if share else "not proved"
        label = f"{kind_name(found.kind)} ({said})"
        plot_features(
            curve, [cast(Root, found.place)], ax, marker=marker, color=color, label=label, size=size, hollow=not share
        )
    legend_below(ax, 2)  # three of these labels in a row are wider than a picture
    return ax


def features_figure(curves: Sequence[Nurbs], title: str = "") -> Figure:
    """One picture of several curves (a drawing or a glyph) with the points that answer some questions: corners and
    cusps, extrema of the curvature and of the coordinates, and inflections.

    >>> from exactspline.interchange.examples import example
    >>> ax, = features_figure([example("cubic_s"), example("cusp")]).axes
    >>> [text.get_text() for text in ax.get_legend().get_texts()][-1]
    'inflections (1)'

    Raises `PlotError` for a space curve among plane ones, otherwise as `plot_curve`.
    """
    figure = new_figure(PAGE, 8)
    ax = figure.add_subplot(projection="3d" if curves[0].dimension == 3 else None)
    for curve in curves:
        plot_curve(curve, ax, control_polygon=False, label="_curve")
    for name, marker, size, color in _MARKED:
        answers = [(curve, _places(curve, name)) for curve in curves]
        shown = name.replace("turning_points", "coordinate extrema").replace("_", " ")
        label = f"{shown} ({sum(len(places) for _, places in answers)})"
        for curve, places in answers:
            plot_features(curve, places, ax, marker=marker, color=color, label=label, size=size)
    legend_once(ax)
    ax.set_title(title or shown_name(curves[0]))
    return figure
