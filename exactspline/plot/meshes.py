"""Surfaces as exact points: the grid that is shaded and the control net around it, whatever draws them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from gmpy2 import mpq

from exactspline.errors import ShapeError
from exactspline.exact import rational
from exactspline.factors import split
from exactspline.language import RuledSurface
from exactspline.plot.canvas import Point, Run, parameter, polygons
from exactspline.plot.frames import Box, homogeneous, kept, usual_box
from exactspline.zeros import zeros

#: Samples along the curve, in all and at least so many a segment; samples along a ruling.
SAMPLES, LEAST, ALONG = 192, 12, 9
#: A pole is approached up to so much of the distance between samples.
BESIDE = mpq(1, 8)


@dataclass(frozen=True)
class SurfaceMesh:
    """Rows of points in patches (None where there is no point, or one far away), and a control net.

    ``net`` are the polygons of the control points in runs drawn joined, ``points`` how many control points there are, ``hidden`` how many of them
    are directions (weight 0) or far away.
    """

    patches: list[list[list[Point | None]]]
    net: list[Run]
    points: int
    hidden: int

    @property
    def faces(self) -> list[Run]:
        """The quadrilaterals all of whose corners are there."""
        found = []
        for rows in self.patches:
            for a, b in pairwise(rows):
                for (p, q), (r, s) in zip(pairwise(a), pairwise(b), strict=True):
                    corners = [x for x in (p, q, s, r) if x is not None]
                    if len(corners) == 4:
                        found.append(corners)
        return found


def ruled_mesh(surface: RuledSurface, rulings: tuple[Any, Any] = (-1, 1), box: Box | None = None) -> SurfaceMesh:
    """The part of a ruled surface (in the spline reading) between two ruling parameters, cut at its poles; its net joins the polygons at both.

    `box` is what is kept; by default what lies around most of the points.

    >>> from exactspline.curves import example
    >>> from exactspline.formulas import find
    >>> mesh = ruled_mesh(find("tangent_developable")(example("twisted_cubic")), (0, 1))
    >>> mesh.points, mesh.hidden
    (8, 0)

    Raises `ShapeError` for anything but a ruled surface of splines in space, and for an interval of rulings that is none.
    """
    low, high = map(rational, rulings)
    if low >= high:
        raise ShapeError(f"rulings from {low} to {high}", where="rulings", remedy="the first must be the smaller one")
    components, denominator = split(surface)
    if len(components) != 6 or not hasattr(components[0], "breakpoints"):
        raise ShapeError("no ruled surface of splines in space", remedy="evaluate a formula of a ruled surface on a curve")
    if denominator is not None and not all(denominator.polynomials):
        raise ShapeError("the denominator vanishes on a whole segment", remedy="derive the surface piece by piece")

    def row(s: mpq, side: str) -> list[Point]:
        w = mpq(1) if denominator is None else denominator(s, side)
        values = [c(s, side) / w for c in components]
        steps = [low + (high - low) * mpq(k, ALONG - 1) for k in range(ALONG)]
        return [tuple(d + z * g for d, g in zip(values[:3], values[3:], strict=True)) for z in steps]

    poles = [] if denominator is None else [parameter(t, denominator.domain) for t in zeros(denominator)]
    patches = _sampled_rows(row, components[0].breakpoints, poles)
    box = usual_box([p for rows in patches for r in rows for p in (r[0], r[-1])], bool(poles)) if box is None else box
    net, points, hidden = _net(surface.joined, (low, high), box)
    return SurfaceMesh([[[kept(p, box) for p in r] for r in rows] for rows in patches], net, points, hidden)


def _sampled_rows(row: Callable[[mpq, str], list[Point]], breaks: Sequence[mpq], poles: Iterable[mpq]) -> list[list[list[Point]]]:
    """The rows patch by patch, patches ending beside poles and where the surface jumps."""
    poles = set(poles)
    cuts = sorted({*breaks, *poles})
    count = max(LEAST, SAMPLES // (len(breaks) - 1))
    patches: list[list[list[Point]]] = []
    for a, b in pairwise(cuts):
        step = (b - a) / count
        inner = [a + step * k for k in range(count + 1)]
        first = row(a, "right") if a not in poles else row(a + step * BESIDE, "right")
        last = row(b, "left") if b not in poles else row(b - step * BESIDE, "right")
        rows = [first, *[row(t, "right") for t in inner[1:-1]], last]
        if patches and a not in poles and patches[-1][-1] == first:
            patches[-1] += rows[1:]
        else:
            patches.append(rows)
    return patches


def _net(value: Any, rulings: tuple[mpq, mpq], box: Box) -> tuple[list[Run], int, int]:
    """The control polygons at the two rulings and the legs between them."""
    rows, knots, degree = homogeneous(value)
    edges: list[list[Point | None]] = [[], []]
    for *x, w in rows:
        for edge, z in zip(edges, rulings, strict=True):
            edge.append(kept(tuple((a + z * b) / w for a, b in zip(x[:3], x[3:], strict=True)), box) if w else None)
    runs = [run for edge in edges for run in polygons(knots, degree, edge)]
    legs = [[p, q] for p, q in zip(*edges, strict=True) if p is not None and q is not None]
    return runs + legs, 2 * len(rows), sum(p is None for edge in edges for p in edge)
