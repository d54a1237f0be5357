"""How far the curvature of a curve must be changed, as a function, until an extremum vanishes."""

from __future__ import annotations

from contextlib import suppress

from exactspline.errors import DomainError, ShapeError
from exactspline.geometry.analysis.curves import analyse
from exactspline.geometry.curves.kinds import Feature, JointKind
from exactspline.geometry.curves.values import curvature
from exactspline.numbers.sides import Side
from exactspline.reals.real import Real, real
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of


def prominences(curve: Nurbs) -> tuple[tuple[Feature, Real | None], ...]:
    """The extrema of the curvature of a curve, each with half of the smaller difference between κ there and at its
    neighbours: the extrema on both sides (in space also points with κ = 0), knots at which the tangent or κ jumps, the
    ends of the domain.

    Every continuous function that differs from κ by less has such an extremum between the neighbours; one that differs
    by as much has none. None where κ has a pole at both neighbours.

    >>> from exactspline import example
    >>> [(found.kind.value, str(least)) for found, least in prominences(example("ellipse"))][:2]
    [('maximum', '7/8'), ('minimum', '7/8')]

    Raises `ShapeError` for a curve that is neither in the plane nor in space.
    """
    given = curve_of(curve)
    if given.dimension not in (2, 3):
        raise ShapeError(
            f"prominences of a curve in R{given.dimension}", remedy="this needs a curve in the plane or in space"
        )
    facts = analyse(given)
    ends = [*map(real, given.domain), *[real(x.parameter) for x in facts.joints if x.kind is not JointKind.CONTINUOUS]]
    extrema = facts.curvature_extrema
    flat = facts.inflections if facts.in_space else ()
    places = sorted([*ends, *[found.root for found in (*extrema, *flat)]])
    return tuple((found, _half_of_the_step(given, found.root, places)) for found in extrema)


def _half_of_the_step(curve: Nurbs, place: Real, places: list[Real]) -> Real | None:
    before, behind = [t for t in places if t < place], [t for t in places if t > place]
    own, steps = curvature(curve, place), list[Real]()
    for end, side in ((before[-1:], Side.RIGHT), (behind[:1], Side.LEFT)):
        with suppress(DomainError):
            steps += [abs(own - curvature(curve, t, side)) for t in end]
    return min(steps) / 2 if steps else None
