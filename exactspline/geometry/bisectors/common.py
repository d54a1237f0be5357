"""The common parts of all bisectors."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import pairwise
from typing import Any

from exactspline.errors import ShapeError, counted
from exactspline.hooks import Written
from exactspline.language.vector import Vector
from exactspline.numbers.exact import Number, mpq, rational
from exactspline.one_line import one_line, short_text
from exactspline.questions.answers import NamedNumbers
from exactspline.reals.real import between
from exactspline.roots.of_polynomials import Parameter
from exactspline.splines.bspline import BSpline


class Bisector(Written):
    """The bisector of a curve and another curve or a point: its pieces, and the missing parts with the reasons. Each
    subclass describes its pieces.
    """

    pieces: tuple[Any, ...]
    missing: tuple[Any, ...]

    @property
    def items(self) -> Iterable[NamedNumbers]:
        """The parts of a bisector in the plane: the end points of each piece, then their parameters.

        Raises `ShapeError` in space.
        """
        raise ShapeError("the points of a surface", remedy="exactspline bisector --json has its control points")

    @one_line
    def __repr__(self) -> str:
        gaps = f", {len(self.missing)} missing" if self.missing else ""
        return f"<{type(self).__name__}: {counted(len(self.pieces), 'piece')}{gaps}>"


# ---- what is missing


STILL = "the curve stands still here, and has no normals"
PARALLEL = "the tangents are parallel everywhere, so are the normal planes"
COPLANAR = "the curves lie in one plane, and all three planes of the system are perpendicular to it"
THROUGH = "the curve is straight here and its line passes through the point"
AROUND = "the curve is an arc here of a circle through the point, and all its normals meet in the centre"


def is_zero_on(v: Vector[BSpline], at: int) -> bool:
    """Whether a vector of splines vanishes on all of the segment or patch with this number."""
    return not any(x.numerators[at] for x in v)


def within(parameter: Number, low: Parameter, high: Parameter) -> mpq:
    """The parameter of a point of a piece; raises `ShapeError` outside the piece.

    >>> within("1/2", mpq(0), mpq(1))
    mpq(1,2)
    """
    t = rational(parameter)
    if not low <= t <= high:
        raise ShapeError(f"{short_text(t)} is outside this piece", remedy="stay between low and high")
    return t


def parts_where(
    holds: Callable[[mpq], bool], cuts: Iterable[Parameter], apart: Sequence[Parameter] = ()
) -> list[tuple[Parameter, Parameter]]:
    """The closed intervals between neighbouring cuts on which a condition holds that can change at cuts only;
    neighbouring intervals are joined except at the places `apart`.

    >>> parts_where(lambda x: x > 1, [mpq(0), mpq(1), mpq(2), mpq(3), mpq(4)], apart=[mpq(3)])
    [(mpq(1,1), mpq(3,1)), (mpq(3,1), mpq(4,1))]
    """
    intervals: list[tuple[Parameter, Parameter]] = []
    for low, high in pairwise(cuts):
        if holds(between(low, high)):
            if intervals and intervals[-1][1] == low and low not in apart:
                intervals[-1] = (intervals[-1][0], high)
            else:
                intervals.append((low, high))
    return intervals
