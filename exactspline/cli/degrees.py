"""``exactspline degrees``: degrees and control points of the constructions."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from exactspline.cli.common import AsJson, CurveFiles, also_in_their_planes, described, loaded, print_json, tracked
from exactspline.errors import ShapeError


def degrees(
    curve: CurveFiles = None,
    formulas: Annotated[
        bool, typer.Option("--variantulas", help="Every formula of the library instead of the constructions.")
    ] = False,
    generic: Annotated[
        bool, typer.Option("--generic", help="For all curves: what is proved of the generic curve of degree d.")
    ] = False,
    certify: Annotated[
        bool, typer.Option("--certify", help="Proofs that the minimal forms cannot be lowered, as JSON data.")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Nominal (in d), represented and true degree and the number of control points: naive, paper, minimal (or formula
    by formula).
    """
    from exactspline.verification.degree_tables import construction_table, formula_table

    if certify:
        _certify(curve)
        return
    if generic:
        _generic(as_json)
        return

    chosen, good = loaded(
        curve or ["rational_cubic", "rational_space_cubic"]
        if formulas
        else curve or ["rational_cubic", "six_segment_cubic"]
    )
    make = formula_table if formulas else construction_table
    results = [(c, tracked(make(c), c.name)) for c in also_in_their_planes(chosen)]
    if as_json:
        print_json([{"curve": c.name, "formulas": [row.data() for row in rows]} for c, rows in results])
    else:
        _print_degrees(results)
    if not good:
        raise typer.Exit(2)


def _certify(names: list[str] | None) -> None:
    """Certificates of all constructions on the curves, or on the witnesses of the generic curve."""
    from exactspline.geometry.constructions import all_constructions, constructions_for
    from exactspline.verification.degree_tables import WITNESSES
    from exactspline.verification.minimality import attained, certificate

    if not names:
        tasks = [
            (name, d, polynomial) for name in all_constructions() for polynomial in (False, True) for d in WITNESSES
        ]
        found = tracked([lambda t=t: attained(t[0], t[1], polynomial=t[2]) for t in tasks], "witnesses")
        print_json([vars(a) for a in found])
        raise typer.Exit(0 if all(a.agrees for a in found) else 1)
    chosen, good = loaded(names)
    data = []
    for c in chosen:
        for made in constructions_for(c.dimension):
            try:
                data.append(certificate(made.name, c))
            except ShapeError as error:
                data.append({"curve": c.name, "construction": made.name, "missing": str(error)})
    print_json(data)
    if not good:
        raise typer.Exit(2)


def _generic(as_json: bool) -> None:
    from exactspline.display import console
    from exactspline.verification.degree_tables import generic_table

    kinds = {kind: tracked(generic_table(polynomial=kind == "polynomial"), kind) for kind in ("rational", "polynomial")}
    if as_json:
        print_json({kind: [vars(row) for row in rows] for kind, rows in kinds.items()})
        return
    out = console.console()
    for kind, rows in kinds.items():
        numbers = ("naive", "paper", "k", "m", "kd − m", "j", "true", "attained at d")
        made = console.table("construction", *numbers, title=f"The generic {kind} curve of degree d", right=numbers)
        for row in rows:
            counts = (row.naive, row.paper, str(row.k), str(row.m), row.nominal, str(row.j), row.true)
            made.add_row(row.object, *counts, _degrees(row))
        out.print(made)
        out.print()
    if any(row.differ for rows in kinds.values() for row in rows):
        raise typer.Exit(1)


def _degrees(row: Any) -> str:
    absent = f"; absent at {', '.join(map(str, row.absent))}" if row.absent else ""
    differ = f"; DIFFERS at {', '.join(map(str, row.differ))}" if row.differ else ""
    return ", ".join(map(str, row.attained)) + absent + differ


def _print_degrees(results: list[tuple[Any, list[Any]]]) -> None:
    from exactspline.display import console

    out = console.console()
    for c, rows in results:
        numbers = ("nominal", "k, m, j", "degree", "true", "points", "generic")
        # on a narrow terminal the numbers are worth more than the formulas
        last = ["what it is"] if out.width >= 120 else []
        made = console.table("formula", "variant", *numbers, *last, title=f"{c.name}: {described(c)}", right=numbers)
        for row in rows:
            counted = ["–" if n is None else str(n) for n in (row.represented, row.true, row.control_points)]
            counts = (str(row.nominal), row.grading, *counted, str(row.generic))
            made.add_row(row.formula, row.variant, *counts, *([row.text] if last else []))
        out.print(made)
        out.print()
