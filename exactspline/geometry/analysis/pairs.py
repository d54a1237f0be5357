"""What is asked of two curves: entries of the registry of questions."""

from __future__ import annotations

from exactspline.geometry.curves.planarity import in_one_plane
from exactspline.geometry.pairs.distance import Distance, nearest_pairs
from exactspline.geometry.pairs.intersections import Intersections, intersections
from exactspline.geometry.rounded.intersections import NearbyMeeting, intersections_nearby
from exactspline.hooks import Displayed
from exactspline.numbers.exact import Number
from exactspline.one_line import one_line
from exactspline.questions.entry import Answered, Inspected, Of, question, question_with
from exactspline.questions.takes import WITHIN
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
        """The points that two curves have in common, and the arcs.

        >>> from exactspline import Nurbs, example
        >>> from exactspline.geometry.analysis.pairs import CurvePair
        >>> CurvePair(example("circle"), Nurbs(1, [0, 0, 1, 1], [(0, 0), (2, 0)])).intersections
        [<crossing at 0 and 1/2>]
        """
        return intersections(*self.curves)

    @question_with(WITHIN, Of.TWO_CURVES, answered=Answered.DESCRIBED, nearby=True)
    def intersections_within(self, epsilon: Number) -> tuple[NearbyMeeting, ...]:
        """The points that all curves near both have in common, and those that some may have: of all whose control
        points and weights differ by at most this.

        >>> from exactspline import Nurbs, example
        >>> from exactspline.geometry.analysis.pairs import CurvePair
        >>> pair = CurvePair(example("circle"), Nurbs(1, [0, 0, 1, 1], [(0, "1/7"), (2, "2/7")]))
        >>> [found.certain for found in pair.intersections_within("1/1000")]
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
