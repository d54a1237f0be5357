"""Where a curve has no tangent (a cusp, or a segment that is one point) its normal plane imposes no condition.

Over the other curve there are lines, and planes where it passes through the point or has no tangent either.
"""

from __future__ import annotations

from itertools import product

from flint import fmpz_mpoly, fmpz_poly

from exactspline.geometry.bisectors.components import (
    Cause,
    Correspondence,
    LineComponent,
    LinePiece,
    PairEquation,
    PlaneComponent,
    SinglePair,
    Solutions,
    SpecialPairs,
)
from exactspline.geometry.bisectors.flats import Conditions
from exactspline.geometry.bisectors.lines import ONE, PARAMETER, Path, constant, lines_along, lines_over_root
from exactspline.geometry.bisectors.polynomials import common_divisor_along, vanish_together
from exactspline.geometry.bisectors.single_pairs import brief, zeros_of_vector
from exactspline.geometry.bisectors.system import SegmentOfCurve, System
from exactspline.polynomials.factors import greatest_common_divisor
from exactspline.polynomials.two_parameters import at, in_one, lifted
from exactspline.roots.of_polynomials import Parameter, Place, exactly, roots_in
from exactspline.roots.root import Root

#: The remaining conditions where the first curve has no tangent.
WITHOUT_FIRST = Conditions.SECOND | Conditions.MIDDLE


def standing(system: System) -> SpecialPairs:
    """The exceptional pairs of two segments of which at least one is a point."""
    first, second = system.first, system.second
    if not first.stands_still:
        return standing(system.transposed()).transposed()
    if second.stands_still:
        solutions = Solutions.PLANE if any(system.chord) else Solutions.SPACE
        return SpecialPairs(planes=(PlaneComponent(solutions, Cause.BOTH_STILL, system.sides, None),))
    surface = lines_along(system, Path(constant(first.interval[0]), (PARAMETER, ONE)), second.interval, WITHOUT_FIRST)
    lines: tuple[LineComponent, ...] = ()
    if surface is not None:
        own = LinePiece(1, *second.interval, None, surface)
        lines = (LineComponent(Correspondence.ALL, Cause.FIRST_STILL, system, None, (own,)),)
    return SpecialPairs(lines, _planes_over_a_point(system))


def _planes_over_a_point(system: System) -> tuple[PlaneComponent, ...]:
    """Where the second curve passes through the single point of the first, and at its cusps."""
    side = system.second.interval
    meetings, cusps = roots_in(in_one(greatest_common_divisor(system.chord), 1), *side), cusps_of(system.second)
    planes = [
        _plane_at(Solutions.SPACE if t in cusps else Solutions.PLANE, Cause.FIRST_STILL, system, t) for t in meetings
    ]
    planes += [_plane_at(Solutions.PLANE, Cause.BOTH_STILL, system, t) for t in cusps if t not in meetings]
    return tuple(planes)


def cusps_of(own: SegmentOfCurve) -> list[Root]:
    """The parameters of a segment at which γ′ = 0."""
    return [root for q in own.cusps for root in roots_in(q, *own.interval)]


def _plane_at(solutions: Solutions, cause: Cause, system: System, t: Root) -> PlaneComponent:
    equation = PairEquation.of(lifted(fmpz_poly(t.minimal_polynomial()), 1))
    return PlaneComponent(solutions, cause, system.sides, equation, of=1, fixed=exactly(t))


def over_cusps(system: System) -> SpecialPairs:
    """Lines over the second curve at the cusps of the first, and the pairs at which it passes through one."""
    pairs = SpecialPairs()
    for q in system.first.cusps:
        for s in roots_in(q, *system.first.interval):
            pairs += _over_cusp(system, lifted(q, 0), exactly(s))
    return pairs


def _over_cusp(system: System, equation: fmpz_mpoly, s: Parameter) -> SpecialPairs:
    second = system.second
    found = lines_at(system, s, Cause.FIRST_CUSP, PairEquation.of(equation), WITHOUT_FIRST)
    meetings, undecided = _meetings(system, equation, s)
    cusps = cusps_of(second)
    pairs = [SinglePair(*x, Solutions.PLANE, Cause.FIRST_CUSP, system) for x in meetings if x[1] not in cusps]
    return found + SpecialPairs(pairs=tuple(pairs), undecided=undecided)


def lines_at(
    system: System, s: Parameter, cause: Cause, equation: PairEquation, conditions: Conditions
) -> SpecialPairs:
    """The lines over all of the second curve at one parameter of the first; none where the planes are parallel."""
    second, fixed = system.second, Correspondence.FIRST_FIXED
    if isinstance(s, Root):
        over_root = lines_over_root(system, s, conditions)
        if over_root is None:
            return SpecialPairs()
        undecided = () if over_root.poles is not None else (f"the poles of the lines over {brief((s,))} of one curve",)
        return SpecialPairs((LineComponent(fixed, cause, system, equation, over_root=over_root),), undecided=undecided)
    surface = lines_along(system, Path(constant(s), (PARAMETER, ONE)), second.interval, conditions)
    if surface is None:
        return SpecialPairs()
    pieces = (LinePiece(1, *second.interval, s, surface),)
    return SpecialPairs((LineComponent(fixed, cause, system, equation, pieces),))


def _meetings(system: System, equation: fmpz_mpoly, s: Parameter) -> tuple[list[Place], tuple[str, ...]]:
    """The pairs with this s at which the curves meet."""
    if not isinstance(s, Root):
        shared = common_divisor_along(at(f, 0, s) for f in system.chord)
        return [(s, exactly(t)) for t in roots_in(shared, *system.second.interval)], ()
    places, undecided = zeros_of_vector(equation, list(system.chord), system.sides)
    return [place for place in places if place[0] == s], undecided


def over_both_cusps(system: System) -> SpecialPairs:
    """The pairs at which neither curve has a tangent: the plane between the points, or all of space."""
    pairs: list[SinglePair] = []
    undecided: list[str] = []
    for s, t in product(*[map(exactly, cusps_of(own)) for own in (system.first, system.second)]):
        meet = vanish_together(list(system.chord), s, t)
        if meet is None:
            undecided.append(f"whether the cusps at {brief((s, t))} coincide")
            continue
        pairs.append(SinglePair(s, t, Solutions.SPACE if meet else Solutions.PLANE, Cause.BOTH_CUSPS, system))
    return SpecialPairs(pairs=tuple(pairs), undecided=tuple(undecided))
