"""How objects show themselves: HTML and LaTeX in a notebook, one line where their exact text would be too long.

``%load_ext exactspline.display`` in a notebook also shows exact numbers as fractions.
"""

from __future__ import annotations

from exactspline.display.latex import latex
from exactspline.display.notebook import html, load_ipython_extension, short

__all__ = ["html", "latex", "load_ipython_extension", "short"]
