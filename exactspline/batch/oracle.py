"""The exact oracle: questions about a curve, answered exactly, in certified intervals and as correctly rounded doubles.

A question is text: a name, an argument after a colon, parameters after an @. ``value@1/2``, ``derivative:2@0,1/3``,
``value@cusps``, ``elevate:2``, ``cusps``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from typing import Any, TypeAlias

from exactspline.batch.lines import EVERYWHERE
from exactspline.batch.oracle_answers import Answer, Item, Question, QuestionError, parts_of
from exactspline.errors import DomainError, ShapeError
from exactspline.geometry.analysis.curves import QUESTIONS as QUESTIONS_ABOUT_CURVES
from exactspline.geometry.analysis.curves import analyse, questions_about
from exactspline.geometry.analysis.pairs import CurvePair
from exactspline.geometry.curves import balls
from exactspline.geometry.curves import values as values_along
from exactspline.geometry.curves.extent import coordinate_range, slope_zeros
from exactspline.geometry.curves.joints import Joint
from exactspline.geometry.curves.kinds import Feature, JointKind
from exactspline.geometry.curves.planarity import Plane
from exactspline.geometry.curves.values import point_at, unit
from exactspline.geometry.derived.derive import derive
from exactspline.geometry.pairs.distance import Distance
from exactspline.geometry.pairs.intersections import Intersections
from exactspline.geometry.pairs.nearest import Nearest, NearestPoint
from exactspline.interchange.files import read
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector, cross
from exactspline.numbers.exact import mpq, text
from exactspline.questions.answers import Described
from exactspline.questions.entry import Entry, questions_of
from exactspline.reals.real import Real, real
from exactspline.roots.answers import CurvePiece, Places
from exactspline.roots.values import exact_place
from exactspline.splines.bspline import BSpline
from exactspline.splines.common import with_common_knots
from exactspline.splines.control_points import Direction
from exactspline.splines.nurbs import Nurbs, changed
from exactspline.splines.type_checks import curve_of

#: The largest number of segments times the square of the degree that `elevate` computes (a few seconds).
MOST_ELEVATED = 1_000_000
#: The questions whose argument may be left out.
DEFAULT = ("derivative", "insert", "remove", "elevate", "moments")
#: Items and certificates.
Found: TypeAlias = tuple[Iterable[Item], Iterable[dict[str, object]]]
#: Numbers by their names.
Values: TypeAlias = dict[str, Real]


def question_of(asked: str) -> Question:
    """The question that a text describes; raises `QuestionError` as `parts_of` does.

    >>> question_of("derivative:2@0,1/3")
    Question(text='derivative:2@0,1/3', name='derivative', argument='2', places=('0', '1/3'))
    """
    name, argument, place = parts_of(asked, {name: kind.asked for name, kind in QUESTIONS.items()}, DEFAULT)
    return Question(asked.strip(), name, argument, tuple(place.split(",")) if place else ())


def oracle(curve: Nurbs, asked: str) -> Answer:
    """The answer to a question about a curve.

    >>> from exactspline import example
    >>> [item] = oracle(example("cusp"), "cusps").items
    >>> item.what, item.values["parameter"].exact, item.values["parameter"].double()
    ('cusp', mpq(1,2), 0.5)
    >>> oracle(example("circle"), "length").items[0].values["length"].double("up")
    6.283185307179587

    Raises `QuestionError` for an unknown question, and another `ExactSplineError` where the question has no answer for
    the curve.
    """
    items, certificates = _found(curve, asked)
    return Answer(asked.strip(), tuple(items), tuple(certificates))


def items(curve: Nurbs, asked: str) -> tuple[Item, ...]:
    """The items of the answer to a question, without the certificates on which it relies.

    >>> from exactspline import example
    >>> [item.what for item in items(example("cusp"), "cusps")]
    ['cusp']
    """
    return tuple(_found(curve, asked)[0])


def _found(curve: Nurbs, asked: str) -> Found:
    question = question_of(asked)
    return QUESTIONS[question.name].answer(curve_of(curve), question)


def _axes(curve: Nurbs) -> list[str]:
    """The names of the coordinates.

    >>> from exactspline import example
    >>> _axes(example("circle"))
    ['x', 'y']
    """
    n = curve.dimension
    return list("xyz"[:n]) if n <= 3 else [f"x{i}" for i in range(1, n + 1)]


# ---- values at parameters


def _coordinates(curve: Nurbs, t: mpq | Real, order: int = 0) -> Values:
    return dict(zip(_axes(curve), point_at(curve, t, order), strict=True))


def _frame(curve: Nurbs, t: mpq | Real) -> Values:
    """The Frenet frame: N is to the left of a plane curve, towards the centre of curvature in space."""
    facts = analyse(curve)
    tangent = facts.velocity
    if not facts.in_space:
        vectors = {"T": tangent, "N": Vector(-tangent[1], tangent[0])}
    else:
        vectors = {"T": tangent, "N": Vector(*cross(facts.binormal, tangent)), "B": facts.binormal}
    return {
        f"{name}{axis}": x
        for name, vector in vectors.items()
        for axis, x in zip(_axes(curve), unit(vector, t, name), strict=True)
    }


def _at(what: str, values: Callable[[Nurbs, mpq | Real], Values], curve: Nurbs, question: Question) -> Found:
    """One item per parameter."""
    return [Item(what, {"parameter": real(t)} | values(curve, t)) for t in question.parameters(curve)], ()


def _derivative(curve: Nurbs, question: Question) -> Found:
    return _at("derivative", partial(_coordinates, order=question.number(1)), curve, question)


# ---- other control points, products, evolutes


def _control_points(curve: Nurbs, part: str = "") -> list[Item]:
    """The knots of a curve, and its control points with their weights."""
    facts = {"part": part} if part else {}
    items = [Item("curve", {}, facts | {"knots": [text(t) for t in curve.knots], "degree": curve.degree})]
    for point, weight in zip(curve.control_points, curve.weights, strict=True):
        values = dict(zip(_axes(curve), map(Real, point), strict=True)) | {"weight": Real(weight)}
        items.append(Item("direction" if isinstance(point, Direction) else "control point", values, facts))
    return items


def _inserted(curve: Nurbs, question: Question) -> Found:
    return _control_points(curve.insert_knot(question.single(curve), question.number(1))), ()


def _removed(curve: Nurbs, question: Question) -> Found:
    """A knot removed; `ReductionError` where that changes the function."""
    t, times = question.single(curve), question.number(1)
    return _control_points(changed(curve, lambda f: f.remove_knot(t, times))), ()


def _elevated(curve: Nurbs, question: Question) -> Found:
    times = question.number(1)
    if curve.segments * (curve.degree + times) ** 2 > MOST_ELEVATED:
        raise QuestionError(f"the degree raised by {times}", remedy="ask for less, or for parts of the curve")
    return _control_points(curve.elevate_degree(times)), ()


def _split(curve: Nurbs, question: Question) -> Found:
    before, behind = curve.split(question.single(curve))
    return [*_control_points(before, "before"), *_control_points(behind, "behind")], ()


def _product(curve: Nurbs, question: Question) -> Found:
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


def _evolute(curve: Nurbs, question: Question) -> Found:
    """The evolute, piece by piece; homogeneous control points ``(w x, w y, w)``; where it is missing, and its poles."""
    derived, items = derive("evolute", curve), list[Item]()
    for piece in derived.pieces:
        top, bottom = piece.value.elevated() if isinstance(piece.value, Rational) else (piece.value, None)
        first, *points = _net(list(top), bottom, _axes(curve))
        items += [Item(first.what, {}, {**first.facts, "interval": [text(t) for t in piece.interval]}), *points]
    gaps = [Item("missing", {}, {"interval": [text(a), text(b)], "reason": why}) for (a, b), why in derived.missing]
    return [*items, *gaps, *(Item("pole", {"parameter": pole}) for pole in derived.poles)], ()


# ---- extent, area, length


def _bounding_box(curve: Nurbs, question: Question) -> Found:
    ranges = [coordinate_range(curve, i) for i in range(curve.dimension)]
    items = [Item(axis, {"low": low, "high": high}) for axis, (low, high) in zip(_axes(curve), ranges, strict=True)]
    return items, (slope_zeros(curve, i).certificate() for i in range(curve.dimension))


def _area(curve: Nurbs, question: Question) -> Found:
    """The signed area: positive where the curve runs counter-clockwise."""
    return [Item("area", {"area": Real(_moment(_closed(curve), 0, 0))})], ()


def _moments(curve: Nurbs, question: Question) -> Found:
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


# ---- questions of the registry


def _of_registry(entry: Entry, curve: Nurbs, question: Question) -> Found:
    """The answer to a question of the registry about a curve."""
    if entry.name not in questions_about(curve):
        raise QuestionError(
            f"{entry.name} of a curve in R{curve.dimension}", remedy=f"it applies to a {' or a '.join(entry.about.of)}"
        )
    facts = analyse(curve)
    items = list(_items(curve, entry.answer(facts, question.argument)))
    given = (question.argument,) if entry.about.argument else ()
    return items, (proof(facts, *given).certificate() for proof in (entry.about.proof,) if proof)


def _items(curve: Nurbs, answer: Any) -> Iterator[Item]:
    if isinstance(answer, Intersections):
        yield from _meetings(answer)
        return
    if isinstance(answer, Distance):
        yield from _closest(answer)
        return
    for each in () if answer is None else answer if isinstance(answer, (tuple, Places, Nearest)) else (answer,):
        yield _item(curve, each)
    if isinstance(answer, (Places, Nearest)):
        for piece in answer.everywhere:
            yield _piece(EVERYWHERE, piece)


def _item(
    curve: Nurbs, each: Feature | NearestPoint | int | Joint | CurvePiece | Described | Plane | tuple[CurvePiece, Plane]
) -> Item:
    if isinstance(each, Feature):
        # an extremum of the curvature is also one of its critical points
        return analyse(curve).once(("item", each), lambda: _point(curve, each))
    if isinstance(each, NearestPoint):
        coordinates = _coordinates(curve, each.parameter)
        return Item("nearest point", {"parameter": each.parameter, "distance": each.distance} | coordinates)
    if isinstance(each, int):
        return Item("value", {"value": real(each)})
    if isinstance(each, Joint):
        return _joint(each)
    if isinstance(each, CurvePiece):
        return _piece("piece", each)
    if isinstance(each, Described):
        return _described(each)
    piece, plane = each if isinstance(each, tuple) else (None, each)
    ends = {} if piece is None else _piece("", piece).values
    return Item("planar piece" if piece else "plane", ends, {"plane": str(plane)})


def _of_two_curves(entry: Entry, curve: Nurbs, question: Question) -> Found:
    """The answer to a question of the registry about this curve and another one, whose argument stands behind the
    last comma.
    """
    other, _, argument = question.argument.rpartition(",") if entry.about.argument else (question.argument, "", "")
    if not other:
        raise QuestionError(f"{question.text!r} is incomplete", remedy=f"write it like {QUESTIONS[entry.name].asked!r}")
    return pair_items(CurvePair(curve, read(other).curve), entry.name, argument), ()


def pair_items(pair: CurvePair, name: str, argument: str = "") -> list[Item]:
    """The answer to a question of the registry about two curves, as items of an answer.

    >>> from exactspline import example
    >>> pair_items(CurvePair(example("circle"), example("ellipse")), "distance")[0].values["distance"].exact
    mpq(0,1)
    """
    return list(_items(pair.curves[0], questions_of(CurvePair)[name].answer(pair, argument)))


def _check_decided(left_out: Iterable[str]) -> None:
    if left_out:
        raise QuestionError(f"not decided: {'; '.join(left_out)}", remedy="ask for the segments one by one")


def _closest(found: Distance) -> Iterator[Item]:
    _check_decided(found.left_out)
    for pair in found.pairs:
        yield Item("pair", {"parameter": pair.first, "other parameter": pair.second, "distance": found.value})


def _meetings(found: Intersections) -> Iterator[Item]:
    _check_decided(found.left_out)
    for point in found:
        values = {"parameter": point.first, "other parameter": point.second}
        coordinates = {name: real(x) for name, x in zip("xyz", point.point, strict=False)}
        yield Item(str(point.kind), values | coordinates, {"multiplicity": point.multiplicity})
    for arc in found.everywhere:
        ends = zip(("start", "end", "other start", "other end"), (*arc.first, *arc.second), strict=True)
        yield Item(EVERYWHERE, dict(ends), {"reversed": arc.reversed})


def _point(curve: Nurbs, feature: Feature) -> Item:
    place = exact_place(feature.root)
    values = {"parameter": real(place)} | _coordinates(curve, place)
    with suppress(DomainError, ShapeError):
        values["curvature"] = values_along.curvature(curve, place)
    facts = {"at_knot": feature.at_knot, "by_jump": feature.by_jump, "multiplicity": feature.root.multiplicity}
    return Item(str(feature.kind), values, facts)


def _described(each: Described) -> Item:
    numbers = {
        name if len(values) == 1 else f"{name} {i + 1}": value
        for name, values in each.values.items()
        for i, value in enumerate(values)
    }
    return Item(str(each.kind), {**_piece("", each.piece).values, **numbers}, each.facts)


def _piece(what: str, piece: CurvePiece) -> Item:
    return Item(what, {"start": real(piece.start), "end": real(piece.end)}, {"across_seam": piece.across_seam})


def _joint(joint: Joint) -> Item:
    values = {"parameter": real(joint.parameter)}
    if joint.angle is not None:
        values |= {"degrees": balls.degrees(joint.angle), "cosine": joint.angle.cosine, "sine": joint.angle.sine}
    if joint.gap is not None:
        values["gap"] = joint.gap
    if joint.curvatures is not None:
        values |= dict(zip(("curvature_before", "curvature_behind"), joint.curvatures, strict=True))
    return Item(str(joint.kind), values, {"geometric_continuity": joint.order, "at_seam": joint.at_seam})


# ---- the table


@dataclass(frozen=True)
class Kind:
    """A kind of question: its syntax, its meaning, and the function that answers it."""

    asked: str
    meaning: str
    answer: Callable[[Nurbs, Question], Found]


def _kinds() -> Iterator[Kind]:
    yield Kind("value@T", "the point", partial(_at, "point", _coordinates))
    yield Kind("derivative:K@T", "the derivative of order K (by default 1)", _derivative)
    bent = partial(_at, "curvature", lambda curve, t: {"curvature": values_along.curvature(curve, t)})
    yield Kind("curvature@T", "the curvature: signed in the plane, not negative in space", bent)
    twisted = partial(_at, "torsion", lambda curve, t: {"torsion": values_along.torsion(curve, t)})
    yield Kind("torsion@T", "the torsion of a space curve", twisted)
    yield Kind("frame@T", "unit tangent and normal, in space also the binormal", partial(_at, "frame", _frame))
    yield Kind("insert:M@T", "the control points with the knot T inserted M times (by default once)", _inserted)
    yield Kind("remove:M@T", "the control points with the knot T removed M times", _removed)
    yield Kind("elevate:K", "the control points with the degree raised by K (by default 1)", _elevated)
    yield Kind("split@T", "the control points of the parts before and after T", _split)
    yield Kind("product:IJ", "the control points of the product of the coordinates I and J (0 is x)", _product)
    yield Kind("evolute", "the control points of the evolute, piece by piece, and its poles", _evolute)
    for entry in QUESTIONS_ABOUT_CURVES.values():
        yield Kind(entry.form, entry.meaning, partial(_of_registry, entry))
    for name, entry in questions_of(CurvePair).items():
        behind = f",{entry.about.argument}" if entry.about.argument else ""
        yield Kind(f"{name}:CURVE{behind}", entry.meaning, partial(_of_two_curves, entry))
    yield Kind("bounding_box", "the smallest and largest value of every coordinate", _bounding_box)
    yield Kind("area", "the signed area inside a closed polynomial plane curve", _area)
    yield Kind("moments:K", "its moments ∬ xⁱ yʲ with i + j ≤ K (by default 2)", _moments)
    yield Kind("length", "the arc length", lambda c, _: ([Item("length", {"length": balls.length(c)})], ()))


#: The kinds by their names.
QUESTIONS: dict[str, Kind] = {kind.asked.partition("@")[0].partition(":")[0]: kind for kind in _kinds()}
