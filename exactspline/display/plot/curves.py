"""Curves with their control polygons, marked points, and evolutes."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, cast

from exactspline.display.plot.canvas import (
    BLACK,
    GREEN,
    GREY,
    LARGEST,
    SILVER,
    VERMILLION,
    Box,
    Point,
    Run,
    axes_for,
    box_around,
    check_options,
    draw,
    draw_polygons,
    exact_box,
    grown,
    homogeneous,
    inside,
    kept,
    legend_below,
    legend_once,
    longer_side,
    new_figure,
    parameter,
    polygons,
    runs_between_gaps,
    sampled,
    shown_name,
    usual_box,
)
from exactspline.errors import ShapeError, a_kind, as_items
from exactspline.geometry.analysis.pairs import CurvePair
from exactspline.geometry.curves.kinds import Feature
from exactspline.geometry.derived.derive import derive
from exactspline.geometry.pairs.intersections import Overlap
from exactspline.language.rational import Rational
from exactspline.language.ruled import split
from exactspline.language.vector import Vector
from exactspline.numbers.exact import Number, mpq
from exactspline.numbers.intervals import Side
from exactspline.reals.real import Real
from exactspline.roots.root import Root
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


#: The margin around the box of a curve in which its evolute is shown, in multiples of the longer side of the box.
REACH = mpq(1, 2)
#: Knots lie on top of marks: where both are at one point, the knot is the dot in the middle of the mark.
KNOTS = 7


def plot_curve(
    curve: Nurbs,
    ax: Axes | None = None,
    *,
    control_polygon: bool = True,
    knots: bool = True,
    label: str | None = None,
    polygon_color: str = SILVER,
    color: str | None = None,
) -> Axes:
    """Draw a curve in the plane or in space: its segments in alternating shades (or in one `color`, if it is given),
    its control polygon, and its knots as dots on the curve.

    The polygon is interrupted where the curve has a knot of multiplicity degree + 1, and at a control point of weight 0
    (a direction, not a point).

    >>> from exactspline.interchange.examples import example
    >>> ax = plot_curve(example("circle"))
    >>> [text.get_text() for text in ax.get_legend().get_texts()]
    ['control polygon (9 points)', 'circle', 'every second segment', 'knots']

    Raises `PlotError` without matplotlib, for a curve neither in the plane nor in space, for axes that do not fit, and
    for numbers beyond 1e100.
    """
    check_options(control_polygon=control_polygon, knots=knots, label=label, polygon_color=polygon_color)
    if color is not None:
        check_options(color=color)
    ax = axes_for(ax, curve_of(curve).dimension)
    if control_polygon:
        points = [point if weight else None for point, weight in zip(curve.control_points, curve.weights, strict=True)]
        draw_polygons(ax, polygons(curve.knots.knots, curve.degree, points), len(points), color=polygon_color)
    name = shown_name(curve) if label is None else label
    shades = [name, "_every second segment" if color or name.startswith("_") else "every second segment"]
    for i, samples in enumerate(sampled(curve, curve.breakpoints)):
        shown_as = shades[i] if i < len(shades) else "_segment"
        shade = color or (GREY if i % 2 else BLACK)
        draw(ax, [p for _, p in samples], color=shade, linewidth=2.2, label=shown_as, zorder=3)
    if knots:
        ends = dict.fromkeys(curve(t, side) for t in curve.breakpoints for side in Side)
        draw(ax, ends, "o", color=BLACK, markerfacecolor="white", markersize=3.5, label="knots", zorder=KNOTS)
    ax.set_aspect("equal", adjustable="box" if ax.name == "3d" else "datalim")
    legend_below(ax)
    return ax


def plot_features(
    curve: Nurbs,
    points: Iterable[Feature | Root | Number],
    ax: Axes | None,
    *,
    marker: str = "D",
    label: str = "",
    color: str = GREEN,
    size: float = 7,
    hollow: bool = False,
) -> Axes:
    """Mark parameters on a curve: exact numbers, certified roots, or any object whose `parameter` is a number or a
    root. `hollow` markers have their colour only at the edge.

    >>> from exactspline.interchange.examples import example
    >>> ax = plot_features(example("circle"), ["1/2", 3], plot_curve(example("circle")), label="marked")
    >>> [float(x) for x in ax.lines[-1].get_xdata()]
    [0.6, 0.0]

    Raises `DomainError` for a parameter outside the domain, otherwise as `plot_curve`.
    """
    check_options(marker=marker, label=label, color=color, size=size, hollow=hollow)
    ax = axes_for(ax, curve_of(curve).dimension)
    places = [curve(parameter(t, curve.domain)) for t in as_items(points, "parameters")]
    if places:
        edge, face = (color, "white") if hollow else ("white", color)
        colors = {"color": color, "markeredgecolor": edge, "markerfacecolor": face}
        draw(ax, places, marker, markersize=size, label=label or "_features", zorder=KNOTS - 1, **colors)
        legend_below(ax)
    return ax


def plot_evolute(curve: Nurbs, ax: Axes | None = None, *, label: str = "evolute", color: str = VERMILLION) -> Axes:
    """Draw the pieces of the evolute of a plane curve that exist, interrupted at poles; the axes show the part near the
    curve.

    >>> from exactspline.interchange.examples import example
    >>> ax = plot_evolute(example("ellipse"))
    >>> float(max(x for line in ax.lines for x in line.get_xdata()))
    1.5

    Raises `ShapeError` for a curve in space and for a straight one, otherwise as `plot_curve`.
    """
    check_options(label=label, color=color)
    pieces = derive("evolute", curve).pieces
    ax = axes_for(ax)
    box = box_around(point for samples in sampled(curve, curve.breakpoints) for _, point in samples)
    near = grown(box, REACH)
    runs = [run for piece in pieces for run in runs_between_poles(piece.value, grown(near, mpq(1)))]
    limits = ax.dataLim.frozen()
    for i, run in enumerate(runs):
        style = "-" if 1000 * longer_side(box_around(run)) > longer_side(near) else "."
        draw(ax, run, style, color=color, linewidth=1.5, label="_evolute" if i else label, zorder=2.5)
    ax.dataLim.set(limits)
    corners = box_around([*box, *[p for run in runs for p in run if inside(p, near)]])
    ax.update_datalim([[float(x) for x in corner] for corner in corners])
    ax.set_aspect("equal", adjustable="datalim")
    legend_below(ax)
    return ax


def runs_between_poles(value: Rational[BSpline], box: Box) -> list[Run]:
    """The points of a vector `Rational` inside a box, in runs that end at knots, at poles, and at the border of the
    box.
    """
    denominator = value.denominator
    poles = {parameter(t, denominator.domain) for t in zeros(denominator)}

    def near(t: mpq, side: Side | str = Side.RIGHT) -> Point | None:
        point = value.point(t, side=side) if t not in poles and denominator(t, side) else None
        return point if point and inside(point, box) else None

    parts = sampled(near, sorted({*denominator.breakpoints, *poles}))
    return runs_between_gaps(point for part in parts for point in [*[p for _, p in part], None])


def _quotient(value: object) -> Rational[BSpline]:
    """A vector of splines as a quotient; raises `ShapeError` for other values."""
    components, _ = split(cast(Any, value))
    if not isinstance(value, Rational | Vector) or not all(isinstance(x, BSpline) for x in components):
        problem = f"{a_kind(value)}, where a vector or a quotient of splines is expected"
        raise ShapeError(problem, remedy="evaluate a formula on a curve, or use curve.gamma")
    return cast("Rational[BSpline]", value if isinstance(value, Rational) else value / components[0].constant(1))


def plot_quotient(
    value: Rational[BSpline],
    ax: Axes | None = None,
    *,
    control_polygon: bool = True,
    label: str = "curve",
    color: str = VERMILLION,
    polygon_color: str = SILVER,
    box: Box | None = None,
) -> Axes:
    """Draw a derived curve in its computed representation (a vector of splines, or a vector `Rational`) with the
    control polygon of that representation.

    The curve ends at its poles; points and control points outside `box` (by default: far from most others) are omitted.

    >>> from exactspline.interchange.examples import example
    >>> from exactspline.papers import find
    >>> ax = plot_quotient(find("evolute_reduced")(example("ellipse")))
    >>> [text.get_text() for text in ax.get_legend().get_texts()]
    ['control polygon (40 points)', 'curve']

    Raises as `plot_curve`.
    """
    check_options(control_polygon=control_polygon, label=label, color=color, polygon_color=polygon_color, box=box)
    quotient = _quotient(value)
    ax, box = axes_for(ax, len(quotient)), exact_box(box, len(quotient))
    everywhere = (tuple([-LARGEST] * len(quotient)), tuple([LARGEST] * len(quotient)))
    if box is None:
        box = usual_box(
            [p for run in runs_between_poles(quotient, everywhere) for p in run], bool(len(zeros(quotient.denominator)))
        )
    if control_polygon:
        rows, knots, degree = homogeneous(quotient)
        points = [kept(tuple(x / w for x in xs), box) if w else None for *xs, w in rows]
        draw_polygons(ax, polygons(knots, degree, points), len(points), color=polygon_color, hidden=points.count(None))
    for i, run in enumerate(runs_between_poles(quotient, box)):
        style = "-" if longer_side(box_around(run)) else "."
        draw(ax, run, style, color=color, linewidth=2, label="_curve" if i else label, zorder=3)
    ax.set_aspect("equal", adjustable="box" if ax.name == "3d" else "datalim")
    legend_below(ax)
    return ax


# ---- two curves


#: Points along an arc.
SAMPLES = 60


def pair_figure(pair: CurvePair) -> Figure:
    """A figure with the curves on the left, and on the right the rectangle of their parameters: common points and
    arcs, and, if there are none, the nearest pairs and arcs of such pairs.

    >>> from exactspline import Nurbs, example
    >>> pair = CurvePair(example("circle"), Nurbs(1, [0, 0, 1, 1], [(0, 0), (2, 0)]))
    >>> [ax.get_title() for ax in pair_figure(pair).axes]
    ['circle (s) and curve (t)', 'parameters s and t']
    """
    figure = new_figure(10, 5)
    place = figure.add_subplot(1, 2, 1, projection="3d" if pair.curves[0].dimension == 3 else None)
    place.set_title(plot_both(pair.curves, place, GREEN))
    place.locator_params(nbins=5)
    rectangle = figure.add_subplot(1, 2, 2, title="parameters s and t")
    common = pair.intersections
    meet = common.points or common.everywhere
    what = "common" if meet else "nearest"
    _draw_rectangle(pair, (common if meet else pair.distance).everywhere, rectangle, f"{what} arcs")
    for s, t in [(p.first, p.second) for p in (common.points if meet else pair.distance.pairs)]:
        at = [_number(s, pair, 0), _number(t, pair, 1)]
        how = {"color": VERMILLION, "label": f"{what} points", "zorder": 5}
        draw(rectangle, [at], "o", **how)
        draw(place, [curve(x) for curve, x in zip(pair.curves, at, strict=True)], "o-", **how)
    legend_once(place)
    legend_once(rectangle)
    return figure


def plot_both(curves: Sequence[Nurbs], ax: Axes, second: str) -> str:
    """Draw two curves, the first in black and the second in a colour; returns both names, with the letters of their
    parameters.
    """
    names = [f"{shown_name(curve)} ({letter})" for curve, letter in zip(curves, "st", strict=True)]
    for curve, label, color in zip(curves, names, (BLACK, second), strict=True):
        plot_curve(curve, ax, control_polygon=False, knots=False, label=label, color=color)
    return " and ".join(names)


def _draw_rectangle(pair: CurvePair, arcs: Sequence[Overlap], ax: Axes, label: str) -> None:
    (a, b), (c, d) = (curve.domain for curve in pair.curves)
    draw(ax, [(a, c), (b, c), (b, d), (a, d), (a, c)], color=BLACK, linewidth=1)
    for k, curve in enumerate(pair.curves):
        for t in curve.breakpoints[1:-1]:
            ends = [(t, c), (t, d)] if k == 0 else [(a, t), (b, t)]
            draw(ax, ends, color="lightgrey", linewidth=0.7)
    for arc in arcs:
        first, second = ([_number(x, pair, k) for x in ends] for k, ends in enumerate((arc.first, arc.second)))
        along = _along(arc.numerator, arc.denominator, arc.of_second, first, second)
        draw(ax, along, color=VERMILLION, linewidth=2, label=label)
    ax.set_xlabel("s")
    ax.set_ylabel("t")


def _along(
    top: tuple[int, ...] | None, bottom: tuple[int, ...] | None, of_second: bool, first: list[mpq], second: list[mpq]
) -> list[tuple[mpq, mpq]]:
    """Points (s, t) along a common arc, in the rectangle of the parameters."""
    if top is None or bottom is None:
        return list(zip(first, second, strict=True))
    low, high = first if of_second else second
    points = []
    for k in range(SAMPLES + 1):
        x = low + (high - low) * mpq(k, SAMPLES)
        y = _value(top, x) / _value(bottom, x)
        points.append((x, y) if of_second else (y, x))
    return points


def _value(coefficients: tuple[int, ...], x: mpq) -> mpq:
    return sum((c * x**k for k, c in enumerate(coefficients)), mpq(0))


def _number(x: Real, pair: CurvePair, k: int) -> mpq:
    """A rational number near a parameter."""
    return parameter(x.enclosure(20).middle, pair.curves[k].domain)
