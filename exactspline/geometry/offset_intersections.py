"""The points at which the offset of a plane curve meets itself: pairs of parameters whose normals meet at the distance.

They are common zeros of two polynomials: both points are equally far from where their normals meet, and this distance
is that of the offset. For s = t both vanish; they are divided by s − t. Where the normals are parallel the polynomials
vanish at any distance; there it is decided by the length of the chord.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import groupby
from math import ceil

from flint import fmpz_mpoly

from exactspline.errors import ReachError, ShapeError
from exactspline.geometry.analysis import analyse
from exactspline.geometry.bisector.plane_pair import PlanePair, tangent
from exactspline.geometry.bisector.system import piece
from exactspline.geometry.box_tree import BoxTree, pairs_that_may_meet, shift_for
from exactspline.geometry.intersections import Intersection, IntersectionKind, Intersections
from exactspline.geometry.intersections import self_intersections as self_intersections_of_curve
from exactspline.geometry.singular_points import sign_at
from exactspline.language.vector import det, dot, norm2
from exactspline.numbers.exact import Number, mpq, rational
from exactspline.numbers.exact import sign as sign_of
from exactspline.numbers.intervals import Box, Interval
from exactspline.numbers.sides import Side
from exactspline.polynomials.cost import PATCH, QUESTION, Budget, drawing_on
from exactspline.polynomials.factors import factorize, greatest_common_divisor
from exactspline.polynomials.two_parameters import S, T, as_form
from exactspline.reals.real import Real, square_root
from exactspline.roots.common_zeros import CommonZero, common_zeros, multiplicity
from exactspline.roots.local_parameters import segment_forms
from exactspline.roots.of_polynomials import Parameter
from exactspline.roots.root import Root
from exactspline.roots.values import at
from exactspline.roots.vanishing import vanish_at
from exactspline.splines.expected import curve_of
from exactspline.splines.nurbs import Nurbs


@dataclass(frozen=True, repr=False)
class OffsetIntersection(Intersection):
    """A point at which the offset at a signed `distance` (positive to the left) meets itself; both parameters are those
    of the curve. The multiplicity is None, and the kind a common point, where the normals are parallel.

    At a corner the offset has two ends: `sides` tells from which side of each parameter it arrives (right elsewhere).
    """

    distance: mpq = field(default_factory=mpq)
    sides: tuple[Side, Side] = (Side.RIGHT, Side.RIGHT)

    @property
    def point(self) -> tuple[mpq | Real, ...]:
        """The coordinates, exactly."""
        curve, k = self.curves[0], int(self.first.closed_form is None and self.second.closed_form is not None)
        t, side = (self.first, self.second)[k], self.sides[k]
        (x, y), (a, b) = at(curve, t, side=side), [at(f, t, side=side) for f in tangent(curve)]
        length = square_root(a * a + b * b)
        return x - b * self.distance / length, y + a * self.distance / length


def self_intersections(curve: Nurbs, *, offset: Number = 0) -> Intersections:
    """The points through which a plane curve passes more than once, each as a pair of parameters s < t; neighbouring
    segments, and the ends of a closed curve, do not meet in their common knot.

    >>> from exactspline import Nurbs
    >>> loop = Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (3, 3), (-2, 3), (1, 0)])
    >>> self_intersections(loop)
    [<crossing at 0.0669873… and 0.933013…>]

    With `offset`, a signed distance (positive to the left), those of the offset curve at it, by the parameters of the
    curve itself. Its cusps are not among them (`analyse(curve).offset_cusps` has them).

    >>> parabola = Nurbs(2, [0, 0, 0, 1, 1, 1], [(-2, 4), (0, -4), (2, 4)])  # y = x²
    >>> (found,) = self_intersections(parabola, offset=1)
    >>> found, [x.exact for x in found.point]
    (<crossing at 0.283494… and 0.716506…>, [mpq(0,1), mpq(5,4)])

    The work is limited as for `intersections`; pairs of segments that exceed it, segments with points without a
    tangent, and those whose offsets are one point or may run along each other are named in ``left_out``.

    Raises `ShapeError` for a curve that is not in the plane.
    """
    d = rational(offset)
    return _Search(curve, d).answer() if d else self_intersections_of_curve(curve)


class _Search:
    """The pairs of segments, and what is found."""

    def __init__(self, curve: Nurbs, d: mpq) -> None:
        if curve_of(curve).dimension != 2:
            raise ShapeError(f"a curve in R{curve.dimension}", remedy="give a curve in the plane")
        self.curve, self.d = curve, d
        self.left_out: list[str] = []
        self.points: list[OffsetIntersection] = []

    def answer(self) -> Intersections:
        """All of it, in order."""
        segments = [segment_forms(self.curve, i) for i in range(self.curve.segments)]
        shift = shift_for(segments)
        tree = BoxTree(segments, shift, ceil(abs(self.d) * (1 << shift)))
        pairs = list(pairs_that_may_meet(tree, tree))
        with drawing_on(Budget(QUESTION + PATCH * max(len(pairs) - 1, 0))):
            for i, j in pairs:
                sides = Box(*(Interval(*self.curve.breakpoints[k : k + 2]) for k in (i, j)))
                try:
                    found = list(_OfSegments(self.curve, self.d, sides, i, j).points())
                except ReachError as error:
                    where = " and ".join(side.shortly for side in sides)
                    self.left_out.append(f"the segments over {where}: {error.problem}")
                    continue
                self.points += map(self._from_seam, found)
        ordered = groupby(sorted(self.points, key=_where), _where)
        return Intersections(tuple(_once(list(own)) for _, own in ordered), (), tuple(self.left_out))

    def _from_seam(self, point: OffsetIntersection) -> OffsetIntersection:
        """A point whose second parameter is the end of a closed curve without a corner there, with the start instead
        of it.
        """
        low, high = self.curve.domain
        if self.curve.closed and point.second == high and analyse(self.curve).tangent_continuous(0):
            sides, at_knot = (Side.RIGHT, point.sides[0]), (True, point.at_knot[0])
            return replace(point, first=Real(low), second=point.first, sides=sides, at_knot=at_knot)
        return point


def _where(point: OffsetIntersection) -> tuple[Real, Real, tuple[Side, Side]]:
    return point.first, point.second, point.sides


def _once(found: Sequence[OffsetIntersection]) -> OffsetIntersection:
    """One point of the pairs of segments that meet in a knot, with the least of their multiplicities."""
    times = [point.multiplicity for point in found if point.multiplicity is not None]
    return replace(found[0], multiplicity=min(times, default=None))


class _OfSegments:
    """The points of the offsets of two segments."""

    def __init__(self, curve: Nurbs, d: mpq, sides: Box, i: int, j: int) -> None:
        self.curve, self.d, self.sides, self.segments, self.alone = curve, d, sides, (i, j), i == j
        if any(piece(curve, k).stands_still or piece(curve, k).cusps for k in {i, j}):
            raise ReachError("a segment on which the curve has a point without a tangent")
        pair = PlanePair.of_segments(curve, i, j)
        a, b, e, w, n, m = pair.a, pair.b, pair.chord, pair.weight, int(d.numerator), int(d.denominator)
        side = pair.across * w * sign_of(d)
        self.pair, self.equidistant = pair, pair.equidistant
        #: Zero where the normals meet at the distance; those that are positive where it is on the side of the offset.
        self.reach = dot(b, e) ** 2 * norm2(a) * (m * m) - (pair.across * w) ** 2 * (n * n)
        self.beside = [dot(b, e) * side, dot(a, e) * side]
        #: What decides where the normals are parallel.
        self.square, self.opposite, self.normal = norm2(e), dot(a, b), det(a, e) * w * sign_of(d)
        self.chord = self.square * (m * m) - (w * w) * (4 * n * n)

    def points(self) -> Iterator[OffsetIntersection]:
        """All points."""
        p, q = self.equidistant, self.reach
        if not p:
            self._check_one_circle()
            return
        if not q:
            raise ReachError("offsets that may run along each other")
        if self.alone:
            p, q = _without_diagonal(p), _without_diagonal(q)
        shared = greatest_common_divisor([p, q])
        pair = p / shared, q / shared
        for zero in common_zeros(pair, self.sides):
            if self._is_met(zero):
                yield self._point(zero, pair)
        for factor in factorize(shared).bases if shared.total_degree() > 0 else ():
            for zero in self._along(factor):
                if self._is_met(zero):
                    yield self._point(zero, None)

    def _check_one_circle(self) -> None:
        """Arcs of one circle, or of one line: their offsets meet where the arcs do, or are one point."""
        if not self.reach:
            raise ReachError("the offset is a single point")
        if self_intersections_of_curve(self.curve):
            raise ReachError("arcs of one circle or line, of a curve that meets itself")

    def _along(self, factor: fmpz_mpoly) -> list[CommonZero]:
        """The pairs at which both equations vanish along a curve, and the chord has the length of a common normal."""
        chord = self.chord
        if greatest_common_divisor([factor, chord]).total_degree() > 0 or divmod(self.pair.across, factor)[1]:
            if as_form(factor).part(self.sides).sign in (1, -1):
                return []
            raise ReachError("offsets that may run along each other")
        return common_zeros([factor, chord], self.sides)

    def _is_met(self, zero: CommonZero) -> bool:
        """Whether the normals of a pair, the first parameter below the second, meet on the side of the offset at its
        distance.
        """
        s, t = zero.place
        if not s < t or (self.curve.closed and (s, t) == self.curve.domain):
            return False
        signs = [_sign(f, zero) for f in self.beside]
        if any(signs):
            return signs == [1, 1]
        # the normals are parallel: the offset touches itself in the middle of a chord, or where the curve does
        if _vanishes(self.square, zero):
            return _sign(self.opposite, zero) > 0
        return _vanishes(self.chord, zero) and _sign(self.opposite, zero) < 0 and _sign(self.normal, zero) > 0

    def _point(self, zero: CommonZero, pair: Sequence[fmpz_mpoly] | None) -> OffsetIntersection:
        first, second = (x if isinstance(x, Root) else Real(x) for x in zero.place)
        times = None
        if pair is not None and not _vanishes(self.pair.across, zero):
            times = multiplicity(zero, *pair)
        at_knot = tuple(not isinstance(x, Root) and x in self.curve.breakpoints for x in zero.place)
        kind = IntersectionKind.SPACE
        if any(at_knot):
            kind = IntersectionKind.KNOT
        elif times is not None:
            kind = IntersectionKind.CROSSING if times % 2 else IntersectionKind.TOUCHING
        curves, (one, other) = (self.curve, self.curve), map(self._side, (0, 1), zero.place)
        knots = at_knot[0], at_knot[1]
        return OffsetIntersection(first, second, kind, times, curves, knots, distance=self.d, sides=(one, other))

    def _side(self, k: int, x: Parameter) -> Side:
        """Left where a parameter is the end of its segment, and a corner."""
        is_end = x == self.sides[k].high != self.curve.domain[1]
        is_corner = is_end and not analyse(self.curve).tangent_continuous(self.segments[k] + 1)
        return Side.LEFT if is_corner else Side.RIGHT


def _without_diagonal(p: fmpz_mpoly) -> fmpz_mpoly:
    """A polynomial divided by s − t as often as possible."""
    while True:
        quotient, rest = divmod(p, S - T)
        if rest:
            return p
        p = quotient


def _vanishes(p: fmpz_mpoly, zero: CommonZero) -> bool:
    return not p or vanish_at([p], *zero.place)


def _sign(p: fmpz_mpoly, zero: CommonZero) -> int:
    return 0 if _vanishes(p, zero) else sign_at(p, zero)


__all__ = ["OffsetIntersection", "self_intersections"]
