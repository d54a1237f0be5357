"""The two sides of a point on the real line."""

from __future__ import annotations

from exactspline.words import Word


class Side(Word):
    """The side from which a limit or a one-sided value is taken."""

    LEFT = "left"
    RIGHT = "right"
