"""What all bisectors have in common."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from exactspline.errors import ShapeError, counted
from exactspline.hooks import Written
from exactspline.one_line import one_line
from exactspline.questions.answers import NamedNumbers


class Bisector(Written):
    """The bisector of a curve and another curve or a point: its pieces, and what is missing, with the reason. Each of
    its classes says what its pieces are.
    """

    pieces: tuple[Any, ...]
    missing: tuple[Any, ...]

    @property
    def items(self) -> Iterable[NamedNumbers]:
        """What it consists of, in the plane: the points of the ends of each piece, then their parameters.

        Raises `ShapeError` in space.
        """
        raise ShapeError("the points of a surface", remedy="exactspline bisector --json has its control points")

    @one_line
    def __repr__(self) -> str:
        gaps = f", {len(self.missing)} missing" if self.missing else ""
        return f"<{type(self).__name__}: {counted(len(self.pieces), 'piece')}{gaps}>"
