"""A claim written out as text."""

from __future__ import annotations

from exactspline.display.data import picked
from exactspline.display.evidence import worded
from exactspline.display.ledger import claimed
from exactspline.verification.divisors import divisors
from exactspline.verification.errata import true_relation
from exactspline.verification.kinds.degree import DegreeClaim
from exactspline.verification.kinds.equality import Identity
from exactspline.verification.statement import Statement
from exactspline.verification.vocabulary import Status


def heading(s: Statement) -> str:
    """The first line: the id, the place of the claim in its source, and whether it is as printed."""
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
        "computed": worded(f.computed),
        "factor": worded(f.factor),
        "witness": worded(f.witness),
        "verdict": f.verdict,
        "relation": f.relation,
        "assumptions": list(f.assumptions),
    }
