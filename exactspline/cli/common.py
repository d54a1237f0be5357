"""What the subcommands share: options, reading curves, printing."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterable, Sequence
from typing import Annotated, Any

import typer

from exactspline.errors import ExactSplineError

CurveFiles = Annotated[
    list[str] | None,
    typer.Option("--curve", help="A curve file (JSON) or the name of an example curve; may be repeated."),
]
AsJson = Annotated[bool, typer.Option("--json", help="Print JSON for programs.")]
Digits = Annotated[
    int,
    typer.Option("--digits", min=0, max=100_000, help="Show exact numbers with so many decimal digits beside them."),
]


def loaded(names: Iterable[str]) -> tuple[list[Any], bool]:
    """The curves that can be read, and whether all could: one bad curve is reported and the rest goes on."""
    from exactspline.display.console import show_error
    from exactspline.splines.examples import load

    curves, good = [], True
    for name in names:
        try:
            curves.append(load(name))
        except ExactSplineError as error:
            show_error(error)
            good = False
    return curves, good


def also_in_their_planes(curves: list[Any]) -> list[Any]:
    """The curves, each space curve in a coordinate plane followed by itself as a plane curve."""
    from exactspline.geometry.planarity import with_plane_curves

    return with_plane_curves(curves)


def print_json(data: Any) -> None:
    """JSON on standard output."""
    sys.stdout.write(json.dumps(data, ensure_ascii=False, indent=1) + "\n")


def tracked(calls: Sequence[Callable[..., Any]], label: str) -> list[Any]:
    """The results of the calls, with a progress bar on a terminal."""
    from rich.console import Console
    from rich.progress import track

    return [
        call()
        for call in track(
            calls, description=label, console=Console(stderr=True), transient=True, disable=not sys.stderr.isatty()
        )
    ]


def described(c: Any) -> str:
    """A curve in one line; equal weights are told to be polynomial."""
    kind = "polynomial" if c.polynomial else "rational"
    equal = " (equal weights)" if c.polynomial and any(w != 1 for w in c.weights) else ""
    segments = f"{c.segments} segment{'s' if c.segments != 1 else ''}"
    return f"{kind}{equal}, degree {c.degree}, {segments}, {len(c.control_points)} control points in R{c.dimension}"


def check_output(output: str, *inputs: str) -> None:
    """Raise `CurveFileError` when an output is one of the files that are read."""
    from pathlib import Path

    from exactspline.errors import CurveFileError

    for name in inputs:
        if output and name and Path(output).exists() and Path(name).exists() and Path(output).samefile(name):
            raise CurveFileError("is the curve that is read", where=output, remedy="write to another file")
