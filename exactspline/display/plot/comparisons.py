"""Whole pictures that compare several things."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import compress
from math import log10
from typing import TYPE_CHECKING, cast

from exactspline.display.numbers import rounded_down
from exactspline.display.plot.canvas import (
    BLACK,
    GREEN,
    MARKS,
    ORANGE,
    PAGE,
    SKY,
    VERMILLION,
    axes_for,
    legend_below,
    legend_once,
    new_figure,
    shown_name,
)
from exactspline.display.plot.curves import plot_curve, plot_evolute, plot_features
from exactspline.display.plot.functions import draw_roots, plot_function
from exactspline.errors import counted
from exactspline.geometry.analysis.curves import QUESTIONS, analyse, questions_about
from exactspline.geometry.curves.facts import among, located
from exactspline.geometry.curves.joints import Joint
from exactspline.geometry.curves.kinds import Feature, FeatureKind, kind_name
from exactspline.questions.entry import Answered
from exactspline.roots.root import Root, knot_root
from exactspline.roots.zero_set import ZeroSet
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


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
