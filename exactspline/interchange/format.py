"""The description of a file format, and of curves and surfaces as files store them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from exactspline.errors import ShapeError, WeightError, as_instance
from exactspline.interchange.numbers import NumberText
from exactspline.interchange.records import NamedCurve, Piece, Reading, Source
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval
from exactspline.one_line import OneLine
from exactspline.splines.knots import KnotVector
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface

# ---- curves and surfaces as formats store them


Point = tuple[mpq, ...]


class Spline:
    """A curve or a surface as a file holds it: degree and knots for each parameter, and the control points with their
    weights in a list; the control points of a surface are listed along u first or along v first.
    """

    def __init__(self, given: NamedCurve | NurbsSurface) -> None:
        self.of = of = given.curve if isinstance(given, NamedCurve) else given
        self.name, self.polynomial, self.dimension = given.name, of.polynomial, of.dimension
        self.degrees: Sequence[int] = of.degree if isinstance(of, NurbsSurface) else [of.degree]
        self.knots: Sequence[KnotVector] = of.knots if isinstance(of, NurbsSurface) else [of.knots]
        self.domains: Sequence[Interval] = of.domain if isinstance(of, NurbsSurface) else [of.domain]
        self.is_surface = isinstance(of, NurbsSurface)
        self.counts = [len(knots) - degree - 1 for knots, degree in zip(self.knots, self.degrees, strict=True)]

    @property
    def curve(self) -> Nurbs:
        """The curve, for formats without surfaces."""
        return as_instance(self.of, Nurbs, "a curve", "write it in a format that holds surfaces")

    def points(self, *, u_fastest: bool = True) -> list[tuple[Point, mpq]]:
        """The control points with their weights, in the order of a file."""
        of = self.of
        if isinstance(of, Nurbs):
            return list(zip(of.control_points, of.weights, strict=True))
        rows = [list(zip(*both, strict=True)) for both in zip(of.control_points, of.weights, strict=True)]
        return [pair for row in (zip(*rows, strict=True) if u_fastest else rows) for pair in row]

    def cartesian(self, *, u_fastest: bool = True) -> list[tuple[Point, mpq]]:
        """The control points with their weights; raises `WeightError` for a weight of zero (a control vector), because
        such a point has no Cartesian coordinates.
        """
        points = self.points(u_fastest=u_fastest)
        if not all(weight for _, weight in points):
            where = "" if self.is_surface else f"weights[{[weight for _, weight in points].index(mpq(0))}]"
            remedy = "use json or a homogeneous format (g2, itd)"
            raise WeightError("a control point of weight zero", where=where, remedy=remedy)
        return points

    def in_space(self, *, u_fastest: bool = True) -> list[tuple[Point, mpq]]:
        """The curve or surface in space: a plane curve and a map of the plane at z = 0. Raises `ShapeError` above
        dimension 3.
        """
        if self.dimension > 3:
            what = f"a {'surface' if self.is_surface else 'curve'} in R{self.dimension}"
            raise ShapeError(what, remedy="this format holds what is in the plane and in space")
        return [((*point, mpq(0))[:3], weight) for point, weight in self.cartesian(u_fastest=u_fastest)]

    def rows(self) -> list[Point]:
        """The control points, with weights as (w x, w y, …, w)."""
        if self.polynomial:
            return [point for point, _ in self.points()]
        return [homogeneous(*each) for each in self.points()]


def homogeneous(point: Point, weight: mpq) -> Point:
    """The point (w x, w y, …, w)."""
    return (*(x * (weight or 1) for x in point), weight)


def pen_segments(curve: Nurbs) -> list[list[Point]]:
    """The Bézier segments of a connected polynomial plane curve of degree 1 to 3, as SVG and pens draw them; raises
    `ShapeError` for other curves and at a jump.
    """
    if curve.dimension != 2 or not curve.polynomial or not 1 <= curve.degree <= 3:
        kind = "polynomial" if curve.polynomial else "rational"
        remedy = "this format holds polynomial plane curves of degree 1 to 3"
        raise ShapeError(f"a {kind} curve of degree {curve.degree} in R{curve.dimension}", remedy=remedy)
    rows = zip(*[component.bezier_points for component in curve.p], strict=True)
    segments = [[*zip(*row, strict=True)] for row in rows]
    for before, after in pairwise(segments):
        if before[-1] != after[0]:
            raise ShapeError("a jump", remedy="split the curve there")
    return segments


@dataclass(frozen=True, repr=False)
class Format(OneLine):
    """A file format: its name, its title, the suffixes of its files, a function that recognizes the beginning of a
    file, its reader and writer, and a note on the information that is lost in writing; for formats with large files,
    also a reader that yields piece after piece; whether surfaces are written, too, and whether parts can be named, as a
    glyph of a font.
    """

    name: str
    title: str
    suffixes: tuple[str, ...]
    looks_like: Callable[[bytes], bool]
    read: Callable[[Source], Reading]
    write: Callable[[Sequence[Spline], NumberText], bytes] | None = None
    loses: str = ""
    pieces: Callable[[Source], Iterator[Piece]] | None = None
    surfaces: bool = False
    parts: bool = False
