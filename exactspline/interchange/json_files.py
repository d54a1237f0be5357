"""The common part of curve files and surface files: JSON with numbers read exactly, points, degrees."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import NoReturn, cast

from exactspline.errors import CurveFileError, NumberError, counted
from exactspline.interchange.limits import Limits
from exactspline.numbers.exact import Number, mpq, rational
from exactspline.numbers.exact import text as text_of
from exactspline.splines.control_points import Direction

USUAL = Limits()
_EXPONENT = re.compile(r"[+-]?0*(\d*)", re.ASCII)
#: Exact numbers are written with this many times the digits, and exponents, that other formats need.
LONGER = 50

#: The fields of a curve and of a surface.
REQUIRED = ("degree", "knots", "control_points")
OPTIONAL = ("weights", "name", "source", "note")
CURVE, SURFACE = "a curve", "a surface"


def check_fields(data: Mapping[str, object], what: str) -> None:
    """Raise `CurveFileError` unless these are the fields of a curve or of a surface (`what`)."""
    remedy = f"{what} has {', '.join(REQUIRED)} and may have {', '.join(OPTIONAL)}"
    for field in REQUIRED:
        if field not in data:
            raise CurveFileError(f"the field {field!r} is missing", remedy=remedy)
    if unknown := sorted(set(data) - {*REQUIRED, *OPTIONAL}):
        raise CurveFileError(f"the field {unknown[0]!r} is unknown", remedy=remedy)


def points_of(rows: Sequence[object], place: str = "control_points", limits: Limits = USUAL) -> list[Iterable[Number]]:
    """Points are lists of numbers, directions are objects: ``{"vector": [x, y]}``; errors name the `place`."""
    points: list[Iterable[Number]] = []
    for i, row in enumerate(rows):
        where = f"{place}[{i}]"
        if isinstance(row, dict):
            if set(row) != {"vector"} or not isinstance(row["vector"], list):
                remedy = 'write [x, y], or {"vector": [x, y]} for a direction'
                raise CurveFileError("is not a control point", where=where, remedy=remedy)
            numbers = numbers_of(row["vector"], f"{where}.vector", limits)
            try:
                points.append(Direction(*numbers))
            except NumberError as error:
                entry = error.where.removeprefix("Direction")
                raise NumberError(error.problem, remedy=error.remedy).at(f"{where}.vector{entry}") from None
        else:
            points.append(numbers_of(row, where, limits) if isinstance(row, list) else cast("list[Number]", row))
    return points


def numbers_of(values: Sequence[object], place: str, limits: Limits = USUAL) -> list[Number]:
    """The numbers of a list (see `number_of`); errors name their places in it."""
    return [number_of(value, f"{place}[{i}]", limits) for i, value in enumerate(values)]


def whole_degree(degree: object) -> int:
    """A degree as written in JSON: an int if it is an integer, otherwise its text, which is rejected later."""
    if not isinstance(degree, _Decimal):
        return cast(int, degree)
    exact = rational(str(degree))
    return int(exact) if exact.denominator == 1 else cast(int, str(degree))


class _Decimal(str):
    """The digits of a JSON number, unchanged."""


def number_of(value: object, where: str = "", limits: Limits = USUAL) -> Number:
    """The text of a JSON number, so that no digit is lost; anything else is checked later.

    Raises `NumberError` for null, and for a text that is longer, or an exponent that is larger, than the limits allow:
    a few digits of an exponent could exhaust the memory.
    """
    if value is None:
        raise NumberError("null is not a number", where=where, remedy="write finite numbers")
    if not isinstance(value, str):
        return cast("Number", value)
    most = LONGER * limits.exponent
    mark, most = ("p", 4 * most) if "x" in value.lower() else ("e", most)
    exponent = value.lower().partition(mark)[2].strip()
    size = found[1] if (found := _EXPONENT.fullmatch(exponent)) else ""
    if len(size) > len(str(most)) or int(size or 0) > most:
        raise NumberError(f"the exponent {exponent[:20]!r}", where=where, remedy=f"exponents up to {most} are read")
    if len(value) > LONGER * limits.digits:
        raise NumberError(f"a number of {counted(len(value), 'character')}", where=where, remedy="raise Limits.digits")
    return str(value)


def parsed(text: str) -> object:
    """The data of a JSON text, with every number as its text.

    >>> parsed('{"a": [1, 0.1, "x"]}')
    {'a': ['1', '0.1', 'x']}

    Raises `CurveFileError` for text that is not JSON, repeats a field, or contains NaN or an infinity.
    """
    try:
        return json.loads(
            text.removeprefix("\ufeff").rstrip(),  # so that an error is never past the last line
            parse_int=_Decimal,
            parse_float=_Decimal,
            parse_constant=_refuse,
            object_pairs_hook=_once_each,
        )
    except RecursionError:
        raise CurveFileError("brackets are nested too deeply", remedy="a curve needs three levels") from None
    except json.JSONDecodeError as error:
        place = f"line {error.lineno}, column {error.colno}"
        raise CurveFileError(f"is not JSON ({error.msg})", where=place, remedy="correct the text there") from None


def _once_each(fields: list[tuple[str, object]]) -> dict[str, object]:
    """The fields of an object; raises `CurveFileError` for a repeated field, which would be ambiguous."""
    unique = dict(fields)
    if len(unique) < len(fields):
        names = [name for name, _ in fields]
        twice = next(name for i, name in enumerate(names) if name in names[:i])
        raise CurveFileError(f"the field {twice!r} is written twice", remedy="keep one of them")
    return unique


def _refuse(word: str) -> NoReturn:
    raise CurveFileError(f"{word} is not a number", remedy="write finite numbers")


def written_point(point: tuple[mpq, ...]) -> dict[str, list[str]] | list[str]:
    """A control point as JSON data: a list of exact coordinates, or an object for a direction."""
    coordinates = [text_of(x) for x in point]
    return {"vector": coordinates} if isinstance(point, Direction) else coordinates
