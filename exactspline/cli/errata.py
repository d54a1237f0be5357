"""``errata``: where a paper is wrong."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

from exactspline.cli.common import Digits, Exact, Papers, Trust
from exactspline.cli.output import Output, printing
from exactspline.cli.parameters import Argument
from exactspline.errors import ClaimError, counted, nearest

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rich.console import Console

    from exactspline.display.numbers import Numbers
    from exactspline.display.sheet import Sheet
    from exactspline.papers import Paper
    from exactspline.verification.errata import Erratum


@printing
def errata(
    out: Output,
    error: Annotated[
        list[str] | None,
        Argument(help="Names of errors, ids of claims, or places (span, C4.2b, 5.4, p. 19); without any, all."),
    ] = None,
    paper: Papers = None,
    trust: Trust = False,
    digits: Digits = 0,
    exact: Exact = False,
) -> None:
    """List the errors of the paper: the printed words with their place, what is true, why, a witness, and a check that
    can be pasted into Python.
    """
    from exactspline.display.errata import erratum_data
    from exactspline.display.evidence import worded
    from exactspline.display.numbers import Numbers
    from exactspline.display.sheet import Sheet
    from exactspline.papers import named_papers
    from exactspline.verification.errata import errata as errors
    from exactspline.verification.errata import remarks

    numbers = Numbers(digits, exact)
    sources = named_papers(paper or [], trust=trust)
    found = list(errors(sources))
    entries = _chosen([*found, *remarks(sources)], error or [], sources)

    def sheets() -> list[Sheet]:
        columns = ("error", "place", "printed", "which says", "found", "witness", "true", "why")
        made = Sheet(*columns, prose=columns[1:])
        for entry in entries:
            for each in entry.statements:
                seen = worded(each.witness, numbers)
                truth, why = "; ".join(entry.truth), "; ".join(entry.why)
                made.add_row(entry.title, each.place, each.words, each.statement, worded(each.found), seen, truth, why)
        return [made]

    def people() -> None:
        from exactspline.display import console

        shown = console.console()
        listed = [entry for entry in entries if entry in found]
        for entry in listed:
            _print(shown, f"{found.index(entry) + 1}. ", entry, numbers)
        for entry in entries:
            if entry not in found:
                _print(shown, "Remark: ", entry, numbers)
        statements = sum(len(entry.statements) for entry in listed)
        console.lines(
            shown, f"{counted(len(listed), 'error')} of the paper, {counted(statements, 'statement')} refuted"
        )
        if not out.quiet:
            console.legend(shown, ["PROVED", "VERIFIED"])

    out.give("errata", lambda: [erratum_data(entry) for entry in entries], sheets, people)


def _chosen(entries: list[Erratum], wanted: list[str], sources: Sequence[Paper]) -> list[Erratum]:
    """The errors with these names, of claims with these ids, or at these places (5.4, §5.4, eq. (34), p. 19)."""
    keep: list[Erratum] = []
    for name in wanted:
        own = [entry for entry in entries if entry.error.lower() == name.lower()]
        keep += own or _at(entries, name, sources)
    return [entry for entry in entries if not wanted or entry in keep]


def _at(entries: list[Erratum], wanted: str, sources: Sequence[Paper]) -> list[Erratum]:
    from exactspline.verification.claims import claims_in, located

    try:
        keys = {(claim.paper, claim.key) for claim in located(wanted, claims_in(sources))}
    except ClaimError:
        names = [name for e in entries for name in (e.error, *[n for s in e.statements for n in (s.id, s.key)])]
        remedy = nearest(wanted, names, listed_by="errata")
        raise ClaimError(f"there is no error called {wanted!r}", remedy=remedy) from None
    found = [entry for entry in entries if any((entry.paper, each.key) in keys for each in entry.statements)]
    if not found:
        raise ClaimError(f"nothing at {wanted!r} is refuted", remedy="without a name all errors are listed")
    return found


def _print(shown: Console, number: str, entry: Erratum, numbers: Numbers) -> None:
    from rich.text import Text

    from exactspline.display import console
    from exactspline.display.code import code_lines
    from exactspline.display.evidence import worded

    console.lines(shown, f"{number}{entry.title}", indent=3, style="bold")
    for each in entry.statements:
        words = f": “{each.words}”" if each.words else ""
        told = "printed in" if number[0].isdigit() else "beside"
        console.lines(shown, f"{told} {each.place}{words}", indent=5, first=3)
        console.lines(shown, f"which says: {each.statement} ({each.id})", indent=7, first=5)
        console.lines(shown, f"found: {worded(each.found)}", indent=7, first=5)
        if each.witness:
            console.lines(shown, f"witness: {worded(each.witness, numbers)}", indent=7, first=5)
    for line in entry.truth:
        console.lines(shown, f"true: {line}", indent=5, first=3)
    for line in entry.why:
        console.lines(shown, f"why: {line}", indent=5, first=3)
    console.lines(shown, "check:", first=3)
    # code begins where the line begins, so that it can be pasted
    for line in dict.fromkeys(line for each in entry.statements for line in each.check):
        for part in code_lines(line, shown.width):
            shown.print(Text(part, no_wrap=True, overflow="ignore"), soft_wrap=True)
    shown.print()
