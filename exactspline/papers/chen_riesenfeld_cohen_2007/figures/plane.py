"""Figures 1 to 3: critical curvature by squaring and by the direct approach, and the evolute of an ellipse."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast

from exactspline.display.figures import Drawn
from exactspline.display.plot.canvas import GREEN, ORANGE, PAGE, SILVER, VERMILLION, legend_below, new_figure
from exactspline.display.plot.curves import plot_curve, plot_evolute, plot_features, plot_quotient
from exactspline.display.plot.functions import draw_roots, plot_function
from exactspline.errors import counted
from exactspline.geometry.analysis.curves import analyse
from exactspline.geometry.derived.constructions import construction
from exactspline.interchange.examples import example
from exactspline.language.rational import Rational
from exactspline.numbers.exact import mpq
from exactspline.papers import find
from exactspline.polynomials.factors import superscript
from exactspline.readings.printing import print_latex
from exactspline.readings.tree import trace
from exactspline.splines.bspline import BSpline
from exactspline.splines.lowest_terms import SplineVector, control_point_count
from exactspline.splines.nurbs import Nurbs
from exactspline.verification.kinds.examples import extrema_at_ends

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.legend import Legend

#: A trimmed graph is shown up to this many times the median of its absolute values.
TRIMMED = 8
#: The forms that squaring and the direct approach solve, of the construction ``critical_curvature``.
SQUARING = "squaring"


def captioned(figure: Figure, number: int, caption: str, scenes: tuple[object, ...] = ()) -> Drawn:
    """The figure and its caption, which is shown as text of the surrounding page."""
    return Drawn(figure, f"Fig. {number}. {caption}", scenes)


def cost(value: BSpline | SplineVector) -> str:
    """The degree and number of control points of a representation.

    >>> cost(find("g2")(example("ellipse")))
    'degree 12, 52 control points'
    """
    return f"degree {value.degree}, {control_point_count(value)} control points"


def figure_1() -> Drawn:
    """Critical points of the curvature of a polynomial curve, by squaring and by the direct approach."""
    curve = example("six_segment_cubic")
    figure = new_figure(9, 13)
    grid = figure.add_gridspec(3, 1, height_ratios=[2.2, 1, 1])
    top, middle, bottom = (figure.add_subplot(grid[i]) for i in range(3))
    extrema = analyse(curve).curvature_extrema
    inner, jumps = [f.root for f in extrema if not f.by_jump], [f.root for f in extrema if f.by_jump]
    plot_evolute(curve, plot_curve(curve, top, knots=False))
    # each marker has the same meaning in (a), (b) and (c)
    plot_features(curve, inner, top, label="κ′ = 0", color=GREEN)
    plot_features(curve, jumps, top, label="κ′ changes its sign by a jump", color=GREEN, hollow=True)
    flat = [f.root for f in analyse(curve).inflections]
    plot_features(curve, flat, top, marker="X", label="inflections, κ = 0", color=VERMILLION)
    _crop(top, curve)
    top.set_title("(a) curvature critical points")
    squared = analyse(curve).zero_form("critical_curvature", SQUARING)
    direct = analyse(curve).zero_form("critical_curvature", "direct")
    powers = [
        _graph(squared.form, squared.zeros, middle, "(b) squaring approach"),
        _graph(direct.form, direct.zeros, bottom, "(c) direct approach"),
    ]
    extra = [root for root in squared.zeros if root not in list(direct.zeros)]
    draw_roots(middle, extra, squared.form.domain, "X", VERMILLION, "extra root")
    legend_below(middle, columns=5)
    parts = (
        (
            f"(a) a cubic B-spline curve of {curve.segments} segments, its evolute and the {len(inner)} critical "
            "points where κ′ = 0;"
        ),
        (
            f"of the {len(extrema)} extrema of the curvature {len(jumps)} are at knots where κ′ changes its sign by "
            f"a jump, {extrema_at_ends(curve)} extrema at the ends of one segment."
        ),
        (
            f"(b) the numerator of (κ²)′ raised to the degree of the whole, {cost(squared.form)}; "
            f"{counted(len(squared.zeros), 'root')}, the {counted(len(extra), 'root')} of f0 (κ = 0) among them, which "
            "are extra."
        ),
        f"(c) g0, {cost(direct.form)}; {counted(len(direct.zeros), 'root')}.",
        f"Graphs scaled by {powers[0]} and {powers[1]} and trimmed.",
    )
    return captioned(figure, 1, " ".join(parts))


def _crop(ax: Axes, curve: Nurbs) -> None:
    """Show the control polygon and a margin around it; anything farther away is cropped."""
    sides = []
    for values in zip(*curve.control_points, strict=True):
        margin = (max(values) - min(values)) / 12
        sides.append((float(min(values) - margin), float(max(values) + margin)))
    ax.set_aspect("equal", adjustable="box")
    ax.set_xlim(*sides[0])
    ax.set_ylim(*sides[1])


def _graph(
    f: BSpline, zeros: Any, ax: Axes, title: str, polygon: str = SILVER, mark: str = GREEN, *, whole: bool = False
) -> str:
    """A graph scaled by a power of ten and trimmed, with its polygon and its roots; the power as text. With `whole`
    all of it, large values on a logarithmic scale.
    """
    a, b = f.domain
    values = sorted(abs(f(a + (b - a) * mpq(k, 200))) for k in range(201))
    usual = values[len(values) // 2]
    power = len(str(int(usual))) - 1
    plot_function(f / 10**power, ax, scale="clip", polygon_color=polygon)
    draw_roots(ax, zeros, f.domain, "D", mark)
    legend_below(ax, columns=5)
    height = (2 * values[-1] if whole else min(TRIMMED * usual, values[-1] * mpq(11, 10))) / 10**power
    if whole:
        ax.set_yscale("symlog", linthresh=1, linscale=0.5)
        ax.set_yticks([sign * 10.0**k for sign in (-1, 1) for k in range(3, len(str(int(height))), 3)] + [0])
    ax.set_ylim(float(-height), float(height))
    ax.set_ylabel(f"value · $10^{{{-power}}}$")
    ax.set_title(f"{title}\n{cost(f)}")
    return f"10{superscript(-power)}"


def figure_2() -> Drawn:
    """Critical points of the curvature of a rational curve, by squaring and by eq. (11)."""
    curve = example("ellipse")
    figure = new_figure(PAGE, 5)
    grid = figure.add_gridspec(1, 2)
    left, right = (figure.add_subplot(grid[i]) for i in range(2))
    squared = analyse(curve).zero_form("critical_curvature", SQUARING)
    reduced = analyse(curve).zero_form("critical_curvature", "paper")
    powers = [
        _graph(squared.form, squared.zeros, left, "(a) squaring approach", GREEN, VERMILLION, whole=True),
        _graph(reduced.form, reduced.zeros, right, "(b) direct approach", GREEN, VERMILLION),
    ]
    inset = right.inset_axes((0.02, 0.66, 0.27, 0.32))
    plot_curve(curve, inset, knots=False, polygon_color=GREEN)
    plot_features(curve, reduced.zeros, inset, color=VERMILLION, size=5)
    cast("Legend", inset.get_legend()).remove()
    inset.set_axis_off()
    smooth = {min(f.continuity_at(t) for t in f.breakpoints[1:-1]) for f in (squared.form, reduced.form)}
    stored = {min(f.continuity) for f in (squared.form, reduced.form)}
    parts = (
        (
            "(a) the graph of the numerator of (κ²)′ of an ellipse γ, raised to the degree of the whole, "
            f"{cost(squared.form)}, scaled by {powers[0]}, on a logarithmic scale beyond ±1."
        ),
        (
            f"(b) the ellipse and the graph of g2, eq. (11), {cost(reduced.form)}, scaled by {powers[1]}. Control "
            "polygons in green."
        ),
        f"{len(squared.zeros)} and {counted(len(reduced.zeros), 'root')}, the rightmost being the leftmost.",
        (
            f"Both graphs are C{'/'.join(map(superscript, smooth))} in a C{'/'.join(map(superscript, stored))} "
            "representation."
        ),
    )
    return captioned(figure, 2, " ".join(parts))


def figure_3() -> Drawn:
    """The evolute of an ellipse, naive and reduced."""
    curve = example("ellipse")
    figure = new_figure(PAGE, 5.6)
    made, costs = construction("evolute"), []
    for i, variant in enumerate(made.unlifted):
        value = made.on(curve, variant)
        assert isinstance(value, Rational)
        ax = plot_curve(curve, figure.add_subplot(1, 2, i + 1), control_polygon=False, knots=False)
        plot_quotient(value, ax, label="evolute", color=ORANGE, polygon_color=GREEN)
        costs.append(cost(value))
        ax.set_title(f"({'ab'[i]}) $E = {print_latex(trace(find(made.variants[variant]), 2))}$\n{costs[-1]}")
    printed = cost(find("evolute_of_caption")(curve))
    return captioned(
        figure,
        3,
        f"Evolute of an ellipse: (a) naive, {costs[0]}; (b) reduced, {costs[1]}. The formula that the paper's caption "
        f"prints has {printed}. Control polygons in green.",
    )
