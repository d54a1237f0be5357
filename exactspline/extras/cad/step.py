"""STEP part 21: polylines, B-spline curves and surfaces, polynomial and rational, with knots of every kind (listed,
Bézier, uniform, quasi-uniform).

Curves are read in the coordinates and units of the file. Placements in an assembly are not applied, and splines are not
trimmed to the edges that use them; notes state this. Lines, circles and ellipses are read between the vertices of an
edge; circles and ellipses that no edge uses are read in full. This is exact, and therefore requires axes of rational
length and vertices exactly on the curve. Surfaces are read as wholes: the faces that trim them are not read. Everything
else is skipped.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from exactspline.extras.cad.step_edges import EDGE, ELEMENTARY, Edges
from exactspline.extras.cad.step_records import StepFile, Value, keywords, parts
from exactspline.extras.cad.step_splines import (
    ANY_SURFACE,
    CURVE,
    FACES,
    KEYWORDS,
    OTHERS,
    SURFACE,
    add_spline,
    written_spline,
)
from exactspline.extras.cad.step_text import StepText, name_of
from exactspline.interchange.collector import Collector
from exactspline.interchange.format import Format
from exactspline.interchange.numbers import NumberText
from exactspline.interchange.records import Reading, Source
from exactspline.interchange.writing import Spline
from exactspline.numbers.exact import mpq

#: How the sets of curves and of surfaces are represented.
WIREFRAME = "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION"
BOUNDED_SURFACES = "GEOMETRICALLY_BOUNDED_SURFACE_SHAPE_REPRESENTATION"
POLYLINE = "POLYLINE"
#: Every keyword of a curve with control points.
ANY_CURVE = frozenset((POLYLINE, KEYWORDS[CURVE].spline, KEYWORDS[CURVE].rational, *KEYWORDS[CURVE].kinds))
SKIPPED = {
    "PARABOLA": "unbounded", "HYPERBOLA": "unbounded", "TRIMMED_CURVE": "trimming is not applied",
    "COMPOSITE_CURVE": "its parts are read separately", "OFFSET_CURVE_2D": "not rational",
    "OFFSET_CURVE_3D": "not rational", "CLOTHOID": "not rational", "CURVE_REPLICA": "copies are not placed",
}  # fmt: skip
#: Skipped entities that are not curves.
NO_CURVE = ("COMPOSITE_CURVE",)
#: Entities that place parts.
PLACING = (
    "MAPPED_ITEM", "ITEM_DEFINED_TRANSFORMATION", "CARTESIAN_TRANSFORMATION_OPERATOR_3D",
    "CARTESIAN_TRANSFORMATION_OPERATOR_2D", "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION",
)  # fmt: skip
#: Every keyword of an entity that is not a spline and is read, named as skipped, or noted.
KNOWN = frozenset((*ELEMENTARY, EDGE, *SKIPPED, *PLACING, *FACES, *OTHERS))
_METRE = re.compile(r"\bSI_UNIT\s*\(\s*(\$|\.[A-Z]+\.)\s*,\s*\.METRE\.\s*\)")
_CONVERSION = re.compile(r"\bCONVERSION_BASED_UNIT\s*\(\s*'([^']{1,40})'")
_REFERENCE = re.compile(r"#(\d{1,12})", re.ASCII)


def looks_like(head: bytes) -> bool:
    """Whether a file begins with the header of part 21."""
    return head.lstrip().startswith(b"ISO-10303-21")


def read(source: Source) -> Reading:
    """The curves and surfaces of a file, in the order of the file."""
    collector = Collector("step", source)
    file = StepFile(source.text, collector)
    edges = Edges(file)
    trimmed, others = set[str](), set[str]()
    for number, text in file.instances.items():
        where = f"#{number}"
        named = keywords(text)
        # of a complex instance, whose keywords are in alphabetical order, the one that is known here
        keyword = next((each for each in named if each in KNOWN), named[0] if named else "")
        if not ANY_CURVE.isdisjoint(named):
            with collector.skipping(keyword, where):
                _curve(file, parts(text, source.limits), where, edges.notes(number))
        elif not ANY_SURFACE.isdisjoint(named):
            with collector.skipping(keyword, where, curve=False):
                add_spline(file, SURFACE, parts(text, source.limits), where)
        elif keyword in ELEMENTARY or keyword == EDGE:
            with collector.skipping(keyword, where):
                edges.read(keyword, number, where)
        elif keyword in SKIPPED:
            collector.skip(keyword, where, SKIPPED[keyword], curve=keyword not in NO_CURVE)
        elif keyword in PLACING:
            collector.note("the file places parts: curves are read where they are defined")
        elif keyword in FACES:
            trimmed.add(keyword)
        elif keyword in OTHERS:
            others.add(keyword)
    if collector.surfaces and trimmed:
        collector.note(f"trims are not read, surfaces are read as wholes: {', '.join(sorted(trimmed))}")
    if others:
        collector.note(f"surfaces of these kinds are not read: {', '.join(sorted(others))}")
    for unit in sorted(_units(file)):
        collector.note(f"lengths in {unit}: read as written")
    return collector.reading()


def _units(file: StepFile) -> set[str]:
    """The units of length that the representations of the file use."""
    used = {
        reference
        for text in file.instances.values()
        if "GLOBAL_UNIT_ASSIGNED_CONTEXT" in text
        for reference in _REFERENCE.findall(text.partition("GLOBAL_UNIT_ASSIGNED_CONTEXT")[2])
    }
    units = set()
    for reference in used:
        text = file.instances.get(int(reference), "")
        metre, other = _METRE.search(text), _CONVERSION.search(text)
        if metre:
            units.add(f"{metre[1].strip('.$').lower()}metres")
        elif other and "LENGTH_UNIT" in text:
            units.add(other[1].lower())
    return units


def _curve(file: StepFile, entity: dict[str, list[Value]], where: str, notes: Sequence[str]) -> None:
    if POLYLINE not in entity:
        add_spline(file, CURVE, entity, where, notes)
        return
    points = [file.point(reference) for reference in file.texts(entity[POLYLINE][-1] if entity[POLYLINE] else "")]
    knots = [mpq(max(0, min(i - 1, len(points) - 1))) for i in range(len(points) + 2)]
    file.collector.add(POLYLINE, where, 1, knots, points, name=name_of(entity[POLYLINE], where), notes=notes)


def write(splines: Sequence[Spline], numbers: NumberText) -> bytes:
    """The curves in one set per dimension, each set in a context of its dimension; surfaces in one set, maps of the
    plane at z = 0.
    """
    text = StepText(numbers)
    if splines[0].is_surface:
        text.add_set("GEOMETRIC_SET", BOUNDED_SURFACES, [written_spline(spline, text) for spline in splines], 3)
        return text.encoded()
    for dimension in sorted({spline.dimension for spline in splines}):
        references = [written_spline(spline, text) for spline in splines if spline.dimension == dimension]
        text.add_set("GEOMETRIC_CURVE_SET", WIREFRAME, references, dimension)
    return text.encoded()


FORMAT = Format("step", "STEP part 21", (".stp", ".step", ".p21"), looks_like, read, write, surfaces=True)
