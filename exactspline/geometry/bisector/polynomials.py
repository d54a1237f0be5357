"""Values of polynomials at exact parameters: in ball arithmetic, and whether several vanish together."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import reduce
from typing import Protocol, Self, TypeVar

from flint import arb, ctx, fmpz_mpoly, fmpz_poly

from exactspline.errors import ReachError
from exactspline.language.operand import Scalar
from exactspline.numbers.exact import rational, to_fmpq
from exactspline.numbers.intervals import ball_around
from exactspline.polynomials.cost import affords
from exactspline.polynomials.factors import greatest_common_divisor
from exactspline.polynomials.two_parameters import at, enclosed, in_one, least_value
from exactspline.roots.of_polynomials import Parameter
from exactspline.roots.root import Root

#: Three polynomials: a vector along a curve, or over a patch.
Three = list[fmpz_poly]
ThreeOfTwo = list[fmpz_mpoly]

#: Nanoseconds per product of balls, and per bit of their precision.
BALL, BALL_BITS = 300, 4
#: How many evaluations of a polynomial it takes to refine one of its roots to the precision of the balls.
REFINED = 4
#: The first and the largest precision (bits) at which it is decided whether a polynomial vanishes at two irrational
#: numbers.
SHORTEST, LONGEST = 512, 1 << 19


class Euclidean(Scalar, Protocol):
    """A polynomial in one parameter over the integers or a field."""

    def __mul__(self, other: Self | int, /) -> Self: ...
    def __floordiv__(self, other: Self, /) -> Self: ...
    def gcd(self, other: Self, /) -> Self:
        """The greatest common divisor."""


E = TypeVar("E", bound=Euclidean)


# ---- one parameter


def common_divisor(polynomials: Iterable[E]) -> E:
    """The greatest common divisor of polynomials in one parameter; `ReachError` where that would take too long."""
    given = list(polynomials)
    if isinstance(given[0], fmpz_poly):
        return greatest_common_divisor(given)  # type: ignore[type-var]  # all of them are of one type
    return reduce(lambda p, q: p.gcd(q), given)


# ---- two parameters


def ball(t: Parameter, digits: int) -> arb:
    """A ball around a parameter; the precision of FLINT is the caller's."""
    return ball_around(*(t.refine(digits) if isinstance(t, Root) else (t, t)))


def certainly_not_zero(p: fmpz_mpoly, s: Parameter, t: Parameter, most: int = 60) -> bool:
    """Whether balls around the parameters show that a polynomial is not zero there; False proves nothing."""
    digits = 15
    while digits <= most:
        with ctx.workprec(8 * digits + 64):
            if not enclosed(p, ball(s, digits), ball(t, digits)).contains(0):
                return True
        digits *= 2
    return False


def vanish_together(polynomials: Sequence[fmpz_mpoly], s: Parameter, t: Parameter) -> bool | None:
    """Whether polynomials vanish at a pair, decided exactly; None where that would need more than the longest precision
    of balls.
    """
    if isinstance(s, Root) and isinstance(t, Root):
        if any(certainly_not_zero(p, s, t) for p in polynomials):
            return False
        verdicts = [_vanishes(p, s, t) for p in polynomials if p]
        return False if False in verdicts else None if None in verdicts else True
    variable, value, other = (0, s, t) if not isinstance(s, Root) else (1, t, s)
    assert not isinstance(value, Root)  # two roots have been handled above
    parts = [q for p in polynomials if (q := at(p, variable, rational(value)))]
    if not parts:
        return True
    if not isinstance(other, Root):
        return all(q(to_fmpq(other)) == 0 for q in parts)
    return all(other.is_root_of(q) for q in parts)


def _vanishes(p: fmpz_mpoly, s: Root, t: Root) -> bool | None:
    """Whether a polynomial vanishes at two irrational parameters; None beyond the longest precision.

    A value that is not zero is at least ``2^−bits`` by Liouville's inequality: balls of growing precision show either
    that it is nonzero, or that it is smaller than this bound.
    """
    try:
        first, second = fmpz_poly(s.minimal_polynomial()), fmpz_poly(t.minimal_polynomial())
    except ReachError:
        return None
    for variable, minimal in enumerate((first, second)):
        if p.degrees()[1 - variable] == 0:
            return not _primitive(in_one(p, variable)) % minimal
    bits, precision = least_value(p, first, second), SHORTEST
    products = len(p) + REFINED * (first.degree() + second.degree())
    while precision < LONGEST and affords(products * (BALL + BALL_BITS * precision)):
        with ctx.workprec(precision):
            digits = precision * 30103 // 100000
            value = abs(enclosed(p, ball(s, digits), ball(t, digits)))
            if not value.contains(0):
                return False
            mantissa, exponent = value.upper().man_exp()
            if mantissa == 0 or int(exponent) + int(mantissa).bit_length() < -bits:
                return True
        precision = max(2 * precision, min(bits + SHORTEST, 4 * precision))
    return None


def _primitive(p: fmpz_poly) -> fmpz_poly:
    return p // p.content()
