"""Engines that are Python packages, one in a process: ``python -m workshop.boolean.python_engines skia-pathops``.

A line of JSON with two paths and an operation in, a line with the path that the engine made, or the exception, out.
"""

from __future__ import annotations

import json
import os
import sys
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


#: Each engine, its package, and the function that calls it.
ENGINES: dict[str, tuple[str, Callable[[str, str, str], Made]]] = {
    "skia-pathops": ("skia-pathops", skia),
    "linesweeper": ("linesweeper", linesweeper),
    "booleanOperations": ("booleanOperations", boolean_operations),
}


def main() -> None:
    """Answer until there are no more requests."""
    package, combine = ENGINES[sys.argv[1]]
    replies = os.fdopen(os.dup(1), "w", encoding="utf-8")
    silence = os.open(os.devnull, os.O_WRONLY)
    os.dup2(silence, 1)
    os.dup2(silence, 2)
    import_module(combine.__name__ if package == "linesweeper" else {"skia-pathops": "pathops"}.get(package, package))
    names = (package, f"mpl-{package}")
    print(json.dumps({"version": next(filter(None, map(_version, names)), "")}), file=replies, flush=True)
    for line in sys.stdin:
        given = json.loads(line)
        try:
            path, rule = combine(given["first"], given["second"], given["operation"])
            reply = {"path": path, "rule": rule}
        except Exception as error:  # an exception of an engine is its answer
            reply = {"raised": f"{type(error).__name__}: {error}"[:300]}
        print(json.dumps(reply), file=replies, flush=True)


def _version(name: str) -> str:
    try:
        return version(name)
    except ImportError:
        return ""


if __name__ == "__main__":
    main()
