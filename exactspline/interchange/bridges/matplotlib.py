"""Paths of matplotlib: read exactly, written with correct rounding."""

from __future__ import annotations

from typing import TYPE_CHECKING

from exactspline.errors import as_instance
from exactspline.interchange.bridges.fonttools import ContourPen
from exactspline.interchange.bridges.values import doubles
from exactspline.interchange.writing import pen_segments
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of

if TYPE_CHECKING:
    from matplotlib.path import Path

#: What a pen does at each code of a path: MOVETO, LINETO, CURVE3, CURVE4.
STEPS = {1: "moveTo", 2: "lineTo", 3: "qCurveTo", 4: "curveTo"}


def from_matplotlib(path: Path) -> list[Nurbs]:
    """The curves of a path, one for each of its parts that begin with ``MOVETO``, with the doubles as they are.

    >>> from matplotlib.path import Path
    >>> (triangle,) = from_matplotlib(Path([(0, 0), (4, 0), (0, 2), (0, 0)], closed=True))
    >>> triangle.closed, triangle("3/2")
    (True, (mpq(2,1), mpq(1,1)))

    Raises `ShapeError` for what is no path, `NumberError` for NaN and infinities.
    """
    from matplotlib.path import Path

    path, pen = as_instance(path, Path, "a path", "give a matplotlib.path.Path"), ContourPen()
    start: list[float] = []
    for row, code in path.iter_segments(remove_nans=False, simplify=False):
        points = row.reshape(-1, 2).tolist()
        if code in STEPS:
            getattr(pen, STEPS[int(code)])(*points)
            start = points[0] if code == Path.MOVETO else start
        elif code == Path.CLOSEPOLY:
            pen.closePath()
            pen.moveTo(start)  # what follows without MOVETO begins there
    pen.endPath()
    return pen.curves()


def to_matplotlib(curve: Nurbs) -> Path:
    """The path of a polynomial plane curve of degree 1 to 3, its points rounded correctly.

    >>> path = to_matplotlib(Nurbs.bezier([(0, 0), (1, 2), (3, 0)]))
    >>> path.codes.tolist(), path.vertices.tolist()
    ([1, 3, 3], [[0.0, 0.0], [1.0, 2.0], [3.0, 0.0]])

    Raises `ShapeError` for other curves and at a jump.
    """
    from matplotlib.path import Path

    curve = curve_of(curve)
    points = [doubles(point) for segment in pen_segments(curve) for point in segment]
    ends = points[:1] * curve.closed
    del points[curve.degree + 1 :: curve.degree + 1]  # where the next segment begins
    # LINETO, CURVE3, CURVE4 are 2, 3, 4
    codes: list[int] = [1, *[curve.degree + 1] * (len(points) - 1), *[int(Path.CLOSEPOLY)] * curve.closed]
    return Path(points + ends, codes)
