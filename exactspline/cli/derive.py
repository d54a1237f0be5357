"""``exactspline derive``: derived curves and functions as exact control points."""

from __future__ import annotations

from typing import Annotated

import typer

from exactspline.cli.common import check_output, print_json


def derive(
    name: Annotated[
        str,
        typer.Argument(
            help="A construction (evolute, zero_curvature, critical_curvature, …) or a formula (f2, g2, …)."
        ),
    ],
    curve: Annotated[str, typer.Argument(help="A curve file (JSON) or the name of an example curve.")],
    output: Annotated[str, typer.Option("--output", "-o", help="The file to write; standard output without it.")] = "",
    variant: Annotated[
        str, typer.Option("--variant", help="naive, paper, minimal or another variant that the construction has.")
    ] = "minimal",
) -> None:
    """Write a derived curve or function as exact control points."""
    from exactspline.display.serialize import derived_data
    from exactspline.geometry.derived import derive as derived
    from exactspline.splines.curve_files import write_json
    from exactspline.splines.examples import load

    check_output(output, curve)
    data = derived_data(derived(name, load(curve), variant), curve)
    if output:
        write_json(output, data)
    else:
        print_json(data)
