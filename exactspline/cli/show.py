"""``show``: one claim spelled out."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

from exactspline.cli.common import PLACES, Papers, Trust, claims_of_papers
from exactspline.cli.output import Output, leave_out, printing
from exactspline.cli.parameters import Argument, Exit, Option
from exactspline.display.data import picked
from exactspline.display.sheet import COLOURS, Sheet
from exactspline.errors import command_name

if TYPE_CHECKING:
    from collections.abc import Sequence

    from exactspline.verification.claim import Claim
    from exactspline.verification.statement import Statement

#: Up to this many claims are spelled out for a person; of more, the first.
FEW = 3


@printing
def show(
    out: Output,
    claim: Annotated[
        str,
        Argument(
            help="The id of a claim, what it begins (C4.2: all of §4.2), a place in the paper (eq. (12)), or words of "
            "the statement (evolute). Without it the claims are listed. Of more than three the first is spelled out, "
            "the others are named.",
            instead_of=PLACES,
        ),
    ] = "",
    latex: Annotated[bool, Option("--latex", help="Print each claim as a theorem of LaTeX with its proof.")] = False,
    paper: Papers = None,
    trust: Trust = False,
) -> None:
    """Spell out a claim: what it says, its naive and its reduced side, the factor, the degrees, the verdict, the
    source.
    """
    from exactspline.display.statement import fields, statement_data
    from exactspline.verification.claims import located
    from exactspline.verification.statement import statement
    from exactspline.verification.verdict import NOT_ASKED

    claims = claims_of_papers(paper, trust)
    if not claim:
        _list(out, claims)
        return
    found = [statement(each) for each in located(claim, claims)]
    cells = [(s.claim.id, what, text) for s in found for what, text in fields(s)]
    out.give(
        "show",
        (statement_data(s) | {"key": f"{s.claim.paper}/{s.claim.key}"} for s in found),
        [Sheet("claim", "what", "is", rows=cells, prose=["is"])],
        lambda: _print_theorems(found) if latex else _print(out, found),
    )
    if not all(s.as_recorded for s in found):
        leave_out()
    if any(s.differs for s in found):
        raise Exit(1)
    if any(s.finding.verdict == NOT_ASKED and not s.as_recorded for s in found):
        raise Exit(2)


def _list(out: Output, claims: Sequence[Claim]) -> None:
    from exactspline.display.ledger import section

    rows = [
        {"key": f"{c.paper}/{c.key}", **picked(c, "id", "status"), "section": section(c)}
        | picked(c, "source", "statement")
        for c in claims
    ]
    cells = [(row["id"], row["section"], row["statement"]) for row in rows]
    out.give("claims", rows, [Sheet("claim", "section", "statement", rows=cells, prose=["statement"])])


def _print_theorems(found: list[Statement]) -> None:
    """For copying, so that lines are not broken."""
    from exactspline.display import console
    from exactspline.display.theorem import PREAMBLE, theorem

    shown = console.console()
    console.unbroken(shown, PREAMBLE)
    shown.print()
    for each in found:
        console.unbroken(shown, theorem(each))
        shown.print()


def _print(out: Output, found: list[Statement]) -> None:
    from exactspline.display import console
    from exactspline.display.statement import fields, heading

    shown = console.console()
    spelled = found if len(found) <= FEW else found[:1]
    for i, s in enumerate(spelled):
        if i:
            shown.print()
        console.lines(shown, heading(s), style="bold")
        for what, text in fields(s):
            style = COLOURS.get(text.split(" ")[0], "") if what == "verdict" else ""
            console.lines(shown, f"{what}: {text}", indent=4, first=2, style=style)
    if others := found[len(spelled) :]:
        shown.print()
        console.lines(shown, f"{len(others)} others; `{command_name()} show NAME` spells one out:")
        for s in others:
            console.lines(shown, f"{s.claim.key} {s.finding.verdict}: {s.claim.statement}", indent=4, first=2)
    if not out.quiet:
        console.legend(shown, ["naive", "reduced", *[s.finding.verdict for s in found]])
