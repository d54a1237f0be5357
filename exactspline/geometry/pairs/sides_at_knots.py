"""Whether two curves change sides at a common point that is a knot of one or both curves."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import NamedTuple

from flint import ctx, fmpq, fmpq_series, fmpz

from exactspline.numbers.exact import mpq
from exactspline.polynomials.bernstein import backwards
from exactspline.polynomials.bezout import PlaneForms
from exactspline.polynomials.isolation import isolate
from exactspline.polynomials.plane_pairs import elimination, without_common_factor
from exactspline.polynomials.zero_places import at

#: A direction by integers.
Ray = tuple[fmpz, fmpz]


def changes_side(through: PlaneForms, before: PlaneForms, behind: PlaneForms) -> bool | None:
    """Whether the segments before and behind a knot are on different sides of a segment that passes through the knot;
    None if one of them coincides with it along an arc, or if it passes several times.
    """
    passing = without_common_factor(through)
    left, right = elimination(passing, before), elimination(passing, behind)
    if not left.determinant or not right.determinant or not right.is_simple(at(mpq(0))):
        return None
    first = isolate(left.determinant, left.size * left.degree).signs[1]
    second = isolate(right.determinant, right.size * right.degree).signs[0]
    return first != second


def _forward_ray(curve: PlaneForms) -> Ray:
    """The direction in which a segment leaves its start; zero if it is a single point."""
    x, y, w = curve.coefficient(0)
    for i in range(1, curve.degree + 1):
        a, b, c = curve.coefficient(i)
        if any(ray := (a * w - x * c, b * w - y * c)):
            return ray
    return fmpz(0), fmpz(0)


class _HalfBranch(NamedTuple):
    """A half branch of a curve at a point: the direction in which it leaves the point, and its segment, which begins at
    the point.
    """

    ray: Ray
    curve: PlaneForms


def half_branches(before: PlaneForms, behind: PlaneForms) -> tuple[_HalfBranch, _HalfBranch]:
    """The two half branches of a curve at a knot, from the segments before and behind the knot."""
    back = PlaneForms(before.degree, *[backwards(form, before.degree) for form in before.forms])
    return _HalfBranch(_forward_ray(back), back), _HalfBranch(_forward_ray(behind), behind)


def interlace(one: tuple[_HalfBranch, _HalfBranch], other: tuple[_HalfBranch, _HalfBranch]) -> bool | None:
    """Whether the half branches of two curves alternate around their common point. None if this is not decided: a half
    branch is a single point, or has a cusp there and the tangent of another one, or coincides with another one along an
    arc.

    >>> from flint import fmpz_poly
    >>> def branch(x, y, bend=0):
    ...     ray = fmpz(x), fmpz(y)
    ...     forms = fmpz_poly([0, x, x]), fmpz_poly([0, y, y + bend]), fmpz_poly([1, 2, 1])
    ...     return _HalfBranch(ray, PlaneForms(2, *forms))
    >>> east, north, west, south = branch(1, 0), branch(0, 1), branch(-1, 0), branch(0, -1)
    >>> interlace((east, west), (north, south)), interlace((east, north), (west, south))
    (True, False)
    >>> above, higher = branch(1, 0, 1), branch(1, 0, 2)
    >>> interlace((above, west), (higher, south)), interlace((above, west), (higher, north))
    (True, False)
    """
    branches = [*one, *other]
    if not all(any(branch.ray) for branch in branches):
        return None
    order: list[int] = []
    for i, branch in enumerate(branches):
        place = 0
        for j in order:
            turn = _turn(branches[j], branch)
            if turn is None:
                return None
            place += turn > 0
        order.insert(place, i)
    owners = [i < 2 for i in order]
    return owners[0] != owners[1] and owners[1] != owners[2]


def _turn(one: _HalfBranch, other: _HalfBranch) -> int | None:
    """1 if the second comes after the first, counterclockwise from the direction of x; −1 if before."""
    first, second = _half_plane(one.ray), _half_plane(other.ray)
    if first != second:
        return 1 if first < second else -1
    cross = one.ray[0] * other.ray[1] - one.ray[1] * other.ray[0]
    if cross:
        return 1 if cross > 0 else -1
    terms = one.curve.degree * other.curve.degree + 2
    heights = [_height(branch.curve, one.ray, terms) for branch in (one, other)]
    if heights[0] is None or heights[1] is None:
        return None
    difference = next((b - a for a, b in zip(*heights, strict=True) if a != b), None)
    return None if difference is None else 1 if difference > 0 else -1


def _half_plane(ray: Ray) -> int:
    """0 for directions from that of x up to the opposite one, 1 for the rest."""
    return 0 if ray[1] > 0 or (ray[1] == 0 and ray[0] > 0) else 1


def _height(curve: PlaneForms, ray: Ray, terms: int) -> list[fmpq] | None:
    """The distance to the left of a ray as a power series in the distance along the ray, at the start of a segment;
    None at a cusp.

    Two segments of degrees m and n that agree in more than mn terms are arcs of the same curve, by Bézout's theorem.
    """
    x, y, w = curve.coefficient(0)
    across, up = curve.x * w - curve.w * x, curve.y * w - curve.w * y
    along, left = across * ray[0] + up * ray[1], up * ray[0] - across * ray[1]
    if along[1] == 0:
        return None
    with _series_length(terms):
        weight = fmpq_series(curve.w.coeffs())
        u, v = (fmpq_series(form.coeffs()) / (weight * fmpq_series([w])) for form in (along, left))
        height = v(u.reversion())
        return [height[k] for k in range(terms)]


@contextmanager
def _series_length(terms: int) -> Iterator[None]:
    """A context in which FLINT's power series have this many terms."""
    before, ctx.cap = ctx.cap, terms
    try:
        yield
    finally:
        ctx.cap = before
