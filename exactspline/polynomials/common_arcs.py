"""Common points and arcs of two segments: the types, and the common arcs of two curves that are parts of the same
curve.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cmp_to_key
from itertools import pairwise
from typing import NamedTuple, Protocol

from flint import arb, arb_poly, ctx, fmpq_poly, fmpz_poly

from exactspline.numbers.exact import mpq, to_fmpq, to_fmpz
from exactspline.polynomials.bernstein import ONE, quotient_slope, value
from exactspline.polynomials.bezout import PlaneForms
from exactspline.polynomials.elimination import linear, quotient_at, resultant
from exactspline.polynomials.factors import factorize, greatest_common_divisor
from exactspline.polynomials.isolation import Isolation, isolate
from exactspline.polynomials.zero_places import FIRST, SUSPICIOUS, Place, at, places, sign_at


@dataclass(frozen=True)
class RationalMap:
    """``s = z/(1 + z)`` with ``z = top(t)/bottom(t)``: two forms of the same degree in t."""

    degree: int
    top: fmpz_poly
    bottom: fmpz_poly

    def __reduce__(self) -> tuple[object, ...]:
        return _map, (self.degree, [int(x) for x in self.top.coeffs()], [int(x) for x in self.bottom.coeffs()])

    @property
    def map(self) -> RationalMap:
        """The map itself."""
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
        """The value at a place, where it must be in [0, 1]."""
        if place.sign(self.top, self.degree) == 0:
            return at(mpq(0))
        return Image(place, self) if place.sign(self.bottom, self.degree) else at(mpq(1))


def _map(degree: int, top: list[int], bottom: list[int]) -> RationalMap:
    return RationalMap(degree, fmpz_poly(top), fmpz_poly(bottom))


class Mapping(Protocol):
    """An object with a map, which may be computed only when needed."""

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

    @property
    def map(self) -> RationalMap:
        """The map; its forms may have common zeros elsewhere."""
        return self.by.map

    def z(self, bits: int) -> arb | None:
        """A ball around ``z = s/(1 − s)``, from a place known to this many bits; None if it is not known to be finite.
        The caller sets FLINT's precision.
        """
        return self.by.near(self.place, bits)


#: The local parameter of a common point on one of the curves.
Local = Place | Image


@dataclass(frozen=True)
class Meeting:
    """One common point of two segments: the parameters on both, and the intersection multiplicity of the two branches
    (None if the curves are arcs of the same curve and continue each other).
    """

    first: Local
    second: Local
    multiplicity: int | None

    def exchanged(self) -> Meeting:
        """The result for the exchanged curves."""
        return Meeting(self.second, self.first, self.multiplicity)


@dataclass(frozen=True)
class Arc:
    """A common arc, along which both parameters are monotone: the parameters of both curves at its two ends, in the
    order of the second parameter, and the map from the second parameter to the first. With `exchanged` the map is from
    the first to the second; without a map the parameters are not rational functions of each other.
    """

    first: tuple[Local, Local]
    second: tuple[Local, Local]
    map: RationalMap | None
    exchanged: bool = False


@dataclass(frozen=True)
class Rest:
    """The case that one of the curves is a single point, which is the point of the other curve at a place (None if both
    curves are the same point).
    """

    place: Place | None
    exchanged: bool = False


@dataclass
class Meetings:
    """All common points, all common arcs and, for a curve that is a single point, the parameters of the other curve at
    this point.
    """

    points: list[Meeting] = field(default_factory=list)
    arcs: list[Arc] = field(default_factory=list)
    rests: list[Rest] = field(default_factory=list)

    def exchanged(self) -> Meetings:
        """The result for the exchanged curves."""
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
    """The arcs on which a map, in lowest terms and not constant, takes values in [0, 1], and the single points at which
    it does; the map is monotone on each arc. With `below` only arcs and points whose values are less than the parameter
    are returned.

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


# ---- on one line


def collinear_arcs(first: PlaneForms, second: PlaneForms | None = None) -> Meetings:
    """The common arcs of two straight curves on the same line, and their common ends that are not on an arc. Without a
    second curve, the common arcs of different parts of the first curve, the earlier part first.

    >>> there, back = fmpz_poly([0, 2, 2]), fmpz_poly([0, 4])
    >>> w, zero = fmpz_poly([1, 2, 1]), fmpz_poly([])
    >>> found = collinear_arcs(PlaneForms(2, there, zero, w), PlaneForms(2, back, zero, w))
    >>> [[x.exact for x in (*arc.first, *arc.second)] for arc in found.arcs][0]
    [mpq(0,1), mpq(1,2), mpq(0,1), mpq(1,2)]
    """
    axis = next(k for k in (0, 1) if RationalMap(first.degree, first.forms[k], first.w).slope)
    found = Meetings()
    runs = [_runs(RationalMap(curve.degree, curve.forms[axis], curve.w)) for curve in (first, second or first)]
    for i, ours in enumerate(runs[0]):
        for theirs in runs[1] if second else runs[1][i + 1 :]:
            low, high = max(ours.low, theirs.low, key=IN_ORDER), min(ours.high, theirs.high, key=IN_ORDER)
            order = compared(low, high)
            if order < 0:
                values = (low, high) if theirs.rises else (high, low)
                s, t = ((run.parameter(values[0]), run.parameter(values[1])) for run in (ours, theirs))
                found.arcs.append(Arc(s, t, None))
            elif order == 0:
                # both curves end or turn back there: then all runs around the point are on the same side
                one, other = ours.parameter(low), theirs.parameter(low)
                if not any(point.first is one and point.second is other for point in found.points):
                    found.points.append(Meeting(one, other, None))
    return found


class Coordinate(NamedTuple):
    """A quotient of forms at a place, such as the coordinate of a straight curve."""

    function: RationalMap
    place: Place

    @property
    def exact(self) -> mpq | None:
        """The value at a rational parameter."""
        t, f = self.place.exact, self.function
        return None if t is None else value((f.top, ONE), f.degree, t) / value((f.bottom, ONE), f.degree, t)

    def near(self, bits: int) -> arb:
        """A ball around the value; the caller sets FLINT's precision."""
        if (exact := self.exact) is not None:
            return arb(to_fmpq(exact))
        z = self.place.z(bits)
        return arb_poly(self.function.top)(z) / arb_poly(self.function.bottom)(z)

    def minimal_polynomial(self) -> fmpz_poly:
        """The irreducible polynomial with this zero."""
        if (exact := self.exact) is not None:
            return linear(exact)
        top, bottom = fmpq_poly(self.function.top), fmpq_poly(self.function.bottom)
        # for an irreducible polynomial it is a power of an irreducible one
        (base,) = factorize(quotient_at(self.place.irreducible, top, bottom)).bases
        return base


def compared(one: Coordinate, other: Coordinate) -> int:
    """The order of two coordinates, exactly.

    >>> square = RationalMap(2, fmpz_poly([0, 0, 1]), fmpz_poly([1]))
    >>> (root,) = isolate(fmpz_poly([-2, 0, 1]), 2).inner
    >>> [compared(Coordinate(square, Place(root)), Coordinate(square, at(t))) for t in (mpq(1, 2), mpq(2, 3))]
    [1, -1]
    >>> compared(Coordinate(square, Place(root)), Coordinate(square, Place(root)))
    0
    """
    if one.exact is not None and other.exact is not None:
        return (one.exact > other.exact) - (one.exact < other.exact)
    bits, shared = FIRST, None
    while True:
        with ctx.workprec(4 * bits):
            a, b = one.near(bits), other.near(bits)
            if not a.overlaps(b):  # a ball that is not finite overlaps all
                return 1 if a > b else -1
            if shared is not None and not arb_poly(shared.derivative())(a.union(b)).contains(0):
                return 0  # a polynomial has at most one zero where it is monotone
        if shared is None and bits >= SUSPICIOUS:
            p, q = one.minimal_polynomial(), other.minimal_polynomial()
            shared = p if p == q else None
        bits *= 2


IN_ORDER = cmp_to_key(compared)


class _Run(NamedTuple):
    """A part of a straight curve on which its coordinate is monotone."""

    start: Coordinate
    end: Coordinate
    rises: bool

    @property
    def low(self) -> Coordinate:
        """The least coordinate of the run."""
        return self.start if self.rises else self.end

    @property
    def high(self) -> Coordinate:
        """The greatest coordinate of the run."""
        return self.end if self.rises else self.start

    def parameter(self, at_value: Coordinate) -> Place:
        """The parameter at which the run has a given coordinate."""
        for end in (self.start, self.end):
            if end is at_value or compared(end, at_value) == 0:
                return end.place
        f, exact = self.start.function, at_value.exact
        for place in places(_preimages(f, at_value)):
            same = exact is not None or compared(Coordinate(f, place), at_value) == 0
            if same and _is_before(self.start.place, place) and _is_before(place, self.end.place):
                return place
        raise ArithmeticError("a monotone function takes all values between those at its ends")


def _preimages(f: RationalMap, at_value: Coordinate) -> Isolation:
    """The zeros of a form that vanishes at all parameters with a given value."""
    if (exact := at_value.exact) is not None:
        return isolate(f.top * to_fmpz(exact.denominator) - f.bottom * to_fmpz(exact.numerator), f.degree)
    g, modulus = at_value.function, at_value.place.irreducible
    rows = [f.top * g.bottom[k] - f.bottom * g.top[k] for k in range(max(g.top.degree(), g.bottom.degree()) + 1)]
    return isolate(resultant([fmpz_poly([c]) for c in modulus.coeffs()], rows), f.degree * modulus.degree())


def _is_before(one: Place, other: Place) -> bool:
    """Whether a place is before another one; the two places must differ."""
    bits = FIRST
    while True:
        (a, b), (c, d) = one.refine(bits), other.refine(bits)
        if b <= c or d <= a:
            return b <= c
        bits *= 2


def _runs(coordinate: RationalMap) -> list[_Run]:
    isolation = isolate(coordinate.slope, coordinate.slope.degree())
    turning = [zero for zero in isolation.inner if sum(zero.signs) == 0]
    turns = [Place(zero) for zero in turning]
    for place in turns:
        _ = place.rational  # now it is known if the place is rational
    ends = [Coordinate(coordinate, place) for place in (at(mpq(0)), *turns, at(mpq(1)))]
    # not the signs at parameters in between, where the slope may vanish without a change of sign
    signs = [isolation.signs[0], *(zero.signs[1] for zero in turning)]
    return [_Run(a, b, sign > 0) for (a, b), sign in zip(pairwise(ends), signs, strict=True)]
