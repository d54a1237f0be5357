"""Readings, that is evaluation modes: the possible interpretations of the operands of a formula. The spline reading is
provided directly by `exactspline.splines.bspline` and `exactspline.splines.nurbs`.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
