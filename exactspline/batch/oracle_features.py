"""The questions of the registry, asked of the oracle; and the bounding box of a curve."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from typing import Any

from exactspline.batch.lines import EVERYWHERE
from exactspline.batch.oracle_answers import Item, Question, QuestionError
from exactspline.batch.oracle_values import axes
from exactspline.errors import DomainError, ShapeError
from exactspline.geometry.analysis import analyse, questions_about
from exactspline.geometry.balls import degrees
from exactspline.geometry.extent import coordinate_range, slope_zeros
from exactspline.geometry.joints import Joint
from exactspline.geometry.kinds import Feature
from exactspline.geometry.planarity import Plane
from exactspline.geometry.recognition.pieces import RecognizedPiece
from exactspline.geometry.values_along import curvature, point_at
from exactspline.questions.answers import CurvePiece, Places
from exactspline.questions.entry import Entry
from exactspline.reals.real import real
from exactspline.roots.values import exact_place
from exactspline.splines.nurbs import Nurbs

Found = tuple[Iterable[Item], Iterable[dict[str, object]]]


def _point(curve: Nurbs, feature: Feature) -> Item:
    place = exact_place(feature.root)
    values = {"parameter": real(place)} | dict(zip(axes(curve), point_at(curve, place), strict=True))
    with suppress(DomainError, ShapeError):
        values["curvature"] = curvature(curve, place)
    facts = {"at_knot": feature.at_knot, "by_jump": feature.by_jump, "multiplicity": feature.root.multiplicity}
    return Item(str(feature.kind), values, facts)


def answered(entry: Entry, curve: Nurbs, question: Question) -> Found:
    """The answer to a question of the registry about a curve; raises `ShapeError` where the question does not apply to
    the curve.
    """
    if entry.name not in questions_about(curve):
        raise QuestionError(
            f"{entry.name} of a curve in R{curve.dimension}", remedy=f"it applies to a {' or a '.join(entry.about.of)}"
        )
    facts = analyse(curve)
    items = list(_items(curve, entry.answer(facts, question.argument)))
    given = (question.argument,) if entry.about.argument else ()
    return items, (entry.about.proof(facts, *given).certificate(),) if entry.about.proof else ()


def _items(curve: Nurbs, answer: Any) -> Iterator[Item]:
    for each in () if answer is None else answer if isinstance(answer, (tuple, Places)) else (answer,):
        yield _item(curve, each)
    if isinstance(answer, Places):
        for piece in answer.everywhere:
            yield _piece(EVERYWHERE, piece)


def _shape(found: RecognizedPiece) -> Item:
    ends = {**_piece("", found.piece).values, "within": real(found.within)}
    numbers = {
        name if len(values) == 1 else f"{name} {i + 1}": value
        for name, values in found.shape.numbers.items()
        for i, value in enumerate(values)
    }
    return Item(str(found.shape.kind), ends | numbers, {"whole": found.whole})


def _item(
    curve: Nurbs, each: Feature | Joint | CurvePiece | RecognizedPiece | Plane | tuple[CurvePiece, Plane]
) -> Item:
    if isinstance(each, Feature):
        return _point(curve, each)
    if isinstance(each, Joint):
        return _joint(each)
    if isinstance(each, CurvePiece):
        return _piece("piece", each)
    if isinstance(each, RecognizedPiece):
        return _shape(each)
    piece, plane = each if isinstance(each, tuple) else (None, each)
    ends = {} if piece is None else _piece("", piece).values
    return Item("planar piece" if piece else "plane", ends, {"plane": str(plane)})


def _piece(what: str, piece: CurvePiece) -> Item:
    values = {"start": real(piece.start), "end": real(piece.end)}
    return Item(what, values, {"across_seam": piece.across_seam})


def _joint(joint: Joint) -> Item:
    values = {"parameter": real(joint.parameter)}
    if joint.angle is not None:
        values |= {"degrees": degrees(joint.angle)}
        values |= {"cosine": joint.angle.cosine, "sine": joint.angle.sine}
    if joint.gap is not None:
        values["gap"] = joint.gap
    if joint.curvatures is not None:
        values |= dict(zip(("curvature_before", "curvature_behind"), joint.curvatures, strict=True))
    return Item(str(joint.kind), values, {"geometric_continuity": joint.order, "at_seam": joint.at_seam})


def bounding_box(curve: Nurbs, question: Question) -> Found:
    """The smallest and largest value of every coordinate."""
    items = [
        Item(axis, dict(zip(("low", "high"), coordinate_range(curve, i), strict=True)))
        for i, axis in enumerate(axes(curve))
    ]
    return items, [slope_zeros(curve, i).certificate() for i in range(curve.dimension)]
