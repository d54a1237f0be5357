"""``formula conditioning``: the forms of a zero set compared by condition number and errors in double precision."""

from __future__ import annotations

from functools import partial
from typing import Annotated

from exactspline.cli.common import CURVE_HELP, loaded
from exactspline.cli.output import Output, printing
from exactspline.cli.parameters import Argument, Exit, Option
from exactspline.cli.progress import tracked

#: The default: a witness for each direction.
WITNESSES = ("conditioning_reduced_worse", "conditioning_reduced_better")


@printing
def conditioning(
    out: Output,
    curve: Annotated[
        list[str] | None, Argument(help=f"{CURVE_HELP} Without any, a witness for each direction.")
    ] = None,
    construction: Annotated[
        str, Option("--construction", metavar="NAME", help="zero_curvature or critical_curvature.")
    ] = "critical_curvature",
) -> None:
    """Condition numbers of every zero in every form: naive, paper, minimal; and the error of double precision in
    each.
    """
    from exactspline.display.conditioning import comparison_data, comparison_sheet, print_comparisons
    from exactspline.verification.conditioning.compare import conditioning as compared

    chosen, good = loaded(curve or WITNESSES)
    found = tracked([partial(compared, c, construction) for c in chosen], "comparing")
    pairs = list(zip(chosen, found, strict=True))
    out.give(
        "conditioning",
        [{"key": f"{e.curve}: {e.construction}", "what": "curve", "data": comparison_data(e)} for e in found],
        [comparison_sheet(c, each) for c, each in pairs],
        lambda: print_comparisons(pairs, quiet=out.quiet),
    )
    if not good:
        raise Exit(2)
