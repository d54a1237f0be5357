"""Pictures of whole bisectors: of two curves with surface, lines and planes; of a point and a curve."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from flint import arb

from exactspline.display.plot.canvas import (
    BLACK,
    GREEN,
    ORANGE,
    PURPLE,
    SILVER,
    SKY,
    VERMILLION,
    Box,
    Point,
    axes_for,
    box_around,
    clipped,
    draw,
    draw_runs,
    grown,
    legend_once,
    parameter,
    runs_in,
    sampled,
    shown_name,
)
from exactspline.display.plot.curves import plot_both, plot_curve
from exactspline.errors import ReachError
from exactspline.extras.pictures3d.meshes import SurfaceMesh, tensor_mesh
from exactspline.extras.pictures3d.surfaces import mark_points, plot_mesh, show_box
from exactspline.geometry.bisectors.components import Correspondence, LineComponent, SinglePair, Solutions
from exactspline.geometry.bisectors.plane_curves import PlaneBisector
from exactspline.geometry.bisectors.point_and_curve import PointBisector
from exactspline.geometry.bisectors.trimmed import TrimmedBisector
from exactspline.geometry.bisectors.two_curves import CurveBisector
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector, cross, dot
from exactspline.numbers.exact import Number, mpq, rational
from exactspline.numbers.intervals import Box as Intervals
from exactspline.reals.real import real
from exactspline.roots.root import Root
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: A point of a line, and its direction.
Ruling = tuple[Point, Point]

#: Rulings of a piece, points along a ruling, samples of a piece of a plane curve.
RULINGS, ALONG, SAMPLES = 64, 12, 200
#: Digits of irrational lines in pictures.
DIGITS = 20


def plot_curve_bisector(bisector: CurveBisector, ax: Axes | None = None, *, box: Box | None = None) -> Axes:
    """The bisector of two curves: its surface, the lines along curves of pairs, and the lines and planes of single
    pairs, in a box around both curves.

    >>> from exactspline import Nurbs
    >>> from exactspline.geometry.bisectors.two_curves import curve_bisector
    >>> low, high = (Nurbs(1, [0, 0, 1, 1], [(0, 0, z), (2, 0, z)]) for z in (0, 1))
    >>> [text.get_text() for text in plot_curve_bisector(curve_bisector(low, high)).get_legend().get_texts()]
    ['curve (s)', 'curve (t)', 'lines of s - t = 0']

    Raises `PlotError` as `plot_mesh` does, except for a bisector without any part in the box.
    """
    ax = axes_for(ax, 3)
    box = _box_of(bisector.curves) if box is None else box
    title = plot_both(bisector.curves, ax, GREEN)
    for patch in bisector.patches:
        if max(patch.value.degree) == 0:
            mark_points(ax, [patch.value.point(*[a for a, _ in patch.sides])], "surface (one point)", SKY)
        else:
            _plot(ax, tensor_mesh(patch.value, box), "surface", SKY)
    for line in bisector.lines:
        label = f"lines of {_short(line)}"
        for rulings in _rulings(line):
            _plot(ax, _lines_mesh(rulings, box), label, ORANGE)
    for pair in bisector.pairs:
        _plot_pair(ax, pair, box)
    return _finished(ax, box, title)


def _finished(ax: Axes, box: Box, of: str) -> Axes:
    """The picture with its title, its legend, and the box as its frame; parts that continue outside the box cross the
    frame.
    """
    if ax.name == "3d":
        show_box(ax, box)
    else:
        (left, low), (right, high) = (map(float, corner) for corner in box)
        ax.set(aspect="equal", adjustable="box", xlim=(left, right), ylim=(low, high))
    ax.set_title(f"bisector of {of}")
    legend_once(ax)
    return ax


def _short(line: LineComponent) -> str:
    text = "all pairs" if line.equation is None else f"{line.equation.text} = 0"
    return text if len(text) <= 30 else "a curve of pairs"


def _box_of(curves: Iterable[Nurbs], more: Iterable[Point] = ()) -> Box:
    box = box_around([*(p for c in curves for run in sampled(c, c.breakpoints) for _, p in run), *more])
    return grown(box if box[0] != box[1] else _unit_around(box[0]), mpq(1, 2))


def _unit_around(point: Point) -> Box:
    return tuple(mpq(x - 1) for x in point), tuple(mpq(x + 1) for x in point)


def _plot(ax: Axes, mesh: SurfaceMesh, label: str, color: str) -> None:
    """Draw a surface, unless no part of it is in the box."""
    if mesh.faces:
        plot_mesh(mesh, ax, label=label, color=color, control_net=False)


def _lines_mesh(rulings: Sequence[Ruling | None], box: Box) -> SurfaceMesh:
    """Lines, one after another, as a surface that is cut at a box; None if the surface is interrupted.

    >>> mesh = _lines_mesh([((0, 0, 0), (0, 0, 1)), ((1, 0, 0), (0, 0, 2))], ((-2, -2, -2), (2, 2, 2)))
    >>> len(mesh.faces), max(p[2] for face in mesh.faces for p in face)
    (12, mpq(2,1))
    """
    patches: list[list[list[Point | None]]] = [[]]
    before: Point | None = None
    for ruling in rulings:
        run = None if ruling is None else clipped(*_turned(ruling, before), box)
        if ruling is None or run is None:
            before = None
            patches.append([])
            continue
        before = _turned(ruling, before)[1]
        low, high = run
        row = [tuple(x + mpq(k, ALONG) * (y - x) for x, y in zip(low, high, strict=True)) for k in range(ALONG + 1)]
        patches[-1].append(list(row))
    return SurfaceMesh([rows for rows in patches if len(rows) > 1], [], 0, 0)


def _turned(ruling: Ruling, before: Point | None) -> Ruling:
    """The line, with its direction chosen to agree with that of the previous line."""
    point, direction = ruling
    against = before is not None and sum(x * y for x, y in zip(before, direction, strict=True)) < 0
    return point, tuple(-x for x in direction) if against else direction


def _rulings(line: LineComponent) -> list[list[Ruling | None]]:
    """The lines of a component, run by run."""
    runs = [
        _rulings_over(one.surface.directrix, one.surface.generator.vector, one.low, one.high) for one in line.pieces
    ]
    for branch in line.real.branches:
        run: list[Ruling | None] = []
        for s in _between(branch.low, branch.high):
            inside = [t for t in line.partners(s) if t not in line.sides[1]]
            run.append(_middle(line.line(s, inside[branch.index], DIGITS)) if branch.index < len(inside) else None)
        runs.append(run)
    if line.fixed is not None:
        own = 0 if line.correspondence is Correspondence.FIRST_FIXED else 1
        others = _between(*line.sides[1 - own])
        places = [(line.fixed, x) if own == 0 else (x, line.fixed) for x in others]
        runs.append([_middle(line.line(s, t, DIGITS)) for s, t in places])
    return runs


def _rulings_over(directrix: Rational[BSpline], generator: Any, low: Any, high: Any) -> list[Ruling | None]:
    """The lines of a ruled surface over an interval."""
    return [
        (directrix.point(u), _value(generator, u)) if directrix.denominator(u) else None for u in _between(low, high)
    ]


def _value(generator: Any, u: mpq) -> Point:
    return generator.point(u) if isinstance(generator, Rational) else tuple(g(u) for g in generator)


def _between(low: Any, high: Any) -> list[mpq]:
    """Parameters strictly inside an interval, and those of its ends that are rational."""
    a, b = (t.refine(DIGITS) if isinstance(t, Root) else (t, t) for t in (low, high))
    return [a[1] + (b[0] - a[1]) * mpq(k, RULINGS) for k in range(RULINGS + 1)]


def _middle(flat: Any) -> Ruling | None:
    """A line in balls as the line through their midpoints; None if a ball is not finite."""
    rows = [flat.point, flat.direction]
    if not all(x.is_finite() for row in rows for x in row):
        return None
    point, direction = (tuple(_rational(x) for x in row) for row in rows)
    return point, direction


def _rational(x: arb) -> mpq:
    mantissa, exponent = x.mid().man_exp()
    return mpq(int(mantissa) * mpq(2) ** int(exponent))


def _plot_pair(ax: Axes, pair: SinglePair, box: Box) -> None:
    if pair.solutions is Solutions.SPACE:
        return
    flat = pair.exact
    ruling = (flat.point, flat.direction) if flat is not None else _middle(pair.enclosed(DIGITS))
    if ruling is None:
        return
    if pair.solutions is Solutions.LINE:
        ends = clipped(*ruling, box)
        if ends is not None:
            draw(ax, ends, color=VERMILLION, linewidth=1.2, label="line of a single pair", zorder=4)
        return
    point, normal = ruling[0], Vector(*ruling[1])
    one = next(v for e in (Vector(0, 0, 1), Vector(0, 1, 0)) if any(v := cross(normal, e.mapped(mpq))))
    other = cross(normal, one)
    size = max(b - a for a, b in zip(*box, strict=True))
    steps = [size * mpq(k, ALONG) for k in range(-ALONG, ALONG + 1)]
    square = dot(other, other)
    starts = [tuple(x + k * y / _root(square) for x, y in zip(point, other, strict=True)) for k in steps]
    _plot(ax, _lines_mesh([(start, tuple(one)) for start in starts], box), "plane of a single pair", PURPLE)


def _root(x: mpq) -> mpq:
    """A rough square root, for the distance between the rulings of a plane."""
    return mpq(1 << (max(int(x).bit_length(), 1) // 2))


def plot_point_bisector(bisector: PointBisector, curve: Nurbs, point: Sequence[Number], ax: Axes | None = None) -> Axes:
    """The ruled bisector of a point and a space curve, in a box around both."""
    ax, place = axes_for(ax, 3), tuple(map(rational, point))
    box = _box_of([curve], [place])
    plot_curve(curve, ax, control_polygon=False, knots=False)
    for piece in bisector.pieces:
        directrix = piece.surface.directrix
        assert isinstance(directrix, Rational)
        _plot(ax, _lines_mesh(_rulings_over(directrix, piece.surface.generator, *piece.interval), box), "bisector", SKY)
    mark_points(ax, [place], "point")
    return _finished(ax, box, f"{shown_name(curve)} and a point")


def plot_plane_bisector(bisector: PlaneBisector, ax: Axes | None = None) -> Axes:
    """Draw the bisector of two plane curves: the parts to which no other point of a curve is nearer, and the other
    parts in grey.

    >>> from exactspline import Nurbs
    >>> from exactspline.geometry.bisectors.plane_curves import PlaneBisector
    >>> line, other = (Nurbs(1, [0, 0, 1, 1], points) for points in ([(0, 0), (2, 0)], [(0, 1), (3, 4)]))
    >>> [text.get_text() for text in plot_plane_bisector(PlaneBisector(line, other)).get_legend().get_texts()]
    ['curve (s)', 'curve (t)', 'bisector']
    """
    ax, box = axes_for(ax), _box_of(bisector.curves)
    title = plot_both(bisector.curves, ax, SKY)
    feet = bisector.trimmed.kept
    for run in bisector.pairs.sampled(SAMPLES):
        points = [(_point_of(bisector, pair), _is_in(pair, feet)) for pair in run]
        for color, label, is_true in ((SILVER, "not nearest, or undecided", False), (GREEN, "bisector", True)):
            runs = runs_in([point if true == is_true else None for point, true in points], box)
            draw_runs(ax, runs, label, color=color, linewidth=1.5, zorder=3)
    return _finished(ax, box, title)


def _point_of(bisector: PlaneBisector, pair: tuple[mpq, mpq]) -> Point | None:
    """The bisector point of a pair near the curve of pairs; None if there is none."""
    try:
        x, y = (real(x).enclosure(DIGITS).middle for x in bisector.point(*pair))
    except ReachError:
        return None
    return x, y


def _is_in(pair: tuple[mpq, mpq], boxes: Iterable[Intervals]) -> bool:
    return any(all(low <= x <= high for x, (low, high) in zip(pair, box, strict=True)) for box in boxes)


def plot_trimmed_bisector(
    bisector: TrimmedBisector, curve: Nurbs, point: Sequence[Number], ax: Axes | None = None
) -> Axes:
    """The true bisector of a point and a plane curve: arcs, and the straight pieces of ends and corners.

    >>> from exactspline import Nurbs
    >>> from exactspline.geometry.bisectors.trimmed import trimmed_bisector
    >>> line = Nurbs(1, [0, 0, 1, 1], [(-4, 0), (4, 0)])
    >>> ax = plot_trimmed_bisector(trimmed_bisector(line, (0, 2)), line, (0, 2))
    >>> [text.get_text() for text in ax.get_legend().get_texts()]
    ['curve', 'arc', 'line (foot: end point)', 'point']
    """
    ax, place = axes_for(ax), tuple(map(rational, point))
    box = _box_of([curve], [place])
    plot_curve(curve, ax, control_polygon=False, knots=False)
    for piece in bisector.pieces:
        low, high = (parameter(t, piece.value.denominator.domain) for t in (piece.low, piece.high))
        places = [low + (high - low) * mpq(k, SAMPLES) for k in range(SAMPLES + 1)]
        points = [piece.value.point(t) if piece.value.denominator(t) else None for t in places]
        color, label = (GREEN, "arc") if piece.foot is None else (VERMILLION, f"line (foot: {piece.kind})")
        draw_runs(ax, runs_in(points, box), label, color=color, linewidth=1.5, zorder=3)
    draw(ax, [place], "o", color=BLACK, markersize=5, label="point", zorder=5)
    return _finished(ax, box, f"{shown_name(curve)} and a point")
