"""Simple common zeros over an irrational number by certified lifting: balls exclude all but small intervals, Krawczyk's
test proves one zero in a box, and two eliminants say which numbers it has.

Source: Krawczyk, Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken, Computing 1969; Berberich,
Emeliyanenko, Kobel and Sagraloff, Exact symbolic-numeric computation of planar algebraic curves, Theoretical Computer
Science 2013.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from flint import arb, arb_poly, ctx, fmpz_mpoly, fmpz_poly

from exactspline.numbers.exact import mpq, to_fmpq
from exactspline.numbers.intervals import Interval, ball_around, joined
from exactspline.polynomials.cost import check_reach
from exactspline.polynomials.elimination import resultant
from exactspline.polynomials.factors import factorize
from exactspline.polynomials.two_parameters import S, T, enclosed, rows_of
from exactspline.roots.of_polynomials import Parameter, ball, exactly, roots_in
from exactspline.roots.root import Root
from exactspline.roots.vanishing import vanish_at

#: The part of an interval by which it is searched beyond its ends.
MARGIN = 16
#: The radii of boxes (bits) that are tried, and the largest number of intervals that balls may leave.
RADII, INTERVALS = (20, 40, 80, 160), 100
#: Nanoseconds per term of the polynomials and level of boxes, to exclude or to prove what is over one number.
LEVEL = 200_000


@dataclass
class Pair:
    """Two polynomials, and their resultant in s, which is not zero."""

    f: fmpz_mpoly
    g: fmpz_mpoly
    eliminant: fmpz_poly

    @cached_property
    def _others(self) -> list[fmpz_poly]:
        """The irreducible polynomials that all values t of common zeros are roots of."""
        own = resultant(*(rows_of(p.compose(T, S)) for p in (self.f, self.g)))
        return [p for p in factorize(own).bases if p.degree() > 0]

    def over(
        self, s: Root, given: Sequence[fmpz_mpoly], side: Interval, also: Sequence[fmpz_mpoly] = ()
    ) -> list[Parameter] | None:
        """All t in an interval at which the given polynomials vanish together with s, in ascending order, but for those
        at which one of the others is certainly not zero; both of the pair are combinations of the given ones. None
        where boxes do not decide, as at multiple zeros.

        Raises `ReachError` where it would take too long.
        """
        minimal = fmpz_poly(s.minimal_polynomial())
        for bits in RADII:
            check_reach(LEVEL * sum(map(len, (*given, *also))), lambda: "the common zeros over an irrational parameter")
            with ctx.workprec(8 * bits + 256):
                parts = _possible(s, [*given, *also], side, bits)
                if parts is None:
                    return None
                if not parts:
                    return []
                around = Interval(*s.refine(bits)).grown(mpq(1, 1 << bits))
                if not self._is_alone(minimal, around):
                    continue
                found = [self._in_box(around, part, bits) for part in parts]
            if all(t is not None for t in found):
                inside = [exactly(t) for t in found if t is not None and side.low <= t <= side.high]
                return inside if len(given) == 2 else [t for t in inside if vanish_at(given, s, t)]
        return None

    def _is_alone(self, minimal: fmpz_poly, around: Interval) -> bool:
        """Whether the eliminant has no root but one of the minimal polynomial in an interval."""
        rest = self.eliminant
        while not rest % minimal:
            rest //= minimal
        box = ball_around(*around)
        return not any(arb_poly(p)(box).contains(0) for p in (rest, minimal.derivative()))

    def _in_box(self, first: Interval, second: Interval, bits: int) -> Root | None:
        """The value t of the common zero in a box, if it is proved that there is exactly one."""
        wide = second.grown(max(second.width, mpq(1, 1 << bits)))
        if not _holds_a_zero(self.f, self.g, [ball_around(*first), ball_around(*wide)]):
            return None
        roots = [t for p in self._others for t in roots_in(p, *wide, whole=True)]
        return roots[0] if len(roots) == 1 else None


def _possible(s: Root, given: Sequence[fmpz_mpoly], side: Interval, bits: int) -> list[Interval] | None:
    """Small intervals that together have all t at which polynomials may vanish over s; None where there are many."""
    at_s, wide = ball(s, bits), side.grown(side.width / MARGIN)
    own = [arb_poly([arb_poly(row)(at_s) for row in rows_of(p)]) for p in given]
    low, step = arb(to_fmpq(wide.low)), arb(to_fmpq(wide.width))
    #: Parts of the interval by their numbers, after this many halvings of all of it.
    parts = [0]
    for _ in range(bits):
        step /= 2
        parts = [
            k
            for part in parts
            for k in (2 * part, 2 * part + 1)
            if all(_may_vanish(p, low + step * (2 * k + 1) / 2, step / 2) for p in own)
        ]
        if len(parts) > INTERVALS:
            return None
    width = wide.width / (1 << bits)
    return joined((wide.low + k * width, wide.low + (k + 1) * width) for k in parts)


def _may_vanish(p: arb_poly, middle: arb, radius: arb) -> bool:
    """Whether a polynomial may vanish near a number: its value there against the other terms of its Taylor series."""
    return bool(p(arb(middle, radius)).contains(0)) and bool(p(arb_poly([middle, radius]))(arb(0, 1)).contains(0))


def _holds_a_zero(f: fmpz_mpoly, g: fmpz_mpoly, sides: Sequence[arb]) -> bool:
    """Krawczyk's test on a box: True proves that there is exactly one common zero in it."""
    middle = [arb(x.mid()) for x in sides]
    (a, b), (c, d) = ([enclosed(p.derivative(i), *middle).mid() for i in (0, 1)] for p in (f, g))
    determinant = a * d - b * c
    if not determinant.is_finite() or determinant.contains(0):
        return False
    inverse = [[d / determinant, -b / determinant], [-c / determinant, a / determinant]]
    values = [enclosed(p, *middle) for p in (f, g)]
    slopes = [[enclosed(p.derivative(i), *sides) for i in (0, 1)] for p in (f, g)]
    for i in (0, 1):
        image = middle[i] - sum((inverse[i][k] * values[k] for k in (0, 1)), arb(0))
        for j in (0, 1):
            product = sum((inverse[i][k] * slopes[k][j] for k in (0, 1)), arb(0))
            image += (arb(int(i == j)) - product) * (sides[j] - middle[j])
        if not sides[i].contains_interior(image):
            return False
    return True


__all__ = ["Pair"]
