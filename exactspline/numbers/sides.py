"""The two sides of a point of the line."""

from __future__ import annotations

from enum import StrEnum


class Side(StrEnum):
    """The side from which a limit is taken or a one-sided value is reached."""

    LEFT = "left"
    RIGHT = "right"
