"""``teach triangle``: the algorithms of lessons as tables of fractions."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Annotated

from exactspline.cli.common import CURVE_HELP, load_curve
from exactspline.cli.output import OptionsError, Output, printing
from exactspline.cli.parameters import Argument, Option

if TYPE_CHECKING:
    from exactspline.extras.teaching.display.triangles import Scheme
    from exactspline.splines.bspline import BSpline
    from exactspline.splines.nurbs import Nurbs


@printing
def triangle(
    out: Output,
    curve: Annotated[str, Argument(metavar="CURVE", help=CURVE_HELP)],
    at: Annotated[
        list[str] | None, Option("--at", metavar="T", help="De Boor's triangle at a parameter. May be repeated.")
    ] = None,
    insert: Annotated[list[str] | None, Option("--insert", metavar="T", help="Insert a knot. May be repeated.")] = None,
    times: Annotated[int, Option("--times", metavar="N", min=1, help="Insert it this many times.")] = 1,
    elevate: Annotated[
        int, Option("--elevate", metavar="N", min=0, max=100, help="Raise the degree by N, segment by segment.")
    ] = 0,
    product: Annotated[
        str, Option("--product", metavar="X,Y", help="Multiply two of the functions x, y, z, w of the curve.")
    ] = "",
    latex: Annotated[bool, Option("--latex", help="Print LaTeX (needs amsmath).")] = False,
    html: Annotated[bool, Option("--html", help="Print an HTML page, for a browser or a printer.")] = False,
) -> None:
    """The triangle of fractions of de Boor's algorithm, of knot insertion and degree elevation, and the table of a
    product.
    """
    from exactspline.extras.teaching.display.triangles import html_page, latex_text, scheme_data, sheets

    if latex + html + (not out.for_people) > 1:
        raise OptionsError("more than one format", remedy="choose one of --latex, --html, --json, --csv, --markdown")
    found = _schemes(load_curve(curve), at or [], insert or [], times, elevate, product)
    if latex:
        sys.stdout.write(latex_text(found) + "\n")
    elif html:
        sys.stdout.write(html_page(found, f"{curve}, step by step"))
    else:
        out.give("triangle", (scheme_data(s) for s in found), (x for s in found for x in sheets(s)))


def _schemes(curve: Nurbs, at: list[str], insert: list[str], times: int, elevate: int, product: str) -> list[Scheme]:
    from exactspline.extras.teaching.triangles import (
        de_boor_triangle,
        elevation_triangles,
        insertion_triangle,
        product_tables,
    )

    found: list[Scheme] = [de_boor_triangle(curve, t) for t in dict.fromkeys(at)]
    found += [insertion_triangle(curve, t, times) for t in dict.fromkeys(insert)]
    found += elevation_triangles(curve, elevate) if elevate else []
    found += product_tables(*_factors(curve, product)) if product else []
    if not found:
        raise OptionsError("nothing is asked", remedy="add --at T, --insert T, --elevate N or --product X,Y")
    return found


def _factors(curve: Nurbs, names: str) -> tuple[BSpline, BSpline]:
    """The two functions that the names mean: of a rational curve the numerators ``w x``, ``w y``."""
    known = dict(zip("xyz", curve.p, strict=False)) | {"w": curve.w}
    requested = [name.strip() for name in names.split(",")]
    if len(requested) != 2 or any(name not in known for name in requested):
        raise OptionsError(f"{names!r} does not name two functions", remedy=f"write two of {', '.join(known)}: x,y")
    return known[requested[0]], known[requested[1]]
