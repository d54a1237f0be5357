"""What two curves have in common, as data and as a table."""

from __future__ import annotations

from contextlib import suppress
from typing import TYPE_CHECKING, Any

from exactspline.display.data import Data
from exactspline.display.numbers import polynomial_text
from exactspline.display.sheet import Sheet
from exactspline.errors import OpenError, ReachError
from exactspline.geometry.intersections import Intersection, Intersections, Overlap
from exactspline.numbers.exact import mpq, text
from exactspline.numbers.intervals import rounded_outwards
from exactspline.questions.entry import questions_of
from exactspline.reals.real import Real, real

if TYPE_CHECKING:
    from exactspline.geometry.curve_pair import CurvePair


def pair_data(pair: CurvePair, digits: int) -> Data:
    """All answers about two curves, each under the name of its question.

    >>> from exactspline import Nurbs, example
    >>> from exactspline.geometry.curve_pair import CurvePair
    >>> pair = CurvePair(example("circle"), Nurbs(1, [0, 0, 1, 1], [(0, 0), (2, 0)]))
    >>> pair_data(pair, 5)["intersections"]["points"][0]["second"]
    {'exact': '1/2', 'interval': ['1/2', '1/2'], 'decimal': '0.50000'}
    """
    answers = {name: entry.answer(pair) for name, entry in questions_of(type(pair)).items() if entry.about.reported}
    return {name: _answer_data(answer, digits) for name, answer in answers.items()}


def _answer_data(answer: object, digits: int) -> Data:
    if isinstance(answer, Intersections):
        return intersections_data(answer, digits)
    from exactspline.geometry.distance import Distance  # not loaded for what a single curve has

    assert isinstance(answer, Distance), "there are no other answers about two curves"
    pairs = [{"first": real_data(p.first, digits), "second": real_data(p.second, digits)} for p in answer.pairs]
    value = {"squared": real_data(answer.squared, digits), "value": real_data(answer.value, digits)}
    lower = None if answer.lower is None else text(answer.lower)
    arcs = [_overlap_data(arc, digits) for arc in answer.everywhere]
    return {"points": pairs, "everywhere": arcs, "lower": lower, "left_out": list(answer.left_out), **value}


def intersections_data(found: Intersections, digits: int) -> Data:
    """The points and arcs that two curves have in common."""
    return {
        "points": [_point_data(point, digits) for point in found],
        "everywhere": [_overlap_data(arc, digits) for arc in found.everywhere],
        "left_out": list(found.left_out),
    }


def _point_data(point: Intersection, digits: int) -> Data:
    return {
        "kind": str(point.kind),
        "first": real_data(point.first, digits),
        "second": real_data(point.second, digits),
        "multiplicity": point.multiplicity,
        "at_knot": list(point.at_knot),
        "point": [real_data(x, digits) for x in point.point],
    }


def _overlap_data(arc: Overlap, digits: int) -> Data:
    return {
        "first": [real_data(x, digits) for x in arc.first],
        "second": [real_data(x, digits) for x in arc.second],
        "reversed": arc.reversed,
        "of_second": arc.of_second,
        "numerator": None if arc.numerator is None else [str(x) for x in arc.numerator],
        "denominator": None if arc.denominator is None else [str(x) for x in arc.denominator],
    }


def real_data(x: Real | mpq, digits: int) -> Data:
    """A number: exactly where it has a short form, in a certified interval, and to a given number of digits."""
    number = real(x)
    with suppress(ReachError, OpenError):
        _ = number.exact  # then its closed form is known
    low, high = number.enclosure(digits)
    if low != high:
        low, high = rounded_outwards(number.enclosure(digits), digits + 1)
    return {"exact": number.closed_form, "interval": [text(low), text(high)], "decimal": number.decimal(digits)}


def pair_sheet(data: Data, title: str) -> Sheet:
    """The points, arcs and nearest pairs, one per row."""
    common: Any = data["intersections"]
    made = Sheet("what", "s", "t", "point", "remark", title=title, prose=["remark"])
    for point in common["points"]:
        at = ", ".join(x["exact"] or x["decimal"] for x in point["point"])
        made.add_row(point["kind"], _shown(point["first"]), _shown(point["second"]), f"({at})", _remark(point))
    for arc in common["everywhere"]:
        made.add_row("common arc", *_sides_of(arc), "", _map_of(arc))
    if not made.row_count:
        distance: Any = data["distance"]
        value = f"distance {_shown(distance['value'])}"
        for pair in distance["points"]:
            made.add_row("nearest", _shown(pair["first"]), _shown(pair["second"]), "", value)
        for arc in distance["everywhere"]:
            made.add_row("nearest arc", *_sides_of(arc), "", value)
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
