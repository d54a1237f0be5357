"""The fields of a kind of claims, sorted out once per kind."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import MISSING, Field, fields
from typing import Any, NamedTuple


class Declared(NamedTuple):
    """Of the dataclass of a kind of claims: what reads each field (None for a text) and its default; the fields that
    make two claims equal; those that an entry may have; and those that it must have.
    """

    checks: tuple[tuple[str, Callable[[Any, str, Any], object] | None, object], ...]
    compared: tuple[str, ...]
    entries: dict[str, Field[object]]
    needed: tuple[str, ...]


_DECLARED: dict[type, Declared] = {}


def declared(kind: type[Any]) -> Declared:
    """The fields of a kind of claims.

    >>> from exactspline.verification.kinds import Vanishing
    >>> declared(Vanishing).needed
    ('id', 'source', 'statement', 'status', 'key', 'left')
    """
    if kind not in _DECLARED:
        _DECLARED[kind] = _sorted_out(fields(kind))
    return _DECLARED[kind]


def _sorted_out(own: tuple[Field[Any], ...]) -> Declared:
    entries = {f.name: f for f in own if f.name != "paper"}
    return Declared(
        checks=tuple((f.name, f.metadata.get("check"), f.default) for f in own),
        compared=tuple(f.name for f in own if f.compare),
        entries=entries,
        needed=tuple(name for name, f in entries.items() if f.default is MISSING),
    )
