"""The ledger for people: what a row says, the refuted statements with what is true, counts by section and by curve."""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Sequence
from typing import Any

from exactspline.display.numbers import decimals
from exactspline.display.sheet import Sheet
from exactspline.papers import find
from exactspline.readings.printing.text import symbol_text
from exactspline.verification.claims import Claim, all_claims
from exactspline.verification.verdict import PROVED, REFUTED, UNDECIDED, VERIFIED, Row
from exactspline.verification.verdict import VACUOUS as VACUOUS_WITNESS

VACUOUS, INAPPLICABLE = "VACUOUS", "INAPPLICABLE"
#: The words of the verdict column, in the order of the tables.
WORDS = (PROVED, VERIFIED, REFUTED, UNDECIDED, VACUOUS, INAPPLICABLE)
HOLDS = (PROVED, VERIFIED)
_AS_MEANT = " (as it must read)"


def word(row: Row) -> str:
    """The verdict in one word: where there is nothing to decide it is not that something was left undecided."""
    return VACUOUS if row.verdict == UNDECIDED and row.witness == VACUOUS_WITNESS else str(row.verdict)


def claim_of(row: Row) -> Claim:
    """The claim of which a row is a line."""
    statement = row.statement.removesuffix(_AS_MEANT)
    return next(c for c in all_claims() if (c.id, c.source, c.statement) == (row.id, row.source, statement))


def is_ours(claim: Claim) -> bool:
    """Whether a statement goes beyond the paper."""
    return claim.id[0] in "LO"


def section(claim: Claim) -> str:
    """The section of the paper to which a claim belongs.

    >>> from exactspline.verification.claims import select
    >>> [section(select([i])[0]) for i in ("C4.2b", "T3", "E12", "Fig. 2", "L1")]
    ['§4.2', 'Table 1', 'equations', 'figures', 'beyond the paper']
    """
    if is_ours(claim):
        return "beyond the paper"
    if number := re.match(r"C(\d+(?:\.\d+)?)", claim.id):
        return f"§{number[1]}"
    return {"T": "Table 1", "E": "equations", "F": "figures"}.get(claim.id[0], claim.id)


def name_of(formula: str) -> str:
    """A formula by its symbol, by its name where it has none."""
    symbol = find(formula).symbol
    return symbol_text(symbol) if symbol else formula


def found(row: Row) -> str:
    """What was found, in one phrase: an identity as ``left = factor · right``."""
    claim = claim_of(row)
    if word(row) in (VACUOUS, INAPPLICABLE):
        return "nothing to decide here"
    if claim.kind == "identity" and row.factor and (row.verdict != REFUTED or not row.curve):
        left, right = name_of(claim.left), name_of(claim.right)
        return f"{left} = {right}" if row.factor == "1" else f"{left} = {row.factor} · {right}"
    if claim.kind == "degree":
        computed = "identically zero" if row.computed == "-1" else row.computed
        return computed if row.verdict in HOLDS else f"{computed}, not {row.claimed}"
    if claim.kind == "vanishing" and row.verdict in HOLDS:
        return "identically zero"
    return row.computed


def witness(row: Row, digits: int = 0, *, exact: bool = False) -> str:
    """Where a row fails, or by which factor it holds, where `found` does not say so already."""
    if word(row) in (VACUOUS, INAPPLICABLE) or row.witness.startswith("the exact quotient is"):
        return ""
    if re.fullmatch(r"-?\d+, not -?\d+|.+ < .+", row.witness):
        return ""
    told = row.witness or ("" if claim_of(row).kind == "identity" else row.factor)
    return decimals(told, digits, exact=exact)


def ledger(rows: Iterable[Row], title: str = "", digits: int = 0, *, exact: bool = False, name: str = "") -> Sheet:
    """The rows of one curve (or of all curves), one a line."""
    columns = ("verdict", "claim", "statement", "found", "witness")
    made = Sheet(*columns, title=title, name=name, prose=("statement", "found", "witness"), heads=2)
    for row in rows:
        mark = "" if row.as_recorded else f" (recorded: {row.expected})"
        made.add_row(word(row) + mark, row.id, row.statement, found(row), witness(row, digits, exact=exact))
    return made


def by_section(rows: Iterable[Row]) -> Sheet:
    """Counts of the verdicts for all curves, section by section: of the paper's statements, and of what they must mean
    or what goes beyond them.
    """
    counts: dict[str, Counter[str]] = defaultdict(Counter)
    for row in rows:
        counts[section(claim_of(row))][word(row)] += 1
    words = [w for w in WORDS if any(c[w] for c in counts.values())]
    made = Sheet("section", "statements", *words, numbers=("statements", *words))
    for name, each in counts.items():
        made.add_row(name, each.total(), *[each[w] or "" for w in words])
    total = sum(counts.values(), Counter())
    made.add_row("all", total.total(), *[total[w] or "" for w in words])
    return made


def by_curve(rows: Sequence[Row]) -> Sheet:
    """Counts of verdicts, curve by curve."""
    counts: dict[str, Counter[str]] = defaultdict(Counter)
    for row in rows:
        counts[row.curve][word(row)] += 1
        counts[row.curve]["as recorded"] += row.as_recorded
    words = [w for w in WORDS if any(c[w] for c in counts.values())]
    made = Sheet("curve", *words, "as recorded", numbers=words)
    for name, each in counts.items():
        of = sum(each[w] for w in words)
        made.add_row(name, *[each[w] or "" for w in words], f"{each['as recorded']} of {of}")
    return made


def refuted(rows: Iterable[Row]) -> list[tuple[Row, list[Row]]]:
    """The refuted statements for all curves, each with the rows that say what is true instead."""
    rows = [row for row in rows if not row.curve]
    fails = [row for row in rows if row.verdict == REFUTED]
    return [(row, [other for other in rows if _corrects(other, row)]) for row in fails]


def _corrects(other: Row, row: Row) -> bool:
    mended, wrong = claim_of(other), claim_of(row)
    related = mended.id == wrong.id and (mended.formula == wrong.formula or wrong.kind != "count")
    return mended.as_meant and related and other.verdict in HOLDS


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


def closing(rows: Sequence[Row]) -> str:
    """The last line: how many verdicts there are of each kind and whether any differs from the record."""
    counts = Counter(map(word, rows))
    differ = sum(not row.as_recorded for row in rows)
    parts = ", ".join(f"{counts[w]} {w}" for w in WORDS if counts[w])
    plural = "" if len(rows) == 1 else "s"
    end = f"{differ} DIFFER from the record" if differ else "all as recorded"
    return f"{len(rows)} verdict{plural}: {parts}; {end}"


def said(row: Row) -> str:
    """A statement with the number that it speaks of."""
    statement = row.statement.removesuffix(_AS_MEANT)
    return f"{statement}: {found(row)}" if claim_of(row).kind in ("degree", "count") else statement


def headline(rows: Sequence[Row]) -> str:
    """The answer in a sentence: how many statements of the paper are refuted, on how many rows, and how many hold."""
    general = [row for row in rows if not row.curve]
    wrong = [row for row in general if row.verdict == REFUTED]
    lines = sum(row.verdict == REFUTED for row in rows)
    open_ = sum(row.verdict not in (*HOLDS, REFUTED) for row in general)
    holds = sum(row.verdict in HOLDS for row in general)
    told = f"{_count(len(wrong), 'statement')} of the paper refuted on {_count(lines, 'row')}; {holds} statements hold"
    return told + (f"; {open_} undecided" if open_ else "; none is undecided")


def _count(n: int, what: str) -> str:
    return f"{n} {what}{'' if n == 1 else 's'}"


def keyed(rows: Iterable[Row]) -> list[tuple[str, str, Row]]:
    """Every row with a key of its own and its verdict in one word."""
    seen: Counter[str] = Counter()
    told = []
    for row in rows:
        base = f"{row.id}@{row.curve or 'all curves'}{row.reading.removeprefix('spline') if row.curve else ''}"
        seen[base] += 1
        told.append((base if seen[base] == 1 else f"{base}#{seen[base]}", word(row), row))
    return told
