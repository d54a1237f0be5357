"""``.3dm`` by rhino3dm (the extra `3dm`), which gives the doubles of the file unrounded.

NURBS curves, lines and polylines are read, of polycurves every segment, of arcs the full circles, exactly for the
plane as written; other arcs have irrational ends. openNURBS leaves out the first and the last knot: they are put back,
and change nothing, as no point of the domain depends on them. Edges of Breps and all other objects are skipped.
"""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from exactspline.errors import CurveFileError, ExactSplineError
from exactspline.exact import from_float, mpq
from exactspline.interchange.affine import Affine
from exactspline.interchange.collector import Collector
from exactspline.interchange.numbers import NumberText
from exactspline.interchange.records import Format, NamedCurve, Reading, Source
from exactspline.interchange.segments import arc_around_origin, joined, mapped
from exactspline.interchange.writing import homogeneous, in_space


def looks_like(head: bytes) -> bool:
    """Whether a file begins as openNURBS writes it."""
    return head.startswith(b"3D Geometry File Format")


def _rhino() -> Any:
    try:
        import rhino3dm
    except ImportError:
        raise CurveFileError("rhino3dm is not installed", remedy="pip install 'exactspline[3dm]'") from None
    return rhino3dm


def read(source: Source) -> Reading:
    """The curves of a file."""
    found, rhino = Collector("3dm", source), _rhino()
    # a damaged archive raises whatever its bytes happen to hit
    try:
        model = rhino.File3dm.FromByteArray(source.data)
        objects = list(model.Objects) if model else None
    except Exception as error:
        raise CurveFileError(f"cannot be read ({type(error).__name__})", remedy="repair the file") from None
    if objects is None:
        raise CurveFileError("is no archive that can be read", remedy="repair the file")
    for number, entry in enumerate(objects, 1):
        try:
            geometry, name = entry.Geometry, str(entry.Attributes.Name or "")
        except Exception as error:
            found.skip("object", f"object {number}", f"it is damaged ({type(error).__name__})")
            continue
        _object(found, rhino, geometry, f"object {number}", name)
    return found.reading()


def _object(found: Collector, rhino: Any, geometry: Any, where: str, name: str) -> None:
    kind = type(geometry).__name__
    if isinstance(geometry, rhino.PolyCurve):
        for i in range(min(geometry.SegmentCount, found.limits.objects)):
            _object(found, rhino, geometry.SegmentCurve(i), f"{where}, segment {i + 1}", name)
        return
    try:
        if isinstance(geometry, rhino.ArcCurve):
            _circle(found, geometry, where, name)
        elif isinstance(geometry, (rhino.NurbsCurve, rhino.LineCurve, rhino.PolylineCurve)):
            _spline(found, geometry if kind == "NurbsCurve" else geometry.ToNurbsCurve(), kind, where, name)
        else:
            found.skip(kind, where, "no curve that is read")
    except ExactSplineError as error:
        found.skip(kind, where, str(error))


def _spline(found: Collector, curve: Any, kind: str, where: str, name: str) -> None:
    if curve is None:
        raise CurveFileError("has no NURBS form", remedy="repair the object")
    inner = [from_float(knot) for knot in curve.Knots]
    found.count(len(inner))
    if not inner:
        raise CurveFileError("no knots", remedy="repair the object")
    rows = [tuple(map(from_float, (p.X, p.Y, p.Z, p.W))) for p in (curve.Points[i] for i in range(len(curve.Points)))]
    knots = [inner[0], *inner, inner[-1]]
    notes = ["the first and the last knot, which openNURBS leaves out, repeat their neighbours"]
    if curve.IsRational:
        found.add(kind, where, int(curve.Degree), knots, rows, homogeneous=True, name=name, notes=notes)
    else:
        found.add(kind, where, int(curve.Degree), knots, [row[:3] for row in rows], name=name, notes=notes)


def _circle(found: Collector, arc: Any, where: str, name: str) -> None:
    if not arc.IsCompleteCircle:
        raise CurveFileError("an arc with irrational ends", remedy="store it as a NURBS curve")
    plane, radius = arc.Arc.Plane, from_float(arc.Radius)
    rows = [
        [from_float(getattr(axis, letter)) for axis in (plane.XAxis, plane.YAxis, plane.Origin)] for letter in "XYZ"
    ]
    frame = Affine([[radius * x, radius * y, centre] for x, y, centre in rows])
    one = (mpq(1), mpq(0))
    degree, knots, points = joined(mapped(arc_around_origin(one, one), frame))
    note = "a whole circle, exact for the plane as written; its angle was the parameter"
    found.add("ArcCurve", where, degree, knots, points, homogeneous=True, name=name, notes=[note])


def write(curves: Sequence[NamedCurve], numbers: NumberText) -> bytes:
    """The curves as objects of an archive of version 7; what is no double needs rounding."""
    rhino = _rhino()
    model = rhino.File3dm()
    for named in curves:
        curve, points = named.curve, in_space(named.curve)
        weights = [row[-1] for row in homogeneous(curve)]
        made = rhino.NurbsCurve(3, not curve.polynomial, curve.degree + 1, len(points))
        for i, (point, weight) in enumerate(zip(points, weights, strict=True)):
            w = mpq(1) if curve.polynomial else weight
            made.Points[i] = rhino.Point4d(*(numbers.double(x * w) for x in point), numbers.double(w))
        for i, knot in enumerate(list(curve.knots)[1:-1]):
            made.Knots[i] = numbers.double(knot)
        attributes = rhino.ObjectAttributes()
        attributes.Name = named.name
        model.Objects.AddCurve(made, attributes)
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder) / "curves.3dm"
        if not model.Write(str(place), 7):
            raise CurveFileError("rhino3dm could not write the archive", remedy="check the curves")
        return place.read_bytes()


FORMAT = Format("3dm", "openNURBS archive", (".3dm",), looks_like, read, write)
