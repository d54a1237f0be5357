"""Small SVG pictures without a plotting library: a curve, or the graph of a function, with its control polygon.

Exact numbers become decimals only when they are written.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby, pairwise

from exactspline.display.plot.canvas import BLUE, GREY, SILVER, Point, polygons
from exactspline.numbers.exact import mpq
from exactspline.numbers.sides import Side
from exactspline.splines.bspline import BSpline
from exactspline.splines.control_points import greville_abscissae
from exactspline.splines.nurbs import Nurbs

#: Size in pixels, margin, samples in total and at least per segment.
WIDTH, HEIGHT, MARGIN, SAMPLES, LEAST = 240, 150, 8, 160, 6
#: A graph this many times lower than its control polygon is shown without the polygon.
POLYGON_ABOVE_GRAPH = 20
#: The colour of the letters around the picture: dark on a light page, light on a dark one.
INK = "currentColor"
#: The projection of a point in space: the coefficients of x, y, z for the two coordinates of the picture.
VIEW = ((mpq(4, 5), mpq(-3, 5), mpq(0)), (mpq(-1, 4), mpq(-1, 3), mpq(9, 10)))


def curve_picture(curve: Nurbs) -> str:
    """A curve in the plane or (in a fixed view) in space, with its control polygon; empty for other dimensions.

    >>> from exactspline.interchange.examples import example
    >>> curve_picture(example("circle")).count("<polyline")
    5
    """
    if curve.dimension not in (2, 3):
        return ""
    runs = [[_seen(curve(t, side)) for t, side in part] for part in _parameters(curve.breakpoints)]
    control = [_seen(p) if w else None for p, w in zip(curve.control_points, curve.weights, strict=True)]
    return _svg(runs, polygons(curve.knots.knots, curve.degree, control), "a curve and its control polygon", equal=True)


def graph_picture(f: BSpline) -> str:
    """The graph of a scalar spline with its control polygon, unless the polygon is far larger than the graph; empty for
    a degree below 0.
    """
    if f.degree < 0:
        return ""
    runs: list[list[Point]] = [[(t, f(t, side)) for t, side in part] for part in _parameters(f.breakpoints)]
    points: list[Point | None] = list(zip(greville_abscissae(f), f.control_points, strict=True))
    top = max(abs(y) for run in runs for _, y in run)
    highest = max(map(abs, f.control_points))
    legs = polygons(f.knots.knots, f.degree, points) if highest <= POLYGON_ABOVE_GRAPH * top else []
    a, b = f.domain
    shown = "the graph of a function and its control polygon" if legs else "the graph of a function"
    return _svg(runs, legs, shown, equal=False, axis=[(a, mpq(0)), (b, mpq(0))])


def _parameters(breaks: Sequence[mpq]) -> Iterator[list[tuple[mpq, str]]]:
    count = max(LEAST, SAMPLES // (len(breaks) - 1))
    for a, b in pairwise(breaks):
        yield [*[(a + (b - a) * mpq(k, count), Side.RIGHT) for k in range(count)], (b, Side.LEFT)]


def _seen(point: Sequence[mpq]) -> Point:
    if len(point) == 2:
        return tuple(point)
    return tuple(sum((c * x for c, x in zip(row, point, strict=True)), mpq(0)) for row in VIEW)


def _svg(
    runs: list[list[Point]], legs: list[list[Point]], shown: str, *, equal: bool, axis: Sequence[Point] = ()
) -> str:
    columns = list(zip(*[p for run in (*runs, *legs, axis) for p in run], strict=True))
    low, high = [min(c) for c in columns], [max(c) for c in columns]
    sizes = [b - a or mpq(1) for a, b in zip(low, high, strict=True)]
    scales = [mpq(WIDTH - 2 * MARGIN) / sizes[0], mpq(HEIGHT - 2 * MARGIN) / sizes[1]]
    if equal:
        scales = [min(scales)] * 2

    def at(p: Point) -> tuple[str, str]:
        x, y = (MARGIN + s * (v - a) for s, v, a in zip(scales, p, low, strict=True))
        return _decimal(x), _decimal(HEIGHT - y)

    parts = [_line([at(p) for p in axis], GREY, "0.5")] if axis else []
    for run in legs:
        parts.append(_line([at(p) for p in run], SILVER, "1"))
    for i, run in enumerate(runs):
        parts.append(_line([at(p) for p, _ in groupby(run)], GREY if i % 2 else INK, "1.8"))
    for x, y in (at(p) for run in legs for p in run):
        parts.append(f'<circle cx="{x}" cy="{y}" r="2" fill="{BLUE}"/>')
    size = f'width="{WIDTH}" height="{HEIGHT}" viewBox="0 0 {WIDTH} {HEIGHT}"'
    label = f'role="img" aria-label="{shown}"'
    return f'<svg xmlns="http://www.w3.org/2000/svg" {size} {label} style="max-width:100%">{"".join(parts)}</svg>'


def _line(points: Sequence[tuple[str, str]], color: str, width: str) -> str:
    path = " ".join(f"{x},{y}" for x, y in points)
    return f'<polyline points="{path}" fill="none" stroke="{color}" stroke-width="{width}"/>'


def _decimal(x: mpq) -> str:
    tenths = int(x * 10 + mpq(1, 2))
    return f"{tenths // 10}.{tenths % 10}"
