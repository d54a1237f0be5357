"""``.3dm`` files, read with rhino3dm (the extra `formats`) in a separate process; it returns the doubles of the file
unchanged.

NURBS curves, lines, polylines and every segment of a polycurve are read, and full circles, exact for the plane as
written. The ends of other arcs are irrational in general: they are moved along the circle if an error is allowed.
openNURBS omits the first and the last knot; they are added again with arbitrary values, since no point of the domain
depends on them. Surfaces that are NURBS in the file are read as wholes, also those under the faces of a Brep; trims,
edges of Breps and all other objects are skipped. Copies of block definitions are not placed: their curves are read as
the block defines them, with a note.
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

from exactspline.errors import CurveFileError, counted
from exactspline.interchange.collector import UNREAD, Collector
from exactspline.interchange.format import Format, Spline
from exactspline.interchange.numbers import NumberText
from exactspline.interchange.records import LARGER, Reading, Source
from exactspline.interchange.segments import RADIANS, RIGHT, Affine, Round
from exactspline.numbers.exact import mpq, rational
from exactspline.system import LIMITS, OUT_OF_TIME

#: The ratio of elapsed time to processor time that a process may take; it is large, since most processes end before.
WAITING = 60 if LIMITS else 5
#: Objects that are curves or place curves.
CURVES = ("InstanceReference", "Curve", "PolyCurve", "ArcCurve", "LineCurve", "PolylineCurve", "NurbsCurve")
MISSING = "the first and last knots, which openNURBS omits, repeat their neighbours"


def _looks_like(head: bytes) -> bool:
    """Whether the file begins with the header of openNURBS."""
    return head.startswith(b"3D Geometry File Format")


def _rhino() -> Any:
    try:
        import rhino3dm
    except ImportError:
        raise CurveFileError("rhino3dm is not installed", remedy="pip install rhino3dm") from None
    return rhino3dm


def _read(source: Source) -> Reading:
    """The curves and surfaces of a file."""
    collector = Collector("3dm", source)
    _rhino()
    for entry in _entries(source):
        if "unit" in entry:
            collector.unit(entry["unit"])
            continue
        where, kind = entry["where"], entry["kind"]
        with collector.skipping(kind, where, curve=len(entry.get("degrees", ())) < 2):
            if "degrees" in entry:
                _spline(collector, entry)
            elif "plane" in entry:
                _arc(collector, entry)
            else:
                collector.skip(
                    kind, where, UNREAD if kind in (*CURVES, "Brep") else "not a curve", curve=kind in CURVES
                )
    return collector.reading()


def _entries(source: Source) -> list[dict[str, Any]]:
    """The objects that rhino3dm reads from the archive, in a separate process, since reading a damaged archive may
    never end. The limit is on processor time, so that it does not depend on other processes. A process that waits is
    ended after `WAITING` times this time, and so is every process on a system without such limits.
    """
    seconds = source.limits.seconds * (1 + (len(source.data) >> 20))
    command = [sys.executable, "-m", "exactspline.extras.cad.rhino_process", str(seconds)]
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    try:
        done = subprocess.run(
            command, input=source.data, capture_output=True, timeout=WAITING * seconds, check=True, env=environment
        )
        entries: list[dict[str, Any]] = json.loads(done.stdout)
    except (subprocess.SubprocessError, ValueError) as error:
        if isinstance(error, subprocess.TimeoutExpired) or getattr(error, "returncode", 0) == OUT_OF_TIME:
            clock = f", or {WAITING * seconds} by the clock" * isinstance(error, subprocess.TimeoutExpired)
            problem = f"takes rhino3dm more than {counted(seconds, 'second')} of processor time{clock}"
            raise CurveFileError(problem, remedy=f"repair the file; {LARGER}") from None
        raise CurveFileError("is not an archive readable by rhino3dm", remedy="repair the file") from None
    return entries


def _spline(collector: Collector, entry: dict[str, Any]) -> None:
    inner = [[rational(knot) for knot in knots] for knots in entry["knots"]]
    if not all(inner):
        raise CurveFileError("no knots", remedy="repair the object")
    rows, homogeneous_points = [[rational(x) for x in row] for row in entry["points"]], entry["rational"]
    points = rows if homogeneous_points else [row[:3] for row in rows]
    knots = [[vector[0], *vector, vector[-1]] for vector in inner]
    more: dict[str, Any] = {"homogeneous": homogeneous_points, "name": entry["name"], "notes": entry["notes"]}
    collector.add_spline(entry["kind"], entry["where"], entry["degrees"], knots, points, u_fastest=False, **more)
    collector.note(MISSING)
    if entry.get("trimmed"):
        collector.note("trims are not read, surfaces are read as wholes: Brep")


def _arc(collector: Collector, entry: dict[str, Any]) -> None:
    [radius] = map(rational, entry["radius"])
    rows = [map(rational, row) for row in entry["plane"]]
    frame = Affine([[radius * x, radius * y, centre] for x, y, centre in zip(*rows, strict=True)])
    curve = Round(frame, collector.source.within)
    ends = [RIGHT[0]] * 2 if entry["complete"] else [curve.at_angle(rational(a), RADIANS) for a in entry["angles"]]
    notes = ["exact for the plane as written; its parameter was the angle", *curve.notes, *entry["notes"]]
    collector.add_segments("ArcCurve", entry["where"], curve.arc(*ends), entry["name"], notes)


def _write(splines: Sequence[Spline], numbers: NumberText) -> bytes:
    """The curves or surfaces as objects of a version 7 archive, plane ones at z = 0. Numbers that are not doubles
    require rounding.
    """
    rhino = _rhino()
    model = rhino.File3dm()
    for spline in splines:
        points, counts = spline.in_space(u_fastest=False), spline.counts
        sizes = not spline.polynomial, *(degree + 1 for degree in spline.degrees), *counts
        made = (rhino.NurbsSurface.Create if spline.is_surface else rhino.NurbsCurve)(3, *sizes)
        for k, (point, weight) in enumerate(points):
            w = mpq(1) if spline.polynomial else weight
            place = divmod(k, counts[1]) if spline.is_surface else k
            made.Points[place] = rhino.Point4d(*(numbers.double(x * w) for x in point), numbers.double(w))
        held = (made.KnotsU, made.KnotsV) if spline.is_surface else (made.Knots,)
        for entries, knots in zip(held, spline.knots, strict=True):
            for i, knot in enumerate(list(knots)[1:-1]):
                entries[i] = numbers.double(knot)
        add = model.Objects.AddSurface if spline.is_surface else model.Objects.AddCurve
        add(made, _named(rhino, spline.name))
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


FORMAT = Format("3dm", "openNURBS archive", (".3dm",), _looks_like, _read, _write, surfaces=True)
