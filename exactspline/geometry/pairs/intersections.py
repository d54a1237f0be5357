"""The common points of two curves, and of a curve and itself: every pair of parameters, exactly, with its multiplicity,
and the common arcs.

Segments that cannot meet are excluded by boxes; each remaining pair is decided by Bézout's matrix
(`exactspline.polynomials.plane_pairs`). Space curves are projected to a plane, and the third coordinate is compared
exactly.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from functools import cache, partial
from itertools import pairwise
from math import comb
from operator import itemgetter
from typing import Any, NamedTuple

from exactspline.bivariate.common_zeros import common_zeros, multiplicity
from exactspline.bivariate.common_zeros_certificate import REMEDY, proof_on_patch
from exactspline.bivariate.zeros import common_zeros as common_zeros_of
from exactspline.certificates import INTERSECTIONS, certificate
from exactspline.errors import ReachError, ShapeError
from exactspline.geometry.bisectors.plane_pair import PlanePair
from exactspline.geometry.curves.planarity import check_in_one_space, in_common_plane
from exactspline.geometry.pairs.box_tree import Cone, cone_around, legs, pairs_that_may_meet, segments_of, shift_for
from exactspline.geometry.pairs.lazy_intersections import PairForm
from exactspline.geometry.pairs.sides_at_knots import changes_side, half_branches, interlace
from exactspline.geometry.pairs.space_intersections import SpaceForms, space_meetings
from exactspline.hooks import Displayed
from exactspline.numbers.exact import common_divisor, mpq, over_one_denominator
from exactspline.numbers.intervals import Box, Interval
from exactspline.numbers.once import cached_property
from exactspline.one_line import one_line
from exactspline.polynomials.bezout import PlaneForms
from exactspline.polynomials.common_arcs import Arc, Local, Meeting, Meetings, Rest
from exactspline.polynomials.cost import PATCH, QUESTION, Budget, drawing_on
from exactspline.polynomials.factors import divided_out, greatest_common_divisor
from exactspline.polynomials.patch_forms import PatchForm
from exactspline.polynomials.plane_pairs import meetings, self_meetings
from exactspline.polynomials.two_parameters import S, T
from exactspline.polynomials.zero_places import Place
from exactspline.programs.certain_pairs import OF_POINT, certain_pair, closer, points_of
from exactspline.reals.real import RationalNumber, Real, real
from exactspline.roots.answers import Answer
from exactspline.roots.segment_forms import (
    ImageValue,
    image_splines,
    is_joined,
    is_point,
    parameter,
    segment_forms,
    segment_rows,
)
from exactspline.roots.values import evaluate, segment_polynomials
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.tensor import surface_pair
from exactspline.splines.type_checks import curve_of


class IntersectionKind(StrEnum):
    """How two curves meet at a point."""

    #: Each curve passes from one side of the other curve to its other side.
    CROSSING = "crossing"
    #: Each curve stays on one side of the other.
    TOUCHING = "touching"
    #: One of the curves ends there.
    END = "end"
    #: The point is at a knot of one of the curves; it is not decided whether they cross.
    KNOT = "knot"
    #: In space, where curves have no sides; for offsets, where it is not decided whether they cross.
    SPACE = "common point"


@dataclass(frozen=True)
class Intersection:
    """One common point: a parameter of each curve.

    `multiplicity` is the intersection multiplicity: 1 where the tangents differ, k + 1 where the curves have contact of
    order k. At knots `multiplicity` is the least multiplicity of the segments that meet there. The multiplicity is None
    in space, and where two arcs of the same algebraic curve continue each other.
    """

    first: Real
    second: Real
    kind: IntersectionKind
    multiplicity: int | None
    curves: tuple[Nurbs, Nurbs]
    #: Whether the parameter of the first, and of the second, is a knot (or an end).
    at_knot: tuple[bool, bool] = (False, False)

    @property
    def point(self) -> tuple[mpq | Real, ...]:
        """The coordinates, exactly."""
        # rational numbers, and after them zeros, are simpler than the value of a map at a zero
        k = min((0, 1), key=lambda k: _unknown((self.first, self.second)[k]))
        return evaluate(self.curves[k], (self.first, self.second)[k])

    @property
    def contact(self) -> int | None:
        """The order of contact: the multiplicity less one."""
        return None if self.multiplicity is None else self.multiplicity - 1

    @one_line
    def __repr__(self) -> str:
        times = "" if self.multiplicity in (None, 1) else f", multiplicity {self.multiplicity}"
        return f"<{self.kind} at {self.first.shortly()} and {self.second.shortly()}{times}>"


def _unknown(parameter: Real) -> tuple[bool, bool]:
    """The sorting key of parameters, the simplest ones first."""
    return not isinstance(parameter, RationalNumber), isinstance(parameter, ImageValue)


@dataclass(frozen=True)
class Overlap:
    """An arc that two curves have in common: the parameters of both curves at its ends, in the order of the second
    parameter. Both parameters are monotone along the arc.

    `numerator` and `denominator` are the coefficients, constant term first, of polynomials N and D such that the
    parameter of the first curve is ``N(t)/D(t)`` at the parameter t of the second (or the other way round with
    `of_second`); both are None where the parameters are not rational functions of each other.
    """

    first: tuple[Real, Real]
    second: tuple[Real, Real]
    numerator: tuple[int, ...] | None
    denominator: tuple[int, ...] | None
    of_second: bool = False

    @property
    def reversed(self) -> bool:
        """Whether the curves run in opposite directions."""
        return self.first[0] > self.first[1]

    @one_line
    def __repr__(self) -> str:
        first, second = ("[{}, {}]".format(*(x.shortly() for x in ends)) for ends in (self.first, self.second))
        return f"<overlap of {first} and {second}{', reversed' if self.reversed else ''}>"


@dataclass(frozen=True, repr=False)
class Intersections(Answer[Intersection, Overlap], Displayed):
    """All common points of two curves in the order of the parameter of the first, and `everywhere` the common arcs,
    whose points are not listed singly. `undecided` lists the pairs of segments that would take too much work; if there
    are any, an empty list of points does not mean that the curves do not meet.
    """

    undecided: tuple[str, ...] = ()
    curves: tuple[Nurbs, Nurbs] | None = field(default=None, compare=False)

    def __bool__(self) -> bool:
        return super().__bool__() or bool(self.undecided)

    def certificate(self) -> dict[str, object]:
        """A proof, as JSON data with exact strings, that these are all common points, with their multiplicities (see
        `exactspline.certificates`). Only two plane curves without arcs in common have such a proof.

        >>> from exactspline import Nurbs, check_certificate
        >>> first, second = (Nurbs(1, [0, 0, 1, 1], [(0, y), (1, 1 - y)]) for y in (0, 1))
        >>> check_certificate(intersections(first, second).certificate())
        {'points': 1, 'multiplicity': 1}

        Raises `ShapeError` in space and for weights of different signs, and `ReachError` where arcs are in common, or
        the proof is too long.
        """
        if self.curves is None:
            raise ShapeError("a certificate of a curve and itself", remedy="give two curves")
        return _certificate(*self.curves)

    def _parts(self) -> list[str]:
        return super()._parts() + [f"undecided: {what}" for what in self.undecided]


#: The largest number of pairs of segments of one certificate.
PAIRS = 10_000


def _certificate(first: Nurbs, second: Nurbs) -> dict[str, object]:
    """The certificate of all common points of two plane curves: of the common zeros of the differences of their
    coordinates, each times both weights.
    """
    if first.dimension != 2 or second.dimension != 2:
        raise ShapeError("a certificate of points in space", remedy="give curves in the plane")
    if first.segments * second.segments > PAIRS:
        raise ReachError(f"a certificate of {first.segments * second.segments} pairs of segments", remedy=REMEDY)
    one, other = (_homogeneous(curve) for curve in (first, second))
    pair = surface_pair(first, second)
    differences = [x * pair.second.w - y * pair.first.w for x, y in zip(pair.first.p, pair.second.p, strict=True)]
    zeros = common_zeros_of(*differences)
    if zeros.everywhere or zeros.undecided:
        raise ReachError("a certificate of curves with arcs in common, or with undecided common points", remedy=REMEDY)
    found = [(point.place, point.patches) for point in zeros.points]

    def proved(i: int, j: int) -> dict[str, object]:
        (*own, w), (*partner, v) = one[i], other[j]
        forms = [
            PatchForm.of_net([[x * q - y * p for y, q in zip(ys, v, strict=True)] for x, p in zip(xs, w, strict=True)])
            for xs, ys in zip(own, partner, strict=True)
        ]
        return {"segments": [i, j]} | proof_on_patch(forms, (i, j), differences[0].patch(i, j), found)

    written = {
        name: [{x: list(map(str, row)) for x, row in zip("xyw", rows, strict=True)} for rows in curve]
        for name, curve in (("first", one), ("second", other))
    }
    pairs = [proved(i, j) for i in range(len(one)) for j in range(len(other))]
    return certificate(INTERSECTIONS, written | {"pairs": pairs})


def _homogeneous(curve: Nurbs) -> list[list[list[int]]]:
    """The coordinates of the Bézier points of each segment times their weights, and these, as integers; the weights are
    positive.
    """
    found = []
    for i in range(curve.segments):
        n, rows = segment_rows(curve, i)
        integers, _ = over_one_denominator([mpq(int(c), comb(n, k)) for row in rows for k, c in enumerate(row)])
        sign = 1 if integers[-1] > 0 else -1
        split = [[sign * x for x in integers[k : k + n + 1]] for k in range(0, len(integers), n + 1)]
        if min(split[-1]) <= 0:
            raise ShapeError("a certificate of a curve with weights of different signs", remedy=REMEDY)
        found.append(split)
    return found


def intersections(first: Nurbs, second: Nurbs) -> Intersections:
    """All common points of two curves, in the plane or in space (see `exactspline.intersections`).

    >>> from exactspline import Nurbs, example
    >>> intersections(example("ellipse"), Nurbs(1, [0, 0, 1, 1], [(-4, 0), (4, 0)]))
    [<crossing at 0 and 3/4>, <crossing at 2 and 1/4>]

    Raises `ShapeError` for curves of different dimensions, and outside plane and space.
    """
    if (found := _of_only_segments(first, second, alone=False)) is not None:
        return found
    check_in_one_space(first, second)
    return CollectedPoints(first, second).answer()


def self_intersections(curve: Nurbs) -> Intersections:
    """The points through which a plane curve passes more than once, each as a pair of parameters s < t; neighbouring
    segments, and the ends of a closed curve, do not meet in their common knot. All parameters of an interval on which
    the curve is constant count as one.

    >>> from exactspline import Nurbs
    >>> loop = Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (3, 3), (-2, 3), (1, 0)])
    >>> self_intersections(loop)
    [<crossing at (2 - √3)/4 and (2 + √3)/4>]

    Raises `ShapeError` for a curve that is not in a plane.
    """
    curve = curve_of(curve)
    if curve.dimension != 2 and (curve.dimension != 3 or in_common_plane(curve) is None):
        raise ShapeError(f"a curve in R{curve.dimension}", remedy="give a curve in a plane")
    found = _of_only_segments(curve, curve, alone=True)
    return CollectedPoints(curve, curve, alone=True).answer() if found is None else found


def _of_only_segments(first: Nurbs, second: Nurbs, *, alone: bool) -> Intersections | None:
    """The common points of two curves of one segment, or of one and itself, if they are certain in doubles."""
    one, other, curves = segments_of(first), segments_of(second), (first, second)
    if len(one.rows) != 1 or len(other.rows) != 1:
        return None
    found = certain_pair(one.table, 0, None if alone else other.table, 0)
    if found is None:
        return None
    make = partial(_in_order, [], curves, curves, [((0, 0), found)] if found else [])
    return Intersections.late(len(found) // OF_POINT, make, curves=None if alone else curves)


class _Found(NamedTuple):
    """A common point of two segments: their indices, both parameters, and which knots these are (None: inside)."""

    segments: tuple[int, int]
    parameters: tuple[Real, Real]
    knots: tuple[int | None, int | None]
    multiplicity: int | None

    def exchanged(self) -> _Found:
        """The common point for the exchanged curves."""
        return _Found(self.segments[::-1], self.parameters[::-1], self.knots[::-1], self.multiplicity)

    def is_at(self, other: _Found) -> bool:
        """Whether two common points are the same pair of parameters."""
        return all(
            (a is not None and a == b) or x == y
            for a, b, x, y in zip(self.knots, other.knots, self.parameters, other.parameters, strict=True)
        )


class CollectedPoints:
    """The common points and arcs of any two segments, each once."""

    def __init__(self, first: Nurbs, second: Nurbs, *, alone: bool = False) -> None:
        plane = in_common_plane(first, second) if first.dimension == 3 else None
        #: The curves, and the curves used in the computation: for curves in a plane in space their images in two
        #: coordinates.
        self.given, self.curves = (first, second), (first, second) if plane is None else plane[1]
        self.alone, self.in_space = alone, self.curves[0].dimension == 3
        prepared = [segments_of(curve) for curve in self.curves[: 2 - alone]]
        self.segments = [own.rows for own in prepared]
        #: The common points inside two segments.
        self.inner: list[_Found] = []
        self.at_knots: dict[tuple[object, object], list[list[_Found]]] = {}
        self.arcs: list[Overlap] = []
        self.undecided: list[str] = []
        #: The cone around the legs of a segment.
        self._cone: Callable[[int], Cone | None] = cache(lambda i: cone_around(legs(self.segments[0][i])))
        trees = [own.boxes(shift_for(*prepared)) for own in prepared]
        pairs = list(pairs_that_may_meet(trees[0], trees[-1]))
        table, others = prepared[0].table, None if alone else prepared[1].table
        certain = [certain_pair(table, i, others, j) for i, j in pairs]
        #: The numbers of the common points that are certain in doubles.
        self.certain = [(pair, found) for pair, found in zip(pairs, certain, strict=True) if found]
        if None in certain:
            with drawing_on(Budget(QUESTION + PATCH * (len(pairs) - 1))):
                for (i, j), found in zip(pairs, certain, strict=True):
                    if found is None and not (alone and self.runs_on(i, j)):
                        self._collect(i, j)

    def runs_on(self, i: int, j: int) -> bool:
        """Whether a curve is certainly monotone in a direction on a segment, or on two adjacent segments: then it does
        not meet itself there, except in the common knot.
        """
        curve, last = self.curves[0], len(self.segments[0]) - 1
        if j > i + 1 and not (i == 0 and j == last and curve.closed):
            return False
        if j == i + 1 and curve.p[0].continuity[i] < 0:
            return False
        cones = [self._cone(k) for k in (i, j)]
        return None not in cones and cone_around([leg for cone in cones for leg in cone or ()]) is not None

    def _form(self, k: int, i: int) -> Any:
        """A segment of one of the curves, in the plane or in space."""
        n, forms = segment_forms(self.curves[k], i)
        return (SpaceForms if self.in_space else PlaneForms)(n, *forms)

    def _collect(self, i: int, j: int) -> None:
        one, other = self._form(0, i), self._form(1, j)
        try:
            if self.alone and i == j:
                found = self_meetings(one)
            else:
                found = space_meetings(one, other) if self.in_space else meetings(one, other)
        except ReachError as error:
            try:
                self._collect_by_chord(i, j)
            except ReachError:
                sides = " and ".join(str(_side(self.curves[k], at)) for k, at in enumerate((i, j)))
                self.undecided.append(f"the segments over {sides}: {error.problem}")
            return
        self._add(found, i, j)

    def _collect_by_chord(self, i: int, j: int) -> None:
        """The common points of two plane segments as common zeros of the coordinates of their chord; no determinant is
        needed where boxes show that there are none. Raises `ReachError`, also where an arc may be in common.
        """
        if self.in_space:
            raise ReachError("segments in space")
        chord = list(PlanePair.of_segments((self.curves[0], i), (self.curves[1], j)).chord)
        if alone := self.alone and i == j:
            chord = [divided_out(f, S - T) for f in chord]
        if greatest_common_divisor(chord).total_degree() > 0:
            raise ReachError("segments that may have an arc in common")
        sides, found = Box(_side(self.curves[0], i), _side(self.curves[1], j)), list[_Found]()
        for zero in common_zeros(chord, sides):
            place = real(zero.s), real(zero.t)
            if not alone or place[0] < place[1]:
                at = zip(place, sides, (i, j), self._knots, strict=True)
                knots = [own[k + (x == side.high)] if x in side[:] else None for x, side, k, own in at]
                found.append(_Found((i, j), place, (knots[0], knots[1]), multiplicity(zero, chord[0], chord[1])))
        for point in found:
            self._put(point)

    def _add(self, found: Meetings, i: int, j: int) -> None:
        sides = _side(self.curves[0], i), _side(self.curves[1], j)
        for point in found.points:
            knots = self._knot(0, i, point.first), self._knot(1, j, point.second)
            self._put(_Found((i, j), _parameters(point, *sides), knots, point.multiplicity))
        for arc in found.arcs:
            self.arcs.append(_overlap(arc, *sides))
        for rest in found.rests:
            if self.alone and self._is_joint(rest, i, j):
                continue
            at_rest, other = sides[::-1] if rest.exchanged else sides
            still = Real(at_rest.low), Real(at_rest.high)
            place = (Real(other.low), Real(other.high))
            if rest.place is not None:
                place = (parameter(rest.place, other, at_rest),) * 2
            first, second = (place, still) if rest.exchanged else (still, place)
            self.arcs.append(Overlap(first, second, None, None))

    @cached_property
    def _knots(self) -> list[list[int]]:
        return [self._different_knots(k) for k in range(2)]

    def _different_knots(self, k: int) -> list[int]:
        """For each knot the first knot at the same point: at the seam of a closed curve and, for a curve and itself, at
        the ends of an interval on which the curve is constant.
        """
        indices, segments = list(range(self.curves[k].segments + 1)), self.segments[0] if self.alone else []
        for i, segment in enumerate(segments):
            if is_point(segment) and all(map(is_joined, segments[max(i - 1, 0) : i + 1], segments[max(i, 1) : i + 2])):
                indices[i + 1] = indices[i]
        return [0 if self.curves[k].closed and index == indices[-1] else index for index in indices]

    def _is_joint(self, rest: Rest, i: int, j: int) -> bool:
        """Whether a segment on which the curve is constant meets itself or a neighbour, in their knot."""
        still, other = (j, i) if rest.exchanged else (i, j)
        others = self._knots[0][other : other + 2] if rest.place is None else [self._knot(0, other, rest.place)]
        return any(knot in self._knots[0][still : still + 2] for knot in others)

    def _knot(self, k: int, i: int, local: Local) -> int | None:
        """The index of the knot at a parameter on segment i; of equal knots the first one."""
        if not isinstance(local, Place) or local.exact not in (0, 1):
            return None
        return self._knots[k][i + int(local.exact)]

    def _put(self, point: _Found) -> None:
        s, t = point.knots
        if s is None and t is None:
            self.inner.append(point)
            return
        if self.alone:
            if s == t:
                return
            if t == 0:
                point = point.exchanged()
                s, t = point.knots
        key = (("knot", s) if s is not None else point.segments[0], ("knot", t) if t is not None else point.segments[1])
        groups = self.at_knots.setdefault(key, [])
        group = next((group for group in groups if group[0].is_at(point)), None)
        if group is None:
            groups.append([point])
        else:
            group.append(point)

    def answer(self) -> Intersections:
        """All common points and arcs, in order."""
        at_knots = [
            self._at_knot(group)
            for groups in self.at_knots.values()
            for group in groups
            if not self._ends_an_arc(group[0])
        ]
        exact = at_knots + [self._at_knot([point]) for point in self.inner]
        count = len(exact) + sum(len(found) for _, found in self.certain) // OF_POINT
        make = partial(_in_order, exact, self.given, self.curves, self.certain)
        curves = None if self.alone else self.given
        return Intersections.late(count, make, tuple(self.arcs), undecided=tuple(self.undecided), curves=curves)

    def _ends_an_arc(self, point: _Found) -> bool:
        place = tuple(self._at(k, point) for k in (0, 1))
        # the seam of a closed curve becomes its start: this may change the order of the two parameters
        places = (place, place[::-1]) if self.alone else (place,)
        ends = (pair for arc in self.arcs for pair in zip(arc.first, arc.second, strict=True))
        return any(tuple(map(from_seam, self.curves, pair)) in places for pair in ends)

    def _at_knot(self, group: list[_Found]) -> Intersection:
        point = group[0]
        times = [each.multiplicity for each in group if each.multiplicity is not None]
        return Intersection(
            self._at(0, point),
            self._at(1, point),
            self._kind(group),
            min(times, default=None),
            self.given,
            (point.knots[0] is not None, point.knots[1] is not None),
        )

    def _at(self, k: int, point: _Found) -> Real:
        knot = point.knots[k]
        return point.parameters[k] if knot is None else Real(self.curves[k].breakpoints[knot])

    def _kind(self, group: list[_Found]) -> IntersectionKind:
        knots = group[0].knots
        if knots == (None, None) and not self.in_space:
            return IntersectionKind.CROSSING if (group[0].multiplicity or 0) % 2 else IntersectionKind.TOUCHING
        for curve, knot in zip(self.curves, knots, strict=True):
            if knot in (0, curve.segments) and not curve.closed:
                return IntersectionKind.END
        if self.in_space:
            return IntersectionKind.SPACE
        s, t = knots
        if len({each.segments for each in group}) < (2 if s is None or t is None else 4):
            return IntersectionKind.KNOT
        if s is not None and t is not None:
            crosses = self._cross_at_knots(s, t)
        else:
            k = 0 if s is not None else 1
            crosses = self._cross_at_knot(k, s or t or 0, group[0].segments[1 - k])
        if crosses is None:
            return IntersectionKind.KNOT
        return IntersectionKind.CROSSING if crosses else IntersectionKind.TOUCHING

    def _cross_at_knot(self, k: int, knot: int, other: int) -> bool | None:
        """Whether curve k, which has a knot here, changes sides with respect to a segment of the other curve, which has
        no knot here.
        """
        before, behind = self._form(k, self._before(k, knot)), self._form(k, knot)
        return changes_side(self._form(1 - k, other), before, behind)

    def _before(self, k: int, knot: int) -> int:
        return (knot or self.curves[k].segments) - 1

    def _cross_at_knots(self, s: int, t: int) -> bool | None:
        """Whether two curves that both have a knot here change sides."""
        one, other = (
            half_branches(self._form(k, self._before(k, knot)), self._form(k, knot)) for k, knot in enumerate((s, t))
        )
        return interlace(one, other)


def _in_order(
    exact: list[Intersection],
    given: tuple[Nurbs, Nurbs],
    curves: Sequence[Nurbs],
    certain: list[tuple[tuple[int, int], Sequence[float]]],
) -> tuple[Intersection, ...]:
    """The common points that are decided exactly, and those of pairs of segments that are certain in doubles, in the
    order of the first curve. An interrupt changes nothing.
    """
    places: list[tuple[int, Sequence[float], Intersection]] = []
    one, other = map(segments_of, curves)
    for (i, j), found in certain:
        forms, sides = PairForm(one.rows[i], other.rows[j]), (_side(curves[0], i), _side(curves[1], j))
        for point in points_of(found):
            parameters = forms.parameters(point, closer(one.precise, i, other.precise, j, point[:4]), *sides)
            places.append((i, point, Intersection(*parameters, IntersectionKind.CROSSING, 1, given)))
    ordered = sorted(places, key=itemgetter(0, 1))
    if exact or any(i == j and one[1] >= other[0] for (i, one, _), (j, other, _) in pairwise(ordered)):
        return tuple(sorted([*exact, *(place[2] for place in places)], key=lambda point: point.first))
    return tuple([place[2] for place in ordered])


def from_seam(curve: Nurbs, t: Real) -> Real:
    """The parameter; at the end of a closed curve its start."""
    return Real(curve.domain.low) if curve.closed and t == curve.domain.high else t


def _side(curve: Nurbs, i: int) -> Interval:
    return Interval(*curve.breakpoints[i : i + 2])


def _parameters(point: Meeting, first: Interval, second: Interval) -> tuple[Real, Real]:
    """The parameters of a common point of segments over two intervals."""
    return parameter(point.first, first, second), parameter(point.second, second, first)


def _overlap(arc: Arc, first: Interval, second: Interval) -> Overlap:
    one = parameter(arc.first[0], first, second), parameter(arc.first[1], first, second)
    other = parameter(arc.second[0], second, first), parameter(arc.second[1], second, first)
    if other[0] > other[1]:
        one, other = one[::-1], other[::-1]
    if arc.map is None:
        return Overlap(one, other, None, None)
    sides = (second, first) if arc.exchanged else (first, second)
    top, bottom = segment_polynomials(image_splines(arc.map, *sides), 0)
    # already in lowest terms up to a constant
    common = common_divisor([top.content(), bottom.content()]) * (-1 if bottom.leading_coefficient() < 0 else 1)
    coefficients = [tuple(int(x // common) for x in p.coeffs()) for p in (top, bottom)]
    return Overlap(one, other, coefficients[0], coefficients[1], arc.exchanged)
