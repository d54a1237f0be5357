"""Readings are the types of operands with which a formula can be evaluated, for example degrees or Taylor series. The
operands of the spline reading are in `exactspline.splines.bspline` and `exactspline.splines.nurbs`.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
