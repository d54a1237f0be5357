"""Curve files: JSON with ``degree``, ``knots``, ``control_points``, optional ``weights``, ``name``, ``source``; numbers
as ints, decimals or text.

A number in JSON is read as the decimal it shows: 0.1 is 1/10. What ``derive`` wrote is read too, where it is one curve
in one piece.
"""

from __future__ import annotations

import json
import os
import stat
from pathlib import Path
from typing import Any

from exactspline.atomic_write import write_atomically
from exactspline.errors import CurveFileError, ExactSplineError
from exactspline.exact import rational
from exactspline.splines.nurbs import Nurbs

#: Largest file read, in bytes: room for a hundred thousand control points.
MAX_BYTES = 8 * 1024 * 1024

REQUIRED = ("degree", "knots", "control_points")
OPTIONAL = ("weights", "name", "source", "note")


def read_curve(path: str | os.PathLike[str]) -> Nurbs:
    """The curve in a file.

    Raises `CurveFileError` (missing, a directory, unreadable, too large, not JSON, a field missing or unknown) or the
    error of the field at fault, the file named in front.
    """
    place = Path(path)
    try:
        status = place.stat()
        if not stat.S_ISREG(status.st_mode):
            kind = "a directory" if stat.S_ISDIR(status.st_mode) else "no regular file"
            raise CurveFileError(f"is {kind}", where=str(place), remedy="name a JSON curve file")
        if status.st_size > MAX_BYTES:
            raise CurveFileError(f"{status.st_size} bytes", where=str(place), remedy=f"at most {MAX_BYTES} are read")
        text = place.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        raise CurveFileError("is not UTF-8 text", where=str(place), remedy="a curve file is JSON") from None
    except OSError as error:
        raise CurveFileError(
            f"cannot be read ({error.strerror})",
            where=str(place),
            remedy="name a curve file, or an example curve (see `exactspline curves`)",
        ) from None
    try:
        return curve_from_text(text, place.stem)
    except ExactSplineError as error:
        raise error.at(f"{place}: ") if error.where.startswith("[") else error.at(str(place)) from None


def curve_from_text(text: str, name: str = "") -> Nurbs:
    """The curve written in JSON text; `name` where the text gives none.

    >>> curve_from_text('{"degree": 1, "knots": [0, 0, 1, 1], "control_points": [[0, 0], [0.1, "1/3"]]}')(1)
    (mpq(1,10), mpq(1,3))
    """
    data = _parsed(text)
    if not isinstance(data, dict):
        raise CurveFileError(
            "the JSON text is no object", remedy='write {"degree": …, "knots": […], "control_points": […]}'
        )
    if "pieces" in data:
        data = _one_piece(data)
    for field in REQUIRED:
        if field not in data:
            raise CurveFileError(
                f"the field {field!r} is missing",
                remedy=f"a curve has {', '.join(REQUIRED)} and may have {', '.join(OPTIONAL)}",
            )
    if unknown := sorted(set(data) - {*REQUIRED, *OPTIONAL}):
        raise CurveFileError(
            f"the field {unknown[0]!r} is unknown",
            remedy=f"a curve has {', '.join(REQUIRED)} and may have {', '.join(OPTIONAL)}",
        )
    for field in ("knots", "control_points", "weights"):
        if not isinstance(data.get(field, []), list) and not (field == "weights" and data[field] is None):
            raise CurveFileError("is no list", where=field, remedy="write a JSON list")
    degree = data["degree"]
    if isinstance(degree, _Decimal):
        degree = rational(str(degree))
        degree = int(degree) if degree.denominator == 1 else str(degree)
    return Nurbs(
        degree,
        map(_number, data["knots"]),
        (map(_number, row) if isinstance(row, list) else row for row in data["control_points"]),
        None if data.get("weights") is None else map(_number, data["weights"]),
        name=str(data.get("name") or name),
        source=str(data.get("source") or ""),
        note=str(data.get("note") or ""),
    )


def _one_piece(data: dict[str, Any]) -> dict[str, Any]:
    """The curve in what `derive` wrote: its only piece, its homogeneous control points ``(w x, w y, …, w)`` divided
    out.
    """
    pieces = data["pieces"] if isinstance(data["pieces"], list) else []
    if (
        data.get("layout")
        or len(pieces) != 1
        or not isinstance(pieces[0], dict)
        or pieces[0].get("kind") not in ("polynomial", "rational")
    ):
        raise CurveFileError(
            "is a derived object, but not one curve in one piece",
            where="pieces",
            remedy="a curve has degree, knots and control points; copy a piece",
        )
    piece = pieces[0]
    if piece.get("cut"):
        raise CurveFileError(
            "is a part of these control points that ends at an irrational parameter",
            where="pieces[0]",
            remedy="low and high tell where; a curve file can only end at a rational parameter",
        )
    curve = {"name": f"{data.get('name')} of {data.get('curve')}"} | {
        field: piece[field] for field in ("degree", "knots") if field in piece
    }
    if piece["kind"] == "polynomial":
        return curve | {field: piece[field] for field in ("control_points",) if field in piece}
    net = piece.get("homogeneous_control_points")
    if not isinstance(net, list) or not all(isinstance(row, list) and row for row in net):
        raise CurveFileError(
            "is no list of points", where="homogeneous_control_points", remedy="write (w x, w y, …, w) for each"
        )
    rows = [[rational(_number(x)) for x in row] for row in net]
    # a point of weight zero is a direction: it is kept as it stands
    points = [[str(x / (row[-1] or 1)) for x in row[:-1]] for row in rows]
    return curve | {"control_points": points, "weights": [str(row[-1]) for row in rows]}


class _Decimal(str):
    """The digits of a JSON number, kept as they stand."""


def _number(value: Any) -> Any:
    """Text for a JSON number, so that no digit is lost; everything else is left to the gate to judge."""
    return str(value) if isinstance(value, _Decimal) else value


def _parsed(text: str) -> Any:
    try:
        return json.loads(text, parse_int=_Decimal, parse_float=_Decimal, parse_constant=_refuse)
    except RecursionError:
        raise CurveFileError("brackets are nested too deep", remedy="a curve needs three levels") from None
    except json.JSONDecodeError as error:
        raise CurveFileError(
            f"is not JSON ({error.msg})",
            where=f"line {error.lineno}, column {error.colno}",
            remedy="correct the text there",
        ) from None


def _refuse(word: str) -> Any:
    raise CurveFileError(f"{word} is not a number", remedy="write finite numbers")


def curve_data(curve: Nurbs) -> dict[str, Any]:
    """The data of a curve file, numbers as exact text."""
    data: dict[str, Any] = {"name": curve.name, "source": curve.source} if curve.source else {"name": curve.name}
    data |= {
        "degree": curve.degree,
        "knots": [str(t) for t in curve.knots],
        "control_points": [[str(x) for x in row] for row in curve.control_points],
    }
    return data if curve.polynomial else data | {"weights": [str(w) for w in curve.weights]}


def write_json(path: str | os.PathLike[str], data: Any) -> None:
    """Write JSON atomically: the file is there whole or not at all."""
    text = json.dumps(data, indent=1, ensure_ascii=False) + "\n"
    write_atomically(path, lambda stream: stream.write(text.encode()))
