"""Open CASCADE BRep text: the sections ``Curve2ds`` and ``Curves``.

B-spline and Bézier curves are read. Circles and ellipses are read as full curves, exact for the axes as written. Lines,
parabolas and hyperbolas are unbounded in this section (edges bound them) and are skipped. A trimmed curve is the part
of its basis between its parameters: of splines, lines and parabolas exactly, of circles and ellipses where these are
multiples of a right angle, or where an error is allowed. Of an offset curve the basis alone is read. For a periodic
curve the first poles are repeated and the knots extended by the period. Edges, which may use a part of a curve, and
placements are ignored; a note states this.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from exactspline.errors import CurveFileError
from exactspline.interchange.affine import Affine
from exactspline.interchange.arcs import RADIANS, RIGHT, Round
from exactspline.interchange.collector import Collector
from exactspline.interchange.format import Format
from exactspline.interchange.numbers import NumberText, finite_double
from exactspline.interchange.periods import domain, used
from exactspline.interchange.records import Reading, Source
from exactspline.interchange.segments import Segment, bezier_knots, polynomial
from exactspline.interchange.tokens import Tokens
from exactspline.interchange.writing import Spline
from exactspline.numbers.exact import mpq
from exactspline.splines.nurbs import Nurbs

LINE, CIRCLE, ELLIPSE, PARABOLA, HYPERBOLA, BEZIER, BSPLINE, TRIMMED, OFFSET = range(1, 10)
#: What has no control points: its name, its axes, and its sizes.
SHAPES = {
    LINE: ("line", 1, 0),
    CIRCLE: ("circle", 2, 1),
    ELLIPSE: ("ellipse", 2, 2),
    PARABOLA: ("parabola", 2, 1),
    HYPERBOLA: ("hyperbola", 2, 2),
}
EXACT, BASIS = "exact for the axes as written", " (basis)"
_EDGE = re.compile(r"^Ed[ \t]*\r?$", re.M)
_SECTION = re.compile(r"^(Curve2ds|Curves) (\d{1,9})[ \t]*\r?$", re.M)


def looks_like(head: bytes) -> bool:
    """Whether the file begins with a header of Open CASCADE."""
    return b"CASCADE Topology V" in head


def read(source: Source) -> Reading:
    """The curves of both sections."""
    collector = Collector("brep", source)
    if _EDGE.search(source.text):
        collector.note("curves are read as defined: edges may use only a part of them, or be placed elsewhere")
    sections = list(_SECTION.finditer(source.text))
    for title in sorted({"Curve2ds", "Curves"} - {match[1] for match in sections}):
        collector.note(f"there is no section {title}: the file may be cut off")
    for match in sections:
        words = Tokens(source.text, source.limits, match.end())
        dimension = 2 if match[1] == "Curve2ds" else 3
        for number in range(1, int(match[2]) + 1):
            _curve(collector, words, dimension, f"{match[1]} {number}")
    return collector.reading()


def _curve(collector: Collector, words: Tokens, dimension: int, where: str) -> None:
    """Read one curve, or the part of it that a trimmed curve uses; of an offset its basis, over the same parameters."""
    trim: list[mpq] = []
    while (kind := words.whole()) in (TRIMMED, OFFSET):
        numbers = words.numbers(2 if kind == TRIMMED else 1 + (dimension == 3) * 3)
        if kind == OFFSET:
            collector.skip("offset curve", where, "only its basis curve is read; write it as a spline")
        else:
            trim = trim or numbers
        where = where.removesuffix(BASIS) + BASIS * (kind == OFFSET)
    if kind in (BEZIER, BSPLINE):
        (_bezier if kind == BEZIER else _spline)(collector, words, dimension, where, trim)
    elif kind not in SHAPES:
        raise CurveFileError(f"a curve of kind {kind}", where=where, remedy="kinds 1 to 9 are known")
    else:
        name, axes, sizes = SHAPES[kind]
        vectors = words.rows(1 + axes + (dimension == 3 and axes > 1), dimension)
        # of a conic in space the second vector is its normal
        frame = [vectors[0], *vectors[-axes:]]
        numbers = words.numbers(sizes)
        if not trim and kind not in (CIRCLE, ELLIPSE):
            collector.skip(name, where, "it is unbounded; write its part as a spline", curve=kind != LINE)
            return
        with collector.skipping(name, where):
            segments, notes = _part(kind, frame, numbers, trim, collector.source.within)
            collector.add_segments(name, where, segments, notes=notes)


def _part(
    kind: int, frame: Sequence[Sequence[mpq]], sizes: Sequence[mpq], trim: Sequence[mpq], within: mpq | None
) -> tuple[list[Segment], list[str]]:
    """The part of a line or a conic between two parameters, or a full ellipse, and notes on it."""
    columns = list(zip(*frame, strict=True))
    if kind == LINE:
        return [polynomial(*([p + t * x for p, x in columns] for t in trim))], []
    if kind == PARABOLA and sizes[0] > 0:
        u, v = trim
        pairs = ((u * u, u), (u * v, (u + v) / 2), (v * v, v))
        return [polynomial(*([p + a * x / (4 * sizes[0]) + b * y for p, x, y in columns] for a, b in pairs))], []
    if kind not in (CIRCLE, ELLIPSE):
        raise CurveFileError("a part whose points are irrational", remedy="write it as a spline")
    curve = Round(Affine([[x * sizes[0], y * sizes[-1], p] for p, x, y in columns]), within)
    ends = [curve.at_angle(t, RADIANS) for t in trim] or [RIGHT[0]] * 2
    whole = [] if trim else [f"the full {SHAPES[kind][0]}, {EXACT}; edges may use only a part of it"]
    return curve.arc(*ends), [*whole, *curve.notes]


def _poles(words: Tokens, count: int, dimension: int, rational: bool) -> tuple[list[list[mpq]], list[mpq] | None]:
    rows = words.rows(count, dimension + rational)
    return [row[:dimension] for row in rows], [row[-1] for row in rows] if rational else None


def _bezier(collector: Collector, words: Tokens, dimension: int, where: str, trim: Sequence[mpq]) -> None:
    rational, degree = words.whole() != 0, words.count()
    points, weights = _poles(words, degree + 1, dimension, rational)
    within, notes = used((mpq(0), mpq(1)), *(trim or (0, 1)))
    collector.add("Bézier curve", where, degree, bezier_knots(degree), points, weights, notes=notes, within=within)


def _spline(collector: Collector, words: Tokens, dimension: int, where: str, trim: Sequence[mpq]) -> None:
    rational, periodic = words.whole() != 0, words.whole() != 0
    degree, count, distinct = words.count(), words.count(), words.count()
    points, weights = _poles(words, count, dimension, rational)
    collector.count(distinct)
    pairs = [(words.number(), words.count()) for _ in range(distinct)]
    collector.count(sum(times for _, times in pairs))
    knots = [knot for knot, times in pairs for _ in range(times)]
    ends = (knots[0], knots[-1]) if periodic and knots else domain(degree, knots)
    if periodic and trim and ends[0] < ends[1] < trim[1]:
        # it runs over the seam: two periods
        knots += [t + ends[1] - ends[0] for t in knots[pairs[0][1] :]]
        points, weights, ends = points * 2, weights and weights * 2, (ends[0], 2 * ends[1] - ends[0])
    within, notes = used(ends, *(trim or ends))
    flagged = ["periodic"] * periodic
    collector.add("B-spline curve", where, degree, knots, points, weights, flagged=flagged, notes=notes, within=within)


def write(splines: Sequence[Spline], numbers: NumberText) -> bytes:
    """Space curves under ``Curves``, each with an edge and its vertices in a compound; plane curves under ``Curve2ds``
    without edges, because a plane curve is an edge only on a surface.
    """
    plane, space = ([spline for spline in splines if spline.dimension == n] for n in (2, 3))
    if len(plane) + len(space) != len(splines):
        raise CurveFileError("a curve that is neither in the plane nor in space", remedy="choose another format")
    lines = ["DBRep_DrawableShape", "", "CASCADE Topology V1, (c) Matra-Datavision", "Locations 0"]
    for title, group in (("Curve2ds", plane), ("Curves", space)):
        lines.append(f"{title} {len(group)}")
        for spline in group:
            lines += _written(spline, numbers)
    lines += ["Polygon3D 0", "PolygonOnTriangulations 0", "Surfaces 0", "Triangulations 0", ""]
    return "\n".join([*lines, *_shapes([spline.curve for spline in space]), ""]).encode()


def _written(spline: Spline, numbers: NumberText) -> list[str]:
    curve, rational = spline.curve, not spline.polynomial
    rows = [" ".join(map(numbers, [*point, *([weight] if rational else [])])) for point, weight in spline.cartesian()]
    pairs = zip(curve.knots.breakpoints, curve.knots.multiplicities, strict=True)
    knots = " ".join(f"{numbers(knot)} {times}" for knot, times in pairs)
    counts = f"{curve.degree} {len(rows)} {len(curve.knots.breakpoints)}"
    return [f"{BSPLINE} {int(rational)} 0  {counts}  {'  '.join(rows)} ", f" {knots}"]


def _shapes(curves: Sequence[Nurbs]) -> list[str]:
    """Two vertices and an edge for each curve, in one compound; a shape is referred to by its index counted from the
    end.
    """
    total = 3 * len(curves) + 1
    lines = [f"TShapes {total}"]
    for i, curve in enumerate(curves):
        a, b = (finite_double(t) for t in curve.domain)
        for point in (curve(curve.domain[0]), curve(curve.domain[1], "left")):
            coordinates = " ".join(repr(finite_double(x)) for x in point)
            lines += ["Ve", "1e-07", coordinates, "0 0", "", "0101101", "*"]
        lines += ["Ed", " 1e-07 1 1 0", f"1  {i + 1} 0 {a!r} {b!r}", "0", "", "0101000"]
        lines.append(f"+{total - 3 * i} 0 -{total - 3 * i - 1} 0 *")
    edges = " ".join(f"+{total - 3 * i - 2} 0" for i in range(len(curves)))
    return [*lines, "Co", "", "1100000", f"{edges} *".strip(), "", "+1 0 "]


FORMAT = Format("brep", "Open CASCADE BRep text", (".brep", ".brp"), looks_like, read, write)
