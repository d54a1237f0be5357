"""The command line. Exit status 0: everything as recorded; 1: a verdict differs from the record; 2: bad input."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterable, Sequence
from typing import Annotated, Any

import typer

from exactspline.errors import ExactSplineError

app = typer.Typer(
    help="B-splines and NURBS in exact rational arithmetic: identities proved or refuted, never 'up to 1e-9'.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)

CurveFiles = Annotated[list[str] | None, typer.Option("--curve", help="A curve file (JSON) or the name of an example curve; may be repeated.")]
AsJson = Annotated[bool, typer.Option("--json", help="Print JSON for programs.")]
Digits = Annotated[int, typer.Option("--digits", min=0, max=100_000, help="Show exact numbers with so many decimal digits beside them.")]


def main() -> None:
    """Entry point: bad input ends in one line on standard error and exit status 2."""
    try:
        app()
    except ExactSplineError as error:
        from exactspline.report import show_error

        show_error(error)
        sys.exit(2)
    except BrokenPipeError:
        sys.stderr.close()
        sys.exit(0)


def loaded(names: Iterable[str]) -> tuple[list[Any], bool]:
    """The curves that can be read, and whether all could: one bad curve is reported and the rest goes on."""
    from exactspline.curves import load
    from exactspline.report import show_error

    curves, good = [], True
    for name in names:
        try:
            curves.append(load(name))
        except ExactSplineError as error:
            show_error(error)
            good = False
    return curves, good


def print_json(data: Any) -> None:
    """JSON on standard output."""
    sys.stdout.write(json.dumps(data, ensure_ascii=False, indent=1) + "\n")


def tracked(calls: Sequence[Callable[..., Any]], label: str) -> list[Any]:
    """The results of the calls, with a progress bar on a terminal."""
    from rich.console import Console
    from rich.progress import track

    return [call() for call in track(calls, description=label, console=Console(stderr=True), transient=True, disable=not sys.stderr.isatty())]


@app.command()
def prove(
    claim: Annotated[
        list[str] | None, typer.Option("--claim", help="The id of a claim, or what it begins (C3: all of section 3); may be repeated.")
    ] = None,
    curve: CurveFiles = None,
    as_json: AsJson = False,
    digits: Digits = 0,
) -> None:
    """Decide every claim: for all curves at once, and exactly on the given curves (without --curve: on the example curves)."""
    from exactspline.audit import tasks
    from exactspline.claims import select

    claims = select(claim or [])
    curves, good = loaded(curve) if curve else (None, True)
    rows = tracked(tasks(claims, curves), "proving")
    if as_json:
        print_json([row.data() for row in rows])
    else:
        _print_ledger(rows, claims, curves, digits)
    if not good:
        raise typer.Exit(2)
    if not all(row.as_recorded for row in rows):
        raise typer.Exit(1)


def _print_ledger(rows: list[Any], claims: Sequence[Any], curves: list[Any] | None, digits: int) -> None:
    from exactspline import report

    out = report.console()
    if curves is None:
        out.print(report.ledger([row for row in rows if not row.curve], "For all curves", digits))
        concrete = [row for row in rows if row.curve]
        out.print("\n[bold]On the example curves[/bold], exactly (each in full with --curve NAME)")
        out.print(report.summary(concrete))
        differing = [row for row in concrete if not row.as_recorded]
        if differing:
            out.print(report.ledger(differing, "Not as recorded", digits))
    for c in curves or []:
        own = [row for row in rows if row.curve == c.name]
        out.print(report.ledger(own, f"{c.name}: {described(c)}", digits))
        if silent := [claim for claim in claims if not claim.speaks_of(c.dimension, c.polynomial)]:
            out.print(f"{len(silent)} claims say nothing of this curve: {report.reasons(silent, c)}", markup=False)
    if rows:
        out.print("\n" + report.closing(rows), markup=False)


def described(c: Any) -> str:
    """A curve in one line; equal weights are told to be polynomial."""
    kind = "polynomial" if c.polynomial else "rational"
    equal = " (equal weights)" if c.polynomial and any(w != 1 for w in c.weights) else ""
    segments = f"{c.segments} segment{'s' if c.segments != 1 else ''}"
    return f"{kind}{equal}, degree {c.degree}, {segments}, {len(c.control_points)} control points in R{c.dimension}"


@app.command()
def degrees(curve: CurveFiles = None, as_json: AsJson = False) -> None:
    """Nominal (in d), represented and true degree and the number of control points, formula by formula."""
    from exactspline.measure import measurable, measure

    curves, good = loaded(curve or ["rational_cubic", "rational_space_cubic"])
    results = []
    for c in curves:
        calls = [lambda f=f, c=c: measure(f, c) for f in measurable(c.dimension)]
        results.append((c, tracked(calls, c.name)))
    if as_json:
        print_json([{"curve": c.name, "formulas": [vars(m) | {"nominal": str(m.nominal)} for m in found]} for c, found in results])
    else:
        _print_degrees(results)
    if not good:
        raise typer.Exit(2)


def _print_degrees(results: list[tuple[Any, list[Any]]]) -> None:
    from exactspline import report
    from exactspline.formulas import find
    from exactspline.printers.text import print_text
    from exactspline.readings.tree import trace

    out = report.console()
    for c, found in results:
        numbers = ("nominal", "represented", "true", "control points")
        made = report.table("formula", *numbers, "what it is", title=f"{c.name}: {described(c)}", right=numbers)
        for m in found:
            made.add_row(
                m.formula, str(m.nominal), str(m.represented), str(m.true), str(m.control_points), print_text(trace(find(m.formula), c.dimension))
            )
        out.print(made)
        out.print()


@app.command()
def curves(as_json: AsJson = False) -> None:
    """List the named example curves."""
    from exactspline import report
    from exactspline.curves import example, example_names

    found = [example(name) for name in example_names()]
    if as_json:
        print_json(
            [
                {"name": c.name, "degree": c.degree, "dimension": c.dimension, "polynomial": c.polynomial, "segments": c.segments, "note": c.note}
                for c in found
            ]
        )
        return
    made = report.table("name", "curve", "note")
    for c in found:
        made.add_row(c.name, described(c), c.note)
    report.console().print(made)


if __name__ == "__main__":
    main()
