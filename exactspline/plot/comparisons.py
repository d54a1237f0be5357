"""Whole pictures that hold things side by side."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from exactspline.nurbs import Nurbs
from exactspline.plot.canvas import MARKS, legend_below, new_figure, shown_name
from exactspline.plot.curves import plot_curve, plot_evolute, plot_features
from exactspline.plot.functions import draw_roots, marked, plot_function
from exactspline.spline import BSpline


def inspect_figure(curve: Nurbs, panels: Sequence[tuple[str, BSpline, Any]], *, evolute: bool = False) -> Any:
    """One picture: on the left the curve with the parameters of every panel marked, on the right each function with its control polygon.

    A panel is ``(title, function, roots)``, roots as for `plot_function`. With `evolute` a plane curve is drawn with its own. Degrees and numbers of
    control points in the titles are those of the objects. Returns the ``matplotlib.figure.Figure``; raises what the functions above raise.

    >>> from exactspline.constructions import construction
    >>> from exactspline.curves import example
    >>> from exactspline.zeros import zeros
    >>> f = construction("zero_curvature").on(example("cubic_s"), "paper")
    >>> [ax.get_title() for ax in inspect_figure(example("cubic_s"), [("zero curvature", f, zeros(f))]).axes]
    ['cubic_s: degree 3, 4 control points', 'zero curvature: degree 3, 4 control points']
    """
    figure = new_figure(13, max(5.5, 3.4 * len(panels)))
    grid = figure.add_gridspec(max(1, len(panels)), 2 if panels else 1)
    ax = plot_curve(curve, figure.add_subplot(grid[:, 0], projection="3d" if curve.dimension == 3 else None))
    if evolute:
        plot_evolute(curve, ax)
    ax.set_title(f"{shown_name(curve)}: degree {curve.degree}, {len(curve.control_points)} control points")
    for i, (title, f, roots) in enumerate(panels):
        marker, color = MARKS[i % len(MARKS)]
        panel = plot_function(f, figure.add_subplot(grid[i, 1]))
        draw_roots(panel, roots, f.domain, marker, color)
        legend_below(panel)
        panel.set_title(f"{title}: degree {f.degree}, {len(f.control_points)} control points")
        single, jumps = marked(roots)
        size = 7 + 3 * (len(panels) - 1 - i)
        plot_features(curve, [*single, *jumps], ax, marker=marker, color=color, label=f"zeros of {title}", size=size)
    return figure
