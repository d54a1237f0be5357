"""Display of objects: HTML and LaTeX in a notebook, one line where their exact text would be too long.

``%load_ext exactspline.display`` in a notebook also shows exact numbers as fractions.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

from exactspline.display.latex import latex

if TYPE_CHECKING:
    from exactspline.display.notebook import html, load_ipython_extension, short

__all__ = ["html", "latex", "load_ipython_extension", "short"]


if not TYPE_CHECKING:

    def __getattr__(name):
        """The names used by notebooks, imported when they are first used, since commands do not need them."""
        if name not in __all__:
            raise AttributeError(f"module 'exactspline.display' has no attribute {name!r}")
        found = globals()[name] = getattr(import_module("exactspline.display.notebook"), name)
        return found
