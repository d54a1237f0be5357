"""Pieces of a curve that are nearly lines or, in the plane, arcs of circles, replaced by exact ones."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass
from itertools import pairwise

from exactspline.errors import ShapeError
from exactspline.geometry.recognition.pieces import RecognizedPiece, near, recognized, signs, small_distance
from exactspline.geometry.recognition.shapes import Circle, Line, Point, Shape, ShapeKind, minus
from exactspline.interchange.segments import Affine, Segment, arc_around_origin, joined_segments, mapped, polynomial
from exactspline.language.wronskians import wronskians
from exactspline.numbers.exact import Number, mpq, scalar
from exactspline.numbers.intervals import Side
from exactspline.one_line import OneLine
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.precision import distance
from exactspline.splines.type_checks import curve_of
from exactspline.words import choice

#: The shapes that can be written exactly between two given points.
KINDS = (ShapeKind.LINE, ShapeKind.CIRCLE)


@dataclass(frozen=True, repr=False)
class Snapped(OneLine):
    """A curve in which some pieces near a shape are replaced by exact pieces.

    `replaced`: the pieces of the original curve, each with the exact shape that replaces it and the proved distance
    between both. `kept`: unchanged pieces that are within the distance of a shape, but not of a shape through their end
    points, and unchanged arcs of circles in space.
    """

    curve: Nurbs
    replaced: tuple[RecognizedPiece, ...]
    kept: tuple[RecognizedPiece, ...]


def snapped(curve: Nurbs, kinds: Collection[ShapeKind | str] = KINDS, epsilon: Number | None = None) -> Snapped:
    """The curve in which the pieces that run along a line or a circle within the distance epsilon (by default 10⁻⁹ of
    the size of the curve) are replaced by exact pieces with the same end points. All other pieces, and pieces that lie
    on their shape exactly, are unchanged, over the same parameters.

    An arc has the tangents of the piece at both ends if such an arc is within the distance; otherwise its centre is the
    point equally far from both end points that is nearest to the centre of the recognized circle.

    >>> rounded = Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], [1, "0.7071", 1])
    >>> found = snapped(rounded, ["circle"], "1e-4")
    >>> found.curve.control_points == rounded.control_points, *found.curve.weights
    (True, mpq(2,1), mpq(1,1), mpq(1,1))
    >>> print(found.replaced[0].shape, found.replaced[0].within < mpq(1, 10**5))
    circle: centre (0, 0), radius 1 True

    Raises `ShapeError` for a curve that jumps, for one that is neither in the plane nor in space, for another kind of
    shape, and for an epsilon that is not positive.
    """
    given, requested = curve_of(curve), checked_kinds(kinds)
    replaced, kept = dict[mpq, RecognizedPiece](), list[RecognizedPiece]()
    limit = small_distance(given) if epsilon is None else distance(epsilon, given)
    for piece in recognized(given, limit or None):
        if piece.kind in requested and not piece.exact:
            tried = (near(given, piece.piece, shape, limit) for shape in _between_ends(given, piece))
            if found := next(filter(None, tried), None):
                replaced[piece.piece.start] = found
            else:
                kept.append(piece)
    return Snapped(_with(given, replaced) if replaced else given, tuple(replaced.values()), tuple(kept))


def checked_kinds(kinds: Collection[ShapeKind | str]) -> frozenset[ShapeKind]:
    """The kinds of shapes, checked: a piece can be replaced by each of them; raises `ShapeError` for other kinds."""
    requested = frozenset(choice(ShapeKind, kind, "shape", raised=ShapeError) for kind in kinds)
    if other := sorted(requested - set(KINDS)):
        raise ShapeError(f"a piece replaced by a {other[0]}", remedy=f"this needs {' or '.join(KINDS)}")
    return requested


def _between_ends(curve: Nurbs, piece: RecognizedPiece) -> Iterator[Shape]:
    """Shapes of the same kind through the end points of a piece; first, if it exists, the shape with the tangents of
    the piece there.
    """
    a, b = _ends(curve, piece)
    if not isinstance(piece.shape, Circle):
        yield Line(a, minus(b, a))
    if not isinstance(piece.shape, Circle) or curve.dimension > 2:
        return
    if (tangent := _tangent_circle(curve, piece)) is not None:
        yield tangent
    yield _circle(piece.shape, a, b)


def _tangent_circle(curve: Nurbs, piece: RecognizedPiece) -> Circle | None:
    """The circle through both end points with the tangents of the piece there."""
    a, b = _ends(curve, piece)
    velocity, sides = wronskians(curve.w, curve.p), (Side.RIGHT, Side.LEFT)
    (x, y), last = (tuple(f(t, side) for f in velocity) for t, side in zip(piece.piece.parts[0], sides, strict=True))
    normal, chord = (-y, x), minus(b, a)
    if not (across := scalar(normal, chord)):
        return None
    factor = scalar(chord, chord) / across / 2
    centre = tuple(c + factor * n for c, n in zip(a, normal, strict=True))
    radius = minus(b, centre)
    return None if scalar(radius, last) else Circle(centre, scalar(radius, radius))


def _ends(curve: Nurbs, piece: RecognizedPiece) -> tuple[Point, Point]:
    return curve(piece.piece.start), curve(piece.piece.end, "left")


def _circle(found: Circle, a: Point, b: Point) -> Circle:
    """The circle through two points whose centre is nearest to that of another."""
    chord, centre = minus(b, a), found.centre
    if any(chord):
        middle = tuple((x + y) / 2 for x, y in zip(a, b, strict=True))
        along = scalar(minus(centre, middle), chord) / scalar(chord, chord)
        centre = tuple(c - along * u for c, u in zip(centre, chord, strict=True))
    radius = minus(a, centre)
    return Circle(centre, scalar(radius, radius))


def _with(curve: Nurbs, replaced: dict[mpq, RecognizedPiece]) -> Nurbs:
    """The curve with exact pieces, by the parameters at which they begin."""
    parts = list(_parts(curve, replaced))
    degree, knots, points = joined_segments([segment for _, segments in parts for segment in segments])
    breaks = [curve.domain[0]]
    for end, segments in parts:
        start, n = breaks[-1], len(segments)
        breaks += [start + (end - start) * mpq(k, n) for k in range(1, n + 1)]
    places = [tuple(x / point[-1] for x in point[:-1]) for point in points]
    return Nurbs(degree, [breaks[int(t)] for t in knots], places, [point[-1] for point in points], name=curve.name)


def _parts(curve: Nurbs, replaced: dict[mpq, RecognizedPiece]) -> Iterator[tuple[mpq, list[Segment]]]:
    """The ends of consecutive parts, each with its segments: those of the curve, one by one, and exact pieces."""
    rows = zip(*[f.bezier_points for f in curve.p], strict=True)
    weights = curve.w.bezier_points if not curve.polynomial else [(mpq(1),) * (curve.degree + 1)] * curve.segments
    behind = curve.domain[0]
    for (start, end), columns, row in zip(pairwise(curve.breakpoints), rows, weights, strict=True):
        if start < behind:
            continue
        found = replaced.get(start)
        behind = end if found is None else found.piece.end
        yield behind, [tuple(zip(*columns, row, strict=True))] if found is None else _exact(curve, found)


def _exact(curve: Nurbs, found: RecognizedPiece) -> list[Segment]:
    """A piece of a line or a circle between two points, in the direction of the curve."""
    a, b = _ends(curve, found)
    if not isinstance(found.shape, Circle):
        return [polynomial(a, b)]
    centre = found.shape.centre
    ends = [minus(a, centre), minus(b, centre)]
    left = 1 in signs(found.shape.advance(curve.restrict(found.piece.start, found.piece.end)))
    arcs = arc_around_origin(*(ends if left else ends[::-1]))
    there = mapped(arcs, Affine([[1, 0, centre[0]], [0, 1, centre[1]]]))
    return there if left else [segment[::-1] for segment in reversed(there)]
