"""Readings are the types of operands with which a formula can be evaluated, for example degrees or Taylor series.
Splines are in `exactspline.splines`.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
