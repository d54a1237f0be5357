"""Words from which a user chooses, and the function that reads them."""

from __future__ import annotations

from enum import EnumType, StrEnum
from typing import TypeVar, cast

from exactspline.errors import ExactSplineError, FormulaError, nearest, shown

E = TypeVar("E", bound=StrEnum)

#: Up to this many words, an error lists all of them.
FEW = 7


class _Words(EnumType):
    """The class of enumerations that refuse other words with an error of exactspline."""

    def __call__(cls: type[E], value: object) -> E:  # type: ignore[override, misc]  # it makes no new enumeration
        """The member that the word names."""
        return choice(cls, value, cls.__name__.lower())


class Word(StrEnum, metaclass=_Words):
    """The base of enumerations that a user names: ``Side("left")`` is a member; any other value raises
    `FormulaError`.
    """


def choice(
    kind: type[E], value: object, what: str, *, raised: type[ExactSplineError] = FormulaError, where: str = ""
) -> E:
    """The member of an enumeration that a word names.

    >>> class Side(Word):
    ...     LEFT = "left"
    >>> choice(Side, "left", "side")
    <Side.LEFT: 'left'>

    Raises `raised`, which lists the words, or the nearest of many.
    """
    found = kind._value2member_map_.get(value) if isinstance(value, str) else None
    if isinstance(found, kind):
        return found
    remedy = f"there are {', '.join(kind)}" if len(kind) <= FEW else nearest(cast(str, value), kind)
    raise raised(f"the {what} {shown(value)} is unknown", where=where, remedy=remedy)
