"""Pictures: curves and functions with their control polygons, roots, features, evolutes, surfaces. Needs matplotlib
(the extra ``plot``).

Everything is computed exactly; numbers become floats only when they are passed to matplotlib. A drawing function takes
the axes (None: those of a new figure) and returns them.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
