"""IRIT ``.itd``: ``[CURVE BSPLINE number order type [KV …] [point] …]`` and ``[CURVE BEZIER number type [point] …]``;
surfaces with two numbers, two orders and two knot vectors, their points along u first.

A point of type E is Cartesian, one of type P homogeneous with the weight first: (w, w x, w y). ``KVP`` marks a periodic
curve, which repeats its first control points. Free text between brackets is a comment.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TypeAlias

from exactspline.errors import CurveFileError, counted
from exactspline.interchange.collector import Collector
from exactspline.interchange.numbers import NumberText, decimal, is_decimal, whole
from exactspline.interchange.records import Format, NamedCurve, Reading, Source
from exactspline.interchange.segments import bezier_knots
from exactspline.interchange.writing import homogeneous, homogeneous_net, net_rows
from exactspline.numbers.exact import mpq
from exactspline.splines.surface import NurbsSurface

Node: TypeAlias = "list[str | Node]"

# an unclosed string extends to the end of the text, so that matching takes linear time
_TOKEN = re.compile(r'"(?:[^"\\]|\\[\s\S])*+\\?(?:"|\Z)|[][]|[^][\s"]+|"')
_POINT = re.compile(r"([EP])(\d)")
SKIPPED = ("TRIVAR", "MULTIVAR", "TRISRF", "POLYGON", "POLYLINE", "POINTLIST", "MODEL", "TRIMSRF")


def looks_like(head: bytes) -> bool:
    """Whether there is an IRIT object near the beginning of a file."""
    return bool(re.search(rb"\[\s*OBJECT\b|\[\s*CURVE\s+(BSPLINE|BEZIER)\b", head))


def read(source: Source) -> Reading:
    """The curves of a file."""
    collector = Collector("itd", source)
    waiting: list[tuple[Node, str]] = [(_tree(source, collector), "")]
    number = surfaces = 0
    while waiting:
        node, name = waiting.pop()
        keyword = node[0] if node and isinstance(node[0], str) else ""
        if keyword == "OBJECT":
            name = next((item for item in node[1:] if isinstance(item, str)), "")
        if keyword == "CURVE":
            number += 1
            where = f"curve {number}" + (f" ({name})" if name else "")
            with collector.skipping("curve", where):
                _curve(collector, node, where, name)
        elif keyword == "SURFACE":
            surfaces += 1
            where = f"surface {surfaces}" + (f" ({name})" if name else "")
            with collector.skipping("surface", where, curve=False):
                _surface(collector, node, where, name)
        elif keyword in SKIPPED:
            if keyword == "TRIMSRF":
                collector.note("trims of surfaces are not read")
            why = "neither a spline curve nor a spline surface"
            collector.skip(keyword.lower(), name or "unnamed object", why, curve=keyword == "POLYLINE")
        else:
            waiting += [(item, name) for item in reversed(node) if isinstance(item, list)]
    return collector.reading()


def _tree(source: Source, collector: Collector) -> Node:
    """The bracketed text as nested lists."""
    root: Node = []
    nodes = [root]
    for match in _TOKEN.finditer(source.text):
        token = match[0]
        if token == "[":
            collector.count(1)
            if len(nodes) > source.limits.depth:
                raise CurveFileError("brackets are nested too deeply", remedy="read with a larger limit of depth")
            inner: Node = []
            nodes[-1].append(inner)
            nodes.append(inner)
        elif token == "]":
            if len(nodes) == 1:
                collector.skip("closing bracket", f"character {match.start()}", "it closes nothing", curve=False)
            else:
                nodes.pop()
        else:
            nodes[-1].append(token)
    if len(nodes) > 1:
        raise CurveFileError(f"{len(nodes) - 1} brackets are not closed", remedy="balance the brackets")
    return root


def _curve(collector: Collector, node: Node, where: str, name: str) -> None:
    words = [item for item in node[1:] if isinstance(item, str)]
    kind = words[0] if words else ""
    if kind not in ("BSPLINE", "BEZIER") or len(words) < (4 if kind == "BSPLINE" else 3):
        raise CurveFileError(f"a curve of kind {kind[:20]!r}", remedy="BSPLINE and BEZIER are read")
    count = whole(words[1])
    order = whole(words[2]) if kind == "BSPLINE" else count
    match = _POINT.fullmatch(words[3] if kind == "BSPLINE" else words[2])
    if not match:
        raise CurveFileError("an unknown type of points", remedy="E2, E3, P2, P3 and the like are read")
    rows = [item for item in node[1:] if isinstance(item, list) and not (item and item[0] in ("KV", "KVP"))]
    vectors = [item for item in node[1:] if isinstance(item, list) and item and item[0] in ("KV", "KVP")]
    points = [_numbers(collector, row) for row in rows if all(isinstance(x, str) and is_decimal(x) for x in row)]
    dimension, homogeneous = int(match[2]), match[1] == "P"
    if len(points) != count or any(len(row) != dimension + homogeneous for row in points):
        raise CurveFileError(
            f"{counted(len(points), 'point')}, but {count} of type {match[0]} are announced",
            remedy="the two must agree",
        )
    notes = []
    if homogeneous:
        points = [[*row[1:], row[0]] for row in points]
    if kind == "BEZIER":
        knots = bezier_knots(order - 1)
    elif len(vectors) == 1:
        knots = _numbers(collector, vectors[0][1:])
        if vectors[0][0] == "KVP":
            points += points[: order - 1]
            notes.append("periodic: its first control points are repeated")
    else:
        raise CurveFileError(f"{len(vectors)} knot vectors", remedy="a curve has one")
    collector.add("curve", where, order - 1, knots, points, homogeneous=homogeneous, name=name, notes=notes)


def _surface(collector: Collector, node: Node, where: str, name: str) -> None:
    words = [item for item in node[1:] if isinstance(item, str)]
    kind, bezier = (words[0] if words else ""), words[:1] == ["BEZIER"]
    if kind not in ("BSPLINE", "BEZIER") or len(words) < (4 if bezier else 6):
        raise CurveFileError(f"a surface of kind {kind[:20]!r}", remedy="BSPLINE and BEZIER are read")
    m, n = (whole(word) for word in (words[1:3] if bezier else words[3:5]))
    match = _POINT.fullmatch(words[3] if bezier else words[5])
    if not match:
        raise CurveFileError("an unknown type of points", remedy="E2, E3, P2, P3 and the like are read")
    lists = [item for item in node[1:] if isinstance(item, list) and item]
    vectors = [item for item in lists if item[0] == "KV"]
    rows = [row for row in lists if all(isinstance(x, str) and is_decimal(x) for x in row)]
    points, dimension = [_numbers(collector, row) for row in rows], int(match[2])
    if any(len(row) != dimension + (match[1] == "P") for row in points):
        raise CurveFileError(f"points that are not of type {match[0]}", remedy="the two must agree")
    if len(vectors) != (0 if bezier else 2):
        raise CurveFileError(f"{counted(len(vectors), 'knot vector')}", remedy="a spline surface has two, by KV")
    if match[1] == "P":
        points = [[*row[1:], row[0]] for row in points]
    knots_u, knots_v = (
        (bezier_knots(m - 1), bezier_knots(n - 1)) if bezier else (_numbers(collector, each[1:]) for each in vectors)
    )
    degree, knots = (m - 1, n - 1), (knots_u, knots_v)
    collector.add_surface("surface", where, degree, knots, points, homogeneous=match[1] == "P", name=name)


def _numbers(collector: Collector, row: Node) -> list[mpq]:
    collector.count(len(row))
    return [decimal(item, collector.limits) if isinstance(item, str) else mpq(0) for item in row]


def write(curves: Sequence[NamedCurve], numbers: NumberText) -> bytes:
    """The curves, one object per curve."""
    lines = []
    for named in curves:
        curve = named.curve
        name = re.sub(r"\W+", "_", named.name, flags=re.ASCII) or "CURVE"
        kind = f"{'E' if curve.polynomial else 'P'}{curve.dimension}"
        lines += [
            f"[OBJECT {name}",
            f" [CURVE BSPLINE {len(curve.control_points)} {curve.degree + 1} {kind}",
            f"  [KV {' '.join(map(numbers, curve.knots))}]",
        ]
        rows = curve.control_points if curve.polynomial else [(row[-1], *row[:-1]) for row in homogeneous(curve)]
        lines += [f"  [{' '.join(map(numbers, row))}]" for row in rows]
        lines += [" ]", "]"]
    return "\n".join([*lines, ""]).encode()


def write_surfaces(surfaces: Sequence[NurbsSurface], numbers: NumberText) -> bytes:
    """The surfaces, one object per surface."""
    lines = []
    for surface in surfaces:
        name = re.sub(r"\W+", "_", surface.name, flags=re.ASCII) or "SURFACE"
        counts = [len(list(knots)) - d - 1 for d, knots in zip(surface.degree, surface.knots, strict=True)]
        sizes = " ".join(map(str, [*counts, *(d + 1 for d in surface.degree)]))
        kind = f"{'E' if surface.polynomial else 'P'}{surface.dimension}"
        lines += [f"[OBJECT {name}", f" [SURFACE BSPLINE {sizes} {kind}"]
        lines += [f"  [KV {' '.join(map(numbers, knots))}]" for knots in surface.knots]
        plain = [point for point, _ in net_rows(surface)]
        rows = plain if surface.polynomial else [(row[-1], *row[:-1]) for row in homogeneous_net(surface)]
        lines += [*(f"  [{' '.join(map(numbers, row))}]" for row in rows), " ]", "]"]
    return "\n".join([*lines, ""]).encode()


FORMAT = Format("itd", "IRIT text", (".itd",), looks_like, read, write, write_surfaces=write_surfaces)
