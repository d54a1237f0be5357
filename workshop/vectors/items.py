"""Answers to the questions of the registry as the packs have them: items, each with its numbers by name.

A question is text: a name, an argument after a colon, parameters after an @. ``value@1/2``, ``derivative:2@0,1/3``,
``value@cusps``, ``elevate:2``, ``cusps``.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from typing import Any

from exactspline.batch.lines import EVERYWHERE
from exactspline.errors import DomainError, ShapeError
from exactspline.geometry.analysis.ask import Asked, asked_of
from exactspline.geometry.analysis.curve_values import axes, coordinates
from exactspline.geometry.analysis.curves import analyse
from exactspline.geometry.analysis.pairs import CurvePair
from exactspline.geometry.bisectors.common import Bisector
from exactspline.geometry.bisectors.plane_curves import PlaneBisector
from exactspline.geometry.curves import angles
from exactspline.geometry.curves import values as values_along
from exactspline.geometry.curves.joints import Joint
from exactspline.geometry.curves.kinds import Feature
from exactspline.geometry.curves.planarity import Plane, in_the_plane
from exactspline.geometry.derived.derive import Derived
from exactspline.geometry.pairs.distance import Distance
from exactspline.geometry.pairs.intersections import Intersections
from exactspline.geometry.pairs.nearest import Nearest, NearestPoint
from exactspline.language.rational import Rational
from exactspline.numbers.exact import text
from exactspline.questions.answers import Described, NamedNumbers
from exactspline.questions.takes import QuestionError
from exactspline.reals.real import Real, real
from exactspline.roots.answers import CurvePiece, Places
from exactspline.roots.values import evaluate, exact_place
from exactspline.splines.bspline import BSpline
from exactspline.splines.common import with_common_knots
from exactspline.splines.control_points import Direction
from exactspline.splines.nurbs import Nurbs


def items(about: Nurbs | CurvePair, asked: str) -> tuple[NamedNumbers, ...]:
    """The items of the answer to a question about a curve or two, without the certificates on which it relies.

    >>> from exactspline import example
    >>> [item.what for item in items(example("cusp"), "cusps")]
    ['cusp']
    >>> items(CurvePair(example("circle"), example("ellipse")), "distance")[0].values["distance"].exact
    mpq(0,1)
    """
    return tuple(_items(_first(about), asked_of(about, asked)))


def _first(about: Nurbs | CurvePair) -> Nurbs:
    """The curve whose coordinates are shown: one in the plane z = 0 as a plane curve, without z."""
    return in_the_plane(about.curves[0] if isinstance(about, CurvePair) else about)


def _items(curve: Nurbs, asked: Asked) -> Iterator[NamedNumbers]:
    """The items of an answer."""
    answer: Any = asked.answer
    if isinstance(answer, Intersections | Distance):
        _check_decided(answer.undecided)
        yield from _meetings(answer) if isinstance(answer, Intersections) else _closest(answer)
        for arc in answer.everywhere:
            ends = zip(("start", "end", "other start", "other end"), (*arc.first, *arc.second), strict=True)
            yield NamedNumbers(EVERYWHERE, dict(ends), {"reversed": arc.reversed})
    elif isinstance(answer, Real):
        yield NamedNumbers(asked.entry.name, {asked.entry.name: answer})
    elif isinstance(answer, Bisector):
        open_parts = answer.missing if isinstance(answer, PlaneBisector) else getattr(answer, "undecided", ())
        _check_decided(map(str, open_parts))
        yield from answer.items
    elif isinstance(answer, Derived):
        yield from _derived(curve, answer)
    elif isinstance(answer, Nurbs):
        yield from _control_points(answer)
    elif isinstance(answer, BSpline | Rational):
        top, bottom = (answer.scalar, answer.denominator) if isinstance(answer, Rational) else (answer, None)
        yield from _net([top], bottom, [asked.entry.name])
    elif isinstance(answer, tuple) and answer and isinstance(answer[0], Nurbs):
        for part, name in zip(answer, ("before", "behind"), strict=True):
            yield from _control_points(part, name)
    elif answer is not None:
        for each in answer if isinstance(answer, (tuple, Places, Nearest)) else (answer,):
            yield each if isinstance(each, NamedNumbers) else _item(curve, each)
        if isinstance(answer, (Places, Nearest)):
            for piece in answer.everywhere:
                yield _piece(EVERYWHERE, piece)


# ---- control points


def _control_points(curve: Nurbs, part: str = "") -> Iterator[NamedNumbers]:
    """The knots of a curve, and its control points with their weights."""
    facts = {"part": part} if part else {}
    yield NamedNumbers("curve", {}, facts | {"knots": [text(t) for t in curve.knots], "degree": curve.degree})
    for point, weight in zip(curve.control_points, curve.weights, strict=True):
        values = dict(zip(axes(curve.dimension), map(Real, point), strict=True)) | {"weight": Real(weight)}
        yield NamedNumbers("direction" if isinstance(point, Direction) else "control point", values, facts)


def _net(numerators: list[BSpline], denominator: BSpline | None, names: list[str]) -> list[NamedNumbers]:
    """The control points of functions with one denominator, homogeneous where there is one."""
    splines = with_common_knots([*numerators, *([] if denominator is None else [denominator])])
    facts = {"knots": [text(t) for t in splines[0].knots], "degree": splines[0].degree}
    names = names if denominator is None else [*(f"w*{name}" for name in names), "w"]
    rows = zip(*[f.control_points for f in splines], strict=True)
    points = [NamedNumbers("control point", dict(zip(names, map(Real, row), strict=True))) for row in rows]
    return [NamedNumbers("curve", {}, facts), *points]


def _derived(curve: Nurbs, derived: Derived) -> Iterator[NamedNumbers]:
    """A derived curve piece by piece: homogeneous control points ``(w x, w y, w)``; where it is missing, its poles."""
    for piece in derived.pieces:
        top, bottom = piece.value.elevated() if isinstance(piece.value, Rational) else (piece.value, None)
        first, *points = _net(list(top), bottom, axes(curve.dimension))
        yield NamedNumbers(first.what, {}, {**first.facts, "interval": [text(t) for t in piece.interval]})
        yield from points
    for (a, b), why in derived.missing:
        yield NamedNumbers("missing", {}, {"interval": [text(a), text(b)], "reason": why})
    yield from (NamedNumbers("pole", {"parameter": pole}) for pole in derived.poles)


# ---- elements of answers


def _item(
    curve: Nurbs, each: Feature | NearestPoint | int | Joint | CurvePiece | Described | Plane | tuple[CurvePiece, Plane]
) -> NamedNumbers:
    if isinstance(each, Feature):
        # an extremum of the curvature is also one of its critical points
        return analyse(curve).once(("item", each), lambda: _point(curve, each))
    if isinstance(each, NearestPoint):
        place = dict(
            zip(axes(curve.dimension), map(real, evaluate(curve, each.parameter, side=each.side)), strict=True)
        )
        return NamedNumbers("nearest point", {"parameter": each.parameter, "distance": each.distance} | place)
    if isinstance(each, int):
        return NamedNumbers("value", {"value": real(each)})
    if isinstance(each, Joint):
        return _joint(each)
    if isinstance(each, CurvePiece):
        return _piece("piece", each)
    if isinstance(each, Described):
        return _described(each)
    piece, plane = each if isinstance(each, tuple) else (None, each)
    ends = {} if piece is None else _piece("", piece).values
    return NamedNumbers("planar piece" if piece else "plane", ends, {"plane": str(plane)})


def _check_decided(given: Iterable[str]) -> None:
    if left_out := list(given):
        raise QuestionError(f"not decided: {'; '.join(left_out)}", remedy="ask for the segments one by one")


def _closest(found: Distance) -> Iterator[NamedNumbers]:
    for pair in found.pairs:
        yield NamedNumbers("pair", {"parameter": pair.first, "other parameter": pair.second, "distance": found.value})


def _meetings(found: Intersections) -> Iterator[NamedNumbers]:
    for point in found:
        values = {"parameter": point.first, "other parameter": point.second}
        coordinates = {name: real(x) for name, x in zip("xyz", point.point, strict=False)}
        yield NamedNumbers(str(point.kind), values | coordinates, {"multiplicity": point.multiplicity})


def _point(curve: Nurbs, feature: Feature) -> NamedNumbers:
    place = exact_place(feature.root)
    values = {"parameter": real(place)} | coordinates(curve, place)
    with suppress(DomainError, ShapeError):
        values["curvature"] = values_along.curvature(curve, place)
    facts = {"at_knot": feature.at_knot, "by_jump": feature.by_jump, "multiplicity": feature.root.multiplicity}
    return NamedNumbers(str(feature.kind), values, facts)


def _described(each: Described) -> NamedNumbers:
    numbers = {
        name if len(values) == 1 else f"{name} {i + 1}": value
        for name, values in each.values.items()
        for i, value in enumerate(values)
    }
    return NamedNumbers(str(each.kind), {**_piece("", each.piece).values, **numbers}, each.facts)


def _piece(what: str, piece: CurvePiece) -> NamedNumbers:
    return NamedNumbers(what, {"start": real(piece.start), "end": real(piece.end)}, {"across_seam": piece.across_seam})


def _joint(joint: Joint) -> NamedNumbers:
    values = {"parameter": real(joint.parameter)}
    if joint.angle is not None:
        values |= {"degrees": angles.degrees(joint.angle), "cosine": joint.angle.cosine, "sine": joint.angle.sine}
    if joint.gap is not None:
        values["gap"] = joint.gap
    if joint.curvatures is not None:
        values |= dict(zip(("curvature_before", "curvature_behind"), joint.curvatures, strict=True))
    return NamedNumbers(str(joint.kind), values, {"geometric_continuity": joint.order, "at_seam": joint.at_seam})
