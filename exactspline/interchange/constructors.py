"""Exact circles, ellipses and conic arcs as rational quadratics with rational weights."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from exactspline.errors import ShapeError, counted
from exactspline.interchange.affine import Affine
from exactspline.interchange.segments import Segment, arc_around_origin, conic_arc, joined_segments, mapped
from exactspline.interchange.segments import ellipse as full_ellipse
from exactspline.numbers.exact import Number, mpq, rational
from exactspline.splines.nurbs import Nurbs


def circle(centre: Iterable[Number], radius: Number) -> Nurbs:
    """A full circle in the plane, counter-clockwise from its rightmost point, in four segments.

    >>> x, y = circle((1, 0), "5/2")("1/3")
    >>> (x - 1) ** 2 + y**2
    mpq(25,4)

    Raises `ShapeError` if the radius is not positive.
    """
    r = rational(radius)
    if r <= 0:
        raise ShapeError(f"the radius {r}", where="radius", remedy="it must be positive")
    return ellipse(centre, (r, 0), (0, r))


def ellipse(centre: Iterable[Number], u: Iterable[Number], v: Iterable[Number]) -> Nurbs:
    """The full ellipse ``centre + cos t u + sin t v`` in the plane or in space.

    >>> ellipse((0, 0, 1), (2, 0, 0), (0, 1, 1))(1)
    (mpq(0,1), mpq(1,1), mpq(2,1))
    """
    return _curve(full_ellipse(Affine(list(zip(_point(u), _point(v), _point(centre), strict=True)))), "ellipse")


def arc(centre: Iterable[Number], start: Iterable[Number], end: Iterable[Number]) -> Nurbs:
    """The circular arc in the plane, counter-clockwise from `start` to `end` (the full circle when they coincide).

    >>> quarter = arc((0, 0), (3, 4), (-4, 3))
    >>> quarter.degree, quarter.weights
    (2, (mpq(2,1), mpq(1,1), mpq(1,1)))

    Raises `ShapeError` if their distances from the centre are not exactly equal.
    """
    x, y = _point(centre)
    u, v = ((p[0] - x, p[1] - y) for p in (_point(start), _point(end)))
    return _curve(mapped(arc_around_origin(u, v), Affine([[1, 0, x], [0, 1, y]])), "arc")


def conic(form: Sequence[Number], start: Iterable[Number], end: Iterable[Number]) -> Nurbs:
    """The arc of the conic A x² + B x y + C y² + D x + E y + F = 0, given by its six coefficients: counter-clockwise on
    an ellipse; on a parabola or a hyperbola along the branch that contains both ends.

    >>> conic([0, 1, 0, 0, 0, -1], (1, 1), (4, "1/4"))("1/2")
    (mpq(28,13), mpq(13,28))

    Raises `ShapeError` if an end is not exactly on the conic, or if there is no such arc.
    """
    if len(form) != 6:
        raise ShapeError(counted(len(form), "coefficient"), where="form", remedy="give A, B, C, D, E, F")
    return _curve(conic_arc([rational(c) for c in form], _point(start), _point(end)), "conic")


def _point(values: Iterable[Number]) -> tuple[mpq, ...]:
    return tuple(rational(value) for value in values)


def _curve(segments: Sequence[Segment], name: str) -> Nurbs:
    return Nurbs.from_homogeneous(*joined_segments(segments), name=name)
