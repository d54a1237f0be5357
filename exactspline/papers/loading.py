"""Loading of formulas from files that are not modules of this package."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from functools import wraps
from importlib import import_module
from importlib.util import module_from_spec, spec_from_file_location
from os.path import abspath
from pathlib import Path
from traceback import walk_tb
from types import ModuleType, TracebackType
from typing import TYPE_CHECKING, Any

from exactspline.errors import ExactSplineError, FormulaError
from exactspline.language.formula import Formula
from exactspline.language.operand import CONSTANTS, Operand
from exactspline.language.ruled import RuledSurface
from exactspline.language.vector import Vector

if TYPE_CHECKING:
    from importlib.resources.abc import Traversable

#: A function that returns the formulas that others may import, by ``papers.paper.module:name``.
Importable = Callable[[], Mapping[str, Formula]]


def checked_formulas(
    file: Traversable,
    importable: Importable,
    *,
    plain: bool = False,
    refused: dict[str, ExactSplineError] | None = None,
) -> dict[str, Formula]:
    """The formulas of a file, checked before they run (see `exactspline.papers.formula_check`, also for `refused`).

    Raises `FormulaError`, with file and line, for an invalid file.
    """
    from exactspline.papers.formula_check import CHARACTERS, ROOMS, formulas_of

    place = str(file)
    try:
        with file.open("rb") as stream:
            text = stream.read(4 * CHARACTERS + 1).decode("utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise FormulaError(f"cannot be read: {error}", where=place, remedy="write a text file in UTF-8") from None
    known: Mapping[str, Formula] = importable() if any(room in text for room in ROOMS) else {}
    read = formulas_of(text, place, known, plain=plain, refused=refused)
    for each in read.values():
        each.checked = True
    return {name: guarded(each, place) for name, each in read.items()}


def trusted_formulas(file: Traversable) -> dict[str, Formula]:
    """The formulas of a file, which is run unchecked.

    Raises `FormulaError` for any error in it.
    """
    place = str(file)
    module = run_file(Path(place))
    formulas = [f for f in vars(module).values() if isinstance(f, Formula) and f.__module__ == module.__name__]
    return {f.name: guarded(f, place) for f in formulas}


#: The files run unchecked in this process.
_ran_unchecked: dict[str, None] = {}


def ran_unchecked() -> tuple[str, ...]:
    """The files of formulas that were run unchecked (``--trust``), for whose results their authors are responsible.

    >>> ran_unchecked()
    ()
    """
    return tuple(_ran_unchecked)


def forget_what_ran() -> None:
    """Clear the list of `ran_unchecked`; called at the start of a command."""
    _ran_unchecked.clear()


def run_file(file: Path) -> ModuleType:
    """Run a Python file unchecked as a temporary module; it is listed in `ran_unchecked` afterwards.

    Raises `FormulaError` for any error in it.
    """
    spec = spec_from_file_location(f"paper_{file.stem}", file)
    if spec is None or spec.loader is None or not file.is_file():
        raise FormulaError("there is no such file", where=str(file), remedy="write file.py:function")
    module = module_from_spec(spec)
    _ran_unchecked[str(file)] = None
    try:
        spec.loader.exec_module(module)
    except ExactSplineError:
        raise
    except (Exception, SystemExit) as error:
        raise described(error, str(file)) from None
    return module


def run_module(name: str) -> ModuleType:
    """Import a module of the user unchecked; it is listed in `ran_unchecked` afterwards."""
    _ran_unchecked[name] = None
    return import_module(name)


def guarded(formula: Formula, file: str) -> Formula:
    """The formula, with errors that name the file and the line in which they occur."""
    function = formula.function

    @wraps(function)
    def value(c: object) -> Any:
        try:
            result = function(c)
            if problem := _no_value(result):
                raise FormulaError(problem, where=f"{file}, {formula.name}", remedy=VALUES, file=file)
            return result
        except ExactSplineError as error:
            if error.data.get("file") == file:  # raised by another formula of the file, which is named
                raise
            placed = error.at(_where(sys.exc_info()[2], file, formula.name))
            placed.data["file"] = file
            raise placed from None
        except (TypeError, AttributeError, IndexError, ValueError, ArithmeticError, RecursionError) as error:
            raise described(error, file, formula.name) from None

    formula.function = value
    return formula


#: The values that a formula may return.
VALUES = "return a scalar, a vector, a quotient or a ruled surface made of operands"


def _no_value(value: object) -> str:
    """The reason why an object is not a possible value of a formula; empty for a possible value."""
    if isinstance(value, CONSTANTS):
        return f"the value is the number {value}, which does not depend on the argument"
    if isinstance(value, Vector):
        if not len(value):
            return "the value is a vector without components"
        return "" if all(isinstance(x, Operand) for x in value) else "the value is a vector of numbers or of vectors"
    if isinstance(value, RuledSurface):
        ends = (value.directrix, value.generator)
        return next((described for end in ends if (described := _no_value(end))), "") or (
            "" if all(getattr(end, "is_vector", False) for end in ends) else "directrix and generator are not vectors"
        )
    return "" if isinstance(value, Operand) else f"the value is a {type(value).__name__}"


def described(error: BaseException, file: str, name: str = "") -> FormulaError:
    """An error in a file, described in terms of the language of formulas."""
    problem = f"{type(error).__name__}: {' '.join(str(error).split())}"
    remedies: dict[type[BaseException], Callable[[], str]] = {
        AttributeError: lambda: "name operands that the argument has",
        TypeError: lambda: "write dot, cross or det for products of vectors",
        IndexError: lambda: "components are counted from 0",
        ZeroDivisionError: lambda: "nothing can be divided by zero",
    }
    remedy = remedies.get(type(error), lambda: "a formula is a function of one argument c")()
    return FormulaError(problem, where=_where(error.__traceback__, file, name), remedy=remedy, file=file)


def _where(trace: TracebackType | None, file: str, name: str) -> str:
    """The place of an error: the file, the line if it is known, and the name of the formula."""
    lines = [line for frame, line in walk_tb(trace) if abspath(frame.f_code.co_filename) == abspath(file)]
    return ", ".join(filter(None, (file, *(f"line {line}" for line in lines[-1:]), name)))
