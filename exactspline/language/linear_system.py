"""Linear systems in formulas: Cramer's rule, and planes as equations of a system."""

from __future__ import annotations

from typing import cast

from exactspline.language.operand import OwnVectors
from exactspline.language.rational import Rational
from exactspline.language.vector import S, Vector, cross, perp


def cramer(*rows: tuple[Vector[S], S]) -> Vector[S]:
    """The numerators of Cramer's rule, eq. (23), as one vector: divided by the determinant of the normals, they are the
    point B with ``normal · B = height`` for each row.

    Each row is a pair of a normal and a height: three planes in space, or two lines in the plane.

    >>> from exactspline.language import Vector
    >>> cramer((Vector(1, 0, 0), 5), (Vector(0, 2, 0), 6), (Vector(0, 0, 1), 7))
    Vector(10, 6, 14)
    """
    if len(rows) == 2:
        (a, h), (b, k) = rows
        line: Vector[S] = perp(a) * k - perp(b) * h
        return line
    (a, h), (b, k), (c, m) = rows
    point: Vector[S] = cross(b, c) * h + cross(c, a) * k + cross(a, b) * m
    return point


def level(normal: Vector[S], height: S) -> tuple[Vector[S], S]:
    """A row of a linear system brought to a common denominator: the step that §6 takes before it applies Cramer's rule.

    Values that are not quotients are returned unchanged.
    """
    given: tuple[object, object] = (normal, height)
    if isinstance(given[0], (Rational, OwnVectors)):
        given = given[0].levelled(height)
    elif isinstance(given[1], Rational):
        second, first = given[1].levelled(normal)
        given = first, second
    return cast("tuple[Vector[S], S]", given)
