"""B-spline curves and surfaces of STEP files, polynomial and rational, with knots of every kind: listed, or those that
the standard defines for the kind.

Faces trim surfaces; the trims are not read.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from exactspline.errors import CurveFileError, counted
from exactspline.extras.cad.step_records import StepFile, Value
from exactspline.extras.cad.step_text import StepText, name_of, string
from exactspline.interchange.numbers import whole
from exactspline.interchange.records import NamedCurve
from exactspline.interchange.writing import Spline
from exactspline.numbers.exact import mpq
from exactspline.splines.nurbs import Nurbs

CURVE, SURFACE = "CURVE", "SURFACE"


class Keywords:
    """The keywords of B-spline curves, or of B-spline surfaces."""

    def __init__(self, what: str) -> None:
        self.what, self.parameters = what, 1 if what == CURVE else 2
        self.spline, self.rational = f"B_SPLINE_{what}", f"RATIONAL_B_SPLINE_{what}"
        self.with_knots = f"{self.spline}_WITH_KNOTS"
        self.kinds = (self.with_knots, f"BEZIER_{what}", f"UNIFORM_{what}", f"QUASI_UNIFORM_{what}")
        #: How many attributes splines of all kinds have.
        self.inherited = 3 + 2 * self.parameters

    def parts(self, entity: dict[str, list[Value]]) -> tuple[str, list[Value], list[Value], list[Value]]:
        """The kind of a spline, the attributes of all kinds, those of this kind, and the list that begins with its
        name: a simple instance has them in one list.

        Raises `CurveFileError` where no kind, which has knots, is among its keywords, and for too few attributes.
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


KEYWORDS = {what: Keywords(what) for what in (CURVE, SURFACE)}
#: Every keyword of a B-spline surface.
ANY_SURFACE = frozenset((KEYWORDS[SURFACE].spline, KEYWORDS[SURFACE].rational, *KEYWORDS[SURFACE].kinds))
#: Entities that use a part of a surface.
FACES = ("ADVANCED_FACE", "FACE_SURFACE", "CURVE_BOUNDED_SURFACE", "RECTANGULAR_TRIMMED_SURFACE")


def built_curve(file: StepFile, entity: dict[str, list[Value]], where: str) -> NamedCurve:
    """The spline curve of an instance."""
    return file.collector.built(where, **_spline(file, CURVE, entity, where))


def add_surface(file: StepFile, entity: dict[str, list[Value]], where: str) -> None:
    """Add the spline surface of an instance."""
    file.collector.add_spline(SURFACE, where, **_spline(file, SURFACE, entity, where))


def _spline(file: StepFile, what: str, entity: dict[str, list[Value]], where: str) -> dict[str, Any]:
    """What a collector needs to build the spline of an instance."""
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
    """The rows of a net; the list of a curve is one."""
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


def written_spline(spline: Spline, text: StepText) -> str:
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
