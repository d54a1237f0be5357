"""The common points of two curves, or of a curve and itself, that persist while every control point and weight is
changed by at most epsilon, and those that only some of the changed curves may have.

Each curve is in the hull of its control points, and its velocity, up to a positive factor, in the hull of those of
``D₁ = w p′ − w′ p``; control points with balls for coordinates enclose those of all curves. Where all velocities of one
curve are on the same side of all velocities of the other, the chords are, too: each pair of curves has at most one
common point there. A common point exists if a linear map of γ(s) − γ̄(t), close to (s, t), has different signs on
opposite sides of a box (Miranda 1940).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import reduce
from itertools import combinations_with_replacement, pairwise, product
from math import comb

from flint import arb, arb_mat, ctx

from exactspline.errors import ShapeError
from exactspline.geometry.pairs.intersections import IntersectionKind
from exactspline.geometry.rounded.forms import PRECISION, CurvesNear, Settled, casteljau, cutting
from exactspline.numbers.exact import Number, mpq, scalar, to_fmpq
from exactspline.numbers.exact import sign as sign_of
from exactspline.numbers.intervals import UNIT, Box, Interval, ball_ends
from exactspline.numbers.once import cached_property
from exactspline.polynomials.patch_forms import clusters
from exactspline.questions.answers import Described
from exactspline.reals.real import Real, real
from exactspline.roots.answers import CurvePiece
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.precision import distance
from exactspline.splines.type_checks import curve_of, in_plane_or_space

#: The number of pairs of parts examined, in all and on one level of halving, in addition to the pairs of segments; the
#: pairs that remain then, as where curves coincide along an arc, are reported as not robust.
MOST, MOST_OF_A_LEVEL = 5_000, 64
#: A part is not halved if its control points are spread by less than this many times the allowed change.
SPREAD = 4
#: The numbers of steps of Newton's method, and of boxes around the point found, each twice as large as the previous
#: one.
STEPS, BOXES = 8, 8

Row = list[arb]


@dataclass(frozen=True, repr=False)
class NearbyMeeting(Described):
    """A common point of curves near two curves, by intervals of the parameters of the first and the second curve (which
    are the same curve for self-intersections).

    ``robust``: each pair of these curves has exactly one common point there. Otherwise some pairs may have any number
    of common points there, and others none.
    """

    first: Interval
    second: Interval
    robust: bool

    kind = IntersectionKind.CROSSING

    @property
    def piece(self) -> CurvePiece:  # type: ignore[override]  # that of the first parameter
        """The parameters of the first curve."""
        return CurvePiece((self.first,))

    @property
    def values(self) -> dict[str, tuple[Real, ...]]:
        """The parameters of the second curve."""
        return {"second": tuple(map(real, self.second))}

    @property
    def facts(self) -> dict[str, bool]:
        """Whether the common point is robust."""
        return {"robust": self.robust}


def intersections_nearby(first: Nurbs, second: Nurbs, epsilon: Number) -> tuple[NearbyMeeting, ...]:
    """The common points of all pairs of curves near two given curves, and those that only some pairs may have. A curve
    is near if its coordinates and, for a rational curve, weights differ from the given ones by at most epsilon.

    Common points at an end of a curve and common points of space curves are never robust. The points are in the order
    of the parameters.

    >>> from exactspline import Nurbs, example
    >>> line = Nurbs(1, [0, 0, 1, 1], [(0, 0), (2, 0)])
    >>> for found in intersections_nearby(example("circle"), line, "1/1000"):
    ...     print(found.robust, *(f"{float(t):.4f}" for t in found.second))
    False 0.4961 0.5039
    False 0.4961 0.5039

    Raises `ShapeError` for curves that are not both in the plane or in space, for an epsilon that is not positive, and
    if a weight function of a near curve may vanish.
    """
    curves = curve_of(first), curve_of(second)
    if curves[0].dimension != curves[1].dimension or curves[0].dimension not in (2, 3):
        dimensions = " and ".join(f"R{c.dimension}" for c in curves)
        raise ShapeError(f"common points in {dimensions}", remedy="this needs two curves in the plane or in space")
    with ctx.workprec(PRECISION):
        one, two = (_Tangled(c, distance(epsilon, c)) for c in curves)
        return _Meetings(one, two, _near(one.parts, two.parts)).found()


def self_intersections_nearby(curve: Nurbs, epsilon: Number) -> tuple[NearbyMeeting, ...]:
    """The self-intersections of all curves near a given curve, and those that only some of them may have. The common
    end of a closed curve is one of the latter, because the ends of a curve near it need not meet.

    >>> loop = Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (3, 2), (-2, 2), (1, 0)])
    >>> [found.robust for found in self_intersections_nearby(loop, "1/1000")]
    [True]

    Raises `ShapeError` like `intersections_nearby`.
    """
    given = in_plane_or_space(curve, "common points")
    with ctx.workprec(PRECISION):
        one = _Tangled(given, distance(epsilon, given))
        return _Meetings(one, one, _near(one.parts, None)).found()


class _Part:
    """A part of a segment: its homogeneous control points and those of D₁, one row per coordinate, as balls that
    contain the control points of all curves.
    """

    def __init__(self, ends: Interval, points: list[Row], velocity: list[Row]) -> None:
        self.ends, self.points, self.velocity = ends, points, velocity

    @cached_property
    def places(self) -> list[Row]:
        """The control points as points of the plane or of space: weights are positive (see `CurvesNear`)."""
        *rows, weights = self.points
        return [[x / w for x, w in zip(row, weights, strict=True)] for row in rows]

    @cached_property
    def spread(self) -> Row:
        """The largest possible change of the control points in each coordinate."""
        return [max(x.rad() for x in row) for row in self.places]

    @cached_property
    def hull(self) -> list[arb]:
        """The box around all curves."""
        return [_union(row) for row in self.places]

    @cached_property
    def direction(self) -> Row:
        """The approximate direction of the part, which is the same for all curves."""
        return [sum((x.mid() for x in row), start=arb(0)).mid() for row in self.velocity]

    @cached_property
    def is_small(self) -> bool:
        """Whether halves of the part would hardly be smaller."""
        return all(x.rad() < SPREAD * spread for x, spread in zip(self.hull, self.spread, strict=True))

    @cached_property
    def halves(self) -> tuple[_Part, _Part]:
        """The two halves of the part."""
        low, high = map(self._on, UNIT.first.halves)
        return low, high

    def between(self, interval: Interval) -> _Part:
        """The part within an interval that meets it."""
        low, high = (self.ends.local(t) for t in (max(interval.low, self.ends.low), min(interval.high, self.ends.high)))
        return self._on(Interval(low, high))

    def _on(self, side: Interval) -> _Part:
        """The part on an interval of the local parameter: means of ordinates, so that radii do not grow."""
        nets = (arb_mat(own) * cutting(len(own[0]) - 1, side).transpose() for own in (self.points, self.velocity))
        points, velocity = (net.table() for net in nets)
        return _Part(self.ends.part(side), points, velocity)


class _Tangled(CurvesNear):
    """The curves near a curve, prepared for the search for common points."""

    @cached_property
    def parts(self) -> list[_Part]:
        """The segments as parts."""
        return [self._part(i, Interval(*ends)) for i, ends in enumerate(pairwise(self.curve.breakpoints))]

    def _part(self, i: int, ends: Interval) -> _Part:
        n, (first, basis) = self.curve.degree, self.basis(i)
        near = range(first, first + n + 1)
        weights = [self.weights[j] for j in near]
        dimension = self.curve.dimension
        columns = [[self.points[j][c] * w for j, w in zip(near, weights, strict=True)] for c in range(dimension)]
        rows = [[scalar([b[k] for b in basis], own) for k in range(n + 1)] for own in (*columns, weights)]
        *points, w = rows
        if self.rational:
            velocity = [
                [a - b for a, b in zip(_product(_steps(p), w), _product(_steps(w), p), strict=True)] for p in points
            ]
        else:
            velocity = [_steps(p) for p in points]
        return _Part(ends, rows, velocity)

    def over(self, interval: Interval) -> list[_Part]:
        """The parts within an interval."""
        first, last = map(self.curve.mesh.locate, interval)
        return [part.between(interval) for part in self.parts[first : last + 1]]

    def jumps_in(self, interval: Interval) -> bool:
        """Whether these curves may have a gap inside an interval."""
        knots, n = self.curve.knots, self.curve.degree
        times = zip(knots.breakpoints, knots.multiplicities, strict=True)
        return any(m > n and interval.low < t < interval.high for t, m in times)


class _Meetings:
    """The search for the common points of the curves near two curves."""

    def __init__(self, first: _Tangled, second: _Tangled, pairs: list[tuple[_Part, _Part]]) -> None:
        self.first, self.second, self.pairs = first, second, pairs
        self.domain = Box(Interval(*first.curve.domain), Interval(*second.curve.domain))
        self.settled = Settled()

    def found(self) -> tuple[NearbyMeeting, ...]:
        """All common points."""
        open_boxes = [box for box, _ in clusters(list(self._possible()))]
        both = [(box, True) for box in self.settled.places] + [(box, False) for box in open_boxes]
        return tuple(NearbyMeeting(*box, robust) for box, robust in sorted(both))

    def _possible(self) -> Iterator[Box]:
        """Boxes of parameters outside which there are only robust common points."""
        level, done, first = self.pairs, 0, len(self.pairs)
        while level:
            after: list[tuple[_Part, _Part]] = []
            for pair in level:
                done += 1
                a, b = pair
                box = Box(a.ends, b.ends)
                if not _may_meet(a, b) or self._is_one_arc(a, b):
                    continue
                if self.settled.contains(box) or self._settles(a, b, box):
                    continue
                too_many = done > MOST + first or len(after) > MOST_OF_A_LEVEL + first
                if too_many or (a.is_small and b.is_small):
                    yield box
                else:
                    after += self._halved(a, b)
            level = after

    def _halved(self, a: _Part, b: _Part) -> Iterator[tuple[_Part, _Part]]:
        if a is b:
            return combinations_with_replacement(a.halves, 2)
        return product([a] if a.is_small else a.halves, [b] if b.is_small else b.halves)

    def _is_one_arc(self, a: _Part, b: _Part) -> bool:
        """Whether both parts belong to an arc whose velocities are on one side of a plane, so that the arc does not
        meet itself.
        """
        if self.first is not self.second or not a.ends.meets(b.ends) or self.first.jumps_in(_around(a.ends, b.ends)):
            return False
        vectors = [*zip(*a.velocity, strict=True), *zip(*b.velocity, strict=True)]
        middle = [sum((x.mid() for x in row), start=arb(0)) for row in zip(*vectors, strict=True)]
        return all(scalar(v, middle) > 0 for v in vectors)

    def _settles(self, a: _Part, b: _Part, box: Box) -> bool:
        """Whether each pair of curves has one common point near a box and at most one in a larger box around it."""
        if self.first.curve.dimension > 2 or not _crosses([a], [b]):
            return False
        around = Box(*(side.grown(side.width).inside(whole) for side, whole in zip(box, self.domain, strict=True)))
        apart = self.first is not self.second or not around.first.meets(around.second)
        if not apart or self.first.jumps_in(around.first) or self.second.jumps_in(around.second):
            return False
        if not _crosses(self.first.over(around.first), self.second.over(around.second)):
            return False
        place = self._crossing(a, b, around)
        # a box next to it may have led to the same points
        return place is not None and self.settled.add(place, around)

    def _crossing(self, a: _Part, b: _Part, around: Box) -> Box | None:
        """A small box in which each pair of curves has a common point."""
        found = _newton(a, b)
        if found is None:
            return None
        (s, t), inverse = found
        place = a.ends.at(s), b.ends.at(t)
        spread = [x + y for x, y in zip(a.spread, b.spread, strict=True)]
        steps = [scalar([abs(x) for x in row], spread) for row in inverse]
        widths = [ball_ends(step).high * width for step, width in zip(steps, (a.ends.width, b.ends.width), strict=True)]
        for k in range(BOXES):
            box = Box(*(Interval(x - h * 2**k, x + h * 2**k) for x, h in zip(place, widths, strict=True)))
            if not around.contains(box):
                return None
            if self._changes_sign(box, inverse):
                return box
        return None

    def _changes_sign(self, box: Box, inverse: list[Row]) -> bool:
        """Whether the two coordinates have different signs on opposite sides of a box, for all curves."""
        (low, high), (left, right) = ([Interval.point(t) for t in side] for side in box)
        first, second = inverse
        return bool(
            self._along(first, low, box.second) < 0 < self._along(first, high, box.second)
            and self._along(second, box.first, left) < 0 < self._along(second, box.first, right)
        )

    def _along(self, row: Row, s: Interval, t: Interval) -> arb:
        """A ball with all values of a coordinate of γ(s) − γ̄(t)."""
        gamma, other = (
            _union([scalar(p, row) for part in curves.over(interval) for p in zip(*part.places, strict=True)])
            for curves, interval in ((self.first, s), (self.second, t))
        )
        return gamma - other


def _may_meet(a: _Part, b: _Part) -> bool:
    """Whether the boxes around two parts overlap and, in the plane, their projections along the first part."""
    if not all(x.overlaps(y) for x, y in zip(a.hull, b.hull, strict=True)):
        return False
    if len(a.hull) > 2:
        return True
    x, y = a.direction
    across, other = (_union([scalar(p, (-y, x)) for p in zip(*part.places, strict=True)]) for part in (a, b))
    return bool(across.overlaps(other))


def _near(first: Sequence[_Part], second: Sequence[_Part] | None) -> list[tuple[_Part, _Part]]:
    """The pairs of parts that may meet along the first axis; without a second curve the pairs of parts of the first,
    each once.
    """
    sides = [(part, 0) for part in first] + [(part, 1) for part in second or ()]
    found = list[tuple[_Part, _Part]]()
    active: list[list[_Part]] = [[], []]
    for part, side in sorted(sides, key=lambda each: ball_ends(each[0].hull[0]).low):
        other = side if second is None else 1 - side
        active[other] = [each for each in active[other] if each.hull[0].overlaps(part.hull[0])]
        if second is None:
            pairs = [(each, part) if each.ends < part.ends else (part, each) for each in (*active[0], part)]
        else:
            pairs = [(each, part) if side else (part, each) for each in active[other]]
        found += pairs
        active[side].append(part)
    return found


def _newton(a: _Part, b: _Part) -> tuple[tuple[mpq, mpq], list[Row]] | None:
    """The approximate common point of the curves themselves, in local parameters, and the inverse of the matrix of both
    velocities.
    """
    rows = [[[x.mid() for x in row] for row in part.points] for part in (a, b)]
    s, t = mpq(1, 2), mpq(1, 2)
    inverse: list[Row] = []
    for _ in range(STEPS):
        (p, u), (q, v) = (_jet(own, x) for own, x in zip(rows, (s, t), strict=True))
        determinant = u[1] * v[0] - u[0] * v[1]
        if not sign_of(determinant):
            return None
        inverse = [[-v[1] / determinant, v[0] / determinant], [-u[1] / determinant, u[0] / determinant]]
        gap = [x - y for x, y in zip(p, q, strict=True)]
        steps = [ball_ends(scalar(row, gap)).middle for row in inverse]
        s, t = (_rounded(x - step) for x, step in zip((s, t), steps, strict=True))
        if not all(-1 <= x <= 2 for x in (s, t)):
            return None
        if max(map(abs, steps)) < mpq(1, 2 ** (PRECISION // 2)):
            break
    return (s, t), inverse


def _jet(rows: list[Row], t: mpq) -> tuple[Row, Row]:
    """The point and the velocity at a local parameter."""
    x = arb(to_fmpq(t))
    last = [casteljau(row, x, 2) for row in rows]
    n = len(rows[0]) - 1
    *points, w = [(row[0] + (row[1] - row[0]) * x, (row[1] - row[0]) * n) for row in last]
    place = [p / w[0] for p, _ in points]
    return place, [(dp - y * w[1]) / w[0] for (_, dp), y in zip(points, place, strict=True)]


def _crosses(first: Sequence[_Part], second: Sequence[_Part]) -> bool:
    """Whether all velocities of the second curve are on the same side of all velocities of the first."""
    us, vs = ([v for part in parts for v in zip(*part.velocity, strict=True)] for parts in (first, second))
    return {sign_of(u[0] * v[1] - u[1] * v[0]) for u, v in product(us, vs)} in ({1}, {-1})


def _around(a: Interval, b: Interval) -> Interval:
    return Interval(min(a.low, b.low), max(a.high, b.high))


def _rounded(x: mpq) -> mpq:
    unit = mpq(1, 2**PRECISION)
    return x // unit * unit


def _union(balls: Sequence[arb]) -> arb:
    return reduce(arb.union, balls)


def _steps(row: Row) -> Row:
    """The ordinates of the derivative, up to a factor."""
    return [b - a for a, b in pairwise(row)]


def _product(f: Row, g: Row) -> Row:
    """The ordinates of a product, by those of both in the Bernstein basis."""
    m, n = len(f) - 1, len(g) - 1
    return [
        sum((f[i] * g[k - i] * comb(m, i) * comb(n, k - i) for i in range(max(0, k - n), min(m, k) + 1)), start=arb(0))
        / comb(m + n, k)
        for k in range(m + n + 1)
    ]
