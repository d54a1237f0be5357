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

from exactspline.extras.cad import NAMES
from exactspline.extras.cad.step_edges import (
    ANY_CURVE,
    ANY_SURFACE,
    BOUNDED,
    COMPOSITE,
    CURVE,
    ELEMENTARY,
    FACES,
    KEYWORDS,
    Edges,
    add_surface,
    written_spline,
)
from exactspline.extras.cad.step_records import StepFile, StepText, keywords, parts
from exactspline.interchange.collector import Collector
from exactspline.interchange.format import Format, Spline
from exactspline.interchange.numbers import NumberText
from exactspline.interchange.records import Reading, Source

#: The representations of sets of curves and of surfaces.
WIREFRAME = "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION"
BOUNDED_SURFACES = "GEOMETRICALLY_BOUNDED_SURFACE_SHAPE_REPRESENTATION"
#: Keywords that are not read, with the reasons; keywords that place parts; and keywords of surfaces other than splines.
SKIPPED, PLACING, OTHERS = NAMES["step"], NAMES["step placing"], NAMES["step surfaces"]
#: Every keyword of an entity that is not a spline and is read, named as skipped, or noted.
KNOWN = frozenset((*ELEMENTARY, *BOUNDED, COMPOSITE, *SKIPPED, *PLACING, *FACES, *OTHERS))
_METRE = re.compile(r"\bSI_UNIT\s*\(\s*(\$|\.[A-Z]+\.)\s*,\s*\.METRE\.\s*\)")
_CONVERSION = re.compile(r"\bCONVERSION_BASED_UNIT\s*\(\s*'([^']{1,40})'")
_REFERENCE = re.compile(r"#(\d{1,12})", re.ASCII)


def _looks_like(head: bytes) -> bool:
    """Whether a file begins with the header of part 21."""
    return head.lstrip().startswith(b"ISO-10303-21")


def _read(source: Source) -> Reading:
    """The curves and surfaces of a file, in the order of the file."""
    collector = Collector("step", source)
    file = StepFile(source.text, collector)
    named_by = {number: keywords(text) for number, text in file.instances.items()}
    _see_that_there_is_room(file, [file.instances[n] for n, named in named_by.items() if ANY_CURVE & {*named}])
    edges = Edges(file)
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
                add_surface(file, parts(text, source.limits), where)
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
    for unit in sorted(_units(file)):
        collector.unit(unit)
    return collector.reading()


def _see_that_there_is_room(file: StepFile, splines: Sequence[str]) -> None:
    """Raise `ShapeError` for too many objects, before any is built. Counted are the entries between the commas of every
    spline (its control points and knots), and the coordinates of its points.
    """
    points, least = set[str](), 0
    for text in splines:
        references = _REFERENCE.findall(text)
        points.update(references)
        least += text.count(",") + len(references) * (3 if KEYWORDS[CURVE].with_knots in text else 2)
    file.collector.room(least + sum(file.instances.get(int(number), "").count(",") for number in points))


def _units(file: StepFile) -> set[str]:
    """The units of length that the representations of the file use."""
    contexts = [text.partition("GLOBAL_UNIT_ASSIGNED_CONTEXT")[2] for text in file.instances.values()]
    units = set()
    for reference in set(_REFERENCE.findall(" ".join(contexts))):
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
        text.add_set("GEOMETRIC_SET", BOUNDED_SURFACES, [written_spline(spline, text) for spline in splines], 3)
        return text.encoded()
    for dimension in sorted({spline.dimension for spline in splines}):
        references = [written_spline(spline, text) for spline in splines if spline.dimension == dimension]
        text.add_set("GEOMETRIC_CURVE_SET", WIREFRAME, references, dimension)
    return text.encoded()


FORMAT = Format("step", "STEP part 21", (".stp", ".step", ".p21"), _looks_like, _read, _write, surfaces=True)
