"""What the front door lends to every room: printers for notebooks, and the names of its functions."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Protocol

#: From the name of a format (``html``, ``latex``, ``short``, ``words``) and an object to a text, None where there is
#: none.
Printers = Callable[[str, object], str | None]


def _plain(form: str, shown: object) -> str | None:
    return repr(shown) if form == "short" else None


_printers: list[Printers] = [_plain]
_functions = set[str]()


def set_printers(printers: Printers) -> None:
    """Let notebooks show objects as these printers write them."""
    _printers[0] = printers


def set_functions(names: Iterable[str]) -> None:
    """Let the errors of missing methods name these functions of the front door."""
    _functions.update(names)


class Writer(Protocol):
    """What IPython hands to `_repr_pretty_`."""

    def text(self, text: str, /) -> object:
        """Write a text."""


class Displayed:
    """An object that a notebook shows as formulas, tables and small pictures."""

    __slots__ = ()

    def _repr_html_(self) -> str | None:
        return _printers[0]("html", self)

    def _repr_latex_(self) -> str | None:
        return _printers[0]("latex", self)

    def _repr_pretty_(self, writer: Writer, cycle: bool) -> None:
        writer.text(_printers[0]("short", self) or repr(self))


class Worded:
    """What a sentence is made of: `str` puts it into words, as `display` writes them."""

    __slots__ = ()

    def __str__(self) -> str:
        return _printers[0]("words", self) or repr(self)


class FunctionsOutside:
    """An object that functions of the front door take: ``exactspline.plot(curve)``, not ``curve.plot()``."""

    __slots__ = ()

    if not TYPE_CHECKING:  # checkers know what there is

        def __getattr__(self, name):
            """Refuse an attribute that there is not, naming the function of that name."""
            problem = f"{type(self).__name__!r} object has no attribute {name!r}"
            remedy = f"; use the function exactspline.{name}" if name in _functions else ""
            raise AttributeError(problem + remedy, name=name, obj=self)
