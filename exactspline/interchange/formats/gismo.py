"""G+Smo XML: ``<Geometry type="BSpline">`` and ``"Nurbs"`` anywhere in the file; Cartesian control points."""

from __future__ import annotations

from collections.abc import Sequence

from exactspline.errors import CurveFileError, counted
from exactspline.interchange.collector import Collector
from exactspline.interchange.numbers import NumberText, whole
from exactspline.interchange.records import Format, NamedCurve, Reading, Source
from exactspline.interchange.writing import cartesian
from exactspline.interchange.xml_tree import Element, attribute, parse
from exactspline.numbers.exact import mpq

CURVES = ("BSpline", "Nurbs")


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
        if kind not in CURVES:
            collector.skip(f"geometry {kind}", where, "not a spline curve", curve=False)
            continue
        with collector.skipping(f"geometry {kind}", where):
            degree, knots, points, weights = _parts(collector, element)
            name = element.attributes.get("label", "")
            collector.add(f"geometry {kind}", where, degree, knots, points, weights, name=name)
    return collector.reading()


def _parts(collector: Collector, element: Element) -> tuple[int, list[mpq], list[list[mpq]], list[mpq] | None]:
    below = list(element.walk())
    vectors = [e for e in below if e.tag == "KnotVector"]
    coefficients = next((e for e in below if e.tag == "coefs"), None)
    if len(vectors) != 1 or coefficients is None:
        raise CurveFileError(
            f"{len(vectors)} knot vectors", where="Basis", remedy="a curve has one knot vector, and coefs"
        )
    knots = collector.numbers(vectors[0].text.split())
    if vectors[0].attributes.get("mode", "list") != "list" and vectors[0].attributes["mode"] != "graded":
        raise CurveFileError("a knot vector without a list of knots", where="KnotVector", remedy="write out the knots")
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
    return whole(vectors[0].attributes.get("degree", "")), knots, points, weights


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


FORMAT = Format("gismo", "G+Smo XML", (".xml",), looks_like, read, write)
