"""DXF in text form: SPLINE, LINE, CIRCLE, ARC, ELLIPSE and LWPOLYLINE, in the ENTITIES section and in blocks.

Circles are rational and read exactly; so are the arcs of a polyline, because the bulge is the tangent of a quarter of
the angle. An ARC or ELLIPSE is exact if it begins and ends at multiples of a right angle; any other is skipped, because
its ends are irrational in general. A curve at z = 0 is read as a plane curve. INSERT (a placed copy of a block) is not
expanded: curves in a block are read as the block defines them. Notes state the unit, and which curves are invisible, in
paper space, or have a thickness.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from exactspline.errors import CurveFileError, ShapeError
from exactspline.extras.cad import NAMES
from exactspline.interchange.collector import UNREAD, Collector
from exactspline.interchange.format import Format, Spline
from exactspline.interchange.numbers import NumberText, decimal, last_digit, whole
from exactspline.interchange.records import Reading, Source
from exactspline.interchange.segments import (
    DEGREES,
    RADIANS,
    ZERO,
    Affine,
    Round,
    Segment,
    axes,
    bulged,
    cross,
    dot,
    mapped,
    polynomial,
    unit,
)
from exactspline.numbers.exact import mpq

CLOSED, PERIODIC, RATIONAL, PLANAR = 1, 2, 4, 8
#: Entities that are curves or place curves, and are not read.
CURVES = ("INSERT", "POLYLINE", "HELIX", "MLINE", "LEADER", "MULTILEADER", "ACAD_PROXY_ENTITY")
WHY = {"INSERT": "copies of blocks are not placed; explode them"}
SILENT = ("SEQEND", "VERTEX", "ENDBLK", "BLOCK", "SECTION", "ENDSEC", "EOF")


@dataclass
class _Entity:
    """An entity: its type, its pairs of group code and value, and the line where it begins."""

    kind: str
    pairs: list[tuple[int, str]]
    line: int
    block: str = ""

    def texts(self, code: int) -> list[str]:
        """The values with a group code."""
        return [value for group, value in self.pairs if group == code]


def _looks_like(head: bytes) -> bool:
    """Whether a file begins with group code 0 and SECTION, possibly after comments, or like binary DXF."""
    lines = [line.strip() for line in head.split(b"\n")]
    while lines[:1] == [b"999"]:
        lines = lines[2:]
    return lines[:2] == [b"0", b"SECTION"] or head.startswith(b"AutoCAD Binary DXF")


def _read(source: Source) -> Reading:
    """The curves of a file."""
    if source.data.startswith(b"AutoCAD Binary DXF"):
        raise CurveFileError("is binary DXF", remedy="save it as DXF text (ASCII)")
    collector, layers = Collector("dxf", source), dict[str, None]()
    for entity in _entities(source, collector):
        layers |= dict.fromkeys(own := entity.texts(8))
        if source.part and source.part not in own:
            continue
        where = f"{entity.kind} at line {entity.line}" + (f" in block {entity.block}" if entity.block else "")
        reader = _READERS.get(entity.kind)
        if reader is None:
            if entity.kind not in SILENT:
                why = WHY.get(entity.kind, UNREAD)
                collector.skip(entity.kind, where, why, curve=entity.kind in CURVES)
            continue
        with collector.skipping(entity.kind, where):
            reader(_Values(collector, entity, where))
    collector.see_that_part_exists(layers)
    return collector.reading()


def _entities(source: Source, collector: Collector) -> Iterator[_Entity]:
    """The entities of the sections ENTITIES and BLOCKS."""
    lines = source.text.split("\n")
    collector.room(len(lines) // 2)
    section, block, variable, value = "", "", "", ""
    entity: _Entity | None = None
    for i in range(0, len(lines) - 1, 2):
        code, value = lines[i].strip(), lines[i + 1].strip()
        if len(code) > 6 or not code.lstrip("-").isdecimal() or not code.isascii():
            raise CurveFileError(f"{code[:20]!r} is not a group code", where=f"line {i + 1}", remedy="an integer is")
        collector.count(1)
        if code == "0":
            if entity:
                yield entity
            entity = None
            if value == "ENDSEC":
                section = ""
            block = "" if value == "ENDBLK" else block
            if section in ("ENTITIES", "BLOCKS"):
                entity = _Entity(value, [], i + 1, block)
        elif code == "2" and lines[i - 1].strip() == "SECTION":
            section = value
        elif section == "HEADER":
            variable = value if code == "9" else variable
            if variable == "$INSUNITS" and code == "70":
                collector.unit(NAMES["dxf units"].get(value, ""))
        elif entity:
            entity.pairs.append((int(code), value))
            if entity.kind == "BLOCK" and code == "2":
                block = value
    if entity:
        yield entity
    if value != "EOF":
        collector.note("EOF is missing: the file may be cut off")


class _Values:
    """The numbers of one entity, and the collector for its curves."""

    def __init__(self, collector: Collector, entity: _Entity, where: str) -> None:
        self.collector, self.entity, self.where = collector, entity, where
        self.notes: list[str] = []
        if entity.block:
            self.notes.append("read as its block defines it; copies are not placed")
        if self.flag(60):
            self.notes.append("marked invisible")
        if self.flag(67):
            self.notes.append("in paper space")
        if any(text.strip("+-0. ") for text in entity.texts(39)):
            self.notes.append("has a thickness, which makes it a surface: only the curve is read")

    def number(self, code: int, default: int | None = None) -> mpq:
        """The value of a group code."""
        texts = self.entity.texts(code)
        if not texts and default is None:
            raise CurveFileError(f"group {code} is missing", remedy="complete the entity")
        return decimal(texts[0], self.collector.limits) if texts else mpq(default)

    def flag(self, code: int) -> int:
        """The integer value of a group code, 0 if it is missing."""
        texts = self.entity.texts(code)
        return whole(texts[0]) if texts else 0

    def numbers(self, code: int) -> list[mpq]:
        """All values of a group code."""
        return [decimal(text, self.collector.limits) for text in self.entity.texts(code)]

    def point(self, code: int, default: Sequence[int] | None = None) -> list[mpq]:
        """The point in the groups code, code + 10 and code + 20; a missing z is 0."""
        x, y, z = default or (None, None, 0)
        return [self.number(code, x), self.number(code + 10, y), self.number(code + 20, z)]

    def rows(self, *codes: int) -> list[list[mpq]]:
        """All rows of values with these group codes, each begun by the first of them; a missing value is 0."""
        rows: list[list[mpq]] = []
        for group, value in self.entity.pairs:
            if group == codes[0]:
                rows.append([mpq(0)] * len(codes))
            if group in codes and rows:
                rows[-1][codes.index(group)] = decimal(value, self.collector.limits)
        return rows

    def see_that_all_are_there(self, code: int, what: str, listed: Sequence[object]) -> None:
        """Check that there are as many values as the entity announces, if it announces a number."""
        if self.entity.texts(code) and self.flag(code) != len(listed):
            raise CurveFileError(
                f"{self.flag(code)} {what} announced, {len(listed)} given", remedy="correct the number"
            )

    def placed(self, local: Sequence[mpq], radius: mpq, size: mpq = ZERO) -> Round:
        """A circle in the entity's coordinate system, by the arbitrary axis algorithm; irrational axes are approximated
        if an error is allowed.
        """
        normal, within = self.point(210, (0, 0, 1)), self.collector.source.within
        # the axes move no point by more than the error times its coordinates
        reach = sum(map(abs, local), start=2 * radius + size)
        error = within / (2 * reach) if within and reach else None
        length = dot(normal, normal)
        small = all(64 * 64 * x * x < length for x in normal[:2])
        up = [mpq(0), mpq(1), mpq(0)] if small else [mpq(0), mpq(0), mpq(1)]
        frame, near = axes(cross(up, normal), normal, error)
        centre = [dot(local, column) for column in zip(*frame, strict=True)]
        rows = [[radius * x, radius * y, c] for x, y, c in zip(frame[0], frame[1], centre, strict=True)]
        return Round(Affine(rows), within, near)

    def angle(self, code: int, default: int, right: mpq) -> tuple[mpq, mpq, mpq]:
        """An angle, by default this number of right angles, with the value of a right angle and the unit of its last
        digit.
        """
        [text] = self.entity.texts(code)[:1] or [""]
        return (self.number(code), right, last_digit(text)) if text else (default * right, right, ZERO)

    def add(self, segments: Sequence[Segment]) -> None:
        """Add the curve made of segments in space, as a plane curve if z = 0."""
        if all(point[2] == 0 for segment in segments for point in segment):
            segments = [tuple((*point[:2], point[3]) for point in segment) for segment in segments]
        self.collector.add_segments(self.entity.kind, self.where, segments, self.name, self.notes)

    @property
    def name(self) -> str:
        """The type and the handle."""
        return " ".join([self.entity.kind.lower(), *self.entity.texts(5)[:1]])


def _spline(values: _Values) -> None:
    points, knots, weights = values.rows(10, 20, 30), values.numbers(40), values.numbers(41)
    flags = values.flag(70)
    if not points and values.entity.texts(11):
        raise CurveFileError("a spline with fit points only", remedy="control points and knots are required")
    values.see_that_all_are_there(72, "knots", knots)
    values.see_that_all_are_there(73, "control points", points)
    if all(point[2] == 0 for point in points):
        points = [point[:2] for point in points]
    degree = values.flag(71)
    if flags & RATIONAL and not weights:
        values.notes.append("flagged rational, but without weights: a polynomial curve")
    flagged = [word for bit, word in ((PERIODIC, "periodic"), (CLOSED, "closed")) if flags & bit]
    parts = degree, knots, points, weights or None
    values.collector.add("SPLINE", values.where, *parts, name=values.name, notes=values.notes, flagged=flagged)


def _line(values: _Values) -> None:
    values.add([polynomial(values.point(10), values.point(11))])


def _circle(values: _Values) -> None:
    _elliptic(values, values.placed(values.point(10), values.number(40)))


def _arc(values: _Values) -> None:
    for code in (50, 51):
        values.number(code)
    _elliptic(values, values.placed(values.point(10), values.number(40)), 50, 51, DEGREES)


def _ellipse(values: _Values) -> None:
    major, centre, within = values.point(11), values.point(10), values.collector.source.within
    reach = values.number(40) * sum(map(abs, major))
    normal = unit(values.point(210, (0, 0, 1)), within and min(within / (2 * reach or 1), mpq(1)))
    minor = [values.number(40) * x for x in cross(normal, major)]
    if values.angle(41, 0, RADIANS)[0] == values.angle(42, 4, RADIANS)[0]:
        raise ShapeError("its start and end parameters agree", remedy="a whole ellipse runs from 0 to 2π")
    _elliptic(values, Round(Affine([*zip(major, minor, centre, strict=True)]), within), 41, 42, RADIANS)


def _elliptic(values: _Values, curve: Round, first: int = 0, last: int = 0, right: mpq = DEGREES) -> None:
    """Add the arc between the angles of two group codes, by default the whole curve."""
    ends = [curve.at_angle(*values.angle(code, turns, right)) for code, turns in ((first, 0), (last, 4))]
    values.notes += curve.notes
    values.add(curve.arc(*ends))


def _polyline(values: _Values) -> None:
    vertices = values.rows(10, 20, 42)
    values.see_that_all_are_there(90, "vertices", vertices)
    if values.flag(70) & CLOSED:
        vertices.append([*vertices[0][:2], mpq(0)] if vertices else [])
    segments: list[Segment] = []
    for (*start, bulge), (*end, _) in pairwise(vertices):
        if start != end:
            segments += bulged((start[0], start[1]), (end[0], end[1]), bulge)
    if not segments:
        raise CurveFileError("all vertices coincide", remedy="a polyline has at least two vertices")
    lift = values.number(38, 0)
    reach = max(sum(map(abs, vertex[:2]), start=mpq(0)) for vertex in vertices)
    # the distance of an arc from its chord is at most the bulge times half the length of the chord
    reach *= 2 + 2 * max(abs(vertex[2]) for vertex in vertices)
    plane = values.placed([ZERO, ZERO, lift], mpq(1), reach)
    values.notes += plane.notes
    values.add(mapped(segments, plane.frame))


_READERS: dict[str, Callable[[_Values], None]] = {
    "SPLINE": _spline,
    "LINE": _line,
    "CIRCLE": _circle,
    "ARC": _arc,
    "ELLIPSE": _ellipse,
    "LWPOLYLINE": _polyline,
}


def _write(splines: Sequence[Spline], numbers: NumberText) -> bytes:
    """The curves as SPLINE entities of a drawing in the AutoCAD 2000 format (AC1015)."""
    pairs: list[tuple[int, str]] = [(0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1015"), (0, "ENDSEC")]
    pairs += [(0, "SECTION"), (2, "ENTITIES")]
    for handle, spline in enumerate(splines, 0x100):
        curve, points = spline.curve, spline.in_space()
        flags = (PLANAR if curve.dimension == 2 else 0) | (0 if curve.polynomial else RATIONAL)
        flags |= CLOSED if curve.closed else 0
        pairs += [(0, "SPLINE"), (5, f"{handle:X}"), (100, "AcDbEntity"), (8, "0"), (100, "AcDbSpline")]
        pairs += [(210, "0"), (220, "0"), (230, "1"), (70, str(flags)), (71, str(curve.degree))]
        pairs += [(72, str(len(curve.knots))), (73, str(len(points))), (74, "0")]
        pairs += [(40, numbers(knot)) for knot in curve.knots]
        for point, weight in points:
            pairs += [(code, numbers(x)) for code, x in zip((10, 20, 30), point, strict=True)]
            pairs += [] if curve.polynomial else [(41, numbers(weight))]
    pairs += [(0, "ENDSEC"), (0, "EOF")]
    return "".join(f"{code:>3}\n{value}\n" for code, value in pairs).encode()


FORMAT = Format("dxf", "DXF text", (".dxf",), _looks_like, _read, _write, parts=True)
