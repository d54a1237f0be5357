"""The ledger (the verdicts on all claims) as text: its rows, the refuted statements with their corrections, and counts
by section and by curve.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from exactspline.display.evidence import opinion, worded
from exactspline.display.forms import grouped, picked
from exactspline.display.numbers import EXACT, Numbers
from exactspline.display.sheet import Sheet
from exactspline.errors import counted
from exactspline.language.kinds import kind_of
from exactspline.papers import paper_named
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface
from exactspline.verification.claim import Claim
from exactspline.verification.divisors import divisors
from exactspline.verification.evidence import DegreeHere, ExactQuotient, WrongDegree
from exactspline.verification.kinds.degree import DegreeClaim
from exactspline.verification.kinds.equality import Identity, Vanishing
from exactspline.verification.ledger import Counts, Row, count_statements, error_of
from exactspline.verification.statement import Statement, claimed_relation, true_relation
from exactspline.verification.verdict import INAPPLICABLE, PROVED, REFUTED, VACUOUS, VERIFIED, Finding
from exactspline.verification.vocabulary import ArgumentKind, Status, Verdict

#: The words of the verdict column, in the order of the tables.
WORDS = tuple(Verdict)
HOLDS = (PROVED, VERIFIED)
#: The last two groups of the summary.
MEANT, OURS = "corrected statements", "our own statements"


def words_of(rows: Iterable[Row]) -> list[str]:
    """The verdicts of these rows, in the order of the tables.

    >>> words_of([])
    []
    """
    present = {row.verdict for row in rows}
    return [each for each in WORDS if each in present]


def section(claim: Claim) -> str:
    """The section of the paper to which a claim belongs.

    >>> from exactspline.verification.claims import select
    >>> [section(select([i])[0]) for i in ("C4.2b", "T3", "E12", "Fig. 2", "L1")]
    ['§4.2', 'Table 1', 'equations', 'figures', 'our own statements']
    """
    return OURS if claim.status == Status.OURS else claim.section or claim.source


def claimed(claim: Claim) -> str:
    """The value that a claim states, in the same form as `found`: an identity as ``left = factor · right``.

    >>> from exactspline.verification.claims import select
    >>> [claimed(claim) for claim in select(["C4.1a"])]
    ['f1 = w · f2', 'f0 = w⁻³ · f2']
    """
    return worded(claimed_relation(claim)) if isinstance(claim, Identity) else claim.claims


def found(row: Row, numbers: Numbers = EXACT) -> str:
    """The result in one phrase; an identity as ``left = factor · right``."""
    computed = worded(row.computed, numbers)
    if row.verdict == INAPPLICABLE:
        return f"{computed or 'nothing'}: {worded(row.witness, numbers)}"
    if row.verdict == VACUOUS:
        return "nothing to decide here"
    relation = true_relation(row.claim, row.finding)
    if relation and (row.verdict != REFUTED or not row.curve):
        return worded(relation, numbers)
    if isinstance(row.claim, DegreeClaim):
        none = isinstance(row.computed, DegreeHere) and (row.computed.degree or 0) < 0
        degree = "identically zero" if none else computed
        return degree if row.verdict in HOLDS or not degree else f"{degree}, not {row.claimed}"
    if isinstance(row.claim, Vanishing) and row.verdict in HOLDS:
        return "identically zero"
    return f"{computed}: {worded(row.factor, numbers)}" if row.factor and row.verdict in HOLDS else computed


def witness(row: Row, numbers: Numbers = EXACT) -> str:
    """The place where a row fails; empty if `found` names this place already."""
    if row.verdict in (VACUOUS, INAPPLICABLE) or isinstance(row.witness, ExactQuotient):
        return ""
    said = isinstance(row.witness, WrongDegree) and row.witness.at is None
    return "" if said else worded(row.witness, numbers)


def _recorded(row: Row) -> str:
    """The recorded verdicts."""
    return " or ".join(row.expected)


def row_data(row: Row) -> dict[str, object]:
    """A row as data.

    >>> from exactspline.verification.claims import select
    >>> from exactspline.verification.ledger import decide
    >>> data = row_data(decide(select(["C4.1a"])[0]))
    >>> [str(data[name]) for name in ("verdict", "claimed", "computed", "witness", "expected")]
    ['PROVED', 'w', 'w', '', 'PROVED']
    """
    claim, finding = row.claim, row.finding
    beside = f", {worded(row.beside)}" if row.beside else ""
    return picked(claim, "id", "key", "paper", "status", "kind", "source") | {
        "statement": row.statement,
        "assumes": claim.assumed,
        "assumptions": list(finding.assumptions),
        "reading": row.reading + beside,
        "curve": row.curve,
        "relation": finding.relation,
        "claimed": row.claimed,
        **_in_words(finding),
        "reason": finding.reason or "",
        "expected": _recorded(row),
        "seconds": row.seconds,
    }


def _in_words(finding: Finding) -> dict[str, str]:
    """What was found, as data."""
    found = {name: worded(getattr(finding, name)) for name in ("computed", "factor", "witness")}
    return found | {"verdict": finding.verdict}


def ledger(rows: Iterable[Row], title: str = "", numbers: Numbers = EXACT, *, name: str = "", judge: str = "") -> Sheet:
    """The rows of one curve (or of all curves), one per line, with the results of a second verifier `judge`."""
    columns = ("verdict", "claim", "statement", "found", "witness", *((judge,) if judge else ()))
    cells = []
    for row in rows:
        mark = "" if row.as_recorded else f" (recorded: {_recorded(row)})"
        says = (opinion(row.second),) if judge else ()
        cells.append((row.verdict + mark, row.id, row.statement, found(row), witness(row, numbers), *says))
    return Sheet(*columns, rows=cells, title=title, name=name, prose=columns[2:], heads=2)


def by_section(rows: Sequence[Row]) -> Sheet:
    """Counts of the verdicts: on printed statements by section, on corrected statements, and on our own."""
    counts: dict[str, Counter[str]] = defaultdict(Counter)
    for row in rows:
        claim = row.claim
        counts[MEANT if claim.status == Status.MEANT else section(claim)][row.verdict] += 1
    words = words_of(rows)
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
    words = words_of(rows)
    made = Sheet("curve", *words, "as recorded", numbers=words)
    for name, each in counts.items():
        of = sum(each[w] for w in words)
        made.add_row(name, *[each[w] or "" for w in words], f"{each['as recorded']} of {of}")
    return made


@dataclass(frozen=True)
class Failure:
    """An error of the paper as the ledger shows it: the refuted statements, and the statements that hold instead."""

    title: str
    rows: list[Row]
    truth: list[Row]


def refuted(rows: Iterable[Row]) -> list[Failure]:
    """The errors of the papers among the rows for all curves, in the order of the rows."""
    failures = []
    groups = grouped(((row.paper, error_of(row.claim)), row) for row in rows if not row.curve)
    for (source, error), group in groups.items():
        fails = [row for row in group if row.status == Status.PRINTED and row.verdict == REFUTED]
        truth = [row for row in group if row.status == Status.MEANT and row.verdict in HOLDS]
        if fails:
            title = paper_named(source).errors.get(error, fails[0].claim.statement)
            failures.append(Failure(title, fails, truth))
    return failures


#: The dimensions of claims about curves alone, without other arguments.
OF_DIMENSION = {2: ArgumentKind.PLANE, 3: ArgumentKind.SPACE}

#: The arguments of claims of these kinds; for other kinds, curves of that kind.
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
    >>> from exactspline.interchange.examples import example
    >>> reasons(select(["C4.1c", "T10"]), example("twisted_cubic"))
    '3 of Table 1, 6 of plane curves, 1 of rational curves'
    """
    counts: Counter[str] = Counter()
    own_kinds = () if isinstance(curve, NurbsSurface) else (ArgumentKind.CURVE, OF_DIMENSION.get(curve.dimension))
    for claim in claims:
        if claim.curve == ArgumentKind.TABLE:
            counts["of Table 1"] += 1
        elif isinstance(curve, NurbsSurface) and kind_of(claim.curve).made_of_a_surface:
            counts["of other surfaces"] += 1
        elif claim.curve not in own_kinds:
            counts[f"of {ARGUMENTS.get(claim.curve, f'{claim.curve} curves')}"] += 1
        else:
            counts[f"of {claim.of} curves"] += 1
    return ", ".join(f"{n} {what}" for what, n in sorted(counts.items()))


def closing(rows: Sequence[Row], judge: str = "") -> str:
    """The last line: the number of rows of each verdict, for all curves and on single curves, the results of a second
    verifier, and the numbers of rows that differ from the record or were too costly to decide.
    """
    if not rows:
        return "no rows"
    differ, beyond = sum(row.differs for row in rows), sum(row.out_of_reach for row in rows)
    unasked = sum(row.refused for row in rows)
    others = "all others as recorded" if beyond or unasked else "all as recorded"
    end = f"{differ} DIFFER from the record" if differ else others
    end = f"{beyond} too costly to decide; {end}" if beyond else end
    end = f'{unasked} could not be asked (--rows --verdict "not asked" says why); {end}' if unasked else end
    if judge:
        decided = Counter(row.second.verdict for row in rows if row.second)
        end = f"{judge}: {', '.join(f'{decided[w]} {w}' for w in (PROVED, REFUTED) if decided[w]) or 'none'}; {end}"
    general, single = [row for row in rows if not row.curve], [row for row in rows if row.curve]
    papers = list(dict.fromkeys(row.paper for row in rows))
    all_rows = counted(len(rows), "row") + f" of {' and '.join(papers)}" * (len(papers) == 2)
    if not general or not single:
        return f"{all_rows}: {_verdicts(rows)}; {end}"
    parts = (
        f"{len(general)} for all curves ({_verdicts(general)}), {len(single)} on single curves ({_verdicts(single)})"
    )
    return f"{all_rows}: {parts}; {end}"


def _verdicts(rows: Iterable[Row]) -> str:
    verdicts = Counter(row.verdict for row in rows)
    return ", ".join(f"{verdicts[w]} {w}" for w in WORDS if verdicts[w])


def headline(rows: Sequence[Row]) -> str:
    """The answer for all curves in a sentence: the numbers of statements of the paper that are refuted (with the
    numbers of errors and of rows), that hold, and that are undecided, and the number of our own statements that are
    refuted.
    """
    general = [row for row in rows if not row.curve]
    printed = count_statements((row.claim, row.verdict) for row in general)[Status.PRINTED]
    lines = sum(row.verdict == REFUTED for row in rows if row.status == Status.PRINTED)
    refuted = f"{counted(printed.refuted, 'statement')} of the paper refuted"
    refutations = f"{refuted} ({counted(printed.errors, 'error')}, {counted(lines, 'row')}); {printed.hold} hold"
    other = Counter(row.verdict for row in general if row.status == Status.PRINTED)
    rest = [f"{other[v]} {v.lower()}" for v in Verdict if other[v] and v not in (*HOLDS, REFUTED)]
    own = sum(row.verdict == REFUTED for row in general if row.status == Status.OURS)
    fail = [f"{counted(own, 'conjecture')} not in the paper {'fails' if own == 1 else 'fail'}"] * (own > 0)
    return "; ".join([refutations, ", ".join(rest) if rest else "none is undecided for all curves", *fail])


def summary(found: Mapping[Status, Counts]) -> str:
    """The counts in a sentence: of the printed, of the corrected and of our own statements.

    >>> from exactspline.verification.claims import select
    >>> from exactspline.verification.ledger import recorded_counts
    >>> summary(recorded_counts(select(["C4.2b"])))
    '2 statements of the paper: 1 holds, 1 is refuted (1 error); 1 corrected statement: 1 holds.'
    """
    said = []
    for status, each in found.items():
        if not each.statements:
            continue
        verdicts = [f"{each.hold} {'holds' if each.hold == 1 else 'hold'}"] if each.hold else []
        if each.refuted:
            errors = f" ({counted(each.errors, 'error')})" if status == Status.PRINTED else ""
            verdicts.append(f"{each.refuted} {'is' if each.refuted == 1 else 'are'} refuted{errors}")
        if each.neither:
            verdicts.append(f"{each.neither} neither")
        said.append(f"{_of_status(status, each.statements)}: {', '.join(verdicts)}")
    return f"{'; '.join(said) or 'nothing decided for all curves'}."


def _of_status(status: Status, number: int) -> str:
    """A number of statements of a status, in words."""
    if status == Status.PRINTED:
        return f"{counted(number, 'statement')} of the paper"
    kind = "our own statement" if status == Status.OURS else "corrected statement"
    return counted(number, kind)


def keyed(rows: Iterable[Row]) -> list[tuple[str, Row]]:
    """Every row with a unique key."""
    seen: Counter[str] = Counter()
    keyed_rows = []
    for row in rows:
        base = f"{row.paper}/{row.key} on {row.curve or 'all curves'}"
        seen[base] += 1
        keyed_rows.append((base if seen[base] == 1 else f"{base} ({seen[base]})", row))
    return keyed_rows


# ---- a claim written out


def heading(s: Statement) -> str:
    """The first line: the id, the place of the claim in its source, and whether it is a corrected statement."""
    return f"{s.claim.id}, {s.claim.source}{' (corrected)' if s.claim.status == Status.MEANT else ''}"


def fields(s: Statement) -> list[tuple[str, str]]:
    """Everything about a claim, one field after the other."""
    c, f = s.claim, s.finding
    rows = [("statement", c.statement)]
    for side in s.sides:
        rows += [(side.role, side.text), ("of which", f"{side.name}, {side.source}, degree {side.degrees}")]
    rows += [
        ("where", "; ".join(each.text for each in s.defined)),
        ("claimed", claimed(c)),
        ("found", worded(true_relation(c, f) or f.computed)),
        ("factor", worded(f.factor) if not isinstance(c, DegreeClaim | Identity) else ""),
        ("witness", worded(f.witness)),
        ("assumes", c.assumed),
        ("divides by", ", ".join(divisors(c))),
        ("used", ", ".join(f.assumptions)),
        ("printed", f"“{c.words}”{f', {c.place}' if c.place else ''}" if c.words else c.place),
        ("note", c.note),
    ]
    recorded = "as recorded" if s.as_recorded else f"recorded: {c.expected}"
    return [*[(what, text) for what, text in rows if text], ("verdict", f"{f.verdict} [{s.reading}], {recorded}")]


def statement_data(s: Statement) -> dict[str, object]:
    """The statement as data.

    >>> from exactspline.verification.statement import statements
    >>> data = statement_data(next(statements("C4.1a")))
    >>> data["latex"], data["factor"], data["divides_by"]
    ('f_1 = w\\\\,f_2', 'w', [])
    """
    c, f = s.claim, s.finding
    head = picked(c, "id", "source", "kind", "statement", "key", "paper", "status", "words", "place", "error")
    return head | {
        "latex": s.latex,
        "sides": [vars(side) for side in s.sides],
        "defined": [vars(each) for each in s.defined],
        "assumes": c.assumed,
        "divides_by": list(divisors(c)),
        "reading": s.reading,
        "note": c.note,
        "expected": c.expected,
        "claimed": c.claims,
        **_in_words(f),
        "relation": f.relation,
        "assumptions": list(f.assumptions),
    }
