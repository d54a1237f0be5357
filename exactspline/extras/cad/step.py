"""STEP part 21: polylines, B-spline curves and surfaces, polynomial and rational, with knots of every kind (listed,
Bézier, uniform, quasi-uniform).

Curves are read in the coordinates and units of the file; placements in an assembly are not applied, as a note says. An
edge is the part of its curve between its vertices, a trimmed curve the part between its parameters or points. The part
is exact if its ends lie exactly on the curve; otherwise it is read only if an error is allowed. A spline that an edge
uses and on which a vertex does not lie is read whole, with a note. Circles, ellipses and splines that nothing uses are
read in full. Surfaces are read as wholes: the faces that trim them are not read. Everything else is skipped.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

from exactspline.errors import CurveFileError, ShapeError, counted
from exactspline.extras.cad import NAMES
from exactspline.extras.cad.step_records import StepFile, StepText, Value, keywords, name_of, parts, string
from exactspline.interchange.collector import Collector, used
from exactspline.interchange.format import Format, Spline
from exactspline.interchange.numbers import NumberText, decimal, last_digit, whole
from exactspline.interchange.records import NamedCurve, Reading, Source
from exactspline.interchange.segments import (
    DEGREES,
    RADIANS,
    RIGHT,
    Affine,
    Round,
    Segment,
    axes,
    dot,
    ellipse,
    minus,
    moved,
    polynomial,
    quarter_turns,
    unit,
)
from exactspline.numbers.exact import mpq
from exactspline.splines.nurbs import Nurbs

# ---- splines
#
# Faces trim surfaces; the trims are not read.


CURVE, SURFACE = "CURVE", "SURFACE"


class _Keywords:
    """The keywords of B-spline curves, or of B-spline surfaces."""

    def __init__(self, what: str) -> None:
        self.what, self.parameters = what, 1 if what == CURVE else 2
        self.spline, self.rational = f"B_SPLINE_{what}", f"RATIONAL_B_SPLINE_{what}"
        self.with_knots = f"{self.spline}_WITH_KNOTS"
        self.kinds = (self.with_knots, f"BEZIER_{what}", f"UNIFORM_{what}", f"QUASI_UNIFORM_{what}")
        #: The number of attributes of splines of all kinds.
        self.inherited = 3 + 2 * self.parameters

    def parts(self, entity: dict[str, list[Value]]) -> tuple[str, list[Value], list[Value], list[Value]]:
        """The kind of a spline, the attributes of all kinds, those of this kind, and the list that begins with its
        name: a simple instance has them in one list.

        Raises `CurveFileError` if no kind with knots is among its keywords, and for too few attributes.
        """
        kind = next((kind for kind in self.kinds if kind in entity), "")
        if not kind:
            remedy = f"one of {', '.join(self.kinds)} is required"
            raise CurveFileError(f"a B-spline {self.what.lower()} without knots", remedy=remedy)
        own = entity[kind]
        base, specific, name = own[1:], own[self.inherited + 1 :], own
        if self.spline in entity:
            base, specific, name = entity[self.spline], own, entity.get("REPRESENTATION_ITEM", [])
        if len(base) < self.inherited or (kind == self.with_knots and len(specific) < 2 * self.parameters):
            raise CurveFileError("attributes are missing", remedy="complete the instance")
        return kind, base, specific, name


KEYWORDS = {what: _Keywords(what) for what in (CURVE, SURFACE)}
#: Every keyword of a B-spline surface.
ANY_SURFACE = frozenset((KEYWORDS[SURFACE].spline, KEYWORDS[SURFACE].rational, *KEYWORDS[SURFACE].kinds))
#: Entities that use a part of a surface.
FACES = ("ADVANCED_FACE", "FACE_SURFACE", "CURVE_BOUNDED_SURFACE", "RECTANGULAR_TRIMMED_SURFACE")


def _add_surface(file: StepFile, entity: dict[str, list[Value]], where: str) -> None:
    """Add the spline surface of an instance."""
    file.collector.add_spline(SURFACE, where, **_spline(file, SURFACE, entity, where))


def _spline(file: StepFile, what: str, entity: dict[str, list[Value]], where: str) -> dict[str, Any]:
    """The arguments of a collector that build the spline of an instance."""
    keywords, notes = KEYWORDS[what], list[str]()
    kind, base, specific, name = keywords.parts(entity)
    n = keywords.parameters
    degrees = [whole(text) for text in file.texts(base[:n])]
    if not all(0 <= degree <= file.limits.degree for degree in degrees):
        raise CurveFileError(f"degree {' × '.join(map(str, degrees))}", remedy=f"at most {file.limits.degree} is read")
    net = [[file.point(reference) for reference in file.texts(row)] for row in _rows(file, what, base[n])]
    if len({len(row) for row in net}) != 1:
        raise CurveFileError("rows of control points of different lengths", remedy="give as many points in each")
    if kind == keywords.with_knots:
        knots = [_listed_knots(file, *pair) for pair in zip(specific[:n], specific[n : 2 * n], strict=True)]
    else:
        knots = [_standard_knots(kind, *pair) for pair in zip(degrees, [len(net), len(net[0])][-n:], strict=True)]
        notes.append(f"{kind}: knots as defined by the standard")
    weights = None
    if entity.get(keywords.rational):
        weights = [w for row in _rows(file, what, entity[keywords.rational][0]) for w in file.numbers(row)]
    points = [point for row in net for point in row]
    made: dict[str, Any] = {"points": points, "weights": weights, "name": name_of(name, where), "notes": notes}
    if what == SURFACE:
        return made | {"degrees": degrees, "knots": knots, "u_fastest": False}
    return made | {"degree": degrees[0], "knots": knots[0], "flagged": ["closed"] if base[3] == ".T." else []}


def _rows(file: StepFile, what: str, values: Value) -> Sequence[Value]:
    """The rows of a net; the list of a curve is a single row."""
    if what == CURVE:
        return [values]
    if not isinstance(values, list):
        raise CurveFileError("a list is missing", remedy="write ((…),(…))")
    file.collector.count(len(values))
    return values


def _listed_knots(file: StepFile, multiplicities: Value, values: Value) -> list[mpq]:
    """Knots that are listed with their multiplicities."""
    counts, knots = [whole(text) for text in file.texts(multiplicities)], file.numbers(values)
    if len(counts) != len(knots) or any(count < 0 for count in counts):
        problem = f"{counted(len(counts), 'multiplicity')} for {counted(len(knots), 'knot')}"
        raise CurveFileError(problem, remedy="give one per knot")
    file.collector.count(sum(counts))
    return [knot for knot, times in zip(knots, counts, strict=True) for _ in range(times)]


def _standard_knots(kind: str, degree: int, count: int) -> list[mpq]:
    """The knots that ISO 10303-42 defines for the kinds of splines that do not list them: their keywords begin with
    UNIFORM, QUASI_UNIFORM or BEZIER.
    """
    if kind.startswith("UNIFORM"):
        return [mpq(i - degree) for i in range(count + degree + 1)]
    times = degree if kind.startswith("BEZIER") else 1
    if degree < 1 or count <= degree or (count - 1 - degree) % times:
        remedy = "this kind of spline needs a different number of points"
        raise CurveFileError(f"{counted(count, 'point')} for degree {degree}", remedy=remedy)
    inner = [mpq(i // times + 1) for i in range(count - 1 - degree)]
    return [mpq(0)] * (degree + 1) + inner + [mpq((count - 1 - degree) // times + 1)] * (degree + 1)


def _written_spline(spline: Spline, text: StepText) -> str:
    """Add a curve, or a surface, which is in space; returns the reference to it."""
    what = SURFACE if spline.is_surface else CURVE
    keywords, length = KEYWORDS[what], spline.counts[-1]
    net = spline.in_space(u_fastest=False) if spline.is_surface else spline.cartesian()
    rows = [net[i : i + length] for i in range(0, len(net), length)]
    points = _net(spline, [f"({','.join(text.point(point) for point, _ in row)})" for row in rows])
    flags = ".U.,.U.,.U." if not isinstance(spline.of, Nurbs) else ".T.,.U." if spline.of.closed else ".F.,.U."
    base = f"{','.join(map(str, spline.degrees))},{points},.UNSPECIFIED.,{flags}"
    counts = [f"({','.join(map(str, knots.multiplicities))})" for knots in spline.knots]
    values = [text.reals(knots.breakpoints) for knots in spline.knots]
    knots, name = f"{','.join([*counts, *values])},.UNSPECIFIED.", string(spline.name)
    if spline.polynomial:
        return text.add(f"{keywords.with_knots}({name},{base},{knots})")
    weights = _net(spline, [text.reals([weight for _, weight in row]) for row in rows])
    parts = [f"BOUNDED_{what}()", f"{what}()", f"{keywords.spline}({base})", f"{keywords.with_knots}({knots})"]
    parts += ["GEOMETRIC_REPRESENTATION_ITEM()", f"{keywords.rational}({weights})", f"REPRESENTATION_ITEM({name})"]
    return text.add(f"({' '.join(sorted(parts))})")


def _net(spline: Spline, rows: Sequence[str]) -> str:
    return f"({','.join(rows)})" if spline.is_surface else rows[0]


EDGE, TRIMMED, POLYLINE, COMPOSITE = "EDGE_CURVE", "TRIMMED_CURVE", "POLYLINE", "COMPOSITE_CURVE"
ELEMENTARY = ("LINE", "CIRCLE", "ELLIPSE")
#: The number of attributes of an edge and of a trimmed curve, and the index of their curve.
BOUNDED = {EDGE: (5, 3), TRIMMED: (6, 1)}
#: Every keyword of a curve with control points.
ANY_CURVE = frozenset((POLYLINE, KEYWORDS[CURVE].spline, KEYWORDS[CURVE].rational, *KEYWORDS[CURVE].kinds))
#: Curves given together with the surfaces they lie on; their first reference is the curve in space.
ON_SURFACES = ("SURFACE_CURVE", "SEAM_CURVE", "INTERSECTION_CURVE")
#: Entities that contain curves in the parameter plane of a surface.
PARAMETERS = "DEFINITIONAL_REPRESENTATION"
PART = "edges may use only a part of it, or reverse it"
_TEXT = re.compile(r"'[^']*'")
_REFERENCE = re.compile(r"#\d{1,12}", re.ASCII)
_UNCERTAINTY = re.compile(r"UNCERTAINTY_MEASURE_WITH_UNIT\s*\(\s*LENGTH_MEASURE\s*\(\s*(\d[.\dE+-]{0,40})\s*\)")
Point: TypeAlias = "list[mpq]"


@dataclass
class _End:
    """An end of a part of a curve: its parameter as text, its point, or both."""

    parameter: str
    point: Point | None


class _Edges:
    """The curves of a file that have no control points, and the parts of curves that edges and trimmed curves use."""

    def __init__(self, file: StepFile) -> None:
        self.file, self.within = file, file.collector.source.within
        #: The largest distance of a vertex from its curve, if an error is allowed: the uncertainty of lengths stated in
        #: the file.
        self.reach = self.within
        self.used: set[str] = set()
        self.in_parameters: set[str] = set()
        #: A right angle in the unit of angles of the file.
        self.right = RADIANS
        for text in file.instances.values():
            kind, _, rest = text.partition("(")
            if kind.strip() == PARAMETERS:
                self.in_parameters.update(_REFERENCE.findall(_TEXT.sub("", rest).partition(")")[0]))
            elif kind.strip() in BOUNDED:
                # the curve that is used, possibly on a continuation line
                place = BOUNDED[kind.strip()][1] - 1
                for curve in _REFERENCE.findall(_TEXT.sub("", rest))[place : place + 1]:
                    self.used.add(self._followed(curve))
            elif self.reach is not None and (found := _UNCERTAINTY.search(text)):
                self.reach = max(self.reach, decimal(found[1], file.limits))
            elif "PLANE_ANGLE_UNIT" in text and "'DEGREE'" in text.upper():
                self.right = DEGREES

    def _followed(self, reference: Value) -> str:
        """The curve in space that a reference means; for a curve on a surface its first curve."""
        for _ in range(self.file.limits.depth):
            kind = self._kind(reference)
            if kind not in (*ON_SURFACES, TRIMMED):
                break
            found = _REFERENCE.findall(_TEXT.sub("", self.file.instances[int(str(reference)[1:])]))
            reference = found[0] if found else ""
        return str(reference)

    def _kind(self, reference: Value) -> str:
        found = _REFERENCE.fullmatch(reference) if isinstance(reference, str) else None
        text = self.file.instances.get(int(found[0][1:]), "") if found else ""
        named = keywords(text)
        return CURVE if not ANY_CURVE.isdisjoint(named) else named[0] if named else ""

    def read(self, keyword: str, number: int, where: str) -> None:
        """Add the curve of an instance, unless it is used by others."""
        collector, reference = self.file.collector, f"#{number}"
        if keyword in BOUNDED:
            self._bounded(keyword, reference)
        elif reference in self.used:
            return
        elif keyword == CURVE:
            collector.take(self._spline(reference), None, *self._in_parameters(reference))
        elif keyword == "LINE":
            collector.skip(keyword, where, "an unbounded line that no edge uses", curve=False)
        else:
            notes = ["the full curve", *self._in_parameters(reference)]
            collector.add_segments(keyword, where, ellipse(self._round(keyword, reference).frame), where, notes)

    def _in_parameters(self, reference: str) -> list[str]:
        return ["in the parameter plane of a surface"] if reference in self.in_parameters else []

    def _bounded(self, keyword: str, reference: str) -> None:
        """Add the curve of an edge, or a trimmed curve."""
        count, place = BOUNDED[keyword]
        name, *given = self.file.named(reference, keyword, count)
        curve, sense = self._followed(given[place - 1]), given[3]
        kind = self._kind(curve)
        if keyword == EDGE:
            ends = [_End("", self.file.point(self.file.named(end, "VERTEX_POINT", 2)[1])) for end in given[:2]]
        else:
            ends = [self._trim(end) for end in given[1:3]]
        whole = keyword == EDGE and given[0] == given[1]
        # the direction of the curve: from the last end to the first one if the sense is not that of the curve
        ends, notes = (ends, list[str]()) if sense == ".T." else (ends[::-1], ["reversed"])
        if kind == CURVE:
            made, title = self._spline(curve, reference), name_of([name], "")
            part, remarks = (None, []) if whole else self._part(made, ends)
            made = NamedCurve(title or made.name, made.curve, made.notes)
            self.file.collector.take(made, part, *remarks, *notes, *self._in_parameters(reference))
            return
        if kind == "LINE":
            segments: list[Segment] = [polynomial(*self._on_line(curve, ends, notes))]
        elif kind in ELEMENTARY:
            found = self._round(kind, curve)
            u, v = [RIGHT[0]] * 2 if whole else [self._on_round(found, end) for end in ends]
            segments, notes = found.arc(u, v), [f"on {curve}", *notes, *found.notes]
        else:
            raise ShapeError(f"a part of {kind or 'no curve'}", remedy="of lines, conics and splines parts are read")
        self.file.collector.add_segments(keyword, reference, segments, name_of([name], reference), notes)

    def join(self, number: int) -> None:
        """Join the parts of a composite curve."""
        given, found = parts(self.file.instances[number], self.file.limits).get(COMPOSITE, []), list[tuple[str, bool]]()
        with self.file.collector.skipping(COMPOSITE, f"#{number}", curve=False):
            for segment in self.file.texts(given[-2] if len(given) > 1 else ""):
                _, sense, curve = self.file.named(segment, f"{COMPOSITE}_SEGMENT", 3)
                found.append((str(curve), sense == ".T."))
            self.file.collector.join(COMPOSITE, f"#{number}", found, name_of(given, f"#{number}"))

    def _trim(self, values: Value) -> _End:
        """An end of a trimmed curve: a list of a point, a parameter, or both."""
        listed = values if isinstance(values, list) else []
        parameters = [inner[0] for inner in listed if isinstance(inner, list) and inner]
        points = [self.file.point(each) for each in listed if isinstance(each, str) and _REFERENCE.fullmatch(each)]
        return _End(str(parameters[0]) if parameters else "", points[0] if points else None)

    def _number(self, end: _End) -> mpq:
        if not end.parameter:
            raise ShapeError("an end without a parameter or a point", remedy="write one")
        return decimal(end.parameter, self.file.limits)

    def _spline(self, reference: str, where: str = "") -> NamedCurve:
        """The curve with control points of an instance that is used by another instance."""
        where = where or reference
        entity = parts(self.file.instances[int(reference[1:])], self.file.limits)
        if POLYLINE not in entity:
            return self.file.collector.built(where, **_spline(self.file, CURVE, entity, where))
        given = entity[POLYLINE]
        points = [self.file.point(each) for each in self.file.texts(given[-1] if given else "")]
        knots = [mpq(max(0, min(i - 1, len(points) - 1))) for i in range(len(points) + 2)]
        return self.file.collector.built(where, 1, knots, points, name=name_of(given, where))

    def _part(self, made: NamedCurve, ends: Sequence[_End]) -> tuple[tuple[mpq, mpq] | None, list[str]]:
        """The parameters between two ends, None for the whole curve, and notes."""
        if all(end.parameter for end in ends):
            return used(made.curve.domain, *map(self._number, ends))
        low, high = made.curve.domain
        points = [made.curve(low), made.curve(high, "left")]
        if [tuple(end.point or ()) for end in ends] == points:
            return None, []
        notes = list[str]()
        found = [self._parameter(made, end.point or [], notes) for end in ends]
        start, end = (found[0], found[1]) if None not in found else (low, low)
        if start is None or end is None or not start < end:
            return None, [PART]
        return (start, end), notes

    def _parameter(self, made: NamedCurve, point: Point, notes: list[str]) -> mpq | None:
        """The parameter of a point of a spline, or of the point nearest to it within the error that is allowed."""
        from exactspline.geometry.pairs.nearest import nearest

        curve, (low, high) = made.curve, made.curve.domain
        if len(point) != curve.dimension:
            return None
        # the ends are tried first, since a point near an end may be even nearer to a point inside
        places = [low, high]
        for place in nearest(curve, point).points:
            exact = place.parameter.exact
            places += [min(max(place.parameter.enclosure(40).low, low), high) if exact is None else exact]
        for t in places:
            foot = curve(t, "left" if t == high else "right")
            gap = minus(foot, point)
            if not any(gap):
                return t
            if self.reach is not None and dot(gap, gap) <= self.reach**2:
                notes.append(moved(foot, point, self.reach))
                return t
        return None

    def _on_line(self, reference: str, ends: Sequence[_End], notes: list[str]) -> list[Sequence[mpq]]:
        """The two ends of a part of a line."""
        _, through, along = self.file.named(reference, "LINE", 3)
        start, (_, towards, size) = self.file.point(through), self.file.named(along, "VECTOR", 3)
        direction = self._direction(towards, ())
        found = list[Sequence[mpq]]()
        for end in ends:
            if end.point is None:
                [length] = self.file.numbers([size])
                t, step = self._number(end) * length, unit(direction)
            else:
                away = minus(end.point, start)
                t, step = dot(away, direction) / dot(direction, direction), direction
            place = minus(start, [-t * b for b in step])
            if end.point is not None and place != end.point:
                notes.append(moved(place, end.point, self.reach))
            found.append(place)
        return found

    def _on_round(self, curve: Round, end: _End) -> tuple[mpq, ...]:
        """The point of the unit circle for an end: by its parameter if that is a multiple of a right angle."""
        if end.parameter:
            angle, digit = self._number(end), last_digit(end.parameter)
            if end.point is None or quarter_turns(angle, self.right, digit) is not None:
                return curve.at_angle(angle, self.right, digit)
        return curve.at_point(end.point or [], self.reach)

    def _round(self, keyword: str, reference: str) -> Round:
        """A circle or an ellipse, in the plane or in space."""
        _, placement, *sizes = self.file.named(reference, keyword, 3 if keyword == "CIRCLE" else 4)
        radii = self.file.numbers(sizes)
        a, b = radii[0], radii[-1]
        if not a > 0 < b:
            raise ShapeError("a circle without a positive radius", remedy="its radius must be positive")
        error = None if self.within is None else min(self.within / (2 * (a + b)), mpq(1))
        if self._kind(placement) == "AXIS2_PLACEMENT_2D":
            _, centre, along = self.file.named(placement, "AXIS2_PLACEMENT_2D", 3)
            x = unit(self._direction(along, (1, 0)), error)
            y, near = [-x[1], x[0]], dot(x, x) != 1
        else:
            _, centre, axis, along = self.file.named(placement, "AXIS2_PLACEMENT_3D", 4)
            (x, y, _), near = axes(self._direction(along, (1, 0, 0)), self._direction(axis, (0, 0, 1)), error)
        # the centre may have another number of coordinates than the axes
        middle = minus(self.file.point(centre), [mpq(0)] * len(x))
        rows = [[p * a, q * b, c] for p, q, c in zip(x, y, middle, strict=True)]
        return Round(Affine(rows), self.within, near)

    def _direction(self, reference: Value, usual: Sequence[int]) -> list[mpq]:
        if reference == "$":
            return list(map(mpq, usual))
        ratios = self.file.numbers(self.file.named(reference, "DIRECTION", 2)[1])
        if not any(ratios) or (usual and len(ratios) != len(usual)):
            raise ShapeError("a direction that is not in space", remedy="write three ratios")
        return ratios


#: The representations of sets of curves and of surfaces.
WIREFRAME = "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION"
BOUNDED_SURFACES = "GEOMETRICALLY_BOUNDED_SURFACE_SHAPE_REPRESENTATION"
#: Keywords that are not read, with the reasons; keywords that place parts; and keywords of surfaces other than splines.
SKIPPED, PLACING, OTHERS = NAMES["step"], NAMES["step placing"], NAMES["step surfaces"]
#: Every keyword of an entity that is not a spline and is read, named as skipped, or noted.
KNOWN = frozenset((*ELEMENTARY, *BOUNDED, COMPOSITE, *SKIPPED, *PLACING, *FACES, *OTHERS))
_METRE = re.compile(r"\bSI_UNIT\s*\(\s*(\$|\.[A-Z]+\.)\s*,\s*\.METRE\.\s*\)")
_CONVERSION = re.compile(r"\bCONVERSION_BASED_UNIT\s*\(\s*'([^']{1,40})'")
_INSTANCE = re.compile(r"#(\d{1,12})", re.ASCII)


def _looks_like(head: bytes) -> bool:
    """Whether a file begins with the header of part 21."""
    return head.lstrip().startswith(b"ISO-10303-21")


def _read(source: Source) -> Reading:
    """The curves and surfaces of a file, in the order of the file."""
    collector = Collector("step", source)
    file = StepFile(source.text, collector)
    named_by = {number: keywords(text) for number, text in file.instances.items()}
    _see_that_there_is_room(file, [file.instances[n] for n, named in named_by.items() if ANY_CURVE & {*named}])
    edges = _Edges(file)
    trimmed, others, composite = set[str](), set[str](), list[int]()
    for number, text in file.instances.items():
        where, named = f"#{number}", named_by[number]
        # the first known keyword of a complex instance, whose keywords are in alphabetical order
        keyword = next((each for each in named if each in KNOWN), named[0] if named else "")
        if not ANY_CURVE.isdisjoint(named):
            with collector.skipping(keyword, where):
                edges.read(CURVE, number, where)
        elif not ANY_SURFACE.isdisjoint(named):
            with collector.skipping(keyword, where, curve=False):
                _add_surface(file, parts(text, source.limits), where)
        elif keyword in ELEMENTARY or keyword in BOUNDED:
            with collector.skipping(keyword, where):
                edges.read(keyword, number, where)
        elif keyword in SKIPPED:
            collector.skip(keyword, where, SKIPPED[keyword])
        elif keyword == COMPOSITE:
            composite.append(number)
        elif keyword in PLACING:
            collector.note("the file places parts: curves are read where they are defined")
        elif keyword in FACES:
            trimmed.add(keyword)
        elif keyword in OTHERS:
            others.add(keyword)
    for number in composite:
        edges.join(number)
    if collector.surfaces and trimmed:
        collector.note(f"trims are not read, surfaces are read as wholes: {', '.join(sorted(trimmed))}")
    if others:
        collector.note(f"surfaces of these kinds are not read: {', '.join(sorted(others))}")
    for length in sorted(_units(file)):
        collector.unit(length)
    return collector.reading()


def _see_that_there_is_room(file: StepFile, splines: Sequence[str]) -> None:
    """Raise `ShapeError` for too many objects, before any is built. Counted are the entries between the commas of every
    spline (its control points and knots), and the coordinates of its points.
    """
    points, least = set[str](), 0
    for text in splines:
        references = _INSTANCE.findall(text)
        points.update(references)
        least += text.count(",") + len(references) * (3 if KEYWORDS[CURVE].with_knots in text else 2)
    file.collector.room(least + sum(file.instances.get(int(number), "").count(",") for number in points))


def _units(file: StepFile) -> set[str]:
    """The units of length that the representations of the file use."""
    contexts = [text.partition("GLOBAL_UNIT_ASSIGNED_CONTEXT")[2] for text in file.instances.values()]
    units = set()
    for reference in set(_INSTANCE.findall(" ".join(contexts))):
        text = file.instances.get(int(reference), "")
        metre, other = _METRE.search(text), _CONVERSION.search(text)
        if metre:
            units.add(f"{metre[1].strip('.$').lower()}metres")
        elif other and "LENGTH_UNIT" in text:
            units.add(other[1].lower())
    return units


def _write(splines: Sequence[Spline], numbers: NumberText) -> bytes:
    """The curves in one set per dimension, each set in a context of its dimension; surfaces in one set, maps of the
    plane at z = 0.
    """
    text = StepText(numbers)
    if splines[0].is_surface:
        text.add_set("GEOMETRIC_SET", BOUNDED_SURFACES, [_written_spline(spline, text) for spline in splines], 3)
        return text.encoded()
    for dimension in sorted({spline.dimension for spline in splines}):
        references = [_written_spline(spline, text) for spline in splines if spline.dimension == dimension]
        text.add_set("GEOMETRIC_CURVE_SET", WIREFRAME, references, dimension)
    return text.encoded()


FORMAT = Format("step", "STEP part 21", (".stp", ".step", ".p21"), _looks_like, _read, _write, surfaces=True)
