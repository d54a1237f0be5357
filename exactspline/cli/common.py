"""What the subcommands share: options, reading curves, progress."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Annotated, TypeVar

import typer

from exactspline.cli.output import is_quiet
from exactspline.errors import CurveFileError, ExactSplineError
from exactspline.splines.nurbs import Nurbs

if TYPE_CHECKING:
    from exactspline.verification.claim import Claim

__all__ = [
    "CURVE_HELP",
    "CurveFiles",
    "Digits",
    "Exact",
    "Papers",
    "Trust",
    "also_in_their_planes",
    "check_output",
    "claims_of_papers",
    "described",
    "load_curve",
    "loaded",
    "tracked",
]
V = TypeVar("V")

CURVE_HELP = "A curve file (JSON), the name of an example curve, or - for standard input."
CurveFiles = Annotated[
    list[str] | None, typer.Option("--curve", metavar="CURVE", help=f"{CURVE_HELP} May be repeated.")
]
Papers = Annotated[
    list[str] | None,
    typer.Option(
        "--paper",
        metavar="PAPER",
        help="A folder with formulas.py and claims.toml, the name of a paper that comes with exactspline, or all. "
        "May be repeated.",
    ),
]
Trust = Annotated[
    bool, typer.Option("--trust", help="Run the formulas of a folder or a file as they stand: any Python, unchecked.")
]
Digits = Annotated[
    int,
    typer.Option(
        "--digits", metavar="N", min=0, max=100_000, help="Show exact numbers with N significant digits beside them."
    ),
]
Exact = Annotated[bool, typer.Option("--exact", help="Show long fractions in full instead of as decimals.")]


def claims_of_papers(names: Sequence[str] | None, trust: bool) -> tuple[Claim, ...]:
    """The claims of papers named by their names or folders; of those that are meant where none is named."""
    from exactspline.papers import named_papers
    from exactspline.verification.claims import claims_in

    return claims_in(named_papers(names or [], trust=trust))


def load_curve(name: str) -> Nurbs:
    """An example curve by its name, a curve file by its path, or the curve on standard input (``-``)."""
    from exactspline.splines.curve_files import MAX_BYTES
    from exactspline.splines.examples import curve_from_text, load

    if name != "-":
        return load(name)
    try:
        text = sys.stdin.read(MAX_BYTES + 1)
    except UnicodeDecodeError:
        raise CurveFileError("is not UTF-8 text", where="standard input", remedy="a curve file is JSON") from None
    if len(text) > MAX_BYTES:
        raise CurveFileError("is too large", where="standard input", remedy=f"at most {MAX_BYTES} characters are read")
    try:
        return curve_from_text(text, "stdin")
    except ExactSplineError as error:
        raise error.at("standard input") from None


def loaded(names: Iterable[str]) -> tuple[list[Nurbs], bool]:
    """The curves that can be read, and whether all could: one bad curve is reported and the rest goes on."""
    from exactspline.display.console import show_error

    curves, good = [], True
    for name in names:
        try:
            curves.append(load_curve(name))
        except ExactSplineError as error:
            show_error(error)
            good = False
    return curves, good


def also_in_their_planes(curves: list[Nurbs]) -> list[Nurbs]:
    """The curves, each space curve in a coordinate plane followed by itself as a plane curve."""
    from exactspline.geometry.planarity import with_plane_curves

    return with_plane_curves(curves)


def tracked(calls: Sequence[Callable[[], V]], label: str) -> list[V]:
    """The results of the calls, with a progress bar on a terminal."""
    if is_quiet() or not sys.stderr.isatty():
        return [call() for call in calls]
    from rich.console import Console
    from rich.progress import track

    return [call() for call in track(calls, description=label, console=Console(stderr=True), transient=True)]


def described(c: Nurbs) -> str:
    """A curve in one line; equal weights are told to be polynomial."""
    kind = "polynomial" if c.polynomial else "rational"
    equal = " (equal weights)" if c.polynomial and any(w != 1 for w in c.weights) else ""
    segments = f"{c.segments} segment{'s' if c.segments != 1 else ''}"
    return f"{kind}{equal}, degree {c.degree}, {segments}, {len(c.control_points)} control points in R{c.dimension}"


def check_output(output: str, *inputs: str) -> None:
    """Raise `CurveFileError` when an output is one of the files that are read."""
    from pathlib import Path

    for name in inputs:
        if output and name and Path(output).exists() and Path(name).exists() and Path(output).samefile(name):
            raise CurveFileError("is the curve that is read", where=output, remedy="write to another file")
