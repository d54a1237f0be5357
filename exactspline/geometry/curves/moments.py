"""The area and the moments inside a closed polynomial plane curve, which are rational numbers."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

from exactspline.errors import ShapeError
from exactspline.geometry.curves.facts import Facts
from exactspline.geometry.curves.kinds import JointKind
from exactspline.numbers.exact import mpq
from exactspline.questions.answers import NamedNumbers
from exactspline.questions.takes import QuestionError
from exactspline.reals.real import Real
from exactspline.splines.bspline import BSpline


def moment(facts: Facts, i: int, j: int) -> mpq:
    """``∬ xⁱ yʲ = ∮ xⁱ⁺¹ yʲ dy / (i + 1)``, by Green's theorem.

    Raises `ShapeError` for a curve that is not closed, polynomial and in the plane, and for one with a gap.
    """
    _check_closed(facts)
    x, y = facts.curve.p
    integrand = y.d()
    for factor in (*[x] * (i + 1), *[y] * j):
        integrand = integrand * factor
    return _integral(integrand) / (i + 1)


def named_moments(moment_of: Callable[[int, int], mpq], order: int) -> tuple[NamedNumbers, ...]:
    """The moments with i + j up to an order; raises `QuestionError` for an order above 8."""
    if order > 8:
        raise QuestionError(f"moments of the order {order}", remedy="at most 8")
    pairs = [(i, total - i) for total in range(order + 1) for i in range(total, -1, -1)]
    return tuple(NamedNumbers("moment", {"moment": Real(moment_of(i, j))}, {"x": i, "y": j}) for i, j in pairs)


def _check_closed(facts: Facts) -> None:
    curve = facts.curve
    if curve.dimension != 2 or not curve.polynomial or not curve.closed:
        raise ShapeError(
            "the area of a curve that is not closed, polynomial and in the plane",
            where=curve.name,
            remedy="the area of a rational curve is not a rational number in general",
        )
    if any(joint.kind is JointKind.GAP for joint in facts.joints):
        raise ShapeError("the area of a curve with a gap", where=curve.name, remedy="close the gap")


def _integral(f: BSpline) -> mpq:
    """Over the whole domain: on a segment the mean of the Bézier points times the width."""
    widths = [b - a for a, b in pairwise(f.breakpoints)]
    means = [sum(points, start=mpq(0)) / len(points) if points else mpq(0) for points in f.bezier_points]
    return sum((w * m for w, m in zip(widths, means, strict=True)), start=mpq(0))
