"""The common points of two segments that are decided in doubles: exact numbers, which are refined on demand."""

from __future__ import annotations

from dataclasses import dataclass

from flint import arb, fmpz_poly

from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval
from exactspline.numbers.once import cached_property
from exactspline.polynomials.bezout import PlaneForms
from exactspline.polynomials.common_arcs import Image, RationalMap
from exactspline.polynomials.isolation import LocalPolynomial, LocalZero
from exactspline.polynomials.plane_pairs import Elimination, elimination, self_elimination
from exactspline.polynomials.zero_places import Place
from exactspline.programs.certain_pairs import PairPoint
from exactspline.reals.real import Real
from exactspline.roots.root import LazyRoot, Root, Shrinking, Shrunk
from exactspline.roots.segment_forms import ImageValue, SegmentRows


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
        if self.first is self.second:
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

    @property
    def map(self) -> RationalMap:
        """The eliminated parameter as a function of the other parameter."""
        return self.elimination.map

    def near(self, place: Place, bits: int) -> arb | None:
        """A ball around the value of the map."""
        return self.elimination.near(place, bits)

    @cached_property
    def _forms(self) -> list[tuple[fmpz_poly, fmpz_poly]]:
        """The six forms with their derivatives, first the forms of the first segment."""
        return [(f, f.derivative()) for segment in self._segments for f in segment.forms]

    def _closer(self, box: list[arb]) -> list[arb]:
        """A step towards the zero of ``x₁w₂ − x₂w₁`` and ``y₁w₂ − y₂w₁``."""
        middle = [ball.mid() for ball in box]
        x, y, w, u, v, q = (f(middle[k // 3]) for k, (f, _) in enumerate(self._forms))
        one, other = x * q - u * w, y * q - v * w
        around = [(f(box[k // 3]), slope(box[k // 3])) for k, (f, slope) in enumerate(self._forms)]
        (x, dx), (y, dy), (w, dw), (u, du), (v, dv), (q, dq) = around
        a, b, c, d = dx * q - u * dw, x * dq - du * w, dy * q - v * dw, y * dq - dv * w
        below = a * d - b * c
        return [middle[0] - (d * one - b * other) / below, middle[1] - (a * other - c * one) / below]

    def parameters(self, found: PairPoint, first: Interval, second: Interval) -> tuple[Real, Real]:
        """The parameters of a common point of the segments over two intervals."""
        interval, other, k = (found.low, found.high), (found.other_low, found.other_high), int(not self.exchanged)
        shrinking = Shrinking([interval, other][:: 1 - 2 * k], self._closer)
        zero = LazyRoot(self, int(found.number), int(found.before), interval, Shrunk(shrinking, k))
        image = Image(Place(zero), self, Interval(*map(mpq, other)), Shrunk(shrinking, 1 - k))
        if self.exchanged:
            return Root(None, None, (1, 1), zero.signs, zero, first), ImageValue(image, second, first)
        return ImageValue(image, first, second), Root(None, None, (1, 1), zero.signs, zero, second)
