"""Single pairs of parameters on a patch: pairs where the curves meet or touch, or where the three planes of the system
share a line.
"""

from __future__ import annotations

from collections.abc import Sequence

from flint import fmpz_mpoly

from exactspline.bivariate.common_zeros import common_zeros
from exactspline.errors import ReachError
from exactspline.geometry.bisectors.components import Cause, SinglePair, Solutions, SpecialPairs
from exactspline.geometry.bisectors.system import System, vanish_together
from exactspline.numbers.exact import scalar
from exactspline.numbers.intervals import Box
from exactspline.one_line import short_text
from exactspline.polynomials.factors import greatest_common_divisor
from exactspline.roots.of_polynomials import Parameter, Place
from exactspline.roots.root import Root

#: Combinations of the components of a vector, tried one after the other.
COMBINATIONS = ((3, 5, -7), (11, -2, 1), (1, 13, 4), (-5, 1, 17))

Found = tuple[list[Place], tuple[str, ...]]


def zeros_of_vector(f: fmpz_mpoly | None, components: list[fmpz_mpoly], sides: Box) -> Found:
    """The pairs at which all components (and f) vanish; and the undecided cases."""
    given = [p for p in ([f] if f is not None else []) + components if p]
    if greatest_common_divisor(given).total_degree() > 0:
        return [], (f"pairs on {sides.shortly}: the conditions have a common factor",)
    return _decided(given, sides)


def _decided(conditions: list[fmpz_mpoly], sides: Box, also: Sequence[fmpz_mpoly] = ()) -> Found:
    """The common zeros of polynomials without a common factor, except those at which one of the polynomials `also` is
    certainly not zero; and the undecided cases.
    """
    try:
        return [zero.place for zero in common_zeros(conditions, sides, also=also)], ()
    except ReachError as error:
        return [], (f"single pairs on {sides.shortly}: {error.problem}",)


def brief(place: Sequence[Parameter]) -> str:
    """Parameters as text."""
    return "(" + ", ".join(x.shortly() if isinstance(x, Root) else short_text(x) for x in place) + ")"


def crossings(system: System) -> Found:
    """The isolated pairs at which the curves meet, without the curves of pairs along which they overlap; and the
    undecided cases.
    """
    shared = greatest_common_divisor(system.chord)
    return zeros_of_vector(None, [f / shared for f in system.chord], system.sides) if shared else ([], ())


def touching(system: System, meetings: list[Place]) -> SpecialPairs:
    """The common points with a common tangent, except those at cusps; their solutions are the normal plane."""
    pairs, undecided = [], []
    for place in meetings:
        if at_cusp(system, place):
            continue
        touches = _touches(system, place)
        if touches:
            pairs.append(SinglePair(*place, Solutions.PLANE, Cause.OVERLAP, system))
        elif touches is None:
            undecided.append(f"whether the curves touch at {brief(place)}")
    return SpecialPairs(pairs=tuple(pairs), undecided=tuple(undecided))


def _touches(system: System, place: Place) -> bool | None:
    """Whether the tangents at a pair are parallel; None where this is not decided."""
    return vanish_together([f for f in system.crosses()[1] if f], *place)


def singles(system: System, factors: list[fmpz_mpoly], meetings: list[Place]) -> SpecialPairs:
    """The single pairs of a patch except those at cusps; `factors` are the equations whose pairs have lines."""
    tangencies = touching(system, meetings)
    others, undecided = _dependent(system, [*factors, *system.cusps], meetings)
    lines = [(x, Cause.DEPENDENT) for x in others]
    # where the curves meet, all minors vanish, and their common factor vanishes, too, if it is one of them
    if not any(p and (p / system.factor).total_degree() == 0 for p in (system.determinant, *system.numerators)):
        lines += [(x, Cause.CROSSING) for x in meetings if _touches(system, x) is False]
    pairs = [
        SinglePair(*place, Solutions.LINE, cause, system)
        for place, cause in lines
        if not at_cusp(system, place) and not any(_lies_on(g, place) for g in factors)
    ]
    return tangencies + SpecialPairs(pairs=tuple(pairs), undecided=undecided)


def at_cusp(system: System, place: Place) -> bool:
    """Whether a curve has no tangent at a pair: its solutions then satisfy fewer conditions, and are listed with the
    cusps.
    """
    return any(_lies_on(q, place) for q in system.cusps)


def _lies_on(g: fmpz_mpoly, place: Place) -> bool:
    """Whether a pair lies on a curve of pairs, so that its line is listed already; an undecided pair is listed
    again.
    """
    return bool(vanish_together([g], *place))


def _dependent(system: System, factors: list[fmpz_mpoly], meetings: list[Place]) -> Found:
    """The pairs with a line of solutions at which the curves do not meet; and the undecided cases.

    Where the determinant vanishes, the normals of the three planes lie in a plane with a normal n, and the vector of
    the numerators is a multiple of n. So this vector is zero if its scalar product with a vector u is zero and u·n is
    not.
    """
    determinant, *numerators = (p / system.factor for p in (system.determinant, *system.numerators))
    conditions = [p for p in (determinant, *numerators) if p]
    if any(p.total_degree() == 0 for p in conditions):
        return [], ()
    combined = next((p for u in COMBINATIONS if _are_coprime(determinant, p := scalar(numerators, u))), None)
    pair = conditions if combined is None else [determinant, combined]
    singular, open_parts = _decided(pair, system.sides, conditions)
    places, undecided = [], list(open_parts)
    for place in singular:
        # a pair on an equation has its line already
        if place in meetings or any(_lies_on(g, place) for g in factors):
            continue
        rank = _has_rank_2(system, place)
        if rank:
            places.append(place)
        elif rank is None:
            undecided.append(f"the rank of the system at {brief(place)}")
    return places, tuple(undecided)


def _are_coprime(p: fmpz_mpoly, q: fmpz_mpoly) -> bool:
    return bool(p and q) and greatest_common_divisor([p, q]).total_degree() == 0


def _has_rank_2(system: System, place: Place) -> bool | None:
    """Whether the normals of the three planes are not all parallel; if they are, and the curves do not meet, the three
    planes are different.
    """
    parallel = vanish_together([f for v in system.crosses() for f in v if f], *place)
    return None if parallel is None else not parallel
