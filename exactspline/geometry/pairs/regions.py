"""The region that several closed plane curves bound together, as the contours of a glyph, with its holes: its area and
moments, and which points are inside, by the rule ``nonzero`` or ``even-odd``.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import combinations

from exactspline.errors import ShapeError, as_items
from exactspline.geometry.curves.facts import facts_of
from exactspline.geometry.curves.moments import moments_up_to
from exactspline.geometry.pairs.intersections import intersections, self_intersections
from exactspline.geometry.pairs.winding import FillRule, Position, contains, winding_number
from exactspline.numbers.exact import Number, mpq
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of
from exactspline.words import choice


class Region:
    """The region inside closed plane curves.

    >>> square = Nurbs(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (4, 0), (4, 4), (0, 4), (0, 0)])
    >>> hole = Nurbs(1, [0, 0, 1, 2, 3, 3], [(1, 1), (3, 1), (1, 2), (1, 1)])
    >>> Region([square, hole], "even-odd").area, Region([square, hole]).area, Region([square, hole.reverse()]).area
    (mpq(15,1), mpq(16,1), mpq(15,1))
    """

    def __init__(self, curves: Iterable[Nurbs], rule: FillRule | str = FillRule.NONZERO) -> None:
        self.curves = [curve_of(curve) for curve in as_items(curves, "curves")]
        self.rule = choice(FillRule, rule, "fill rule")

    def winding_number(self, point: Iterable[Number]) -> int:
        """How often the curves wind around a point; raises the errors of `winding_number`."""
        return winding_number(self.curves, point)

    def contains(self, point: Iterable[Number]) -> Position:
        """Whether a point is inside; raises the errors of `contains`."""
        return contains(self.curves, point, self.rule)

    @property
    def area(self) -> mpq:
        """The area; raises `ShapeError` as `moments` does."""
        return self.moments(0)[0, 0]

    def moments(self, order: int = 2) -> dict[tuple[int, int], mpq]:
        """The moments ∬ xⁱ yʲ with i + j up to an order.

        Raises `ShapeError` for a curve that is not closed, polynomial and in the plane, and where curves meet each
        other or themselves.
        """
        if any(map(self_intersections, self.curves)) or any(intersections(*p) for p in combinations(self.curves, 2)):
            raise ShapeError("contours that meet each other, or themselves", remedy="remove their overlaps first")
        total: dict[tuple[int, int], mpq] = {}
        for i, curve in enumerate(self.curves):
            found = moments_up_to(facts_of(curve), order)
            turn = 1 if found[0, 0] > 0 else -1
            around = winding_number([*self.curves[:i], *self.curves[i + 1 :]], curve(curve.domain[0]))
            # on one side the number of the others, on the inner one that of this curve more
            sign = (self._is_filled(around + turn) - self._is_filled(around)) * turn
            total = {key: total.get(key, mpq(0)) + sign * value for key, value in found.items()}
        return total

    def _is_filled(self, number: int) -> bool:
        return bool(number % 2 if self.rule is FillRule.EVEN_ODD else number)
