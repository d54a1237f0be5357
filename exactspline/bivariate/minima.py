"""The least value of a quotient of functions of two parameters on a rectangle, and where it is taken, exactly: at
points inside, on edges, at corners, along curves.

Inside a patch the least value is taken at common zeros of both derivatives; those with a value above a known value are
not computed. Along the zeros of a common factor of the derivatives the value is constant.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from exactspline.bivariate.across_borders import Place, Spot, single_places, together
from exactspline.bivariate.answers import SurfacePart, SurfacePlaces
from exactspline.bivariate.borders import EDGES, Patch
from exactspline.bivariate.common_zeros import CommonZero
from exactspline.bivariate.quotients import BOUND, Quotient, keep_least, quotient_on
from exactspline.bivariate.zeros import budget_for, patches_of
from exactspline.errors import ReachError
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import UNIT, Box, Interval
from exactspline.polynomials.cost import drawing_on
from exactspline.polynomials.two_parameters import at
from exactspline.reals.real import Real
from exactspline.roots.of_polynomials import distinct, roots_in
from exactspline.roots.root import Root
from exactspline.splines.surface import Along
from exactspline.splines.tensor import TensorSpline, aligned

#: A value, and the place where it is taken: a point, or a part all of whose points have the value.
Found = tuple[Real, Place | SurfacePart]


def minima(top: TensorSpline, bottom: TensorSpline, closed: Sequence[Along] = ()) -> tuple[Real, SurfacePlaces[Place]]:
    """The least value of a quotient with a positive denominator, and where it is taken; at knots the limits from all
    sides count as values. `closed` are the parameters whose two ends are identified.

    >>> knots = [0, 0, 0, 1, 1, 1]
    >>> f = TensorSpline((2, 2), knots, knots, [[2, 0, 2], [0, -2, 0], [2, 0, 2]])  # (2s − 1)² + (2t − 1)²
    >>> value, places = minima(f + 3, f.constant(1))
    >>> value, places[0].exact
    (<Real 3>, (mpq(1,2), mpq(1,2)))

    Raises `ReachError` if this would take too long.
    """
    (f, g), ends = aligned(top, bottom), set[Spot]()
    with drawing_on(budget_for(f)):
        given = [(patch, quotient_on(patch, f, g)) for patch, _ in patches_of(f)]
        bound = min(x.value(s, t).enclosure(BOUND).high for _, x in given for s in UNIT.first for t in UNIT.second)
        near = [(patch, x) for patch, x in given if x.excess(bound).sign != 1]
        found = [one for patch, x in near for one in _on_border(patch, x, bound)]
        bound = min(value.enclosure(BOUND).high for value, _ in found)
        found += [one for patch, x in near if any(x.slopes) for one in _inside(patch, x, bound, ends)]
        keep_least(found, BOUND)
    parts = dict.fromkeys(part for _, part in found if isinstance(part, SurfacePart))
    places, boxes = [x for _, x in found if isinstance(x, Place)], [x.sides for x in parts if not x.along_curve]
    groups = single_places(places, boxes, ends, f.domain, closed)
    return found[0][0], SurfacePlaces(tuple(map(together, groups)), tuple(parts))


def _line(patch: Patch, sides: Box, direction: int, local: mpq) -> SurfacePart:
    """A line of a patch at a local parameter."""
    return SurfacePart(patch, sides.with_side(direction, Interval.point(sides[direction].at(local))))


def _on_border(patch: Patch, f: Quotient, bound: mpq) -> Iterator[Found]:
    """The points of edges at which a quotient may be least, and edges and patches on which it is constant, if the value
    is at most a bound.
    """
    excess, whole = f.excess(bound), SurfacePart(patch, f.sides)
    for edge in [edge for edge in EDGES if min(excess.edge(*edge)) <= 0]:
        slope = at(f.slopes[1 - edge.direction], edge.direction, mpq(edge.end))
        part = _line(patch, f.sides, edge.direction, mpq(edge.end)) if any(f.slopes) else whole
        for local in [edge.place(UNIT, t) for t in distinct([*UNIT.first, *roots_in(slope, *UNIT.first)])]:
            yield f.value(*local), Place((patch,), CommonZero(f.sides, local)) if slope else part


def _inside(patch: Patch, f: Quotient, bound: mpq, ends: set[Spot]) -> Iterator[Found]:
    """The points inside a patch at which a quotient may be least, and curves on which it is constant; the end points of
    these curves are added to `ends`.
    """
    points, arcs, undecided = f.critical(bound)
    if undecided:
        raise ReachError(f"the least value over {f.sides.shortly}", remedy="take a part of the surface (restrict)")
    met = {place for _, arc in arcs for place in (arc.start, arc.end)}
    ends |= {CommonZero(f.sides, place).place for place in met}
    for _, arc in arcs:
        lines = [(k, x) for k, x in enumerate(arc.start) if x == arc.end[k] and not isinstance(x, Root)]
        parts = [_line(patch, f.sides, k, x) for k, x in lines] or [SurfacePart(patch, f.sides, along_curve=True)]
        yield f.value(*arc.inner), parts[0]
    for zero, pair in points:
        if not arcs or zero.local not in met:
            yield f.at(zero, pair), Place((patch,), zero.on(f.sides))
