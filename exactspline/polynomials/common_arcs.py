"""Common points and arcs of two segments: the types, and the arcs of two curves that run along one curve."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Protocol

from flint import arb, arb_poly, fmpz_poly

from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval
from exactspline.polynomials.bernstein import ONE, quotient_slope
from exactspline.polynomials.factors import greatest_common_divisor
from exactspline.polynomials.isolation import isolate
from exactspline.polynomials.refinement import sign_at
from exactspline.polynomials.zero_places import FIRST, Place, at


@dataclass(frozen=True)
class RationalMap:
    """``s = z/(1 + z)`` with ``z = top(t)/bottom(t)``: two forms of one degree in t."""

    degree: int
    top: fmpz_poly
    bottom: fmpz_poly

    def __reduce__(self) -> tuple[object, ...]:
        return _map, (self.degree, [int(x) for x in self.top.coeffs()], [int(x) for x in self.bottom.coeffs()])

    @property
    def map(self) -> RationalMap:
        """Itself."""
        return self

    def near(self, place: Place, bits: int) -> arb | None:
        """A ball around ``top/bottom`` at a place below 1; None if it is not known to be finite."""
        z = place.z(bits)
        value = arb_poly(self.top)(z) / arb_poly(self.bottom)(z)
        return value if value.is_finite() else None

    @property
    def slope(self) -> fmpz_poly:
        """``top′ bottom − top bottom′``, a form of degree ``2 degree − 2`` with the sign of the derivative."""
        return quotient_slope(self.top, self.bottom)

    def at(self, place: Place) -> Local:
        """The value at a place where it is in [0, 1]."""
        if place.sign(self.top, self.degree) == 0:
            return at(mpq(0))
        return Image(place, self) if place.sign(self.bottom, self.degree) else at(mpq(1))


def _map(degree: int, top: list[int], bottom: list[int]) -> RationalMap:
    return RationalMap(degree, fmpz_poly(top), fmpz_poly(bottom))


class Mapping(Protocol):
    """What has a map, possibly computed only when it is needed."""

    @property
    def map(self) -> RationalMap:
        """The map."""

    def near(self, place: Place, bits: int) -> arb | None:
        """A ball around ``top/bottom`` at a place below 1; None if it is not known to be finite."""


@dataclass(frozen=True)
class Image:
    """The parameter of one curve that belongs to a parameter of the other: the value of a map at a place."""

    place: Place
    by: Mapping
    #: An interval that contains it, where one is known.
    known: Interval | None = None

    @property
    def map(self) -> RationalMap:
        """The map; its forms may have common zeros elsewhere."""
        return self.by.map

    def z(self, bits: int) -> arb | None:
        """A ball around ``z = s/(1 − s)``, from a place known to this many bits; None if it is not known to be finite.
        FLINT's precision is the caller's.
        """
        return self.by.near(self.place, bits)


#: The local parameter of a common point on one of the curves.
Local = Place | Image


@dataclass(frozen=True)
class Meeting:
    """One common point of two segments: the parameters on both, and the intersection multiplicity of the two branches
    (None where the curves are arcs of one curve and continue each other).
    """

    first: Local
    second: Local
    multiplicity: int | None

    def exchanged(self) -> Meeting:
        """The same with the curves exchanged."""
        return Meeting(self.second, self.first, self.multiplicity)


@dataclass(frozen=True)
class Arc:
    """A common arc, along which both parameters are monotone: those of both curves at its two ends, in the order of
    the second, and the map from the second to the first. With `exchanged` the map is from the first to the second;
    without a map the two are not rational functions of each other.
    """

    first: tuple[Local, Local]
    second: tuple[Local, Local]
    map: RationalMap | None
    exchanged: bool = False


@dataclass(frozen=True)
class Rest:
    """One of the curves is a single point: that of the other one at a place (None where both are the same point)."""

    place: Place | None
    exchanged: bool = False


@dataclass
class Meetings:
    """All common points, all common arcs, and the parameters of the other curve at a curve that is a single point."""

    points: list[Meeting] = field(default_factory=list)
    arcs: list[Arc] = field(default_factory=list)
    rests: list[Rest] = field(default_factory=list)

    def exchanged(self) -> Meetings:
        """The same with the curves exchanged."""
        return Meetings(
            [point.exchanged() for point in self.points],
            [Arc(arc.second, arc.first, arc.map, not arc.exchanged) for arc in self.arcs],
            [replace(rest, exchanged=not rest.exchanged) for rest in self.rests],
        )


def lowest_terms(given: RationalMap) -> RationalMap:
    """The map without common factors of its forms.

    >>> lowest_terms(RationalMap(2, fmpz_poly([0, 2, 2]), fmpz_poly([2, 4, 2])))
    RationalMap(degree=1, top=x, bottom=x + 1)
    """
    common = greatest_common_divisor([given.top, given.bottom])
    top, bottom = given.top // common, given.bottom // common
    return RationalMap(max(top.degree(), bottom.degree()), top, bottom)


def common_arcs(carried: RationalMap, *, below: bool = False) -> Meetings:
    """The arcs on which a map, in lowest terms and not constant, takes values in [0, 1], and the single points where it
    does; the map is monotone on each arc. With `below` only those whose values are less than the parameter.

    >>> found = common_arcs(RationalMap(1, fmpz_poly([-1, 1]), fmpz_poly([1])))  # z − 1
    >>> [(arc.second[0].exact, arc.second[1].exact) for arc in found.arcs], found.points
    ([(mpq(1,2), mpq(1,1))], [])
    """
    inside = carried.top * carried.bottom
    # the sign of (value − parameter), a form of even degree
    excess = (carried.top - carried.bottom.left_shift(1)) * carried.bottom if below else fmpz_poly([-ONE])
    product = inside * carried.slope * excess
    marks = [at(mpq(0)), *(Place(zero) for zero in isolate(product, product.degree()).inner), at(mpq(1))]
    on = [sign_at(inside, t) > 0 > sign_at(excess, t) for t in (rational_between(a, b) for a, b in pairwise(marks))]
    found = Meetings()
    for place, before, behind in zip(marks, [False, *on], [*on, False], strict=True):
        single = not before and not behind and place.sign(inside, 2 * carried.degree) == 0
        if single and (not below or place.sign(excess, 2 * carried.degree + 1) < 0):
            found.points.append(Meeting(carried.at(place), place, None))
    for (a, b), holds in zip(pairwise(marks), on, strict=True):
        if holds:
            found.arcs.append(Arc((carried.at(a), carried.at(b)), (a, b), carried))
    return found


def rational_between(a: Place, b: Place) -> mpq:
    """A rational parameter between two isolated zeros of one polynomial."""
    bits = FIRST
    while not (low := a.refine(bits).high) < (high := b.refine(bits).low):
        bits *= 2
    return (low + high) / 2
