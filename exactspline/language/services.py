"""Services: what objects can do but what lives in rooms further right, called by name and loaded when first called.

`exactspline` itself registers where each service lives; no room imports upwards. A method that calls one is declared
with its types and its docstring where its object is.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from importlib import import_module
from typing import Any

_homes: dict[str, str] = {}


def register(homes: Mapping[str, str]) -> None:
    """Say where services live: name → ``module:function``."""
    _homes.update(homes)


def registered() -> dict[str, str]:
    """Where the services live.

    >>> registered()["html"]
    'exactspline.display.notebook:html'
    """
    return dict(_homes)


@cache
def service(name: str) -> Callable[..., Any]:
    """The service with this name, imported at the first call."""
    module, _, function = _homes[name].partition(":")
    found: Callable[..., Any] = getattr(import_module(module), function)
    return found


class Displayed:
    """Something that a notebook shows as formulas, tables and small pictures."""

    __slots__ = ()

    def _repr_html_(self) -> str | None:
        shown: str | None = service("html")(self)
        return shown

    def _repr_latex_(self) -> str | None:
        shown: str | None = service("latex")(self)
        return shown

    def _repr_pretty_(self, printer: Any, cycle: bool) -> None:
        printer.text(service("short")(self))
