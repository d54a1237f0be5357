"""``derive``: derived curves and functions as exact control points."""

from __future__ import annotations

from typing import Annotated

from exactspline.cli.common import Trust, check_output, load_curve
from exactspline.cli.output import Argument, Option, Output, print_json, printing, unchecked


@printing
def derive(
    out: Output,
    name: Annotated[
        str,
        Argument(
            help="A construction (evolute, zero_curvature, critical_curvature, …) or a formula (f2, g2, …; "
            "see list formulas). A formula of your own is FOLDER:NAME or file.py:NAME."
        ),
    ],
    curve: Annotated[
        str,
        Argument(
            help="A file with one curve, the name of an example curve, or - for standard input. For a "
            "formula of surfaces give a surface in the same ways."
        ),
    ],
    output: Annotated[
        str, Option("--output", "-o", metavar="FILE", help="The file to write instead of standard output.")
    ] = "",
    variant: Annotated[
        str,
        Option(
            "--variant",
            metavar="VARIANT",
            help="The variant of the construction: naive (without cancellation), paper, minimal, ….",
        ),
    ] = "minimal",
    trust: Trust = False,
) -> None:
    """Write the exact control points of a derived curve or function (JSON)."""
    from exactspline.cli.common import read_surface
    from exactspline.display.forms import derived_data
    from exactspline.display.surface_data import surface_value_data
    from exactspline.geometry.derived.derive import derive as derived
    from exactspline.interchange.curve_files import write_json
    from exactspline.language.formula import Formula
    from exactspline.language.kinds import PLANAR_MAP, SURFACE
    from exactspline.papers import resolve

    check_output(output, curve)
    requested = resolve(name, trust=trust) if ":" in name else name
    if isinstance(requested, Formula) and requested.kind in (SURFACE, PLANAR_MAP):
        data = surface_value_data(requested, read_surface(curve), curve)
    else:
        data = derived_data(derived(requested, load_curve(curve), variant), curve)
    if unchecked():
        data |= {"unchecked": list(unchecked())}
    if output:
        write_json(output, data)
    else:
        print_json(data)
