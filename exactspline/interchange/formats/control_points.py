"""``.cpt`` and ``.cptw``, control points alone, as geomdl reads them: one point per line, coordinates separated by
commas or blanks; in ``.cptw`` they are (w x, w y, …, w).

Such a file holds neither degree nor knots. Given both it is a curve; given a degree one less than the number of points
it is a Bézier curve; otherwise the points are skipped: nothing is guessed.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import PurePath

from exactspline.interchange.collector import Collector
from exactspline.interchange.numbers import decimal
from exactspline.interchange.records import Format, Reading, Source
from exactspline.numbers.exact import mpq, rational


def looks_like(head: bytes) -> bool:
    """Rows of numbers occur in many formats: the suffix decides."""
    return False


def read(source: Source) -> Reading:
    """The curve of a file, where degree and knots are given."""
    found = Collector("cptw", source)
    rows = [line.replace(",", " ").split() for line in source.text.splitlines()]
    points = []
    for row in filter(None, rows):
        found.count(len(row))
        points.append([decimal(word, source.limits) for word in row])
    weighted = PurePath(source.name).suffix.lower() != ".cpt"
    complete(found, "control points", points, homogeneous=weighted)
    return found.reading()


def complete(
    found: Collector,
    where: str,
    points: Sequence[Sequence[mpq]],
    weights: Sequence[mpq] | None = None,
    *,
    homogeneous: bool = False,
) -> None:
    """The curve with these control points and the degree and knots that the caller gave."""
    degree, given = found.source.degree, found.source.knots
    if degree is None or (given is None and len(points) != degree + 1):
        found.skip(f"{len(points)} control points", where, "the file holds no degree and no knots: give both")
        return
    knots = [mpq(0)] * (degree + 1) + [mpq(1)] * (degree + 1) if given is None else [rational(knot) for knot in given]
    notes = ["degree and knots were given by the caller"]
    found.add("control points", where, degree, knots, points, weights, homogeneous=homogeneous, notes=notes)


FORMAT = Format("cptw", "control points alone", (".cptw", ".cpt"), looks_like, read)
