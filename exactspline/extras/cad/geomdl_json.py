"""The JSON of geomdl (NURBS-Python): Cartesian control points and a separate list of weights.

The importer of geomdl converts every number to a float, so the text is parsed here. Older files of that project hold
only control points: they become a curve if the caller gives degree and knots.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence
from typing import Any

from exactspline.errors import CurveFileError, ExactSplineError
from exactspline.interchange.collector import Collector
from exactspline.interchange.curve_files import parsed
from exactspline.interchange.format import Format, Spline
from exactspline.interchange.formats.control_points import complete
from exactspline.interchange.numbers import NumberText, whole
from exactspline.interchange.records import Reading, Source
from exactspline.numbers.exact import mpq


def _looks_like(head: bytes) -> bool:
    """Whether a file begins like one written by geomdl."""
    return head.lstrip().startswith(b"{") and bool(re.search(rb'"(?:shape|controlpoints|knotvector)"\s*:', head))


def _read(source: Source) -> Reading:
    """The curves of a file."""
    collector = Collector("geomdl", source)
    data = parsed(source.text)
    if isinstance(data, dict) and "controlpoints" in data:
        _arrays(collector, data)
        return collector.reading()
    for number, entry in enumerate(_entries(data), 1):
        where = f"shape {number}"
        surface = isinstance(entry, dict) and "knotvector_u" in entry and "knotvector_w" not in entry
        try:
            _spline(collector, entry, where, ("_u", "_v") if surface else ("",))
        except ExactSplineError as error:
            # volumes are also shapes
            kind = entry.get("type", "curve") if isinstance(entry, dict) else "curve"
            collector.skip("shape", where, str(error), curve=not surface and kind not in ("surface", "volume"))
    return collector.reading()


def _entries(data: object) -> Iterator[Any]:
    shape = data.get("shape", data) if isinstance(data, dict) else None
    if not isinstance(shape, dict):
        raise CurveFileError("has no shape", remedy='geomdl writes {"shape": {"type": "curve", "data": […]}}')
    kind = shape.get("type", "curve")
    entries = shape.get("data", [shape])
    for entry in entries if isinstance(entries, list) else [entries]:
        yield entry if kind == "curve" or not isinstance(entry, dict) else entry | {"type": str(kind)}


def _points(collector: Collector, entry: Any) -> tuple[list[list[mpq]], list[mpq] | None]:
    """The control points and the weights of a shape."""
    points = entry.get("control_points")
    if not isinstance(points, dict):
        raise CurveFileError("has no control_points", remedy="geomdl writes control_points: {points, weights}")
    rows, weights = points.get("points"), points.get("weights")
    if not isinstance(rows, list):
        raise CurveFileError("has no points", where="control_points", remedy="write a list of points")
    return [_row(collector, row) for row in rows], None if weights is None else _row(collector, weights)


def _spline(collector: Collector, entry: Any, where: str, sides: Sequence[str]) -> None:
    """Read a shape whose parameters have these suffixes."""
    if len(sides) == 1 and (not isinstance(entry, dict) or entry.get("type", "spline") not in ("spline", "curve")):
        raise CurveFileError("is not a spline curve", remedy="shapes of type curve are read")
    points, weights = _points(collector, entry)
    degrees = [whole(str(entry.get(f"degree{side}", ""))) for side in sides]
    knots = [_row(collector, entry.get(f"knotvector{side}")) for side in sides]
    if entry.get("trims"):
        collector.note("trims of surfaces are not read")
    what, name = "curve" if len(sides) == 1 else "surface", str(entry.get("name", "") or "")
    collector.add_spline(what, where, degrees, knots, points, weights, u_fastest=False, name=name)


def _arrays(collector: Collector, data: dict[str, Any]) -> None:
    """Read the layout of 2016: ``controlpoints: {x: […], y: […]}`` and ``weights``, without degree and knots."""
    arrays = data["controlpoints"]
    if not isinstance(arrays, dict):
        raise CurveFileError("controlpoints is not an object", remedy='write {"x": […], "y": […]}')
    columns = [_row(collector, arrays[axis]) for axis in "xyz" if axis in arrays]
    if len({len(column) for column in columns}) != 1:
        raise CurveFileError("coordinates of different lengths", where="controlpoints", remedy="give one per point")
    points = [list(point) for point in zip(*columns, strict=True)]
    weights = None if data.get("weights") is None else _row(collector, data["weights"])
    complete(collector, "controlpoints", points, weights)


def _row(collector: Collector, values: Any) -> list[mpq]:
    if not isinstance(values, list):
        raise CurveFileError("a list of numbers is missing", remedy="write a JSON list")
    return collector.numbers(list(map(str, values)))


def _write(splines: Sequence[Spline], numbers: NumberText) -> bytes:
    """The curves or surfaces as one shape, with numbers as JSON numbers."""
    kind, sides = ("surface", ("_u", "_v")) if splines[0].is_surface else ("curve", ("",))
    entries = []
    for spline in splines:
        net = spline.cartesian(u_fastest=False)
        rows = ", ".join(f"[{', '.join(map(numbers, point))}]" for point, _ in net)
        weights = "" if spline.polynomial else f', "weights": [{", ".join(numbers(w) for _, w in net)}]'
        parts = [
            f'"degree{side}": {degree}, "size{side}": {count}, "knotvector{side}": [{", ".join(map(numbers, knots))}],'
            for side, degree, count, knots in zip(sides, spline.degrees, spline.counts, spline.knots, strict=True)
        ]
        entries.append(
            f'  {{"type": "spline", "name": {json.dumps(spline.name)}, "dimension": {spline.dimension}, '
            f'"rational": {json.dumps(not spline.polynomial)},\n   {" ".join(parts)}\n'
            f'   "control_points": {{"points": [{rows}]{weights}}}}}'
        )
    body = ",\n".join(entries)
    return f'{{"shape": {{"type": "{kind}", "count": {len(entries)}, "data": [\n{body}\n]}}}}\n'.encode()


FORMAT = Format("geomdl", "geomdl JSON", (".json",), _looks_like, _read, _write, surfaces=True)
