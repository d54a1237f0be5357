"""``show``: one claim spelled out."""

from __future__ import annotations

from typing import TYPE_CHECKING

from exactspline.cli.common import claims_of_papers
from exactspline.cli.output import Exit, Output, leave_out, printing
from exactspline.display.forms import picked
from exactspline.display.sheet import COLOURS, Sheet
from exactspline.errors import ClaimError, command_name, nearest
from exactspline.verification.verdict import NOT_ASKED

if TYPE_CHECKING:
    from collections.abc import Sequence

    from exactspline.papers import Paper
    from exactspline.verification.claim import Claim
    from exactspline.verification.statement import Erratum, Statement


#: Up to this many claims are spelled out for people; if there are more, only the first.
FEW = 3


@printing
def show(
    out: Output, claim: str = "", latex: bool = False, paper: list[str] | None = None, trust: bool = False
) -> None:
    """Show a claim in full: the statement, the naive and the reduced side, the factor between the sides, the degrees,
    the verdict, and the source.
    """
    from exactspline.display.ledger import fields, statement_data
    from exactspline.verification.claims import located
    from exactspline.verification.statement import statement

    claims = claims_of_papers(paper, trust)
    if not claim:
        _list(out, claims)
        return
    found = [statement(each) for each in located(claim, claims)]
    cells = ((s.claim.id, what, text) for s in found for what, text in fields(s))  # where they are printed
    out.give(
        "show",
        (statement_data(s) | {"key": f"{s.claim.paper}/{s.claim.key}"} for s in found),
        (Sheet("claim", "what", "is", rows=each, prose=["is"]) for each in [cells]),
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
    """Print theorems for copying: long lines are not broken."""
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
    from exactspline.display.ledger import fields, heading

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
        modes = [s.reading for s in spelled if s.reading in ("jet", "spline")]
        console.legend(shown, ["naive", "reduced", *[s.finding.verdict for s in found], *modes])


# ---- errors


@printing
def errata(
    out: Output,
    error: list[str] | None = None,
    paper: list[str] | None = None,
    trust: bool = False,
    digits: int = 0,
    exact: bool = False,
) -> None:
    """List the errors of a paper: for each error the printed words with their place, a witness, the corrected
    statement, the reason, and a check that can be pasted into Python.
    """
    from exactspline.display.numbers import Numbers
    from exactspline.display.tables import errata_sheet, erratum_data, print_errata
    from exactspline.papers import named_papers
    from exactspline.verification.combined import computed_once
    from exactspline.verification.statement import errata as errors
    from exactspline.verification.statement import left_open, remarks

    numbers = Numbers(digits, exact)
    sources = named_papers(paper or [], trust=trust, partly=True)
    with computed_once():
        found = list(errors(sources))
        entries = _chosen([*found, *remarks(sources)], error or [], sources)
        undecided = [] if error else list(left_open(sources))

    out.give(
        "errata",
        (erratum_data(entry) for entry in entries),
        [errata_sheet(entries, numbers)],
        lambda: print_errata(entries, found, numbers, undecided, quiet=out.quiet),
    )
    if any(verdict == NOT_ASKED != claim.expected for claim, verdict in undecided):
        raise Exit(2)


def _chosen(entries: list[Erratum], requested: list[str], sources: Sequence[Paper]) -> list[Erratum]:
    """The errors with these names, of claims with these ids, or at these places (5.4, §5.4, eq. (34), p. 19)."""
    keep: list[Erratum] = []
    for name in requested:
        own = [entry for entry in entries if entry.error.lower() == name.lower()]
        keep += own or _at(entries, name, sources)
    return [entry for entry in entries if not requested or entry in keep]


def _at(entries: list[Erratum], requested: str, sources: Sequence[Paper]) -> list[Erratum]:
    from exactspline.verification.claims import claims_in, located

    try:
        keys = {(claim.paper, claim.key) for claim in located(requested, claims_in(sources))}
    except ClaimError:
        names = [name for e in entries for name in (e.error, *[n for s in e.statements for n in (s.id, s.key)])]
        remedy = nearest(requested, names, listed_by="errata")
        raise ClaimError(f"there is no error called {requested!r}", remedy=remedy) from None
    found = [entry for entry in entries if any((entry.paper, each.key) in keys for each in entry.statements)]
    if not found:
        raise ClaimError(f"nothing at {requested!r} is refuted", remedy="without a name all errors are listed")
    return found
