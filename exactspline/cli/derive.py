"""``derive``: derived curves and functions as exact control points."""

from __future__ import annotations

from exactspline.cli.common import check_output, load_curve
from exactspline.cli.output import Output, print_json, printing, unchecked


@printing
def derive(out: Output, name: str, curve: str, output: str = "", variant: str = "minimal", trust: bool = False) -> None:
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
