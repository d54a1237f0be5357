"""Whether polynomials in two parameters vanish at a pair of exact numbers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from flint import arb, ctx, fmpz_mpoly, fmpz_poly

from exactspline.numbers.exact import to_fmpq
from exactspline.polynomials.cost import LONGEST as LONGEST_CALL
from exactspline.polynomials.cost import check_reach
from exactspline.polynomials.two_parameters import at, enclosed, in_one, least_value
from exactspline.roots.of_polynomials import Parameter, ball
from exactspline.roots.root import Root

#: The digits with which it is tried first to show that a value is not zero.
DIGITS = (15, 30, 60)
#: Nanoseconds per product of balls, and per bit of their precision.
BALL, BALL_BITS = 300, 4
#: The number of evaluations of a polynomial that refine one of its roots to the precision of the balls.
REFINED = 4
#: The first and the largest precision (bits) at which it is decided whether a polynomial vanishes at two irrational
#: numbers.
SHORTEST, LONGEST = 512, 1 << 19


def vanish_at(polynomials: Sequence[fmpz_mpoly], s: Parameter, t: Parameter) -> bool:
    """Whether polynomials vanish at a pair of numbers, decided exactly. Raises `ReachError` if this would take too
    long.

    >>> from exactspline.polynomials.two_parameters import S, T
    >>> from exactspline.roots.of_polynomials import roots_in
    >>> (s,) = roots_in(fmpz_poly([-1, 0, 2]), 0, 1)
    >>> vanish_at([S * S + T * T - 1, S - T], s, s), vanish_at([S + T - 1], s, s)
    (True, False)
    """
    if isinstance(s, Root) and isinstance(t, Root):
        if any(is_certainly_not_zero(p, s, t) for p in polynomials):
            return False
        return all(_vanishes(p, s, t) for p in polynomials if p)
    variable, value, other = (0, s, t) if not isinstance(s, Root) else (1, t, s)
    assert not isinstance(value, Root)  # two roots have been handled above
    parts = [q for p in polynomials if (q := at(p, variable, value))]
    if not isinstance(other, Root):
        return all(q(to_fmpq(other)) == 0 for q in parts)
    return all(other.is_root_of(q) for q in parts)


def is_certainly_not_zero(p: fmpz_mpoly, s: Parameter, t: Parameter) -> bool:
    """Whether balls around the numbers (or the exact value of a rational number) show that a polynomial is not zero
    there.
    """
    if not (isinstance(s, Root) and isinstance(t, Root)):
        return not vanish_at([p], s, t)
    for digits in DIGITS:
        with ctx.workprec(8 * digits + 64):
            if not enclosed(p, ball(s, digits), ball(t, digits)).contains(0):
                return True
    return False


def _vanishes(p: fmpz_mpoly, s: Root, t: Root) -> bool:
    """Whether a polynomial vanishes at two irrational numbers.

    A value that is not zero is at least ``2^−bits`` by Liouville's inequality: balls of growing precision show either
    that it is nonzero, or that it is smaller than this bound.
    """
    first, second = fmpz_poly(s.minimal_polynomial()), fmpz_poly(t.minimal_polynomial())
    for variable, minimal in enumerate((first, second)):
        if p.degrees()[1 - variable] == 0:
            return not in_one(p, variable) % minimal
    bits = least_value(p, first, second)
    products = len(p) + REFINED * (first.degree() + second.degree())
    for precision in _precisions(bits):
        cost = products * (BALL + BALL_BITS * precision)
        longest = LONGEST_CALL if precision < LONGEST else 0
        check_reach(cost, lambda: "whether a polynomial vanishes at two irrational numbers", longest)
        with ctx.workprec(precision):
            digits = precision * 30103 // 100000
            value = abs(enclosed(p, ball(s, digits), ball(t, digits)))
            if not value.contains(0):
                return False
            if value < arb(2) ** -bits:
                return True
    raise AssertionError("there is a larger precision")


def _precisions(bits: int) -> Iterator[int]:
    """Growing precisions, up to the one at which a value of ``2^−bits`` is distinguished from 0."""
    precision = SHORTEST
    while True:
        yield precision
        precision = max(2 * precision, min(bits + SHORTEST, 4 * precision))
