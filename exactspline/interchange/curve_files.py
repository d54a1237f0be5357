"""Curve files: JSON with ``degree``, ``knots``, ``control_points``, optional ``weights``, ``name``, ``source``; numbers
as ints, decimals or text.

A control point is a list of coordinates, or ``{"vector": [x, y]}`` for a direction (see `Direction`), whose weight is
0. A number in JSON is read as a decimal: 0.1 is 1/10. Output of ``derive`` and ``bisector`` is also read, if it is a
single curve in one piece; so is any piece copied from it, restricted to the part of the domain that belongs to the
piece.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from typing import Any

from exactspline.atomic_write import write_text
from exactspline.errors import CurveFileError, NumberError, as_path, as_text
from exactspline.interchange.json_files import (
    CURVE,
    MAX_BYTES,
    USUAL,
    check_fields,
    from_file,
    json_object,
    number_of,
    numbers_of,
    points_of,
    whole_degree,
    written_point,
)
from exactspline.interchange.limits import Limits
from exactspline.numbers.exact import mpq, rational
from exactspline.splines.bspline import BSpline
from exactspline.splines.control_points import exact_points
from exactspline.splines.given import checked_degree
from exactspline.splines.knots import KnotVector
from exactspline.splines.nurbs import Nurbs

__all__ = ["MAX_BYTES", "curve_data", "curve_from_data", "curve_from_text", "read_curve", "write_json"]


def read_curve(path: str | os.PathLike[str]) -> Nurbs:
    """The curve in a file.

    Raises `CurveFileError` (file missing, a directory, unreadable, too large, not JSON; a field missing or unknown) or
    the error for an invalid field, preceded by the name of the file.
    """
    return from_file(path, curve_from_text)


def curve_from_text(text: str, name: str = "") -> Nurbs:
    """The curve in a JSON text; `name` is used if the text gives none.

    >>> curve_from_text('{"degree": 1, "knots": [0, 0, 1, 1], "control_points": [[0, 0], [0.1, "1/3"]]}')(1)
    (mpq(1,10), mpq(1,3))
    """
    data: dict[str, Any] = json_object(
        text,
        'one curve is {"degree": …, "knots": […], "control_points": […]}; several, {"curves": […]}, are '
        "read by exactspline.interchange.files.read",
    )
    return curve_from_data(data, as_text(name, "the name of a curve"))


def curve_from_data(given: Mapping[str, object], name: str = "", limits: Limits = USUAL) -> Nurbs:
    """The curve in JSON data, with numbers as text (`exactspline.interchange.json_files.parsed`), within the limits on
    single numbers.
    """
    data: dict[str, Any] = dict(given)
    if "pieces" in data:
        data = _one_piece(data)
    if "kind" in data:
        return _curve_of_piece(data, name, limits)
    check_fields(data, CURVE)
    for field in ("knots", "control_points", "weights"):
        if not isinstance(data.get(field, []), list) and not (field == "weights" and data[field] is None):
            raise CurveFileError("is not a list", where=field, remedy="write a JSON list")
    weights = data.get("weights")
    return Nurbs(
        whole_degree(data["degree"]),
        numbers_of(data["knots"], "knots", limits),
        points_of(data["control_points"], limits=limits),
        None if weights is None else numbers_of(weights, "weights", limits),
        name=str(data.get("name") or name),
        source=str(data.get("source") or ""),
        note=str(data.get("note") or ""),
    )


def _one_piece(data: dict[str, Any]) -> dict[str, Any]:
    """The only piece in an output of `derive` or `bisector`."""
    pieces = data["pieces"] if isinstance(data["pieces"], list) else []
    curves = [p for p in pieces if isinstance(p, dict) and p.get("kind") in ("polynomial", "rational")]
    if data.get("layout") or len(pieces) != 1 or not curves:
        raise CurveFileError(
            "is a derived object, but not one curve in one piece",
            where="pieces",
            remedy="a curve has degree, knots and control points; copy a piece",
        )
    if pieces[0].get("cut"):
        raise CurveFileError(
            "is a part of these control points that ends at an irrational parameter",
            where="pieces[0]",
            remedy="see low and high; a curve file can only end at a rational parameter",
        )
    of = f" of {data['curve']}" if data.get("curve") else ""
    named: dict[str, Any] = {"name": f"{data.get('name') or data.get('kind') or 'piece'}{of}"}
    return named | curves[0]


def _curve_of_piece(piece: dict[str, Any], name: str, limits: Limits) -> Nurbs:
    """The curve of a piece, restricted to the part of the domain that belongs to the piece.

    Its homogeneous control points are ``(w x, w y, …, w)``.
    """
    if piece["kind"] not in ("polynomial", "rational"):
        raise CurveFileError(
            f"a piece of the kind {piece['kind']!r} is not a curve", where="kind", remedy="copy one that is a curve"
        )
    rational_piece = piece["kind"] == "rational"
    field = "homogeneous_control_points" if rational_piece else "control_points"
    for needed in ("degree", "knots", field):
        if needed not in piece:
            raise CurveFileError(f"the field {needed!r} is missing", remedy="copy the whole piece")
    if not isinstance(piece["knots"], list):
        raise CurveFileError("is not a list", where="knots", remedy="write a JSON list")
    net = piece[field]
    if not isinstance(net, list) or not net or not all(isinstance(row, list) and row for row in net):
        raise CurveFileError(
            "is not a list of points",
            where=field,
            remedy="write (w x, w y, …, w) for each" if rational_piece else "write (x, y, …) for each",
        )
    read = [numbers_of(row, f"{field}[{i}]", limits) for i, row in enumerate(net)]
    rows = exact_points(read, least=3 if rational_piece else 2)
    degree, knots = whole_degree(piece["degree"]), KnotVector(numbers_of(piece["knots"], "knots", limits))
    knots.check(checked_degree(degree))
    low, high = _ends(piece, knots.domain(degree), limits)
    *p, last = [BSpline(degree, knots, column).restrict(low, high) for column in zip(*rows, strict=True)]
    name = str(piece.get("name") or name)
    return Nurbs.from_splines(p, last, name=name) if rational_piece else Nurbs.from_splines([*p, last], name=name)


def _ends(piece: dict[str, Any], domain: tuple[mpq, mpq], limits: Limits) -> tuple[mpq, mpq]:
    """The parameters where a piece begins and ends: ``low`` and ``high``, else ``interval``, else from its knots."""
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
    if end.get("parameter") is None:
        raise CurveFileError(
            f"the piece ends at an irrational parameter (in {end.get('interval')})",
            where=key,
            remedy="no curve with rational knots ends there; write a rational parameter inside the piece",
        )
    return _rational(end["parameter"], key, limits)


def _rational(value: object, key: str, limits: Limits) -> mpq:
    number = number_of(value, key, limits)
    try:
        return rational(number)
    except NumberError as error:
        raise error.at(key) from None


def curve_data(curve: Nurbs) -> dict[str, object]:
    """The data of a curve file, with numbers as exact text."""
    data: dict[str, object] = {"name": curve.name, "source": curve.source} if curve.source else {"name": curve.name}
    data |= {
        "degree": curve.degree,
        "knots": [str(t) for t in curve.knots],
        "control_points": [written_point(point) for point in curve.control_points],
    }
    if curve.note:
        data["note"] = curve.note
    return data if curve.polynomial else data | {"weights": [str(w) for w in curve.weights]}


def write_json(path: str | os.PathLike[str], data: object) -> None:
    """Write JSON atomically: either the whole file is written or nothing."""
    text = json.dumps(data, indent=1, ensure_ascii=False) + "\n"
    write_text(as_path(path), text)
