"""Errors of papers, as data, as a table and as text."""

from __future__ import annotations

from collections.abc import Sequence

from rich.console import Console

from exactspline.display import console
from exactspline.display.evidence import worded
from exactspline.display.numbers import Numbers
from exactspline.display.sheet import Sheet, code_lines
from exactspline.errors import command_name, counted
from exactspline.papers import option_of
from exactspline.verification.errata import Erratum, Holds, Refuted
from exactspline.verification.vocabulary import Verdict


def erratum_data(entry: Erratum) -> dict[str, object]:
    """An error of a paper as data.

    >>> from exactspline.verification.errata import errata
    >>> data = erratum_data(errata()[0])
    >>> data["error"], len(data["statements"])
    ('span', 1)
    """
    statements = [
        vars(each) | {"found": worded(each.found), "witness": worded(each.witness)} for each in entry.statements
    ]
    truth = [vars(each) | {"verdict": str(each.verdict)} for each in entry.truth]
    return {"key": f"{entry.paper}: {entry.error}"} | vars(entry) | {"statements": statements, "truth": truth}


def errata_sheet(entries: Sequence[Erratum], numbers: Numbers) -> Sheet:
    """The statements of errors, one per row."""
    columns = ("error", "place", "printed", "which says", "found", "witness", "true", "why")
    cells = [
        (e.title, each.place, each.words, each.statement, found_text(each), worded(each.witness, numbers), *reasons)
        for e in entries
        for reasons in [("; ".join(map(true_text, e.truth)), "; ".join(e.why))]
        for each in e.statements
    ]
    return Sheet(*columns, rows=cells, prose=columns[1:])


def print_errata(
    entries: Sequence[Erratum],
    errors: Sequence[Erratum],
    numbers: Numbers,
    undecided: Sequence[tuple[str, Verdict]] = (),
    *,
    quiet: bool,
) -> None:
    """Print entries: those that are errors with their number among all errors, then the others as remarks; then the
    keys of what neither holds nor fails.
    """
    shown = console.console()
    listed = [entry for entry in entries if entry in errors]
    for entry in listed:
        _print(shown, f"{errors.index(entry) + 1}. ", entry, numbers)
    for entry in entries:
        if entry not in errors:
            _print(shown, "Remark: ", entry, numbers)
    statements = sum(len(entry.statements) for entry in listed)
    console.lines(shown, f"{counted(len(listed), 'error')} of the paper, {counted(statements, 'statement')} refuted")
    if undecided:
        keys = ", ".join(f"{key} ({verdict})" for key, verdict in undecided)
        console.lines(shown, f"neither proved nor refuted: {keys}")
    if not quiet:
        console.legend(shown, [*dict.fromkeys(verdict for _, verdict in undecided), "PROVED", "VERIFIED"])


def _print(shown: Console, number: str, entry: Erratum, numbers: Numbers) -> None:
    console.lines(shown, f"{number}{entry.title}", indent=3, style="bold")
    for each in entry.statements:
        words = f": “{each.words}”" if each.words else ""
        where = "printed in" if number[0].isdigit() else "beside"
        console.lines(shown, f"{where} {each.place}{words}", indent=5, first=3)
        console.lines(shown, f"which says: {each.statement} ({_names(each)})", indent=7, first=5)
        console.lines(shown, f"found: {found_text(each)}", indent=7, first=5)
        if each.witness:
            console.lines(shown, f"witness: {worded(each.witness, numbers)}", indent=7, first=5)
    for held in entry.truth:
        console.lines(shown, f"true: {true_text(held)}", indent=5, first=3)
    for line in entry.why:
        console.lines(shown, f"why: {line}", indent=5, first=3)
    console.lines(shown, "check:", first=3)
    # code begins where the line begins, so that it can be pasted
    for line in dict.fromkeys(line for each in entry.statements for line in each.check):
        for part in code_lines(line, shown.width):
            console.unbroken(shown, part)
    first = entry.statements[0].key
    also = " (or another of these keys)" if len(entry.statements) + len(entry.truth) > 1 else ""
    shows = f"show {first}{option_of(entry.paper)} --latex"
    console.lines(shown, f"a theorem to cite: {command_name()} {shows}{also}", indent=5, first=3)
    shown.print()


def _names(statement: Refuted) -> str:
    """The claim to which a statement belongs, and its own key."""
    return statement.key if statement.key == statement.id else f"{statement.id}, {statement.key}"


def true_text(each: Holds) -> str:
    """What holds instead, with its verdict and its key."""
    return f"{each} ({each.key})"


def found_text(statement: Refuted) -> str:
    """What holds instead of a statement, with what its letters stand for."""
    found = worded(statement.found)
    return f"{found}, where {', '.join(statement.where)}" if statement.where else found
