"""Exact values and signs of splines, and of quotients of splines, at irrational numbers.

A ball around a root yields balls around the values there, which converge as the ball shrinks: the root is refined until
the requested digits are certain. If balls do not decide a sign, a greatest common divisor does.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import cast, overload

from flint import arb, ctx, fmpq_poly, fmpz_poly

from exactspline.errors import DomainError
from exactspline.numbers.exact import Number, mpq, mpz, rational, sign, text, to_fmpq
from exactspline.numbers.intervals import Interval, Side, ball_around, ball_ends
from exactspline.numbers.once import fill
from exactspline.polynomials import elimination
from exactspline.polynomials.bernstein import over_common_denominator, raiser
from exactspline.reals.algebraic import PRECISION
from exactspline.reals.real import UNASKED, Real, square_root
from exactspline.roots.root import Root
from exactspline.splines.bspline import BSpline, in_powers
from exactspline.splines.knots import Mesh
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of

#: The digits of a place with which balls begin that decide a sign, and those from which numbers are written; guard
#: bits in addition to those of the requested digits.
SHORT, WRITTEN, GUARD = 10, 20, 64


class ValueAt(Real):
    """``top/bottom`` at an irrational number where the denominator is not zero.

    >>> from exactspline import BSpline, zeros
    >>> t = BSpline.identity(0, 2)
    >>> value = ValueAt(t * t * t, t.constant(1), zeros(t * t - 2).roots[0])
    >>> float(value), value.minimal_polynomial(), value == 2 * square_root(2)
    (2.8284271247461903, [-8, 0, 1], True)
    """

    __slots__ = ("_ball", "bottom", "place", "top")
    top: BSpline
    bottom: BSpline
    place: Real
    #: The smallest ball computed so far.
    _ball: arb | None

    def __init__(self, top: BSpline, bottom: BSpline, place: Real) -> None:
        fill(self, top=top, bottom=bottom, place=place, _ball=None, **UNASKED)

    def __reduce__(self) -> tuple[object, ...]:
        return ValueAt, (self.top, self.bottom, self.place)

    def _enclosed(self, digits: int) -> Interval:
        known, unit = ball_ends(cast(arb, self._at_hand())), mpq(1, mpz(10) ** max(digits, 0))
        if known.width > unit:
            near, known = next(found for x in self._balls(digits) if (found := (x, ball_ends(x)))[1].width <= unit)
            fill(self, _ball=near)
        return known

    def _at_hand(self) -> arb | None:
        if self._ball is None:
            fill(self, _ball=next(self._balls(WRITTEN)))
        return self._ball

    def _balls(self, digits: int) -> Iterator[arb]:
        above, below = (_balls(f, self.place, digits + 5) for f in (self.top, self.bottom))
        for (bits, top), (_, bottom) in zip(above, below, strict=True):
            with ctx.workprec(bits):
                ball = top / bottom
            if ball.is_finite():
                yield ball

    def _against_number(self, t: mpq) -> int:
        if side := self._by_ball(lambda ball: sign(ball - to_fmpq(t))):
            return side
        low, high = self._enclosed(SHORT)
        if not low <= t <= high:
            return 1 if t < low else -1
        return sign_at(self.bottom, self.place) * sign_at(self.top - self.bottom.scaled(t), self.place)

    def _in_terms(self) -> tuple[Real | None, fmpq_poly, fmpq_poly]:
        i = segment_of(self.top, self.place)
        return self.place, in_powers(self.top, i), in_powers(self.bottom, segment_of(self.bottom, self.place))

    def _annihilator(self) -> fmpz_poly:
        return elimination.quotient_at(self.place._annihilator(), *self._in_terms()[1:])

    def _found(self) -> Real | None:
        local = self._in_local_parameter()
        if local and elimination.without_quadratic_zero(cast(Root, self.place).local_polynomial, *local):
            return None
        place = self.place.in_closed_form()
        if place is None:
            return super()._found()
        if local:
            low, high = cast(Interval, cast(Root, self.place).segment)
            place = (place - low) / (high - place)
        # the polynomials modulo that of the place are linear
        modulus = fmpq_poly(place._annihilator())
        rests = [fmpq_poly(p) % modulus for p in local or self._in_terms()[1:]]
        top, bottom = (place * rational(p[1]) + rational(p[0]) for p in rests)
        return (top / bottom).in_closed_form()

    def _in_local_parameter(self) -> list[fmpz_poly]:
        """Numerator and denominator as polynomials of ``z = t/(1 − t)``, where t is the local parameter of the place;
        empty where the segment of the place is not known.
        """
        parts = [(_segment_of_root(f.mesh, self.place), f) for f in (self.top, self.bottom)]
        highest, (above, below) = max(f.degree for _, f in parts), [f.denominators[i or 0] for i, f in parts]
        raised = [f.numerators[i] * raiser(highest - f.degree) for i, f in parts if i is not None]
        return [raised[0] * below, raised[1] * above] if len(raised) == 2 else []

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
    value = ValueAt(top, bottom, place)
    return value if value.sign else Real(0)


def signed_root(sign: int, square: Real) -> Real:
    """``± √square`` with the given sign; 0 if the sign is 0.

    >>> signed_root(-1, Real(2))
    <Real -√2>
    """
    root = square_root(square) if sign else Real(0)
    return root if sign >= 0 else -root


@overload
def evaluate(function: BSpline, t: Number | Real, *, side: Side | str = Side.RIGHT) -> mpq | Real:
    """The value of a spline at a parameter."""


@overload
def evaluate(function: Nurbs, t: Number | Real, *, side: Side | str = Side.RIGHT) -> tuple[mpq | Real, ...]:
    """The point of a curve at a parameter."""


def evaluate(
    function: BSpline | Nurbs, t: Number | Real, *, side: Side | str = Side.RIGHT
) -> mpq | Real | tuple[mpq | Real, ...]:
    """Return the value of a spline, or the point of a curve, at a parameter: as rational numbers for a rational
    parameter, as `Real` numbers for an irrational `Root`.

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
    inside = place.segment if isinstance(place, Root) else None
    if not (inside and domain.contains(inside)) and not a < place < b:
        raise DomainError(f"the root is outside the domain [{text(a)}, {text(b)}]", remedy="stay inside")


def exact_place(t: Number | Real) -> mpq | Real:
    """A parameter as a rational number if it is rational, otherwise unchanged."""
    if not isinstance(t, Real):
        return rational(t)
    return t if t.exact is None else t.exact


def _local_balls(mesh: Mesh, place: Real, digits: int = SHORT) -> Iterator[tuple[int, int, arb]]:
    """The segment that contains an irrational number, and balls around ``z = t/(1 − t)`` for its local parameter t,
    with the precision at which to use them: ever smaller ones, the first for about this many digits.
    """
    i, breaks = _segment_of_root(mesh, place), mesh.breaks
    if i is not None and (ball := cast(Root, place).ball) is not None:
        yield i, PRECISION, ball
    while True:
        low, high = place.enclosure(digits)
        i = mesh.locate(low) if breaks[0] <= low < breaks[-1] else None
        if i is not None and high < breaks[i + 1]:
            bits = 10 * digits // 3 + GUARD
            with ctx.workprec(bits):
                z = ball_around(*(x / (1 - x) for x in (mesh.local(i, low), mesh.local(i, high))))
            yield i, bits, z
        digits *= 2


def local_ball(mesh: Mesh, place: Real) -> tuple[int, arb] | None:
    """The segment that has an irrational root strictly inside, and a ball around ``z = t/(1 − t)`` for its local
    parameter t; None for other numbers and where it is not known.
    """
    return None if _segment_of_root(mesh, place) is None else next(_local_balls(mesh, place, WRITTEN))[::2]


def _segment_of_root(mesh: Mesh, place: Real) -> int | None:
    """The index of the segment of which a number is known to be a root inside; None where it is not known."""
    inside = place.segment if isinstance(place, Root) else None
    if inside is None or not mesh.breaks[0] <= inside.low < mesh.breaks[-1]:
        return None
    i = mesh.locate(inside.low)
    return i if mesh.breaks[i : i + 2] == inside else None


def _balls(f: BSpline, place: Real, digits: int = SHORT) -> Iterator[tuple[int, arb]]:
    """Balls around the value of a spline at an irrational number, ever smaller ones, with their precision."""
    for i, bits, z in _local_balls(f.mesh, place, digits):
        with ctx.workprec(bits):
            ball = f.numerators[i](z) / (1 + z) ** max(f.degree, 0) / f.denominators[i]
        yield bits, ball


def segment_of(f: BSpline, place: Real) -> int:
    """The index of the segment that contains an irrational number of the domain."""
    return next(_local_balls(f.mesh, place))[0]


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
    signs = (sign(ball) for _, ball in _balls(f, place))
    first = next(signs)
    if not first and place.is_root_of(_segment_polynomial(f, segment_of(f, place))):
        return 0
    return first or next(filter(None, signs))


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
