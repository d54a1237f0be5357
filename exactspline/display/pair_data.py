"""What two curves have in common, as data and as a table."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from exactspline.display.data import Data
from exactspline.display.forms import (
    FLAG,
    INTEGER,
    INTERVAL,
    TEXT,
    Form,
    list_of,
    one_of,
    optional,
    or_null,
    pair_of,
    record,
)
from exactspline.display.numbers import polynomial_text
from exactspline.display.sheet import Sheet
from exactspline.errors import OpenError, ReachError
from exactspline.geometry.pairs.intersections import IntersectionKind, Intersections
from exactspline.numbers.exact import mpq, text
from exactspline.questions.entry import questions_of
from exactspline.reals.real import Real, real

if TYPE_CHECKING:
    from exactspline.geometry.analysis.pairs import CurvePair


def pair_data(pair: CurvePair, digits: int) -> Data:
    """All answers about two curves, each under the name of its question.

    >>> from exactspline import Nurbs, example
    >>> from exactspline.geometry.analysis.pairs import CurvePair
    >>> pair = CurvePair(example("circle"), Nurbs(1, [0, 0, 1, 1], [(0, 0), (2, 0)]))
    >>> pair_data(pair, 5)["intersections"]["points"][0]["second"]
    {'exact': '1/2', 'interval': ['1/2', '1/2'], 'decimal': '0.50000'}
    """
    answers = {name: entry.answer(pair) for name, entry in questions_of(type(pair)).items() if entry.about.reported}
    return {
        name: (INTERSECTIONS if isinstance(answer, Intersections) else DISTANCE).write(answer, digits)
        for name, answer in answers.items()
    }


def real_data(x: Real | mpq, digits: int) -> Data:
    """A number: exactly where it has a short form, in a certified interval, and to a given number of digits."""
    number = real(x)
    form, (low, high) = form_data(number), number.around(digits + 1)
    return {**form, "interval": [text(low), text(high)], "decimal": number.decimal(digits)}


def form_data(x: Real) -> Data:
    """The closed form of a number, null if it is proved to have none; ``open`` where that is not decided.

    >>> from exactspline.reals.real import square_root
    >>> form_data(square_root(8)), form_data(square_root(2) + square_root(3))
    ({'exact': '2√2'}, {'exact': None})
    """
    try:
        return {"exact": x.closed_form}
    except (ReachError, OpenError):
        return {"exact": None, "open": True}


REAL = Form(record(exact=or_null(TEXT), open=optional(FLAG), interval=INTERVAL, decimal=TEXT).schema, real_data)
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
    point=list_of(REAL),
)
#: The points and arcs that two curves have in common.
INTERSECTIONS = record(points=list_of(_INTERSECTION), everywhere=list_of(_OVERLAP), left_out=list_of(TEXT))
DISTANCE = record(
    points=(list_of(record(first=REAL, second=REAL)), "pairs"),
    everywhere=list_of(_OVERLAP),
    lower=or_null(TEXT),
    left_out=list_of(TEXT),
    squared=REAL,
    value=REAL,
)


def pair_sheet(data: Data, title: str) -> Sheet:
    """The points, arcs and nearest pairs, one per row."""
    common: Any = data["intersections"]
    made = Sheet("what", "s", "t", "point", "remark", title=title, prose=["remark"])
    for point in common["points"]:
        at = ", ".join(x["exact"] or x["decimal"] for x in point["point"])
        made.add_row(point["kind"], _shown(point["first"]), _shown(point["second"]), f"({at})", _remark(point))
    for arc in common["everywhere"]:
        made.add_row("common arc", *_sides_of(arc), "", _map_of(arc))
    if not made.rows:
        distance: Any = data["distance"]
        value = f"distance {_shown(distance['value'])}"
        for pair in distance["points"]:
            made.add_row("nearest", _shown(pair["first"]), _shown(pair["second"]), "", value)
        for arc in distance["everywhere"]:
            made.add_row("nearest arc", *_sides_of(arc), "", ", ".join(filter(None, (value, _map_of(arc)))))
    return made


def _sides_of(arc: dict[str, Any]) -> list[str]:
    """The parameters of both curves along an arc."""
    return [f"[{', '.join(map(_shown, arc[name]))}]" for name in ("first", "second")]


def _shown(x: dict[str, Any]) -> str:
    exact: str | None = x["exact"]
    return exact or str(x["decimal"])


def _remark(point: dict[str, Any]) -> str:
    times = point["multiplicity"]
    knots = [name for name, here in zip("st", point["at_knot"], strict=True) if here]
    parts = [
        f"multiplicity {times}" if times and times > 1 else "",
        f"{' and '.join(knots)} at a knot" if knots else "",
    ]
    return ", ".join(filter(None, parts))


def _map_of(arc: dict[str, Any]) -> str:
    if arc["numerator"] is None:
        return ""
    value, variable = ("t", "s") if arc["of_second"] else ("s", "t")
    top, bottom = (polynomial_text([mpq(x) for x in arc[name]], variable) for name in ("numerator", "denominator"))
    return f"{value} = {top}" if bottom == "1" else f"{value} = ({top})/({bottom})"
