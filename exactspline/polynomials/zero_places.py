"""The place of an isolated zero of a form on its segment, and exact signs of other forms there.

Balls around the zero decide nearly every sign; a sign that is open after `SUSPICIOUS` bits is decided by a greatest
common divisor.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from flint import arb, arb_poly, ctx, fmpq, fmpz_poly

from exactspline.numbers.exact import mpq, mpz, ratio, sign, to_fmpq
from exactspline.numbers.exact import sign as sign_of
from exactspline.numbers.intervals import Interval
from exactspline.polynomials.factors import factorize, greatest_common_divisor
from exactspline.polynomials.isolation import Isolation, LocalPolynomial, LocalZero, Zero, end_signs

# ---- refinement
#
# The result of every step is proved. For a ball X with midpoint m, `N = m − g(m)/g′(X)` contains every zero of g in X,
# and if N is contained in the interior of X there is exactly one (interval Newton). Evaluations use FLINT's `arb`,
# whose results contain the exact value at any precision; the precision is set for each step, with guard bits according
# to the cancellation observed in the previous step. The sign at a rational parameter is computed in integers if balls
# do not decide it.
#
# All computations use `z = t/(1 − t)` or, in the right half of the segment, its reciprocal: evaluation in these
# variables is as well conditioned as in the Bernstein basis.
#
# Source: Moore, Interval Analysis, 1966; Johansson, Arb: efficient arbitrary-precision midpoint-radius interval
# arithmetic, IEEE Trans. Comput. 2017.


#: The initial working precision, and the guard bits of every later step.
START, GUARD = 64, 12
#: Up to this product of the degree and the bits of the parameter, a sign is computed directly in integers.
EXACTLY = 3000
#: The precision (bits) from which every step is stored; lower precisions are quickly recomputed.
KEEP = 1500


def sign_at(c: fmpz_poly, t: mpq) -> int:
    """The sign of a form (of the degree of c) at a local parameter in [0, 1]: first by balls if the numbers are long,
    exactly if they are short or the ball contains zero.

    >>> sign_at(fmpz_poly([1, -1]), mpq(1, 3)), sign_at(fmpz_poly([1, -1]), mpq(1, 2))
    (1, 0)
    """
    if 0 < t < 1 and c.degree() * t.denominator.bit_length() > EXACTLY:
        with ctx.workprec(START + t.denominator.bit_length()):
            near = arb_poly(c)(arb(to_fmpq(t / (1 - t))))
            if near > 0 or near < 0:
                return 1 if near > 0 else -1
    at = c(fmpq(int(t.numerator), int(t.denominator - t.numerator))) if t != 1 else c[c.degree()]
    return sign(at)


def enclosures(factor: LocalPolynomial, low: mpq, high: mpq, sign: int, bits: int) -> Iterator[Interval]:
    """A sequence of shrinking rational intervals around the only zero in (low, high), the last at most ``2^−bits``
    wide; ``(t, t)`` if t turns out to be the zero.

    `low` and `high` are local parameters, `sign` is the sign of the factor just right of `low`. The zero is strictly
    inside every interval, and the factor is not zero at an end unless this end is the original `low` or `high`. Every
    interval is valid, so that a caller that stops early can continue from the last one.

    Raises `AssertionError` if the sign does not change as stated, because the refinement would not end.

    >>> *_, (a, b) = enclosures(LocalPolynomial(fmpz_poly([1, -3, 1])), mpq(0), mpq(1, 2), 1, 200)
    >>> b - a < mpq(1, 2**200), a < mpq(5, 18) < b, mpq(276, 1000) < a < mpq(277, 1000)
    (True, False, True)
    """
    half = mpq(1, 2)
    if low < half < high:  # each half of the segment has its own chart, in which z is at most 1
        at_half = factor.polynomial(1) * sign
        if at_half == 0:
            yield Interval.point(half)
            return
        low, high = (half, high) if at_half > 0 else (low, half)
    flipped = low + high > 1
    if (_just_inside(factor.polynomial, low, high), _just_inside(factor.polynomial, high, low)) != (sign, -sign):
        raise AssertionError(f"the sign does not change from {sign:+d} between {low} and {high}")
    if flipped:
        chart = _Chart(factor.reversed, factor.reversed_slope, 1 - high, 1 - low, -sign)
    else:
        chart = _Chart(factor.polynomial, factor.slope, low, high, sign)
    for a, b in chart.run(bits):
        yield Interval(1 - b, 1 - a) if flipped else Interval(a, b)


def _just_inside(g: fmpz_poly, end: mpq, other: mpq) -> int:
    """The sign of a form at one end of an interval, or just inside the interval if the form vanishes at this end."""
    return sign_at(g, end) or end_signs(g, *sorted((end, other)))[end > other]


class _Chart:
    """The zero of g(z) in the interval of z that corresponds to [low, high], with z at most 1."""

    def __init__(self, g: fmpz_poly, slope: fmpz_poly, low: mpq, high: mpq, sign: int) -> None:
        self.g, self.slope, self.low, self.high, self.sign = g, slope, low, high, sign
        self.ends = to_fmpq(low / (1 - low)), to_fmpq(high / (1 - high))
        #: Bits lost by cancellation and division, as observed so far.
        self.loss = 0

    def run(self, bits: int) -> Iterator[Interval]:
        ball = self._caught()
        accuracy = _accuracy(ball)
        # one bit for the two units added by outward rounding, two for the width of a ball
        goal = bits + 3
        while accuracy < goal:
            if accuracy >= KEEP:
                yield self._local(ball, accuracy)
            target = goal + GUARD
            while target > 2 * accuracy + GUARD:
                target = target // 2 + 2
            ball = self._step(ball, accuracy, target)
            accuracy, before = _accuracy(ball), accuracy
            if accuracy < before + 2:
                self.loss += before + GUARD
        yield self._local(ball, goal)

    def _step(self, ball: Any, accuracy: int, target: int) -> Any:
        """One interval Newton step from a ball of the given accuracy; the observed cancellation is stored in `loss`."""
        precision = target + self.loss + GUARD
        with ctx.workprec(min(precision, accuracy + self.loss + 2 * GUARD)):
            slope = arb_poly(self.slope)(ball)
        with ctx.workprec(precision):
            middle = ball.mid()
            correction = arb_poly(self.g)(middle) / slope
            step = middle - correction
            # the balls overlap, because both contain the zero
            result = step.intersection(ball) if step.is_finite() else ball
        noise = _accuracy(result)
        self.loss = (
            max(self.loss, min(target - noise, target))
            if noise < target and noise < 2 * accuracy - 2 * GUARD
            else self.loss
        )
        return result

    def _caught(self) -> Any:
        """A ball that is proved to contain exactly this zero, and on which the interval Newton method contracts.

        Unproved Newton iteration from the midpoint, restricted to the interval, which shrinks with every certain sign;
        then an inclusion test around its limit.
        """
        low, high = self.ends
        gap = high - low
        precision = START + max(0, gap.q.bit_length() - gap.p.bit_length())
        start: Any = None
        while True:
            with ctx.workprec(precision):
                caught, low, high, start = self._attempt(low, high, start)
            if caught is not None:
                return caught
            precision *= 2
            self.loss = precision

    def _attempt(self, low_end: Any, high_end: Any, x: Any) -> tuple[Any, Any, Any, Any]:
        """The ball, or None if the precision is insufficient; in this case also the smaller interval and the point at
        which a sign was uncertain.
        """
        g, slope = arb_poly(self.g), arb_poly(self.slope)
        (first, end), low, high = map(arb, self.ends), arb(low_end), arb(high_end)
        x = ((low + high) / 2).mid() if x is None else x
        last = high - low
        # close enough to try the inclusion test at a higher precision
        near = last / 1024
        while True:
            at = g(x)
            if (at > 0) if self.sign > 0 else (at < 0):
                low = low_end = x
            elif (at < 0) if self.sign > 0 else (at > 0):
                high = high_end = x
            elif at.is_zero():
                return x, low_end, high_end, x
            else:
                return None, low_end, high_end, x
            change = at / slope(x)
            y = (x - change).mid()
            size = abs(change).upper() if change.is_finite() else last
            inside = bool(change.is_finite() and low < y and y < high)
            ball = arb(y, size / 4)
            # an end that has moved may be closer to the zero than the precision can resolve
            if change.is_finite() and size < near and first < ball < end:
                newton = y - g(y) / slope(ball)
                if newton.is_finite() and ball.contains_interior(newton):
                    # once more at the same precision
                    y = newton.mid()
                    return (y - g(y) / slope(newton)).intersection(newton), low_end, high_end, y
            if inside and 2 * size < last:
                last = size
            else:
                y, last = ((low + high) / 2).mid(), high - low
            if not (low < y < high):
                return None, low_end, high_end, None
            x = y

    def _local(self, ball: Any, bits: int) -> Interval:
        """The interval of t around the ball, rounded outwards to multiples of ``2^−bits``, and inside the previous
        interval.
        """
        if ball.is_exact() and self.g(ball.fmpq()) == 0:
            z = ball.fmpq()
            self.low = self.high = mpq(int(z.p), int(z.p + z.q))
            return Interval(self.low, self.high)
        with ctx.workprec(max(bits, 0) + START):
            low, high = (_floor_scaled(end, bits) for end in (ball.lower(), ball.upper()))
        unit = mpz(1) << bits
        self.low, self.high = max(self.low, mpq(low - 1, unit)), min(self.high, mpq(high + 2, unit))
        return Interval(self.low, self.high)


def _floor_scaled(z: Any, bits: int) -> mpz:
    """The integer part of ``2^bits z/(1 + z)`` for a dyadic ball of radius zero."""
    mantissa, exponent = z.man_exp()
    man, exp = mpz(int(mantissa)), int(exponent)
    if exp >= 0:
        man, exp = man << exp, 0
    return (man << bits) // (man + (mpz(1) << -exp))


def _accuracy(ball: Any) -> int:
    """The largest k such that the radius is below ``2^−k``."""
    mantissa, exponent = ball.rad().man_exp()
    return -int(exponent) - int(mantissa).bit_length() if mantissa != 0 else 1 << 60


#: The first precision (bits) of a place, and the one after which a value is suspected to be zero.
FIRST, SUSPICIOUS = 40, 200


class Place:
    """A parameter in [0, 1]: a rational number, or an isolated zero, whose interval shrinks when it is refined.

    >>> from exactspline.polynomials.isolation import isolate
    >>> (zero,) = isolate(fmpz_poly([1, 0, -2]), 2).inner  # z = v/u = √(1/2)
    >>> place = Place(zero)
    >>> place.sign(fmpz_poly([-1, 0, 2]), 2), place.sign(fmpz_poly([-5, 7]), 1)
    (0, -1)
    """

    __slots__ = ("_ball", "_irreducible", "bits", "interval", "zero")

    def __init__(self, zero: Zero) -> None:
        self.zero, self.interval, self.bits = zero, Interval(zero.low, zero.high), 0
        self._irreducible: fmpz_poly | None = None
        self._ball: tuple[int, arb] | None = None

    @property
    def exact(self) -> mpq | None:
        """The rational parameter if it is known to be rational."""
        low, high = self.interval
        return low if low == high else None

    @property
    def multiplicity(self) -> int:
        """The multiplicity of the zero."""
        return self.zero.multiplicity

    def refine(self, bits: int) -> Interval:
        """An interval that contains the parameter strictly inside, at most ``2^−bits`` wide; a point if it is
        rational and known.
        """
        low, high = self.interval
        if low != high and bits > self.bits:
            for interval in enclosures(self.zero.changing[0], low, high, self.zero.changing[1], bits):
                self.interval = interval
            self.bits = bits
        return self.interval

    def sign(self, c: fmpz_poly, n: int) -> int:
        """The exact sign of a form of degree n."""
        if not c:
            return 0
        bits = max(FIRST, self.bits)
        while True:
            low, high = self.refine(bits)
            if low == high:
                return sign_of(c[n]) if low == 1 else sign_at(c, low)
            with ctx.workprec(2 * bits):
                if sign := sign_of(arb_poly(c)(self.z(bits))):
                    return sign
            if bits >= SUSPICIOUS and self._is_zero_of(c):
                return 0
            bits *= 2

    def z(self, bits: int) -> arb:
        """A ball around ``z = t/(1 − t)``, for a parameter below 1; the caller sets FLINT's precision."""
        low, high = self.refine(bits)
        if self._ball is None or self._ball[0] != bits:
            while high == 1:
                bits *= 2
                low, high = self.refine(bits)
            first, last = low / (1 - low), high / (1 - high)
            self._ball = bits, arb(to_fmpq(first)).union(arb(to_fmpq(last)))
        return self._ball[1]

    def _is_zero_of(self, c: fmpz_poly) -> bool:
        common = greatest_common_divisor([self.zero.factor.polynomial, c])
        if common.degree() < 1:
            return False
        before, behind = end_signs(common, *self.interval)
        return before != behind

    @property
    def rational(self) -> mpq | None:
        """The parameter if it is rational, else None."""
        if self.exact is None and not self.zero.factor.without_rational_zero:
            p = self.irreducible
            if p.degree() == 1:
                self.interval = Interval.point(ratio(p[0], p[0] - p[1]))
        return self.exact

    @property
    def irreducible(self) -> fmpz_poly:
        """The irreducible polynomial in ``z = t/(1 − t)`` with this zero, for an inner parameter.

        Raises `ReachError` if the factorization would take too long.
        """
        if self._irreducible is None:
            low, high = self.refine(FIRST)
            if low == high:
                z = to_fmpq(low / (1 - low))
                self._irreducible = fmpz_poly([-z.p, z.q])
            else:
                self._irreducible = next(
                    f for f in factorize(self.zero.factor.polynomial).bases if len(set(end_signs(f, low, high))) == 2
                )
        return self._irreducible


def places(isolation: Isolation) -> list[Place]:
    """The places of all zeros of a form, the ends of the segment included, in ascending order."""
    found = [Place(zero) for zero in isolation.inner]
    if isolation.at_left:
        found.insert(0, at(mpq(0), isolation.at_left))
    if isolation.at_right:
        found.append(at(mpq(1), isolation.at_right))
    return found


def at(t: mpq, multiplicity: int = 0) -> Place:
    """A rational parameter as a place, with its multiplicity if it is a zero.

    >>> at(mpq(1), 2).sign(fmpz_poly([1, -1]), 1)
    -1
    """
    return Place(LocalZero(t, t, multiplicity, (0, 0), LocalPolynomial(fmpz_poly([])), 0))
