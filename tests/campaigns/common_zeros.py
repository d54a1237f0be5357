"""Common zeros against elimination by another route: ``python -m tests.campaigns.common_zeros 400 1``.

The other route: FLINT's resultants in both directions, all their real roots to a thousand bits, and every pair of them
at which both polynomials are below 2⁻⁴⁰⁰. It shares no code with the library and knows no fields, boxes or signs. The
comparison stands beside the sentence of `docs/two-parameters.md` that it judges (`COMPARED`). It steps around pairs
with a common factor, and around several patches, kinds, places and multiplicities: tests compare those. What is out
of reach is counted for each family; the exit status is 1 where anything is different, or more than one per mille of a
family is left out.
"""

from __future__ import annotations

import sys
from random import Random

from flint import arb, ctx, fmpz_mpoly, fmpz_poly

from exactspline.bivariate.common_zeros import common_zeros
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Box, Interval
from exactspline.polynomials.two_parameters import CONTEXT, S, T
from tests.support.families import by_families

#: Per mille of the pairs of a family that may be out of reach.
CEILING = 1
BITS, SMALL = 1000, 400
SIDE = Interval(mpq(0), mpq(1))


def any_polynomial(random: Random, m: int, n: int, size: int = 9) -> fmpz_mpoly:
    """One of these degrees with random coefficients."""
    return CONTEXT.from_dict({(i, j): random.randint(-size, size) for i in range(m + 1) for j in range(n + 1)})


def _point(random: Random) -> tuple[fmpz_mpoly, fmpz_mpoly]:
    """Two linear polynomials that vanish at a rational point of the closed square, often on its border."""
    own = []
    for variable in (S, T):
        b = random.randint(1, 7)
        own.append(b * variable - random.choice((0, b, random.randint(0, b))))
    return own[0], own[1]


# ---- families


def generic(random: Random) -> tuple[fmpz_mpoly, fmpz_mpoly]:
    return any_polynomial(random, random.randint(1, 4), random.randint(1, 3)), any_polynomial(random, 3, 2)


def through(random: Random) -> tuple[fmpz_mpoly, fmpz_mpoly]:
    """With a rational common zero of multiplicity 1, 2, 4 or 6."""
    x, y = _point(random)
    m, n = random.choice(((1, 1), (1, 2), (2, 2), (2, 3)))
    f = sum((x**i * y ** (m - i) * any_polynomial(random, 1, 1, 5) for i in range(m + 1)), S * 0)
    g = sum((x**i * y ** (n - i) * any_polynomial(random, 1, 1, 5) for i in range(n + 1)), S * 0)
    return f, g


def irrational(random: Random) -> tuple[fmpz_mpoly, fmpz_mpoly]:
    """Multiple at irrational points: squares of generic ones in the ideal."""
    p = random.randint(2, 5) * S**2 - random.randint(1, 4)
    q = random.randint(2, 5) * T**2 - random.choice((1, 2, S + 1, S))
    f = p * any_polynomial(random, 1, 1, 5) + q * any_polynomial(random, 1, 1, 5)
    return f, random.choice((p * p + q * (S - 2 * T), p * q + p * p * 3, q * q - p * p))


def tangent(random: Random) -> tuple[fmpz_mpoly, fmpz_mpoly]:
    """Curves that touch to some order."""
    x, y = _point(random)
    curve = y - x**2 * random.randint(1, 3)
    k = random.randint(2, 4)
    return curve * any_polynomial(random, 1, 1, 3) + x**k * random.randint(1, 9), curve + x ** (k + 1) - y * x * curve


def lines(random: Random) -> tuple[fmpz_mpoly, fmpz_mpoly]:
    """Factors in one parameter alone, fibres with several zeros."""
    f = any_polynomial(random, 2, 0) * any_polynomial(random, 0, 2)
    return f, any_polynomial(random, 2, 2)


FAMILIES = {each.__name__: each for each in (generic, through, irrational, tangent, lines)}


def by_other_route(f: fmpz_mpoly, g: fmpz_mpoly) -> list[tuple[arb, arb]]:
    """The zeros in the closed unit square, as balls; a number that touches 0 or 1 counts as inside."""
    eliminants = [_real_roots(f.resultant(g, variable), k) for k, variable in ((0, "t"), (1, "s"))]
    found = []
    for s in eliminants[0]:
        for t in eliminants[1]:
            values = [_value(p, s, t) for p in (f, g)]
            if all(abs(x) < arb(2) ** -SMALL for x in values):
                found.append((s, t))
    return found


def _real_roots(p: fmpz_mpoly, k: int) -> list[arb]:
    coefficients = {int(e[k]): c for e, c in p.terms()}
    q = fmpz_poly([coefficients.get(i, 0) for i in range(max(coefficients, default=0) + 1)])
    one = fmpz_poly([1])
    for base, _ in q.factor()[1]:
        one *= base
    roots = [z.real for z, _ in one.complex_roots() if z.imag.contains(0) and abs(z.imag) < arb(2) ** -SMALL]
    margin = arb(2) ** -SMALL
    return [x for x in roots if x > -margin and x < 1 + margin]


def _value(p: fmpz_mpoly, s: arb, t: arb) -> arb:
    total = arb(0)
    for (i, j), x in p.terms():
        total += arb(x) * s ** int(i) * t ** int(j)
    return total


def other_points(f: fmpz_mpoly, g: fmpz_mpoly) -> str | None:
    """The points on the closed square by their numbers, each in a box of 25 digits. Of two functions alone."""
    found = common_zeros([f, g], Box(SIDE, SIDE))
    with ctx.workprec(BITS):
        other = by_other_route(f, g)
        if len(found) != len(other):
            return f"{len(found)} zeros, {len(other)} by the other route"
        for zero in found:
            box = [Interval(low - mpq(1, 1 << 90), high + mpq(1, 1 << 90)) for low, high in zero.box(25)]
            near = [pair for pair in other if all(_in(x, side) for x, side in zip(pair, box, strict=True))]
            if len(near) != 1:
                return f"{len(near)} zeros of the other route at {zero.place}"
    return None


#: What is compared, by the sentence of the documentation that it judges.
COMPARED = {
    "`common_zeros` finds all points at which two or more functions of two parameters vanish together": other_points
}


def difference(f: fmpz_mpoly, g: fmpz_mpoly) -> str | None:
    """What is different between the two routes, if anything."""
    return next((each for compare in COMPARED.values() if (each := compare(f, g))), None)


def _in(x: arb, side: Interval) -> bool:
    low, high = (arb(int(end.numerator)) / int(end.denominator) for end in side)
    return bool(low < x < high)


def differs(family: str, dial: str, seed: int) -> str | None:
    """What is different of one pair, if anything; its numbers are small integers whatever the dial."""
    f, g = FAMILIES[family](Random(f"{family} {seed}"))
    return difference(f, g) if f and g and f.gcd(g).total_degree() <= 0 else None


if __name__ == "__main__":
    sys.exit(by_families(__doc__, FAMILIES, ("small integers",), differs, sys.argv[1:], ceiling=CEILING))
