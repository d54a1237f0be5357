"""The form of the answer to each question, by the type of the answer; answers as data, as records (the kind of each
thing, with its numbers and words by name), and as tables; and all answers about an object as data.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from enum import StrEnum
from functools import cache
from operator import itemgetter
from types import NoneType, SimpleNamespace
from typing import TYPE_CHECKING, Any, NamedTuple, cast, get_args, get_type_hints, overload

from exactspline.bivariate.zeros import SurfacePlaces
from exactspline.display import bisector_data, surface_data
from exactspline.display.bisector_data import FORMS_OF_POINT, MISSING, PAIRS, PARAMETER, SIDES_MISSING
from exactspline.display.features import ends_text
from exactspline.display.forms import (
    BOX,
    CURVE,
    DERIVED,
    DIGITS,
    FEATURE,
    FLAG,
    INTEGER,
    INTERVAL,
    INTERVALS,
    JOINT,
    NAMED_NUMBERS,
    NEAREST_POINT,
    PLANAR_PIECE,
    POINT,
    REAL,
    SPLINE,
    TEXT,
    Data,
    Form,
    Located,
    Net,
    described_form,
    double_of,
    list_of,
    lists,
    located,
    one_of,
    or_null,
    pair_of,
    picked,
    plain,
    real_text,
    record,
    word,
)
from exactspline.display.numbers import polynomial_text
from exactspline.display.sheet import Sheet
from exactspline.display.surface_data import places_on_surface
from exactspline.errors import ShapeError, a_kind, as_integer
from exactspline.geometry.analysis.ask import About, Asked, asked_of
from exactspline.geometry.analysis.curves import QUESTIONS
from exactspline.geometry.analysis.inspection import Report, inspect_curve
from exactspline.geometry.analysis.planar_maps import MapInspection
from exactspline.geometry.analysis.surfaces import SurfaceInspection
from exactspline.geometry.bisectors.common import Bisector
from exactspline.geometry.bisectors.point_and_curve import PointBisector
from exactspline.geometry.bisectors.two_curves import CurveBisector
from exactspline.geometry.curves.facts import Facts
from exactspline.geometry.curves.joints import Joint
from exactspline.geometry.curves.kinds import Feature, FeatureKind
from exactspline.geometry.curves.planarity import Plane
from exactspline.geometry.derived.derive import Derived
from exactspline.geometry.pairs.distance import Distance
from exactspline.geometry.pairs.intersections import Intersection, IntersectionKind, Intersections, Overlap
from exactspline.geometry.pairs.nearest import Nearest, NearestPoint
from exactspline.geometry.recognition.pieces import RecognizedPiece
from exactspline.geometry.recognition.shapes import ShapeKind
from exactspline.geometry.rounded.features import NearbyFeature
from exactspline.geometry.rounded.intersections import NearbyMeeting
from exactspline.geometry.rounded.stability import StableFeature
from exactspline.geometry.rounded.umbilics import NearbyUmbilic
from exactspline.hooks import Written
from exactspline.language.rational import Rational
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval
from exactspline.questions.answers import NamedNumbers
from exactspline.questions.entry import Entry, Question, QuestionWith, Remembers, questions_of
from exactspline.reals.real import Real, real
from exactspline.roots.answers import Answer, CurvePiece, Places
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of

if TYPE_CHECKING:
    from exactspline.geometry.analysis.pairs import CurvePair

# ---- common points of two curves


_OVERLAP = record(
    first=pair_of(REAL),
    second=pair_of(REAL),
    reversed=FLAG,
    of_second=FLAG,
    numerator=or_null(list_of(TEXT)),
    denominator=or_null(list_of(TEXT)),
)
_INTERSECTION = record(
    kind=one_of(IntersectionKind),
    first=REAL,
    second=REAL,
    multiplicity=or_null(INTEGER),
    at_knot=pair_of(FLAG),
    point=POINT,
)
#: The points and arcs that two curves have in common.
INTERSECTIONS = lists(points=list_of(_INTERSECTION), everywhere=list_of(_OVERLAP), undecided=list_of(TEXT))
DISTANCE = lists(
    points=(list_of(record(first=REAL, second=REAL)), "pairs"),
    everywhere=list_of(_OVERLAP),
    lower=or_null(TEXT),
    undecided=list_of(TEXT),
    squared=REAL,
    value=REAL,
)


def pair_sheet(pair: CurvePair, title: str, digits: int = DIGITS) -> Sheet:
    """The points, arcs and nearest pairs, one per row."""
    common = pair.intersections

    def number(x: Real | mpq) -> str:
        return real_text(x, digits)

    def along(arc: Overlap) -> list[str]:
        return [f"[{', '.join(map(number, ends))}]" for ends in (arc.first, arc.second)]

    made = Sheet("what", "s", "t", "point", "remark", title=title, prose=["remark"], lists=["s", "t", "point"])
    for point in common:
        at = ", ".join(map(number, point.point))
        made.add_row(point.kind, number(point.first), number(point.second), f"({at})", _remark(point))
    for arc in common.everywhere:
        made.add_row("common arc", *along(arc), "", _map_of(arc))
    if not made.rows:
        distance = pair.distance
        value = f"distance {number(distance.value)}"
        for nearest in distance.pairs:
            made.add_row("nearest", number(nearest.first), number(nearest.second), "", value)
        for arc in distance.everywhere:
            made.add_row("nearest arc", *along(arc), "", ", ".join(filter(None, (value, _map_of(arc)))))
    return made


def _remark(point: Intersection) -> str:
    times = point.multiplicity
    knots = [name for name, here in zip("st", point.at_knot, strict=True) if here]
    parts = [
        f"multiplicity {times}" if times and times > 1 else "",
        f"{' and '.join(knots)} at a knot" if knots else "",
    ]
    return ", ".join(filter(None, parts))


def _map_of(arc: Overlap) -> str:
    if arc.numerator is None or arc.denominator is None:
        return ""
    value, variable = ("t", "s") if arc.of_second else ("s", "t")
    top, bottom = (polynomial_text([mpq(x) for x in each], variable) for each in (arc.numerator, arc.denominator))
    return f"{value} = {top}" if bottom == "1" else f"{value} = ({top})/({bottom})"


TEXTS = list_of(TEXT)


def _any_of(*forms: Form) -> Form:
    return Form({"anyOf": [form.schema for form in forms]})


def bisector_answer(found: Bisector, digits: int) -> Data:
    """A bisector as data."""
    if isinstance(found, CurveBisector):
        return bisector_data.curve_bisector_data(found) | answers_data(found, digits)
    return bisector_data.WRITTEN[type(found)](found, digits)


#: A part of a bisector in space, as in the table of ``bisector``.
PART = record(kind=(TEXT, "piece"), parameters=TEXT, degree=TEXT, remark=TEXT)


def _parts_of(found: Bisector) -> Iterator[tuple[str, Form, Any]]:
    """The parts of a bisector: in the plane the end points, in space all parts; and its missing and undecided parts."""
    if isinstance(found, CurveBisector):
        yield from (("", PART, row) for row in bisector_data.of_two_curves(found, DIGITS)[0])
    elif isinstance(found, PointBisector):
        yield from (("", PART, row) for row in bisector_data.of_point_in_space(found, DIGITS)[0])
    else:
        yield from (("", NAMED_NUMBERS, item) for item in found.items)
    for name in ("missing", "undecided"):
        for why in getattr(found, name, ()):
            yield name, TEXT, why if isinstance(why, str) else ": ".join(map(str, why))


#: The form of an answer, or of one of its elements, by its type.
FORMS: dict[Any, Form] = {
    **surface_data.FORMS,
    **bisector_data.FORMS,
    Real: REAL,
    mpq: TEXT,
    int: INTEGER,
    NamedNumbers: NAMED_NUMBERS,
    Nurbs: CURVE,
    BSpline | Rational[BSpline]: SPLINE.of(Net.of),
    Derived: DERIVED,
    Bisector: Form({"type": "object"}, bisector_answer, elements=_parts_of),
    Plane: TEXT,
    Feature: FEATURE,
    Joint: JOINT,
    CurvePiece: INTERVALS,
    tuple[CurvePiece, Plane]: PLANAR_PIECE,
    RecognizedPiece: described_form(ShapeKind, "whole"),
    NearbyFeature: described_form(FeatureKind, "robust", "single"),
    NearbyMeeting: replace(
        described_form(IntersectionKind, "robust"),
        leaves=lambda one: [("kind", one.kind), ("first", one.first), ("second", one.second), ("robust", one.robust)],
    ),
    StableFeature: described_form(FeatureKind),
    NearestPoint: NEAREST_POINT,
    Nearest: lists(points=list_of(NEAREST_POINT), everywhere=list_of(INTERVALS)),
    Intersections: INTERSECTIONS,
    Distance: DISTANCE,
}
#: The fields of `inspect`, `between` and `bisector` in addition to the answers.
FORMS_BESIDE: dict[str, dict[str, Form]] = {
    "bisector": {
        "curves": TEXTS,
        "point": TEXTS,
        "undecided": TEXTS,
        "singular": list_of(PARAMETER),
        "missing": list_of(_any_of(TEXT, MISSING, SIDES_MISSING)),
        "pieces": list_of(_any_of(*FORMS_OF_POINT.values(), PAIRS)),
        "ends": list_of(NAMED_NUMBERS),
        **dict.fromkeys(("true_feet", "undecided_feet"), list_of(pair_of(INTERVAL))),
    },
    "between": {"meetings": list_of(FORMS[NearbyMeeting])},
    "inspect surface": {"umbilics_within": list_of(FORMS[NearbyUmbilic])},
    "inspect": {
        "coordinate_extrema": list_of(FEATURE),
        "nearby": list_of(FORMS[NearbyFeature]),
        "meetings": list_of(FORMS[NearbyMeeting]),
        "stability": list_of(record(FORMS[StableFeature].of(itemgetter(0)), prominence=(or_null(REAL), itemgetter(1)))),
    },
}


@cache
def form_of(entry: Entry) -> Form:
    """The form of the answer to a question, chosen by the type of the answer. Features and joints are written with
    their curve (`_placed`).

    >>> from exactspline.geometry.analysis.curves import QUESTIONS
    >>> form_of(QUESTIONS["inflections"]).schema["properties"]["points"]["items"]["properties"]["kind"]["enum"][:2]
    ['cusp', 'stop']
    """
    assert isinstance(entry, Question | QuestionWith)
    return _form(get_type_hints(entry.compute)["return"])


def _form(kind: Any) -> Form:
    if kind in FORMS:
        return FORMS[kind]
    parts, origin = get_args(kind), getattr(kind, "__origin__", None)
    if NoneType in parts:
        return or_null(_form(next(part for part in parts if part is not NoneType)))
    if origin is Places:
        return lists(points=list_of(_form(parts[0])), everywhere=list_of(INTERVALS))
    if origin is SurfacePlaces:
        return places_on_surface(_form(parts[0]))
    return one_of(kind) if isinstance(kind, type) and issubclass(kind, StrEnum) else list_of(_form(parts[0]))


def _placed(facts: Remembers, answer: object, tick: Callable[[], None] = lambda: None) -> object:
    """An answer ready to be written: features and joints of a curve are joined with the curve. `tick` is called after
    every feature.
    """
    if not isinstance(facts, Facts):
        return answer
    if isinstance(answer, Places):
        return SimpleNamespace(points=_ticking(facts.curve, answer, tick), everywhere=answer.everywhere)
    if isinstance(answer, tuple):
        return [located(facts.curve, each) if isinstance(each, Joint) else each for each in answer]
    return answer


def _ticking(curve: Nurbs, features: Iterable[Feature], tick: Callable[[], None]) -> Iterator[Located]:
    for feature in features:
        yield located(curve, feature)
        tick()


def answers_data(facts: Remembers, digits: int) -> Data:
    """The answers to all questions of a report about an object, under the names of the questions.

    >>> from exactspline import Nurbs, example
    >>> from exactspline.geometry.analysis.pairs import CurvePair
    >>> pair = CurvePair(example("circle"), Nurbs(1, [0, 0, 1, 1], [(0, 0), (2, 0)]))
    >>> answers_data(pair, 5)["intersections"]["points"][0]["second"]
    {'exact': '1/2', 'low': '1/2', 'high': '1/2', 'double': 0.5}
    """
    entries = {name: entry for name, entry in questions_of(type(facts)).items() if entry.about.reported}
    return {name: form_of(entry).write(entry.answer(facts), digits) for name, entry in entries.items()}


def inspection_data(curve: Nurbs, digits: int = 20, tick: Callable[[], None] = lambda: None) -> Data:
    """Return the features of a curve as data: each answer has the name of its question. `tick` is called after each
    answer.

    Raises `ExactSplineError` for an object that is neither a plane curve nor a space curve.
    """
    digits = as_integer(digits, "a number of digits", 1)
    if not callable(tick):
        raise ShapeError(f"{a_kind(tick)}, where a function without arguments is expected", remedy="leave it out")
    return report_data(inspect_curve(curve_of(curve)), digits, tick)


def report_data(report: Report, digits: int, tick: Callable[[], None] = lambda: None) -> Data:
    """A report about a curve as data; `tick` is called after every feature."""
    curve, facts, beside = report.curve, report.analysis, FORMS_BESIDE["inspect"]
    data: Data = {"curve": curve.name, "closed": curve.closed, "digits": digits}
    for name, answer in report.answers.items():
        data[name] = form_of(QUESTIONS[name]).write(_placed(facts, answer, tick), digits)
    if report.within is not None:
        data["epsilon"] = report.epsilon
        data |= {name: beside[name].write(getattr(report, name), digits) for name in ("nearby", "meetings")}
    if report.with_stability:
        data["stability"] = beside["stability"].write(report.stable, digits)
    if report.with_coordinates:
        extrema = enumerate(report.coordinate_extrema)
        at = [located(curve, feature, axis) for axis, places in extrema for feature in places]
        data["coordinate_extrema"] = beside["coordinate_extrema"].write(at, digits)
    return data


def surface_inspection_data(inspection: SurfaceInspection | MapInspection, digits: int) -> Data:
    """The whole inspection of a surface or of a map of the plane as data."""
    head = {"surface": inspection.surface.name} | picked(inspection.surface, "degree", "polynomial")
    if isinstance(inspection, SurfaceInspection):
        head |= {"digits": digits} | picked(inspection, "closed", "complete", "minimal", "umbilic_everywhere")
        head["curvature"] = plain(inspection.constant_curvature)
    else:
        head |= {"complete": inspection.complete, "undecided": list_of(BOX).write(inspection.undecided, digits)}
    return head | answers_data(inspection, digits)


#: The types of exact numbers.
NUMBER = Real | type(mpq())


class _Record(NamedTuple):
    """One thing of an answer: its kind, and its numbers and words by name."""

    what: str
    values: Mapping[str, object]


def answer_data(asked: Asked, digits: int) -> object:
    """The answer to a question as data for programs."""
    return form_of(asked.entry).write(_placed(asked.facts, asked.answer), digits)


def records(asked: Asked) -> list[_Record]:
    """The records of an answer, one for each thing in it.

    >>> from exactspline import example
    >>> [(each.what, dict(each.values)) for each in records(asked_of(example("circle"), "bounding_box"))]
    [('x', {'low': <Real -1>, 'high': <Real 1>}), ('y', {'low': <Real -1>, 'high': <Real 1>})]
    """
    return _records_of(form_of(asked.entry), _placed(asked.facts, asked.answer), asked.entry.name)


def _records_of(form: Form, value: object, name: str) -> list[_Record]:
    what = name.removesuffix("_within")
    return [*_records(form, value, what if form.elements is None else what.removesuffix("s"))]


def _records(form: Form, value: object, what: str) -> Iterator[_Record]:
    if form.elements is None:
        values = dict(form.leaves(value))
        kind = str(values.pop("kind", values.pop("what", what)))
        # an absent thing has neither numbers nor a kind
        if values or kind != what:
            yield _Record(kind.replace("_", " "), {name or "value": x for name, x in values.items()})
        return
    for group, element, each in form.elements(value):
        own = what if group in ("", "points") else group.removesuffix("s")
        yield from _records(element if element.divided else replace(element, elements=None), each, own)


def answer_sheet(title: str, found: list[_Record], digits: int) -> Sheet:
    """An answer as a table: one row for each number, with its exact value if that is short and with the nearest double,
    and one row for the words.
    """
    made = Sheet("what", "name", "value", "double", title=title, name=title, prose=["value"])
    for each in found:
        words = list[str]()
        for name, value in each.values.items():
            if isinstance(value, NUMBER):
                double = double_of(real(value))
                shown = "–" if double is None else repr(double)
                made.add_row(each.what, name.replace("_", " "), real_text(value, digits), shown)
            else:
                words.append(f"{name.replace('_', ' ')} {_outwards(value)}")
        if words or not each.values:
            made.add_row(each.what, "", "; ".join(words).removeprefix("value "), "")
    if not found:
        made.add_row("nothing", "", "there is none", "")
    return made


def _outwards(value: object) -> str:
    """A word as text. An interval is rounded outwards, since the JSON has its exact ends."""
    if not isinstance(value, Interval | CurvePiece):
        return word(value)
    parts = value.parts if isinstance(value, CurvePiece) else [value]
    return " ∪ ".join(f"[{', '.join(ends_text(part))}]" for part in parts)


@overload
def to_dict(about: About, question: str, digits: int = 20) -> dict[str, object]:
    """The answer to a question (see `ask`) about an object, as data."""


@overload
def to_dict(about: Written, *, digits: int = 20) -> dict[str, object]:
    """An answer."""


def to_dict(about: About | Written, question: str = "", digits: int = 20) -> dict[str, object]:
    """Return the answer to a question (see `ask`) as data for ``json.dumps``, with this many digits of irrational
    numbers. ``answer.to_dict()`` returns the same.

    >>> from exactspline import example
    >>> to_dict(example("torus"), "umbilics")
    {'question': 'umbilics', 'answer': {'points': [], 'everywhere': [], 'undecided': []}}
    """
    digits = as_integer(digits, "a number of digits", 1)
    if isinstance(about, Written) and not question:
        form, value, _ = _form_of_answer(about)
        return cast("dict[str, object]", form.write(value, digits))
    return {"question": question, "answer": answer_data(asked_of(cast(About, about), question), digits)}


@overload
def to_records(about: About, question: str) -> list[dict[str, object]]:
    """The answer to a question about an object."""


@overload
def to_records(about: Written) -> list[dict[str, object]]:
    """An answer."""


def to_records(about: About | Written, question: str = "") -> list[dict[str, object]]:
    """Return the answer to a question (see `ask`) as a list of records for ``pandas.DataFrame`` and
    ``polars.DataFrame``, with correctly rounded doubles as numbers. ``answer.to_records()`` returns the same.

    >>> from exactspline import example
    >>> to_records(example("cubic_s"), "inflections")[0]["parameter"]
    0.5
    """
    if isinstance(about, Written) and not question:
        found = _records_of(*_form_of_answer(about))
    else:
        found = records(asked_of(cast(About, about), question))
    return [{"what": each.what} | {name: _plain(x) for name, x in each.values.items()} for each in found]


def answer_table(answer: Written) -> Sheet:
    """An answer as a table.

    >>> from exactspline import example
    >>> answer_table(example("cubic_s").inflections).rows[0]
    ('inflection', 'parameter', '1/2', '0.5')
    """
    form, value, name = _form_of_answer(answer)
    return answer_sheet(name.replace("_", " "), _records_of(form, value, name), DIGITS)


def _form_of_answer(answer: Written) -> tuple[Form, object, str]:
    """The form of an answer, the value that is written, and its name."""
    if isinstance(answer, Answer) and answer.asked is not None:
        name, again = answer.asked
        facts = cast(Remembers, again())  # an answer that knows its question
        entry = (QUESTIONS if isinstance(facts, Facts) else questions_of(type(facts)))[name]
        return form_of(entry), _placed(facts, answer), name
    for kind in type(answer).__mro__:
        if kind in FORMS:
            return FORMS[kind], answer, kind.__name__.lower()
    raise ShapeError(f"an answer of unknown origin ({type(answer).__name__})", remedy="take it from exactspline.ask")


def _plain(value: object) -> object:
    """A number as a double, a word as text."""
    if isinstance(value, NUMBER):
        return double_of(real(value))
    return value if isinstance(value, bool | int) else str(value)
