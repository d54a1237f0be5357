"""Surfaces as exact points: the shaded grid and the control net around it, for any renderer."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import chain, count, pairwise
from typing import Any

from exactspline.display.plot.canvas import (
    Box,
    Point,
    Run,
    box_around,
    clipped,
    homogeneous,
    inside,
    kept,
    parameter,
    polygon_in,
    polygons,
    runs_between_gaps,
    usual_box,
)
from exactspline.errors import ShapeError, as_items, counted
from exactspline.language.rational import Rational
from exactspline.language.ruled import RuledSurface, split
from exactspline.language.vector import Vector
from exactspline.numbers.exact import Number, mpq, rational
from exactspline.numbers.intervals import Side
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.common import with_common_knots
from exactspline.splines.lowest_terms import SplineSurface
from exactspline.splines.tensor import TensorSpline

#: Samples along the curve, in total and at least per segment; samples along a ruling.
SAMPLES, LEAST, ALONG = 192, 12, 21
#: Samples of a surface in two parameters in each direction, in total and at least per segment.
GRID, LEAST_OF_GRID = 48, 8
#: A cell at the border of the visible part is halved this often.
DEPTH = 4
#: Sampling stops this close to a pole, as a fraction of the distance between samples.
BESIDE = mpq(1, 8)
#: Two parameters of a surface.
Parameters = tuple[mpq, ...]


@dataclass(frozen=True)
class SurfaceMesh:
    """Rows of points in patches (None if there is no point, or a faraway one), and a control net.

    ``cut`` are the polygons, with three or more corners each, that join the patches to the border of the visible part.
    ``net`` are the polygons of the control points in connected runs, ``points`` is the number of control points,
    ``hidden`` the number of those that are directions (weight 0) or far away. ``parameters`` are the two parameters of
    each point of the patches, in their shape, and ``letters`` their names.
    """

    patches: list[list[list[Point | None]]]
    net: list[Run]
    points: int
    hidden: int
    cut: Sequence[Run] = ()
    parameters: Sequence[Sequence[Sequence[Parameters | None]]] = ()
    letters: tuple[str, str] = ("s", "ζ")

    @property
    def located(self) -> list[Parameters]:
        """The parameters of the first points of `indexed`: those of the patches, where they are known."""
        rows = zip(chain(*self.patches), chain(*self.parameters), strict=False)
        return [q for points, own in rows for p, q in zip(points, own, strict=True) if p is not None and q is not None]

    @property
    def faces(self) -> list[Run]:
        """The quadrilaterals with all four corners, and the cut polygons."""
        points, faces = self.indexed
        return [[points[k] for k in face] for face in faces]

    @property
    def indexed(self) -> tuple[list[Point], list[tuple[int, ...]]]:
        """The points, patch by patch, and the faces as indices into that list: neighbours share their corners."""
        points: list[Point] = []
        faces: list[tuple[int, ...]] = []
        for rows in self.patches:
            places: list[list[int | None]] = []
            for row in rows:
                number = count(len(points))
                places.append([None if p is None else next(number) for p in row])
                points += [p for p in row if p is not None]
            for a, b in pairwise(places):
                for (p, q), (r, s) in zip(pairwise(a), pairwise(b), strict=True):
                    corners = tuple(x for x in (p, q, s, r) if x is not None)
                    if len(corners) == 4:
                        faces.append(corners)
        known: dict[Point, int] = {}
        for polygon in self.cut:
            first, *more = [known.setdefault(p, len(points) + len(known)) for p in polygon]
            # in a fan of quadrilaterals and at most one triangle
            faces += [(first, *more[k : k + 3]) for k in range(0, len(more) - 1, 2)]
        points += known
        return points, faces

    def isolines(self, along: int = 7, across: int = 24) -> list[Run]:
        """About this many lines along each patch (including its edges) and across all patches together, with gaps at
        missing points.

        >>> rows = [[(mpq(i), mpq(j), mpq(0)) for j in range(5)] for i in range(9)]
        >>> lines = SurfaceMesh([rows], [], 0, 0).isolines(2, 3)
        >>> [[int(x) for p in (run[0], run[-1]) for x in p[:2]] for run in lines]
        [[0, 0, 8, 0], [0, 4, 8, 4], [0, 0, 0, 4], [4, 0, 4, 4], [8, 0, 8, 4]]
        """
        rows_in_all = sum(map(len, self.patches))
        lines: list[list[Point | None]] = []
        for rows in self.patches:
            columns = list(zip(*rows, strict=True))
            share = max(2, -(-across * len(rows) // rows_in_all))
            lines += [list(columns[k]) for k in _spread(len(columns), along)]
            lines += [list(rows[k]) for k in _spread(len(rows), share)]
        return [run for line in lines for run in runs_between_gaps(line) if len(run) > 1]


def _spread(length: int, count: int) -> list[int]:
    """About this many indices of a list, both ends included."""
    steps = max(1, min(count, length) - 1)
    return sorted({(length - 1) * k // steps for k in range(steps + 1)})


def _two(given: Iterable[Number], what: str) -> tuple[mpq, mpq]:
    """Both ends of an interval, exactly."""
    ends = tuple(map(rational, as_items(given, what)))
    if len(ends) != 2:
        raise ShapeError(f"{counted(len(ends), 'number')} for {what}", where=what, remedy="give two, (low, high)")
    return ends


def ruled_mesh(
    surface: SplineSurface,
    rulings: tuple[Number, Number] = (-1, 1),
    box: Box | None = None,
    heights: tuple[Number, Number] | None = None,
) -> SurfaceMesh:
    """The part of a ruled surface (in the spline reading) between two ruling parameters, cut at its poles; its net
    connects the polygons at both.

    `box` is the visible part; by default it contains most of the points. Between two `heights` (third coordinates)
    every ruling is cut there instead: the same part of the surface, whatever its parameters; horizontal rulings are
    omitted.

    >>> from exactspline.interchange.examples import example
    >>> from exactspline.papers import find
    >>> mesh = ruled_mesh(find("tangent_developable")(example("twisted_cubic")), (0, 1))
    >>> mesh.points, mesh.hidden
    (8, 0)

    Raises `ShapeError` for anything but a ruled surface of splines in space, and for an invalid interval of rulings.
    """
    low, high = _two(rulings, "rulings")
    levels = None if heights is None else _two(heights, "heights")
    if low >= high:
        raise ShapeError(f"rulings from {low} to {high}", where="rulings", remedy="the first must be the smaller one")
    if not isinstance(surface, RuledSurface) or len(surface.directrix) != 3 or not _of_splines(surface.directrix):
        raise ShapeError(
            "expected a ruled surface of splines in space", remedy="evaluate a formula of a ruled surface on a curve"
        )
    components, denominator = split(surface)
    if denominator is not None and not all(denominator.numerators):
        raise ShapeError("the denominator vanishes on a whole segment", remedy="derive the surface piece by piece")

    def row(s: mpq, side: Side | str) -> list[Point | None]:
        w = mpq(1) if denominator is None else denominator(s, side)
        values = [c(s, side) / w for c in components]
        start, end = low, high
        if levels is not None:
            if values[5] == 0:
                return [None, None]
            start, end = ((h - values[2]) / values[5] for h in levels)
        return [(*[d + z * g for d, g in zip(values[:3], values[3:], strict=True)], s, z) for z in (start, end)]

    poles = [] if denominator is None else [parameter(t, denominator.domain) for t in zeros(denominator)]
    patches = _sampled_rows(row, components[0].breakpoints, poles)
    if box is None:
        box = usual_box([p[:3] for rows in patches for r in rows for p in r if p is not None], bool(poles))
    net, points, hidden = _net(surface.joined, (low, high), box)
    found = [[_along(ends, box) for ends in rows] for rows in patches]
    places, parameters = (
        [[[None if p is None else p[part] for p in row] for row in rows] for rows in found]
        for part in (slice(3), slice(3, 5))
    )
    return SurfaceMesh(places, net, points, hidden, parameters=parameters)


def _along(ends: Sequence[Point | None], box: Box) -> list[Point | None]:
    """The points of a ruling between two ends, as far as it is in the box, each followed by its parameters."""
    first, last = ends
    inside = None
    if first is not None and last is not None:
        direction = tuple(y - x for x, y in zip(first, last, strict=True))
        low, high = box_around([first[3:], last[3:]])
        inside = clipped(first, direction, ((*box[0], *low), (*box[1], *high)), mpq(0), mpq(1))
    if inside is None:
        return [None] * ALONG
    steps = [mpq(k, ALONG - 1) for k in range(ALONG)]
    return [tuple(x + z * (y - x) for x, y in zip(*inside, strict=True)) for z in steps]


def _of_splines(value: Any) -> bool:
    vector = value.numerator if isinstance(value, Rational) else value
    return isinstance(vector, Vector) and all(isinstance(x, BSpline) for x in vector)


def _sampled_rows(
    row: Callable[[mpq, str], list[Point | None]], breaks: Sequence[mpq], poles: Iterable[mpq]
) -> list[list[list[Point | None]]]:
    """The rows patch by patch, where patches end near poles and where the surface jumps."""
    poles = set(poles)
    cuts = sorted({*breaks, *poles})
    steps = max(LEAST, SAMPLES // (len(breaks) - 1))
    patches: list[list[list[Point | None]]] = []
    for a, b in pairwise(cuts):
        step = (b - a) / steps
        inner = [a + step * k for k in range(steps + 1)]
        first = row(a, Side.RIGHT) if a not in poles else row(a + step * BESIDE, Side.RIGHT)
        last = row(b, Side.LEFT) if b not in poles else row(b - step * BESIDE, Side.RIGHT)
        rows = [first, *[row(t, Side.RIGHT) for t in inner[1:-1]], last]
        if patches and a not in poles and patches[-1][-1] == first:
            patches[-1] += rows[1:]
        else:
            patches.append(rows)
    return patches


def _net(value: Any, rulings: tuple[mpq, mpq], box: Box) -> tuple[list[Run], int, int]:
    """The control polygons at the two ruling parameters and the legs between them."""
    rows, knots, degree = homogeneous(value)
    edges: list[list[Point | None]] = [[], []]
    for *x, w in rows:
        for edge, z in zip(edges, rulings, strict=True):
            edge.append(kept(tuple((a + z * b) / w for a, b in zip(x[:3], x[3:], strict=True)), box) if w else None)
    runs = [run for edge in edges for run in polygons(knots, degree, edge)]
    legs = [[p, q] for p, q in zip(*edges, strict=True) if p is not None and q is not None]
    return runs + legs, 2 * len(rows), sum(p is None for edge in edges for p in edge)


def tensor_mesh(surface: Vector[TensorSpline] | Rational[TensorSpline], box: Box | None = None) -> SurfaceMesh:
    """A surface in two parameters, a `Vector` of three `TensorSpline` or a quotient of such, with its control net.

    The surface goes to infinity where its denominator vanishes: points far from most of the surface (or outside `box`)
    are omitted.

    >>> from exactspline.splines.tensor import TensorSpline
    >>> nets = [[0, 0], [1, 1]], [[0, 1], [0, 1]], [[0, 0], [0, 1]]
    >>> s, t, st = (TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], net) for net in nets)
    >>> mesh = tensor_mesh(Vector(s, t, st))
    >>> mesh.points, len(mesh.net)
    (4, 4)

    Raises `ShapeError` for anything else.
    """
    numerator, w = (surface.numerator, surface.denominator) if isinstance(surface, Rational) else (surface, None)
    if not isinstance(numerator, Vector) or len(numerator) != 3 or not isinstance(numerator[0], TensorSpline):
        problem = "expected a surface of splines in two parameters"
        raise ShapeError(problem, remedy="give a vector of three TensorSplines, or a quotient of such")
    sampled = _Sampled([*numerator, *([] if w is None else [w])], w is not None)
    grids = [_grid(mesh.breaks) for mesh in numerator[0].meshes]
    places = [[sampled(s, t) for t in grids[1]] for s in grids[0]]
    box = usual_box([p for row in places for p, _ in row if p is not None], w is not None) if box is None else box
    # one patch for either sign of the denominator, so that no face reaches across a pole
    patches = [
        [[kept(p, box) if sign == side else None for p, sign in row] for row in places] for side in (True, False)
    ]
    cut = [
        polygon
        for s in pairwise(grids[0])
        for t in pairwise(grids[1])
        if not sampled.is_inside(s, t, box)
        for polygon in sampled.cut(s, t, box, DEPTH)
    ]
    points = _control_net(numerator, w, box)
    net = [run for line in (*points, *map(list, zip(*points, strict=True))) for run in runs_between_gaps(line)]
    flat = [p for row in points for p in row]
    patches = patches[: 1 if w is None else 2]
    parameters = [[[(s, t) for t in grids[1]] for s in grids[0]] for _ in patches]
    return SurfaceMesh(patches, net, len(flat), flat.count(None), cut, parameters, ("s", "t"))


class _Sampled:
    """Points of a surface, each computed once, with the sign of the denominator there: whether it is positive."""

    def __init__(self, scalars: Sequence[TensorSpline], quotient: bool) -> None:
        self.scalars, self.quotient = scalars, quotient
        self._lines: dict[mpq, list[BSpline]] = {}
        self._points: dict[tuple[mpq, mpq], tuple[Point | None, bool]] = {}

    def __call__(self, s: mpq, t: mpq) -> tuple[Point | None, bool]:
        if (s, t) not in self._points:
            if s not in self._lines:
                self._lines[s] = [c.at_s(s) for c in self.scalars]
            values = [line(t) for line in self._lines[s]]
            self._points[s, t] = _over(values, self.quotient), not self.quotient or values[-1] > 0
        return self._points[s, t]

    def corners(self, s: tuple[mpq, mpq], t: tuple[mpq, mpq]) -> list[Point] | None:
        """The corners of a cell in order around it; None if a pole may run through the cell."""
        found = [self(s[i], t[j]) for i, j in ((0, 0), (0, 1), (1, 1), (1, 0))]
        points = [p for p, _ in found if p is not None]
        return points if len(points) == 4 and len({sign for _, sign in found}) == 1 else None

    def is_inside(self, s: tuple[mpq, mpq], t: tuple[mpq, mpq], box: Box) -> bool:
        """Whether a cell has its corners in a box and no pole."""
        corners = self.corners(s, t)
        return corners is not None and all(inside(p, box) for p in corners)

    def cut(self, s: tuple[mpq, mpq], t: tuple[mpq, mpq], box: Box, depth: int) -> list[Run]:
        """The polygons of a cell inside a box: it is halved in both directions until it is inside, outside or small."""
        corners = self.corners(s, t)
        if corners is not None:
            if self.is_inside(s, t, box):
                return [corners]
            if not _overlap(box_around(corners), box):
                return []
            if not depth:
                polygon = polygon_in(corners, box)
                return [polygon] if len(polygon) > 2 else []
        if not depth:
            return []
        halves = [((a, (a + b) / 2), ((a + b) / 2, b)) for a, b in (s, t)]
        return [piece for u in halves[0] for v in halves[1] for piece in self.cut(u, v, box, depth - 1)]


def _overlap(first: Box, second: Box) -> bool:
    return all(a <= d and c <= b for a, b, c, d in zip(*first, *second, strict=True))


def _grid(breaks: Sequence[mpq]) -> list[mpq]:
    steps = max(LEAST_OF_GRID, GRID // (len(breaks) - 1))
    return [*[a + (b - a) * mpq(k, steps) for a, b in pairwise(breaks) for k in range(steps)], breaks[-1]]


def _over(values: list[mpq], quotient: bool) -> Point | None:
    if not quotient:
        return tuple(values)
    *xs, w = values
    return tuple(x / w for x in xs) if w else None


def _control_net(numerator: Vector[TensorSpline], w: TensorSpline | None, box: Box) -> list[list[Point | None]]:
    """The control points of the common degrees and knots, row by row."""
    scalars = [*numerator, *([] if w is None else [w])]
    nets = [c.control_points for c in with_common_knots(scalars)]
    return [
        [kept(_over(list(values), w is not None), box) for values in zip(*lines, strict=True)]
        for lines in zip(*nets, strict=True)
    ]
