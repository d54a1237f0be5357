"""The spline reading: formulas evaluated on the given curves."""

from __future__ import annotations

from exactspline.language.argument import Evaluated
from exactspline.language.kinds import Kind
from exactspline.language.reading import Reading


class SplineReading(Reading):
    """Curves themselves: a formula returns a spline, or a quotient of splines.

    >>> from exactspline.papers import find
    >>> from exactspline.splines.examples import example
    >>> SplineReading(example("ellipse")).of(find("g2"), 2).degree
    12
    """

    name = "spline"
    proves = "what is true of the given curve"

    def __init__(self, given: Evaluated) -> None:
        self.given = given

    def argument(self, kind: Kind, dimension: int, *, polynomial: bool = False) -> Evaluated:
        """The given curves."""
        return self.given
