"""Numbers known only by enclosures: angles in degrees and arc lengths, enclosed between rational numbers by FLINT's
ball arithmetic.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from itertools import pairwise
from math import comb
from typing import TypeAlias

from flint import acb, acb_poly, arb, arb_poly, ctx, fmpq, fmpq_poly, fmpz_poly

from exactspline.errors import OpenError, ReachError
from exactspline.geometry.curves.angles import Angle
from exactspline.geometry.curves.curvature import polynomial_root
from exactspline.geometry.curves.facts import facts_of
from exactspline.language.vector import norm2
from exactspline.numbers.exact import mpq, to_fmpq
from exactspline.numbers.intervals import ball_around
from exactspline.polynomials.factors import greatest_common_divisor
from exactspline.polynomials.isolation import zero_on_segment
from exactspline.reals.ball import InBalls
from exactspline.reals.real import Expression, Real, square_root
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs

#: The work allowed for one enclosure of an arc length, as `_Budget` counts it: a few seconds.
MOST_WORK = 4_000_000
TOO_MUCH = "ask for fewer digits, or for parts of the curve"


def degrees(angle: Angle) -> Real:
    """An angle in degrees, in (−180, 180].

    It is rational only for multiples of 30 and 45 degrees: cos² is rational, so Niven's theorem holds for twice the
    angle. Otherwise it is transcendental, by the theorem of Gelfond and Schneider: ``(−1)^(angle/180)`` is algebraic.

    >>> from exactspline.geometry.curves.angles import Angle
    >>> degrees(Angle((mpq(1), mpq(0)), (mpq(1), mpq(1))))
    <Real 45>
    >>> degrees(Angle((mpq(1), mpq(0)), (mpq(3), mpq(4)))).double()
    53.13010235415598
    """
    if 4 * angle.cosine * angle.cosine in (0, 1, 2, 3, 4):
        return Real(round(float(_angle_ball(angle, 60).mid())))
    return InBalls(partial(_angle_ball, angle), transcendental=True)


def _angle_ball(angle: Angle, bits: int) -> arb:
    sine, cosine = (ball_around(*x.enclosure(bits * 3 // 10 + 1)) for x in (angle.sine, angle.cosine))
    return arb.atan2(sine, cosine) * 180 / arb.pi()


def length(curve: Nurbs) -> Real:
    """The arc length; exact where ‖γ′‖ is a polynomial without a zero on every segment. A curve of many segments, a
    high degree or many digits may need too much work: operations on the number then raise `OpenError`.

    >>> from exactspline import Nurbs
    >>> length(Nurbs(1, [0, 0, 1, 1], [(0, 0), (3, 4)]))
    <Real 5>
    >>> length(Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), (1, 1), (2, 0)])).double()
    2.295587149392638
    """
    known = _exact_length(norm2(facts_of(curve).velocity)) if curve.polynomial else None
    return InBalls(partial(_length_ball, curve)) if known is None else known


def _length_ball(curve: Nurbs, bits: int) -> arb:
    """An enclosure of the arc length: |g| √h / w² segment by segment, where γ′ = g u / w², h = ‖u‖² > 0."""
    velocity, breaks, total = facts_of(curve).velocity, curve.breakpoints, arb(0)
    budget = _Budget(bits)
    # all segments in one pass: every access to them computes them anew
    weights, *columns = ([_powers(points, f.degree) for points in f.bezier_points] for f in (curve.w, *velocity))
    stops = [root.refine(bits * 3 // 10 + bits // 500 + 5) for root in facts_of(curve).speed.zeros]
    for i, (a, b) in enumerate(pairwise(breaks)):
        parts_of = [column[i] for column in columns]
        common = _common(parts_of)
        if not common:
            continue
        squared = sum(((p // common) ** 2 for p in parts_of), start=fmpq_poly())
        inside = [ball_around((low - a) / (b - a), (high - a) / (b - a)) for low, high in stops if a < low and high < b]
        for u, v in pairwise([arb(0), *inside, arb(1)]):
            total += abs(_integral(common, squared, weights[i], u, v, budget)) * to_fmpq(b - a)
    return total


def _common(polynomials: Sequence[fmpq_poly]) -> fmpq_poly:
    try:
        return greatest_common_divisor(polynomials)
    except ReachError as error:
        raise OpenError("the arc length takes too much work", remedy=TOO_MUCH) from error


def _powers(points: Sequence[mpq], degree: int) -> fmpq_poly:
    """The polynomial of a segment in powers of its local parameter."""
    n = max(degree, 0)
    differences = [
        comb(n, k) * sum(((-1) ** (k - j) * comb(k, j) * points[j] for j in range(k + 1)), start=mpq(0))
        for k in range(n + 1 if points else 0)
    ]
    return fmpq_poly([to_fmpq(c) for c in differences])


class _Budget:
    """The remaining work for one enclosure: every evaluation of the integrand is counted before it is made, inside
    FLINT's integration loop, which ends when an evaluation fails.
    """

    def __init__(self, bits: int) -> None:
        self.remaining = MOST_WORK
        self._words = 1 + bits // 100

    def take(self, terms: int) -> None:
        """Count an evaluation of this many terms; raises `OpenError` when the budget is exhausted."""
        self.remaining -= terms * self._words
        if self.remaining < 0:
            raise OpenError("the arc length takes too much work", remedy=TOO_MUCH)


def _integral(common: fmpq_poly, squared: fmpq_poly, weight: fmpq_poly, low: arb, high: arb, budget: _Budget) -> arb:
    """``∫ common √squared / weight²``, where ``squared`` has no real zeros."""
    integers = squared.numer()
    far = integers.degree() * integers.height_bits() <= NEAR or _separate(integers)
    root = _rooted(squared, budget) if far else _expanded(squared, budget)
    factor, bottom = acb_poly(arb_poly(common)), acb_poly(arb_poly(weight))

    def speed(z: acb, analytic: bool) -> acb:
        # the fixed cost of an evaluation
        budget.take(6)
        return factor(z) / bottom(z) ** 2 * root(z, analytic)

    bits = ctx.prec
    with ctx.workprec(bits + (0 if far else integers.height_bits())):
        return acb.integral(speed, acb(low), acb(high), rel_tol=arb((1, -bits)), eval_limit=20_000).real


#: The product of degree and bits of coefficients up to which the complex zeros of the squared speed are isolated
#: whatever they are, and the bits by which those of others must differ: FLINT isolates them in one call that cannot be
#: interrupted, and zeros near to each other take long (measured for degree 4: 7 ms for 270 bits, 3 s for 806, minutes
#: for 1337).
NEAR, SEPARATING = 2000, 2048
#: A square root as a function of a complex ball, analytic where this is asked for.
Root: TypeAlias = Callable[[acb, bool], acb]


def _separate(p: fmpz_poly) -> bool:
    """Whether the different complex zeros are separated in arithmetic of a bounded number of bits."""
    simple = p // greatest_common_divisor([p, p.derivative()])
    with ctx.workprec(SEPARATING + p.height_bits()):
        try:
            acb_poly(simple).roots(maxprec=SEPARATING)
        except ValueError:
            return False
    return True


def _rooted(squared: fmpq_poly, budget: _Budget) -> Root:
    """The faster one: ``√squared`` as a constant times roots of factors (z − a)² + b², each of which FLINT encloses
    narrowly.
    """
    integers = squared.numer()
    # measured, of Bézier curves: 80 to 400 nanoseconds for the cube of the degree, and more for long integers
    degree, bits = integers.degree(), integers.height_bits()
    budget.take(degree**3 * (1 + degree * bits // 100_000) // 2)
    constant = arb(integers.leading_coefficient() / fmpq(squared.denom())).sqrt()
    roots: list[tuple[acb, int]] = integers.complex_roots()  # type: ignore[assignment]  # flint says a single one
    pairs = [(root.real, root.imag**2, times) for root, times in roots if root.imag > 0]

    def root(z: acb, analytic: bool) -> acb:
        budget.take(len(pairs))
        value = acb(constant)
        for a, b, times in pairs:
            value *= ((z - a) ** 2 + b).sqrt(analytic=analytic) ** times
        return value

    return root


def _expanded(squared: fmpq_poly, budget: _Budget) -> Root:
    """The one whose cost does not depend on the zeros: ``√squared`` by the Taylor expansion at the centre of a ball."""
    degree = squared.degree()

    def root(z: acb, analytic: bool) -> acb:
        budget.take(degree**2)
        centre = acb(z.real.mid(), z.imag.mid())
        return acb_poly(arb_poly(squared))(acb_poly([centre, 1]))(z - centre).sqrt(analytic=analytic)

    return root


def _exact_length(squared: BSpline) -> Real | None:
    """``∫ √squared`` where it is a constant times a square without zeros on every segment, and these constants agree up
    to rational squares.
    """
    total = Real(0)
    for a, b in pairwise(squared.breakpoints):
        root = polynomial_root(squared.restrict(a, b))
        if root is None or zero_on_segment(root[0].numerators[0], root[0].degree) is not None:
            return None
        points = root[0].control_points
        total += square_root(root[1]) * abs(sum(points, start=mpq(0)) / len(points) * (b - a))
        if isinstance(total, Expression):
            return None
    return total
