"""The ledger as text: rows, the refuted statements with what is true, counts by section and by curve."""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache

from exactspline.display.numbers import decimals
from exactspline.display.sheet import Sheet
from exactspline.errors import counted
from exactspline.language.kinds import kind_of
from exactspline.papers import Paper, paper
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface
from exactspline.verification.claim import Claim
from exactspline.verification.claims import claims_of
from exactspline.verification.errata import name_of, numbered
from exactspline.verification.kinds import DegreeClaim, Identity, Vanishing
from exactspline.verification.verdict import INAPPLICABLE, PROVED, REFUTED, VACUOUS, VERIFIED, Row
from exactspline.verification.vocabulary import ArgumentKind, Status, Verdict

#: The words of the verdict column, in the order of the tables.
WORDS = tuple(Verdict)
HOLDS = (PROVED, VERIFIED)
#: The last two groups of the summary.
MEANT, OURS = "as it must read", "beyond the paper"


@cache
def _claims(source: Paper) -> dict[str, Claim]:
    return {claim.key: claim for claim in claims_of(source)}


def claim_of(row: Row) -> Claim:
    """The claim of which a row is a line."""
    return _claims(paper(row.paper))[row.key]


def section(claim: Claim) -> str:
    """The section of the paper to which a claim belongs.

    >>> from exactspline.verification.claims import select
    >>> [section(select([i])[0]) for i in ("C4.2b", "T3", "E12", "Fig. 2", "L1")]
    ['§4.2', 'Table 1', 'equations', 'figures', 'beyond the paper']
    """
    if claim.status == Status.OURS:
        return OURS
    if number := re.match(r"C(\d+(?:\.\d+)?)", claim.id):
        return f"§{number[1]}"
    return claim.source_paper.sections.get(claim.id[0], claim.source)


def found(row: Row) -> str:
    """The result in one phrase: an identity as ``left = factor · right``."""
    claim = claim_of(row)
    if row.verdict == INAPPLICABLE:
        return f"{row.computed or 'nothing'}: {row.witness}"
    if row.verdict == VACUOUS:
        return "nothing to decide here"
    if isinstance(claim, Identity) and row.factor and (row.verdict != REFUTED or not row.curve):
        left, right = name_of(claim, claim.left), name_of(claim, claim.right)
        return f"{left} = {right}" if row.factor == "1" else f"{left} = {row.factor} · {right}"
    if isinstance(claim, DegreeClaim):
        computed = "identically zero" if row.computed == "-1" else row.computed
        return computed if row.verdict in HOLDS else f"{computed}, not {row.claimed}"
    if isinstance(claim, Vanishing) and row.verdict in HOLDS:
        return "identically zero"
    return f"{row.computed}: {row.factor}" if row.factor and row.verdict in HOLDS else row.computed


def witness(row: Row, digits: int = 0, *, exact: bool = False) -> str:
    """The place where a row fails, unless `found` says so already."""
    if row.verdict in (VACUOUS, INAPPLICABLE) or row.witness.startswith("the exact quotient is"):
        return ""
    said = re.fullmatch(r"-?\d+, not -?\d+", row.witness)
    return "" if said else decimals(row.witness, digits, exact=exact)


def ledger(
    rows: Iterable[Row],
    title: str = "",
    digits: int = 0,
    *,
    exact: bool = False,
    name: str = "",
    kernel: Mapping[tuple[str, str], str] | None = None,
) -> Sheet:
    """The rows of one curve (or of all curves), one per line; with `kernel`, the opinions of the kernel of Coq."""
    asked = () if kernel is None else ("kernel",)
    columns = ("verdict", "claim", "statement", "found", "witness", *asked)
    made = Sheet(*columns, title=title, name=name, prose=("statement", "found", "witness", *asked), heads=2)
    for row in rows:
        mark = "" if row.as_recorded else f" (recorded: {row.expected})"
        says = () if kernel is None else (kernel.get((row.paper, row.key), ""),)
        made.add_row(row.verdict + mark, row.id, row.statement, found(row), witness(row, digits, exact=exact), *says)
    return made


def by_section(rows: Iterable[Row]) -> Sheet:
    """Counts of the verdicts: of printed statements by section, of corrected ones, and of those beyond the paper."""
    counts: dict[str, Counter[str]] = defaultdict(Counter)
    for row in rows:
        claim = claim_of(row)
        counts[MEANT if claim.status == Status.MEANT else section(claim)][row.verdict] += 1
    words = [w for w in WORDS if any(c[w] for c in counts.values())]
    made = Sheet("section", "statements", *words, numbers=("statements", *words))
    last = [name for name in (MEANT, OURS) if name in counts]
    for name in [*[name for name in counts if name not in last], *last]:
        made.add_row(name, counts[name].total(), *[counts[name][w] or "" for w in words])
    total = sum(counts.values(), Counter())
    made.add_row("all", total.total(), *[total[w] or "" for w in words])
    return made


def by_curve(rows: Sequence[Row]) -> Sheet:
    """Counts of verdicts, curve by curve."""
    counts: dict[str, Counter[str]] = defaultdict(Counter)
    for row in rows:
        counts[row.curve][row.verdict] += 1
        counts[row.curve]["as recorded"] += row.as_recorded
    words = [w for w in WORDS if any(c[w] for c in counts.values())]
    made = Sheet("curve", *words, "as recorded", numbers=words)
    for name, each in counts.items():
        of = sum(each[w] for w in words)
        made.add_row(name, *[each[w] or "" for w in words], f"{each['as recorded']} of {of}")
    return made


@dataclass(frozen=True)
class Failure:
    """An error of the paper as the ledger shows it: its statements that are refuted, and those that hold instead."""

    title: str
    rows: list[Row]
    truth: list[Row]


def refuted(rows: Iterable[Row]) -> list[Failure]:
    """The errors of the papers among the rows for all curves, in the order of the rows."""
    groups: dict[tuple[str, str], list[Row]] = defaultdict(list)
    for row in rows:
        if not row.curve and (error := claim_of(row).error):
            groups[row.paper, error].append(row)
    found = []
    for (source, error), own in groups.items():
        fails = [row for row in own if row.status == Status.PRINTED and row.verdict == REFUTED]
        truth = [row for row in own if row.status == Status.MEANT and row.verdict in HOLDS]
        if fails:
            found.append(Failure(paper(source).errors[error], fails, truth))
    return found


#: Curves of a dimension alone, without anything beside them.
OF_DIMENSION = {2: ArgumentKind.PLANE, 3: ArgumentKind.SPACE}

#: The arguments of claims of these kinds; those of other kinds are curves of that kind.
ARGUMENTS = {
    "curve": "curves",
    "pair": "two space curves",
    "point": "a point and a space curve",
    "plane point": "a point and a plane curve",
    "framed plane": "plane curves with their frames",
    "framed space": "space curves with their frames",
    "surface": "surfaces",
    "planar map": "planar maps",
    "curve on a surface": "curves on surfaces",
    "forms": "quadratic forms",
}


def reasons(claims: Iterable[Claim], curve: Nurbs | NurbsSurface) -> str:
    """The reasons why claims do not apply to a curve or a surface, counted.

    >>> from exactspline.verification.claims import select
    >>> from exactspline.splines.examples import example
    >>> reasons(select(["C4.1c", "T10"]), example("twisted_cubic"))
    '2 of Table 1, 3 of plane curves'
    """
    counts: Counter[str] = Counter()
    own = () if isinstance(curve, NurbsSurface) else (ArgumentKind.CURVE, OF_DIMENSION.get(curve.dimension))
    for claim in claims:
        if claim.curve == ArgumentKind.TABLE:
            counts["of Table 1"] += 1
        elif isinstance(curve, NurbsSurface) and kind_of(claim.curve).made_of_a_surface:
            counts["of other surfaces"] += 1
        elif claim.curve not in own:
            counts[f"of {ARGUMENTS.get(claim.curve, f'{claim.curve} curves')}"] += 1
        else:
            counts[f"of {claim.of} curves"] += 1
    return ", ".join(f"{n} {what}" for what, n in sorted(counts.items()))


def closing(rows: Sequence[Row]) -> str:
    """The last line: how many verdicts there are of each kind and whether any differs from the record."""
    if not rows:
        return "no verdicts"
    counts = Counter(row.verdict for row in rows)
    differ = sum(not row.as_recorded for row in rows)
    parts = ", ".join(f"{counts[w]} {w}" for w in WORDS if counts[w])
    end = f"{differ} DIFFER from the record" if differ else "all as recorded"
    return f"{counted(len(rows), 'verdict')}: {parts}; {end}"


def said(row: Row) -> str:
    """A statement with its number."""
    return numbered(claim_of(row))


def headline(rows: Sequence[Row]) -> str:
    """The answer in a sentence: how many statements of the paper are refuted, on how many rows, how many hold, and what
    is neither.
    """
    printed = [row for row in rows if row.status == Status.PRINTED]
    general = Counter(row.verdict for row in printed if not row.curve)
    lines = sum(row.verdict == REFUTED for row in printed)
    holds = sum(general[verdict] for verdict in HOLDS)
    told = f"{counted(general[REFUTED], 'statement')} of the paper refuted on {counted(lines, 'row')}; {holds} hold"
    rest = [f"{general[v]} {v.lower()}" for v in Verdict if general[v] and v not in (*HOLDS, REFUTED)]
    return "; ".join([told, ", ".join(rest) if rest else "none is undecided"])


def keyed(rows: Iterable[Row]) -> list[tuple[str, Row]]:
    """Every row with a unique key."""
    seen: Counter[str] = Counter()
    told = []
    for row in rows:
        base = f"{row.paper}/{row.key} on {row.curve or 'all curves'}"
        seen[base] += 1
        told.append((base if seen[base] == 1 else f"{base} ({seen[base]})", row))
    return told
