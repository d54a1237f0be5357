"""What all bisectors have in common."""

from __future__ import annotations

from typing import Any

from exactspline.errors import counted
from exactspline.hooks import Displayed
from exactspline.one_line import one_line


class Bisector(Displayed):
    """The bisector of a curve and another curve or a point: its pieces, and what is missing, with the reason. Each of
    its classes says what its pieces are.
    """

    pieces: tuple[Any, ...]
    missing: tuple[Any, ...]

    @one_line
    def __repr__(self) -> str:
        gaps = f", {len(self.missing)} missing" if self.missing else ""
        return f"<{type(self).__name__}: {counted(len(self.pieces), 'piece')}{gaps}>"
