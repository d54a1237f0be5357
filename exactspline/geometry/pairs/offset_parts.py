"""The true parts of the offset of a simple closed plane curve. A point of the offset lies on the normal at a point of
the curve, its foot, or on a circle about a corner, at the distance d; it is true if no point of the curve is nearer to
it.

The offset is cut where it meets itself, including the arcs of circles about the corners that turn away from it. Between
two cuts all points are true, or no point is: the true points form a closed set, and at an end of this set another point
of the curve is equally near. The other point is not close to the foot: where the curvature passes through 1/d, the
circle about the offset point crosses the curve at the foot, so that neither this point nor its neighbours are true. So
a rational parameter decides for all points between two cuts: by the sign of a polynomial between its zeros, and on arcs
about corners by the nearest point.

There is a true part if and only if some point on this side of the curve is farther from it than d. Such points form an
open set with infinitely many boundary points; the boundary points are true, and all except finitely many of them lie in
parts. Conversely, beyond a point of a part whose only nearest point is its foot there are points farther than d.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import pairwise, product
from typing import Any

from flint import fmpq_poly, fmpz_poly

from exactspline.constructors import circle
from exactspline.errors import ReachError, ShapeError
from exactspline.geometry.bisectors.plane_pair import tangent
from exactspline.geometry.curves.facts import facts_of
from exactspline.geometry.pairs.deviation import between_zeros, critical_places, foot_of
from exactspline.geometry.pairs.distance import Forms
from exactspline.geometry.pairs.nearest import over_the_seam
from exactspline.geometry.pairs.offsets import self_intersections
from exactspline.language.vector import Vector, det, norm2
from exactspline.numbers.exact import mpq, to_fmpq
from exactspline.numbers.intervals import UNIT, Interval, joined
from exactspline.polynomials.bernstein import in_parameter
from exactspline.polynomials.elimination import square_free
from exactspline.questions.answers import NamedNumbers
from exactspline.reals.real import Real, between, real
from exactspline.roots.answers import CurvePiece
from exactspline.roots.of_polynomials import roots_in
from exactspline.roots.segment_forms import segment_forms
from exactspline.roots.values import evaluate
from exactspline.splines.nurbs import Nurbs


def offset_parts(curve: Nurbs, d: mpq) -> tuple[NamedNumbers, ...]:
    """The parts by the parameters of the curve at their ends, in order (the end of a part across the seam is below its
    start); then the arcs about corners, counterclockwise.

    >>> square = Nurbs(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (4, 0), (4, 4), (0, 4), (0, 0)])
    >>> offset_parts(square, mpq(1))[0]
    <part: start 1/4, end 3/4>
    >>> [len(offset_parts(square, d)) for d in (mpq(19, 10), mpq(21, 10), mpq(-1))]
    [4, 0, 5]

    Raises `ShapeError` for a curve that is not simple, closed and in the plane, or turns back at a corner, and for the
    distance 0; and `ReachError` where parts of the offset may coincide or be single points.
    """
    turns = {x.parameter: (x.angle.sine * d).sign for x in facts_of(curve).joints if x.angle is not None}
    remedy = "give a closed plane curve that does not meet itself"
    if curve.dimension != 2 or not curve.closed or 0 in (d, *turns.values()):
        raise ShapeError(f"the offset of {curve}", remedy=remedy)
    if own := self_intersections(curve):
        place = next(iter((*own.points, *own.everywhere, *own.undecided)))
        raise ShapeError(f"the offset of {curve}, which meets itself: {place}", remedy=remedy)
    corners = [t for t, sign in turns.items() if sign < 0]
    met = self_intersections(curve, offset=d)
    if met.undecided:
        raise ReachError(met.undecided[0], remedy="take another distance")
    cuts = [t for point in met for t in (point.first, point.second)]
    for j, t in product(range(curve.segments), corners):
        x, y, w = _functions(curve, j, curve(t))
        velocity = Vector(*(f.derivative() * w - f * w.derivative() for f in (x, y)))
        cuts += _zeros_on(curve, j, [_nearer(velocity, Vector(x, y), w, d)[0].numer()])
    parts = _kept(curve, cuts, lambda s: _is_true(curve, s, d))
    found = [NamedNumbers("part", {"start": real(part.start), "end": real(part.end)}) for part in parts]
    for t in corners:
        found += [NamedNumbers("arc about a corner", {"corner": Real(t)} | ends) for ends in _arcs(curve, t, d)]
    return tuple(found)


def _arcs(curve: Nurbs, t: mpq, d: mpq) -> Iterator[dict[str, Real]]:
    """The ends of the arcs about a corner."""
    around, cuts = circle(curve(t), abs(d)), list[Real]()
    for i, j in product(range(around.segments), range(curve.segments)):
        forms = Forms(segment_forms(around, i), segment_forms(curve, j), UNIT)
        if forms.excess(d * d).sign != 1:
            cuts += _zeros_on(around, i, critical_places(forms.above(d * d)))
    for arc in _kept(around, cuts, lambda s: foot_of(curve, around(s), s).squared >= d * d):
        values = [real(x) for end in (arc.start, arc.end) for x in evaluate(around, real(end))]
        yield dict(zip(("start x", "start y", "end x", "end y"), values, strict=True))


def _functions(curve: Nurbs, j: int, point: Sequence[mpq]) -> tuple[fmpq_poly, fmpq_poly, fmpq_poly]:
    """w times the vector from a point to the points of a segment, and w, in its local parameter."""
    n, forms = segment_forms(curve, j)
    x, y, w = (fmpq_poly(in_parameter(f, n, UNIT.first)[0]) for f in forms)
    return x - w * to_fmpq(point[0]), y - w * to_fmpq(point[1]), w


def _nearer(velocity: Vector[Any], chord: Vector[fmpq_poly], w: fmpq_poly, d: mpq) -> tuple[fmpq_poly, fmpq_poly]:
    """Two polynomials: the first is negative and the second positive where a point of the curve is nearer to a point of
    the offset than its foot. With the tangent v at the foot and the vector c/w from the foot to the other point, this
    is ``‖v‖ c² < 2 d [v, c] w``.
    """
    across = det(velocity, chord) * w * to_fmpq(2 * d)
    return norm2(chord) ** 2 * norm2(velocity) - across * across, across


def _is_true(curve: Nurbs, s: mpq, d: mpq) -> bool:
    """Whether no point of the curve is nearer than the foot to the point of the offset at a rational parameter."""
    velocity = Vector(*(to_fmpq(f(s)) for f in tangent(curve)))
    for j in range(curve.segments):
        x, y, w = _functions(curve, j, curve(s))
        excess, across = _nearer(velocity, Vector(x, y), w, d)
        for t in between_zeros([square_free(excess.numer())] if excess else []):
            if excess(to_fmpq(t)) < 0 < across(to_fmpq(t)):
                return False
    return True


def _zeros_on(curve: Nurbs, j: int, polynomials: Iterable[fmpz_poly]) -> list[Real]:
    """The zeros of polynomials in the local parameter of a segment as parameters of the curve."""
    side = Interval(*curve.breakpoints[j : j + 2])
    return [real(zero.moved(side)) for p in polynomials for zero in roots_in(p, *UNIT.first)]


def _kept(curve: Nurbs, cuts: Iterable[Real], is_true: Callable[[mpq], bool]) -> tuple[CurvePiece, ...]:
    """The parts of a closed curve between cuts that are true at a parameter; adjacent parts are joined."""
    marks = sorted([*map(Real, curve.breakpoints), *cuts])
    cells = [cell for cell in pairwise(marks) if cell[0] < cell[1] and is_true(between(*cell))]
    return over_the_seam(curve, joined(cells))  # type: ignore[arg-type]  # real numbers in the place of rational ones
