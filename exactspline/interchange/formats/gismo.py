"""G+Smo XML: ``<Geometry type="BSpline">``, ``"Nurbs"`` and the surfaces ``"TensorBSpline2"`` and ``"TensorNurbs2"``
anywhere in the file; Cartesian control points, those of a surface along u first.
"""

from __future__ import annotations

from collections.abc import Sequence

from exactspline.errors import CurveFileError, counted
from exactspline.interchange.collector import Collector
from exactspline.interchange.numbers import NumberText, whole
from exactspline.interchange.records import Format, NamedCurve, Reading, Source
from exactspline.interchange.writing import cartesian, cartesian_net
from exactspline.interchange.xml_tree import Element, attribute, parse
from exactspline.numbers.exact import mpq
from exactspline.splines.surface import NurbsSurface

CURVES = ("BSpline", "Nurbs")
SURFACES = ("TensorBSpline2", "TensorNurbs2")


def looks_like(head: bytes) -> bool:
    """Whether a file begins like one written by G+Smo."""
    return b"<Geometry" in head or (b"<xml" in head and b"<Multipatch" in head)


def read(source: Source) -> Reading:
    """The curves of a file."""
    collector = Collector("gismo", source)
    number = 0
    for element in parse(source.data, source.limits).walk():
        if element.tag != "Geometry":
            continue
        number += 1
        kind = element.attributes.get("type", "without a type")
        where = f"geometry {element.attributes.get('id', number)} (line {element.line})"
        if kind not in (*CURVES, *SURFACES):
            collector.skip(f"geometry {kind}", where, "neither a spline curve nor a spline surface", curve=False)
            continue
        with collector.skipping(f"geometry {kind}", where, curve=kind in CURVES):
            sides, points, weights = _parts(collector, element, 1 if kind in CURVES else 2)
            name = element.attributes.get("label", "")
            what, (degrees, vectors) = f"geometry {kind}", zip(*sides, strict=True)
            if kind in CURVES:
                collector.add(what, where, degrees[0], vectors[0], points, weights, name=name)
            else:
                pair, knots = (degrees[0], degrees[1]), (vectors[0], vectors[1])
                collector.add_surface(what, where, pair, knots, points, weights, name=name)
    return collector.reading()


Side = tuple[int, list[mpq]]


def _parts(
    collector: Collector, element: Element, parameters: int
) -> tuple[list[Side], list[list[mpq]], list[mpq] | None]:
    """Degree and knots of each parameter, the control points and the weights."""
    below = list(element.walk())
    vectors = [e for e in below if e.tag == "KnotVector"]
    coefficients = next((e for e in below if e.tag == "coefs"), None)
    if len(vectors) != parameters or coefficients is None:
        raise CurveFileError(
            f"{len(vectors)} knot vectors",
            where="Basis",
            remedy="a curve has one knot vector, a surface two, and both coefs",
        )
    sides = [_side(collector, vector) for vector in vectors]
    values = collector.numbers(coefficients.text.split())
    dimension = whole(coefficients.attributes.get("geoDim", ""))
    if dimension < 1 or len(values) % dimension:
        raise CurveFileError(
            f"{counted(len(values), 'number')} for points of dimension {dimension}",
            where="coefs",
            remedy="give full rows",
        )
    points = [values[i : i + dimension] for i in range(0, len(values), dimension)]
    weights = next((collector.numbers(e.text.split()) for e in below if e.tag == "weights"), None)
    return sides, points, weights


def _side(collector: Collector, vector: Element) -> Side:
    if vector.attributes.get("mode", "list") not in ("list", "graded"):
        raise CurveFileError("a knot vector without a list of knots", where="KnotVector", remedy="write out the knots")
    return whole(vector.attributes.get("degree", "")), collector.numbers(vector.text.split())


def write(curves: Sequence[NamedCurve], numbers: NumberText) -> bytes:
    """The curves, one geometry per curve."""
    lines = ['<?xml version="1.0" encoding="UTF-8"?>', "<xml>"]
    for i, named in enumerate(curves):
        curve = named.curve
        vector = f'<KnotVector degree="{curve.degree}">{" ".join(map(numbers, curve.knots))}</KnotVector>'
        basis = [' <Basis type="BSplineBasis">', f"  {vector}", " </Basis>"]
        if not curve.polynomial:
            weights = " ".join(map(numbers, curve.weights))
            basis = [' <Basis type="NurbsBasis">', *basis, f"  <weights>{weights}</weights>", " </Basis>"]
        kind = "BSpline" if curve.polynomial else "Nurbs"
        lines += [
            f'<Geometry type="{kind}" id="{i}" label={attribute(named.name)}>',
            *basis,
            f' <coefs geoDim="{curve.dimension}">',
            *(" ".join(map(numbers, point)) for point in cartesian(curve)),
            " </coefs>",
            "</Geometry>",
        ]
    return "\n".join([*lines, "</xml>", ""]).encode()


def write_surfaces(surfaces: Sequence[NurbsSurface], numbers: NumberText) -> bytes:
    """The surfaces, one geometry per surface."""
    lines = ['<?xml version="1.0" encoding="UTF-8"?>', "<xml>"]
    for i, surface in enumerate(surfaces):
        rows = cartesian_net(surface)
        vectors = [
            f'  <Basis type="BSplineBasis" index="{k}"><KnotVector degree="{degree}">'
            f"{' '.join(map(numbers, knots))}</KnotVector></Basis>"
            for k, (degree, knots) in enumerate(zip(surface.degree, surface.knots, strict=True))
        ]
        basis = [' <Basis type="TensorBSplineBasis2">', *vectors, " </Basis>"]
        if not surface.polynomial:
            weights = " ".join(numbers(weight) for _, weight in rows)
            basis = [' <Basis type="TensorNurbsBasis2">', *basis, f"  <weights>{weights}</weights>", " </Basis>"]
        kind = SURFACES[not surface.polynomial]
        lines += [
            f'<Geometry type="{kind}" id="{i}" label={attribute(surface.name)}>',
            *basis,
            f' <coefs geoDim="{surface.dimension}">',
            *(" ".join(map(numbers, point)) for point, _ in rows),
            " </coefs>",
            "</Geometry>",
        ]
    return "\n".join([*lines, "</xml>", ""]).encode()


FORMAT = Format("gismo", "G+Smo XML", (".xml",), looks_like, read, write, write_surfaces=write_surfaces)
