"""``exactspline derive``: derived curves and functions as exact control points."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from exactspline.cli.common import Trust, check_output, load_curve
from exactspline.cli.output import Output, print_json, printing
from exactspline.errors import CurveFileError

if TYPE_CHECKING:
    from exactspline.display.sheet import Sheet


@printing
def derive(
    out: Output,
    name: Annotated[
        str,
        typer.Argument(
            help="A construction (evolute, zero_curvature, critical_curvature, …) or a formula (f2, g2, …), yours too: "
            "FOLDER:NAME or file.py:NAME. Without it they are listed."
        ),
    ] = "",
    curve: Annotated[
        str,
        typer.Argument(
            help="A curve file (JSON), the name of an example curve, or - for standard input; for a formula of "
            "surfaces a surface file or the name of an example surface."
        ),
    ] = "",
    output: Annotated[
        str, typer.Option("--output", "-o", metavar="FILE", help="The file to write; standard output without it.")
    ] = "",
    variant: Annotated[
        str,
        typer.Option(
            "--variant", metavar="VARIANT", help="naive, paper, minimal or another variant that the construction has."
        ),
    ] = "minimal",
    trust: Trust = False,
) -> None:
    """Write a derived curve or function as exact control points (JSON)."""
    from exactspline.display.serialize import derived_data
    from exactspline.display.surface_values import surface_value_data
    from exactspline.geometry.derived import derive as derived
    from exactspline.interchange.curve_files import write_json
    from exactspline.interchange.examples import load_surface
    from exactspline.language.formula import Formula
    from exactspline.language.kinds import PLANAR_MAP, SURFACE
    from exactspline.papers import resolve

    if not name:
        _list(out)
        return
    if not curve:
        raise CurveFileError(
            "no curve is named", where=f"derive {name}", remedy="name a curve file or an example curve"
        )
    check_output(output, curve)
    wanted = resolve(name, trust=trust) if ":" in name else name
    if isinstance(wanted, Formula) and wanted.kind in (SURFACE, PLANAR_MAP):
        data = surface_value_data(wanted, load_surface(curve), curve)
    else:
        data = derived_data(derived(wanted, load_curve(curve), variant), curve)
    if output:
        write_json(output, data)
    else:
        print_json(data)


def _list(out: Output) -> None:
    """What can be derived: the constructions with their variants, and the formulas."""
    from exactspline.display.sheet import Sheet
    from exactspline.geometry.constructions import all_constructions
    from exactspline.language.kinds import CURVE, PLANE, SPACE
    from exactspline.papers import all_formulas

    rows = [
        {"key": name, "name": name, "kind": "construction", "curve": c.curve, "variants": list(c.all_variants)}
        for name, c in all_constructions().items()
    ] + [
        {"key": f"formula {name}", "name": name, "kind": "formula", "curve": str(f.curve), "variants": []}
        for name, f in all_formulas().items()
        if f.kind in (CURVE, PLANE, SPACE)
    ]

    def sheets() -> list[Sheet]:
        made = Sheet("name", "what", "of a", "variants", prose=["variants"])
        for row in rows:
            kind = {"plane": "plane curve", "space": "space curve"}.get(str(row["curve"]), "curve")
            made.add_row(row["name"], row["kind"], kind, ", ".join(row["variants"]))
        return [made]

    out.give("derivable", lambda: rows, sheets)
