"""The questions about two curves: entries of the registry of questions. How two curves meet at their ends is computed
here: the first curve is traversed towards one of its ends, the second curve away from one of its ends.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from exactspline.errors import ShapeError
from exactspline.formulas.derivatives import across, turning_rate
from exactspline.geometry.bisectors.any_pair import bisector
from exactspline.geometry.bisectors.common import Bisector
from exactspline.geometry.curves.angles import Angle, degrees
from exactspline.geometry.curves.facts import facts_of
from exactspline.geometry.curves.joints import ORDER, Jet, Point, distance, limit_direction, order_of, turned
from exactspline.geometry.curves.planarity import check_in_one_space, in_one_plane
from exactspline.geometry.pairs import offsets
from exactspline.geometry.pairs.deviation import deviation, deviation_within
from exactspline.geometry.pairs.distance import Distance, nearest_pairs
from exactspline.geometry.pairs.intersections import Intersections, intersections
from exactspline.geometry.rounded.intersections import NearbyMeeting, intersections_nearby
from exactspline.hooks import Displayed
from exactspline.language.vector import Vector, norm2, perp
from exactspline.numbers.exact import Number, mpq, rational, text
from exactspline.numbers.intervals import Side
from exactspline.one_line import one_line
from exactspline.questions.answers import NamedNumbers
from exactspline.questions.entry import Answered, Inspected, Of, question, question_with
from exactspline.questions.takes import OFFSETS, TOLERANCE, WITHIN
from exactspline.reals.real import Real
from exactspline.splines.nurbs import Nurbs


def _parametric_order(left: Jet, right: Jet) -> int:
    """The order of parametric continuity of two sides: −1 for different points, 3 for an order of at least 3.

    >>> a, b = [((0, 0), (1, 0), (0, k), (0, 0)) for k in (0, 1)]
    >>> _parametric_order(a, a), _parametric_order(a, b)
    (3, 1)
    """
    return next((k - 1 for k in range(ORDER + 1) if left[k] != right[k]), ORDER)


def _curvature_vector(jet: Jet) -> Point:
    """κN of a jet with γ′ ≠ 0: it points from the curve towards the centre of curvature and has the length |κ|.

    >>> _curvature_vector(((0, 0), (0, 2), (-4, 0), (0, 0)))
    (mpq(-1,1), mpq(0,1))
    """
    first, second = (Vector(*map(mpq, part)) for part in jet[1:3])
    if len(first) == 2:
        return tuple(perp(first) * turning_rate(first, second))
    return tuple(across(first, second) / norm2(first) ** 2)


class _Sides(NamedTuple):
    """Two ends: their parameters, their jets and the directions of their tangents, traversed from the first curve to
    the second.
    """

    places: tuple[mpq, mpq]
    left: Jet
    right: Jet
    directions: tuple[Point, Point]

    @property
    def gap(self) -> Real:
        """The distance of the points."""
        return distance(self.left[0], self.right[0])

    @property
    def angle(self) -> Angle | None:
        """The angle between the tangents; None where they have the same direction or a tangent does not exist."""
        return turned(*self.directions)

    @property
    def jump(self) -> Real | None:
        """The length of the difference of the curvature vectors; None where γ′ = 0 on a side."""
        if not any(self.left[1]) or not any(self.right[1]):
            return None
        return distance(_curvature_vector(self.left), _curvature_vector(self.right))

    @property
    def named(self) -> dict[str, Real]:
        """The two parameters as named numbers."""
        return {"first": Real(self.places[0]), "second": Real(self.places[1])}

    @property
    def described(self) -> NamedNumbers:
        """The exact description of the junction."""
        angle, jump = self.angle, self.jump
        values = self.named | {"gap": self.gap}
        if all(map(any, self.directions)):
            values["angle"] = Real(0) if angle is None else abs(degrees(angle))
        if jump is not None:
            values["curvature jump"] = jump
        order = order_of(self.left, self.right, angle)
        orders = {"geometric": "unknown" if order is None else order}
        return NamedNumbers("ends", values, orders | {"parametric": _parametric_order(self.left, self.right)})

    def order_within(self, epsilon: mpq) -> int:
        """The largest order, up to 2, to which points, unit tangents and curvature vectors of the two ends differ by at
        most a distance.
        """
        if self.gap > epsilon:
            return -1
        cosine = Real(1) if self.angle is None else self.angle.cosine
        # the distance of two unit vectors is √(2 − 2 cos)
        if not all(map(any, self.directions)) or 2 - 2 * cosine > epsilon * epsilon:
            return 0
        return 1 if self.jump is None or self.jump > epsilon else 2


def _reversed_jet(jet: Jet) -> Jet:
    """The jet of the reversed curve."""
    point, first, second, third = jet
    return point, _negative(first), second, _negative(third)


def _negative(v: Point) -> Point:
    return tuple(-x for x in v)


def _pairs_of_ends(first: Nurbs, second: Nurbs) -> list[_Sides]:
    """The pairs of an end of each curve, the nearest pair first; no pairs if one of the curves is closed.

    Raises `ShapeError` for curves of different dimensions, and outside plane and space.
    """
    check_in_one_space(first, second)
    if first.closed or second.closed:
        return []
    pairs = []
    for t, left, direction in _towards_ends(first):
        for s, right, back in _towards_ends(second):
            pairs.append(_Sides((t, s), left, _reversed_jet(right), (direction, _negative(back))))
    return sorted(pairs, key=lambda pair: pair.gap)


def _towards_ends(curve: Nurbs) -> Iterator[tuple[mpq, Jet, Point]]:
    """The parameters of both ends, with jets and directions of the curve traversed towards them."""
    facts, (a, b) = facts_of(curve), curve.domain
    start = limit_direction(facts.velocity, a, Side.RIGHT)
    yield a, _reversed_jet(facts.ends.jet(0, Side.RIGHT)), _negative(start)
    yield b, facts.ends.jet(len(facts.breaks) - 2, Side.LEFT), limit_direction(facts.velocity, b, Side.LEFT)


class CurvePair(Inspected, Displayed):
    """Two curves of the same dimension, in the plane or in space.

    >>> from exactspline import Nurbs, example
    >>> pair = CurvePair(example("circle"), Nurbs(1, [0, 0, 1, 1], [(0, 0), (2, 0)]))
    >>> pair.intersections, pair.distance.value
    ([<crossing at 0 and 1/2>], <Real 0>)
    """

    def __init__(self, first: Nurbs, second: Nurbs) -> None:
        self.curves = in_one_plane(first, second)
        super().__init__(*self.curves)

    @one_line
    def __repr__(self) -> str:
        return f"<CurvePair of {' and '.join(each.name or 'a curve' for each in self.curves)}>"

    @question(Of.TWO_CURVES, answered=Answered.PAIRS)
    def intersections(self) -> Intersections:
        """The common points of two curves, and their common arcs.

        >>> from exactspline import Nurbs, example
        >>> from exactspline.geometry.analysis.pairs import CurvePair
        >>> CurvePair(example("circle"), Nurbs(1, [0, 0, 1, 1], [(0, 0), (2, 0)])).intersections
        [<crossing at 0 and 1/2>]
        """
        return intersections(*self.curves)

    @question_with(OFFSETS, Of.TWO_CURVES, answered=Answered.PAIRS)
    def offset_intersections(self, distances: tuple[Number, Number]) -> Intersections:
        """The common points of the offsets of two plane curves at signed distances (positive to the left), by the
        parameters of the curves.

        >>> from exactspline import Nurbs, example
        >>> from exactspline.geometry.analysis.pairs import CurvePair
        >>> line = Nurbs(1, [0, 0, 1, 1], [(-4, 0), (4, 0)])
        >>> CurvePair(example("ellipse"), line).offset_intersections(("1/4", 0))
        [<knot at 0 and 23/32>, <knot at 2 and 9/32>]

        Raises `ShapeError` in space.
        """
        return offsets.intersections(*self.curves, offset=distances)

    @question_with(WITHIN, Of.TWO_CURVES, answered=Answered.DESCRIBED, nearby=True)
    def intersections_within(self, epsilon: Number) -> tuple[NearbyMeeting, ...]:
        """The common points of all pairs of curves whose control points and weights differ from these two by at most
        this number, and those that only some pairs may have.

        >>> from exactspline import Nurbs, example
        >>> from exactspline.geometry.analysis.pairs import CurvePair
        >>> pair = CurvePair(example("circle"), Nurbs(1, [0, 0, 1, 1], [(0, "1/7"), (2, "2/7")]))
        >>> [found.robust for found in pair.intersections_within("1/1000")]
        [True]
        """
        return intersections_nearby(*self.curves, epsilon)

    @question(Of.TWO_CURVES, answered=Answered.PAIRS)
    def distance(self) -> Distance:
        """The pairs of points of two curves at the least distance.

        >>> from exactspline import Nurbs, example
        >>> from exactspline.geometry.analysis.pairs import CurvePair
        >>> CurvePair(example("circle"), Nurbs(1, [0, 0, 1, 1], [(2, 0), (3, 0)])).distance.value
        <Real 1>
        """
        return nearest_pairs(*self.curves, self.intersections)

    @question(Of.TWO_CURVES, answered=Answered.NUMBERS, on_request=True)
    def deviation(self) -> tuple[NamedNumbers, ...]:
        """Bounds for the largest distance of a point of each of two curves from the other curve (Hausdorff distance).

        The upper bound is at most a hundredth above the lower one, which is the distance of the points at the two
        parameters.

        >>> from exactspline import Nurbs
        >>> from exactspline.geometry.analysis.pairs import CurvePair
        >>> lines = (Nurbs(1, [0, 0, 1, 1], points) for points in ([(0, 0), (1, 0)], [(0, 0), (3, 0)]))
        >>> CurvePair(*lines).deviation[1]
        <second from first: low 2, high 10099/5000, at 1, nearest 1>

        Raises `ReachError` if it would take too much work to decide whether the curves have arcs in common.
        """
        return tuple(deviation(*self.curves))

    @question_with(TOLERANCE, Of.TWO_CURVES, answered=Answered.NUMBERS)
    def deviation_within(self, tolerance: Number) -> tuple[NamedNumbers, ...]:
        """Whether all points of each of two curves are within a distance of the other curve; if not, a point that is
        farther away.

        >>> from exactspline import Nurbs
        >>> from exactspline.geometry.analysis.pairs import CurvePair
        >>> lines = (Nurbs(1, [0, 0, 1, 1], points) for points in ([(0, 0), (1, 0)], [(0, 0), (3, 0)]))
        >>> [found.facts["holds"] for found in CurvePair(*lines).deviation_within(1)]
        ['yes', 'no']

        Raises `ShapeError` for a negative distance, and `ReachError` if the decision takes too much work.
        """
        return tuple(deviation_within(*self.curves, rational(tolerance)))

    @question(Of.TWO_CURVES, answered=Answered.NUMBERS, on_request=True)
    def junctions(self) -> tuple[NamedNumbers, ...]:
        """How the ends of two curves meet: gap, angle of the tangents, jump of the curvature, orders of continuity.

        Each end of the first curve is paired with each end of the second, the nearest pair first; a closed curve has no
        ends. The first curve is traversed towards its end, the second away from its end. Orders are at most 3.

        >>> from exactspline import Nurbs
        >>> from exactspline.geometry.analysis.pairs import CurvePair
        >>> lines = (Nurbs(1, [0, 0, 1, 1], points) for points in ([(0, 0), (1, 0)], [(1, 0), (2, 1)]))
        >>> CurvePair(*lines).junctions[0]
        <ends: first 1, second 0, gap 0, angle 45, curvature jump 0>
        """
        return tuple(pair.described for pair in _pairs_of_ends(*self.curves))

    @question_with(WITHIN, Of.TWO_CURVES, answered=Answered.NUMBERS)
    def junctions_within(self, epsilon: Number) -> tuple[NamedNumbers, ...]:
        """The largest order, from −1 to 2, to which the ends of two curves meet within a distance: points (0), unit
        tangents (1) and curvature vectors κN (2) differ by vectors of at most this length.

        >>> from exactspline import Nurbs
        >>> from exactspline.geometry.analysis.pairs import CurvePair
        >>> lines = (Nurbs(1, [0, 0, 1, 1], points) for points in ([(0, 0), (1, 0)], [(1, 0), (2, "1/500")]))
        >>> CurvePair(*lines).junctions_within("1/100")[0].facts
        {'geometric': 2}
        """
        within = rational(epsilon)
        if within <= 0:
            raise ShapeError(f"within {text(within)}", remedy="give a positive number, such as 1/1000")
        pairs = _pairs_of_ends(*self.curves)
        return tuple(NamedNumbers("ends", pair.named, {"geometric": pair.order_within(within)}) for pair in pairs)

    @question(Of.TWO_CURVES, answered=Answered.SOLUTIONS, on_request=True)
    def bisector(self) -> Bisector:
        """The points equally far from two curves, on normals of both.

        >>> from exactspline import Nurbs
        >>> from exactspline.geometry.analysis.pairs import CurvePair
        >>> lines = (Nurbs(1, [0, 0, 1, 1], points) for points in ([(0, 0), (2, 0)], [(0, 1), (3, 4)]))
        >>> CurvePair(*lines).bisector.pieces
        (<arc from (-1 + √2)/2 and 0 to 1 and (-2 + 3√2)/6>,)
        """
        return bisector(*self.curves)
