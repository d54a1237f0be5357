"""Polynomials of one segment in the spline's own parameter, and of a patch in both parameters s and t: from splines and
back, values in balls, and boxes in which several may vanish together.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import reduce
from math import lcm
from typing import Protocol, Self, TypeVar

from flint import Ordering, arb, arb_poly, ctx, fmpz_mpoly, fmpz_mpoly_ctx, fmpz_poly

from exactspline.errors import ReachError
from exactspline.language.operand import Scalar
from exactspline.numbers.exact import from_flint, mpq, rational, to_fmpq, to_fmpz
from exactspline.numbers.intervals import Box
from exactspline.polynomials.bernstein import ONE, halves, substituted
from exactspline.polynomials.cost import QUESTION, affords, check_reach, height_bits
from exactspline.polynomials.factors import factorize, factorize_square_free, greatest_common_divisor
from exactspline.roots.root import Root
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.knots import Mesh

CONTEXT = fmpz_mpoly_ctx.get(["s", "t"], Ordering.lex)
S, T = CONTEXT.gens()

#: An exact parameter: rational, or a certified root.
Parameter = mpq | Root
#: Three polynomials: a vector along a curve, or over a patch.
Three = list[fmpz_poly]
ThreeOfTwo = list[fmpz_mpoly]
#: A patch as its rows in z = (s − a)/(b − s), one for each power of (t − c)/(d − t).
Rows = list[fmpz_poly]

#: Halvings before a box is assumed to hold a common zero, and boxes before the search stops.
DEPTH, BOXES = 9, 3000
#: Nanoseconds for a coefficient of a patch to halve it, and for 100 bits of a coefficient on top of it.
HALVING, HALVING_BITS = 4000, 500
#: Hundredths of a nanosecond, times the square of the degree and the bits of a form, to make it and to isolate its
#: roots.
ISOLATION = 80
#: Nanoseconds for a product of balls, and for each bit of them.
BALL, BALL_BITS = 300, 4
#: Evaluations of a polynomial to refine a root of it to the precision of the balls.
REFINED = 4
#: Bits of precision with which it is first asked whether a polynomial vanishes at two irrational numbers, and bits with
#: which it is not asked any more.
SHORTEST, LONGEST = 512, 1 << 19


class Euclidean(Scalar, Protocol):
    """A polynomial in one parameter over the whole numbers or a field."""

    def __mul__(self, other: Self | int, /) -> Self: ...
    def __floordiv__(self, other: Self, /) -> Self: ...
    def gcd(self, other: Self, /) -> Self:
        """The greatest common divisor."""


E = TypeVar("E", bound=Euclidean)


# ---- one parameter


def of_segment(f: BSpline, i: int) -> tuple[fmpz_poly, int]:
    """The polynomial of one segment in the spline's own parameter, and its positive denominator.

    >>> of_segment(BSpline.bezier([0, 0, 1], 0, 2), 0)
    (x^2, 4)
    """
    a, b = f.mesh.breaks[i : i + 2]
    m = lcm(int(a.denominator), int(b.denominator))
    low, high = int(mpq(a * m)), int(mpq(b * m))
    n = max(f.degree, 0)
    top = substituted(f.polynomials[i], n, fmpz_poly([high, -m]), fmpz_poly([-low, m]))
    bottom = f.denominators[i] * (high - low) ** n
    common = top.content().gcd(bottom)
    return (top // common, int(bottom // common)) if top else (top, 1)


def as_form(p: fmpz_poly, n: int, a: mpq, b: mpq) -> fmpz_poly:
    """The form of degree n over [a, b] of a polynomial, up to a positive constant that depends on n alone."""
    m = lcm(int(a.denominator), int(b.denominator))
    return substituted(p, n, fmpz_poly([m, m]), fmpz_poly([int(mpq(a * m)), int(mpq(b * m))]))


def as_splines(polynomials: Sequence[fmpz_poly], a: mpq, b: mpq) -> list[BSpline]:
    """Polynomials as splines of one degree over [a, b], up to one positive constant.

    >>> [f("1/2") for f in as_splines([fmpz_poly([0, 2]), fmpz_poly([1])], mpq(0), mpq(1))]
    [mpq(1,1), mpq(1,1)]
    """
    n, mesh = max(0, *[p.degree() for p in polynomials]), Mesh([a, b])
    return [BSpline.from_forms(n, mesh, (), [(as_form(p, n, a, b), ONE)]) for p in polynomials]


def roots_in(p: fmpz_poly, a: mpq, b: mpq) -> list[Root]:
    """The real roots of a polynomial in [a, b], in order, each once.

    >>> [root.exact for root in roots_in(fmpz_poly([0, -1, 0, 4]), mpq(0), mpq(1))]
    [mpq(0,1), mpq(1,2)]
    """
    if not p:
        return []
    check_isolation(p, height_bits(to_fmpz(x) for end in (a, b) for x in (end.numerator, end.denominator)))
    try:
        factors = factorize(p).bases
    except ReachError:  # with irreducible factors roots are refined faster, but these have the same
        factors = factorize_square_free(p).bases
    return sorted(root for q in factors for root in zeros(as_splines([q], a, b)[0]))


def check_isolation(p: fmpz_poly, bits: int = 0) -> None:
    """`ReachError` where isolating the roots of a polynomial, between ends of this many bits, would take too long."""
    cost = p.degree() ** 2 * (height_bits(p.coeffs()) + p.degree() * (1 + bits)) * ISOLATION // 100
    check_reach(cost, lambda: f"the isolation of the roots of a polynomial of degree {p.degree()}", QUESTION)


def common_divisor(polynomials: Iterable[E]) -> E:
    """The greatest common divisor of polynomials in one parameter; `ReachError` where that would take too long."""
    found = list(polynomials)
    if isinstance(found[0], fmpz_poly):
        return greatest_common_divisor(found)  # type: ignore[type-var]  # all of them are of one type
    return reduce(lambda p, q: p.gcd(q), found)


def exactly(t: Parameter) -> Parameter:
    """The rational number itself where a root is one."""
    return t if not isinstance(t, Root) or t.exact is None else t.exact


# ---- two parameters


def lifted(p: fmpz_poly, variable: int) -> fmpz_mpoly:
    """A polynomial of one parameter as one of both: variable 0 is s, 1 is t."""
    return CONTEXT.from_dict({(k, 0) if variable == 0 else (0, k): x for k, x in enumerate(p.coeffs()) if x})


def in_one(p: fmpz_mpoly, variable: int) -> fmpz_poly:
    """A polynomial in both parameters in which only one of them occurs."""
    found = {int(powers[variable]): x for powers, x in p.terms()}
    return fmpz_poly([found.get(k, 0) for k in range(max(found, default=-1) + 1)])


def rows_of(p: fmpz_mpoly) -> Rows:
    """The coefficients, polynomials in s, of the powers of t.

    >>> rows_of(S * T + 2)
    [2, x]
    """
    found: list[dict[int, int]] = [{} for _ in range(int(p.degrees()[1]) + 1)] if p else []
    for (i, j), x in p.terms():
        found[int(j)][int(i)] = int(x)
    return [fmpz_poly([row.get(k, 0) for k in range(max(row, default=-1) + 1)]) for row in found]


def at(p: fmpz_mpoly, variable: int, value: mpq) -> fmpz_poly:
    """The polynomial in the other parameter when one is a rational number, up to a positive constant.

    >>> at(S * T + 2, 0, mpq(1, 2))
    x + 4
    """
    rows = rows_of(p if variable == 0 else p.compose(T, S))
    n = max((row.degree() for row in rows), default=0)
    bottom = int(value.denominator)
    numerator = fmpz_poly([int(value.numerator)])
    values = [substituted(row, max(n, 0), fmpz_poly([bottom]), numerator)[0] for row in rows]
    return fmpz_poly(values)


def value_at(p: fmpz_mpoly, s: mpq, t: mpq) -> mpq:
    """The exact value at rational parameters, up to a positive constant that depends on s and the degree alone."""
    return from_flint(at(p, 0, s)(to_fmpq(t)))


def ball(t: Parameter, digits: int) -> arb:
    """A ball around a parameter; the precision of FLINT is the caller's."""
    low, high = t.refine(digits) if isinstance(t, Root) else (t, t)
    return arb(to_fmpq(low)).union(arb(to_fmpq(high))) if low < high else arb(to_fmpq(low))


def enclosed(p: fmpz_mpoly, s: arb, t: arb) -> arb:
    """A ball with the values of a polynomial over two balls."""
    return arb_poly([arb_poly(row)(s) for row in rows_of(p)])(t)


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
    assert not isinstance(value, Root)  # two roots are done
    parts = [q for p in polynomials if (q := at(p, variable, rational(value)))]
    if not parts:
        return True
    if not isinstance(other, Root):
        return all(q(to_fmpq(other)) == 0 for q in parts)
    return all(other.is_root_of(q) for q in parts)


def _vanishes(p: fmpz_mpoly, s: Root, t: Root) -> bool | None:
    """Whether a polynomial vanishes at two irrational parameters; None beyond the longest precision.

    A value that is not zero is at least ``2^−bits`` by Liouville's inequality: balls of growing precision show either
    that it is not zero, or that it is smaller than that.
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


def least_value(p: fmpz_mpoly, first: fmpz_poly, second: fmpz_poly) -> int:
    """A number b such that p is 0 or of a size of at least ``2^−b`` at a root of one integer polynomial and a root of
    another.

    Liouville's inequality: the sizes of an algebraic number at all places of its field multiply to 1. At the others it
    is at most the sum of the coefficients of p times powers of the Mahler measures, and these are at most Euclid's
    norms of both polynomials (Waldschmidt, Diophantine Approximation on Linear Algebraic Groups, 2000, §3.5).

    >>> least_value(S - T, fmpz_poly([-2, 0, 1]), fmpz_poly([-3, 0, 1]))
    16
    """
    m, n = (int(k) for k in p.degrees())
    total = sum(abs(int(x)) for x in p.coeffs())
    size = first.degree() * second.degree() * total.bit_length()
    return size + m * second.degree() * _norm_bits(first) + n * first.degree() * _norm_bits(second)


def _norm_bits(p: fmpz_poly) -> int:
    """The logarithm to base 2 of Euclid's norm of the coefficients, rounded up."""
    return (sum(int(x) ** 2 for x in p.coeffs()).bit_length() + 1) // 2


def _primitive(p: fmpz_poly) -> fmpz_poly:
    return p // p.content()


# ---- boxes


def possible_boxes(polynomials: Sequence[fmpz_mpoly], sides: Box) -> list[Box]:
    """Boxes that hold all common zeros on a closed rectangle; none is a proof that there are none.

    A box is left out where all Bernstein coefficients of one of the polynomials are of one strict sign.

    >>> from exactspline.numbers.intervals import UNIT
    >>> possible_boxes([S - T, S + T - 3], UNIT)
    []
    """
    patches = [_patch(p, sides) for p in polynomials if p]
    cost = sum(_halving(*patch) for patch in patches)
    todo = [(0, sides, patches)]
    found: list[Box] = []
    steps = 0
    while todo:
        depth, box, forms = todo.pop()
        if any(_keeps_sign(rows, m) for rows, m in forms):
            continue
        steps += 1
        if depth == DEPTH or steps > BOXES or not affords(cost):
            found.append(box)
            continue
        parts = [halved(rows, m, depth % 2) for rows, m in forms]
        todo += [(depth + 1, half, [pair[k] for pair in parts]) for k, half in enumerate(box.halves(depth % 2))]
    return found


def _patch(p: fmpz_mpoly, sides: Box) -> tuple[Rows, int]:
    """A polynomial as rows over a rectangle, and its degree in s."""
    (a, b), (c, d) = sides
    rows = rows_of(p)
    m, n = (int(k) for k in p.degrees())
    rows = crossed([as_form(row, m, a, b) for row in rows], m)
    return crossed([as_form(row, n, c, d) for row in rows], n), m


def crossed(rows: Rows, m: int) -> Rows:
    """Rows of degree m exchanged with columns."""
    return [fmpz_poly([row[i] for row in rows]) for i in range(m + 1)]


def _halving(rows: Rows, m: int) -> int:
    """An estimate in nanoseconds of halving a patch on the way to the smallest boxes."""
    n = len(rows) - 1
    bits = max(height_bits(row.coeffs()) for row in rows) + DEPTH // 2 * (m + n)
    return (m + 1) * (n + 1) * (HALVING + HALVING_BITS * bits // 100)


def _keeps_sign(rows: Rows, m: int) -> bool:
    sign = rows[0][0]
    if sign == 0:
        return False
    if sign > 0:
        return all(row[i] > 0 for row in rows for i in range(m + 1))
    return all(row[i] < 0 for row in rows for i in range(m + 1))


def halved(rows: Rows, m: int, direction: int) -> tuple[tuple[Rows, int], tuple[Rows, int]]:
    """A patch of degree m in the first parameter on the two halves of its rectangle, up to one positive constant."""
    if direction == 0:
        pairs = [halves(row, m) for row in rows]
        return ([left for left, _ in pairs], m), ([right for _, right in pairs], m)
    n = len(rows) - 1
    pairs = [halves(row, n) for row in crossed(rows, m)]
    return (crossed([left for left, _ in pairs], n), m), (crossed([right for _, right in pairs], n), m)
