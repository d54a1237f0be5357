"""Services: methods of objects that are implemented in rooms further right, called by name and loaded when first
called.

`exactspline` itself registers where each service lives; no room imports upwards. A method that calls one is declared,
with types and docstring, on its object.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING, Literal, Protocol, overload

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from exactspline.exact import mpq
    from exactspline.language.kind import Kind
    from exactspline.language.operand import Operand
    from exactspline.papers.folder import Paper
    from exactspline.roots.enclosure import Enclosure
    from exactspline.splines.surd import Surd

_homes: dict[str, str] = {}


def register(homes: Mapping[str, str]) -> None:
    """Register where services are implemented: name → ``module:function``."""
    _homes.update(homes)


def registered() -> dict[str, str]:
    """Where the services are implemented.

    >>> registered()["html"]
    'exactspline.display.notebook:html'
    """
    return dict(_homes)


@overload
def service(name: Literal["html", "latex"]) -> Callable[[object], str | None]: ...
@overload
def service(name: Literal["short", "formula_text"]) -> Callable[[object], str]: ...
@overload
def service(name: Literal["at_floats"]) -> Callable[..., list[tuple[float, ...]]]: ...
@overload
def service(name: Literal["curvature_floats", "torsion_floats"]) -> Callable[..., list[float]]: ...
@overload
def service(name: Literal["at"]) -> Callable[..., tuple[mpq | Enclosure, ...]]: ...
@overload
def service(name: Literal["curvature"]) -> Callable[..., mpq | Surd | Enclosure]: ...
@overload
def service(name: Literal["torsion"]) -> Callable[..., mpq | Enclosure]: ...
@overload
def service(name: Literal["plot"]) -> Callable[..., Axes]: ...
@overload
def service(name: Literal["kind"]) -> Callable[[str], Kind]: ...
@overload
def service(name: Literal["paper"]) -> Callable[[str], Paper]: ...
@overload
def service(name: Literal["quotient"]) -> Callable[[object, object], Operand]: ...
def service(name: str) -> Callable[..., object]:
    """The service with this name, imported at the first call.

    A new one is declared above with its return type.
    """
    return _imported(name)


@cache
def _imported(name: str) -> Callable[..., object]:
    module, _, function = _homes[name].partition(":")
    found: Callable[..., object] = getattr(import_module(module), function)
    return found


class Printer(Protocol):
    """What IPython hands to `_repr_pretty_`."""

    def text(self, text: str, /) -> object:
        """Write a text."""


class Displayed:
    """An object that a notebook shows as formulas, tables and small pictures."""

    __slots__ = ()

    def _repr_html_(self) -> str | None:
        return service("html")(self)

    def _repr_latex_(self) -> str | None:
        return service("latex")(self)

    def _repr_pretty_(self, printer: Printer, cycle: bool) -> None:
        printer.text(service("short")(self))
