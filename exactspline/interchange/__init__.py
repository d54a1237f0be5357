"""This package imports and exports curves exactly: `read` and `write` are for file formats, the other functions for
other libraries.

>>> import os, tempfile
>>> from exactspline.interchange.examples import example
>>> with tempfile.TemporaryDirectory() as folder:
...     place = os.path.join(folder, "circle.g2")
...     notes = write([example("circle")], place)
...     [named] = read(place).curves
>>> named.curve("1/2"), notes
((mpq(3,5), mpq(4,5)), ())
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
