"""Surfaces in space: shaded, with their control nets."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from exactspline.language import RuledSurface
from exactspline.plot.canvas import BLUE, GREY, LARGEST, ORANGE, SKY, VERMILLION, PlotError, Point, axes_for, draw, legend_below, library
from exactspline.plot.frames import Box
from exactspline.plot.meshes import SurfaceMesh, ruled_mesh


def plot_mesh(mesh: SurfaceMesh, ax: Any = None, *, label: str = "surface", color: str = SKY, control_net: bool = True, alpha: float = 1) -> Any:
    """A surface given by its points: shaded faces, and its control net with the number of points in the legend.

    Raises `PlotError` without matplotlib, for axes in the plane, where nothing is left to draw, and for numbers beyond 1e100.
    """
    ax = axes_for(ax, 3)
    faces = mesh.faces
    if not faces:
        raise PlotError("the surface has no face in what is shown", where="box", remedy="choose other rulings or a larger box")
    if any(abs(x) > LARGEST for face in faces for p in face for x in p):
        raise PlotError("a number beyond 1e100", remedy="scale the data")
    corners = [[tuple(float(x) for x in p) for p in face] for face in faces]
    made = library("mpl_toolkits.mplot3d.art3d").Poly3DCollection(
        corners, facecolors=color, edgecolors=color, shade=True, linewidths=0.1, alpha=alpha
    )
    made.set_label(label)
    ax.add_collection3d(made)
    if control_net and mesh.net:
        for run in mesh.net:
            draw(ax, run, color=GREY, linewidth=0.6, label="_net")
        draw(ax, dict.fromkeys(p for run in mesh.net for p in run), "o", color=BLUE, markersize=2.5, label=_counted(mesh))
    _framed(ax, [p for face in faces for p in face])
    legend_below(ax)
    return ax


def _counted(mesh: SurfaceMesh) -> str:
    hidden = f", {mesh.hidden} far away or at infinity" if mesh.hidden else ""
    return f"control net ({mesh.points} points{hidden})"


def _framed(ax: Any, points: Iterable[Point]) -> None:
    """Equal scales on the three axes, and all points in sight."""
    columns = [[float(x) for x in column] for column in zip(*points, strict=True)]
    ax.auto_scale_xyz(*columns)
    ax.set_aspect("equal")


def plot_ruled_surface(
    surface: RuledSurface,
    rulings: tuple[Any, Any] = (-1, 1),
    ax: Any = None,
    *,
    label: str = "ruled surface",
    color: str = SKY,
    control_net: bool = True,
    box: Box | None = None,
    alpha: float = 1,
) -> Any:
    """The part of a ruled surface in the spline reading between two ruling parameters: shaded, with its control net.

    Where its denominator has a zero the surface goes to infinity: it is cut there, and what is far from most of it is not shown (nor outside
    `box`, two opposite corners, when that is given).

    >>> from exactspline.curves import example
    >>> from exactspline.formulas import find
    >>> ax = plot_ruled_surface(find("tangent_developable_reduced")(example("rational_space_cubic")), (0, 1))
    >>> ax.name, ax.get_legend().get_texts()[-1].get_text()
    ('3d', 'control net (12 points)')

    Raises `ShapeError` for anything but a ruled surface of splines in space, otherwise as `plot_mesh`.
    """
    return plot_mesh(ruled_mesh(surface, rulings, box), ax, label=label, color=color, control_net=control_net, alpha=alpha)


def mark_points(ax: Any, points: Iterable[Point], label: str, color: str = VERMILLION) -> Any:
    """Single points in space, such as the one that a bisector belongs to."""
    draw(axes_for(ax, 3), points, "o", color=color, markersize=7, markeredgecolor=ORANGE, label=label)
    legend_below(ax)
    return ax
