"""Figures 4 to 6: bisectors of a point and a curve by the explicit directrix and by the direct approach, and the planar
bisector in both.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

from exactspline.display.figures import Drawn
from exactspline.display.plot.canvas import (
    BLACK,
    GREEN,
    PAGE,
    VERMILLION,
    PlotError,
    Point,
    Run,
    new_figure,
    sampled,
    three_ticks,
)
from exactspline.display.plot.curves import plot_curve, plot_quotient
from exactspline.extras.pictures3d.html import Scene
from exactspline.extras.pictures3d.meshes import SurfaceMesh, ruled_mesh
from exactspline.extras.pictures3d.surfaces import mark_points, plot_mesh
from exactspline.interchange.examples import example
from exactspline.numbers.exact import mpq
from exactspline.papers import find
from exactspline.papers.chen_riesenfeld_cohen_2007.figures.plane import captioned
from exactspline.splines.lowest_terms import RationalSurface, control_point_count

if TYPE_CHECKING:
    from matplotlib.figure import Figure

EXPLICIT, DIRECT = "point_bisector_polynomial", "point_bisector_direct_z"
TITLES = ("(a) explicit directrix approach", "(b) direct approach")
#: The view of the figures: elevation and azimuth, in degrees.
VIEW = (22, -60)
#: The scene with its axes and their names fits into its frame.
ZOOM = 0.8


class Shown(NamedTuple):
    """A curve, a point, the heights between which their bisector is shown, and the bounds of the ruling parameter for
    the control nets; in the direct approach this parameter is the height.
    """

    curve: str
    point: Point
    heights: tuple[str, str]
    explicit: tuple[str, str]


HELIX = Shown("helix_like", (mpq(1, 3), mpq(1, 4), mpq(1)), ("-1/2", "5/2"), ("-1/4", "1/4"))
ELLIPSE = Shown("ellipse_in_space", (mpq(1, 2), mpq(1, 4), mpq(0)), ("-3/2", "3/2"), ("-1/8", "1/8"))


def figure_4() -> Drawn:
    """Bisector of a point and a helix-like curve."""
    return _compared(4, "a space point (in grey) and a helix-like quadratic space curve", HELIX)


def figure_5() -> Drawn:
    """Bisector of a point and an ellipse."""
    return _compared(5, "a point (in grey) and an ellipse in its plane", ELLIPSE)


def _surfaces(shown: Shown) -> list[tuple[RationalSurface, SurfaceMesh]]:
    """The surface by both approaches: the same part of it, cut at the same heights, with both nets."""
    argument = example(shown.curve).with_point(shown.point)
    surfaces = [find(formula)(argument) for formula in (EXPLICIT, DIRECT)]
    nets = (shown.explicit, shown.heights)
    return [(s, ruled_mesh(s, net, heights=shown.heights)) for s, net in zip(surfaces, nets, strict=True)]


def _frame(figure: Figure, i: int, shown: Shown, mesh: SurfaceMesh, title: str, *, net: bool) -> Any:
    curve = example(shown.curve)
    ax = figure.add_subplot(1, 2, i + 1, projection="3d")
    plot_curve(curve, ax, control_polygon=False, knots=False, color=BLACK)
    plot_mesh(mesh, ax, label="bisector", control_net=net, net_color=GREEN)
    mark_points(ax, [shown.point], "point")
    ax.set_title(title)
    return ax


def _alike(frames: Sequence[Any]) -> None:
    """Give all frames one camera, one scale and the same few ticks, so that each contains its whole scene."""
    bounds = {axis: list(zip(*[getattr(ax, f"get_{axis}lim")() for ax in frames], strict=True)) for axis in "xyz"}
    longest = max(max(high) - min(low) for low, high in bounds.values())
    for axis, (lows, highs) in bounds.items():
        low, high = min(lows), max(highs)
        for ax in frames:
            getattr(ax, f"set_{axis}lim")(low, high)
            getattr(ax, f"{axis}axis").set_ticks([float(x) for x in three_ticks(low, high, longest)])
            getattr(ax, f"set_{axis}label")(axis)
    for ax in frames:
        ax.set_box_aspect([high - low for low, high in (getattr(ax, f"get_{axis}lim")() for axis in "xyz")], zoom=ZOOM)
        ax.view_init(*VIEW)


def _scene(shown: Shown, mesh: SurfaceMesh, title: str, *more: tuple[str, list[Run]]) -> Scene:
    curve = example(shown.curve)
    runs = [[p for _, p in part] for part in sampled(curve, curve.breakpoints)]
    return Scene(title, mesh, [(shown.curve, runs), *more], [("point", shown.point)])


def _compared(number: int, what: str, shown: Shown) -> Drawn:
    figure, scenes, counts, frames = new_figure(PAGE, 5.2), [], [], []
    for i, (surface, mesh) in enumerate(_surfaces(shown)):
        title = f"{TITLES[i]} (degree = {surface.degree})"
        frames.append(_frame(figure, i, shown, mesh, title, net=True))
        scenes.append(_scene(shown, mesh, title))
        counts.append(
            f"({'ab'[i]}) degree {surface.degree}, {control_point_count(surface.joined)} control points along the curve"
        )
    _alike(frames)
    caption = (
        f"Bisector of {what}, the same part of it in both: heights from {_minus(shown.heights[0])} to "
        f"{shown.heights[1]}; {'; '.join(counts)}. In green the nets, in (a) between the ruling parameters "
        f"{_minus(shown.explicit[0])} and {shown.explicit[1]}, in (b) between the two heights."
    )
    return captioned(figure, number, caption, tuple(scenes))


def _minus(text: str) -> str:
    return text.replace("-", "−")


def figure_6() -> Drawn:
    """The planar bisector in both surfaces of Figure 5."""
    plane = find("plane_bisector_polynomial")(example("ellipse").with_point(ELLIPSE.point[:2]))
    figure, scenes, frames = new_figure(PAGE, 5.2), [], []
    for i, (surface, mesh) in enumerate(_surfaces(ELLIPSE)):
        iso_curve = surface.directrix
        if any(iso_curve[k] != plane[k] for k in range(2)) or not iso_curve[2].is_zero:
            raise PlotError("the planar bisector is not an iso-curve of the surface", where=f"figure 6{TITLES[i][:3]}")
        ax = _frame(figure, i, ELLIPSE, mesh, TITLES[i], net=False)
        plot_quotient(iso_curve, ax, control_polygon=False, color=VERMILLION, label="planar bisector")
        frames.append(ax)
        runs = [[p for _, p in part] for part in sampled(iso_curve.point, iso_curve.denominator.breakpoints)]
        scenes.append(_scene(ELLIPSE, replace(mesh, net=[]), TITLES[i], ("planar bisector", runs)))
    _alike(frames)
    caption = (
        f"The planar bisector of Figure 5, of degree {plane.degree}, is the iso-curve of the ruled "
        "bisector at ruling parameter 0 in both."
    )
    return captioned(figure, 6, caption, tuple(scenes))
