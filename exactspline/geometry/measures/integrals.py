"""Integrals of rational functions over [0, 1], in closed form where no logarithms occur and the zeros of the
denominator are rational or complex quadratic: integrals of circular and elliptic arcs are ``a + b θ`` with angles θ.

Arc lengths of curves, and the parameters at given arc lengths, are exact where the speed is a polynomial, or rational
with an integral in closed form; otherwise they are enclosed by FLINT's integration.

Sources: Bronstein, Symbolic Integration I, §2.2 (Hermite's reduction); Baker, Transcendental Number Theory, Theorem 2.2
(a sum of logarithms of algebraic numbers with algebraic coefficients is 0 or transcendental).
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache, partial, reduce
from itertools import accumulate, pairwise
from math import comb, prod
from typing import TypeAlias

from flint import acb, acb_poly, arb, arb_poly, ctx, fmpq, fmpq_poly, fmpz_poly
from flint.utils.flint_exceptions import DomainError as NoRoot

from exactspline.errors import DomainError, OpenError, ReachError, ShapeError
from exactspline.geometry.curves.facts import Facts, facts_of
from exactspline.geometry.curves.kinds import JointKind
from exactspline.numbers.exact import mpq, rational, text, to_fmpq
from exactspline.numbers.intervals import Interval, ball_around, ball_ends
from exactspline.numbers.search import Search
from exactspline.polynomials.bernstein import in_parameter
from exactspline.polynomials.cost import check_reach
from exactspline.polynomials.factors import factorize, greatest_common_divisor
from exactspline.questions.answers import NamedNumbers
from exactspline.questions.takes import QuestionError
from exactspline.reals.ball import InBalls, WithAngles
from exactspline.reals.real import Expression, Real, real, square_root, square_root_parts
from exactspline.roots.values import evaluate, exact_place
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs

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


def _too_much(what: str) -> OpenError:
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
            raise _too_much("an integral")
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
class _Term:
    """``factor · √radicand``, possibly times an integral."""

    factor: mpq
    radicand: int
    of: _Logarithmic | None = None

    def times(self, factor: mpq, radicand: int = 1) -> _Term:
        """The term times a factor and a square root."""
        root, own = square_root_parts(mpq(self.radicand * radicand))
        return _Term(self.factor * factor * root, own, self.of)

    def ball(self) -> arb:
        """The value of the term, enclosed in the present precision."""
        return arb(to_fmpq(self.factor)) * arb(self.radicand).sqrt() * (arb(1) if self.of is None else self.of.ball())


Terms: TypeAlias = tuple[_Term, ...]


def _in_local_powers(f: BSpline) -> list[fmpq_poly]:
    """The polynomials of a spline in powers of the local parameter of each segment, which runs from 0 to 1.

    >>> from exactspline import BSpline
    >>> _in_local_powers(BSpline.bezier([0, 0, 1], 1, 3))
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
    terms = [_Term(rational((top // bottom).integral()(1)), 1)]
    for factor, times in powers:
        p, m = fmpq_poly(factor), times * n
        value, left = _reduced(top * (bottom // p**m).xgcd(p**m)[1] % p**m, p, m)
        terms.append(_Term(value, 1))
        if left:
            terms.append(_Term(mpq(1), 1, _Logarithmic(*(tuple(map(rational, f.coeffs())) for f in (left, p)))))
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
    n, terms = i + j + 2, list[_Term]()
    for parts in zip(*map(_in_local_powers, (*facts.curve.p, facts.curve.w)), strict=True):
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


WHAT = "the arc length"
#: The work allowed for one enclosure of an arc length, as `_Budget` counts it: a few seconds.
MOST_WORK = 4_000_000
#: From this number of bits on a parameter is first computed with half of them; and the number of bits lost by this.
FIRST_BITS, MARGIN = 200, 35
#: The number of points of a quadrature is a multiple of this, so that few different rules occur; and the largest half
#: axis of its ellipse.
STEP, LARGEST = 8, 16
#: Bits by which the errors of parts are smaller than the requested one, for their sum.
SPARE = 8
#: A segment: the common factor g of the components of γ′, h, and w, with ``‖γ′‖ = |g| √h / w²`` and h > 0.
Speed: TypeAlias = tuple[fmpq_poly, fmpq_poly, fmpq_poly]


class _Budget:
    """The remaining work for one enclosure: inside FLINT's integration loop every evaluation of the integrand is
    counted before it is made; the loop ends when an evaluation fails.
    """

    def __init__(self, bits: int) -> None:
        self.remaining, self._words = MOST_WORK, 1 + bits // 100

    def take(self, terms: int) -> None:
        """Count an evaluation of this many terms; raises `OpenError` when the budget is exhausted."""
        self.remaining -= terms * self._words
        if self.remaining < 0:
            raise _too_much(WHAT)


def length(curve: Nurbs) -> Real:
    """The arc length; exact where ‖γ′‖ is, on every segment, the square root of a rational number times a polynomial or
    a rational function with an integral in closed form, as on circular arcs. A curve of many segments, a high degree or
    many digits may need too much work: operations on the number then raise `OpenError`.

    >>> from exactspline import Nurbs, example
    >>> length(Nurbs(1, [0, 0, 1, 1], [(0, 0), (3, 4)])), length(example("circle"))
    (<Real 5>, <Real 2π>)
    >>> length(Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), (1, 1), (2, 0)])).double()
    2.295587149392638
    """
    speeds, terms = _rational_speeds(curve), list[_Term]()
    if speeds is None:
        return InBalls(partial(_length_ball, curve, *curve.domain))
    for width, weight, speed, square in speeds:
        factor, radicand = square_root_parts(square)
        terms += [term.times(factor * width, radicand) for term in integral(speed, weight, 2)]
    return number(tuple(terms))


def length_between(curve: Nurbs, first: mpq | Real, second: mpq | Real) -> Real:
    """The arc length between two parameters, in either order.

    >>> from exactspline import example
    >>> length_between(example("circle"), mpq(1, 2), mpq(0)).double()
    0.9272952180016122

    Raises `DomainError` outside the domain.
    """
    low, high = sorted((exact_place(first), exact_place(second)), key=real)
    for t in (low, high):
        evaluate(curve, t)  # an error outside the domain
    if isinstance(low, Real) or isinstance(high, Real):
        return InBalls(partial(_length_ball, curve, low, high))
    return length(curve.restrict(low, high)) if low < high else Real(0)


def at_length(curve: Nurbs, distance: mpq) -> Real:
    """The parameter at an arc length from the start of the curve.

    >>> from exactspline import Nurbs, example
    >>> at_length(Nurbs(1, [0, 0, 1, 1], [(0, 0), (3, 4)]), mpq(2)), at_length(example("circle"), mpq(1)).double()
    (<Real 2/5>, 0.5463024898437905)

    Raises `DomainError` for a negative length and for a length greater than that of the curve.
    """
    total = length(curve)
    if not 0 <= distance <= total:
        raise DomainError(f"the length {text(distance)} on a curve of the length {total}", remedy="stay on the curve")
    return _places(curve, [(distance, mpq(0))])[0] if distance else Real(curve.domain[0])


def equally_spaced(curve: Nurbs, parts: int) -> list[Real]:
    """The parameters that divide a curve into parts of the same arc length, both ends of the domain included.

    >>> from exactspline import Nurbs
    >>> equally_spaced(Nurbs(1, [0, 0, 1, 1], [(0, 0), (3, 4)]), 3)
    [<Real 0>, <Real 1/3>, <Real 2/3>, <Real 1>]

    Raises `QuestionError` for 0 parts.
    """
    if parts < 1:
        raise QuestionError("a curve in 0 parts", remedy="ask for one part or more")
    (start, end), inner = curve.domain, _places(curve, [(mpq(0), mpq(k, parts)) for k in range(1, parts)])
    return [Real(start), *inner, Real(end)]


def _places(curve: Nurbs, at: list[tuple[mpq, mpq]]) -> list[Real]:
    """The parameters at arc lengths, each given as a number plus a fraction of the whole length; one of the two is
    0.
    """
    known = _travelled(curve)
    if known is None:
        return [InBalls(partial(_place_ball, curve, *each)) for each in at]
    root, radicand = square_root_parts(known[1])
    travelled = known[0].scaled(root)
    squared, total = travelled * travelled * radicand, travelled(curve.domain[1])
    return [
        _zero_of(squared - distance**2 if distance and radicand != 1 else travelled - distance - total * share)
        for distance, share in at
    ]


def _zero_of(increasing: BSpline) -> Real:
    """The first zero of an increasing spline, which has a zero."""
    found = zeros(increasing)
    return Real(found.intervals[0].low) if found.intervals else real(exact_place(found.roots[0]))


# ---- exactly


def _rational_speeds(curve: Nurbs) -> list[tuple[mpq, fmpq_poly, fmpq_poly, mpq]] | None:
    """Width, w, f and k of each segment with ``‖γ′‖ = √k f / w²``, where f ≥ 0; None if they do not exist."""
    found = []
    try:
        for (a, b), (common, squared, weight) in zip(pairwise(curve.breakpoints), _speeds(curve), strict=True):
            factor = squared.leading_coefficient() if squared else fmpq(1)
            speed = common * (squared / factor).sqrt()
            if any(a < stop < b for stop in facts_of(curve).speed.zeros):
                return None
            found.append((b - a, weight, speed if speed(fmpq(1, 2)) > 0 else -speed, rational(factor)))
    except (NoRoot, ValueError, OpenError):  # not a square (FLINT's wrapper raises either error), or too much work
        return None
    return found


def _travelled(curve: Nurbs) -> tuple[BSpline, mpq] | None:
    """A spline f and a number k such that ``√k f`` is the arc length from the start; None if they do not exist."""
    speeds = [each[2:] for each in (_rational_speeds(curve) if curve.polynomial else None) or ()]
    square = next((k for f, k in speeds if f), mpq(1))
    roots = [square_root_parts(k / square) if f else (mpq(1), 1) for f, k in speeds]
    if not speeds or any(radicand != 1 for _, radicand in roots):
        return None
    n = max(0, *(f.degree() for f, _ in speeds))
    points = [
        factor * sum((mpq(comb(j, i), comb(n, i)) * rational(f[i]) for i in range(j + 1)), start=mpq(0))
        for (f, _), (factor, _) in zip(speeds, roots, strict=True)
        for j in range(n + 1)
    ]
    return BSpline(n, [t for t in curve.breakpoints for _ in range(n + 1)], points).integral(), square


# ---- in balls


def _speeds(curve: Nurbs) -> list[Speed]:
    """The segments, computed once; raises `OpenError` where this takes too much work."""
    return facts_of(curve).once("speeds", partial(_computed_speeds, curve))


def _computed_speeds(curve: Nurbs) -> list[Speed]:
    columns = map(_in_local_powers, (curve.w, *facts_of(curve).velocity))
    return [_speed(*each) for each in zip(*columns, strict=True)]


def _speed(weight: fmpq_poly, *velocity: fmpq_poly) -> Speed:
    try:
        common = greatest_common_divisor(velocity)
    except ReachError as error:
        raise _too_much(WHAT) from error
    return common, sum(((p // common) ** 2 for p in velocity), start=fmpq_poly()) if common else common, weight


def _lengths(curve: Nurbs, low: mpq | Real, high: mpq | Real, bits: int) -> list[arb]:
    """Enclosures of the arc lengths between two parameters, segment by segment."""
    budget = _Budget(bits)
    return [_on_segment(curve, i, low, high, budget) for i in range(len(_speeds(curve)))]


def _length_ball(curve: Nurbs, low: mpq | Real, high: mpq | Real, bits: int) -> arb:
    return sum(_lengths(curve, low, high, bits), start=arb(0))


def _on_segment(curve: Nurbs, i: int, low: mpq | Real, high: mpq | Real, budget: _Budget) -> arb:
    """The arc length on a segment between two parameters, which may be outside the segment, to the present
    precision.
    """
    common, squared, weight = _speeds(curve)[i]
    a, b = curve.breakpoints[i : i + 2]
    start, end = low if low > a else a, high if high < b else b
    if not common or not start < end:
        return arb(0)
    stops = [stop for stop in facts_of(curve).speed.zeros if start < stop < end]
    local = [_ball_of((real(t) - a) / (b - a)) for t in (start, *stops, end)]
    parts = (abs(_integral(common, squared, weight, u, v, budget)) for u, v in pairwise(local))
    return sum(parts, start=arb(0)) * to_fmpq(b - a)


def _ball_of(x: Real) -> arb:
    return ball_around(*x.enclosure(ctx.prec * 3 // 10 + ctx.prec // 500 + 5))


def _marks(curve: Nurbs, bits: int) -> list[arb]:
    """The arc lengths from the start to each of the distinct knots."""
    parts: list[arb] = facts_of(curve).once(("arc lengths", bits), lambda: _lengths(curve, *curve.domain, bits))
    return list(accumulate(parts, initial=arb(0)))


def _place_ball(curve: Nurbs, distance: mpq, share: mpq, bits: int) -> arb:
    """The parameter at an arc length plus a fraction of the whole length, by the interval Newton method: the mean value
    theorem holds also across knots, with the hull of the speeds on all segments between the ends.
    """
    marks, budget, breaks, (low, high) = _marks(curve, bits), _Budget(bits), curve.breakpoints, curve.domain
    goal = marks[-1] * to_fmpq(share) + to_fmpq(distance)
    if bits > FIRST_BITS:
        # each step doubles the bits: the last step costs as much as all before
        with ctx.workprec(bits // 2 + MARGIN):
            ends = ball_ends(_place_ball(curve, distance, share, bits // 2 + MARGIN))
        low, high = max(low, ends.low), min(high, ends.high)

    def narrowed(cut: mpq) -> tuple[mpq, mpq]:
        at = low + (high - low) * cut
        i, segments = bisect_right(breaks, at) - 1, range(bisect_right(breaks, low) - 1, bisect_left(breaks, high))
        beyond = marks[i] + _on_segment(curve, i, breaks[i], at, budget) - goal
        speed = reduce(arb.union, (_speed_on(curve, i, low, high) for i in segments))
        ends = Interval(at if beyond < 0 else low, at if beyond > 0 else high)
        step = ball_ends(arb(to_fmpq(at)) - beyond / speed) if speed > 0 else ends
        return max(ends.low, step.low), min(ends.high, step.high)

    while (width := high - low) > mpq(1, 1 << (bits - MARGIN)):
        # at the second point if the sign at the first is not decided
        tried = (narrowed(cut) for cut in (mpq(1, 2), mpq(1, 3)))
        found = next((ends for ends in tried if ends[1] - ends[0] < width * 3 / 4), None)
        if found is None:
            break
        low, high = found
    return ball_around(low, high)


def _speed_on(curve: Nurbs, i: int, low: mpq, high: mpq) -> arb:
    """An enclosure of the speeds on the part of an interval within a segment."""
    a, b = curve.breakpoints[i : i + 2]
    local = ball_around((max(low, a) - a) / (b - a), (min(high, b) - a) / (b - a))
    common, squared, weight = (arb_poly(p)(local) for p in _speeds(curve)[i])
    return abs(common) * squared.sqrt() / weight**2


def _integral(common: fmpq_poly, squared: fmpq_poly, weight: fmpq_poly, low: arb, high: arb, budget: _Budget) -> arb:
    """``∫ common √squared / weight²``, where ``squared`` has no real zeros."""
    if separate(squared.numer()) and separate(weight.numer()):
        return _Rooted(common, squared, weight, budget).integral(low, high)
    factor, bottom = acb_poly(arb_poly(common)), acb_poly(arb_poly(weight))

    def speed(z: acb, analytic: bool) -> acb:
        budget.take(6 + squared.degree() ** 2)
        # by the Taylor expansion at the centre of the ball, whose cost does not depend on the zeros
        centre = acb(z.real.mid(), z.imag.mid())
        square = acb_poly(arb_poly(squared))(acb_poly([centre, 1]))(z - centre)
        return factor(z) / bottom(z) ** 2 * square.sqrt(analytic=analytic)

    bits = ctx.prec
    with ctx.workprec(bits + squared.numer().height_bits()):
        return acb.integral(speed, acb(low), acb(high), rel_tol=arb((1, -bits)), eval_limit=20_000).real


class _Rooted:
    """A speed given by the zeros of ``squared`` and of the weight, and its integral by Gauss's quadrature.

    On [−1, 1] the error of n points is at most ``64/15 M ρ^−2n / (1 − ρ^−2)`` for a function that is analytic inside an
    ellipse with the foci ±1 whose half axes have the sum ρ, and whose absolute value is at most M there. The distance
    of points on two such ellipses is at least the difference of their larger half axes.

    Source: Trefethen, Approximation Theory and Approximation Practice, SIAM 2013, theorem 19.3.
    """

    def __init__(self, common: fmpq_poly, squared: fmpq_poly, weight: fmpq_poly, budget: _Budget) -> None:
        self.top, self.bottom, self.budget = arb_poly(common**2 * squared), arb_poly(weight**2), budget
        self.zeros, self.poles = self._roots(squared.numer()), self._roots(weight.numer())
        self.square, self.lead = (arb(p.leading_coefficient()) for p in (squared, weight))
        self.sizes = arb_poly([abs(c) for c in common.coeffs()])

    def _roots(self, p: fmpz_poly) -> list[tuple[acb, int]]:
        # measured, of Bézier curves: 80 to 400 nanoseconds for the cube of the degree, and more for long integers
        degree, bits = p.degree(), p.height_bits()
        self.budget.take(degree**3 * (1 + degree * bits // 100_000) // 2)
        return p.complex_roots()  # type: ignore[return-value]  # flint says a single one

    def at(self, x: arb) -> arb:
        """The speed, or bounds of it on an interval."""
        return self.top(x).nonnegative_part().sqrt() / self.bottom(x)

    def integral(self, low: arb, high: arb) -> arb:
        """The integral of the speed: an interval near a zero is halved, and a short one is estimated. The error of a
        part is small compared with the integral over that part, or with the speed at two points of the whole interval.
        """
        total, search, quarter = arb(0), Search([(low, high)], depth_first=True), (high - low) / 4
        self.small = self.at(low + quarter).max(self.at(high - quarter)) * quarter * arb((1, -ctx.prec - SPARE))
        for left, right in search:
            self.budget.take(6 + len(self.zeros))
            half, middle = (right - left) / 2, (left + right) / 2
            axes, far = ([(abs(z - left) + abs(z - right)) / half / 2 for z, _ in x] for x in (self.zeros, self.poles))
            axis = reduce(arb.min, [*axes, *((1 + a) / 2 for a in far)], arb(LARGEST)).lower()
            if 5 * axis > 6:
                total += self._by_points(middle, half, axis, far)
            elif search.depth > ctx.prec or self.at(left.union(right)) * half < self.small:
                total += self.at(left.union(right)) * 2 * half
            else:
                search.split([(middle, right), (left, middle)])
        return total

    def _by_points(self, middle: arb, half: arb, axis: arb, far: Sequence[arb]) -> arb:
        """The integral on an interval around a point, with the larger half axis of an ellipse, relative to half of the
        interval, and with those of the ellipses through the poles.
        """
        radius, rho = half * axis, axis + (axis * axis - 1).sqrt()
        apart = ((half * (a - axis)) ** (2 * times) for (_, times), a in zip(self.poles, far, strict=True))
        square = prod(((abs(z - middle) + radius) ** times for z, times in self.zeros), start=self.square)
        most = self.sizes(abs(middle) + radius) * square.sqrt() / prod(apart, start=self.lead**2)
        error = 64 * half * most / (15 - 15 / rho**2)
        n, allowed = 0, self.small.max(half * self.at(middle) * arb((1, -ctx.prec)))
        while not error / rho ** (2 * n) < allowed and n < 4 * ctx.prec:
            n += STEP * (1 + n // (4 * STEP))
        self.budget.take(n * (1 + len(self.zeros)))
        values = (w * (self.at(middle - half * x) + self.at(middle + half * x)) for x, w in _points(n, ctx.prec))
        return sum(values, start=arb(0)) * half + arb(0, (error / rho ** (2 * n)).upper())


@lru_cache(maxsize=256)
def _points(n: int, bits: int) -> list[tuple[arb, arb]]:
    """The positive half of an even number of points of Gauss's quadrature, with their weights."""
    return [arb.legendre_p_root(n, k, weight=True) for k in range(n // 2)]
