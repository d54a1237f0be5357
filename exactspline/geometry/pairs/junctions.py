"""How two curves meet at their ends, as two segments of a curve meet at a knot: the first curve is traversed towards
one of its ends, the second curve away from one of its ends.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from exactspline.errors import ShapeError
from exactspline.geometry.curves.angles import Angle, degrees
from exactspline.geometry.curves.facts import facts_of
from exactspline.geometry.curves.joints import (
    Jet,
    Point,
    curvature_vector,
    distance,
    limit_direction,
    order_of,
    parametric_order,
    reversed_jet,
    turned,
)
from exactspline.geometry.curves.planarity import check_in_one_space
from exactspline.numbers.exact import mpq, text
from exactspline.numbers.sides import Side
from exactspline.questions.answers import NamedNumbers
from exactspline.reals.real import Real
from exactspline.splines.nurbs import Nurbs


class Sides(NamedTuple):
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
        return distance(curvature_vector(self.left), curvature_vector(self.right))

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
        return NamedNumbers("ends", values, orders | {"parametric": parametric_order(self.left, self.right)})

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


def _pairs_of_ends(first: Nurbs, second: Nurbs) -> list[Sides]:
    """The pairs of an end of each curve, the nearest pair first; no pairs if one of the curves is closed.

    Raises `ShapeError` for curves of different dimensions, and outside plane and space.
    """
    check_in_one_space(first, second)
    if first.closed or second.closed:
        return []
    pairs = []
    for t, left, direction in _towards_ends(first):
        for s, right, back in _towards_ends(second):
            away = tuple(-x for x in back)
            pairs.append(Sides((t, s), left, reversed_jet(right), (direction, away)))
    return sorted(pairs, key=lambda pair: pair.gap)


def _towards_ends(curve: Nurbs) -> Iterator[tuple[mpq, Jet, Point]]:
    """The parameters of both ends, with jets and directions of the curve traversed towards them."""
    facts, (a, b) = facts_of(curve), curve.domain
    start = limit_direction(facts.velocity, a, Side.RIGHT)
    yield a, reversed_jet(facts.ends.jet(0, Side.RIGHT)), tuple(-x for x in start)
    yield b, facts.ends.jet(len(facts.breaks) - 2, Side.LEFT), limit_direction(facts.velocity, b, Side.LEFT)


def junctions(first: Nurbs, second: Nurbs) -> tuple[NamedNumbers, ...]:
    """How each end of a curve meets each end of another curve.

    >>> from exactspline import Nurbs
    >>> lines = [Nurbs(1, [0, 0, 1, 1], points) for points in ([(0, 0), (1, 0)], [(1, 0), (3, 0)])]
    >>> nearest = junctions(*lines)[0]
    >>> nearest, nearest.facts
    (<ends: first 1, second 0, gap 0, angle 0, curvature jump 0>, {'geometric': 3, 'parametric': 0})
    """
    return tuple(pair.described for pair in _pairs_of_ends(first, second))


def junctions_within(first: Nurbs, second: Nurbs, epsilon: mpq) -> tuple[NamedNumbers, ...]:
    """The order to which the ends of two curves meet, up to differences of at most ε.

    >>> from exactspline import Nurbs
    >>> lines = [Nurbs(1, [0, 0, 1, 1], points) for points in ([(0, 0), (1, 0)], [(1, "1/9"), (3, 0)])]
    >>> [junctions_within(*lines, mpq(1, n))[0].facts["geometric"] for n in (2, 9, 10)]
    [2, 2, -1]

    Raises `ShapeError` for a number that is not positive.
    """
    if epsilon <= 0:
        raise ShapeError(f"within {text(epsilon)}", remedy="give a positive number, such as 1/1000")
    pairs = _pairs_of_ends(first, second)
    return tuple(NamedNumbers("ends", pair.named, {"geometric": pair.order_within(epsilon)}) for pair in pairs)
