"""Shapes for the oracle: other control points, products, evolutes, area and moments, arc length."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise

from exactspline.batch.oracle_answers import Item, Question, QuestionError
from exactspline.batch.oracle_values import axes
from exactspline.errors import ShapeError
from exactspline.geometry import balls
from exactspline.geometry.analysis import analyse
from exactspline.geometry.derived import derive
from exactspline.geometry.kinds import JointKind
from exactspline.language.rational import Rational
from exactspline.numbers.exact import mpq, text
from exactspline.reals.real import Real
from exactspline.splines.bspline import BSpline
from exactspline.splines.common import with_common_knots
from exactspline.splines.control_points import Direction
from exactspline.splines.nurbs import Nurbs, changed

#: The largest number of segments times the square of the degree that `elevate` computes (a few seconds).
MOST_ELEVATED = 1_000_000
Found = tuple[Iterable[Item], Iterable[dict[str, object]]]


def control_points(curve: Nurbs, part: str = "") -> list[Item]:
    """The knots of a curve, and its control points with their weights."""
    facts = {"part": part} if part else {}
    knots = {"knots": [text(t) for t in curve.knots], "degree": curve.degree}
    items = [Item("curve", {}, facts | knots)]
    for point, weight in zip(curve.control_points, curve.weights, strict=True):
        values = dict(zip(axes(curve), map(Real, point), strict=True)) | {"weight": Real(weight)}
        items.append(Item("direction" if isinstance(point, Direction) else "control point", values, facts))
    return items


def insert(curve: Nurbs, question: Question) -> Found:
    """A knot inserted."""
    return control_points(curve.insert_knot(question.single(curve), question.number(1))), ()


def remove(curve: Nurbs, question: Question) -> Found:
    """A knot removed; `ReductionError` where that changes the function."""
    t, times = question.single(curve), question.number(1)
    return control_points(changed(curve, lambda f: f.remove_knot(t, times))), ()


def elevate(curve: Nurbs, question: Question) -> Found:
    """The degree raised."""
    times = question.number(1)
    if curve.segments * (curve.degree + times) ** 2 > MOST_ELEVATED:
        raise QuestionError(f"the degree raised by {times}", remedy="ask for less, or for parts of the curve")
    return control_points(curve.elevate_degree(times)), ()


def split(curve: Nurbs, question: Question) -> Found:
    """Both parts."""
    before, behind = curve.split(question.single(curve))
    return [*control_points(before, "before"), *control_points(behind, "behind")], ()


def product(curve: Nurbs, question: Question) -> Found:
    """The product of two coordinates."""
    given = question.argument
    if len(given) != 2 or not given.isascii() or not given.isdecimal() or max(map(int, given)) >= curve.dimension:
        raise QuestionError(
            f"{question.text!r} needs two coordinates of R{curve.dimension}", remedy="product:01 is x y"
        )
    product_form = curve.p[int(given[0])] * curve.p[int(given[1])]
    return _net([product_form], curve.w * curve.w if not curve.polynomial else None, ["product"]), ()


def _net(numerators: list[BSpline], denominator: BSpline | None, names: list[str]) -> list[Item]:
    """The control points of functions with one denominator, homogeneous where there is one."""
    splines = with_common_knots([*numerators, *([] if denominator is None else [denominator])])
    facts = {"knots": [text(t) for t in splines[0].knots], "degree": splines[0].degree}
    names = names if denominator is None else [*(f"w*{name}" for name in names), "w"]
    rows = zip(*[f.control_points for f in splines], strict=True)
    points = [Item("control point", dict(zip(names, map(Real, row), strict=True))) for row in rows]
    return [Item("curve", {}, facts), *points]


def evolute(curve: Nurbs, question: Question) -> Found:
    """The evolute, piece by piece; homogeneous control points ``(w x, w y, w)``."""
    derived, items = derive("evolute", curve), list[Item]()
    for piece in derived.pieces:
        top, bottom = piece.value.elevated() if isinstance(piece.value, Rational) else (piece.value, None)
        first, *points = _net(list(top), bottom, axes(curve))
        items += [Item(first.what, {}, {**first.facts, "interval": [text(t) for t in piece.interval]}), *points]
    gaps = [Item("missing", {}, {"interval": [text(a), text(b)], "reason": why}) for (a, b), why in derived.missing]
    return [*items, *gaps], ()


def area(curve: Nurbs, question: Question) -> Found:
    """The signed area: positive where the curve runs counter-clockwise."""
    return [Item("area", {"area": Real(_moment(_closed(curve), 0, 0))})], ()


def moments(curve: Nurbs, question: Question) -> Found:
    """∬ xⁱ yʲ for all i + j up to an order."""
    order, c = question.number(2), _closed(curve)
    if order > 8:
        raise QuestionError(f"moments of the order {order}", remedy="at most 8")
    pairs = [(i, total - i) for total in range(order + 1) for i in range(total, -1, -1)]
    return [Item("moment", {"moment": Real(_moment(c, i, j))}, {"x": i, "y": j}) for i, j in pairs], ()


def _closed(curve: Nurbs) -> Nurbs:
    if curve.dimension != 2 or not curve.polynomial or not curve.closed:
        raise ShapeError(
            "the area of a curve that is not closed, polynomial and in the plane",
            remedy="the area of a rational curve is not a rational number in general",
        )
    if any(joint.kind is JointKind.GAP for joint in analyse(curve).joints):
        raise ShapeError("the area of a curve with a gap", remedy="close the gap")
    return curve


def _moment(curve: Nurbs, i: int, j: int) -> mpq:
    """``∮ xⁱ⁺¹ yʲ dy / (i + 1)``, by Green's theorem."""
    x, y = curve.p
    integrand = y.d()
    for factor in (*[x] * (i + 1), *[y] * j):
        integrand = integrand * factor
    return _integral(integrand) / (i + 1)


def _integral(f: BSpline) -> mpq:
    """Over the whole domain: on a segment the mean of the Bézier points times the width."""
    widths = [b - a for a, b in pairwise(f.breakpoints)]
    means = [sum(points, start=mpq(0)) / len(points) if points else mpq(0) for points in f.segments]
    return sum((w * m for w, m in zip(widths, means, strict=True)), start=mpq(0))


def length(curve: Nurbs, question: Question) -> Found:
    """The arc length."""
    return [Item("length", {"length": balls.length(curve)})], ()
