"""This package displays objects: as HTML and LaTeX in a notebook, and in one line in place of long exact texts.

``%load_ext exactspline.display`` in a notebook also shows exact numbers as fractions.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
