"""``.cpt`` and ``.cptw``, files of control points only, as geomdl reads them: one point per line, coordinates separated
by commas or blanks; in ``.cptw`` they are (w x, w y, …, w).

Such a file holds neither degree nor knots. If the caller gives both, it is read as a B-spline curve; if the caller
gives only a degree, one less than the number of points, as a Bézier curve; otherwise the points are skipped.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import PurePath

from exactspline.errors import counted
from exactspline.interchange.collector import Collector
from exactspline.interchange.format import Format
from exactspline.interchange.records import Reading, Source
from exactspline.interchange.segments import bezier_knots
from exactspline.numbers.exact import mpq, rational


def _looks_like(head: bytes) -> bool:
    """Always False: rows of numbers occur in many formats, so that only the suffix can decide."""
    return False


def read(source: Source) -> Reading:
    """The curve of a file, if degree and knots are given."""
    collector = Collector("cptw", source)
    rows = [line.replace(",", " ").split() for line in source.text.splitlines()]
    points = [collector.numbers(row) for row in rows if row]
    complete(collector, "control points", points, homogeneous=PurePath(source.name).suffix.lower() != ".cpt")
    return collector.reading()


def complete(
    collector: Collector,
    where: str,
    points: Sequence[Sequence[mpq]],
    weights: Sequence[mpq] | None = None,
    *,
    homogeneous: bool = False,
) -> None:
    """Add the curve with these control points and with the degree and knots that the caller gave."""
    degree, given = collector.source.degree, collector.source.knots
    if degree is None or (given is None and len(points) != degree + 1):
        why = "the file holds no degree and no knots; give both, as `convert` takes them: --degree 3 --knots 0,0,0,0,…"
        collector.skip(counted(len(points), "control point"), where, why)
        return
    knots = bezier_knots(degree) if given is None else [rational(knot) for knot in given]
    notes = ["degree and knots were given by the caller"]
    collector.add("control points", where, degree, knots, points, weights, homogeneous=homogeneous, notes=notes)


FORMAT = Format("cptw", "control points only", (".cptw", ".cpt"), _looks_like, read)
