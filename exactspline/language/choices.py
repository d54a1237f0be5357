"""Words that a user chooses from: enumerations whose members are also their names as text, and the one place that reads
them.
"""

from __future__ import annotations

from enum import StrEnum
from typing import TypeVar

from exactspline.errors import ExactSplineError, FormulaError, nearest

E = TypeVar("E", bound=StrEnum)

#: Up to so many words, an error lists all of them.
FEW = 7


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

    >>> choice(Counting, "part by part", "way to count")
    <Counting.PART_BY_PART: 'part by part'>

    Raises `raised`, which lists the words, or the nearest of many.
    """
    if isinstance(value, str):
        try:
            return kind(value)
        except ValueError:
            pass
    words = [*kind, *also]
    remedy = f"there are {', '.join(words)}" if len(words) <= FEW else nearest(str(value), words)
    raise raised(f"the {what} {value!r} is unknown", where=where, remedy=remedy)
