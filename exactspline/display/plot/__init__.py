"""Pictures: curves and functions with their control polygons, roots, features, evolutes, surfaces. Needs matplotlib
(the extra ``plot``).

Everything is computed exactly; numbers become floats only when they are passed to matplotlib. A drawing function takes
the axes (None: those of a new figure) and returns them.
"""

from exactspline.display.plot.canvas import PlotError, new_figure, save
from exactspline.display.plot.comparisons import inspect_figure, plot_approaches
from exactspline.display.plot.curves import plot_curve, plot_evolute, plot_features, plot_quotient
from exactspline.display.plot.functions import plot_function, plot_roots
from exactspline.display.plot.meshes import SurfaceMesh, ruled_mesh, tensor_mesh
from exactspline.display.plot.surfaces import mark_points, plot_bisector, plot_mesh, plot_ruled_surface, plot_surface

__all__ = [
    "PlotError",
    "SurfaceMesh",
    "inspect_figure",
    "mark_points",
    "new_figure",
    "plot_approaches",
    "plot_bisector",
    "plot_curve",
    "plot_evolute",
    "plot_features",
    "plot_function",
    "plot_mesh",
    "plot_quotient",
    "plot_roots",
    "plot_ruled_surface",
    "plot_surface",
    "ruled_mesh",
    "save",
    "tensor_mesh",
]
