"""The fields of a kind of claims, determined once per kind."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import MISSING, Field, dataclass, field, fields
from typing import NamedTuple, TypeVar, dataclass_transform

K = TypeVar("K")


@dataclass_transform(kw_only_default=True, frozen_default=True, eq_default=False, field_specifiers=(field,))
def claim_kind(kind: type[K]) -> type[K]:
    """Declare a kind of claims: a dataclass with named fields, whose methods are inherited from `Claim` (generating
    them for each kind would take longer than reading all its claims).
    """
    return dataclass(init=False, repr=False, eq=False, kw_only=True)(kind)


class _Declared(NamedTuple):
    """Data about the dataclass of a kind of claims: the reader of each field (None for a text) and its default; the
    fields compared by equality; the fields that an entry may have; the fields that it must have; and the values of all
    others.
    """

    checks: tuple[tuple[str, Callable[..., object] | None, object], ...]
    compared: tuple[str, ...]
    entries: dict[str, Field[object]]
    needed: tuple[str, ...]
    defaults: dict[str, object]


_DECLARED: dict[type, _Declared] = {}


def declared(kind: type) -> _Declared:
    """The fields of a kind of claims.

    >>> from exactspline.verification.kinds.equality import Vanishing
    >>> declared(Vanishing).needed
    ('id', 'source', 'statement', 'status', 'key', 'left')
    """
    if kind not in _DECLARED:
        _DECLARED[kind] = _sorted_out(fields(kind))
    return _DECLARED[kind]


def _sorted_out(own: tuple[Field[object], ...]) -> _Declared:
    entries = {f.name: f for f in own if f.name != "paper"}
    return _Declared(
        checks=tuple((f.name, f.metadata.get("check"), f.default) for f in own),
        compared=tuple(f.name for f in own if f.compare),
        entries=entries,
        needed=tuple(name for name, f in entries.items() if f.default is MISSING),
        defaults={f.name: f.default for f in own if f.default is not MISSING},
    )
