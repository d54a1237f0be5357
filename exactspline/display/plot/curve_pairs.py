"""Two curves and what they have in common: the plane, and the rectangle of their parameters next to it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from exactspline.display.plot.canvas import BLACK, GREEN, VERMILLION, draw, legend_below, new_figure, parameter
from exactspline.display.plot.curves import plot_curve
from exactspline.geometry.analysis.pairs import CurvePair
from exactspline.geometry.pairs.intersections import Overlap
from exactspline.numbers.exact import mpq
from exactspline.reals.real import Real

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Points along an arc.
SAMPLES = 60


def pair_figure(pair: CurvePair) -> Figure:
    """A figure with the curves on the left, and on the right the rectangle of their parameters: common points and
    arcs, and, if there are none, the nearest pairs and arcs of such pairs.

    >>> from exactspline import Nurbs, example
    >>> pair = CurvePair(example("circle"), Nurbs(1, [0, 0, 1, 1], [(0, 0), (2, 0)]))
    >>> [ax.get_xlabel() for ax in pair_figure(pair).axes]
    ['', 's']
    """
    figure = new_figure(10, 5)
    flat = pair.curves[0].dimension == 2
    place = figure.add_subplot(1, 2, 1, projection=None if flat else "3d")
    for curve, color in zip(pair.curves, (BLACK, GREEN), strict=True):
        plot_curve(curve, place, control_polygon=False, knots=False, color=color)
    rectangle = figure.add_subplot(1, 2, 2)
    common = pair.intersections
    meet = common.points or common.everywhere
    _draw_rectangle(pair, (common if meet else pair.distance).everywhere, rectangle)
    for s, t in [(p.first, p.second) for p in (common.points if meet else pair.distance.pairs)]:
        at = [_number(s, pair, 0), _number(t, pair, 1)]
        draw(rectangle, [at], "o", color=VERMILLION)
        draw(place, [curve(x) for curve, x in zip(pair.curves, at, strict=True)], "o-", color=VERMILLION)
    legend_below(place)
    return figure


def _draw_rectangle(pair: CurvePair, arcs: Sequence[Overlap], ax: Axes) -> None:
    (a, b), (c, d) = (curve.domain for curve in pair.curves)
    draw(ax, [(a, c), (b, c), (b, d), (a, d), (a, c)], color=BLACK, linewidth=1)
    for k, curve in enumerate(pair.curves):
        for t in curve.breakpoints[1:-1]:
            ends = [(t, c), (t, d)] if k == 0 else [(a, t), (b, t)]
            draw(ax, ends, color="lightgrey", linewidth=0.7)
    for arc in arcs:
        first, second = ([_number(x, pair, k) for x in ends] for k, ends in enumerate((arc.first, arc.second)))
        draw(ax, _along(arc.numerator, arc.denominator, arc.of_second, first, second), color=VERMILLION, linewidth=2)
    ax.set_xlabel("s")
    ax.set_ylabel("t")


def _along(
    top: tuple[int, ...] | None, bottom: tuple[int, ...] | None, of_second: bool, first: list[mpq], second: list[mpq]
) -> list[tuple[mpq, mpq]]:
    """Points of the parameters along a common arc."""
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
