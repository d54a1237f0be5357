"""The area, the moments and the centroid inside a closed plane curve, by Green's theorem."""

from __future__ import annotations

from collections.abc import Callable

from exactspline.errors import DomainError, ShapeError
from exactspline.geometry.curves.facts import Facts
from exactspline.geometry.curves.kinds import JointKind
from exactspline.geometry.measures.integrals import Term, Terms, in_local_powers, integral, number
from exactspline.polynomials.factors import greatest_common_divisor
from exactspline.questions.answers import NamedNumbers
from exactspline.questions.takes import QuestionError
from exactspline.reals.ball import WithAngles
from exactspline.reals.real import Real


def moment(facts: Facts, i: int, j: int) -> Terms:
    """The terms of ``∬ xⁱ yʲ = ∮ xⁱ yʲ (x dy − y dx) / (i + j + 2)``.

    Raises `ShapeError` for a curve that is not closed and in the plane, and for one with a gap.
    """
    _check_closed(facts)
    n, terms = i + j + 2, list[Term]()
    for parts in zip(*map(in_local_powers, (*facts.curve.p, facts.curve.w)), strict=True):
        common = greatest_common_divisor(parts)
        x, y, w = (p // common for p in parts)
        terms += integral(x**i * y**j * (x * y.derivative() - y * x.derivative()) / n, w, n)
    return tuple(terms)


def named_moments(moment_of: Callable[[int, int], Terms], order: int) -> tuple[NamedNumbers, ...]:
    """The moments with i + j up to an order; raises `QuestionError` for an order above 8."""
    if order > 8:
        raise QuestionError(f"moments of the order {order}", remedy="at most 8")
    pairs = [(i, total - i) for total in range(order + 1) for i in range(total, -1, -1)]
    return tuple(NamedNumbers("moment", {"moment": number(moment_of(i, j))}, {"x": i, "y": j}) for i, j in pairs)


def centroid(moment_of: Callable[[int, int], Terms]) -> tuple[NamedNumbers, ...]:
    """The centroid by moments; raises `DomainError` for the area 0."""
    area, *first = (number(moment_of(*powers)) for powers in ((0, 0), (1, 0), (0, 1)))
    if area.sign == 0:
        raise DomainError("the centroid of the area 0", remedy="an area that is not 0 has one")
    return (NamedNumbers("centroid", {axis: _quotient(x, area) for axis, x in zip("xy", first, strict=True)}),)


def _quotient(top: Real, bottom: Real) -> Real:
    """The quotient, rational where both numbers are ``a + b π`` and one is a multiple of the other."""
    if isinstance(top, WithAngles) and isinstance(bottom, WithAngles) and not top.arcs and not bottom.arcs:
        ratio = top.of_pi / bottom.of_pi
        if top.constant == ratio * bottom.constant:
            return ratio
    return top / bottom


def _check_closed(facts: Facts) -> None:
    curve = facts.curve
    if curve.dimension != 2 or not curve.closed:
        raise ShapeError("the area of a curve that is not closed and in the plane", where=curve.name, remedy="close it")
    if any(joint.kind is JointKind.GAP for joint in facts.joints):
        raise ShapeError("the area of a curve with a gap", where=curve.name, remedy="close the gap")
