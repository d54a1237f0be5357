"""Numbers known only as balls: angles in degrees, arc lengths; enclosed by rational numbers, by FLINT's balls."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial, reduce
from itertools import pairwise
from math import comb

from flint import acb, acb_poly, arb, arb_poly, ctx, fmpq, fmpq_poly

from exactspline.errors import ExactSplineError
from exactspline.exact import mpq, to_fmpq
from exactspline.geometry.analysis import analyse
from exactspline.geometry.angles import Angle
from exactspline.geometry.curvature import polynomial_root
from exactspline.roots.enclosure import Bounds
from exactspline.roots.real import Real
from exactspline.splines.bernstein import zero_on_segment
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surd import Surd, parts, square_root

#: Digits after the point up to which a ball is refined to decide a question.
MOST_DIGITS = 1500


class OpenError(ExactSplineError):
    """A question about a number that its ball leaves open."""


def degrees(angle: Angle) -> Real:
    """An angle in degrees, in (−180, 180].

    It is rational only for multiples of 30 and 45 degrees: cos² is rational, so Niven's theorem holds for twice the
    angle.

    >>> from exactspline.geometry.angles import angle_between
    >>> degrees(angle_between((mpq(1), mpq(0)), (mpq(1), mpq(1)))).exact
    mpq(45,1)
    >>> degrees(angle_between((mpq(1), mpq(0)), (mpq(3), mpq(4)))).double()
    53.13010235415598
    """
    squared = mpq(angle.cosine * angle.cosine)

    if 4 * squared in (0, 1, 2, 3, 4):
        return Real.of(round(float(_angle_ball(angle, 60).mid())))
    return of_ball(partial(_angle_ball, angle))


def _angle_ball(angle: Angle, bits: int) -> arb:
    return arb.atan2(_ball(angle.sine), _ball(angle.cosine)) * 180 / arb.pi()


def length(curve: Nurbs) -> Real:
    """The arc length; exact where ‖γ′‖ is a polynomial without a zero on every segment.

    >>> from exactspline import Nurbs
    >>> length(Nurbs(1, [0, 0, 1, 1], [(0, 0), (3, 4)])).exact
    mpq(5,1)
    >>> length(Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), (1, 1), (2, 0)])).double()
    2.295587149392638
    """
    velocity = analyse(curve).velocity
    squared = sum((x * x for x in velocity[1:]), start=velocity[0] * velocity[0])
    known = _exact_length(squared) if curve.polynomial else None
    if known is not None:
        return Real.of(known)
    return of_ball(partial(_length_ball, curve))


def _length_ball(curve: Nurbs, bits: int) -> arb:
    """The arc length in a ball: |g| √h / w² segment by segment, where γ′ = g u / w², h = ‖u‖² > 0."""
    velocity, breaks, total = analyse(curve).velocity, curve.breakpoints, arb(0)
    stops = [root.refine(bits * 3 // 10 + bits // 500 + 5) for root in analyse(curve).speed.zeros]
    for i, (a, b) in enumerate(pairwise(breaks)):
        parts_of = [_powers(x, i) for x in velocity]
        common = reduce(lambda p, q: p.gcd(q), parts_of)
        if not common:
            continue
        squared = sum(((p // common) ** 2 for p in parts_of), start=fmpq_poly())
        inside = [_between((low - a) / (b - a), (high - a) / (b - a)) for low, high in stops if a < low and high < b]
        for u, v in pairwise([arb(0), *inside, arb(1)]):
            total += abs(_integral(common, squared, _powers(curve.w, i), u, v)) * to_fmpq(b - a)
    return total


def of_ball(ball: Callable[[int], arb]) -> Real:
    """The number in a ball that shrinks with FLINT's precision; `OpenError` where a question needs too many digits."""
    return Real(None, partial(_enclosed, ball), partial(_compared, ball))


def _enclosed(ball: Callable[[int], arb], digits: int) -> tuple[mpq, mpq]:
    bits, wanted = 10 * digits // 3 + 40, mpq(1, 10**digits)
    while digits <= MOST_DIGITS and bits < 8 * MOST_DIGITS:
        with ctx.workprec(bits):
            found = ball(bits)
        if found.is_finite() and (ends := ball_ends(found)).high - ends.low <= wanted:
            return ends.low, ends.high
        bits *= 2
    raise OpenError(f"the ball leaves the answer open at {digits} digits", remedy="ask for an enclosure")


def _compared(ball: Callable[[int], arb], t: mpq) -> int:
    digits = 20
    while True:
        low, high = _enclosed(ball, digits)
        if not low <= t <= high:
            return 1 if low > t else -1
        digits *= 2


def ball_ends(ball: arb) -> Bounds:
    """The ends of a ball, exactly.

    >>> ball_ends(arb("1.5"))
    Bounds(low=mpq(3,2), high=mpq(3,2))
    """
    middle, radius = (_dyadic(*part.man_exp()) for part in (ball.mid(), ball.rad()))
    return Bounds(middle - radius, middle + radius)


def _dyadic(mantissa: object, exponent: object) -> mpq:
    m, e = int(mantissa), int(exponent)  # type: ignore[call-overload]  # FLINT's integers
    return mpq(m << e) if e >= 0 else mpq(m, 1 << -e)


def _ball(number: mpq | Surd) -> arb:
    coefficient, radicand = parts(number)
    return arb(to_fmpq(coefficient)) * arb(radicand).sqrt()


def _between(low: mpq, high: mpq) -> arb:
    """A ball that holds an interval."""
    return arb(to_fmpq(low)).union(arb(to_fmpq(high)))


def _powers(f: BSpline, i: int) -> fmpq_poly:
    """The polynomial of a segment in powers of its local parameter."""
    points, n = f.segments[i], max(f.degree, 0)
    differences = [
        comb(n, k) * sum(((-1) ** (k - j) * comb(k, j) * points[j] for j in range(k + 1)), start=mpq(0))
        for k in range(n + 1 if points else 0)
    ]
    return fmpq_poly([to_fmpq(c) for c in differences])


def _integral(common: fmpq_poly, squared: fmpq_poly, weight: fmpq_poly, low: arb, high: arb) -> arb:
    """``∫ common √squared / weight²``.

    ``squared`` has no real zeros, so it is a constant times factors (z − a)² + b²: of each of them FLINT's balls give a
    narrow enclosure, of the expanded polynomial they do not.
    """
    factor, bottom = acb_poly(arb_poly(common)), acb_poly(arb_poly(weight))
    integers = squared.numer()
    constant = arb(integers.leading_coefficient() / fmpq(squared.denom())).sqrt()
    roots: list[tuple[acb, int]] = integers.complex_roots()  # type: ignore[assignment]  # flint says a single one
    pairs = [(root.real, root.imag**2, times) for root, times in roots if root.imag > 0]

    def speed(z: acb, analytic: bool) -> acb:
        value = factor(z) / bottom(z) ** 2
        for a, b, times in pairs:
            value *= ((z - a) ** 2 + b).sqrt(analytic=analytic) ** times
        return value

    return acb.integral(speed, acb(low), acb(high), eval_limit=20_000).real * constant


def _exact_length(squared: BSpline) -> mpq | Surd | None:
    """``∫ √squared`` where it is a constant times a square without zeros on every segment."""
    total: mpq | Surd = mpq(0)
    for a, b in pairwise(squared.breakpoints):
        found = polynomial_root(squared.restrict(a, b))
        if found is None or zero_on_segment(found[0].polynomials[0], found[0].degree) is not None:
            return None
        points = found[0].control_points
        part: mpq | Surd = square_root(found[1]) * abs(sum(points, start=mpq(0)) / len(points) * (b - a))
        if total == 0:
            total = part
        elif parts(total)[1] != parts(part)[1]:
            return None
        else:
            coefficient, radicand = parts(total)[0] + parts(part)[0], parts(part)[1]
            total = coefficient if radicand == 1 else Surd(coefficient, radicand)
    return total
