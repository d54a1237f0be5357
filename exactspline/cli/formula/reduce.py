"""``formula reduce``: the reduction of a formula of the library or of the user, found by factorization."""

from __future__ import annotations

import sys
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from exactspline.cli.common import Limit, Trust
from exactspline.cli.output import Output, printing
from exactspline.cli.parameters import Argument, Option
from exactspline.cli.progress import tracked
from exactspline.errors import ExactSplineError, FormulaError

if TYPE_CHECKING:
    from exactspline.display.sheet import Sheet


@printing
def reduce(
    out: Output,
    name: Annotated[
        str,
        Argument(
            help="A formula of the library, or your own: FOLDER:NAME, file.py:function or, with --trust, "
            "module:function. Without it: all."
        ),
    ] = "",
    dimension: Annotated[
        int | None,
        Option(
            "--dimension", metavar="N", min=2, max=7, help="Dimension of the curve; by default that of the formula."
        ),
    ] = None,
    polynomial: Annotated[bool, Option("--polynomial", help="Polynomial curves only: w = 1.")] = False,
    everything: Annotated[bool, Option("--all", help="Every formula of the library.")] = False,
    trust: Trust = False,
    limit: Limit = None,
) -> None:
    """Find the reduction of a formula: its factors with their meaning, the reduced form, naive, nominal and true
    degree.
    """
    from exactspline.display.formulas import explanations, reduction_rows, reduction_sheet
    from exactspline.language.formula import Formula
    from exactspline.language.kinds import TABLE
    from exactspline.papers import all_formulas
    from exactspline.polynomials.cost import within_seconds
    from exactspline.symbolic.reduction import reduce as reduction

    one = bool(name) and not everything
    chosen = (
        [_guarded(name, lambda: _formula(name, trust))]
        if one
        else [f for f in all_formulas().values() if f.kind is not TABLE and not f.kind.adjoins_roots]
    )
    calls = [
        partial(_guarded, name, partial(reduction, f, dimension=dimension, polynomial=polynomial, parameter=parameter))
        for f in chosen
        for parameter in (f.kind.counted if isinstance(f, Formula) and len(f.kind.counted) > 1 else (None,))
    ]
    with within_seconds(limit):
        found = tracked(calls, "reducing")
    sheet = reduction_sheet(found)
    out.give(
        "reduce", reduction_rows(found), [sheet], lambda: _print(out, sheet, [*explanations(found[0])] if one else [])
    )


def _formula(name: str, trust: bool) -> Any:
    """A formula of the library, of the folder of a paper, of a file, or a function of a module of the user."""
    from exactspline.papers import papers, resolve
    from exactspline.papers.loading import run_module

    place, colon, function = name.rpartition(":")
    is_module = place.replace(".", "").isidentifier() and not place.endswith(".py") and not Path(place).exists()
    if not colon or not is_module or any(place == each.name for each in papers()):
        return resolve(name, trust=trust)
    if not trust:
        raise FormulaError(
            "a module runs unchanged, any Python",
            where=name,
            remedy="add --trust for what you trust; file.py:function is checked before it runs",
        )
    sys.path.insert(0, str(Path.cwd()))
    if not callable(found := getattr(run_module(place), function, None)):
        raise FormulaError(
            f"{place} has no function {function!r}", where=name, remedy="write module:function or file.py:function"
        )
    return found


def _guarded(name: str, call: Any) -> Any:
    """Any exception in code of the user is bad input: one line."""
    try:
        return call()
    except ExactSplineError:
        raise
    except (Exception, SystemExit) as error:
        raise FormulaError(
            f"{type(error).__name__}: {' '.join(str(error).split())}",
            where=name,
            remedy="a formula is a function of one curve c",
        ) from None


def _print(out: Output, sheet: Sheet, explained: list[str]) -> None:
    from exactspline.display import console

    shown = console.console()
    shown.print(sheet)
    if explained:
        shown.print()
    for line in explained:
        console.lines(shown, line)
    if not out.quiet:
        console.legend(shown, sheet.columns)
