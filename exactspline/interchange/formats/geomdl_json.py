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
from exactspline.interchange.formats.control_points import complete
from exactspline.interchange.json_files import parsed
from exactspline.interchange.numbers import NumberText, whole
from exactspline.interchange.records import Format, NamedCurve, Reading, Source
from exactspline.interchange.writing import cartesian, cartesian_net
from exactspline.numbers.exact import mpq
from exactspline.splines.surface import NurbsSurface


def looks_like(head: bytes) -> bool:
    """Whether a file begins like one written by geomdl."""
    return head.lstrip().startswith(b"{") and bool(re.search(rb'"(?:shape|controlpoints|knotvector)"\s*:', head))


def read(source: Source) -> Reading:
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
            (_surface if surface else _curve)(collector, entry, where)
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


def _surface(collector: Collector, entry: Any, where: str) -> None:
    points, weights = _points(collector, entry)
    m, n = (whole(str(entry.get(f"degree_{side}", ""))) for side in "uv")
    knots_u, knots_v = (_row(collector, entry.get(f"knotvector_{side}")) for side in "uv")
    if entry.get("trims"):
        collector.note("trims of surfaces are not read")
    name = str(entry.get("name", "") or "")
    parts = (m, n), (knots_u, knots_v), points, weights
    collector.add_surface("surface", where, *parts, u_fastest=False, name=name)


def _points(collector: Collector, entry: Any) -> tuple[list[list[mpq]], list[mpq] | None]:
    """The control points and the weights of a shape."""
    points = entry.get("control_points")
    if not isinstance(points, dict):
        raise CurveFileError("has no control_points", remedy="geomdl writes control_points: {points, weights}")
    rows, weights = points.get("points"), points.get("weights")
    if not isinstance(rows, list):
        raise CurveFileError("has no points", where="control_points", remedy="write a list of points")
    return [_row(collector, row) for row in rows], None if weights is None else _row(collector, weights)


def _curve(collector: Collector, entry: Any, where: str) -> None:
    if not isinstance(entry, dict) or entry.get("type", "spline") not in ("spline", "curve"):
        raise CurveFileError("is not a spline curve", remedy="shapes of type curve are read")
    points, weights = _points(collector, entry)
    collector.add(
        "curve",
        where,
        whole(str(entry.get("degree", ""))),
        _row(collector, entry.get("knotvector")),
        points,
        weights,
        name=str(entry.get("name", "") or ""),
    )


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


def write(curves: Sequence[NamedCurve], numbers: NumberText) -> bytes:
    """The curves as one shape, with numbers as JSON numbers."""
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


def write_surfaces(surfaces: Sequence[NurbsSurface], numbers: NumberText) -> bytes:
    """The surfaces as one shape, with numbers as JSON numbers."""
    entries = []
    for surface in surfaces:
        net, sides = cartesian_net(surface, u_fastest=False), zip("uv", surface.degree, surface.knots, strict=True)
        rows = ", ".join(f"[{', '.join(map(numbers, point))}]" for point, _ in net)
        weights = "" if surface.polynomial else f', "weights": [{", ".join(numbers(w) for _, w in net)}]'
        parts = [
            f'"degree_{side}": {degree}, "size_{side}": {len(list(knots)) - degree - 1}, '
            f'"knotvector_{side}": [{", ".join(map(numbers, knots))}],'
            for side, degree, knots in sides
        ]
        entries.append(
            f'  {{"type": "spline", "name": {json.dumps(surface.name)}, "dimension": {surface.dimension}, '
            f'"rational": {json.dumps(not surface.polynomial)},\n   {" ".join(parts)}\n'
            f'   "control_points": {{"points": [{rows}]{weights}}}}}'
        )
    body = ",\n".join(entries)
    return f'{{"shape": {{"type": "surface", "count": {len(entries)}, "data": [\n{body}\n]}}}}\n'.encode()


FORMAT = Format("geomdl", "geomdl JSON", (".json",), looks_like, read, write, write_surfaces=write_surfaces)
