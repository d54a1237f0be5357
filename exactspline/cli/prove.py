"""``exactspline prove``: the ledger."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Any

import typer

from exactspline.cli.common import (
    AsJson,
    CurveFiles,
    Digits,
    also_in_their_planes,
    described,
    loaded,
    print_json,
    tracked,
)


def prove(
    claim: Annotated[
        list[str] | None,
        typer.Option("--claim", help="The id of a claim, or what it begins (C3: all of section 3); may be repeated."),
    ] = None,
    curve: CurveFiles = None,
    judge: Annotated[
        str, typer.Option("--judge", help="Who decides the identities once more, for all curves: sympy.")
    ] = "",
    as_json: AsJson = False,
    digits: Digits = 0,
) -> None:
    """Decide every claim: for all curves at once, and exactly on the given curves (without --curve: on the example
    curves).
    """
    from exactspline.verification.claims import select
    from exactspline.verification.ledger import tasks

    claims = select(claim or [])
    given, good = loaded(curve or [])
    curves = also_in_their_planes(given) if curve else None
    if judge and curve:
        raise typer.BadParameter("another judge decides for all curves; leave --curve out", param_hint="--judge")
    rows = tracked(_judge(judge)(claims) if judge else tasks(claims, curves), "proving")
    if as_json:
        print_json([row.data() for row in rows])
    else:
        _print_ledger(rows, claims, curves, digits)
    if not good:
        raise typer.Exit(2)
    if not all(row.as_recorded for row in rows):
        raise typer.Exit(1)


def _judge(name: str) -> Any:
    """What gives the calls of another judge."""
    if name != "sympy":
        raise typer.BadParameter(f"no judge is called {name!r}; there is sympy", param_hint="--judge")
    from exactspline.verification import sympy_judge

    return sympy_judge.tasks


def _print_ledger(rows: list[Any], claims: Sequence[Any], curves: list[Any] | None, digits: int) -> None:
    from exactspline.display import console

    out = console.console()
    if curves is None:
        out.print(console.ledger([row for row in rows if not row.curve], "For all curves", digits))
        concrete = [row for row in rows if row.curve]
        if concrete:
            out.print("\n[bold]On the example curves[/bold], exactly (each in full with --curve NAME)")
            out.print(console.summary(concrete))
        differing = [row for row in concrete if not row.as_recorded]
        if differing:
            out.print(console.ledger(differing, "Not as recorded", digits))
    for c in curves or []:
        own = [row for row in rows if row.curve == c.name]
        out.print(console.ledger(own, f"{c.name}: {described(c)}", digits))
        if silent := [claim for claim in claims if not claim.speaks_of(c.dimension, c.polynomial)]:
            out.print(f"{len(silent)} claims say nothing of this curve: {console.reasons(silent, c)}", markup=False)
    if rows:
        out.print("\n" + console.closing(rows), markup=False)
