"""Pictures: curves and functions with their control polygons, roots, features, evolutes, surfaces. Needs matplotlib (the extra ``plot``).

All is computed exactly; numbers become floats only when matplotlib gets them. A function that draws takes the axes (None: those of a new figure)
and returns them.
"""

from exactspline.plot.canvas import PlotError, new_figure, save
from exactspline.plot.comparisons import inspect_figure
from exactspline.plot.curves import plot_curve, plot_evolute, plot_features
from exactspline.plot.functions import greville_abscissae, plot_function

__all__ = ["PlotError", "greville_abscissae", "inspect_figure", "new_figure", "plot_curve", "plot_evolute", "plot_features", "plot_function", "save"]
