"""A claim spelled out as text."""

from __future__ import annotations

from exactspline.verification.divisors import divisors
from exactspline.verification.errata import name_of
from exactspline.verification.kinds import Count, DegreeClaim, Identity
from exactspline.verification.statement import Statement
from exactspline.verification.vocabulary import Status


def heading(s: Statement) -> str:
    """The first line: the id, where the claim stands, and whether it is as printed."""
    return f"{s.claim.id}, {s.claim.source}{' (as it must read)' if s.claim.status == Status.MEANT else ''}"


def fields(s: Statement, latex: bool = False) -> list[tuple[str, str]]:
    """Everything about a claim, one field after the other."""
    c, f = s.claim, s.finding
    told = [("statement", s.latex if latex else c.statement)]
    for side in s.sides:
        told += [
            (side.role, side.latex if latex else side.text),
            ("of which", f"{side.name}, {side.source}, degree {side.degrees}"),
        ]
    is_number = isinstance(c, DegreeClaim | Count)
    told += [
        ("claimed", f.claimed if not isinstance(c, Identity) else f"factor {f.claimed}"),
        ("found", _found(s) if not is_number else f.computed),
        ("factor", f.factor if not isinstance(c, DegreeClaim | Identity) else ""),
        ("witness", f.witness),
        ("assumes", c.assumed),
        ("divides by", ", ".join(divisors(c))),
        ("used", ", ".join(f.assumptions)),
        ("printed", f"“{c.words}”{f', {c.place}' if c.place else ''}" if c.words else c.place),
        ("note", c.note),
    ]
    recorded = "as recorded" if s.as_recorded else f"recorded: {c.expected}"
    return [*[(what, text) for what, text in told if text], ("verdict", f"{f.verdict} [{s.reading}], {recorded}")]


def _found(s: Statement) -> str:
    claim, factor = s.claim, s.finding.factor
    if not isinstance(claim, Identity) or not factor:
        return s.finding.computed
    times = "" if factor == "1" else f"{factor} · "
    return f"{name_of(claim, claim.left)} = {times}{name_of(claim, claim.right)}"
