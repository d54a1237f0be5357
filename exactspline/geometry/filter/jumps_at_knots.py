"""What happens at the knots of a plane curve whose forms have certain signs on both sides: the rules, whoever computed
the signs. Corners and joints are decided in exact arithmetic, jumps of the curvature by certified doubles where these
suffice. On a closed curve the seam is a knot like any other.

Derivation: docs/certified-filter.md.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence, Set
from typing import NamedTuple

from flint import fmpz_poly

from exactspline.geometry.curves.facts import Facts
from exactspline.geometry.curves.kinds import Feature
from exactspline.geometry.curves.plane_features import critical_points, flat_points
from exactspline.geometry.filter.plane_programs import CRITICAL, CURVATURE, SPEED
from exactspline.numbers.sides import Side
from exactspline.polynomials.bernstein import raiser
from exactspline.splines.knots import mesh_of
from exactspline.splines.nurbs import Nurbs

#: Forms and weights below this are not used: products of their powers could underflow.
SMALL = 2**-60
#: The relative error of a product of a dozen factors, the weight functions among them, is below this.
CLOSE = 2**-44


class Jump(NamedTuple):
    """A change of sign at a knot without a zero: the output, the index of the breakpoint (0: the start of the domain or
    the seam), and the sign before it.
    """

    output: int
    knot: int
    before: int


def is_straight(operands: Sequence[fmpz_poly], degree: int) -> bool:
    """Whether a segment lies on a line, exactly: its two coordinates and its weight function are linearly dependent.

    >>> is_straight([fmpz_poly([0, 3, 6, 3]), fmpz_poly([1, 3, 3, 1])], 3)
    True
    >>> is_straight([fmpz_poly([0, 2, 2]), fmpz_poly([0, 2, 1])], 2)
    False
    """
    x, y = operands[:2]
    w = operands[2] if len(operands) > 2 else raiser(degree)
    first, second = x * w[0] - w * x[0], y * w[0] - w * y[0]
    k = next((k for k in range(degree + 1) if first[k] or second[k]), None)
    return k is None or first * second[k] == second * first[k]


def jumps(
    facts: Facts, ends: Sequence[Sequence[float]], weights: Sequence[Sequence[float]], others: Set[int]
) -> Iterator[Jump]:
    """The changes of sign of κ and κ′ by a jump at the knots of a plane curve, except at the ends of `others`: straight
    segments (a zero at an end of a straight piece belongs to the piece), and those that are decided exactly.

    `ends`: for every segment and output the ordinates at both ends, each followed by a bound of its error; these signs
    are certain, and γ′ ≠ 0. `weights`: the weight function at both ends.
    """
    continuity = mesh_of(facts.curve.knots, facts.curve.degree)[1]
    for i in range(0 if facts.closed else 1, len(ends)):
        if others and (i in others or (i - 1) % len(ends) in others):
            continue
        left, right = ends[i - 1], ends[i]
        bends, turns = ((left[4 * k + 2] > 0) != (right[4 * k] > 0) for k in (CURVATURE, CRITICAL))
        if not bends and not turns:
            continue
        smooth = continuity[i - 1] if i else 0
        if smooth < 1 and not facts.tangent_continuous(i):
            continue
        if bends:
            # κ jumps from one sign to the other, so that it has no extremum there
            yield Jump(CURVATURE, i, 1 if left[4 * CURVATURE + 2] > 0 else -1)
        elif smooth >= 2 or (not _differ(left, right, weights[i - 1][1], weights[i][0]) and facts.same_curvature(i)):
            yield Jump(CRITICAL, i, 1 if left[4 * CRITICAL + 2] > 0 else -1)


def on_runs(curve: Nurbs, left: Set[int]) -> tuple[list[Feature], list[Feature]] | None:
    """The zeros of κ and of κ′ on some segments of a curve and at their ends, by exact arithmetic on these segments
    and one more on both sides. None where the whole curve must be decided: at a seam, where γ′ or a form vanishes on a
    whole segment, and where there are many such segments.
    """
    count = curve.segments
    if 2 * len(left) > count or (curve.closed and not left.isdisjoint((0, count - 1))):
        return None
    found: tuple[list[Feature], list[Feature]] = ([], [])
    starts = [i for i in sorted(left) if i - 1 not in left]
    for start, end in zip(starts, [i for i in sorted(left) if i + 1 not in left], strict=True):
        first, last = max(start - 1, 0), min(end + 2, count)
        facts = Facts(curve.restrict(curve.breakpoints[first], curve.breakpoints[last]))
        own = slice(start - first, end + 1 - first)
        forms = facts.zero_form("zero_curvature"), facts.zero_form("critical_curvature")
        if facts.closed or any(facts.standing[own]) or any(None in form.zeros.isolations[own] for form in forms):
            return None
        low, high = curve.breakpoints[start], curve.breakpoints[end + 1]
        for features, exact in zip(found, (flat_points(facts), critical_points(facts)), strict=True):
            features += [feature for feature in exact if low <= feature.root <= high]
    return found


def _differ(left: Sequence[float], right: Sequence[float], v: float, w: float) -> bool:
    """Whether the curvatures of two sides, of one sign, certainly differ: κ² is ``K² w⁶ / S³`` for the forms K of κ and
    S of the speed, whatever the parameter, up to a factor that both sides share.
    """
    first, second = _squared(left, Side.LEFT, v), _squared(right, Side.RIGHT, w)
    return bool(first and second and (first[1] < second[0] or second[1] < first[0]))


def _squared(end: Sequence[float], side: Side, w: float) -> tuple[float, float] | None:
    """The squared curvature at an end of a segment between two numbers."""
    at = 2 if side is Side.LEFT else 0
    k, error = abs(end[4 * CURVATURE + at]), end[4 * CURVATURE + at + 1]
    s, off = end[4 * SPEED + at], end[4 * SPEED + at + 1]
    if min(k - error, s - off, w) < SMALL:
        return None
    w3 = w * w * w
    low, high = (k - error) * w3, (k + error) * w3
    slow, fast = s - off, s + off
    return low * low / (fast * fast * fast) * (1 - CLOSE), high * high / (slow * slow * slow) * (1 + CLOSE)
