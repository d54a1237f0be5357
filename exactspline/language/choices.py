"""Words that a user chooses from: enumerations whose members are also their names as text."""

from __future__ import annotations

from enum import StrEnum


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
