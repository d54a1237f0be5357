"""``inspect``: the features of a curve."""

from __future__ import annotations

from dataclasses import asdict
from typing import Annotated, Any

import typer

from exactspline.commands.common import AsJson, described, print_json


def inspect(
    curve: Annotated[str, typer.Argument(help="A curve file (JSON) or the name of an example curve.")],
    digits: Annotated[int, typer.Option("--digits", min=1, max=100_000, help="Digits of parameters and curvatures.")] = 20,
    approach: Annotated[str, typer.Option("--approach", help="squaring, direct, reduced, minimal, or all side by side.")] = "minimal",
    plot: Annotated[str, typer.Option("--plot", help="Draw the curve and the function that was solved into an SVG or PNG file.")] = "",
    certificate: Annotated[
        str, typer.Option("--certificate", help="Write a proof that these are all zeros (JSON; see exactspline.zeros.checker).")
    ] = "",
    as_json: AsJson = False,
) -> None:
    """Inflections, curvature extrema and cusps of a plane curve, certified, to any number of digits."""
    from exactspline.curves import load
    from exactspline.inspection import compare_approaches, inspect_curve, inspection_data

    c = load(curve)
    found = inspect_curve(c, "minimal" if approach == "all" else approach)
    count = len(found.singularities) + len(found.inflections) + len(found.critical)
    with _ticking(count) as tick:
        data = inspection_data(c, found, digits, tick)
    if approach == "all":
        data["approaches"] = [asdict(row) for row in compare_approaches(c)]
    if certificate:
        _certify(c, found, certificate)
    if plot:
        _draw(c, found, plot)
    if as_json:
        print_json(data)
    else:
        _print(c, data)


def _ticking(count: int) -> Any:
    """A progress bar on a terminal, advanced by calling what it gives."""
    import sys
    from contextlib import contextmanager

    from rich.console import Console
    from rich.progress import Progress

    @contextmanager
    def bar() -> Any:
        with Progress(console=Console(stderr=True), transient=True, disable=not sys.stderr.isatty()) as progress:
            task = progress.add_task("refining", total=count)
            yield lambda: progress.advance(task)

    return bar()


def _print(c: Any, data: dict[str, Any]) -> None:
    from exactspline import report

    out = report.console()
    closed = ", closed" if c.closed else ""
    made = report.table("what", "parameter", "exactly", "curvature", "remark", title=f"{c.name}: {described(c)}{closed}")
    for group in ("singularities", "inflections", "critical"):
        for f in data[group]:
            remark = " at a knot, by a jump" if f["by_jump"] else " at a knot" if f["at_knot"] else ""
            kind = f["kind"] + (" of κ" if f["kind"] in ("maximum", "minimum") else "")
            absolute = f"{f['of_absolute']} of |κ|" if f.get("of_absolute") else ""
            made.add_row(kind, f["decimal"], f["parameter"] or "–", f.get("curvature", ""), absolute + remark)
    for name, what in (("straight", "straight"), ("constant_curvature", "κ′ ≡ 0")):
        for a, b in data[name]:
            made.add_row(what, f"[{a}, {b}]", f"[{a}, {b}]", "", "")
    out.print(made if made.row_count else f"{c.name}: no singular points, no inflections, no extrema of the curvature inside", markup=False)
    if "approaches" in data:
        out.print(_approaches(report, data["approaches"]))


def _approaches(report: Any, rows: list[dict[str, Any]]) -> Any:
    numbers = ("degree", "control points", "roots", "invented", "missing", "seconds")
    made = report.table("approach", *numbers, title="\nApproaches to critical curvature", right=numbers)
    for row in rows:
        made.add_row(row["name"], *[str(row[name.replace(" ", "_")]) for name in numbers[:-1]], f"{row['seconds']:.4f}")
    return made


def _solved(c: Any, found: Any) -> list[tuple[Any, Any, Any]]:
    """The constructions that were solved, their functions and their zeros."""
    from exactspline.constructions import construction
    from exactspline.features import zero_form
    from exactspline.inspection import APPROACHES

    forms = (("zero_curvature", "minimal"), ("critical_curvature", APPROACHES[found.approach]))
    return [(construction(name), *zero_form(c, name, form)) for name, form in forms]


def _certify(c: Any, found: Any, path: str) -> None:
    from exactspline.curves import write_json

    write_json(path, [{"curve": c.name, "function": made.name, "certificate": zero_set.certificate()} for made, _, zero_set in _solved(c, found)])


def _draw(c: Any, found: Any, path: str) -> None:
    from exactspline.plot import inspect_figure, save

    save(inspect_figure(c, [(made.title, f, zero_set) for made, f, zero_set in _solved(c, found)]), path)
