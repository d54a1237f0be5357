"""Open CASCADE BRep text: the sections ``Curve2ds`` and ``Curves``.

B-spline and Bézier curves are read. Circles and ellipses are read as full curves, exact for the axes as written. Lines,
parabolas and hyperbolas are unbounded in this section (edges bound them) and are skipped, as are trimmed and offset
curves. For a periodic curve the first poles are repeated and the knots extended by the period. Edges, which may use a
part of a curve, and placements are ignored; a note states this.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from exactspline.errors import CurveFileError
from exactspline.interchange.affine import Affine
from exactspline.interchange.collector import Collector
from exactspline.interchange.format import Format
from exactspline.interchange.numbers import NumberText, finite_double
from exactspline.interchange.records import Reading, Source
from exactspline.interchange.segments import bezier_knots, ellipse
from exactspline.interchange.tokens import Tokens
from exactspline.interchange.writing import Spline
from exactspline.numbers.exact import mpq
from exactspline.splines.nurbs import Nurbs

LINE, CIRCLE, ELLIPSE, PARABOLA, HYPERBOLA, BEZIER, BSPLINE, TRIMMED, OFFSET = range(1, 10)
NAMES = {LINE: "line", PARABOLA: "parabola", HYPERBOLA: "hyperbola", TRIMMED: "trimmed curve", OFFSET: "offset curve"}
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
            where = f"{match[1]} {number}"
            while _curve(collector, words, dimension, where):
                where = f"{match[1]} {number} (basis)"
    return collector.reading()


def _curve(collector: Collector, words: Tokens, dimension: int, where: str) -> bool:
    """Read one curve; return whether its basis curve follows."""
    kind = words.whole()
    if kind in (BEZIER, BSPLINE):
        (_bezier if kind == BEZIER else _spline)(collector, words, dimension, where)
    elif kind in (CIRCLE, ELLIPSE):
        _ellipse(collector, words, dimension, where, kind)
    elif kind in (TRIMMED, OFFSET):
        words.numbers(2 if kind == TRIMMED else 1 + (dimension == 3) * 3)
        collector.skip(NAMES[kind], where, "only its basis curve is read; write it as a spline")
    elif kind in NAMES:
        frame = {LINE: 2, PARABOLA: 3, HYPERBOLA: 3}[kind] + (dimension == 3 and kind != LINE)
        words.numbers(frame * dimension + {LINE: 0, PARABOLA: 1, HYPERBOLA: 2}[kind])
        collector.skip(NAMES[kind], where, "it is unbounded; write its part as a spline", curve=kind != LINE)
    else:
        raise CurveFileError(f"a curve of kind {kind}", where=where, remedy="kinds 1 to 9 are known")
    return kind in (TRIMMED, OFFSET)


def _poles(words: Tokens, count: int, dimension: int, rational: bool) -> tuple[list[list[mpq]], list[mpq] | None]:
    rows = words.rows(count, dimension + rational)
    return [row[:dimension] for row in rows], [row[-1] for row in rows] if rational else None


def _bezier(collector: Collector, words: Tokens, dimension: int, where: str) -> None:
    rational, degree = words.whole() != 0, words.count()
    points, weights = _poles(words, degree + 1, dimension, rational)
    collector.add("Bézier curve", where, degree, bezier_knots(degree), points, weights)


def _spline(collector: Collector, words: Tokens, dimension: int, where: str) -> None:
    rational, periodic = words.whole() != 0, words.whole() != 0
    degree, count, distinct = words.count(), words.count(), words.count()
    points, weights = _poles(words, count, dimension, rational)
    collector.count(distinct)
    pairs = [(words.number(), words.count()) for _ in range(distinct)]
    collector.count(sum(times for _, times in pairs))
    knots = [knot for knot, times in pairs for _ in range(times)]
    collector.add("B-spline curve", where, degree, knots, points, weights, flagged=["periodic"] * periodic)


def _ellipse(collector: Collector, words: Tokens, dimension: int, where: str, kind: int) -> None:
    centre = words.numbers(dimension)
    if dimension == 3:
        words.numbers(3)
    across, up = words.numbers(dimension), words.numbers(dimension)
    major = words.number()
    minor = words.number() if kind == ELLIPSE else major
    frame = Affine([[x * major, y * minor, c] for x, y, c in zip(across, up, centre, strict=True)])
    name = "circle" if kind == CIRCLE else "ellipse"
    note = f"the full {name}, exact for the axes as written; edges may use only a part of it"
    collector.add_segments(name, where, ellipse(frame), notes=[note])


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
