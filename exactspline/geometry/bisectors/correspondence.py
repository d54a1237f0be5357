"""The real zeros of an irreducible equation G(s, t) = 0 on a rectangle: as the graph of a quotient, or as certified
branches between the parameters at which their number can change.
"""

from __future__ import annotations

from itertools import pairwise
from operator import itemgetter

from flint import ctx, fmpz_mpoly, fmpz_poly

from exactspline.bivariate.common_zeros import common_zeros
from exactspline.geometry.bisectors.components import Branch
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Box, Interval
from exactspline.polynomials.bernstein import substituted
from exactspline.polynomials.elimination import discriminant
from exactspline.polynomials.two_parameters import at, enclosed, rows_of
from exactspline.reals.real import between
from exactspline.roots.of_polynomials import Parameter, Place, ball, distinct, exactly, roots_in


def graph_intervals(
    top: fmpz_poly, bottom: fmpz_poly, own: Interval, range_: Interval
) -> list[tuple[Parameter, Parameter]]:
    """The maximal closed intervals on which the quotient lies in a closed range, single parameters included.

    >>> graph_intervals(fmpz_poly([0, 1]), fmpz_poly([1]), (mpq(0), mpq(2)), (mpq(1), mpq(3)))
    [(mpq(1,1), mpq(2,1))]
    """
    low, high = own
    borders = [top * int(y.denominator) - bottom * int(y.numerator) for y in range_]
    hits = distinct(root for border in borders for root in roots_in(border, low, high))
    cuts = distinct([low, *roots_in(bottom, low, high), *hits, high])
    intervals: list[tuple[Parameter, Parameter]] = []
    for a, b in pairwise(cuts):
        x = between(a, b)
        y = _value_at_rational(top, x) / _value_at_rational(bottom, x)
        if range_[0] <= y <= range_[1]:
            if intervals and intervals[-1][1] == a:
                intervals[-1] = (intervals[-1][0], b)
            else:
                intervals.append((a, b))
    single = [t for t in hits if not any(a <= t <= b for a, b in intervals)]
    return sorted([*intervals, *((t, t) for t in single)], key=itemgetter(0))


def _value_at_rational(p: fmpz_poly, x: mpq) -> mpq:
    """The value of an integer polynomial at a rational number."""
    n, m = max(p.degree(), 0), int(x.denominator)
    value = substituted(p, n, fmpz_poly([m]), fmpz_poly([int(x.numerator)]))[0]
    return mpq(int(value), m**n)


def branches(g: fmpz_mpoly, sides: Box) -> list[Branch]:
    """The real branches of an equation of degree at least 2 in both parameters, strictly inside the rectangle.

    Between two parameters s at which the discriminant, the first coefficient or the value on a side of the rectangle
    vanishes, the number of roots inside does not change. `ReachError` where the discriminant would take too long.

    >>> from exactspline.polynomials.two_parameters import S, T
    >>> square = (mpq(-2), mpq(2))
    >>> [(b.index, b.sample[0]) for b in branches(S * S + T * T - 1, (square, square))]
    [(0, mpq(0,1)), (1, mpq(0,1))]
    """
    own, other = sides
    critical = [discriminant(rows_of(g)), rows_of(g)[-1], *(at(g, 1, y) for y in other)]
    cuts = distinct([*own, *(root for p in critical for root in roots_in(p, *own))])
    branches_of_equation = []
    for low, high in pairwise(cuts):
        s = between(low, high)
        inside = [exactly(t) for t in roots_in(at(g, 0, s), *other)]
        branches_of_equation += [Branch(low, high, k, (s, t)) for k, t in enumerate(inside)]
    return branches_of_equation


def nodes(g: fmpz_mpoly, sides: Box) -> list[Place]:
    """The singular pairs of an irreducible equation that need not be limits of branches: where the Hessian is negative
    two branches cross. Raises `ReachError` where this would take too long.

    >>> from exactspline.polynomials.two_parameters import S, T
    >>> side = Interval(mpq(-1, 2), mpq(1, 2))
    >>> nodes(S**3 - S * S - T * T, Box(side, side))
    [(mpq(0,1), mpq(0,1))]
    """
    first, second = g.derivative(0), g.derivative(1)
    crossing = first.derivative(1) ** 2 - first.derivative(0) * second.derivative(1)
    singular = (zero.place for zero in common_zeros([g, first, second], sides))
    return [place for place in singular if not _certainly_positive(crossing, place)]


def _certainly_positive(p: fmpz_mpoly, place: Place) -> bool:
    with ctx.workprec(400):
        return bool(enclosed(p, ball(place[0], 40), ball(place[1], 40)) > 0)
