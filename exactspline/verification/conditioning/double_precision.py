"""The experiment: the error of a zero in double precision. This is the only module of this room with floats.

They result from exact numbers by a single rounding, and are converted back by `exactspline.numbers.exact.from_float`.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from sys import float_info

from exactspline.numbers.exact import from_float, mpq
from exactspline.numbers.intervals import Interval
from exactspline.polynomials.bernstein import Form, bezier

#: The rounding unit of double precision.
UNIT = mpq(1, 2**53)
#: The number of bisections, from brackets that shrink towards the zero; the worst result is reported.
STARTS = 3


@dataclass(frozen=True)
class Double:
    """The result of double precision for a zero: the largest error in the local parameter over all bisections that
    could be started.

    `error` is None where none could be started, with the reason.
    """

    error: mpq | None
    reason: str = ""

    @property
    def units(self) -> mpq | None:
        """The error in units of 2⁻⁵³."""
        return None if self.error is None else self.error / UNIT


def double_precision_root(form: Form, n: int, x: mpq, bracket: Interval) -> Double:
    """The error of a zero when the Bézier points are rounded to doubles and the zero is found by bisection with de
    Casteljau's algorithm.

    `x` is the zero (or within ``10^−60`` of it), `bracket` an interval with no other zero; all in the local parameter.
    The bisection starts in the bracket and in two smaller ones. The points are scaled by one power of two, which only
    keeps them in range.

    >>> from exactspline.polynomials.bernstein import from_bezier
    >>> double_precision_root(from_bezier([mpq(-1), mpq(2)]), 1, mpq(1, 3), (mpq(0), mpq(1))).units
    mpq(1,6)
    """
    points, (low, high) = to_doubles(bezier(form, n)), bracket
    if points is None:
        return Double(None, "the coefficients span more than the range of doubles")
    parts = [mpq(j, 2 * STARTS) for j in range(STARTS)]
    starts = [(_double(low + (x - low) * part), _double(high + (x - high) * part)) for part in parts]
    errors = [abs(from_float(y) - x) for a, b in starts if (y := bisected(points, a, b)) is not None]
    return Double(max(errors)) if errors else Double(None, "no change of sign in doubles")


def to_doubles(points: list[mpq]) -> list[float] | None:
    """The points to the nearest double, the largest near 2¹⁰⁰⁰; None where one that is not zero would be less than the
    smallest normal double.
    """
    largest = max(abs(b) for b in points)
    scale = mpq(2) ** (1000 - int(largest.numerator).bit_length() + int(largest.denominator).bit_length())
    doubles = [_double(b * scale) for b in points]
    return None if any(b and abs(y) < float_info.min for b, y in zip(points, doubles, strict=True)) else doubles


def _double(q: mpq) -> float:
    """The double nearest to an exact number."""
    return int(q.numerator) / int(q.denominator)


def _de_casteljau(points: list[float], t: float) -> float:
    """The value in doubles by de Casteljau's algorithm."""
    u = 1.0 - t
    while len(points) > 1:
        points = [u * a + t * b for a, b in pairwise(points)]
    return points[0]


def bisected(points: list[float], low: float, high: float) -> float | None:
    """The result of a bisection, which ends at neighbouring doubles or at a zero; None without a change of sign."""
    first, last = _de_casteljau(points, low), _de_casteljau(points, high)
    if first == 0 or last == 0 or (first > 0) == (last > 0):
        return None
    while low < (middle := (low + high) / 2) < high:
        value = _de_casteljau(points, middle)
        if value == 0:
            return middle
        low, high = (middle, high) if (value > 0) == (first > 0) else (low, middle)
    return low
