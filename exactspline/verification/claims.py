"""The claims of the papers as data: what is claimed of which formulas, where it stands, and the verdict that is on
record.

The tables lie beside the formulas of each paper. An entry names formulas of `exactspline.papers`, never transcribes
one; it is read as an object of its kind (`exactspline.verification.kinds`), and whatever says nothing is refused.
Several entries may share the id of the paper's claim; each has a key of its own.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import MISSING, fields
from enum import StrEnum
from functools import cache
from typing import Any

from exactspline.errors import ClaimError, ExactSplineError, nearest
from exactspline.papers import Paper, Table, paper, papers
from exactspline.symbolic.assumptions import Assumption
from exactspline.verification.claim import Claim, entries
from exactspline.verification.kinds import KINDS


def claim_of(table: Table, source: Paper) -> Claim:
    """One entry of a table as a claim.

    >>> table = next(paper("lifted").claim_tables())
    >>> claim_of(table, paper("lifted")).latex
    '\\\\mathrm{inflections\\\\_lifted} = f_2'

    Raises `ClaimError` that names file and entry and says what would be right.
    """
    try:
        return _read(table.entry, source)
    except ExactSplineError as error:
        raise ClaimError(
            error.problem, where=", ".join(filter(None, (table.place, error.where))), remedy=error.remedy
        ) from error


def _read(entry: dict[str, Any], source: Paper) -> Claim:
    told = dict(entry)
    name = told.pop("kind", None)
    if name not in KINDS:
        raise ClaimError(f"the kind {name!r} is unknown", where="kind", remedy=nearest(str(name), list(KINDS)))
    kind = KINDS[name]
    known = entries(kind)
    for field in told:
        if field not in known:
            raise ClaimError(
                f"claims of the kind {name!r} have no field {field!r}", where=field, remedy=nearest(field, list(known))
            )
    for field, declared in known.items():
        if field not in told and declared.default is MISSING:
            raise ClaimError(f"the field {field!r} is missing", where=field, remedy="add it")
    values: dict[str, Any] = {f: tuple(v) if isinstance(v, list) else v for f, v in told.items()}
    claim = kind(paper=source.name, **values)
    if claim.error and claim.error not in source.errors:
        raise ClaimError(
            f"no error is called {claim.error!r}", where="error", remedy=nearest(claim.error, list(source.errors))
        )
    _check_words_of_key(claim)
    return claim


def _check_words_of_key(claim: Claim) -> None:
    """Each word of a key stands elsewhere in the entry too, so that no key is misspelled unnoticed."""
    known = set(claim.kind.split())
    for f in fields(claim):
        if f.name not in ("id", "key", "paper", "words", "context", "note"):
            known |= key_words(getattr(claim, f.name))
    for each in claim.key.removeprefix(claim.begin_of_key + "-").split("-"):
        if each not in known:
            raise ClaimError(
                f"the word {each!r} of the key {claim.key!r} stands nowhere else in the entry",
                where="key",
                remedy=f"use names of its formulas and words of its fields; {nearest(each, sorted(known))}",
            )


def key_words(value: object) -> set[str]:
    """The words of a field that may stand in a key.

    >>> from exactspline.language.choices import Parameter
    >>> sorted(key_words(("4d − 2", Parameter.SECOND)))
    ['2', '4d', 's', 'second']
    """
    if isinstance(value, Assumption):
        return key_words(value.name)
    if isinstance(value, tuple):
        return {word for each in value for word in key_words(each)}
    own = {value.name.lower()} if isinstance(value, StrEnum) else set()
    return own | set(re.findall(r"[\w′]+", str(value)))


@cache
def claims_of(name: str) -> tuple[Claim, ...]:
    """The claims of one paper, in its order.

    Raises `ClaimError` for an entry that says nothing, and for a key that occurs twice.
    """
    source, found, places = paper(name), [], dict[str, str]()
    for table in source.claim_tables():
        claim = claim_of(table, source)
        if claim.key in places:
            raise ClaimError(
                f"the key {claim.key!r} is taken by {places[claim.key]}", where=table.place, remedy="choose another one"
            )
        places[claim.key] = table.place
        found.append(claim)
    return tuple(found)


@cache
def all_claims() -> tuple[Claim, ...]:
    """Every claim of every paper that comes with the library, in the order of the papers.

    >>> [claim.factor for claim in all_claims() if claim.id == "C4.1a"]
    ['w', 'w^-3']
    """
    return tuple(claim for source in papers() for claim in claims_of(source.name))


def select(ids: Iterable[str]) -> tuple[Claim, ...]:
    """The claims with the given ids or keys, all of them for none; an id also selects what it begins (``C3`` all of
    §3).

    Raises `ClaimError` with the nearest ids.
    """
    ids = list(ids)
    chosen = tuple(c for c in all_claims() if not ids or any(i == c.key or matches(c.id, i) for i in ids))
    for i in ids:
        if not any(i == claim.key or matches(claim.id, i) for claim in all_claims()):
            known = list(dict.fromkeys(claim.id for claim in all_claims()))
            raise ClaimError(f"no claim has the id {i!r}", remedy=nearest(i, known))
    return chosen


def matches(claim_id: str, wanted: str) -> bool:
    """Whether an id is the wanted one or a part of it.

    >>> matches("C3a", "c3"), matches("C4.1a", "C4.1"), matches("T17", "T1")
    (True, True, False)
    """
    a, b = claim_id.lower(), wanted.lower()
    return a == b or (a.startswith(b) and not (b[-1].isdigit() and a[len(b)].isdigit()))
