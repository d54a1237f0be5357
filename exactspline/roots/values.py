"""Exact values and signs of splines, and of quotients of splines, at irrational numbers.

The interval of a root yields bounds on the values there (`bounds_over`), which converge as it shrinks: the root is
refined until the requested digits are certain. A sign that is not decided by bounds is decided by a greatest common
divisor.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import overload

from flint import fmpq_poly, fmpz_poly

from exactspline.errors import DomainError
from exactspline.numbers.exact import Number, mpq, mpz, rational, sign, text
from exactspline.numbers.intervals import Interval, quotient, rounded_outwards
from exactspline.numbers.once import fill
from exactspline.numbers.sides import Side
from exactspline.polynomials import elimination
from exactspline.polynomials.bernstein import over_common_denominator
from exactspline.polynomials.zero_places import bounds_over
from exactspline.reals.real import UNASKED, Real, square_root
from exactspline.splines.bspline import BSpline, in_powers
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of


class ValueAt(Real):
    """``top/bottom`` at an irrational number where the denominator is not zero.

    >>> from exactspline import BSpline, zeros
    >>> t = BSpline.identity(0, 2)
    >>> value = ValueAt(t * t * t, t.constant(1), zeros(t * t - 2).roots[0])
    >>> float(value), value.minimal_polynomial(), value == 2 * square_root(2)
    (2.8284271247461903, [-8, 0, 1], True)
    """

    __slots__ = ("bottom", "place", "top")
    top: BSpline
    bottom: BSpline
    place: Real

    def __init__(self, top: BSpline, bottom: BSpline, place: Real) -> None:
        fill(self, top=top, bottom=bottom, place=place, **UNASKED)

    def __reduce__(self) -> tuple[object, ...]:
        return ValueAt, (self.top, self.bottom, self.place)

    def _enclosed(self, digits: int) -> Interval:
        def bounds(low: mpq, high: mpq) -> Interval | None:
            above, below = _values_between(self.top, low, high), _values_between(self.bottom, low, high)
            return None if above is None or below is None or below.low <= 0 <= below.high else quotient(above, below)

        return _narrowed(bounds, self.place, digits)

    def _against_number(self, t: mpq) -> int:
        return sign_at(self.bottom, self.place) * sign_at(self.top - self.bottom.scaled(t), self.place)

    def _in_terms(self) -> tuple[Real | None, fmpq_poly, fmpq_poly]:
        i = segment_of(self.top, self.place)
        return self.place, in_powers(self.top, i), in_powers(self.bottom, segment_of(self.bottom, self.place))

    def _annihilator(self) -> fmpz_poly:
        return elimination.quotient_at(self.place._annihilator(), *self._in_terms()[1:])

    def _found(self) -> Real | None:
        place = self.place.in_closed_form()
        if place is None:
            return super()._found()
        top, bottom = (
            sum((place**k * rational(c) for k, c in enumerate(p.coeffs())), start=Real(0)) for p in self._in_terms()[1:]
        )
        return (top / bottom).in_closed_form()

    def _height(self) -> int:
        parts = over_common_denominator([(p.numer(), p.denom()) for p in self._in_terms()[1:]])[0]
        degree = max(p.degree() for p in parts)
        return degree * self.place._height() + max(p.height_bits() for p in parts) + degree.bit_length()


def value_at(top: BSpline, bottom: BSpline, place: mpq | Real, side: Side | str = Side.RIGHT) -> Real:
    """``top/bottom`` at a parameter where the denominator is not zero.

    >>> from exactspline import BSpline, zeros
    >>> t = BSpline.identity(0, 2)
    >>> value_at(t * t - 2, t, zeros(t * t - 2).roots[0]), value_at(t, t + 1, mpq(1))
    (<Real 0>, <Real 1/2>)
    """
    if not isinstance(place, Real):
        return Real(top(place, side) / bottom(place, side))
    return ValueAt(top, bottom, place) if sign_at(top, place) else Real(0)


def signed_root(sign: int, square: Real) -> Real:
    """``± √square`` with the given sign; 0 if the sign is 0.

    >>> signed_root(-1, Real(2))
    <Real -√2>
    """
    return square_root(square) * sign


@overload
def evaluate(function: BSpline, t: Number | Real, *, side: Side | str = Side.RIGHT) -> mpq | Real:
    """The value of a spline at a parameter."""


@overload
def evaluate(function: Nurbs, t: Number | Real, *, side: Side | str = Side.RIGHT) -> tuple[mpq | Real, ...]:
    """The point of a curve at a parameter."""


def evaluate(
    function: BSpline | Nurbs, t: Number | Real, *, side: Side | str = Side.RIGHT
) -> mpq | Real | tuple[mpq | Real, ...]:
    """The value of a spline, or the point of a curve, at a parameter: rational numbers at a rational parameter, `Real`
    numbers at an irrational `Root`.

    >>> from exactspline import BSpline, Nurbs, zeros
    >>> parabola = Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), ("1/2", 0), (1, 1)])
    >>> evaluate(parabola, "1/2")
    (mpq(1,2), mpq(1,4))
    >>> x, y = evaluate(parabola, zeros(parabola.p[1].scaled(2) - 1).roots[0])
    >>> x, y == "1/2", y == mpq(1, 2), x.decimal(30)
    (<Real √2/2>, False, True, '0.707106781186547524400844362105')
    >>> s = BSpline.identity(0, 2)
    >>> evaluate(s * s * s, zeros(s * s - 2).roots[0]), evaluate(s, "1/3")
    (<Real 2√2>, mpq(1,3))

    Raises `DomainError` outside the domain.
    """
    function = function if isinstance(function, BSpline) else curve_of(function)
    place = exact_place(t)
    if not isinstance(place, Real):
        return function(place, side)
    within(function.domain, place)
    if isinstance(function, BSpline):
        return value_at(function, function.constant(1), place)
    return tuple(value_at(x, function.w, place) for x in function.p)


def within(domain: Interval, place: Real) -> None:
    """Raise `DomainError` for an irrational number outside a domain."""
    a, b = domain
    if not a < place < b:
        raise DomainError(f"the root is outside the domain [{text(a)}, {text(b)}]", remedy="stay inside")


def exact_place(t: Number | Real) -> mpq | Real:
    """A parameter as a rational number if it is rational, otherwise unchanged."""
    if not isinstance(t, Real):
        return rational(t)
    return t if t.exact is None else t.exact


def _narrowed(bounds: Callable[[mpq, mpq], Interval | None], place: Real, digits: int) -> Interval:
    """Bounds at most ``10^−digits`` wide: the number is refined until the bounds over its interval (None if not yet
    known) are narrow enough.
    """
    precision, width = digits + 5, mpq(1, mpz(10) ** max(digits + 1, 0))
    while True:
        enclosure = bounds(*place.enclosure(precision))
        if enclosure is not None and enclosure.width <= 5 * width:
            return rounded_outwards(enclosure, max(digits + 1, 0))
        precision *= 2


def _values_between(f: BSpline, low: mpq, high: mpq) -> Interval | None:
    """Bounds of a spline on an interval inside one of its segments; None if a knot is inside the interval.

    >>> from exactspline import BSpline
    >>> low, high = _values_between(BSpline.bezier([0, 0, 1]), mpq(1, 2), mpq(5001, 10000))
    >>> low <= mpq(1, 4), mpq(5001, 10000) ** 2 <= high, high - low < mpq(1, 5000)
    (True, True, True)
    """
    i = _segment_between(f, low, high)
    if i is None:
        return None
    if f.degree < 0:
        return Interval(mpq(0), mpq(0))
    form = f.numerators[i], f.denominators[i]
    return Interval(*bounds_over(form, f.degree, f.mesh.local(i, low), f.mesh.local(i, high)))


def _segment_between(f: BSpline, low: mpq, high: mpq) -> int | None:
    """The index of the segment that contains an interval, or None."""
    breaks = f.mesh.breaks
    if low < breaks[0] or high > breaks[-1]:
        return None
    i = f.mesh.locate(low)
    return i if high <= breaks[i + 1] else None


def segment_of(f: BSpline, place: Real) -> int:
    """The index of the segment that contains an irrational number of the domain."""
    digits = 5
    while (segment := _segment_between(f, *place.enclosure(digits))) is None:
        digits *= 2
    return segment


def sign_at(f: BSpline, t: mpq | Real, side: Side | str = Side.RIGHT) -> int:
    """The exact sign of a spline at a parameter.

    >>> from exactspline import BSpline, zeros
    >>> t = BSpline.identity(0, 2)
    >>> root = zeros(t * t - 2).roots[0]
    >>> sign_at(t * t * t - 2 * t, root), sign_at(t - 1, root), sign_at(2 * t - 3, root)
    (0, 1, -1)
    """
    place = exact_place(t)
    if not isinstance(place, Real):
        return sign(f(place, side))
    digits, zero = 5, None
    while True:
        low, high = place.enclosure(digits)
        enclosure = _values_between(f, low, high)
        if enclosure is not None:
            if enclosure.low > 0 or enclosure.high < 0:
                return 1 if enclosure.low > 0 else -1
            if zero is None:
                zero = place.is_root_of(_segment_polynomial(f, f.mesh.locate(low)))
            if zero:
                return 0
        digits *= 2


def segment_polynomials(splines: Sequence[BSpline], i: int) -> list[fmpz_poly]:
    """The polynomials of a segment, in the parameter of the splines, times a common positive integer.

    >>> from exactspline import BSpline
    >>> segment_polynomials([BSpline.bezier([0, "1/2"]), BSpline.bezier([1, 1])], 0)
    [x, 2]
    """
    return over_common_denominator([(f.numer(), f.denom()) for f in (in_powers(f, i) for f in splines)])[0]


def _segment_polynomial(f: BSpline, i: int) -> fmpz_poly:
    """A constant times the polynomial of a segment, in the parameter of the spline, with integer coefficients.

    >>> from exactspline import BSpline
    >>> _segment_polynomial(BSpline.bezier([0, 0, 1], 1, 3), 0)
    x^2 + (-2)*x + 1
    """
    p = in_powers(f, i).numer()
    return p // p.content() if p else p
