"""Integrals of rational functions over [0, 1], in closed form where no logarithms occur and the zeros of the
denominator are rational or complex quadratic: integrals of circular and elliptic arcs are ``a + b θ`` with angles θ.

Sources: Bronstein, Symbolic Integration I, §2.2 (Hermite's reduction); Baker, Transcendental Number Theory, Theorem 2.2
(a sum of logarithms of algebraic numbers with algebraic coefficients is 0 or transcendental).
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TypeAlias

from flint import acb, acb_poly, arb, arb_poly, ctx, fmpq_poly, fmpz_poly

from exactspline.errors import DomainError, OpenError, ShapeError
from exactspline.geometry.curves.facts import Facts
from exactspline.geometry.curves.kinds import JointKind
from exactspline.numbers.exact import mpq, rational, to_fmpq
from exactspline.numbers.intervals import ball_around
from exactspline.polynomials.bernstein import in_parameter
from exactspline.polynomials.cost import check_reach
from exactspline.polynomials.factors import factorize, greatest_common_divisor
from exactspline.questions.answers import NamedNumbers
from exactspline.questions.takes import QuestionError
from exactspline.reals.ball import InBalls, WithAngles
from exactspline.reals.real import Expression, Real, square_root, square_root_parts
from exactspline.splines.bspline import BSpline

#: The largest number of angles in a closed form.
MOST_ANGLES = 1000
#: The product of the degree and the bits of the coefficients up to which the complex zeros of a polynomial are isolated
#: in any case; and the number of bits by which the zeros of other polynomials must differ. FLINT isolates zeros in one
#: call that cannot be interrupted, and zeros close to each other take long (measured for degree 4: 7 ms for 270 bits, 3
#: s for 806, minutes for 1337).
NEAR, SEPARATING = 2000, 2048
#: The nanoseconds per square of the degree of a denominator and bit of its coefficients: with one irreducible factor
#: (measured: up to 60), with several factors, and the number of bits times the degree for each further nanosecond
#: (measured, for 64 to 400 bits of the factors: 0.1 to 120 s, at most 1.5 times as much).
ONE_FACTOR, SEVERAL, LONG = 60, 90, 800


def separate(p: fmpz_poly) -> bool:
    """Whether the distinct complex zeros are separated by arithmetic with a bounded number of bits."""
    if p.degree() * p.height_bits() <= NEAR:
        return True
    simple = p // greatest_common_divisor([p, p.derivative()])
    with ctx.workprec(SEPARATING + p.height_bits()):
        try:
            acb_poly(simple).roots(maxprec=SEPARATING)
        except ValueError:
            return False
    return True


def too_much(what: str) -> OpenError:
    """The error for a number whose enclosure takes too much work."""
    return OpenError(f"{what} takes too much work", remedy="ask for fewer digits, or for parts of the curve")


@dataclass(frozen=True)
class _Logarithmic:
    """``∫ top/bottom`` over [0, 1], by the coefficients of two polynomials, the second one irreducible: a sum of
    logarithms over its complex zeros, or an angle.
    """

    top: tuple[mpq, ...]
    bottom: tuple[mpq, ...]

    def ball(self) -> arb:
        """The integral, enclosed in the present precision; raises `OpenError` where isolating the zeros takes too much
        work.
        """
        top, bottom = (fmpq_poly([to_fmpq(c) for c in p]) for p in (self.top, self.bottom))
        if not separate(bottom.numer()):
            raise too_much("an integral")
        residues, slope = acb_poly(arb_poly(top)), acb_poly(arb_poly(bottom.derivative()))
        roots: list[tuple[acb, int]] = bottom.complex_roots()  # type: ignore[assignment]  # flint says a single one
        return sum((residues(z) / slope(z) * (1 - 1 / z).log() for z, _ in roots), start=acb(0)).real

    def angle(self) -> tuple[mpq, mpq, mpq, int] | None:
        """f, x, y, c such that the integral is ``f √c`` times the argument of ``x + y √−c``; None where logarithms
        occur.
        """
        if len(self.bottom) != 3 or len(self.top) != 1:
            return None
        low, middle, high = self.bottom
        square = 4 * low * high - middle * middle
        if square < 0:
            return None
        root, c = square_root_parts(square)
        x = 1 + middle * (middle + 2 * high) / square
        return 2 * self.top[0] * root / square, x, 2 * high * root / square, c


@dataclass(frozen=True)
class Term:
    """``factor · √radicand``, possibly times an integral."""

    factor: mpq
    radicand: int
    of: _Logarithmic | None = None

    def times(self, factor: mpq, radicand: int = 1) -> Term:
        """The term times a factor and a square root."""
        root, own = square_root_parts(mpq(self.radicand * radicand))
        return Term(self.factor * factor * root, own, self.of)

    def ball(self) -> arb:
        """The value of the term, enclosed in the present precision."""
        return arb(to_fmpq(self.factor)) * arb(self.radicand).sqrt() * (arb(1) if self.of is None else self.of.ball())


Terms: TypeAlias = tuple[Term, ...]


def in_local_powers(f: BSpline) -> list[fmpq_poly]:
    """The polynomials of a spline in powers of the local parameter of each segment, which runs from 0 to 1.

    >>> from exactspline import BSpline
    >>> in_local_powers(BSpline.bezier([0, 0, 1], 1, 3))
    [x^2]
    """
    n, forms = max(f.degree, 0), zip(f.numerators, f.denominators, strict=True)
    return [fmpq_poly(in_parameter(c, n, (mpq(0), mpq(1)))[0]) / m for c, m in forms]


def integral(top: fmpq_poly, base: fmpq_poly, n: int) -> Terms:
    """``∫ top/baseⁿ`` over [0, 1], where the denominator has no zero.

    >>> [term.of.angle() for term in integral(fmpq_poly([4]), fmpq_poly([1, 0, 1]), 1)]
    [(mpq(4,1), mpq(1,1), mpq(1,1), 1)]

    Raises `ReachError` if the integral may take too long.
    """
    bottom, powers = base**n, list(factorize(base.numer()).powers)
    size = bottom.degree() * bottom.numer().height_bits()
    cost = size * bottom.degree() * (ONE_FACTOR if len(powers) < 2 else SEVERAL + size // LONG)
    check_reach(cost, lambda: f"the integral of a function of degree {bottom.degree()}")
    terms = [Term(rational((top // bottom).integral()(1)), 1)]
    for factor, times in powers:
        p, m = fmpq_poly(factor), times * n
        value, left = _reduced(top * (bottom // p**m).xgcd(p**m)[1] % p**m, p, m)
        terms.append(Term(value, 1))
        if left:
            terms.append(Term(mpq(1), 1, _Logarithmic(*(tuple(map(rational, f.coeffs())) for f in (left, p)))))
    return tuple(term for term in terms if term.factor)


def _reduced(part: fmpq_poly, p: fmpq_poly, times: int) -> tuple[mpq, fmpq_poly]:
    """``∫ part/pⁿ`` over [0, 1] for an irreducible p, as a number and a polynomial that remains to be integrated over
    p: Hermite's reduction.
    """
    slope, value = p.derivative(), mpq(0)
    inverse = p.xgcd(slope)[2]
    carried, part = part % p, part // p
    for n in range(times - 1, 0, -1):
        factor = carried * inverse % p
        value += rational((factor(0) / p(0) ** n - factor(1) / p(1) ** n) / n)
        carried = (carried - factor * slope) // p + factor.derivative() / n + part % p
        part = part // p
    return value, carried


# ---- sums


def number(terms: Terms) -> Real:
    """The sum of terms as a number: in closed form if it contains angles only, and not too many, otherwise by
    enclosures.

    >>> number(integral(fmpq_poly([4]), fmpq_poly([1, 0, 1]), 1))
    <Real π>
    """
    by_balls, angles = partial(_sum_in_balls, terms), defaultdict[tuple[mpq, int, int], list[tuple[mpq, mpq]]](list)
    constant, of_pi, arcs = Real(0), Real(0), list[tuple[Real, Real]]()
    for term in terms:
        angle = term.of and term.of.angle()
        if angle and len(angles) < MOST_ANGLES:
            own, x, y, c = angle
            multiple = term.times(own, c)
            angles[abs(multiple.factor), multiple.radicand, c].append((x, y if multiple.factor > 0 else -y))
        elif term.of:
            return InBalls(by_balls)
        else:
            constant += square_root(term.radicand) * term.factor
    for (times, radicand, c), numbers in angles.items():
        turns, tangent = _together(numbers, c)
        factor = square_root(radicand) * times
        of_pi += factor * turns
        arcs += [] if tangent is None else [(factor, tangent)]
    if isinstance(constant, Expression) or isinstance(of_pi, Expression):
        return InBalls(by_balls)
    if not arcs and of_pi == 0:
        return constant
    with ctx.workprec(200):
        # a sum that is not 0 is transcendental
        may_vanish = _sum_in_balls(tuple(term for term in terms if term.of), 200).contains(0)
    return InBalls(by_balls) if may_vanish else WithAngles(by_balls, constant, of_pi, tuple(arcs))


def _together(numbers: Sequence[tuple[mpq, mpq]], c: int) -> tuple[mpq, Real | None]:
    """The sum of the arguments of numbers ``x + y √−c``: a multiple of π, and the tangent of the rest, if the rest is
    not 0. The sum is a rational multiple of π if and only if the 12th power of the product z of the numbers is real:
    then ``z/z̄`` is a root of unity in an imaginary quadratic field. The integers are certain, because there are few
    angles.
    """
    x, y, total, root = mpq(1), mpq(0), arb(0), arb(c).sqrt()
    for a, b in numbers:
        x, y = x * a - c * y * b, x * b + y * a
        total += arb.atan2(arb(to_fmpq(b)) * root, arb(to_fmpq(a)))
    real, imaginary = x * (x * x - 3 * c * y * y), y * (3 * x * x - c * y * y)
    if real * imaginary * (real * real - c * imaginary * imaginary) == 0:
        return rational((12 * total / arb.pi()).unique_fmpz() or 0) / 12, None
    tangent = square_root(c) * (y / x)
    rest = total - ball_around(*tangent.enclosure(30)).atan()
    return rational((rest / arb.pi()).unique_fmpz() or 0), tangent


def _sum_in_balls(terms: Terms, bits: int) -> arb:
    """A sum, enclosed in the present precision."""
    return sum((term.ball() for term in terms), start=arb(0))


# ---- area, moments, centroid


def moment(facts: Facts, i: int, j: int) -> Terms:
    """The terms of ``∬ xⁱ yʲ = ∮ xⁱ yʲ (x dy − y dx) / (i + j + 2)``.

    Raises `ShapeError` for a curve that is not closed, not in the plane, or has a gap.
    """
    _check_closed(facts)
    n, terms = i + j + 2, list[Term]()
    for parts in zip(*map(in_local_powers, (*facts.curve.p, facts.curve.w)), strict=True):
        common = greatest_common_divisor(parts)
        x, y, w = (p // common for p in parts)
        terms += integral(x**i * y**j * (x * y.derivative() - y * x.derivative()) / n, w, n)
    return tuple(terms)


def named_moments(moment_of: Callable[[int, int], Terms], order: int) -> tuple[NamedNumbers, ...]:
    """The moments with i + j up to an order; raises `QuestionError` for an order above 8."""
    if order > 8:
        raise QuestionError(f"moments of the order {order}", remedy="at most 8")
    pairs = [(i, total - i) for total in range(order + 1) for i in range(total, -1, -1)]
    return tuple(NamedNumbers("moment", {"moment": number(moment_of(i, j))}, {"x": i, "y": j}) for i, j in pairs)


def centroid(moment_of: Callable[[int, int], Terms]) -> tuple[NamedNumbers, ...]:
    """The centroid by moments; raises `DomainError` for the area 0."""
    area, *first = (number(moment_of(*powers)) for powers in ((0, 0), (1, 0), (0, 1)))
    if area.sign == 0:
        raise DomainError("the centroid of the area 0", remedy="an area that is not 0 has one")
    return (NamedNumbers("centroid", {axis: _quotient(x, area) for axis, x in zip("xy", first, strict=True)}),)


def _quotient(top: Real, bottom: Real) -> Real:
    """The quotient; it is a rational number if both numbers are ``a + b π`` and one is a multiple of the other."""
    if isinstance(top, WithAngles) and isinstance(bottom, WithAngles) and not top.arcs and not bottom.arcs:
        ratio = top.of_pi / bottom.of_pi
        if top.constant == ratio * bottom.constant:
            return ratio
    return top / bottom


def _check_closed(facts: Facts) -> None:
    curve = facts.curve
    if curve.dimension != 2 or not curve.closed:
        raise ShapeError("the area of a curve that is not closed and in the plane", where=curve.name, remedy="close it")
    if any(joint.kind is JointKind.GAP for joint in facts.joints):
        raise ShapeError("the area of a curve with a gap", where=curve.name, remedy="close the gap")
