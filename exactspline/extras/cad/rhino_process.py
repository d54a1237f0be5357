"""The contents of an archive as read by rhino3dm, written as JSON to standard output. This runs as a separate process,
because on a damaged archive the library may crash, use gigabytes of memory, or not terminate.

Doubles are written as C99 hexadecimal floats, exactly.
"""

from __future__ import annotations

import json
import sys
from math import ceil
from time import process_time
from typing import Any

from exactspline.system import limit

#: Memory limit of the process in bytes.
MEMORY = 2 << 30


def _hex(*values: float) -> list[str]:
    return [float(value).hex() for value in values]


def _described(rhino: Any, geometry: Any, where: str, name: str, notes: list[str]) -> list[dict[str, Any]]:
    entry: dict[str, Any] = {"kind": type(geometry).__name__, "where": where, "name": name, "notes": notes}
    if isinstance(geometry, rhino.PolyCurve):
        segments = [(i, geometry.SegmentCurve(i)) for i in range(geometry.SegmentCount)]
        inside = [_described(rhino, part, f"{where}, segment {i + 1}", name, notes) for i, part in segments]
        return [row for rows in inside for row in rows]
    if isinstance(geometry, rhino.ArcCurve):
        plane = geometry.Arc.Plane
        vectors = [_hex(v.X, v.Y, v.Z) for v in (plane.XAxis, plane.YAxis, plane.Origin)]
        found = {"radius": _hex(geometry.Radius), "plane": vectors, "complete": bool(geometry.IsCompleteCircle)}
        return [entry | found | {"angles": _hex(geometry.Arc.StartAngle, geometry.Arc.EndAngle)}]
    if isinstance(geometry, rhino.NurbsSurface):
        return [entry | _net(geometry)]
    if isinstance(geometry, rhino.Brep):
        under = [(i, geometry.Surfaces[i]) for i in range(len(geometry.Surfaces))]
        nets = [(i, surface) for i, surface in under if isinstance(surface, rhino.NurbsSurface)]
        held = entry | {"kind": "NurbsSurface", "trimmed": True}
        return [*(held | {"where": f"{where}, surface {i + 1}"} | _net(surface) for i, surface in nets), entry]
    if not isinstance(geometry, (rhino.NurbsCurve, rhino.LineCurve, rhino.PolylineCurve)):
        return [entry]
    curve = geometry if isinstance(geometry, rhino.NurbsCurve) else geometry.ToNurbsCurve()
    if curve is None:
        return [entry]
    points = [curve.Points[i] for i in range(len(curve.Points))]
    return [entry | _held([int(curve.Degree)], [curve.Knots], points, curve.IsRational)]


def _net(surface: Any) -> dict[str, Any]:
    """A surface: two degrees, two knot vectors, the control points along v first."""
    grid = [(i, j) for i in range(surface.Points.CountU) for j in range(surface.Points.CountV)]
    points = [surface.Points.GetControlPoint(i, j) for i, j in grid]
    degrees = [int(surface.OrderU) - 1, int(surface.OrderV) - 1]
    return _held(degrees, [surface.KnotsU, surface.KnotsV], points, surface.IsRational)


def _held(degrees: list[int], knots: list[Any], points: list[Any], rational: bool) -> dict[str, Any]:
    rows = [_hex(p.X, p.Y, p.Z, p.W) for p in points]
    return {"degrees": degrees, "rational": bool(rational), "knots": [_hex(*each) for each in knots], "points": rows}


def entries(data: bytes, seconds: int) -> list[dict[str, object]]:
    """The contents of an archive. First the memory of this process and its further processor time are limited, so that
    it ends even if the parent process was killed.
    """
    import rhino3dm

    limit(MEMORY, seconds + ceil(process_time()))
    model = rhino3dm.File3dm.FromByteArray(data)
    rows: list[dict[str, object]] = [{"unit": str(model.Settings.ModelUnitSystem).rpartition(".")[2].lower()}]
    for number, entry in enumerate(model.Objects, 1):
        attributes, notes = entry.Attributes, []
        if attributes.Mode == rhino3dm.ObjectMode.InstanceDefinitionObject:
            notes.append("read as its block defines it; copies are not placed")
        elif not attributes.Visible:
            notes.append("marked invisible")
        rows += _described(rhino3dm, entry.Geometry, f"object {number}", str(attributes.Name or ""), notes)
    return rows


def main() -> None:
    """Read an archive from standard input, for at most this many seconds."""
    json.dump(entries(sys.stdin.buffer.read(), int(sys.argv[1])), sys.stdout)


if __name__ == "__main__":
    main()
