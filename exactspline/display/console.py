"""What people see: aligned tables, the ledger, errors. Programs get JSON instead."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Iterable
from io import StringIO
from typing import Any

from gmpy2 import mpq
from rich.console import Console
from rich.table import Table
from rich.text import Text

from exactspline.verification.claim import Claim
from exactspline.verification.statement import Statement
from exactspline.verification.verdict import PROVED, REFUTED, UNDECIDED, VACUOUS, VERIFIED, Row

COLOURS = {PROVED: "bold green", VERIFIED: "green", REFUTED: "bold magenta", UNDECIDED: "yellow"}
_NUMBER = re.compile(r"-?\d+/\d+|-?\d{25,}")
#: Exact numbers longer than this are cut in the middle for people.
LONGEST = 40


def console() -> Console:
    """The console for results: as wide as the terminal; what goes into a file or a pipe has room."""
    made = Console(highlight=False, emoji=False)
    return made if made.is_terminal or "COLUMNS" in os.environ else Console(highlight=False, emoji=False, width=160)


class Columns(Table):
    """A table without lines whose cells are taken literally."""

    def add_row(self, *cells: Any, **options: Any) -> None:
        """A row; a text keeps its brackets, and a number is not broken."""
        for column, cell in zip(self.columns, cells, strict=False):
            if column.justify == "right":
                whole = str(cell) if len(str(cell)) <= LONGEST // 3 else ""
                longest = max((*str(column.header).split(), *str(cell).split(), whole), key=len)
                column.min_width = max(column.min_width or 0, min(len(longest), LONGEST))
        super().add_row(*[cell if isinstance(cell, Text) else Text(cell) for cell in cells], **options)


def table(*columns: str, title: str = "", right: Iterable[str] = ()) -> Columns:
    """An empty table, the named columns right-aligned, the first one never broken."""
    made = Columns(
        title=Text(title, style="bold") if title else None,
        title_justify="left",
        box=None,
        pad_edge=False,
        header_style="bold",
    )
    for i, column in enumerate(columns):
        made.add_column(column, justify="right" if column in right else "left", overflow="fold", no_wrap=i == 0)
    return made


def decimals(text: str, digits: int = 0) -> str:
    """Exact numbers in a text shortened for people, with so many decimal digits beside them when asked for.

    >>> decimals("at the parameter 1/3", 5)
    'at the parameter 1/3 ≈ 0.33333'
    """

    def shown(match: re.Match[str]) -> str:
        exact = match[0]
        short = exact if len(exact) <= LONGEST else f"{exact[:18]}…{exact[-18:]}"
        return f"{short} ≈ {decimal(mpq(exact), digits)}" if digits else short

    return _NUMBER.sub(shown, text)


def decimal(value: mpq, digits: int) -> str:
    """An exact number rounded to so many significant digits.

    >>> decimal(mpq(1, 3), 5)
    '0.33333'
    """
    from mpmath import mp

    with mp.workdps(digits + 5):
        return str(mp.nstr(mp.mpf(int(value.numerator)) / int(value.denominator), digits))


def decimal_milliseconds(seconds: float) -> str:
    """A time in milliseconds, to a tenth.

    >>> decimal_milliseconds(0.01234)
    '12.3'
    """
    return f"{1000 * seconds:.1f}"


def ledger(rows: list[Row], title: str, digits: int = 0) -> Columns:
    """The rows of one curve (or of all curves), one a line."""
    made = table("verdict", "claim", "statement", "claimed", "computed", "factor or witness", title=title)
    for row in rows:
        mark = "" if row.as_recorded else f" (recorded: {row.expected})"
        computed = row.computed + (f" [{row.reading}]" if row.reading != "spline" else "")
        remark = row.factor if row.factor and not row.witness else row.witness
        made.add_row(
            Text(row.verdict + mark, style=COLOURS[row.verdict]),
            row.id,
            row.statement,
            row.claimed,
            computed,
            decimals(remark, digits),
        )
    return made


def summary(rows: list[Row]) -> Columns:
    """Counts of verdicts, curve by curve."""
    made = table(
        "curve",
        "verified",
        "vacuous",
        "refuted",
        "undecided",
        "as recorded",
        right=("verified", "vacuous", "refuted", "undecided"),
    )
    curves = dict.fromkeys(row.curve for row in rows)
    for curve in curves:
        own = [row for row in rows if row.curve == curve]
        counts = Counter(row.verdict for row in own)
        vacuous = sum(row.witness == VACUOUS for row in own)
        recorded = sum(row.as_recorded for row in own)
        made.add_row(
            curve,
            str(counts[VERIFIED]),
            str(vacuous),
            str(counts[REFUTED]),
            str(counts[UNDECIDED] - vacuous),
            f"{recorded} of {len(own)}",
        )
    return made


def reasons(claims: Iterable[Claim], curve: Any) -> str:
    """Why claims say nothing of a curve, counted.

    >>> from exactspline.verification.claims import select
    >>> from exactspline.splines.examples import example
    >>> reasons(select(["C4.1c", "T1"]), example("twisted_cubic"))
    '1 of Table 1, 3 of plane curves'
    """
    counts: Counter[str] = Counter()
    for claim in claims:
        if claim.curve == "table":
            counts["of Table 1"] += 1
        elif claim.curve not in ("curve", {2: "plane", 3: "space"}.get(curve.dimension, "")):
            counts[f"of {claim.curve} curves"] += 1
        else:
            counts[f"of {claim.of} curves"] += 1
    return ", ".join(f"{n} {what}" for what, n in sorted(counts.items()))


def erratum(entry: Any) -> Text:
    """One error of the paper as a paragraph."""
    text = Text.assemble(
        (f"{entry.id}  {entry.where}", "bold"), "\n  printed  ", entry.printed, "\n  found    ", decimals(entry.found)
    )
    for line in entry.truth:
        text.append(f"\n  true     {line}")
    if entry.why:
        text.append(f"\n  why      {entry.why}")
    for i, line in enumerate(entry.check):
        text.append(f"\n  {'check' if not i else '     '}    {line}")
    return text.append("\n")


def spelled_out(s: Statement, latex: bool = False) -> Columns:
    """A claim with its sides, factor, degrees and verdict, one thing a line."""
    c, f = s.claim, s.finding
    made = table("what", "is", title=f"{c.id}  {c.source}{'  (as it must read)' if c.status == 'meant' else ''}")
    made.show_header = False
    lines = [("statement", s.latex if latex else c.statement)]
    for side in s.sides:
        lines += [
            (side.role, side.latex if latex else side.text),
            ("", f"{side.name}, {side.source}, degree {side.degrees}"),
        ]
    lines += [
        ("claimed", f.claimed if c.kind in ("degree", "count") else ""),
        ("factor", f.factor if c.kind != "degree" else ""),
        ("computed", f.computed),
        ("witness", f.witness),
    ]
    lines += [("assumes", c.assumed), ("used", ", ".join(f.assumptions)), ("words", c.words), ("note", c.note)]
    for what, text in lines:
        if text:
            made.add_row(what, text)
    recorded = "as recorded" if s.as_recorded else f"recorded: {c.expected}"
    made.add_row("verdict", Text.assemble((f.verdict, COLOURS[f.verdict]), f" [{s.reading}], {recorded}"))
    made.add_row("", "")
    return made


def plain(made: Any, width: int = 160) -> str:
    """A table as text, for where there is no terminal."""
    out = Console(highlight=False, width=width, color_system=None, file=StringIO(), force_jupyter=False)
    out.print(made)
    return "\n".join(line.rstrip() for line in out.file.getvalue().splitlines())  # type: ignore[attr-defined]


def closing(rows: list[Row]) -> str:
    """The last line: how many verdicts there are of each kind and whether any differs from the record."""
    counts = Counter(row.verdict for row in rows)
    differ = sum(not row.as_recorded for row in rows)
    parts = ", ".join(f"{counts[v]} {v}" for v in COLOURS if counts[v])
    return f"{len(rows)} verdicts: {parts}; {'all as recorded' if not differ else f'{differ} DIFFER from the record'}"


def show_error(error: Any) -> None:
    """One line on standard error."""
    Console(stderr=True, highlight=False, emoji=False, soft_wrap=True).print(f"error: {error}", markup=False)
