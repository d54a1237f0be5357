"""Curves with their control polygons, marked points, and evolutes."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from gmpy2 import mpq

from exactspline.interrogate import derive
from exactspline.nurbs import Nurbs
from exactspline.plot.canvas import (
    BLACK,
    GREEN,
    GREY,
    VERMILLION,
    Point,
    Run,
    axes_for,
    draw,
    draw_polygons,
    joined,
    legend_below,
    parameter,
    polygons,
    sampled,
    shown_name,
)
from exactspline.zeros import zeros

#: How far an evolute is shown outside the box around its curve, in lengths of the box's longer side.
REACH = mpq(1, 2)
Box = tuple[Point, Point]


def plot_curve(curve: Nurbs, ax: Any = None, *, control_polygon: bool = True, knots: bool = True, label: str | None = None) -> Any:
    """A curve in the plane or in space: its segments in alternating shades, its control polygon, and its knots as dots on the curve.

    The polygon is interrupted where the curve has a knot of multiplicity degree + 1, and at a control point of weight 0 (a direction, no point).

    >>> from exactspline.curves import example
    >>> ax = plot_curve(example("circle"))
    >>> [text.get_text() for text in ax.get_legend().get_texts()]
    ['control polygon (9 points)', 'circle', 'knots']

    Raises `PlotError` without matplotlib, for a curve neither in the plane nor in space, for axes that do not fit, and for numbers beyond 1e100.
    """
    ax = axes_for(ax, curve.dimension)
    if control_polygon:
        points = [point if weight else None for point, weight in zip(curve.control_points, curve.weights, strict=True)]
        draw_polygons(ax, polygons(curve.knots.knots, curve.degree, points), len(points))
    for i, samples in enumerate(sampled(curve, curve.breakpoints)):
        shown_as = "_segment" if i else shown_name(curve) if label is None else label
        draw(ax, [p for _, p in samples], color=GREY if i % 2 else BLACK, linewidth=2.2, label=shown_as, zorder=3)
    if knots:
        ends = dict.fromkeys(curve(t, side) for t in curve.breakpoints for side in ("left", "right"))
        draw(ax, ends, "o", color=BLACK, markerfacecolor="white", markersize=3.5, label="knots", zorder=4)
    ax.set_aspect("equal", adjustable="box" if ax.name == "3d" else "datalim")
    legend_below(ax)
    return ax


def plot_features(curve: Nurbs, points: Iterable[Any], ax: Any, *, marker: str = "D", label: str = "", color: str = GREEN, size: float = 7) -> Any:
    """Mark parameters on a curve: exact numbers, certified roots, or anything that carries one of them as its `parameter`.

    >>> from exactspline.curves import example
    >>> ax = plot_features(example("circle"), ["1/2", 3], plot_curve(example("circle")), label="marked")
    >>> [float(x) for x in ax.lines[-1].get_xdata()]
    [0.6, 0.0]

    Raises `DomainError` for a parameter outside the domain, otherwise as `plot_curve`.
    """
    ax = axes_for(ax, curve.dimension)
    places = [curve(parameter(t, curve.domain)) for t in points]
    if places:
        draw(ax, places, marker, color=color, markeredgecolor="white", markersize=size, label=label or "_features", zorder=6)
        legend_below(ax)
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
    ax = axes_for(ax)
    box = _box(point for samples in sampled(curve, curve.breakpoints) for _, point in samples)
    near = _grown(box, REACH)
    runs = [run for piece in pieces for run in _evolute_runs(piece.value, _grown(near, mpq(1)))]
    limits = ax.dataLim.frozen()
    for i, run in enumerate(runs):
        style = "-" if 1000 * _longer_side(_box(run)) > _longer_side(near) else "."
        draw(ax, run, style, color=color, linewidth=1.5, label="_evolute" if i else label, zorder=2.5)
    ax.dataLim.set(limits)
    ax.update_datalim([[float(x) for x in corner] for corner in _box([*box, *[p for run in runs for p in run if _inside(p, near)]])])
    ax.set_aspect("equal", adjustable="datalim")
    legend_below(ax)
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
    poles = {parameter(t, denominator.domain) for t in zeros(denominator)}

    def near(t: mpq, side: str = "right") -> Point | None:
        point = value(t, side) if t not in poles and denominator(t, side) else None
        return point if point and _inside(point, box) else None

    parts = sampled(near, sorted({*denominator.breakpoints, *poles}))
    return joined(point for part in parts for point in [*[p for _, p in part], None])
