"""The results of `prove`: as data, as tables, as text with the answer first, and as self-contained pages: all rows with
filters, and a referee's report with the claims of a paper, their verdicts, and the software on which the verdicts rely.
"""

from __future__ import annotations

import shlex
import sys
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from hashlib import sha256
from html import escape
from importlib.resources import files

from rich.console import Console

from exactspline.display import console
from exactspline.display.console import explained
from exactspline.display.evidence import curve_of_witness, opinion, values_there, written_out
from exactspline.display.forms import grouped
from exactspline.display.latex_prose import parts
from exactspline.display.ledger import (
    Failure,
    by_curve,
    by_section,
    claimed,
    closing,
    found,
    headline,
    keyed,
    ledger,
    reasons,
    refuted,
    row_data,
    section,
    summary,
    witness,
    words_of,
)
from exactspline.display.numbers import Numbers, described, described_surface
from exactspline.display.page import cells, definitions, page, style, table
from exactspline.display.sheet import Sheet
from exactspline.errors import command_name, counted
from exactspline.papers import Paper
from exactspline.papers.passages import passages
from exactspline.readings.printing import print_text, symbol_text
from exactspline.readings.tree import trace
from exactspline.release import all_releases
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface
from exactspline.verification.claim import Claim
from exactspline.verification.claims import claims_of
from exactspline.verification.evaluation import is_tried_whole
from exactspline.verification.kinds.not_asked import NotAsked
from exactspline.verification.ledger import Row, count_statements
from exactspline.verification.paper_curves import own_curves
from exactspline.verification.statement import numbered
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


def ledger_page(rows: Sequence[Row]) -> str:
    """The rows as an HTML page, with a filter by verdict, by section, by curve and by text.

    >>> from exactspline.verification.claims import select
    >>> from exactspline.verification.ledger import audit
    >>> text = ledger_page(list(audit(select(["C4.1a"]), [])))
    >>> "<title>" in text, "http" in text
    (True, False)
    """
    words = words_of(rows)
    sections = list(dict.fromkeys(section(row.claim) for row in rows))
    curves = list(dict.fromkeys(_curve(row) for row in rows))
    choices = (("verdict", words), ("section", sections), ("curve", curves))
    filters = "".join(_select(name, values) for name, values in choices)
    head = cells(("verdict", "claim", "place", "on", "statement", "found", "witness"), "th")
    script = files("exactspline.display").joinpath("ledger.js").read_text(encoding="utf-8")
    body = (
        f"<h1>{escape(headline(rows))}</h1><p>{escape(closing(rows))}</p>{_unchecked(rows)}"
        f'<form>{filters}<label>text <input name="text" type="search"></label><output></output></form>'
        f"<table><thead><tr>{head}</tr></thead><tbody>{''.join(map(_row, rows))}</tbody></table>"
        f"{_meanings(words)}<script>\n{script}</script>"
    )
    return page("Ledger", body, style("ledger"))


def _unchecked(rows: Sequence[Row]) -> str:
    """The papers whose formulas ran unchecked."""
    papers = dict.fromkeys(row.claim.source_paper for row in rows)
    names = ", ".join(source.name for source in papers if source.trusted)
    return f"<p><b>Formulas that ran unchecked (--trust): {escape(names)}</b></p>" if names else ""


def _curve(row: Row) -> str:
    return row.curve or "all curves"


def _select(name: str, values: Sequence[str]) -> str:
    options = "".join(f"<option>{escape(value)}</option>" for value in values)
    return f'<label>{name} <select name="{name}"><option value="">all</option>{options}</select></label>'


def _row(row: Row) -> str:
    verdict = row.verdict
    data = {"verdict": verdict, "section": section(row.claim), "curve": _curve(row)}
    attributes = "".join(f' data-{name}="{escape(value)}"' for name, value in data.items())
    shown = cells((row.id, row.claim.source, _curve(row), row.statement, found(row), witness(row)))
    return f'<tr{attributes}><td class="{verdict}">{verdict}</td>{shown}</tr>'


def report(claims: Sequence[Claim], rows: Sequence[Row]) -> str:
    """The referee's report on claims, made from the rows of the ledger.

    >>> from exactspline.verification.claims import select
    >>> from exactspline.verification.ledger import audit
    >>> chosen = select(["C4.1a"])
    >>> text = report(chosen, list(audit(chosen)))
    >>> "PROVED" in text, "http" in text, "<script" in text
    (True, False, False)
    """
    sources = list(dict.fromkeys(claim.source_paper for claim in claims))
    title = "; ".join(source.title for source in sources)
    decided = count_statements((row.claim, row.verdict) for row in rows if not row.curve)
    body = (
        f"<h1>{escape(title)}</h1>{''.join(f'<p>{escape(s.reference)}</p>' for s in sources if s.reference)}"
        f"<p>{escape(summary(decided))} {escape(closing(rows))}.</p>"
        f"<h2>What is claimed, and what holds</h2>{''.join(_claim(claim, rows) for claim in claims)}"
        f"{_not_entered(claims, sources)}<h2>Formulas</h2>{''.join(map(_formulas, sources))}"
        f"<h2>What the words mean</h2>{_meanings(words_of(rows))}"
        f"<h2>What the verdicts rely on</h2>{_versions(rows)}{''.join(map(_digests, sources))}"
    )
    return page(f"Report: {title}", body, style("report"))


def _meanings(words: Iterable[str]) -> str:
    """The meanings of some terms, as a list."""
    return definitions((term, escape(said)) for term, said in explained(words))


def _claim(claim: Claim, rows: Iterable[Row]) -> str:
    mine = [row for row in rows if (row.paper, row.key) == (claim.paper, claim.key)]
    general = next((row for row in mine if not row.curve), None)
    verdict = general.verdict if general else ""
    fields = [
        ("claimed", claimed(claim)),
        ("assumes", claim.assumed),
        ("recorded", "" if general is None or not general.differs else f"{claim.expected}: it differs"),
    ]
    if general:
        why = "witness" if general.verdict == REFUTED else "reason"
        fields += [("found", found(general)), (why, witness(general))]
        if (curve := curve_of_witness(claim, general.finding)) is not None:
            parts = "; ".join(f"{what} {numbers}" for what, numbers in written_out(curve).items())
            fields.append(("on the curve", f"{curve.name} of degree {curve.degree}: {parts}"))
        fields.append(("there", "; ".join(values_there(claim, general.finding))))
        fields.append(("rests on", ", ".join(general.finding.assumptions)))
    lines = [("printed", _printed(claim.words)), *[(what, escape(text)) for what, text in fields]]
    listed = definitions((what, shown) for what, shown in lines if shown)
    shown = f'<span class="verdict">{verdict or "on curves"}</span>'
    head = f"<h3>{escape(claim.id)} · {escape(claim.place or claim.source)} · {shown}</h3>"
    return f'<article class="{verdict}">{head}<p>{escape(claim.statement)}</p>{listed}{_on_curves(mine)}</article>'


def _printed(words: str) -> str:
    """The words of the source, with its TeX formulas as typed there."""
    if any(is_formula for is_formula, _ in parts(words)):
        return f"“<code>{escape(words)}</code>”"
    return f"“{escape(words)}”" if words else ""


def _on_curves(rows: Iterable[Row]) -> str:
    """The verdicts curve by curve; curves with the same verdict in one line."""
    lines = grouped(((row.verdict, witness(row)), row.curve) for row in rows if row.curve)
    return table((result, ", ".join(curves), where) for (result, where), curves in lines.items()) if lines else ""


def _formulas(source: Paper) -> str:
    lines = []
    for name, formula in source.formulas.items():
        text = print_text(trace(formula, formula.kind.dimensions[0]))
        shown = f" = {symbol_text(formula.symbol)}" if formula.symbol else ""
        lines.append((name + shown, f"{escape(text)} <small>({escape(formula.source)})</small>"))
    return f"<h3>{escape(source.name)}</h3>{definitions(lines)}"


def _not_entered(claims: Sequence[Claim], sources: Iterable[Paper]) -> str:
    """The part of the paper that the report does not decide: statements not asked, formulas without a claim, passages
    of the text.
    """
    lines = [(f"{each.id} (not asked)", escape(each.statement)) for each in claims if isinstance(each, NotAsked)]
    named = {(claim.paper, name) for claim in claims for name in claim.named}
    for source in sources:
        silent = [name for name in source.formulas if (source.name, name) not in named]
        lines.append(("formulas without a claim", escape(", ".join(silent)) or "none"))
        text = passages(source)
        without = [each for each in text if not (each.claims or each.read)]
        unknown = {key for each in text for key in each.claims} - {claim.key for claim in claims_of(source)}
        missing = [f"claims that do not exist: {', '.join(map(escape, sorted(unknown)))}"] if unknown else []
        read = (
            f"{len(text) - len(without)} of {len(text)} are read" if text else "not entered: there is no reading.toml"
        )
        lines.append(("passages of the text", "; ".join([read, *missing, *[escape(each.place) for each in without]])))
    return f"<h2>What was not entered</h2>{definitions(lines)}"


def _digest_of(rows: Iterable[Row]) -> str:
    """A digest of the sorted lines ``paper/key, curve, verdict``: runs with the same verdicts have the same digest."""
    return sha256("\n".join(sorted(f"{r.paper}/{r.key}, {r.curve}, {r.verdict}" for r in rows)).encode()).hexdigest()


def _versions(rows: Iterable[Row]) -> str:
    lines = [
        ("date", datetime.now(UTC).isoformat(" ", "minutes")),
        ("command", shlex.join([command_name(), *sys.argv[1:]])),
        ("digest of the verdicts", _digest_of(rows)),
        *all_releases().items(),
    ]
    return table(lines)


def _digests(source: Paper) -> str:
    files = "".join(
        f"<tr>{cells([name])}<td><code>{digest}</code></td></tr>" for name, digest in source.digests().items()
    )
    checked = "run unchecked" if source.trusted else "checked before they ran" if not source.package else "built in"
    return f"<h3>{escape(source.name)}: formulas {checked}; SHA-256 of the files</h3><table>{files}</table>"
