"""``curves``, ``degrees`` and ``derive``: curves and what is derived from them."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from exactspline.commands.common import AsJson, CurveFiles, also_in_their_planes, described, loaded, print_json, tracked


def degrees(
    curve: CurveFiles = None,
    formulas: Annotated[bool, typer.Option("--formulas", help="Every formula of the library instead of the constructions.")] = False,
    as_json: AsJson = False,
) -> None:
    """Nominal (in d), represented and true degree and the number of control points: naive, paper, minimal (or formula by formula)."""
    from exactspline.tables import construction_table, formula_table

    chosen, good = loaded(curve or ["rational_cubic", "rational_space_cubic"] if formulas else curve or ["rational_cubic", "six_segment_cubic"])
    make = formula_table if formulas else construction_table
    results = [(c, tracked(make(c), c.name)) for c in also_in_their_planes(chosen)]
    if as_json:
        print_json([{"curve": c.name, "formulas": [row.data() for row in rows]} for c, rows in results])
    else:
        _print_degrees(results)
    if not good:
        raise typer.Exit(2)


def _print_degrees(results: list[tuple[Any, list[Any]]]) -> None:
    from exactspline import report

    out = report.console()
    for c, rows in results:
        numbers = ("nominal", "represented", "true", "control points", "generic true degree")
        made = report.table("formula", "form", *numbers, "what it is", title=f"{c.name}: {described(c)}", right=numbers)
        for row in rows:
            true = "–" if row.true is None else str(row.true)
            counts = (str(row.nominal), str(row.represented), true, str(row.control_points), str(row.generic))
            made.add_row(row.formula, row.form, *counts, row.text)
        out.print(made)
        out.print()


def derive(
    name: Annotated[str, typer.Argument(help="A construction (evolute, zero_curvature, critical_curvature, …) or a formula (f2, g2, …).")],
    curve: Annotated[str, typer.Argument(help="A curve file (JSON) or the name of an example curve.")],
    output: Annotated[str, typer.Option("--output", "-o", help="The file to write; standard output without it.")] = "",
    form: Annotated[str, typer.Option("--form", help="naive, paper, minimal or another form that the construction has.")] = "minimal",
) -> None:
    """Write a derived curve or function as exact control points."""
    from exactspline.curves import load, write_json
    from exactspline.interrogate import derive as derived
    from exactspline.tables import derived_data

    data = derived_data(derived(name, load(curve), form), curve)
    if output:
        write_json(output, data)
    else:
        print_json(data)


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
