"""Isolation of the zeros of many forms in one operation, in doubles with error bounds, for those forms for which
doubles decide it.

Every form is a row of coefficients in the scaled Bernstein basis with bounds on their errors. A sign is certain if the
coefficient is larger than its error bound; Descartes' rule is applied with the largest number of sign changes that the
certain signs allow. Rows for which this never yields 0 or 1 are decided by exact arithmetic. Derivation:
docs/certified-filter.md.

An integer form has no rational zero if its residues modulo a small prime vanish at no point of the projective line over
the prime field; this is evaluated for many forms in one operation.

This module is the only one of `polynomials` that loads numpy.
"""

from __future__ import annotations

from math import comb
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from exactspline.polynomials.roundings import ROUNDING, UNDERFLOW

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
Flags = NDArray[np.bool_]

#: The parameter at which pieces are split: not the midpoint, where symmetric curves have zeros. Splitting ten times is
#: exact in doubles.
SPLIT, DEPTH = 15 / 32, 9
#: The depth of subdivision to prove the absence of zeros, for which the ends of pieces need not be exact: sufficient to
#: distinguish a speed of 10⁻⁷ from 0.
DEEP = 22
#: The maximal number of (unproved) steps towards a zero, and the length of a step after which they stop.
STEPS, REACHED = 40, 2.0**-48
#: Half widths of the intervals in which a zero is verified after Newton's method, narrowest first.
WIDTHS = (2.0**-46, 2.0**-42, 2.0**-37, 2.0**-30, 2.0**-20, 2.0**-10)


class Bounded(NamedTuple):
    """Numbers, one row per form, and bounds on their errors. The bound of an infinite number or a NaN is infinite or
    NaN, too, so that the sign is not certain.
    """

    values: Floats
    errors: Floats

    @property
    def signs(self) -> Integers:
        """The signs: 1 or −1 where the sign is certain, 0 elsewhere."""
        return np.where(self.values > self.errors, 1, np.where(self.values < -self.errors, -1, 0))


class Isolated(NamedTuple):
    """Simple zeros: the row, an interval in [0, 1] whose interior contains this zero and no other, and the sign before
    it.
    """

    row: Integers
    low: Floats
    high: Floats
    before: Integers

    def where(self, holds: Flags) -> Isolated:
        """The zeros selected by a mask."""
        return Isolated(self.row[holds], self.low[holds], self.high[holds], self.before[holds])


def ordinates(values: Floats, errors: Floats) -> Bounded:
    """The Bézier ordinates of coefficients in the scaled basis."""
    n = values.shape[1] - 1
    scale = np.array([float(comb(n, i)) for i in range(n + 1)])
    with np.errstate(all="ignore"):
        values_found = values / scale
        return Bounded(
            values_found, errors / scale * (1 + 8 * ROUNDING) + 2 * ROUNDING * np.abs(values_found) + UNDERFLOW
        )


def isolated(rows: Bounded) -> tuple[Isolated, Flags]:
    """The zeros inside (0, 1) of the forms for which doubles decide them, in order, and a mask of the other forms.

    >>> found, open_ = isolated(Bounded(np.array([[1.0, -2, 1], [1, 2, 1], [0, 1, 2]]), np.full((3, 3), 1e-9)))
    >>> found.row.tolist(), found.before.tolist(), open_.tolist()
    ([0, 0], [1, -1], [False, False, True])
    """
    count, part = len(rows.values), rows
    undecided = np.zeros(count, dtype=bool)
    index, low, width = np.arange(count), np.zeros(count), np.ones(count)
    parts: list[tuple[NDArray[np.generic], ...]] = []
    for level in range(DEPTH + 1):
        signs = part.signs
        blind = (signs[:, 0] == 0) | (signs[:, -1] == 0)
        most = most_changes(signs)
        one = (most == 1) & ~blind
        parts.append((index[one], low[one], low[one] + width[one], signs[one, 0]))
        undecided[index[blind]] = True
        again = (most > 1) & ~undecided[index]
        if level == DEPTH or not again.any():
            undecided[index[again]] = True
            break
        index, low, width = index[again], low[again], width[again]
        part = _halved(part, again)
        index = np.concatenate([index, index])
        low = np.concatenate([low, low + width * SPLIT])
        width = np.concatenate([width * SPLIT, width * (1 - SPLIT)])
    row, start, end, before = (np.concatenate(column) for column in zip(*parts, strict=True))
    order = np.lexsort((start, row))
    zeros = Isolated(row[order], start[order], end[order], before[order])
    return zeros.where(~undecided[zeros.row]), undecided


def without_zeros(rows: Bounded) -> Flags:
    """A mask of the forms that certainly have no zero on [0, 1]: on all pieces the ordinates have one certain sign. The
    ends of pieces need not be exact, so that pieces may be smaller than for isolation.

    >>> without_zeros(Bounded(np.array([[1, -0.999, 1], [1, -1.0, 1]]), np.full((2, 3), 1e-15))).tolist()
    [True, False]
    """
    certain = np.ones(len(rows.values), dtype=bool)
    index, part = np.arange(len(rows.values)), rows
    for level in range(DEEP + 1):
        signs = part.signs
        # an uncertain sign at an end, or two signs: there is a zero, or it cannot be excluded
        certain[index[(signs[:, 0] == 0) | (signs[:, 0] != signs[:, -1])]] = False
        again = (signs != signs[:, :1]).any(axis=1) & certain[index]
        if level == DEEP or not again.any():
            certain[index[again]] = False
            break
        index = np.concatenate([index[again]] * 2)
        part = _halved(part, again)
    return certain


def _halved(rows: Bounded, chosen: Flags) -> Bounded:
    """The left parts of some forms, then their right parts."""
    pair = split_in_two(Bounded(rows.values[chosen], rows.errors[chosen]))
    return Bounded(*(np.concatenate(column) for column in zip(*pair, strict=True)))


def most_changes(signs: NDArray[np.int64]) -> NDArray[np.int64]:
    """The maximal number of sign changes of a row over all choices of the uncertain signs."""
    ends_up, ends_down = (np.where(signs[:, 0] == s, -1000, 0) for s in (-1, 1))
    for column in signs.T[1:]:
        up, down = np.maximum(ends_up, ends_down + 1), np.maximum(ends_down, ends_up + 1)
        ends_up, ends_down = np.where(column < 0, -1000, up), np.where(column > 0, -1000, down)
    return np.maximum(ends_up, ends_down)


def split_in_two(rows: Bounded) -> tuple[Bounded, Bounded]:
    """The forms to the left and right of `SPLIT`, by de Casteljau's algorithm."""
    (value, error), n = rows, rows.values.shape[1] - 1
    left, right = [(value[:, 0], error[:, 0])], [(value[:, -1], error[:, -1])]
    with np.errstate(all="ignore"):
        for _ in range(n):
            first, second = (1 - SPLIT) * value[:, :-1], SPLIT * value[:, 1:]
            value = first + second
            carried = (1 - SPLIT) * error[:, :-1] + SPLIT * error[:, 1:]
            rounding = 3 * ROUNDING * (np.abs(first) + np.abs(second))
            error = (carried + rounding) * (1 + 8 * ROUNDING) + 8 * UNDERFLOW
            left.append((value[:, 0], error[:, 0]))
            right.append((value[:, -1], error[:, -1]))
    return _stacked(left), _stacked(right[::-1])


def _stacked(columns: list[tuple[Floats, Floats]]) -> Bounded:
    values, errors = zip(*columns, strict=True)
    return Bounded(np.stack(values, axis=1), np.stack(errors, axis=1))


def values_at(rows: Bounded, index: Integers, t: Floats) -> tuple[Floats, Floats]:
    """The values of forms at parameters in [0, 1], and bounds on their errors."""
    b = rows.values[index]
    n = b.shape[1] - 1
    with np.errstate(all="ignore"):
        bound = rows.errors[index] + 4 * (n + 1) * ROUNDING * np.abs(b)
        u, v = (1 - t)[:, None], t[:, None]
        for _ in range(n):
            b = u * b[:, :-1] + v * b[:, 1:]
            bound = u * bound[:, :-1] + v * bound[:, 1:]
    return b[:, 0], bound[:, 0] * (1 + 8 * (n + 1) * ROUNDING) + 16 * (n + 1) * UNDERFLOW


def narrowed(rows: Bounded, zeros: Isolated) -> Isolated:
    """The same zeros in narrower intervals, where the signs at their ends are certain."""
    index, low, high, before = zeros
    if not len(index):
        return zeros
    x = _approximated(rows, zeros)
    new_low, new_high, open_ = low.copy(), high.copy(), np.ones(len(index), dtype=bool)
    for half in WIDTHS:
        some = np.flatnonzero(open_)
        if not len(some):
            break
        a, b = np.maximum(low[some], x[some] - half), np.minimum(high[some], x[some] + half)
        (left, left_error), (right, right_error) = (values_at(rows, index[some], t) for t in (a, b))
        s = before[some]
        proved = (s * left > left_error) & (s * right < -right_error) & (a < b)
        new_low[some[proved]], new_high[some[proved]] = a[proved], b[proved]
        open_[some[proved]] = False
    return Isolated(index, new_low, new_high, before)


def _approximated(rows: Bounded, zeros: Isolated) -> Floats:
    """Unproved approximations of the zeros, by Newton's method safeguarded by bisection when it leaves the bracket or
    is slow. Zeros for which it has converged are not iterated further.
    """
    x = (zeros.low + zeros.high) / 2
    low, high, last = zeros.low.copy(), zeros.high.copy(), zeros.high - zeros.low
    todo = np.arange(len(x))
    with np.errstate(all="ignore"):
        for _ in range(STEPS):
            value, slope = _value_and_slope(rows.values[zeros.row[todo]], x[todo])
            left = value * zeros.before[todo] > 0
            low[todo], high[todo] = np.where(left, x[todo], low[todo]), np.where(left, high[todo], x[todo])
            step = value / slope
            near = x[todo] - step
            good = (near >= low[todo]) & (near <= high[todo]) & (2 * np.abs(step) <= last[todo])
            last[todo] = np.where(good, np.abs(step), (high[todo] - low[todo]) / 2)
            x[todo] = np.where(good, near, (low[todo] + high[todo]) / 2)
            todo = todo[last[todo] > REACHED]
            if not len(todo):
                break
    return x


def _value_and_slope(b: Floats, t: Floats) -> tuple[Floats, Floats]:
    """The values and derivatives of forms at parameters."""
    u, v, n = (1 - t)[:, None], t[:, None], b.shape[1] - 1
    for _ in range(n - 1):
        b = u * b[:, :-1] + v * b[:, 1:]
    first, second = b[:, 0], b[:, -1]
    return u[:, 0] * first + v[:, 0] * second, n * (second - first)
