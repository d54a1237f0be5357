"""The least distance from a shape that is proved of a curve or a surface: by functions that are nowhere negative."""

from __future__ import annotations

from collections.abc import Callable
from itertools import chain, count, pairwise

from exactspline.geometry.recognition.shapes import Homogeneous, Shape
from exactspline.numbers.exact import decimal_unit, mpq, sign
from exactspline.numbers.intervals import Interval
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline

#: Factors, at first, by which the bound that is proved may exceed the distance found at points.
FACTORS = tuple(mpq(n, 16) for n in (17, 20, 24, 32))


def proved_distance(
    shape: Shape, of: Homogeneous, found: mpq, limit: mpq, never_negative: Callable[..., bool]
) -> mpq | None:
    """A distance from a shape that is proved, up to a limit: 0 where all points are on it, otherwise the least of a few
    that are above one that was found; then of larger ones, as it may be farther away elsewhere. None where none was
    proved. `never_negative` decides it of a function on the curve or the surface.
    """
    if shape.holds(of):
        return mpq(0)
    for within in (rounded_up(found * factor) for factor in chain(FACTORS, (mpq(2) ** k for k in count(2)))):
        if not within or within > limit or (shape.most is not None and within > shape.most):
            return None
        if all(never_negative(f) for f in shape.margins(of, within)):
            return within
    return None


def never_negative(f: BSpline) -> bool:
    """Whether a function of one parameter is nowhere negative.

    >>> t = BSpline.identity(-1, 1)
    >>> never_negative(t * t), never_negative(t)
    (True, False)
    """
    return signs(f) <= {0, 1}


def signs(f: BSpline) -> set[int]:
    """The signs that a function has on whole intervals: 0 where it vanishes on a segment.

    >>> t = BSpline.identity(-1, 1)
    >>> signs(t * t + 1), signs(t * t), signs(-t * t), sorted(signs(t)), signs(t - t)
    ({1}, {1}, {-1}, [-1, 1], {0})
    """
    found, hard = set[int](), set[Interval]()
    for ends, points in zip(pairwise(f.breakpoints), f.bezier_points, strict=True):
        of_points = {sign(x) for x in points}
        if len(of_points) > 1:
            of_points -= {0}
        if len(of_points) == 1 or len({sign(points[0]), sign(points[-1])} - {0}) == 2:
            found |= of_points
        else:
            hard.add(Interval(*ends))
    if hard:
        roots = [root for root in zeros(f) if root.segment in hard]
        found |= {side for root in roots for side in root.signs if side}
        found |= {sign(f(segment.middle)) for segment in hard - {root.segment for root in roots}}
    return found


def rounded_up(x: mpq) -> mpq:
    """The least decimal with four digits that is not below a positive number.

    >>> rounded_up(mpq(1, 3)), rounded_up(mpq(0))
    (mpq(1667,5000), mpq(0,1))
    """
    if not x:
        return x
    unit = decimal_unit(x) / 1000
    return -(-x // unit) * unit
