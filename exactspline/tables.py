"""This module has tables of degrees, control points, verdicts, printed and computed numbers, and sections of a paper,
and the objects that the tables compare: constructions with their variants, and factors between formulas.

>>> from exactspline.tables import measure
>>> from exactspline.papers import find
>>> from exactspline.interchange.examples import example
>>> measure(find("f2"), example("ellipse"))
<Measure f2: degree 3d − 3, here 3, true degree 0, 16 control points>
"""

import lazy_loader

# the names are relative to the package, as this is no package
__getattr__, __dir__, __all__ = lazy_loader.attach_stub("exactspline", __file__)
