"""``identity``: one identity between any formulas."""

from __future__ import annotations

from typing import Annotated

from exactspline.cli.common import Limit, Trust
from exactspline.cli.output import Output, printing
from exactspline.cli.parameters import Argument, Exit
from exactspline.display.sheet import Sheet


@printing
def identity(
    out: Output,
    text: Annotated[
        str,
        Argument(
            metavar="IDENTITY", help='"2*f1 = f1 + f1", "det(γ\', γ\'\') = w^-3 * f2", "file.py:left = w * right".'
        ),
    ],
    trust: Trust = False,
    limit: Limit = None,
) -> None:
    """Decide one identity between formulas, yours too, for all curves; exit status 1 where it does not hold."""
    from exactspline.display import console
    from exactspline.polynomials.cost import within_seconds
    from exactspline.verification.questions import proof_of

    with within_seconds(limit):
        found = proof_of(text, trust=trust)
    cells = (found.left, found.factor, found.right, found.verdict, str(found.quotient or "–"))
    made = Sheet("left", "factor", "right", "verdict", "quotient", rows=[cells])
    out.give("identity", [found.data()], [made], lambda: console.lines(console.console(), str(found)))
    if not found:
        raise Exit(1)
