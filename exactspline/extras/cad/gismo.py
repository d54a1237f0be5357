"""G+Smo XML: ``<Geometry type="BSpline">``, ``"Nurbs"`` and the surfaces ``"TensorBSpline2"`` and ``"TensorNurbs2"``
anywhere in the file; Cartesian control points, those of a surface along u first.
"""

from __future__ import annotations

from collections.abc import Sequence

from exactspline.errors import CurveFileError, counted
from exactspline.interchange.collector import Collector
from exactspline.interchange.format import Format, Spline
from exactspline.interchange.numbers import NumberText, whole
from exactspline.interchange.records import Reading, Source
from exactspline.interchange.xml_tree import Element, attribute, parse
from exactspline.numbers.exact import mpq

CURVES = ("BSpline", "Nurbs")
SURFACES = ("TensorBSpline2", "TensorNurbs2")


def _looks_like(head: bytes) -> bool:
    """Whether a file begins like one written by G+Smo."""
    return b"<Geometry" in head or (b"<xml" in head and b"<Multipatch" in head)


def _read(source: Source) -> Reading:
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
            collector.skip(f"geometry {kind}", where, curve=False)
            continue
        with collector.skipping(f"geometry {kind}", where, curve=kind in CURVES):
            sides, points, weights = _parts(collector, element, 1 if kind in CURVES else 2)
            name = element.attributes.get("label", "")
            degrees, vectors = zip(*sides, strict=True)
            collector.add_spline(f"geometry {kind}", where, degrees, vectors, points, weights, name=name)
    return collector.reading()


Side = tuple[int, list[mpq]]


def _parts(
    collector: Collector, element: Element, parameters: int
) -> tuple[list[Side], list[list[mpq]], list[mpq] | None]:
    """Degree and knots of each parameter, the control points and the weights."""
    below = list(element.walk())
    vectors = [e for e in below if e.tag == "KnotVector"]
    coefficients = [e for e in below if e.tag == "coefs"]
    if len(vectors) != parameters or len(coefficients) != 1:
        problem = f"{counted(len(vectors), 'knot vector')} and {len(coefficients)} coefs"
        raise CurveFileError(problem, where="Basis", remedy=f"{parameters} and 1 are needed")
    sides = [_side(collector, vector) for vector in vectors]
    values = collector.numbers(coefficients[0].text.split())
    dimension = whole(coefficients[0].attributes.get("geoDim", ""))
    if dimension < 1 or len(values) % dimension:
        problem = f"{counted(len(values), 'number')} for points of dimension {dimension}"
        raise CurveFileError(problem, where="coefs", remedy="give full rows")
    points = [values[i : i + dimension] for i in range(0, len(values), dimension)]
    return sides, points, next((collector.numbers(e.text.split()) for e in below if e.tag == "weights"), None)


def _side(collector: Collector, vector: Element) -> Side:
    if vector.attributes.get("mode", "list") not in ("list", "graded"):
        raise CurveFileError("a knot vector without a list of knots", where="KnotVector", remedy="write out the knots")
    return whole(vector.attributes.get("degree", "")), collector.numbers(vector.text.split())


def _write(splines: Sequence[Spline], numbers: NumberText) -> bytes:
    """One geometry per curve or surface."""
    lines = ['<?xml version="1.0" encoding="UTF-8"?>', "<xml>"]
    for i, spline in enumerate(splines):
        points, weights = zip(*spline.cartesian(), strict=True)
        kind = (SURFACES if spline.is_surface else CURVES)[not spline.polynomial]
        basis = _basis(spline, numbers)
        if not spline.polynomial:
            written = f"  <weights>{' '.join(map(numbers, weights))}</weights>"
            tensor = "TensorNurbsBasis2" if spline.is_surface else "NurbsBasis"
            basis = [f' <Basis type="{tensor}">', *basis, written, " </Basis>"]
        rows = [" ".join(map(numbers, point)) for point in points]
        lines += [f'<Geometry type="{kind}" id="{i}" label={attribute(spline.name)}>', *basis]
        lines += [f' <coefs geoDim="{spline.dimension}">', *rows, " </coefs>", "</Geometry>"]
    return "\n".join([*lines, "</xml>", ""]).encode()


def _basis(spline: Spline, numbers: NumberText) -> list[str]:
    vectors = [
        f'<KnotVector degree="{degree}">{" ".join(map(numbers, knots))}</KnotVector>'
        for degree, knots in zip(spline.degrees, spline.knots, strict=True)
    ]
    if not spline.is_surface:
        return [' <Basis type="BSplineBasis">', f"  {vectors[0]}", " </Basis>"]
    bases = [f'  <Basis type="BSplineBasis" index="{k}">{vector}</Basis>' for k, vector in enumerate(vectors)]
    return [' <Basis type="TensorBSplineBasis2">', *bases, " </Basis>"]


FORMAT = Format("gismo", "G+Smo XML", (".xml",), _looks_like, _read, _write, surfaces=True)
