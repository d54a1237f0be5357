"""``.3dm`` files, read with rhino3dm (the extra `formats`) in a separate process; it returns the doubles of the file
unchanged.

NURBS curves, lines, polylines and every segment of a polycurve are read. Of arcs only full circles are read, exact for
the plane as written; the ends of other arcs are irrational in general. openNURBS omits the first and the last knot;
they are added again with arbitrary values, since no point of the domain depends on them. Surfaces are read where they
are NURBS in the file, also those under the faces of a Brep, as wholes: trims, edges of Breps and all other objects are
skipped. Copies of block definitions are not placed: their curves are read as the block defines them, with a
note.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from exactspline.errors import CurveFileError
from exactspline.interchange.affine import Affine
from exactspline.interchange.collector import Collector
from exactspline.interchange.numbers import NumberText
from exactspline.interchange.records import Format, NamedCurve, Reading, Source
from exactspline.interchange.segments import ellipse
from exactspline.interchange.writing import cartesian_net, homogeneous, in_space
from exactspline.numbers.exact import mpq, rational
from exactspline.splines.surface import NurbsSurface

#: Time limit for reading one archive, in seconds.
SECONDS = 30
#: Objects that are curves or place curves.
CURVES = ("InstanceReference", "Curve", "PolyCurve", "ArcCurve", "LineCurve", "PolylineCurve", "NurbsCurve")
MISSING = "the first and last knots, which openNURBS omits, repeat their neighbours"


def looks_like(head: bytes) -> bool:
    """Whether the file begins with the header of openNURBS."""
    return head.startswith(b"3D Geometry File Format")


def _rhino() -> Any:
    try:
        import rhino3dm
    except ImportError:
        raise CurveFileError("rhino3dm is not installed", remedy="pip install rhino3dm") from None
    return rhino3dm


def read(source: Source) -> Reading:
    """The curves and surfaces of a file."""
    collector = Collector("3dm", source)
    _rhino()
    for entry in _entries(source):
        if "unit" in entry:
            collector.note(f"lengths in {entry['unit']}: read as written")
            continue
        where, kind = entry["where"], entry["kind"]
        with collector.skipping(kind, where, curve="degrees" not in entry):
            if "degrees" in entry:
                _surface(collector, entry)
            elif "plane" in entry:
                _circle(collector, entry)
            elif "points" in entry:
                _spline(collector, entry)
            else:
                collector.skip(kind, where, "this type of object is not read", curve=kind in CURVES)
    return collector.reading()


def _entries(source: Source) -> list[dict[str, Any]]:
    """The objects that rhino3dm reads from the archive, in a separate process."""
    command = [sys.executable, "-m", "exactspline.interchange.rhino_process"]
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    try:
        done = subprocess.run(
            command, input=source.data, capture_output=True, timeout=SECONDS, check=True, env=environment
        )
        entries: list[dict[str, Any]] = json.loads(done.stdout)
    except subprocess.TimeoutExpired:
        raise CurveFileError(f"takes rhino3dm more than {SECONDS} seconds", remedy="repair the file") from None
    except (subprocess.CalledProcessError, ValueError):
        raise CurveFileError("is not an archive readable by rhino3dm", remedy="repair the file") from None
    return entries


def _surface(collector: Collector, entry: dict[str, Any]) -> None:
    u, v = ([rational(knot) for knot in knots] for knots in entry["knots"])
    if not u or not v:
        raise CurveFileError("no knots", remedy="repair the object")
    rows, homogeneous_points = [[rational(x) for x in row] for row in entry["points"]], entry["rational"]
    points = rows if homogeneous_points else [row[:3] for row in rows]
    m, n = entry["degrees"]
    collector.add_surface(
        entry["kind"], entry["where"], (m, n), ([u[0], *u, u[-1]], [v[0], *v, v[-1]]), points,
        homogeneous=homogeneous_points, u_fastest=False, name=entry["name"],
    )  # fmt: skip
    collector.note(MISSING)
    if entry.get("trimmed"):
        collector.note("trims are not read, surfaces are read as wholes: Brep")
    for note in entry["notes"]:
        collector.note(f"{entry['where']}: {note}")


def _spline(collector: Collector, entry: dict[str, Any]) -> None:
    inner, rows = [rational(knot) for knot in entry["knots"]], [[rational(x) for x in row] for row in entry["points"]]
    if not inner:
        raise CurveFileError("no knots", remedy="repair the object")
    knots, notes = [inner[0], *inner, inner[-1]], [MISSING, *entry["notes"]]
    kind, where, name, homogeneous_points = entry["kind"], entry["where"], entry["name"], entry["rational"]
    points = rows if homogeneous_points else [row[:3] for row in rows]
    degree = entry["degree"]
    collector.add(kind, where, degree, knots, points, homogeneous=homogeneous_points, name=name, notes=notes)


def _circle(collector: Collector, entry: dict[str, Any]) -> None:
    if not entry["complete"]:
        raise CurveFileError("an arc with irrational ends", remedy="store it as a NURBS curve")
    [radius] = map(rational, entry["radius"])
    rows = [map(rational, row) for row in entry["plane"]]
    frame = Affine([[radius * x, radius * y, centre] for x, y, centre in zip(*rows, strict=True)])
    note = "a full circle, exact for the plane as written; its parameter was the angle"
    collector.add_segments("ArcCurve", entry["where"], ellipse(frame), entry["name"], [note, *entry["notes"]])


def write(curves: Sequence[NamedCurve], numbers: NumberText) -> bytes:
    """The curves as objects of a version 7 archive; numbers that are not doubles require rounding."""
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
        model.Objects.AddCurve(made, _named(rhino, named.name))
    return _archive(model)


def write_surfaces(surfaces: Sequence[NurbsSurface], numbers: NumberText) -> bytes:
    """The surfaces as objects of a version 7 archive, a map of the plane at z = 0; numbers that are not doubles require
    rounding.
    """
    rhino = _rhino()
    model = rhino.File3dm()
    for surface in surfaces:
        rational_net, (m, n) = not surface.polynomial, surface.degree
        counts = len(surface.control_points), len(surface.control_points[0])
        made = rhino.NurbsSurface.Create(3, rational_net, m + 1, n + 1, *counts)
        for k, (point, weight) in enumerate(cartesian_net(surface, u_fastest=False)):
            w = weight if rational_net else mpq(1)
            row = [numbers.double(x * w) for x in (*point, mpq(0))[:3]]
            made.Points[divmod(k, counts[1])] = rhino.Point4d(*row, numbers.double(w))
        for held, knots in zip((made.KnotsU, made.KnotsV), surface.knots, strict=True):
            for i, knot in enumerate(list(knots)[1:-1]):
                held[i] = numbers.double(knot)
        model.Objects.AddSurface(made, _named(rhino, surface.name))
    return _archive(model)


def _named(rhino: Any, name: str) -> Any:
    attributes = rhino.ObjectAttributes()
    attributes.Name = name
    return attributes


def _archive(model: Any) -> bytes:
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder) / "written.3dm"
        if not model.Write(str(place), 7):
            raise CurveFileError("rhino3dm could not write the archive", remedy="check the curves")
        return place.read_bytes()


FORMAT = Format("3dm", "openNURBS archive", (".3dm",), looks_like, read, write, write_surfaces=write_surfaces)
