"""Space curves, or pieces of them, that lie in a plane: the plane exactly, and in a coordinate plane the curve as a
plane curve.

A curve p/w lies in the plane n·x = c exactly where n·p − c·w is identically zero: a linear relation between the Bézier
points of (p, w), found by elimination over the rationals.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import TypeVar

from flint import fmpz, fmpz_mat

from exactspline.errors import ShapeError
from exactspline.geometry.curves.facts import facts_of
from exactspline.geometry.derived.derive import space
from exactspline.numbers.exact import common_divisor, mpq, primitive, ratio, text
from exactspline.one_line import OneLine
from exactspline.polynomials.bernstein import Form, over_common_denominator
from exactspline.roots.answers import CurvePiece
from exactspline.splines.knots import intervals_of
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of

AXES = "xyz"
T = TypeVar("T")


@dataclass(frozen=True, repr=False)
class Plane(OneLine):
    """The plane ``normal·x = offset``: integers without a common divisor, the first nonzero component of the normal
    being positive.

    >>> str(Plane((1, 0, -2), 3))
    'x − 2z = 3'
    """

    normal: tuple[int, int, int]
    offset: int

    def __str__(self) -> str:
        axis = self.axis
        if axis is not None:
            return f"{AXES[axis]} = {text(mpq(self.offset, self.normal[axis]))}".replace("= -", "= −")
        terms = [(k, name) for k, name in zip(self.normal, AXES, strict=True) if k]
        parts = [("− " if k < 0 else "+ ") + (str(abs(k)) if abs(k) != 1 else "") + name for k, name in terms]
        left = " ".join(parts).removeprefix("+ ")
        return f"{left} = {self.offset}".replace("= -", "= −")

    @property
    def axis(self) -> int | None:
        """The number of the coordinate that is constant on a coordinate plane (or one parallel to it), else None."""
        return self.across if sum(map(bool, self.normal)) == 1 else None

    @property
    def across(self) -> int:
        """The number of the first coordinate that is not constant along the normal. Without this coordinate, points of
        the plane have two coordinates: an affine image of the plane as seen from the tip of the normal (`seen`).
        """
        return next(i for i, k in enumerate(self.normal) if k)

    def seen(self, point: Sequence[T]) -> tuple[T, T]:
        """Two coordinates of a point of the plane: (x, y), (z, x) or (y, z).

        >>> Plane((1, 0, -2), 3).seen(("x", "y", "z"))
        ('y', 'z')
        """
        return point[(self.across + 1) % 3], point[(self.across + 2) % 3]


def plane_of(curve: Nurbs) -> Plane | None:
    """The plane of a space curve, None if there is no such plane; for a straight curve a coordinate plane, or a plane
    parallel to one, if it contains the curve, otherwise None.

    >>> from exactspline.interchange.examples import example
    >>> print(plane_of(example("planar_in_space"))), plane_of(example("twisted_cubic"))
    x − z = −1
    (None, None)

    Raises `ShapeError` for a curve that is not in space.
    """
    points = _span_of(curve)
    relations = _relations(points)
    if len(relations) == 1:
        return _plane(relations[0])
    for i in (2, 1, 0):
        if relations and len(_relations([(row[i], row[3]) for row in points])) == 1:
            (a, k) = _relations([(row[i], row[3]) for row in points])[0]
            return _plane([a if j == i else mpq(0) for j in range(3)] + [k])
    return None


def in_common_plane(*curves: Nurbs) -> tuple[Plane, list[Nurbs]] | None:
    """A plane that contains all given space curves, and their images in two coordinates of the plane (`Plane.seen`);
    None if there is no such plane.

    >>> from exactspline.interchange.examples import example
    >>> plane, (curve,) = in_common_plane(example("planar_in_space"))
    >>> str(plane), curve
    ('x − z = −1', <Nurbs planar_in_space in the plane x − z = −1: rational, degree 3, 4 control points in R2>)
    >>> in_common_plane(example("planar_in_space"), example("twisted_cubic"))
    """
    relations = _relations(_span_of(*curves))
    plane = _plane(relations[0]) if relations else None
    return None if plane is None else (plane, [_seen_in(plane, curve) for curve in curves])


def _span_of(*curves: Nurbs) -> Rows:
    """The span of the Bézier points of curves in space; the whole space as soon as they lie in no plane."""
    points: Rows = []
    segments = chain.from_iterable(_rows(space(curve)) for curve in curves)
    while len(points) < 4 and (segment := next(segments, None)):
        points = _span([*points, *segment])
    return points


def planar_pieces(curve: Nurbs) -> list[tuple[CurvePiece, Plane]]:
    """The longest pieces on each of which a space curve lies in one plane (τ ≡ 0) without being straight, with their
    planes; on a closed curve they continue across the seam.

    Two such pieces can share a straight piece.

    >>> from exactspline.interchange.examples import example
    >>> [str(piece) for piece, _ in planar_pieces(example("planar_in_space"))]
    ['[0, 1]']
    """
    rows, breaks = _rows(space(curve)), curve.breakpoints
    count = len(rows)
    planar_runs = _planar_runs(rows)
    if curve.closed and all(last - first < count for first, last, _ in planar_runs):
        # twice around, so that a run that crosses the seam is seen completely
        planar_runs = [
            (first % count, first % count + last - first, span)
            for first, last, span in _planar_runs([*rows, *rows])
            if 1 <= first <= count
        ]
    planar = sorted((run for run in planar_runs if len(run[2]) == 3), key=lambda run: run[:2])
    return [
        (CurvePiece(intervals_of(breaks, first, last - first)), _plane(_relations(span)[0]))
        for first, last, span in planar
    ]


Rows = list[tuple[fmpz, ...]]


def _planar_runs(rows: list[Rows]) -> list[tuple[int, int, Rows]]:
    """The maximal runs of segments ``[first, last)`` that lie in one plane, and the span of their points."""
    planar_runs: list[tuple[int, int, Rows]] = []
    first = last = 0
    span: Rows = []
    while last < len(rows):
        wider = _span([*span, *rows[last]])
        if len(wider) < 4:
            span, last = wider, last + 1
            continue
        if span:
            planar_runs.append((first, last, span))
        # the next run begins with the earliest segment that lies in one plane with the next one
        first, span = last, _span(rows[last])
        while len(span) < 4 and len(wider := _span([*span, *rows[first - 1]])) < 4:
            first, span = first - 1, wider
        last += 1
        if len(span) == 4:
            first, span = last, []
    if span:
        planar_runs.append((first, last, span))
    return planar_runs


def _rows(curve: Nurbs) -> list[Rows]:
    """Integer multiples of the homogeneous Bézier points (p, w), segment by segment."""
    n = curve.degree
    columns = [s.elevated_to(curve.p[0]).forms for s in (*curve.p, curve.w)]
    return [_whole(n, parts) for parts in zip(*columns, strict=True)]


def _whole(n: int, forms: Sequence[Form]) -> Rows:
    """The coefficients of forms of degree n side by side, over a common denominator."""
    polynomials, _ = over_common_denominator(forms)
    return [tuple([c[i] for c in polynomials]) for i in range(n + 1)]


def _span(rows: Rows) -> Rows:
    """A basis of the span of the rows, in echelon form: integers without a common divisor, each pivot being the only
    nonzero entry of its column.
    """
    matrix, _, rank = fmpz_mat(rows).rref()
    return [_primitive(row) for row in matrix.tolist()[:rank]]


def _primitive(row: Sequence[fmpz]) -> tuple[fmpz, ...]:
    divisor = common_divisor(row)
    return tuple([x // divisor for x in row])


def _relations(rows: Rows) -> list[list[mpq]]:
    """A basis of the linear relations between the coordinates of the rows."""
    reduced, width = _span(rows), len(rows[0])
    pivots = [next(j for j in range(width) if row[j]) for row in reduced]
    basis = []
    for free in (j for j in range(width) if j not in pivots):
        relation = [mpq(j == free) for j in range(width)]
        for row, j in zip(reduced, pivots, strict=True):
            relation[j] = ratio(-row[free], row[j])
        basis.append(relation)
    return basis


def _plane(relation: list[mpq]) -> Plane:
    """The plane of a relation n·p + k w = 0."""
    a, b, c, k = map(int, primitive(relation))
    return Plane((a, b, c), -k)


def as_plane_curve(curve: Nurbs) -> Nurbs | None:
    """A space curve with a constant coordinate as a plane curve, None when there is no such coordinate.

    The plane is seen from the tip of the axis: the coordinates are (x, y), (z, x) or (y, z), so that [γ′ γ″] is the
    component of γ′ × γ″ along it.

    >>> from exactspline import Nurbs
    >>> as_plane_curve(Nurbs(1, [0, 0, 1, 1], [(1, 7, 2), (3, 7, 5)])).control_points
    ((mpq(2,1), mpq(1,1)), (mpq(5,1), mpq(3,1)))
    """
    plane = plane_of(curve)
    return None if plane is None or plane.axis is None else _seen_in(plane, curve)


def _seen_in(plane: Plane, curve: Nurbs) -> Nurbs:
    """A curve in a plane by two coordinates."""
    name = f"{curve.name or 'the curve'} in the plane {plane}"
    x, y = (f.control_points for f in plane.seen([*curve.p]))
    weights = [mpq(1)] * len(x) if curve.polynomial else curve.w.control_points
    points = list(zip(x, y, weights, strict=True))
    return Nurbs.from_homogeneous(curve.degree, curve.knots, points, name=name, source=curve.source)


def in_the_plane(curve: Nurbs) -> Nurbs:
    """A space curve with z = 0, as most curves in files of drawings, as a plane curve; any other curve unchanged.

    >>> from exactspline import Nurbs
    >>> in_the_plane(Nurbs(1, [0, 0, 1, 1], [(1, 2, 0), (3, 4, 0)])).control_points
    ((mpq(1,1), mpq(2,1)), (mpq(3,1), mpq(4,1)))
    """
    if curve.dimension != 3 or not curve.p[2].is_zero:
        return curve
    return facts_of(curve).once("in the plane z = 0", lambda: as_plane_curve(curve) or curve)


def in_one_plane(first: Nurbs, second: Nurbs) -> tuple[Nurbs, Nurbs]:
    """Two curves as plane curves if each is in the plane or has z = 0 in space; otherwise the curves unchanged.

    >>> from exactspline.interchange.examples import example
    >>> [curve.dimension for curve in in_one_plane(example("ellipse_in_space"), example("circle"))]
    [2, 2]
    """
    flat = in_the_plane(first), in_the_plane(second)
    return flat if flat[0].dimension == flat[1].dimension else (first, second)


def check_in_one_space(first: Nurbs, second: Nurbs) -> None:
    """Raise `ShapeError` for two curves of different dimensions, or outside plane and space.

    >>> from exactspline.interchange.examples import example
    >>> check_in_one_space(example("circle"), example("twisted_cubic"))
    Traceback (most recent call last):
    exactspline.errors.ShapeError: a curve in R2 and one in R3; give curves of the same dimension
    """
    for curve in (first, second):
        if curve_of(curve).dimension not in (2, 3):
            facts_of(curve).check_dimension()
    if first.dimension != second.dimension:
        different = f"a curve in R{first.dimension} and one in R{second.dimension}"
        raise ShapeError(different, remedy="give curves of the same dimension")


def with_plane_curves(curves: Iterable[Nurbs]) -> list[Nurbs]:
    """The curves, where each space curve with a constant coordinate is followed by its plane curve.

    >>> from exactspline.interchange.examples import example
    >>> len(with_plane_curves([example("planar_in_space"), example("circle")]))
    2
    """
    result = []
    for curve in curves:
        flat = as_plane_curve(curve) if curve.dimension == 3 else None
        result += [curve] if flat is None else [curve, flat]
    return result
