"""The arguments of a question in addition to its object, and the question as text: its name, arguments after a colon,
parameters after an @, as in ``length``, ``nearest:1/2,2``, ``derivative:2@0,1/3``, ``value@cusps``.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Iterable, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

from exactspline.errors import ExactSplineError, as_text, nearest
from exactspline.numbers.exact import mpq, rational
from exactspline.numbers.intervals import Side
from exactspline.reals.real import Real

#: The largest integer that a question takes.
MOST = 999


class QuestionError(ExactSplineError):
    """The error for a question that cannot be read, or that has no answer for its object."""


def parts_of(asked: str, forms: Mapping[str, str], optional: Container[str] = ()) -> tuple[str, str, str]:
    """The name, the argument and the place of a question, whose `forms` are given by its names, as
    ``derivative:2@1/2``. The argument of the `optional` ones may be left out.

    >>> parts_of("derivative:2@0,1/3", {"derivative": "derivative:2@1/2"})
    ('derivative', '2', '0,1/3')

    Raises `QuestionError` for an unknown name, with the nearest names, and for missing and superfluous arguments, with
    the form of the question; for ``length`` at parameters, with the form of ``length_between``, and likewise.
    """
    asked, name = as_text(asked, "a question").strip(), name_of(asked)
    if name not in forms:
        raise unknown(name, forms)
    form, rest = forms[name], asked.removeprefix(name)
    argument, _, place = rest.partition("@") if "@" in form else (rest, "", "")
    given = argument.startswith(":") and argument != ":"
    fits = given if argument else name in optional or ":" not in form
    if not fits or given > (":" in form) or bool(place) != ("@" in form):
        others = [form, *(x for k, x in forms.items() if k.startswith(f"{name}_") and "@" in asked and "@" in x)]
        raise QuestionError(f"the question {asked!r}", remedy=f"write it like {' or '.join(map(repr, others))}")
    return name, argument[1:], place


def name_of(asked: str) -> str:
    """The name in the text of a question.

    >>> name_of("derivative:2@0")
    'derivative'
    """
    return as_text(asked, "a question").partition("@")[0].partition(":")[0].strip()


def unknown(name: str, names: Iterable[str]) -> QuestionError:
    """The error for a question that does not exist, with the nearest names."""
    remedy = nearest(name, dict.fromkeys(names), listed_by="list questions")
    return QuestionError(f"there is no question called {name!r}", remedy=remedy)


@dataclass(frozen=True)
class Takes:
    """One argument of a question: an example as text, and the function that reads it, from text or from a value in
    Python, for the given object. An argument that is `placed` comes after the @.
    """

    example: str
    read: Callable[[Any, Any], Any]
    placed: bool = False


def _integer(given: object, facts: object) -> int:
    written = str(given)
    if written.isascii() and written.isdecimal() and int(written) <= MOST:
        return int(written)
    raise QuestionError(f"{written!r}, where an integer up to {MOST} is expected", remedy="such as 2")


def _distance(given: Any, facts: object) -> mpq:
    return rational(given)


def _parts(given: Any, facts: object = None) -> tuple[Any, ...]:
    """The parts of a text with commas between them, or of a sequence."""
    return tuple(given.split(",") if isinstance(given, str) else given)


#: An integer from 0 on.
INTEGER = Takes("2", _integer)
#: A coordinate by its number; 0 is x.
COORDINATE = Takes("0", _integer)
#: A distance, and one within which control points and weights may differ.
DISTANCE, WITHIN = Takes("1/10", _distance), Takes("1/1000000", _distance)
#: A distance that may not be exceeded.
TOLERANCE = Takes("1/1000", _distance)
#: An arc length from the start of a curve.
LENGTH = Takes("1", _distance)
#: A number for an upper bound.
BOUND = Takes("2", _distance)
#: The coordinates of a point.
POINT = Takes("1/2,2", _parts)


def _two_coordinates(given: Any, facts: Any) -> tuple[int, int]:
    written, dimension = "".join(map(str, given)), facts.curve.dimension
    if len(written) != 2 or not written.isascii() or not written.isdecimal() or max(map(int, written)) >= dimension:
        raise QuestionError(f"{written!r}, where two coordinates of R{dimension} are needed", remedy="01 is x y")
    return int(written[0]), int(written[1])


TWO_COORDINATES = Takes("01", _two_coordinates)


class OnCurve(NamedTuple):
    """A parameter of a curve, and the side from which limits are taken, if one is named."""

    parameter: mpq | Real
    side: Side | None = None


#: The signs after a parameter: from the left, and from the right.
SIDES = {"-": Side.LEFT, "+": Side.RIGHT}


def _places(given: Any, facts: Any) -> tuple[OnCurve, ...]:
    many = given.split(",") if isinstance(given, str) else given if isinstance(given, tuple | list) else (given,)
    if not many or "" in many:
        raise QuestionError(
            "no parameter is named", remedy="name one behind the @, as in value@1/2 or value@inflections"
        )
    return tuple(place for each in many for place in _named(each, facts))


def _named(place: Any, facts: Any) -> list[OnCurve]:
    """A parameter, or the parameters of the knots or of the features of a curve, each with the named side if the domain
    is on both sides. The sides of the seam of a closed curve are its two ends.
    """
    side = SIDES.get(place.strip()[-1:]) if isinstance(place, str) else None
    name = place.strip()[:-1] if side else place
    found = facts.parameters_of(name) if isinstance(name, str) else None
    outside = facts.curve.domain[side is Side.RIGHT] if side else None
    if found is None:
        found = (name if isinstance(name, Real) else rational(name),)
        if found[0] == outside and not facts.curve.closed:
            remedy = "the limit from inside is asked for without a side"
            raise QuestionError(f"the limit {place} from outside of the domain", remedy=remedy)
    if side and facts.curve.closed:
        around = facts.curve.domain[side is Side.LEFT]
        found, outside = tuple(dict.fromkeys(around if t == outside else t for t in found)), None
    return [OnCurve(t, None if t == outside else side) for t in found]


def _place(given: Any, facts: Any) -> mpq:
    places = _places(given, facts)
    if len(places) != 1 or isinstance(places[0].parameter, Real) or places[0].side:
        raise QuestionError(f"{given!r}, where one rational parameter is needed", remedy="such as 1/2")
    return places[0].parameter


#: Parameters: numbers, ``knots``, or the name of a question whose answer is a list of places; each may be followed by
#: the side from which limits are taken, as in ``1/2-`` and ``knots+`` (at a knot by default the right side).
PLACES = Takes("1/2", _places, placed=True)
#: One rational parameter.
PLACE = Takes("1/2", _place, placed=True)


def _two_places(given: Any, facts: Any) -> tuple[mpq | Real, ...]:
    places = _places(given, facts)
    if len(places) != 2 or any(place.side for place in places):
        raise QuestionError(f"{given!r}, where two parameters are needed", remedy="such as 0,1/2")
    return tuple(place.parameter for place in places)


#: Two parameters between which something is asked.
TWO_PLACES = Takes("0,1/2", _two_places, placed=True)


def _numbers(
    count: int, expected: str, remedy: str, not_zero: slice = slice(None)
) -> Callable[[Any, Any], tuple[Any, ...]]:
    def read(given: Any, facts: object) -> tuple[mpq, ...]:
        parts = _parts(given)
        if len(parts) != count or (not_zero.stop and not any(map(rational, parts[not_zero]))):
            raise QuestionError(f"{given!r}, where {expected} are expected", remedy=remedy)
        return tuple(map(rational, parts))

    return read


def _two_orders(given: Any, facts: object) -> tuple[int, int]:
    parts = _parts(given)
    if len(parts) != 2 or not all(str(n).isascii() and str(n).isdecimal() and int(n) <= MOST // 10 for n in parts):
        raise QuestionError(f"a derivative of the orders {given!r}", remedy="derivative:1,0@1/2,1/3 is S_u")
    return int(parts[0]), int(parts[1])


#: A coordinate by its number, and a value of it.
COORDINATE_VALUE = Takes("0,1/2", _numbers(2, "a coordinate and a value", "0,1/2 is x = 1/2"))
#: A signed distance for each of two curves.
OFFSETS = Takes("1/10,0", _numbers(2, "two distances", "give one for each curve, such as 1/10,0"))
#: The parameters u and v of a point on a surface.
PLACE_ON_SURFACE = Takes("1/2,1/3", _numbers(2, "u and v", "as in value@1/2,1/3"), placed=True)
#: The orders of a derivative by u and by v.
TWO_ORDERS = Takes("1,0", _two_orders)
#: The coordinates of a point in space.
POINT_IN_SPACE = Takes("0,0,2", _numbers(3, "three coordinates", "such as 0,0,2"))
#: Six numbers, for a line and for a segment.
SIX = "0,0,2,1/2,0,-1"
#: A point of a line and its direction.
LINE = Takes(SIX, _numbers(6, "a point and a direction", f"{SIX} is (0, 0, 2) + t (1/2, 0, -1)", slice(3, 6)))
#: Two points in space.
ENDS = Takes(SIX, _numbers(6, "two points", f"{SIX} is from (0, 0, 2) to (1/2, 0, -1)"))
#: The coefficients a, b, c, d of a plane ax + by + cz = d.
PLANE = Takes("0,0,1,1/2", _numbers(4, "a, b, c, d of ax + by + cz = d", "0,0,1,1/2 is z = 1/2", slice(0, 3)))
