"""Engines that Python calls, one in a process: ``python -m workshop.boolean.python_engines skia-pathops``.

A line of JSON with two paths and an operation in, a line with the path that the engine made, or the exception, out.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable
from importlib import import_module
from importlib.metadata import version
from typing import Any

Made = tuple[str, str]
#: Font units in a unit of a path, a power of two: coordinates up to 10 become some of an em.
UNITS = 64


def _data(commands: list[tuple[str, Any]]) -> str:
    """Path data of the commands of a pen, each number in full."""
    letters = {"moveTo": "M", "lineTo": "L", "qCurveTo": "Q", "curveTo": "C", "closePath": "Z", "endPath": ""}
    return "".join(
        letters[name] + " ".join(repr(float(c)) for point in points for c in point) for name, points in commands
    )


def skia(first: str, second: str, operation: str) -> Made:
    """``pathops.op``; its result is filled by the rule that it names."""
    pathops = import_module("pathops")
    from fontTools.pens.recordingPen import DecomposingRecordingPen
    from fontTools.svgLib.path import parse_path

    paths = []
    for data in (first, second):
        path = pathops.Path()
        parse_path(data, path.getPen())
        paths.append(path)
    made = pathops.op(*paths, pathops.PathOp[operation.upper()], fix_winding=False, keep_starting_points=False)
    pen = DecomposingRecordingPen({})
    made.draw(pen)
    even_odd = made.fillType in (pathops.FillType.EVEN_ODD, pathops.FillType.INVERSE_EVEN_ODD)
    return _data(pen.value), "even-odd" if even_odd else "nonzero"


def linesweeper(first: str, second: str, operation: str) -> Made:
    """``linesweeper.binary_op``."""
    library = import_module("linesweeper")
    paths = [library.BezPath.from_svg(data) for data in (first, second)]
    made = library.binary_op(*paths, "nonzero", operation)
    several = made if isinstance(made, (list, tuple)) else [made]
    return "".join(path if isinstance(path, str) else path.to_svg() for path in several), "nonzero"


class _Contour:
    """A contour as booleanOperations takes it, in font units."""

    def __init__(self, data: str) -> None:
        self.data = data

    def __len__(self) -> int:
        """How many segments it has, about."""
        return self.data.count("C") + 1

    def drawPoints(self, pen: Any) -> None:  # the library's name
        """Draw it with a pen of points."""
        from fontTools.pens.pointPen import SegmentToPointPen
        from fontTools.pens.transformPen import TransformPen
        from fontTools.svgLib.path import parse_path

        parse_path(self.data, TransformPen(SegmentToPointPen(pen), (UNITS, 0, 0, UNITS, 0, 0)))


def boolean_operations(first: str, second: str, operation: str) -> Made:
    """``booleanOperations``: curves become polygons, and curves again where points allow that. It is made for font
    units and gets paths in these.
    """
    library = import_module("booleanOperations")
    from fontTools.pens.pointPen import PointToSegmentPen
    from fontTools.pens.recordingPen import DecomposingRecordingPen
    from fontTools.pens.transformPen import TransformPen

    pen = DecomposingRecordingPen({})
    out = PointToSegmentPen(TransformPen(pen, (1 / UNITS, 0, 0, 1 / UNITS, 0, 0)))
    if operation == "union":
        library.union([_Contour(first), _Contour(second)], out)
    else:
        getattr(library, operation)([_Contour(first)], [_Contour(second)], out)
    return _data(pen.value), "nonzero"


def _points(data: str) -> list[tuple[float, float]]:
    """The control points of a path of cubics."""
    numbers = [float(x) for x in re.findall(r"[^MCZ\s]+", data)]
    return list(zip(numbers[::2], numbers[1::2], strict=True))


def font_forge(first: str, second: str, operation: str) -> Made:
    """``layer.removeOverlap`` of each path, which makes all outlines go round one way, then that of both, ``intersect``
    or ``exclude``; in font units.
    """
    library = import_module("fontforge")
    if operation == "xor":
        raise NotImplementedError("it has no exclusive or")
    layers = []
    for data in (first, second):
        contour = library.contour()
        start, *points = [(UNITS * x, UNITS * y) for x, y in _points(data)]
        contour.moveTo(*start)
        for i in range(0, len(points), 3):
            contour.cubicTo(*points[i : i + 3])
        contour.closed = True
        layers.append(library.layer())
        layers[-1] += contour
        layers[-1].removeOverlap()
    made, other = layers
    if operation == "difference":
        made.exclude(other)
    else:
        for contour in other:
            made += contour
        if operation == "union":
            made.removeOverlap()
        else:
            made.intersect()
    return "".join(map(_of_font_forge, made)), "nonzero"


def _of_font_forge(contour: Any) -> str:
    """A contour as path data: between two points on it there are two others or none."""
    points = [(point.x / UNITS, point.y / UNITS, point.on_curve) for point in contour]
    at = next(i for i, (_, _, on) in enumerate(points) if on)
    points = [*points[at:], *points[: at + 1]]
    data, waiting = f"M{points[0][0]!r} {points[0][1]!r}", list[str]()
    for x, y, on in points[1:]:
        waiting.append(f"{x!r} {y!r}")
        if on:
            data += f"{'C' if len(waiting) == 3 else 'L'}{' '.join(waiting)}"
            waiting = []
    return data + "Z"


def inkscape(first: str, second: str, operation: str) -> Made:
    """The actions ``path-union``, ``path-intersection``, ``path-difference`` and ``path-exclusion``."""
    action = {"xor": "exclusion"}.get(operation, operation)
    with tempfile.TemporaryDirectory() as folder:
        given, made = f"{folder}/given.svg", f"{folder}/made.svg"
        with open(given, "w", encoding="utf-8") as stream:
            paths = f'<path id="a" d="{first}"/><path id="b" d="{second}"/>'
            head = '<svg xmlns="http://www.w3.org/2000/svg" width="100" height="100" viewBox="0 0 100 100">'
            stream.write(f"{head}{paths}</svg>")
        actions = f"select-by-id:a,b;path-{action};export-filename:{made};export-plain-svg;export-do"
        subprocess.run(["inkscape", given, f"--actions={actions}"], check=True, capture_output=True, timeout=60)
        with open(made, encoding="utf-8") as stream:
            found = re.findall(r'\sd="([^"]*)"', stream.read())
    if len(found) > 1:
        raise RuntimeError("both paths are left")
    return "".join(found), "nonzero"


#: Each engine, its package, and the function that calls it.
ENGINES: dict[str, tuple[str, Callable[[str, str, str], Made]]] = {
    "skia-pathops": ("skia-pathops", skia),
    "linesweeper": ("linesweeper", linesweeper),
    "booleanOperations": ("booleanOperations", boolean_operations),
    "FontForge": ("fontforge", font_forge),
    "Inkscape": ("inkscape", inkscape),
}


def main() -> None:
    """Answer until there are no more requests."""
    package, combine = ENGINES[sys.argv[1]]
    replies = os.fdopen(os.dup(1), "w", encoding="utf-8")
    silence = os.open(os.devnull, os.O_WRONLY)
    os.dup2(silence, 1)
    os.dup2(silence, 2)
    print(json.dumps({"version": installed_version(package)}), file=replies, flush=True)
    for line in sys.stdin:
        given = json.loads(line)
        try:
            path, rule = combine(given["first"], given["second"], given["operation"])
            reply = {"path": path, "rule": rule}
        except NotImplementedError as error:
            reply = {"declined": f"{error}"}
        except Exception as error:  # an exception of an engine is its answer
            reply = {"raised": f"{type(error).__name__}: {error}"[:300]}
        print(json.dumps(reply), file=replies, flush=True)


def installed_version(package: str) -> str:
    """The version of what an engine calls; ImportError where it is not installed."""
    if package == "inkscape":
        if shutil.which(package) is None:
            raise ImportError(package)
        printed = subprocess.run([package, "--version"], check=True, capture_output=True, text=True).stdout
        return printed.split()[1]
    module = import_module({"skia-pathops": "pathops"}.get(package, package))
    return str(module.version()) if package == "fontforge" else version(package)


if __name__ == "__main__":
    main()
