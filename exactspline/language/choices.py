"""Options that users choose from: enumerations whose members are equal to their names as strings."""

from __future__ import annotations

from enum import StrEnum


class Parameter(StrEnum):
    """A parameter: of a curve or the first of two curves; of the second curve; the two parameters of a surface."""

    FIRST = "s"
    SECOND = "s̄"
    U = "u"
    V = "v"


class Counting(StrEnum):
    """How nominal degrees are counted: as in Table 1, or part by part, as in (24)."""

    TABLE_1 = "Table 1"
    PART_BY_PART = "part by part"
