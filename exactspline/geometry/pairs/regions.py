"""The region bounded by several closed plane curves, such as the contours of a glyph with its holes: its area and
moments, and whether a point is inside, by the rule ``nonzero`` or ``even-odd``. The methods are entries of the registry
of questions.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import combinations

from exactspline.errors import ShapeError, as_items
from exactspline.geometry.curves.facts import facts_of
from exactspline.geometry.curves.planarity import in_the_plane
from exactspline.geometry.measures.integrals import Terms, centroid, moment, named_moments, number
from exactspline.geometry.pairs.intersections import intersections, self_intersections
from exactspline.geometry.pairs.winding import FillRule, Position, contains, winding_number
from exactspline.hooks import Displayed
from exactspline.numbers.exact import Number, mpq
from exactspline.one_line import one_line
from exactspline.questions.answers import NamedNumbers
from exactspline.questions.entry import Answered, Inspected, Of, question, question_with
from exactspline.questions.takes import INTEGER, POINT
from exactspline.reals.real import Real
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of
from exactspline.words import choice

OVERLAPS = "remove overlaps first, or take a part of the file"


class Region(Inspected, Displayed):
    """The region inside closed plane curves.

    >>> square = Nurbs(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (4, 0), (4, 4), (0, 4), (0, 0)])
    >>> hole = Nurbs(1, [0, 0, 1, 2, 3, 3], [(1, 1), (3, 1), (1, 2), (1, 1)])
    >>> Region([square, hole], "even-odd").area, Region([square, hole]).area, Region([square, hole.reverse()]).area
    (<Real 15>, <Real 16>, <Real 15>)
    """

    def __init__(self, curves: Iterable[Nurbs], rule: FillRule | str = FillRule.NONZERO) -> None:
        self.curves = [in_the_plane(curve_of(curve)) for curve in as_items(curves, "curves")]
        self.rule = choice(FillRule, rule, "fill rule")
        super().__init__(*self.curves, self.rule)

    @one_line
    def __repr__(self) -> str:
        return f"<Region of {len(self.curves)} curves, {self.rule}>"

    @question_with(POINT, Of.REGION, answered=Answered.VALUE)
    def winding_number(self, point: Iterable[Number]) -> int:
        """How often the curves wind around a point, counterclockwise.

        >>> from exactspline import Nurbs
        >>> from exactspline.geometry.pairs.regions import Region
        >>> square = Nurbs(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (4, 0), (4, 4), (0, 4), (0, 0)])
        >>> Region([square, square]).winding_number((1, 1))
        2

        Raises `DomainError` for a point on a curve, and `ShapeError` for a curve that is not closed.
        """
        return winding_number(self.curves, point)

    @question_with(POINT, Of.REGION, answered=Answered.VALUE)
    def contains(self, point: Iterable[Number]) -> Position:
        """Whether a point is inside the region, outside of it, or on one of its curves.

        >>> from exactspline import Nurbs
        >>> from exactspline.geometry.pairs.regions import Region
        >>> square = Nurbs(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (4, 0), (4, 4), (0, 4), (0, 0)])
        >>> Region([square, square], "even-odd").contains((1, 1)), Region([square]).contains((1, 1))
        (<Position.OUTSIDE: 'outside'>, <Position.INSIDE: 'inside'>)

        Raises `ShapeError` for a curve that is not closed.
        """
        return contains(self.curves, point, self.rule)

    @question(Of.REGION, answered=Answered.VALUE, on_request=True)
    def area(self) -> Real:
        """The area of the region, without its holes.

        >>> from exactspline import Nurbs
        >>> from exactspline.geometry.pairs.regions import Region
        >>> square = Nurbs(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (4, 0), (4, 4), (0, 4), (0, 0)])
        >>> Region([square]).area
        <Real 16>

        Raises `ShapeError` as `moments` does.
        """
        return number(self._moment(0, 0))

    @question_with(INTEGER, Of.REGION, answered=Answered.NUMBERS)
    def moments(self, order: int = 2) -> tuple[NamedNumbers, ...]:
        """The moments ∬ xⁱ yʲ over the region with i + j up to an order, by default 2.

        >>> from exactspline import Nurbs
        >>> from exactspline.geometry.pairs.regions import Region
        >>> square = Nurbs(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (4, 0), (4, 4), (0, 4), (0, 0)])
        >>> [found.values["moment"] for found in Region([square]).moments(1)]
        [<Real 16>, <Real 32>, <Real 32>]

        Raises `ShapeError` for a curve that is not closed or not in the plane, and for curves that meet each other or
        themselves, and `QuestionError` for an order above 8.
        """
        return named_moments(self._moment, order)

    @question(Of.REGION, answered=Answered.NUMBERS, on_request=True)
    def centroid(self) -> tuple[NamedNumbers, ...]:
        """The centroid of the region.

        >>> from exactspline import Nurbs
        >>> from exactspline.geometry.pairs.regions import Region
        >>> square = Nurbs(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (4, 0), (4, 4), (0, 4), (0, 0)])
        >>> Region([square]).centroid
        (<centroid: x 2, y 2>,)

        Raises `ShapeError` as `moments` does, and `DomainError` where the area is 0.
        """
        return centroid(self._moment)

    def _moment(self, i: int, j: int) -> Terms:
        signs = zip(self.curves, self.once("signs", self._signs), strict=True)
        return tuple(term.times(mpq(sign)) for x, sign in signs if sign for term in moment(facts_of(x), i, j))

    def _signs(self) -> list[int]:
        """For each curve whether the moments of its interior are added (1), subtracted (−1) or ignored (0)."""
        areas = [number(moment(facts_of(curve), 0, 0)) for curve in self.curves]
        for met in (x.name for x in self.curves if self_intersections(x)):
            raise ShapeError("a contour that meets itself", where=met, remedy=OVERLAPS)
        for met in (f"{a.name} and {b.name}" for a, b in combinations(self.curves, 2) if intersections(a, b)):
            raise ShapeError("contours that meet each other", where=met, remedy=OVERLAPS)
        signs = list[int]()
        for i, curve in enumerate(self.curves):
            turn = 1 if areas[i] > 0 else -1
            around = winding_number([*self.curves[:i], *self.curves[i + 1 :]], curve(curve.domain[0]))
            # outside this curve only the others wind around the point; inside, this curve does, too
            signs.append((self._is_filled(around + turn) - self._is_filled(around)) * turn)
        return signs

    def _is_filled(self, number: int) -> bool:
        return bool(number % 2 if self.rule is FillRule.EVEN_ODD else number)
