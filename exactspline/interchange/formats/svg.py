"""SVG: paths and basic shapes, one curve per subpath, in the coordinates of the outermost ``<svg>``.

Lines, quadratics and cubics are exact, elliptic arcs where their centre is rational and their axes are parallel to the
coordinate axes (or they are circular); a subpath with another arc is skipped. Transforms are applied exactly; one with
an irrational sine, cosine or tangent skips what it moves. Path data with an error count up to the error, as the
standard says. Definitions (`defs`, `marker`, …) and copies (`use`) are skipped. svgelements and
svgpathtools hold floats, so the text is parsed here.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import pairwise

from exactspline.errors import ExactSplineError, ShapeError
from exactspline.exact import mpq
from exactspline.interchange.affine import Affine
from exactspline.interchange.collector import Collector
from exactspline.interchange.numbers import NumberText, decimal
from exactspline.interchange.records import Format, NamedCurve, Reading, Source
from exactspline.interchange.segments import Segment, arc_around_origin, joined, mapped, polynomial
from exactspline.interchange.svg_paths import Subpath, subpaths
from exactspline.interchange.svg_transforms import transform
from exactspline.interchange.writing import pen_segments
from exactspline.interchange.xml_tree import Element, attribute, parse

DEFINITIONS = ("defs", "symbol", "marker", "clipPath", "mask", "pattern", "linearGradient", "font", "glyph")
SKIPPED = {"use": "a placed copy is not followed", "text": "glyphs need a font", "image": "no curve"}
SHAPES = ("path", "line", "polyline", "polygon", "rect", "circle", "ellipse")
IDENTITY = Affine.identity(2)


LOSES = "SVG holds no knots: segments are kept, their parameter intervals are not"


def looks_like(head: bytes) -> bool:
    """Whether an element svg begins near the start."""
    return bool(re.search(rb"<(\w+:)?svg[\s>]", head))


def read(source: Source) -> Reading:
    """The curves of a file in the order of drawing."""
    found = Collector("svg", source)
    waiting: list[tuple[Element, Affine]] = [(parse(source.data, source.limits), IDENTITY)]
    root = waiting[0][0]
    while waiting:
        element, placed = waiting.pop()
        where = f"{element.tag} at line {element.line}"
        if element.tag in DEFINITIONS:
            for below in element.walk():
                if below.tag in SHAPES:
                    found.skip(below.tag, f"{below.tag} at line {below.line}", f"not drawn: inside {element.tag}")
            continue
        if element.tag in SKIPPED:
            found.skip(element.tag, where, SKIPPED[element.tag])
            continue
        try:
            placed = placed @ _own_transform(element, element is root, source)
            if element.tag in SHAPES:
                _shape(found, element, where, placed)
        except ExactSplineError as error:
            found.skip(element.tag, where, str(error))
            continue
        waiting += [(child, placed) for child in reversed(element.children)]
    return found.reading()


def _own_transform(element: Element, is_root: bool, source: Source) -> Affine:
    if element.tag == "svg" and not is_root and {"x", "y", "viewBox"} & element.attributes.keys():
        raise ShapeError("an inner svg with its own view", remedy="flatten the drawing")
    if re.search(r"(?:^|[;\s])transform\s*:", element.attributes.get("style", "")):
        raise ShapeError("a transform in CSS", remedy="write it as an attribute")
    return transform(element.attributes.get("transform", ""), source.limits)


def _shape(found: Collector, element: Element, where: str, placed: Affine) -> None:
    name = element.attributes.get("id") or f"{element.tag} {element.line}"
    if element.tag == "path":
        parsed, problem = subpaths(element.attributes.get("d", ""), found.limits)
    else:
        parsed, problem = [Subpath(_basic(found, element))], ""
    notes = [f"{problem}: read up to there"] if problem else []
    several = len(parsed) > 1
    for i, part in enumerate(parsed, 1):
        place = f"{where}, subpath {i}" if several else where
        if part.problem:
            found.skip("subpath", place, part.problem)
            continue
        _add(found, element.tag, place, mapped(part.segments, placed), f"{name}.{i}" if several else name, notes)


def _add(found: Collector, what: str, where: str, segments: Sequence[Segment], name: str, notes: Sequence[str]) -> None:
    degree, knots, points = joined(segments)
    if {point[-1] for point in points} == {1}:
        found.add(what, where, degree, knots, [point[:-1] for point in points], name=name, notes=notes)
    else:
        found.add(what, where, degree, knots, points, homogeneous=True, name=name, notes=notes)


def _basic(found: Collector, element: Element) -> list[Segment]:
    """The segments of a basic shape, in the order in which the standard draws them."""

    def length(attribute: str) -> mpq:
        text = element.attributes.get(attribute, "0").strip()
        return decimal(text.removesuffix("px"), found.limits)

    if element.tag == "line":
        return [polynomial((length("x1"), length("y1")), (length("x2"), length("y2")))]
    if element.tag in ("circle", "ellipse"):
        circle = element.tag == "circle"
        rx, ry = (length("r"), length("r")) if circle else (length("rx"), length("ry"))
        if rx <= 0 or ry <= 0:
            raise ShapeError("no radius is positive", remedy="nothing is drawn")
        one = (mpq(1), mpq(0))
        return mapped(arc_around_origin(one, one), Affine([[rx, 0, length("cx")], [0, ry, length("cy")]]))
    if element.tag == "rect":
        if {"rx", "ry"} & element.attributes.keys():
            raise ShapeError("a rectangle with round corners", remedy="write it as a path")
        x, y, width, height = map(length, ("x", "y", "width", "height"))
        corners = [(x, y), (x + width, y), (x + width, y + height), (x, y + height), (x, y)]
    else:
        texts = element.attributes.get("points", "").replace(",", " ").split()
        found.count(len(texts))
        numbers = [decimal(text, found.limits) for text in texts]
        corners = list(zip(numbers[::2], numbers[1::2], strict=False))
        corners += corners[:1] if element.tag == "polygon" and corners[:1] != corners[-1:] else []
    if len(corners) < 2:
        raise ShapeError("fewer than two points", remedy="nothing is drawn")
    return [polynomial(a, b) for a, b in pairwise(corners)]


def write(curves: Sequence[NamedCurve], numbers: NumberText) -> bytes:
    """Polynomial plane curves of degree 1 to 3 as paths; SVG holds no knots: the segments are kept, their parameter
    intervals are not.
    """
    paths = []
    for named in curves:
        segments = pen_segments(named.curve)
        letter = " LQC"[named.curve.degree]
        data = [f"M{_pair(numbers, segments[0][0])}"]
        data += [letter + " ".join(_pair(numbers, point) for point in points[1:]) for points in segments]
        paths.append(f'<path id={attribute(named.name)} d="{" ".join(data)}" fill="none" stroke="black"/>')
    return "\n".join(['<svg xmlns="http://www.w3.org/2000/svg">', *paths, "</svg>", ""]).encode()


def _pair(numbers: NumberText, point: Sequence[mpq]) -> str:
    return ",".join(map(numbers, point))


FORMAT = Format("svg", "SVG paths and shapes", (".svg",), looks_like, read, write, LOSES)
