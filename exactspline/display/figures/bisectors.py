"""Figures 4 to 6: bisectors of a point and a curve with an explicit directrix and directly, and the planar bisector
inside both.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast

from exactspline.display.figures.plane import Drawn, captioned
from exactspline.display.plot.canvas import GREEN, VERMILLION, PlotError, Point, Run, new_figure, sampled
from exactspline.display.plot.curves import plot_curve, plot_quotient
from exactspline.display.plot.html import Scene
from exactspline.display.plot.meshes import SurfaceMesh, ruled_mesh
from exactspline.display.plot.surfaces import mark_points, plot_mesh
from exactspline.exact import mpq
from exactspline.papers import find
from exactspline.splines.examples import example
from exactspline.splines.lowest_terms import control_point_count
from exactspline.splines.values import RationalSurface

if TYPE_CHECKING:
    from matplotlib.figure import Figure

EXPLICIT, DIRECT = "point_bisector_polynomial", "point_bisector_direct_z"
TITLES = ("(a) explicit directrix approach", "(b) direct approach")
#: Where the figures are seen from: height and turn, in degrees.
VIEW = (22, -60)
#: Curve, point, and the bounds of the ruling parameter in both approaches: in the second it is the height itself.
HELIX = ("helix_like", (mpq(1, 3), mpq(1, 4), mpq(1)), (("-1/4", "1/4"), ("-1/2", "5/2")))
ELLIPSE = ("ellipse_in_space", (mpq(1, 2), mpq(1, 4), mpq(0)), (("-1/4", "1/4"), ("-3/2", "3/2")))


def figure_4() -> Drawn:
    """Bisector of a point and a helix-like curve."""
    return _compared(4, "a space point (in grey) and a helix-like quadratic space curve", *HELIX)


def figure_5() -> Drawn:
    """Bisector of a point and an ellipse."""
    return _compared(5, "a point (in grey) and an ellipse in its plane", *ELLIPSE)


def _surfaces(name: str, point: Point, rulings: Any) -> list[tuple[RationalSurface, SurfaceMesh]]:
    argument = example(name).with_point(point)
    found = [find(formula)(argument) for formula in (EXPLICIT, DIRECT)]
    return [(surface, ruled_mesh(surface, bounds)) for surface, bounds in zip(found, rulings, strict=True)]


def _frame(figure: Figure, i: int, name: str, mesh: SurfaceMesh, point: Point, title: str, *, net: bool) -> Any:
    ax = plot_curve(example(name), figure.add_subplot(1, 2, i + 1, projection="3d"), control_polygon=False, knots=False)
    plot_mesh(mesh, ax, label="bisector", control_net=net, net_color=GREEN)
    mark_points(ax, [point], "point")
    cast(Any, ax).view_init(*VIEW)  # axes in space
    ax.set_title(title)
    return ax


def _scene(name: str, mesh: SurfaceMesh, point: Point, title: str, *more: tuple[str, list[Run]]) -> Scene:
    curve = example(name)
    runs = [[p for _, p in part] for part in sampled(curve, curve.breakpoints)]
    return Scene(title, mesh, [(name, runs), *more], [("point", point)])


def _compared(number: int, what: str, name: str, point: Point, rulings: Any) -> Drawn:
    figure, scenes, counts = new_figure(13, 7), [], []
    for i, (surface, mesh) in enumerate(_surfaces(name, point, rulings)):
        title = f"{TITLES[i]} (degree = {surface.degree})"
        _frame(figure, i, name, mesh, point, title, net=True)
        scenes.append(_scene(name, mesh, point, title))
        counts.append(
            f"({'ab'[i]}) degree {surface.degree}, {control_point_count(surface.joined)} control points along the curve"
        )
    caption = (
        f"Bisector of {what}: {'; '.join(counts)}. Rulings between bounds of the ruling parameter, which "
        "is the height in (b); nets in green."
    )
    return captioned(figure, number, caption, tuple(scenes))


def figure_6() -> Drawn:
    """The planar bisector inside both surfaces of Figure 5."""
    name, point, rulings = ELLIPSE
    plane = find("plane_bisector_polynomial")(example("ellipse").with_point(point[:2]))
    figure, scenes = new_figure(13, 7), []
    for i, (surface, mesh) in enumerate(_surfaces(name, point, rulings)):
        iso_curve = surface.directrix
        if any(iso_curve[k] != plane[k] for k in range(2)) or not iso_curve[2].is_zero:
            raise PlotError("the planar bisector is no iso-curve of the surface", where=f"figure 6{TITLES[i][:3]}")
        ax = _frame(figure, i, name, mesh, point, TITLES[i], net=False)
        plot_quotient(iso_curve, ax, control_polygon=False, color=VERMILLION, label="planar bisector")
        runs = [[p for _, p in part] for part in sampled(iso_curve.point, iso_curve.denominator.breakpoints)]
        scenes.append(_scene(name, mesh, point, TITLES[i], ("planar bisector", runs)))
    caption = (
        f"The planar bisector of Figure 5, of degree {plane.degree}, is the iso-curve of the ruled "
        "bisector at ruling parameter 0 in both."
    )
    return captioned(figure, 6, caption, tuple(scenes))
