"""The paper, one module a section; nothing else. Every formula stands here once and everything else is derived from it."""

from __future__ import annotations

from functools import cache
from importlib import import_module

from exactspline.errors import FormulaError
from exactspline.language import Formula

#: The modules of formulas, in the order of the paper.
MODULES = ("table1", "derivatives", "plane", "space", "bisector", "lifted")


@cache
def all_formulas() -> dict[str, Formula]:
    """Every formula of the library by name, in the order of the paper."""
    found = {}
    for module in MODULES:
        for value in vars(import_module(f"exactspline.formulas.{module}")).values():
            if isinstance(value, Formula) and value.__module__ == f"exactspline.formulas.{module}":
                found[value.name] = value
    return found


def find(name: str) -> Formula:
    """The formula with this name.

    >>> find("f2")
    <formula f2, eq. (8)>

    Raises `FormulaError` with the names there are.
    """
    known = all_formulas()
    if name not in known:
        raise FormulaError(f"no formula is called {name!r}", remedy=f"there are {', '.join(known)}")
    return known[name]
