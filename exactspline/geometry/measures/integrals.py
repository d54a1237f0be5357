"""Integrals of rational functions over [0, 1], in closed form where the denominator has rational zeros and pairs of
complex quadratic ones, without logarithms: those of circular and elliptic arcs are ``a + b θ`` with angles θ.

Sources: Bronstein, Symbolic Integration I, §2.2 (Hermite's reduction); Baker, Transcendental Number Theory, Theorem 2.2
(a sum of logarithms of algebraic numbers with algebraic coefficients is 0 or transcendental).
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TypeAlias

from flint import acb, acb_poly, arb, arb_poly, ctx, fmpq_poly, fmpz_poly

from exactspline.errors import OpenError
from exactspline.numbers.exact import mpq, rational, to_fmpq
from exactspline.numbers.intervals import ball_around
from exactspline.polynomials.bernstein import in_parameter
from exactspline.polynomials.cost import check_reach
from exactspline.polynomials.factors import factorize, greatest_common_divisor
from exactspline.reals.ball import InBalls, WithAngles
from exactspline.reals.real import Expression, Real, square_root, square_root_parts
from exactspline.splines.bspline import BSpline

#: The largest number of angles in a closed form.
MOST_ANGLES = 1000
#: The product of degree and bits of coefficients up to which the complex zeros of a polynomial are isolated whatever
#: they are, and the bits by which those of others must differ: FLINT isolates them in one call that cannot be
#: interrupted, and zeros near to each other take long (measured for degree 4: 7 ms for 270 bits, 3 s for 806, minutes
#: for 1337).
NEAR, SEPARATING = 2000, 2048
#: Nanoseconds for a bit of a denominator, for each of its degrees (measured: 0.2 to 3).
REDUCED = 5


def separate(p: fmpz_poly) -> bool:
    """Whether the different complex zeros are separated in arithmetic of a bounded number of bits."""
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
    """The error for a number of which no enclosure is in reach."""
    return OpenError(f"{what} takes too much work", remedy="ask for fewer digits, or for parts of the curve")


@dataclass(frozen=True)
class Logarithmic:
    """``∫ top/bottom`` over [0, 1], by the coefficients of two polynomials, the second one irreducible: a sum of
    logarithms over its complex zeros, or an angle.
    """

    top: tuple[mpq, ...]
    bottom: tuple[mpq, ...]

    def ball(self) -> arb:
        """It, enclosed in the present precision; raises `OpenError` where the zeros are out of reach."""
        top, bottom = (fmpq_poly([to_fmpq(c) for c in p]) for p in (self.top, self.bottom))
        if not separate(bottom.numer()):
            raise too_much("an integral")
        residues, slope = acb_poly(arb_poly(top)), acb_poly(arb_poly(bottom.derivative()))
        roots: list[tuple[acb, int]] = bottom.complex_roots()  # type: ignore[assignment]  # flint says a single one
        return sum((residues(z) / slope(z) * (1 - 1 / z).log() for z, _ in roots), start=acb(0)).real

    def angle(self) -> tuple[mpq, mpq, mpq, int] | None:
        """f, x, y, c such that it is ``f √c`` times the argument of ``x + y √−c``; None where there are logarithms."""
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
    """``factor · √radicand``, or that times an integral."""

    factor: mpq
    radicand: int
    of: Logarithmic | None = None

    def times(self, factor: mpq, radicand: int = 1) -> Term:
        """A multiple."""
        root, own = square_root_parts(mpq(self.radicand * radicand))
        return Term(self.factor * factor * root, own, self.of)

    def ball(self) -> arb:
        """Its value, enclosed in the present precision."""
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


def integral(top: fmpq_poly, bottom: fmpq_poly) -> Terms:
    """``∫ top/bottom`` over [0, 1], where the denominator has no zero.

    >>> [term.of.angle() for term in integral(fmpq_poly([4]), fmpq_poly([1, 0, 1]))]
    [(mpq(4,1), mpq(1,1), mpq(1,1), 1)]
    """
    cost = REDUCED * bottom.degree() ** 2 * bottom.numer().height_bits()
    check_reach(cost, lambda: f"the integral of a function of degree {bottom.degree()}")
    antiderivative = (top // bottom).integral()
    terms = [Term(rational(antiderivative(1) - antiderivative(0)), 1)]
    for base, times in factorize(bottom.numer()).powers:
        p = fmpq_poly(base)
        rest = bottom // p**times
        value, left = _reduced(top * rest.xgcd(p**times)[1] % p**times, p, times)
        terms.append(Term(value, 1))
        if left:
            coefficients = (tuple(rational(c) for c in each.coeffs()) for each in (left, p))
            terms.append(Term(mpq(1), 1, Logarithmic(*coefficients)))
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


def number(terms: Iterable[Term]) -> Real:
    """The sum as a number: in closed form where only finitely many angles are in it, otherwise by enclosures.

    >>> number(integral(fmpq_poly([4]), fmpq_poly([1, 0, 1])))
    <Real π>
    """
    given = tuple(terms)
    by_balls = partial(sum_in_balls, given)
    constants, of_pi, arcs = defaultdict[int, mpq](mpq), defaultdict[int, mpq](mpq), list[tuple[Real, Real]]()
    angles = defaultdict[tuple[mpq, int, int], list[tuple[mpq, mpq]]](list)
    for term in given:
        angle = term.of and term.of.angle()
        if angle and len(angles) < MOST_ANGLES:
            own, x, y, c = angle
            multiple = term.times(own, c)
            angles[abs(multiple.factor), multiple.radicand, c].append((x, y if multiple.factor > 0 else -y))
        elif term.of:
            return InBalls(by_balls)
        else:
            constants[term.radicand] += term.factor
    for (factor, radicand, c), numbers in angles.items():
        turns, tangent = _together(numbers, c)
        of_pi[radicand] += factor * turns
        arcs += [] if tangent is None else [(square_root(radicand) * factor, tangent)]
    constant, half = (_sum(each) for each in (constants, of_pi))
    if not arcs and half == 0 and not isinstance(constant, Expression):
        return constant
    with ctx.workprec(200):
        # what is not 0 is transcendental
        may_vanish = sum_in_balls(tuple(term for term in given if term.of), 200).contains(0)
    if may_vanish or isinstance(constant, Expression) or isinstance(half, Expression):
        return InBalls(by_balls)
    return WithAngles(by_balls, constant, half, tuple(arcs))


def _sum(multiples: dict[int, mpq]) -> Real:
    return sum((square_root(radicand) * factor for radicand, factor in multiples.items() if factor), start=Real(0))


def _together(numbers: Sequence[tuple[mpq, mpq]], c: int) -> tuple[mpq, Real | None]:
    """The sum of the arguments of numbers ``x + y √−c``: a multiple of π, and the tangent of the rest, if there is one.
    It is a rational multiple of π if and only if the 12th power of their product z is real: ``z/z̄`` is a root of unity
    in an imaginary quadratic field then. The integers are certain: there are few angles.
    """
    x, y, total, root = mpq(1), mpq(0), arb(0), arb(c).sqrt()
    for a, b in numbers:
        x, y = x * a - c * y * b, x * b + y * a
        total += arb.atan2(arb(to_fmpq(b)) * root, arb(to_fmpq(a)))
    real, imaginary = x * (x * x - 3 * c * y * y), y * (3 * x * x - c * y * y)
    if real * imaginary * (real * real - c * imaginary * imaginary) == 0:
        return _integer(12 * total / arb.pi()) / 12, None
    tangent = square_root(c) * (y / x)
    rest = total - ball_around(*tangent.enclosure(30)).atan()
    return _integer(rest / arb.pi()), tangent


def _integer(ball: arb) -> mpq:
    return rational(ball.unique_fmpz() or 0)


def sum_in_balls(terms: Terms, bits: int) -> arb:
    """A sum, enclosed in the present precision."""
    return sum((term.ball() for term in terms), start=arb(0))
