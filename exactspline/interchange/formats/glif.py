"""GLIF, a glyph of a UFO: one curve per contour, in font units, with decimals read exactly.

fontTools also reads these files but converts decimals to doubles; so the XML is read here, and fontTools only
interprets the points (the extra `formats`). Components, which are defined in other files, are skipped.
"""

from __future__ import annotations

from exactspline.errors import CurveFileError
from exactspline.interchange.collector import Collector
from exactspline.interchange.format import Format
from exactspline.interchange.numbers import decimal
from exactspline.interchange.pens import ContourPen
from exactspline.interchange.records import Reading, Source
from exactspline.interchange.xml_tree import Element, parse

TYPES = {None: None, "offcurve": None, "move": "move", "line": "line", "curve": "curve", "qcurve": "qcurve"}


def _looks_like(head: bytes) -> bool:
    """Whether a file is XML with a glyph element."""
    return b"<glyph" in head[:2000] and b"<svg" not in head[:2000]


def read(source: Source) -> Reading:
    """The contours of the glyph."""
    collector = Collector("glif", source)
    try:
        from fontTools.pens.pointPen import PointToSegmentPen
    except ImportError:
        raise CurveFileError("fontTools is not installed", remedy="pip install fonttools") from None
    root = parse(source.data, source.limits)
    if root.tag != "glyph":
        raise CurveFileError(f"<{root.tag[:40]}> where <glyph> is expected", remedy="give a GLIF file")
    outline = root.first("outline")
    number = 0
    for element in outline.children if outline else ():
        where = f"line {element.line}"
        if element.tag != "contour":
            placed = element.tag == "component"
            why = "it is defined in another file; decompose the glyph" if placed else "not a curve"
            collector.skip(element.tag[:40], where, why, curve=placed)
            continue
        number += 1
        pen, name = ContourPen(source.limits.objects), f"{root.attributes.get('name', 'glyph')}.{number}"
        with collector.skipping("contour", where, damaged="its points do not form a contour"):
            points = PointToSegmentPen(pen)
            points.beginPath()
            for point in element.children:
                _add(points, point, source)
            points.endPath()
            for degree, knots, places in pen.contours:
                collector.add("contour", where, degree, knots, places, name=name)
    return collector.reading()


def _add(points: object, point: Element, source: Source) -> None:
    if point.tag != "point":
        raise CurveFileError(f"<{point.tag[:40]}> in a contour", where=f"line {point.line}", remedy="write points")
    given = point.attributes
    if given.get("type") not in TYPES or not {"x", "y"} <= set(given):
        raise CurveFileError("a point without x, y or a known type", where=f"line {point.line}", remedy="correct it")
    place = tuple(decimal(given[axis], source.limits) for axis in "xy")
    points.addPoint(place, TYPES[given.get("type")], given.get("smooth") == "yes")  # type: ignore[attr-defined]  # a pen


FORMAT = Format("glif", "GLIF glyph of a UFO", (".glif",), _looks_like, read)
