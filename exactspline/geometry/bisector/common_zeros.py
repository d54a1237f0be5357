"""The common zeros of two polynomials in two parameters on a rectangle, each certified.

Resultants give all parameters that a common zero can have; balls exclude the other pairs. A remaining pair is proved by
the interval Newton method in Krawczyk's form: a box around it holds a common zero, and no other root of the resultants.
A pair of rational parameters is decided by exact evaluation.

Source: Krawczyk, Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken, Computing 1969.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from flint import arb, ctx, fmpz_mpoly, fmpz_poly, nmod_poly

from exactspline.errors import ReachError
from exactspline.geometry.bisector.polynomials import certainly_not_zero, vanish_together
from exactspline.numbers.exact import to_fmpq
from exactspline.numbers.intervals import Box, Interval, hull
from exactspline.polynomials.cost import affords, check_reach
from exactspline.polynomials.elimination import resultant
from exactspline.polynomials.factors import factorize
from exactspline.polynomials.two_parameters import S, T, enclosed, possible_boxes, rows_of
from exactspline.roots.of_polynomials import Parameter, exactly, roots_in
from exactspline.roots.root import Root

#: A pair of parameters.
Place = tuple[Parameter, Parameter]
#: The largest number of common zeros, real and complex, for which an elimination is tried.
REACH = 1000
#: Primes modulo which a factor of a resultant is tried.
PRIMES = ((1 << 61) - 1, (1 << 61) - 31, (1 << 62) - 57, (1 << 62) - 87)
#: Nanoseconds, per square of the degree, to find the roots of an image (measured: 700 to 2300).
ROOTS = 2000
#: Nanoseconds, per term of the polynomials, to exclude or to prove a pair of parameters.
PAIR = 3000
#: The fraction of a side within which roots just outside it are isolated too, and the radii of boxes that are tried.
MARGIN, RADII = 16, (12, 24, 40, 80, 160)


class CommonZeros(NamedTuple):
    """Certified pairs, and pairs that could not be decided (the precision did not suffice, or the zero is multiple);
    ``out_of_reach`` means that nothing was tried.
    """

    places: list[Place]
    undecided: list[Place]
    out_of_reach: bool = False


def common_zeros(
    f: fmpz_mpoly, g: fmpz_mpoly, sides: Box, also: Sequence[fmpz_mpoly] = (), known: Sequence[Place] = ()
) -> CommonZeros:
    """The common zeros of two coprime polynomials on a closed rectangle, except those at which one of the `others` is
    certainly nonzero.

    `known` are zeros that have already been proved.

    >>> from exactspline.polynomials.two_parameters import S, T
    >>> from exactspline.numbers.intervals import UNIT
    >>> common_zeros(S * S + T * T - 1, S - T, UNIT).places[0][0].minimal_polynomial()
    [-1, 0, 2]
    """
    boxes = possible_boxes([f, g, *also], sides)
    if not boxes:
        return CommonZeros([], [])
    (m, n), (k, h) = f.degrees(), g.degrees()
    if m * h + n * k > REACH:
        return CommonZeros([], [], out_of_reach=True)
    try:
        return _among(boxes, f, g, sides, also, known)
    except ReachError:
        return CommonZeros([], [], out_of_reach=True)


def _among(
    boxes: Sequence[Box], f: fmpz_mpoly, g: fmpz_mpoly, sides: Box, also: Sequence[fmpz_mpoly], known: Sequence[Place]
) -> CommonZeros:
    """The common zeros in boxes that together contain all of them. Raises `ReachError` where that would take
    too long.
    """
    ranges = [side.grown(side.width / MARGIN) for side in hull(boxes)]
    roots_of_both = [_parameters(f, g, also, variable, ranges[variable]) for variable in (0, 1)]
    known_roots = [_Known(roots, side) for (_, roots), side in zip(roots_of_both, ranges, strict=True)]
    cost = PAIR * sum(len(p) for p in (f, g, *also))
    candidates = [kept for kept, _ in roots_of_both]
    places, undecided = [], []
    for s in (x for x in candidates[0] if _inside(x, sides[0])):
        for t in (x for x in candidates[1] if _inside(x, sides[1])):
            if not any(_touches(s, box[0]) and _touches(t, box[1]) for box in boxes):
                continue
            if any(s == x and t == y for x, y in known):
                places.append((exactly(s), exactly(t)))
                continue
            check_reach(cost, lambda: "the comparison of all pairs of possible parameters")
            if (verdict := _is_zero(f, g, also, (s, t), known_roots)) is None:
                undecided.append((exactly(s), exactly(t)))
            elif verdict:
                places.append((exactly(s), exactly(t)))
    return CommonZeros(places, undecided)


class _Known(NamedTuple):
    """All real roots of a resultant on an interval."""

    roots: list[Root]
    side: Interval

    def around(self, t: Root, bits: int) -> Interval | None:
        """An interval around a root that contains no other root and no end of the known intervals."""
        low, high = t.refine(bits // 3 + 8)
        radius = self.side.width / (1 << bits)
        first, last = low - 2 * radius, high + 2 * radius
        if not self.side[0] < first < last < self.side[1] or any(x is not t and first <= x <= last for x in self.roots):
            return None
        return Interval(low, high).grown(radius)


def _inside(t: Root, side: Interval) -> bool:
    return bool(side[0] <= t <= side[1])


def _touches(t: Root, side: Interval) -> bool:
    return t.refine(6).meets(side)


def _parameters(
    f: fmpz_mpoly, g: fmpz_mpoly, also: Sequence[fmpz_mpoly], variable: int, side: Interval
) -> tuple[list[Root], list[Root]]:
    """The real roots of the resultant on an interval: those at which all polynomials may vanish, and all roots."""
    rows = [rows_of(p if variable == 0 else p.compose(T, S)) for p in (f, g)]
    kept: list[Root] = []
    every: list[Root] = []
    for factor in factorize(resultant(*rows)).bases:
        roots = roots_in(factor, *side)
        every += roots
        if roots and not _certainly_apart([f, g, *also], factor, variable):
            kept += roots
    return sorted(kept), sorted(every)


def _certainly_apart(polynomials: Sequence[fmpz_mpoly], factor: fmpz_poly, variable: int) -> bool:
    """Whether the polynomials have no common zero at any root of an irreducible factor: their images modulo a prime at
    a root have none, and the first image has the degree of its polynomial.
    """
    for prime in PRIMES:
        image = nmod_poly([int(x) % prime for x in factor.coeffs()], prime)
        if image.degree() != factor.degree():
            continue
        if not affords(ROOTS * factor.degree() ** 2):
            return False
        roots = image.roots()
        if not roots:
            continue
        parts = [_image(p, int(roots[0][0]), prime, variable) for p in polynomials]
        if parts[0].degree() != int(polynomials[0].degrees()[1 - variable]):
            continue
        common = parts[0]
        for part in parts[1:]:
            common = common.gcd(part)
        return bool(common.degree() == 0)
    return False


def _image(p: fmpz_mpoly, root: int, prime: int, variable: int) -> nmod_poly:
    rows = rows_of(p) if variable == 0 else rows_of(p.compose(T, S))
    values = [int(nmod_poly([int(x) % prime for x in row.coeffs()], prime)(root)) for row in rows]
    return nmod_poly(values, prime)


def _is_zero(
    f: fmpz_mpoly, g: fmpz_mpoly, also: Sequence[fmpz_mpoly], place: tuple[Root, Root], known: list[_Known]
) -> bool | None:
    """Whether f and g vanish at a pair and none of the others is certainly not zero there; None when undecided."""
    if any(certainly_not_zero(p, *place) for p in (f, g, *also)):
        return False
    s, t = exactly(place[0]), exactly(place[1])
    if isinstance(s, Root) and isinstance(t, Root):
        for bits in RADII:
            box = [own.around(x, bits) for x, own in zip(place, known, strict=True)]
            if all(side is not None for side in box) and _holds_a_zero(f, g, box, bits):
                return True
    return vanish_together((f, g, *also), s, t)


def _holds_a_zero(f: fmpz_mpoly, g: fmpz_mpoly, box: Sequence[Interval | None], bits: int) -> bool:
    """Krawczyk's test on a box: True proves that there is exactly one common zero in it."""
    with ctx.workprec(8 * bits + 256):
        sides = [arb(to_fmpq(low)).union(arb(to_fmpq(high))) for low, high in (side for side in box if side)]
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


__all__ = ["CommonZeros", "Place", "common_zeros"]
