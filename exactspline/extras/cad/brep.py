"""Open CASCADE BRep text: the sections ``Curve2ds`` and ``Curves``.

The parts of a curve in space that edges use are read, and the part of a trimmed curve between its parameters: exactly
for splines, lines and parabolas, and for circles and ellipses whose parameters are multiples of a right angle; other
arcs of circles and ellipses only with `approximate`. Splines, circles and ellipses that no edge uses are read whole,
exact for the axes as written; lines and parabolas that no edge uses are unbounded. Curves in the parameter planes of
surfaces are read whole, too. Hyperbolas are skipped, and of an offset curve only the basis is read. For a periodic
curve the first poles are repeated and the knots extended by the period. Places of edges are ignored; a note states
this.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

from exactspline.errors import CurveFileError
from exactspline.interchange.collector import Collector, domain, used
from exactspline.interchange.format import Format, Spline
from exactspline.interchange.numbers import NumberText, Tokens, finite_double, last_digit
from exactspline.interchange.records import Reading, Source
from exactspline.interchange.segments import RADIANS, RIGHT, Affine, Round, Segment, bezier_knots, polynomial
from exactspline.numbers.exact import mpq
from exactspline.splines.nurbs import Nurbs

LINE, CIRCLE, ELLIPSE, PARABOLA, HYPERBOLA, BEZIER, BSPLINE, TRIMMED, OFFSET = range(1, 10)
#: The curves without control points, by kind: the name, the axes, and the sizes.
SHAPES = {
    LINE: ("line", 1, 0),
    CIRCLE: ("circle", 2, 1),
    ELLIPSE: ("ellipse", 2, 2),
    PARABOLA: ("parabola", 2, 1),
    HYPERBOLA: ("hyperbola", 2, 2),
}
BASIS = " (basis)"
#: A parameter that differs from an end by no more than this part is that end, written with fifteen digits.
ROUNDED = 2**47
#: A spline by its degree, its knots, its control points and weights, and whether it is periodic.
_Spline = tuple[int, list[mpq], list[list[mpq]], list[mpq] | None, bool]
#: The parameters of a part, as text.
Ends = tuple[str, str]
_EDGE = re.compile(
    r"^Ed[ \t]*\r?\n[^\n]*\n(?:1[ \t]+(?P<curve>\d{1,9})[ \t]+\d+[ \t]+(?P<first>\S+)[ \t]+(?P<last>\S+)[ \t]*\r?$)?",
    re.M,
)
_SECTION = re.compile(r"^(Curve2ds|Curves) (\d{1,9})[ \t]*\r?$", re.M)


def _looks_like(head: bytes) -> bool:
    """Whether the file begins with a header of Open CASCADE."""
    return b"CASCADE Topology V" in head


def _read(source: Source) -> Reading:
    """The curves of both sections; of curves in space the parts that edges use."""
    collector, uses = Collector("brep", source), dict[str, dict[Ends, None]]()
    for edge in _EDGE.finditer(source.text):
        collector.note("edges are read where their curves are defined: they may be placed elsewhere")
        if edge["curve"]:
            uses.setdefault(f"Curves {edge['curve']}", {})[edge["first"], edge["last"]] = None
    sections = list(_SECTION.finditer(source.text))
    for title in sorted({"Curve2ds", "Curves"} - {match[1] for match in sections}):
        collector.note(f"there is no section {title}: the file may be cut off")
    for match in sections:
        words = Tokens(source.text, source.limits, match.end())
        dimension = 2 if match[1] == "Curve2ds" else 3
        for number in range(1, int(match[2]) + 1):
            where = f"{match[1]} {number}"
            _curve(collector, words, dimension, where, list(uses.get(where, ())))
    return collector.reading()


def _curve(collector: Collector, words: Tokens, dimension: int, where: str, parts: Sequence[Ends]) -> None:
    """Read one curve, or the parts of it that edges use, or a trimmed curve; for an offset curve read its basis, over
    the same parameters.
    """
    while (kind := words.whole()) in (TRIMMED, OFFSET):
        numbers = [words.word() for _ in range(2 if kind == TRIMMED else 1 + (dimension == 3) * 3)]
        if kind == OFFSET:
            collector.skip("offset curve", where, "only its basis curve is read; write it as a spline")
            where = where.removesuffix(BASIS) + BASIS
        else:
            parts = parts or [(numbers[0], numbers[1])]
    requested: Sequence[Ends | None] = parts or [None]
    if kind in (BEZIER, BSPLINE):
        spline = _listed(collector, words, dimension, kind == BEZIER)
        for part in requested:
            with collector.skipping("spline", where):
                _add_spline(collector, where, spline, part)
        return
    if kind not in SHAPES:
        raise CurveFileError(f"a curve of kind {kind}", where=where, remedy="kinds 1 to 9 are known")
    name, axes, sizes = SHAPES[kind]
    vectors = words.rows(1 + axes + (dimension == 3 and axes > 1), dimension)
    # the second vector of a conic in space is its normal
    frame, numbers_of_it = [vectors[0], *vectors[-axes:]], words.numbers(sizes)
    if not parts and kind not in (CIRCLE, ELLIPSE):
        collector.skip(name, where, "it is unbounded; write its part as a spline", curve=kind != LINE)
        return
    for part in requested:
        with collector.skipping(name, where):
            segments, notes = _part(collector, kind, frame, numbers_of_it, part)
            collector.add_segments(name, where, segments, notes=notes)


def _part(
    collector: Collector, kind: int, frame: Sequence[Sequence[mpq]], sizes: Sequence[mpq], part: Ends | None
) -> tuple[list[Segment], list[str]]:
    """The part of a line or a conic between two parameters, or a full ellipse, and notes on it."""
    columns, ends = list(zip(*frame, strict=True)), collector.numbers(part or ())
    if kind == LINE:
        return [polynomial(*([p + t * x for p, x in columns] for t in ends))], []
    if kind == PARABOLA and sizes[0] > 0:
        u, v = ends
        pairs = ((u * u, u), (u * v, (u + v) / 2), (v * v, v))
        return [polynomial(*([p + a * x / (4 * sizes[0]) + b * y for p, x, y in columns] for a, b in pairs))], []
    if kind not in (CIRCLE, ELLIPSE):
        raise CurveFileError("a part whose points are irrational", remedy="write it as a spline")
    curve = Round(Affine([[x * sizes[0], y * sizes[-1], p] for p, x, y in columns]), collector.source.within)
    if part is None:
        return curve.arc(RIGHT[0], RIGHT[0]), [f"the full {SHAPES[kind][0]}, exact for the axes as written"]
    digits = map(last_digit, part)
    return curve.arc(*(curve.at_angle(t, RADIANS, d) for t, d in zip(ends, digits, strict=True))), curve.notes


def _listed(collector: Collector, words: Tokens, dimension: int, bezier: bool) -> _Spline:
    rational, periodic = words.whole() != 0, not bezier and words.whole() != 0
    degree = words.count()
    count, distinct = (degree + 1, 0) if bezier else (words.count(), words.count())
    rows = words.rows(count, dimension + rational)
    points, weights = [row[:dimension] for row in rows], [row[-1] for row in rows] if rational else None
    collector.count(distinct)
    pairs = [(words.number(), words.count()) for _ in range(distinct)]
    collector.count(sum(times for _, times in pairs))
    knots = [knot for knot, times in pairs for _ in range(times)]
    return degree, bezier_knots(degree) if bezier else knots, points, weights, periodic


def _add_spline(collector: Collector, where: str, spline: _Spline, part: Ends | None) -> None:
    """Add a spline, or the part of it between two parameters, which may run over the seam of a periodic one."""
    degree, knots, points, weights, periodic = spline
    ends = (knots[0], knots[-1]) if periodic and knots else domain(degree, knots)
    given = collector.numbers(part or ())
    trim = [next((end for end in ends if abs(end - t) * ROUNDED <= abs(end)), t) for t in given] or ends
    period = ends[1] - ends[0]
    if periodic and period > 0:
        # an edge may begin in any period
        turns = (trim[0] - ends[0]) // period * period
        knots, ends = [t + turns for t in knots], (ends[0] + turns, ends[1] + turns)
    if periodic and 0 < period < trim[1] - ends[0] <= 2 * period:
        # two periods
        knots = knots + [t + ends[1] - ends[0] for t in knots[knots.count(knots[0]) :]]
        points, weights, ends = points * 2, weights and weights * 2, (ends[0], 2 * ends[1] - ends[0])
    within, notes = used(ends, *trim)
    more: dict[str, Any] = {"flagged": ["periodic"] * periodic, "notes": notes, "within": within}
    collector.add("spline", where, degree, knots, points, weights, **more)


def _write(splines: Sequence[Spline], numbers: NumberText) -> bytes:
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


FORMAT = Format("brep", "Open CASCADE BRep text", (".brep", ".brp"), _looks_like, _read, _write)
