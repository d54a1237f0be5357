from .patches import surface_figure as surface_figure
from .surfaces import plot_bisector as plot_bisector
from .surfaces import plot_ruled_surface as plot_ruled_surface
from .surfaces import plot_surface as plot_surface
