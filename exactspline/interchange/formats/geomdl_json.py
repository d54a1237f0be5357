"""The JSON of geomdl (NURBS-Python): Cartesian control points and weights beside them.

geomdl's own importer passes every number through a float, so the text is parsed here. Older files of the project hold
control points alone: they become a curve where degree and knots are given by the caller.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence
from typing import Any

from exactspline.errors import CurveFileError, ExactSplineError
from exactspline.interchange.collector import Collector
from exactspline.interchange.formats.control_points import complete
from exactspline.interchange.json_files import parsed
from exactspline.interchange.numbers import NumberText, decimal, whole
from exactspline.interchange.records import Format, NamedCurve, Reading, Source
from exactspline.interchange.writing import cartesian
from exactspline.numbers.exact import mpq


def looks_like(head: bytes) -> bool:
    """Whether a file begins as geomdl writes it."""
    return head.lstrip().startswith(b"{") and bool(re.search(rb'"(?:shape|controlpoints|knotvector)"\s*:', head))


def read(source: Source) -> Reading:
    """The curves of a file."""
    found = Collector("geomdl", source)
    data = parsed(source.text)
    if isinstance(data, dict) and "controlpoints" in data:
        _arrays(found, data)
        return found.reading()
    for number, entry in enumerate(_entries(data), 1):
        where = f"shape {number}"
        try:
            _curve(found, entry, where)
        except ExactSplineError as error:
            # surfaces and volumes are shapes too
            kind = entry.get("type", "curve") if isinstance(entry, dict) else "curve"
            found.skip("shape", where, str(error), curve=kind not in ("surface", "volume"))
    return found.reading()


def _entries(data: object) -> Iterator[Any]:
    shape = data.get("shape", data) if isinstance(data, dict) else None
    if not isinstance(shape, dict):
        raise CurveFileError("has no shape", remedy='geomdl writes {"shape": {"type": "curve", "data": […]}}')
    kind = shape.get("type", "curve")
    entries = shape.get("data", [shape])
    for entry in entries if isinstance(entries, list) else [entries]:
        yield entry if kind == "curve" or not isinstance(entry, dict) else entry | {"type": str(kind)}


def _curve(found: Collector, entry: Any, where: str) -> None:
    if not isinstance(entry, dict) or entry.get("type", "spline") not in ("spline", "curve"):
        raise CurveFileError("no spline curve", remedy="shapes of the type curve are read")
    points = entry.get("control_points")
    if not isinstance(points, dict):
        raise CurveFileError("has no control_points", remedy="geomdl writes control_points: {points, weights}")
    knots = _row(found, entry.get("knotvector"))
    rows = points.get("points")
    if not isinstance(rows, list):
        raise CurveFileError("has no points", where="control_points", remedy="write a list of points")
    weights = points.get("weights")
    found.add(
        "curve",
        where,
        whole(str(entry.get("degree", ""))),
        knots,
        [_row(found, row) for row in rows],
        None if weights is None else _row(found, weights),
        name=str(entry.get("name", "") or ""),
    )


def _arrays(found: Collector, data: dict[str, Any]) -> None:
    """The file of 2016: ``controlpoints: {x: […], y: […]}`` and ``weights``, without degree and knots."""
    arrays = data["controlpoints"]
    if not isinstance(arrays, dict):
        raise CurveFileError("controlpoints is not an object", remedy='write {"x": […], "y": […]}')
    columns = [_row(found, arrays[axis]) for axis in "xyz" if axis in arrays]
    if len({len(column) for column in columns}) != 1:
        raise CurveFileError("coordinates of different lengths", where="controlpoints", remedy="give one per point")
    points = [list(point) for point in zip(*columns, strict=True)]
    weights = None if data.get("weights") is None else _row(found, data["weights"])
    complete(found, "controlpoints", points, weights)


def _row(found: Collector, values: Any) -> list[mpq]:
    if not isinstance(values, list):
        raise CurveFileError("a list of numbers is missing", remedy="write a JSON list")
    found.count(len(values))
    return [decimal(str(value), found.limits) for value in values]


def write(curves: Sequence[NamedCurve], numbers: NumberText) -> bytes:
    """The curves as one shape; numbers as JSON numbers."""
    entries = []
    for named in curves:
        curve = named.curve
        rows = ", ".join(f"[{', '.join(map(numbers, point))}]" for point in cartesian(curve))
        weights = "" if curve.polynomial else f', "weights": [{", ".join(map(numbers, curve.weights))}]'
        entries.append(
            f'  {{"type": "spline", "name": {json.dumps(named.name)}, "degree": {curve.degree}, '
            f'"dimension": {curve.dimension}, "rational": {json.dumps(not curve.polynomial)},\n'
            f'   "knotvector": [{", ".join(map(numbers, curve.knots))}],\n'
            f'   "control_points": {{"points": [{rows}]{weights}}}}}'
        )
    body = ",\n".join(entries)
    return f'{{"shape": {{"type": "curve", "count": {len(entries)}, "data": [\n{body}\n]}}}}\n'.encode()


FORMAT = Format("geomdl", "geomdl JSON", (".json",), looks_like, read, write)
