"""The results of `prove`: as data, as tables, and as text with the answer first."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from rich.console import Console

from exactspline.display import console
from exactspline.display.described import described, described_surface
from exactspline.display.evidence import opinion
from exactspline.display.ledger import (
    Failure,
    by_curve,
    by_section,
    closing,
    found,
    headline,
    keyed,
    ledger,
    reasons,
    refuted,
    row_data,
    witness,
    words_of,
)
from exactspline.display.numbers import Numbers
from exactspline.display.sheet import Sheet
from exactspline.errors import command_name, counted
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface
from exactspline.verification.claim import Claim
from exactspline.verification.errata import numbered
from exactspline.verification.evaluation import is_tried_whole
from exactspline.verification.ledger import Row
from exactspline.verification.paper_curves import own_curves
from exactspline.verification.verdict import REFUTED


@dataclass
class Run:
    """The rows that a call of `prove` decided, as data, as tables and as text."""

    rows: list[Row]
    claims: Sequence[Claim]
    curves: Sequence[Nurbs | NurbsSurface] | None
    numbers: Numbers
    #: The name of the second verifier, if one was asked.
    judge: str = ""
    #: How many rows are those of earlier runs.
    remembered: int = 0

    def data(self) -> list[dict[str, object]]:
        """Every row, with a unique key, and with the result of the second verifier if one was asked."""
        return [
            row_data(row)
            | {"key": key, "claim": row.key, "as_recorded": row.as_recorded}
            | ({self.judge: opinion(row.second)} if self.judge else {})
            for key, row in keyed(self.rows)
        ]

    def sheets(self) -> list[Sheet]:
        """The ledger, curve by curve."""
        shown = []
        for name in dict.fromkeys(row.curve for row in self.rows):
            own = [row for row in self.rows if row.curve == name]
            title = name or "For all curves"
            judge = "" if name else self.judge
            shown.append(ledger(own, title, self.numbers, name=name or "all curves", judge=judge))
        return shown

    def print(self, *, listed: bool, everything: bool, quiet: bool) -> None:
        """Print the answer first, and the rows if they are asked for."""
        shown = console.console()
        if self.curves is not None:
            self._on_curves(shown, listed)
        elif listed:
            self._listed(shown, everything)
        else:
            self._summary(shown)
        shown.print()
        console.lines(shown, closing(self.rows, self.judge))
        if not quiet:
            if self.remembered:
                earlier = f"{self.remembered} rows are from earlier runs with the same formulas, curves and code"
                console.lines(shown, f"{earlier}; --fresh decides everything anew.")
            if not listed:
                called = command_name()
                commands = f"{called} prove --rows prints every row; {called} errata the errors, each with its witness"
                console.lines(shown, f"{commands} and a check; {called} show CLAIM one claim.")
            counted = [] if listed or self.curves is not None else ["statement", "error", "row"]
            console.legend(shown, [*words_of(self.rows), *counted])

    def _summary(self, shown: Console) -> None:
        general = [row for row in self.rows if not row.curve]
        console.lines(shown, headline(self.rows), style="bold")
        shown.print()
        shown.print(by_section(general))
        fails = refuted(general)
        if fails:
            shown.print("\nRefuted, and what is true", style="bold")
        for failure in fails:
            self._failure(shown, failure)
        self._not_as_recorded(shown)

    def _failure(self, shown: Console, failure: Failure) -> None:
        ids = ", ".join(dict.fromkeys(row.id for row in failure.rows))
        console.lines(shown, f"{ids}: {failure.title}", style="bold magenta")
        for row in failure.rows:
            console.lines(shown, f"claimed: {numbered(row.claim)} ({row.claim.source})", indent=4, first=2)
            console.lines(shown, f"found: {found(row)}", indent=4, first=2)
            if example := witness(row, self.numbers):
                console.lines(shown, f"witness: {example}", indent=4, first=2)
        for row in failure.truth:
            console.lines(shown, f"true: {numbered(row.claim)}", indent=4, first=2)

    def _listed(self, shown: Console, everything: bool) -> None:
        sheets = self.sheets()
        console.below_each_other(shown, sheets if everything else [s for s in sheets if s.name == "all curves"])
        concrete = [row for row in self.rows if row.curve]
        if concrete and not everything:
            made = by_curve(concrete)
            of = "its own" if any(own_curves(claim.source_paper) for claim in self.claims) else "the example"
            made.title = f"On {of} curves, exactly (--curve CURVE prints one in full, --rows all of them)"
            shown.print()
            shown.print(made)
            self._not_as_recorded(shown)

    def _not_as_recorded(self, shown: Console) -> None:
        differing = [row for row in self.rows if not (row.as_recorded or row.refused)]
        once: dict[tuple[str, str], Row] = {}
        for row in sorted(differing, key=lambda row: not row.curve):  # rows on one curve say where a claim fails
            once.setdefault((row.paper, row.key), row)
        if once:
            shown.print()
            more = f" (once per claim; {counted(len(differing), 'row')} with --rows)" * (len(differing) > len(once))
            shown.print(ledger([*once.values()], f"Not as recorded{more}", self.numbers))

    def _on_curves(self, shown: Console, listed: bool) -> None:
        for i, c in enumerate(self.curves or []):
            if i:
                shown.print()
            on_surface = not isinstance(c, Nurbs)
            title = f"{c.name}: {described(c) if isinstance(c, Nurbs) else described_surface(c)}"
            own = [row for row in self.rows if row.curve == c.name]
            if own and not isinstance(c, Nurbs) and not is_tried_whole(c):
                title += "; tried on the first patch"
            if not own:
                console.lines(shown, title)
            elif listed:
                shown.print(ledger(own, title, self.numbers))
            else:
                made = by_section(own)
                made.title = title
                shown.print(made)
                wrong = [row for row in own if row.verdict == REFUTED or not row.as_recorded]
                if wrong:
                    shown.print()
                    shown.print(ledger(wrong, "Refuted on this curve", self.numbers))
            speaks = [claim.applies_to(c.dimension, c.polynomial, surface=on_surface) for claim in self.claims]
            if silent := [claim for claim, spoken in zip(self.claims, speaks, strict=True) if not spoken]:
                who = "1 claim does" if len(silent) == 1 else f"{len(silent)} claims do"
                console.lines(
                    shown, f"{who} not apply to this {'surface' if on_surface else 'curve'}: {reasons(silent, c)}"
                )
