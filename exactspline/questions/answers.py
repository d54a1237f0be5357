"""One of the things of which an answer consists, with what is to be said of it."""

from __future__ import annotations

from enum import StrEnum

from exactspline.reals.real import Real
from exactspline.roots.answers import CurvePiece


class Described:
    """One of the things of which an answer consists, on a piece of a curve: its kind, and what is to be said of it."""

    kind: StrEnum
    piece: CurvePiece

    @property
    def values(self) -> dict[str, tuple[Real, ...]]:
        """Numbers, points and vectors that describe it, by name."""
        return {}

    @property
    def facts(self) -> dict[str, bool]:
        """What is true of it, by name."""
        return {}
