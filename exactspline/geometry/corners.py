"""Where a curve has corners, and nothing else about its joints: from the integers of its forms, without derivatives and
angles.
"""

from __future__ import annotations

from typing import NamedTuple

from flint import fmpz

from exactspline.exact import mpq
from exactspline.geometry.analysis import analyse
from exactspline.geometry.kinds import JointKind
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs


class Corner(NamedTuple):
    """A joint at which the direction of the tangent jumps."""

    parameter: mpq
    kind: JointKind


def corner_places(curve: Nurbs) -> list[Corner]:
    """The corners of a curve in the plane or in space, without their angles (see `exactspline.corners`).

    >>> square = Nurbs(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)])
    >>> [int(corner.parameter) for corner in corner_places(square)]
    [0, 1, 2, 3]

    Raises `ShapeError` for a curve that is neither in the plane nor in space.
    """
    facts = analyse(curve)
    facts.check_dimension()
    continuity = curve.p[0].continuity
    smooth = [curve.closed - 1, *continuity]
    found = []
    for i in range(0 if curve.closed else 1, curve.segments):
        left, right = _direction(curve, i - 1, at_end=True), _direction(curve, i, at_end=False)
        if smooth[i] >= 0 and any(left) and any(right):
            if smooth[i] == 0 and not _same(left, right):
                found.append(Corner(curve.breakpoints[i], JointKind.CORNER))
        elif (joint := facts.joint(curve.breakpoints[i])) is not None and joint.angle is not None:
            found.append(Corner(joint.parameter, joint.kind))
    return found


def _direction(curve: Nurbs, segment: int, *, at_end: bool) -> list[fmpz]:
    """A positive multiple of γ′ at the right or the left end of a segment: by its last (or first) two Bézier points
    P, Q with weights, ``w_P (w_Q Q) − w_Q (w_P P)``.
    """
    n = fmpz(curve.degree)
    if curve.polynomial:
        return [q - p for p, q in (_last_two(x, segment, n, at_end) for x in curve.p)]
    v, w = _last_two(curve.w, segment, n, at_end)
    return [v * q - w * p for p, q in (_last_two(x, segment, n, at_end) for x in curve.p)]


def _last_two(x: BSpline, segment: int, n: fmpz, at_end: bool) -> tuple[fmpz, fmpz]:
    """The last (or first) two Bézier ordinates of a form, n times over its denominator."""
    c, degree = x._polynomials[segment], x.degree
    return (c[degree - 1], n * c[degree]) if at_end else (n * c[0], c[1])


def _same(a: list[fmpz], b: list[fmpz]) -> bool:
    """Whether two vectors that are not zero have one direction."""
    product = sum((x * y for x, y in zip(a, b, strict=True)), fmpz(0))
    if product <= 0:
        return False
    squares = [sum((x * x for x in v), fmpz(0)) for v in (a, b)]
    return bool(product * product == squares[0] * squares[1])
