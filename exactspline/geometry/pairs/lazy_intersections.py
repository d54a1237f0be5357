"""The common points of two segments that are certain in doubles: exact numbers, of which more is computed when it is
asked for.
"""

from __future__ import annotations

from dataclasses import dataclass

from flint import arb, fmpz_poly

from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval
from exactspline.numbers.once import cached_property
from exactspline.polynomials.bezout import PlaneForms
from exactspline.polynomials.common_arcs import Image, Meeting, RationalMap
from exactspline.polynomials.isolation import LocalPolynomial, LocalZero
from exactspline.polynomials.plane_pairs import Elimination, elimination
from exactspline.polynomials.zero_places import Place
from exactspline.programs.certain_pairs import PairPoint
from exactspline.roots.root import LazyRoot
from exactspline.roots.segment_forms import SegmentRows


@dataclass
class PairForm:
    """Bézout's determinant of two segments, and the map of the parameter."""

    first: PlaneForms
    second: PlaneForms

    @classmethod
    def of(cls, first: SegmentRows, second: SegmentRows) -> PairForm:
        """Of two segments in the degrees in which they are given."""
        return cls(*(PlaneForms(n, *(fmpz_poly([*c]) for c in rows)) for n, rows in (first, second)))

    @property
    def exchanged(self) -> bool:
        """Whether the parameter of the second, the one of lower degree, is eliminated."""
        return self.first.degree > self.second.degree

    @cached_property
    def elimination(self) -> Elimination:
        """The matrix of the curve of lower degree."""
        return elimination(*((self.second, self.first) if self.exchanged else (self.first, self.second)))

    @cached_property
    def form(self) -> LocalPolynomial:
        """The determinant."""
        determinant = self.elimination.determinant
        return LocalPolynomial(determinant // determinant.content())

    @cached_property
    def inner(self) -> list[LocalZero]:
        """Its zeros inside the segment, by exact arithmetic."""
        return self.elimination.isolation.inner

    @property
    def map(self) -> RationalMap:
        """The parameter that was eliminated as a function of the other."""
        return self.elimination.map

    def near(self, place: Place, bits: int) -> arb | None:
        """A ball around the value of the map."""
        return self.elimination.near(place, bits)

    def meeting(self, found: PairPoint) -> Meeting:
        """A common point."""
        place = Place(LazyRoot(self, found.number, found.before, (found.low, found.high)))
        meeting = Meeting(Image(place, self, Interval(*map(mpq, found.other))), place, 1)
        return meeting.exchanged() if self.exchanged else meeting
