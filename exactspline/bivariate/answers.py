"""The places of a surface at which something holds: points, parts of patches, or both."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeVar

from exactspline.numbers.intervals import Box
from exactspline.one_line import OneLine, one_line
from exactspline.roots.answers import Answer

T_co = TypeVar("T_co", covariant=True)


@dataclass(frozen=True, repr=False)
class SurfacePart(OneLine):
    """A part of one patch of a surface: a rectangle of parameters, an edge (one side of the rectangle is a single
    number), or a curve inside the rectangle.

    >>> from gmpy2 import mpq
    >>> from exactspline.numbers.intervals import Interval
    >>> print(SurfacePart((0, 0), Box(Interval(mpq(0), mpq(1)), Interval.point(mpq(2)))))
    [0, 1] × [2, 2]
    """

    patch: tuple[int, int]
    sides: Box
    along_curve: bool = False

    @one_line
    def __str__(self) -> str:
        return f"{'a curve in ' * self.along_curve}{self.sides.shortly}"


@dataclass(frozen=True, repr=False)
class SurfacePlaces(Answer[T_co, SurfacePart]):
    """The places of a surface at which something holds: points, each once, and `everywhere` parts of patches.
    `undecided` are rectangles of parameters in which there may be more. An answer with such a rectangle is not
    "nowhere".

    >>> from gmpy2 import mpq
    >>> from exactspline.numbers.intervals import Interval
    >>> unit = Box(Interval(mpq(0), mpq(1)), Interval(mpq(0), mpq(1)))
    >>> SurfacePlaces((), undecided=(unit,)), bool(SurfacePlaces((), undecided=(unit,)))
    (undecided in [0, 1] × [0, 1], True)
    """

    undecided: tuple[Box, ...] = ()

    def __bool__(self) -> bool:
        return super().__bool__() or bool(self.undecided)

    def _parts(self) -> list[str]:
        return super()._parts() + [f"undecided in {SurfacePart((0, 0), box)}" for box in self.undecided]
