"""How often closed plane curves wind around a point, and whether the point is inside, decided exactly; a point on a
curve is reported as such.

The crossings of the curves with the ray from the point in the direction of x are counted with their signs: zeros of y −
b at which its sign changes and x > a, for the point (a, b). A ray that passes through a vertex, or along a segment, is
treated as if it were moved down by an infinitesimal amount.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from itertools import pairwise
from math import ceil, floor, inf
from typing import cast

from flint import fmpz, fmpz_poly

from exactspline.errors import DomainError, ShapeError, as_items
from exactspline.geometry.curves.facts import kept_by
from exactspline.geometry.curves.planarity import in_common_plane, in_the_plane
from exactspline.geometry.pairs.box_tree import BoxTree, pairs_that_may_meet, segments_of, shift_for
from exactspline.geometry.pairs.nearest import exact_point
from exactspline.numbers.exact import Number, mpq
from exactspline.numbers.intervals import Interval
from exactspline.polynomials.bernstein import variations
from exactspline.polynomials.isolation import isolate
from exactspline.polynomials.zero_places import Place, at, places
from exactspline.reals.real import Real
from exactspline.roots.segment_forms import SegmentForms, root_at
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of, of_dimension
from exactspline.words import Word, choice


class FillRule(Word):
    """The rule for which winding numbers are inside."""

    #: All winding numbers except 0.
    NONZERO = "nonzero"
    #: The odd winding numbers.
    EVEN_ODD = "even-odd"


class Position(Word):
    """The position of a point."""

    INSIDE = "inside"
    OUTSIDE = "outside"
    ON_CURVE = "on a curve"


def winding_number(curves: Nurbs | Iterable[Nurbs], point: Iterable[Number]) -> int:
    """Return how often one or several closed plane curves wind around a point, counterclockwise.

    >>> from exactspline import example
    >>> circle = example("circle")
    >>> winding_number(circle, (0, 0)), winding_number(circle.reverse(), ("1/2", 0)), winding_number(circle, (1, 1))
    (1, -1, 0)
    >>> winding_number([circle, circle], (0, "1/3"))
    2

    In a plane of space other than z = 0, counterclockwise means as seen from the tip of the normal whose first nonzero
    coordinate is positive. Raises `DomainError`, with the parameter, for a point on a curve, and `ShapeError` for
    curves that are not closed, not in one plane or not connected.

    Source: Hormann and Agathos, The point in polygon problem for arbitrary polygons, 2001 (for polygons).
    """
    found = _position(curves, point)
    if isinstance(found, int):
        return found
    curve, parameter = found
    raise DomainError(
        f"the point is on the curve{' ' + curve.name if curve.name else ''} at the parameter {parameter.shortly()}",
        remedy="the winding number is defined for the other points",
    )


def contains(
    curves: Nurbs | Iterable[Nurbs], point: Iterable[Number], rule: FillRule | str = FillRule.NONZERO
) -> Position:
    """Return whether a point is inside closed plane curves, by the rule ``nonzero`` or ``even-odd``, or on one of the
    curves.

    >>> from exactspline import example
    >>> [str(contains(example("circle"), point)) for point in ((0, 0), (1, 1), ("3/5", "4/5"))]
    ['inside', 'outside', 'on a curve']

    Raises `ShapeError` like `winding_number`.
    """
    chosen = choice(FillRule, rule, "fill rule")
    found = _position(curves, point)
    if not isinstance(found, int):
        return Position.ON_CURVE
    inside = found % 2 if chosen is FillRule.EVEN_ODD else found
    return Position.INSIDE if inside else Position.OUTSIDE


def _position(curves: Nurbs | Iterable[Nurbs], point: Iterable[Number]) -> int | tuple[Nurbs, Real]:
    """The winding number, or the curve that the point is on, and the parameter."""
    point, total = tuple(as_items(point, "a point")), 0
    given = [in_the_plane(curve_of(x)) for x in ([curves] if isinstance(curves, Nurbs) else as_items(curves, "curves"))]
    if given and all(curve.dimension == 3 for curve in given):
        place = Nurbs(0, [0, 1], [exact_point(given[0], point)])
        if flat := in_common_plane(*given, place):
            *given, place = flat[1]
            (point,) = place.control_points
    for curve in given:
        _check_closed_in_the_plane(curve)
        delta = exact_point(curve, point)
        own = segments_of(curve)
        kept_by(curve).once("connected", partial(_check_connected, own.forms))
        shift = shift_for(own)
        x, y = (coordinate * (1 << shift) for coordinate in delta)
        ray = BoxTree([((floor(x), cast(int, inf)), (floor(y), ceil(y)))])
        for i, _ in pairs_that_may_meet(own.boxes(shift), ray):
            found = _crossings(own.forms[i], delta)
            if isinstance(found, Place):
                return curve, root_at(found, Interval(*curve.breakpoints[i : i + 2]))
            total += found
    return total


def _check_closed_in_the_plane(curve: Nurbs) -> None:
    of_dimension(curve, "give curves and a point in one plane", 2)
    if not curve.closed:
        raise ShapeError("a curve that is not closed", remedy="close it by a segment")


def _check_connected(segments: list[SegmentForms]) -> None:
    """Raise `ShapeError` where a segment does not begin at the end of the previous segment."""
    for (n, before), (_, behind) in pairwise(segments):
        end, start = [c[n] for c in before], [c[0] for c in behind]
        if any(a * start[-1] != b * end[-1] for a, b in zip(end, start, strict=True)):
            raise ShapeError("a curve that jumps", remedy="give curves that are connected")


def _crossings(segment: SegmentForms, delta: tuple[mpq, ...]) -> int | Place:
    """The signed number of crossings of a segment with the ray from a point in the direction of x, or the place at
    which the segment passes through the point.

    >>> from exactspline import example
    >>> from exactspline.roots.segment_forms import segment_forms
    >>> [_crossings(segment_forms(example("circle"), i), (mpq(0), mpq(1, 2))) for i in range(4)]
    [1, 0, 0, 0]
    """
    n, (x, y, w) = segment
    y = _above(y, w, delta[1])
    if y and _one_sign(y, n):
        return 0
    x = _above(x, w, delta[0])
    if w[0] < 0:
        x, y = -x, -y
    if x and _one_sign(x, n):
        # to the right of the point only the ends matter; a zero of y there counts as positive
        return int(y[n] >= 0) - int(y[0] >= 0) if x[0] > 0 else 0
    if not y:
        # a segment on the line of the ray crosses the ray nowhere
        return next(iter(places(isolate(x, n))), 0) if x else at(mpq(0), 1)
    isolation, total = isolate(y, n), 0
    for place in places(isolation):
        side = place.sign(x, n)
        if side == 0:
            return place
        before, behind = _signs(place, isolation.signs)
        if side > 0:
            total += int(before < 0 < behind) - int(behind < 0 < before)
    return total


def _one_sign(form: fmpz_poly, n: int) -> bool:
    """Whether all coefficients are positive, or all are negative; inner coefficients may also be 0."""
    return bool(form[0] != 0 and form.degree() == n and variations(form) == 0)


def _signs(place: Place, ends: tuple[int, int]) -> tuple[int, int]:
    """The signs on both sides of a zero, above the ray at an end of the segment."""
    if place.exact == 0:
        return 1, ends[0]
    return (ends[1], 1) if place.exact == 1 else place.zero.signs


def _above(form: fmpz_poly, w: fmpz_poly, number: mpq) -> fmpz_poly:
    """The form of a coordinate minus a number, times the weight and a positive integer."""
    return form * fmpz(int(number.denominator)) - w * fmpz(int(number.numerator))
