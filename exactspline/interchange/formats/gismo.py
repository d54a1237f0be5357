"""G+Smo XML: ``<Geometry type="BSpline">``, ``"Nurbs"`` and the surfaces ``"TensorBSpline2"`` and ``"TensorNurbs2"``
anywhere in the file; Cartesian control points, those of a surface along u first.
"""

from __future__ import annotations

from collections.abc import Sequence

from exactspline.errors import CurveFileError, counted
from exactspline.interchange.collector import Collector
from exactspline.interchange.numbers import NumberText, whole
from exactspline.interchange.records import Format, NamedCurve, Reading, Source
from exactspline.interchange.writing import Point, cartesian, cartesian_net
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
    geometries = []
    for i, named in enumerate(curves):
        curve = named.curve
        basis = [' <Basis type="BSplineBasis">', f"  {_vector(curve.degree, curve.knots.knots, numbers)}", " </Basis>"]
        head = f'<Geometry type="{CURVES[not curve.polynomial]}" id="{i}" label={attribute(named.name)}>'
        rational = None if curve.polynomial else ("NurbsBasis", curve.weights)
        geometries.append([head, *_geometry(basis, rational, cartesian(curve), numbers)])
    return _document(geometries)


def write_surfaces(surfaces: Sequence[NurbsSurface], numbers: NumberText) -> bytes:
    """The surfaces, one geometry per surface."""
    geometries = []
    for i, surface in enumerate(surfaces):
        points, weights = zip(*cartesian_net(surface), strict=True)
        vectors = [
            f'  <Basis type="BSplineBasis" index="{k}">{_vector(degree, knots.knots, numbers)}</Basis>'
            for k, (degree, knots) in enumerate(zip(surface.degree, surface.knots, strict=True))
        ]
        basis = [' <Basis type="TensorBSplineBasis2">', *vectors, " </Basis>"]
        head = f'<Geometry type="{SURFACES[not surface.polynomial]}" id="{i}" label={attribute(surface.name)}>'
        rational = None if surface.polynomial else ("TensorNurbsBasis2", weights)
        geometries.append([head, *_geometry(basis, rational, points, numbers)])
    return _document(geometries)


def _vector(degree: int, knots: Sequence[mpq], numbers: NumberText) -> str:
    return f'<KnotVector degree="{degree}">{" ".join(map(numbers, knots))}</KnotVector>'


def _geometry(
    basis: list[str], rational: tuple[str, Sequence[mpq]] | None, points: Sequence[Point], numbers: NumberText
) -> list[str]:
    """What is in a geometry: the basis, in a rational one with weights where there is one, and the control points."""
    if rational is not None:
        kind, weights = rational
        basis = [
            f' <Basis type="{kind}">',
            *basis,
            f"  <weights>{' '.join(map(numbers, weights))}</weights>",
            " </Basis>",
        ]
    rows = [" ".join(map(numbers, point)) for point in points]
    return [*basis, f' <coefs geoDim="{len(points[0])}">', *rows, " </coefs>", "</Geometry>"]


def _document(geometries: Sequence[list[str]]) -> bytes:
    lines = [line for geometry in geometries for line in geometry]
    return "\n".join(['<?xml version="1.0" encoding="UTF-8"?>', "<xml>", *lines, "</xml>", ""]).encode()


FORMAT = Format("gismo", "G+Smo XML", (".xml",), looks_like, read, write, write_surfaces=write_surfaces)
