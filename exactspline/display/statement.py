"""A claim spelled out as text, and claims found by their place."""

from __future__ import annotations

from collections.abc import Iterable

from exactspline.errors import ClaimError, nearest
from exactspline.verification.claim import Claim
from exactspline.verification.claims import all_claims, matches
from exactspline.verification.divisors import divisors
from exactspline.verification.errata import name_of
from exactspline.verification.kinds import Count, DegreeClaim, Identity
from exactspline.verification.statement import Statement
from exactspline.verification.vocabulary import Status

#: A shorter text is not searched for in statements.
SHORTEST = 4


def located(wanted: str, claims: Iterable[Claim] | None = None) -> tuple[Claim, ...]:
    """The claims with this id or one that begins with it, those at this place of the paper, or those that mention it.

    >>> [claim.id for claim in located("eq. (8)")][:2], located("C4.1c")[0].id
    (['E8', 'C4.1a'], 'C4.1c')
    >>> located("rectifying developable")[0].id
    'C5.4a'

    They are sought among `claims`, by default among those of the default papers. Raises
    `ClaimError` with the nearest ids.
    """
    known = all_claims() if claims is None else tuple(claims)
    chosen = tuple(c for c in known if c.key == wanted or matches(c.id, wanted))
    chosen = chosen or tuple(c for c in known if _stands(c.source, wanted) or _stands(c.place, wanted))
    if len(wanted) >= SHORTEST:
        chosen = chosen or tuple(c for c in known if wanted.lower() in c.statement.lower())
    if not chosen:
        ids = dict.fromkeys(claim.id for claim in known)
        raise ClaimError(f"no claim has the id {wanted!r}", remedy=nearest(wanted, ids, listed_by="exactspline show"))
    return chosen


def _stands(source: str, wanted: str) -> bool:
    """Whether a place is the wanted one: the equation with this number, a remark, a figure, a section."""
    a, b = (" ".join(text.lower().replace("equation", "eq.").split()) for text in (source, wanted))
    if b.startswith("(") and b.endswith(")"):
        return b in a
    position = a.find(b)
    after = a[position + len(b) :]
    return len(b) > 1 and position >= 0 and not (b[-1].isdigit() and after[:1].isdigit())


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
