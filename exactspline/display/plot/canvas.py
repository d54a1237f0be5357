"""The basis of every picture: figures, axes, colours, files, and the only place where exact numbers become floats. This
module has no global state and needs neither pyplot nor a display. Colours after Okabe and Ito (2008), which
colour-blind readers can distinguish too.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from importlib import import_module
from inspect import signature
from itertools import groupby, pairwise
from math import ceil, floor, log10
from numbers import Real
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any, TypeVar, cast

from exactspline.atomic_write import write_atomically
from exactspline.errors import ExactSplineError, a_kind, counted, nearest, shown
from exactspline.geometry.curves.kinds import Feature
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector
from exactspline.numbers.exact import Number, mpq, rational
from exactspline.roots.root import Root
from exactspline.splines.common import with_common_knots
from exactspline.splines.lowest_terms import SplineVector
from exactspline.splines.nurbs import Nurbs

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


BLACK, GREY, SILVER = "#000000", "#7A7A7A", "#C4C4C4"
BLUE, SKY, GREEN, ORANGE, VERMILLION, PURPLE = "#0072B2", "#56B4E9", "#009E73", "#E69F00", "#D55E00", "#CC79A7"
#: Markers and colours of the roots, by panel.
MARKS = (("D", GREEN), ("s", PURPLE), ("^", ORANGE), ("v", SKY))

#: Samples per segment, and the approximate total when there are many segments.
SAMPLES, ALL_SAMPLES = 128, 8192
#: The size beyond which (and below whose reciprocal) matplotlib fails.
LARGEST = mpq(10) ** 100

#: The width of a page in inches: in wider figures the letters would be too small to read.
PAGE = 9.2
#: The width of an entry of a legend, in inches.
ENTRY = 1.9

#: The suffixes of pictures, and the data in them that would differ from run to run.
SUFFIXES = {".svg": ["Date"], ".png": [], ".pdf": ["CreationDate"]}
Point = tuple[mpq, ...]
Run = list[Point]

V = TypeVar("V")

#: The largest figure, in inches, that matplotlib writes to a bitmap.
LARGEST_SIZE = 600


class PlotError(ExactSplineError):
    """The error for a picture that cannot be drawn or written.

    >>> print(PlotError("cannot be written", where="a.gif", remedy="name it .svg or .png"))
    a.gif: cannot be written; name it .svg or .png
    """


#: The size of the marks of control points, from this many points on.
MARKER_SIZES = {300: 1.8, 100: 3.5, 0: 5}


def new_figure(width: float = 7, height: float = 5) -> Figure:
    """An empty ``matplotlib.figure.Figure`` of the given size in inches, without a window; raises `PlotError` without
    matplotlib.
    """
    for inches in (width, height):
        if not isinstance(inches, Real) or not 0 < inches <= LARGEST_SIZE:
            raise PlotError(f"a figure of {shown(inches)} inches", remedy="give positive numbers")
    made: Figure = library("matplotlib.figure").Figure(figsize=(float(width), float(height)), layout="constrained")
    return made


def library(module: str) -> ModuleType:
    """A module of matplotlib; raises `PlotError` if matplotlib is not installed."""
    try:
        return import_module(module)
    except ImportError:
        raise PlotError("drawing needs matplotlib, which is not installed", remedy="pip install matplotlib") from None


def axes_for(ax: Axes | None, dimension: int = 2) -> Axes:
    """The axes given, or those of a new figure; raises `PlotError` when they do not fit the dimension."""
    if dimension not in (2, 3):
        raise PlotError(f"a curve in R{dimension}", remedy="curves in the plane and in space can be drawn")
    if ax is None:
        return new_figure().add_subplot(projection="3d" if dimension == 3 else None)
    if not isinstance(ax, library("matplotlib.axes").Axes):
        raise PlotError(
            f"{a_kind(ax)}, where axes of matplotlib are expected", remedy="leave them out for a new figure"
        )
    if (ax.name == "3d") != (dimension == 3):
        problem = f"axes that do not fit R{dimension}"
        raise PlotError(problem, where="ax", remedy="projection='3d' is for curves in space, and only for them")
    return cast("Axes", ax)


def draw(ax: Axes, points: Iterable[Sequence[mpq]], style: str = "", **how: object) -> None:
    """Exact points as a line or as dots: the only place where they become floats."""
    options: dict[str, Any] = how
    columns = list(zip(*points, strict=True))
    if any(abs(x) > LARGEST for column in columns for x in column):
        raise PlotError("a number beyond 1e100", remedy="scale the data")
    ax.plot(*[[float(x) for x in column] for column in columns], *([style] if style else []), **options)


def draw_runs(ax: Axes, runs: Iterable[Iterable[Sequence[mpq]]], label: str, **how: object) -> None:
    """Runs of points, each as a line; the legend names them once."""
    for i, run in enumerate(runs):
        draw(ax, run, "", label=f"_{label}" if i else label, **how)


def legend_below(ax: Axes, columns: int = 3) -> None:
    """Put a legend under the axes, where it hides nothing, in at most `columns` columns, fewer if there is no room."""
    handles, labels = ax.get_legend_handles_labels()
    columns = min(columns, max(1, int(_width(ax) / ENTRY)))
    below = library("matplotlib.transforms").offset_copy(
        ax.transAxes, fig=ax.figure, y=-36 if ax.get_xlabel() else -20, units="points"
    )
    place = {"loc": "upper center", "bbox_to_anchor": (0.5, 0), "bbox_transform": below}
    ax.legend(handles, labels, ncols=columns, fontsize="small", frameon=False, **place)


def legend_once(ax: Axes) -> None:
    """A legend with each label once."""
    seen: set[str] = set()
    for artist in [*ax.lines, *ax.collections]:
        label = str(artist.get_label())
        if label in seen:
            artist.set_label(f"_{label}")
        seen.add(label)
    legend_below(ax)


def _width(ax: Axes) -> float:
    """The width of the axes in inches."""
    place: Any = ax.get_subplotspec()
    share = len(place.colspan) / place.get_gridspec().ncols if place else 1.0
    figure: Any = ax.figure
    return share * float(figure.get_figwidth())


def sampled(f: Callable[..., V], breaks: Sequence[mpq]) -> Iterator[list[tuple[mpq, V]]]:
    """Parameters and exact values segment by segment, both ends included, their limits taken from within."""
    count = max(8, min(SAMPLES, ALL_SAMPLES // (len(breaks) - 1)))
    for a, b in pairwise(breaks):
        inner = [a + (b - a) * mpq(k, count) for k in range(count)]
        yield [*[(t, f(t)) for t in inner], (b, f(b, "left"))]


def parameter(t: Number | Root | Feature, domain: tuple[mpq, mpq]) -> mpq:
    """An exact parameter: the number itself, or the middle of a root's interval, narrow compared with the domain."""
    place: Any = getattr(t, "parameter", getattr(t, "root", t))
    if isinstance(place, Root):
        low, high = place.refine(20 + int(1 / (domain[1] - domain[0])).bit_length() // 3)
        return (low + high) / 2
    return rational(place)


def runs_between_gaps(points: Iterable[Point | None]) -> list[Run]:
    """The runs of points between the gaps (None)."""
    return [[p for p in run if p is not None] for there, run in groupby(points, lambda p: p is not None) if there]


def polygons(knots: Sequence[mpq], degree: int, points: Sequence[Point | None]) -> list[Run]:
    """Runs of control points that are drawn connected: the runs end at jumps and at missing points (None)."""
    spread: list[Point | None] = []
    for i, point in enumerate(points):
        jump = i > 0 and knots[i] == knots[i + degree] and point != points[i - 1]
        spread += [None, point] if jump else [point]
    return runs_between_gaps(spread)


def draw_polygons(ax: Axes, runs: list[Run], count: int, bends: int = 1, color: str = SILVER, hidden: int = 0) -> None:
    """Draw the legs of control polygons (by default in light grey) and the visible control points. The legs are
    straight in the data, hence curved on a nonlinear scale.
    """
    size = next(size for least, size in MARKER_SIZES.items() if count >= least)
    for run in runs:
        legs = [
            [x + mpq(k, bends) * (y - x) for x, y in zip(p, q, strict=True)]
            for p, q in pairwise(run)
            for k in range(bends)
        ]
        draw(ax, [*legs, run[-1]], color=color, linewidth=1, label="_legs", zorder=2)
        draw(ax, run, "o", color=BLUE, markersize=size, label="_control points", zorder=2.2)
    nothing: list[list[float]] = [[]] * (3 if ax.name == "3d" else 2)
    label = f"control polygon ({counted(count, 'point')}{f', {hidden} far away or at infinity' if hidden else ''})"
    ax.plot(*nothing, "o-", color=color, markerfacecolor=BLUE, markeredgecolor=BLUE, markersize=5, label=label)


def shown_name(curve: Nurbs) -> str:
    """The name in words, escaped so that matplotlib shows it literally: no dollar signs as mathematics."""
    return curve.name.replace("$", r"\$").replace("_", " ").strip() or "curve"


def settle(figure: Figure) -> None:
    """Lay out a figure with axes in space: the size of the axes is known only after drawing once."""
    if any(ax.name == "3d" for ax in figure.axes):
        figure.draw_without_rendering()


def in_words(figure: Figure) -> str:
    """A description of a figure, from its titles, the names of its axes and its legends.

    >>> figure = new_figure()
    >>> ax = figure.add_subplot(title="speed")
    >>> draw(ax, [(mpq(0), mpq(0)), (mpq(1), mpq(1))], label="graph")
    >>> in_words(figure)
    'A plot: speed, showing graph.'
    """
    descriptions = []
    for ax in figure.axes:
        title = " ".join(ax.get_title().split()).replace("$", "")
        names = dict.fromkeys(name for name in ax.get_legend_handles_labels()[1] if not name.startswith("_"))
        shown = f"showing {', '.join(names)}" if names else ""
        descriptions.append(", ".join(filter(None, (title, shown))) or "a picture without words")
    return f"{'A plot' if len(descriptions) == 1 else 'Plots'}: {'; '.join(descriptions)}."


def save(figure_or_ax: Figure | Axes, path: str | os.PathLike[str]) -> None:
    """Write a figure, or the one that axes belong to, as SVG, PNG or PDF by the suffix of the path; the file is written
    completely or not at all.

    The same picture gives the same bytes. Raises `PlotError` for another suffix and where nothing can be written.
    """
    place = Path(path)
    suffix = place.suffix.lower()
    if suffix not in SUFFIXES:
        problem = "is neither SVG nor PNG nor PDF"
        raise PlotError(problem, where=str(place), remedy=f"use a name that ends in {' or '.join(SUFFIXES)}")
    figure: Any = figure_or_ax if hasattr(figure_or_ax, "savefig") else figure_or_ax.figure
    description = "Subject" if suffix == ".pdf" else "Description"
    metadata = dict.fromkeys(SUFFIXES[suffix]) | {description: in_words(figure)}
    settle(figure)
    with library("matplotlib").rc_context({"svg.hashsalt": "exactspline"}):
        write_atomically(
            place, lambda stream: figure.savefig(stream, format=suffix[1:], dpi=150, metadata=metadata), PlotError
        )


# ---- the visible part


#: The visible part: the fraction of points omitted on either side, and the margin (in multiples of its longest side).
OUTLIERS, AROUND = 10, mpq(1)
#: A side of a box is short below this fraction of the longest one.
SHORT = 0.55

Box = tuple[Point, Point]


def box_around(points: Iterable[Point]) -> Box:
    """Lower left and upper right corner of the smallest box around the points."""
    columns = list(zip(*points, strict=True))
    return tuple(map(min, columns)), tuple(map(max, columns))


def longer_side(box: Box) -> mpq:
    """The length of the longest side of a box."""
    return max(high - low for low, high in zip(*box, strict=True))


def grown(box: Box, by: mpq) -> Box:
    """The box with a margin on all sides, given as a multiple of its longer side."""
    margin = by * longer_side(box)
    return tuple(x - margin for x in box[0]), tuple(x + margin for x in box[1])


def inside(point: Point, box: Box) -> bool:
    """Whether a box contains a point."""
    return all(low <= x <= high for low, x, high in zip(box[0], point, box[1], strict=True))


def usual_box(points: Sequence[Point], poles: bool = True) -> Box:
    """A box around the points with a margin; with `poles` around most of them, so that faraway points do not matter.

    Raises `PlotError` if there are no points.
    """
    if not points:
        raise PlotError(
            "there is nothing to draw",
            remedy="this does not exist on the curve (its denominator vanishes), or is all at infinity",
        )
    columns = [sorted(column) for column in zip(*points, strict=True)]
    cut = len(points) // OUTLIERS if poles else 0
    return grown((tuple(c[cut] for c in columns), tuple(c[-1 - cut] for c in columns)), AROUND)


def three_ticks(low: mpq | float, high: mpq | float, longest: float = 0) -> list[mpq]:
    """Two or three round numbers between two bounds, in steps of 1, 2 or 5 times a power of ten. A side that is short
    compared with the longest one gets only two, since three would overlap.

    >>> [[float(x) for x in three_ticks(*ends)] for ends in ((-1.2, 4.1), (-0.5, 2.5), (0.12, 0.31), (3, 3))]
    [[0.0, 2.0, 4.0], [0.0, 1.0, 2.0], [0.2, 0.3], [3.0]]
    """
    low, high = mpq(low), mpq(high)
    if low >= high:
        return [low]
    power = floor(log10(high - low)) - 1
    at_most = 2 if float(high - low) < SHORT * longest else 3
    steps = (mpq(k) * mpq(10) ** (power + up) for up in range(3) for k in (1, 2, 5))
    return next(
        [k * step for k in range(first, last + 1)]
        for step in steps
        if (last := floor(high / step)) - (first := ceil(low / step)) < at_most
    )


def kept(point: Point | None, box: Box) -> Point | None:
    """The point if the box contains it, otherwise None."""
    return point if point is not None and inside(point, box) else None


def runs_in(points: Sequence[Point | None], box: Box) -> list[Run]:
    """The runs of points inside a box between gaps (None), each with its neighbours just outside, so that a line that
    continues crosses the frame.

    >>> line = [(mpq(x), mpq(0)) for x in (-9, 0, 1, 2, 3, 4)]
    >>> runs_in(line, ((mpq(0), mpq(0)), (mpq(2), mpq(0)))) == [line[1:5]]
    True
    """
    near, there = grown(box, mpq(1)), [kept(point, box) is not None for point in points]
    return runs_between_gaps(kept(p, near) if any(there[max(i - 1, 0) : i + 2]) else None for i, p in enumerate(points))


def clipped(
    point: Point, direction: Point, box: Box, low: mpq | None = None, high: mpq | None = None
) -> tuple[Point, Point] | None:
    """The two ends of the part of a line inside a box, between two parameters of the line if they are given; None if no
    part is inside.

    >>> clipped((mpq(-2), mpq(0)), (mpq(1), mpq(0)), ((mpq(-1), mpq(-1)), (mpq(1), mpq(1))))
    ((mpq(-1,1), mpq(0,1)), (mpq(1,1), mpq(0,1)))
    """
    for x, d, a, b in zip(point, direction, *box, strict=True):
        if d == 0:
            if not a <= x <= b:
                return None
            continue
        first, last = sorted(((a - x) / mpq(d), (b - x) / mpq(d)))
        low = first if low is None else max(low, first)
        high = last if high is None else min(high, last)
    if low is None or high is None or low >= high:
        return None
    ends = [tuple(x + z * d for x, d in zip(point, direction, strict=True)) for z in (low, high)]
    return ends[0], ends[1]


def polygon_in(corners: Sequence[Point], box: Box) -> list[Point]:
    """The part of a polygon inside a box: the polygon is cut by the sides of the box one after another.

    >>> square = [(mpq(x), mpq(y)) for x, y in ((0, 0), (2, 0), (2, 2), (0, 2))]
    >>> polygon_in(square, ((mpq(1), mpq(1)), (mpq(3), mpq(3))))
    [(mpq(2,1), mpq(1,1)), (mpq(2,1), mpq(2,1)), (mpq(1,1), mpq(2,1)), (mpq(1,1), mpq(1,1))]
    """
    points = list(corners)
    for k in range(len(box[0])):
        for bound, side in ((box[0][k], 1), (box[1][k], -1)):
            cut: list[Point] = []
            for p, q in zip(points, [*points[1:], *points[:1]], strict=True):
                a, b = side * (p[k] - bound), side * (q[k] - bound)
                if a >= 0:
                    cut.append(p)
                if a * b < 0:
                    cut.append(tuple(x + (y - x) * a / (a - b) for x, y in zip(p, q, strict=True)))
            points = cut
    return points


def homogeneous(value: SplineVector) -> tuple[list[tuple[mpq, ...]], Sequence[mpq], int]:
    """Homogeneous control points ``(w x, …, w)`` of a vector or quotient over the knots that carry all components, the
    knots, and the degree.
    """
    numerator, w = value.elevated() if isinstance(value, Rational) else (value, value[0].constant(1))
    assert isinstance(numerator, Vector)
    raised = with_common_knots([*numerator, w])
    return list(zip(*[c.control_points for c in raised], strict=True)), raised[0].knots.knots, raised[0].degree


# ---- options


#: The largest number that an option may be.
LARGEST_NUMBER = 10**9


def check_options(**given: object) -> None:
    """Raise `PlotError` for a value that an option of a picture cannot have; options are known by their names.

    >>> check_options(color="#D55E00", control_polygon=True, label=None)
    >>> check_options(color="reddish")
    Traceback (most recent call last):
    exactspline.display.plot.canvas.PlotError: color: 'reddish' is not a colour; give a name or '#rrggbb'
    """
    for name, value in given.items():
        what, is_good, remedy = CHECKS[name]
        if not is_good(value):
            raise PlotError(f"{shown(value)} is not {what}", where=name, remedy=remedy)


def exact_box(box: Box | None, dimension: int) -> Box | None:
    """The box with exact corners; `PlotError` for one of another dimension."""
    if box is None:
        return None
    low, high = (tuple(map(rational, corner)) for corner in box)
    if len(low) != dimension:
        raise PlotError(f"a box in R{len(low)}", where="box", remedy=f"corners have {dimension} coordinates here")
    return low, high


def check_names(draw: Callable[..., object], names: Iterable[str]) -> None:
    """Raise `PlotError` for the name of an option that a function does not have."""
    known = [p.name for p in signature(draw).parameters.values() if p.kind is p.KEYWORD_ONLY]
    for name in names:
        if name not in known:
            raise PlotError(f"{draw.__name__} has no option {name!r}", remedy=nearest(name, known))


def _is_color(value: object) -> bool:
    if isinstance(value, tuple):
        return len(value) in (3, 4) and all(_is_number(x) and 0 <= x <= 1 for x in value)
    return isinstance(value, str) and bool(library("matplotlib.colors").is_color_like(value))


def _is_number(value: Any) -> bool:
    if not isinstance(value, int | float) or isinstance(value, bool):
        return False
    return -LARGEST_NUMBER < value < LARGEST_NUMBER


def _is_corner(value: Any) -> bool:
    return isinstance(value, list | tuple) and all(map(_is_rational, value))


def _is_rational(value: Any) -> bool:
    try:
        rational(value)
    except ExactSplineError:
        return False
    return True


def _is_box(value: Any) -> bool:
    if value is None:
        return True
    if not isinstance(value, list | tuple) or len(value) != 2 or not all(map(_is_corner, value)):
        return False
    low, high = value
    return len(low) == len(high) in (2, 3) and all(rational(x) < rational(y) for x, y in zip(low, high, strict=True))


def _is_marker(value: object) -> bool:
    return isinstance(value, str) and value in library("matplotlib.markers").MarkerStyle.markers


_COLOR = ("a colour", _is_color, "give a name or '#rrggbb'")
_FLAG = ("a choice between two", lambda x: isinstance(x, bool), "give True or False")
_SIZE = f"give a number between 0 and {LARGEST_SIZE}"
#: For each option: its description, a check of values, and the remedy for a wrong value.
CHECKS: dict[str, tuple[str, Callable[[Any], bool], str]] = {
    **dict.fromkeys(("color", "polygon_color", "net_color"), _COLOR),
    **dict.fromkeys(("control_polygon", "control_net", "knots", "hollow"), _FLAG),
    "label": ("a label", lambda x: isinstance(x, str | None), "give a text"),
    "marker": ("a marker", _is_marker, "give one of matplotlib's, such as 'o', 'D', '^'"),
    "size": ("a size of markers", lambda x: _is_number(x) and 0 < x <= LARGEST_SIZE, _SIZE),
    "box": ("a box", _is_box, "give two opposite corners, the lower one first: ((0, 0), (1, 2))"),
}
