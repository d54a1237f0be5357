"""Linear systems in formulas: Cramer's rule, and planes as rows of a system."""

from __future__ import annotations

from typing import Any

from exactspline.language.operand import OwnVectors
from exactspline.language.rational import Rational
from exactspline.language.vector import cross, perp


def cramer(*rows: tuple[Any, Any]) -> Any:
    """The numerators of Cramer's rule, eq. (23), as one vector: over the determinant of the normals they are the point
    with ``normal · B = height``.

    Each row is a normal with its height: three planes in space, or two lines in the plane.

    >>> from exactspline import Vector
    >>> cramer((Vector(1, 0, 0), 5), (Vector(0, 2, 0), 6), (Vector(0, 0, 1), 7))
    Vector(10, 6, 14)
    """
    if len(rows) == 2:
        (a, h), (b, k) = rows
        return perp(a) * k - perp(b) * h
    (a, h), (b, k), (c, m) = rows
    return cross(b, c) * h + cross(c, a) * k + cross(a, b) * m


def level(normal: Any, height: Any) -> tuple[Any, Any]:
    """A row of a linear system brought to one denominator: the step that §6 takes before it applies Cramer's rule.

    Only quotients have one; anything else stays as it is.
    """
    if isinstance(normal, (Rational, OwnVectors)):
        return normal.levelled(height)
    if isinstance(height, Rational):
        second, first = height.levelled(normal)
        return first, second
    return normal, height
