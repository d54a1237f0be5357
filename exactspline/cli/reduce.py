"""``reduce``: the reduction of a formula of the library or of the user, found by factoring."""

from __future__ import annotations

import importlib
import importlib.util
import sys
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import typer

from exactspline.cli.common import AsJson, print_json, tracked
from exactspline.errors import ExactSplineError, FormulaError


def reduce(
    name: Annotated[
        str,
        typer.Argument(
            help="A formula of the library, or your own: module:function or file.py:function. Without it: all."
        ),
    ] = "",
    dimension: Annotated[
        int | None, typer.Option("--dimension", min=2, max=7, help="Of the curve; without it what the formula says.")
    ] = None,
    polynomial: Annotated[bool, typer.Option("--polynomial", help="Polynomial curves only: w = 1.")] = False,
    everything: Annotated[bool, typer.Option("--all", help="Every formula of the library.")] = False,
    as_json: AsJson = False,
) -> None:
    """Find the reduction of a formula: its factors with their meaning, the reduced form, naive, nominal and true
    degree.
    """
    from exactspline.papers import all_formulas
    from exactspline.symbolic.reduction import reduce as reduction

    one = bool(name) and not everything
    chosen = (
        [_guarded(name, lambda: _formula(name))] if one else [f for f in all_formulas().values() if f.curve != "table"]
    )
    calls = [partial(_guarded, name, partial(reduction, f, dimension=dimension, polynomial=polynomial)) for f in chosen]
    found = tracked(calls, "reducing")
    if as_json:
        print_json(
            [
                {
                    "formula": r.name,
                    "dimension": r.dimension,
                    "polynomial": r.polynomial,
                    "parts": [p.data() for p in r.parts],
                }
                for r in found
            ]
        )
    else:
        _print(found, explain=one)


def _formula(name: str) -> Any:
    """A formula of the library, or a function out of a module or a file of the user."""
    from exactspline.papers import find

    place, colon, function = name.rpartition(":")
    if not colon:
        return find(name)
    module = _module(place)
    if not callable(found := getattr(module, function, None)):
        raise FormulaError(
            f"{place} has no function {function!r}", where=name, remedy="write module:function or file.py:function"
        )
    return found


def _module(place: str) -> Any:
    if not place.endswith(".py"):
        sys.path.insert(0, str(Path.cwd()))
        return importlib.import_module(place)
    spec = importlib.util.spec_from_file_location(Path(place).stem, place)
    if spec is None or spec.loader is None or not Path(place).is_file():
        raise FormulaError("there is no such file", where=place, remedy="write file.py:function")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def _guarded(name: str, call: Any) -> Any:
    """Whatever goes wrong in code of the user is bad input: one line."""
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


def _print(found: list[Any], *, explain: bool) -> None:
    from exactspline.display import console

    out = console.console()
    numbers = ("naive", "k, m, j", "nominal", "true", "in lowest terms")
    made = console.table("formula", "factors cancelled", "reduced form", *numbers, right=numbers)
    for r in found:
        for part in r.parts:
            row = part.data()
            label = r.name if len(r.parts) == 1 else f"{r.name}, {part.role}"
            grading = f"{row['k']}, {row['m']}, {row['j']}" if row["k"] is not None else "–"
            reduced = row["reduced"] + (f", poles at {row['poles']} = 0" if row["poles"] else "")
            made.add_row(
                label,
                row["cancelled"],
                reduced,
                row["naive"],
                grading,
                row["nominal"] or "–",
                row["true"],
                row["lowest terms"] or "–",
            )
    out.print(made)
    if explain:
        _explain(out, found[0])


def _explain(out: Any, r: Any) -> None:
    kind = {2: "plane curve", 3: "space curve"}.get(r.dimension, f"curve in R{r.dimension}")
    out.print(
        f"\nFor the {'polynomial' if r.polynomial else 'rational'} {kind} of degree d; verified by multiplication.",
        markup=False,
    )
    for name, meaning in {
        name: meaning for part in r.parts for name, meaning in part.data()["meaning"].items()
    }.items():
        out.print(f"{name}: {meaning}", markup=False)
    for part in r.parts:
        for d, n in part.data()["lower"].items():
            out.print(
                f"{part.role}: at d = {d} the true degree is {n}"
                if n >= 0
                else f"{part.role}: at d = {d} it vanishes on every curve",
                markup=False,
            )
