"""``show``: one claim spelled out."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from exactspline.cli.common import AsJson, print_json

#: Longer than any line.
LONG = 10_000


def show(
    claim: Annotated[str, typer.Argument(help="The id of a claim, or what it begins (C4.2: all of §4.2).")],
    latex: Annotated[bool, typer.Option("--latex", help="Print formulas as LaTeX.")] = False,
    as_json: AsJson = False,
) -> None:
    """Spell out a claim: what it says, its naive and its reduced side, the factor, the degrees, the verdict, the
    source.
    """
    from exactspline.verification.statement import statements

    found = list(statements(claim))
    if as_json:
        print_json([s.data() for s in found])
    else:
        _print(found, latex)
    if not all(s.as_recorded for s in found):
        raise typer.Exit(1)


def _print(found: list[Any], latex: bool) -> None:
    from exactspline.display import console

    out = console.console()
    for s in found:
        made = console.spelled_out(s, latex)
        # LaTeX is for copying: no line of it is broken
        out.print(console.plain(made, LONG) + "\n" if latex else made, soft_wrap=latex, markup=False)
