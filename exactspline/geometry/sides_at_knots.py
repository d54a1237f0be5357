"""Whether two curves change sides at a common point at which one of them, or both, have a knot."""

from __future__ import annotations

from flint import fmpz

from exactspline.numbers.exact import mpq
from exactspline.polynomials.bezout import PlaneForms
from exactspline.polynomials.isolation import isolate
from exactspline.polynomials.plane_pairs import elimination
from exactspline.polynomials.zero_places import at

#: A direction by integers.
Ray = tuple[fmpz, fmpz]


def changes_side(through: PlaneForms, before: PlaneForms, behind: PlaneForms) -> bool | None:
    """Whether the segments before and behind a knot are on different sides of a segment that passes through the knot;
    None if one of them runs along it, or if it passes several times.
    """
    left, right = elimination(through, before), elimination(through, behind)
    if not left.determinant or not right.determinant or not right.is_simple(at(mpq(0), 0)):
        return None
    first = isolate(left.determinant, left.size * left.degree).signs[1]
    second = isolate(right.determinant, right.size * right.degree).signs[0]
    return first != second


def forward_ray(curve: PlaneForms) -> Ray:
    """The direction in which a segment leaves its start; zero if it is a single point."""
    x, y, w = curve.coefficient(0)
    for i in range(1, curve.degree + 1):
        a, b, c = curve.coefficient(i)
        if any(ray := (a * w - x * c, b * w - y * c)):
            return ray
    return fmpz(0), fmpz(0)


def backward_ray(curve: PlaneForms) -> Ray:
    """The direction from the end of a segment back along it."""
    n = curve.degree
    x, y, w = curve.coefficient(n)
    for i in range(n - 1, -1, -1):
        a, b, c = curve.coefficient(i)
        if any(ray := (a * w - x * c, b * w - y * c)):
            return ray
    return fmpz(0), fmpz(0)


def rays_interlace(one: tuple[Ray, Ray], other: tuple[Ray, Ray]) -> bool | None:
    """Whether the rays of two pairs alternate around their common start; None if a ray of one pair is one of the other,
    or no ray.

    >>> east, north, west, south = [(fmpz(x), fmpz(y)) for x, y in ((1, 0), (0, 1), (-1, 0), (0, -1))]
    >>> rays_interlace((east, west), (north, south)), rays_interlace((east, north), (west, south))
    (True, False)
    """
    if not all(any(ray) for ray in (*one, *other)) or any(_same(a, b) for a in one for b in other):
        return None
    return _is_between(one, other[0]) != _is_between(one, other[1])


def _cross(a: Ray, b: Ray) -> fmpz:
    return a[0] * b[1] - a[1] * b[0]


def _same(a: Ray, b: Ray) -> bool:
    return _cross(a, b) == 0 and a[0] * b[0] + a[1] * b[1] > 0


def _is_between(pair: tuple[Ray, Ray], ray: Ray) -> bool:
    """Whether a ray is inside the angle from the first counterclockwise to the second."""
    first, second = pair
    turn = _cross(first, second)
    if turn > 0:
        return _cross(first, ray) > 0 and _cross(ray, second) > 0
    if turn < 0 or not _same(first, second):
        # more than half a turn, or exactly one half
        return _cross(first, ray) > 0 if turn == 0 else not (_cross(second, ray) > 0 and _cross(ray, first) > 0)
    return False
