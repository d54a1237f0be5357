"""B-spline surfaces of STEP files, polynomial and rational, with knots of every kind.

Faces trim surfaces; the trims are not read.
"""

from __future__ import annotations

from exactspline.errors import CurveFileError
from exactspline.interchange.numbers import whole
from exactspline.interchange.step_knots import listed_knots, standard_knots
from exactspline.interchange.step_records import StepFile, Value, spline_parts
from exactspline.interchange.step_text import StepText, name_of, string
from exactspline.interchange.writing import Spline

SPLINE = "B_SPLINE_SURFACE"
WITH_KNOTS, RATIONAL = "B_SPLINE_SURFACE_WITH_KNOTS", "RATIONAL_B_SPLINE_SURFACE"
KINDS = (WITH_KNOTS, "BEZIER_SURFACE", "UNIFORM_SURFACE", "QUASI_UNIFORM_SURFACE")
#: Every keyword of a B-spline surface.
ANY = frozenset((SPLINE, *KINDS))
#: Entities that use a part of a surface.
FACES = ("ADVANCED_FACE", "FACE_SURFACE", "CURVE_BOUNDED_SURFACE", "RECTANGULAR_TRIMMED_SURFACE")
#: Surfaces that are not splines.
OTHERS = (
    "PLANE", "CYLINDRICAL_SURFACE", "CONICAL_SURFACE", "SPHERICAL_SURFACE", "TOROIDAL_SURFACE",
    "DEGENERATE_TOROIDAL_SURFACE", "SURFACE_OF_REVOLUTION", "SURFACE_OF_LINEAR_EXTRUSION", "OFFSET_SURFACE",
    "SURFACE_REPLICA", "RECTANGULAR_COMPOSITE_SURFACE",
)  # fmt: skip


def add_surface(file: StepFile, entity: dict[str, list[Value]], where: str) -> None:
    """Add the surface of an instance."""
    kind, base, specific, name = spline_parts(entity, "surface", SPLINE, KINDS, 7)
    if len(base) < 7 or (kind == WITH_KNOTS and len(specific) < 4):
        raise CurveFileError("attributes are missing", remedy="complete the instance")
    m, n = (whole(text) for text in file.texts(base[:2]))
    if not 0 <= min(m, n) <= max(m, n) <= file.limits.degree:
        raise CurveFileError(f"degree {m} × {n}", remedy=f"at most {file.limits.degree} is read")
    net = [[file.point(reference) for reference in file.texts(row)] for row in _rows(file, base[2])]
    if len({len(row) for row in net}) != 1:
        raise CurveFileError("rows of control points of different lengths", remedy="give as many points in each")
    if kind == WITH_KNOTS:
        knots = listed_knots(file, specific[0], specific[2]), listed_knots(file, specific[1], specific[3])
    else:
        knots = standard_knots(kind, m, len(net)), standard_knots(kind, n, len(net[0]))
    weights = None
    if entity.get(RATIONAL):
        weights = [w for row in _rows(file, entity[RATIONAL][0]) for w in file.numbers(row)]
    points = [point for row in net for point in row]
    notes = [] if kind == WITH_KNOTS else [f"{kind}: knots as defined by the standard"]
    file.collector.add_surface(
        kind, where, (m, n), knots, points, weights, u_fastest=False, name=name_of(name, where), notes=notes
    )


def _rows(file: StepFile, values: Value) -> list[Value]:
    """A list of lists."""
    if not isinstance(values, list):
        raise CurveFileError("a list is missing", remedy="write ((…),(…))")
    file.collector.count(len(values))
    return values


def written(surface: Spline, text: StepText) -> str:
    """Add a surface, which is in space; returns the reference to it."""
    net, length = surface.in_space(u_fastest=False), surface.counts[1]
    rows = [net[i : i + length] for i in range(0, len(net), length)]
    points = ",".join(f"({','.join(text.point(point) for point, _ in row)})" for row in rows)
    m, n = surface.degrees
    base = f"{m},{n},({points}),.UNSPECIFIED.,.U.,.U.,.U."
    counts = ",".join(f"({','.join(map(str, knots.multiplicities))})" for knots in surface.knots)
    values = ",".join(text.reals(knots.breakpoints) for knots in surface.knots)
    knots = f"{counts},{values},.UNSPECIFIED."
    if surface.polynomial:
        return text.add(f"{WITH_KNOTS}({string(surface.name)},{base},{knots})")
    weights = ",".join(text.reals([weight for _, weight in row]) for row in rows)
    return text.add(
        f"(BOUNDED_SURFACE() {SPLINE}({base}) {WITH_KNOTS}({knots}) GEOMETRIC_REPRESENTATION_ITEM() "
        f"{RATIONAL}(({weights})) REPRESENTATION_ITEM({string(surface.name)}) SURFACE())"
    )
