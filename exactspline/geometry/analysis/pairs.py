"""The questions about two curves: entries of the registry of questions."""

from __future__ import annotations

from exactspline.geometry.bisectors.any_pair import bisector
from exactspline.geometry.bisectors.common import Bisector
from exactspline.geometry.curves.planarity import in_one_plane
from exactspline.geometry.pairs import offsets
from exactspline.geometry.pairs.deviation import deviation, deviation_within
from exactspline.geometry.pairs.distance import Distance, nearest_pairs
from exactspline.geometry.pairs.intersections import Intersections, intersections
from exactspline.geometry.pairs.junctions import junctions, junctions_within
from exactspline.geometry.rounded.intersections import NearbyMeeting, intersections_nearby
from exactspline.hooks import Displayed
from exactspline.numbers.exact import Number, rational
from exactspline.one_line import one_line
from exactspline.questions.answers import NamedNumbers
from exactspline.questions.entry import Answered, Inspected, Of, question, question_with
from exactspline.questions.takes import OFFSETS, TOLERANCE, WITHIN
from exactspline.splines.nurbs import Nurbs


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
        return junctions(*self.curves)

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
        return junctions_within(*self.curves, rational(epsilon))

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
