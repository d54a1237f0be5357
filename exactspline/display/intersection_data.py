"""Common points and arcs of curves as data."""

from __future__ import annotations

from contextlib import suppress

from exactspline.errors import OpenError, ReachError
from exactspline.geometry.intersections import Intersection, Intersections, Overlap
from exactspline.numbers.exact import mpq, text
from exactspline.numbers.intervals import rounded_outwards
from exactspline.reals.real import Real, real

Data = dict[str, object]


def intersections_data(found: Intersections, digits: int) -> Data:
    """The points and arcs that two curves have in common."""
    return {
        "points": [_point_data(point, digits) for point in found],
        "everywhere": [_overlap_data(arc, digits) for arc in found.everywhere],
        "left_out": list(found.left_out),
    }


def _point_data(point: Intersection, digits: int) -> Data:
    return {
        "kind": str(point.kind),
        "first": real_data(point.first, digits),
        "second": real_data(point.second, digits),
        "multiplicity": point.multiplicity,
        "at_knot": list(point.at_knot),
        "point": [real_data(x, digits) for x in point.point],
    }


def _overlap_data(arc: Overlap, digits: int) -> Data:
    return {
        "first": [real_data(x, digits) for x in arc.first],
        "second": [real_data(x, digits) for x in arc.second],
        "reversed": arc.reversed,
        "of_second": arc.of_second,
        "numerator": None if arc.numerator is None else [str(x) for x in arc.numerator],
        "denominator": None if arc.denominator is None else [str(x) for x in arc.denominator],
    }


def real_data(x: Real | mpq, digits: int) -> Data:
    """A number: exactly where it has a short form, in a certified interval, and to a given number of digits."""
    number = real(x)
    with suppress(ReachError, OpenError):
        _ = number.exact  # then its closed form is known
    low, high = number.enclosure(digits)
    if low != high:
        low, high = rounded_outwards(number.enclosure(digits), digits + 1)
    return {"exact": number.closed_form, "interval": [text(low), text(high)], "decimal": number.decimal(digits)}
