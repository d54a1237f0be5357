"""Certified zero sets: all roots and no others, to any number of digits.

>>> from exactspline import BSpline
>>> zeros(BSpline.bezier([1, -2, 1])).roots
(<Root (3 - √3)/6: multiplicity 1, sign + to −>, <Root (3 + √3)/6: multiplicity 1, sign − to +>)
"""

from exactspline.reals.real import between
from exactspline.roots.root import Root
from exactspline.roots.zero_set import Jump, ZeroInterval, ZeroSet, zeros

__all__ = ["Jump", "Root", "ZeroInterval", "ZeroSet", "between", "zeros"]
