"""The form of the answer to each question, as JSON Schema: what `serialize`, `surface_data`, `pair_data` and
`bisector_data` write.
"""

from __future__ import annotations

from enum import Enum, StrEnum
from types import NoneType
from typing import Any, cast, get_args, get_type_hints

from exactspline.geometry.bisector.components import (
    Cause,
    Correspondence,
    LineComponent,
    PlaneComponent,
    PoleCurve,
    SinglePair,
    Solutions,
)
from exactspline.geometry.bisector.trimmed import PieceKind
from exactspline.geometry.bisector.two_curves import BisectorPatch
from exactspline.geometry.distance import Distance
from exactspline.geometry.intersections import IntersectionKind, Intersections
from exactspline.geometry.joints import Joint
from exactspline.geometry.kinds import Feature, FeatureKind, JointKind
from exactspline.geometry.meetings_nearby import NearbyMeeting
from exactspline.geometry.nearby import NearbyFeature
from exactspline.geometry.planarity import Plane
from exactspline.geometry.recognition.pieces import RecognizedPiece
from exactspline.geometry.recognition.shapes import ShapeKind
from exactspline.geometry.registry import REGISTRY
from exactspline.geometry.stability import StableFeature
from exactspline.geometry.surface.chains import ZeroComponent
from exactspline.geometry.surface.degenerate import Gap, Pole
from exactspline.geometry.surface.inspection import PatchInspection, PatchKind
from exactspline.geometry.surface.joints import SurfaceJoint, SurfaceJointKind
from exactspline.geometry.surface.places import Place
from exactspline.geometry.surface.recognized import RecognizedPart
from exactspline.geometry.surface.ridges import Ridges
from exactspline.geometry.surface.umbilics import Umbilic, UmbilicKind
from exactspline.geometry.surface.umbilics_nearby import NearbyUmbilic
from exactspline.geometry.surface.zero_curve import Shape
from exactspline.geometry.surface.zero_lines import ZeroLine
from exactspline.numbers.exact import mpq
from exactspline.questions.answers import CurvePiece, Places, SurfacePlaces
from exactspline.questions.entry import Entry, Of, Question, QuestionWith
from exactspline.splines.surface import Along

Form = dict[str, object]
TEXT: Form = {"type": "string"}
FLAG: Form = {"type": "boolean"}
INTEGER: Form = {"type": "integer"}


def list_of(form: Form, least: int = 0, most: int | None = None) -> Form:
    """The form of a list."""
    return {"type": "array", "items": form, "minItems": least} | ({} if most is None else {"maxItems": most})


def pair_of(form: Form) -> Form:
    """The form of a list of two."""
    return list_of(form, 2, 2)


def or_null(form: Form) -> Form:
    """The form of what may be missing."""
    return {"anyOf": [form, {"type": "null"}]}


def form_of(*parts: Form, **fields: Form) -> Form:
    """The form of an object with these fields, and those of other forms."""
    given = [cast("dict[str, Form]", part["properties"]) for part in parts]
    properties = {name: form for each in given for name, form in each.items()} | fields
    return {"type": "object", "required": list(properties), "additionalProperties": False, "properties": properties}


def optional(*names: str, form: Form) -> Form:
    """The form of an object in which these fields may be missing."""
    required = cast("list[str]", form["required"])
    return form | {"required": [name for name in required if name not in names]}


def one_of(kinds: type[Enum]) -> Form:
    """The form of a member of an enumeration."""
    return {"enum": [kind.value for kind in kinds]}


TEXTS = list_of(TEXT)
INTERVAL = pair_of(TEXT)
INTERVALS = list_of(INTERVAL, 1)
ANGLE = or_null(form_of(cosine=TEXT, sine=TEXT, degrees=TEXT))
BOX = form_of(u=INTERVAL, v=INTERVAL)
PATCH = pair_of(INTEGER)
PARAMETER = optional(
    "polynomial", form=form_of(parameter=or_null(TEXT), interval=INTERVAL, decimal=TEXT, polynomial=TEXTS)
)
REAL = form_of(exact=or_null(TEXT), interval=INTERVAL, decimal=TEXT)
PLACE = form_of(**dict.fromkeys("uv", PARAMETER), patches=list_of(PATCH))
FEATURE = optional(
    "curvature",
    "torsion",
    "coordinate",
    form=form_of(
        kind=one_of(FeatureKind),
        parameter=or_null(TEXT),
        interval=INTERVAL,
        decimal=TEXT,
        at_knot=FLAG,
        by_jump=FLAG,
        of_absolute={"enum": ["", *map(str, FeatureKind)]},
        angle=ANGLE,
        curvature=TEXT,
        torsion=TEXT,
        coordinate=INTEGER,
    ),
)


_NUMBERS: Form = {"type": "object", "additionalProperties": TEXTS}


def _described(kinds: type[StrEnum], *facts: str) -> Form:
    return form_of(kind=one_of(kinds), intervals=INTERVALS, numbers=_NUMBERS, **dict.fromkeys(facts, FLAG))


_NET: dict[str, Form] = {
    "degree": {"type": ["integer", "array"], "items": INTEGER},
    "knots": {"type": "array", "items": {"type": ["string", "array"], "items": TEXT}},
}
_POINTS = list_of(TEXTS)
_PIECE = optional(
    "homogeneous_control_points",
    "control_points",
    form=form_of(
        interval=INTERVAL,
        kind={"enum": ["rational", "polynomial", "function"]},
        **_NET,
        homogeneous_control_points=_POINTS,
        control_points={"type": "array", "items": {"type": ["string", "array"], "items": TEXT}},
    ),
)
_EQUATION = form_of(text=TEXT, terms=list_of({"type": "array", "minItems": 3, "maxItems": 3}))
_LIMITS = form_of(ends=list_of(pair_of(PARAMETER)), nodes=list_of(pair_of(PARAMETER)))
_BRANCH = form_of(low=PARAMETER, high=PARAMETER, index=INTEGER, sample=pair_of(PARAMETER))
_SIDES = pair_of(INTERVAL)
_OVER_ROOT = form_of(
    parameter={"enum": ["s", "t"]},
    low=PARAMETER,
    high=PARAMETER,
    directrix=form_of(**_NET, homogeneous_control_points=list_of(list_of(TEXTS))),
    generator=form_of(**_NET, control_points=list_of(list_of(TEXTS))),
    poles=or_null(list_of(PARAMETER)),
)
_LINE_PIECE = form_of(
    parameter={"enum": ["s", "t"]},
    low=PARAMETER,
    high=PARAMETER,
    other=or_null({"anyOf": [_PIECE, PARAMETER]}),
    directrix=_PIECE,
    generator=_PIECE,
    poles=list_of(PARAMETER),
)
_OVERLAP = form_of(
    first=pair_of(REAL),
    second=pair_of(REAL),
    reversed=FLAG,
    of_second=FLAG,
    numerator=or_null(TEXTS),
    denominator=or_null(TEXTS),
)
_INTERSECTION = form_of(
    kind=one_of(IntersectionKind),
    first=REAL,
    second=REAL,
    multiplicity=or_null(INTEGER),
    at_knot=pair_of(FLAG),
    point=list_of(REAL),
)
#: The form of an answer, or of one of its elements, by its type.
FORMS: dict[Any, Form] = {
    mpq: TEXT,
    Plane: TEXT,
    Feature: FEATURE,
    Joint: form_of(
        kind=one_of(JointKind),
        parameter=TEXT,
        decimal=TEXT,
        at_seam=FLAG,
        geometric_continuity=or_null(INTEGER),
        angle=ANGLE,
        gap=or_null(TEXT),
        gap_decimal=or_null(TEXT),
        curvatures=or_null(INTERVAL),
        curvature=or_null(TEXT),
    ),
    CurvePiece: INTERVALS,
    tuple[CurvePiece, Plane]: form_of(intervals=INTERVALS, plane=TEXT),
    RecognizedPiece: _described(ShapeKind, "whole"),
    RecognizedPart: form_of(kind=one_of(ShapeKind), patches=list_of(PATCH), whole=FLAG, once=FLAG, numbers=_NUMBERS),
    NearbyFeature: _described(FeatureKind, "certain", "single"),
    NearbyMeeting: _described(IntersectionKind, "certain"),
    StableFeature: _described(FeatureKind),
    Intersections: form_of(points=list_of(_INTERSECTION), everywhere=list_of(_OVERLAP), left_out=TEXTS),
    Distance: form_of(
        points=list_of(form_of(first=REAL, second=REAL)),
        everywhere=list_of(_OVERLAP),
        lower=or_null(TEXT),
        left_out=TEXTS,
        squared=REAL,
        value=REAL,
    ),
    PatchInspection: form_of(
        BOX,
        patch=PATCH,
        kind=one_of(PatchKind),
        minimal=FLAG,
        curvature=or_null(TEXT),
        radius_squared=or_null(TEXT),
        umbilic_everywhere=FLAG,
        singular_curve=FLAG,
        curve_of_umbilics=FLAG,
        undecided=list_of(BOX),
    ),
    NearbyUmbilic: form_of(BOX, certain=FLAG),
    Umbilic: form_of(PLACE, kind=one_of(UmbilicKind), index=or_null(TEXT), one_sided=FLAG),
    Place: PLACE,
    ZeroLine: form_of(
        along=one_of(Along), value=or_null(TEXT), decimal=TEXT, interval=INTERVAL, closed=FLAG, one_sided=FLAG
    ),
    ZeroComponent: form_of(BOX, patches=list_of(PATCH), shape=one_of(Shape)),
    Pole: form_of(along=one_of(Along), value=TEXT, interval=INTERVAL, point=or_null(TEXTS), gap=one_of(Gap)),
    SurfaceJoint: form_of(
        across=one_of(Along),
        value=TEXT,
        interval=INTERVAL,
        at_seam=FLAG,
        kind=one_of(SurfaceJointKind),
        geometric_continuity=or_null(INTEGER),
        angle=ANGLE,
    ),
    BisectorPatch: form_of(**_NET, sides=_SIDES, homogeneous_control_net=list_of(_POINTS)),
    LineComponent: form_of(
        _LIMITS,
        pairs=one_of(Correspondence),
        cause=one_of(Cause),
        sides=_SIDES,
        equation=or_null(_EQUATION),
        fixed=or_null(PARAMETER),
        over_root=or_null(_OVER_ROOT),
        pieces=list_of(_LINE_PIECE),
        branches=list_of(form_of(_BRANCH, point=TEXTS, direction=TEXTS)),
    ),
    PlaneComponent: form_of(
        _LIMITS,
        solutions=one_of(Solutions),
        cause=one_of(Cause),
        sides=_SIDES,
        equation=or_null(_EQUATION),
        parameter={"enum": ["s", "t"]},
        intervals=list_of(pair_of(PARAMETER)),
        fixed=or_null(PARAMETER),
        branches=list_of(_BRANCH),
    ),
    SinglePair: optional(
        "point",
        "direction",
        "normal",
        form=form_of(
            s=PARAMETER,
            t=PARAMETER,
            solutions=one_of(Solutions),
            cause=one_of(Cause),
            sides=_SIDES,
            point=TEXTS,
            direction=TEXTS,
            normal=TEXTS,
        ),
    ),
    PoleCurve: form_of(sides=_SIDES, equation=_EQUATION, certain=FLAG),
}
FORMS[Ridges] = form_of(
    curves=list_of(FORMS[ZeroComponent]),
    lines=list_of(FORMS[ZeroLine]),
    everywhere=list_of(form_of(BOX, patch=PATCH, curvatures=INTEGER)),
    undecided=list_of(form_of(BOX, umbilics=INTEGER, singular_points=INTEGER)),
)
_MISSING = form_of(interval=INTERVAL, reason=TEXT)
_RULED = form_of(interval=INTERVAL, moved=TEXT, directrix=_PIECE, generator=_PIECE)
_TRIMMED = form_of(_PIECE, piece=one_of(PieceKind), foot=TEXT, low=PARAMETER, high=PARAMETER, cut=FLAG)
_TRIMMED |= {"required": ["piece", "low", "high", "interval", "kind"]}
_PAIRS = form_of(
    piece={"enum": ["arc of pairs", "loop of pairs", "pair", "line of pairs", "rectangle of pairs"]},
    **dict.fromkeys(("start", "end"), or_null(pair_of(REAL))),
)
#: What `inspect`, `between` and `bisector` have beside answers.
FORMS_BESIDE: dict[str, dict[str, Form]] = {
    "bisector": {
        "curves": TEXTS,
        "point": TEXTS,
        "left_out": TEXTS,
        "singular": list_of(PARAMETER),
        "missing": list_of({"anyOf": [TEXT, _MISSING, form_of(sides=_SIDES, reason=TEXT)]}),
        "pieces": list_of({"anyOf": [_RULED, _TRIMMED, _PAIRS]}),
        "true_feet": list_of(_SIDES),
        "undecided": list_of(_SIDES),
    },
    "between": {"meetings": list_of(FORMS[NearbyMeeting])},
    "inspect surface": {"umbilics_within": list_of(FORMS[NearbyUmbilic])},
    "inspect": {
        "coordinate_extrema": list_of(FEATURE),
        "nearby": list_of(FORMS[NearbyFeature]),
        "meetings": list_of(FORMS[NearbyMeeting]),
        "stability": list_of(form_of(FORMS[StableFeature], prominence=or_null(TEXT))),
        "approaches": list_of(
            form_of(
                name=TEXT,
                **dict.fromkeys(("degree", "control_points", "roots", "extraneous", "missing"), INTEGER),
                seconds={"type": "number"},
            )
        ),
    },
}


def values_form() -> Form:
    """The form of numbers by name, as the oracle has them: exactly, between two bounds, and as a double."""
    number = form_of(exact=or_null(TEXT), low=TEXT, high=TEXT, double=or_null({"type": "number"}))
    return form_of(values={"type": "object", "additionalProperties": number})


#: A part of a surface all of whose points belong to an answer.
_PART = form_of(BOX, patch=PATCH, along_curve=FLAG)


def answer_form(entry: Entry) -> Form:
    """The form of the answer to a question, by the type that the question promises.

    >>> from exactspline.geometry.analysis import QUESTIONS
    >>> answer_form(QUESTIONS["inflections"])["properties"]["points"]["items"]["properties"]["kind"]["enum"][:2]
    ['cusp', 'stop']
    """
    assert isinstance(entry, Question | QuestionWith)
    promised = get_type_hints(entry.compute).get("return")
    return {} if promised is None else _form(promised)


def _form(kind: Any) -> Form:
    if kind in FORMS:
        return FORMS[kind]
    parts, origin = get_args(kind), getattr(kind, "__origin__", None)
    if NoneType in parts:
        return or_null(_form(next(part for part in parts if part is not NoneType)))
    if origin is Places:
        return form_of(points=list_of(_form(parts[0])), everywhere=list_of(INTERVALS))
    if origin is SurfacePlaces:
        return form_of(points=list_of(_form(parts[0])), everywhere=list_of(_PART), undecided=list_of(BOX))
    return one_of(kind) if isinstance(kind, type) and issubclass(kind, StrEnum) else list_of(_form(parts[0]))


def surface_answer_forms() -> dict[str, Form]:
    """The forms of the answers to the questions about surfaces and maps of the plane, by their names."""
    return {name: answer_form(entry) for of in (Of.SURFACE, Of.PLANAR_MAP) for name, entry in REGISTRY[of].items()}
