"""``identity``: one identity between any formulas."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

from exactspline.cli.common import Trust
from exactspline.cli.output import Output, printing
from exactspline.cli.parameters import Argument, Exit

if TYPE_CHECKING:
    from exactspline.display.sheet import Sheet
    from exactspline.verification.questions import Proof


@printing
def identity(
    out: Output,
    text: Annotated[str, Argument(metavar="IDENTITY", help='"f1 = w * f2", or "file.py:left = w^3 * file.py:right".')],
    trust: Trust = False,
) -> None:
    """Decide one identity between formulas, yours too, for all curves; exit status 1 where it does not hold."""
    from exactspline.display import console
    from exactspline.verification.questions import proof_of

    found = proof_of(text, trust=trust)
    out.give(
        "identity",
        lambda: [found.data()],
        lambda: [_sheet(found)],
        lambda: console.lines(console.console(), str(found)),
    )
    if not found:
        raise Exit(1)


def _sheet(found: Proof) -> Sheet:
    from exactspline.display.sheet import Sheet

    made = Sheet("left", "factor", "right", "verdict", "quotient")
    made.add_row(found.left, found.factor, found.right, found.verdict, str(found.quotient or "–"))
    return made
