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
    search: Annotated[
        int, Option("--search", metavar="N", min=0, max=10_000, help="Search N random curves of each family too.")
    ] = 0,
    seed: Annotated[
        int, Option("--seed", metavar="N", help="The seed of the search: the same seed gives the same result.")
    ] = 0,
) -> None:
    """Condition numbers of every zero in every form: naive, paper, minimal; and the error of double precision in
    each.
    """
    from exactspline.display.conditioning import (
        comparison_data,
        comparison_sheet,
        print_comparisons,
        tally_data,
        tally_sheet,
    )
    from exactspline.verification.conditioning.compare import conditioning as compared
    from exactspline.verification.conditioning.search import search_witnesses

    chosen, good = loaded(curve or (() if search else WITNESSES))
    found = tracked([partial(compared, c, construction) for c in chosen], "comparing")
    (tallies,) = tracked([lambda: search_witnesses(seed, search)], "searching") if search else ([],)
    pairs = list(zip(chosen, found, strict=True))
    out.give(
        "conditioning",
        [
            *({"key": f"{e.curve}: {e.construction}", "what": "curve", "data": comparison_data(e)} for e in found),
            *(
                {"key": f"search: {t.family}, {t.construction}, {t.form}", "what": "search", "data": tally_data(t)}
                for t in tallies
            ),
        ],
        [*[comparison_sheet(c, each) for c, each in pairs], *([tally_sheet(tallies)] if tallies else [])],
        lambda: print_comparisons(pairs, tallies, quiet=out.quiet),
    )
    if not good:
        raise Exit(2)
