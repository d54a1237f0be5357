"""The claims of the papers as data: a statement about formulas, its place in the source, and the recorded verdict.

The tables are stored next to the formulas of each paper. An entry names formulas of `exactspline.papers` and never
transcribes one; it is read as an object of its kind (`exactspline.verification.kinds`), and anything without meaning is
refused. Several entries may share the id of the paper's claim; each has a unique key.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from enum import StrEnum
from functools import cache
from typing import Any

from exactspline.errors import (
    ClaimError,
    ExactSplineError,
    ShapeError,
    a_kind,
    as_instance,
    as_items,
    as_text,
    nearest,
    shown,
)
from exactspline.papers import Paper, Table, default_papers, paper
from exactspline.symbolic.assumptions import Assumption
from exactspline.verification.claim import Claim, declared
from exactspline.verification.kinds import KINDS
from exactspline.verification.kinds.not_asked import NotAsked
from exactspline.verification.paper_curves import refused_curves
from exactspline.verification.vocabulary import Verdict

#: The largest length of a text of a claim.
LONGEST = 2000
#: Texts shorter than this are not searched for in statements.
SHORTEST = 4


def claim_of(table: Table, source: Paper) -> Claim:
    """One entry of a table as a claim.

    >>> table = next(paper("lifted").claim_tables())
    >>> claim_of(table, paper("lifted")).latex
    '\\\\mathrm{inflections\\\\_lifted} = f_2'

    Raises `ClaimError`, which names file and entry and suggests a correction.
    """
    try:
        return _read(table.entry, source)
    except ExactSplineError as error:
        raise ClaimError(
            error.problem, where=", ".join(filter(None, (table.place, error.where))), remedy=error.remedy
        ) from error


def _completed(entry: dict[str, Any], source: Paper) -> dict[str, Any]:
    """An entry with its defaults: its status is ``printed`` if it has words or a place in the source, otherwise
    ``ours``.
    """
    completed = dict(entry)
    completed.setdefault("status", "printed" if completed.get("words") or completed.get("place") else "ours")
    completed.setdefault("source", completed.get("place") or source.title)
    if "id" in completed and "key" not in completed:
        completed["key"] = f"{re.sub(r'[ .]+', '', str(completed['id']))}-{completed.get('kind', '')}".replace(" ", "-")
    return completed


def _read(entry: dict[str, Any], source: Paper) -> Claim:
    fields = _completed(entry, source)
    name = fields.pop("kind", None)
    if name is None:
        raise ClaimError("the field 'kind' is missing", where="kind", remedy=f"there are {', '.join(KINDS)}")
    if not isinstance(name, str) or name not in KINDS:
        raise ClaimError(f"the kind {name!r} is unknown", where="kind", remedy=nearest(str(name), list(KINDS)))
    kind = KINDS[name]
    known = declared(kind).entries
    for field in fields:
        if field not in known:
            raise ClaimError(
                f"claims of the kind {name!r} have no field {field!r}", where=field, remedy=nearest(field, list(known))
            )
    for field, value in fields.items():
        if problem := _shape(str(known[field].type), value):
            raise ClaimError(f"{shown(value)} is {problem}", where=field, remedy="look at the table of kinds of claims")
        if field != "words" and "$" in str(value):  # quotations keep the LaTeX of their source
            raise ClaimError(
                "'$' in a text", where=field, remedy="write formulas as text, like κ′ or γ; pages show them"
            )
    for field in declared(kind).needed:
        if field not in fields:
            raise ClaimError(f"the field {field!r} is missing", where=field, remedy="add it")
    values: dict[str, Any] = {f: tuple(v) if isinstance(v, list) else v for f, v in fields.items()}
    claim = kind(paper=source.name, **values)
    if claim.error and claim.error not in source.errors:
        raise ClaimError(
            f"there is no error called {claim.error!r}",
            where="error",
            remedy=f'write [errors] {claim.error} = "what is wrong"; {nearest(claim.error, list(source.errors))}',
        )
    _check_words_of_key(claim)
    return claim


def _shape(declared: str, value: object) -> str:
    """The reason why a value does not have the declared type of its field; empty if it has the type."""
    if "mpq" in declared:
        several = value if isinstance(value, list) and declared.startswith("tuple") else [value]
        good = all(type(each) in (int, str) for each in several)
        return "" if good else 'not a number such as "1/3", or not a list of them'
    if declared.startswith("tuple"):
        good = isinstance(value, list) and all(isinstance(each, str) and len(each) <= LONGEST for each in value)
        return "" if good else "not a list of texts"
    if declared == "int":
        return "" if type(value) is int else "not an integer"
    return "" if isinstance(value, str) and len(value) <= LONGEST else f"not a text of at most {LONGEST} letters"


def _check_words_of_key(claim: Claim) -> None:
    """Each word of a key also occurs elsewhere in the entry, so that a misspelled key is detected."""
    words = dict.fromkeys(claim.key.removeprefix(claim.begin_of_key + "-").split("-"))
    known = set(claim.kind.replace("-", " ").split())
    for field in reversed(declared(type(claim)).entries):  # the fields of its kind first: usually they suffice
        if words.keys() <= known:
            return
        if field not in ("id", "key", "words", "context", "note"):
            known |= _key_words(getattr(claim, field))
    for each in words:
        if each not in known:
            raise ClaimError(
                f"the word {each!r} of the key {claim.key!r} does not occur elsewhere in the entry",
                where="key",
                remedy=f"use names of its formulas and words of its fields; {nearest(each, sorted(known))}",
            )


def _key_words(value: object) -> set[str]:
    """The words of a field that may occur in a key.

    >>> from exactspline.language.operand import Parameter
    >>> sorted(_key_words(("4d − 2", Parameter.SECOND)))
    ['2', '4d', 's', 'second']
    """
    if isinstance(value, Assumption):
        return _key_words(value.name)
    if isinstance(value, tuple):
        return {word for each in value for word in _key_words(each)}
    own = {value.name.lower()} if isinstance(value, StrEnum) else set()
    return own.union(_words_of(str(value)))


@cache
def _words_of(text: str) -> tuple[str, ...]:
    return tuple(re.findall(r"[\w′]+", text))


def claims_of(source: Paper | str) -> tuple[Claim, ...]:
    """The claims of one paper, in its order. In a user's folder, an entry that is refused, or whose key occurs twice,
    becomes a claim of the kind ``not asked``, with the verdict NOT ASKED and the reason, so that no other claim is
    hidden. Refused formulas and curves become such claims, too, at the end.

    Raises `ClaimError` for such an entry of a paper of the library, and for a file that is not a table of claims.
    """
    given = paper(source) if isinstance(source, str) else source
    return _claims(as_instance(given, Paper, "a paper", "give its name, or the result of exactspline.paper"))


@cache
def _claims(source: Paper) -> tuple[Claim, ...]:
    claims, places = list[Claim](), dict[str, str]()
    for table in source.claim_tables():
        try:
            claim = claim_of(table, source)
            if claim.key in places:
                taken = f"the key {claim.key!r} is taken by {places[claim.key]}"
                raise ClaimError(taken, where=table.place, remedy="choose another one")
        except ClaimError as error:
            if source.package:
                raise
            claim = _refused(table.entry, source, f"{len(claims) + 1}", error)
        places[claim.key] = table.place
        claims.append(claim)
    for name, why in {**source.refused, **refused_curves(source)}.items():
        claims.append(_refused({"id": name, "statement": f"refused: {name}"}, source, f"{len(claims) + 1}", why))
    return tuple(claims)


def _refused(entry: dict[str, Any], source: Paper, number: str, error: ExactSplineError) -> NotAsked:
    """The claim in place of a refused entry, formula or curve of a user's folder, with those of its texts that can be
    printed.
    """
    given = {name: entry.get(name) for name in ("id", "statement", "place", "words", "section")}
    texts = {name: text for name, text in given.items() if isinstance(text, str) and _printable(text) == text}
    texts = {"id": number, "statement": "an entry without a statement"} | texts
    texts["key"] = f"{re.sub(r'[ .]+', '', texts['id'])}-not-asked-{number}"
    why = _printable(str(error))
    return NotAsked(paper=source.name, **_completed(texts, source), why=why, expected=Verdict.PROVED)


def _printable(text: str) -> str:
    """A text in one line, shortened to the length that a text of a claim may have."""
    return " ".join("".join(letter if letter.isprintable() else " " for letter in text[:LONGEST]).split())


@cache
def all_claims() -> tuple[Claim, ...]:
    """Every claim of the default papers, in the order of the papers.

    >>> [claim.factor for claim in all_claims() if claim.id == "C4.1a"]
    ['w', 'w^-3']
    """
    return claims_in(default_papers())


def claims(*ids: str, paper: Paper | str | None = None) -> tuple[Claim, ...]:
    """Return the claims with these ids or keys, or without ids all claims, of a paper (by default of the default
    papers). An id also selects all ids that begin with this id (``C3`` selects all of §3).

    >>> [claim.key for claim in claims("C4.1a")]
    ['C41a-f1-f2', 'C41a-f0-f2']

    Raises `ClaimError`, with the nearest ids, for an unknown id.
    """
    return select(ids, None if paper is None else claims_of(paper))


def claims_in(sources: Iterable[Paper]) -> tuple[Claim, ...]:
    """Every claim of some papers."""
    return tuple(claim for source in sources for claim in claims_of(source))


def select(ids: Iterable[str], claims: Iterable[Claim] | None = None) -> tuple[Claim, ...]:
    """The claims with the given ids or keys; without any, all claims. An id also selects all ids that begin with it
    (``C3`` all of §3). They are searched for among `claims`, by default those of the default papers.

    Raises `ClaimError`, with the nearest ids, for an unknown id.
    """
    ids = [as_text(each, "the id of a claim") for each in as_items(ids, "ids of claims")]
    known = all_claims() if claims is None else tuple(map(expect_claim, as_items(claims, "claims")))
    chosen = tuple(c for c in known if not ids or any(i == c.key or matches(c.id, i) for i in ids))
    for i in ids:
        if not any(i == claim.key or matches(claim.id, i) for claim in known):
            ids_there = dict.fromkeys(claim.id for claim in known)
            raise ClaimError(f"no claim has the id {i!r}", remedy=nearest(i, ids_there))
    return chosen


def expect_claim(given: object) -> Claim:
    """The claim itself; `ShapeError` for anything else."""
    if isinstance(given, Claim):
        return given
    raise ShapeError(
        f"{a_kind(given)}, where a claim is expected", remedy='give one, such as exactspline.claims("C4.1a")[0]'
    )


def matches(claim_id: str, requested: str) -> bool:
    """Whether an id is the requested id or begins with it.

    >>> matches("C3a", "c3"), matches("C4.1a", "C4.1"), matches("T17", "T1")
    (True, True, False)
    """
    a, b = claim_id.lower(), requested.lower()
    return a == b or (a.startswith(b) and not (b[-1].isdigit() and a[len(b)].isdigit()))


def located(requested: str, claims: Iterable[Claim] | None = None) -> tuple[Claim, ...]:
    """The claims with this id or one that begins with it, those at this place of the paper, or those that mention it.

    >>> [claim.id for claim in located("eq. (8)")][:2], located("C4.1c")[0].id
    (['E8', 'C4.1a'], 'C4.1c')
    >>> located("rectifying developable")[0].id
    'C5.4a'

    They are searched for among `claims`, by default those of the default papers. Raises `ClaimError`, with the nearest
    ids, for an unknown id.
    """
    known = all_claims() if claims is None else tuple(claims)
    chosen = tuple(c for c in known if c.key == requested or matches(c.id, requested))
    chosen = chosen or tuple(
        c for c in known if any(stands_at(each, requested) for each in (c.source, c.place, c.section))
    )
    if len(requested) >= SHORTEST:
        chosen = chosen or tuple(c for c in known if requested.lower() in c.statement.lower())
    if not chosen:
        ids = dict.fromkeys(claim.id for claim in known)
        raise ClaimError(f"no claim has the id {requested!r}", remedy=nearest(requested, ids, listed_by="show"))
    return chosen


def stands_at(source: str, requested: str) -> bool:
    """Whether a place is the requested one: the equation with this number, a remark, a figure, a section."""
    a, b = (" ".join(text.lower().replace("equation", "eq.").split()) for text in (source, requested))
    if b.startswith("(") and b.endswith(")"):
        return b in a
    position = a.find(b)
    after = a[position + len(b) :]
    return len(b) > 1 and position >= 0 and not (b[-1].isdigit() and after[:1].isdigit())
