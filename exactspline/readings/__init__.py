"""Readings: what the operands of a formula can be. The spline reading is `exactspline.splines.bspline` and
`exactspline.splines.nurbs` themselves.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
