"""The common points of the offsets of two plane curves, and those at which the offset of a curve meets itself: pairs of
parameters whose normals meet, at the distances of the offsets.

These pairs are common zeros of two polynomials, one for each distance; if the distances are equal, one polynomial
vanishes where both points are equally far from the intersection of the normals. For a curve and itself both polynomials
vanish where s = t, and are divided by s − t. Where the normals are parallel, the polynomials vanish whether or not the
offsets meet; there the length of the chord decides.

The true parts of the offset of a simple closed plane curve: a point of the offset lies on the normal at a point of the
curve, its foot, or on a circle about a corner, at the distance d; it is true if no point of the curve is nearer to it.

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
from dataclasses import dataclass, replace
from itertools import groupby, pairwise, product
from math import ceil
from typing import Any, cast

from flint import fmpq_poly, fmpz_mpoly, fmpz_poly

from exactspline.bivariate.common_zeros import CommonZero, common_zeros, multiplicity
from exactspline.bivariate.singular_points import sign_at_point
from exactspline.constructors import circle
from exactspline.errors import ReachError, ShapeError, counted
from exactspline.geometry.bisectors.plane_pair import PlanePair, tangent
from exactspline.geometry.bisectors.system import piece
from exactspline.geometry.curves.facts import facts_of
from exactspline.geometry.curves.planarity import in_one_plane, in_the_plane
from exactspline.geometry.pairs.box_tree import pairs_that_may_meet, segments_of, shift_for
from exactspline.geometry.pairs.deviation import between_zeros, critical_places, foot_of
from exactspline.geometry.pairs.distance import Forms
from exactspline.geometry.pairs.intersections import Intersection, IntersectionKind, Intersections
from exactspline.geometry.pairs.intersections import intersections as intersections_of_curves
from exactspline.geometry.pairs.intersections import self_intersections as self_intersections_of_curve
from exactspline.geometry.pairs.nearest import over_the_seam
from exactspline.language.vector import Vector, det, dot, norm2
from exactspline.numbers.exact import Number, mpq, rational, to_fmpq
from exactspline.numbers.exact import sign as sign_of
from exactspline.numbers.intervals import UNIT, Box, Interval, Side, joined
from exactspline.numbers.once import cached_property
from exactspline.polynomials.bernstein import in_parameter
from exactspline.polynomials.cost import PATCH, QUESTION, Budget, drawing_on
from exactspline.polynomials.elimination import square_free
from exactspline.polynomials.factors import divided_out, factorize, greatest_common_divisor
from exactspline.polynomials.two_parameters import S, T, as_form
from exactspline.questions.answers import NamedNumbers
from exactspline.reals.real import RationalNumber, Real, between, real, square_root
from exactspline.roots.answers import CurvePiece
from exactspline.roots.of_polynomials import Parameter, roots_in
from exactspline.roots.root import Root
from exactspline.roots.segment_forms import segment_forms
from exactspline.roots.values import evaluate
from exactspline.roots.vanishing import vanish_at
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of, of_dimension


@dataclass(frozen=True, repr=False)
class OffsetIntersection(Intersection):
    """A common point of the offsets of two curves, or of a curve and itself, at signed `distances` (positive to the
    left), by the parameters of the curves. The multiplicity is None, and the kind a common point, where the normals are
    parallel.

    At a corner an offset has two ends: `sides` are the sides of each parameter from which the point is the limit (right
    elsewhere).
    """

    distances: tuple[mpq, mpq] = (mpq(), mpq())
    sides: tuple[Side, Side] = (Side.RIGHT, Side.RIGHT)

    @property
    def point(self) -> tuple[mpq | Real, ...]:
        """The coordinates, exactly."""
        k = int(not isinstance(self.first, RationalNumber) and isinstance(self.second, RationalNumber))
        curve, t, side, d = self.curves[k], (self.first, self.second)[k], self.sides[k], self.distances[k]
        (x, y), (a, b) = evaluate(curve, t, side=side), [evaluate(f, t, side=side) for f in tangent(curve)]
        length = square_root(a * a + b * b)
        return x - b * d / length, y + a * d / length


def intersections(first: Nurbs, second: Nurbs, *, offset: Number | tuple[Number, Number] = 0) -> Intersections:
    """Return all common points of two curves in the plane or in space. Curves in the plane z = 0 are plane curves.

    Each point is a pair of exact parameters, with the intersection multiplicity and the kind: a crossing, a touching
    point (the order of contact is the multiplicity − 1), an end, or a knot. Common arcs of the curves are given as
    intervals with the exact map between the parameters. The seam of a closed curve is a knot.

    >>> from exactspline import Nurbs, example
    >>> line = Nurbs(1, [0, 0, 1, 1], [(-4, 0), (4, 0)])
    >>> intersections(example("ellipse"), line)
    [<crossing at 0 and 3/4>, <crossing at 2 and 1/4>]
    >>> tangent = Nurbs(1, [0, 0, 1, 1], [(-3, 1), (3, 1)])
    >>> intersections(tangent, example("ellipse"))
    [<touching at 1/2 and 1, multiplicity 2>]
    >>> parabola = Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), ("1/2", 0), (1, 1)])
    >>> intersections(parabola, parabola.restrict("1/2", 1).reverse())
    everywhere on <overlap of [1, 1/2] and [1/2, 1], reversed>

    With `offset`, a signed distance (positive to the left) or one distance for each curve, the result is the common
    points of the offsets of two plane curves, given by the parameters of the curves themselves.

    >>> intersections(example("ellipse"), line, offset=("1/4", 0))
    [<knot at 0 and 23/32>, <knot at 2 and 9/32>]

    The work is limited to about ten seconds (somewhat more for many pairs of segments). Pairs of segments that exceed
    the limit are listed in ``undecided``; for offsets also segments with points without a tangent, and segments whose
    offsets are a single point or may coincide.

    Raises `ShapeError` for curves of different dimensions, outside plane and space, for offsets in space, and for more
    than two distances.

    Source: Bézout's matrix as in Manocha and Demmel, Algorithms for intersecting parametric and algebraic curves I, ACM
    Transactions on Graphics 1994.
    """
    if type(offset) is int and not offset:
        return intersections_of_curves(*in_one_plane(curve_of(first), curve_of(second)))
    given = offset if isinstance(offset, tuple) else (offset, offset)
    if len(given) != 2:
        raise ShapeError(counted(len(given), "offset"), remedy="give one distance, or one for each curve")
    distances, curves = (rational(given[0]), rational(given[1])), in_one_plane(curve_of(first), curve_of(second))
    return _Search(curves, distances).answer() if any(distances) else intersections_of_curves(*curves)


def self_intersections(curve: Nurbs, *, offset: Number = 0) -> Intersections:
    """Return the points through which a plane curve passes more than once, each as a pair of parameters s < t. The
    common knot of neighbouring segments, or of the two ends of a closed curve, does not count.

    >>> from exactspline import Nurbs
    >>> loop = Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (3, 3), (-2, 3), (1, 0)])
    >>> self_intersections(loop)
    [<crossing at (2 - √3)/4 and (2 + √3)/4>]

    With `offset`, a signed distance (positive to the left), the result is the self-intersections of the offset at this
    distance, given by the parameters of the curve itself. Cusps of the offset are not included (see
    `analyse(curve).offset_cusps`).

    >>> parabola = Nurbs(2, [0, 0, 0, 1, 1, 1], [(-2, 4), (0, -4), (2, 4)])  # y = x²
    >>> (found,) = self_intersections(parabola, offset=1)
    >>> found, [x.exact for x in found.point]
    (<crossing at (4 - √3)/8 and (4 + √3)/8>, [mpq(0,1), mpq(5,4)])

    The work is limited as for `intersections`; pairs of segments that exceed the limit, segments with points without a
    tangent, and segments whose offsets are a single point or may coincide are listed in ``undecided``.

    Raises `ShapeError` for a curve that is not in the plane.
    """
    d, curve = rational(offset), in_the_plane(curve_of(curve))
    return _Search((curve, curve), (d, d), alone=True).answer() if d else self_intersections_of_curve(curve)


class _Search:
    """The search over pairs of segments, with its results; `alone` means a curve and itself."""

    def __init__(self, curves: tuple[Nurbs, Nurbs], distances: tuple[mpq, mpq], *, alone: bool = False) -> None:
        for curve in curves:
            of_dimension(curve_of(curve), "offsets need curves in the plane", 2)
        self.curves, self.distances, self.alone = curves, distances, alone
        self.undecided: list[str] = []
        self.points: list[OffsetIntersection] = []

    @cached_property
    def met(self) -> Intersections:
        """The common points of the curves themselves."""
        return self_intersections_of_curve(self.curves[0]) if self.alone else intersections_of_curves(*self.curves)

    def answer(self) -> Intersections:
        """All common points of the offsets, in order."""
        pairs = self._pairs()
        with drawing_on(Budget(QUESTION + PATCH * max(len(pairs) - 1, 0))):
            for pair in pairs:
                try:
                    found = list(_OfSegments(self, pair).points())
                except ReachError as error:
                    where = " and ".join(str(side) for side in self.over(pair))
                    self.undecided.append(f"the segments over {where}: {error.problem}")
                    continue
                self.points += map(self._from_seam, found)
        ordered = groupby(sorted(self.points, key=_where), _where)
        return Intersections(tuple(_once(list(own)) for _, own in ordered), (), tuple(self.undecided))

    def _pairs(self) -> list[tuple[int, int]]:
        """The pairs of segments whose boxes, widened by the distances, meet."""
        prepared = [segments_of(curve) for curve in self.curves[: 2 - self.alone]]
        shift = shift_for(*prepared)
        wide = [ceil(abs(d) * (1 << shift)) for d in self.distances]
        trees = [own.boxes(shift, by) for own, by in zip(prepared, wide, strict=False)]
        return list(pairs_that_may_meet(trees[0], trees[-1]))

    def over(self, pair: tuple[int, int]) -> Box:
        """The parameters of a pair of segments."""
        return Box(*(Interval(*curve.breakpoints[k : k + 2]) for curve, k in zip(self.curves, pair, strict=True)))

    def _from_seam(self, point: OffsetIntersection) -> OffsetIntersection:
        """The point with the start of a closed curve in place of its end, unless there is a corner; for a curve and
        itself the start comes first.
        """
        for k, curve in enumerate(self.curves):
            low, high = curve.domain
            places, sides, knots = [point.first, point.second], list(point.sides), list(point.at_knot)
            if curve.closed and places[k] == high and facts_of(curve).tangent_continuous(0):
                places[k], sides[k] = Real(low), Side.RIGHT
                if self.alone:
                    places, sides, knots = places[::-1], sides[::-1], knots[::-1]
                at_knot = knots[0], knots[1]
                point = replace(point, first=places[0], second=places[1], sides=(sides[0], sides[1]), at_knot=at_knot)
        return point


def _where(point: OffsetIntersection) -> tuple[Real, Real, tuple[Side, Side]]:
    return point.first, point.second, point.sides


def _once(found: Sequence[OffsetIntersection]) -> OffsetIntersection:
    """The common point of several pairs of segments that meet in a knot, with the least of their multiplicities."""
    times = [point.multiplicity for point in found if point.multiplicity is not None]
    return replace(found[0], multiplicity=min(times, default=None))


class _OfSegments:
    """The common points of the offsets of two segments."""

    def __init__(self, search: _Search, segments: tuple[int, int]) -> None:
        self.search, self.curves, self.segments = search, search.curves, segments
        self.sides, self.alone = search.over(segments), search.alone and segments[0] == segments[1]
        own = list(zip(self.curves, segments, strict=True))
        if any(piece(curve, k).stands_still or piece(curve, k).cusps for curve, k in own):
            raise ReachError("a segment on which the curve has a point without a tangent")
        self.pair = pair = PlanePair.of_segments(*own)
        a, b, e = pair.a, pair.b, pair.chord
        one, other = search.distances
        first, second = ((dot(b, e), a, one), (dot(a, e), b, other))
        #: Zero where the normals meet at the given distances.
        self.equations = [self._distance(*first), self._distance(*second)]
        if abs(one) == abs(other):
            self.equations[1] = pair.equidistant
        #: Positive where the normals meet on the side of each offset, for distances other than 0.
        self.beside = [f * pair.across * pair.weight * sign_of(d) for f, _, d in (first, second) if d]
        self.square, self.along, self.normal = norm2(e), dot(a, b), det(a, e) * pair.weight
        self.triangle = self._triangle()

    def _distance(self, f: fmpz_mpoly, velocity: Vector[fmpz_mpoly], d: mpq) -> fmpz_mpoly:
        """A polynomial that is zero where the normals meet at a given distance from one of the points."""
        if not d:
            return f
        reached: fmpz_mpoly = self.pair.across * self.pair.weight * int(d.numerator)
        return f**2 * norm2(velocity) * int(d.denominator) ** 2 - reached**2

    def _chord(self, d: mpq) -> fmpz_mpoly:
        """A polynomial that is zero where the chord has a given length."""
        weight: fmpz_mpoly = self.pair.weight
        return cast(fmpz_mpoly, self.square * int(d.denominator) ** 2 - weight**2 * int(d.numerator) ** 2)

    def _triangle(self) -> fmpz_mpoly:
        """A polynomial that is zero where the chord is the third side of a triangle whose other sides are normals of
        the curves with the lengths of the distances (law of cosines). Unlike the two equations, it is usually not zero
        at common normals and at common points of the curves.
        """
        one, other = self.search.distances
        m = int(one.denominator * other.denominator)
        weight: fmpz_mpoly = self.pair.weight
        left = self.square * m**2 - weight**2 * int((one**2 + other**2) * m**2)
        right = weight**2 * self.along * int(2 * one * other * m**2)
        return cast(fmpz_mpoly, left**2 * norm2(self.pair.a) * norm2(self.pair.b) - right**2)

    def points(self) -> Iterator[OffsetIntersection]:
        """All common points of the two offsets."""
        q, p = self.equations
        if not (p and q):
            self._check_circles()
            return
        if self.alone:
            p, q, self.triangle = (divided_out(f, S - T) for f in (p, q, self.triangle))
        shared = greatest_common_divisor([p, q])
        pair = p / shared, q / shared
        for zero in common_zeros(pair, self.sides, [self.triangle]):
            if self._is_met(zero):
                yield self._point(zero, pair)
        for factor in factorize(shared).bases if shared.total_degree() > 0 else ():
            for zero in self._on(factor):
                if self._is_met(zero):
                    yield self._point(zero, None)

    def _check_circles(self) -> None:
        """Handle an equation that is zero everywhere: an arc of a circle whose radius is its distance, or two arcs of
        the same circle or line at the same distance, whose offsets meet only where the arcs meet.
        """
        one, other = self.search.distances
        if not self.equations[0] or abs(one) != abs(other):
            raise ReachError("an arc of a circle with its radius as the distance, whose offset may be a single point")
        points = [((p.first,) * 2, (p.second,) * 2) for p in self.search.met]
        if self._run_along() or any(self._reached(*own) for own in points):
            raise ReachError("arcs of one circle or line, of curves that meet")

    def _run_along(self) -> bool:
        """Whether the offsets may coincide along an arc because the curves do."""
        met = self.search.met
        arcs = [arc for arc in met.everywhere if not self._between(-1 if arc.reversed else 1)]
        return bool(met.undecided) or any(self._reached(arc.first, arc.second, inside=True) for arc in arcs)

    def _reached(self, one: tuple[Real, Real], other: tuple[Real, Real], *, inside: bool = False) -> bool:
        """Whether two ranges of parameters meet the segments; with `inside`, not only in their ends."""
        pairs = ((one, other), (other, one)) if self.search.alone else ((one, other),)
        return any(
            all(
                low < high if inside else low <= high
                for ends, side in zip(pair, self.sides, strict=True)
                for low, high in ((min(ends), side.high), (side.low, max(ends)))
            )
            for pair in pairs
        )

    def _between(self, same: int) -> mpq:
        """The distance between the offsets where the tangents have the same direction (1) or opposite directions
        (−1).
        """
        one, other = self.search.distances
        return one - same * other

    def _on(self, factor: fmpz_mpoly) -> list[CommonZero]:
        """The pairs at which both equations vanish along a curve, and the chord is a common normal whose length is the
        distance between the offsets.
        """
        if divmod(self.pair.across, factor)[1]:
            self._exclude(factor)
            return []
        return [zero for same in (1, -1) for zero in self._on_common_normals(factor, same)]

    def _exclude(self, factor: fmpz_mpoly) -> None:
        if not as_form(factor).part(self.sides).sign:
            raise ReachError("offsets that may run along each other")

    def _on_common_normals(self, factor: fmpz_mpoly, same: int) -> list[CommonZero]:
        """The pairs at which the tangents have the same direction (1) or opposite directions (−1)."""
        apart = self._between(same)
        signs = [(self.along, same), (self.normal, sign_of(apart))]
        if any(required and as_form(f).part(self.sides).sign == -required for f, required in signs):
            return []
        conditions = [self._chord(apart)] if apart else list(self.pair.chord)
        along = greatest_common_divisor([factor, *conditions])
        if along.total_degree() == 0:
            return common_zeros([factor, *conditions], self.sides)
        if apart:
            self._exclude(along)
            return common_zeros([factor / along, *conditions], self.sides)
        if self._run_along():
            raise ReachError("offsets that may run along each other")
        # arcs that continue each other have an end in common
        ends = [S * int(x.denominator) - int(x.numerator) for x in self.sides.first]
        zeros = common_zeros([factor / along, *conditions], self.sides)
        return zeros + common_zeros([along, ends[0] * ends[1]], self.sides)

    def _is_met(self, zero: CommonZero) -> bool:
        """Whether the normals of a pair meet on the sides of the offsets at their distances; for a curve and itself the
        first parameter must also be below the second.
        """
        s, t = zero.place
        if self.search.alone and (not s < t or (self.curves[0].closed and (s, t) == self.curves[0].domain)):
            return False
        if not _vanishes(self.pair.across, zero):
            return all(_sign(f, zero) > 0 for f in self.beside)
        # the normals are parallel: the offsets meet on the common normal, or where the curves meet
        apart = self._between(_sign(self.along, zero))
        if not apart:
            return _vanishes(self.square, zero)
        return _vanishes(self._chord(apart), zero) and _sign(self.normal, zero) == sign_of(apart)

    def _point(self, zero: CommonZero, pair: Sequence[fmpz_mpoly] | None) -> OffsetIntersection:
        first, second = map(real, zero.place)
        times = multiplicity(zero, *pair) if pair is not None and not _vanishes(self.pair.across, zero) else None
        knots = [
            not isinstance(x, Root) and x in curve.breakpoints for curve, x in zip(self.curves, zero.place, strict=True)
        ]
        kind = IntersectionKind.SPACE
        if any(knots):
            kind = IntersectionKind.KNOT
        elif times is not None:
            kind = IntersectionKind.CROSSING if times % 2 else IntersectionKind.TOUCHING
        one, other = map(self._side, (0, 1), zero.place)
        at_knot, distances = (knots[0], knots[1]), self.search.distances
        return OffsetIntersection(first, second, kind, times, self.curves, at_knot, distances, (one, other))

    def _side(self, k: int, x: Parameter) -> Side:
        """The side of a parameter: left if it is the end of its segment and a corner."""
        curve = self.curves[k]
        is_end = x == self.sides[k].high != curve.domain[1]
        is_corner = is_end and not facts_of(curve).tangent_continuous(self.segments[k] + 1)
        return Side.LEFT if is_corner else Side.RIGHT


def _vanishes(p: fmpz_mpoly, zero: CommonZero) -> bool:
    return not p or vanish_at([p], *zero.place)


def _sign(p: fmpz_mpoly, zero: CommonZero) -> int:
    return 0 if _vanishes(p, zero) else sign_at_point(p, zero)


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
