"""``errata``: where a paper is wrong."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

from exactspline.cli.common import PLACES, Digits, Exact, Papers, Trust
from exactspline.cli.output import Output, printing
from exactspline.cli.parameters import Argument
from exactspline.errors import ClaimError, nearest

if TYPE_CHECKING:
    from collections.abc import Sequence

    from exactspline.papers import Paper
    from exactspline.verification.errata import Erratum


@printing
def errata(
    out: Output,
    error: Annotated[
        list[str] | None,
        Argument(
            help="Names of errors, ids of claims, or places (span, C4.2b, 5.4, p. 19); without any, all.",
            instead_of=PLACES,
        ),
    ] = None,
    paper: Papers = None,
    trust: Trust = False,
    digits: Digits = 0,
    exact: Exact = False,
) -> None:
    """List the errors of the paper: the printed words with their place, what is true, why, a witness, and a check that
    can be pasted into Python.
    """
    from exactspline.display.errata import errata_sheet, erratum_data, print_errata
    from exactspline.display.numbers import Numbers
    from exactspline.papers import named_papers
    from exactspline.verification.combined import computed_once
    from exactspline.verification.errata import errata as errors
    from exactspline.verification.errata import left_open, remarks

    numbers = Numbers(digits, exact)
    sources = named_papers(paper or [], trust=trust)
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
