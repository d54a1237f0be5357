"""Words that a user chooses from: enumerations whose members are also their names as text, and the one place that reads
them.
"""

from __future__ import annotations

from enum import EnumType, StrEnum
from typing import TypeVar, cast

from exactspline.errors import ExactSplineError, FormulaError, nearest, shown

E = TypeVar("E", bound=StrEnum)

#: Up to so many words, an error lists all of them.
FEW = 7


class _Words(EnumType):
    """The class of enumerations that refuse what is not one of their words by an error of ours."""

    def __call__(cls: type[E], value: object) -> E:  # type: ignore[override, misc]  # it makes no new enumeration
        """The member that the word names."""
        return choice(cls, value, cls.__name__.lower())


class Word(StrEnum, metaclass=_Words):
    """The base of enumerations that a user names: ``Side("left")`` is a member, another value a `FormulaError`."""


class Side(Word):
    """The side from which a limit is taken or a one-sided value is reached."""

    LEFT = "left"
    RIGHT = "right"


class Parameter(StrEnum):
    """A parameter: that of a curve, or of the first of two; that of the second one; the two of a surface."""

    FIRST = "s"
    SECOND = "s̄"
    U = "u"
    V = "v"


class Counting(StrEnum):
    """How nominal degrees are counted: as Table 1 counts, or part by part, as (24) does."""

    TABLE_1 = "Table 1"
    PART_BY_PART = "part by part"


def choice(
    kind: type[E],
    value: object,
    what: str,
    *,
    raised: type[ExactSplineError] = FormulaError,
    where: str = "",
    also: tuple[str, ...] = (),
) -> E:
    """The member of an enumeration that a word names; `also` are further words that the caller accepts.

    >>> choice(Side, "left", "side")
    <Side.LEFT: 'left'>

    Raises `raised`, which lists the words, or the nearest of many.
    """
    found = kind._value2member_map_.get(value) if isinstance(value, str) else None
    if isinstance(found, kind):
        return found
    words = [*kind, *also]
    remedy = f"there are {', '.join(words)}" if len(words) <= FEW else nearest(cast(str, value), words)
    raise raised(f"the {what} {shown(value)} is unknown", where=where, remedy=remedy)
