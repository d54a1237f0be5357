"""The points of a curve in the forms in which file formats store them."""

from __future__ import annotations

from itertools import pairwise

from exactspline.errors import ShapeError, WeightError
from exactspline.numbers.exact import mpq
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface

Point = tuple[mpq, ...]


def cartesian(curve: Nurbs) -> tuple[Point, ...]:
    """The Cartesian control points; raises `WeightError` if one has weight zero (a control vector), because it has no
    Cartesian coordinates.
    """
    if not all(curve.weights):
        raise WeightError(
            "a control point of weight zero",
            where=f"weights[{curve.weights.index(mpq(0))}]",
            remedy="use json or a homogeneous format (g2, itd)",
        )
    return curve.control_points


def homogeneous(curve: Nurbs) -> list[Point]:
    """The points (w x, w y, …, w)."""
    rows = zip(curve.control_points, curve.weights, strict=True)
    return [(*(x * (w or 1) for x in point), w) for point, w in rows]


def pen_segments(curve: Nurbs) -> list[list[Point]]:
    """The Bézier segments of a connected polynomial plane curve of degree 1 to 3, as SVG and pens draw them; raises
    `ShapeError` for other curves and at a jump.
    """
    if curve.dimension != 2 or not curve.polynomial or not 1 <= curve.degree <= 3:
        kind = "polynomial" if curve.polynomial else "rational"
        raise ShapeError(
            f"a {kind} curve of degree {curve.degree} in R{curve.dimension}",
            remedy="this format holds polynomial plane curves of degree 1 to 3",
        )
    columns = [component.segments for component in curve.p]
    segments = [[*zip(*rows, strict=True)] for rows in zip(*columns, strict=True)]
    for before, after in pairwise(segments):
        if before[-1] != after[0]:
            raise ShapeError("a jump", remedy="split the curve there")
    return segments


def in_space(curve: Nurbs) -> list[Point]:
    """The Cartesian control points in space, a plane curve at z = 0; raises `ShapeError` above dimension 3."""
    if curve.dimension > 3:
        raise ShapeError(f"a curve in R{curve.dimension}", remedy="this format holds curves in the plane and in space")
    return [(*point, mpq(0)) if curve.dimension == 2 else point for point in cartesian(curve)]


def net_rows(surface: NurbsSurface, *, u_fastest: bool = True) -> list[tuple[Point, mpq]]:
    """The control points of a surface with their weights, in the order of a file."""
    rows = [list(zip(*both, strict=True)) for both in zip(surface.control_points, surface.weights, strict=True)]
    ordered = zip(*rows, strict=True) if u_fastest else rows
    return [pair for row in ordered for pair in row]


def cartesian_net(surface: NurbsSurface, *, u_fastest: bool = True) -> list[tuple[Point, mpq]]:
    """The same; raises `WeightError` for a weight of zero, because such a point has no Cartesian coordinates."""
    rows = net_rows(surface, u_fastest=u_fastest)
    if not all(weight for _, weight in rows):
        raise WeightError("a control point of weight zero", remedy="use json or a homogeneous format (g2, itd)")
    return rows


def homogeneous_net(surface: NurbsSurface, *, u_fastest: bool = True) -> list[Point]:
    """The points (w x, w y, …, w) in the order of a file."""
    return [(*(x * (w or 1) for x in point), w) for point, w in net_rows(surface, u_fastest=u_fastest)]
