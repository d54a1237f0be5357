"""Surface files: JSON with ``degree``, ``knots``, ``control_points``, optional ``weights``, ``name``, ``source``,
``note``.

``degree`` is ``[m, n]``, ``knots`` two lists, ``control_points`` (or ``points``) a net of rows in the direction of u,
``weights`` a net of the same shape. Numbers and points are written as in curve files.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

from exactspline.errors import CurveFileError, ExactSplineError, counted
from exactspline.interchange.json_files import (
    SURFACE,
    USUAL,
    check_fields,
    from_file,
    json_object,
    numbers_of,
    points_of,
    whole_degree,
    written_point,
)
from exactspline.interchange.limits import Limits
from exactspline.numbers.exact import Number
from exactspline.splines.surface import NurbsSurface

#: An alternative name for ``control_points``.
NET = "points"


def read_surface(path: str | os.PathLike[str]) -> NurbsSurface:
    """The surface in a file.

    Raises `CurveFileError` (file missing, a directory, unreadable, too large, not JSON; a field missing or unknown) or
    the error for an invalid field, preceded by the name of the file.
    """
    return from_file(path, surface_from_text)


def surface_from_text(text: str, name: str = "") -> NurbsSurface:
    """The surface in a JSON text; `name` is used if the text gives none.

    >>> surface_from_text('''{"degree": [1, 1], "knots": [[0, 0, 1, 1], [0, 0, 1, 1]],
    ...     "control_points": [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0.1]]]}''')(1, 1)
    (mpq(1,1), mpq(1,1), mpq(1,10))
    """
    remedy = 'write {"degree": [m, n], "knots": [[…], […]], "control_points": [[…], …]}'
    return surface_from_data(json_object(text, remedy), name)


def surface_from_data(given: Mapping[str, object], name: str = "", limits: Limits = USUAL) -> NurbsSurface:
    """The surface in JSON data, with numbers as text (`exactspline.interchange.json_files.parsed`), within the limits
    on single numbers.
    """
    data = dict(given)
    if NET in data and "control_points" not in data:
        data["control_points"] = data.pop(NET)
    check_fields(data, SURFACE)
    degree = [whole_degree(n) for n in _list(data["degree"], "degree", 2)]
    knots = [_list(row, f"knots[{i}]") for i, row in enumerate(_list(data["knots"], "knots", 2))]
    net = []
    for i, row in enumerate(_list(data["control_points"], "control_points")):
        place = f"control_points[{i}]"
        net.append(points_of(_list(row, place), place, limits))
    weights = data.get("weights")
    return NurbsSurface(
        (degree[0], degree[1]),
        numbers_of(knots[0], "knots[0]", limits),
        numbers_of(knots[1], "knots[1]", limits),
        net,
        None if weights is None else _numbers(weights, limits),
        name=str(data.get("name") or name),
        source=str(data.get("source") or ""),
        note=str(data.get("note") or ""),
    )


def looks_like_surface(text: str) -> bool:
    """Whether a JSON text describes a surface: an object whose degree is a list.

    >>> looks_like_surface('{"degree": [1, 1]}'), looks_like_surface('{"degree": 2}'), looks_like_surface("{")
    (True, False, False)
    """
    try:
        return isinstance(json_object(text, "").get("degree"), list)
    except ExactSplineError:
        return False


def _list(value: Any, where: str, count: int | None = None) -> list[Any]:
    if not isinstance(value, list):
        raise CurveFileError("is not a list", where=where, remedy="write a JSON list")
    if count is not None and len(value) != count:
        raise CurveFileError(f"has {counted(len(value), 'entry')}", where=where, remedy="one for u and one for v")
    return value


def _numbers(rows: object, limits: Limits) -> list[list[Number]]:
    listed = ((f"weights[{i}]", row) for i, row in enumerate(_list(rows, "weights")))
    return [numbers_of(_list(row, place), place, limits) for place, row in listed]


def surface_data(surface: NurbsSurface) -> dict[str, object]:
    """The data of a surface file, with numbers as exact text."""
    data: dict[str, object] = {"name": surface.name}
    if surface.source:
        data["source"] = surface.source
    data |= {
        "degree": list(surface.degree),
        "knots": [[str(t) for t in knots] for knots in surface.knots],
        "control_points": [[written_point(point) for point in row] for row in surface.control_points],
    }
    if surface.note:
        data["note"] = surface.note
    return data if surface.polynomial else data | {"weights": [[str(w) for w in row] for row in surface.weights]}
