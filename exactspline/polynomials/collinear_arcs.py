"""The common arcs of two straight curves of higher degree on one line, and of such a curve and itself: they may turn
back, at rational or irrational parameters.
"""

from __future__ import annotations

from functools import cmp_to_key
from itertools import pairwise
from typing import NamedTuple

from flint import arb, arb_poly, ctx, fmpq_poly, fmpz_poly

from exactspline.numbers.exact import mpq, to_fmpq, to_fmpz
from exactspline.polynomials.annihilating import linear, quotient_at
from exactspline.polynomials.bernstein import ONE, value
from exactspline.polynomials.bezout import PlaneForms
from exactspline.polynomials.common_arcs import Arc, Meeting, Meetings, RationalMap
from exactspline.polynomials.elimination import resultant
from exactspline.polynomials.factors import factorize
from exactspline.polynomials.isolation import Isolation, isolate
from exactspline.polynomials.zero_places import FIRST, SUSPICIOUS, Place, at, places


def collinear_arcs(first: PlaneForms, second: PlaneForms | None = None) -> Meetings:
    """The common arcs of two straight curves on one line, and their common ends that are on none; without a second
    curve those of different parts of the first, the earlier part first.

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
                # both end there, or turn back there: then none of the runs around it is on the other side
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
        """A ball around the value; FLINT's precision is the caller's."""
        if (exact := self.exact) is not None:
            return arb(to_fmpq(exact))
        z = self.place.z(bits)
        return arb_poly(self.function.top)(z) / arb_poly(self.function.bottom)(z)

    def minimal_polynomial(self) -> fmpz_poly:
        """The irreducible polynomial with this zero."""
        if (exact := self.exact) is not None:
            return linear(exact)
        top, bottom = fmpq_poly(self.function.top), fmpq_poly(self.function.bottom)
        # of an irreducible polynomial it is a power of one
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
        """Its least coordinate."""
        return self.start if self.rises else self.end

    @property
    def high(self) -> Coordinate:
        """Its greatest coordinate."""
        return self.end if self.rises else self.start

    def parameter(self, at_value: Coordinate) -> Place:
        """The parameter with a coordinate that it takes."""
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
    """The zeros of a form among which are all parameters with a value."""
    if (exact := at_value.exact) is not None:
        return isolate(f.top * to_fmpz(exact.denominator) - f.bottom * to_fmpz(exact.numerator), f.degree)
    g, modulus = at_value.function, at_value.place.irreducible
    rows = [f.top * g.bottom[k] - f.bottom * g.top[k] for k in range(max(g.top.degree(), g.bottom.degree()) + 1)]
    return isolate(resultant([fmpz_poly([c]) for c in modulus.coeffs()], rows), f.degree * modulus.degree())


def _is_before(one: Place, other: Place) -> bool:
    """Whether a place is before another one, from which it differs."""
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
        _ = place.rational  # then it is known where it is rational
    ends = [Coordinate(coordinate, place) for place in (at(mpq(0)), *turns, at(mpq(1)))]
    # not the signs at parameters between: the slope may vanish there without a change of sign
    signs = [isolation.signs[0], *(zero.signs[1] for zero in turning)]
    return [_Run(a, b, sign > 0) for (a, b), sign in zip(pairwise(ends), signs, strict=True)]
