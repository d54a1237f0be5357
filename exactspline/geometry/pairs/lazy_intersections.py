"""The common points of two segments that are decided in doubles: exact numbers, which are refined on demand."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb, fmpz_poly

from exactspline.numbers.intervals import UNIT, Interval
from exactspline.numbers.once import cached_property
from exactspline.polynomials.bezout import PlaneForms
from exactspline.polynomials.common_arcs import Image, Meeting, RationalMap
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

    @property
    def map(self) -> RationalMap:
        """The eliminated parameter as a function of the other parameter."""
        return self.elimination.map

    def near(self, place: Place, bits: int) -> arb | None:
        """A ball around the value of the map."""
        return self.elimination.near(place, bits)

    def parameters(
        self, found: PairPoint, near: Sequence[float], first: Interval, second: Interval
    ) -> tuple[Real, Real]:
        """The parameters of a common point of the segments over two intervals; `near` are its numbers for
        `InDoubles`.
        """
        if found[5] < 0:
            point = BoxedPoint(self, (InDoubles(found[:2], near[:4], first), InDoubles(found[2:4], near[4:], second)))
            return ImageValue(LateImage(point, 0), first, second), ImageValue(LateImage(point, 1), second, first)
        one, other, sides = (found[:2], near[:4]), (found[2:4], near[4:]), (first, second)
        if not self.exchanged:
            one, other, sides = other, one, (second, first)
        zero = LazyRoot(self, int(found[5]), int(found[4]), *one, sides[0])
        root = root_inside(zero, sides[0])
        image = ImageValue(Image(Place(zero), self, InDoubles(*other, sides[1])), sides[1], sides[0])
        return (root, image) if self.exchanged else (image, root)


@dataclass
class BoxedPoint:
    """A common point that was found without the determinant, the only one in a box of doubles."""

    pair: PairForm
    box: tuple[InDoubles, InDoubles]

    @cached_property
    def exactly(self) -> tuple[Image, Image]:
        """Both parameters in exact arithmetic."""
        found, digits = self.pair.points, FEW
        while len(found) > 1:
            found, digits = [point for point in found if self._may_be(point, digits)], 2 * digits
        (point,) = found
        one, other = (x if isinstance(x, Image) else Image(x, IDENTITY) for x in (point.first, point.second))
        return one, other

    def _may_be(self, point: Meeting, digits: int) -> bool:
        """Whether enclosures with this many digits leave a common point in the box."""
        places = (parameter(local, *UNIT).enclosure(digits) for local in (point.first, point.second))
        return all(place.meets(Interval(own.low, own.high)) for place, own in zip(places, self.box, strict=True))


@dataclass
class LateImage:
    """A parameter of such a point, with the attributes of an `Image`."""

    point: BoxedPoint
    k: int

    @property
    def local(self) -> InDoubles:
        """The parameter as it is known in doubles."""
        return self.point.box[self.k]

    @property
    def place(self) -> Place:
        """The place of which it is the image."""
        return self.point.exactly[self.k].place

    @property
    def map(self) -> RationalMap:
        """The map."""
        return self.point.exactly[self.k].map

    def z(self, bits: int) -> arb | None:
        """A ball around ``z = s/(1 − s)``, as for an `Image`."""
        return self.point.exactly[self.k].z(bits)
