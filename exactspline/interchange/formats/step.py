"""STEP part 21: polylines and B-spline curves, polynomial and rational, with knots of every kind (listed, Bézier,
uniform, quasi-uniform).

Curves are read in the coordinates and units of the file. Placements in an assembly are not applied, and splines are not
trimmed to the edges that use them; notes state this. Lines, circles and ellipses are read between the vertices of an
edge; circles and ellipses that no edge uses are read in full. This is exact, and therefore requires axes of rational
length and vertices exactly on the curve. Everything else is skipped.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from exactspline.errors import CurveFileError, counted
from exactspline.interchange.collector import Collector
from exactspline.interchange.numbers import NumberText, whole, with_point
from exactspline.interchange.records import Format, NamedCurve, Reading, Source
from exactspline.interchange.step_edges import EDGE, ELEMENTARY, Edges
from exactspline.interchange.step_records import StepFile, Value, parts
from exactspline.interchange.writing import cartesian
from exactspline.numbers.exact import mpq

SPLINE, WITH_KNOTS, RATIONAL = "B_SPLINE_CURVE", "B_SPLINE_CURVE_WITH_KNOTS", "RATIONAL_B_SPLINE_CURVE"
KINDS = (WITH_KNOTS, "BEZIER_CURVE", "UNIFORM_CURVE", "QUASI_UNIFORM_CURVE")
SKIPPED = {
    "PARABOLA": "unbounded", "HYPERBOLA": "unbounded", "TRIMMED_CURVE": "trimming is not applied",
    "COMPOSITE_CURVE": "its parts are read separately", "OFFSET_CURVE_2D": "not rational",
    "OFFSET_CURVE_3D": "not rational", "B_SPLINE_SURFACE_WITH_KNOTS": "a surface", "B_SPLINE_SURFACE": "a surface",
    "CLOTHOID": "not rational", "CURVE_REPLICA": "copies are not placed",
}  # fmt: skip
#: Skipped entities that are not curves.
NO_CURVE = ("COMPOSITE_CURVE", "B_SPLINE_SURFACE_WITH_KNOTS", "B_SPLINE_SURFACE")
#: Entities that place parts.
PLACING = (
    "MAPPED_ITEM", "ITEM_DEFINED_TRANSFORMATION", "CARTESIAN_TRANSFORMATION_OPERATOR_3D",
    "CARTESIAN_TRANSFORMATION_OPERATOR_2D", "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION",
)  # fmt: skip
_METRE = re.compile(r"\bSI_UNIT\s*\(\s*(\$|\.[A-Z]+\.)\s*,\s*\.METRE\.\s*\)")
_CONVERSION = re.compile(r"\bCONVERSION_BASED_UNIT\s*\(\s*'([^']{1,40})'")
_KEYWORD = re.compile(r"\(?\s*([A-Z0-9_]+)")
_REFERENCE = re.compile(r"#(\d{1,12})", re.ASCII)
_CURVE = re.compile(rf"\b(?:{SPLINE}|{'|'.join(KINDS)})\b")


def looks_like(head: bytes) -> bool:
    """Whether a file begins with the header of part 21."""
    return head.lstrip().startswith(b"ISO-10303-21")


def read(source: Source) -> Reading:
    """The curves of a file, in the order of the file."""
    collector = Collector("step", source)
    file = StepFile(source.text, collector)
    edges = Edges(file)
    for number, text in file.instances.items():
        where = f"#{number}"
        match = _KEYWORD.match(text)
        keyword = match[1] if match else ""
        if keyword == "POLYLINE" or (_CURVE.search(text) and (text.startswith("(") or keyword in (SPLINE, *KINDS))):
            with collector.skipping(keyword, where):
                _curve(file, parts(text, source.limits), where, edges.notes(number))
        elif keyword in ELEMENTARY or keyword == EDGE:
            with collector.skipping(keyword, where):
                edges.read(keyword, number, where)
        elif keyword in SKIPPED:
            collector.skip(keyword, where, SKIPPED[keyword], curve=keyword not in NO_CURVE)
        elif keyword in PLACING:
            collector.note("the file places parts: curves are read where they are defined")
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
    kind = next((kind for kind in ("POLYLINE", *KINDS) if kind in entity), "")
    if kind == "POLYLINE":
        points = [file.point(reference) for reference in file.texts(_last(entity[kind]))]
        knots = [mpq(max(0, min(i - 1, len(points) - 1))) for i in range(len(points) + 2)]
        file.collector.add(kind, where, 1, knots, points, name=_name(entity[kind], where), notes=notes)
        return
    if not kind:
        raise CurveFileError("a B-spline curve without knots", remedy=f"one of {', '.join(KINDS)} is required")
    if SPLINE in entity:
        base, specific, name = entity[SPLINE], entity[kind], entity.get("REPRESENTATION_ITEM", [])
    else:
        base, specific, name = entity[kind][1:], entity[kind][6:], entity[kind]
    if len(base) < 5 or not isinstance(base[0], str) or (kind == WITH_KNOTS and len(specific) < 2):
        raise CurveFileError("attributes are missing", remedy="complete the instance")
    degree = whole(base[0])
    if not 0 <= degree <= file.limits.degree:
        raise CurveFileError(f"degree {degree}", remedy=f"at most {file.limits.degree} is read")
    points = [file.point(reference) for reference in file.texts(base[1])]
    knots = _listed(file, specific) if kind == WITH_KNOTS else _standard(kind, degree, len(points))
    weights = file.numbers(entity[RATIONAL][0]) if entity.get(RATIONAL) else None
    notes = [*notes, *([] if kind == WITH_KNOTS else [f"{kind}: knots as defined by the standard"])]
    file.collector.add(kind, where, degree, knots, points, weights, name=_name(name, where), notes=notes)


def _last(arguments: list[Value]) -> Value:
    return arguments[-1] if arguments else ""


def _name(arguments: list[Value], where: str) -> str:
    text = arguments[0] if arguments and isinstance(arguments[0], str) else ""
    return text.strip("'").replace("''", "'") or where


def _listed(file: StepFile, arguments: list[Value]) -> list[mpq]:
    counts, values = [whole(text) for text in file.texts(arguments[0])], file.numbers(arguments[1])
    if len(counts) != len(values) or any(count < 0 for count in counts):
        raise CurveFileError(
            f"{counted(len(counts), 'multiplicity')} for {counted(len(values), 'knot')}", remedy="give one per knot"
        )
    file.collector.count(sum(counts))
    return [knot for knot, times in zip(values, counts, strict=True) for _ in range(times)]


def _standard(kind: str, degree: int, count: int) -> list[mpq]:
    """The knots that ISO 10303-42 defines for the kinds of curves that do not list them."""
    if kind == "UNIFORM_CURVE":
        return [mpq(i - degree) for i in range(count + degree + 1)]
    times = degree if kind == "BEZIER_CURVE" else 1
    if degree < 1 or count <= degree or (count - 1 - degree) % times:
        raise CurveFileError(
            f"{counted(count, 'point')} for degree {degree}",
            remedy="this kind of curve needs a different number of points",
        )
    inner = [mpq(i // times + 1) for i in range(count - 1 - degree)]
    return [mpq(0)] * (degree + 1) + inner + [mpq((count - 1 - degree) // times + 1)] * (degree + 1)


_HEADER = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION(('curves'),'2;1');
FILE_NAME('','',(''),(''),'exactspline','exactspline','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));
ENDSEC;
DATA;
"""


def write(curves: Sequence[NamedCurve], numbers: NumberText) -> bytes:
    """The curves in one set per dimension, each set in a context of its dimension."""
    lines: list[str] = []

    def add(text: str) -> str:
        lines.append(f"#{len(lines) + 1}={text};")
        return f"#{len(lines)}"

    units = [add(f"({unit})") for unit in _UNITS]
    for dimension in sorted({named.curve.dimension for named in curves}):
        references = [_written(named, numbers, add) for named in curves if named.curve.dimension == dimension]
        collected = add(f"GEOMETRIC_CURVE_SET('',({','.join(references)}))")
        context = add(
            f"(GEOMETRIC_REPRESENTATION_CONTEXT({dimension}) GLOBAL_UNIT_ASSIGNED_CONTEXT(({','.join(units)})) "
            "REPRESENTATION_CONTEXT('',''))"
        )
        shape = add(f"GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION('',({collected}),{context})")
        _product(shape, add)
    return (_HEADER + "\n".join(lines) + "\nENDSEC;\nEND-ISO-10303-21;\n").encode()


def _product(shape: str, add: Callable[[str], str]) -> None:
    """Add a part with this shape: other programs show only shapes that belong to a part."""
    application = add("APPLICATION_CONTEXT('automotive design')")
    add(f"APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,{application})")
    context = add(f"PRODUCT_CONTEXT('',{application},'mechanical')")
    product = add(f"PRODUCT('curves','curves','',({context}))")
    formation = add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
    stage = add(f"PRODUCT_DEFINITION_CONTEXT('part definition',{application},'design')")
    definition = add(f"PRODUCT_DEFINITION('design','',{formation},{stage})")
    defined = add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")
    add(f"SHAPE_DEFINITION_REPRESENTATION({defined},{shape})")


_UNITS = (
    "LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.)",
    "NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.)",
    "NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT()",
)


def _written(named: NamedCurve, numbers: NumberText, add: Callable[[str], str]) -> str:
    curve = named.curve
    points = [add(f"CARTESIAN_POINT('',{_reals(numbers, point)})") for point in cartesian(curve)]
    closed = ".T." if curve.closed else ".F."
    base = f"{curve.degree},({','.join(points)}),.UNSPECIFIED.,{closed},.U."
    counts = ",".join(map(str, curve.knots.multiplicities))
    knots = f"({counts}),{_reals(numbers, curve.knots.breakpoints)},.UNSPECIFIED."
    name = "'" + "".join(c for c in named.name if " " <= c <= "~" and c != "\\").replace("'", "''") + "'"
    if curve.polynomial:
        return add(f"{WITH_KNOTS}({name},{base},{knots})")
    weights = _reals(numbers, curve.weights)
    return add(
        f"(BOUNDED_CURVE() {SPLINE}({base}) {WITH_KNOTS}({knots}) CURVE() GEOMETRIC_REPRESENTATION_ITEM() "
        f"{RATIONAL}({weights}) REPRESENTATION_ITEM({name}))"
    )


def _reals(numbers: NumberText, values: Sequence[mpq]) -> str:
    """A list of reals."""
    return f"({','.join(with_point(numbers(value)) for value in values)})"


FORMAT = Format("step", "STEP part 21", (".stp", ".step", ".p21"), looks_like, read, write)
