"""A fontTools pen that collects contours as exact splines, and the reverse: drawing a curve with a pen."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

from exactspline.errors import ShapeError, counted
from exactspline.interchange.format import pen_segments
from exactspline.interchange.numbers import exact, finite_double
from exactspline.interchange.records import LARGER
from exactspline.interchange.segments import joined_segments, polynomial
from exactspline.numbers.exact import mpq
from exactspline.splines.nurbs import Nurbs

if TYPE_CHECKING:
    from fontTools.pens.basePen import AbstractPen

Point = tuple[mpq, ...]
Contour = tuple[int, list[mpq], list[Point]]


class ContourPen:
    """A pen of the fontTools protocol; `contours` holds degree, knots and control points of each.

    >>> pen = ContourPen()
    >>> pen.moveTo((0, 0)); pen.qCurveTo((1, 1), (3, 1), (4, 0)); pen.closePath()
    >>> degree, knots, points = pen.contours[0]
    >>> degree, [int(t) for t in knots], len(points)
    (2, [0, 0, 0, 1, 2, 2, 3, 3, 3], 6)
    >>> pen.curves()[0](1)
    (mpq(2,1), mpq(1,1))

    Raises `ShapeError` for components (decompose them first) and for more than `most` points.
    """

    def __init__(self, most: int = 1_000_000) -> None:
        self.contours: list[Contour] = []
        self.placed: Sequence[mpq] = tuple(map(mpq, (1, 0, 0, 1, 0, 0)))
        self._most, self._count = most, 0
        self._start: Point | None = None
        self._runs: list[tuple[str, list[Point]]] = []

    def curves(self) -> list[Nurbs]:
        """The contours as curves."""
        return [Nurbs(degree, knots, points) for degree, knots, points in self.contours]

    def _point(self, point: Sequence[object]) -> Point:
        self._count += 1
        if self._count > self._most:
            raise ShapeError(f"more than {self._most} points", remedy=LARGER)
        x, y = map(exact, point)
        a, b, c, d, u, v = self.placed
        return (a * x + c * y + u, b * x + d * y + v)

    def moveTo(self, point: Sequence[object]) -> None:
        """Start a contour at a point."""
        self._end()
        self._start = self._point(point)

    def lineTo(self, point: Sequence[object]) -> None:
        """Draw a line."""
        self._runs.append(("line", [self._point(point)]))

    def curveTo(self, *points: Sequence[object]) -> None:
        """Draw a cubic; raises `ShapeError` unless there are three points."""
        if len(points) != 3:
            raise ShapeError(f"a cubic of {counted(len(points), 'point')}", remedy="give three")
        self._runs.append(("cubic", [self._point(point) for point in points]))

    def qCurveTo(self, *points: Sequence[object] | None) -> None:
        """Draw a run of quadratics, given its off-curve points and its end; None as the end closes a contour without
        on-curve points.
        """
        off = [self._point(point) for point in points if point is not None]
        if points[-1] is None:
            self._end()
            self._start = _middle(off[-1], off[0])
            off.append(self._start)
        self._runs.append(("run", off))

    def closePath(self) -> None:
        """Close the contour, with a line if its ends differ."""
        if self._start and self._runs and self._runs[-1][1][-1] != self._start:
            self._runs.append(("line", [self._start]))
        self._end()

    def endPath(self) -> None:
        """Leave the contour open."""
        self._end()

    def addComponent(self, name: str, *_: object) -> None:
        """Raise `ShapeError`: components are not drawn."""
        raise ShapeError(f"the component {name}", remedy="decompose the glyph (DecomposingRecordingPen)")

    def addVarComponent(self, name: str, *_: object) -> None:
        """Raise `ShapeError`: components are not drawn."""
        self.addComponent(name)

    def _end(self) -> None:
        if self._start and self._runs:
            cubic = any(kind == "cubic" for kind, _ in self._runs)
            self.contours.append((_beziers if cubic else _runs)(self._start, self._runs))
        self._start, self._runs = None, []


def _middle(a: Point, b: Point) -> Point:
    return tuple((x + y) / 2 for x, y in zip(a, b, strict=True))


def _runs(start: Point, runs: Sequence[tuple[str, list[Point]]]) -> Contour:
    """Join lines and runs of quadratics: knots are simple within a run, where each implied on-curve point is the
    midpoint of two off-curve points.
    """
    degree = max(min(len(points), 2) for _, points in runs)
    knots, points, at = [mpq(0)] * (degree + 1), [start], 0
    for _, run in runs:
        given = [_middle(points[-1], run[0]), run[0]] if len(run) < degree else run
        spans = max(len(given) - 1, 1)
        knots += [mpq(at + i) for i in range(1, spans)] + [mpq(at + spans)] * degree
        points, at = [*points, *given], at + spans
    return degree, [*knots, mpq(at)], points


def _beziers(start: Point, runs: Sequence[tuple[str, list[Point]]]) -> Contour:
    """Join a contour that has cubics: every breakpoint has full multiplicity."""
    segments = []
    for kind, run in runs:
        if kind != "run":
            segments.append(polynomial(start, *run))
        else:
            ends = [_middle(a, b) for a, b in pairwise(run[:-1])] + run[-1:]
            for off, end in zip(run[:-1], ends, strict=True):
                segments.append(polynomial(start, off, end))
                start = end
        start = run[-1]
    degree, knots, points = joined_segments(segments)
    return degree, knots, [point[:-1] for point in points]


def draw(curve: Nurbs, pen: AbstractPen) -> None:
    """Draw a polynomial plane curve of degree 1 to 3 with a fontTools pen. Integer coordinates are passed as integers,
    others as correctly rounded doubles.

    Raises `ShapeError` for other curves and at a jump.
    """
    segments = pen_segments(curve)
    step = (pen.lineTo, pen.qCurveTo, pen.curveTo)[curve.degree - 1]
    pen.moveTo(_rounded(segments[0][0]))
    for _, *points in segments:
        step(*map(_rounded, points))
    (pen.closePath if curve.closed else pen.endPath)()


def _rounded(point: Sequence[mpq]) -> tuple[float, ...]:
    return tuple(int(x) if x.denominator == 1 else finite_double(x) for x in point)
