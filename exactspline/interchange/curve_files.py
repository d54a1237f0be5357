"""Files of curves and surfaces: JSON with ``degree``, ``knots``, ``control_points``, optional ``weights``, ``name``,
``source``, ``note``; numbers as ints, decimals or text.

A control point is a list of coordinates, or ``{"vector": [x, y]}`` for a direction (see `Direction`), whose weight is
0. A number in JSON is read as a decimal: 0.1 is 1/10. Output of ``derive`` and ``bisector`` is also read, if it is a
single curve in one piece; so is any piece copied from it, restricted to the part of the domain that belongs to the
piece.

In a file of a surface, ``degree`` is ``[m, n]``, ``knots`` are two lists, ``control_points`` (or ``points``) is a net
of rows in the direction of u, and ``weights`` a net of the same shape.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterable, Mapping, Sequence
from hashlib import blake2b
from pathlib import Path
from typing import Any, NoReturn, cast

from exactspline.atomic_write import write_text
from exactspline.errors import CurveFileError, NumberError, as_path, counted
from exactspline.interchange.collector import Collector, whole
from exactspline.interchange.format import Format, Spline
from exactspline.interchange.numbers import NumberText
from exactspline.interchange.records import Limits, Reading, Source
from exactspline.numbers.exact import Number, mpq, rational
from exactspline.numbers.exact import text as text_of
from exactspline.splines.bspline import BSpline
from exactspline.splines.control_points import Direction, exact_points
from exactspline.splines.inputs import checked_degree
from exactspline.splines.knots import KnotVector
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface

# ---- JSON with exact numbers


USUAL = Limits()
_EXPONENT = re.compile(r"[+-]?0*(\d*)", re.ASCII)
#: Exact numbers are written with this many times the digits, and exponents, that other formats need.
LONGER = 50

#: The fields of a curve and of a surface.
REQUIRED = ("degree", "knots", "control_points")
OPTIONAL = ("weights", "name", "source", "note")
CURVE, SURFACE = "a curve", "a surface"


def _check_fields(data: Mapping[str, object], what: str) -> None:
    """Raise `CurveFileError` unless these are the fields of a curve or of a surface (`what`)."""
    remedy = f"{what} has {', '.join(REQUIRED)} and may have {', '.join(OPTIONAL)}"
    for field in REQUIRED:
        if field not in data:
            raise CurveFileError(f"the field {field!r} is missing", remedy=remedy)
    if unknown := sorted(set(data) - {*REQUIRED, *OPTIONAL}):
        raise CurveFileError(f"the field {unknown[0]!r} is unknown", remedy=remedy)


def _points_of(rows: Sequence[object], place: str = "control_points", limits: Limits = USUAL) -> list[Iterable[Number]]:
    """Points are lists of numbers, directions are objects: ``{"vector": [x, y]}``; errors name the `place`."""
    points: list[Iterable[Number]] = []
    for i, row in enumerate(rows):
        where = f"{place}[{i}]"
        if isinstance(row, dict):
            if set(row) != {"vector"} or not isinstance(row["vector"], list):
                remedy = 'write [x, y], or {"vector": [x, y]} for a direction'
                raise CurveFileError("is not a control point", where=where, remedy=remedy)
            numbers = _numbers_of(row["vector"], f"{where}.vector", limits)
            try:
                points.append(Direction(*numbers))
            except NumberError as error:
                entry = error.where.removeprefix("Direction")
                raise NumberError(error.problem, remedy=error.remedy).at(f"{where}.vector{entry}") from None
        else:
            points.append(_numbers_of(row, where, limits) if isinstance(row, list) else cast("list[Number]", row))
    return points


def _numbers_of(values: Sequence[object], place: str, limits: Limits = USUAL) -> list[Number]:
    """The numbers of a list (see `_number_of`); errors name their places in it."""
    return [_number_of(value, f"{place}[{i}]", limits) for i, value in enumerate(values)]


def _whole_degree(degree: object) -> int:
    """A degree as written in JSON: an int if it is an integer, otherwise its text, which is rejected later."""
    if not isinstance(degree, _Decimal):
        return cast(int, degree)
    exact = rational(str(degree))
    return int(exact) if exact.denominator == 1 else cast(int, str(degree))


class _Decimal(str):
    """The digits of a JSON number, unchanged."""


def _number_of(value: object, where: str = "", limits: Limits = USUAL) -> Number:
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


def _written_point(point: tuple[mpq, ...]) -> dict[str, list[str]] | list[str]:
    """A control point as JSON data: a list of exact coordinates, or an object for a direction."""
    coordinates = [text_of(x) for x in point]
    return {"vector": coordinates} if isinstance(point, Direction) else coordinates


#: The fields of a curve that are long.
SIZED = "knots", "control_points", "weights"


def _curve_from_data(given: Mapping[str, object], name: str = "", limits: Limits = USUAL) -> Nurbs:
    """The curve in JSON data, with numbers as text (`exactspline.interchange.curve_files.parsed`), within the limits on
    single numbers.
    """
    data: dict[str, Any] = dict(given)
    if "pieces" in data:
        data = _one_piece(data)
    if "kind" in data:
        return _curve_of_piece(data, name, limits)
    _check_fields(data, CURVE)
    listed = {field: _list(data[field], field) for field in SIZED if data.get(field) is not None or field != "weights"}
    own = _numbers_of(listed["weights"], "weights", limits) if "weights" in listed else None
    knots, points = _numbers_of(listed["knots"], "knots", limits), _points_of(listed["control_points"], limits=limits)
    return Nurbs(_whole_degree(data["degree"]), knots, points, own, **_labels(data, name))


def _labels(data: Mapping[str, object], name: str) -> dict[str, str]:
    """Name, source and note."""
    return {"name": str(data.get("name") or name)} | {key: str(data.get(key) or "") for key in ("source", "note")}


def _one_piece(data: dict[str, Any]) -> dict[str, Any]:
    """The only piece in an output of `derive` or `bisector`."""
    pieces = data["pieces"] if isinstance(data["pieces"], list) else []
    curves = [p for p in pieces if isinstance(p, dict) and p.get("kind") in ("polynomial", "rational")]
    if data.get("layout") or len(pieces) != 1 or not curves:
        problem = "is a derived object, but not one curve in one piece"
        raise CurveFileError(problem, where="pieces", remedy="copy a piece: degree, knots and control points")
    if pieces[0].get("cut"):
        problem = "is a part of these control points that ends at an irrational parameter"
        raise CurveFileError(
            problem, where="pieces[0]", remedy="see low and high; a curve in a file ends at a rational parameter"
        )
    of = f" of {data['curve']}" if data.get("curve") else ""
    named: dict[str, Any] = {"name": f"{data.get('name') or data.get('kind') or 'piece'}{of}"}
    return named | curves[0]


def _curve_of_piece(piece: dict[str, Any], name: str, limits: Limits) -> Nurbs:
    """The curve of a piece, restricted to the part of the domain that belongs to the piece.

    Its homogeneous control points are ``(w x, w y, …, w)``.
    """
    if piece["kind"] not in ("polynomial", "rational"):
        raise CurveFileError(f"{piece['kind']!r} is not a curve", where="kind", remedy="copy a piece that is a curve")
    rational_piece = piece["kind"] == "rational"
    field = "homogeneous_control_points" if rational_piece else "control_points"
    for needed in ("degree", "knots", field):
        if needed not in piece:
            raise CurveFileError(f"the field {needed!r} is missing", remedy="copy the whole piece")
    listed, net = _list(piece["knots"], "knots"), piece[field]
    if not isinstance(net, list) or not net or not all(isinstance(row, list) and row for row in net):
        remedy = f"write {'(w x, w y, …, w)' if rational_piece else '(x, y, …)'} for each"
        raise CurveFileError("is not a list of points", where=field, remedy=remedy)
    read = [_numbers_of(row, f"{field}[{i}]", limits) for i, row in enumerate(net)]
    rows = exact_points(read, least=3 if rational_piece else 2)
    degree, knots = _whole_degree(piece["degree"]), KnotVector(_numbers_of(listed, "knots", limits))
    knots.check(checked_degree(degree))
    low, high = _ends(piece, knots.domain(degree), limits)
    *p, last = [BSpline(degree, knots, column).restrict(low, high) for column in zip(*rows, strict=True)]
    name = str(piece.get("name") or name)
    return Nurbs.from_splines(p, last, name=name) if rational_piece else Nurbs.from_splines([*p, last], name=name)


def _ends(piece: dict[str, Any], domain: tuple[mpq, mpq], limits: Limits) -> tuple[mpq, mpq]:
    """The parameters where a piece begins and ends: ``low`` and ``high``, or ``interval``, or the ends of its knots."""
    interval = piece.get("interval")
    if interval is not None and (not isinstance(interval, list) or len(interval) != 2):
        raise CurveFileError("is not an interval", where="interval", remedy="write [low, high]")
    low, high = domain if interval is None else (_end(end, f"interval[{i}]", limits) for i, end in enumerate(interval))
    given = ((piece.get(key), key, otherwise) for key, otherwise in (("low", low), ("high", high)))
    first, last = (otherwise if end is None else _end(end, key, limits) for end, key, otherwise in given)
    return first, last


def _end(end: Any, key: str, limits: Limits) -> mpq:
    if not isinstance(end, dict):
        return _rational(end, key, limits)
    if end.get("exact") is None:
        problem = f"the piece ends at an irrational parameter (in [{end.get('low')}, {end.get('high')}])"
        raise CurveFileError(problem, where=key, remedy="write a rational parameter inside the piece")
    return _rational(end["exact"], key, limits)


def _rational(value: object, key: str, limits: Limits) -> mpq:
    number = _number_of(value, key, limits)
    try:
        return rational(number)
    except NumberError as error:
        raise error.at(key) from None


# ---- surfaces

#: An alternative name for ``control_points``.
NET = "points"


def _surface_from_data(given: Mapping[str, object], name: str = "", limits: Limits = USUAL) -> NurbsSurface:
    """The surface in JSON data, with numbers as text (`exactspline.interchange.curve_files.parsed`), within the limits
    on single numbers.
    """
    data = dict(given)
    if NET in data and "control_points" not in data:
        data["control_points"] = data.pop(NET)
    _check_fields(data, SURFACE)
    degree = [_whole_degree(n) for n in _list(data["degree"], "degree", 2)]
    knots = [_list(row, f"knots[{i}]") for i, row in enumerate(_list(data["knots"], "knots", 2))]
    net = []
    for i, row in enumerate(_list(data["control_points"], "control_points")):
        place = f"control_points[{i}]"
        net.append(_points_of(_list(row, place), place, limits))
    weights = data.get("weights")
    own = None if weights is None else _numbers(weights, limits)
    u, v = (_numbers_of(row, f"knots[{i}]", limits) for i, row in enumerate(knots))
    return NurbsSurface((degree[0], degree[1]), u, v, net, own, **_labels(data, name))


def _list(value: Any, where: str, count: int | None = None) -> list[Any]:
    if not isinstance(value, list):
        raise CurveFileError("is not a list", where=where, remedy="write a JSON list")
    if count is not None and len(value) != count:
        raise CurveFileError(f"has {counted(len(value), 'entry')}", where=where, remedy="one for u and one for v")
    return value


def _numbers(rows: object, limits: Limits) -> list[list[Number]]:
    listed = ((f"weights[{i}]", row) for i, row in enumerate(_list(rows, "weights")))
    return [_numbers_of(_list(row, place), place, limits) for place, row in listed]


# ---- writing


def curve_data(curve: Nurbs) -> dict[str, object]:
    """The data of a curve file, with numbers as exact text."""
    points = [_written_point(point) for point in curve.control_points]
    return _data(curve, curve.degree, _texts(curve.knots), points, _texts(curve.weights))


def surface_data(surface: NurbsSurface) -> dict[str, object]:
    """The data of a surface file, with numbers as exact text."""
    net = [[_written_point(point) for point in row] for row in surface.control_points]
    knots, weights = ([_texts(row) for row in rows] for rows in (surface.knots, surface.weights))
    return _data(surface, list(surface.degree), knots, net, weights)


def _texts(numbers: Iterable[mpq]) -> list[str]:
    return [str(x) for x in numbers]


def _data(
    of: Nurbs | NurbsSurface, degree: object, knots: object, points: object, weights: object
) -> dict[str, object]:
    data = {"name": of.name, "source": of.source or None, "degree": degree, "knots": knots, "control_points": points}
    data |= {"note": of.note or None, "weights": None if of.polynomial else weights}
    return {field: value for field, value in data.items() if value is not None}


def write_json(path: str | os.PathLike[str], data: object) -> None:
    """Write JSON atomically: either the whole file is written or nothing."""
    write_text(as_path(path), json.dumps(data, indent=1, ensure_ascii=False) + "\n")


# ---- digests


def short_digest(text: str) -> str:
    """Sixteen hexadecimal digits that change with the text: a protection against accidents, not against forgery."""
    return blake2b(text.encode("utf-8", "surrogatepass"), digest_size=8).hexdigest()


def curve_digest(curve: Nurbs) -> str:
    """A digest of a curve's exact data, whatever its name."""
    points = [*curve.knots, *curve.weights, *(x for row in curve.control_points for x in row)]
    return short_digest(f"{curve.degree} {curve.dimension} {' '.join(map(str, points))}")


def surface_digest(surface: NurbsSurface) -> str:
    """A digest of a surface's exact data, whatever its name."""
    net = (x for row in surface.control_points for point in row for x in point)
    points = [*surface.knots[0], "|", *surface.knots[1], *(w for row in surface.weights for w in row), *net]
    return short_digest(f"{surface.degree} {surface.dimension} {' '.join(map(str, points))}")


#: An object, or a list of them.
_BEGINNING = re.compile(rb"(\xef\xbb\xbf)?\s*(\[\s*)?\{")


def looks_like(head: bytes) -> bool:
    """Whether a file begins like a curve file."""
    return _BEGINNING.match(head) is not None


def read(source: Source) -> Reading:
    """The curves and surfaces of a file. If there are several, an invalid one is skipped; the error of a single one is
    raised.
    """
    collector = Collector("json", source)
    try:
        data: Any = parsed(source.data.decode("utf-8-sig"))
    except UnicodeDecodeError:
        raise CurveFileError("is not UTF-8 text", remedy="a curve file is JSON") from None
    if isinstance(data, dict) and "curves" not in data:
        _add(collector, data, "curve 1")
        return collector.reading()
    entries = data["curves"] if isinstance(data, dict) else data
    if not isinstance(entries, list):
        raise CurveFileError("the JSON text holds no curves", remedy='write one curve or {"curves": […]}')
    for number, entry in enumerate(entries, 1):
        what = "surface" if _is_surface(entry) else "curve"
        name = entry.get("name") if isinstance(entry, dict) else None
        where = f"{what} {number}" + (f" ({name})" if isinstance(name, str) and name else "")
        with collector.skipping(what, where, curve=what == "curve"):
            _add(collector, entry, where)
    return collector.reading()


def _is_surface(entry: Any) -> bool:
    return isinstance(entry, dict) and isinstance(entry.get("degree"), list)


def _add(collector: Collector, entry: Any, where: str) -> None:
    (_surface if _is_surface(entry) else _curve)(collector, entry, where)


def _curve(collector: Collector, entry: Any, where: str) -> None:
    if not isinstance(entry, dict):
        raise CurveFileError("is not an object", remedy='write {"degree": …, "knots": […], "control_points": […]}')
    collector.count(sum(len(entry[key]) for key in SIZED if isinstance(entry.get(key), list)))
    piece = "pieces" in entry or "kind" in entry
    entry, unrolled = (entry, []) if piece else _whole(entry, collector.limits)
    curve = _curve_from_data(entry, where if piece else Path(collector.source.name).stem, collector.limits)
    remarks = [curve.note, f"source: {curve.source}" if curve.source else ""]
    notes = ["written by `derive`"] if piece else [*filter(None, remarks), *unrolled]
    collector.keep(curve, notes, rational=not piece and entry.get("weights") is not None)


def _whole(entry: dict[str, Any], limits: Limits) -> tuple[dict[str, Any], Sequence[str]]:
    """The data of a curve, and notes. If only one period of the curve is listed, the data are continued."""
    degree, listed = entry.get("degree"), {key: entry[key] for key in SIZED if isinstance(entry.get(key), list)}
    knots, points = listed.get("knots", []), listed.get("control_points", [])
    # a degree beyond the limits is refused later
    n = int(degree) if isinstance(degree, str) and degree.isdecimal() and len(degree) < 9 else limits.degree + 1
    if n > limits.degree or len(knots) == len(points) + n + 1:
        return entry, ()
    full = whole(n, [*KnotVector(_numbers_of(knots, "knots", limits))], len(points))
    more = {key: full.continued(values) for key, values in listed.items()} | {"knots": list(map(str, full.knots))}
    return (entry | more, full.notes) if full.notes else (entry, ())


def _surface(found: Collector, entry: Any, where: str) -> None:
    rows = entry.get("control_points", entry.get("points", ()))
    found.count(sum(len(row) for row in rows if isinstance(row, list)) if isinstance(rows, list) else 1)
    found.surfaces.append(_surface_from_data(entry, Path(found.source.name).stem or where, found.limits))


def write(splines: Sequence[Spline], numbers: NumberText) -> bytes:
    """A single curve or surface as an object, several curves as ``{"curves": […]}``, surfaces as a list; always
    exact.
    """
    entries = [
        (surface_data(s.of) if isinstance(s.of, NurbsSurface) else curve_data(s.of)) | {"name": s.name} for s in splines
    ]
    several: Any = entries if splines[0].is_surface else {"curves": entries}
    return (json.dumps(entries[0] if len(entries) == 1 else several, indent=1, ensure_ascii=False) + "\n").encode()


FORMAT = Format("json", "exactspline JSON", (".json",), looks_like, read, write, surfaces=True)
