"""The zeros of an irreducible polynomial in two parameters on the unit square, as arcs along which both are monotone.

The square is cut at every s of a zero on its border and of a zero at which a derivative vanishes. Between two cuts the
zeros are graphs, of which rational lines near a cut show at which zero over it each of them ends.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

from flint import fmpz_mpoly, fmpz_poly

from exactspline.bivariate.common_zeros import Column, CommonZero, common_zeros
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import UNIT, Box
from exactspline.polynomials.two_parameters import at, in_one
from exactspline.reals.real import between
from exactspline.roots.of_polynomials import Parameter, Place, distinct, exactly, roots_in
from exactspline.roots.root import Root


class MonotoneArc(NamedTuple):
    """An arc of zeros: its ends, and a point on it of which one parameter is rational."""

    start: Place
    end: Place
    inner: Place


def monotone_arcs(p: fmpz_mpoly) -> tuple[list[MonotoneArc], list[CommonZero]]:
    """The zeros of an irreducible polynomial: the arcs between points of the border and zeros at which a derivative
    vanishes; and these zeros, single points among them. A polynomial in one parameter vanishes along whole lines.

    >>> from exactspline.polynomials.two_parameters import S, T
    >>> ((arc,), turning) = monotone_arcs(2 * S * S - T)
    >>> arc.start, arc.end[0].minimal_polynomial(), arc.end[1], turning
    ((mpq(0,1), mpq(0,1)), [-1, 0, 2], mpq(1,1), [<common zero near 0.000000 and 0.000000>])
    >>> monotone_arcs((2 * S - 1) ** 2 + (3 * T - 1) ** 2)
    ([], [<common zero near 0.500000 and 0.333333>])

    Raises `ReachError` where this would take too long.
    """
    for k in (0, 1):
        if p.degrees()[1 - k] == 0:
            roots = [exactly(x) for x in roots_in(in_one(p, k), *UNIT[k])]
            ends = [[(x, y) if k == 0 else (y, x) for y in UNIT[1 - k]] for x in roots]
            return [MonotoneArc(start, end, start) for start, end in ends], []
    turning = common_zeros([p, p.derivative(0) * p.derivative(1)], UNIT)
    marks = [*border_pairs(p, UNIT), *(zero.place for zero in turning)]
    cuts = distinct([mpq(0), mpq(1), *(s for s, _ in marks)])
    fibres = [_fibre(p, s) for s in cuts]
    found, open_arcs = list[MonotoneArc](), dict[int, MonotoneArc]()
    for (low, before), (high, behind) in pairwise(zip(cuts, fibres, strict=True)):
        s = between(low, high)
        graphs = [exactly(t) for t in roots_in(at(p, 0, s), *UNIT.second)]
        going_on = dict[int, MonotoneArc]()
        for a, b, t in zip(_ends(p, before, low, high), _ends(p, behind, high, low), graphs, strict=True):
            arc = MonotoneArc(open_arcs[a].start if a in open_arcs else (low, before[a]), (high, behind[b]), (s, t))
            if arc.end in marks:
                found.append(arc)
            else:
                going_on[b] = arc
        open_arcs = going_on
    return found, turning


def _fibre(p: fmpz_mpoly, s: Parameter) -> list[Parameter]:
    """All t in [0, 1] of zeros over a number s, in ascending order."""
    if not isinstance(s, Root):
        return [exactly(t) for t in roots_in(at(p, 0, s), *UNIT.second)]
    column = Column.of([p], fmpz_poly(s.minimal_polynomial()))
    return [t for t in column.candidates if column.contains(s, t)]


def _ends(p: fmpz_mpoly, fibre: Sequence[Parameter], near: Parameter, far: Parameter) -> Iterator[int]:
    """For each graph between two cuts, in ascending order, the number of the zero over the near cut at which it ends:
    on a line so near that no graph crosses a height between two of these zeros on the way.
    """
    heights = [between(a, b) for a, b in pairwise(fibre)]
    crossed = [s for t in heights for s in roots_in(at(p, 1, t), *UNIT.first)]
    if near < far:
        line = between(near, min([far, *(s for s in crossed if s > near)]))
    else:
        line = between(max([far, *(s for s in crossed if s < near)]), near)
    return (sum(height < t for height in heights) for t in roots_in(at(p, 0, line), *UNIT.second))


def border_pairs(p: fmpz_mpoly, sides: Box) -> list[Place]:
    """The zeros on the border of a rectangle, each once.

    >>> from exactspline.polynomials.two_parameters import S, T
    >>> border_pairs(S - T, UNIT)
    [(mpq(0,1), mpq(0,1)), (mpq(1,1), mpq(1,1))]
    """
    pairs: list[Place] = []
    for variable in (0, 1):
        for value in sides[variable]:
            for root in roots_in(at(p, variable, value), *sides[1 - variable]):
                place = (value, exactly(root)) if variable == 0 else (exactly(root), value)
                if place not in pairs:
                    pairs.append(place)
    return pairs
