"""IRIT ``.itd``: ``[CURVE BSPLINE number order type [KV …] [point] …]`` and ``[CURVE BEZIER number type [point] …]``;
surfaces with two numbers, two orders and two knot vectors, their points along u first.

A point of type E is Cartesian, one of type P homogeneous with the weight first: (w, w x, w y). ``KVP`` marks a periodic
curve, which repeats its first control points. Free text between brackets is a comment.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from math import prod
from typing import Any

from exactspline.errors import CurveFileError, counted
from exactspline.interchange.collector import Collector
from exactspline.interchange.format import Format, Spline
from exactspline.interchange.numbers import Nested, NumberText, decimal, is_decimal, nested, whole
from exactspline.interchange.records import Reading, Source
from exactspline.interchange.segments import bezier_knots
from exactspline.numbers.exact import mpq

Node = list[Nested]

# an unclosed string extends to the end of the text, so that matching takes linear time
_TOKEN = re.compile(r'"(?:[^"\\]|\\[\s\S])*+\\?(?:"|\Z)|[][]|[^][\s"]+|"')
_POINT = re.compile(r"([EP])(\d)")
#: The number of parameters of an object.
PARAMETERS = {"CURVE": 1, "SURFACE": 2}
SKIPPED = ("TRIVAR", "MULTIVAR", "TRISRF", "POLYGON", "POLYLINE", "POINTLIST", "MODEL", "TRIMSRF")


def _looks_like(head: bytes) -> bool:
    """Whether there is an IRIT object near the beginning of a file."""
    return bool(re.search(rb"\[\s*OBJECT\b|\[\s*CURVE\s+(BSPLINE|BEZIER)\b", head))


def _read(source: Source) -> Reading:
    """The curves of a file."""
    collector = Collector("itd", source)
    waiting: list[tuple[Node, str]] = [(_tree(source, collector), "")]
    seen = Counter[str]()
    while waiting:
        node, name = waiting.pop()
        keyword = node[0] if node and isinstance(node[0], str) else ""
        if keyword == "OBJECT":
            name = next((item for item in node[1:] if isinstance(item, str)), "")
        if keyword in PARAMETERS:
            what, seen[keyword] = keyword.lower(), seen[keyword] + 1
            where = f"{what} {seen[keyword]}" + (f" ({name})" if name else "")
            with collector.skipping(what, where, curve=keyword == "CURVE"):
                _spline(collector, node, where, name, PARAMETERS[keyword])
        elif keyword in SKIPPED:
            if keyword == "TRIMSRF":
                collector.note("trims of surfaces are not read")
            collector.skip(keyword.lower(), name or "unnamed object", curve=keyword == "POLYLINE")
        else:
            waiting += [(item, name) for item in reversed(node) if isinstance(item, list)]
    return collector.reading()


def _tree(source: Source, collector: Collector) -> Node:
    """The bracketed text as nested lists."""
    tokens = _TOKEN.findall(source.text)
    collector.count(tokens.count("["))
    return nested(tokens, "[]", source.limits, lambda: collector.note("a bracket closes nothing: remove it"))


def _spline(collector: Collector, node: Node, where: str, name: str, parameters: int) -> None:
    what = "curve" if parameters == 1 else "surface"
    words = [item for item in node[1:] if isinstance(item, str)]
    kind, bezier = (words[0] if words else ""), words[:1] == ["BEZIER"]
    size = parameters if bezier else 2 * parameters
    if kind not in ("BSPLINE", "BEZIER") or len(words) < size + 2:
        raise CurveFileError(f"a {what} of kind {kind[:20]!r}", remedy="BSPLINE and BEZIER are read")
    sizes = [whole(word) for word in words[1 : size + 1]]
    counts, orders = sizes[:parameters], sizes[-parameters:]
    match = _POINT.fullmatch(words[size + 1])
    if not match:
        raise CurveFileError("an unknown type of points", remedy="E2, E3, P2, P3 and the like are read")
    lists = [item for item in node[1:] if isinstance(item, list)]
    vectors = [item for item in lists if item and item[0] in ("KV", "KVP")]
    rows = [row for row in lists if all(isinstance(x, str) and is_decimal(x) for x in row)]
    points = [_numbers(collector, row) for row in rows]
    dimension, homogeneous = int(match[2]), match[1] == "P"
    if len(points) != prod(counts) or any(len(row) != dimension + homogeneous for row in points):
        problem = f"{counted(len(points), 'point')}, but {prod(counts)} of type {match[0]} are announced"
        raise CurveFileError(problem, remedy="the two must agree")
    if homogeneous:
        points = [[*row[1:], row[0]] for row in points]
    if not bezier and len(vectors) != parameters:
        raise CurveFileError(f"{len(vectors)} knot vectors", remedy="a curve has one, a surface two")
    knots = [bezier_knots(n - 1) for n in orders] if bezier else [_numbers(collector, each[1:]) for each in vectors]
    flagged = ["periodic"] if not bezier and any(each[0] == "KVP" for each in vectors) else []
    if flagged and parameters > 1:
        raise CurveFileError("a periodic surface", remedy="write it with knots marked by KV")
    degrees = [order - 1 for order in orders]
    more: dict[str, Any] = {"homogeneous": homogeneous, "flagged": flagged, "name": name}
    collector.add_spline(what, where, degrees, knots, points, **more)


def _numbers(collector: Collector, row: Node) -> list[mpq]:
    collector.count(len(row))
    return [decimal(item, collector.limits) if isinstance(item, str) else mpq(0) for item in row]


def _write(splines: Sequence[Spline], numbers: NumberText) -> bytes:
    """One object per curve or surface."""
    lines = []
    for spline in splines:
        what = "SURFACE" if spline.is_surface else "CURVE"
        name = re.sub(r"\W+", "_", spline.name, flags=re.ASCII) or what
        sizes = " ".join(map(str, [*spline.counts, *(degree + 1 for degree in spline.degrees)]))
        kind = f"{'E' if spline.polynomial else 'P'}{spline.dimension}"
        rows = spline.rows() if spline.polynomial else [(row[-1], *row[:-1]) for row in spline.rows()]
        lines += [f"[OBJECT {name}", f" [{what} BSPLINE {sizes} {kind}"]
        lines += [f"  [KV {' '.join(map(numbers, knots))}]" for knots in spline.knots]
        lines += [*(f"  [{' '.join(map(numbers, row))}]" for row in rows), " ]", "]"]
    return "\n".join([*lines, ""]).encode()


FORMAT = Format("itd", "IRIT text", (".itd",), _looks_like, _read, _write, surfaces=True)
