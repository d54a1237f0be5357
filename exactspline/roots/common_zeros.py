"""All common zeros of polynomials in two parameters on a rectangle: simple, multiple, irrational, on its border.

A resultant has all values s of common zeros among its roots. Over the field of each of them the zeros t are those of a
greatest common divisor, so that nothing is decided by digits: balls exclude, and a change of an exact sign proves.
Boxes in Bernstein form come first, so that most questions end before there is a resultant.

Source: Berberich, Emeliyanenko, Kobel and Sagraloff, Exact symbolic-numeric computation of planar algebraic curves,
Theoretical Computer Science 2013 (the two steps: projection and fibres).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property, reduce
from itertools import pairwise

from flint import arb, arb_poly, ctx, fmpq_poly, fmpz_mpoly, fmpz_poly

from exactspline.numbers.exact import mpq, to_fmpq
from exactspline.numbers.exact import sign as sign_of
from exactspline.numbers.intervals import Box, Interval, hull
from exactspline.polynomials.cost import check_reach, height_bits
from exactspline.polynomials.elimination import resultant
from exactspline.polynomials.factors import factorize, factorize_square_free, greatest_common_divisor
from exactspline.polynomials.over_root import OverRoot, by_powers
from exactspline.polynomials.two_parameters import S, T, lifted, possible_boxes, rows_of
from exactspline.roots.of_polynomials import Parameter, Place, ball, exactly, roots_in
from exactspline.roots.root import Root
from exactspline.roots.simple_zeros import Pair
from exactspline.roots.vanishing import is_certainly_not_zero

#: The number of resultants whose common roots are taken, for more than two polynomials.
ELIMINANTS = 2
#: Nanoseconds, per square of the degree and per bit, to isolate roots on an interval as small as boxes are (measured up
#: to 11).
SUBDIVISION = 12
#: The degree of a field, times the bits of the polynomials over it, beyond which boxes are tried before arithmetic in
#: it.
LARGE = 60
#: The first precision (decimal digits) at which a sign is tried.
DIGITS = 15


@dataclass(frozen=True)
class Column:
    """The common zeros of polynomials over the roots of one irreducible polynomial: those of a square-free polynomial
    in t over its field.
    """

    minimal: fmpz_poly
    zeros: OverRoot

    @classmethod
    def of(cls, polynomials: Sequence[fmpz_mpoly], minimal: fmpz_poly) -> Column:
        """That of polynomials which do not all vanish on the line. Raises `ReachError` where that would take too
        long.
        """
        common = reduce(lambda p, q: p.gcd(q), _over(polynomials, minimal))
        slope = OverRoot([c * k for k, c in enumerate(common.coefficients)][1:], common.modulus)
        return cls(minimal, common // common.gcd(slope) if slope else common)

    def candidates(self, side: Interval) -> list[Parameter]:
        """All values t in an interval that the zeros over any of the roots have, in ascending order."""
        if self.zeros.degree < 1:
            return []
        (parts,) = by_powers([self.zeros])
        p = sum((lifted(part, 1) * S**k for k, part in enumerate(parts)), S * 0)
        norm = resultant([fmpz_poly([x]) for x in self.minimal.coeffs()], rows_of(p.compose(T, S)))
        return apart([exactly(t) for t in roots_in(norm, *side)])

    def sign(self, s: Parameter, t: mpq) -> int:
        """The sign over one of the roots at a rational t."""
        x, value = to_fmpq(t), fmpq_poly([])
        for c in reversed(self.zeros.coefficients):
            value = value * x + c
        return sign_over(value, s)

    def contains(self, s: Parameter, t: Parameter) -> bool:
        """Whether one of the `candidates` is a zero over one of the roots."""
        if not isinstance(t, Root):
            return self.sign(s, t) == 0
        # a zero in the interval of a candidate is this one, and it is simple
        digits = 1
        while True:
            before, behind = (self.sign(s, end) for end in t.refine(digits))
            if before and behind:
                return before != behind
            digits *= 2


@dataclass(frozen=True)
class Fibre:
    """Polynomials over the roots of one irreducible polynomial."""

    polynomials: Sequence[fmpz_mpoly]
    minimal: fmpz_poly
    also: Sequence[fmpz_mpoly] = ()

    @cached_property
    def column(self) -> Column:
        """Their common zeros there, over the field of the roots."""
        return Column.of(self.polynomials, self.minimal)

    def over(self, s: Parameter, pair: Pair, side: Interval) -> list[Parameter]:
        """All t in an interval at which they vanish together with one of the roots: by boxes where its field is large,
        and where these do not decide by arithmetic in the field.
        """
        if isinstance(s, Root) and self._size > LARGE:
            simple = pair.over(s, self.polynomials, side, self.also)
            if simple is not None:
                return simple
        return [t for t in self._candidates(side) if self.column.contains(s, t)]

    @cached_property
    def _size(self) -> int:
        heights = [height_bits(self.minimal.coeffs()), *(height_bits(p.coeffs()) for p in self.polynomials)]
        return self.minimal.degree() * max(heights)

    @cached_property
    def _known(self) -> dict[Interval, list[Parameter]]:
        return {}

    def _candidates(self, side: Interval) -> list[Parameter]:
        if side not in self._known:
            self._known[side] = self.column.candidates(side)
        return self._known[side]


@dataclass(frozen=True)
class CommonZero:
    """A common zero: two real numbers, each rational or a certified root."""

    s: Parameter
    t: Parameter
    fibre: Fibre = field(repr=False, compare=False)

    @property
    def place(self) -> Place:
        """Both numbers."""
        return self.s, self.t

    def box(self, digits: int) -> Box:
        """A box that contains it, its sides at most ``10^−digits`` long."""
        first, second = (x.refine(digits) if isinstance(x, Root) else Interval.point(x) for x in self.place)
        return Box(first, second)

    def is_zero_of(self, p: fmpz_mpoly) -> bool:
        """Whether another polynomial vanishes here too, decided exactly."""
        minimal = self.fibre.minimal
        (own,) = _over([p], minimal)
        return not own or Column(minimal, self.fibre.column.zeros.gcd(own)).contains(self.s, self.t)


def common_zeros(
    polynomials: Sequence[fmpz_mpoly], sides: Box, boxes: Sequence[Box] | None = None, also: Sequence[fmpz_mpoly] = ()
) -> list[CommonZero]:
    """All common zeros on a closed rectangle of polynomials without a common factor; where `boxes` are given, all that
    are in one of them. Those at which one of the others, `also`, is certainly not zero are left out.

    Raises `ReachError` where this would take too long.

    >>> from exactspline.numbers.intervals import UNIT
    >>> (zero,) = common_zeros([2 * S * S - 1, (S - T) ** 2], UNIT)
    >>> zero.s == zero.t, zero.s.minimal_polynomial()
    (True, [-1, 0, 2])
    """
    given = [p for p in polynomials if p]
    if any(p.total_degree() == 0 for p in given):
        return []
    boxes = possible_boxes([*given, *also], sides) if boxes is None else boxes
    if not boxes:
        return []
    found, side = list[CommonZero](), hull(boxes).second
    eliminant, pair = _eliminant(given)
    for minimal, roots in _lines(eliminant, [box.first for box in boxes]):
        fibre = Fibre(given, minimal, also)
        places = [(s, t) for s in roots for t in fibre.over(s, pair, side)]
        found += [CommonZero(*x, fibre) for x in places if not any(is_certainly_not_zero(p, *x) for p in also)]
    return sorted(found, key=lambda zero: zero.place)


def multiplicity(zero: CommonZero, f: fmpz_mpoly, g: fmpz_mpoly) -> int:
    """The intersection multiplicity of two polynomials without a common factor at one of their zeros: as a zero of the
    resultant in ``t + λ s``, for a λ for which no other zero has the same value.

    >>> from exactspline.numbers.intervals import UNIT
    >>> f, g = S * S - T**3, S - T * T
    >>> [multiplicity(zero, f, g) for zero in common_zeros([f, g], UNIT)]
    [3, 1]
    """
    jacobian = f.derivative(0) * g.derivative(1) - f.derivative(1) * g.derivative(0)
    if is_certainly_not_zero(jacobian, *zero.place) or not zero.is_zero_of(jacobian):
        return 1
    slope = 0
    while True:
        slope += 1
        sheared = [p.compose(T, S - slope * T) for p in (f, g)]
        rows = [rows_of(p) for p in sheared]
        if all(own[-1].degree() > 0 for own in rows):
            continue  # zeros at infinity would be counted
        factor, times = _factor_at(resultant(*rows), zero, slope)
        if Column.of(sheared, factor).zeros.degree == 1:
            return times


def _factor_at(eliminant: fmpz_poly, zero: CommonZero, slope: int) -> tuple[fmpz_poly, int]:
    """The irreducible factor that vanishes at ``t + λ s``, which is a root, and its power."""
    factors, digits = list(factorize(eliminant).powers), DIGITS
    while len(factors) > 1:
        with ctx.workprec(8 * digits + 64):
            value = ball(zero.t, digits) + slope * ball(zero.s, digits)
            factors = [(p, times) for p, times in factors if arb_poly(p)(value).contains(0)]
        digits *= 2
    return factors[0]


def _over(polynomials: Sequence[fmpz_mpoly], minimal: fmpz_poly) -> list[OverRoot]:
    modulus = fmpq_poly(minimal)
    return [OverRoot.of(p, modulus) for p in polynomials]


def _lines(eliminant: fmpz_poly, sides: Sequence[Interval]) -> Iterator[tuple[fmpz_poly, list[Parameter]]]:
    """The irreducible factors of a polynomial that have roots in some intervals, and these roots."""
    whole = Interval(min(side.low for side in sides), max(side.high for side in sides))

    def roots(p: fmpz_poly) -> list[Parameter]:
        cost = SUBDIVISION * p.degree() ** 2 * p.height_bits()
        check_reach(cost, lambda: f"the roots of an eliminant of degree {p.degree()} on a small interval")
        return [exactly(s) for s in roots_in(p, *whole, whole=True) if any(low <= s <= high for low, high in sides)]

    for part, _ in factorize_square_free(eliminant).powers:
        # most square-free parts have no root there, and are not factored any further
        if roots(part):
            for minimal in factorize(part).bases:
                if own := roots(minimal):
                    yield minimal, own


def _eliminant(polynomials: Sequence[fmpz_mpoly]) -> tuple[fmpz_poly, Pair]:
    """A polynomial in s, not zero, that vanishes at all common zeros; and the first two combinations that have one."""
    first, *others = sorted(polynomials, key=lambda p: (int(p.degrees()[1]), len(p)))
    rows, found, pairs = rows_of(first), list[fmpz_poly](), list[Pair]()
    k = 0
    while len(found) < (ELIMINANTS if len(others) > 1 else 1):
        # a factor of the first divides two of the combinations only if it divides all
        combined = sum((p * k**i for i, p in enumerate(others)), S * 0)
        eliminant = _without_t(rows, rows_of(combined)) if combined else fmpz_poly([])
        if eliminant:
            found.append(eliminant)
            pairs.append(Pair(first, combined, eliminant))
        k += 1
    return greatest_common_divisor(found), pairs[0]


def _without_t(first: list[fmpz_poly], second: list[fmpz_poly]) -> fmpz_poly:
    """The resultant in t, or the common divisor of polynomials in which t does not occur, whose resultant is 1."""
    return greatest_common_divisor([*first, *second]) if len(first) == len(second) == 1 else resultant(first, second)


def apart(numbers: Sequence[Parameter]) -> list[Parameter]:
    """Different numbers in ascending order, refined until no two of their intervals meet."""
    for low, high in pairwise(numbers):
        digits = 2
        while _interval(low, digits).meets(_interval(high, digits)):
            digits *= 2
    return list(numbers)


def _interval(t: Parameter, digits: int) -> Interval:
    return t.refine(digits) if isinstance(t, Root) else Interval.point(t)


def sign_over(x: fmpq_poly, s: Parameter) -> int:
    """The sign of a polynomial, reduced modulo the minimal one, at a number."""
    if not x:
        return 0
    numerator, digits = x.numer(), DIGITS
    if not isinstance(s, Root):
        return sign_of(numerator(to_fmpq(s)))
    while True:
        with ctx.workprec(8 * digits + 64):
            value: arb = arb_poly(numerator)(ball(s, digits))
            if not value.contains(0):
                return 1 if value > 0 else -1
        digits *= 2


__all__ = ["Column", "CommonZero", "apart", "common_zeros", "multiplicity", "sign_over"]
