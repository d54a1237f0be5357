"""Surfaces in space: shaded, with their control nets; bisectors."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import hypot
from typing import TYPE_CHECKING, Any

from exactspline.display.plot.canvas import (
    BLACK,
    BLUE,
    GREY,
    LARGEST,
    SKY,
    Box,
    PlotError,
    Point,
    axes_for,
    check_options,
    draw,
    draw_runs,
    exact_box,
    legend_below,
    library,
    three_ticks,
)
from exactspline.display.plot.curves import plot_quotient
from exactspline.errors import FormulaError, ShapeError, as_items, as_text, counted
from exactspline.extras.pictures3d.meshes import SurfaceMesh, ruled_mesh, tensor_mesh
from exactspline.language.arguments import Curve
from exactspline.language.kinds import PAIR, PLANE_POINT, POINT_IN_SPACE, Kind
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector
from exactspline.numbers.exact import Number, rational
from exactspline.papers import find
from exactspline.splines.bspline import BSpline
from exactspline.splines.lowest_terms import SplineSurface
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.tensor import TensorSpline, surface_pair
from exactspline.splines.type_checks import curve_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: The direction of the light (a unit vector), and the brightness of a face turned away from it.
LIGHT, SHADOW = (0.48, -0.6, 0.64), 0.45
#: The opacity of a surface.
OPACITY = 0.7


def plot_mesh(
    mesh: SurfaceMesh,
    ax: Axes | None = None,
    *,
    label: str = "surface",
    color: str = SKY,
    control_net: bool = True,
    net_color: str = GREY,
) -> Axes:
    """A surface given by its points: translucent shaded faces, lines of constant parameters, and its control net with
    the number of points in the legend.

    Raises `PlotError` without matplotlib, for axes in the plane, where nothing can be drawn, and for numbers beyond
    1e100.
    """
    check_options(label=label, color=color, control_net=control_net, net_color=net_color)
    ax = axes_for(ax, 3)
    space: Any = ax  # matplotlib's axes in space have no types
    faces = mesh.faces
    if not faces:
        raise PlotError(
            "the surface has no face in what is shown", where="box", remedy="choose other rulings or a larger box"
        )
    if any(abs(x) > LARGEST for face in faces for p in face for x in p):
        raise PlotError("a number beyond 1e100", remedy="scale the data")
    rgb = library("matplotlib.colors").to_rgb(color)
    corners = [[tuple(float(x) for x in p) for p in face] for face in faces]
    shades = [shaded(face, rgb) for face in corners]
    space.plot([], [], [], "s", color=color, markersize=9, label=label)
    show_faces(space, corners, shades)
    draw_runs(ax, mesh.isolines(), "_isoline", color=[0.4 * c for c in rgb], linewidth=0.4, alpha=0.5, zorder=1.5)
    if control_net and mesh.net:
        draw_runs(ax, mesh.net, "_net", color=net_color, linewidth=0.6, zorder=2)
        points = dict.fromkeys(p for run in mesh.net for p in run)
        draw(ax, points, "o", color=BLUE, markersize=2.5, label=_counted(mesh), zorder=2.1)
    frame_faces(ax, corners)
    legend_below(ax)
    return ax


def show_faces(ax: Axes, faces: Sequence[Sequence[Sequence[float]]], shades: Sequence[Sequence[float]]) -> None:
    """Draw translucent faces in these colours; what is drawn later is seen through them."""
    space: Any = ax  # axes in space have no types
    made = library("mpl_toolkits.mplot3d.art3d").Poly3DCollection(
        faces, facecolors=shades, alpha=OPACITY, linewidths=0, zorder=1, label="_surface"
    )
    # thousands of faces are a picture inside an SVG, not as many paths
    made.set_rasterized(True)
    space.add_collection3d(made)
    space.computed_zorder = False
    space.set_proj_type("ortho")


def frame_faces(ax: Axes, faces: Sequence[Sequence[Sequence[float]]]) -> None:
    """Set equal scales on the three axes, with all faces visible."""
    space: Any = ax  # axes in space have no types
    space.auto_scale_xyz(*zip(*[p for face in faces for p in face], strict=True))
    space.set_aspect("equal")
    _tick(space)


def shaded(corners: Sequence[Sequence[float]], color: tuple[float, float, float]) -> tuple[float, ...]:
    """The colour of a face by its angle to the light, the same for both of its sides."""
    (px, py, pz), (qx, qy, qz), (rx, ry, rz), *more = corners
    sx, sy, sz = more[0] if more else (rx, ry, rz)
    ax, ay, az, bx, by, bz = rx - px, ry - py, rz - pz, sx - qx, sy - qy, sz - qz
    normal = (ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)
    length = hypot(*normal)
    slope = abs(sum(n * light for n, light in zip(normal, LIGHT, strict=True))) / length if length else 1.0
    return tuple(c * (SHADOW + (1 - SHADOW) * slope) for c in color)


def _counted(mesh: SurfaceMesh) -> str:
    hidden = f", {mesh.hidden} far away or at infinity" if mesh.hidden else ""
    return f"control net ({mesh.points} points{hidden})"


def show_box(ax: Axes, box: Box) -> None:
    """Let axes in space show a box, in equal scales, with a few ticks."""
    space: Any = ax  # axes in space have no types
    for axis, low, high in zip("xyz", *box, strict=True):
        getattr(space, f"set_{axis}lim")(float(low), float(high))
    space.set_aspect("equal")
    _tick(space)


def _tick(space: Any) -> None:
    sides = {axis: getattr(space, f"get_{axis}lim")() for axis in "xyz"}
    longest = max(high - low for low, high in sides.values())
    for axis, (low, high) in sides.items():
        getattr(space, f"{axis}axis").set_ticks([float(x) for x in three_ticks(low, high, longest)])


def plot_ruled_surface(
    surface: SplineSurface,
    rulings: tuple[Number, Number] = (-1, 1),
    ax: Axes | None = None,
    *,
    label: str = "ruled surface",
    color: str = SKY,
    control_net: bool = True,
    net_color: str = GREY,
    box: Box | None = None,
) -> Axes:
    """Draw the part of a ruled surface between two ruling parameters, shaded, with its control net.

    The surface is cut where it goes to infinity. Points outside `box` (two opposite corners), by default points far
    from most of the surface, are not shown.

    >>> from exactspline.interchange.examples import example
    >>> from exactspline.papers import find
    >>> ax = plot_ruled_surface(find("tangent_developable_reduced")(example("rational_space_cubic")), (0, 1))
    >>> ax.name, ax.get_legend().get_texts()[-1].get_text()
    ('3d', 'control net (12 points)')

    Raises `ShapeError` for anything but a ruled surface of splines in space, and the errors of `plot_mesh`.
    """
    check_options(label=label, color=color, control_net=control_net, net_color=net_color, box=box)
    mesh = ruled_mesh(surface, rulings, exact_box(box, 3))
    return plot_mesh(mesh, ax, label=label, color=color, control_net=control_net, net_color=net_color)


def plot_surface(
    surface: Vector[TensorSpline] | Rational[TensorSpline],
    ax: Axes | None = None,
    *,
    label: str = "surface",
    control_net: bool = True,
    box: Box | None = None,
) -> Axes:
    """Draw a tensor-product surface, shaded, with its control net. The surface is cut where it goes to infinity.

    >>> from exactspline.language import Vector
    >>> from exactspline.splines.tensor import TensorSpline
    >>> nets = [[0, 0], [1, 1]], [[0, 1], [0, 1]], [[0, 0], [0, 1]]
    >>> s, t, st = (TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], net) for net in nets)
    >>> plot_surface(Vector(s, t, st)).get_legend().get_texts()[-1].get_text()
    'control net (4 points)'

    Raises `ShapeError` for anything but a vector of three `TensorSpline` or its quotient, and the errors of
    `plot_mesh`.
    """
    check_options(label=label, control_net=control_net, box=box)
    axes = axes_for(ax, 3)
    return plot_mesh(tensor_mesh(surface, exact_box(box, 3)), axes, label=label, control_net=control_net)


def plot_bisector(
    curve: Nurbs,
    other: Nurbs | Iterable[Number],
    ax: Axes | None = None,
    *,
    formula: str = "",
    rulings: tuple[Number, Number] = (-1, 1),
    control_net: bool = True,
    box: Box | None = None,
) -> Axes:
    """Draw the untrimmed bisector of a curve and a point (its coordinates) or another curve, as in §6 of the paper of
    2007.

    The bisector of a plane curve and a point is a curve, that of a space curve and a point a ruled surface, and that of
    two space curves a surface in two parameters. `formula` is the name of a formula of §6 for such arguments.

    >>> from exactspline.interchange.examples import example
    >>> ax = plot_bisector(example("ellipse"), ("1/2", "1/4"))
    >>> ax.get_legend().get_texts()[-1].get_text()
    'bisector: degree 7'

    Raises `ShapeError` if the dimensions do not match, `FormulaError` for an unknown formula, and the errors of
    `plot_mesh` and `plot_quotient`.
    """
    check_options(control_net=control_net, box=box)
    kind, default, handed = _argument(curve_of(curve), other)
    ax = axes_for(ax, 2 if kind is PLANE_POINT else 3)
    name = as_text(formula, "the name of a formula")
    bisector = find(name or default)
    if bisector.kind is not kind:
        raise FormulaError(
            f"{bisector.name} is not a bisector of these",
            where="formula",
            remedy=f"its argument is of the kind {bisector.curve!r}, not {kind.name!r}",
        )
    value = bisector(handed)
    if kind is PLANE_POINT:
        return plot_quotient(value, ax, label=f"bisector: degree {value.degree}", control_polygon=control_net, box=box)
    if kind is POINT_IN_SPACE:
        return plot_ruled_surface(
            value, rulings, ax, label=f"bisector: degree {value.degree}", control_net=control_net, box=box
        )
    degree = value.degree
    return plot_surface(value, ax, label=f"bisector: degree {degree.s} × {degree.t}", control_net=control_net, box=box)


def _argument(curve: Curve[BSpline], other: Any) -> tuple[Kind, str, Any]:
    """The kind of formula, the default formula, and its argument."""
    if isinstance(other, Curve):
        if curve.dimension != 3 or other.dimension != 3:
            raise ShapeError("a bisector of curves that are not in space", remedy="give two curves in space")
        return PAIR, "bisector_symmetric", surface_pair(curve, other)
    point = tuple(map(rational, as_items(other, "the coordinates of a point")))
    if len(point) != curve.dimension or len(point) not in (2, 3):
        problem = f"a point of {counted(len(point), 'coordinate')} with a curve in R{curve.dimension}"
        raise ShapeError(problem, remedy="both in the plane or both in space")
    kind, default = (
        (PLANE_POINT, "plane_bisector_polynomial") if len(point) == 2 else (POINT_IN_SPACE, "point_bisector_direct_z")
    )
    return kind, default, curve.with_point(point)


def mark_points(ax: Axes, points: Iterable[Point], label: str, color: str = GREY) -> Axes:
    """Mark single points, such as the point of a bisector of a point and a curve."""
    draw(ax, points, "o", color=color, markersize=7, markeredgecolor=BLACK, label=label, zorder=7)
    legend_below(ax)
    return ax
