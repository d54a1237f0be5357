"""What two curves have in common, as data and as a table."""

from __future__ import annotations

from typing import TYPE_CHECKING

from exactspline.display.forms import (
    DIGITS,
    FLAG,
    INTEGER,
    REAL,
    TEXT,
    list_of,
    lists,
    one_of,
    or_null,
    pair_of,
    real_text,
    record,
)
from exactspline.display.numbers import polynomial_text
from exactspline.display.serialize import POINT
from exactspline.display.sheet import Sheet
from exactspline.geometry.pairs.intersections import Intersection, IntersectionKind, Overlap
from exactspline.numbers.exact import mpq
from exactspline.reals.real import Real

if TYPE_CHECKING:
    from exactspline.geometry.analysis.pairs import CurvePair


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
