"""How objects reach what shows them: the methods that notebooks and IPython look for, and nothing of what they show."""

from __future__ import annotations

from typing import Any


class Displayed:
    """Something that a notebook shows as formulas, tables and small pictures; `exactspline.display` knows how and is loaded when first asked."""

    __slots__ = ()

    def _repr_html_(self) -> str | None:
        from exactspline.display import html

        return html(self)

    def _repr_latex_(self) -> str | None:
        from exactspline.display import latex

        return latex(self)

    def _repr_pretty_(self, printer: Any, cycle: bool) -> None:
        from exactspline.display import short

        printer.text(short(self))
