"""How the pieces of a curve meet at a knot: limits of directions from both sides."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from gmpy2 import mpq

from exactspline.language.vector import Vector

#: What can happen at a knot, from bad to good; the turn of the osculating plane in space only.
GAP, CORNER, SINGULAR, TURN = "gap", "corner", "singular", "jump of the osculating plane"


CURVATURE_JUMP, CONTINUOUS = "jump of the curvature", "continuous curvature"


def sides(curve: Any, t: mpq) -> tuple[mpq, mpq]:
    """The parameters whose left and right limits meet at a knot: the same one, but for the seam of a closed curve."""
    a, b = curve.domain
    return (b, a) if curve.closed and t in (a, b) else (t, t)


def inside(curve: Any, t: mpq) -> bool:
    """Whether the curve goes on at both sides of a parameter."""
    return curve.closed or t not in curve.domain


def tangent_joint(curve: Any, d1: Vector, t: mpq) -> str:
    """What happens at a knot up to first order: a gap, a singular point, a corner, or nothing (then the text is empty);
    `d1` is D1 of the curve.
    """
    left, right = sides(curve, t)
    if curve(left, "left") != curve(right, "right"):
        return GAP
    a, b = tuple(c(left, "left") for c in d1), tuple(c(right, "right") for c in d1)
    if not any(a) or not any(b):
        return SINGULAR
    return "" if same_direction(a, b) else CORNER


def same_direction(a: Sequence[mpq], b: Sequence[mpq]) -> bool:
    """Whether two vectors that are not zero point the same way (exactly: a·b > 0 and (a·b)² = ‖a‖²‖b‖²).

    >>> same_direction((1, 2), (2, 4)), same_direction((1, 2), (-1, -2))
    (True, False)
    """
    product = sum(x * y for x, y in zip(a, b, strict=True))
    return bool(product > 0 and product**2 == sum(x * x for x in a) * sum(y * y for y in b))


def limit_direction(v: Vector, t: mpq, side: str) -> tuple[mpq, ...]:
    """The direction in which a vector points just beside a parameter; zeros where it vanishes all along that side.

    >>> from exactspline import BSpline
    >>> s = BSpline.identity(-1, 1)
    >>> limit_direction(Vector(s, s * s), mpq(0), "left")
    (mpq(-1,1), mpq(0,1))
    """
    for order in range(v.degree + 1):
        values = tuple(c.d(order)(t, side) for c in v)
        if any(values):
            return tuple(-x for x in values) if side == "left" and order % 2 else values
    return (mpq(0),) * len(v)
