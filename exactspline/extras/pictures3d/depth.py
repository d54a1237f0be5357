"""Surfaces drawn by a renderer with a depth buffer: VTK through pyvista, off screen (where pyvista is installed).

matplotlib orders whole faces from back to front, which is wrong as soon as two of them cross. A `DepthCollection` lies
in matplotlib's axes as any collection of faces does; when the picture is drawn, it has the surfaces, lines and dots of
its axes rendered in one image with a depth for every pixel, translucent, with isolines, and puts that image in their
place. Without pyvista, or without EGL, it draws as matplotlib does.
"""

from __future__ import annotations

import os
import sys
import warnings
from collections.abc import Iterable, Sequence
from ctypes.util import find_library
from functools import cache
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.artist import allow_rasterization
from matplotlib.colors import to_rgb
from matplotlib.image import BboxImage
from mpl_toolkits.mplot3d.art3d import Line3D, Poly3DCollection  # type: ignore[import-untyped]  # has no types
from mpl_toolkits.mplot3d.proj3d import proj_transform  # type: ignore[import-untyped]  # has no types
from numpy.typing import NDArray

from exactspline.extras.pictures3d.meshes import SurfaceMesh

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.backend_bases import RendererBase
    from matplotlib.lines import Line2D

Array = NDArray[np.float64]

#: The opacity of a surface, and the lowest resolution of an image in dots per inch: images drawn finer than shown have
#: smooth edges.
OPACITY, RESOLUTION = 0.7, 240
#: The positions of the two lights, seen from the eye, and their intensities.
LIGHTS = (((-0.5, 0.8, 1.0), 0.9), ((0.9, -0.3, 0.5), 0.35))
MATERIAL = {"ambient": 0.35, "diffuse": 0.8, "specular": 0.08, "specular_power": 15}
#: Isolines along and across the rows of a patch, about this many, and their width in points.
ISOLINES, FINE = (7, 24), 0.5
#: How far towards the eye lines lie, as a fraction of the picture's size, so that they are not half inside their
#: surface.
LIFT = 0.002

#: The names of matplotlib for no marker or no line.
NOTHING = ("None", None, "", " ")

#: The note where surfaces are drawn without it.
REMARK = "surfaces are drawn face by face, from back to front: pip install pyvista for a renderer that knows depth"


@cache
def knows_depth() -> bool:
    """Whether pyvista is there and can draw off screen: on Linux with Mesa's EGL or OSMesa (libegl1, libosmesa6)."""
    if find_spec("pyvista") is None:
        return False
    # without a rendering library, VTK aborts the process instead of raising
    return not sys.platform.startswith("linux") or any(map(find_library, ("EGL", "OSMesa")))


def remark() -> str:
    """What is said where surfaces are drawn without it, else nothing."""
    return "" if knows_depth() else REMARK


class DepthCollection(Poly3DCollection):  # type: ignore[misc]  # its base has no types
    """The faces of a mesh in one colour, for axes in space."""

    def __init__(self, mesh: SurfaceMesh, color: str, shades: Sequence[tuple[float, ...]], zorder: float = 1) -> None:
        corners = [[tuple(float(x) for x in p) for p in face] for face in mesh.faces]
        super().__init__(corners, facecolors=shades, edgecolors=shades, linewidths=0.1, zorder=zorder)
        self.mesh = mesh
        self.color = color
        self._rendered_lines: list[Line3D] = []
        self._last: tuple[object, NDArray[np.uint8]] | None = None
        # thousands of faces are a picture inside an SVG, not as many paths
        if not knows_depth():
            self.set_rasterized(True)

    @allow_rasterization
    def draw(self, renderer: RendererBase) -> None:
        """Draw all surfaces, lines and dots of the axes together; called for the first of their surfaces."""
        space: Any = self.axes
        parallel = np.allclose(space.M[3, :3], 0) if space.M is not None else False
        if not (knows_depth() and parallel):
            super().draw(renderer)
            return
        if hasattr(renderer.draw_image, "__wrapped__"):
            return  # a renderer that only lays out a picture: its methods are wrapped, and draw nothing
        surfaces = [c for c in space.collections if isinstance(c, DepthCollection) and c.get_visible()]
        if surfaces[0] is self:
            self._draw_all(space, surfaces, renderer)

    def _draw_all(self, space: Any, surfaces: Sequence[DepthCollection], renderer: RendererBase) -> None:
        lines = [line for line in space.lines if line.get_visible() or line in self._rendered_lines]
        self._rendered_lines = [line for line in lines if _is_rendered(line)]
        image = self._image(space, [(c.mesh, c.color) for c in surfaces])
        frame = BboxImage(space.bbox, interpolation="antialiased", origin="upper")
        frame.set_figure(space.figure)
        frame.set_data(image)
        frame.draw(renderer)
        # they are in the image already, so that matplotlib must skip them
        for line in self._rendered_lines:
            line.set_visible(False)

    def _image(self, space: Any, surfaces: Sequence[tuple[SurfaceMesh, str]]) -> NDArray[np.uint8]:
        """What is rendered, once for all files that show the same from the same side in the same resolution; texts take
        some millionths of an inch more or less in one than in the other.
        """
        dpi, (left, bottom, right, top) = space.figure.dpi, space.bbox.extents
        points = space.transData.transform([(0, 0), (1, 1)]) - [left, bottom]
        sides = np.round(np.array([[right - left, top - bottom], *points]) / dpi, 3)
        seen = max(dpi, RESOLUTION), sides.tolist(), space.M.tolist(), surfaces, list(map(_looks, self._rendered_lines))
        if self._last is None or self._last[0] != seen:
            self._last = seen, rendered(space, surfaces, self._rendered_lines)
        return self._last[1]


def _looks(line: Any) -> object:
    """What is seen of a line."""
    style = line.get_color(), line.get_linewidth(), line.get_linestyle(), line.get_marker()
    points = [np.asarray(column, dtype=float).tolist() for column in line.get_data_3d()]
    return style, line.get_markerfacecolor(), line.get_markersize(), points


def _is_rendered(line: Any) -> bool:
    return isinstance(line, Line3D) and line.get_marker() in ("o", *NOTHING) and len(line.get_data_3d()[0]) > 0


def rendered(
    axes: Axes, surfaces: Sequence[tuple[SurfaceMesh, str]], lines: Iterable[Line2D], opacity: float = OPACITY
) -> NDArray[np.uint8]:
    """The image of surfaces and of matplotlib's lines as matplotlib's axes in space see them: rows of pixels with red,
    green, blue and opacity, background transparent.
    """
    vista = _pyvista()
    space: Any = axes  # in space, where they have no types
    frame = space.bbox
    scale = max(1.0, RESOLUTION / space.figure.dpi)
    points_to_pixels = scale * space.figure.dpi / 72
    width, height = (max(1, round(side * scale)) for side in (frame.width, frame.height))
    plotter = vista.Plotter(off_screen=True, window_size=[width, height], lighting="none")
    try:
        # layers of what is translucent are peeled off pixel by pixel, which leaves no room for several samples in one
        plotter.disable_anti_aliasing()
        plotter.enable_depth_peeling(10)
        for position, intensity in LIGHTS:
            plotter.add_light(vista.Light(position=position, light_type="camera light", intensity=intensity))
        seen = _Seen(space, scale)
        for mesh, color in surfaces:
            _add_surface(vista, plotter, seen, mesh, color, opacity, points_to_pixels)
        _add_lines(vista, plotter, seen, lines, points_to_pixels)
        camera = plotter.camera
        camera.focal_point, camera.up = (width / 2, height / 2, 0), (0, 1, 0)
        camera.position = (width / 2, height / 2, 1)
        camera.parallel_projection, camera.parallel_scale = True, height / 2
        plotter.reset_camera_clipping_range()
        image: NDArray[np.uint8] = plotter.screenshot(None, transparent_background=True, return_img=True)
        return image
    finally:
        plotter.close()


def _pyvista() -> Any:
    # off screen no X server is needed, and no warning about a missing one
    if sys.platform.startswith("linux") and not os.environ.get("DISPLAY"):
        os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")
    with warnings.catch_warnings():
        # in a notebook without widgets it warns of progress bars, which are not shown
        warnings.simplefilter("ignore")
        import pyvista

    return pyvista


class _Seen:
    """Points of space in pixels of the image, the third coordinate towards the eye."""

    def __init__(self, space: Any, scale: float) -> None:
        self.space, self.scale = space, scale
        a, b = space.transData.transform([(0, 0), (1, 0)])
        self.depth = float(b[0] - a[0]) * scale
        self.size = max(space.bbox.width, space.bbox.height) * scale

    def __call__(self, points: Array, lift: float = 0) -> Array:
        x, y, z = proj_transform(*points.T, self.space.M)
        flat = self.space.transData.transform(np.column_stack([x, y])) - [self.space.bbox.x0, self.space.bbox.y0]
        return np.column_stack([flat * self.scale, -np.asarray(z) * self.depth + lift * self.size])


def _floats(points: Iterable[Sequence[Any]]) -> Array:
    return np.array([[float(x) for x in p] for p in points], dtype=float).reshape(-1, 3)


def _add_surface(
    vista: Any, plotter: Any, seen: _Seen, mesh: SurfaceMesh, color: str, opacity: float, pixels: float
) -> None:
    points, faces = mesh.indexed
    made = vista.PolyData(seen(_floats(points)), np.hstack([[len(face), *face] for face in faces]))
    plotter.add_mesh(made, color=to_rgb(color), opacity=opacity, smooth_shading=True, **MATERIAL)
    dark = tuple(0.4 * c for c in to_rgb(color))
    runs = [seen(_floats(run), LIFT) for run in mesh.isolines(*ISOLINES)]
    plotter.add_mesh(_polylines(vista, runs), color=dark, line_width=FINE * pixels, opacity=0.6, lighting=False)


def _polylines(vista: Any, runs: Sequence[Array]) -> Any:
    """Runs of points as one object of VTK."""
    starts = np.cumsum([0, *map(len, runs)])
    cells = [[len(run), *range(start, start + len(run))] for run, start in zip(runs, starts, strict=False)]
    return vista.PolyData(np.vstack(runs), lines=np.hstack(cells))


def _add_lines(vista: Any, plotter: Any, seen: _Seen, lines: Iterable[Any], pixels: float) -> None:
    drawn: dict[tuple[str, float], list[Array]] = {}
    dots: dict[tuple[str, float], list[Array]] = {}
    for line in lines:
        points = np.column_stack([np.asarray(column, dtype=float) for column in line.get_data_3d()])
        if line.get_linestyle() not in NOTHING and len(points) > 1:
            drawn.setdefault((line.get_color(), line.get_linewidth()), []).append(seen(points, LIFT))
        if line.get_marker() not in NOTHING:
            dots.setdefault((line.get_markerfacecolor(), line.get_markersize()), []).append(seen(points, 2 * LIFT))
    for (color, width), runs in drawn.items():
        plotter.add_mesh(_polylines(vista, runs), color=to_rgb(color), line_width=width * pixels, lighting=False)
    for (color, size), places in dots.items():
        cloud = vista.PolyData(np.vstack(places))
        plotter.add_mesh(cloud, color=to_rgb(color), point_size=size * pixels, render_points_as_spheres=True)
