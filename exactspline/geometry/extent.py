"""The extent of a curve: the extrema of its coordinates, and its bounding box."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

from exactspline.exact import mpq
from exactspline.geometry.facts import located
from exactspline.geometry.kinds import Feature, FeatureKind
from exactspline.roots.enclosure import exact_place
from exactspline.roots.real import Real
from exactspline.roots.root import Root
from exactspline.roots.zero_set import ZeroSet, zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs


def slope(curve: Nurbs, axis: int) -> BSpline:
    """A spline with the sign of the derivative of a coordinate."""
    p, w = curve.p[axis], curve.w
    return p.d() if curve.polynomial else p.d() * w - p * w.d()


def slope_zeros(curve: Nurbs, axis: int) -> ZeroSet:
    """The zeros of that spline."""
    return zeros(slope(curve, axis), periodic=curve.closed)


def turning_points(curve: Nurbs, axis: int) -> list[Feature]:
    """Where a coordinate changes from increasing to decreasing (``maximum``) or back (``minimum``), at a single
    parameter: where type designers place points. Intervals on which it is constant are not included.

    >>> from exactspline import example
    >>> [(f.kind.value, f.root.exact) for f in turning_points(example("circle"), 1)]
    [('maximum', mpq(1,1)), ('minimum', mpq(3,1))]
    """
    found = []
    for root, by_jump in located(slope_zeros(curve, axis)):
        left, right = root.signs
        if left and right and left != right:
            kind = FeatureKind.MAXIMUM if left > 0 else FeatureKind.MINIMUM
            found.append(Feature(kind, root, f"coordinate {axis}", by_jump))
    return found


def coordinate_extrema(curve: Nurbs) -> list[Feature]:
    """The extrema of all coordinates, in the order of the parameter.

    >>> from exactspline import example
    >>> len(coordinate_extrema(example("circle")))
    4
    """
    found = [f for axis in range(curve.dimension) for f in turning_points(curve, axis)]
    return sorted(found, key=lambda f: f.root)


def coordinate_range(curve: Nurbs, axis: int) -> tuple[Real, Real]:
    """The smallest and the largest value of a coordinate, known exactly.

    >>> from exactspline import example
    >>> [x.exact for x in coordinate_range(example("circle"), 0)]
    [mpq(-1,1), mpq(1,1)]
    """
    values = [Real.of(curve(t, side)[axis]) for t in curve.breakpoints for side in ("left", "right")]
    values += [_value(curve, axis, exact_place(root)) for root in slope_zeros(curve, axis) if not root.at_knot]
    return _extreme(values, -1), _extreme(values, 1)


def _value(curve: Nurbs, axis: int, place: mpq | Root) -> Real:
    if isinstance(place, Root):
        return Real.quotient_at(curve.p[axis], curve.w, place)
    return Real.of(curve(place)[axis])


def _extreme(values: Sequence[Real], side: int) -> Real:
    """The largest (side 1) or smallest (−1) of several numbers, without deciding which of them it is."""
    choose = max if side > 0 else min
    best = choose(v.exact for v in values if isinstance(v.exact, type(mpq())))
    rest = [v for v in values if v.exact is None and v.sign_above(best) == side]
    if not rest:
        return Real.of(best)

    given = (tuple(rest), choose)
    return Real(None, partial(_extreme_enclosed, *given), partial(_extreme_compared, *given))


def _extreme_enclosed(values: Sequence[Real], choose: Callable[..., mpq], digits: int) -> tuple[mpq, mpq]:
    ends = [v.enclosed(digits) for v in values]
    return choose(low for low, _ in ends), choose(high for _, high in ends)


def _extreme_compared(values: Sequence[Real], choose: Callable[..., int], t: mpq) -> int:
    return choose(v.sign_above(t) for v in values)
