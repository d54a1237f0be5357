"""Exact import and export of curves: `read` and `write` for file formats, and bridges to other libraries.

>>> import os, tempfile
>>> from exactspline.splines.examples import example
>>> with tempfile.TemporaryDirectory() as folder:
...     place = os.path.join(folder, "circle.g2")
...     notes = write([example("circle")], place)
...     [named] = read(place).curves
>>> named.curve("1/2"), notes
((mpq(3,5), mpq(4,5)), ())
"""

from exactspline.interchange.files import read, write
from exactspline.interchange.limits import Limits
from exactspline.interchange.records import NamedCurve, Reading, Skipped

__all__ = ["Limits", "NamedCurve", "Reading", "Skipped", "read", "write"]
