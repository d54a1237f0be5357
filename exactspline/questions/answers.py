"""The things of which an answer consists, with their descriptions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from exactspline.hooks import Written
from exactspline.one_line import OneLine, one_line
from exactspline.reals.real import Real
from exactspline.roots.answers import CurvePiece


class Described(OneLine):
    """One of the things of which an answer consists, on a piece of a curve: its kind and its description."""

    kind: StrEnum
    piece: CurvePiece

    @property
    def values(self) -> dict[str, tuple[Real, ...]]:
        """The numbers, points and vectors that describe it, by name."""
        return {}

    @property
    def facts(self) -> dict[str, bool]:
        """The facts about it, by name."""
        return {}


@dataclass(frozen=True)
class NamedNumbers(Written):
    """Numbers by their names, the kind of object that they describe, and further facts about it."""

    what: str
    values: Mapping[str, Real]
    facts: Mapping[str, object] = field(default_factory=dict)

    @one_line
    def __repr__(self) -> str:
        numbers = ", ".join(f"{name} {value}" for name, value in self.values.items())
        return f"<{self.what}: {numbers}>"
