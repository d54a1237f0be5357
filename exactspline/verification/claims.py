"""The claims of the paper as data: what is claimed of which formulas, where it stands, and the verdict that is on
record.

Each section is a TOML file beside this one. An entry names formulas of `exactspline.papers`, never transcribes one.
Several entries may share the id of the paper's claim; ``as_meant`` marks what the paper must have meant where its
wording fails.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, fields
from functools import cache

from exactspline.errors import ClaimError
from exactspline.language.kinds import DIMENSIONS
from exactspline.language.services import Displayed
from exactspline.papers import find, papers

KINDS = (
    "degree",
    "identity",
    "vanishing",
    "zero set",
    "coefficients",
    "count",
    "square class",
    "same surface",
    "existence",
    "iso-curve",
)
VERDICTS = ("PROVED", "VERIFIED", "REFUTED", "UNDECIDED")


@dataclass(frozen=True)
class Claim(Displayed):
    """One checkable statement.

    ``curve`` is what it speaks of, as of a `Formula`: ``curve`` (any dimension), ``plane``, ``space``, ``table``, a
    ``pair`` of curves, a ``point`` and a curve. ``polynomial`` claims speak of polynomial curves, ``rational`` ones of
    rational curves, the others of both. What else is set depends on the kind:

    - ``degree``: ``formula``, ``claimed`` (in d), ``measure``, ``relation`` (``=`` or ``≥``); the measure is
      ``nominal``, ``true`` (of a polynomial), ``lowest terms`` (true, of the value), ``reduced`` (true, of what
      `exactspline.symbolic.reduction` keeps) or ``height`` (0 for a covariant); of two curves in the ``parameter`` s or
      s̄; with the ``counting`` ``part by part`` as (24) counts;
    - ``identity``: ``left = factor · right``;
    - ``vanishing``: ``left`` is identically zero;
    - ``zero set``: all of ``formulas`` have one zero set;
    - ``coefficients``: no B-spline coefficient of ``formula`` vanishes;
    - ``count``: the numbers in ``claimed`` ("degree 96, 388 control points") are those of ``formula`` on the curve
      ``example``;
    - ``same surface``: the ruled surfaces ``left`` and ``right`` are one: parallel generators, and directrices that
      differ along them;
    - ``existence``: ``formula`` is not rational (refuted by the formula itself, which is a quotient of polynomials, and
      by the proof of what it is);
    - ``iso-curve``: the plane curve ``left`` is the curve ζ = 0 of the ruled surface ``right``;
    - ``square class``: ``formula`` is a square up to constants, on whatever curve, exactly where ``right`` is.

    ``without_zero`` lists what `assumes` says has no zero (``w``, ``γ′``, ``γ′×γ″``): a factor made of these changes no
    zero set. ``witness`` is the example curve that is tried first where a counterexample is wanted.
    """

    id: str
    kind: str
    source: str
    statement: str
    curve: str = "curve"
    assumes: str = ""
    of: str = "both"
    formula: str = ""
    claimed: str = ""
    parameter: str = "s"
    counting: str = ""
    measure: str = "nominal"
    relation: str = "="
    left: str = ""
    right: str = ""
    factor: str = "1"
    formulas: tuple[str, ...] = ()
    example: str = ""
    without_zero: tuple[str, ...] = ()
    witness: str = ""
    as_meant: bool = False
    expected: str = "PROVED"
    note: str = field(default="", compare=False)

    @property
    def named(self) -> tuple[str, ...]:
        """The formulas it speaks of."""
        return tuple(name for name in (self.formula, self.left, self.right, *self.formulas) if name)

    def speaks_of(self, dimension: int, polynomial: bool) -> bool:
        """Whether it says anything about curves of that dimension and kind."""
        if self.example or self.counting or self.measure in ("generic", "height"):
            return False
        return (
            self.curve != "table"
            and dimension in DIMENSIONS[self.curve]
            and self.of in ("both", "polynomial" if polynomial else "rational")
        )


def _claim(entry: dict[str, object], place: str) -> Claim:
    known = {f.name for f in fields(Claim)}
    if unknown := set(entry) - known:
        raise ClaimError(
            f"the field {sorted(unknown)[0]!r} is unknown", where=place, remedy=f"fields are {', '.join(sorted(known))}"
        )
    if missing := {"id", "kind", "source", "statement"} - set(entry):
        raise ClaimError(
            f"the field {sorted(missing)[0]!r} is missing",
            where=place,
            remedy="every claim has an id, a kind, a source and a statement",
        )
    claim = Claim(**{name: tuple(value) if isinstance(value, list) else value for name, value in entry.items()})  # type: ignore[arg-type]
    if claim.kind not in KINDS:
        raise ClaimError(f"the kind {claim.kind!r} is unknown", where=place, remedy=f"kinds are {', '.join(KINDS)}")
    if unsaid := [name for name in claim.without_zero if name not in claim.assumes]:
        raise ClaimError(
            f"{unsaid[0]!r} has no zero, which `assumes` does not say", where=place, remedy="say it there too"
        )
    if claim.expected not in VERDICTS:
        raise ClaimError(
            f"the verdict {claim.expected!r} is unknown", where=place, remedy=f"verdicts are {', '.join(VERDICTS)}"
        )
    for name in claim.named:
        find(name)
    return claim


@cache
def all_claims() -> tuple[Claim, ...]:
    """Every claim, in the order of the paper.

    >>> [claim.factor for claim in all_claims() if claim.id == "C4.1a"]
    ['w', 'w^-3']
    """
    claims = [_claim(table.entry, table.place) for source in papers() for table in source.claim_tables()]
    return tuple(claims)


def select(ids: Iterable[str]) -> tuple[Claim, ...]:
    """The claims with the given ids, all of them for none; an id also selects what it begins (``C3`` all of §3).

    Raises `ClaimError` with the ids there are.
    """
    ids = list(ids)
    chosen = tuple(claim for claim in all_claims() if not ids or any(matches(claim.id, i) for i in ids))
    for i in ids:
        if not any(matches(claim.id, i) for claim in all_claims()):
            known = ", ".join(dict.fromkeys(claim.id for claim in all_claims()))
            raise ClaimError(f"no claim has the id {i!r}", remedy=f"ids are {known}")
    return chosen


def matches(claim_id: str, wanted: str) -> bool:
    """Whether an id is the wanted one or a part of it.

    >>> matches("C3a", "c3"), matches("C4.1a", "C4.1"), matches("T17", "T1")
    (True, True, False)
    """
    a, b = claim_id.lower(), wanted.lower()
    return a == b or (a.startswith(b) and not (b[-1].isdigit() and a[len(b)].isdigit()))
