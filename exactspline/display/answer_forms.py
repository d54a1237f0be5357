"""The form of the answer to each question, by the type that it promises."""

from __future__ import annotations

from enum import StrEnum
from types import NoneType
from typing import Any, get_args, get_type_hints

from exactspline.bivariate.answers import SurfacePlaces
from exactspline.display import bisector_data, surface_data
from exactspline.display.bisector_data import FORMS_OF_POINT, MISSING, PAIRS, PARAMETER, SIDES_MISSING
from exactspline.display.forms import (
    FLAG,
    INTEGER,
    INTERVAL,
    TEXT,
    Form,
    Schema,
    list_of,
    one_of,
    or_null,
    pair_of,
    record,
)
from exactspline.display.pair_data import DISTANCE, INTERSECTIONS
from exactspline.display.reals import REAL
from exactspline.display.serialize import FEATURE, INTERVALS, JOINT, NUMBERS, PLANAR_PIECE
from exactspline.display.surface_data import places_on_surface
from exactspline.geometry.analysis.registry import REGISTRY
from exactspline.geometry.curves.joints import Joint
from exactspline.geometry.curves.kinds import Feature, FeatureKind
from exactspline.geometry.curves.planarity import Plane
from exactspline.geometry.pairs.distance import Distance
from exactspline.geometry.pairs.intersections import IntersectionKind, Intersections
from exactspline.geometry.recognition.pieces import RecognizedPiece
from exactspline.geometry.recognition.shapes import ShapeKind
from exactspline.geometry.rounded.features import NearbyFeature
from exactspline.geometry.rounded.intersections import NearbyMeeting
from exactspline.geometry.rounded.stability import StableFeature
from exactspline.geometry.rounded.umbilics import NearbyUmbilic
from exactspline.numbers.exact import mpq
from exactspline.questions.entry import Answered, Entry, Of, Question, QuestionWith
from exactspline.roots.answers import CurvePiece, Places

TEXTS = list_of(TEXT)


def _described(kinds: type[StrEnum], *facts: str) -> Form:
    return record(kind=one_of(kinds), intervals=INTERVALS, numbers=NUMBERS, **dict.fromkeys(facts, FLAG))


def _any_of(*forms: Form) -> Form:
    return Form({"anyOf": [form.schema for form in forms]})


#: The form of an answer, or of one of its elements, by its type.
FORMS: dict[Any, Form] = {
    **surface_data.FORMS,
    **bisector_data.FORMS,
    mpq: TEXT,
    Plane: TEXT,
    Feature: FEATURE,
    Joint: JOINT,
    CurvePiece: INTERVALS,
    tuple[CurvePiece, Plane]: PLANAR_PIECE,
    RecognizedPiece: _described(ShapeKind, "whole"),
    NearbyFeature: _described(FeatureKind, "certain", "single"),
    NearbyMeeting: _described(IntersectionKind, "certain"),
    StableFeature: _described(FeatureKind),
    Intersections: INTERSECTIONS,
    Distance: DISTANCE,
}
#: What `inspect`, `between` and `bisector` have beside answers.
FORMS_BESIDE: dict[str, dict[str, Form]] = {
    "bisector": {
        "curves": TEXTS,
        "point": TEXTS,
        "left_out": TEXTS,
        "singular": list_of(PARAMETER),
        "missing": list_of(_any_of(TEXT, MISSING, SIDES_MISSING)),
        "pieces": list_of(_any_of(*FORMS_OF_POINT.values(), PAIRS)),
        **dict.fromkeys(("true_feet", "undecided"), list_of(pair_of(INTERVAL))),
    },
    "between": {"meetings": list_of(FORMS[NearbyMeeting])},
    "inspect surface": {"umbilics_within": list_of(FORMS[NearbyUmbilic])},
    "inspect": {
        "coordinate_extrema": list_of(FEATURE),
        "nearby": list_of(FORMS[NearbyFeature]),
        "meetings": list_of(FORMS[NearbyMeeting]),
        "stability": list_of(record(FORMS[StableFeature], prominence=or_null(REAL))),
        "approaches": list_of(
            record(
                name=TEXT,
                **dict.fromkeys(("degree", "control_points", "roots", "extraneous", "missing"), INTEGER),
                seconds=Form({"type": "number"}),
            )
        ),
    },
}


def values_form() -> Schema:
    """The form of numbers by name, as the oracle has them: exactly, between two bounds, and as a double."""
    return record(values=Form({"type": "object", "additionalProperties": REAL.schema})).schema


def answer_form(entry: Entry) -> Schema:
    """The form of the answer to a question, by the type that the question promises.

    >>> from exactspline.geometry.analysis.curves import QUESTIONS
    >>> answer_form(QUESTIONS["inflections"])["properties"]["points"]["items"]["properties"]["kind"]["enum"][:2]
    ['cusp', 'stop']
    """
    assert isinstance(entry, Question | QuestionWith)
    promised = get_type_hints(entry.compute).get("return")
    return {} if promised is None else _form(promised).schema


def _form(kind: Any) -> Form:
    if kind in FORMS:
        return FORMS[kind]
    parts, origin = get_args(kind), getattr(kind, "__origin__", None)
    if NoneType in parts:
        return or_null(_form(next(part for part in parts if part is not NoneType)))
    if origin is Places:
        return record(points=list_of(_form(parts[0])), everywhere=list_of(INTERVALS))
    if origin is SurfacePlaces:
        return places_on_surface(_form(parts[0]))
    return one_of(kind) if isinstance(kind, type) and issubclass(kind, StrEnum) else list_of(_form(parts[0]))


def surface_answer_forms() -> dict[str, Schema]:
    """The forms of the answers to the questions about surfaces and maps of the plane, by their names."""
    entries = {name: entry for of in (Of.SURFACE, Of.PLANAR_MAP) for name, entry in REGISTRY[of].items()}
    return {name: answer_form(x) for name, x in entries.items() if x.about.answered is not Answered.NUMBERS}
