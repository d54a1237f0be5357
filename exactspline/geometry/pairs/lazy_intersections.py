"""The common points of two segments that are decided in doubles: exact numbers, which are refined on demand."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

from flint import fmpz_poly

from exactspline.numbers.intervals import UNIT, Interval
from exactspline.numbers.once import cached_property
from exactspline.polynomials.bezout import PlaneForms
from exactspline.polynomials.common_arcs import Image, Local, Meeting
from exactspline.polynomials.isolation import LocalPolynomial, LocalZero
from exactspline.polynomials.plane_pairs import (
    IDENTITY,
    Elimination,
    elimination,
    meetings,
    self_elimination,
    self_meetings,
)
from exactspline.polynomials.zero_places import Place
from exactspline.programs.certain_pairs import PairPoint
from exactspline.reals.real import Real
from exactspline.roots.root import InDoubles, LazyRoot, root_inside
from exactspline.roots.segment_forms import ImageValue, SegmentRows, forms_of, parameter

#: The digits with which a common point is first compared with a box.
FEW = 20


@dataclass
class PairForm:
    """Bézout's determinant of two segments, and the map of the parameter; of a segment and itself the determinant
    without the pairs of equal parameters, which are not common points.
    """

    first: SegmentRows
    second: SegmentRows

    @property
    def exchanged(self) -> bool:
        """Whether the second segment has the lower degree, so that its parameter is eliminated."""
        return self.first[0] > self.second[0]

    @cached_property
    def _segments(self) -> list[PlaneForms]:
        """The forms of both segments in the degrees in which they are given."""
        return [PlaneForms(n, *(fmpz_poly([*c]) for c in rows)) for n, rows in (self.first, self.second)]

    @cached_property
    def elimination(self) -> Elimination:
        """The matrix of the curve of lower degree."""
        if self.first == self.second:
            return self_elimination(self._segments[0])
        return elimination(*self._segments[:: -1 if self.exchanged else 1])

    @cached_property
    def form(self) -> LocalPolynomial:
        """The determinant."""
        determinant = self.elimination.determinant
        return LocalPolynomial(determinant // determinant.content())

    @cached_property
    def inner(self) -> list[LocalZero]:
        """The zeros of the determinant inside the segment, by exact arithmetic."""
        return self.elimination.isolation.inner

    @cached_property
    def points(self) -> list[Meeting]:
        """The common points, by exact arithmetic; there are no arcs in common."""
        one, other = (PlaneForms(n, *forms) for n, forms in map(forms_of, (self.first, self.second)))
        return (self_meetings(one) if self.first == self.second else meetings(one, other)).points

    def parameters(
        self, found: PairPoint, near: Sequence[float], first: Interval, second: Interval
    ) -> tuple[Real, Real]:
        """The parameters of a common point of the segments over two intervals; `near` are its numbers for
        `InDoubles`.
        """
        known = InDoubles(found[:2], near[:4], first), InDoubles(found[2:4], near[4:], second)
        if found[5] < 0:
            one, other = (partial(self._image_in, known, k) for k in (0, 1))
            return ImageValue(one, first, second, known[0]), ImageValue(other, second, first, known[1])
        k, sides = 0 if self.exchanged else 1, (first, second)
        zero = LazyRoot(self, int(found[5]), int(found[4]), known[k].interval, known[k].near, sides[k])
        root = root_inside(zero, sides[k])
        image = ImageValue(lambda: Image(Place(zero), self.elimination), sides[1 - k], sides[k], known[1 - k])
        return (root, image) if self.exchanged else (image, root)

    def _image_in(self, box: Sequence[InDoubles], k: int) -> Image:
        """A parameter of the only common point in a box, by exact arithmetic."""
        found, digits = [(point.first, point.second) for point in self.points], FEW
        while len(found) > 1:
            found = [point for point in found if all(map(partial(_may_be_in, digits), box, point))]
            digits *= 2
        (point,) = found
        return local if isinstance(local := point[k], Image) else Image(local, IDENTITY)


def _may_be_in(digits: int, known: InDoubles, local: Local) -> bool:
    """Whether an enclosure with this many digits leaves a parameter in an interval."""
    return parameter(local, *UNIT).enclosure(digits).meets(Interval(known.low, known.high))
