"""The experiment: the error of a zero in double precision. This is the only module of this room with floats.

They result from exact numbers by a single rounding, and are converted back by `exactspline.numbers.exact.from_float`.
"""

from __future__ import annotations

from collections.abc import Sequence
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
    return double_precision_roots(form, n, [(x, bracket)])[0]


def double_precision_roots(form: Form, n: int, zeros: Sequence[tuple[mpq, Interval]]) -> list[Double]:
    """The same for several zeros of one form, each with its bracket: all bisections run in parallel."""
    points = to_doubles(bezier(form, n))
    if points is None:
        return [Double(None, "the coefficients span more than the range of doubles") for _ in zeros]
    starts = [
        (_double(low + (x - low) * mpq(j, 2 * STARTS)), _double(high + (x - high) * mpq(j, 2 * STARTS)))
        for x, (low, high) in zeros
        for j in range(STARTS)
    ]
    ends = bisected(points, starts)
    result = []
    for k, (x, _) in enumerate(zeros):
        errors = [abs(from_float(y) - x) for y in ends[k * STARTS : (k + 1) * STARTS] if y is not None]
        result.append(Double(max(errors)) if errors else Double(None, "no change of sign in doubles"))
    return result


def to_doubles(points: list[mpq]) -> list[float] | None:
    """The points to the nearest double, the largest near 2¹⁰⁰⁰; None where one that is not zero would be less than the
    smallest normal double.
    """
    largest = max(abs(b) for b in points)
    shift = 1000 - int(largest.numerator).bit_length() + int(largest.denominator).bit_length()
    scale = mpq(2) ** shift
    doubles = [_double(b * scale) for b in points]
    return None if any(b and abs(y) < float_info.min for b, y in zip(points, doubles, strict=True)) else doubles


def _double(q: mpq) -> float:
    """The double nearest to an exact number."""
    return int(q.numerator) / int(q.denominator)


def values_at(points: list[float], parameters: Sequence[float]) -> list[float]:
    """The values at parameters by de Casteljau's algorithm, all rounded alike: with numpy, where it is installed, for
    all parameters together.
    """
    try:
        import numpy
    except ImportError:
        return [de_casteljau(points, t) for t in parameters]
    t = numpy.array(parameters)
    u, column = 1.0 - t, numpy.array(points, dtype=float)[:, None]
    left, right = numpy.repeat(column, len(t), axis=1), numpy.empty((len(points), len(t)))
    for m in range(len(points) - 1, 0, -1):
        numpy.multiply(left[1 : m + 1], t, out=right[:m])
        numpy.multiply(left[:m], u, out=left[:m])
        numpy.add(left[:m], right[:m], out=left[:m])
    values: list[float] = left[0].tolist()
    return values


def de_casteljau(points: list[float], t: float) -> float:
    """The value in doubles by de Casteljau's algorithm."""
    u = 1.0 - t
    while len(points) > 1:
        points = [u * a + t * b for a, b in pairwise(points)]
    return points[0]


def bisected(points: list[float], starts: Sequence[tuple[float, float]]) -> list[float | None]:
    """The results of bisections, which end at neighbouring doubles or at a value of zero; None where there is no change
    of sign.
    """
    first = values_at(points, [low for low, _ in starts])
    last = values_at(points, [high for _, high in starts])
    ends: list[float | None] = [None] * len(starts)
    going = {
        k: start for k, start in enumerate(starts) if first[k] != 0 and last[k] != 0 and (first[k] > 0) != (last[k] > 0)
    }
    while going:
        middles = {k: (low + high) / 2 for k, (low, high) in going.items()}
        for k in [k for k, (low, high) in going.items() if not low < middles[k] < high]:
            ends[k] = going.pop(k)[0]
            del middles[k]
        for (k, middle), at in zip(middles.items(), values_at(points, list(middles.values())), strict=True):
            low, high = going[k]
            if at == 0:
                ends[k] = middle
                del going[k]
            else:
                going[k] = (middle, high) if (at > 0) == (first[k] > 0) else (low, middle)
    return ends
